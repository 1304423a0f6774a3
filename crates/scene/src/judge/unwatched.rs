//! Touches that a run may miss, because no contact models them: of floors beside columns, and at levels that contacts leave out.

use std::collections::BTreeMap;

use pounding_solver::Opening;

use crate::{Excess, ExcessKind, RunResult, Simulation, Unwatched};

impl Simulation {
    /// The floors that reach farthest beyond a gap towards what no contact lets them touch.
    pub(super) fn unwatched(&self, result: &RunResult) -> impl Iterator<Item = Excess> {
        let (floors, contacts) = (self.floors(), self.scene().contacts.as_deref());
        let openings = self.openings();
        let judged = |one: Unwatched| {
            let together = together(&one, result, &openings);
            let Some(contacts) = contacts else {
                return Some((ExcessKind::BesideColumn, together, one));
            };
            let kind = if one.is_level() {
                ExcessKind::LeftOut
            } else {
                ExcessKind::AtColumn
            };
            Some((kind, together - contacts.get(one.gap)?.gap_m, one))
        };
        let all = floors.unwatched().into_iter().filter_map(judged);
        let all: Vec<_> = all
            .filter(|(kind, found, _)| *found >= kind.most())
            .collect();
        ExcessKind::UNWATCHED.into_iter().filter_map(move |kind| {
            let of_kind = all.iter().filter(|one| one.0 == kind);
            let (_, found, one) = of_kind.max_by(|one, other| one.1.total_cmp(&other.1))?;
            let left_out = one.is_level().then(|| floors.left_out(one.gap)).flatten();
            Some(Excess {
                kind,
                floor: one.floor,
                name: left_out.unwrap_or_else(|| floors.all()[one.floor].name.clone()),
                found: *found,
            })
        })
    }

    /// The width by gaps that keeps floors beside columns from them, by the same measure \[m\].
    pub(crate) fn beside_columns(&self, alone: &RunResult) -> BTreeMap<usize, f64> {
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
