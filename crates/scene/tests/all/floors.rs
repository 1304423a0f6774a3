//! Floors that can touch, their names, and levels that are refused.

use std::path::Path;

use pounding_scene::{Refused, Scene, Simulation};

/// Storeys of 3 m: four storeys beside two storeys beside a wall.
const ROW: &str = r#"
name = "row"
record.generated.ricker = { amplitude_m_per_s2 = 5, frequency_hz = 1, time_step_s = 0.01 }
[[structures]]
[structures.building]
name = "four"
period_s = 0.6
damping.ratio = 0.05
storeys = [{ mass_kg = 2e5, height_m = 3.0, repeat = 4 }]
[[structures]]
[structures.building]
name = "two"
period_s = 0.2
damping.ratio = 0.05
storeys = [{ mass_kg = 2e5, height_m = 3.0, repeat = 2 }]
[[structures]]
wall = {}
[[contacts]]
gap_m = 0.01
law.stereomechanical.restitution = 0.6
[[contacts]]
gap_m = 0.02
law.stereomechanical.restitution = 0.6
"#;

fn scene(levels: [Option<&[usize]>; 2]) -> Scene {
    let mut scene = Scene::parse(ROW.as_bytes(), Path::new("row.toml")).expect("a scene");
    let contacts = scene.contacts.iter_mut().flatten();
    for (contact, levels) in contacts.zip(levels) {
        contact.levels = levels.map(<[usize]>::to_vec);
    }
    scene
}

fn prepared(scene: &Scene) -> Result<Simulation, Refused> {
    Simulation::new(scene, Path::new("")).map_err(|error| {
        let mut refused = Refused::from(error);
        refused.place_mut().scene = None;
        refused
    })
}

/// Levels without a floor were accepted silently, and their pairs vanished.
#[test]
fn issue_levels_that_do_not_exist_are_refused() {
    let refused = |levels| prepared(&scene(levels)).expect_err("it is refused").to_string();
    for (levels, found) in [
        ([Some(&[9][..]), None], "contacts[0].levels[0]: found 9, allowed 1, 2:"),
        ([Some(&[1, 0]), None], "contacts[0].levels[1]: found 0, allowed 1, 2:"),
        ([Some(&[3]), None], "contacts[0].levels[0]: found 3, allowed 1, 2:"),
        ([None, Some(&[3])], "contacts[1].levels[0]: found 3, allowed 1, 2:"),
        ([Some(&[]), None], "contacts[0].levels: found none, allowed one or more of 1, 2,"),
        ([None, Some(&[])], "contacts[1].levels: found none, allowed one or more of 1, 2,"),
    ] {
        let message = refused(levels);
        assert!(message.starts_with(found), "{message}");
    }
    let prepared = prepared(&scene([Some(&[2]), Some(&[1, 2])])).expect("those exist");
    assert_eq!(prepared.floors().facing().len(), 3);
}

/// A wall beside several floors had the same name at all of them.
#[test]
fn issue_a_wall_is_named_by_its_level_where_it_faces_several() {
    let names = |levels| {
        let prepared = prepared(&scene(levels)).expect("a good scene");
        let floors = prepared.floors();
        let pairs = floors.pairs_by_contact().into_iter();
        let pairs: Vec<_> = pairs.map(|pair| floors.names(pair).join(" – ")).collect();
        pairs
    };
    let both = [
        "four, floor 1 – two, floor 1",
        "four, floor 2 – two, floor 2",
        "two, floor 1 – wall, level 1",
        "two, floor 2 – wall, level 2",
    ];
    assert_eq!(names([None, None]), both);
    assert_eq!(
        names([Some(&[2]), Some(&[2])]),
        ["four, floor 2 – two, floor 2", "two, floor 2 – wall"]
    );
}

/// Floors beside columns were refused even if `levels` left them out, and the message offered no way that keeps the geometry.
#[test]
fn issue_floors_at_unequal_heights_are_no_matter_where_they_cannot_touch() {
    // Floors of "two" at 2.5 and 6 m beside those of "four" at 3, 6, 9 and 12 m.
    let heights = |levels: Option<&[usize]>| {
        let mut scene = scene([levels, None]);
        let pounding_scene::Structure::Building(two) = &mut scene.structures[1] else {
            panic!("a building");
        };
        two.storeys[0].height_m = Some(2.5);
        two.storeys[1].height_m = Some(3.5);
        prepared(&scene)
    };
    let all = heights(None).expect("a slab hits columns");
    let names: Vec<_> = (0..all.floors().facing().len())
        .map(|pair| all.floors().names(pair).join(" – "))
        .collect();
    let wanted = [
        "four, column of storey 1 – two, floor 1",
        "four, floor 1 – two, column of storey 2",
        "four, floor 2 – two, floor 2",
    ];
    assert!(wanted.iter().all(|one| names.contains(&String::from(*one))), "{names:?}");
    let prepared = heights(Some(&[3])).expect("what is left faces a floor");
    let names: Vec<_> = (0..1).map(|pair| prepared.floors().names(pair)).collect();
    assert!(names.contains(&["two, floor 1".into(), "wall, level 1".into()]), "{names:?}");
    let facing: Vec<_> = prepared.floors().facing().iter().filter(|one| one.contact == 0).collect();
    assert_eq!(facing.len(), 1, "the roof of the lower one alone");
    let message = heights(Some(&[1])).expect_err("nothing faces it").to_string();
    assert!(message.contains("found 1, allowed 3:"), "{message}");
}

/// Gaps, heights, storeys, laws and arrivals that were wrong by a power of ten looked usual.
#[test]
fn issue_powers_of_ten_look_unusual() {
    let usual = prepared(&scene([None, None])).expect("a good scene");
    assert_eq!(usual.doubts(), []);
    for (from, to, place) in [
        ("gap_m = 0.02", "gap_m = 30", "contacts[1].gap_m"),
        ("height_m = 3.0", "height_m = 3200", "structures[0].building.storeys[0].height_m"),
        (
            "height_m = 3.0, repeat = 2",
            "repeat = 2, height_m = 3.0, yield_drift_ratio = 0.5",
            "structures[1].building.storeys[0].yield_drift_ratio",
        ),
        (
            "height_m = 3.0, repeat = 2",
            "repeat = 2, height_m = 3.0, initial_velocity_m_per_s = 30",
            "structures[1].building.storeys[0].initial_velocity_m_per_s",
        ),
        ("period_s = 0.2", "period_s = 6.7", "structures[1].building"),
        (
            "gap_m = 0.02\nlaw.stereomechanical.restitution = 0.6",
            "gap_m = 0.02\nlaw.kelvin_voigt = { impact_stiffness_n_per_m = 1e6, restitution = 0.6 }",
            "contacts[1].law.kelvin_voigt",
        ),
        ("name = \"row\"", "name = \"row\"\narrivals_s = [0, 0.1, 100]", "arrivals_s[2]"),
    ] {
        let text = ROW.replace(from, to);
        assert_ne!(text, ROW, "{from}");
        let scene = Scene::parse(text.as_bytes(), Path::new("row.toml")).expect("a scene");
        let doubts = prepared(&scene).expect("it can be modelled").doubts();
        assert!(doubts.iter().any(|doubt| doubt.place == place), "{place}: {doubts:?}");
    }
}

/// Storeys of one number were taken to be level after a mere warning.
#[test]
fn issue_floors_that_may_not_be_level_are_asked_for() {
    let of = |text: &str| prepared(&Scene::parse(text.as_bytes(), Path::new("row.toml")).expect("a scene"));
    let unknown = ROW.replace(
        "{ mass_kg = 2e5, height_m = 3.0, repeat = 2 }",
        "{ mass_kg = 2e5, height_m = 3.0 }, { mass_kg = 2e5 }",
    );
    assert_ne!(unknown, ROW);
    let message = of(&unknown).expect_err("heights decide").to_string();
    insta::assert_snapshot!(message, @r#"structures[1].building.storeys[1].height_m: found none, so that nothing tells which floors face floors, allowed is the height of every storey of the row; or write floors = "level" in the scene if storeys of one number are at one height. A floor that faces a column can bring a building down"#);
    let told = of(&format!("floors = \"level\"\n{}", unknown.trim_start())).expect("it is told");
    assert!(
        (0..1).all(|gap| told.floors().are_level(gap)) && !told.floors().are_level(1),
        "a wall is no level floor"
    );
    assert_eq!(told.doubts(), []);
    // Without contacts nothing faces anything, unless gaps are asked for.
    let (apart, _) = unknown.split_once("[[contacts]]").expect("contacts");
    assert!(of(apart).is_ok());
    let apart = Scene::parse(apart.as_bytes(), Path::new("row.toml")).expect("a scene");
    assert!(prepared(&apart.seeking_gaps()).is_err());
}

/// A warning about the third pair named `contacts[2]` in a scene with two contacts.
#[test]
fn issue_warnings_name_contacts_and_not_pairs() {
    let building = |name: &str, period: f64| {
        serde_json::json!({"building": {
            "name": name, "period_s": period, "damping": {"ratio": 0.05},
            "storeys": [{"mass_kg": 1e5, "repeat": 2}]
        }})
    };
    let contact = serde_json::json!({"gap_m": 0.0, "law": {"linear_spring": {"impact_stiffness_n_per_m": 1e11}}});
    let scene = serde_json::json!({
        "name": "three buildings of two storeys",
        "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}}},
        "duration_s": 2.0,
        "floors": "level",
        "structures": [building("a", 0.5), building("b", 0.8), building("c", 0.4)],
        "contacts": [contact, contact],
        "method": {"rk4": {"time_step_s": 0.005}}
    });
    let scene: Scene = serde_json::from_value(scene).expect("a scene");
    let simulation = Simulation::new(&scene, Path::new("")).expect("it is sound");
    let exact = simulation.exact().expect("it is sound").run(None).expect("it runs");
    let warnings = simulation.warnings_before(&exact);
    let texts: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    for pair in ["contacts[0] (a, floor 2", "contacts[1] (b, floor 2"] {
        assert!(texts.iter().any(|text| text.contains(pair)), "{pair}: {texts:#?}");
    }
    assert!(
        !texts
            .iter()
            .any(|text| text.contains("contacts[2]") || text.contains("contacts[3]")),
        "{texts:#?}"
    );
}
