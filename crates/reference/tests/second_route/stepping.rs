//! Towers that pound each other, by the second route and by the classical Runge–Kutta method with shrinking steps.
//!
//! A touch reduces the order of this method to two if the force begins like δ, and further if it begins like δ^(1/4). A sharp knee of
//! columns also reduces it to two. Its steps do not depend on events.

use pounding_contact::ContactLaw;
use pounding_reference::Response;
use pounding_solver::{Bilinear, BoucWen, Clock, Excitation, Hysteretic, Impact, Integrator, Recorder, Rk4, Row, Smoothness, Span, State};

use super::storeys::{ALPHA, BETA, Building, TOWERS, buildings, elastic, ground, spring};
use super::{run, viscoelastic};

const DURATION: f64 = 3.0;

/// Last state of every node.
struct Ends(Vec<State>);

impl Recorder for Ends {
    fn span(&mut self, span: &Span<'_>) {
        self.0[span.structure] = span.end;
    }
    fn impact(&mut self, _: &Impact) {}
}

/// Largest difference of displacements and velocities at the end of a run, relative to the largest displacement, and to 30/s times it.
pub(super) fn error<Column: Hysteretic>(row: &Row<Column>, known: &Response, method: Integrator, n_steps: usize) -> f64 {
    let ground = ground();
    let excitation = Excitation::new(0.1, &ground).expect("finite samples");
    let clock = Clock {
        time_step: DURATION / n_steps as f64,
        n_steps,
    };
    let mut ends = Ends(vec![State::default(); row.nodes().len()]);
    method.run(row, excitation, clock, &mut ends).expect("the run ends");
    let peaks = known.structures.iter();
    let scale = peaks.map(|floor| floor.displacement.value.abs());
    let scale = scale.fold(0.0, f64::max);
    let nodes = ends.0.iter().zip(&known.structures);
    let errors = nodes.map(|(found, known)| {
        let displacement = (found.displacement - known.end_displacement).abs();
        let velocity = (found.velocity - known.end_velocity).abs() / 30.0;
        displacement.max(velocity) / scale
    });
    errors.fold(0.0, f64::max)
}

/// Checks that Runge–Kutta approaches the second route: within `nearest` with the fine steps, and with at least the `order` from the coarse
/// to the fine steps. The position of a touch in a step is random, and may improve either result.
fn approaches<Column: Hysteretic>(towers: &[Building<Column>], contact: (f64, ContactLaw), [nearest, order]: [f64; 2], what: &str) {
    let row = buildings(towers, (ALPHA, BETA), contact);
    if contact.0 < 1.0 {
        let known = run(&row, &ground(), DURATION);
        let count: Vec<_> = known.collisions.iter().map(Vec::len).collect();
        assert!(count.iter().all(|n| *n > 0), "{what}: {count:?}");
    }
    approach(&row, Integrator::Rk4(Rk4), [nearest, order], what);
}

/// Checks that a method approaches the second route on a row.
pub(super) fn approach<Column: Hysteretic>(row: &Row<Column>, method: Integrator, [nearest, order]: [f64; 2], what: &str) {
    let known = run(row, &ground(), DURATION);
    let [coarse, fine] = [15_000, 240_000].map(|n_steps| error(row, &known, method, n_steps));
    let slope = libm::log2(coarse / fine) / 4.0;
    assert!(fine < nearest && slope > order, "{what}: {coarse:e} to {fine:e}, order {slope}");
}

const APART: (f64, ContactLaw) = (
    1e3,
    ContactLaw::LinearSpring(pounding_contact::LinearSpring { impact_stiffness: 1.0 }),
);

#[test]
fn reference_runge_kutta_comes_near_pounding_towers() {
    let towers = TOWERS.map(elastic);
    approaches(&towers, (0.01, spring(5e8)), [4e-9, 1.2], "linear spring");
    approaches(&towers, (0.01, viscoelastic(0.35)), [4e-7, 0.8], "viscoelastic");
}

#[test]
fn reference_runge_kutta_comes_near_yielding_towers() {
    // Yield drifts of 15 mm.
    let bilinear = TOWERS.map(|of| {
        yielding(of, |stiffness| Bilinear {
            stiffness,
            yield_force: 0.015 * stiffness,
            hardening: 0.05,
        })
    });
    approaches(&bilinear, APART, [4e-9, 1.2], "bilinear, apart");
    approaches(&bilinear, (0.01, spring(5e8)), [3e-8, 1.2], "bilinear");
    let plastic = TOWERS.map(|of| {
        yielding(of, |stiffness| Bilinear {
            stiffness,
            yield_force: 0.015 * stiffness,
            hardening: 0.0,
        })
    });
    approaches(&plastic, APART, [4e-9, 1.2], "plastic, apart");
    approaches(&plastic, (0.01, spring(5e8)), [3e-8, 1.2], "plastic");
    for (exponent, unloading) in [(1, 0.5), (2, 0.3), (5, 0.8)] {
        let smooth = TOWERS.map(|of| {
            yielding(of, |stiffness| BoucWen {
                stiffness,
                yield_force: 0.015 * stiffness,
                hardening: 0.05,
                smoothness: Smoothness { exponent, unloading },
            })
        });
        let what = format!("Bouc–Wen {exponent}, {unloading}");
        approaches(&smooth, APART, [4e-9, 1.2], &what);
        approaches(&smooth, (0.01, spring(5e8)), [3e-8, 1.2], &what);
    }
}

fn yielding<Column>(of: &[(f64, f64)], column: impl Fn(f64) -> Column) -> Building<Column> {
    let storey = |&(mass, stiffness): &(f64, f64)| (mass, column(stiffness));
    of.iter().map(storey).collect()
}
