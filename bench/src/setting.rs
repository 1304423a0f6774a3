//! Common settings of all benchmarks of many scenes: the record, its steps, the methods, and the bounds of random numbers.

use std::f64::consts::PI;
use std::path::Path;

use pounding_solver::{Bilinear, CentralDifference, Clock, Exact, Excitation, Integrator, SimultaneousImpacts, Storey};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use crate::measure::Outcome;

/// The record that shakes the scenes, from the top folder.
pub(crate) const RECORD: &str = "studies/records/el-centro-1940-ns-chopra.csv";
/// Acceleration of gravity \[m/s²\].
pub(crate) const GRAVITY: f64 = 9.81;
/// Of the structures: mass \[kg\], damping ratio \[–\], least and largest period \[s\], least and largest gap \[m\].
pub(crate) const MASS: f64 = 1e5;
pub(crate) const DAMPING: f64 = 0.05;
pub(crate) const PERIODS: [f64; 2] = [0.2, 1.5];
pub(crate) const GAPS: [f64; 2] = [0.01, 0.08];
/// e of all laws \[–\], and β̄ of the viscoelastic element \[N/m^1.5\].
pub(crate) const RESTITUTION: f64 = 0.65;
pub(crate) const STIFFNESS: f64 = 2.75e9;

/// Steps of runs in lanes, alone and by hand.
pub(crate) const CLOCK: Clock = Clock {
    time_step: 0.01,
    n_steps: 1000,
};
/// Time between two samples of the record \[s\]; the exact method needs no other step.
pub(crate) const RECORDED: f64 = 0.02;
pub(crate) const STEPPING: CentralDifference = CentralDifference { contact_substeps: 1 };

/// The exact method at a tolerance.
pub(crate) const fn exact(tolerance: f64) -> Exact {
    Exact {
        tolerance,
        simultaneous_impacts: SimultaneousImpacts::Together,
    }
}

/// A method, and the motion under which it runs.
pub(crate) type Way<'a> = (Integrator, Excitation<'a>);

/// Ten seconds of the record: accelerations \[m/s²\] at the nodes of the clock, and at its samples.
pub(crate) struct Ground {
    pub(crate) sampled: Vec<f64>,
    recorded: Vec<f64>,
}

impl Ground {
    pub(crate) fn new(root: &Path) -> Outcome<Self> {
        Ok(Self {
            sampled: ground(root, CLOCK)?,
            recorded: ground(root, recorded())?,
        })
    }

    /// Central differences and the exact method, each with its form of the motion.
    pub(crate) fn methods(&self) -> Outcome<[Way<'_>; 2]> {
        let sampled = Excitation::new(CLOCK.time_step, &self.sampled)?;
        let recorded = Excitation::new(RECORDED, &self.recorded)?;
        Ok([
            (Integrator::CentralDifference(STEPPING), sampled),
            (Integrator::Exact(exact(1e-10)), recorded),
        ])
    }
}

/// The clock of an equally long time at the samples of the record.
pub(crate) fn recorded() -> Clock {
    Clock {
        time_step: RECORDED,
        n_steps: CLOCK.n_steps / 2,
    }
}

/// Accelerations of the record at the nodes of a clock \[m/s²\].
pub(crate) fn ground(root: &Path, clock: Clock) -> Outcome<Vec<f64>> {
    let path = root.join(RECORD);
    let bytes = std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let record = pounding_motion::read(&bytes)?.into_record(GRAVITY)?;
    let record = record.resampled(clock.time_step)?;
    Ok(record.samples()[..=clock.n_steps].to_vec())
}

/// The generator from which the numbers of all scenes come.
pub(crate) fn random() -> Pcg64 {
    Pcg64::new(7, 11)
}

/// A random number between two bounds.
pub(crate) fn between(random: &mut Pcg64, [low, high]: [f64; 2]) -> f64 {
    // The upper 53 bits: a number in [0, 1).
    let unit = (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
    low + unit * (high - low)
}

/// A structure of one storey that never yields, with a random period.
pub(crate) fn structure(random: &mut Pcg64) -> Storey<Bilinear> {
    let omega = 2.0 * PI / between(random, PERIODS);
    Storey {
        mass: MASS,
        damping: 2.0 * DAMPING * MASS * omega,
        ground_damping: 0.0,
        column: Bilinear {
            stiffness: MASS * omega * omega,
            yield_force: f64::INFINITY,
            hardening: 0.0,
        },
    }
}
