//! Rows under motions of several intensities: each run is that of a scene that one could write by hand.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use pounding_assess::{FolderUse, IntensityMeasure, Separation, Suite, Watched};
use pounding_risk::{State, StripeRuns};
use pounding_scene::{Scene, Simulation};
use pounding_sweep::{Directions, StripeMotions, StripesAsked};
use pounding_text::Refused;
use serde_json::{Value, json};

use crate::folder;

static GOES_ON: AtomicBool = AtomicBool::new(false);

/// Three events of noise: one of two components.
fn records(folder: &Path) -> PathBuf {
    let records = folder.join("records");
    fs::create_dir_all(&records).expect("a folder");
    for (index, name) in ["a_000", "a_090", "b_000", "c_000"].into_iter().enumerate() {
        let rate = 3.0 + 1.7 * index as f64;
        let sample = |step: i32| {
            let time = 0.02 * f64::from(step);
            libm::exp(-0.4 * time) * (libm::sin(rate * time) + 0.7 * libm::sin((2.3 * rate + 1.0) * time))
        };
        let rows: Vec<String> = (0..300)
            .map(|step| format!("{:.2},{:.6}", 0.02 * f64::from(step), sample(step)))
            .collect();
        let text = format!("time_s,acceleration_m_per_s2\n{}\n", rows.join("\n"));
        fs::write(records.join(format!("{name}.csv")), text).expect("a file");
    }
    records
}

fn scene(more: &Value) -> Scene {
    let mut words = json!({
        "name": "two",
        "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}}},
        "structures": [
            {"sdof": {"name": "left", "mass_kg": 1e5, "period_s": 0.8, "damping": {"ratio": 0.05}}},
            {"sdof": {"name": "right", "mass_kg": 2e5, "period_s": 0.4, "damping": {"ratio": 0.05}}},
        ],
        "contacts": [{"gap_m": 0.03, "law": {"linear_spring": {"impact_stiffness_n_per_m": 1e8}}}],
    });
    for (name, value) in more.as_object().expect("an object") {
        words[name] = value.clone();
    }
    Scene::parse(words.to_string().as_bytes(), "two.json".as_ref()).expect("a scene")
}

fn suite(test: &str) -> Suite {
    Suite::in_folder(&records(&folder(test)), FolderUse::default()).expect("records")
}

fn run(scene: &Scene, motions: &StripeMotions, states: &[State]) -> Result<StripeRuns, Refused> {
    let asked = StripesAsked {
        scene,
        path: "two.json".as_ref(),
        motions,
        directions: Directions::Both,
        states,
        closings: true,
    };
    let watched = Watched {
        stop: &GOES_ON,
        step: &|_| {},
    };
    asked.run(watched)
}

fn scaled(suite: Suite, measure: IntensityMeasure) -> StripeMotions {
    StripeMotions::Scaled {
        suite,
        measure,
        intensities: vec![0.05, 0.2, 0.5, 1.5],
    }
}

/// A gap that is narrower than its largest closing apart is hit, and no other.
#[test]
fn limit_what_touches_apart_has_a_force_beside_each_other() {
    let motions = scaled(suite("stripes-touch"), IntensityMeasure::Sa(0.8));
    let (touch, force) = (State::Touch(None), State::Force(1e-6));
    for more in [
        json!({}),
        json!({"structures": [
            {"building": {"name": "left", "period_s": 0.9, "damping": {"ratio": 0.05}, "storeys": [
                {"mass_kg": 1e5, "height_m": 3.0, "repeat": 3, "yield_drift_ratio": 0.01}]}},
            {"building": {"name": "right", "period_s": 0.4, "damping": {"ratio": 0.05}, "storeys": [{"mass_kg": 1e5, "height_m": 3.0, "repeat": 2}]}},
        ]}),
    ] {
        let found = run(&scene(&more), &motions, &[touch, force]).expect("runs");
        assert_eq!(found.runs.len(), 4 * 2 * 4);
        let mut touching = 0;
        for run in &found.runs {
            let numbers = run.found.as_ref().expect("it runs");
            let touches = touch.is_reached(numbers, &found.gaps);
            assert_eq!(touches, force.is_reached(numbers, &found.gaps), "{run:?}");
            touching += usize::from(touches == Some(true));
        }
        assert!((4..28).contains(&touching), "{touching}");
    }
}

/// A run is that of the scene under the record times intensity over own intensity; components of a pair have one intensity.
#[test]
fn limit_a_run_is_that_of_a_scene_with_a_scale() {
    let suite = suite("stripes-scale");
    let two = scene(&json!({}));
    let found = run(&two, &scaled(suite.clone(), IntensityMeasure::Pga), &[State::Touch(None)]).expect("runs");
    let own: Vec<f64> = found.motions.iter().filter_map(|one| one.own_intensity).collect();
    assert_eq!(own[0].to_bits(), own[2].to_bits(), "both components of a");
    let peak = suite.motions[2]
        .origin()
        .file
        .values()
        .iter()
        .fold(0.0_f64, |peak, one| peak.max(one.abs()));
    assert!((own[4] * 9.80665 / peak - 1.0).abs() < 1e-12, "the peak of b");
    for run in found.runs.iter().filter(|run| !found.motions[run.motion].reversed) {
        let motion = &suite.motions[run.motion / 2];
        let mut by_hand = two.clone();
        by_hand.record.scale = found.intensities[run.stripe] / own[run.motion];
        let simulation: Simulation = motion.shake(&by_hand, false, None).expect("a simulation");
        let wanted = Separation::of(&simulation).expect("it runs")[0].required;
        let required = run.found.as_ref().expect("it runs").required[0];
        assert!((required - wanted).abs() < 1e-11, "{required} {wanted}");
    }
}

/// A row that never yields runs once for each motion. The same row with columns that could yield, but do not, runs at every intensity.
#[test]
fn limit_a_proportional_row_has_the_widths_of_every_intensity() {
    let structure = |name: &str, period: f64, more: &str| {
        let damping = json!({"ratio": 0.05});
        let mut storey = json!({"mass_kg": 1e5, "height_m": 3.0, "repeat": 2});
        if !more.is_empty() {
            storey[more] = json!(1.0);
        }
        json!({"building": {"name": name, "period_s": period, "damping": damping, "storeys": [storey]}})
    };
    let row = |more: &str| {
        scene(&json!({
            "structures": [structure("left", 0.9, more), structure("right", 0.5, "")],
            "links": [{"between": [{"structure": "left", "floor": 2}, {"structure": "right", "floor": 2}], "law": {"dashpot": {"damping_n_s_per_m": 1e5}}}],
        }))
    };
    let motions = scaled(suite("stripes-proportional"), IntensityMeasure::Pga);
    let [once, every] = ["", "yield_drift_ratio"].map(|more| run(&row(more), &motions, &[State::Touch(None)]).expect("runs"));
    assert_eq!(once.runs.len(), 4 * 2 * 4);
    for (once, every) in once.runs.iter().zip(&every.runs) {
        assert_eq!([once.motion, once.stripe], [every.motion, every.stripe]);
        let [once, every] = [once, every].map(|run| run.found.as_ref().expect("it runs").required[0]);
        assert!(every > 0.0 && (once / every - 1.0).abs() < 1e-9, "{once} {every}");
    }
}

/// Pieces of work do not depend on the number of threads.
#[test]
fn limit_the_same_bits_on_any_number_of_threads() {
    let motions = scaled(suite("stripes-threads"), IntensityMeasure::SaAverage([0.2, 1.0]));
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| run(&scene(&json!({})), &motions, &[State::Touch(None), State::Shear(1e5)]).expect("runs"))
    };
    assert_eq!(on(1), on(3));
}

/// Runs that collapse reach every state: neighbours that touch no more once a building lies flattened the fragility of touching.
#[test]
fn limit_a_collapse_is_a_state_of_its_own() {
    let leaning = scene(&json!({"structures": [
        {"sdof": {"name": "left", "mass_kg": 1e5, "period_s": 0.8, "damping": {"ratio": 0.05}, "height_m": 3.0,
            "yield_displacement_m": 0.02, "gravity_load_n": 1.5e6}},
        {"sdof": {"name": "right", "mass_kg": 2e5, "period_s": 0.4, "damping": {"ratio": 0.05}, "height_m": 3.0}},
    ], "contacts": [{"gap_m": 0.03, "law": {"linear_spring": {"impact_stiffness_n_per_m": 1e8}}}]}));
    let motions = scaled(suite("stripes-collapse"), IntensityMeasure::Sa(0.8));
    let found = run(&leaning, &motions, &[State::Touch(None), State::Drift(0.01), State::Collapse]).expect("runs");
    assert!(found.n_collapsed() > 0);
    assert_eq!(found.failed().count(), 0);
    let counted = found.stripes_of(State::Collapse);
    let first = counted.all.first().expect("a stripe");
    let last = counted.all.last().expect("a stripe");
    assert!(first.exceeding() <= 0.0 && last.exceeding() > 0.0, "{counted:?}");
    for state in [State::Touch(None), State::Drift(0.01)] {
        let all = found.stripes_of(state).all;
        assert!(
            all.iter()
                .zip(&counted.all)
                .all(|(one, fallen)| one.exceeding() >= fallen.exceeding())
        );
    }
    let wide = found.stripes_with_gaps(1e3).all;
    assert_eq!(wide, counted.all, "across a gap that nothing closes only collapses count");
}

/// Motions of their own have events of their own at each intensity, and are not scaled.
#[test]
fn limit_each_intensity_may_have_motions_of_its_own() {
    let suite = suite("stripes-own");
    let motions = StripeMotions::Own(vec![(0.1, suite.clone()), (0.3, suite)]);
    let found = run(&scene(&json!({})), &motions, &[State::Touch(None)]).expect("runs");
    assert!(!found.same_events);
    let stripes = found.stripes_of(State::Touch(None));
    let events: Vec<usize> = stripes.all.iter().flat_map(|one| &one.events).map(|one| one.event).collect();
    assert_eq!(events, [0, 1, 2, 3, 4, 5]);
    // The same motions touch as often, whatever intensity their folder is said to have.
    assert!((stripes.all[0].exceeding() - stripes.all[1].exceeding()).abs() <= 0.0);
}

#[test]
fn extreme_what_no_run_tells_is_refused() {
    let motions = scaled(suite("stripes-refused"), IntensityMeasure::Pga);
    let refused = |more: &Value, state: State| run(&scene(more), &motions, &[state]).expect_err("refused").to_string();
    let apart = json!({"contacts": null});
    let impulsive = json!({"contacts": [{"gap_m": 0.03, "law": {"stereomechanical": {"restitution": 0.6}}}]});
    assert_eq!(
        refused(&apart, State::Touch(None)),
        "contacts: found none, allowed are one or more: what stands apart does not touch"
    );
    assert_eq!(
        refused(&json!({}), State::Touch(Some(1))),
        "state: found touch=2, allowed are gaps 1 to 1"
    );
    assert_eq!(
        refused(&impulsive, State::Force(1e6)),
        "state: found a force of a law that has impulses alone, allowed is a compliant law; choose one with `pounding laws`"
    );
    assert_eq!(
        refused(&json!({}), State::Drift(0.01)),
        "state: found drift=0.01, of which no run has a number, allowed are states of this row; a drift needs height_m of storeys, a shear \
         force columns"
    );
}

/// Isolators of 0.6 m that moved 12 mm were a storey whose drift exceeds 1 %.
#[test]
fn issue_isolators_are_no_storey() {
    let row = |isolation_layer: bool| {
        scene(&json!({"structures": [
            {"building": {"name": "left", "damping": {"ratio": 0.05}, "storeys": [
                {"mass_kg": 1e5, "height_m": 0.6, "stiffness_n_per_m": 4e6, "isolation_layer": isolation_layer},
                {"mass_kg": 1e5, "height_m": 3.0, "stiffness_n_per_m": 2e8, "repeat": 2},
            ]}},
            {"sdof": {"name": "right", "mass_kg": 2e5, "period_s": 0.4, "damping": {"ratio": 0.05}}},
        ], "floors": "level", "contacts": [{"gap_m": 0.03, "levels": [1], "law": {"linear_spring": {"impact_stiffness_n_per_m": 1e8}}}]}))
    };
    let motions = scaled(suite("stripes-isolators"), IntensityMeasure::Pga);
    let drifts = |row: &Scene| {
        let found = run(row, &motions, &[State::Drift(1e-9)]).expect("runs");
        let drift = |run: &pounding_risk::StripeRun| run.found.as_ref().ok().and_then(|one| one.drift).expect("a drift");
        found.runs.iter().map(drift).collect::<Vec<f64>>()
    };
    let [isolated, storeys] = [true, false].map(|one| drifts(&row(one)));
    for (isolated, storeys) in isolated.into_iter().zip(storeys) {
        assert!(isolated > 0.0 && 5.0 * isolated < storeys, "{isolated} {storeys}");
    }
}
