//! The scenes of benchmarks of many scenes: two elastic structures with one pair under El Centro.

use std::path::Path;

use pounding_solver::{CentralDifference, Clock, Exact, SimultaneousImpacts};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// The record that shakes the scenes, from the top folder.
pub(super) const RECORD: &str = "studies/records/el-centro-1940-ns-chopra.csv";
/// Of the Earth \[m/s²\].
pub(super) const GRAVITY: f64 = 9.81;
/// Of the structures: mass \[kg\], damping ratio \[–\], least and largest period \[s\], least and largest gap \[m\].
pub(super) const MASS: f64 = 1e5;
pub(super) const DAMPING: f64 = 0.05;
pub(super) const PERIODS: [f64; 2] = [0.2, 1.5];
pub(super) const GAPS: [f64; 2] = [0.01, 0.08];
/// e of all laws \[–\], and β̄ of the viscoelastic element \[N/m^1.5\].
pub(super) const RESTITUTION: f64 = 0.65;
pub(super) const STIFFNESS: f64 = 2.75e9;

/// Steps of runs in lanes, one by one and by hand.
pub(super) const CLOCK: Clock = Clock {
    time_step: 0.01,
    n_steps: 1000,
};
/// Time between two samples of the record \[s\], which is all that the exact method needs.
pub(super) const RECORDED: f64 = 0.02;
pub(super) const STEPPING: CentralDifference = CentralDifference {
    contact_substeps: 1,
};
pub(super) const EXACT: Exact = Exact {
    tolerance: 1e-10,
    simultaneous_impacts: SimultaneousImpacts::Together,
};

/// Accelerations \[m/s²\] at so many steps of a time step \[s\], and at the start.
pub(super) fn ground(root: &Path, time_step: f64, n_steps: usize) -> Result<Vec<f64>, String> {
    let path = root.join(RECORD);
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let bytes = std::fs::read(&path).map_err(|error| fail(&error))?;
    let record = pounding_motion::read(&bytes).map_err(|error| fail(&error))?;
    let record = record.into_record(GRAVITY).map_err(|error| fail(&error))?;
    let record = record.resampled(time_step);
    let record = record.map_err(|error| fail(&error))?;
    Ok(record.samples()[..=n_steps].to_vec())
}

/// The generator from which the numbers of all scenes come.
pub(super) fn random() -> Pcg64 {
    Pcg64::new(7, 11)
}

/// A number between two.
pub(super) fn between(random: &mut Pcg64, [low, high]: [f64; 2]) -> f64 {
    // The upper 53 bits: a number in [0, 1).
    let unit = (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
    low + unit * (high - low)
}
