//! Touches that a run may miss because no contact models them: floors beside columns, and levels that contacts leave out.

use std::collections::BTreeMap;

use pounding_solver::Opening;

use crate::{Excess, ExcessKind, RunResult, Simulation, UnwatchedFloor};

impl Simulation {
    /// Returns possible touches without a contact: by how much they exceed the gap, or without contacts how far both sides move together.
    pub(super) fn unwatched(&self, result: &RunResult) -> Vec<Excess> {
        let floors = self.floors();
        let openings = self.openings();
        let judged = |one: UnwatchedFloor| {
            let contacts = self.scene().contacts.as_deref();
            let kind = match contacts {
                Some(_) if one.is_at_ground() => ExcessKind::AtFoot,
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
                capacity: None,
                often: None,
            }
        };
        let all = floors.unwatched().into_iter();
        // Without a contact nothing says where the foot of a neighbour is.
        let all = all.filter(|one| !one.is_at_ground() || self.scene().contacts.is_some());
        let all = all.map(judged);
        all.filter(|one| one.found >= 0.0).collect()
    }

    /// Width that keeps floors from columns of the neighbour \[m\], by the sum of both peaks, for each gap with such floors.
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

/// Sum of the peaks of a floor and of the column or floor beside it \[m\]. A wider gap stays open. A narrower one may stay open, too, if
/// both peak at different times.
fn together(one: &UnwatchedFloor, result: &RunResult, openings: &[Opening]) -> f64 {
    let peak = |floor: usize| result.peaks.of(floor).displacement.value.abs();
    let foot = one.below.map_or(0.0, peak);
    let beside = foot + one.along * (peak(one.above) - foot);
    let bases = openings.get(one.gap);
    peak(one.floor) + beside + bases.map_or(0.0, |one| one.distance.abs())
}
