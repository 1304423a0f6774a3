//! What pounding does to every storey, as text.

use pounding::assess::{Effects, FloorEffects, Known};
use pounding::scene::Simulation;

use crate::text::{NONE, paragraph, percent, short, table};

/// A table with a line for each direction of every storey, each building from the ground up.
pub(super) fn text(prepared: &Simulation, effects: &Effects) -> String {
    let header = [
        ["Storey,", "direction"],
        ["Colli-", "sions"],
        ["Sum of imp.", "[kN·s]"],
        ["Drift", "× alone"],
        ["Shear", "× alone"],
        ["Accel.", "× alone"],
    ];
    let floors = prepared.floors();
    if !effects.touch() {
        let why = floors.says_no_contact().unwrap_or(Effects::NOTHING_TOUCHES);
        return paragraph("Effects", &format!("none: {why}"));
    }
    let rows = floors.by_structure().filter(|floor| effects.concern(*floor)).flat_map(|floor| {
        let directions = effects.directions();
        directions.map(|(name, all)| row(name, &all[floor]))
    });
    let notes = format!(
        "peaks beside the neighbours over those of the same building alone, by the exact method; errors: {}. ~ marks what moves by \
         more than {} when the record is made 1 % weaker, stronger, faster or slower: it holds no better than that. Collisions \
         and impulses are those of both sides of a floor together. --out and --json say how far it goes.",
        percent(effects.largest_error()),
        percent(Known::ROBUST)
    );
    let table = table(&header, &rows.collect::<Vec<_>>());
    format!("{table}\n{}", paragraph("Effects", &notes))
}

fn row(direction: &str, floor: &FloorEffects) -> Vec<String> {
    let ratios = floor.responses().map(|one| one?.amplification);
    let [drift, shear, acceleration] = ratios.map(|one| one.map_or_else(|| NONE.into(), |one| marked(&one, format!("{:.2}", one.value))));
    let name = if direction == "reversed" {
        "  reversed".into()
    } else {
        floor.name.clone()
    };
    vec![
        name,
        marked(&floor.collisions, floor.collisions.value.to_string()),
        marked(&floor.impulse_n_s, short(1e-3 * floor.impulse_n_s.value)),
        drift,
        shear,
        acceleration,
    ]
}

/// A number with its mark.
fn marked(known: &Known, text: String) -> String {
    if known.is_robust() { text } else { format!("~{text}") }
}
