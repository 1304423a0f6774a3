//! Touches that a run may miss because no contact models them: floors beside columns, and levels that contacts leave out.

use pounding_solver::Opening;

use crate::{Excess, ExcessKind, RunResult, Simulation, UnwatchedFloor};

impl Simulation {
    /// Returns possible touches without a contact: by how much they exceed the gap, or without contacts how far both sides move together.
    /// If the run has no closings, the sum of both peaks bounds them.
    pub(super) fn unwatched(&self, result: &RunResult) -> Vec<Excess> {
        let floors = self.floors();
        let openings = self.openings();
        let contacts = self.scene().contacts.as_deref();
        let mut columns = 0;
        let mut judged = |one: UnwatchedFloor| {
            let kind = match contacts {
                Some(_) if one.is_at_ground() => ExcessKind::AtFoot,
                None => ExcessKind::BesideColumn,
                Some(_) if one.is_level() => ExcessKind::LeftOut,
                Some(_) => ExcessKind::AtColumn,
            };
            let closing = if one.is_level() {
                None
            } else {
                columns += 1;
                result.closings.as_ref().and_then(|all| all.of_column(columns - 1, false))
            };
            let gap = contacts.map_or(0.0, |all| all[one.gap].gap_m);
            Excess {
                kind,
                floor: one.floor,
                name: floors.all()[one.floor].name.clone(),
                found: closing.map_or_else(|| one.together(result, &openings), |closing| closing.distance) - gap,
                capacity: None,
                often: None,
            }
        };
        let all = floors.unwatched().into_iter();
        // Without a contact nothing says where the foot of a neighbour is.
        let all = all.map(|one| (one.is_at_ground() && contacts.is_none(), judged(one)));
        all.filter(|(skipped, one)| !skipped && one.found >= 0.0)
            .map(|(_, one)| one)
            .collect()
    }
}

impl UnwatchedFloor {
    /// Peaks of the floor and of the column or floor beside it \[m\], without sign; that of a column, which is straight between its ends, at
    /// most.
    pub fn peaks(&self, result: &RunResult) -> [f64; 2] {
        let peak = |floor: usize| result.peaks.of(floor).displacement.value.abs();
        let foot = self.below.map_or(0.0, peak);
        [peak(self.floor), foot + self.along * (peak(self.above) - foot)]
    }

    /// Sum of both peaks \[m\]. A wider gap stays open. A narrower one may stay open, too, if both peak at different times.
    fn together(&self, result: &RunResult, openings: &[Opening]) -> f64 {
        let bases = openings.get(self.gap);
        let [own, beside] = self.peaks(result);
        own + beside + bases.map_or(0.0, |one| one.distance.abs())
    }
}
