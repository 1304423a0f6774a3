//! Tests of folders of records, and of several scenes in one command.

use std::fs;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use serde_json::{Value, json};

use crate::runs::printed;
use crate::{folder, pounding, refusal};

pub(crate) const TOWERS: &str = r#"
name = "towers"
record = { file = "records/column.txt", unit = "cm_per_s2", time_step_s = 0.02 }
duration_s = 3.0

structures = [
  { sdof = { name = "left", mass_kg = 1e5, period_s = 0.8, damping.ratio = 0.05, yield_displacement_m = 0.02 } },
  { sdof = { name = "right", mass_kg = 2e5, period_s = 0.4, damping.ratio = 0.05 } },
]

[[contacts]]
gap_m = 0.01
law.stereomechanical.restitution = 0.6
"#;

/// A folder with a scene and records: one with a unit, one that needs the scene's unit, one of spectra, one hidden.
pub(crate) fn suite(test: &str) -> PathBuf {
    let folder = folder(test);
    let records = folder.join("records");
    fs::create_dir_all(&records).expect("a folder");
    let write = |name: &str, text: String| fs::write(records.join(name), text).expect("a file");
    let ramp = |step: usize| 4.0 * libm::sin(0.25 * step as f64);
    let line = |step: usize| format!("{:.2},{:.4}", step as f64 / 50.0, ramp(step));
    let csv = (0..60).map(line).collect::<Vec<_>>().join("\n");
    write("pulse.csv", format!("time_s,acceleration_m_per_s2\n{csv}\n"));
    // This is another motion, because the first one reversed would count as a copy.
    let line = |step: usize| format!("{:.3}", -400.0 * libm::sin(0.31 * step as f64));
    let column = (0..60).map(line).collect::<Vec<_>>().join("\n");
    write("column.txt", column);
    write("spectra.V3", "Response and Fourier amplitude spectra (86 periods)\n".into());
    write(".hidden", "not a record".into());
    fs::write(folder.join("towers.toml"), TOWERS).expect("a file");
    folder
}

#[test]
fn reference_gap_under_a_folder() {
    let folder = suite("gap");
    let text = pounding(&folder, &["gap", "towers.toml", "--records", "records"]);
    assert_snapshot!(printed(&text));
    let csv = pounding(&folder, &["gap", "towers.toml", "--records", "records", "--csv"]);
    assert_snapshot!(csv.stdout);
    let json = pounding(&folder, &["gap", "towers.toml", "--records", "records", "--json"]);
    let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
    let required = json["motions"][0]["gaps"][0]["required_m"].as_f64().expect("a number");
    assert!(csv.stdout.contains(&required.to_string()), "{required}");
    // Every field of the JSON is a column of the CSV.
    let header = csv.stdout.lines().next().expect("a header");
    let columns: Vec<&str> = header.split(',').collect();
    let gap = json["motions"][0]["gaps"][0].as_object().expect("fields");
    assert!(gap.keys().all(|key| columns.contains(&key.as_str())), "{gap:?}");
    let others = "record, event, reversed and refused";
    assert_eq!(columns.len(), gap.len() + 4, "{others}");
    // The counts of the paragraph Records.
    let records = &json["records"];
    assert_eq!((&records["files"], &records["files_left_out"]), (&3.into(), &1.into()));
    assert_eq!(records["events"], 2);
    assert_eq!(records["declared"][0]["records"], json!(["column.txt"]));
    assert_eq!(records["direction_not_told"], json!(["column.txt", "pulse.csv"]));
}

#[test]
fn reference_run_under_a_folder() {
    let folder = suite("batch");
    let arguments = ["run", "towers.toml", "--records", "records", "--both"];
    assert_snapshot!(printed(&pounding(&folder, &arguments)));
    let csv = pounding(&folder, &[&arguments[..], &["--csv"]].concat());
    assert_snapshot!(csv.stdout);
    let json = pounding(&folder, &[&arguments[..], &["--json"]].concat());
    let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
    // Motions are sorted by name, and each has both directions.
    assert_eq!(json["motions"][0]["record"], "column.txt");
    assert_eq!(json["motions"][3]["record"], "pulse.csv");
    assert_eq!(json["motions"][3]["reversed"], true);
    assert_eq!(json["records"]["files_used"], 2);
}

/// An AT2 file of PEER with a component after the last comma of its title.
pub(crate) fn at2(component: &str) -> String {
    // Each component gets another motion: copies would be left out.
    let own = component.bytes().fold(0, |own: u32, byte| (31 * own + u32::from(byte)) % 97);
    let rate = 0.25 + 1e-2 * f64::from(own);
    let sample = |step: usize| format!("{:.5}", 0.2 * libm::sin(rate * step as f64));
    let values = (0..60).map(sample).collect::<Vec<_>>().join(" ");
    format!(
        "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 2/3/1940, A Station #9{component}\n\
         ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=     60, DT=   .0200 SEC\n{values}\n"
    )
}

/// Vertical components shook rows: only the names of components were tested, and only some formats have them.
#[test]
fn issue_vertical_components_shake_no_row() {
    let folder = suite("vertical");
    let records = folder.join("records");
    fs::remove_dir_all(&records).expect("a folder");
    fs::create_dir_all(&records).expect("a folder");
    let knet = fs::read_to_string("../motion/tests/files/knet.ns").expect("a file of the tests");
    let smc = fs::read_to_string("../motion/tests/files/usgs.smc").expect("a file of the tests");
    let column = "10\n20\n-30\n5\n";
    for (name, text) in [
        ("RSN6_ELC180.AT2", at2(", 180")),
        // The contents of a file count more than its name.
        ("RSN6_ELC-V.AT2", at2(", 090")),
        ("RSN6_ELC-C.AT2", at2(", UP")),
        ("RSN6_ELC-DWN.AT2", at2("")),
        ("RSN6_NIGH11UD.AT2", at2("")),
        ("column_z.txt", column.into()),
        ("column_ud.txt", column.into()),
        ("ABCH01.EW2", knet.replace("N-S", "5")),
        ("ABCH01.UD2", knet.replace("N-S", "6")),
        ("ABC001.UD", knet.replace("N-S", "U-D")),
        ("a.smc", smc.replace("=     27", "=     UP")),
        ("b.smc", smc),
    ] {
        fs::write(records.join(name), text).expect("a file");
    }
    for command in [&["gap"][..], &["run", "--no-error"]] {
        let arguments = [command, &["towers.toml", "--records", "records"]].concat();
        let ended = pounding(&folder, &arguments);
        let text = printed(&ended);
        let left_out = text.lines().skip_while(|line| !line.starts_with("Records"));
        let left_out: Vec<_> = left_out.take_while(|line| !line.is_empty()).collect();
        assert_snapshot!("vertical", left_out.join("\n"));
        let json = pounding(&folder, &[&arguments[..], &["--json"]].concat());
        let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
        let motions = json["motions"].as_array().expect("a list");
        let mut shaken: Vec<_> = motions
            .iter()
            .filter(|motion| motion.get("refused").is_none())
            .map(|motion| motion["record"].as_str().expect("a name"))
            .collect();
        shaken.dedup();
        assert_eq!(shaken, ["ABCH01.EW2", "RSN6_ELC-V.AT2", "RSN6_ELC180.AT2", "b.smc",]);
    }
}

/// A line of the table equals a run of that record alone.
#[test]
fn limit_a_line_is_a_run() {
    let folder = suite("line");
    let json = pounding(&folder, &["run", "towers.toml", "--records", "records", "--json"]);
    let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
    let peak = json["motions"][0]["structures"][0]["peak_displacement_m"].as_f64();
    let alone = pounding(&folder, &["run", "towers.toml", "--details"]);
    let line = printed(&alone).lines().find(|line| line.starts_with("left  "));
    let printed_peak: f64 = line.and_then(|line| line.split_whitespace().nth(3)?.parse().ok()).expect("a peak");
    let peak = 1e3 * peak.expect("a number");
    assert!((peak / printed_peak - 1.0).abs() < 1e-3, "{peak} {printed_peak}");
}

#[test]
fn reference_scenes_side_by_side() {
    let folder = suite("compare");
    let wide = TOWERS.replace("0.01\n", "0.1\n").replace("\"towers\"", "\"wider\"");
    fs::write(folder.join("wider.toml"), wide).expect("a file");
    let third = TOWERS
        .split("\n[[contacts]]")
        .next()
        .expect("a part")
        .replace("\"towers\"", "\"apart\"");
    fs::write(folder.join("apart.toml"), third).expect("a file");
    let text = pounding(&folder, &["compare", "towers.toml", "wider.toml", "apart.toml", "--details"]);
    assert_snapshot!(printed(&text));
}

/// Four gaps made 247 lines without a summary, of one direction of shaking.
#[test]
fn issue_a_comparison_begins_with_six_lines() {
    let folder = suite("compare_brief");
    let wide = TOWERS.replace("0.01\n", "0.1\n").replace("\"towers\"", "\"wider\"");
    fs::write(folder.join("wider.toml"), wide).expect("a file");
    let text = pounding(&folder, &["compare", "towers.toml", "wider.toml"]);
    assert_snapshot!(printed(&text));
}

/// Every example that the project ships runs and has no implausible values.
#[test]
fn reference_every_example_runs() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let examples = here.join("../../studies/examples");
    let mut names = Vec::new();
    for entry in fs::read_dir(&examples).expect("the folder is there") {
        let path = entry.expect("a file").path();
        if path.extension().is_none_or(|ending| ending != "toml" && ending != "json") {
            continue;
        }
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let path = format!("../../studies/examples/{name}");
        let ran = pounding(here, &["run", &path]);
        assert_eq!((ran.code, ran.stderr.as_str()), (0, ""), "{name}");
        let checked = pounding(here, &["check", &path]);
        assert_eq!((checked.code, checked.stderr.as_str()), (0, ""), "{name}");
        names.push(name);
    }
    names.sort();
    assert_eq!(
        names,
        [
            "bridge-with-restrainers.toml",
            "isolated-building-and-moat.toml",
            "row-of-five.toml",
            "slab-against-column.toml",
            "towers-of-storeys.toml",
            "towers-with-dampers.toml",
            "towers.toml",
            "two-structures.json",
            "wall-and-neighbour.json"
        ]
    );
}

#[test]
fn reference_demo() {
    let folder = folder("demo");
    let first = pounding(&folder, &["demo"]);
    assert_snapshot!(printed(&first));
    let file = |name: &str| fs::read(folder.join("pounding-demo").join(name)).expect("it is there");
    let page = file("results/report.html");
    // Structures of one storey have a drift ratio if their height is known.
    assert!(String::from_utf8_lossy(&page).contains("<th>Drift ratio</th>"));
    // A repeated command leaves equal bytes.
    let again = pounding(&folder, &["demo"]);
    assert_eq!((again.code, &again.stdout), (0, &first.stdout), "{}", again.stderr);
    assert_eq!(file("results/report.html"), page);
    fs::write(folder.join("pounding-demo/scene.toml"), "mine").expect("a file");
    assert_snapshot!(refusal(&pounding(&folder, &["demo"])), @"error: pounding-demo/scene.toml: found another file, allowed is none or that of the demo; name another folder: pounding demo FOLDER");
}

#[test]
fn extreme_folders_without_a_record() {
    let folder = suite("no_records");
    fs::create_dir_all(folder.join("empty")).expect("a folder");
    for command in ["gap", "run"] {
        let refused = |records| refusal(&pounding(&folder, &[command, "towers.toml", "--records", records]));
        assert_eq!(
            refused("empty"),
            "error: empty: found 0 files and no record that shakes a row, allowed is a folder with one or more"
        );
        assert!(refused("none").starts_with("error: none: cannot be read: "), "{}", refused("none"));
        fs::create_dir_all(folder.join("bad")).expect("a folder");
        fs::write(folder.join("bad/x"), "nothing of the kind").expect("a file");
        let message = refused("bad");
        assert!(message.ends_with("with one or more; 1 file that is no record: x"), "{message}");
    }
}

#[test]
fn extreme_a_gap_of_one_structure() {
    let folder = suite("one");
    let one = TOWERS.split("  { sdof = { name = \"right\"").next().expect("a part");
    fs::write(folder.join("one.toml"), format!("{one}]\n")).expect("a file");
    let message = refusal(&pounding(&folder, &["gap", "one.toml", "--records", "records"]));
    assert_snapshot!(message, @"error: one.toml: structures: found 1, allowed two or more: a gap lies between two");
}

/// A scene with every implausible value at once; all may be correct.
#[test]
fn extreme_an_unusual_scene() {
    let folder = suite("unusual");
    let unusual = TOWERS
        .replace("damping.ratio = 0.05, yield", "damping.ratio = 5, yield")
        .replace("mass_kg = 2e5, period_s = 0.4", "mass_kg = 200, period_s = 0.02")
        .replace("duration_s = 3.0", "duration_s = 0.6")
        .replace("gap_m = 0.01", "gap_m = 0.5")
        .replace("record = {", "record = { gravity_m_per_s2 = 981, scale = 0.001,");
    fs::write(folder.join("unusual.toml"), unusual).expect("a file");
    let checked = pounding(&folder, &["check", "unusual.toml"]);
    let text = printed(&checked);
    let unusual = text.lines().skip_while(|line| !line.starts_with("Unusual"));
    let unusual: Vec<_> = unusual.take_while(|line| !line.is_empty()).collect();
    assert_snapshot!(unusual.join("\n"));
}

/// If one of several scenes does not run, the message names it and nothing else is printed.
#[test]
fn extreme_a_scene_that_cannot_be_compared() {
    let folder = suite("compare_refused");
    let wrong = TOWERS.replace("gap_m = 0.01", "gap_m = -0.01");
    fs::write(folder.join("wrong.toml"), wrong).expect("a file");
    let refused = |arguments: &[&str]| refusal(&pounding(&folder, arguments));
    assert_snapshot!(refused(&["compare", "towers.toml", "wrong.toml"]), @r#"error: wrong.toml, line 12, column 1: scene "towers": contacts[0].gap_m: found -0.01, allowed a finite number >= 0"#);
    let missing = refused(&["compare", "towers.toml", "missing.toml"]);
    assert!(missing.starts_with("error: missing.toml: cannot be read: "), "{missing}");
    let alone = pounding(&folder, &["compare", "towers.toml"]);
    assert_eq!((alone.code, alone.stdout.as_str()), (2, ""), "two or more");
}

/// Scenes that do not fit beside each other are printed in blocks, at most 80 columns wide.
#[test]
fn limit_many_scenes_are_printed_in_blocks() {
    let folder = suite("compare_many");
    let text = pounding(&folder, &[&["compare", "--all"][..], &["towers.toml"; 7]].concat());
    let blocks: Vec<&str> = printed(&text).split("\n\n").collect();
    let columns = |block: &&str| block.lines().next().unwrap_or("").matches("towers").count();
    let columns: Vec<usize> = blocks.iter().map(columns).collect();
    assert!(columns.len() > 1, "{}", text.stdout);
    assert_eq!(columns.iter().sum::<usize>(), 7, "{}", text.stdout);
    for block in blocks {
        assert!(block.contains("  peak force [kN]"), "{block}");
    }
}
