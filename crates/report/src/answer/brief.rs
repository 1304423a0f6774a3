//! The first screen of a run: the hardest touches, and the worst numbers of every building.

use std::collections::BTreeSet;

use pounding_contact::LawName;
use pounding_scene::file::Interpolation;
use pounding_scene::{Collapse, Errors, FloorQuantity, PairQuantity, QuantityGroup, Review, RunResult, Simulation};
use pounding_text::{Grid, Shown, Table, Unit, digits, percent, short};

use crate::shown::tables::WORST;
use crate::{Blow, InWords};

/// Pairs that are shown on the first screen; the others are counted.
const MOST: usize = 6;

/// The scene, its record and method, and the errors, in a line each.
pub(super) fn scene(prepared: &Simulation, review: &Review) -> Vec<String> {
    let scene = prepared.scene();
    let method = match scene.method.name().replace('_', " ") {
        name if name == "exact" => "the exact method".into(),
        name => name,
    };
    let steps = scene.method.time_step();
    let steps = steps.map_or(String::new(), |step| format!(", steps of {} s", digits(step)));
    let (_, peak) = prepared.record().peak();
    vec![
        scene.name.clone(),
        format!(
            "{}, peak {} g{}",
            scene.record.source,
            short(peak.abs() / scene.record.gravity_m_per_s2),
            match scene.record.interpolation {
                Interpolation::Linear => "",
                Interpolation::BandLimited => ", band-limited between samples",
            }
        ),
        format!(
            "{} by {method}{steps}, {}: {}",
            lasts(prepared, review.outcome.collapse),
            scene.record.direction(),
            errors(&review.errors)
        ),
    ]
}

/// How long the run lasts, and where a collapse ends it.
pub(super) fn lasts(prepared: &Simulation, collapse: Option<Collapse>) -> String {
    let ended = collapse.map(|one| format!("ended at {:.2} s of ", one.time_s));
    format!("{}{} s", ended.unwrap_or_default(), digits(prepared.duration()))
}

fn errors(errors: &Errors) -> String {
    match errors {
        Errors::Exact => "no error of the method beyond rounding".into(),
        Errors::Doubtful => "this run has gone wrong (see the warnings)".into(),
        Errors::NotMeasured => "errors not measured (--no-error)".into(),
        Errors::Unknown(_) => "errors not known, the exact run fails".into(),
        Errors::Measured(errors, _) => match errors.largest(QuantityGroup::All) {
            (largest, _) if largest <= 0.0 => "no error".into(),
            (largest, of) if largest.is_finite() => format!("largest error {} ({of})", percent(largest)),
            (_, of) => format!("not the {of} of the exact run"),
        },
    }
}

/// The pairs that touch, the hardest first.
pub(super) fn pairs(prepared: &Simulation, outcome: &RunResult) -> Grid {
    Table::of(Blow::all(outcome))
        .shown("Floors that touch, the hardest first", |blow| {
            prepared.floors().names(blow.pair).join(" – ")
        })
        .shown_number("Gap", &Unit::GAP, |blow| prepared.pairs()[blow.pair].gap())
        .shown("Collisions", |blow| outcome.of_pair(blow.pair).collisions)
        .shown_number("Approach", &Unit::SPEED, |blow| blow.speed)
        .shown_number("Impulse", &Unit::NEWTON_SECOND, |blow| blow.impulse)
        .shown_in("kN", "Force", |blow| {
            let force = blow.force.map(|force| Unit::POUNDING_FORCE.text_of(force, 1.0));
            force.unwrap_or_else(|| "impulsive".into())
        })
        .grid()
        .most(MOST)
}

/// What forces of compliant contact depend on, if any pair touches with one: a spring that stores a given energy at K δ^n has the force of
/// K^(1/(n+1)).
pub(super) fn forces(prepared: &Simulation, outcome: &RunResult) -> Vec<String> {
    let touching = Blow::all(outcome).into_iter().map(|blow| &prepared.pairs()[blow.pair].law);
    let laws = touching.filter_map(|law| LawName::from_name(law.name())?.stiffness_unit());
    let is_linear: BTreeSet<bool> = laws.map(|unit| unit == "N/m").collect();
    let powers: Vec<&str> = is_linear
        .into_iter()
        .map(|linear| {
            if linear {
                "k^0.5 (linear spring; ten times the stiffness, 3.2 times the force)"
            } else {
                "k^0.4 (Hertz spring; ten times the stiffness, 2.5 times the force)"
            }
        })
        .collect();
    if powers.is_empty() {
        return Vec::new();
    }
    vec![format!(
        "for the assumed contact stiffness, which nobody knows; grows as {}. Not a design force: `pounding assess` gives a range",
        powers.join(" and ")
    )]
}

/// How many pairs never touch, if others do.
pub(super) fn apart(prepared: &Simulation, outcome: &RunResult) -> Vec<String> {
    let (all, touching) = (prepared.pairs().len(), Blow::all(outcome).len());
    match (touching, all - touching) {
        (0, _) | (_, 0) => Vec::new(),
        (_, 1) => vec!["1 pair of floors never touches".into()],
        (_, n) => vec![format!("{n} pairs of floors never touch")],
    }
}

/// How far the sides of every gap of a bridge move apart. Hinges of bridges have seats or restrainers.
pub(super) fn openings(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    let floors = prepared.floors();
    let is_hinged = seats(prepared).next().is_some() || prepared.scene().links.iter().any(|one| one.law.has_sides());
    let is_shown = |pair: &usize| is_hinged && floors.facing()[*pair].column.is_none();
    let seat = |pair: usize| seats(prepared).find(|(of, _)| *of == pair);
    let used = |pair: usize| {
        let opening = words.value(PairQuantity::LargestOpeningM, pair)?;
        Some(short((opening - 1e3 * prepared.pairs()[pair].gap()).max(0.0)))
    };
    let table = Table::of(floors.pairs_by_contact().into_iter().filter(is_shown))
        .shown("Gaps that open", |pair| floors.names(*pair).join(" – "))
        .shown_number("Gap", &Unit::GAP, |pair| prepared.pairs()[*pair].gap())
        .shown_in("mm", "Largest opening", |pair| words.text(PairQuantity::LargestOpeningM, *pair))
        .shown_in("s", "at", |pair| words.text(PairQuantity::LargestOpeningTimeS, *pair));
    if seats(prepared).next().is_none() {
        return table.grid();
    }
    table
        .shown_in("mm", "Seat used", move |pair| {
            let is_off = words.value(PairQuantity::UnseatedS, *pair).is_some();
            Shown::from(seat(*pair).and_then(|_| used(*pair))).over(is_off.then(|| "unseated".into()))
        })
        .shown_in("mm", "Seat", move |pair| seat(*pair).map(|(_, width)| digits(1e3 * width)))
        .grid()
}

/// The pairs with a seat, and its width \[m\].
fn seats(prepared: &Simulation) -> impl Iterator<Item = (usize, f64)> {
    let contacts = prepared.scene().contacts.as_deref().unwrap_or_default();
    let pairs = prepared.floors().facing().iter().enumerate();
    let pairs = pairs.filter(|(_, facing)| facing.column.is_none());
    pairs.filter_map(|(pair, facing)| Some((pair, contacts.get(facing.contact)?.seat_width_m?)))
}

/// Defines the used part of a seat; empty if there is no seat.
pub(super) fn says_seats(prepared: &Simulation) -> Vec<String> {
    let is_seated = seats(prepared).next().is_some();
    let said = "used is how far the right side moves away from the left one, the opening less the gap; beyond its seat (seat_width_m) it is unseated";
    is_seated.then(|| said.to_owned()).into_iter().collect()
}

/// The worst of every building, each with the number of its floor or storey. How far isolators move comes
/// first: it is no drift of columns.
pub(super) fn buildings(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    let floors = prepared.floors();
    let worst = |structure: usize, quantity: FloorQuantity| {
        let own = floors.of_structure(structure);
        let is_drift = ![FloorQuantity::PeakDisplacementM, FloorQuantity::BaseShearRatio].contains(&quantity);
        let is_left_out = |floor: &usize| is_drift && own.len() > 1 && floors.all()[*floor].is_isolation_layer();
        let own = own.iter().copied().filter(|floor| !is_left_out(floor));
        let known = own.filter_map(|floor| {
            let value = words.value(words.of_storey(quantity, floor), floor)?;
            Some((floor, value.abs()))
        });
        let (floor, _) = known.reduce(|worst, next| if next.1 > worst.1 { next } else { worst })?;
        let text = words.text(words.of_storey(quantity, floor), floor)?;
        let text = text.trim_start_matches('-');
        Some(match floors.all()[floor].storey {
            Some(storey) => format!("{text} ({storey})"),
            None => text.into(),
        })
    };
    let scene = prepared.scene();
    let moving = 0..scene.structures.len();
    let moving: Vec<usize> = moving
        .filter(|one| worst(*one, FloorQuantity::PeakDisplacementM).is_some())
        .collect();
    let has_storeys = floors.all().iter().any(|floor| floor.storey.is_some());
    let known = WORST.iter().copied().filter(|quantity| {
        let is_drift = *quantity == FloorQuantity::PeakDriftM;
        (has_storeys || !is_drift) && moving.iter().any(|one| worst(*one, *quantity).is_some())
    });
    let mut known: Vec<FloorQuantity> = known.collect();
    let is_isolated = moving.iter().any(|one| floors.is_isolated(*one));
    if is_isolated && known.contains(&FloorQuantity::DriftRatio) {
        // The column of isolators takes the place of the drifts in millimetres.
        known.retain(|one| *one != FloorQuantity::PeakDriftM);
    }
    let heading = if has_storeys { "Largest (floor or storey)" } else { "Largest" };
    let isolators = |structure: usize| {
        let mut own = floors.of_structure(structure).iter().copied();
        let floor = own.find(|floor| floors.all()[*floor].is_isolation_layer())?;
        let text = words.text(words.of_storey(FloorQuantity::PeakDriftM, floor), floor)?;
        Some(text.trim_start_matches('-').to_owned())
    };
    let table = Table::of(moving).shown(heading, |one| scene.structures[*one].name().to_owned());
    let table = if is_isolated {
        table.shown_in("mm", "Isolators move", move |one| isolators(*one))
    } else {
        table
    };
    let table = known.into_iter().fold(table, |table, quantity| {
        let about = quantity.about();
        table.shown_in(about.unit.shown, about.heading, move |one| {
            let found = worst(*one, quantity);
            let falls = found.is_none() && words.falls(*one);
            Shown::from(found).over(falls.then(|| "collapsed".into()))
        })
    });
    table.grid()
}
