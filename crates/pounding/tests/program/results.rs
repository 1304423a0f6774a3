//! Tests of the contents of folders of results.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use pounding::report::Summary;
use pounding::scene::{FloorQuantity, PairQuantity};
use serde_json::{Value, json};

use crate::{EXAMPLE, Ended, folder, good_scene, pounding, quiet};

/// Two masses that collide once: 2 m/s close 125 mm.
pub(crate) fn meeting() -> Value {
    let free = |name: &str, mass: f64, velocity: f64| {
        json!({"sdof": {
            "name": name, "mass_kg": mass, "stiffness_n_per_m": 1e-6, "damping": {"ratio": 0}, "height_m": 4.0,
            "initial_velocity_m_per_s": velocity
        }})
    };
    let mut scene = good_scene();
    scene["name"] = json!("meeting");
    scene["structures"] = json!([free("one", 1000.0, 2.0), free("other", 3000.0, 0.0)]);
    scene["contacts"] = json!([{"gap_m": 0.125, "law": {"stereomechanical": {"restitution": 0.5}}}]);
    scene["method"] = json!({"newmark": {"time_step_s": 0.01, "beta": 0.25, "gamma": 0.5}});
    scene["duration_s"] = json!(0.5);
    scene
}

/// Writes a scene with its record, and runs it with more arguments in its folder.
pub(crate) fn run_in(folder: &Path, scene: &Value, arguments: &[&str]) -> Ended {
    fs::write(folder.join("scene.json"), scene.to_string()).expect("the scene can be written");
    fs::write(folder.join("record.csv"), quiet(10)).expect("the record can be written");
    pounding(folder, &[&["run", "scene.json"], arguments].concat())
}

/// The folder of results of a scene.
pub(crate) fn results(test: &str, scene: &Value) -> PathBuf {
    let folder = folder(test);
    let ended = run_in(&folder, scene, &["--out", "out"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "a good run");
    assert!(
        ended.stdout.ends_with("Results   out/report.html\n"),
        "it says where: {}",
        ended.stdout
    );
    folder.join("out")
}

/// Every file of a folder.
pub(crate) fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let file = |path: PathBuf| {
        let name = path.file_name().expect("a name").to_string_lossy().into();
        (name, fs::read(&path).expect("a file"))
    };
    entries.map(|entry| file(entry.expect("an entry").path())).collect()
}

pub(crate) fn text(path: PathBuf) -> String {
    fs::read_to_string(path).expect("a text")
}

/// The columns of a CSV by name; an empty cell is `None`.
fn columns(path: PathBuf) -> BTreeMap<String, Vec<Option<f64>>> {
    let text = text(path);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let names: Vec<String> = reader.headers().expect("a header").iter().map(String::from).collect();
    let mut columns: BTreeMap<String, Vec<Option<f64>>> = BTreeMap::new();
    for row in reader.records() {
        for (name, cell) in names.iter().zip(&row.expect("a row as long as the header")) {
            columns.entry(name.clone()).or_default().push(cell.parse().ok());
        }
    }
    columns
}

/// A column whose cells are all numbers.
fn numbers(columns: &BTreeMap<String, Vec<Option<f64>>>, name: &str) -> Vec<f64> {
    let column = columns
        .get(name)
        .unwrap_or_else(|| panic!("no column {name}: {:?}", columns.keys()));
    let number = |cell: &Option<f64>| cell.unwrap_or_else(|| panic!("{name} has a gap"));
    column.iter().map(number).collect()
}

#[test]
fn reference_a_folder_of_results() {
    let out = results("results", &meeting());
    let names: Vec<String> = files(&out).into_keys().collect();
    assert_snapshot!(names.join("\n"), @r"
animation.svg
displacements.png
displacements.svg
gaps.png
gaps.svg
ground-motion.png
ground-motion.svg
history.csv
impacts.csv
report.html
summary.json
");
    assert_snapshot!("summary_json", text(out.join("summary.json")));
    assert_snapshot!(text(out.join("impacts.csv")), @r"
pair,left,right,start_s,end_s,duration_s,approach_speed_m_per_s,impulse_n_s,peak_force_n,peak_force_time_s,start_uncertainty_s
0,one,other,0.07,0.07,0.0,1.9999999999951001,2249.999999994488,,,
");
    let history = text(out.join("history.csv"));
    let beginning: Vec<&str> = history.lines().take(9).collect();
    assert_snapshot!(beginning.join("\n"), @r"
time_s,ground_acceleration_m_per_s2,one_displacement_m,one_velocity_m_per_s,one_absolute_acceleration_m_per_s2,one_shear_force_n,other_displacement_m,other_velocity_m_per_s,other_absolute_acceleration_m_per_s2,other_shear_force_n,one_other_opening_m
0,0,0,2,0,0,0,0,0,0,0.125
0.01,0,0.02,2,-2.000000e-11,2.000000e-8,0,0,0,0,0.105
0.02,0,0.04,2,-4.000000e-11,4.000000e-8,0,0,0,0,0.085
0.03,0,0.06,2,-6.000000e-11,6.000000e-8,0,0,0,0,0.065
0.04,0,0.08,2,-8.000000e-11,8.000000e-8,0,0,0,0,0.045
0.05,0,0.1,2,-1.000000e-10,1.000000e-7,0,0,0,0,0.025
0.06,0,0.12,2,-1.200000e-10,1.200000e-7,0,0,0,0,0.005
0.07,0,0.14,2,-1.400000e-10,1.400000e-7,0,0,0,0,-0.015
");
}

#[test]
fn reference_histories_are_those_of_the_summary() {
    let out = results("histories", &meeting());
    let history = columns(out.join("history.csv"));
    let summary: Summary = serde_json::from_str(&text(out.join("summary.json"))).expect("a summary");
    let time = numbers(&history, "time_s");
    assert_eq!((time.len(), time[50]), (51, 0.5), "every step to the end");
    for structure in &summary.structures {
        let displacements = numbers(&history, &format!("{}_displacement_m", structure.name));
        let peak = displacements
            .iter()
            .copied()
            .fold(0.0, |most: f64, next| if next.abs() > most.abs() { next } else { most });
        let wanted = structure
            .numbers
            .get(FloorQuantity::PeakDisplacementM)
            .expect("a structure has a peak");
        assert!((peak - wanted).abs() < 1e-6 * wanted.abs(), "{peak} {wanted}");
    }
    let [left, right] = ["one", "other"].map(|name| numbers(&history, &format!("{name}_displacement_m")));
    let gaps = numbers(&history, "one_other_opening_m");
    for (row, gap) in gaps.iter().enumerate() {
        let wanted = 0.125 + right[row] - left[row];
        assert!((gap - wanted).abs() < 1e-6, "row {row}: {gap} {wanted}");
    }
    assert!(!history.contains_key("one_other_pounding_force_n"), "an impulse has no force");
}

/// The example with a copy of its record under another name.
fn example() -> Value {
    let mut scene = good_scene();
    let records = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies/records");
    let record = records.join("el-centro-1940-ns-peer-pacific-engineering.csv");
    scene["record"]["file"] = json!(record.to_str().expect("a path in UTF-8"));
    scene
}

#[test]
fn reference_forces_of_a_compliant_pair() {
    let out = results("forces", &example());
    let history = columns(out.join("history.csv"));
    let forces = numbers(&history, "weak_stiff_pounding_force_n");
    let largest = forces.iter().copied().fold(0.0, f64::max);
    let impacts = columns(out.join("impacts.csv"));
    let peaks = numbers(&impacts, "peak_force_n").into_iter().fold(0.0, f64::max);
    assert!((largest - peaks).abs() < 1e-6 * peaks, "{largest} {peaks}");
    let durations = numbers(&impacts, "duration_s");
    let (starts, ends) = (numbers(&impacts, "start_s"), numbers(&impacts, "end_s"));
    for (row, duration) in durations.iter().enumerate() {
        assert!((ends[row] - starts[row] - duration).abs() < 1e-12, "row {row}");
    }
    assert!(impacts["start_uncertainty_s"].iter().all(Option::is_none), "a step knows none");
}

#[test]
fn reference_rest_and_chatter_of_the_exact_method() {
    let mut scene = example();
    scene["structures"] = json!(["wall", scene["structures"][0], scene["structures"][1]]);
    let law = json!({"stereomechanical": {"restitution": 0.4}});
    scene["contacts"] = json!([{"gap_m": 0.0, "law": law}, {"gap_m": 0.01, "law": law}]);
    scene["method"] = json!({"exact": {}});
    scene["duration_s"] = json!(6.0);
    let out = results("chatter", &scene);
    let summary: Summary = serde_json::from_str(&text(out.join("summary.json"))).expect("a summary");
    let impacts = columns(out.join("impacts.csv"));
    let pairs = text(out.join("impacts.csv"));
    let pairs: Vec<&str> = pairs.lines().filter_map(|line| line.split(',').next()).collect();
    for (index, pair) in summary.pairs.iter().enumerate() {
        let wanted = index.to_string();
        let of_pair = pairs.iter().filter(|found| **found == wanted).count();
        assert_eq!(of_pair, pair.collisions(), "pair {index}");
        assert!(pair.least_opening() <= 0.0, "pair {index} touches");
        assert_eq!(pair.number(PairQuantity::PeakForceN), None, "pair {index} is impulsive");
    }
    assert!(impacts["start_uncertainty_s"].iter().any(Option::is_some), "it states them");
    assert!(impacts["peak_force_n"].iter().any(Option::is_some), "it rests, with a force");
    let history = columns(out.join("history.csv"));
    assert!(!history.contains_key("wall_displacement_m"), "a wall does not move");
}

#[test]
fn limit_the_same_scene_gives_the_same_bytes() {
    let folder = folder("same_bytes");
    for (out, threads) in [("first", "1"), ("second", "2")] {
        fs::write(folder.join("scene.json"), example().to_string()).expect("written");
        let ended = assert_cmd::Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
            .args(["run", "scene.json", "--out", out])
            .env("RAYON_NUM_THREADS", threads)
            .current_dir(&folder)
            .output()
            .expect("the program starts");
        assert!(ended.status.success(), "a good run");
    }
    let [first, second] = ["first", "second"].map(|out| files(&folder.join(out)));
    assert_eq!(first.len(), 15, "four files, five figures twice, the animation");
    assert!(first == second, "the same bytes");
}

#[test]
fn limit_json_is_the_summary_of_the_folder() {
    let folder = folder("json");
    let printed = run_in(&folder, &meeting(), &["--json", "--out", "out"]);
    assert_eq!((printed.code, printed.stderr.as_str()), (0, ""));
    assert_eq!(printed.stdout, text(folder.join("out/summary.json")));
    assert_eq!(printed.stdout, run_in(&folder, &meeting(), &["--json"]).stdout);
    let summary: Summary = serde_json::from_str(&printed.stdout).expect("a summary");
    assert_eq!(printed.stdout, summary.to_json(), "what is read is what is written");

    // A later version may have more numbers.
    let mut later: Value = serde_json::from_str(&printed.stdout).expect("JSON");
    for place in ["structures", "pairs"] {
        later[place][0]["peak_wonder_m"] = json!(1.0);
        later[place][0]["errors"]["peak_wonder"] = json!({"relative": 0.1});
        later[place][0]["first_wonder"] = json!("text");
    }
    let read: Summary = serde_json::from_value(later).expect("a summary");
    assert_eq!(read.to_json(), summary.to_json());
}

#[test]
fn extreme_the_page_is_well_formed_and_needs_nothing_else() {
    let name = "Bürohaus \"Süd\" & <b>Markt</b>, Größe 1";
    let mut scene = meeting();
    scene["name"] = json!(name);
    scene["structures"][0]["sdof"]["name"] = json!("<script>塔</script>, \u{1}Süd & 'Nord'");
    scene["structures"][1]["sdof"]["name"] = json!("{a} -- %s ".repeat(9));
    let out = results("page", &scene);
    let page = text(out.join("report.html"));
    let options = roxmltree::ParsingOptions {
        allow_dtd: true,
        ..roxmltree::ParsingOptions::default()
    };
    let document = roxmltree::Document::parse_with_options(&page, options).expect("well-formed");
    let heading = document.descendants().find(|node| node.has_tag_name("h1"));
    assert_eq!(heading.and_then(|heading| heading.text()), Some(name));
    let drawings = document.descendants().filter(|node| node.has_tag_name("svg"));
    assert_eq!(drawings.count(), 4, "displacements, gaps, ground motion and the animation");
    for node in document.descendants() {
        let other = ["script", "img", "link", "iframe", "object", "a"];
        assert!(!other.contains(&node.tag_name().name()), "{:?}", node.tag_name());
        let reaching = |one: &roxmltree::Attribute<'_, '_>| ["src", "href"].contains(&one.name()) && !one.value().starts_with('#');
        assert!(!node.attributes().any(|one| reaching(&one)), "{:?}", node.tag_name());
    }
    for outside in ["http", "src=", "@import", "url(h"] {
        assert!(!page.contains(outside), "{outside}");
    }
    let header = text(out.join("history.csv"));
    let header = header.lines().next().expect("a header");
    assert_snapshot!(header, @"time_s,ground_acceleration_m_per_s2,script_script_sued_nord_displacement_m,script_script_sued_nord_velocity_m_per_s,script_script_sued_nord_absolute_acceleration_m_per_s2,script_script_sued_nord_shear_force_n,a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_displacement_m,a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_velocity_m_per_s,a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_absolute_acceleration_m_per_s2,a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_shear_force_n,script_script_sued_nord_a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_a_s_opening_m");
}

#[test]
fn extreme_long_runs_have_at_most_twenty_thousand_rows() {
    let mut scene = meeting();
    scene["duration_s"] = json!(5.0);
    scene["method"] = json!({"rk4": {"time_step_s": 1e-4}});
    let out = results("long", &scene);
    let time = numbers(&columns(out.join("history.csv")), "time_s");
    // Every third of 50 000 steps is kept.
    assert_eq!((time.len(), time[1]), (16_667, 3e-4));
}

#[test]
fn reference_the_example_is_reported_from_where_it_lies() {
    let folder = folder("example");
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let out = folder.join("out");
    let out = out.to_str().expect("a path in UTF-8");
    let ended = pounding(here, &["run", EXAMPLE, "--out", out]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    for (name, bytes) in files(&folder.join("out")) {
        let machine = env!("CARGO_MANIFEST_DIR").as_bytes();
        let found = bytes.windows(machine.len()).any(|window| window == machine);
        assert!(!found, "{name} names this machine");
    }
}
