//! Folders of records: which motions shake a row, what is left out and why, and which motions count as one event.

use std::fs;
use std::path::{Path, PathBuf};

use pounding_assess::{LeftOutKind, Suite};
use pounding_scene::FileUse;
use pounding_scene::file::Unit;

/// A folder that is removed with the test.
pub(crate) struct Folder(tempfile::TempDir);

impl Folder {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().expect("a disk"))
    }

    pub(crate) fn path(&self) -> &Path {
        self.0.path()
    }

    pub(crate) fn with(self, name: &str, text: impl AsRef<[u8]>) -> Self {
        fs::write(self.path().join(name), text).expect("a disk");
        self
    }

    pub(crate) fn suite(&self) -> Suite {
        self.declared(&FileUse::default())
    }

    pub(crate) fn declared(&self, declared: &FileUse) -> Suite {
        Suite::of(&[self.path().to_path_buf()], declared).expect("a folder")
    }
}

fn in_g() -> FileUse {
    FileUse {
        unit: Some(Unit::StandardGravity),
        time_step_s: Some(0.02),
        ..FileUse::default()
    }
}

/// A decaying sum of two sines in g; each `rate` is another motion.
fn value(rate: f64, step: usize) -> f64 {
    let time = 0.02 * step as f64;
    let sine = |share: f64| libm::sin(share * rate * time);
    0.2 * time * libm::exp(-time) * (sine(1.0) + 0.6 * sine(2.3))
}

/// A CSV file in the project's format, from a step on, times a factor.
fn csv(rate: f64, (skipped, factor): (usize, f64)) -> String {
    let line = |step: usize| format!("{},{}\n", 0.02 * step as f64, factor * value(rate, step + skipped));
    let lines: String = (0..300).map(line).collect();
    format!("time_s,acceleration_g\n{lines}")
}

pub(crate) fn list(rate: f64) -> String {
    let values: Vec<String> = (0..300).map(|step| value(rate, step).to_string()).collect();
    values.join("\n")
}

pub(crate) fn motion(rate: f64) -> String {
    csv(rate, (0, 1.0))
}

fn names(suite: &Suite) -> Vec<&str> {
    suite.motions.iter().map(|one| one.name.as_str()).collect()
}

fn left_out(suite: &Suite) -> Vec<(&str, LeftOutKind)> {
    let left_out = suite.left_out.iter();
    left_out.map(|one| (one.name.as_str(), one.reason.kind)).collect()
}

/// Pipes, folders and entries whose `stat` failed vanished silently: "4 of 4 runs" became "2 of 2".
#[cfg(unix)]
#[test]
fn issue_nothing_in_a_folder_vanishes() {
    let folder = Folder::new().with("a.csv", motion(9.0)).with("README.md", "Some words.\n");
    std::os::unix::fs::symlink("/nowhere/b.csv", folder.path().join("b.csv")).expect("a link");
    std::os::unix::fs::symlink("c.csv", folder.path().join("c.csv")).expect("a link to itself");
    fs::create_dir(folder.path().join("more")).expect("a folder");
    let pipe = folder.path().join("pipe");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo").success());
    let suite = folder.suite();
    assert_eq!(names(&suite), ["a.csv"]);
    assert_eq!(
        left_out(&suite),
        [
            ("b.csv", LeftOutKind::Unreadable),
            ("c.csv", LeftOutKind::Unreadable),
            ("more", LeftOutKind::Folder),
            ("pipe", LeftOutKind::NoFile),
            ("README.md", LeftOutKind::NoRecord),
        ]
    );
    assert_eq!(suite.counts(), "6 files, 1 used and 5 left out: 1 motion of 1 event");
    let said = suite.said_of_left_out(false).join("\n");
    assert!(said.starts_with("b.csv: cannot be read: "), "{said}");
}

/// Copies counted as events: three files of one record were three events.
#[test]
fn issue_copies_are_one_record() {
    let later = csv(9.0, (3, 9.806_65)).replace("acceleration_g", "acceleration_m_per_s2");
    let folder = Folder::new()
        .with("quake.csv", motion(9.0))
        .with("quake (1).csv", motion(9.0))
        // Begins three steps later, and has the values in another unit.
        .with("cut.csv", later)
        .with("reversed quake.csv", csv(9.0, (0, -1.0)))
        .with("another.csv", motion(7.0));
    let suite = folder.suite();
    assert_eq!(suite.motions.len(), 2, "{:?}", names(&suite));
    assert_eq!(suite.n_events, 2);
    let copies = suite.left_out.iter();
    assert!(copies.clone().all(|one| one.reason.kind == LeftOutKind::Copy));
    let of: Vec<&str> = copies.map(|one| one.reason.said.as_str()).collect();
    assert_eq!(of, ["of cut.csv"; 3]);
}

/// A record at two scales: nothing shows which scale is right, so it counts as one event, with a remark.
#[test]
fn issue_a_record_at_two_scales_is_one_event_and_asked_about() {
    let folder = Folder::new()
        .with("a.csv", motion(9.0))
        .with("a times two.csv", csv(9.0, (0, 2.0)))
        .with("b.csv", motion(7.0));
    let suite = folder.suite();
    assert_eq!((suite.motions.len(), suite.n_events), (3, 2));
    let said = suite.remarks(false).join("\n");
    let said = said.lines().next().expect("a line");
    assert!(
        said.contains("a.csv comes again times a factor, and counts as one event with the others"),
        "{said}"
    );
    assert!(said.ends_with("a times two.csv (times 2.000)"), "{said}");
}

/// Two records that differ are two, however alike their spectra are.
#[test]
fn limit_other_records_are_no_copies() {
    let mut folder = Folder::new();
    for index in 0..12 {
        let rate = 6.0 + 0.5 * f64::from(index);
        folder = folder.with(&format!("r{index:03}.csv"), motion(rate));
    }
    let suite = folder.suite();
    assert_eq!((suite.motions.len(), suite.n_events, suite.alike.len()), (12, 12, 0));
}

/// A unit that was declared for one file in g was also taken for a file in cm/s², which then shook the row with 0.6 g. No remark named that
/// file.
#[test]
fn issue_every_file_that_takes_a_declaration_is_named() {
    let folder = Folder::new()
        .with("said.csv", motion(9.0))
        .with("one.txt", list(7.0))
        .with("two.txt", list(5.0));
    assert_eq!(folder.suite().motions.len(), 1, "nothing is guessed");
    let suite = folder.declared(&in_g());
    assert_eq!(names(&suite), ["one.txt", "said.csv", "two.txt"]);
    let said = suite.remarks(false).join("\n");
    assert!(
        said.contains("unit = \"g\", time_step_s = 0.02 is declared, and was taken for 2 records that do not say it: one.txt, two.txt"),
        "{said}"
    );
    let mut of_unit = said.lines().filter(|line| line.starts_with("unit"));
    assert!(of_unit.all(|line| !line.contains("said.csv")), "{said}");
}

/// One unit held for all silent files of a folder, whatever their values.
#[test]
fn issue_one_unit_for_peaks_far_apart_is_warned_of() {
    let folder = Folder::new().with("one.txt", list(7.0)).with("two.txt", list(5.0));
    assert_eq!(folder.declared(&in_g()).says_units_apart(), None);
    let in_gal = |line: &str| (981.0 * line.parse::<f64>().expect("a number")).to_string();
    let in_gal: Vec<String> = list(5.0).lines().map(in_gal).collect();
    let folder = Folder::new().with("one.txt", list(7.0)).with("three.txt", in_gal.join("\n"));
    let said = folder.declared(&in_g()).says_units_apart().expect("a warning");
    assert!(
        said.starts_with("the unit g is declared for 2 records without one, whose peaks differ by a factor of 1000, ")
            && said.contains("one.txt ("),
        "{said}"
    );
}

/// A velocity shook rows as an acceleration if a unit was declared for its folder.
#[test]
fn issue_a_name_that_says_velocity_is_believed() {
    let folder = Folder::new()
        .with("a.acc", list(9.0))
        .with("a.vel", list(7.0))
        .with("b_disp.txt", list(5.0))
        // The content of the file counts more than its name.
        .with("c.vel", motion(4.0));
    let suite = folder.declared(&in_g());
    assert_eq!(names(&suite), ["a.acc", "c.vel"]);
    assert_eq!(
        left_out(&suite),
        [("a.vel", LeftOutKind::Velocity), ("b_disp.txt", LeftOutKind::Displacement)]
    );
    let declared = FileUse {
        acceleration: true,
        ..in_g()
    };
    let suite = folder.declared(&declared);
    assert_eq!(suite.motions.len(), 4);
    let said = suite.remarks(false).join("\n");
    assert!(
        said.contains("acceleration = true is declared, and was taken for 2 records that do not say it: a.vel, b_disp.txt"),
        "{said}"
    );
}

/// A record of zeros counted as an event, under which every gap was enough.
#[test]
fn issue_zeros_shake_nothing() {
    let folder = Folder::new()
        .with("a.csv", motion(9.0))
        .with("zeros.csv", "time_s,acceleration_g\n0,0\n0.02,0\n0.04,0\n");
    let suite = folder.suite();
    assert_eq!(left_out(&suite), [("zeros.csv", LeftOutKind::Zeros)]);
}

/// A name that is not UTF-8 was opened as another one: another file was read, with exit code 0.
#[cfg(target_os = "linux")]
#[test]
fn issue_a_name_that_is_not_utf_8_is_its_own_file() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let folder = Folder::new();
    let write = |name: &[u8], rate: f64| {
        let path = folder.path().join(OsStr::from_bytes(name));
        fs::write(path, motion(rate)).expect("a disk");
    };
    write(b"r\xff.csv", 9.0);
    write("r\u{fffd}.csv".as_bytes(), 7.0);
    let suite = folder.suite();
    assert_eq!(names(&suite), ["r\u{fffd}.csv", "r\\xff.csv"]);
    let of = |index: usize| suite.motions[index].origin().file.values()[1];
    assert_eq!(of(0).to_bits(), value(7.0, 1).to_bits());
    assert_eq!(of(1).to_bits(), value(9.0, 1).to_bits());
    let one = PathBuf::from(OsStr::from_bytes(b"r\xff.csv"));
    let named = Suite::of(&[folder.path().join(one)], &FileUse::default()).expect("a file");
    let first = named.motions[0].origin().file.values()[1];
    assert_eq!(first.to_bits(), value(9.0, 1).to_bits());
}

/// The copy with the shorter name stayed. This name does not tell the record, so that the record's other component was a second event.
#[test]
fn issue_a_copy_is_of_the_event_of_its_name() {
    let folder = Folder::new()
        .with("KOBE_NS.csv", motion(9.0))
        .with("KOBE_EW.csv", motion(7.0))
        .with("x.csv", motion(9.0));
    let suite = folder.suite();
    assert_eq!(names(&suite), ["KOBE_EW.csv", "x.csv"]);
    assert_eq!(suite.n_events, 1);
    assert_eq!(left_out(&suite), [("KOBE_NS.csv", LeftOutKind::Copy)]);
    assert!(suite.motions[1].direction.is_some(), "its copy tells it");
    let said = suite.counts();
    assert_eq!(said, "3 files, 2 used and 1 left out: 2 motions of 1 event");
}

/// The copy of a vertical component shook the row: copies were looked for only among motions that shake it.
#[test]
fn issue_the_copy_of_a_vertical_shakes_nothing() {
    let folder = Folder::new()
        .with("KOBE_EW.csv", motion(7.0))
        .with("KOBE_UD.csv", motion(9.0))
        .with("x.csv", motion(9.0));
    let suite = folder.suite();
    assert_eq!(names(&suite), ["KOBE_EW.csv"]);
    let wanted = [("KOBE_UD.csv", LeftOutKind::VerticalByName), ("x.csv", LeftOutKind::Copy)];
    assert_eq!(left_out(&suite), wanted);
}

/// Pulses of other periods were left out as copies: they correlate by more than 0.99.
#[test]
fn issue_pulses_of_other_periods_are_no_copies() {
    let pulse = |period: f64| {
        let line = |step: usize| {
            let x = core::f64::consts::PI * (0.02 * step as f64 - 2.0) / period;
            let value = 0.2 * (1.0 - 2.0 * x * x) * libm::exp(-x * x);
            format!("{},{value}\n", 0.02 * step as f64)
        };
        let lines: String = (0..200).map(line).collect();
        format!("time_s,acceleration_g\n{lines}")
    };
    let folder = Folder::new()
        .with("a.csv", pulse(0.5))
        .with("b.csv", pulse(0.52))
        .with("c.csv", pulse(0.545))
        .with("d.csv", pulse(0.5).replace("acceleration_g", "acceleration_G"));
    let suite = folder.suite();
    assert_eq!(names(&suite), ["a.csv", "b.csv", "c.csv"]);
    assert_eq!((suite.n_events, suite.alike.len()), (3, 0));
}

/// A folder of one record at eight intensities had a line for each.
#[test]
fn issue_a_record_at_many_scales_is_one_line() {
    let mut folder = Folder::new();
    for factor in 1_u8..=8 {
        let text = csv(9.0, (0, f64::from(factor)));
        folder = folder.with(&format!("im{factor}.csv"), text);
    }
    let suite = folder.suite();
    assert_eq!((suite.motions.len(), suite.n_events), (8, 1));
    let said = suite.remarks(false);
    let alike = said.iter().filter(|line| line.contains("times a factor"));
    assert_eq!(alike.count(), 1, "{said:?}");
    assert!(said[0].contains("im5.csv (times 5.000), and 3 more"), "{said:?}");
}

/// The lower sensors of KiK-net shook rows, and so did vertical components whose word comes first in the name.
#[test]
fn issue_names_of_boreholes_and_verticals() {
    let mut folder = Folder::new();
    for (rate, name) in [
        (5.0, "IWTH25.EW1.csv"),
        (5.7, "IWTH25.EW2.csv"),
        (6.4, "IWTH25.NS2.csv"),
        (7.1, "UD_filtered.csv"),
    ] {
        folder = folder.with(name, motion(rate));
    }
    let suite = folder.suite();
    assert_eq!(names(&suite), ["IWTH25.EW2.csv", "IWTH25.NS2.csv"]);
    assert_eq!(suite.n_events, 1);
    assert_eq!(
        left_out(&suite),
        [
            ("IWTH25.EW1.csv", LeftOutKind::Borehole),
            ("UD_filtered.csv", LeftOutKind::VerticalByName)
        ]
    );
    let said = suite.remarks(false).join("\n");
    assert!(said.contains("IWTH25.EW1.csv (by its name)"), "{said}");
}

/// NS1 and EW1 of a table of KiK-net are in the borehole, and shook rows.
#[test]
fn issue_columns_of_boreholes_shake_nothing() {
    let header = "Time (s),NS1 (gal),EW1 (gal),UD1 (gal),NS2 (gal),EW2 (gal),UD2 (gal)\n";
    let row = |row: usize| {
        let values = [5.0, 5.7, 6.4, 7.1, 7.8, 8.5].map(|rate| format!("{:.6}", value(rate, row)));
        format!("{:.2},{}\n", row as f64 * 0.02, values.join(","))
    };
    let table = header.to_owned() + &(0..300).map(row).collect::<String>();
    let suite = Folder::new().with("IWTH25.csv", table).suite();
    assert_eq!(names(&suite), ["IWTH25.csv NS2", "IWTH25.csv EW2"]);
    assert_eq!(suite.n_events, 1);
}

#[path = "../../../../fuzz/src/folder.rs"]
mod fuzzed;

/// The seeds in `fuzz/corpus` pass the checks of the fuzz target for folders.
#[test]
fn issue_every_seed_of_a_folder_keeps_its_entries() {
    let seeds = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/folder");
    let seeds: Vec<_> = fs::read_dir(seeds).expect("the corpus is there").collect();
    assert!(seeds.len() > 10, "{} seeds", seeds.len());
    for seed in seeds {
        let bytes = fs::read(seed.expect("a file").path()).expect("a seed");
        let folder = Folder::new();
        fuzzed::check(&bytes, folder.path());
    }
}

/// A message asked for a step to resample to, but folders ignored it; a `.vel` file without a step was told to declare one.
#[test]
fn issue_declarations_that_are_asked_for_help() {
    let row = |step: usize| {
        format!(
            "{:.4} {:.6}\n",
            0.02 * step as f64 + 0.004 * f64::from(step % 3 == 1),
            value(5.0, step)
        )
    };
    let uneven: String = (0..300).map(row).collect();
    let folder = Folder::new()
        .with("uneven.txt", format!("# unit: g\n{uneven}"))
        .with("quake.csv", motion(5.7))
        .with("foo.vel", list(6.4));
    let suite = folder.suite();
    let reasons = left_out(&suite);
    assert_eq!(reasons[0], ("foo.vel", LeftOutKind::Velocity));
    assert_eq!(reasons[1].0, "uneven.txt");
    let declared = FileUse {
        time_step_s: Some(0.01),
        ..FileUse::default()
    };
    assert_eq!(names(&folder.declared(&declared)), ["quake.csv", "uneven.txt"]);
}
