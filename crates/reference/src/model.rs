//! The row as plain numbers, and their places in the vector of unknowns.

use pounding_solver::{Hysteretic, Knee, Node, Pair, Row, Support};

use super::SecondRouteError;
use super::ends::Ends;
use super::law::Law;
use super::links::Link;
use super::storey::{Friction, Smooth, StoreyColumns, Structure};

/// Index in the vector of unknowns of the time within the present segment of the record \[s\].
///
/// Displacement and velocity of each structure follow, then the impulse of the present collision of each pair. The deformation and its rate
/// of each pair are next. The elastic part of the drift of each storey with smoothly yielding columns follows, or the impulse of its friction,
/// then the force of each link that flows.
///
/// A deformation is a separate unknown, because a difference of displacements would lose the digits of small bounces.
pub(super) const TIME: usize = 0;

/// Index of a structure's displacement in the vector of unknowns.
pub(super) fn displacement(structure: usize) -> usize {
    1 + 2 * structure
}

/// Index of a structure's velocity in the vector of unknowns.
pub(super) fn velocity(structure: usize) -> usize {
    2 + 2 * structure
}

/// The row as plain numbers.
#[derive(Debug, Clone)]
pub(super) struct Model {
    /// Structures of the row, then, as walls, the grounds of points on a ground or between a ground and a first floor.
    pub structures: Vec<Structure>,
    /// Number of nodes of the row.
    pub n_nodes: usize,
    pub pairs: Vec<Neighbours>,
    pub links: Vec<Link>,
    n_unknowns: usize,
}

/// Two points that can touch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbours {
    pub ends: Ends,
    pub gap: f64,
    /// Index of the deformation in the vector of unknowns, followed by its rate.
    pub deformation: usize,
    pub reduced_mass: f64,
    pub law: Law,
}

impl Model {
    /// # Errors
    /// A link has a law, or a storey columns, that this program does not integrate.
    pub(super) fn new<Column: Hysteretic>(row: &Row<Column>) -> Result<Self, SecondRouteError> {
        let sticks = |node: &Node<Column>| node.column.hysteresis().knee == Knee::Rigid && node.support != Support::Ground;
        if let Some(node) = row.nodes().iter().position(sticks) {
            return Err(SecondRouteError::Sticks { node });
        }
        let nodes = row.nodes().iter().enumerate();
        let mut structures: Vec<_> = nodes.map(|(index, node)| structure(node, index, row.arrival(index))).collect();
        let n_nodes = structures.len();
        let sides = row.pairs().iter().map(|pair| Ends::new(pair.relation, &mut structures));
        let sides: Vec<_> = sides.collect();
        let n_pairs = row.pairs().len();
        let links = row.links().iter().enumerate();
        let links: Result<Vec<_>, _> = links.map(|(index, link)| Link::new(index, link, &mut structures)).collect();
        let mut links = links?;
        let of_pairs = 1 + 2 * structures.len() + n_pairs;
        let mut next = of_pairs + 2 * n_pairs;
        for structure in &mut structures {
            if let Some(Smooth { unknown, .. }) = &mut structure.columns.smooth {
                *unknown = next;
                next += 1;
            }
            if let Some(friction) = &mut structure.friction {
                friction.unknown = next;
                next += 1;
            }
        }
        for link in &mut links {
            next += link.number(next);
        }
        unite(&mut structures, &links);
        let neighbours = |(index, (pair, ends)): (usize, (&Pair, Ends))| {
            let mobility = |(floor, part): (usize, f64)| part * part * structures[floor].inverse_mass;
            let reduced_mass = 1.0 / ends.parts().map(mobility).sum::<f64>();
            Neighbours {
                ends,
                gap: pair.relation.offset,
                deformation: of_pairs + 2 * index,
                reduced_mass,
                law: Law::of(pair.law, reduced_mass),
            }
        };
        let pairs = row.pairs().iter().zip(sides).enumerate();
        let pairs = pairs.map(neighbours).collect();
        Ok(Self {
            pairs,
            links,
            n_nodes,
            n_unknowns: next,
            structures,
        })
    }

    /// Number of unknowns.
    pub(super) fn n_unknowns(&self) -> usize {
        self.n_unknowns
    }

    /// Index of the impulse of a pair's present collision in the vector of unknowns.
    pub(super) fn impulse(&self, pair: usize) -> usize {
        1 + 2 * self.structures.len() + pair
    }

    /// Displacement of a floor relative to the support of its storey \[m\].
    pub(super) fn drift(&self, structure: usize, unknowns: &[f64]) -> f64 {
        let of_floor = unknowns[displacement(structure)];
        match self.structures[structure].below {
            None => of_floor,
            Some(below) => of_floor - unknowns[displacement(below)],
        }
    }

    /// Rate of the drift \[m/s\].
    pub(super) fn drift_rate(&self, structure: usize, unknowns: &[f64]) -> f64 {
        let of_floor = unknowns[velocity(structure)];
        match self.structures[structure].below {
            None => of_floor,
            Some(below) => of_floor - unknowns[velocity(below)],
        }
    }

    /// Drift at t = 0 \[m\].
    pub(super) fn initial_drift(&self, structure: &Structure) -> f64 {
        let below = structure.below.map(|below| self.structures[below].initial_displacement);
        structure.initial_displacement - below.unwrap_or(0.0)
    }

    /// Deformation δ of a pair \[m\]; negative while apart.
    pub(super) fn deformation(&self, pair: usize, unknowns: &[f64]) -> f64 {
        unknowns[self.pairs[pair].deformation]
    }

    /// Rate of deformation of a pair \[m/s\], positive while approaching.
    pub(super) fn rate(&self, pair: usize, unknowns: &[f64]) -> f64 {
        unknowns[self.pairs[pair].deformation + 1]
    }

    /// Deformation of a pair \[m\] and its rate \[m/s\] at t = 0, when grounds are at rest.
    pub(super) fn initial_deformation(&self, pair: &Neighbours) -> [f64; 2] {
        [
            pair.ends.ahead(|floor| self.structures[floor].initial_displacement) - pair.gap,
            pair.ends.ahead(|floor| self.structures[floor].initial_velocity),
        ]
    }

    pub(super) fn is_wall(&self, structure: usize) -> bool {
        self.structures[structure].inverse_mass == 0.0
    }

    /// Changes the velocity of a structure, and the rate of every pair at it.
    pub(super) fn push(&self, structure: usize, gained: f64, unknowns: &mut [f64]) {
        unknowns[velocity(structure)] += gained;
        for pair in &self.pairs {
            unknowns[pair.deformation + 1] += pair.ends.part(structure) * gained;
        }
    }
}

/// Finds the body of every structure.
fn unite(structures: &mut [Structure], links: &[Link]) {
    let storeys = structures
        .iter()
        .enumerate()
        .filter_map(|(floor, structure)| Some([floor, structure.below?]));
    let mut joined: Vec<_> = storeys.collect();
    for link in links {
        let moving = link
            .ends
            .parts()
            .map(|(floor, _)| floor)
            .filter(|floor| structures[*floor].inverse_mass > 0.0);
        let moving: Vec<_> = moving.collect();
        joined.extend(moving.windows(2).map(|two| [two[0], two[1]]));
    }
    for [one, other] in joined {
        let bodies = [structures[one].body, structures[other].body];
        for structure in structures.iter_mut().filter(|structure| bodies.contains(&structure.body)) {
            structure.body = bodies[0].min(bodies[1]);
        }
    }
}

fn structure<Column: Hysteretic>(node: &Node<Column>, index: usize, arrival: f64) -> Structure {
    let (below, ground_damping) = match node.support {
        Support::Ground => (None, 0.0),
        Support::Floor(floor) => (Some(floor.below), floor.ground_damping),
    };
    let hysteresis = node.column.hysteresis();
    let sticks = hysteresis.knee == Knee::Rigid && !node.is_wall();
    Structure {
        inverse_mass: node.inverse_mass,
        below,
        body: index,
        damping: node.damping,
        elastic_damping: node.elastic_damping,
        ground_damping,
        columns: StoreyColumns::of(hysteresis),
        friction: sticks.then_some(Friction {
            limit: hysteresis.yield_force,
            inverse_mass: node.inverse_mass,
            // The model numbers the unknown.
            unknown: 0,
        }),
        arrival,
        initial_displacement: node.initial_displacement,
        initial_velocity: node.initial_velocity,
    }
}

impl Model {
    /// Storeys with smooth columns, with the places of their unknowns z.
    pub(super) fn smooth(&self) -> impl Iterator<Item = (usize, Smooth)> {
        let storeys = self.structures.iter().enumerate();
        storeys.filter_map(|(index, storey)| Some((index, storey.columns.smooth?)))
    }

    /// Friction below a floor \[N\], from the derivative of the unknowns, limited despite rounding; 0 without any.
    pub(super) fn friction(&self, structure: usize, slope: &[f64]) -> f64 {
        let friction = self.structures[structure].friction;
        friction.map_or(0.0, |Friction { limit, unknown, .. }| slope[unknown].clamp(-limit, limit))
    }

    /// Floors with friction below them.
    pub(super) fn frictions(&self) -> impl Iterator<Item = (usize, Friction)> {
        let storeys = self.structures.iter().enumerate();
        storeys.filter_map(|(index, storey)| Some((index, storey.friction?)))
    }
}
