//! Tests of output about buildings of several storeys and their results.

use std::fs;
use std::path::Path;

use pounding::report::{StructureSummary, Summary};
use pounding::scene::{FloorQuantity, PairQuantity};

use crate::runs::printed;
use crate::{folder, pounding};

const TOWERS: &str = "../../studies/examples/towers-of-storeys.toml";

/// Runs the example of two towers by a method. Returns the summary, the report and the table of histories.
fn reported(test: &str, method: &str) -> (Summary, String, csv::Reader<fs::File>) {
    let folder = folder(test);
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let scene = fs::read_to_string(here.join(TOWERS)).expect("the example is there");
    let records = here.join("../../studies/records");
    let scene = scene.replace("../records", records.to_str().expect("UTF-8"));
    fs::write(folder.join("scene.toml"), format!("{method}\n{scene}")).expect("a file");
    let ended = pounding(&folder, &["run", "scene.toml", "--json", "--out", "out"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "a good run");
    let summary = serde_json::from_str(&ended.stdout).expect("a summary");
    let file = |name: &str| folder.join("out").join(name);
    let page = fs::read_to_string(file("report.html")).expect("a report");
    let histories = csv::Reader::from_path(file("history.csv")).expect("histories");
    (summary, page, histories)
}

/// Values of a column.
fn column(histories: &mut csv::Reader<fs::File>, name: &str) -> Vec<f64> {
    let header = histories.headers().expect("a header").clone();
    let at = header.iter().position(|one| one == name);
    let at = at.unwrap_or_else(|| panic!("{name} is in {header:?}"));
    histories.seek(csv::Position::new()).expect("the beginning");
    let rows = histories.records().skip(1).map(|row| row.expect("a row"));
    rows.map(|row| row[at].parse().expect("a number")).collect()
}

/// Histories had no drifts, and residual displacements and peak accelerations were not printed. Two routes agree: the rows of the histories
/// end at the residuals and reach the peaks.
#[test]
fn issue_residuals_accelerations_and_drifts_are_those_of_the_histories() {
    let (summary, page, mut histories) = reported("building_numbers", "");
    let five = &summary.structures[2];
    assert_eq!(five.name, "five, floor 2");
    let mut of = |quantity: &str| column(&mut histories, &format!("five_floor_2_{quantity}"));
    let (displacements, drifts) = (of("displacement_m"), of("storey_drift_m"));
    let close = |found: f64, wanted: Option<f64>| {
        let wanted = wanted.expect("a number");
        assert!((found - wanted).abs() < 1e-6, "{found} {wanted}");
    };
    let last = |values: &[f64]| *values.last().expect("rows");
    close(last(&displacements), five.numbers.get(FloorQuantity::ResidualDisplacementAtEndM));
    close(last(&drifts), five.numbers.get(FloorQuantity::ResidualDriftAtEndM));
    let largest = |values: &[f64]| values.iter().map(|one| one.abs()).fold(0.0, f64::max);
    let accelerations = largest(&of("absolute_acceleration_m_per_s2"));
    let peak = five.numbers.get(FloorQuantity::PeakAccelerationMPerS2).expect("a number").abs();
    assert!(
        accelerations <= peak * (1.0 + 1e-6) && accelerations > 0.95 * peak,
        "{accelerations} {peak}"
    );
    let drift = five.numbers.get(FloorQuantity::PeakDriftM).expect("a number").abs();
    assert!((largest(&drifts) / drift - 1.0).abs() < 1e-3, "{drift}");
    for words in ["Residual at end [mm]", "Peak acceleration [g]", "Peak drift [mm]"] {
        assert!(page.contains(words), "{words}");
    }
}

/// Drifts had no errors.
#[test]
fn issue_drifts_have_errors() {
    let (exact, ..) = reported("building_exact", "");
    let method = "method.newmark = { time_step_s = 0.005, beta = 0.25, gamma = 0.5 }";
    let (run, page, _) = reported("building_errors", method);
    let drift = |one: &StructureSummary| one.numbers.get(FloorQuantity::PeakDriftM);
    let mut compared = 0;
    for (run, exact) in run.structures.iter().zip(&exact.structures) {
        let errors = run.errors.as_ref().expect("errors");
        let Some((drift, right)) = drift(run).zip(drift(exact)) else {
            assert_eq!(errors.get(FloorQuantity::PeakDriftM), None, "{}", run.name);
            continue;
        };
        let wanted = (drift / right - 1.0).abs();
        let found = errors.get(FloorQuantity::PeakDriftM).expect("an error");
        assert!((found - wanted).abs() < 1e-12, "{found} {wanted}");
        compared += 1;
    }
    assert_eq!(compared, 6, "the upper storeys");
    assert!(page.contains("<th>Peak drift [mm]</th>"), "{page}");
}

/// A peak force had the time of the first touch as its time.
#[test]
fn issue_the_peak_force_has_its_own_time() {
    let (summary, page, _) = reported("building_forces", "");
    let pair = summary.pairs.iter().find(|pair| pair.collisions() > 1);
    let pair = pair.expect("one touches more than once");
    let (first, largest) = (pair.first.expect("one"), pair.largest.expect("one"));
    let time = pair.number(PairQuantity::PeakForceTimeS).expect("a time");
    assert!(first.end_s < time, "not in the first collision: {time}");
    assert!(largest.start_s < time && time < largest.end_s, "{time}");
    assert_eq!(largest.peak_force_time_s, Some(time), "of the largest, too");
    let force = pounding::text::two_digits(pair.number(PairQuantity::PeakForceN).expect("a force") / 1e3);
    let time = pounding::text::short(time);
    let words = format!("the largest force {force} kN at {time} s");
    assert!(page.contains(&words), "{words}");
}

/// The report showed the model only as JSON, and every floor of the figure repeated the period of its building.
#[test]
fn issue_the_report_tables_the_scene_and_names_a_period_once() {
    let (_, page, _) = reported("building_scene", "");
    let (_, scene) = page.split_once("<h2>Scene</h2>").expect("a section");
    let (scene, _) = scene.split_once("<h2>").expect("the next one");
    for words in [
        "<th>Mass [t]</th>",
        "<th>Yields at [kN]</th>",
        "<td>five, floor 5</td><td>300.0</td>",
        "hardening 0.03",
        "0.05 and 0.05 in modes 1 and 3",
        "nonlinear viscoelastic",
        "<td>five – three</td><td>30</td>",
        "<td>0.6500</td>",
    ] {
        assert!(scene.contains(words), "{words}:\n{scene}");
    }
    let (_, figure) = page.split_once("<svg").expect("a figure");
    let (figure, _) = figure.split_once("</svg>").expect("its end");
    assert!(figure.matches("(T = ").count() <= 2, "once per building");
}

/// `check` printed the yield force of the first storey for all storeys.
#[test]
fn issue_check_prints_the_yield_forces_of_all_storeys() {
    let folder = folder("building_yields");
    let scene = r#"
name = "one"
record.generated.ricker = { amplitude_m_per_s2 = 2.0, frequency_hz = 1.0, time_step_s = 0.01 }
[[structures]]
[structures.building]
name = "all alike"
damping.ratio = 0.05
storeys = [{ mass_kg = 1e5, stiffness_n_per_m = 1e8, yield_force_n = 9e5, repeat = 2 }]
[[structures]]
[structures.building]
name = "weaker above"
damping.ratio = 0.05
storeys = [
  { mass_kg = 1e5, stiffness_n_per_m = 1e8, yield_force_n = 9e5 },
  { mass_kg = 1e5, stiffness_n_per_m = 1e8, yield_force_n = 4e5 },
  { mass_kg = 1e5, stiffness_n_per_m = 1e8 },
]
"#;
    fs::write(folder.join("scene.toml"), scene).expect("a file");
    let checked = pounding(&folder, &["check", "scene.toml"]);
    let yields = |name: &str| {
        let line = printed(&checked).lines().find(|line| line.starts_with(name));
        let line = line.expect("a line").trim_start_matches(name);
        let words: Vec<&str> = line.split_whitespace().skip(2).collect();
        words.join(" ")
    };
    assert_eq!(yields("all alike"), "900.0 –");
    assert_eq!(yields("weaker above"), "400.0 to 900.0, 2 of 3 –");
}
