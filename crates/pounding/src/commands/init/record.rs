//! A record of the user: how a scene names it, and what the scene has to declare.

use std::fs;
use std::path::{Component, Path, PathBuf};

use pounding::motion::{AccelerationUnit, Accelerogram, Declared, components, read_declared};
use pounding::scene::STANDARD_GRAVITY;
use pounding::scene::file::record_bytes;
use pounding::text::{Knob, Naming, RefusalKind, Refused, digits, short, steers, visible};
use serde_json::json;

use crate::commands::folder;

/// A record as the lines of a scene.
pub(super) struct Named {
    /// From the folder of the scene, or absolute.
    path: String,
    is_absolute: bool,
    /// The content of the record in words; `None` while a declaration is missing.
    holds: Option<String>,
    missing: Vec<Missing>,
}

/// A field that the scene has to give.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Missing {
    field: &'static str,
    /// Why it is missing.
    why: &'static str,
    /// A value to begin with.
    example: &'static str,
    /// The values that are allowed.
    allowed: String,
}

/// Most folders between a scene and the folder that it shares with its record; a longer path from the scene is no help.
const MOST_UP: usize = 3;

impl Named {
    /// Reads a record, as far as it goes, and names it from the folder of a scene; both paths are seen from here.
    ///
    /// # Errors
    /// Says what cannot be read, or is no record.
    pub(super) fn of(record: &Path, scene: &Path) -> Result<Self, Refused> {
        let option = || format!("--record {}", record.display());
        let unreadable = |error: std::io::Error| Refused::at(option()).is(format!("cannot be read: {error}"));
        if fs::metadata(record).map_err(unreadable)?.is_dir() {
            let folder = Refused::at(option()).found("a folder").allowed_is("a file");
            return Err(folder.help("`pounding run SCENE --records` takes a folder"));
        }
        let bytes = record_bytes(record).map_err(unreadable)?;
        let (holds, missing) = read(&bytes).map_err(|refused| in_option(refused, record))?;
        let (path, is_absolute) = match from_scene(record, scene) {
            Some(path) => (path, false),
            None => (std::path::absolute(record).map_err(unreadable)?, true),
        };
        let path = path.into_os_string().into_string().map_err(|_| {
            let name = Refused::at(option()).found("a name that is not UTF-8");
            name.allowed_is("one that is: a scene is text").help("rename the file")
        })?;
        Ok(Self {
            path,
            is_absolute,
            holds,
            missing,
        })
    }

    /// The lines of a scene.
    pub(super) fn lines(&self) -> String {
        // A literal string of TOML, in which a backslash is itself; JSON's strings are TOML's, too.
        let awkward = |letter: char| letter == '\'' || letter == '\n' || letter == '\t' || steers(letter);
        let quoted = if self.path.contains(awkward) {
            visible(&json!(self.path).to_string()).into_owned()
        } else {
            format!("'{}'", self.path)
        };
        let seen = if self.is_absolute {
            "absolute: other machines do not have it there"
        } else {
            "seen from the folder of this file"
        };
        let file = format!("file = {quoted}    # {seen}");
        let missing = self.missing.iter().map(|one| {
            // Names come from the file; a comment is one line.
            let allowed = one.allowed.replace('\n', " ");
            let allowed = visible(&allowed);
            format!("# {} = {}    # to fill in, {}: {allowed}", one.field, one.example, one.why)
        });
        std::iter::once(file).chain(missing).collect::<Vec<_>>().join("\n")
    }

    /// A sentence about the record, after the scene is written.
    pub(super) fn said(&self, scene: &str, is_json: bool) -> String {
        let missing = self.missing.iter();
        let missing: Vec<String> = missing.map(|one| format!("`{}` ({})", one.field, one.why)).collect();
        let example = |one: &Missing| format!("\"{}\": {} ({})", one.field, one.example, one.allowed);
        let examples: Vec<String> = self.missing.iter().map(example).collect();
        match &self.holds {
            Some(holds) => holds.clone(),
            None if is_json => format!(
                "it needs {}: add to \"record\" in {scene}, for example, {}",
                missing.join(" and "),
                examples.join("; ")
            ),
            None => format!(
                "it needs {}: fill in what stands for it in {scene} as a comment",
                missing.join(" and ")
            ),
        }
    }
}

/// The refusal of a record that an option names.
fn in_option(mut refused: Refused, record: &Path) -> Refused {
    let option = format!("--record {}", record.display());
    refused.place_mut().file = Some(option.into());
    refused
}

/// The content of a record in words, or the declarations that are missing.
fn read(bytes: &[u8]) -> Result<(Option<String>, Vec<Missing>), Refused> {
    let mut declared = Declared::default();
    let mut missing: Vec<Missing> = Vec::new();
    loop {
        // The values declared below only serve to find what else is missing.
        let refused = match read_declared(bytes, &declared) {
            Ok(file) if missing.is_empty() => {
                return Ok((Some(held(file)?), missing));
            }
            Ok(_) => return Ok((None, missing)),
            Err(refused) => refused,
        };
        let (field, example, allowed) = match refused.wanted() {
            Some(Knob::Unit) => {
                declared.unit = Some(AccelerationUnit::MetrePerSecondSquared);
                let names = AccelerationUnit::ALL.map(AccelerationUnit::name);
                ("unit", "\"g\"", format!("one of {}", names.join(", ")))
            }
            Some(Knob::TimeStep) if !refused.is_kind(RefusalKind::Uneven) => {
                declared.time_step = Some(1.0);
                ("time_step_s", "0.01", "time between samples [s]".into())
            }
            Some(Knob::PerCount) => {
                declared.per_count = Some(1.0);
                let allowed = "what one count of the digitiser is worth, in `unit`";
                ("per_count", "1e-6", allowed.into())
            }
            Some(Knob::Acceleration) if refused.is_kind(RefusalKind::Velocity) => {
                let found = refused.word().unwrap_or_default();
                declared.acceleration = true;
                let allowed = format!("only if the values are accelerations, though {found:?} speaks for velocities");
                ("acceleration", "true", allowed)
            }
            Some(Knob::Component) => {
                let names = components(bytes)?;
                declared.component = Some("1".into());
                ("component", "\"1\"", format!("one of {}", names.join("; ")))
            }
            _ => return Err(refused.by(Naming::Scene)),
        };
        let why = if field == "component" {
            "the file holds several"
        } else {
            "the file does not say it"
        };
        // A field that is missing although it was declared would never end the loop.
        if missing.iter().any(|one| one.field == field) {
            return Ok((None, missing));
        }
        missing.push(Missing {
            field,
            why,
            example,
            allowed,
        });
    }
}

/// The content of a record in words.
fn held(file: Accelerogram) -> Result<String, Refused> {
    let format = file.format().name();
    let record = file.into_record(STANDARD_GRAVITY);
    let record = record?;
    let (time, peak) = record.peak();
    Ok(format!(
        "{format}, {} samples, {} s apart, peak {} m/s² at {} s",
        record.samples().len(),
        digits(record.time_step()),
        short(peak),
        digits(time)
    ))
}

/// The path of a record from the folder of a scene: in it, below it, or not far beside it; `None` if that is no help.
fn from_scene(record: &Path, scene: &Path) -> Option<PathBuf> {
    let canonical = |path: &Path| {
        let folder = folder(path);
        let here = folder.as_os_str().is_empty();
        fs::canonicalize(if here { Path::new(".") } else { folder }).ok()
    };
    let (to, from) = (canonical(record)?, canonical(scene)?);
    let shared = to
        .components()
        .zip(from.components())
        .take_while(|(one, other)| one == other)
        .map(|(one, _)| one);
    let n_shared = shared.clone().count();
    // The root is shared by all.
    let related = shared.filter(|one| matches!(one, Component::Normal(_))).count() > 0;
    let up = from.components().count() - n_shared;
    if up > MOST_UP || (up > 0 && !related) {
        return None;
    }
    let up = std::iter::repeat_n(Component::ParentDir, up);
    let down = to.components().skip(n_shared);
    let name = Component::Normal(record.file_name()?);
    Some(up.chain(down).chain([name]).collect())
}
