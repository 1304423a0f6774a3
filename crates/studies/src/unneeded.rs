//! What a scene gives and its exact run does not need: the numbers would be the same without it.

use crate::{Outcome, Prepared, Structure, digits, rounded_down};

impl Prepared {
    /// What the exact run of the scene does not need, a line each: yielding that is not reached, gaps that stay open.
    pub fn unneeded(&self, expected: &Outcome) -> Vec<String> {
        let scene = self.scene();
        let structures = scene.structures.iter().enumerate();
        let columns = structures.filter_map(|(index, structure)| {
            let Structure::Sdof(sdof) = structure else {
                return None;
            };
            let peak = expected.peaks.of(index).restoring_force.value.abs();
            let share = peak / sdof.yield_force_n?;
            // What rounding leaves of a force that is cut off.
            (share < 1.0 - 1e-9).then(|| {
                format!(
                    "the yielding of structures[{index}] ({}), whose columns reach {} % of their yield force",
                    sdof.name,
                    rounded_down(100.0 * share, 1)
                )
            })
        });
        let contacts = scene.contacts.iter().flatten().enumerate();
        let gaps = contacts.filter_map(|(pair, contact)| {
            let touch = expected.collisions_of(pair).next().is_some();
            let [left, right] = [pair, pair + 1].map(|index| scene.structures[index].name());
            (!touch).then(|| {
                format!(
                    "the contact of contacts[{pair}] ({left} – {right}), whose gap of {} mm stays open",
                    digits(1e3 * contact.gap_m)
                )
            })
        });
        columns.chain(gaps).collect()
    }
}
