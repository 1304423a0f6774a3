//! The lean model of a scene equals the full one, bit for bit, on random scenes.

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName};
use pounding_scene::file::RunBudget;
use pounding_scene::{
    Capacities, Contact, Damping, FileUse, Method, Property, RecordUse, RunResult, Scene, Sdof, Simulation, Source, Structure,
};
use proptest::prelude::*;

/// Structures with and without optional properties.
fn structure() -> impl Strategy<Value = Sdof> {
    let yields = prop_oneof![
        3 => Just(None),
        // Never reached, seldom reached, reached at once.
        1 => Just(Some(1e3)),
        1 => (0.01..0.2_f64).prop_map(Some),
        1 => (1e-4..0.01_f64).prop_map(Some),
    ];
    (4.0..7.0_f64, 0.15..2.0_f64, 0.0..0.2_f64, yields, -0.5..0.5_f64).prop_map(|(mass, period, ratio, yields, velocity)| {
        let mass = libm::pow(10.0, mass);
        let omega = 2.0 * std::f64::consts::PI / period;
        let stiffness = mass * omega * omega;
        Sdof {
            name: String::new(),
            mass_kg: mass,
            stiffness_n_per_m: stiffness,
            damping: Damping::Ratio(ratio),
            hardening_ratio: None,
            bouc_wen: None,
            yield_force_n: yields.map(|displacement| displacement * stiffness),
            height_m: None,
            capacities: Capacities::default(),
            initial_displacement_m: 0.0,
            initial_velocity_m_per_s: velocity,
        }
    })
}

fn law() -> impl Strategy<Value = ContactLaw> {
    (0..LawName::ALL.len(), 0.1..1.0_f64).prop_map(|(index, restitution)| {
        let name = LawName::ALL[index];
        let stiffness = match name.stiffness_unit() {
            Some("N/m") => 1e8,
            _ => 1e9,
        };
        let pair = FreePair {
            reduced_mass: 1e5,
            approach_speed: 0.3,
        };
        let law = |e: f64| name.calibrated(stiffness, e, Calibration::Exact, &pair);
        // Springs without damping deliver only e = 1.
        law(restitution).or_else(|_| law(1.0)).expect("an e in its range")
    })
}

/// Gaps that are closed, seldom closed, or never.
fn contact() -> impl Strategy<Value = Contact> {
    let gap = prop_oneof![Just(0.0), 0.001..0.1_f64, Just(10.0)];
    (gap, law()).prop_map(|(gap_m, law)| Contact {
        gap_m,
        law,
        levels: None,
        heights_m: None,
        seat_width_m: None,
        column_shape: pounding_scene::ColumnShape::Fixed,
        property: Property::Other,
    })
}

fn method() -> impl Strategy<Value = Method> {
    let text = prop_oneof![
        2 => Just(r#"{"exact": {}}"#),
        1 => Just(r#"{"central_difference": {"time_step_s": 0.001}}"#),
        1 => Just(r#"{"central_difference": {"time_step_s": 0.001, "contact_substeps": 3}}"#),
        1 => Just(r#"{"newmark": {"time_step_s": 0.001, "beta": 0.25, "gamma": 0.5}}"#),
        1 => Just(r#"{"hht": {"time_step_s": 0.001, "alpha": -0.1}}"#),
        1 => Just(r#"{"velocity_verlet": {"time_step_s": 0.001, "impacts": "located"}}"#),
        1 => Just(r#"{"rk4": {"time_step_s": 0.001}}"#),
        1 => Just(r#"{"moreau_jean": {"time_step_s": 0.001, "theta": 0.5}}"#),
    ];
    text.prop_map(|text| serde_json::from_str(text).expect("a method"))
}

/// One to five structures, with or without a wall at either end, with or without contacts.
fn scene() -> impl Strategy<Value = (Scene, Vec<f64>)> {
    let row = prop::collection::vec(structure(), 1..=5);
    let contacts = prop::option::weighted(0.8, prop::collection::vec(contact(), 6));
    let ground = prop::collection::vec(-6.0..6.0_f64, 40..80);
    let walls = (any::<bool>(), any::<bool>());
    (row, walls, contacts, ground, method()).prop_map(|(row, walls, contacts, ground, method)| {
        let mut structures = Vec::new();
        structures.extend(walls.0.then_some(Structure::Wall));
        for (index, sdof) in row.into_iter().enumerate() {
            let name = format!("s{index}");
            structures.push(Structure::Sdof(Sdof { name, ..sdof }));
        }
        structures.extend(walls.1.then_some(Structure::Wall));
        let contacts = contacts.map(|mut contacts| {
            contacts.truncate(structures.len() - 1);
            contacts
        });
        let record = RecordUse::of(Source::File(FileUse::default()));
        let scene = Scene {
            name: "random".into(),
            record,
            duration_s: Some(1.5),
            structures,
            contacts,
            neighbour: None,
            p_delta: None,
            collapse_drift_ratio: None,
            links: Vec::new(),
            arrivals_s: None,
            floors: None,
            method,
            budget: RunBudget::default(),
            seeks_gaps: false,
        };
        (scene, ground)
    })
}

/// All numbers of a run to the last bit: the shortest digits that restore them, and the sign of zeros.
fn bits(outcome: &RunResult) -> String {
    let RunResult {
        peaks,
        collisions,
        momentum,
        accelerations,
        last,
        closings,
        drift_rates,
        histories,
        collapse,
        links,
        link_energies,
        work: _,
    } = outcome;
    format!(
        "{peaks:?} {:?} {momentum:?} {accelerations:?} {last:?} {closings:?} {drift_rates:?} {histories:?} {collapse:?} {links:?} {link_energies:?}",
        collisions.all()
    )
}

/// The record of a scene, as the text of a file.
fn record(ground: &[f64]) -> pounding_motion::Accelerogram {
    let line = |(index, value): (usize, &f64)| format!("{},{value:?}\n", index as f64 / 50.0);
    let lines: String = ground.iter().enumerate().map(line).collect();
    let text = format!("time_s,acceleration_m_per_s2\n{lines}");
    pounding_motion::read(text.as_bytes()).expect("a record")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn limit_the_lean_model_equals_the_full_one((scene, ground) in scene()) {
        let lean = Simulation::with_record(&scene, record(&ground)).expect("a good scene");
        let full = lean.clone().full().expect("a good scene");
        // Histories are recorded for the comparison; they change nothing else.
        match (lean.run(Some(0.01)), full.run(Some(0.01))) {
            (Ok(a), Ok(b)) => {
                prop_assert_eq!(bits(&a), bits(&b));
                let mut without = lean.run(None).expect("it ran");
                prop_assert!(without.histories.is_none());
                without.histories = a.histories.clone();
                prop_assert_eq!(bits(&a), bits(&without));
            }
            // A scene that breaks a law of mechanics or diverges does so in both models.
            (a, b) => prop_assert_eq!(
                a.err().map(|error| error.to_string()),
                b.err().map(|error| error.to_string())
            ),
        }
    }
}
