//! Reasons why entries of a folder of records shake no row, a line for each reason.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use pounding_files::shown_name;
use pounding_scene::Error;
use pounding_text::{RefusalKind, short, two_digits};
use serde_json::{Value, json};

use super::{Suite, SuiteMotion};

/// An entry of a folder that shakes no row.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// Name of the entry, and of its component if it holds several.
    pub name: String,
    /// The entry.
    pub path: PathBuf,
    /// Reason why it is left out.
    pub reason: LeftOutReason,
    /// Motion that it holds. Only [`Suite::listed`] gives it, and only if it was read.
    pub motion: Option<Box<SuiteMotion>>,
}

/// Reason why an entry of a folder shakes no row.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct LeftOutReason {
    /// Kind of the entry.
    pub kind: LeftOutKind,
    /// Message of the system or of the reader, or the word that shows the kind; empty if there is none.
    pub said: String,
}

/// Kinds of entries that are left out. The first kinds matter most, because a record may be missing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum LeftOutKind {
    /// The system cannot read it.
    Unreadable,
    /// A reader refuses it.
    Refused,
    /// A folder inside the folder.
    Folder,
    /// A pipe, a socket or a device.
    NoFile,
    /// Every value is zero.
    Zeros,
    /// A velocity, by its content or its name.
    Velocity,
    /// A displacement, by its name.
    Displacement,
    /// A spectrum or another quantity, by its content or its name.
    NoAcceleration,
    /// The instrument stands in a borehole.
    Borehole,
    /// The instrument stands on a structure.
    Structure,
    /// A horizontal component without the other one, under an axis.
    Unpaired,
    /// It would need a larger factor than asked for.
    Scaled,
    /// A copy of another motion.
    Copy,
    /// Vertical, by the name that the file gives its component.
    Vertical,
    /// Vertical, by the name of the file.
    VerticalByName,
    /// A table that describes other files.
    Table,
    /// A file that no reader recognizes, such as a README.
    NoRecord,
}

impl LeftOut {
    /// A table beside the records.
    pub(super) fn table(path: &Path) -> Self {
        Self {
            name: shown_name(path),
            path: path.to_path_buf(),
            reason: LeftOutKind::Table.saying(""),
            motion: None,
        }
    }
}

impl LeftOutKind {
    /// Singular, plural, and the explanation.
    fn words(self) -> [&'static str; 3] {
        const ON_THE_GROUND: &str = "a row stands on the ground";
        const NO_ACCELERATION: &str = "only accelerations shake a row";
        match self {
            Self::Unreadable | Self::Refused => ["", "", ""],
            Self::Folder => ["folder", "folders", "give each as a folder of its own, or --sub-folders"],
            Self::NoFile => ["pipe or device", "pipes or devices", "only files are read"],
            Self::Zeros => ["record of zeros", "records of zeros", "they shake nothing"],
            Self::Velocity => ["velocity", "velocities", NO_ACCELERATION],
            Self::Displacement => ["displacement", "displacements", NO_ACCELERATION],
            Self::NoAcceleration => ["spectrum or other quantity", "spectra or other quantities", NO_ACCELERATION],
            Self::Borehole => ["record in a borehole", "records in boreholes", ON_THE_GROUND],
            Self::Structure => ["record on a structure", "records on structures", ON_THE_GROUND],
            Self::Unpaired => [
                "horizontal component alone",
                "horizontal components alone",
                "an axis needs two of one recording",
            ],
            Self::Scaled => [
                "record scaled too far",
                "records scaled too far",
                "they belong to other earthquakes",
            ],
            Self::Copy => ["copy", "copies", "each record counts once"],
            Self::Vertical => ["vertical component", "vertical components", "by the name in the file"],
            Self::VerticalByName => [
                "vertical component",
                "vertical components",
                "by the name of the file; rename a horizontal one",
            ],
            Self::Table => ["table of records", "tables of records", ""],
            Self::NoRecord => ["file that is no record", "files that are no records", ""],
        }
    }

    /// Whether a record that should be used may be missing.
    pub fn hides_a_record(self) -> bool {
        matches!(self, Self::Unreadable | Self::Refused)
    }

    /// Whether it is vertical, by its file or by its name.
    pub fn is_vertical(self) -> bool {
        matches!(self, Self::Vertical | Self::VerticalByName)
    }

    pub(super) fn saying(self, said: impl Into<String>) -> LeftOutReason {
        LeftOutReason {
            kind: self,
            said: said.into(),
        }
    }
}

impl LeftOutReason {
    /// Returns the reason that an error of reading a file gives.
    pub(super) fn of(error: &Error) -> Self {
        let refused = error.refused();
        let word = refused.word().unwrap_or("by its name");
        match refused.own_kind() {
            RefusalKind::System(_) => LeftOutKind::Unreadable.saying(error.reason()),
            RefusalKind::NoRecord => LeftOutKind::NoRecord.saying(""),
            RefusalKind::Velocity => LeftOutKind::Velocity.saying(word),
            RefusalKind::Displacement => LeftOutKind::Displacement.saying(word),
            RefusalKind::OtherQuantity => LeftOutKind::NoAcceleration.saying(word),
            RefusalKind::Wrong | RefusalKind::CutShort | RefusalKind::Stopped | _ => LeftOutKind::Refused.saying(error.reason()),
        }
    }

    /// Returns the kind of the entry and the explanation in a sentence.
    pub fn sentence(&self) -> String {
        let [one, _, why] = self.kind.words();
        let said = match self.said.as_str() {
            "" => String::new(),
            said => format!(" ({said})"),
        };
        if self.kind.hides_a_record() {
            self.said.clone()
        } else if why.is_empty() {
            format!("{one}{said}")
        } else {
            format!("{one}{said}, {why}")
        }
    }
}

/// Largest number of names in a line.
const MOST_NAMES: usize = 4;

/// Ratio of the strongest to the weakest peak \[–\] above which one unit for both is in doubt. A convention: records that shake buildings have
/// peaks of 0.02 g to 1 g, and g and cm/s² differ by 981.
const MOST_APART: f64 = 50.0;

impl Suite {
    /// Lists what is left out, a line for each reason. Reasons that may hide a record come first. With `details` a line has every name.
    pub fn said_of_left_out(&self, details: bool) -> Vec<String> {
        let mut sorted: Vec<&LeftOut> = self.left_out.iter().collect();
        sorted.sort_by_key(|one| &one.reason);
        let told_together = |one: &&LeftOut, other: &&LeftOut| {
            let [one, other] = [&one.reason, &other.reason];
            one.kind == other.kind && (!one.kind.hides_a_record() || one.said == other.said)
        };
        let groups = sorted.chunk_by(told_together);
        groups.map(|group| said_of(group, details)).collect()
    }

    /// Returns what is left out as JSON, each entry with its reason.
    pub fn left_out_json(&self) -> Value {
        let left_out = self.left_out.iter();
        left_out
            .map(|one| json!({"record": one.name, "reason": one.reason.sentence()}))
            .collect()
    }

    /// Counts files, motions and events, followed by the lines of [`Self::remarks`].
    pub fn said(&self, details: bool) -> Vec<String> {
        let counts = std::iter::once(self.counts());
        counts.chain(self.remarks(details)).collect()
    }

    /// Counts files, motions and events: "24 files, 16 used and 8 left out: 16 motions of 8 events".
    pub fn counts(&self) -> String {
        let used = self.used();
        let of_used = self.left_out.iter();
        let of_used = of_used.filter(|one| used.contains(&one.path)).count();
        let of_used = match of_used {
            0 => String::new(),
            n => format!(", {} of used files left out", number(n, "component")),
        };
        let left_out = match self.n_entries - used.len() {
            0 => String::new(),
            n => format!(", {} used and {n} left out", used.len()),
        };
        format!(
            "{}{left_out}: {} of {}{of_used}",
            number(self.n_entries, "file"),
            number(self.motions.len(), "motion"),
            number(self.n_events, "event")
        )
    }

    /// Returns the files that hold a motion that shakes a row.
    fn used(&self) -> BTreeSet<PathBuf> {
        let motions = self.motions.iter();
        motions.flat_map(SuiteMotion::files).collect()
    }

    /// Returns the content of [`Self::counts`] and [`Self::remarks`] as JSON, except for what is left out.
    pub fn json(&self) -> Value {
        let alike = self.alike.iter();
        let alike = alike.map(|(one, other, factor)| json!({"record": other, "times": factor, "of": one}));
        let declared = self.declared().into_iter();
        let declared = declared.map(|(words, names)| json!({"declared": words, "records": names}));
        let used = self.used().len();
        json!({
            "files": self.n_entries,
            "files_used": used,
            "files_left_out": self.n_entries - used,
            "motions": self.motions.len(),
            "events": self.n_events,
            "declared": declared.collect::<Value>(),
            "alike": alike.collect::<Value>(),
            "direction_not_told": self.untold(),
        })
    }

    /// Says how many records of the folder may be missing in an answer, `n_failed` failed runs included; `None` if no record is missing.
    pub fn says_missing(&self, n_failed: usize) -> Option<String> {
        let hidden = self.left_out.iter();
        let hidden = hidden.filter(|one| one.reason.kind.hides_a_record());
        let n = hidden.count() + n_failed;
        let are = if n == 1 {
            "record of the folder is"
        } else {
            "records of the folder are"
        };
        (n > 0).then(|| format!("{n} {are} missing here, not read or not run for reasons given below."))
    }

    /// Lists what is left out, the declarations with the files that they were used for, and what the user should check; `details` as in
    /// [`Self::said_of_left_out`].
    pub fn remarks(&self, details: bool) -> Vec<String> {
        let declared = self.declared().into_iter().map(|(words, names)| {
            let (n, does) = (number(names.len(), "record"), if names.len() == 1 { "does" } else { "do" });
            format!(
                "{words} is declared, and was taken for {n} that {does} not say it: {}",
                names.join(", ")
            )
        });
        let untold = self.untold();
        let untold = (!untold.is_empty()).then(|| {
            format!(
                "direction not told, they count as horizontal; take a vertical one out of the folder, or end its name in -UP: {}",
                listed(&untold, details)
            )
        });
        let from_first: Vec<&str> = self.from_first.iter().map(String::as_str).collect();
        let from_first = (!from_first.is_empty()).then(|| {
            format!(
                "no name tells angles from north; the axis counts from the first component: {}",
                listed(&from_first, details)
            )
        });
        let left_out = self.said_of_left_out(details).into_iter();
        let said = left_out.chain(self.said_of_alike(details));
        let of_tables = self.of_tables.iter().cloned();
        said.chain(declared).chain(untold).chain(from_first).chain(of_tables).collect()
    }

    /// Names motions that differ only by a factor, a line for each motion that others are multiples of.
    fn said_of_alike(&self, details: bool) -> Vec<String> {
        let mut sorted: Vec<_> = self.alike.iter().collect();
        sorted.sort_by_key(|(one, ..)| one);
        let groups = sorted.chunk_by(|(one, ..), (other, ..)| one == other);
        let said = groups.map(|group| {
            let times = |(_, name, factor): &&(String, String, f64)| format!("{name} (times {})", short(*factor));
            let others: Vec<String> = group.iter().map(times).collect();
            let others: Vec<&str> = others.iter().map(String::as_str).collect();
            format!(
                "{} comes again times a factor, and counts as one event with the others; leave one of them in the folder: {}",
                group[0].0,
                listed(&others, details)
            )
        });
        said.collect()
    }

    /// Warns of a unit that is declared for records whose peaks lie too far apart for one unit, in a sentence without its end; `None` if there
    /// is no such unit.
    pub fn says_units_apart(&self) -> Option<String> {
        let peak = |motion: &SuiteMotion| motion.origin.file.values().iter().fold(0.0, |peak: f64, one| peak.max(one.abs()));
        let told = self.declared_motions().into_iter().filter_map(|(_, motions)| {
            let unit = motions[0].taken.unit?.to_motion().name();
            let by_peak = |one: &&&SuiteMotion, other: &&&SuiteMotion| peak(one).total_cmp(&peak(other));
            let (weakest, strongest) = (motions.iter().min_by(by_peak)?, motions.iter().max_by(by_peak)?);
            let times = peak(strongest) / peak(weakest);
            (times > MOST_APART).then(|| {
                format!(
                    "the unit {unit} is declared for {} without one, whose peaks differ by a factor of {}, from {} ({}) to {} ({})",
                    number(motions.len(), "record"),
                    two_digits(times),
                    weakest.name,
                    short(peak(weakest)),
                    strongest.name,
                    short(peak(strongest))
                )
            })
        });
        let said: Vec<String> = told.collect();
        (!said.is_empty()).then(|| said.join("; "))
    }

    /// Returns each declaration with the names of the motions that it was used for.
    fn declared(&self) -> Vec<(String, Vec<&str>)> {
        let all = self.declared_motions().into_iter();
        all.map(|(words, motions)| (words, motions.into_iter().map(|one| one.name.as_str()).collect()))
            .collect()
    }

    /// Returns each declaration with the motions that it was used for.
    fn declared_motions(&self) -> Vec<(String, Vec<&SuiteMotion>)> {
        let mut taken: Vec<(String, Vec<&SuiteMotion>)> = Vec::new();
        for motion in &self.motions {
            let words = motion.taken.words();
            if words.is_empty() {
                continue;
            }
            match taken.iter_mut().find(|(known, _)| *known == words) {
                Some((_, motions)) => motions.push(motion),
                None => taken.push((words, vec![motion])),
            }
        }
        taken
    }

    /// Names the motions without a known direction, unless their names tell a pair of angles from north.
    fn untold(&self) -> Vec<&str> {
        let pairs = self.pairs().into_iter().filter(|pair| pair.angles.from_north);
        let told: Vec<&str> = pairs.flat_map(|pair| pair.motions.map(|one| one.name.as_str())).collect();
        let untold = self
            .motions
            .iter()
            .filter(|one| one.direction.is_none() && !told.contains(&one.name.as_str()));
        untold.map(|one| one.name.as_str()).collect()
    }
}

/// Writes "1 file", "2 files".
fn number(n: usize, word: &str) -> String {
    let s = if n == 1 { "" } else { "s" };
    format!("{n} {word}{s}")
}

/// Writes a line about entries that are left out for one reason.
fn said_of(group: &[&LeftOut], details: bool) -> String {
    let reason = &group[0].reason;
    let [one, several, why] = reason.kind.words();
    let names = group.iter().map(|one| match one.reason.said.as_str() {
        said if reason.kind.hides_a_record() || said.is_empty() || one.name.ends_with(said) => one.name.clone(),
        said => format!("{} ({said})", one.name),
    });
    let names: Vec<String> = names.collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let names = listed(&names, details);
    let count = match group.len() {
        1 => format!("1 {one}"),
        n => format!("{n} {several}"),
    };
    if reason.kind.hides_a_record() {
        format!("{names}: {}", reason.sentence())
    } else if why.is_empty() {
        format!("{count}: {names}")
    } else {
        format!("{count}, {why}: {names}")
    }
}

/// Lists the first names, or all of them.
fn listed(names: &[&str], details: bool) -> String {
    let shown = if details { names.len() } else { MOST_NAMES.min(names.len()) };
    let mut listed = names[..shown].join(", ");
    if shown < names.len() {
        write!(listed, ", and {} more", names.len() - shown).expect("memory takes all");
    }
    listed
}
