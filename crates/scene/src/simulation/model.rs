//! Converts a scene for the solver: the leanest row that models it, the integrator and the clock.

use crate::simulation::floors::{Floor, FloorPair, Floors};
use crate::{Columns, Method, Scene, Standing, Structure};
use pounding_contact::{ContactLaw, LinearSpring, Stereomechanical};
use pounding_solver::{
    AnyRow, Bilinear, BoucWen, CentralDifference, Clock, Elastic, Exact, Hht, Hysteretic, Integrator, Link, Mixed, ModelError, MoreauJean,
    Newmark, Node, Pair, Point, Relation, Rk4, Row, Sliding, Smoothness, Storey, Verlet,
};

/// Gap of neighbours that stand apart in a scene, if all pairs are modelled \[m\].
const OUT_OF_REACH: f64 = 1e9;

/// Kinds of columns; the storey with the richest kind decides for the row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Asked {
    Nothing,
    Yielding,
    /// Or sliding.
    Bending,
}

impl Asked {
    fn of(columns: &Columns) -> Self {
        match (columns.yield_force_n, columns.bouc_wen) {
            _ if columns.friction_n.is_some() => Self::Bending,
            (None, _) => Self::Nothing,
            (Some(_), Some(_)) => Self::Bending,
            (Some(_), None) => Self::Yielding,
        }
    }
}

/// Returns the leanest row of a checked scene.
pub(super) fn lean(scene: &Scene, floors: &Floors) -> Result<AnyRow, ModelError> {
    let made = floors.all().iter().filter_map(|floor| floor.made_of);
    let most = made.map(|made| Asked::of(&made.columns)).max();
    let pairs = pairs(scene, floors).collect();
    match most.unwrap_or(Asked::Nothing) {
        Asked::Nothing => row(scene, floors, elastic, pairs).map(AnyRow::Elastic),
        Asked::Yielding => row(scene, floors, bilinear, pairs).map(AnyRow::Bilinear),
        Asked::Bending => row(scene, floors, mixed, pairs).map(AnyRow::Mixed),
    }
}

/// Gives a row the numbers of another scene, without new memory.
pub(super) fn renumber(any: &mut AnyRow, scene: &Scene, floors: &Floors) -> Result<(), ModelError> {
    match any {
        AnyRow::Elastic(row) => renumbered(row, scene, floors, elastic),
        AnyRow::Bilinear(row) => renumbered(row, scene, floors, bilinear),
        AnyRow::Mixed(row) => renumbered(row, scene, floors, mixed),
    }
}

/// Returns the row with everything that a scene can ask for: columns that remember yielding, and all floors that face each other as pairs.
pub(super) fn full(scene: &Scene, floors: &Floors) -> Result<AnyRow, ModelError> {
    let pairs = match &scene.contacts {
        Some(_) => pairs(scene, floors).collect(),
        None => pairs_out_of_reach(floors),
    };
    match lean(scene, floors)? {
        AnyRow::Elastic(_) | AnyRow::Bilinear(_) => row(scene, floors, bilinear, pairs).map(AnyRow::Bilinear),
        AnyRow::Mixed(_) => row(scene, floors, mixed, pairs).map(AnyRow::Mixed),
    }
}

fn elastic(columns: &Columns) -> Elastic {
    Elastic {
        stiffness: columns.stiffness_n_per_m,
    }
}

fn bilinear(columns: &Columns) -> Bilinear {
    Bilinear {
        stiffness: columns.stiffness_n_per_m,
        yield_force: columns.yield_force_n.unwrap_or(f64::INFINITY),
        hardening: columns.hardening_ratio.unwrap_or(0.0),
    }
}

fn mixed(columns: &Columns) -> Mixed {
    let sharp = bilinear(columns);
    if let Some(friction) = columns.friction_n {
        return Mixed::Sliding(Sliding {
            stiffness: sharp.stiffness,
            friction,
        });
    }
    match columns.bouc_wen {
        None => Mixed::Sharp(sharp),
        Some(smooth) => Mixed::Smooth(BoucWen {
            stiffness: sharp.stiffness,
            yield_force: sharp.yield_force,
            hardening: sharp.hardening,
            smoothness: Smoothness {
                exponent: smooth.exponent,
                unloading: smooth.beta,
            },
        }),
    }
}

fn pairs(scene: &Scene, floors: &Floors) -> impl Iterator<Item = Pair> {
    let contacts = scene.contacts.as_deref().unwrap_or_default();
    let pair = |facing: &FloorPair| {
        let contact = &contacts[facing.contact];
        let [left, right] = floors.points(facing);
        let bends = floors.column_of(facing).and_then(|column| column.bending_stiffness(floors));
        Pair::new(left, right, contact.gap_m, in_series(contact.law, bends))
    };
    floors.facing().iter().map(pair)
}

/// The law of a contact with a column that bends: of a linear spring, both stiffnesses stand in series. Other laws are left as they are.
fn in_series(law: ContactLaw, bending: Option<f64>) -> ContactLaw {
    match (law, bending) {
        (ContactLaw::LinearSpring(LinearSpring { impact_stiffness }), Some(bending)) => ContactLaw::LinearSpring(LinearSpring {
            impact_stiffness: impact_stiffness * bending / (impact_stiffness + bending),
        }),
        _ => law,
    }
}

/// The links of a scene; an error for a link that a checked scene does not have.
fn links(scene: &Scene, floors: &Floors) -> Result<Vec<Link>, ModelError> {
    let point = |Standing { structure, floor }| {
        let nodes = floors.of_structure(structure);
        match floor.and_then(|floor| nodes.get(floor)) {
            Some(node) => Point::Floor(*node),
            None => Point::Ground(nodes[0]),
        }
    };
    let link = |(index, link): (usize, &crate::Link)| {
        let unchecked = |_| ModelError::LinkOfNothing { link: index };
        let [left, right] = link.ends(scene).map_err(unchecked)?.map(point);
        let relation = Relation { left, right, offset: 0.0 };
        let law = link.law.for_solver().map_err(unchecked)?;
        Ok(Link { relation, law })
    };
    scene.links.iter().enumerate().map(link).collect()
}

fn pairs_out_of_reach(floors: &Floors) -> Vec<Pair> {
    let walls = |node: usize| floors.all()[node].is_wall();
    let facing = floors.all_facing().into_iter();
    facing
        .filter(|(_, left, right)| !(walls(*left) && walls(*right)))
        .map(|(_, left, right)| {
            Pair::of_floors(
                left,
                right,
                OUT_OF_REACH,
                ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.0 }),
            )
        })
        .collect()
}

fn row<Column: Hysteretic>(
    scene: &Scene,
    floors: &Floors,
    column: impl Fn(&Columns) -> Column,
    pairs: Vec<Pair>,
) -> Result<Row<Column>, ModelError> {
    let row = Row::new(nodes(scene, floors, column).collect(), pairs)?.linked(links(scene, floors)?)?;
    match &scene.arrivals_s {
        None => Ok(row),
        Some(arrivals) => {
            let arrival = |floor: &Floor| arrivals[floor.structure];
            row.delayed(floors.all().iter().map(arrival).collect())
        }
    }
}

/// Gives a row other numbers, without new memory. The motion arrives everywhere at once.
fn renumbered<Column: Hysteretic>(
    row: &mut Row<Column>,
    scene: &Scene,
    floors: &Floors,
    column: impl Fn(&Columns) -> Column,
) -> Result<(), ModelError> {
    let nothing = Row::new(Vec::new(), Vec::new())?;
    let before = std::mem::replace(row, nothing);
    let renewed = before.renewed(nodes(scene, floors, column), pairs(scene, floors))?;
    *row = if scene.links.is_empty() {
        renewed
    } else {
        renewed.linked(links(scene, floors)?)?
    };
    Ok(())
}

fn nodes<Column>(scene: &Scene, floors: &Floors, column: impl Fn(&Columns) -> Column) -> impl Iterator<Item = Node<Column>> {
    // The dampings of a building are found together. The search ends with the last building, so that structures of one storey need no
    // memory.
    let of_building = |one: &Structure| match one {
        Structure::Building(building) => building.dampings().into_iter().zip(building.elastic_dampings()).collect(),
        Structure::Sdof(_) | Structure::Wall => Vec::new(),
    };
    let is_building = |one: &Structure| matches!(one, Structure::Building(_));
    let up_to = scene.structures.iter().rposition(is_building);
    let up_to = up_to.map_or(0, |last| last + 1);
    let dampings: Vec<_> = scene.structures[..up_to].iter().map(of_building).collect();
    let node = move |(index, floor): (usize, &Floor)| {
        let Some(made) = floor.made_of else {
            return Node::wall(column(&Columns::elastic(1.0)));
        };
        let (_, storey) = floors.levels().place(index);
        let ((damping, ground_damping), elastic_damping) = match &scene.structures[floor.structure] {
            Structure::Sdof(sdof) => ((sdof.damping_coefficient(), 0.0), sdof.elastic_damping()),
            Structure::Building(_) | Structure::Wall => dampings[floor.structure][storey],
        };
        let storey = Storey {
            mass: made.mass_kg,
            damping,
            ground_damping,
            column: column(&made.leaning_columns()),
        };
        Node {
            elastic_damping,
            initial_displacement: made.initial_displacement_m,
            initial_velocity: made.initial_velocity_m_per_s,
            ..floors.levels().floor(index, storey)
        }
    };
    floors.all().iter().enumerate().map(node)
}

impl Method {
    /// Returns the method for the solver, without its time step.
    pub(crate) fn integrator(self) -> Integrator {
        match self {
            Self::CentralDifference { contact_substeps, .. } => Integrator::CentralDifference(CentralDifference { contact_substeps }),
            Self::Newmark { beta, gamma, .. } => Integrator::Newmark(Newmark { beta, gamma }),
            Self::Hht { alpha, .. } => Integrator::Hht(Hht { alpha }),
            Self::VelocityVerlet { impacts, .. } => Integrator::Verlet(Verlet { impacts }),
            Self::Rk4 { .. } => Integrator::Rk4(Rk4),
            Self::MoreauJean { theta, .. } => Integrator::MoreauJean(MoreauJean { theta }),
            Self::Exact {
                tolerance,
                simultaneous_impacts,
            } => Integrator::Exact(Exact {
                tolerance,
                simultaneous_impacts,
            }),
            Self::Accuracy(_) => unreachable!("the method for an accuracy is found before"),
        }
    }

    /// Returns the time steps of a run of some duration \[s\]; a single one for the exact method, which needs only the end.
    pub fn clock(self, duration: f64) -> Clock {
        let time_step = self.time_step().unwrap_or(duration);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked: 0 < n <= 1e9")]
        let n_steps = (duration / time_step).round() as usize;
        Clock { time_step, n_steps }
    }
}
