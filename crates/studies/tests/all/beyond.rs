//! The paper's scenes under other ground motions: tables, messages, and claims where nothing touches.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use insta::assert_snapshot;
use pounding_scene::{Method, Simulation};
use pounding_studies::{Beyond, BeyondSettings, BeyondStudy, Change, Output, Strength, StudyFile};
use pounding_text::digits;
use sha2::{Digest, Sha256};

type Files = BTreeMap<PathBuf, Vec<u8>>;
type TableRow = BTreeMap<String, String>;

fn studies() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies")
}

/// The studies with a changed list of motions. Changed scenes run only if the list adds them.
fn listing(change: impl FnOnce(&mut BeyondSettings)) -> Vec<StudyFile> {
    let mut files = StudyFile::read_all(&studies()).expect("readable studies");
    let settings = files.iter_mut().find_map(|file| {
        if let Output::Beyond(settings) = &mut file.study.output {
            Some(settings)
        } else {
            None
        }
    });
    let settings = settings.expect("a study that lists motions");
    settings.changes.clear();
    change(settings);
    files
}

fn run(files: &[StudyFile]) -> Beyond {
    let files: Vec<&StudyFile> = files.iter().collect();
    let study = BeyondStudy::listed(&files).expect("motions that can be read");
    let study = study.expect("a study that lists motions");
    study.run(&|| ()).expect("runs that do not fail")
}

fn files(made: &Beyond) -> Files {
    made.files().expect("figures that can be drawn")
}

/// The paper's record and the shortest of the others.
fn two_motions(settings: &mut BeyondSettings) {
    settings
        .motions
        .retain(|motion| motion.name.contains("paper") || motion.name.contains("pulse"));
}

static TWO: LazyLock<Files> = LazyLock::new(|| files(&run(&listing(two_motions))));

fn text<'a>(files: &'a Files, table: &str) -> &'a str {
    std::str::from_utf8(&files[&Path::new("beyond").join(table)]).expect("CSV is text")
}

/// Rows of a table as columns by name.
fn rows(files: &Files, table: &str) -> Vec<TableRow> {
    let mut reader = csv::Reader::from_reader(text(files, table).as_bytes());
    let rows = reader.deserialize();
    rows.map(|row| row.expect("a row of text")).collect()
}

#[test]
fn reference_tables_of_two_motions() {
    for table in ["motions.csv", "claims.csv", "verdicts.csv", "scenes.csv", "direction.csv"] {
        assert_snapshot!(table, text(&TWO, table));
    }
}

#[test]
fn limit_bytes_do_not_depend_on_threads() {
    for n_threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build();
        let pool = pool.expect("threads");
        let again = pool.install(|| files(&run(&listing(two_motions))));
        assert!(*TWO == again, "{n_threads} threads give the same bytes");
    }
}

#[test]
fn limit_the_papers_case_is_the_paper_run_exactly() {
    let study = StudyFile::read(&studies().join("table-6.json")).expect("a readable study");
    let rows = rows(&TWO, "scenes.csv");
    for scene in &study.study.scenes {
        let mut exact = scene.clone();
        exact.method = Method::EXACT;
        let prepared = Simulation::new(&exact, study.base()).expect("a sound scene");
        let outcome = prepared.run(None).expect("an exact run");
        let own = rows
            .iter()
            .filter(|row| row["table"] == "6" && row["scene"] == scene.name && row["direction"] == "reversed");
        let own = own.filter(|row| row["motion"].contains("paper"));
        for (index, row) in own.enumerate() {
            let momentum = digits(outcome.momentum.of(index) / 1e3);
            let displacement = digits(1e3 * outcome.peaks.of(index).displacement.value);
            let found = (&*row["transferred_momentum_kn_s"], &*row["peak_displacement_mm"]);
            assert_eq!(found, (&*momentum, &*displacement), "{row:?}");
        }
    }
}

/// Runs the paper's record alone, multiplied by `scale`.
fn weakened(scale: f64) -> Beyond {
    run(&listing(|settings| {
        settings.motions.truncate(1);
        settings.motions[0].record.scale = scale;
    }))
}

#[test]
fn limit_claims_about_nothing_do_not_apply() {
    let made = weakened(0.01);
    let [(None, claims)] = &made.claims()[..] else {
        panic!("the paper's scenes alone");
    };
    assert_eq!(claims.len(), 11, "claims that exact runs are asked");
    for (claim, tally) in claims {
        assert_eq!((tally.holds, tally.does_not_apply), (0, 2), "{claim}");
        assert_eq!(tally.words(), "in 0 of 2 cases; 2 do not apply");
    }
    let touch = |row: &TableRow| row["collisions"] != "0" || !row["first_touch_s"].is_empty();
    assert!(!rows(&files(&made), "scenes.csv").iter().any(touch));
}

/// In one direction two elastic structures touch and two nonlinear ones do not. A claim about both does not hold; a claim about each is
/// tested on the touching ones.
#[test]
fn limit_claims_about_something_and_nothing() {
    assert_snapshot!(text(&files(&weakened(0.35)), "verdicts.csv"));
}

#[test]
fn limit_weaker_shaking_is_a_weaker_record() {
    let made = run(&listing(|settings| {
        settings.motions.truncate(1);
        settings.changes = vec![Change::Weaker(0.35)];
    }));
    let (made, plain) = (files(&made), files(&weakened(0.35)));
    for table in ["scenes.csv", "verdicts.csv", "direction.csv"] {
        assert_eq!(text(&made, &format!("weaker/{table}")), text(&plain, table), "{table}");
    }
}

/// A file of results/beyond/storeys.
fn committed(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../results/beyond/storeys");
    let path = path.join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// `reproduce` does not make these files: they take longer than all else beyond the paper's record. This test runs their part under that
/// record.
#[test]
fn reference_buildings_of_storeys_are_what_their_command_made() {
    for table in ["claims.csv", "direction.csv", "scenes.csv", "verdicts.csv"] {
        let hash = format!("{:x}", Sha256::digest(committed(table).as_bytes()));
        assert!(committed("made-by.txt").contains(&hash), "{table}: {hash}");
    }
    let mut listed = None;
    let part = listing(|settings| {
        settings.motions.truncate(1);
        listed = Some(settings.motions[0].name.clone());
        settings.changes = vec![Change::Storeys(3)];
    });
    let listed = listed.expect("a motion");
    let made = files(&run(&part));
    for table in ["scenes.csv", "verdicts.csv"] {
        let of = |text: &str| -> Vec<String> {
            let own = text.lines().filter(|line| line.contains(&listed));
            own.map(String::from).collect()
        };
        let fresh = of(text(&made, &format!("storeys/{table}")));
        assert!(fresh.len() >= 22, "two directions of all that is asked");
        assert_eq!(fresh, of(&committed(table)), "{table}");
    }
}

#[test]
fn limit_a_mirrored_row_under_the_reversed_motion_mirrors() {
    let mut mirrored = listing(two_motions);
    for file in &mut mirrored {
        if ["table-2", "table-4", "table-6", "table-7"].contains(&&*file.id) {
            for scene in &mut file.study.scenes {
                scene.structures.reverse();
                scene.contacts.iter_mut().for_each(|contacts| contacts.reverse());
            }
        }
    }
    let mirrored = rows(&files(&run(&mirrored)), "scenes.csv");
    let plain = rows(&TWO, "scenes.csv");
    assert_eq!(mirrored.len(), plain.len());
    for row in &plain {
        let same = |other: &&TableRow| ["table", "scene", "motion"].iter().all(|key| other[*key] == row[*key]);
        let in_scene: Vec<_> = mirrored.iter().filter(same).collect();
        let n_structures = in_scene.len() / 2;
        let number: usize = row["structure"].parse().expect("a number");
        let twin = in_scene
            .iter()
            .find(|other| other["direction"] != row["direction"] && other["structure"] == (n_structures + 1 - number).to_string());
        let twin = twin.expect("the structure at the other end");
        for (column, value) in row {
            let unsigned = |value: &String| value.trim_start_matches('-').to_string();
            match &**column {
                "direction" | "structure" => {}
                "peak_displacement_mm" | "peak_shear_kn" | "residual_displacement_mm" => {
                    assert_eq!(unsigned(value), unsigned(&twin[column]), "{column}, {row:?}");
                    let signs = [value, &twin[column]].map(|value| value.starts_with('-'));
                    let nothing = value.is_empty() || value == "0";
                    assert!(nothing || signs[0] != signs[1], "{column}, {row:?}");
                }
                _ => assert_eq!(value, &twin[column], "{column}, {row:?}"),
            }
        }
    }
}

#[test]
fn limit_motions_scaled_by_a_spectrum_share_it() {
    let made = run(&listing(|settings| {
        two_motions(settings);
        settings.scaled_by = Some(Strength::Sa {
            period_s: 0.3,
            damping_ratio: 0.05,
        });
        for motion in &mut settings.motions {
            // The scaling uses the whole record.
            motion.duration_s = None;
        }
    }));
    let rows = rows(&files(&made), "motions.csv");
    let number = |row: &TableRow, column: &str| row[column].parse::<f64>().expect("a number");
    let [one, other] = [0, 1].map(|index| number(&rows[index], "sa_0.30_s_m_per_s2"));
    assert!((one / other - 1.0).abs() < 1e-3, "{one}, {other}");
    assert!(number(&rows[1], "scaled_by") > 1.5, "{:?}", rows[1]);
}

#[test]
fn extreme_lists_that_are_refused() {
    let refused = |change: fn(&mut BeyondSettings)| {
        let files = listing(change);
        let files: Vec<&StudyFile> = files.iter().collect();
        let error = BeyondStudy::listed(&files).expect_err("a list that is refused");
        let text = error.to_string();
        let start = text.find("beyond.json").expect("the name of the file");
        text[start..].to_string()
    };
    let messages = [
        refused(|settings| settings.motions.clear()),
        refused(|settings| settings.motions[1].name = settings.motions[0].name.clone()),
        refused(|settings| settings.motions[2].record.reversed = true),
        refused(|settings| settings.motions[0].duration_s = Some(0.0)),
        refused(|settings| settings.rest_s = f64::NAN),
        refused(|settings| settings.changes = vec![Change::Storeys(1)]),
        refused(|settings| settings.changes = vec![Change::Weaker(1.5)]),
        refused(|settings| settings.changes = vec![Change::Storeys(3), Change::Storeys(4)]),
        refused(|settings| {
            settings.scaled_by = Some(Strength::Sa {
                period_s: -1.0,
                damping_ratio: 0.05,
            });
        }),
    ];
    assert_snapshot!(messages.join("\n"));
}

/// A folder with a record, its vertical twin, and a file that is not a record.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    drop(fs::remove_dir_all(&folder));
    fs::create_dir_all(&folder).expect("a folder");
    let pulse = |step: i32| 0.2 * f64::from(20 - (step - 20).abs()) / 20.0;
    let lines: Vec<_> = (0..=40)
        .map(|step| format!("{:.2},{}", 0.02 * f64::from(step), pulse(step)))
        .collect();
    let text = format!("# A push\ntime_s,acceleration_g\n{}\n", lines.join("\n"));
    fs::write(folder.join("push.csv"), text).expect("a file");
    fs::write(folder.join("notes.txt"), "Nothing but words.\n").expect("a file");
    let files = Path::new(env!("CARGO_MANIFEST_DIR")).join("../motion/tests/files");
    let horizontal = fs::read_to_string(files.join("knet.ns")).expect("a file at hand");
    let vertical = horizontal.replace("N-S", "U-D");
    assert_ne!(vertical, horizontal, "it names its direction");
    fs::write(folder.join("station.UD"), vertical).expect("a file");
    folder
}

#[test]
fn reference_a_folder_of_records() {
    let folder = folder("beyond-records");
    let peak = |scaled: bool| {
        let study = BeyondStudy::of_records(&studies(), &folder, scaled).expect("a record");
        assert_eq!(study.n_cases(), 6, "one record, both directions, three kinds of scene");
        let made = study.run(&|| ()).expect("runs that do not fail");
        let left_out = made.left_out().iter();
        let names: Vec<_> = left_out.map(|(name, _)| name.split(' ').next()).collect();
        assert_eq!(names, [Some("notes.txt"), Some("station.UD")]);
        assert!(made.left_out()[1].1.contains("vertical"), "{:?}", made.left_out());
        let files = files(&made);
        let rows = rows(&files, "motions.csv");
        assert_eq!(rows.len(), 1, "the paper's record is no part of it");
        assert_eq!(rows[0]["run_s"], "10.8", "ten seconds of rest");
        rows[0]["pga_m_per_s2"].clone()
    };
    assert_eq!(peak(false), "1.962", "0.2 g as given");
    assert_eq!(peak(true), rows(&TWO, "motions.csv")[0]["pga_m_per_s2"]);
}

#[test]
fn extreme_a_folder_without_records() {
    let folder = folder("beyond-nothing");
    fs::remove_file(folder.join("push.csv")).expect("a file");
    let refused = BeyondStudy::of_records(&studies(), &folder, true);
    let message = refused.expect_err("nothing shakes").to_string();
    assert!(message.contains("none that shakes the scenes; the first, notes.txt:"), "{message}");
}
