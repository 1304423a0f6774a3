//! The numbers of a run, in the tables of its structures, storeys, pairs and collisions.

use pounding_scene::{FloorQuantity, Quantity, RunResult, Simulation};
use pounding_text::{Grid, NONE, Shown, Table, digits, instant, short};

use crate::shown::tables::{LINKS, MOTIONS, OF_STOREYS, PAIRS, STOREYS, STRUCTURES};
use crate::{InWords, collision_table};

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
    let mut grid = table.grid();
    for row in &mut grid.rows {
        let has_errors = row.iter().any(|cell| cell.below.is_some());
        row[0].below = has_errors.then(|| "error".into());
    }
    grid
}

/// A number over its error.
fn cell(words: &InWords<'_>, quantity: Quantity, place: usize) -> Shown {
    let text = words.text(quantity, place);
    let error = words.error(quantity, place).filter(|_| words.value(quantity, place).is_some());
    let error = error.map(|error| if error == "∞" { "not comparable".into() } else { error });
    Shown::from(text).over(error)
}

/// Places of floors under a word, with their names.
fn floors<'a>(prepared: &'a Simulation, heading: &'static str, is_shown: impl Fn(usize) -> bool) -> Table<'a, usize> {
    let floors = prepared.floors();
    let shown = floors.by_structure().filter(|floor| is_shown(*floor));
    Table::of(shown).shown(heading, move |floor| floors.all()[*floor].name.as_str())
}

/// Peaks of every floor and wall. Forces of columns and ductility stand here for structures of one storey alone: those of buildings belong
/// to storeys.
pub(super) fn structures(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    let all = prepared.floors().all();
    let has_single = all.iter().any(|one| one.storey.is_none() && !one.is_wall());
    let shown = STRUCTURES.iter().copied().filter(|one| has_single || !OF_STOREYS.contains(one));
    let shown: Vec<FloorQuantity> = shown.collect();
    let mut grid = numbers(words, floors(prepared, "Structure", |_| true), &shown, |quantity, _| quantity);
    for (row, floor) in grid.rows.iter_mut().zip(prepared.floors().by_structure()) {
        let is_of_storey = |quantity: &FloorQuantity| all[floor].storey.is_some() && OF_STOREYS.contains(quantity);
        for (cell, _) in row[1..].iter_mut().zip(&shown).filter(|(_, quantity)| is_of_storey(quantity)) {
            *cell = NONE.into();
        }
    }
    grid
}

/// The motion that is left at the end, and the shaking of objects on the floors.
pub(super) fn motions(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    let places = floors(prepared, "Structure", |floor| !prepared.floors().all()[floor].is_wall());
    numbers(words, places, MOTIONS, |quantity, _| quantity)
}

/// Drifts of the storeys of buildings, from the ground up, and of structures of one storey with a known height.
pub(super) fn storeys(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    let is_storey = |floor: usize| {
        let ratio = words.value(words.of_storey(FloorQuantity::DriftRatio, floor), floor);
        prepared.floors().all()[floor].storey.is_some() || ratio.is_some()
    };
    let floors = prepared.floors();
    let shown = floors.by_structure().filter(|floor| is_storey(*floor));
    let places = Table::of(shown).shown("Storey", move |floor| floors.storey_name(*floor));
    numbers(words, places, STOREYS, |quantity, floor| match quantity {
        Quantity::Floor(quantity) => words.of_storey(quantity, floor),
        Quantity::Pair(_) | Quantity::Link(_) => quantity,
    })
}

/// Collisions of every pair; its law stands among the contacts of the scene.
pub(super) fn pairs(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    let floors = prepared.floors();
    let pairs = Table::of(floors.pairs_by_contact()).shown("Pair", move |pair| floors.names(*pair).join(" – "));
    numbers(words, pairs, PAIRS, |quantity, _| quantity)
}

/// Forces and deformations of every link.
pub(super) fn links(prepared: &Simulation, words: &InWords<'_>) -> Grid {
    let scene = prepared.scene();
    let places = Table::of(0..scene.links.len()).shown("Link", |link| {
        let link = &scene.links[*link];
        Shown::from(link.names(scene).join(" – ")).over(Some(link.law.name().into()))
    });
    LINKS
        .iter()
        .fold(places, |table, quantity| {
            let about = Quantity::from(*quantity).about();
            table.shown_in(about.unit.shown, about.heading, move |place| words.text(*quantity, *place))
        })
        .grid()
}

/// Notes on the tables of structures.
pub(super) fn notes(prepared: &Simulation, outcome: &RunResult) -> String {
    let residual = match outcome.collapse {
        Some(collapse) => format!("The run ends by a collapse at {:.2} s: there is no residual.", collapse.time_s),
        None => format!(
            "Residual is the displacement at the end of the run, at {} s; free vibration that has not died away by then is still in it.",
            digits(prepared.duration())
        ),
    };
    format!(
        "Accelerations are absolute, that of the ground included, impulsive impacts left out. {residual} Shear is that of the columns; the \
         force of the dampers is not in it."
    )
}

/// A sentence about pairs that lean on each other; empty if none does.
pub(super) fn leaning(prepared: &Simulation, outcome: &RunResult) -> Vec<String> {
    let floors = prepared.floors();
    let said = |pair: usize| {
        let one = outcome.leaning(prepared, pair)?;
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
        "touches of more than 0.25 s, longer than a blow of their contact, are pushes, and their impulses no measure of a blow: {}",
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
    collision_table(prepared.floors(), all.iter().take(MOST), heading).grid()
}
