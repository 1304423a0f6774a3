//! Required gaps: widths by rules, and floors beside columns.

use std::path::Path;

use pounding_assess::{Rule, Separation};
use pounding_scene::{ExcessKind, Scene, Simulation};

/// Floors at 3, 6.5 and 9.5 m beside floors at 3, 7, 11 and 15 m. Only the lowest floors may touch.
const STAGGERED: &str = r#"
name = "staggered"
record.generated.ricker = { amplitude_m_per_s2 = 5, frequency_hz = 1, time_step_s = 0.01 }
[[structures]]
building = { name = "a", period_s = 0.4, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3 }, { mass_kg = 2e5, height_m = 3.5 }, { mass_kg = 2e5, height_m = 3 }] }
[[structures]]
building = { name = "b", period_s = 0.7, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3 }, { mass_kg = 2e5, height_m = 4, repeat = 3 }] }
[[contacts]]
gap_m = 0.02
law.stereomechanical.restitution = 0.5
levels = [1]
"#;

fn prepared(text: &str) -> Simulation {
    let scene = Scene::parse(text.as_bytes(), Path::new("scene.toml")).expect("a scene");
    Simulation::new(&scene, "").expect("it is sound")
}

/// EC 8 took 0.7 of SRSS, and IS 1893 and TBDY took half, because the only level that may touch is level. The codes ask for equal
/// elevations of all floors of both buildings.
#[test]
fn issue_rules_for_level_floors_ask_for_all_floors() {
    let widths = |text: &str| {
        let separations = Separation::of(&prepared(text)).expect("it runs");
        let one: &Separation = &separations[0];
        let width = |rule: Rule| rule.width(one).expect("heights are given");
        let srss = width(Rule::Srss);
        let [ec8, is, tbdy] = [Rule::Eurocode8, Rule::Is1893, Rule::Tbdy2018].map(width);
        [ec8 / srss, is / width(Rule::Abs), tbdy / srss]
    };
    let [ec8, is, _] = widths(STAGGERED);
    assert!((ec8 - 1.0).abs() < 1e-15 && (is - 1.0).abs() < 1e-15);
    let level = STAGGERED.replace("height_m = 3.5", "height_m = 4");
    let level = level.replace("{ mass_kg = 2e5, height_m = 3 }] }", "{ mass_kg = 2e5, height_m = 4 }] }");
    assert_ne!(level, STAGGERED);
    let [ec8, is, _] = widths(&level);
    assert!((ec8 - 0.7).abs() < 1e-12 && (is - 0.5).abs() < 1e-12);
}

/// Without a contact, a floor beside columns was not reported.
#[test]
fn issue_columns_are_seen_without_a_contact() {
    let apart = &STAGGERED[..STAGGERED.find("[[contacts]]").expect("it is there")];
    let simulation = prepared(apart);
    let (separations, excesses) = Separation::judged(&simulation).expect("it runs");
    let beside = excesses.iter().find(|one| one.kind == ExcessKind::BesideColumn);
    let width = beside.expect("it is named").found;
    assert_eq!(separations[0].beside_columns, Some(width));
    assert!(width > 1.5 * separations[0].required, "{separations:?}");
}
