//! What a scene gives and its exact run does not need: the numbers would be the same without it.

use crate::{RunResult, Simulation};
use pounding_text::{digits, rounded_down};

impl Simulation {
    /// What none of these exact runs of the scene, of which there is at least one, needs, a line each: yielding that is not reached, gaps
    /// that stay open. Runs of both directions say more than one.
    pub fn unneeded(&self, expected: &[&RunResult]) -> Vec<String> {
        let floors = self.floors().all().iter().enumerate();
        let columns = floors.filter_map(|(index, floor)| {
            let peaks = expected.iter().map(|run| run.peaks.of(index).restoring_force.value.abs());
            let peak = peaks.fold(0.0, f64::max);
            let columns = floor.made_of?.columns;
            // Columns that yield smoothly do so from the first drift on.
            let sharp = columns.yield_force_n.filter(|_| columns.bouc_wen.is_none());
            let share = peak / sharp?;
            // What rounding leaves of a force that is cut off.
            (share < 1.0 - 1e-9).then(|| {
                format!(
                    "the yielding of structures[{}] ({}), whose columns reach {} % of their yield force",
                    floor.structure,
                    floor.name,
                    rounded_down(100.0 * share, 1)
                )
            })
        });
        let pairs = self
            .pairs()
            .iter()
            .take(self.floors().facing().len())
            .enumerate();
        let gaps = pairs.filter_map(|(pair, one)| {
            let touch = expected.iter().any(|run| run.collisions_of(pair).next().is_some());
            let [left, right] = self.floors().names(pair);
            let contact = self.floors().facing()[pair].contact;
            (!touch).then(|| {
                format!(
                    "the contact of contacts[{contact}] ({left} – {right}), whose gap of {} mm stays open",
                    digits(1e3 * one.gap)
                )
            })
        });
        columns.chain(gaps).collect()
    }
}
