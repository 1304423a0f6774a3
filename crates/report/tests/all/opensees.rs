//! The script for OpenSees: what OpenSees finds with it is what the exact method finds.

use std::fs;
use std::path::Path;

use pounding_scene::{RunResult, Scene, Simulation};

const EXPORTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies/opensees/exported");

/// Largest distance at a time step of 2e-5 s, relative: `BoucWen` follows its columns to first order.
const ALLOWED: [(&str, f64); 4] = [("towers", 5e-5), ("travelling", 1e-6), ("bouc-wen", 1e-4), ("links", 2e-7)];

/// Buildings that harden or yield smoothly, a wall, a motion that travels and ends before the run does, and a link of each kind.
#[test]
fn reference_opensees_follows_its_script() {
    let folder = Path::new(EXPORTED);
    let table = fs::read_to_string(folder.join("exported.csv")).expect("a table");
    for (name, allowed) in ALLOWED {
        let path = folder.join(name).with_extension("toml");
        let scene = Scene::read(&path).expect("a scene");
        let simulation = Simulation::new(&scene, folder).expect("it is valid");
        let exact = simulation.run(None).expect("it runs");
        let mut compared = 0;
        for line in table.lines().filter(|line| line.starts_with(&format!("{name},"))) {
            let cells: Vec<&str> = line.split(',').collect();
            let place: usize = cells[2].parse().expect("a number");
            let pair = || exact.of_pair(place);
            let ours = match cells[1] {
                "first" => pair().first.map(|first| first.start),
                quantity => found(&exact, quantity, place),
            };
            let theirs: Option<f64> = cells[3].parse().ok();
            assert_eq!(ours.is_some(), theirs.is_some(), "{line}");
            if let (Some(ours), Some(theirs)) = (ours, theirs) {
                assert!((ours - theirs).abs() <= allowed * ours.abs(), "{line}: {ours}");
                compared += 1;
            }
        }
        assert!(compared > 10, "{name}: {compared}");
    }
}

/// A number of a run in the words of the tables.
fn found(exact: &RunResult, quantity: &str, place: usize) -> Option<f64> {
    match quantity {
        "displacement" => Some(exact.peaks.of(place).displacement.value),
        "touches" => Some(exact.of_pair(place).collisions as f64),
        "force" => exact.of_pair(place).peak_force.map(|peak| peak.value),
        other => panic!("{other}"),
    }
}

/// A slab that hits a column, which bends: OpenSees has two half-columns of beams, and comes nearer with the square of its step.
#[test]
fn order_opensees_of_a_slab_on_a_column() {
    let folder = Path::new(EXPORTED).parent().expect("a folder");
    let table = fs::read_to_string(folder.join("slab-on-column.csv")).expect("a table");
    let scene = Scene::read(&folder.join("slab-on-column.toml")).expect("a scene");
    let exact = Simulation::new(&scene, folder).expect("it is valid").run(None).expect("it runs");
    for (step, allowed) in [("0.001,", 2e-4), ("0.0001,", 2e-6), ("2e-05,", 1e-7)] {
        let lines: Vec<_> = table.lines().filter(|line| line.starts_with(step)).collect();
        assert_eq!(lines.len(), 6, "{step}");
        for line in lines {
            let cells: Vec<&str> = line.split(',').collect();
            let ours = found(&exact, cells[1], cells[2].parse().expect("a number")).expect("it touches");
            let theirs: f64 = cells[3].parse().expect("a number");
            assert!((ours - theirs).abs() <= allowed * ours.abs(), "{line}: {ours}");
        }
    }
}
