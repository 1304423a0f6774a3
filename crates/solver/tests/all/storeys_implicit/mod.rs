//! Buildings of several storeys by the implicit methods.

mod extremes;
mod limits;
mod momentum;
mod orders;

pub(crate) use momentum::Momentum;

use pounding_contact::{ContactLaw, LinearSpring};
use pounding_solver::{
    Bilinear, BoucWen, Clock, Elastic, Excitation, Histories, Hysteretic, Integrator, Pair, Recorder, Row, Smoothness, State, Work,
};

use crate::common::{AVERAGE, HHT, LINEAR, MOREAU_JEAN, moreau_jean};
use crate::towers::{Rayleigh, Tower, uniform};
use crate::watch::Watch;

const IMPLICIT: [(&str, Integrator); 4] = [
    ("Newmark 1/4", AVERAGE),
    ("Newmark 1/6", LINEAR),
    ("HHT -0.1", HHT),
    ("Moreau-Jean 1/2", MOREAU_JEAN),
];
pub(crate) const DAMPING: Rayleigh = Rayleigh { alpha: 0.3, beta: 0.002 };
const SPRING: ContactLaw = ContactLaw::LinearSpring(LinearSpring { impact_stiffness: 9.35e7 });

/// All levels that face each other, with a common gap and law.
pub(crate) fn facing(gap: f64, law: ContactLaw) -> impl Fn(usize, usize, [usize; 2]) -> Option<Pair> {
    move |_, _, [left, right]| Some(Pair::of_floors(left, right, gap, law))
}

/// A tower of three floors, and a stiffer, heavier tower of two.
fn towers<Column: Copy>(column: impl Fn(f64) -> Column) -> [Tower<Column>; 2] {
    [uniform(3, 1e5, column(5e7)), uniform(2, 3e5, column(4e8))]
}

pub(crate) fn elastic(stiffness: f64) -> Elastic {
    Elastic { stiffness }
}

fn plastic(stiffness: f64) -> Bilinear {
    let yield_force = 0.006 * stiffness;
    Bilinear {
        stiffness,
        yield_force,
        hardening: 0.0,
    }
}

fn bilinear(stiffness: f64) -> Bilinear {
    Bilinear {
        stiffness,
        yield_force: 0.006 * stiffness,
        hardening: 0.05,
    }
}

fn smooth(stiffness: f64) -> BoucWen {
    BoucWen {
        stiffness,
        yield_force: 0.006 * stiffness,
        hardening: 0.05,
        smoothness: Smoothness {
            exponent: 2,
            unloading: 0.5,
        },
    }
}

pub(crate) fn run<Column: Hysteretic, R: Recorder>(
    row: &Row<Column>,
    method: Integrator,
    (ground, clock): (&[f64], Clock),
    recorder: &mut R,
) -> Work {
    let excitation = Excitation::new(0.01, ground).expect("a finite ground motion");
    method
        .watch(row, excitation, clock, recorder)
        .unwrap_or_else(|error| panic!("{method:?}: {error}"))
}

/// States of every node every 0.02 s.
fn sampled<Column: Hysteretic>(row: &Row<Column>, method: Integrator, ground: &[f64], clock: Clock) -> (Vec<Vec<State>>, Work) {
    let n = row.nodes().len();
    let duration = clock.time_step * clock.n_steps as f64;
    let mut histories = Histories::new(n, 0.02, duration);
    let work = run(row, method, (ground, clock), &mut histories);
    let states = |node: usize| histories.of(node).states.clone();
    ((0..n).map(states).collect(), work)
}

/// Largest difference of displacements.
fn apart(one: &[Vec<State>], other: &[Vec<State>]) -> f64 {
    let states = one.iter().flatten().zip(other.iter().flatten());
    states
        .map(|(one, other)| (one.displacement - other.displacement).abs())
        .fold(0.0, f64::max)
}

/// Largest difference of totals, relative to the largest total.
pub(crate) fn off(found: &[f64], wanted: &[f64]) -> f64 {
    let largest = wanted.iter().fold(0.0, |most: f64, total| most.max(total.abs()));
    let pairs = found.iter().zip(wanted);
    pairs.map(|(found, wanted)| (found - wanted).abs() / largest).fold(0.0, f64::max)
}

/// The four implicit methods, and Moreau–Jean stepping with the most damping.
fn all() -> impl Iterator<Item = (&'static str, Integrator)> {
    IMPLICIT.into_iter().chain([("Moreau-Jean 1", moreau_jean(1.0))])
}
