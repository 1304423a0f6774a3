//! The assertions on every folder of records: nothing in it vanishes, and no record counts twice.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use pounding_assess::Suite;
use pounding_scene::FileUse;
use pounding_scene::file::Unit;

/// Beginnings and ends of names; a byte chooses one of each list.
const STEMS: [&str; 12] = [
    "A-ELC",
    "RSN6_IMPVALL.I_I-ELC",
    "quake",
    "ABC001",
    "E06",
    "CHY080",
    "r00",
    "x y",
    "..",
    "é",
    "st.HNE",
    "1895",
];
const ENDS: [&str; 24] = [
    "180.AT2",
    "270.AT2",
    "-UP.AT2",
    ".EW",
    ".NS2",
    ".UD1",
    ".vel",
    "_disp.txt",
    " (1).csv",
    ".csv",
    "_H1.txt",
    "_H2.txt",
    "N",
    "E",
    "140",
    "230",
    ".V2",
    ".VT2",
    ".provenance.json",
    "-E.csv",
    "-N.csv",
    "a.smc",
    "c.smc",
    ".HNN.D.ASC",
];

/// Makes a folder from the bytes and reads it.
pub(crate) fn check(bytes: &[u8], folder: &Path) {
    let names = made(bytes, folder);
    let hidden = |name: &&String| name.starts_with('.') || name.ends_with(".provenance.json");
    let shown = names.iter().filter(|name| !hidden(name)).count();
    for declared in [FileUse::default(), in_g()] {
        let suite = Suite::of(&[folder.to_path_buf()], &declared).expect("a folder");
        assert_eq!(suite.n_entries, shown, "an entry vanished");
        let told = |name: &&String| {
            // The name of a component's file precedes its own name.
            let is_of = |said: &str| {
                let behind = said.strip_prefix(name.as_str());
                behind.is_some_and(|behind| behind.is_empty() || behind.starts_with(' '))
            };
            suite.motions.iter().any(|one| is_of(&one.name)) || suite.left_out.iter().any(|one| is_of(&one.name))
        };
        assert!(names.iter().filter(|name| !hidden(name)).all(|name| told(&name)), "{names:?}");
        let mut bytes = BTreeSet::new();
        let is_new = |one: &pounding_assess::SuiteMotion| bytes.insert((one.origin().sha256.clone(), one.component().map(str::to_owned)));
        assert_eq!(suite.motions.iter().map(is_new).filter(|new| !new).count(), 0, "a copy counts");
        let events: BTreeSet<usize> = suite.motions.iter().map(|one| one.event).collect();
        assert!(events.into_iter().eq(0..suite.n_events), "an event without a motion");
        copies_change_nothing(&suite, folder, &declared);
        assert!(!suite.said(true).is_empty(), "nothing is said");
    }
}

/// Copies every motion under a longer name without meaning: motions and events stay.
fn copies_change_nothing(suite: &Suite, folder: &Path, declared: &FileUse) {
    let copy = |index: usize| folder.join(format!("{}{index}q", "copied again".repeat(4)));
    for (index, motion) in suite.motions.iter().enumerate() {
        fs::copy(&motion.path, copy(index)).expect("a disk");
    }
    let again = Suite::of(&[folder.to_path_buf()], declared).expect("a folder");
    for index in 0..suite.motions.len() {
        fs::remove_file(copy(index)).expect("it was made");
    }
    let of = |suite: &Suite| -> Vec<(String, usize)> {
        let motions = suite.motions.iter();
        motions.map(|one| (one.name.clone(), one.event)).collect()
    };
    assert_eq!(of(&again), of(suite), "a copy changes the events");
}

/// Makes the entries that the bytes name, and returns their names. Two bytes name an entry, a third tells its kind.
fn made(bytes: &[u8], folder: &Path) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    let mut rest = bytes;
    while let [stem, end, kind, behind @ ..] = rest {
        let name = format!(
            "{}{}",
            STEMS[usize::from(*stem) % STEMS.len()],
            ENDS[usize::from(*end) % ENDS.len()]
        );
        let length = usize::from(*kind >> 3).min(behind.len());
        let (own, after) = behind.split_at(length);
        rest = after;
        let path = folder.join(&name);
        if names.contains(&name) || names.len() > 20 {
            continue;
        }
        let made = match kind % 8 {
            0 => fs::create_dir(&path),
            #[cfg(unix)]
            1 => std::os::unix::fs::symlink(Path::new("/nowhere").join(&name), &path),
            #[cfg(unix)]
            2 => match names.first() {
                Some(first) => std::os::unix::fs::symlink(first, &path),
                None => continue,
            },
            3 => fs::write(&path, own),
            4 => fs::write(&path, list(own)),
            5 => fs::write(&path, at2(&name, own)),
            6 => fs::write(&path, with_header(own)),
            _ => fs::write(&path, csv(own)),
        };
        if made.is_ok() {
            names.insert(name);
        }
    }
    names
}

fn in_g() -> FileUse {
    FileUse {
        unit: Some(Unit::StandardGravity),
        time_step_s: Some(0.02),
        ..FileUse::default()
    }
}

fn values(own: &[u8]) -> impl Iterator<Item = f64> + '_ {
    own.iter().map(|byte| (f64::from(*byte) - 128.0) / 256.0)
}

fn list(own: &[u8]) -> String {
    let values: Vec<String> = values(own).map(|value| value.to_string()).collect();
    values.join("\n")
}

/// A list below a header with place and time; the first byte chooses the header.
fn with_header(own: &[u8]) -> String {
    let told = own.first().copied().unwrap_or(0);
    let station = ["ABC", "Los Gatos", "1"][usize::from(told % 3)];
    let event = ["Kobe, NS component", "Kobe, EW component", "Kobe"][usize::from(told / 3 % 3)];
    let time = ["2010-02-27T06:34:00.998", "2010-02-27T06:34:01", "2010-03-11T14:39:00", "0.0"];
    let time = time[usize::from(told / 9 % 4)];
    let values = list(own);
    format!("# Station: {station}\n# Event: {event}\n# Start time: {time}\n# dt = 0.02 s, unit: g\n{values}")
}

fn csv(own: &[u8]) -> String {
    let line = |(step, value): (usize, f64)| format!("{},{value}\n", 0.02 * step as f64);
    let lines: String = values(own).enumerate().map(line).collect();
    format!("time_s,acceleration_g\n{lines}")
}

fn at2(name: &str, own: &[u8]) -> String {
    format!(
        "PEER STRONG MOTION DATABASE RECORD\nSOMEWHERE 1/2/34, {name}\nACCELERATION TIME HISTORY IN UNITS OF G\n\
         NPTS= {}, DT= .02 SEC\n{}",
        own.len(),
        list(own)
    )
}
