//! What pounding does to every storey, on the page.

use super::markup::{Cell, digits, short, table};
use crate::summary::Summary;
use pounding_assess::{Effect, Effects, FloorEffects, Known};
use pounding_scene::Floors;
use pounding_text::percent;

/// The section with its figure; nothing where nobody asked.
pub(super) fn effects(summary: &Summary, floors: &Floors, figure: &str) -> String {
    let Some(effects) = &summary.effects else {
        return String::new();
    };
    if !effects.touch() {
        let why = floors.says_no_contact().unwrap_or(Effects::NOTHING_TOUCHES);
        return format!("<h2>What pounding does to every storey</h2>\n<p>None: {why}.</p>\n");
    }
    let header = [
        "Storey",
        "Direction",
        "Collisions",
        "Sum of impulses [kN·s]",
        "Drift [mm]",
        "× alone",
        "Shear force [kN]",
        "× alone",
        "Acceleration [m/s²]",
        "× alone",
    ];
    let [one, other] = effects.directions();
    let rows: Vec<_> = floors
        .by_structure()
        .filter(|floor| effects.concern(*floor))
        .flat_map(|floor| [one, other].map(|(name, all)| row(name, &all[floor])))
        .collect();
    format!(
        "<h2>What pounding does to every storey</h2>\n<p>Peaks beside the neighbours, and as multiples of those of the same building \
         alone, in both directions of shaking; below them their least and largest values when the record is made 1 % weaker, \
         stronger, faster or slower. What moves by more than {} is marked ~ and should not be relied on to more digits than \
         that. All by the exact method; another exact run, with a tolerance ten thousand times as large and a record \
         larger by one part in 10¹², is within {} of every multiple. Impulsive impacts accelerate without bound and \
         are left out of accelerations. Collisions and impulses are those of both sides of a floor together.</p>\n{figure}{}",
        percent(Known::ROBUST),
        percent(effects.largest_error()),
        table(&header, &rows)
    )
}

fn row(direction: &str, floor: &FloorEffects) -> Vec<Cell> {
    let mut row = vec![
        Cell::new(&floor.name),
        Cell::new(direction),
        known(&floor.collisions, 1.0, digits),
        known(&floor.impulse_n_s, 1e-3, short),
    ];
    for (effect, factor) in floor.responses().into_iter().zip([1e3, 1e-3, 1.0]) {
        row.extend(pair(effect, factor));
    }
    row
}

fn pair(effect: Option<Effect>, factor: f64) -> [Cell; 2] {
    let peak = effect.map(|effect| short(factor * effect.beside));
    let ratio = effect.and_then(|effect| effect.amplification);
    let ratio = ratio.map_or_else(|| Cell::known(None), |ratio| known(&ratio, 1.0, hundredths));
    [Cell::known(peak), ratio]
}

fn hundredths(value: f64) -> String {
    format!("{value:.2}")
}

/// A number over its range, with a mark where that is wide.
fn known(known: &Known, factor: f64, words: fn(f64) -> String) -> Cell {
    let mark = if known.is_robust() { "" } else { " ~" };
    let range = format!("{} to {}", words(factor * known.low), words(factor * known.high));
    let moves = known.change() > 0.0;
    Cell::new(format!("{}{mark}", words(factor * known.value))).over(moves.then_some(range))
}
