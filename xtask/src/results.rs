//! The results folder: writing it, and comparing it with a fresh run.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Folders with generated files only; other files in them are stale.
const GENERATED: [&str; 8] = ["", "tables", "figures", "trade", "laws", "beyond", "beyond/weaker", "extremes/part"];
/// A folder that is generated only by a complete run of the extremes.
const WHOLE: &str = "extremes";
/// Files that `reproduce` does not make: written by hand, or measured by `bench`.
const KEPT: [&str; 5] = ["README.md", "savings.csv", "storeys.csv", "storeys.png", "wall-time.csv"];

/// Writes the files that changed and removes stale ones; returns how many changed.
pub(crate) fn write(folder: &Path, files: &BTreeMap<PathBuf, Vec<u8>>) -> Result<usize, String> {
    let mut changed = 0;
    for (name, contents) in files {
        let path = folder.join(name);
        if fs::read(&path).is_ok_and(|found| found == *contents) {
            continue;
        }
        let fail = |error| format!("{}: cannot be written: {error}", path.display());
        fs::create_dir_all(path.parent().expect("a file lies in a folder")).map_err(fail)?;
        fs::write(&path, contents).map_err(fail)?;
        changed += 1;
    }
    for path in stale(folder, files)? {
        fs::remove_file(&path).map_err(|error| format!("{}: cannot be removed: {error}", path.display()))?;
        changed += 1;
    }
    Ok(changed)
}

/// Differences between the folder and a fresh run, in words.
///
/// Figures are compared only on Linux x86-64: their bytes are untested elsewhere.
pub(crate) fn differences(folder: &Path, files: &BTreeMap<PathBuf, Vec<u8>>) -> Result<Vec<String>, String> {
    let compares_figures = cfg!(all(target_os = "linux", target_arch = "x86_64"));
    let mut differences = Vec::new();
    for (name, contents) in files {
        let is_figure = name.extension().is_some_and(|extension| extension == "png");
        match fs::read(folder.join(name)) {
            Err(error) => differences.push(format!("{}: {error}", name.display())),
            Ok(found) if found != *contents && (compares_figures || !is_figure) => {
                differences.push(format!("{}: {}", name.display(), first_difference(&found, contents)));
            }
            Ok(_) => {}
        }
    }
    let stale = stale(folder, files)?;
    differences.extend(stale.iter().map(|path| format!("{}: no study makes it", path.display())));
    Ok(differences)
}

/// The first line that differs, for text files.
fn first_difference(found: &[u8], fresh: &[u8]) -> String {
    let (Ok(found), Ok(fresh)) = (std::str::from_utf8(found), std::str::from_utf8(fresh)) else {
        return "other bytes".into();
    };
    let mut pairs = found.lines().zip(fresh.lines()).zip(1..);
    match pairs.find(|((found, fresh), _)| found != fresh) {
        Some(((found, fresh), line)) => {
            format!("line {line} is\n    {found}\n  a fresh run gives\n    {fresh}")
        }
        None => format!("{} lines, a fresh run gives {}", found.lines().count(), fresh.lines().count()),
    }
}

fn stale(folder: &Path, files: &BTreeMap<PathBuf, Vec<u8>>) -> Result<Vec<PathBuf>, String> {
    let mut stale = Vec::new();
    let whole = files.contains_key(&Path::new(WHOLE).join("cells.csv"));
    let mut folders: BTreeSet<&Path> = GENERATED.map(Path::new).into();
    folders.extend(whole.then_some(Path::new(WHOLE)));
    folders.extend(files.keys().filter_map(|file| file.parent()));
    for name in folders {
        // A missing folder contains nothing stale.
        let Ok(entries) = fs::read_dir(folder.join(name)) else {
            continue;
        };
        for entry in entries {
            let entry = entry.map_err(|error| format!("{}: {error}", folder.join(name).display()))?;
            let file = name.join(entry.file_name());
            let kept = KEPT.iter().any(|name| file == Path::new(name)) || entry.path().is_dir();
            if !kept && !files.contains_key(&file) {
                stale.push(entry.path());
            }
        }
    }
    stale.sort();
    Ok(stale)
}
