//! Damaged remains of a sweep: there must be no wrong table, and complete parts must not be lost.

use std::fs;
use std::path::{Path, PathBuf};

use pounding_files::Existing;
use pounding_sweep::{Parts, Shard, Sweep, merge};
use pounding_text::Refused;
use serde_json::json;

use crate::{folder, opened, scene, sweep};

/// Ten runs in ten existing parts, and their table.
struct Prepared {
    sweep: Sweep,
    out: PathBuf,
    parts: PathBuf,
    table: Vec<u8>,
}

fn prepared(test: &str) -> Prepared {
    let folder = folder(test);
    let words = json!({
        "scene": scene(),
        "vary": [{"field": "contacts[0].gap_m", "uniform": {"from": 0.0, "to": 0.02}}],
        "samples": {"count": 10, "seed": 4, "method": "sobol"},
        // This output prevents lanes, which have larger parts.
        "outputs": {"pairs": ["first_start_s", "total_impulse_n_s"]},
    });
    let sweep = sweep(&folder, &words);
    let out = folder.join("runs.csv");
    let parts = Parts::folder_of(&out);
    assert_eq!(
        opened(&sweep, &out, Shard::WHOLE).fill(&sweep, &|_| ()).expect("a disk"),
        10,
        "all are there"
    );
    let other = folder.join("other.csv");
    merge(&other, std::slice::from_ref(&parts), Existing::Kept).expect("a table");
    let table = fs::read(other).expect("a table");
    Prepared { sweep, out, parts, table }
}

impl Prepared {
    fn merged(&self) -> Result<Vec<u8>, Refused> {
        merge(&self.out, std::slice::from_ref(&self.parts), Existing::Replaced)?;
        Ok(fs::read(&self.out).expect("a table"))
    }

    /// Damage found by the sweep, and the number of runs that existed.
    fn mended(&self) -> (Vec<String>, u64) {
        let parts = opened(&self.sweep, &self.out, Shard::WHOLE);
        let said = parts.damaged().iter().map(ToString::to_string).collect();
        let before = parts.n_runs_there();
        let there = parts.fill(&self.sweep, &|_| ()).expect("a disk");
        assert_eq!(there, 10, "all are there");
        assert!(self.merged_within(&parts) == self.table, "a wrong table");
        (said, before)
    }

    /// The table of parts that this process holds.
    fn merged_within(&self, parts: &Parts) -> Vec<u8> {
        let other = self.out.with_file_name("mended.csv");
        merge(&other, &[parts.folder().to_path_buf()], Existing::Replaced).expect("a table");
        fs::read(other).expect("a table")
    }
}

/// Changes every byte of a part and of a manifest in two ways: the table is refused or correct. Only the damaged part runs again.
#[test]
fn issue_no_byte_of_a_part_or_manifest_changes_unseen() {
    let prepared = prepared("bytes");
    let part = prepared.parts.join("part-000000003.csv");
    let manifest = prepared.parts.join("manifest.json");
    for path in [&part, &manifest] {
        let whole = fs::read(path).expect("it is there");
        for place in 0..whole.len() {
            for change in [1, 0x10] {
                let mut bytes = whole.clone();
                bytes[place] ^= change;
                fs::write(path, &bytes).expect("a disk");
                match prepared.merged() {
                    Ok(table) => assert!(path == &manifest && table == prepared.table, "{place}"),
                    Err(error) => assert!(error.to_string().contains(&path.display().to_string()), "{error}"),
                }
            }
        }
        for length in [0, whole.len() / 2, whole.len() - 2] {
            fs::write(path, &whole[..length]).expect("a disk");
            assert!(prepared.merged().is_err(), "{length} bytes");
        }
        fs::write(path, &whole).expect("a disk");
    }
    fs::write(&part, b"").expect("a disk");
    let (said, before) = prepared.mended();
    assert_eq!(before, 9, "the others stay");
    assert!(
        said.len() == 1 && said[0].contains("part-000000003.csv: found no bytes"),
        "{said:?}"
    );
}

/// A part in the place of another, swapped rows, a part of another sweep.
#[test]
fn issue_parts_are_not_mixed() {
    let prepared = prepared("mixed");
    let path = |number: usize| prepared.parts.join(format!("part-{number:09}.csv"));
    fs::copy(path(5), path(3)).expect("a disk");
    let text = fs::read_to_string(path(6)).expect("a part");
    fs::write(path(6), text.replacen("pounding sweep ", "pounding sweep 0", 1)).expect("a disk");
    assert!(prepared.merged().is_err());
    let (said, before) = prepared.mended();
    assert_eq!((said.len(), before), (2, 8), "{said:?}");
}

/// A manifest that was edited, or has an unknown format, is refused, and nothing is deleted.
#[test]
fn issue_an_edited_manifest_is_refused() {
    let prepared = prepared("edited");
    let path = prepared.parts.join("manifest.json");
    let whole = fs::read_to_string(&path).expect("a manifest");
    for (from, to) in [
        ("\"runs\": 10", "\"runs\": 0"),
        ("\"runs\": 10", "\"runs\": 1000000000000000000"),
        ("\"runs_per_part\": 1", "\"runs_per_part\": 0"),
        ("first_start_s", "first_impact_s"),
        ("\"schema_version\": 2", "\"schema_version\": 3"),
        ("  \"schema_version\": 2,\n", ""),
    ] {
        let edited = whole.replacen(from, to, 1);
        assert_ne!(edited, whole);
        fs::write(&path, edited).expect("a disk");
        let sweep = Parts::open(&prepared.sweep, &prepared.out, Shard::WHOLE, false).map(|_| ());
        for refused in [prepared.merged().map(|_| ()), sweep] {
            let said = refused.expect_err(to).to_string();
            assert!(said.contains("manifest.json: found"), "{said}");
        }
    }
    // As in the message: without the manifest, complete parts stay.
    fs::remove_file(&path).expect("a disk");
    assert_eq!(prepared.mended().1, 10);
    assert_eq!(fs::read_to_string(&path).expect("a manifest"), whole);
}

/// Other files in a folder of parts survive the sweep, also with `--overwrite`.
#[test]
fn issue_files_of_others_stay() {
    let prepared = prepared("foreign");
    let notes = prepared.parts.join("notes.txt");
    fs::write(&notes, "mine").expect("a disk");
    let parts = opened(&prepared.sweep, &prepared.out, Shard::WHOLE);
    parts.join(Existing::Kept).expect("a table");
    assert_eq!(names(&prepared.parts), ["notes.txt"]);
    // Nothing identifies the folder; --overwrite takes it, and leaves other files.
    let open = |overwritten| Parts::open(&prepared.sweep, &prepared.out, Shard::WHOLE, overwritten);
    assert!(open(false).is_err_and(|refused| refused.to_string().contains("parts of another sweep")));
    drop(open(true).expect("parts"));
    assert_eq!(names(&prepared.parts), ["manifest.json", "notes.txt"]);
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder").flatten();
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut names: Vec<String> = names.collect();
    names.sort();
    names
}

/// A process ends between the table and the end of the clean-up, at every file: the next process completes it.
#[test]
fn issue_what_a_kill_leaves_of_a_clean_up_goes() {
    let prepared = prepared("clean_up");
    prepared.merged().expect("a table");
    let open = || Parts::open(&prepared.sweep, &prepared.out, Shard::WHOLE, false).expect("parts");
    assert!(open().expect("the parts").made_table().expect("a disk"));
    let beside = prepared.out.with_file_name(".runs.csv.joined.json");
    fs::copy(prepared.parts.join("manifest.json"), &beside).expect("a disk");
    fs::remove_file(prepared.parts.join("part-000000002.csv")).expect("a disk");
    assert!(open().is_none(), "it has its table");
    assert!(!prepared.parts.exists() && !beside.exists());
    // A table without parts is not continued.
    let again = Parts::open(&prepared.sweep, &prepared.out, Shard::WHOLE, false);
    assert!(again.is_err_and(|refused| refused.to_string().contains("is there already")));
    assert!(!prepared.parts.exists());
    fs::remove_file(&prepared.out).expect("a disk");
    // A table that does not match these parts is not taken for theirs.
    let (_, before) = prepared.mended();
    assert_eq!(before, 0);
    fs::write(&prepared.out, "run,failed\n").expect("a disk");
    assert!(!open().expect("the parts").made_table().expect("a disk"));
}

/// After a kill during the write of its manifest, a sweep took the folder for another sweep's.
#[test]
fn issue_half_a_manifest_is_nobodys() {
    let prepared = prepared("half");
    for name in names(&prepared.parts) {
        fs::remove_file(prepared.parts.join(name)).expect("a disk");
    }
    fs::write(prepared.parts.join(".manifest.json.aBc1.new"), "{").expect("a disk");
    assert_eq!(prepared.mended().1, 0);
}

/// A single process at a time, or shards together.
#[test]
fn issue_one_process_works_on_a_table() {
    let prepared = prepared("one");
    let open = |shard| Parts::open(&prepared.sweep, &prepared.out, shard, true);
    let [one, two] = [1, 2].map(|index| Shard::new(index, 2).expect("a shard"));
    let whole = open(Shard::WHOLE).expect("parts");
    for refused in [open(one).map(|_| ()), open(Shard::WHOLE).map(|_| ()), prepared.merged().map(|_| ())] {
        let said = refused.expect_err("somebody is at work").to_string();
        assert!(said.contains(&format!("found process {}", std::process::id())), "{said}");
    }
    drop(whole);
    let shards = [open(one), open(two), open(two)].map(|shard| shard.expect("shards work together"));
    assert!(open(Shard::WHOLE).is_err_and(|refused| refused.to_string().contains("at work on it")));
    drop(shards);
    assert!(open(Shard::WHOLE).is_ok());
}

/// Sweeps whose parts did not fit into memory ended the program.
#[test]
fn issue_more_rows_than_parts_hold_are_refused() {
    let folder = folder("too_many_parts");
    let words = |count: u64| {
        json!({
            "scene": scene(),
            "vary": [{"field": "contacts[0].gap_m", "uniform": {"from": 0.0, "to": 0.02}}],
            "samples": {"count": count, "seed": 4, "method": "random"},
        })
    };
    let open = |words: &_| {
        let sweep = sweep(&folder, words);
        Parts::open(&sweep, &folder.join("runs.csv"), Shard::WHOLE, false)
    };
    let mut many = words(1_000_000_000_000_000);
    let refused = open(&many).expect_err("no folder holds their parts");
    let allowed = refused.parts().allowed.expect("a number");
    let allowed = allowed.strip_prefix("up to ").and_then(|most| most.strip_suffix(" with rows"));
    let allowed = allowed.expect("nothing sums them up").parse().expect("a number");
    assert!(open(&words(allowed)).is_ok(), "{allowed} runs");
    many["summary"] = json!({});
    let refused = open(&many).expect_err("no folder holds their parts");
    assert!(refused.to_string().contains("coarser grids"), "{refused}");
}

/// Lanes moved to another crate, whose sources were not hashed: a sweep was continued by lanes that computed other results.
#[test]
fn issue_a_sweep_is_known_by_the_sources_of_every_crate_that_computes() {
    let (manifest, hashed) = (include_str!("../../Cargo.toml"), include_str!("../../build.rs"));
    let crates = manifest.lines().filter_map(|line| line.strip_prefix("pounding-"));
    let names = crates.filter_map(|line| line.split('.').next());
    // Files contain bytes, independent of their meaning.
    let mut names: Vec<&str> = names.filter(|name| *name != "files").collect();
    names.dedup();
    assert!(names.contains(&"lanes"), "{names:?}");
    for name in names {
        assert!(hashed.contains(&format!("\"../{name}/src\"")), "{name}");
    }
}
