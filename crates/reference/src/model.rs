//! The row as plain numbers, and their places in the vector of unknowns.

use pounding_solver::{Hysteretic, Node, Pair, Point, Row, Share, Support};

use super::law::Law;
use super::storey::{Smooth, StoreyColumns};

/// Index in the vector of unknowns of the time within the present segment of the record \[s\].
///
/// Displacement and velocity of each structure follow, then the impulse of the present collision of each pair. The deformation and its rate
/// of each pair are next. The elastic part of the drift of each storey with smoothly yielding columns is last.
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
    /// Structures of the row, then, as walls, the grounds of points between a ground and a first floor.
    pub structures: Vec<Structure>,
    /// Number of nodes of the row.
    pub n_nodes: usize,
    pub pairs: Vec<Neighbours>,
    /// Number of storeys with columns that yield smoothly.
    n_smooth: usize,
}

/// A floor with the storey below it, or a wall with inverse mass 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Structure {
    pub inverse_mass: f64,
    /// Floor on which the storey stands; `None` on the ground.
    pub below: Option<usize>,
    /// Damping coefficient of the storey \[N·s/m\].
    pub damping: f64,
    /// What yielding takes of it \[N·s/m\].
    pub elastic_damping: f64,
    /// Damping coefficient of the floor against the ground, in addition to that of a storey on the ground \[N·s/m\].
    pub ground_damping: f64,
    pub columns: StoreyColumns,
    /// Arrival of the ground motion \[s\].
    pub arrival: f64,
    pub initial_displacement: f64,
    pub initial_velocity: f64,
}

/// A point with a part `lean` of the far floor's motion and the rest of the near floor's motion. On a floor both are this floor.
#[derive(Debug, Clone, Copy)]
struct Spot {
    near: usize,
    far: usize,
    lean: f64,
}

impl Spot {
    /// Value at the point of a quantity of floors; exactly that of the floors if they agree.
    fn of(self, quantity: impl Fn(usize) -> f64) -> f64 {
        let near = quantity(self.near);
        near + self.lean * (quantity(self.far) - near)
    }

    /// Parts of a force on the point that the floors carry.
    fn parts(self) -> impl Iterator<Item = (usize, f64)> {
        let parts = [(self.near, 1.0 - self.lean), (self.far, self.lean)];
        parts.into_iter().filter(|(_, part)| *part > 0.0)
    }
}

/// Two points that can touch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbours {
    left: Spot,
    right: Spot,
    pub gap: f64,
    /// Index of the deformation in the vector of unknowns, followed by its rate.
    pub deformation: usize,
    pub reduced_mass: f64,
    pub law: Law,
}

impl Neighbours {
    /// Left point minus right point, in a quantity of floors.
    pub(super) fn ahead(&self, quantity: impl Fn(usize) -> f64) -> f64 {
        self.left.of(&quantity) - self.right.of(&quantity)
    }

    /// Parts of floors and walls in the rate of deformation. A force pushes each by its part, with opposite sign.
    pub(super) fn parts(&self) -> impl Iterator<Item = (usize, f64)> {
        let right = self.right.parts().map(|(floor, part)| (floor, -part));
        self.left.parts().chain(right)
    }

    /// The part of a floor; 0 if the pair does not meet it.
    pub(super) fn part(&self, floor: usize) -> f64 {
        let parts = self.parts().filter(|(met, _)| *met == floor);
        parts.fold(0.0, |sum, (_, part)| sum + part)
    }

    /// Size of the terms of the difference, from the sizes of the quantity at floors.
    pub(super) fn size(&self, sizes: impl Fn(usize) -> f64) -> f64 {
        self.parts().map(|(floor, part)| part.abs() * sizes(floor)).sum()
    }

    /// A floor or wall on the ground of the left point, and another on that of the right point.
    pub(super) fn grounds(&self) -> [usize; 2] {
        [self.left.near, self.right.near]
    }
}

impl Model {
    pub(super) fn new<Column: Hysteretic>(row: &Row<Column>) -> Self {
        let nodes = row.nodes().iter().enumerate();
        let mut structures: Vec<_> = nodes.map(|(index, node)| structure(node, row.arrival(index))).collect();
        let n_nodes = structures.len();
        let spots = |pair: &Pair| {
            let points = [pair.relation.left, pair.relation.right];
            points.map(|point| spot(point, &mut structures))
        };
        let spots: Vec<_> = row.pairs().iter().map(spots).collect();
        let n_pairs = row.pairs().len();
        let of_pairs = 1 + 2 * structures.len() + n_pairs;
        let first = of_pairs + 2 * n_pairs;
        let mut next = first;
        for structure in &mut structures {
            if let Some(Smooth { unknown, .. }) = &mut structure.columns.smooth {
                *unknown = next;
                next += 1;
            }
        }
        let neighbours = |(index, (pair, [left, right])): (usize, (&Pair, [Spot; 2]))| {
            let parts = left.parts().chain(right.parts());
            let mobility = |(floor, part): (usize, f64)| part * part * structures[floor].inverse_mass;
            let reduced_mass = 1.0 / parts.map(mobility).sum::<f64>();
            Neighbours {
                left,
                right,
                gap: pair.relation.offset,
                deformation: of_pairs + 2 * index,
                reduced_mass,
                law: Law::of(pair.law, reduced_mass),
            }
        };
        let pairs = row.pairs().iter().zip(spots).enumerate();
        let pairs = pairs.map(neighbours).collect();
        Self {
            pairs,
            n_nodes,
            n_smooth: next - first,
            structures,
        }
    }

    /// Number of unknowns.
    pub(super) fn n_unknowns(&self) -> usize {
        1 + 2 * self.structures.len() + 3 * self.pairs.len() + self.n_smooth
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
            pair.ahead(|floor| self.structures[floor].initial_displacement) - pair.gap,
            pair.ahead(|floor| self.structures[floor].initial_velocity),
        ]
    }

    pub(super) fn is_wall(&self, structure: usize) -> bool {
        self.structures[structure].inverse_mass == 0.0
    }

    /// Changes the velocity of a structure, and the rate of every pair at it.
    pub(super) fn push(&self, structure: usize, gained: f64, unknowns: &mut [f64]) {
        unknowns[velocity(structure)] += gained;
        for pair in &self.pairs {
            unknowns[pair.deformation + 1] += pair.part(structure) * gained;
        }
    }
}

/// A point of the row; a ground that it shares becomes another wall.
fn spot(point: Point, structures: &mut Vec<Structure>) -> Spot {
    let (near, far, lean) = match point {
        Point::Floor(floor) => (Some(floor), Some(floor), 0.0),
        Point::Share(Share { base, other, lean }) => (base, other, lean),
        Point::Ground(_) => (None, None, 0.0),
    };
    let floor = point.floor();
    let mut or_ground = |met: Option<usize>| {
        met.unwrap_or_else(|| {
            let carried = structures[floor];
            structures.push(Structure {
                inverse_mass: 0.0,
                below: None,
                columns: StoreyColumns {
                    smooth: None,
                    ..carried.columns
                },
                initial_displacement: 0.0,
                initial_velocity: 0.0,
                ..carried
            });
            structures.len() - 1
        })
    };
    Spot {
        near: or_ground(near),
        far: or_ground(far),
        lean,
    }
}

fn structure<Column: Hysteretic>(node: &Node<Column>, arrival: f64) -> Structure {
    let (below, ground_damping) = match node.support {
        Support::Ground => (None, 0.0),
        Support::Floor(floor) => (Some(floor.below), floor.ground_damping),
    };
    Structure {
        inverse_mass: node.inverse_mass,
        below,
        damping: node.damping,
        elastic_damping: node.elastic_damping,
        ground_damping,
        columns: StoreyColumns::of(node.column.hysteresis()),
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
}
