//! Extremes: scenes and the changes that push them to their limits.

use serde::{Deserialize, Serialize};

use super::axis::{Axis, Pushed};
use pounding_scene::{Scene, Simulation};

/// Scenes and the changes that push them to their limits.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Edges {
    /// Time step of the methods \[s\], unless an axis changes it.
    pub time_step_s: f64,
    /// Grids of two changes at once.
    pub maps: Vec<Map>,
    /// Series of one change.
    pub lines: Vec<ChangeSeries>,
}

/// A grid of two changes of one scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Map {
    /// Name of the map's figure.
    pub name: String,
    /// Name of the scene.
    pub scene: String,
    /// The change along the horizontal axis of the figure.
    pub x: Values,
    /// The change along the vertical axis of the figure.
    pub y: Values,
}

/// A series of one change, for some scenes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChangeSeries {
    /// Names of the scenes.
    pub scenes: Vec<String>,
    /// The change.
    pub change: Values,
}

/// A change and its values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Values {
    /// The change.
    pub axis: Axis,
    /// The numbers, in the order of the figure.
    pub values: Vec<f64>,
}

/// How much of the grid is run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Extent {
    /// The first and then every fourth value of every axis.
    #[default]
    Part,
    /// All values.
    Whole,
}

/// One changed scene.
#[derive(Debug, Clone)]
pub(crate) struct ExtremeScene {
    /// Name of the map, or "line" for a series.
    pub(crate) place: String,
    /// Name of the scene.
    pub(crate) scene: String,
    /// The changes with their values.
    pub(crate) changes: Vec<(Axis, f64)>,
    /// Whether the usual part of the grid contains it.
    pub(crate) in_part: bool,
}

/// A value of an axis, and whether the usual part of the grid contains it.
type Taken = (f64, bool);

impl Edges {
    /// Every changed scene, maps before series.
    pub(crate) fn cells(&self, extent: Extent) -> Vec<ExtremeScene> {
        let mut cells = Vec::new();
        for map in &self.maps {
            for (y, in_part) in map.y.taken(extent) {
                cells.extend(map.x.taken(extent).map(|(x, also)| ExtremeScene {
                    place: map.name.clone(),
                    scene: map.scene.clone(),
                    changes: vec![(map.x.axis, x), (map.y.axis, y)],
                    in_part: in_part && also,
                }));
            }
        }
        for line in &self.lines {
            for scene in &line.scenes {
                cells.extend(line.change.taken(extent).map(|(value, in_part)| ExtremeScene {
                    place: "line".into(),
                    scene: scene.clone(),
                    changes: vec![(line.change.axis, value)],
                    in_part,
                }));
            }
        }
        cells
    }
}

impl Values {
    fn taken(&self, extent: Extent) -> impl Iterator<Item = Taken> {
        let values = self.values.iter().enumerate().map(|(index, value)| (*value, index % 4 == 0));
        values.filter(move |(_, in_part)| *in_part || extent == Extent::Whole)
    }
}

impl ExtremeScene {
    /// The changed scene. The time step is changed last, because it depends on the structures.
    pub(crate) fn pushed(&self, base: &Simulation, scene: &Scene, time_step: f64) -> Result<Pushed, String> {
        let mut pushed = Pushed::new(scene, base.record(), time_step);
        let (last, first): (Vec<_>, Vec<_>) = self.changes.iter().copied().partition(|(axis, _)| *axis == Axis::TimeStep);
        for (axis, value) in first.into_iter().chain(last) {
            axis.push(&mut pushed, value)?;
        }
        Ok(pushed.rounded())
    }
}
