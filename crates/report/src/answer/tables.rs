//! The numbers of a run, in the tables of its structures, storeys, pairs and collisions.

use pounding_scene::{Floor, Quantity, RunResult, Simulation};
use pounding_text::{Grid, Shown, Table, digits, instant, short};

use crate::InWords;
use crate::shown::tables::{MOTIONS, PAIRS, STOREYS, STRUCTURES};

/// Most collisions that are shown; `impacts.csv` has all.
const MOST: usize = 10;

/// A table with a row for each place, and a column for each of these numbers, with their errors below if these were measured.
fn numbers<'a, Q: Into<Quantity> + Copy>(
    words: &'a InWords<'_>,
    places: Table<'a, usize>,
    quantities: &[Q],
    of_place: impl Fn(Quantity, usize) -> Quantity + Copy + 'a,
) -> Grid {
    let table = quantities.iter().fold(places, |table, quantity| {
        let quantity = (*quantity).into();
        let about = quantity.about();
        table.shown_in(about.unit.shown, about.heading, move |place| {
            cell(words, of_place(quantity, *place), *place)
        })
    });
    table.grid()
}

/// A number over its error.
fn cell(words: &InWords<'_>, quantity: Quantity, place: usize) -> Shown {
    let text = words.text(quantity, place);
    let error = words.error(quantity, place).filter(|_| words.value(quantity, place).is_some());
    let error = error.map(|error| if error == "∞" { "not comparable".into() } else { error });
    Shown::from(text).over(error)
}

/// Places of floors under a word, with their names.
fn floors<'a>(
    prepared: &'a Simulation,
    words: &'a InWords<'_>,
    heading: &'static str,
    is_shown: impl Fn(&Floor) -> bool,
) -> Table<'a, usize> {
    let floors = prepared.floors();
    let shown = floors.by_structure().filter(|floor| is_shown(&floors.all()[*floor]));
    let below = words.is_measured().then(|| "error".to_owned());
    Table::of(shown).shown(heading, move |floor| {
        Shown::from(floors.all()[*floor].name.as_str()).over(below.clone())
    })
}

/// Peaks of every floor and wall.
pub(super) fn structures(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    numbers(words, floors(prepared, words, "Structure", |_| true), STRUCTURES, |quantity, _| {
        quantity
    })
}

/// The motion that is left at the end, and the shaking of objects on the floors.
pub(super) fn motions(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    numbers(
        words,
        floors(prepared, words, "Structure", |floor| !floor.is_wall()),
        MOTIONS,
        |quantity, _| quantity,
    )
}

/// Drifts of the storeys of buildings, from the ground up; no rows if every structure has one storey.
pub(super) fn storeys(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    let storeys = floors(prepared, words, "Storey", |floor| floor.storey.is_some());
    numbers(words, storeys, STOREYS, |quantity, floor| match quantity {
        Quantity::Floor(quantity) => words.of_storey(quantity, floor),
        Quantity::Pair(_) => quantity,
    })
}

/// Collisions of every pair.
pub(super) fn pairs(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    let law = |pair: usize| prepared.pairs()[pair].law.name().replace('_', " ");
    let pairs = Table::of(prepared.floors().pairs_by_contact()).shown("Pair", move |pair| {
        Shown::from(prepared.floors().names(*pair).join(" – ")).over(Some(law(*pair)))
    });
    numbers(words, pairs, PAIRS, |quantity, _| quantity)
}

/// Notes on the tables of structures.
pub(super) fn notes(prepared: &Simulation) -> String {
    format!(
        "Accelerations are absolute, that of the ground included, impulsive impacts left out. Residual is the displacement at the end of the \
         run, at {} s; free vibration that has not died away by then is still in it.",
        digits(prepared.duration())
    )
}

/// A sentence about pairs that lean on each other; empty if none does.
pub(super) fn leaning(prepared: &Simulation, outcome: &RunResult) -> Vec<String> {
    let floors = prepared.floors();
    let said = |pair: usize| {
        let one = outcome.of_pair(pair).leaning()?;
        let names = floors.names(pair).join(" – ");
        Some(format!(
            "{names} for {} s from {} s on",
            short(one.end - one.start),
            instant(one.start)
        ))
    };
    let said: Vec<String> = floors.pairs_by_contact().into_iter().filter_map(said).collect();
    if said.is_empty() {
        return Vec::new();
    }
    vec![format!(
        "touches of more than 0.25 s are pushes, and their impulses no measure of a blow: {}",
        said.join("; ")
    )]
}

/// The first collisions.
pub(super) fn collisions(prepared: &Simulation, outcome: &RunResult) -> Grid {
    let all = outcome.collisions.all();
    let left = all.len().saturating_sub(MOST);
    let heading = match left {
        0 => "Collision of".into(),
        left => format!("Collision of ({left} more in impacts.csv)"),
    };
    Table::of(all.iter().take(MOST))
        .shown(heading, |one| prepared.floors().names(one.pair).join(" – "))
        .shown_in("s", "Start", |one| digits(one.start))
        .shown_in("ms", "Duration", |one| short(1e3 * (one.end - one.start)))
        .shown_in("m/s", "Approach speed", |one| one.approach_speed.map(short))
        .shown_in("kN·s", "Impulse", |one| short(1e-3 * one.impulse))
        .shown_in("kN", "Peak force", |one| one.peak_force.map(|force| short(1e-3 * force)))
        .shown_in("s", "at", |one| one.peak_force_time.map(instant))
        .grid()
}
