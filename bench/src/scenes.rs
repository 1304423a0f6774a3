//! Random scenes of two buildings: two elastic structures, and two towers of bilinear storeys.

use std::f64::consts::PI;

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName, Stereomechanical};
use pounding_lanes::RowsOf;
use pounding_solver::{Bilinear, Collisions, Elastic, Hysteretic, Levels, Pair, Peaks, Row, RunError, Storey};
use rand_pcg::Pcg64;

use crate::measure::Outcome;
use crate::setting::{CLOCK, DAMPING, GAPS, GRAVITY, MASS, RESTITUTION, STIFFNESS, Way, between, random, structure};

/// Number of scenes in a group, and numbers of scenes of each law: of structures and of towers.
pub(crate) const GROUP: usize = 16;
const STRUCTURES: usize = 4096;
const TOWERS: usize = 1024;
/// Storeys of both towers.
pub(crate) const LEFT: usize = 8;
pub(crate) const RIGHT: usize = 5;
/// Smallest and largest mass of a floor of a tower, over that of a structure.
const MASSES: [f64; 2] = [0.5, 1.5];
/// Smallest and largest period of a tower over its number of storeys \[s\].
const PERIODS: [f64; 2] = [0.06, 0.15];
/// Smallest and largest base shear at yield over the weight.
const SHEARS: [f64; 2] = [0.1, 0.4];
/// Ratio of the stiffness after yielding to that before.
const HARDENING: f64 = 0.05;
/// Second frequency of the Rayleigh damping, over that of the first mode.
const DAMPED_TO: f64 = 5.0;

/// Numbers of a group of scenes of two buildings, with storeys from the ground up.
#[derive(Debug, Clone)]
pub(crate) struct Group<const L: usize, const R: usize> {
    pub(crate) left: [[Storey<Bilinear>; L]; GROUP],
    pub(crate) right: [[Storey<Bilinear>; R]; GROUP],
    pub(crate) gaps: [f64; GROUP],
}

/// Impacts, and the nonlinear viscoelastic element.
pub(crate) fn laws() -> Outcome<[ContactLaw; 2]> {
    let restitution = RESTITUTION;
    let element = LawName::NonlinearViscoelastic;
    Ok([
        ContactLaw::Stereomechanical(Stereomechanical { restitution }),
        element.calibrated(STIFFNESS, restitution, Calibration::Exact, &FreePair::UNIT)?,
    ])
}

/// Whether a law is impulsive, and its numbers: e, or β̄ \[N/m^1.5\] and ξ̄ \[–\].
pub(crate) fn numbers(law: ContactLaw) -> (bool, [f64; 2]) {
    if let ContactLaw::NonlinearViscoelastic(law) = law {
        return (false, [law.impact_stiffness, law.impact_damping_ratio]);
    }
    (true, [RESTITUTION, 0.0])
}

/// Two structures, in groups.
pub(crate) fn structures() -> Vec<Group<1, 1>> {
    let mut random = random();
    let mut group = || {
        let scenes: [_; GROUP] = std::array::from_fn(|_| {
            let pair = [structure(&mut random), structure(&mut random)];
            (pair, between(&mut random, GAPS))
        });
        Group {
            left: scenes.map(|([left, _], _)| [left]),
            right: scenes.map(|([_, right], _)| [right]),
            gaps: scenes.map(|(_, gap)| gap),
        }
    };
    (0..STRUCTURES / GROUP).map(|_| group()).collect()
}

/// Two towers, in groups.
pub(crate) fn towers() -> Vec<Group<LEFT, RIGHT>> {
    let mut random = random();
    let mut group = || Group {
        left: std::array::from_fn(|_| tower(&mut random)),
        right: std::array::from_fn(|_| tower(&mut random)),
        gaps: std::array::from_fn(|_| between(&mut random, GAPS)),
    };
    (0..TOWERS / GROUP).map(|_| group()).collect()
}

/// A tower of equal floors and storeys. They yield at a share of the weight that falls with the number of floors above.
fn tower<const N: usize>(random: &mut Pcg64) -> [Storey<Bilinear>; N] {
    let mass = MASS * between(random, MASSES);
    let omega = 2.0 * PI / (N as f64 * between(random, PERIODS));
    let shear = between(random, SHEARS);
    // The first mode of a row of equal masses and springs.
    let of_storey = omega / (2.0 * libm::sin(0.5 * PI / (2 * N + 1) as f64));
    let stiffness = mass * of_storey * of_storey;
    let sum = (1.0 + DAMPED_TO) * omega;
    std::array::from_fn(|level| Storey {
        mass,
        damping: 2.0 * DAMPING / sum * stiffness,
        ground_damping: 2.0 * DAMPING * DAMPED_TO * omega * omega / sum * mass,
        column: Bilinear {
            stiffness,
            yield_force: shear * GRAVITY * mass * (N - level) as f64,
            hardening: HARDENING,
        },
    })
}

/// Columns that can run in lanes.
pub(crate) trait Beside: Hysteretic {
    /// The leaner column if the bilinear column never yields.
    fn of(column: Bilinear) -> Self;
    fn rows<'a>(rows: &'a [&'a Row<Self>]) -> RowsOf<'a>;
}

impl Beside for Elastic {
    fn of(column: Bilinear) -> Self {
        let stiffness = column.stiffness;
        Self { stiffness }
    }
    fn rows<'a>(rows: &'a [&'a Row<Self>]) -> RowsOf<'a> {
        RowsOf::Elastic(rows)
    }
}

impl Beside for Bilinear {
    fn of(column: Bilinear) -> Self {
        column
    }
    fn rows<'a>(rows: &'a [&'a Row<Self>]) -> RowsOf<'a> {
        RowsOf::Bilinear(rows)
    }
}

/// The scenes of groups as rows.
pub(crate) fn rows<Column: Beside, const L: usize, const R: usize>(groups: &[Group<L, R>], law: ContactLaw) -> Outcome<Vec<Row<Column>>> {
    let levels = Levels::new(&[L, R]);
    let row = |group: &Group<L, R>, lane: usize| {
        let node = |node: usize| {
            let (building, storey) = levels.place(node);
            let buildings = [&group.left[lane][..], &group.right[lane][..]];
            let storey = buildings[building][storey];
            let column = Column::of(storey.column);
            let (mass, damping) = (storey.mass, storey.damping);
            let ground_damping = storey.ground_damping;
            levels.floor(
                node,
                Storey {
                    mass,
                    damping,
                    ground_damping,
                    column,
                },
            )
        };
        let pair = |(left, right)| Pair::of_floors(left, right, group.gaps[lane], law);
        let nodes = (0..L + R).map(node).collect();
        Row::new(nodes, levels.facing(0).map(pair).collect())
    };
    let scenes = groups.iter().flat_map(|group| (0..GROUP).map(move |lane| (group, lane)));
    Ok(scenes.map(|(group, lane)| row(group, lane)).collect::<Result<_, _>>()?)
}

/// A run of a scene alone, with the recorders that give the numbers of lanes.
pub(crate) fn alone<Column: Hysteretic>(row: &Row<Column>, (integrator, excitation): Way<'_>) -> Result<(Peaks, Collisions), RunError> {
    let n = row.nodes().len();
    let mut recorder = (Peaks::new(n), Collisions::new(n, row.pairs()));
    integrator.run(row, excitation, CLOCK, &mut recorder)?;
    Ok(recorder)
}
