//! Bodies: floors that move together because storeys join them, or because neighbours touch or rest against each other.

use std::ops::Range;

use crate::exact::contact::{Join, PairState, System};
use crate::exact::member::Member;
use crate::exact::tie::Tie;
use crate::model::incidence::Incidence;
use crate::{Point, Relation};

/// The bodies of a row, from its links.
#[derive(Debug, Default)]
pub(super) struct Groups {
    /// First node of the body of each node.
    pub(super) body_of: Vec<usize>,
    /// Nodes, body by body.
    nodes: Vec<usize>,
    /// Nodes of bodies that stand on a floor, are linked, or whose columns yield smoothly.
    followed: Vec<usize>,
    /// Blocks of nodes at rest, for chains only.
    blocks: Vec<Block>,
    /// For rows that are no chain: the pairs at rest of each body, by its first node; `None` if no pair rests.
    ties: Vec<Option<Tie>>,
    /// Pairs that touch or rest.
    pairs: Vec<usize>,
    /// Pairs that touch a body or are inside it.
    around: Vec<usize>,
    /// Links of bodies.
    linked: Vec<usize>,
    /// The ends of every link.
    links: Vec<Relation>,
    /// Places of the lists of each body, by its first node.
    places: Vec<Places>,
    /// How pairs were joined when the lists were made.
    joins: Vec<JoinKind>,
    /// Which nodes stood still then: ties depend on masses.
    still: Vec<bool>,
    /// The next node of the body, by node; the last node points to itself.
    next: Vec<usize>,
    pub(super) is_chain: bool,
}

/// Nodes that rest against each other and share their acceleration, or a single node.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block {
    pub(super) first: usize,
    pub(super) last: usize,
    /// Pair that pushes from the left.
    pub(super) left: Option<usize>,
    /// The first pair at rest inside the block, which has one pair less than nodes.
    pub(super) within: usize,
    pub(super) right: Option<usize>,
}

/// Contribution of a node to its side of a pair.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Side {
    /// Weight ≥ 0 that decides which side is lighter.
    pub(super) weight: f64,
    /// Need that is summed over the lighter side.
    pub(super) need: f64,
}

/// The sum of the needs of the lighter side of a pair.
#[derive(Debug, Clone, Copy)]
pub(super) enum Lighter {
    Left(f64),
    Right(f64),
}

impl Side {
    fn over(self, other: Self) -> Self {
        Self {
            weight: self.weight + other.weight,
            need: self.need + other.need,
        }
    }
}

impl Block {
    /// Calls `tell` for every pair inside, by its place, with the need of its lighter side (the left one of equal sides). The number of
    /// operations is proportional to the number of nodes, because the lighter side grows from its end of the block.
    pub(super) fn tell_lighter_sides(&self, side: impl Fn(usize) -> Side, mut tell: impl FnMut(usize, Lighter)) {
        let (mut first, mut last) = (self.first, self.last);
        if first == last {
            return;
        }
        let (mut left, mut right) = (side(first), side(last));
        loop {
            if left.weight <= right.weight {
                tell(first - self.first, Lighter::Left(left.need));
                first += 1;
                if first == last {
                    return;
                }
                left = left.over(side(first));
            } else {
                last -= 1;
                tell(last - self.first, Lighter::Right(right.need));
                if first == last {
                    return;
                }
                right = right.over(side(last));
            }
        }
    }
}

/// Parts of the lists that belong to a body.
#[derive(Debug, Clone, Default)]
struct Places {
    first: usize,
    nodes: Range<usize>,
    followed: Range<usize>,
    blocks: Range<usize>,
    pairs: Range<usize>,
    around: Range<usize>,
    links: Range<usize>,
}

/// One body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Group<'a> {
    groups: &'a Groups,
    places: &'a Places,
}

impl<'a> Group<'a> {
    #[inline]
    pub(super) fn nodes(self) -> &'a [usize] {
        &self.groups.nodes[self.places.nodes.clone()]
    }

    /// Nodes that stand on a floor, are linked, or whose columns yield smoothly.
    #[inline]
    pub(super) fn followed(self) -> &'a [usize] {
        &self.groups.followed[self.places.followed.clone()]
    }

    #[inline]
    pub(super) fn blocks(self) -> &'a [Block] {
        &self.groups.blocks[self.places.blocks.clone()]
    }

    /// Pairs inside that touch or rest.
    #[inline]
    pub(super) fn pairs(self) -> &'a [usize] {
        &self.groups.pairs[self.places.pairs.clone()]
    }

    /// Links inside.
    #[inline]
    pub(super) fn links(self) -> &'a [usize] {
        &self.groups.linked[self.places.links.clone()]
    }

    /// Pairs at rest of the body, in a row that is no chain.
    #[inline]
    pub(super) fn tie(self) -> Option<&'a Tie> {
        self.groups.ties[self.places.first].as_ref()
    }

    /// Whether the row is a chain, so that the group has blocks.
    #[inline]
    pub(super) fn is_of_chain(self) -> bool {
        self.groups.is_chain
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum JoinKind {
    Apart,
    Resting,
    Idle,
    Touching,
}

impl PairState {
    fn kind(&self) -> JoinKind {
        match self.join {
            Join::Apart => JoinKind::Apart,
            Join::Resting if self.idle => JoinKind::Idle,
            Join::Resting => JoinKind::Resting,
            Join::Touching(_) => JoinKind::Touching,
        }
    }
}

impl Groups {
    /// Bodies of a row in which nothing touches, with the ends of its links.
    pub(super) fn new(system: System<'_>, links: Vec<Relation>, is_chain: bool) -> Self {
        let n = system.members.len();
        let mut groups = Self {
            body_of: vec![0; n],
            ties: vec![None; n],
            places: vec![Places::default(); n],
            next: vec![0; n],
            links,
            is_chain,
            ..Self::default()
        };
        groups.rebuild(system);
        groups
    }

    /// Updates the bodies if the links have changed.
    pub(super) fn update(&mut self, system: System<'_>) {
        let same = |(kind, contact): (&JoinKind, &PairState)| *kind == contact.kind();
        let still = |(still, member): (&bool, &Member)| *still == member.is_still();
        if !self.joins.iter().zip(system.contacts).all(same) || !self.still.iter().zip(system.members).all(still) {
            self.rebuild(system);
        }
    }

    fn rebuild(&mut self, system: System<'_>) {
        self.linked.clear();
        self.joins.clear();
        self.joins.extend(system.contacts.iter().map(PairState::kind));
        self.still.clear();
        self.still.extend(system.members.iter().map(Member::is_still));
        self.unite(system);
        self.nodes.clear();
        self.followed.clear();
        self.blocks.clear();
        self.pairs.clear();
        self.around.clear();
        for first in 0..system.members.len() {
            self.ties[first] = None;
            if self.body_of[first] == first {
                self.list(first, system);
            }
        }
    }

    /// Finds the first node of the body of every node, and the next node.
    fn unite(&mut self, System { members, contacts, .. }: System<'_>) {
        for (node, body) in self.body_of.iter_mut().enumerate() {
            *body = node;
        }
        for (node, member) in members.iter().enumerate() {
            if let Some(storey) = &member.storey {
                self.join(storey.below, node);
            }
        }
        for link in 0..self.links.len() {
            // The node above a ground, too: samples that arrive there end the pieces of the body.
            let [left, right] = self.links[link].points().map(Point::floor);
            self.join(left, right);
        }
        for (pair, contact) in contacts.iter().enumerate() {
            if self.joins[pair] != JoinKind::Apart {
                let [left, right] = contact.floors();
                self.join(left, right);
            }
        }
        for node in 0..members.len() {
            // Every root comes before the nodes that lead to it.
            self.body_of[node] = self.body_of[self.body_of[node]];
            self.next[node] = node;
        }
        for node in (0..members.len()).rev() {
            // From the right: until it is reached, the first node of a body leads to the last node found.
            let first = self.body_of[node];
            if first != node {
                (self.next[node], self.next[first]) = (self.next[first], node);
                if self.next[node] == first {
                    self.next[node] = node;
                }
            }
        }
    }

    fn root(&self, mut node: usize) -> usize {
        while self.body_of[node] != node {
            node = self.body_of[node];
        }
        node
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.body_of[a.max(b)] = a.min(b);
    }

    /// Lists everything that belongs to the body with this first node.
    fn list(&mut self, first: usize, system: System<'_>) {
        let starts = self.lengths();
        let mut node = first;
        loop {
            self.add(node, system);
            if self.next[node] == node {
                break;
            }
            node = self.next[node];
        }
        let ends = self.lengths();
        let range = |index: usize| starts[index]..ends[index];
        self.places[first] = Places {
            first,
            nodes: range(0),
            followed: range(1),
            blocks: range(2),
            pairs: range(3),
            around: range(4),
            links: self.list_links(first),
        };
        if !self.is_chain {
            let pairs = self.pairs[range(3)].iter().copied();
            let resting = pairs.filter(|pair| self.joins[*pair] == JoinKind::Resting);
            self.ties[first] = Tie::of(resting.collect(), system);
        }
    }

    /// Lists the links of the body with this first node.
    fn list_links(&mut self, first: usize) -> Range<usize> {
        let start = self.linked.len();
        for (index, link) in self.links.iter().enumerate() {
            let mut floors = link.pushes().map(|(floor, _)| floor);
            if floors.any(|floor| self.body_of[floor] == first) {
                self.linked.push(index);
            }
        }
        start..self.linked.len()
    }

    /// Places of the links of a body, for [`Self::link`].
    pub(super) fn links_of(&self, first: usize) -> Range<usize> {
        self.places[first].links.clone()
    }

    pub(super) fn link(&self, place: usize) -> usize {
        self.linked[place]
    }

    fn lengths(&self) -> [usize; 5] {
        [
            self.nodes.len(),
            self.followed.len(),
            self.blocks.len(),
            self.pairs.len(),
            self.around.len(),
        ]
    }

    fn add(&mut self, node: usize, system: System<'_>) {
        let member = &system.members[node];
        self.nodes.push(node);
        if member.storey.is_some() || member.bend.is_some() || member.linked.is_some() {
            self.followed.push(node);
        }
        for at in system.incidence.at(node) {
            let [left, right] = system.contacts[at.pair].floors();
            // Several floors may carry a point, but the pair is listed once. A neighbour in the same body has listed it already.
            let first = if at.on_left {
                node == left
            } else {
                node == right && self.body_of[left] != self.body_of[node]
            };
            if first {
                self.around.push(at.pair);
                if at.on_left && self.joins[at.pair] != JoinKind::Apart {
                    self.pairs.push(at.pair);
                }
            }
        }
        if self.is_chain {
            self.extend_blocks(node, system.incidence);
        }
    }

    /// Adds a node of a chain to the block of the node before it if they rest, or begins a block.
    fn extend_blocks(&mut self, node: usize, incidence: &Incidence) {
        let [left, right] = beside(incidence, node);
        let pushing = |pair: &usize| self.joins[*pair] == JoinKind::Touching;
        let (from_left, from_right) = (left.filter(pushing), right.filter(pushing));
        let rests = left.is_some_and(|pair| self.joins[pair] == JoinKind::Resting);
        match self.blocks.last_mut() {
            Some(block) if rests => (block.last, block.right) = (node, from_right),
            Some(_) | None => self.blocks.push(Block {
                first: node,
                last: node,
                left: from_left,
                within: right.unwrap_or(0),
                right: from_right,
            }),
        }
    }

    /// The body that begins with a node.
    #[inline]
    pub(super) fn of(&self, first: usize) -> Group<'_> {
        Group {
            groups: self,
            places: &self.places[first],
        }
    }

    /// Places of the nodes of a body, for [`Self::node`].
    pub(super) fn nodes_of(&self, first: usize) -> Range<usize> {
        self.places[first].nodes.clone()
    }

    pub(super) fn node(&self, place: usize) -> usize {
        self.nodes[place]
    }

    /// Places of the pairs inside a body and on both sides of it, for [`Self::pair`].
    pub(super) fn around(&self, first: usize) -> Range<usize> {
        self.places[first].around.clone()
    }

    pub(super) fn pair(&self, place: usize) -> usize {
        self.around[place]
    }
}

/// The pairs on the left and right of a node of a chain.
pub(super) fn beside(incidence: &Incidence, node: usize) -> [Option<usize>; 2] {
    let side = |on_left: bool| {
        let at = incidence.at(node).iter().find(|at| at.on_left == on_left);
        at.map(|at| at.pair)
    };
    [side(false), side(true)]
}
