//! `effects.csv`: what pounding does to every storey, a line for each direction.

use super::{Effect, Effects, FloorEffects, Known};
use crate::Floors;
use pounding_text::{Cell, csv_text};

/// Columns of the place of a line.
const PLACE: [&str; 4] = ["structure", "storey", "name", "direction"];
/// Names of the numbers of hits.
const HITS: [&str; 3] = ["collisions", "impulse_n_s", "largest_impulse_n_s"];
/// Names of responses with their units.
const RESPONSES: [(&str, &str); 3] = [("drift", "m"), ("shear", "n"), ("acceleration", "m_per_s2")];

impl Effects {
    /// The file `effects.csv`: a line per floor and direction, building by building from the left and
    /// from the ground up, each by its number; peaks without sign. A wall has a line for each level at which it can be hit.
    ///
    /// `low` and `high` are the least and the largest value under the record and its changes by one per cent.
    pub fn to_csv(&self, floors: &Floors) -> String {
        let mut rows = Vec::new();
        for floor in floors.by_structure() {
            for (direction, all) in self.directions() {
                let structure = floors.all()[floor].structure;
                let place = [structure + 1, floors.storey_of(floor)];
                rows.push(row(place, direction, &all[floor]));
            }
        }
        csv_text(&header(), rows)
    }
}

fn header() -> Vec<String> {
    let mut header = PLACE.map(String::from).to_vec();
    for name in HITS {
        header.extend(known_columns(name));
    }
    for (name, unit) in RESPONSES {
        header.extend([
            format!("{name}_alone_{unit}"),
            format!("{name}_beside_{unit}"),
        ]);
        header.extend(known_columns(&format!("{name}_amplification")));
    }
    header
}

fn known_columns(name: &str) -> [String; 5] {
    ["", "_error", "_low", "_high", "_robust"].map(|end| format!("{name}{end}"))
}

fn row(place: [usize; 2], direction: &str, effects: &FloorEffects) -> Vec<Cell> {
    let mut row = place.map(Cell::from).to_vec();
    row.extend([effects.name.clone().into(), direction.into()]);
    for known in [
        effects.collisions,
        effects.impulse_n_s,
        effects.largest_impulse_n_s,
    ] {
        row.extend(known_cells(&known));
    }
    for effect in effects.responses() {
        row.extend(effect.map_or_else(|| vec![Cell::default(); 7], |effect| cells(&effect)));
    }
    row
}

fn cells(effect: &Effect) -> Vec<Cell> {
    let mut cells = vec![Cell::exact(effect.alone), Cell::exact(effect.beside)];
    let ratio = effect.amplification.as_ref();
    cells.extend(ratio.map_or_else(Default::default, known_cells));
    cells
}

fn known_cells(known: &Known) -> [Cell; 5] {
    [
        Cell::exact(known.value),
        Cell::number(known.error, |error| format!("{error:.1e}")),
        Cell::exact(known.low),
        Cell::exact(known.high),
        known.is_robust().into(),
    ]
}
