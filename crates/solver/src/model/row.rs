use crate::model::buildings::Buildings;
use crate::model::ground::{Ground, Shaking};
use crate::model::incidence::Incidence;
use crate::{Clock, Excitation, ModelError, Node, Pair, Point, RestoringForce, State, Travel};
use pounding_contact::reduced_mass;

/// The model: floors, level by level and in each from left to right, and the pairs of points that can touch.
///
/// A row of structures of one storey is one level. Structures that cannot touch share no pair, and nothing of one then
/// enters the arithmetic of the other.
#[derive(Debug, Clone, PartialEq)]
pub struct Row<Column> {
    nodes: Vec<Node<Column>>,
    buildings: Buildings,
    pairs: Vec<Pair>,
    /// Which of them meet which nodes.
    incidence: Incidence,
    /// When the ground motion arrives at every node \[s\]; nothing where it does so everywhere at t = 0.
    arrivals: Option<Vec<f64>>,
}

impl<Column: RestoringForce> Row<Column> {
    /// How an excitation shakes it on a clock.
    pub(crate) fn shaken<'a>(&self, excitation: Excitation<'a>, clock: Clock) -> Shaking<'a> {
        Shaking::new(self.nodes.len(), self.travel(excitation), excitation, clock)
    }

    /// Checks and keeps the nodes and pairs.
    ///
    /// # Errors
    /// [`ModelError`] for a mass, damping or initial state out of range, a floor that does not stand on an earlier one
    /// of its own, a point that is none of the row, a pair whose points are of one building or of walls alone, a negative
    /// gap, a contact parameter out of range, or points that overlap at t = 0. Which point is the left one is not checked.
    pub fn new(nodes: Vec<Node<Column>>, pairs: Vec<Pair>) -> Result<Self, ModelError> {
        let unchecked = Self {
            nodes,
            buildings: Buildings::default(),
            pairs,
            incidence: Incidence::default(),
            arrivals: None,
        };
        unchecked.checked()
    }

    /// Another row in the memory of this one, for many of them: with these nodes and pairs, and a ground motion that arrives
    /// everywhere at t = 0.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn renewed(
        mut self,
        nodes: impl IntoIterator<Item = Node<Column>>,
        pairs: impl IntoIterator<Item = Pair>,
    ) -> Result<Self, ModelError> {
        self.nodes.clear();
        self.nodes.extend(nodes);
        self.pairs.clear();
        self.pairs.extend(pairs);
        self.arrivals = None;
        self.checked()
    }

    fn checked(mut self) -> Result<Self, ModelError> {
        let (nodes, pairs) = (&self.nodes, &self.pairs);
        for (index, node) in nodes.iter().enumerate() {
            check_node(index, node)?;
        }
        self.buildings.renew(nodes)?;
        for (index, pair) in pairs.iter().enumerate() {
            self.check_points(index, pair)?;
            check_pair(index, pair)?;
            let ahead = pair.relation.ahead(|node| nodes[node].initial_displacement);
            let overlap = ahead - pair.gap();
            if overlap > 0.0 {
                return Err(ModelError::OverlapsAtStart { pair: index, overlap });
            }
        }
        self.incidence.renew(nodes.len(), pairs);
        Ok(self)
    }

    /// Both points of a pair are of the row, and of two buildings, or of a building and a wall.
    ///
    /// Nodes do not tell who stands on the left: the lowest floor of a building may be on any level.
    fn check_points(&self, index: usize, pair: &Pair) -> Result<(), ModelError> {
        let points = pair.relation.points();
        for (side, point) in ["left", "right"].into_iter().zip(points) {
            point
                .check(&self.nodes)
                .map_err(|fault| ModelError::Point { pair: index, side, fault })?;
        }
        let [left, right] = points.map(Point::floor);
        let walls = [left, right].map(|floor| self.nodes[floor].is_wall());
        let [before, after] = [left, right].map(|floor| self.buildings.of(floor));
        let found = match walls {
            [true, true] => "two walls",
            _ if before == after => "one building",
            _ => return Ok(()),
        };
        Err(ModelError::NotNeighbours {
            pair: index,
            left,
            right,
            found,
        })
    }

    /// Whether the pairs are a chain: each joins a node with the next one, both as floors, and they stand in the order of their nodes.
    pub fn is_chain(&self) -> bool {
        let follows = |pair: &Pair| pair.relation.is_level() && pair.right() == pair.left() + 1;
        let rises = |pairs: &[Pair]| pairs[0].left() < pairs[1].left();
        self.pairs.iter().all(follows) && self.pairs.windows(2).all(rises)
    }

    /// The same row, at whose nodes the ground motion arrives one after the other: after these times \[s\], ≥ 0, one for
    /// each node, which all floors of a building share.
    ///
    /// A wave of apparent velocity v reaches a base that is a distance x further along its way after x/v. Every building,
    /// and every wall, then stands on a ground of its own, which moves as the excitation says, that much later, and rests
    /// before. Displacements, velocities and accelerations stay relative to it, so that nothing of a building alone changes
    /// but its time. What changes is the deformation of a pair, δ = (u + `u_g`)\_left − (u + `u_g`)\_right − g, with `u_g` the exact
    /// double integral of the record ([`Travel`]). Where all arrive at once and at t = 0, this is the row as it was.
    ///
    /// # Errors
    /// [`ModelError`] for another number of times than nodes, a time that is not a finite number ≥ 0, and a floor whose
    /// time is not that of the floor below.
    pub fn delayed(self, arrivals: Vec<f64>) -> Result<Self, ModelError> {
        if arrivals.len() != self.nodes.len() {
            return Err(ModelError::Arrivals {
                found: arrivals.len(),
                n_nodes: self.nodes.len(),
            });
        }
        for (index, (node, &found)) in self.nodes.iter().zip(&arrivals).enumerate() {
            let refused = |allowed| ModelError::OutOfRange {
                place: format!("arrivals[{index}]"),
                found,
                allowed,
            };
            if !(found >= 0.0 && found.is_finite()) {
                return Err(refused("a finite number >= 0"));
            }
            let below = node.support.below().map_or(found, |below| arrivals[below]);
            if found.total_cmp(&below).is_ne() {
                return Err(refused("that of the floor below: a building stands on one ground"));
            }
        }
        let at_once = arrivals.iter().all(|arrival| *arrival == 0.0);
        Ok(Self {
            arrivals: (!at_once).then_some(arrivals),
            ..self
        })
    }

    /// The floors and walls: those on the ground from left to right, then those of the next level, and so on.
    pub fn nodes(&self) -> &[Node<Column>] {
        &self.nodes
    }

    /// The pairs that can touch, in the order in which they were given.
    pub fn pairs(&self) -> &[Pair] {
        &self.pairs
    }

    /// Which pairs meet which nodes.
    pub(crate) fn incidence(&self) -> &Incidence {
        &self.incidence
    }

    /// Which floors make a building.
    pub fn buildings(&self) -> &Buildings {
        &self.buildings
    }

    /// The floor that stands on a node; nothing on the top floor of a building, and on a wall.
    pub fn above(&self, node: usize) -> Option<usize> {
        self.buildings.above(node)
    }

    /// Number of pairs that overlap.
    pub(crate) fn n_overlaps(&self, states: &[State], ground: Ground<'_>) -> u64 {
        let overlaps = |pair: &&Pair| ground.deformation_of(pair, states) > 0.0;
        self.pairs.iter().filter(overlaps).count() as u64
    }

    /// Reduced mass of a pair \[kg\].
    pub fn reduced_mass(&self, pair: &Pair) -> f64 {
        let mobility = |node: usize| self.nodes[node].inverse_mass;
        let [left, right] = pair.relation.points().map(|point| point.mobility(mobility));
        reduced_mass(left, right)
    }
}

impl<Column> Row<Column> {
    /// How an excitation travels along the row; nothing where it arrives at all nodes at t = 0.
    pub fn travel(&self, excitation: Excitation<'_>) -> Option<Travel> {
        let arrivals = self.arrivals.as_ref()?;
        Some(Travel::new(excitation, arrivals.clone()))
    }

    /// When the ground motion arrives at a node \[s\].
    pub fn arrival(&self, node: usize) -> f64 {
        self.arrivals.as_ref().map_or(0.0, |arrivals| arrivals[node])
    }
}

fn check_node<Column>(index: usize, node: &Node<Column>) -> Result<(), ModelError> {
    const NOT_NEGATIVE: &str = "a finite number >= 0";
    let require = |valid: bool, field: &'static str, found: f64, allowed: &'static str| {
        if valid && found.is_finite() {
            return Ok(());
        }
        Err(ModelError::Node {
            node: index,
            field,
            found,
            allowed,
        })
    };
    require(node.inverse_mass >= 0.0, "inverse_mass", node.inverse_mass, NOT_NEGATIVE)?;
    require(node.damping >= 0.0, "damping", node.damping, NOT_NEGATIVE)?;
    let stands = !node.is_wall() || node.initial_displacement == 0.0;
    require(
        stands,
        "initial_displacement",
        node.initial_displacement,
        "a finite number; 0 for a wall",
    )?;
    let moves = !node.is_wall() || node.initial_velocity == 0.0;
    require(moves, "initial_velocity", node.initial_velocity, "a finite number; 0 for a wall")
}

fn check_pair(index: usize, pair: &Pair) -> Result<(), ModelError> {
    if !(pair.gap() >= 0.0 && pair.gap().is_finite()) {
        return Err(ModelError::Pair {
            pair: index,
            field: "gap",
            found: pair.gap(),
            allowed: "a finite number >= 0",
        });
    }
    pair.law.check().map_err(|error| ModelError::Pair {
        pair: index,
        field: error.parameter,
        found: error.found,
        allowed: error.allowed,
    })
}
