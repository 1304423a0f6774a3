//! Trial of a sweep before it runs: all values must give scenes with a common kind of row.

use std::path::Path;

use serde_json::Value;

use super::error::RefusedScene;
use super::manifest::PRICES;
use super::output::Row;
use super::plan::{Axis, Plan, Setting};
use super::spread::{Between, Spread};
use super::{Sweep, SweepError};
use pounding_scene::{Error, Floors, Scene, SceneError, SharedMotion, Simulation};

/// Number of first values of a grid or list that are tried.
const MOST_TRIED: u64 = 1000;
/// Distance from the ends of an interval at which it is tried, relative to it: the ends may be the bounds of validity.
const NEAR: f64 = 1e-6;

/// The row of a scene, without running it.
pub(super) fn row_of(scene: &Scene) -> Result<Row, SweepError> {
    let refused = |source| Error::Scene {
        scene: scene.name.clone(),
        source,
    };
    scene.check().map_err(refused)?;
    Ok(Row::of(&Floors::of(scene).map_err(refused)?))
}

/// Reads a scene with set fields; an error names the field.
pub(super) fn scene_of(value: &Value) -> Result<Scene, RefusedScene> {
    Scene::of_words(value).map_err(|refused| RefusedScene::Form {
        place: refused.place().into(),
        fault: Box::new(refused.into_fault()),
    })
}

/// The scene with typical values; an error names the first value that fails.
pub(super) fn first_scene(plan: &Plan, scene: &Value) -> Result<Scene, SweepError> {
    let mut first = scene.clone();
    let settings = plan.typical();
    let mut found = scene_of(&first).map_err(SweepError::Inline)?;
    for (axis, setting) in plan.axes().iter().zip(&settings) {
        axis.put(*setting, &mut first);
        found = scene_of(&first).map_err(|reason| refused(axis, *setting, reason))?;
    }
    found.check_method().map_err(|source| {
        let scene = found.name.clone();
        SweepError::Inline(Error::Scene { scene, source }.into())
    })?;
    Ok(found)
}

/// The error of the motions of the first run: in a varying value, else in the scene's file or the sweep's file.
pub(super) fn blamed(error: SweepError, plan: &Plan, [of_sweep, of_scene]: [&Path; 2]) -> SweepError {
    let SweepError::Scene(error) = error else {
        return error.in_file(of_sweep);
    };
    let place = error.place().unwrap_or_default();
    let sets = |axis: &Axis| axis.fields.iter().any(|field| field.holds(&place));
    let mut axes = plan.axes().iter().zip(plan.typical());
    match axes.find(|(axis, _)| sets(axis)) {
        Some((axis, setting)) => refused(axis, setting, error.into()),
        None => SweepError::Scene(error.in_file(of_scene)),
    }
}

fn refused(axis: &Axis, setting: Setting, reason: RefusedScene) -> SweepError {
    SweepError::Refused {
        place: axis.place.clone(),
        field: axis.name.clone(),
        value: axis.value(setting).to_string(),
        reason,
    }
}

/// Whether a refusal concerns only values, which another run may not have.
fn is_of_values(error: &RefusedScene) -> bool {
    let RefusedScene::Scene(error) = error else {
        return false;
    };
    matches!(
        **error,
        Error::Scene {
            source: SceneError::Unstable { .. }
                | SceneError::OverlapsAtStart { .. }
                | SceneError::TooLong { .. }
                | SceneError::PreparedTooLong { .. }
                | SceneError::TooManySteps { .. },
            ..
        }
    )
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
    /// Tries the values of grids and lists and both ends of intervals, each with the first values of all others. Returns the common row, if
    /// any scene runs.
    pub(super) fn tried(&self) -> Result<Option<Row>, SweepError> {
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

    fn try_one(&self, axis: &Axis, setting: Setting, settings: &[Setting], row: &mut Option<Row>) -> Result<(), SweepError> {
        let mut scene = self.scene.clone();
        let tried = self.prepared(0, settings, &mut scene);
        let found = match tried {
            Ok(prepared) => prepared,
            Err(error) if is_of_values(&error) => return Ok(()),
            Err(reason) => return Err(refused(axis, setting, reason)),
        };
        let floors = found.floors();
        let first = row.get_or_insert_with(|| Row::of(floors));
        if first.fits(floors) {
            return Ok(());
        }
        Err(SweepError::OtherRow {
            place: axis.place.clone(),
            field: axis.name.clone(),
            value: axis.value(setting).to_string(),
            found: Row::of(floors).words(),
            allowed: first.words(),
        })
    }

    /// The scene with these settings under a motion, ready to run. `scene` is that of the sweep and may contain other settings.
    pub(super) fn prepared(&self, motion: usize, settings: &[Setting], scene: &mut Value) -> Result<Simulation, RefusedScene> {
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

    /// The scene with these settings before preparation, and the motion.
    pub(super) fn shaken(&self, motion: usize, settings: &[Setting], scene: &mut Value) -> Result<(Scene, SharedMotion), RefusedScene> {
        for (axis, setting) in self.plan.axes().iter().zip(settings) {
            if let Setting::Number(number) = *setting
                && !number.is_finite()
            {
                // JSON has no such number: an optional field would be null.
                return Err(RefusedScene::NotFinite {
                    field: axis.name.clone(),
                    number,
                });
            }
            axis.put(*setting, scene);
        }
        Ok(self.motions.shake(motion, scene_of(scene)?)?)
    }
}
