//! The sweep file: a scene, its varying fields, and the outputs of every run.

use pounding_text::Refused;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::distribution::{LogNormal, Normal};
use super::spread::{Between, Grid, Spread};
use super::summary_file::Summary;
use pounding_scene::file::RunBudget;
use pounding_scene::{Error, FloorQuantity, LinkQuantity, PairQuantity};

/// A sweep: a scene that runs many times with other values of its fields, under one or many records.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SweepFile {
    /// The scene: the path of its file, from the folder of this file, or the scene itself.
    pub scene: SceneOf,
    /// Varying fields. Grids and lists are combined, each value with all others, the last one fastest. All sampled fields together form a
    /// further axis, which is the fastest.
    #[serde(default)]
    pub vary: Vec<Vary>,
    /// Number of samples of random fields.
    #[serde(default)]
    pub samples: Option<Samples>,
    /// Folders of records and record files, which replace the record of the scene; paths are relative to the folder of this file.
    #[serde(default)]
    pub records: Option<Records>,
    /// Directions in which every record shakes; by default that of the scene.
    #[serde(default)]
    pub directions: Option<Directions>,
    /// Outputs of every run.
    #[serde(default)]
    pub outputs: Outputs,
    /// Whether every run is checked against the laws of mechanics and fails if it breaks one; default `true`.
    #[serde(default = "yes")]
    pub verdict: bool,
    /// Limits of the cost of a run; a run that exceeds them is a row with the reason. Default: those of the scene.
    #[serde(default)]
    pub budget: Option<RunBudget>,
    /// Statistics over all runs: counts, means, quantiles, exceedances. Rows are then written only if requested here.
    #[serde(default)]
    pub summary: Option<Summary>,
}

/// Deserialisers are large: they are compiled here once instead of in every program that reads a sweep.
impl SweepFile {
    /// Reads a sweep from the text of a JSON or TOML file; [`is_json`](pounding_scene::file::is_json) decides which.
    ///
    /// # Errors
    /// Refuses text that is no sweep, with `path` as its file.
    pub fn parse(text: &[u8], path: &Path) -> Result<Self, Error> {
        pounding_scene::file::parse(text, path)
    }
}

/// The JSON Schema (2020-12) of a sweep file, generated from its types.
pub fn sweep_schema() -> String {
    pounding_scene::file::schema_of::<SweepFile>()
}

fn yes() -> bool {
    true
}

/// A scene, or the path of its file.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(from = "Value")]
#[schemars(with = "SceneOfFile")]
pub enum SceneOf {
    /// In a separate file.
    File(String),
    /// In the file of the sweep.
    Inline(Value),
}

/// A scene, or the path of its file, for the schema.
#[derive(JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "a schema is made of the type alone")]
enum SceneOfFile {
    /// Path of its file, relative to the folder of the sweep.
    File(String),
    /// The scene.
    Inline(Box<pounding_scene::Scene>),
}

impl From<Value> for SceneOf {
    fn from(value: Value) -> Self {
        if let Value::String(path) = value {
            Self::File(path)
        } else {
            Self::Inline(value)
        }
    }
}

/// Number of samples of all random fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "SamplesFile")]
#[schemars(with = "SamplesFile")]
pub struct Samples {
    /// Number of samples, ≥ 1.
    pub count: u64,
    /// Seed: equal seeds give equal samples.
    pub seed: u64,
    /// Method of sampling.
    pub method: SampleMethod,
}

/// The number of samples in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct SamplesFile {
    /// Number of samples, ≥ 1.
    count: u64,
    /// Seed: equal seeds give equal samples.
    seed: u64,
    /// Method of sampling.
    method: SampleMethod,
}

/// Most samples, and most runs of a sweep: counts up to here are numbers of 64 bits to the last digit.
pub(super) const MOST: u64 = 1_000_000_000_000_000;

impl TryFrom<SamplesFile> for Samples {
    type Error = Refused;

    fn try_from(words: SamplesFile) -> Result<Self, Refused> {
        if !(1..=MOST).contains(&words.count) {
            let found = Refused::at("count").found(words.count.to_string());
            return Err(found.allowed_is("a whole number from 1 to 1e15"));
        }
        Ok(Self {
            count: words.count,
            seed: words.seed,
            method: words.method,
        })
    }
}

/// Method of sampling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SampleMethod {
    /// Independent of each other.
    Random,
    /// A scrambled Sobol sequence: even in all axes together. Powers of two are the most even counts.
    Sobol,
    /// Latin hypercube: every axis is divided into as many equal parts as there are samples, with a sample in each.
    LatinHypercube,
}

/// Folders and files of records.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Records {
    /// A folder, or a file.
    One(String),
    /// Several.
    Several(Vec<String>),
}

impl Records {
    /// Their paths.
    pub(super) fn paths(&self) -> &[String] {
        match self {
            Self::One(path) => std::slice::from_ref(path),
            Self::Several(paths) => paths,
        }
    }
}

/// Directions in which a record shakes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Directions {
    /// As in the file.
    AsGiven,
    /// Left becomes right.
    Reversed,
    /// First as given, then reversed.
    Both,
}

impl Directions {
    /// For each direction, whether it is reversed.
    pub(super) fn reversed(self) -> &'static [bool] {
        match self {
            Self::AsGiven => &[false],
            Self::Reversed => &[true],
            Self::Both => &[false, true],
        }
    }
}

/// The outputs of every run, a column for each.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Outputs {
    /// Outputs of every structure; for a building, of every floor.
    pub structures: Vec<FloorQuantity>,
    /// Outputs of every building and structure, as the severest of all floors: the largest by magnitude.
    pub buildings: Vec<FloorQuantity>,
    /// Outputs of every pair of floors that can touch.
    pub pairs: Vec<PairQuantity>,
    /// Outputs of every two neighbours, as the severest of all levels: the largest number, the least opening, the first start.
    pub neighbours: Vec<PairQuantity>,
    /// Outputs of every link.
    pub links: Vec<LinkQuantity>,
}

impl Default for Outputs {
    fn default() -> Self {
        Self {
            structures: vec![FloorQuantity::PeakDisplacementM],
            buildings: Vec::new(),
            neighbours: Vec::new(),
            links: Vec::new(),
            pairs: vec![PairQuantity::Collisions, PairQuantity::PeakForceN, PairQuantity::TotalImpulseNS],
        }
    }
}

/// A varying field of the scene, or several fields with a common value.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(try_from = "VaryFile")]
#[schemars(with = "VaryFile")]
pub struct Vary {
    /// The fields, as in messages: `structures[0].sdof.period_s`; `[*]` stands for every item of a list.
    pub fields: Vec<String>,
    /// Its values.
    pub spread: Spread,
}

impl Vary {
    /// Name of its column.
    pub fn name(&self) -> String {
        self.fields.join(" = ")
    }
}

/// A varying field in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct VaryFile {
    /// The field of the scene, such as `contacts[0].gap_m`; `contacts[*].gap_m` stands for all gaps.
    field: Option<String>,
    /// Several fields with a common value, instead of `field`.
    fields: Option<Vec<String>>,
    /// A list of values.
    values: Option<Vec<Value>>,
    /// Values at equal distances.
    grid: Option<Grid>,
    /// Uniformly distributed between two numbers.
    uniform: Option<Between>,
    /// Distributed with a uniform logarithm.
    log_uniform: Option<Between>,
    /// Normally distributed.
    normal: Option<Normal>,
    /// Distributed with a normal logarithm.
    log_normal: Option<LogNormal>,
}

impl TryFrom<VaryFile> for Vary {
    type Error = Refused;

    fn try_from(words: VaryFile) -> Result<Self, Refused> {
        let fields = match (words.field, words.fields) {
            (None, None) => {
                let neither = Refused::default().found("neither `field` nor `fields`");
                return Err(neither.allowed_is("one of them").help("name the field that varies"));
            }
            (Some(_), Some(_)) => {
                let both = Refused::default().found("both `field` and `fields`");
                return Err(both.allowed_is("one of them").help("delete the other"));
            }
            (Some(field), None) => vec![field],
            (None, Some(fields)) if fields.is_empty() => {
                return Err(Refused::at("fields").found("an empty list").allowed_is("one name or more"));
            }
            (None, Some(fields)) => fields,
        };
        if words.values.as_ref().is_some_and(Vec::is_empty) {
            return Err(Refused::at("values").found("an empty list").allowed_is("one value or more"));
        }
        let spreads = [
            ("values", words.values.map(Spread::Values)),
            ("grid", words.grid.map(Spread::Grid)),
            ("uniform", words.uniform.map(Spread::Uniform)),
            ("log_uniform", words.log_uniform.map(Spread::LogUniform)),
            ("normal", words.normal.map(Spread::Normal)),
            ("log_normal", words.log_normal.map(Spread::LogNormal)),
        ];
        let mut given = spreads.into_iter().filter_map(|(name, spread)| Some((name, spread?)));
        let (name, spread) = given.next().ok_or_else(|| {
            let none = Refused::default().found("no values");
            none.allowed_is("one of `values`, `grid`, `uniform`, `log_uniform`, `normal` and `log_normal`")
                .help("say how the field varies")
        })?;
        if let Some((other, _)) = given.next() {
            let both = Refused::default().found(format!("both `{name}` and `{other}`"));
            return Err(both.allowed_is("one of them").help("delete the other"));
        }
        spread.check()?;
        Ok(Self { fields, spread })
    }
}
