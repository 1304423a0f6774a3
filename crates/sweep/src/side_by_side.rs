//! Simulation scenes in lanes.

use pounding_lanes::{ExactSideBySide, Excitations, RowsOf, SceneSums, SideBySide};
use pounding_scene::Simulation;
use pounding_solver::{AnyRow, CentralDifference, Clock, Elastic, Exact, Excitation, Integrator, Pair, Row};

/// The rows of scenes with a common type of columns; `None` if types differ.
macro_rules! rows {
    ($scenes:expr, $kind:ident) => {
        $scenes
            .iter()
            .map(|(_, scene)| if let AnyRow::$kind(row) = scene.row() { Some(row) } else { None })
            .collect::<Option<Vec<_>>>()
    };
}

/// Runs scenes in lanes, in groups of compatible scenes, and returns their results. With `closings`, the results also say how far
/// neighbours come towards each other. Returns `None` if no scene can run in lanes.
///
/// A scene has no results if it has other numbers of floors and pairs than the first scene, Bouc–Wen columns, a travelling motion, or a
/// method other than the two below; with closings, if its pairs are no chain. Each scene may have a separate record.
///
/// With the central difference method without sub-steps, the numbers of a scene are exactly those of a separate run. The exact method
/// supports two elastic structures, with a tolerance of at least 1e-12 for compliant contact. Its numbers are those of separate runs up to
/// about the tolerance, and do not depend on the other scenes.
pub(crate) fn side_by_side(scenes: &[&Simulation], closings: bool) -> Option<SceneSums> {
    let shape = |scene: &Simulation| (scene.floors().all().len(), scene.pairs().len());
    let of_first = shape(scenes.first()?);
    let mut tallies = SceneSums::default();
    tallies.begin(scenes.len(), of_first.0, of_first.1);
    let of_shape = scenes.iter().enumerate();
    let of_shape = of_shape.filter(|(_, scene)| shape(scene) == of_first);
    let mut left: Vec<_> = of_shape.map(|(place, scene)| (place, *scene)).collect();
    let mut any = false;
    while let Some(&(first_place, first)) = left.first() {
        // A scene that cannot run in lanes is compatible with none, itself included.
        let is_now = |(place, scene): &Placed<'_>| *place == first_place || goes_with(scene, first);
        let (now, later): (Vec<_>, Vec<_>) = left.into_iter().partition(is_now);
        any |= match stepping(first) {
            Some(settings) => stepped(&now, closings, settings, &mut tallies).unwrap_or(false),
            None => exact(&now, closings, &mut tallies),
        };
        left = later;
    }
    any.then_some(tallies)
}

/// Says why a scene needs a separate run, with closings if these are asked for. Returns `None` if it can run in lanes with similar scenes.
pub(crate) fn alone_because(scene: &Simulation, closings: bool) -> Option<&'static str> {
    let floors = scene.floors().all();
    let two = floors.len() == 2 && floors.iter().all(|floor| floor.storey.is_none());
    let of_method = match scene.integrator() {
        Integrator::CentralDifference(settings) => (settings.contact_substeps > 1).then_some("sub-steps in contact are those of one scene"),
        Integrator::Exact(settings) => match elastic(scene) {
            Some(row) if ExactSideBySide::takes(row, settings) => None,
            Some(_) if scene.pairs().iter().any(bends) => Some("a law of two slopes is that of one scene by the exact method"),
            Some(_) if two && !scene.pairs().is_empty() => Some("the exact method goes side by side with a tolerance of 1e-12 or more"),
            Some(_) | None => {
                Some("the exact method takes two elastic structures of one storey that can touch side by side, central differences any row")
            }
        },
        Integrator::Newmark(_) | Integrator::Verlet(_) | Integrator::Hht(_) | Integrator::Rk4(_) | Integrator::MoreauJean(_) => {
            Some("central differences and the exact method go side by side, this method does not")
        }
    };
    let travels = scene.travel().is_some();
    let smooth = matches!(scene.row(), AnyRow::Mixed(_));
    if !scene.row().links().iter().all(SideBySide::takes_link) {
        return Some("restrainers, Maxwell elements and dampers with a brace are those of one scene; springs and dashpots go side by side");
    }
    if matches!(scene.row(), AnyRow::Bilinear(row) if row.has_tangent_damping()) {
        return Some("damping on the tangent stiffness is that of one scene");
    }
    let of_row = || match (smooth, travels, closings && !scene.row().is_chain()) {
        (true, ..) => Some("Bouc–Wen columns, and isolators that stick, are those of one scene"),
        (false, true, _) => Some("a motion that arrives at one structure after the other is that of one scene"),
        (false, false, true) => {
            Some("least openings of floors beside columns, or of several pairs on one side of a floor, are those of one scene")
        }
        (false, false, false) => None,
    };
    of_row().or(of_method)
}

/// Whether the law of a pair has a second slope.
fn bends(pair: &Pair) -> bool {
    let form = pair.law.form(1.0, 1.0);
    form.is_some_and(|form| form.second.is_some())
}

/// A scene with its index.
type Placed<'a> = (usize, &'a Simulation);

/// Whether two scenes can share lanes. They need the same method and time step. Stepping methods also need rows of the same kind. The exact
/// method needs records with the same time step, and runs with the same number of steps.
fn goes_with(one: &Simulation, other: &Simulation) -> bool {
    let equal = |of: fn(&Simulation) -> f64| of(one).total_cmp(&of(other)).is_eq();
    let with_method = one.integrator() == other.integrator() && equal(|scene| scene.clock().time_step);
    let of_kind = || match (one.row(), other.row()) {
        (AnyRow::Elastic(one), AnyRow::Elastic(other)) => SideBySide::are_alike(one, other),
        (AnyRow::Bilinear(one), AnyRow::Bilinear(other)) => SideBySide::are_alike(one, other),
        _ => false,
    };
    let at_one_pace = || equal(|scene| scene.record().time_step()) && one.clock().n_steps == other.clock().n_steps;
    with_method
        && match stepping(one) {
            Some(_) => of_kind(),
            None => at_one_pace(),
        }
}

/// Runs scenes that share lanes by a stepping method; `None` if they cannot.
fn stepped(scenes: &[Placed<'_>], closings: bool, settings: CentralDifference, tallies: &mut SceneSums) -> Option<bool> {
    let (_, first) = scenes.first()?;
    let n_steps: Vec<_> = scenes.iter().map(|(_, scene)| scene.clock().n_steps).collect();
    let clock = Clock {
        time_step: first.clock().time_step,
        n_steps: n_steps.iter().copied().max()?,
    };
    let excitations = excitations(scenes);
    let together = SideBySide::new(settings, Excitations::of(&excitations), clock).ok()?;
    let together = together.within(first.budget()).with_closings(closings);
    let mut found = SceneSums::default();
    let mut run = |rows| together.run(rows, &n_steps, &mut found);
    let ran = match first.row() {
        AnyRow::Elastic(_) => run(RowsOf::Elastic(&rows!(scenes, Elastic)?)),
        AnyRow::Bilinear(_) => run(RowsOf::Bilinear(&rows!(scenes, Bilinear)?)),
        AnyRow::Mixed(_) => false,
    };
    if ran {
        for (index, (place, _)) in scenes.iter().enumerate() {
            tallies.take(*place, &found, index);
        }
    }
    Some(ran)
}

/// Runs the scenes that the exact method supports. Returns false if there are none.
fn exact(scenes: &[Placed<'_>], closings: bool, tallies: &mut SceneSums) -> bool {
    let flies = |(_, scene): &Placed<'_>| {
        let settings = settings(scene)?;
        ExactSideBySide::takes(elastic(scene)?, settings).then_some(settings)
    };
    let flown = scenes.iter().copied().filter(|scene| flies(scene).is_some());
    let flown: Vec<_> = flown.collect();
    let Some((first, settings)) = flown.first().and_then(|one| Some((one.1, flies(one)?))) else {
        return false;
    };
    let rows = flown.iter().filter_map(|(place, scene)| Some((*place, elastic(scene)?)));
    let rows: Vec<_> = rows.collect();
    let excitations = excitations(&flown);
    let together = ExactSideBySide::new(settings, Excitations::of(&excitations), first.clock());
    if let Ok(together) = together {
        let together = together.within(first.budget());
        together.with_closings(closings).run(&rows, tallies);
    }
    true
}

/// The ground motions of scenes. A shared record is scanned once.
fn excitations<'a>(scenes: &[Placed<'a>]) -> Vec<Excitation<'a>> {
    let mut last: Option<(&Simulation, Excitation<'_>)> = None;
    let one = |scene: &'a Simulation| {
        let shared = last.filter(|(other, _)| std::ptr::eq(scene.record(), other.record()));
        let excitation = shared.map_or_else(|| scene.excitation(), |(_, known)| known);
        last = Some((scene, excitation));
        excitation
    };
    scenes.iter().map(|(_, scene)| *scene).map(one).collect()
}

/// Settings of the central difference method; `None` if the scene has another one.
fn stepping(scene: &Simulation) -> Option<CentralDifference> {
    if let Integrator::CentralDifference(settings) = scene.integrator() {
        Some(settings)
    } else {
        None
    }
}

/// Settings of the exact method; `None` if the scene has another method.
fn settings(scene: &Simulation) -> Option<Exact> {
    if let Integrator::Exact(settings) = scene.integrator() {
        Some(settings)
    } else {
        None
    }
}

/// The row; `None` if a column can yield or floors are linked.
fn elastic(scene: &Simulation) -> Option<&Row<Elastic>> {
    match scene.row() {
        AnyRow::Elastic(row) if row.links().is_empty() => Some(row),
        AnyRow::Elastic(_) | AnyRow::Bilinear(_) | AnyRow::Mixed(_) => None,
    }
}
