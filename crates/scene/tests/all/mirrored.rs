//! A row and its mirror under mirrored shaking respond alike.

use std::path::Path;

use pounding_scene::{Scene, Simulation};

const STUDIES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies");

/// A tower of four storeys and a wall, in this order from the left or reversed.
fn collisions(method: &str, mirrored: bool) -> Vec<usize> {
    let tower = r#"{ building = { name = "tower", period_s = 0.6, damping.ratio = 0.02, storeys = [{ mass_kg = 3e5, repeat = 4 }] } }"#;
    let wall = "{ wall = {} }";
    let row = if mirrored { [wall, tower] } else { [tower, wall] };
    let text = format!(
        r#"
        name = "tower and wall"
        record = {{ file = "records/el-centro-1940-ns-chopra.csv", scale = 2.0, reversed = {mirrored} }}
        duration_s = 20
        method.{method}
        structures = [{}, {}]
        contacts = [{{ gap_m = 0.005, law.kelvin_voigt = {{ impact_stiffness_n_per_m = 2e8, impact_damping_ratio = 0.7 }} }}]"#,
        row[0], row[1]
    );
    let scene = Scene::parse(text.as_bytes(), "row.toml".as_ref()).expect("a scene");
    let simulation = Simulation::new(&scene, Path::new(STUDIES)).expect("it is valid");
    let run = simulation.run(None).expect("it runs");
    let pairs = 0..simulation.pairs().len();
    pairs.map(|pair| run.of_pair(pair).collisions).collect()
}

/// The upper levels of a wall on the left come after the tower in the row. There a clamped force that let go for a moment began another
/// collision.
#[test]
fn issue_a_wall_on_the_left_is_touched_as_often_as_its_mirror() {
    for method in [
        "central_difference = { time_step_s = 0.0005 }",
        "velocity_verlet = { time_step_s = 0.0005 }",
        "exact = {}",
    ] {
        let [found, wanted] = [true, false].map(|mirrored| collisions(method, mirrored));
        assert!(found.len() == 4 && found.iter().all(|count| *count > 20), "{found:?}");
        assert_eq!(found, wanted, "{method}");
    }
}
