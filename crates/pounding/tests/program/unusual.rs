//! Tests of implausible values, which come before every answer; both directions are judged, and unchecked properties are not called good.

use std::fs;
use std::path::PathBuf;

use serde_json::Value;

use crate::{Ended, folder, pounding};

/// Two structures 210 mm apart.
pub(crate) const TWO: &str = r#"
name = "two"
record.file = "records/good.csv"
structures = [
  { sdof = { name = "a", mass_kg = 2e5, period_s = 0.5, damping.ratio = 0.05 } },
  { sdof = { name = "b", mass_kg = 2e5, period_s = 0.9, damping.ratio = 0.05 } },
]
contacts = [{ gap_m = 0.21, law.hertz.impact_stiffness_n_per_m1_5 = 2e9 }]
"#;

/// Floors at 3 and 6.5 m beside floors at 3, 7 and 11 m; only the lowest can touch.
pub(crate) const STAGGERED: &str = r#"
name = "staggered"
record.file = "records/good.csv"
structures = [
  { building = { name = "a", period_s = 0.4, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3 }, { mass_kg = 2e5, height_m = 3.5 }] } },
  { building = { name = "b", period_s = 0.7, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3 }, { mass_kg = 2e5, height_m = 4, repeat = 2 }] } },
]
contacts = [{ gap_m = 0.05, levels = [1], law.stereomechanical.restitution = 0.5 }]
"#;

/// Samples of ten seconds whose oscillation becomes faster and dies out, with a speed and a factor.
pub(crate) fn record(speed: f64, factor: f64) -> String {
    let sample = |index: u32| {
        let time = 0.01 * f64::from(index);
        let envelope = (time / 2.0).min(1.0) * libm::exp(-0.25 * (time - 2.0).max(0.0));
        let sum = libm::sin(6.0 * speed * time) + libm::sin(13.0 * time + 0.5 * time * time);
        format!("{time:.2},{:.9}\n", factor * envelope * sum)
    };
    let samples = (0..1000).map(sample).collect::<String>();
    format!("time_s,acceleration_m_per_s2\n{samples}")
}

/// A folder with a scene and sound records. With `spoilt`, one record is in cm/s² but declared in m/s², and one is all zeros.
pub(crate) fn workplace(test: &str, scene: &str, spoilt: bool) -> PathBuf {
    let work = folder(test);
    fs::write(work.join("scene.toml"), scene).expect("it can be written");
    fs::create_dir(work.join("records")).expect("it can be made");
    let mut all = vec![("good.csv", record(1.0, 2.0)), ("other.csv", record(1.3, 1.7))];
    if spoilt {
        all.extend([
            ("cm.csv", record(0.8, 150.0)),
            ("cm2.csv", record(0.6, 130.0)),
            ("zeros.csv", record(1.0, 0.0)),
        ]);
    }
    for (name, text) in all {
        fs::write(work.join("records").join(name), text).expect("it can be written");
    }
    work
}

pub(crate) fn flat(ended: &Ended) -> String {
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    ended.stdout.split_whitespace().collect::<Vec<_>>().join(" ")
}

pub(crate) const OF_FOLDERS: [&[&str]; 3] = [
    &["assess", "scene.toml", "--records", "records"],
    &["gap", "scene.toml", "--records", "records"],
    &["run", "scene.toml", "--records", "records", "--both"],
];

/// "Proposed: 11850 mm" had no remark about a record in cm/s² that is declared in m/s². Only `run` named it, with a line per file.
#[test]
fn issue_unusual_records_stand_before_every_answer() {
    let work = workplace("unusual_records", TWO, true);
    let sweep = r#"{"scene": "scene.toml", "records": "records", "vary": [{"field": "contacts[0].gap_m", "values": [0.1, 0.2]}]}"#;
    fs::write(work.join("sweep.json"), sweep).expect("it can be written");
    let of_sweep: &[&str] = &["sweep", "sweep.json", "--out", "table.csv"];
    for arguments in OF_FOLDERS.into_iter().chain([of_sweep]) {
        let said = flat(&pounding(&work, arguments));
        let first = "Unusual 2 motions, the farthest off cm.csv: found a peak of ";
        assert!(said.starts_with(first), "{arguments:?}: {said}");
        assert_eq!(said.matches("a peak of").count(), 1, "{arguments:?}: {said}");
        assert!(!said.contains("none of") || arguments[0] != "assess", "{said}");
    }
    for arguments in OF_FOLDERS {
        let ended = pounding(&work, &[arguments, &["--json"]].concat());
        let found: Value = serde_json::from_str(&ended.stdout).expect("JSON");
        let place = found["unusual"][0]["place"].as_str().expect("a place");
        assert!(place.ends_with("cm.csv"), "{arguments:?}: {place}");
    }
    let ended = pounding(&work, &[OF_FOLDERS[0], &["--out", "out"]].concat());
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let page = fs::read_to_string(work.join("out/report.html")).expect("a page");
    let [unusual, answer] = ["cm.csv: found", "class=\"verdict"].map(|word| page.find(word));
    assert!(unusual.is_some() && unusual < answer, "{unusual:?} {answer:?}");
}

/// A file of zeros counted as an event under which "20 mm is enough", without a remark.
#[test]
fn issue_a_record_of_zeros_is_no_event() {
    let work = workplace("unusual_zeros", TWO, true);
    let said = pounding(&work, &[OF_FOLDERS[0], &["--json"]].concat()).stdout;
    let found: Value = serde_json::from_str(&said).expect("JSON");
    assert_eq!(found["events"], 4, "{said}");
    let named = found["motions"].as_array().expect("motions").iter();
    assert!(named.clone().all(|one| one["record"] != "zeros.csv"));
    let alone = TWO.replace("good.csv", "zeros.csv");
    fs::write(work.join("scene.toml"), alone).expect("it can be written");
    let said = flat(&pounding(&work, &["run", "scene.toml"]));
    assert!(said.starts_with("Unusual record: found "), "{said}");
}

/// Masses in tonnes gave a warning only at the end of an unmarked answer. `check` printed "Warnings none" below implausible values.
#[test]
fn issue_unusual_scenes_stand_before_every_answer() {
    let tonnes = TWO.replace("mass_kg = 2e5", "mass_kg = 200");
    let work = workplace("unusual_scene", &tonnes, false);
    let alone: [&[&str]; 3] = [
        &["run", "scene.toml"],
        &["run", "scene.toml", "--one-direction", "--details"],
        &["check", "scene.toml"],
    ];
    for arguments in alone.into_iter().chain(OF_FOLDERS) {
        let said = flat(&pounding(&work, arguments));
        let first = "Unusual structures[0].sdof.mass_kg and 1 more: found 200 kg, usual is ";
        assert!(said.starts_with(first), "{arguments:?}: {said}");
        for none in ["Warnings none More", "none of stability and e;"] {
            assert!(!said.contains(none), "{arguments:?}: {said}");
        }
    }
    let ended = pounding(&work, &["run", "scene.toml", "--out", "out"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let page = fs::read_to_string(work.join("out/report.html")).expect("a page");
    let [unusual, answer] = ["200 kg", "class=\"verdict"].map(|word| page.find(word));
    assert!(unusual.is_some() && unusual < answer, "{unusual:?} {answer:?}");
}

/// Only the first value of a varied field was tested, and the advice named options that `sweep` does not have.
#[test]
fn issue_all_that_a_sweep_varies_is_doubted() {
    let work = workplace("unusual_sweep", TWO, false);
    fs::write(work.join("records/bare.txt"), "0.1\n-0.2\n0.1\n").expect("it can be written");
    for (vary, found) in [
        (r#"{ field = "contacts[0].gap_m", values = [0.2, 50] }"#, "found 50 m"),
        (r#"{ field = "record.scale", values = [1, 100] }"#, "found a peak of 37.32 g"),
        (
            r#"{ field = "structures[0].sdof.damping.ratio", grid = { from = 0.05, to = 5, count = 3 } }"#,
            "which is 500 %",
        ),
    ] {
        let words = format!("scene = \"scene.toml\"\nrecords = \"records\"\nsummary = {{}}\nvary = [{vary}]\n");
        fs::write(work.join("sweep.toml"), words).expect("it can be written");
        let said = flat(&pounding(&work, &["sweep", "sweep.toml", "--overwrite"]));
        assert!(said.starts_with("Unusual ") && said.contains(found), "{vary}: {said}");
        assert!(said.contains("bare.txt") && !said.contains("--time-step"), "{said}");
    }
}

/// "250 mm is enough … and need 247.6 mm at most" lacked the caution that "not enough" had, with a margin far below the spread.
#[test]
fn issue_enough_is_said_with_its_cautions() {
    let soft = TWO.replace("period_s = 0.9", "period_s = 2.5, height_m = 3");
    let work = workplace("unusual_enough", &soft, false);
    let scaled = [OF_FOLDERS[0], &["--scale", "pga=0.42g"]].concat();
    let ended = pounding(&work, &[&scaled[..], &["--json"]].concat());
    let found: Value = serde_json::from_str(&ended.stdout).expect("JSON");
    let largest = found["gaps"][0]["required_m"]["largest"].as_f64().expect("a width");
    let enough = soft.replace("gap_m = 0.21", &format!("gap_m = {:.6}", 1.01 * largest));
    fs::write(work.join("scene.toml"), enough).expect("it can be written");
    let said = flat(&pounding(&work, &scaled));
    let [caution, answer, margin] = [
        "Caution: b: drift of ",
        " mm keeps a and b apart: they touch in none of 4 runs",
        "It is 1.01 times as wide, less than a standard deviation of the widths (",
    ]
    .map(|words| said.find(words).unwrap_or_else(|| panic!("{words}: {said}")));
    assert!(caution < answer && answer < margin, "{said}");
    // The damping of 500 % comes first.
    let damped = TWO.replace("damping.ratio = 0.05", "damping.ratio = 5");
    fs::write(work.join("scene.toml"), damped).expect("it can be written");
    let said = flat(&pounding(&work, OF_FOLDERS[0]));
    let first = "Unusual structures[0].sdof.damping and 1 more: found a damping ratio of 5, which is 500 %";
    assert!(said.starts_with(first) && said.contains("is enough between"), "{said}");
}

/// A pulse throws a building against a wall; reversed, it throws the building away from the wall.
pub(crate) const BESIDE_A_WALL: &str = r#"
name = "beside a wall"
record.generated.half_sine = { amplitude_m_per_s2 = -4, duration_s = 0.5, time_step_s = 0.01 }
structures = [
  { sdof = { name = "tower", mass_kg = 2e5, period_s = 1.0, height_m = 4, damping.ratio = 0.02, yield_displacement_m = 0.02 } },
  { wall = {} },
]
contacts = [{ gap_m = 0.01, law.hertz.impact_stiffness_n_per_m1_5 = 2e9 }]
"#;

/// The direction with the larger pounding force came first. The other one, in which the building drifts beyond all limits, had no warning:
/// "Warnings none".
#[test]
fn issue_both_directions_are_judged() {
    let work = workplace("unusual_directions", BESIDE_A_WALL, false);
    let said = flat(&pounding(&work, &["run", "scene.toml"]));
    let [first, second] = ["Answer Shaken reversed, ", "This direction is worse for the structures (tower: "]
        .map(|words| said.find(words).unwrap_or_else(|| panic!("{words}: {said}")));
    assert!(first < second && said[second..].contains("Shaken as given, "), "{said}");
    assert!(!said.contains("Warnings none"), "{said}");
    assert!(said.contains(" reversed: tower: drift of "), "{said}");
    let mirrored = BESIDE_A_WALL.replace("record.gen", "record.reversed = true\nrecord.gen");
    fs::write(work.join("scene.toml"), mirrored).expect("it can be written");
    let said = flat(&pounding(&work, &["run", "scene.toml"]));
    assert!(said.contains("Answer Shaken reversed, "), "{said}");
}

/// Eleven floors face columns, but the answer was "nothing touches … Warnings none": following the hint to set `levels` silenced them.
#[test]
fn issue_floors_beside_columns_are_not_silent() {
    let work = workplace("unusual_columns", STAGGERED, false);
    let said = flat(&pounding(&work, &["run", "scene.toml"]));
    for words in [
        "may hit a column, which is not modelled",
        "faces columns of its neighbour between floors; both together may move up to",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let said = flat(&pounding(&work, OF_FOLDERS[0]));
    assert!(
        said.contains("Caution: ") && said.contains("faces columns of its neighbour"),
        "{said}"
    );
    let said = flat(&pounding(&work, OF_FOLDERS[1]));
    assert!(said.contains(" Warnings a, floor 2: faces columns of its neighbour"), "{said}");
    // Storeys that bear everything, so that nothing else is warned of.
    let wide = STAGGERED
        .replace("gap_m = 0.05", "gap_m = 1.5")
        .replace("mass_kg", "drift_capacity_ratio = 0.1, shear_capacity_n = 1e8, mass_kg");
    fs::write(work.join("scene.toml"), wide).expect("it can be written");
    let said = flat(&pounding(&work, &["run", "scene.toml"]));
    assert!(said.contains("no floors touch") && said.contains("Warnings none"), "{said}");
}

/// Without contacts "nothing touches … Warnings none" was printed although nothing had been checked.
#[test]
fn issue_without_contacts_nothing_is_said_of_pounding() {
    let apart = TWO.lines().filter(|line| !line.starts_with("contacts"));
    let apart = apart.collect::<Vec<_>>().join("\n");
    let work = workplace("unusual_apart", &apart, false);
    let none = "no contact is modelled, so that nothing is said about pounding";
    let runs: [&[&str]; 3] = [&["run", "scene.toml"], &["run", "scene.toml", "--effects"], OF_FOLDERS[2]];
    for arguments in runs {
        let said = flat(&pounding(&work, arguments));
        assert!(said.contains(none), "{arguments:?}: {said}");
        assert!(!said.contains("nothing touches") && !said.contains("they touch under 0"), "{said}");
    }
    let ended = pounding(&work, &[OF_FOLDERS[0], &["--out", "out"]].concat());
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let page = fs::read_to_string(work.join("out/report.html")).expect("a page");
    assert!(page.contains("No contact is modelled") && !page.contains("Nothing touches"));
    let sweep = r#"{"scene": "scene.toml", "vary": [{"field": "structures[0].sdof.period_s", "values": [0.4, 0.5]}]}"#;
    fs::write(work.join("sweep.json"), sweep).expect("it can be written");
    let said = flat(&pounding(&work, &["sweep", "sweep.json", "--out", "table.csv"]));
    assert!(said.contains(none), "{said}");
}

/// The law of bumpers was not named.
#[test]
fn issue_the_law_of_bumpers_is_named() {
    let narrow = TWO.replace(
        "gap_m = 0.21, law.hertz.impact_stiffness_n_per_m1_5 = 2e9",
        "gap_m = 0.04, law.hertz_damp = { impact_stiffness_n_per_m1_5 = 2e9, restitution = 0.6 }",
    );
    let work = workplace("unusual_bumper", &narrow, false);
    let said = flat(&pounding(&work, &[OF_FOLDERS[0], &["--bumper", "k=500MN/m"]].concat()));
    let law = "between a and b, law modified linear viscoelastic with e = 0.60)";
    assert!(said.contains(law), "{said}");
}

/// The messages about `gap_m = 0,05` and `"records\quake"` were "unexpected key or value, expected newline" and that `b` and `e` are
/// expected.
#[test]
fn issue_decimal_commas_and_backslashes_are_named() {
    let work = workplace("unusual_mistakes", TWO, false);
    let said = |name: &str, from: &str, to: &str| {
        assert!(TWO.contains(from), "{from}");
        fs::write(work.join(name), TWO.replace(from, to)).expect("it can be written");
        let ended = pounding(&work, &["check", name]);
        assert_eq!(ended.code, 1, "{}", ended.stdout);
        ended.stderr
    };
    let json = r#"{"name": "two", "contacts": [{"gap_m": 0,05}]}"#;
    fs::write(work.join("scene.json"), json).expect("it can be written");
    let of_break = said("new.toml", "records/good.csv", "records\\new.csv");
    let said = [
        said("comma.toml", "gap_m = 0.21", "gap_m = 0,21"),
        said("line.toml", "name = \"two\"", "name = \"two\"\nduration_s = 10,5"),
        said("thousands.toml", "name = \"two\"", "name = \"two\"\nduration_s = 1.000,5"),
        said("quake.toml", "records/good.csv", "records\\quake.csv"),
        pounding(&work, &["check", "scene.json"]).stderr,
    ];
    insta::assert_snapshot!(said.concat(), @r"
    error: comma.toml, line 8, column 27: found `0,21` with a decimal comma, allowed is a decimal point: `0.21`
    error: line.toml, line 3, column 16: found `10,5` with a decimal comma, allowed is a decimal point: `10.5`
    error: thousands.toml, line 3, column 19: found `1.000,5` with a decimal comma, allowed is a decimal point: `1000.5`
    error: quake.toml, line 3, column 24: found a backslash in double quotes, where it begins an escape such as \n, allowed is / in its place, or single quotes: 'records\quake.csv'
    error: scene.json, line 1, column 42: found `0,05` with a decimal comma, allowed is a decimal point: `0.05`
    ");
    assert!(
        of_break.contains("in double quotes a backslash begins an escape: write / in its place"),
        "{of_break}"
    );
}
