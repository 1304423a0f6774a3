//! Touches that a run may miss because no contact models them: floors beside columns, and levels that contacts leave out.

use pounding_solver::Opening;

use crate::{ColumnBeside, Excess, ExcessKind, RunResult, Simulation, UnwatchedFloor};

impl Simulation {
    /// Returns possible touches without a contact: by how much they exceed the gap, or without contacts how far both sides move together.
    /// If the run has no closings, the sum of both peaks bounds them.
    pub(super) fn unwatched(&self, result: &RunResult) -> Vec<Excess> {
        let floors = self.floors();
        let openings = self.openings();
        let contacts = self.scene().contacts.as_deref();
        let beside = floors.beside_all_columns();
        let judged = |one: UnwatchedFloor| {
            let (kind, gap, found) = match one {
                UnwatchedFloor::Level { gap, floors } => (
                    ExcessKind::LeftOut,
                    gap,
                    together(floors.map(|one| peak(result, one)), gap, &openings),
                ),
                UnwatchedFloor::Column(index) => {
                    let column = &beside[index];
                    let kind = match contacts {
                        Some(_) if column.is_at_ground() => ExcessKind::AtFoot,
                        // Without a contact nothing says where the foot of a neighbour is.
                        None if column.is_at_ground() => return None,
                        None => ExcessKind::BesideColumn,
                        Some(_) => ExcessKind::AtColumn,
                    };
                    let closing = result.closings.as_ref().and_then(|all| all.of_column(index, false));
                    let bound = || together(column.peaks(result), column.gap, &openings);
                    (kind, column.gap, closing.map_or_else(bound, |closing| closing.distance))
                }
            };
            let floor = floors.unwatched_floor(&one);
            Some(Excess {
                kind,
                floor,
                name: floors.all()[floor].name.clone(),
                found: found - contacts.map_or(0.0, |all| all[gap].gap_m),
                capacity: None,
                often: None,
            })
        };
        let all = floors.unwatched().into_iter().filter_map(judged);
        all.filter(|one| one.found >= 0.0).collect()
    }
}

fn peak(result: &RunResult, floor: usize) -> f64 {
    result.peaks.of(floor).displacement.value.abs()
}

impl ColumnBeside {
    /// Peaks of the floor and of the column beside it \[m\], without sign; that of the column at most.
    pub fn peaks(&self, result: &RunResult) -> [f64; 2] {
        let foot = self.below.map_or(0.0, |floor| peak(result, floor));
        let head = peak(result, self.above);
        [peak(result, self.floor), foot + self.upper_part() * (head - foot)]
    }
}

/// Sum of both peaks \[m\]. A wider gap stays open. A narrower one may stay open, too, if both peak at different times.
fn together([own, beside]: [f64; 2], gap: usize, openings: &[Opening]) -> f64 {
    let bases = openings.get(gap);
    own + beside + bases.map_or(0.0, |one| one.distance.abs())
}
