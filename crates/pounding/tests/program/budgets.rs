//! Tests that work ends: budgets of runs, and Ctrl-C.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::{folder, good_scene, pounding, quiet, refusal};

/// Two structures with a given contact law, under a pulse that drives them together.
fn scene(law: &Value) -> Value {
    let structure =
        |name: &str, period: f64| json!({"sdof": {"name": name, "mass_kg": 1e5, "period_s": period, "damping": {"ratio": 0.05}}});
    json!({
        "name": "two",
        "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}}},
        "duration_s": 20.0,
        "structures": [structure("left", 0.5), structure("right", 0.3)],
        "contacts": [{"gap_m": 0.01, "law": law}],
    })
}

fn kelvin_voigt(impact_damping_ratio: f64) -> Value {
    json!({"kelvin_voigt": {"impact_stiffness_n_per_m": 9e7, "impact_damping_ratio": impact_damping_ratio}})
}

fn write(folder: &Path, name: &str, json: &Value) {
    fs::write(folder.join(name), json.to_string()).expect("a disk");
}

/// Starts the program, sends a signal such as Ctrl-C after a while, and returns the output if the program ends within a second.
#[cfg(unix)]
pub(crate) fn interrupted(folder: &Path, signal: &str, arguments: &[&str], ready: impl Fn() -> bool) -> Output {
    let child = Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    while !ready() {
        std::thread::sleep(Duration::from_millis(10));
    }
    std::thread::sleep(Duration::from_millis(700));
    let id = child.id().to_string();
    let sent = Command::new("kill").args([signal, &id]).status();
    assert!(sent.expect("kill is there").success(), "it runs");
    let since = Instant::now();
    let output = child.wait_with_output().expect("it ends");
    // The limit is a second on a machine with ten other tasks.
    assert!(since.elapsed() < Duration::from_secs(10), "{:?}", since.elapsed());
    output
}

/// Ctrl-C waited for runs that had begun: a sweep with one value of 1e12 had to be killed.
#[cfg(unix)]
#[test]
fn issue_a_sweep_ends_though_a_run_of_it_does_not() {
    let folder = folder("budgets_sweep");
    write(
        &folder,
        "sweep.json",
        &json!({
            "scene": scene(&kelvin_voigt(0.1)),
            "vary": [{"field": "contacts[0].law.kelvin_voigt.impact_damping_ratio", "values": [1e9, 0.1]}],
            "budget": {"pieces": 1e30},
        }),
    );
    let parts = folder.join("sweep.json.csv.parts");
    let ended = interrupted(&folder, "-INT", &["sweep", "sweep.json"], || parts.exists());
    let said = String::from_utf8_lossy(&ended.stderr);
    assert_eq!(ended.status.code(), Some(1), "{said}");
    assert!(said.starts_with("error: stopped: "), "{said}");
    assert!(!parts.join("part-000000000.csv").exists(), "it was not finished");
}

/// Ctrl-C waited for the runs of a folder of records. A single run ends with its process.
#[cfg(unix)]
#[test]
fn issue_runs_end_though_one_of_them_does_not() {
    let folder = folder("budgets_runs");
    let mut endless = scene(&kelvin_voigt(1e9));
    endless["budget"] = json!({"pieces": 1e30});
    write(&folder, "scene.json", &endless);
    let records = folder.join("records");
    fs::create_dir_all(&records).expect("a disk");
    let line = |index: i32| format!("{},{}\n", f64::from(index) / 100.0, 4 * (index % 20));
    let pulse = (0..40).map(line).collect::<Vec<_>>().concat();
    fs::write(records.join("one.csv"), format!("time_s,acceleration_m_per_s2\n{pulse}")).expect("a disk");
    // A single run has no handler of Ctrl-C. It ignores the signal if a background script started the tests.
    for (signal, arguments) in [
        ("-INT", &["run", "scene.json", "--records", "records"][..]),
        ("-TERM", &["run", "scene.json"]),
        ("-TERM", &["check", "scene.json"]),
        ("-TERM", &["advise", "scene.json"]),
    ] {
        let ended = interrupted(&folder, signal, arguments, || true);
        assert!(!ended.status.success(), "{arguments:?}");
    }
}

/// A row that exceeded its budget stopped all others.
#[test]
fn issue_a_row_over_its_budget_fails_and_the_others_go_on() {
    let folder = folder("budgets_rows");
    write(
        &folder,
        "sweep.json",
        &json!({
            "scene": scene(&kelvin_voigt(0.1)),
            "vary": [{"field": "contacts[0].law.kelvin_voigt.impact_damping_ratio", "values": [0.1, 1e4, 1e12, 0.2]}],
            "budget": {"pieces": 5000},
        }),
    );
    let ended = pounding(&folder, &["sweep", "sweep.json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let table = fs::read_to_string(folder.join("sweep.json.csv")).expect("a table");
    let failed = table.lines().skip(1).map(|row| row.rsplit(',').next().unwrap_or_default());
    let failed: Vec<_> = failed.map(|reason| !reason.is_empty()).collect();
    assert_eq!(failed, [false, true, true, false], "{table}");
    assert!(table.contains("`budget.pieces`"), "{table}");
}

/// A thousand sub-steps were not counted: such a run used 5.8 GB.
#[test]
fn issue_sub_steps_count_among_the_steps() {
    let folder = folder("budgets_substeps");
    let mut scene = scene(&json!({"stereomechanical": {"restitution": 0.0}}));
    scene["method"] = json!({"central_difference": {
        "time_step_s": 1e-5, "contact_substeps": 1000,
    }});
    write(&folder, "scene.json", &scene);
    let refused = refusal(&pounding(&folder, &["run", "scene.json"]));
    let wanted = ["with 1000 sub-steps in contact", "allowed 1e8 (`budget.steps`)"];
    assert!(wanted.iter().all(|words| refused.contains(words)), "{refused}");
    scene["method"]["central_difference"]["time_step_s"] = json!(1e-3);
    scene["budget"] = json!({"steps": 1e8});
    write(&folder, "scene.json", &scene);
    let ended = pounding(&folder, &["run", "scene.json", "--no-error"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
}

/// `check` of a mass near the largest number did not end.
#[test]
fn issue_masses_near_the_largest_number_end() {
    let folder = folder("budgets_mass");
    fs::write(folder.join("record.csv"), quiet(40)).expect("a disk");
    for structure in [0, 1] {
        let mut scene = good_scene();
        scene["structures"][structure]["sdof"]["mass_kg"] = json!(1.7e308);
        scene["structures"][1 - structure]["sdof"]["initial_velocity_m_per_s"] = json!(0.3);
        scene["duration_s"] = json!(2.0);
        write(&folder, "scene.json", &scene);
        let ended = pounding(&folder, &["check", "scene.json"]);
        assert!(ended.code < 2, "{}", ended.stderr);
    }
}

#[test]
fn extreme_budgets_of_nothing_are_refused() {
    let folder = folder("budgets_nothing");
    for (budget, wanted) in [
        (json!({"pieces": 0}), "budget.pieces: found 0"),
        (json!({"steps": 1e10}), "budget.steps: found 10000000000"),
        (json!({"seconds": -1}), "budget.seconds: found -1"),
        (json!({"events": 3}), "budget"),
        (
            json!({"seconds": 1e-9}),
            "budget.seconds: found 0.000000001, which was over before the run began",
        ),
    ] {
        let mut scene = scene(&kelvin_voigt(1e3));
        scene["budget"] = budget;
        write(&folder, "scene.json", &scene);
        let refused = refusal(&pounding(&folder, &["run", "scene.json"]));
        assert!(refused.contains(wanted), "{refused}");
    }
}

/// The program waited for a pipe that nobody filled, and read an endless device, as a scene or sweep.
#[cfg(unix)]
#[test]
fn issue_what_is_no_file_is_refused_at_once() {
    let folder = folder("budgets_files");
    let made = Command::new("mkfifo").arg(folder.join("pipe.json")).status();
    assert!(made.expect("mkfifo is there").success());
    let mut messages = Vec::new();
    for file in ["pipe.json", "/dev/zero"] {
        for command in ["run", "check", "sweep"] {
            messages.push(refusal(&pounding(&folder, &[command, file])));
        }
    }
    assert!(
        messages.iter().all(|message| message.contains("it is a pipe or a device")),
        "{messages:?}"
    );
}
