//! `effects.csv`: effects of pounding on every storey, a row for each number.

use pounding_scene::{Floors, Scene};
use pounding_text::{Cell, csv_text};

use super::{Effects, FloorEffects, Known};

/// Columns of the table.
const HEADER: [&str; 9] = [
    "building",
    "floor",
    "direction",
    "quantity",
    "value",
    "error",
    "low",
    "high",
    "robust",
];
/// Names of responses with their units.
const RESPONSES: [(&str, &str); 3] = [("drift", "m"), ("shear_force", "n"), ("acceleration", "m_per_s2")];

/// Name and value of a number, with its error and range if they are known.
type Fact = (String, f64, Option<Known>);

impl Effects {
    /// Returns the file `effects.csv`: a row for each number, building by building from the left and floor by floor from the ground, in
    /// both directions. Peaks have no sign. A wall has rows for each level at which it can be hit.
    ///
    /// `low` and `high` are the least and the largest value under the record and its changes by one per cent.
    pub fn to_csv(&self, scene: &Scene, floors: &Floors) -> String {
        let directions = [("as_in_scene", &self.as_given), ("reversed", &self.reversed)];
        let mut rows = Vec::new();
        for floor in floors.by_structure() {
            let structure = floors.all()[floor].structure;
            let building = scene.structures[structure].name();
            for (direction, all) in directions {
                rows.extend(all[floor].facts().into_iter().map(|(quantity, value, known)| {
                    let of = |number: fn(&Known) -> f64| Cell::exact(known.as_ref().map(number));
                    [
                        building.into(),
                        floors.storey_of(floor).into(),
                        direction.into(),
                        quantity.into(),
                        Cell::exact(value),
                        Cell::number(known.map(|known| known.error), |error| format!("{error:.1e}")),
                        of(|known| known.low),
                        of(|known| known.high),
                        known.map_or_else(Cell::default, |known| known.is_robust().into()),
                    ]
                }));
            }
        }
        csv_text(&HEADER, rows)
    }
}

impl FloorEffects {
    /// Returns every number of a floor.
    pub fn facts(&self) -> Vec<Fact> {
        let hits = [
            ("collisions", self.collisions),
            ("impulse_n_s", self.impulse_n_s),
            ("largest_impulse_n_s", self.largest_impulse_n_s),
        ];
        let mut facts: Vec<Fact> = hits.map(|(name, known)| (name.into(), known.value, Some(known))).into();
        for ((name, unit), effect) in RESPONSES.into_iter().zip(self.responses()) {
            let Some(effect) = effect else { continue };
            facts.push((format!("{name}_alone_{unit}"), effect.alone, None));
            facts.push((format!("{name}_{unit}"), effect.beside, None));
            let ratio = effect.amplification;
            facts.extend(ratio.map(|known| (format!("{name}_amplification"), known.value, Some(known))));
        }
        facts
    }
}
