//! Newton iterations of the implicit methods for each law, up to a thousand times the usual stiffness.

use std::fmt::Write;

use insta::assert_snapshot;
use pounding_contact::{Calibration, ContactLaw, FreePair, LawName};
use pounding_solver::{Excitation, Integrator, Row, RunError, Work};

use crate::common::{AVERAGE, HHT, STIFF, WEAK, clock, elastic, ground, pairs};
use crate::watch::Watch;

/// A law calibrated to e = 0.65, at a multiple of its usual stiffness; springs keep their e.
fn law(name: LawName, factor: f64) -> Option<ContactLaw> {
    let stiffness = match name.stiffness_unit()? {
        "N/m" => 9.35e7,
        _ => 2.75e9,
    };
    let pair = FreePair {
        reduced_mass: WEAK.0 * STIFF.0 / (WEAK.0 + STIFF.0),
        approach_speed: 0.3,
    };
    let of = |e| name.calibrated(factor * stiffness, e, Calibration::Exact, &pair);
    of(0.65).or_else(|_| of(1.0)).ok()
}

/// Two shaken structures, over two seconds.
fn run(law: ContactLaw, method: Integrator) -> Result<Work, RunError> {
    let row = Row::new(vec![elastic(WEAK), elastic(STIFF)], pairs(2, 0.002, law)).expect("as built");
    let ground = ground();
    let excitation = Excitation::new(0.01, &ground).expect("as built");
    method.watch(&row, excitation, clock(1e-3, 2.0), &mut ())
}

/// Newton iterations, force evaluations (halved corrections need more of them) and steps in contact.
fn counts(law: ContactLaw, method: Integrator) -> String {
    match run(law, method) {
        Ok(work) => format!(
            "{:5} {:6} {:5}",
            work.newton_iterations, work.force_evaluations, work.touching_steps
        ),
        Err(RunError::NotConverged { time, .. }) => format!("no equilibrium at {time} s"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn limit_newton_iterations_of_every_law_are_counted() {
    let mut text = String::from("law, stiffness: iterations, force evaluations, touching steps\n");
    for (method, integrator) in [("Newmark", AVERAGE), ("HHT", HHT)] {
        // Names that share a force are equal laws once they deliver the same e.
        let mut last = "";
        for name in LawName::ALL {
            let Some(force) = law(name, 1.0).map(|law| law.name()) else {
                continue;
            };
            if std::mem::replace(&mut last, force) == force {
                continue;
            }
            for factor in [1.0, 10.0, 100.0, 1000.0] {
                let Some(law) = law(name, factor) else {
                    continue;
                };
                let counts = counts(law, integrator);
                writeln!(text, "{method:7} {force:28} {factor:4} {counts}").expect("to a string");
            }
        }
    }
    assert_snapshot!(text);
}
