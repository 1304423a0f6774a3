//! The ground motions of a sweep. Each is read once, and processed once unless runs need different processing.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::file::{Records, SweepFile};
use super::plan::Axis;
use pounding_assess::Suite;
use pounding_scene::{Error, GroundMotion, Implausible, RecordUse, Scene, SharedMotion, Source};
use pounding_text::Refused;

/// Motions that were read before the sweep, in place of those of its file.
#[derive(Debug, Clone)]
pub struct ScaledSuite {
    /// The motions; one or more.
    pub suite: Suite,
    /// Factor on each of them \[–\], besides the scale of the scene.
    pub factors: Vec<f64>,
}

/// A ground motion in one direction.
#[derive(Debug, Clone)]
pub(super) struct Shaking {
    /// Name in its rows.
    pub(super) name: String,
    /// Number of its event: components and directions of a record are one event.
    pub(super) event: usize,
    /// How the scene uses it.
    record: RecordUse,
    /// SHA-256 of its file; empty for a generated motion.
    sha256: String,
    /// The motion; it keeps its file only if runs process it again.
    motion: SharedMotion,
}

/// Differences of the motion between runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Differs {
    Nothing,
    /// Only its scale, which multiplies the processed motion at the end.
    Scale,
    /// Any other part of its use: it is processed again.
    Use,
}

impl Differs {
    pub(super) fn by(axes: &[Axis]) -> Self {
        let of_record = axes
            .iter()
            .flat_map(|axis| &axis.fields)
            .filter(|place| place.begins_with("record"));
        let mut differs = Self::Nothing;
        for place in of_record {
            if !place.is_in("record.scale") {
                return Self::Use;
            }
            differs = Self::Scale;
        }
        differs
    }
}

/// All motions of a sweep.
#[derive(Debug, Clone)]
pub(super) struct Motions {
    pub(super) all: Vec<Shaking>,
    /// Unusual properties of each motion, by its name.
    pub(super) unusual: Vec<(String, Implausible)>,
    /// The records of folders, and the omitted ones; `None` for the scene's record.
    pub(super) suite: Option<Suite>,
    /// Files that were read, including omitted ones.
    pub(super) files: Vec<PathBuf>,
    /// Whether they replace the scene's record, whose duration is then ignored.
    replace: bool,
    duration_varies: bool,
    pub(super) differs: Differs,
}

impl Motions {
    /// Reads the motions of a sweep whose first run is this scene, unless they are `given`; `base` is the folder of its file, `of_scene` that
    /// of the scene's.
    pub(super) fn read(
        file: &SweepFile,
        given: Option<&ScaledSuite>,
        [base, of_scene]: [&Path; 2],
        scene: &Scene,
        axes: &[Axis],
    ) -> Result<Self, Refused> {
        let differs = Differs::by(axes);
        let mut record = scene.record.clone();
        if differs == Differs::Scale {
            record.scale = 1.0;
        }
        let own = [record.reversed];
        let directions = file.directions.map_or(&own[..], |all| all.reversed());
        let mut motions = Self {
            all: Vec::new(),
            unusual: Vec::new(),
            suite: None,
            files: Vec::new(),
            replace: file.records.is_some() || given.is_some(),
            duration_varies: axes.iter().flat_map(|axis| &axis.fields).any(|place| place.is_in("duration_s")),
            differs,
        };
        let suite = match (given, &file.records) {
            (Some(given), _) => given.suite.clone(),
            (None, Some(records)) => Self::suite_of(records, base, &record)?,
            (None, None) => {
                if let Source::File(file) = &record.source {
                    motions.files.push(of_scene.join(&file.file));
                }
                for record in in_directions(&record, directions) {
                    let motion = GroundMotion::of(&record, of_scene, &scene.name)?;
                    motions.add(&own_name(&record.source), 0, record, motion);
                }
                return Ok(motions);
            }
        };
        for (index, motion) in suite.motions.iter().enumerate() {
            for mut record in in_directions(&record, directions) {
                record.scale *= given.map_or(1.0, |given| given.factors[index]);
                let (record, used) = motion.used_as(&record, &scene.name)?;
                motions.add(&motion.name, motion.event, record, used);
            }
        }
        motions.files.clone_from(&suite.files);
        motions.suite = Some(suite);
        Ok(motions)
    }

    /// The motions of the folders and files that a sweep names; one or more.
    fn suite_of(records: &Records, base: &Path, record: &RecordUse) -> Result<Suite, Refused> {
        let mut paths = Vec::new();
        for path in records.paths() {
            let path = base.join(path);
            if !path.exists() {
                let none = Refused::at("records").found(format!("no file or folder {}", path.display()));
                return Err(none.allowed_is("one that is there, seen from the folder of the sweep"));
            }
            paths.push(path);
        }
        let suite = Suite::of(&paths, &record.declared())?;
        if suite.motions.is_empty() {
            let left_out = suite.said_of_left_out(false);
            let said = [vec![records.paths().join(", ")], left_out].concat();
            let none = Refused::at("records").found(format!("no record in {}", said.join("; ")));
            return Err(none.allowed_is("a folder with one or more, or a file"));
        }
        Ok(suite)
    }

    fn add(&mut self, name: &str, event: usize, record: RecordUse, motion: GroundMotion) {
        let doubts = motion.doubts(&record, self.differs == Differs::Nothing);
        let named = doubts.into_iter().map(|doubt| (name.to_owned(), doubt));
        self.unusual.extend(named);
        let origin = motion.origin.as_ref();
        let sha256 = origin.map(|origin| origin.sha256.clone());
        let mut motion = SharedMotion::from(motion);
        if self.differs != Differs::Use {
            motion.origin = None;
        }
        self.all.push(Shaking {
            name: name.into(),
            event,
            record,
            sha256: sha256.unwrap_or_default(),
            motion,
        });
    }

    /// The scene of a run under this motion, and the motion as used by the scene.
    pub(super) fn shake(&self, index: usize, mut scene: Scene) -> Result<(Scene, SharedMotion), Error> {
        let shaking = &self.all[index];
        scene.record.reversed = shaking.record.reversed;
        if self.replace {
            scene.record.source.clone_from(&shaking.record.source);
            if !self.duration_varies {
                scene.duration_s = None;
            }
        }
        let motion = match self.differs {
            Differs::Nothing => Ok(shaking.motion.clone()),
            Differs::Scale => shaking.motion.scaled(scene.record.scale),
            Differs::Use => shaking.used_anew(&scene.record),
        };
        match motion {
            Ok(motion) => Ok((scene, motion)),
            Err(refused) => Err(Error::in_scene(&scene.name, refused)),
        }
    }

    /// Whether runs may have separate motions, besides those of the records.
    pub(super) fn differ(&self) -> bool {
        self.differs != Differs::Nothing
    }

    /// Index of the longest motion.
    pub(super) fn longest(&self) -> usize {
        let duration = |index: &usize| self.all[*index].motion.record().duration();
        let all = 0..self.all.len();
        let longest = all.max_by(|one, other| duration(one).total_cmp(&duration(other)));
        longest.unwrap_or(0)
    }

    /// Identification of a set of motions: names, directions and SHA-256 of files.
    pub(super) fn marks(&self) -> impl Iterator<Item = String> {
        self.all.iter().map(|shaking| {
            let Shaking { name, sha256, .. } = shaking;
            format!("{name} {} {sha256}", shaking.is_reversed())
        })
    }
}

impl Shaking {
    pub(super) fn is_reversed(&self) -> bool {
        self.record.reversed
    }

    /// The motion, processed as another use of it says.
    fn used_anew(&self, record: &RecordUse) -> Result<SharedMotion, Refused> {
        let motion = match (&record.source, &self.motion.origin) {
            (Source::Generated(generated), _) => GroundMotion::of_formula(record, generated),
            (Source::File(_), Some(origin)) => GroundMotion::of_file(record, Arc::clone(origin)),
            (Source::File(_), None) => unreachable!("what was read of a file has an origin"),
        };
        motion.map(SharedMotion::from)
    }
}

/// The use of a record in several directions; `true` is reversed.
fn in_directions(record: &RecordUse, directions: &[bool]) -> Vec<RecordUse> {
    let use_of = |reversed: &bool| RecordUse {
        reversed: *reversed,
        ..record.clone()
    };
    directions.iter().map(use_of).collect()
}

/// Name of a scene's motion.
fn own_name(source: &Source) -> String {
    let Source::File(file) = source else {
        return source.to_string();
    };
    let name = Path::new(&file.file).file_name().unwrap_or_default();
    let name = name.to_string_lossy();
    match &file.component {
        Some(component) => format!("{name} {component}"),
        None => name.into_owned(),
    }
}
