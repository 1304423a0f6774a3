//! Folders as they are downloaded: archives, sub-folders, and tables beside the files.

use std::fs;
use std::path::PathBuf;

use pounding_assess::{FolderUse, LeftOutKind, SelectionFactors, Suite};
use pounding_scene::FileUse;

use crate::suite::{Folder, list, motion};

fn at2(title: &str, rate: f64) -> String {
    format!(
        "PEER STRONG MOTION DATABASE RECORD\n{title}\nACCELERATION TIME HISTORY IN UNITS OF G\nNPTS= 300, DT= .02 SEC\n{}",
        list(rate)
    )
}

/// The files of a download of PEER.
fn download() -> Vec<(&'static str, String)> {
    let velocity = at2("A, 180", 5.0).replace("ACCELERATION TIME HISTORY IN UNITS OF G", "VELOCITY TIME HISTORY IN UNITS OF CM/S");
    vec![
        ("_SearchResults.csv", SELECTION.to_owned()),
        ("RSN6_A180.AT2", at2("A, 180", 5.0)),
        ("RSN6_A180.VT2", velocity),
        ("RSN6_A270.AT2", at2("A, 270", 5.7)),
        ("RSN6_A-UP.AT2", at2("A, UP", 6.1)),
        ("RSN7_B000.AT2", at2("B, 0", 7.7)),
        ("RSN7_B090.AT2", at2("B, 90", 8.3)),
    ]
}

const SELECTION: &str = "PEER Ground Motion Database\n\n -- Summary of Metadata of Selected Records --\n\
     Result ID, Record Sequence Number, Scale Factor, Earthquake Name, Horizontal-1 Acc. Filename, Horizontal-2 Acc. Filename\n\
     1, 6, 2.5, \"Chi-Chi, Taiwan\", RSN6_A180.AT2, RSN6_A270.AT2\n2, 7, 0.5, B, RSN7_B000.AT2, RSN7_B090.AT2\n\n";

fn tar(files: &[(&str, String)]) -> Vec<u8> {
    let mut builder = tar::Builder::new(Vec::new());
    for (name, text) in files {
        let mut header = tar::Header::new_gnu();
        header.set_size(text.len() as u64);
        header.set_mode(0o644);
        builder
            .append_data(&mut header, format!("PEERNGARecords/{name}"), text.as_bytes())
            .expect("memory");
    }
    builder.into_inner().expect("memory")
}

fn names(suite: &Suite) -> Vec<&str> {
    suite.motions.iter().map(|one| one.name.as_str()).collect()
}

fn values(suite: &Suite, index: usize) -> &[f64] {
    suite.motions[index].origin().file.values()
}

/// The archive and the folder with its files have the same motions, events and omissions.
#[test]
fn limit_an_archive_is_the_folder_that_it_holds() {
    let files = download();
    let folder = files
        .iter()
        .fold(Folder::new(), |folder, (name, text)| folder.with(name, text))
        .suite();
    let archive = Folder::new().with("peer.tar", tar(&files));
    let named = Suite::in_folder(&archive.path().join("peer.tar"), &FileUse::default()).expect("an archive");
    for suite in [archive.suite(), named] {
        assert_eq!(names(&suite), ["RSN6_A180.AT2", "RSN6_A270.AT2", "RSN7_B000.AT2", "RSN7_B090.AT2"]);
        assert_eq!(suite.counts(), folder.counts());
        assert_eq!(suite.counts(), "7 files, 4 used and 3 left out: 4 motions of 2 events");
        assert_eq!(suite.remarks(true), folder.remarks(true));
        assert_eq!((suite.pairs().len(), suite.files.len()), (2, 1));
        for (index, motion) in folder.motions.iter().enumerate() {
            assert_eq!(values(&suite, index), values(&folder, index), "{}", motion.name);
        }
    }
    let said = folder.remarks(false).join("\n");
    assert!(
        said.contains("1 velocity") && said.contains("1 table of records: _SearchResults.csv"),
        "{said}"
    );
}

#[test]
fn reference_scale_factors_of_a_selection_on_request() {
    let folder = download()
        .iter()
        .fold(Folder::new(), |folder, (name, text)| folder.with(name, text));
    let asked = FolderUse {
        selection_factors: SelectionFactors::Used,
        ..FolderUse::default()
    };
    let [plain, scaled] = [FolderUse::default(), asked].map(|asked| Suite::in_folder(folder.path(), asked).expect("a folder"));
    for (index, factor) in [2.5, 2.5, 0.5, 0.5].into_iter().enumerate() {
        let wanted: Vec<f64> = values(&plain, index).iter().map(|value| factor * value).collect();
        assert_eq!(values(&scaled, index), wanted);
    }
    let said = |suite: &Suite| suite.remarks(false).join("\n");
    assert!(
        said(&plain).contains("scale factors from 0.5 to 2.5 are not used; --selection-factors uses them"),
        "{}",
        said(&plain)
    );
    assert!(
        said(&scaled).contains("scale factors from 0.5 to 2.5 multiply its records"),
        "{}",
        said(&scaled)
    );
}

#[test]
fn reference_sub_folders_on_request() {
    let folder = Folder::new().with("a.csv", motion(5.0));
    for (path, rate) in [("one/b.csv", 5.7), ("one/two/c.csv", 6.4)] {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a disk");
        fs::write(path, motion(rate)).expect("a disk");
    }
    let suite = folder.suite();
    assert_eq!(names(&suite), ["a.csv"]);
    assert_eq!(suite.left_out[0].reason.kind, LeftOutKind::Folder);
    let asked = FolderUse {
        sub_folders: true,
        ..FolderUse::default()
    };
    let suite = Suite::in_folder(folder.path(), asked).expect("a folder");
    assert_eq!(names(&suite), ["a.csv", "b.csv", "c.csv"]);
    assert_eq!(suite.left_out, []);
}

/// Lists of numbers without a word, told by a table.
#[test]
fn reference_a_table_beside_the_files() {
    let table = "# from the laboratory\nfile, component, unit, time_step_s, factor, event\n\
                 one.txt, NS, g, 0.02, , quake\ntwo.txt, EW, cm_per_s2, 0.01, 980.665, quake\nthree.txt, UP, g, 0.02, , quake\nfour.txt,,mg,0.02,-1,\n";
    let folder = Folder::new()
        .with("records.csv", table)
        .with("one.txt", list(5.0))
        .with("two.txt", list(5.7))
        .with("three.txt", list(6.4))
        .with("four.txt", list(7.1));
    let suite = folder.suite();
    assert_eq!(names(&suite), ["four.txt", "one.txt", "two.txt"]);
    assert_eq!(suite.motions.iter().map(|one| one.event).collect::<Vec<_>>(), [0, 1, 1]);
    let left_out: Vec<_> = suite.left_out.iter().map(|one| (one.name.as_str(), one.reason.kind)).collect();
    assert_eq!(
        left_out,
        [("records.csv", LeftOutKind::Table), ("three.txt", LeftOutKind::Vertical)]
    );
    let files: Vec<_> = suite
        .motions
        .iter()
        .map(|one| (one.origin().file.time_step(), one.origin().file.unit().name()))
        .collect();
    assert_eq!(files, [(0.02, "mg"), (0.02, "g"), (0.01, "cm_per_s2")]);
    let own: Vec<f64> = list(7.1).lines().map(|line| -line.parse::<f64>().expect("a number")).collect();
    assert_eq!(values(&suite, 0), own);
    // Steps and units differ: an event of two, and no pair.
    assert_eq!(suite.pairs().len(), 0);
    let even = table.replace("cm_per_s2, 0.01, 980.665", "g, 0.02,");
    let pairs = folder.with("records.csv", even).suite();
    let pairs: Vec<_> = pairs.pairs().iter().map(|pair| (pair.name(), pair.angles.degrees)).collect();
    assert_eq!(pairs, [("one.txt + two.txt".to_owned(), [0.0, 90.0])]);
}

/// A record by the name of the table stays a record.
#[test]
fn limit_a_record_named_like_the_table() {
    assert_eq!(names(&Folder::new().with("records.csv", motion(5.0)).suite()), ["records.csv"]);
}

#[test]
fn extreme_tables_with_faults_are_refused() {
    let refused = |table: &str| {
        let folder = Folder::new().with("records.csv", table).with("one.txt", list(5.0));
        let refused = Suite::of(&[folder.path().to_path_buf()], &FileUse::default()).expect_err(table);
        refused.to_string()
    };
    for (table, wanted) in [
        ("file,unit\none.txt,feet\n", "the unit \"feet\" in line 2"),
        ("file,units\none.txt,g\n", "the column \"units\" in line 1"),
        ("file,time_step_s\none.txt,0\n", "the time_step_s \"0\" in line 2"),
        ("file,factor\none.txt,x\n", "the factor \"x\" in line 2"),
        ("file,factor\n,1\n", "no file in line 2"),
        ("file,factor\nnone.txt,1\n", "a row of the file none.txt, which is not there"),
        ("file,factor\none.txt,1,2\n", "in line 2"),
        ("file,factor\n../../etc/passwd,1\n", "which is not there"),
    ] {
        let refused = refused(table);
        assert!(refused.contains(wanted), "{table}: {refused}");
    }
}

/// A damaged archive is named, and the records beside it shake the row.
#[test]
fn extreme_archives_that_cannot_be_read() {
    let whole = tar(&download());
    let folder = Folder::new()
        .with("cut.tar", &whole[..2000])
        .with("zip.zip", b"PK\x03\x04 and nothing")
        .with("a.csv", motion(5.0));
    let suite = folder.suite();
    assert_eq!(names(&suite), ["a.csv"]);
    let said = suite.remarks(false).join("\n");
    assert!(said.contains("archive is damaged") || said.contains("it is cut short"), "{said}");
    assert!(suite.left_out.iter().all(|one| one.reason.kind.hides_a_record()), "{said}");
    let named: PathBuf = folder.path().join("zip.zip");
    let refused = Suite::of(&[named], &FileUse::default()).expect_err("a damaged archive").to_string();
    assert!(refused.contains("the ZIP archive is damaged"), "{refused}");
}

#[path = "../../../../fuzz/src/table.rs"]
mod fuzzed;

/// The seeds in `fuzz/corpus` pass the checks of the fuzz target for tables.
#[test]
fn extreme_seeds_of_the_fuzz_target_for_tables() {
    let seeds = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fuzz/corpus/table");
    for seed in fs::read_dir(seeds).expect("seeds") {
        let bytes = fs::read(seed.expect("a seed").path()).expect("a seed");
        fuzzed::check(&bytes, Folder::new().path());
    }
}
