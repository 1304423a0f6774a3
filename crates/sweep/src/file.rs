//! What a user writes: a scene, what of it varies, and what is wanted of every run.

use pounding_text::Refused;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::distribution::{LogNormal, Normal};
use super::spread::{Between, Grid, Spread};
use super::summary_file::Summary;
use pounding_scene::{Error, FloorQuantity, PairQuantity, RunBudget};

/// A sweep: one scene, run again and again with other values of its fields, under one record or many.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SweepFile {
    /// The scene: the path of its file, from the folder of this file, or the scene itself.
    pub scene: SceneOf,
    /// What varies. Grids and lists are combined, each value with all others, the last one fastest; everything that is
    /// sampled forms one further axis, faster than they.
    #[serde(default)]
    pub vary: Vec<Vary>,
    /// How many samples, of fields that vary at random.
    #[serde(default)]
    pub samples: Option<Samples>,
    /// Folders of records and record files, which shake the scene instead of its own record; paths from the folder of this
    /// file.
    #[serde(default)]
    pub records: Option<Records>,
    /// In which directions every record shakes; without it as the scene says.
    #[serde(default)]
    pub directions: Option<Directions>,
    /// Which numbers are wanted of every run.
    #[serde(default)]
    pub outputs: Outputs,
    /// Whether every run is asked whether it keeps the laws of mechanics, and fails where it breaks one; without it `true`.
    #[serde(default = "yes")]
    pub verdict: bool,
    /// What every run may cost before it is given up, which then is a row with the reason; without it as the scene says.
    #[serde(default)]
    pub budget: Option<RunBudget>,
    /// What is told of all runs together: counts, means, quantiles, exceedances; rows are then written where it asks for them.
    #[serde(default)]
    pub summary: Option<Summary>,
}

/// Deserialisers are large: they are compiled here once, and not with every program that reads a sweep.
impl SweepFile {
    /// Reads a sweep from the text of a JSON or TOML file, as [`is_json`](pounding_scene::is_json) tells them apart.
    ///
    /// # Errors
    /// [`Error::Form`], with the `path` that the text came from.
    pub fn parse(text: &[u8], path: &Path) -> Result<Self, Error> {
        pounding_scene::parse(text, path)
    }
}

/// The JSON Schema (2020-12) of a sweep file, made from the types that read it.
pub fn sweep_schema() -> String {
    pounding_scene::schema_of::<SweepFile>()
}

fn yes() -> bool {
    true
}

/// A scene, or the path of its file.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(from = "Value")]
#[schemars(with = "SceneOfFile")]
pub enum SceneOf {
    /// In a file of its own.
    File(String),
    /// As it stands.
    Inline(Value),
}

/// A scene, or the path of its file, for the schema.
#[derive(JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "a schema is made of the type alone")]
enum SceneOfFile {
    /// Its file, from the folder of the sweep.
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

/// How many samples are taken of all that vary at random.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "SamplesFile")]
#[schemars(with = "SamplesFile")]
pub struct Samples {
    /// Number of samples, ≥ 1.
    pub count: u64,
    /// Seed: the same gives the same samples.
    pub seed: u64,
    /// How they are spread.
    pub method: SampleMethod,
}

/// The number of samples in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct SamplesFile {
    /// Number of samples, ≥ 1.
    count: u64,
    /// Seed: the same gives the same samples.
    seed: u64,
    /// How they are spread.
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

/// How samples are spread.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SampleMethod {
    /// Independent of each other.
    Random,
    /// A scrambled Sobol sequence: even in all axes together; counts that are powers of two are the most even.
    Sobol,
    /// One sample in each of as many equal parts of every axis as there are samples.
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

/// In which directions a record shakes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Directions {
    /// As the file has it.
    AsRecorded,
    /// Left becomes right.
    Reversed,
    /// First as recorded, then reversed.
    Both,
}

impl Directions {
    /// Of each whether it is reversed.
    pub(super) fn reversed(self) -> &'static [bool] {
        match self {
            Self::AsRecorded => &[false],
            Self::Reversed => &[true],
            Self::Both => &[false, true],
        }
    }
}

/// The numbers that are wanted of every run, a column each.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Outputs {
    /// Of every structure, of a building of every floor.
    pub structures: Vec<FloorQuantity>,
    /// Of every building and structure the severest of all floors: the largest by magnitude.
    pub buildings: Vec<FloorQuantity>,
    /// Of every pair of floors that can touch.
    pub pairs: Vec<PairQuantity>,
    /// Of every two neighbours the severest of all levels: the largest number, the least opening, the first start.
    pub neighbours: Vec<PairQuantity>,
}

impl Default for Outputs {
    fn default() -> Self {
        Self {
            structures: vec![FloorQuantity::PeakDisplacementM],
            buildings: Vec::new(),
            neighbours: Vec::new(),
            pairs: vec![PairQuantity::Collisions, PairQuantity::PeakForceN, PairQuantity::TotalImpulseNS],
        }
    }
}

/// One thing that varies: a field of the scene, or several that always have the same value.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(try_from = "VaryFile")]
#[schemars(with = "VaryFile")]
pub struct Vary {
    /// The fields, in the words of messages: `structures[0].sdof.period_s`; `[*]` stands for every item of a list.
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

/// What varies in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct VaryFile {
    /// The field of the scene, such as `contacts[0].gap_m`; `contacts[*].gap_m` stands for all gaps.
    field: Option<String>,
    /// Several fields that always have the same value; or `field`.
    fields: Option<Vec<String>>,
    /// Its values one by one.
    values: Option<Vec<Value>>,
    /// Values at equal distances.
    grid: Option<Grid>,
    /// Random, every value between two numbers as likely.
    uniform: Option<Between>,
    /// Random, its logarithm uniform.
    log_uniform: Option<Between>,
    /// Random, normally distributed.
    normal: Option<Normal>,
    /// Random, its logarithm normally distributed.
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
