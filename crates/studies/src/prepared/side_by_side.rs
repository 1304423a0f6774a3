//! Prepared scenes that run side by side.

use pounding_solver::{Clock, Integrator, RowsOf, SideBySide, Tallies};

use super::Prepared;
use super::model::Model;

/// The rows of scenes that all have one kind of columns; nothing where they have not.
macro_rules! rows {
    ($scenes:expr, $kind:ident) => {
        $scenes
            .iter()
            .map(|scene| {
                if let Model::$kind(row) = &scene.model {
                    Some(row)
                } else {
                    None
                }
            })
            .collect::<Option<Vec<_>>>()
    };
}

/// Runs scenes under the same record side by side, and takes what happened in them; nothing where they cannot: they have to be
/// rows of structures of one storey, of one shape, without Bouc–Wen columns or a motion that travels, all run by one central
/// difference method without sub-steps. Every scene has the numbers of its run alone.
pub(crate) fn side_by_side(scenes: &[&Prepared]) -> Option<Tallies> {
    let first = scenes.first()?;
    let Integrator::CentralDifference(settings) = first.integrator else {
        return None;
    };
    let alike = |one: &&Prepared| {
        one.integrator == first.integrator
            && one
                .clock
                .time_step
                .total_cmp(&first.clock.time_step)
                .is_eq()
    };
    if !scenes.iter().all(alike) {
        return None;
    }
    let n_steps: Vec<_> = scenes.iter().map(|scene| scene.clock.n_steps).collect();
    let clock = Clock {
        time_step: first.clock.time_step,
        n_steps: n_steps.iter().copied().max()?,
    };
    let together = SideBySide::new(settings, first.excitation(), clock).ok()?;
    let mut tallies = Tallies::default();
    let mut run = |rows| together.run(rows, &n_steps, &mut tallies);
    let ran = match first.model {
        Model::Elastic(_) => run(RowsOf::Elastic(&rows!(scenes, Elastic)?)),
        Model::ElastoPlastic(_) => run(RowsOf::ElastoPlastic(&rows!(scenes, ElastoPlastic)?)),
        Model::Bilinear(_) => run(RowsOf::Bilinear(&rows!(scenes, Bilinear)?)),
        Model::Mixed(_) => false,
    };
    ran.then_some(tallies)
}
