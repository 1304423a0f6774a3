//! The paper's scenes under every law.

use super::entry::{Entry, N_LAWS, by_name};
use crate::Completed;
use crate::drivers::{each, pairs};
use crate::research::work_precision::{MethodQuantity, Quantities};
use crate::study::laws::{AtlasSettings, free_pair};
use pounding_contact::Calibration;
use pounding_scene::{Scene, Simulation};
use pounding_text::Table;

/// The results of a scene under every law, in their order.
#[derive(Debug)]
pub(super) struct Played {
    pub(super) scene: String,
    pub(super) n_structures: usize,
    /// The numbers of each run, or the reason why it failed.
    pub(super) outcomes: Vec<Result<Quantities, String>>,
}

/// Runs every scene under every law. Calls `done` after each run.
pub(super) fn play(completed: &Completed, entries: &[Entry], settings: &AtlasSettings, done: &(dyn Fn() + Sync)) -> Vec<Played> {
    let scenes = &completed.file.study.scenes;
    let run = |&(scene, entry): &(&Scene, &Entry)| run(completed, scene, entry, settings);
    let mut outcomes = each(&pairs(scenes, entries), done, run).into_iter();
    let played = |scene: &Scene| Played {
        scene: scene.name.clone(),
        n_structures: scene.structures.len(),
        outcomes: outcomes.by_ref().take(entries.len()).collect(),
    };
    scenes.iter().map(played).collect()
}

/// Number of calls of `done` by [`play`].
pub(super) fn n_runs(scenes: &[Scene]) -> usize {
    scenes.len() * N_LAWS
}

/// Runs a scene under a law that is calibrated for every pair.
fn run(completed: &Completed, scene: &Scene, entry: &Entry, settings: &AtlasSettings) -> Result<Quantities, String> {
    let mut scene = scene.clone();
    let name = entry.name();
    let neighbours = scene.structures.windows(2);
    for (contact, two) in scene.contacts.iter_mut().flatten().zip(neighbours) {
        let pair = free_pair(two, settings.approach_speed_m_per_s);
        let law = name.calibrated(settings.stiffness(name), settings.restitution(name), Calibration::Exact, &pair);
        contact.law = law.map_err(|error| error.to_string())?;
    }
    let prepared = Simulation::new(&scene, completed.file.base());
    let outcome = prepared.and_then(|prepared| prepared.run(None));
    let outcome = outcome.map_err(|error| error.to_string())?;
    Ok(Quantities::of(&outcome, scene.structures.len()))
}

/// A number of a scene.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Item {
    pub(super) quantity: &'static str,
    /// Number of the structure from the left; `None` for a number of the whole row.
    pub(super) structure: Option<usize>,
    pub(super) unit: &'static str,
    pub(super) value: f64,
}

impl Item {
    /// Whether both are the same number of the scene, under any law.
    pub(super) fn is_as(&self, other: &Self) -> bool {
        let keys = |item: &Self| (item.quantity, item.structure, item.unit);
        keys(self) == keys(other)
    }
}

/// Key of the only number that is not a [`MethodQuantity`].
const COUNT: &str = "number_of_collisions";

/// The numbers of a run, in the order of tables.
pub(super) fn items(found: &Quantities, compliant: bool) -> Vec<Item> {
    let of_quantity = |quantity: MethodQuantity| {
        let values = found.values(quantity);
        values.iter().zip(1..).map(move |(value, number)| Item {
            quantity: quantity.key(),
            structure: (values.len() > 1).then_some(number),
            unit: quantity.unit(compliant),
            value: *value,
        })
    };
    let count = Item {
        quantity: COUNT,
        structure: None,
        unit: "1",
        value: found.n_collisions as f64,
    };
    MethodQuantity::ALL.into_iter().flat_map(of_quantity).chain([count]).collect()
}

/// Table of every number of every scene under every law.
pub(super) fn table<'a>(played: &'a [Played], entries: &'a [Entry]) -> String {
    let of_run = |(scene, entry, outcome): (&'a Played, &'a Entry, &Result<Quantities, String>)| {
        let items: Vec<Result<Item, String>> = match outcome {
            Ok(found) => items(found, entry.is_compliant()).into_iter().map(Ok).collect(),
            Err(reason) => vec![Err(reason.clone())],
        };
        by_name(entry, items.into_iter().map(move |item| (scene, item)))
    };
    let of_scene = |scene: &'a Played| {
        entries
            .iter()
            .zip(&scene.outcomes)
            .map(move |(entry, outcome)| (scene, entry, outcome))
    };
    let item = |item: &Result<Item, String>| item.clone().ok();
    Table::of(played.iter().flat_map(of_scene).flat_map(of_run))
        .column("scene", |(.., (scene, _))| scene.scene.clone())
        .column("law", |(name, ..)| name.name())
        .column("restitution", |(_, entry, _)| entry.certificate.by_exact)
        .column("quantity", |(.., (_, one))| item(one).map(|one| one.quantity))
        .column("structure", |(.., (_, one))| item(one).and_then(|one| one.structure))
        .column("unit", |(.., (_, one))| item(one).map(|one| one.unit))
        .column("value", |(.., (_, one))| item(one).map(|one| one.value))
        .column("failed", |(.., (_, one))| one.as_ref().err().cloned())
        .csv()
}
