//! Reasons why runs must run alone, as reported by the program.

use serde_json::{Value, json};

use crate::{folder, scene, sweep, towers};

/// A scene of two elastic structures by a method.
fn elastic(method: Value) -> Value {
    let mut scene = scene();
    let left = scene["structures"][0]["sdof"].as_object_mut();
    left.expect("a table").remove("yield_displacement_m");
    scene["method"] = method;
    scene
}

/// A scene with a changed field.
fn with(mut scene: Value, place: &str, value: Value) -> Value {
    let (above, field) = place.rsplit_once('/').expect("a place");
    match field.parse::<usize>() {
        Ok(index) => scene.pointer_mut(above).expect("a list")[index] = value,
        Err(_) => scene.pointer_mut(above).expect("a table")[field] = value,
    }
    scene
}

fn stepping(name: &str) -> Value {
    json!({(name): {"time_step_s": 0.001}})
}

/// Scenes with the reported reason; `None` if they run in lanes.
fn scenes() -> [(Option<&'static str>, Value); 19] {
    let (exact, central) = (json!({"exact": {}}), stepping("central_difference"));
    let towers = towers::words(&json!({}))["scene"].take();
    let smooth = "/structures/0/sdof/bouc_wen";
    let law = "/contacts/0/law";
    let slopes = json!({"two_slopes": {"impact_stiffness_n_per_m": 1e7, "second_stiffness_n_per_m": 1e8, "second_from_m": 0.005}});
    let leaning = with(
        with(scene(), "/structures/0/sdof/height_m", json!(3.0)),
        "/structures/0/sdof/gravity_load_n",
        json!(2e5),
    );
    let linked = |law: Value| {
        let ends = json!([{"structure": 1}, {"structure": 2}]);
        with(scene(), "/links", json!([{"between": ends, "law": law}]))
    };
    let storeys = json!([{"mass_kg": 1e5, "height_m": 3.0, "repeat": 2}]);
    let frame = json!({"building": {"name": "frame", "period_s": 0.5, "damping": {"ratio": 0.05}, "storeys": storeys}});
    let slab = with(with(scene(), "/structures/0/sdof/height_m", json!(4.5)), "/structures/1", frame);
    let slab = with(slab, "/contacts/0/heights_m", json!([4.5]));
    let tangent = json!({"rayleigh": {"alpha_per_s": 0.3, "beta_s": 0.001, "stiffness": "tangent"}});
    [
        (None, scene()),
        (None, towers.clone()),
        (None, elastic(central.clone())),
        (Some("this method"), elastic(stepping("velocity_verlet"))),
        (None, elastic(exact.clone())),
        // The word "exact" had another default tolerance, with which runs run alone.
        (None, elastic(json!("exact"))),
        (Some("this method"), elastic(stepping("rk4"))),
        (
            Some("sub-steps"),
            with(scene(), "/method/central_difference/contact_substeps", json!(4)),
        ),
        (Some("1e-12"), elastic(json!({"exact": {"tolerance": 1e-14}}))),
        (
            Some("one structure after the other"),
            with(scene(), "/arrivals_s", json!([0.0, 0.1])),
        ),
        (Some("Bouc–Wen"), with(scene(), smooth, json!({"exponent": 2}))),
        (Some("two slopes"), with(elastic(exact.clone()), law, slopes.clone())),
        (None, with(scene(), law, slopes)),
        (
            Some("tangent"),
            with(with(scene(), "/method", stepping("rk4")), "/structures/0/sdof/damping", tangent),
        ),
        (Some("elastic structures"), with(scene(), "/method", exact)),
        (None, leaning),
        (
            None,
            linked(json!({"spring": {"stiffness_n_per_m": 1e6, "yield_force_n": 1e4, "damping_n_s_per_m": 1e4}})),
        ),
        (Some("restrainers"), linked(json!({"restrainer": {"stiffness_n_per_m": 1e6}}))),
        (None, slab),
    ]
}

/// Runs without a reported reason run in lanes, and only those.
#[test]
fn issue_why_runs_go_alone_is_told() {
    let folder = folder("alone_because");
    let words = |scene: Value| {
        let gaps = json!({"from": 0.005, "to": 0.02, "count": 4});
        json!({"scene": scene, "vary": [{"field": "contacts[0].gap_m", "grid": gaps}]})
    };
    let mut cases: Vec<_> = scenes().map(|(why, scene)| (why, words(scene))).into();
    let first = json!({"pairs": ["first_start_s"]});
    cases.push((Some("`first_start_s`"), with(words(scene()), "/outputs", first)));
    let most = json!({"pieces": 1_000_000_000});
    cases.push((Some("`pieces`"), with(words(scene()), "/budget", most)));
    for (why, words) in cases {
        let sweep = sweep(&folder, &words);
        let (batch, said) = (sweep.batch(0..4), sweep.alone_because());
        let failed = batch.failed;
        assert!(failed.iter().all(Option::is_none), "{why:?}: {failed:?}");
        assert_eq!(batch.beside > 0, why.is_none(), "{why:?}: {said:?}");
        let told = said.as_deref().is_some_and(|said| said.contains(why.unwrap_or("?")));
        assert_eq!(told, why.is_some(), "{why:?}: {said:?}");
    }
}
