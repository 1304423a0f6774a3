//! What every folder of records is held to: nothing in it vanishes, and no record counts twice.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use pounding_scene::{FileUse, Suite, Unit};

/// Beginnings and ends of names; a byte chooses one of each.
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

/// Makes a folder of what the bytes say, and reads it.
pub(crate) fn check(bytes: &[u8], folder: &Path) {
    let names = made(bytes, folder);
    let hidden = |name: &&String| name.starts_with('.') || name.ends_with(".provenance.json");
    let shown = names.iter().filter(|name| !hidden(name)).count();
    for declared in [FileUse::default(), in_g()] {
        let suite = Suite::of(&[folder.to_path_buf()], &declared).expect("a folder");
        assert_eq!(suite.n_entries, shown, "an entry vanished");
        let told = |name: &&String| {
            let begins = |said: &str| said.starts_with(name.as_str());
            suite.motions.iter().any(|one| begins(&one.name))
                || suite.left_out.iter().any(|one| begins(&one.name))
        };
        assert!(
            names
                .iter()
                .filter(|name| !hidden(name))
                .all(|name| told(&name)),
            "{names:?}"
        );
        assert!(
            suite.n_events <= suite.motions.len(),
            "more events than motions"
        );
        let mut bytes = BTreeSet::new();
        let is_new = |one: &pounding_scene::Motion| {
            bytes.insert((one.origin().sha256.clone(), one.name.len()))
        };
        assert_eq!(
            suite.motions.iter().map(is_new).filter(|new| !new).count(),
            0,
            "a copy counts"
        );
        for motion in &suite.motions {
            assert!(motion.event < suite.n_events, "an event of its own");
        }
        assert!(!suite.said(true).is_empty(), "nothing is said");
    }
}

/// Makes the entries that the bytes name, and returns their names: two bytes name an entry, one says what it is.
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
