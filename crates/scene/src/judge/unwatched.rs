//! Touches that a run may miss, because no contact models them: of floors beside columns, and at levels that contacts leave out.

use std::collections::BTreeMap;

use pounding_solver::Opening;

use crate::{Excess, ExcessKind, RunResult, Simulation, Unwatched};

impl Simulation {
    /// What may touch and no contact models: how far beyond the gap, or without contacts how far together.
    pub(super) fn unwatched(&self, result: &RunResult) -> Vec<Excess> {
        let floors = self.floors();
        let openings = self.openings();
        let judged = |one: Unwatched| {
            let contacts = self.scene().contacts.as_deref();
            let kind = match contacts {
                None => ExcessKind::BesideColumn,
                Some(_) if one.is_level() => ExcessKind::LeftOut,
                Some(_) => ExcessKind::AtColumn,
            };
            let gap = contacts.map_or(0.0, |all| all[one.gap].gap_m);
            Excess {
                kind,
                floor: one.floor,
                name: floors.all()[one.floor].name.clone(),
                found: together(&one, result, &openings) - gap,
                often: None,
            }
        };
        let all = floors.unwatched().into_iter().map(judged);
        all.filter(|one| one.found >= 0.0).collect()
    }

    /// The width by gaps that keeps floors beside columns from them, by the same measure \[m\].
    pub fn beside_columns(&self, alone: &RunResult) -> BTreeMap<usize, f64> {
        let openings = self.openings();
        let mut widths = BTreeMap::new();
        for one in self.floors().unwatched() {
            if !one.is_level() {
                let so_far: &mut f64 = widths.entry(one.gap).or_default();
                *so_far = so_far.max(together(&one, alone, &openings));
            }
        }
        widths
    }
}

/// The sum of the peaks of a floor and of the column or floor next to it \[m\]. A gap that is wider stays open; a narrower one may, if both
/// peak at different times.
fn together(one: &Unwatched, result: &RunResult, openings: &[Opening]) -> f64 {
    let peak = |floor: usize| result.peaks.of(floor).displacement.value.abs();
    let foot = one.below.map_or(0.0, peak);
    let beside = foot + one.along * (peak(one.above) - foot);
    let bases = openings.get(one.gap);
    peak(one.floor) + beside + bases.map_or(0.0, |one| one.distance.abs())
}
