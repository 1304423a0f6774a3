//! What everybody solves: random scenes that touch, and their exact answers.

use std::path::Path;

use pounding_contact::{Calibration, ContactLaw, NonlinearViscoelastic, Stereomechanical};
use pounding_solver::{
    Clock, Collisions, Elastic, Exact, Excitation, Integrator, Node, Pair, Peaks, Row,
    SimultaneousImpacts,
};
use rand_pcg::Pcg64;
use serde_json::{Value, json};

use crate::setting::{self, DAMPING, GAPS, MASS, PERIODS, RESTITUTION, STIFFNESS};

/// Scenes whose errors are measured, and those that run in lanes: as many as a sweep hands over at once, of which the former are the first.
pub(super) const SCENES: usize = 8;
pub(super) const IN_LANES: usize = 256;
/// Time step of the record \[s\], and how long the scenes last \[s\].
const GROUND_STEP: f64 = 0.02;
pub(super) const DURATION: f64 = 10.0;
/// A scene whose least impact is a smaller part of its largest is left out: bounces that come to rest ask for a rule that packages lack.
const LEAST_IMPACT: f64 = 1e-3;

/// Peak displacements \[m\] and the sum of impulses \[N·s\] of a scene.
pub(super) type Found = [f64; 3];

/// Scenes of one law.
pub(super) struct Scenes<'a> {
    /// Name of the law in tables.
    pub(super) law: &'static str,
    /// All rows; errors are measured on the first.
    pub(super) rows: Vec<Row<Elastic>>,
    pub(super) excitation: Excitation<'a>,
    /// Exact answers of the first.
    pub(super) answers: Vec<Found>,
}

/// Accelerations of the record at its own step \[m/s²\].
pub(super) fn ground(root: &Path) -> Result<Vec<f64>, String> {
    setting::ground(root, GROUND_STEP, clock(GROUND_STEP).n_steps)
}

/// The exact method at a tolerance.
pub(super) fn exact(tolerance: f64) -> Integrator {
    Integrator::Exact(Exact {
        tolerance,
        simultaneous_impacts: SimultaneousImpacts::Together,
    })
}

/// The clock of a time step \[s\].
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "time steps of the ladder: some millions of steps at most"
)]
pub(super) fn clock(time_step: f64) -> Clock {
    Clock {
        time_step,
        n_steps: (DURATION / time_step).round() as usize,
    }
}

/// A run of a row, with the recorders that find what is compared.
pub(super) fn solved(
    row: &Row<Elastic>,
    excitation: Excitation<'_>,
    integrator: Integrator,
    clock: Clock,
) -> Option<(Found, Collisions)> {
    let mut recorder = (Peaks::new(2), Collisions::new(2, row.pairs()));
    integrator.run(row, excitation, clock, &mut recorder).ok()?;
    let (peaks, collisions) = recorder;
    let peak = |structure| peaks.of(structure).displacement.value.abs();
    let impulse = collisions.all().iter().map(|one| one.impulse).sum();
    Some(([peak(0), peak(1), impulse], collisions))
}

impl<'a> Scenes<'a> {
    /// The scenes of both laws: the same structures and gaps as far as they touch.
    pub(super) fn of_all_laws(ground: &'a [f64]) -> Result<[Self; 2], String> {
        let element = NonlinearViscoelastic::calibrated(STIFFNESS, RESTITUTION, Calibration::Exact);
        let element = element.map_err(|error| error.to_string())?;
        let impact = Stereomechanical {
            restitution: RESTITUTION,
        };
        Ok([
            Self::of(ContactLaw::Stereomechanical(impact), ground)?,
            Self::of(ContactLaw::NonlinearViscoelastic(element), ground)?,
        ])
    }

    fn of(law: ContactLaw, ground: &'a [f64]) -> Result<Self, String> {
        let excitation = Excitation::new(GROUND_STEP, ground).map_err(|error| error.to_string())?;
        let mut random = setting::random();
        let (mut rows, mut answers) = (Vec::new(), Vec::new());
        while rows.len() < IN_LANES {
            let row = drawn(law, &mut random)?;
            let (found, collisions) = solved(&row, excitation, exact(1e-16), clock(GROUND_STEP))
                .ok_or("the exact method fails in a scene")?;
            if !plain(&collisions) {
                continue;
            }
            rows.push(row);
            if answers.len() < SCENES {
                answers.push(found);
            }
        }
        Ok(Self {
            law: law.name(),
            rows,
            excitation,
            answers,
        })
    }

    /// Whether contact is impulsive.
    pub(super) fn is_impulsive(&self) -> bool {
        self.rows[0].pairs()[0].law.impulsive().is_some()
    }

    /// The median over the scenes of the largest relative error of a scene; infinite where half of them have none.
    pub(super) fn error(&self, found: &[Found]) -> f64 {
        let of_scene = |(found, answer): (&Found, &Found)| {
            let errors = found.iter().zip(answer);
            let errors = errors.map(|(found, answer)| (found - answer).abs() / answer);
            // Not a number is an error, too.
            errors.fold(0.0, |worst: f64, error| {
                if error.is_finite() {
                    worst.max(error)
                } else {
                    f64::INFINITY
                }
            })
        };
        let errors: Vec<f64> = found.iter().zip(&self.answers).map(of_scene).collect();
        super::work::median(errors)
    }
}

/// Whether a scene touches, and no bounce dies away.
fn plain(collisions: &Collisions) -> bool {
    let impulses = || collisions.all().iter().map(|one| one.impulse);
    let largest = impulses().fold(0.0, f64::max);
    largest > 0.0 && impulses().all(|impulse| impulse > LEAST_IMPACT * largest)
}

fn drawn(law: ContactLaw, random: &mut Pcg64) -> Result<Row<Elastic>, String> {
    let mut between = |range: [f64; 2]| setting::between(random, range);
    let mut node = || {
        let omega = 2.0 * std::f64::consts::PI / between(PERIODS);
        let column = Elastic {
            stiffness: MASS * omega * omega,
        };
        Node::structure(MASS, 2.0 * DAMPING * MASS * omega, column)
    };
    let nodes = vec![node(), node()];
    let pair = Pair {
        left: 0,
        right: 1,
        gap: between(GAPS),
        law,
    };
    Row::new(nodes, vec![pair]).map_err(|error| error.to_string())
}

/// The scenes as the worker reads them.
pub(super) fn as_json(all: &[Scenes<'_>], ground: &[f64]) -> Value {
    let law = |scenes: &Scenes<'_>| {
        let numbers = |row: &Row<Elastic>| {
            let [left, right] = [&row.nodes()[0], &row.nodes()[1]];
            let gap = row.pairs()[0].gap;
            json!([
                1.0 / left.inverse_mass,
                1.0 / right.inverse_mass,
                left.column.stiffness,
                right.column.stiffness,
                left.damping,
                right.damping,
                gap
            ])
        };
        let (kind, a, b) =
            if let ContactLaw::NonlinearViscoelastic(law) = scenes.rows[0].pairs()[0].law {
                (1, law.impact_stiffness, law.impact_damping_ratio)
            } else {
                (0, RESTITUTION, 0.0)
            };
        let rows: Vec<Value> = scenes.rows[..SCENES].iter().map(numbers).collect();
        json!({"name": scenes.law, "kind": kind, "a": a, "b": b, "scenes": rows})
    };
    let laws: Vec<Value> = all.iter().map(law).collect();
    json!({"duration": DURATION, "ground_step": GROUND_STEP, "ground": ground, "laws": laws})
}

/// What one measurement gives.
#[derive(Debug, Clone)]
pub(super) struct Measured {
    /// CPU time of a scene \[s\].
    pub(super) seconds: f64,
    /// What was found in each.
    pub(super) found: Vec<Found>,
}
