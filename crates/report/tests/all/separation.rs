//! The width that gaps need, and the rules for it.

use std::path::Path;

use pounding_assess::{Rule, Separation};
use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_report::PairSummary;
use pounding_scene::{Contact, PairQuantity, Property, Scene, Simulation, Structure};

/// Structures of other periods, one of which yields, beside a wall, under three seconds of random shaking.
const SCENE: &str = r#"
name = "row"
record.generated.stochastic = { ground = "medium", pga_m_per_s2 = 4, strong_from_s = 1, strong_until_s = 4, decay_per_s = 0.8, duration_s = 8, time_step_s = 0.02, cutoff_hz = 20, seed = 3 }
structures = [
  { sdof = { name = "a", mass_kg = 1e5, period_s = 1.0, damping.ratio = 0.05 } },
  { sdof = { name = "b", mass_kg = 3e5, period_s = 0.5, damping.ratio = 0.02, yield_displacement_m = 0.01 } },
  { sdof = { name = "c", mass_kg = 2e5, period_s = 0.3, damping.ratio = 0.05 } },
  "wall",
]
"#;

fn scene() -> Scene {
    Scene::parse(SCENE.as_bytes(), Path::new("scene.toml")).expect("a good scene")
}

fn prepared(scene: &Scene) -> Simulation {
    Simulation::new(scene, Path::new("")).expect("a good scene")
}

/// Whether a pair touches, with a gap there and the others out of reach.
fn touches(scene: &Scene, pair: usize, gap: f64) -> bool {
    let contact = |index| Contact {
        gap_m: if index == pair { gap } else { 10.0 },
        law: ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.5 }),
        levels: None,
        heights_m: None,
        seat_width_m: None,
        column_shape: pounding_scene::ColumnShape::Fixed,
        property: Property::default(),
    };
    let mut scene = scene.clone();
    scene.contacts = Some((0..scene.structures.len() - 1).map(contact).collect());
    let outcome = prepared(&scene).run(None).expect("it runs");
    !outcome.collisions.all().is_empty()
}

/// A second route: runs with gaps of about that width.
#[test]
fn limit_the_width_is_where_touching_begins() {
    for reversed in [false, true] {
        let mut scene = scene();
        scene.record.reversed = reversed;
        let separations = Separation::of(&prepared(&scene)).expect("it runs");
        hold(&scene, &separations);
    }
}

/// A gap a millionth narrower than each of three widths closes, one a millionth wider does not.
fn hold(scene: &Scene, separations: &[Separation]) {
    assert_eq!(separations.len(), 3, "a gap between all neighbours");
    for one in separations {
        assert!(one.required > 0.0, "{one:?}");
        let narrow = touches(scene, one.left, one.required * (1.0 - 1e-6));
        let wide = touches(scene, one.left, one.required * (1.0 + 1e-6));
        assert!(narrow && !wide, "{one:?}: {narrow} {wide}");
    }
}

/// The least opening of a gap was that of the rows of the history, which overstated what stays open.
#[test]
fn issue_what_stays_open_is_no_sample() {
    let mut scene = scene();
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.5 });
    scene.contacts = Some(vec![
        Contact {
            gap_m: 0.5,
            law,
            levels: None,
            heights_m: None,
            seat_width_m: None,
            column_shape: pounding_scene::ColumnShape::Fixed,
            property: Property::default(),
        };
        3
    ]);
    let separations = Separation::of(&prepared(&scene)).expect("it runs");
    for method in [
        r#"{"exact": {}}"#,
        r#"{"rk4": {"time_step_s": 0.01}}"#,
        r#"{"newmark": {"time_step_s": 0.01, "beta": 0.25, "gamma": 0.5}}"#,
    ] {
        scene.method = serde_json::from_str(method).expect("a method");
        let prepared = prepared(&scene);
        let review = prepared.review(false).expect("it runs");
        let pairs = PairSummary::of_run(&prepared, &review);
        let outcome = prepared.run(Some(0.01)).expect("it runs");
        let histories = outcome.histories.expect("asked for");
        for (pair, separation) in pairs.iter().zip(&separations) {
            let opening = pair.least_opening();
            let [left, right] = [0, 1].map(|side| &histories.of(separation.left + side).states);
            let rows = left.iter().zip(right);
            let least = rows
                .map(|(left, right)| 0.5 - left.displacement + right.displacement)
                .fold(f64::INFINITY, f64::min);
            assert!(opening <= least, "{method}: {opening} {least}");
            // By another run, another recorder and, for stepping methods, to their error.
            let wanted = 0.5 - separation.required;
            let allowed = if method.contains("exact") { 1e-9 } else { 1e-3 };
            assert!((opening - wanted).abs() < allowed, "{method}: {opening} {wanted}");
            let instant = pair.number(PairQuantity::LeastOpeningTimeS).expect("a time") - separation.time;
            assert!(instant.abs() < 0.02, "{method}: {instant}");
        }
    }
}

/// Gaps, laws and method of the scene do not matter.
#[test]
fn limit_the_width_is_that_of_structures_alone() {
    let scene = scene();
    let mut touching = scene.clone();
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 1.0 });
    touching.contacts = Some(vec![
        Contact {
            gap_m: 0.001,
            law,
            levels: None,
            heights_m: None,
            seat_width_m: None,
            column_shape: pounding_scene::ColumnShape::Fixed,
            property: Property::default(),
        };
        3
    ]);
    touching.method = serde_json::from_str(r#"{"rk4": {"time_step_s": 0.02}}"#).expect("a method");
    touching.duration_s = Some(10.0);
    let mut alone = scene;
    alone.duration_s = Some(10.0);
    let [a, b] = [&alone, &touching].map(|scene| Separation::of(&prepared(scene)).expect("it runs"));
    assert_eq!(a, b);
}

#[test]
fn limit_rules_for_like_neighbours_and_walls() {
    let scene = scene();
    let mut twins = scene.clone();
    let twin = |name: &str| {
        let Structure::Sdof(sdof) = &scene.structures[0] else {
            panic!("no wall")
        };
        let mut sdof = sdof.clone();
        sdof.name = name.into();
        Structure::Sdof(sdof)
    };
    twins.structures = vec![twin("one"), twin("other")];
    let found = Separation::of(&prepared(&twins)).expect("it runs")[0];
    assert!(found.required.abs() < 1e-300, "twins move alike: {}", found.required);
    let ddc = Rule::Ddc.width(&found).expect("a width");
    assert!(ddc < 1e-7 * Rule::Abs.width(&found).expect("a width"), "{ddc}");
    let beside_wall = Separation::of(&prepared(&scene)).expect("it runs")[2];
    for rule in Rule::COMMON {
        let width = rule.width(&beside_wall).expect("a width");
        assert!((width / beside_wall.peaks[0] - 1.0).abs() < 1e-15, "{rule:?}");
    }
    // A single mass does not tell whether the floors of its building are level.
    for (heights, share) in [((Some(9.0), Some(9.0)), 1.0), ((Some(9.0), Some(8.0)), 1.0), ((None, None), 1.0)] {
        let mut scene = scene.clone();
        for (structure, height) in scene.structures.iter_mut().zip([heights.0, heights.1]) {
            if let Structure::Sdof(sdof) = structure {
                sdof.height_m = height;
            }
        }
        let found = Separation {
            property: Property::Same,
            ..Separation::of(&prepared(&scene)).expect("it runs")[0]
        };
        let found = Rule::Eurocode8.width(&found).expect("a width") / Rule::Srss.width(&found).expect("a width");
        assert!((found - share).abs() < 1e-15, "{heights:?}: {found}");
    }
}

/// ρ by hand for T₁/T₂ = 2, ζ₁ = 2 % and ζ₂ = 10 %, term by term of the formula.
#[test]
fn reference_correlation_of_the_double_difference_combination() {
    let found = Separation::of(&prepared(&scene())).expect("it runs")[0];
    let mut pair = found;
    pair.peaks = [1.0, 1.0];
    pair.oscillations = [Some((1.0, 0.02)), Some((0.5, 0.10))];
    // 8 √(ζ₁ζ₂) (ζ₁ + rζ₂) r^1.5 over (1 − r²)² + 4ζ₁ζ₂r(1 + r²) + 4(ζ₁² + ζ₂²)r².
    let above = 8.0 * 0.002_f64.sqrt() * 0.22 * 8.0_f64.sqrt();
    let below = 9.0 + 4.0 * 0.002 * 2.0 * 5.0 + 4.0 * 0.0104 * 4.0;
    let rho = above / below;
    let width = Rule::Ddc.width(&pair).expect("a width");
    assert!((width * width - (2.0 - 2.0 * rho)).abs() < 1e-14, "{width} {rho}");
    // The same from the other side.
    pair.oscillations.reverse();
    let mirrored = Rule::Ddc.width(&pair).expect("a width");
    assert!((mirrored - width).abs() < 1e-14, "{mirrored} {width}");
}

/// Bases that move apart need wider gaps; a wall moves with its own.
#[test]
fn limit_the_width_where_the_motion_travels() {
    let mut scene = scene();
    scene.arrivals_s = Some(vec![0.0, 0.11, 0.2, 0.33]);
    let separations = Separation::of(&prepared(&scene)).expect("it runs");
    hold(&scene, &separations);
}

/// How far 0.1 s of delay moves bases apart under the records of the paper, against the ground's displacement integrated
/// once more, sample by sample.
#[test]
fn reference_openings_of_a_tenth_of_a_second() {
    let file = "../../studies/examples/two-structures.json";
    let text = std::fs::read(file).expect("the example");
    let mut found = Vec::new();
    for record in ["peer-pacific-engineering", "chopra"] {
        let text = String::from_utf8_lossy(&text).replace("peer-pacific-engineering", record);
        let mut scene: Scene = Scene::parse(text.as_bytes(), Path::new("scene.json")).expect("a scene");
        scene.arrivals_s = Some(vec![0.0, 0.1]);
        let folder = Path::new("../../studies/examples");
        let prepared = Simulation::new(&scene, folder).expect("a good scene");
        let [opening] = prepared.openings()[..] else {
            panic!("one pair of neighbours");
        };
        let record = prepared.record();
        let h = record.time_step();
        let delay = (0.1 / h).round();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small whole number")]
        let behind = delay as usize;
        assert!((delay * h - 0.1).abs() < 1e-12, "whole samples");
        let (mut ground, mut velocity) = (vec![0.0], 0.0);
        for pair in record.samples().windows(2) {
            let last = ground[ground.len() - 1];
            ground.push(last + h * velocity + h * h * (2.0 * pair[0] + pair[1]) / 6.0);
            velocity += 0.5 * h * (pair[0] + pair[1]);
        }
        let apart = (behind..ground.len()).map(|index| ground[index] - ground[index - behind]);
        let largest = apart.fold(0.0_f64, |most, one| most.max(one.abs()));
        // Between samples it may be a little more.
        let excess = opening.distance.abs() / largest - 1.0;
        assert!((-1e-12..1e-3).contains(&excess), "{opening:?} {largest}");
        found.push(format!("{:.2} mm at {:.2} s", 1e3 * opening.distance, opening.time));
    }
    insta::assert_snapshot!(found.join("; "), @"27.43 mm at 4.45 s; 35.13 mm at 1.64 s");
}

#[test]
fn issue_a_wall_beside_storeys_is_as_far_as_their_roof_goes() {
    let text = br#"
        name = "tower beside a wall"
        duration_s = 5
        [record.generated.harmonic]
        amplitude_m_per_s2 = 2
        frequency_hz = 2
        duration_s = 5
        time_step_s = 0.01
        [[structures]]
        [structures.building]
        name = "tower"
        period_s = 0.5
        damping.ratio = 0.05
        storeys = [{ mass_kg = 2e5, repeat = 3 }]
        [[structures]]
        wall = {}
        [[contacts]]
        gap_m = 0.01
        law.stereomechanical.restitution = 0.6
    "#;
    let mut scene = Scene::parse(text, Path::new("scene.toml")).expect("a scene");
    let all = Separation::of(&prepared(&scene)).expect("it runs")[0];
    let contact = &mut scene.contacts.as_mut().expect("one")[0];
    contact.levels = Some(vec![1]);
    let lowest = Separation::of(&prepared(&scene)).expect("it runs")[0];
    scene.contacts = None;
    assert_eq!(Separation::of(&prepared(&scene)).expect("it runs")[0], all);
    let apart = prepared(&scene).run(None).expect("it runs");
    let peak = |floor: usize| apart.peaks.of(floor).displacement.value.abs();
    let floors = prepared(&scene).floors().of_structure(0).to_vec();
    assert!((all.peaks[0] - peak(floors[2])).abs() < 1e-12, "{all:?}");
    assert!((lowest.peaks[0] - peak(floors[0])).abs() < 1e-12, "{lowest:?}");
    assert!(all.required > 2.0 * lowest.required, "{all:?} {lowest:?}");
}
