//! The second route compared with the exact method.

use pounding_reference::Response;
use pounding_solver::{Clock, Collisions, Exact, Excitation, Hysteretic, Integrator, Node, Peaks, Row, TransferredMomentum};

use super::storeys::ground;
use super::{close, run};

/// Digits on which both routes agree.
const TOLERANCE: f64 = 1e-9;

/// Impacts and pressing of a pair.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Met {
    /// Number of impacts of an impulsive law, or of touches of another law.
    pub(super) n: usize,
    /// Total impulse \[N·s\].
    impulse: f64,
    /// Largest pounding force; for an impulsive law, that of a rest without an impact \[N\].
    pub(super) force: f64,
    /// Duration of touching; for an impulsive law, of rest \[s\].
    pub(super) touching: f64,
}

/// Impulse, peak force and time of a collision.
type One = (f64, Option<f64>, f64);

impl Met {
    fn of(collisions: impl Iterator<Item = One>, impulsive: bool) -> Self {
        let mut met = Self::default();
        for (impulse, force, touching) in collisions {
            met.n += usize::from(force.is_none() || !impulsive);
            met.impulse += impulse;
            met.force = met.force.max(force.unwrap_or(0.0));
            met.touching += touching;
        }
        met
    }
}

/// The exact method on a row under shaking sampled every 0.1 s.
pub(super) fn exact<Column: Hysteretic>(row: &Row<Column>, duration: f64) -> (Peaks, TransferredMomentum, Collisions) {
    let samples = ground();
    let excitation = Excitation::new(0.1, &samples).expect("finite samples");
    let n = row.nodes().len();
    let mut recorders = (
        Peaks::new(n),
        TransferredMomentum::new(n),
        Collisions::new(n, row.pairs()).travelled(row.travel(excitation)),
    );
    let clock = Clock {
        time_step: duration,
        n_steps: 1,
    };
    Integrator::Exact(Exact::default())
        .run(row, excitation, clock, &mut recorders)
        .expect("the run ends");
    recorders
}

/// Compares both routes on a row: peaks and transferred momenta of its floors must agree.
pub(super) fn agree_on_floors<Column: Hysteretic>(
    row: &Row<Column>,
    duration: f64,
    (tolerance, what): (f64, &str),
) -> (Collisions, Response) {
    let (peaks, momentum, collisions) = exact(row, duration);
    let other = run(row, &ground(), duration);
    for (index, node) in row.nodes().iter().enumerate() {
        let what = format!("{what}, node {index}");
        let (one, other) = (peaks.of(index), &other.structures[index]);
        if !Node::is_wall(node) {
            let [one, other] = [one.displacement.value, other.displacement.value].map(f64::abs);
            close(one, other, tolerance, &what);
        }
        let found = momentum.of(index);
        close(found, other.transferred_momentum, tolerance, &what);
    }
    (collisions, other)
}

/// Compares both routes on a row; returns the results of every pair.
pub(super) fn agree<Column: Hysteretic>(row: &Row<Column>, duration: f64, what: &str) -> Vec<Met> {
    let (collisions, other) = agree_on_floors(row, duration, (TOLERANCE, what));
    let of_pair = |(pair, wanted): (usize, &Vec<pounding_reference::Collision>)| {
        let what = format!("{what}, pair {pair}");
        let impulsive = !row.pairs()[pair].law.is_compliant();
        let found = collisions.all().iter().filter(|one| one.pair == pair);
        let found = Met::of(found.map(|one| (one.impulse, one.peak_force, one.end - one.start)), impulsive);
        let wanted = wanted.iter().map(|one| (one.impulse, one.peak_force, one.end - one.start));
        let wanted = Met::of(wanted, impulsive);
        assert_eq!(found.n, wanted.n, "{what}");
        close(found.impulse, wanted.impulse, TOLERANCE, &what);
        close(found.force, wanted.force, TOLERANCE, &what);
        close(found.touching, wanted.touching, TOLERANCE, &what);
        wanted
    };
    other.collisions.iter().enumerate().map(of_pair).collect()
}
