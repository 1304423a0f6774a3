//! Fields of a scene that its exact run does not need: the numbers would be equal without them.

use crate::{RunResult, Simulation, Structure};
use pounding_text::{digits, rounded_down};

impl Simulation {
    /// Lists what none of these exact runs of the scene needs: yielding that is not reached and gaps that stay open, a line for each
    /// structure and contact. There must be at least one run; runs in both directions tell more.
    pub fn unneeded(&self, expected: &[&RunResult]) -> Vec<String> {
        let structures = self.scene().structures.iter().enumerate();
        let columns = structures.filter_map(|(index, one)| self.unneeded_yielding(index, one, expected));
        let contacts = 0..self.scene().contacts.as_ref().map_or(0, Vec::len);
        let gaps = contacts.filter_map(|contact| self.unneeded_contact(contact, expected));
        columns.chain(gaps).collect()
    }

    fn unneeded_yielding(&self, index: usize, structure: &Structure, expected: &[&RunResult]) -> Option<String> {
        let floors = self.floors().of_structure(index);
        let share = |floor: &usize| {
            let forces = expected.iter().map(|run| run.peaks.of(*floor).column_force().value.abs());
            let columns = self.floors().all()[*floor].made_of?.columns;
            // Columns that yield smoothly do so from the smallest drift.
            let sharp = columns.yield_force_n.filter(|_| columns.bouc_wen.is_none());
            Some(forces.fold(0.0, f64::max) / sharp?)
        };
        // A force that is cut off at yielding may be off by rounding.
        let elastic = floors.iter().filter_map(share);
        let elastic: Vec<f64> = elastic.filter(|share| *share < 1.0 - 1e-9).collect();
        let most = elastic.iter().copied().reduce(f64::max)?;
        let (name, most) = (structure.name(), rounded_down(100.0 * most, 1));
        Some(match floors.len() {
            1 => format!("the yielding of structures[{index}] ({name}), whose columns reach {most} % of their yield force"),
            n => format!(
                "the yielding of structures[{index}] ({name}) at {} of {n} storeys, whose columns reach at most {most} % of their yield force",
                elastic.len()
            ),
        })
    }

    fn unneeded_contact(&self, contact: usize, expected: &[&RunResult]) -> Option<String> {
        let facing = self.floors().facing().iter().enumerate();
        let pairs: Vec<usize> = facing.filter(|(_, one)| one.contact == contact).map(|(pair, _)| pair).collect();
        let touches = |pair: usize| {
            let mut runs = expected.iter();
            runs.any(|run| run.collisions_of(pair).next().is_some())
        };
        let open: Vec<usize> = pairs.iter().copied().filter(|pair| !touches(*pair)).collect();
        let first = *open.first()?;
        let [left, right] = self.floors().names(first);
        let gap = digits(1e3 * self.pairs()[first].gap());
        Some(match pairs.len() {
            1 => format!("the contact of contacts[{contact}] ({left} – {right}), whose gap of {gap} mm stays open"),
            n => format!(
                "the contact of contacts[{contact}] at {} of {n} pairs of floors ({left} – {right}{}), whose gap of {gap} mm stays open",
                open.len(),
                if open.len() > 1 { " …" } else { "" }
            ),
        })
    }
}
