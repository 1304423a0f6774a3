//! `effects.csv`: effects of pounding on every storey, a row for each number.

use pounding_scene::{Floors, Scene};
use pounding_text::{Cell, Table};

use super::{Effects, FloorEffects, Known};

/// Names of responses with their units; their peaks are `peak_drift_m` and so on.
const RESPONSES: [(&str, &str); 3] = [("drift", "m"), ("shear_force", "n"), ("acceleration", "m_per_s2")];

/// A number of a floor.
#[derive(Debug, Clone, PartialEq)]
pub struct FloorFact {
    /// Its name, with its unit.
    pub quantity: String,
    /// Its value \[SI\].
    pub value: f64,
    /// Its error and range; `None` if they are not known.
    pub known: Option<Known>,
}

impl Effects {
    /// Returns the file `effects.csv`: a row for each number, building by building from the left and floor by floor from the ground, in
    /// both directions. Peaks have no sign. A wall has rows for each level at which it can be hit.
    ///
    /// `low` and `high` are the least and the largest value under the record and its changes by one per cent.
    pub fn to_csv(&self, scene: &Scene, floors: &Floors) -> String {
        let directions = [("as_given", &self.as_given), ("reversed", &self.reversed)];
        let rows = floors.by_structure().flat_map(|floor| {
            let of_floor = directions.into_iter().flat_map(move |(direction, all)| {
                let facts = all[floor].facts().into_iter();
                facts.map(move |fact| (floor, direction, fact))
            });
            of_floor.collect::<Vec<_>>()
        });
        let known = |fact: &FloorFact, number: fn(&Known) -> f64| Cell::exact(fact.known.as_ref().map(number));
        Table::of(rows)
            .column("building", |(floor, ..)| scene.structures[floors.all()[*floor].structure].name())
            .column("floor", |(floor, ..)| floors.storey_of(*floor))
            .column("direction", |(_, direction, _)| *direction)
            .column("quantity", |(.., fact)| fact.quantity.clone())
            .column("value", |(.., fact)| Cell::exact(fact.value))
            .column("error", |(.., fact)| {
                Cell::number(fact.known.map(|known| known.error), |error| format!("{error:.1e}"))
            })
            .column("low", move |(.., fact)| known(fact, |known| known.low))
            .column("high", move |(.., fact)| known(fact, |known| known.high))
            .column("robust", |(.., fact)| fact.known.map(|known| known.is_robust()))
            .csv()
    }
}

impl FloorEffects {
    /// Returns every number of a floor.
    pub fn facts(&self) -> Vec<FloorFact> {
        let hits = [
            ("collisions", self.collisions),
            ("impulse_n_s", self.impulse_n_s),
            ("largest_impulse_n_s", self.largest_impulse_n_s),
        ];
        let fact = |quantity: String, value: f64, known: Option<Known>| FloorFact { quantity, value, known };
        let mut facts = hits.map(|(name, known)| fact(name.into(), known.value, Some(known))).to_vec();
        for ((name, unit), effect) in RESPONSES.into_iter().zip(self.responses()) {
            let Some(effect) = effect else { continue };
            facts.push(fact(format!("peak_{name}_alone_{unit}"), effect.alone, None));
            facts.push(fact(format!("peak_{name}_{unit}"), effect.beside, None));
            let ratio = effect.amplification;
            facts.extend(ratio.map(|known| fact(format!("{name}_amplification"), known.value, Some(known))));
        }
        facts
    }
}
