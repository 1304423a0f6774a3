//! Estimate of the cost of a run before it starts. A run that costs too much is refused.

use crate::exact::ExactRun;
use crate::{Recorder, RunError};

/// Part of the run during which pairs with strong dampers are assumed to touch: such pairs creep apart.
///
/// Two structures needed between 1/70 and 1/500 of c/m times the duration, under two records, with ξ̄ from 1e3 to 1e7.
const TOUCHING: f64 = 0.01;

impl<R: Recorder> ExactRun<'_, R> {
    /// Refuses a run that needs more than `allowed` pieces. A piece reaches at most to the next sample, and no further than the series of
    /// the fastest floor of its building.
    pub(super) fn check_cost(&self, allowed: f64) -> Result<(), RunError> {
        let samples = (self.shaking.excitation.samples().len() - 1) as f64;
        let samples = samples.min(self.agenda.end / self.shaking.excitation.time_step());
        let mut sum = 0.0;
        for floors in self.moving.buildings.each() {
            let structure = floors[0];
            if self.moving.members[structure].is_wall() {
                continue;
            }
            let rates = floors.iter().map(|floor| self.moving.members[*floor].fastest_rate);
            let pieces = floors.len() as f64 * (rates.fold(0.0, f64::max) * self.agenda.end).max(samples);
            if pieces > allowed {
                return Err(RunError::TooStiff {
                    structure,
                    pieces,
                    allowed,
                });
            }
            sum += pieces;
        }
        if sum > allowed {
            let pieces = sum;
            return Err(RunError::TooLarge { pieces, allowed });
        }
        for contact in &self.touching.contacts {
            let pieces = TOUCHING * contact.relaxation() * self.agenda.end;
            if pieces > allowed {
                let [left, right] = contact.floors();
                return Err(RunError::TooDamped {
                    left,
                    right,
                    pieces,
                    allowed,
                });
            }
        }
        Ok(())
    }
}
