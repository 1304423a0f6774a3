//! Checks of the laws of mechanics for every run of a sweep.
//!
//! A run alone has a ledger. Scenes in lanes have books of their contacts, and doubted scenes run alone. A sample of the others, drawn by
//! their numbers, also runs alone and must give equal results. This also finds faults of lanes.

use pounding_scene::{Method, Simulation};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use super::Sweep;
use super::column_errors::distance;

/// Of this many scenes in lanes, one also runs alone: this takes at most an eighth longer.
const ONE_IN: u64 = 2048;
/// Relative change of a record that shows the effect of rounding.
const CHANGE: f64 = 1e-12;
/// Largest allowed distance of numbers, relative to the effect of the record's change, and in tolerances.
const TIMES: f64 = 1e3;

/// How the laws of mechanics were checked for a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Checked {
    /// No check: the sweep requests no verdict, or the run failed.
    #[default]
    No,
    /// By the ledger of the run.
    Ledger,
    /// In lanes with others. A stepping method is checked by the books of its compliant contacts; the exact method obeys the laws by
    /// construction.
    Beside,
    /// Both: it ran in lanes and alone, with equal numbers.
    Both,
}

impl Checked {
    /// Name in tables; empty if there was no check.
    pub fn name(self) -> &'static str {
        match self {
            Self::No => "",
            Self::Ledger => "ledger",
            Self::Beside => "beside",
            Self::Both => "both",
        }
    }

    /// The check with this name.
    pub(super) fn of(name: &str) -> Option<Self> {
        [Self::No, Self::Ledger, Self::Beside, Self::Both]
            .into_iter()
            .find(|one| one.name() == name)
    }
}

/// The numbers of a scene, by column.
pub(super) struct TwoRuns<'a> {
    pub(super) beside: &'a [f64],
    pub(super) alone: &'a [f64],
    /// Least scale of each number for its relative error.
    pub(super) least: &'a [f64],
}

impl Sweep {
    /// Whether a run in lanes also runs alone; at least one run of the sweep does.
    pub(super) fn is_sampled(&self, run: u64) -> bool {
        let drawn = |number: u64| Pcg64::new(number.into(), 29).next_u64();
        run == drawn(u64::MAX) % self.n_runs() || drawn(run).is_multiple_of(ONE_IN)
    }

    /// Compares the numbers of a scene in lanes with those of its run alone. Stepping methods must give equal bits; the exact method must
    /// agree within its tolerance and the effect of rounding on the scene.
    ///
    /// # Errors
    /// Names the number with the largest difference.
    pub(super) fn compare(&self, scene: &Simulation, runs: &TwoRuns<'_>) -> Result<(), String> {
        let apart = self.apart(scene, runs.beside, runs);
        let furthest = (0..apart.len()).max_by(|one, other| apart[*one].total_cmp(&apart[*other]));
        let Some(furthest) = furthest.filter(|place| apart[*place] > 0.0) else {
            return Ok(());
        };
        let mut allowed = 0.0;
        if let Method::Exact {
            tolerance,
            simultaneous_impacts,
        } = scene.method()
        {
            let change = tolerance.max(CHANGE);
            allowed = TIMES * change;
            if apart[furthest] > allowed {
                let looser = Method::Exact {
                    tolerance: 10.0 * tolerance,
                    simultaneous_impacts,
                };
                allowed += TIMES * self.moved(scene, runs, change, looser);
            }
        }
        if apart[furthest] <= allowed {
            return Ok(());
        }
        Err(format!(
            "{}: found {} side by side with other runs and {} alone, {:.1e} apart, allowed is {allowed:.1e}; this is a fault of the program: \
             report it, and let all runs go alone, as with `touching_s` among the `outputs`",
            self.outputs[furthest].name, runs.beside[furthest], runs.alone[furthest], apart[furthest],
        ))
    }

    /// Distance of numbers from those of a run alone. The side of a peak may be undecided within the accuracy of the exact method: peaks
    /// are compared by magnitude.
    fn apart(&self, scene: &Simulation, numbers: &[f64], runs: &TwoRuns<'_>) -> Vec<f64> {
        let is_exact = matches!(scene.method(), Method::Exact { .. });
        let mut apart = Vec::with_capacity(numbers.len());
        for (column, output) in self.outputs.iter().enumerate() {
            let (mut one, mut other) = (numbers[column], runs.alone[column]);
            if is_exact && output.quantity.is_peak() {
                (one, other) = (one.abs(), other.abs());
            }
            apart.push(distance(one, other, runs.least[column]));
        }
        apart
    }

    /// Largest change of any number of the exact method under such a small change of the record's scale or time, or with a looser method.
    /// The latter matters if the initial motion dominates the ground motion.
    fn moved(&self, scene: &Simulation, runs: &TwoRuns<'_>, change: f64, looser: Method) -> f64 {
        let by = 1.0 + change;
        let changed = [
            scene.under(|record| record.scaled(by)),
            scene.under(|record| record.stretched(by)),
            scene.with_method(looser),
        ];
        let mut furthest = 0.0;
        let (mut moved, mut least) = (Vec::new(), Vec::new());
        for near in changed.into_iter().flatten() {
            if self.run_alone(&near, &mut moved, &mut least).is_err() {
                return f64::INFINITY;
            }
            let moved = self.apart(scene, &moved, runs);
            furthest = moved.into_iter().fold(furthest, f64::max);
        }
        furthest
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::SweepFile;

    fn sweep(method: &str) -> Sweep {
        let text = format!(
            r#"
            vary = [{{ field = "contacts[0].gap_m", grid = {{ from = 0.001, to = 0.01, count = 9 }} }}]
            [scene]
            name = "a tower beside a wall"
            record.generated.half_sine = {{ amplitude_m_per_s2 = -4.0, duration_s = 0.5, time_step_s = 0.01 }}
            structures = [{{ sdof = {{ name = "tower", mass_kg = 1e5, period_s = 1.0, damping.ratio = 0.05 }} }}, {{ wall = {{}} }}]
            contacts = [{{ gap_m = 0.05, law.stereomechanical.restitution = 0.65 }}]
            method.{method}"#
        );
        let path = Path::new("sweep.toml");
        let file = SweepFile::parse(text.as_bytes(), path).unwrap();
        Sweep::of(&file, text.as_bytes(), path, None).unwrap()
    }

    /// A fault of lanes, inserted on purpose, changes a number. In a stepping method the last bit reveals it, in the exact method a change
    /// that rounding does not explain.
    #[test]
    fn issue_a_fault_side_by_side_is_found() {
        for (method, hidden, found) in [
            ("central_difference.time_step_s = 0.005", 0.0, f64::EPSILON),
            ("exact = {}", 1e-12, 1e-6),
        ] {
            let sweep = sweep(method);
            let mut json = sweep.scene.clone();
            let (mut point, mut settings) = (crate::sampling::SamplePoint::default(), Vec::new());
            sweep.plan.settings(3, &mut point, &mut settings);
            let scene = sweep.prepared(0, &settings, &mut json).unwrap();
            let (mut alone, mut least) = (Vec::new(), Vec::new());
            sweep.run_alone(&scene, &mut alone, &mut least).unwrap();
            let changed = |by: f64| {
                let mut beside = alone.clone();
                beside[0] *= 1.0 + by;
                let runs = TwoRuns {
                    beside: &beside,
                    alone: &alone,
                    least: &least,
                };
                sweep.compare(&scene, &runs)
            };
            assert_eq!(changed(hidden), Ok(()), "{method}");
            // A structure that goes equally far to both sides: the sign of its peak is rounding only in the exact method.
            assert_eq!(changed(-2.0).is_ok(), hidden > 0.0, "{method}");
            let reason = changed(found).unwrap_err();
            assert!(reason.starts_with("tower: peak_displacement_m: found "), "{reason}");
        }
    }
}
