//! Simulation scenes that run side by side.

use std::sync::Arc;

use pounding_solver::{
    Clock, Elastic, Exact, ExactSideBySide, Excitation, Excitations, Integrator, Row, RowsOf,
    SceneSums, SideBySide, Stepping,
};

use super::Simulation;
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

/// Runs scenes side by side, and takes what happened in them, with `closings` also how far neighbours come towards each other; nothing
/// where they cannot: they have to be rows of one shape, without Bouc–Wen columns or a motion that travels, all run by one method. Each may
/// have a record of its own.
///
/// By the central difference method without sub-steps, and two structures of one storey by the velocity Verlet method, every scene has
/// the numbers of its run alone. By the exact method two elastic structures run side by side, in compliant contact with a tolerance of 1e-12 or
/// more; they then have the numbers of their runs alone to about that tolerance, and the same ones whatever runs beside them.
pub fn side_by_side(scenes: &[&Simulation], closings: bool) -> Option<SceneSums> {
    let first = scenes.first()?;
    let mut tallies = SceneSums::default();
    if let Some(stepping) = Stepping::of(first.integrator)
        && scenes.iter().all(|scene| goes_with(scene, first))
    {
        return stepped((scenes, closings), stepping, &mut tallies)?.then_some(tallies);
    }
    exact(scenes, closings, &mut tallies).then_some(tallies)
}

/// Whether scenes have one method and time step.
fn goes_with(one: &Simulation, other: &Simulation) -> bool {
    let steps = [one, other].map(|scene| scene.clock.time_step);
    one.integrator == other.integrator && steps[0].total_cmp(&steps[1]).is_eq()
}

fn stepped(
    (scenes, closings): (&[&Simulation], bool),
    stepping: Stepping,
    tallies: &mut SceneSums,
) -> Option<bool> {
    let first = scenes.first()?;
    let n_steps: Vec<_> = scenes.iter().map(|scene| scene.clock.n_steps).collect();
    let clock = Clock {
        time_step: first.clock.time_step,
        n_steps: n_steps.iter().copied().max()?,
    };
    let excitations = excitations(scenes.iter().copied());
    let together = SideBySide::new(stepping, Excitations::of(&excitations), clock).ok()?;
    let together = together.within(first.budget()).with_closings(closings);
    let mut run = |rows| together.run(rows, &n_steps, tallies);
    Some(match first.model {
        Model::Elastic(_) => run(RowsOf::Elastic(&rows!(scenes, Elastic)?)),
        Model::ElastoPlastic(_) => run(RowsOf::ElastoPlastic(&rows!(scenes, ElastoPlastic)?)),
        Model::Bilinear(_) => run(RowsOf::Bilinear(&rows!(scenes, Bilinear)?)),
        Model::Mixed(_) => false,
    })
}

/// Runs those scenes that the exact method can, whatever the others are; false where that is none.
fn exact(scenes: &[&Simulation], closings: bool, tallies: &mut SceneSums) -> bool {
    let [n_structures, n_pairs] = [scenes[0].floors().all().len(), scenes[0].pairs().len()];
    tallies.begin(scenes.len(), (n_structures, n_pairs));
    let flies = |(place, scene): (usize, &&Simulation)| {
        let settings = settings(scene)?;
        ExactSideBySide::takes(elastic(scene)?, settings).then_some((place, settings))
    };
    let mut left: Vec<_> = scenes.iter().enumerate().filter_map(flies).collect();
    let any = !left.is_empty();
    while let Some(&(first, settings)) = left.first() {
        let first = scenes[first];
        let together = |(place, _): &(usize, Exact)| {
            let scene = scenes[*place];
            let steps = [scene, first].map(|scene| scene.record.time_step());
            let one_pace = steps[0].total_cmp(&steps[1]).is_eq();
            one_pace && goes_with(scene, first) && scene.clock.n_steps == first.clock.n_steps
        };
        let (now, later): (Vec<_>, Vec<_>) = left.iter().copied().partition(together);
        let row = |(place, _): &(usize, Exact)| Some((*place, elastic(scenes[*place])?));
        let rows: Vec<_> = now.iter().filter_map(row).collect();
        let excitations = excitations(now.iter().map(|(place, _)| scenes[*place]));
        let excitations = Excitations::of(&excitations);
        if let Ok(together) = ExactSideBySide::new(settings, excitations, first.clock) {
            let together = together.within(first.budget());
            together.with_closings(closings).run(&rows, tallies);
        }
        left = later;
    }
    any
}

/// The ground motions of scenes; of those that share a record it is looked through once.
fn excitations<'a>(scenes: impl Iterator<Item = &'a Simulation>) -> Vec<Excitation<'a>> {
    let mut last: Option<(&Simulation, Excitation<'_>)> = None;
    let one = |scene: &'a Simulation| {
        let shared = last.filter(|(other, _)| Arc::ptr_eq(&scene.record, &other.record));
        let excitation = shared.map_or_else(|| scene.excitation(), |(_, known)| known);
        last = Some((scene, excitation));
        excitation
    };
    scenes.map(one).collect()
}

/// Settings of the exact method, where that is the scene's.
fn settings(scene: &Simulation) -> Option<Exact> {
    if let Integrator::Exact(settings) = scene.integrator {
        Some(settings)
    } else {
        None
    }
}

/// The row, where none of its columns can yield.
fn elastic(scene: &Simulation) -> Option<&Row<Elastic>> {
    if let Model::Elastic(row) = &scene.model {
        Some(row)
    } else {
        None
    }
}
