//! The scenes of the paper's Tables 6 and 7 and of its text by the second route.

use std::path::Path;

use pounding_reference::{Fineness, Response};
use pounding_scene::{Scene, Simulation};
use pounding_studies::StudyFile;

fn scenes() -> Vec<(Scene, Simulation)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let of = |file: &str| {
        let study = StudyFile::read(&folder.join(file)).expect("a study").study;
        study.scenes
    };
    let scenes = ["text.json", "table-6.json", "table-7.json"].into_iter().flat_map(of);
    let prepared = |scene: Scene| {
        let prepared = Simulation::new(&scene, &folder).expect("a valid scene");
        (scene, prepared)
    };
    scenes.map(prepared).collect()
}

/// Largest relative difference of two transferred momenta.
fn difference(one: &Response, other: &Response) -> f64 {
    let pairs = one.structures.iter().zip(&other.structures);
    pairs
        .map(|(one, other)| {
            let [one, other] = [one.transferred_momentum, other.transferred_momentum];
            // A structure without hits has no momentum to divide by.
            (one - other).abs() / other.max(f64::MIN_POSITIVE)
        })
        .fold(0.0, f64::max)
}

#[test]
fn order_a_tighter_tolerance_and_other_steps_change_nothing() {
    let coarse = Fineness {
        tolerance: 1e-10,
        steps_per_sample: 3,
        ..Fineness::FINE
    };
    for (scene, prepared) in scenes() {
        let [coarse, fine] = [coarse, Fineness::FINE].map(|fineness| pounding_studies::second_route(&prepared, fineness).unwrap());
        let error = difference(&coarse, &fine);
        assert!(error < 1e-10, "{}: {error:e}", scene.name);
        for (one, other) in coarse.collisions.iter().zip(&fine.collisions) {
            assert_eq!(one.len(), other.len(), "{}: number of collisions", scene.name);
        }
    }
}

#[test]
fn limit_transferred_momentum_is_the_sum_of_impulses() {
    for (scene, prepared) in scenes() {
        let response = pounding_studies::second_route(&prepared, Fineness::FINE).unwrap();
        let impulses = |pair: usize| -> f64 { response.collisions[pair].iter().map(|collision| collision.impulse).sum() };
        let last = response.structures.len() - 1;
        for (structure, pair) in [(0, 0), (last, last - 1)] {
            let (found, sum) = (response.structures[structure].transferred_momentum, impulses(pair));
            assert!(
                (found - sum).abs() <= 1e-14 * sum,
                "{}, structure {structure}: {found} against {sum} N·s",
                scene.name
            );
        }
    }
}

#[test]
fn limit_the_yield_force_is_the_largest_restoring_force() {
    for (scene, prepared) in scenes() {
        let response = pounding_studies::second_route(&prepared, Fineness::FINE).unwrap();
        for (structure, found) in scene.structures.iter().zip(&response.structures) {
            let pounding_scene::Structure::Sdof(structure) = structure else {
                continue;
            };
            let limit = structure.yield_force_n.unwrap_or(f64::INFINITY);
            let stiff = structure.stiffness_n_per_m * found.displacement.value.abs();
            close(found.restoring_force.value.abs(), stiff.min(limit), 0.0, &scene.name);
        }
    }
}

/// Asserts that a number is within `tolerance` of the wanted one.
#[track_caller]
fn close(found: f64, wanted: f64, tolerance: f64, what: &str) {
    assert!(
        (found - wanted).abs() <= tolerance * wanted.abs(),
        "{what}: found {found}, wanted {wanted}, relative error {:e}",
        (found - wanted) / wanted
    );
}
