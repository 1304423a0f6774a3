//! What a run will cost, before it starts: what it cannot do with is refused.

use crate::exact::Run;
use crate::{Recorder, RunError};

/// Part of a run that pairs with strong dampers touch, as far as its cost is asked before: they creep apart.
///
/// Two structures took a seventieth to a five-hundredth of c/m times the duration, under two records, with ξ̄ from 1e3 to 1e7.
const TOUCHING: f64 = 0.01;

impl<R: Recorder> Run<'_, R> {
    /// Refuses a run that will need more than so many pieces: each reaches no further than the next sample and the series of
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
