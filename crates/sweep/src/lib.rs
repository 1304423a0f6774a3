//! Sweeps: a scene that runs many times with other values of its fields.
//!
//! [`SweepFile`] is the file of a user. [`Sweep`] finds every run from its number alone. A shard is therefore a range of numbers, and any
//! range runs as a [`Batch`]. [`Parts`] writes rows into files of a fixed number of runs; after a stop it only runs the missing files.
//! [`merge`] joins them into a table.
//!
//! ```
//! use pounding_sweep::{Sweep, SweepFile};
//! let text = br#"
//!     vary = [{ field = "contacts[0].law.stereomechanical.restitution", values = [0.2, 0.6, 1.0] }]
//!     outputs = { structures = [], pairs = ["first_impulse_n_s"] }
//!     [scene]
//!     name = "a tower beside a wall, shaken by half a sine of half the tower's period"
//!     record.generated.half_sine = { amplitude_m_per_s2 = -4.0, duration_s = 0.5, time_step_s = 0.001 }
//!     structures = [{ sdof = { name = "tower", mass_kg = 1e5, period_s = 1.0, damping.ratio = 0 } }, { wall = {} }]
//!     contacts = [{ gap_m = 0.05066059, law.stereomechanical.restitution = 0.65 }]"#;
//! let path = "sweep.toml".as_ref();
//! let sweep = Sweep::of(&SweepFile::parse(text, path)?, text, path, None)?;
//!
//! // The tower arrives with A T/8 = 0.5 m/s, whatever the restitution: (1+e) m v₀ is 60, 80 and 100 kN·s.
//! let impulses = sweep.batch(0..sweep.n_runs()).columns.concat();
//! assert!(impulses.iter().zip([60e3, 80e3, 100e3]).all(|(impulse, theory)| (impulse / theory - 1.0).abs() < 1e-5));
//! # Ok::<(), pounding_text::Refused>(())
//! ```
//!
//! Not in this crate: a scheduler (yours distributes the shards), and figures. Surveys with figures are in `pounding-studies`.
//!
//! Where to start:
//!
//! - [`SweepFile`], with [`Vary`], [`Spread`], [`Samples`] and [`Outputs`] and [`Summary`]: the words of a file.
//! - [`Sweep::batch`] for runs in memory; [`Parts::open`], [`Parts::fill`] and [`merge`] for a table on disk.
//! - `beside.rs` in the source: which runs use SIMD lanes.

mod accuracy;
mod batch;
mod beside;
mod checked;
mod choosing;
mod column;
mod column_errors;
mod distribution;
mod error;
mod field_path;
mod file;
mod join;
mod manifest;
mod motions;
mod output;
mod part;
mod parts;
mod permutation;
mod plan;
mod prices;
mod quantile;
mod renumbered;
mod rows;
mod sampling;
mod shard;
mod side_by_side;
mod spread;
mod stripe_motions;
mod stripes;
mod summary;
mod summary_file;
mod table;
mod trial;

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use serde_json::Value;
use sha2::{Digest, Sha256};

pub use accuracy::SweepAccuracy;
pub use batch::Batch;
pub use checked::Checked;
use choosing::Choosing;
pub use column::SweepColumn;
pub use column_errors::ColumnErrors;
pub use distribution::{LogNormal, Normal};
pub use file::{Directions, Outputs, Records, SampleMethod, Samples, SceneOf, SweepFile, Vary, sweep_schema};
pub use join::{Joined, beside_table, compresses, merge, summary_beside};
use motions::Motions;
pub use motions::ScaledSuite;
use output::{Output, RowShape};
pub use parts::Parts;
use plan::{Plan, Setting, placed, varies_method};
pub use shard::Shard;
pub use spread::{Between, Grid, Spacing, Spread};
pub use stripe_motions::StripeMotions;
pub use stripes::StripesAsked;
pub use summary::{Exceedance, SummaryTable, SummedCell, SummedColumn};
pub use summary_file::Summary;

use pounding_assess::Suite;
use pounding_scene::file::in_file;
use pounding_scene::{Implausible, Method, PairQuantity, Quantity, Scene, Simulation};
use pounding_text::{RefusalKind, Refused};

/// The numbers that need closings.
const OPENINGS: [Quantity; 3] = [
    Quantity::Pair(PairQuantity::LeastOpeningM),
    Quantity::Pair(PairQuantity::LargestOpeningM),
    Quantity::Pair(PairQuantity::UnseatedS),
];

/// A sweep with its scene and records, after a trial of its values.
#[derive(Debug)]
pub struct Sweep {
    plan: Plan,
    motions: Motions,
    /// The scene that is varied.
    scene: Value,
    row: RowShape,
    /// The columns of numbers.
    outputs: Vec<Output>,
    verdict: bool,
    /// Whether least or largest openings, or the loss of a seat, are requested.
    closings: bool,
    /// Choice of the method, if the scene requests an accuracy.
    accuracy: Option<SweepAccuracy>,
    /// Form of the summary, if requested.
    summary: Option<summary::Form>,
    /// SHA-256 of all inputs of the rows.
    sha256: String,
    /// Files that were read.
    inputs: Vec<PathBuf>,
    /// Stop flag: ends all runs when set.
    stop: Option<&'static AtomicBool>,
    /// Progress of the choice of a method, while it lasts.
    choosing: Option<Choosing>,
}

/// A sweep in words, and what they stand for.
#[derive(Clone, Copy)]
struct SweepWords<'a> {
    file: &'a SweepFile,
    /// The file as read.
    bytes: &'a [u8],
    path: &'a Path,
    /// Motions in place of those of the file.
    given: Option<&'a ScaledSuite>,
}

/// The scene of a sweep as read.
struct Read {
    scene: Value,
    /// Its file; the sweep's file if the scene is in it.
    path: PathBuf,
    bytes: Vec<u8>,
}

impl Sweep {
    /// Reads a sweep, its scene and its records. Tries the values of its grids and lists, each with the first values of all others, and
    /// chooses the method if an accuracy is requested. Setting `stop` ends this and all runs.
    ///
    /// # Errors
    /// Names the line of the field. Of [`RefusalKind::Stopped`] where somebody says stop while a method is chosen.
    pub fn read(path: &Path, stop: Option<&'static AtomicBool>) -> Result<Self, Refused> {
        Self::read_followed(path, stop, |_, _| {})
    }

    /// [Reads](Self::read) a sweep; while a method is chosen, `told` gets the number of runs of samples that are done, and about how many
    /// there will be.
    ///
    /// # Errors
    /// Those of [`Self::read`].
    pub fn read_followed(
        path: &Path,
        stop: Option<&'static AtomicBool>,
        told: impl Fn(u64, u64) + Send + Sync + 'static,
    ) -> Result<Self, Refused> {
        let bytes = pounding_scene::file::bytes(path).map_err(|error| Refused::unreadable(path, &error))?;
        let file = SweepFile::parse(&bytes, path)?;
        let of = SweepWords {
            file: &file,
            bytes: &bytes,
            path,
            given: None,
        };
        Self::followed(&of, stop, Choosing::new(told)).map_err(|refused| {
            let is_stopped = refused.is_kind(RefusalKind::Stopped);
            if is_stopped { refused } else { in_file(refused, path) }
        })
    }

    /// Makes a sweep from a file that was read as these bytes, which identify its parts.
    ///
    /// # Errors
    /// Those of [`Self::read`], without the name of the file.
    ///
    /// # Panics
    /// Never: a budget is numbers and their names, which JSON holds.
    pub fn of(file: &SweepFile, bytes: &[u8], path: &Path, stop: Option<&'static AtomicBool>) -> Result<Self, Refused> {
        let of = SweepWords {
            file,
            bytes,
            path,
            given: None,
        };
        Self::followed(&of, stop, Choosing::new(|_, _| {}))
    }

    /// Makes a sweep under motions that were read before. Its scene is inline, or in a file seen from the folder of `path`.
    ///
    /// # Errors
    /// Those of [`Self::read`], without the name of the file.
    pub fn under(file: &SweepFile, path: &Path, given: &ScaledSuite, stop: Option<&'static AtomicBool>) -> Result<Self, Refused> {
        let of = SweepWords {
            file,
            bytes: &[],
            path,
            given: Some(given),
        };
        Self::followed(&of, stop, Choosing::new(|_, _| {}))
    }

    fn followed(of: &SweepWords<'_>, stop: Option<&'static AtomicBool>, choosing: Choosing) -> Result<Self, Refused> {
        let SweepWords { file, bytes, path, given } = *of;
        let folder = |path: &Path| path.parent().unwrap_or_else(|| Path::new("")).to_path_buf();
        let mut read = Read::of(&file.scene, path)?;
        if let (Some(budget), Some(scene)) = (file.budget, read.scene.as_object_mut()) {
            scene.insert("budget".into(), serde_json::json!(budget));
        }
        set_tolerance(&mut read.scene);
        let vary = placed(file, &read.scene)?;
        let asked = accuracy::asked(&read.scene);
        if asked.is_some() && vary.iter().any(|(_, fields)| varies_method(fields)) {
            let found = "a field of `method` where scene.method asks for an accuracy, for which one method is chosen";
            return Err(Refused::at("vary").found(found).help("leave one of them out"));
        }
        // Motions are read as in the first run, independent of their number.
        let first = Plan::new(vary.clone(), file.samples, 1)?;
        let scene = trial::first_scene(&first, &read.scene)?;
        let (base, of_scene) = (folder(path), folder(&read.path));
        let motions = Motions::read(file, given, [&base, &of_scene], &scene, first.axes());
        let motions = motions.map_err(|error| trial::blamed(error, &first, [path, &read.path]))?;
        let plan = Plan::new(vary, file.samples, motions.all.len())?;
        let sha256 = hash(bytes, &read.bytes, &motions);
        let mut inputs = motions.files.clone();
        inputs.extend([path.to_path_buf(), read.path]);
        let mut sweep = Self {
            row: RowShape::default(),
            closings: false,
            outputs: Vec::new(),
            verdict: file.verdict,
            scene: read.scene,
            plan,
            motions,
            accuracy: None,
            summary: None,
            sha256,
            inputs,
            stop,
            choosing: None,
        };
        if asked.is_some() {
            sweep.set_method(&Method::EXACT);
        }
        sweep.row = match sweep.tried()? {
            Some(row) => row,
            None => trial::row_of(&scene)?,
        };
        sweep.outputs = sweep.row.outputs(&file.outputs);
        sweep.closings = sweep.outputs.iter().any(|one| OPENINGS.contains(&one.quantity));
        if let Some(words) = &file.summary {
            let directions = file.directions.map_or(1, |all| all.reversed().len());
            sweep.summary = Some(sweep.form(words, directions)?);
        }
        if let Some(asked) = asked {
            sweep.choosing = Some(choosing);
            sweep.choose(asked);
            sweep.choosing = None;
            if sweep.is_stopped() {
                let stopped = Refused::that("stopped while a method was chosen").kind(RefusalKind::Stopped);
                return Err(stopped.help("the same command begins with that again"));
            }
        }
        Ok(sweep)
    }

    /// Number of runs.
    pub fn n_runs(&self) -> u64 {
        self.plan.n_runs()
    }

    /// Form of the summary that replaces rows.
    fn without_rows(&self) -> Option<&summary::Form> {
        self.summary.as_ref().filter(|form| !form.rows)
    }

    /// Whether a summary is written next to the table, which has rows.
    pub fn has_summary_beside(&self) -> bool {
        self.summary.is_some() && self.without_rows().is_none()
    }

    /// Unusual values in the motions and in rows. The rows have the first values of grids and lists and the medians of samples; further
    /// rows have each end of each axis.
    pub fn unusual(&self) -> Vec<Implausible> {
        let typical = self.plan.typical();
        let mut of_rows = self.doubts(&typical);
        let mut of_records = Vec::new();
        for (index, axis) in self.plan.axes().iter().enumerate() {
            let of_record = axis.fields.iter().any(|place| place.begins_with("record"));
            for end in axis.ends() {
                let mut settings = typical.clone();
                settings[index] = end;
                of_rows.extend(self.doubts(&settings));
                if of_record {
                    for motion in 0..self.motions.all.len().min(MOST_LOOKED_AT) {
                        let doubts = self.row(&settings, motion).map_or_else(Vec::new, |row| row.doubts());
                        let name = self.motions.all[motion].name.clone();
                        let doubts = doubts.into_iter().filter(|one| !one.is_of_row());
                        of_records.extend(doubts.map(|one| (name.clone(), one)));
                    }
                }
            }
        }
        let of_motions = self.motions.unusual.iter();
        let of_motions = of_motions.map(|(name, one)| (name.as_str(), one));
        let of_motions = of_motions.chain(of_records.iter().map(|(name, one)| (name.as_str(), one)));
        Implausible::gathered(of_motions.chain(of_rows.iter().map(|one| ("", one))))
    }

    /// Unusual values in the row with these settings.
    fn doubts(&self, settings: &[Setting]) -> Vec<Implausible> {
        let mut doubts = self.row(settings, 0).map_or_else(Vec::new, |row| row.doubts());
        doubts.retain(Implausible::is_of_row);
        doubts
    }

    /// The row with typical values under the first motion; `None` if it cannot be prepared.
    fn first_row(&self) -> Option<Simulation> {
        self.row(&self.plan.typical(), 0)
    }

    /// The row with these values, one for each axis, under a motion; `None` if it cannot be prepared.
    fn row(&self, settings: &[Setting], motion: usize) -> Option<Simulation> {
        let mut value = self.scene.clone();
        for (axis, setting) in self.plan.axes().iter().zip(settings) {
            axis.put(*setting, &mut value);
        }
        let scene = trial::scene_of(&value).ok()?;
        let (scene, motion) = self.motions.shake(motion, scene).ok()?;
        Simulation::shaken(&scene, motion).ok()
    }

    /// Messages about contact: if the scene has none, or if floors cannot touch their neighbours.
    pub fn says_of_contact(&self) -> Vec<String> {
        let Some(row) = self.first_row() else {
            return Vec::new();
        };
        let none = row.floors().says_no_contact().map(String::from);
        none.into_iter().chain(row.floors().says_unwatched()).collect()
    }

    /// Returns the records of folders, and the omitted ones; `None` if the scene's record is used.
    pub fn suite(&self) -> Option<&Suite> {
        self.motions.suite.as_ref()
    }

    /// Returns the files that were read: sweep, scene, records.
    pub fn inputs(&self) -> &[PathBuf] {
        &self.inputs
    }

    /// SHA-256 of all inputs of the rows, in hexadecimal digits.
    pub fn sha256(&self) -> &str {
        &self.sha256
    }
}

impl Read {
    fn of(scene: &SceneOf, path: &Path) -> Result<Self, Refused> {
        match scene {
            SceneOf::Inline(scene) => Ok(Self {
                scene: scene.clone(),
                path: path.to_path_buf(),
                bytes: Vec::new(),
            }),
            SceneOf::File(name) => {
                let path = path.parent().unwrap_or_else(|| Path::new("")).join(name);
                let bytes = pounding_scene::file::bytes(&path).map_err(|error| Refused::unreadable(&path, &error))?;
                // Its faults are told with their lines.
                Scene::parse(&bytes, &path)?;
                Ok(Self {
                    scene: pounding_scene::file::parse(&bytes, &path)?,
                    path,
                    bytes,
                })
            }
        }
    }
}

/// Tolerance of the exact method in a sweep if the scene gives none: the finest that lanes support.
/// Most motions whose strength at the ends of an axis is looked at.
const MOST_LOOKED_AT: usize = 100;

const TOLERANCE: f64 = 1e-12;

/// Sets the tolerance of the exact method to that of a sweep if the scene gives none.
fn set_tolerance(scene: &mut Value) {
    let Some(scene) = scene.as_object_mut() else {
        return;
    };
    let method = scene.entry("method").or_insert_with(|| serde_json::json!({"exact": {}}));
    if method.as_str() == Some("exact") {
        *method = serde_json::json!({"exact": {}});
    }
    if let Some(exact) = method.get_mut("exact").and_then(Value::as_object_mut) {
        exact.entry("tolerance").or_insert_with(|| TOLERANCE.into());
    }
}

/// SHA-256 of the sources that compute, from the build script.
const SOURCES: &str = env!("POUNDING_SOURCES");

/// SHA-256 of all inputs of the rows: the sources of the program, the files of sweep and scene, the motions.
fn hash(sweep: &[u8], scene: &[u8], motions: &Motions) -> String {
    let mut hash = Sha256::new();
    hash.update(SOURCES);
    for bytes in [sweep, scene] {
        hash.update((bytes.len() as u64).to_le_bytes());
        hash.update(bytes);
    }
    for mark in motions.marks() {
        hash.update((mark.len() as u64).to_le_bytes());
        hash.update(mark);
    }
    pounding_scene::hexadecimal(&hash.finalize())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// A sweep of one structure under half a sine in which this varies.
    fn sweep(vary: &Value, seed: u64) -> Result<Sweep, Refused> {
        let sampled = vary.to_string().contains("normal");
        let samples = sampled.then(|| json!({"count": 4, "seed": seed, "method": "random"}));
        let file = json!({
            "scene": {
                "name": "one",
                "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}}},
                "structures": [{"sdof": {"name": "one", "mass_kg": 1e5, "period_s": 0.8, "damping": {"ratio": 0.05}}}],
            },
            "vary": vary,
            "samples": samples,
        });
        let file = serde_json::from_value(file).expect("the words of a sweep");
        Sweep::of(&file, b"", Path::new("sweep.json"), None)
    }

    #[test]
    fn issue_a_field_within_another_that_varies_is_refused() {
        let damping = json!({"field": "structures[0].sdof.damping", "values": [{"ratio": 0.02}]});
        let ratio = json!({"field": "structures[0].sdof.damping.ratio", "values": [0.03, 0.04]});
        for vary in [json!([damping, ratio]), json!([ratio, damping])] {
            let refused = sweep(&vary, 0).expect_err("one would undo the other");
            assert!(refused.to_string().contains("a second time"), "{refused}");
        }
    }

    #[test]
    fn issue_no_seed_decides_whether_a_sweep_is_accepted() {
        let mass = json!({"mean": 1e5, "standard_deviation": 1e5});
        let vary = json!([{"field": "structures[0].sdof.mass_kg", "normal": mass}]);
        let mut failed = 0;
        for seed in 0..30 {
            let batch = sweep(&vary, seed).expect("the median is a mass").batch(0..4);
            failed += batch.failed.iter().flatten().count();
        }
        assert!((5..60).contains(&failed), "{failed} of 120 masses are below 0");
    }
}
