//! Both routes against a solution with 36 digits, `studies/digits/towers.csv`, which `towers.py` makes.

use std::path::Path;

use pounding_reference::Fineness;
use pounding_scene::{Scene, Simulation};

/// Largest distance of a start \[s\], and of an impulse relative to the largest \[–\].
const CLOSE: f64 = 1e-13;

#[test]
fn reference_both_routes_have_the_impacts_of_36_digits() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies/digits");
    let scene = std::fs::read(folder.join("towers.json")).expect("a scene");
    let scene: Scene = serde_json::from_slice(&scene).expect("a scene");
    let simulation = Simulation::new(&scene, folder.as_path()).expect("a valid scene");
    let mut table = csv::Reader::from_path(folder.join("towers.csv")).expect("a table");
    let wanted: Vec<(f64, f64)> = table.deserialize().collect::<Result<_, _>>().expect("times and impulses");
    assert_eq!(wanted.len(), 211);
    let exact = simulation.run(None).expect("an exact run");
    let exact = exact.collisions.all().iter();
    let exact: Vec<_> = exact.map(|one| (one.start, one.impulse)).collect();
    let second = pounding_studies::second_route(&simulation, Fineness::FINE).expect("a run");
    let second = second.collisions[0].iter();
    let second: Vec<_> = second.map(|one| (one.start, one.impulse)).collect();
    let largest = wanted.iter().map(|one| one.1).fold(0.0, f64::max);
    for (route, found) in [("exact", exact), ("second", second)] {
        for &(start, impulse) in &wanted {
            let apart = |one: &&(f64, f64)| (one.0 - start).abs();
            let near = found.iter();
            let near = near.min_by(|one, other| apart(one).total_cmp(&apart(other)));
            let near = near.expect("a touch");
            assert!(apart(&near) < CLOSE, "{route}: {start} s, found {near:?}");
            let off = (near.1 - impulse).abs() / largest;
            assert!(off < CLOSE, "{route}: {impulse} N·s, found {near:?}");
        }
    }
}
