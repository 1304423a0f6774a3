//! Trial of a sweep before it runs: all values must give scenes with a common kind of row.

use std::path::Path;

use serde_json::Value;

use super::Sweep;
use super::manifest::PRICES;
use super::output::RowShape;
use super::plan::{Axis, Plan, Setting};
use super::spread::{Between, Spread};
use pounding_scene::file::in_file;
use pounding_scene::{Error, Floors, Scene, SharedMotion, Simulation};
use pounding_text::{RefusalKind, Refused, plain};

/// Number of first values of a grid or list that are tried.
const MOST_TRIED: u64 = 1000;
/// Distance from the ends of an interval at which it is tried, relative to it: the ends may be the bounds of validity.
const NEAR: f64 = 1e-6;

/// The row of a scene that does not run.
pub(super) fn row_of(scene: &Scene) -> Result<RowShape, Refused> {
    let floors = scene.check().and_then(|()| Floors::of(scene));
    Ok(RowShape::of(
        scene,
        &floors.map_err(|refused| Error::in_scene(&scene.name, refused))?,
    ))
}

/// Reads a scene whose fields were set; an error names the field.
pub(super) fn scene_of(value: &Value) -> Result<Scene, Refused> {
    Scene::of_words(value)
}

/// The scene with typical values; blames the first value with which there is none.
pub(super) fn first_scene(plan: &Plan, scene: &Value) -> Result<Scene, Refused> {
    let mut first = scene.clone();
    let settings = plan.typical();
    let mut found = scene_of(&first).map_err(inline)?;
    for (axis, setting) in plan.axes().iter().zip(&settings) {
        axis.put(*setting, &mut first);
        found = scene_of(&first).map_err(|reason| refused(axis, *setting, &reason))?;
    }
    found.check_method().map_err(inline)?;
    Ok(found)
}

/// What is wrong with the motions of the first run: with what varies, else with the scene's file or the sweep's.
pub(super) fn blamed(error: Refused, plan: &Plan, [of_sweep, of_scene]: [&Path; 2]) -> Refused {
    let place = error.place().field.as_ref().map(|field| field.path().to_owned());
    let place = place.unwrap_or_default();
    if place == "records" {
        return in_file(error, of_sweep);
    }
    let sets = |axis: &Axis| axis.fields.iter().any(|field| field.holds(&place));
    let mut axes = plan.axes().iter().zip(plan.typical());
    match axes.find(|(axis, _)| sets(axis)) {
        Some((axis, setting)) => refused(axis, setting, &error),
        None => in_file(error, of_scene),
    }
}

fn refused(axis: &Axis, setting: Setting, reason: &Refused) -> Refused {
    let found = Refused::at(axis.place.clone()).found(format!("{} = {}", axis.name, axis.value(setting)));
    found.so(", which the scene refuses: ", reason)
}

/// Blames the scene in the sweep's own file, or a field of it.
fn inline(refused: Refused) -> Refused {
    let field = refused.place().field.as_ref().map(|field| format!("scene.{}", field.path()));
    refused.in_field(field.unwrap_or_else(|| "scene".into()))
}

/// The values of a spread that are tried, each with the value to name in an error: for an interval, its end. An unbounded distribution
/// always exceeds the valid range and is only tried in the middle.
fn tried(spread: &Spread) -> Vec<(Setting, Setting)> {
    let itself = |setting: Setting| (setting, setting);
    let middle = spread.sample(0.5).map(Setting::Number).map(itself);
    match spread {
        Spread::Uniform(Between { from, to }) | Spread::LogUniform(Between { from, to }) => {
            let inside = [(NEAR, *from), (1.0 - NEAR, *to)].into_iter();
            let inside = inside.filter_map(|(part, end)| Some((spread.sample(part)?, end)));
            let inside = inside.map(|(value, end)| (Setting::Number(value), Setting::Number(end)));
            middle.into_iter().chain(inside).collect()
        }
        Spread::Normal(_) | Spread::LogNormal(_) => middle.into_iter().collect(),
        Spread::Values(_) | Spread::Grid(_) => {
            let count = spread.count().unwrap_or(0).min(MOST_TRIED);
            (0..count).map(|value| itself(spread.at(value))).collect()
        }
    }
}

impl Sweep {
    /// Tries the values of grids and lists and both ends of intervals, each with the first values of all others; the row that
    /// all have, where one of them runs.
    pub(super) fn tried(&self) -> Result<Option<RowShape>, Refused> {
        let first = self.plan.typical();
        let mut row = None;
        for (index, axis) in self.plan.axes().iter().enumerate() {
            for (setting, end) in tried(&axis.spread) {
                let mut settings = first.clone();
                let mut trial = |setting| {
                    settings[index] = setting;
                    self.try_one(axis, setting, &settings, &mut row)
                };
                if let Err(refused) = trial(setting) {
                    // The error names the number in the file.
                    trial(end)?;
                    return Err(refused);
                }
            }
        }
        Ok(row)
    }

    fn try_one(&self, axis: &Axis, setting: Setting, settings: &[Setting], row: &mut Option<RowShape>) -> Result<(), Refused> {
        let mut scene = self.scene.clone();
        let tried = self.prepared(0, settings, &mut scene);
        let found = match tried {
            Ok(prepared) => prepared,
            Err(error) if matches!(error.own_kind(), RefusalKind::Together | RefusalKind::Unstable) => return Ok(()),
            Err(reason) => return Err(refused(axis, setting, &reason)),
        };
        let (scene, floors) = (found.scene(), found.floors());
        let first = row.get_or_insert_with(|| RowShape::of(scene, floors));
        if first.fits(scene, floors) {
            return Ok(());
        }
        let (value, words) = (axis.value(setting), RowShape::of(scene, floors).words());
        let found = format!(
            "{} = {value}, with which the row has {words}, where the first run has {}",
            axis.name,
            first.words()
        );
        let found = Refused::at(axis.place.clone()).found(found);
        let found = found.but("; allowed are ", "rows of one kind");
        Err(found.so(": ", "make a sweep of each"))
    }

    /// The scene of these settings under a motion, ready to run; `scene` is that of the sweep, in which any settings were put
    /// before.
    pub(super) fn prepared(&self, motion: usize, settings: &[Setting], scene: &mut Value) -> Result<Simulation, Refused> {
        let (scene, motion) = self.shaken(motion, settings, scene)?;
        Ok(Simulation::shaken(&scene, motion)?)
    }

    /// Cost of a run alone, from the run with typical values under the longest motion. If this is refused, a high cost, which makes parts
    /// small.
    pub(super) fn expected_price(&self) -> f64 {
        let motion = self.motions.longest();
        let typical = self.prepared(motion, &self.plan.typical(), &mut self.scene.clone());
        typical.map_or(PRICES[0], |typical| typical.expected_price())
    }

    /// Whether all runs alone would take about ten seconds or more.
    pub fn is_long(&self) -> bool {
        self.n_runs() as f64 * self.expected_price() > PRICES[1]
    }

    /// The scene of these settings before it is prepared, and the motion.
    pub(super) fn shaken(&self, motion: usize, settings: &[Setting], scene: &mut Value) -> Result<(Scene, SharedMotion), Refused> {
        for (axis, setting) in self.plan.axes().iter().zip(settings) {
            if let Setting::Number(number) = *setting
                && !number.is_finite()
            {
                // JSON has no such number: a field that may be left out would be.
                let found = Refused::at(axis.name.clone()).found(plain(number)).allowed_are("finite numbers");
                return Err(found.help("its spread reaches beyond them"));
            }
            axis.put(*setting, scene);
        }
        Ok(self.motions.shake(motion, scene_of(scene)?)?)
    }
}
