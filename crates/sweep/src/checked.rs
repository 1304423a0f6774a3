//! How every run of a sweep was held to the laws of mechanics.
//!
//! A run alone has a ledger. Scenes side by side have books of their contacts, and what these doubt runs alone. Some of the others, drawn
//! by their numbers, run alone as well, and have to come to the same: so that a fault of what runs side by side is found, too.

use pounding_scene::{Method, Simulation};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use super::Sweep;
use super::column_errors::distance;

/// Of so many scenes side by side one runs alone, too: they then take an eighth longer at most.
const ONE_IN: u64 = 2048;
/// Relative change of a record that tells what rounding moves.
const CHANGE: f64 = 1e-12;
/// How many times as far as the record's change moves them numbers may be apart, and how many tolerances.
const TIMES: f64 = 1e3;

/// How a run was held to the laws of mechanics.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Checked {
    /// Not at all: the sweep asks for no verdict, or the run failed.
    #[default]
    No,
    /// By the ledger of its own run.
    Ledger,
    /// Side by side with others: by the books of its compliant contacts where a stepping method ran it, by no more than its way of working
    /// where the exact one did.
    Beside,
    /// By both: it ran side by side and alone, with the same numbers.
    Both,
}

impl Checked {
    /// Its name in tables; nothing where it was not.
    pub fn name(self) -> &'static str {
        match self {
            Self::No => "",
            Self::Ledger => "ledger",
            Self::Beside => "beside",
            Self::Both => "both",
        }
    }

    /// The one of this name.
    pub(super) fn of(name: &str) -> Option<Self> {
        [Self::No, Self::Ledger, Self::Beside, Self::Both]
            .into_iter()
            .find(|one| one.name() == name)
    }
}

/// The numbers of a scene, one for each column.
pub(super) struct TwoRuns<'a> {
    pub(super) beside: &'a [f64],
    pub(super) alone: &'a [f64],
    /// What each counts as at least where its error is relative to it.
    pub(super) least: &'a [f64],
}

impl Sweep {
    /// Whether a run that goes side by side runs alone, too; one of the sweep does at least.
    pub(super) fn is_sampled(&self, run: u64) -> bool {
        let drawn = |number: u64| Pcg64::new(number.into(), 29).next_u64();
        run == drawn(u64::MAX) % self.n_runs() || drawn(run).is_multiple_of(ONE_IN)
    }

    /// Holds the numbers of a scene side by side to those of its run alone: stepping methods give the same bits, the exact method the same
    /// to its tolerance and to how far rounding moves the scene.
    ///
    /// # Errors
    /// Names the number that is furthest off.
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

    /// How far numbers are from those of a run alone. To which side a peak is may be less than the exact method knows: there peaks count by
    /// their magnitudes.
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

    /// How far the furthest number of the exact method moves with a change of the record's size or pace as small as this, or by a looser method.
    /// The last one speaks where the start moves more than the ground does.
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
        Sweep::of((file, text.as_bytes()), path, None).unwrap()
    }

    /// What a fault side by side would do to a number, put in on purpose: it is found in the last bit of a stepping method, and by the
    /// exact method where rounding does not explain it.
    #[test]
    fn issue_a_fault_side_by_side_is_found() {
        for (method, hidden, found) in [
            ("central_difference.time_step_s = 0.005", 0.0, f64::EPSILON),
            ("exact = {}", 1e-12, 1e-6),
        ] {
            let sweep = sweep(method);
            let mut json = sweep.scene.clone();
            let (mut point, mut settings) = (crate::sampling::Point::default(), Vec::new());
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
            // A structure that goes equally far to both sides: the sign of its peak is rounding by the exact method alone.
            assert_eq!(changed(-2.0).is_ok(), hidden > 0.0, "{method}");
            let reason = changed(found).unwrap_err();
            assert!(reason.starts_with("tower: peak_displacement_m: found "), "{reason}");
        }
    }
}
