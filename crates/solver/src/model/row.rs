use crate::model::buildings::Buildings;
use crate::model::ground::{Ground, Shaking};
use crate::model::incidence::Incidence;
use crate::{Clock, Excitation, Link, LinkFault, ModelError, Node, Pair, Point, PointFault, RestoringForce, State, Travel};
use pounding_contact::reduced_mass;

/// The model: floors, level by level and from left to right in each level, and the pairs of points that can touch.
///
/// A row of structures of one storey is a single level. Structures that cannot touch share no pair, and then do not enter each other's
/// arithmetic.
#[derive(Debug, Clone, PartialEq)]
pub struct Row<Column> {
    nodes: Vec<Node<Column>>,
    buildings: Buildings,
    pairs: Vec<Pair>,
    /// Incidence of pairs and nodes.
    incidence: Incidence,
    links: Vec<Link>,
    /// Incidence of links and nodes.
    linking: Incidence,
    /// Arrival of the ground motion at every node \[s\]; `None` if it arrives everywhere at t = 0.
    arrivals: Option<Vec<f64>>,
}

impl<Column: RestoringForce> Row<Column> {
    /// The shaking of the row by an excitation on a clock.
    pub(crate) fn shaken<'a>(&self, excitation: Excitation<'a>, clock: Clock) -> Shaking<'a> {
        Shaking::new(self.nodes.len(), self.travel(excitation), excitation, clock)
    }

    /// Checks and keeps the nodes and pairs.
    ///
    /// # Errors
    /// [`ModelError`] if any of these holds:
    ///
    /// - a mass, a damping, an initial state or a contact parameter is out of range, or a gap is negative;
    /// - a floor does not stand on an earlier floor, or shares it with another floor;
    /// - a pair has a point that is not in the row, or both its points are of one building or of walls;
    /// - points overlap at t = 0.
    ///
    /// The order of the left and the right point is not checked.
    pub fn new(nodes: Vec<Node<Column>>, pairs: Vec<Pair>) -> Result<Self, ModelError> {
        let unchecked = Self {
            nodes,
            buildings: Buildings::default(),
            pairs,
            incidence: Incidence::default(),
            links: Vec::new(),
            linking: Incidence::default(),
            arrivals: None,
        };
        unchecked.checked()
    }

    /// Another row in the memory of this row, with these nodes and pairs and a ground motion that arrives everywhere at t = 0.
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
        self.links.clear();
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
        self.incidence.renew(nodes.len(), pairs.iter().map(|pair| pair.relation));
        self.linking.renew(nodes.len(), std::iter::empty());
        Ok(self)
    }

    /// Checks that both points of a pair are in the row, and belong to two buildings, or to a building and a wall.
    ///
    /// Nodes do not tell which building is on the left: the lowest floor of a building may be on any level.
    fn check_points(&self, index: usize, pair: &Pair) -> Result<(), ModelError> {
        let points = pair.relation.points();
        for (side, point) in ["left", "right"].into_iter().zip(points) {
            let on_ground = matches!(point, Point::Ground(_)).then_some(PointFault::NoFloor);
            let checked = on_ground.map_or_else(|| point.check(&self.nodes), Err);
            checked.map_err(|fault| ModelError::Point { pair: index, side, fault })?;
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

    /// The row with these links.
    ///
    /// # Errors
    /// [`ModelError`] if a number of a link is out of range, an end is not in the row, no end is a floor that moves, or both ends are the
    /// same point.
    pub fn linked(mut self, links: Vec<Link>) -> Result<Self, ModelError> {
        for (index, link) in links.iter().enumerate() {
            let points = link.relation.points();
            for (side, point) in ["left", "right"].into_iter().zip(points) {
                let is_share = matches!(point, Point::Share(_));
                let checked = if is_share {
                    Err(PointFault::NoEnd)
                } else {
                    point.check(&self.nodes)
                };
                checked.map_err(|fault| ModelError::LinkEnd { link: index, side, fault })?;
            }
            let moves = |(floor, _): (usize, f64)| !self.nodes[floor].is_wall();
            if points[0] == points[1] || !link.relation.pushes().any(moves) {
                return Err(ModelError::LinkOfNothing { link: index });
            }
            link.law.check().map_err(|LinkFault { field, found, allowed }| ModelError::Link {
                link: index,
                field,
                found,
                allowed,
            })?;
        }
        self.linking.renew(self.nodes.len(), links.iter().map(|link| link.relation));
        Ok(Self { links, ..self })
    }

    /// Whether the pairs are a chain: each joins a node with the next node, both as floors, in the order of the nodes.
    pub fn is_chain(&self) -> bool {
        let follows = |pair: &Pair| pair.relation.is_level() && pair.right() == pair.left() + 1;
        let rises = |pairs: &[Pair]| pairs[0].left() < pairs[1].left();
        self.pairs.iter().all(follows) && self.pairs.windows(2).all(rises)
    }

    /// The row with a ground motion that arrives at its nodes after these times \[s\], ≥ 0. There is a time for each node; all floors of a
    /// building share it.
    ///
    /// A wave of apparent velocity v reaches a base at distance x after x/v. Every building, and every wall, then stands on a separate
    /// ground, which rests until the arrival and then follows the excitation. Displacements, velocities and accelerations remain relative
    /// to this ground, so that the motion of a building alone is only shifted in time. The deformation of a pair changes: δ = (u +
    /// `u_g`)\_left − (u + `u_g`)\_right − g, with `u_g` the exact double integral of the record ([`Travel`]). If all times are 0, the row
    /// is unchanged.
    ///
    /// # Errors
    /// [`ModelError`] if there is not a time for each node, a time is not a finite number ≥ 0, or a floor has another time than the floor
    /// below.
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

    /// The pairs that can touch, in their given order.
    pub fn pairs(&self) -> &[Pair] {
        &self.pairs
    }

    /// Incidence of pairs and nodes.
    pub(crate) fn incidence(&self) -> &Incidence {
        &self.incidence
    }

    /// The links, in their given order.
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// Incidence of links and nodes.
    pub(crate) fn linking(&self) -> &Incidence {
        &self.linking
    }

    /// The buildings that the floors form.
    pub fn buildings(&self) -> &Buildings {
        &self.buildings
    }

    /// The floor that stands on a node; `None` for the top floor of a building and for a wall.
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

    /// Whether some damping follows the tangent stiffness ([`Node::elastic_damping`]).
    pub fn has_tangent_damping(&self) -> bool {
        self.nodes.iter().any(|node| node.elastic_damping > 0.0)
    }

    /// Gives the storeys the damping that those of a `whole` row have at these tangent stiffnesses \[N/m\].
    pub(crate) fn take_damping(&mut self, whole: &Self, tangent: impl Fn(usize) -> f64) {
        for (index, (node, whole)) in self.nodes.iter_mut().zip(&whole.nodes).enumerate() {
            let yields = tangent(index) < whole.column.loaded(0.0).tangent;
            let missing = if yields { whole.elastic_damping } else { 0.0 };
            node.damping = whole.damping - missing;
        }
    }
}

impl<Column> Row<Column> {
    /// How an excitation travels along the row; `None` if it arrives at all nodes at t = 0.
    pub fn travel(&self, excitation: Excitation<'_>) -> Option<Travel> {
        let arrivals = self.arrivals.as_ref()?;
        Some(Travel::new(excitation, arrivals.clone()))
    }

    /// Arrival of the ground motion at a node \[s\].
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
    let part = (0.0..=node.damping).contains(&node.elastic_damping);
    require(part, "elastic_damping", node.elastic_damping, "0 to the damping of the storey")?;
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
