//! Required gaps: widths by rules, and floors beside columns.

use std::path::Path;

use pounding_assess::{JudgedSeparations, Rule, Separation};
use pounding_scene::{Excess, ExcessKind, Scene, Simulation};

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
    let same = |text: &str| text.replace("gap_m = 0.02", "gap_m = 0.02\nproperty = \"same\"");
    let [ec8, is, _] = widths(&same(STAGGERED));
    assert!((ec8 - 1.0).abs() < 1e-15 && (is - 1.0).abs() < 1e-15);
    let level = STAGGERED.replace("height_m = 3.5", "height_m = 4");
    let level = level.replace("{ mass_kg = 2e5, height_m = 3 }] }", "{ mass_kg = 2e5, height_m = 4 }] }");
    assert_ne!(level, STAGGERED);
    let [ec8, is, _] = widths(&same(&level));
    assert!((ec8 - 0.7).abs() < 1e-12 && (is - 0.5).abs() < 1e-12);
}

/// Without a contact, a floor beside columns was not reported. Its width was the sum of both peaks, whatever their instants.
#[test]
fn issue_columns_are_seen_without_a_contact() {
    let apart = &STAGGERED[..STAGGERED.find("[[contacts]]").expect("it is there")];
    let simulation = prepared(apart);
    let JudgedSeparations { separations, excesses, .. } = JudgedSeparations::of(&simulation).expect("it runs");
    let beside = Excess::worst(excesses).into_iter().find(|one| one.kind == ExcessKind::BesideColumn);
    let width = beside.expect("it is named").found;
    let one = separations[0];
    assert_eq!((one.beside_columns, one.at_column, one.required), (Some(width), true, width));
    assert!(width < one.peaks[0] + one.peaks[1], "{separations:?}");
}

/// A second route: the states of floors a thousandth of a second apart, and columns straight between them.
#[test]
fn reference_the_closing_of_floors_and_columns() {
    for (text, reversed) in [(STAGGERED, false), (STAGGERED, true)] {
        let apart = &text[..text.find("[[contacts]]").expect("it is there")];
        let apart = apart.replace("record.gen", &format!("record.reversed = {reversed}\nrecord.gen"));
        let simulation = prepared(&apart);
        let found = Separation::of(&simulation).expect("it runs")[0].beside_columns.expect("columns");
        let run = simulation.run(Some(1e-3)).expect("it runs");
        let histories = run.histories.expect("asked for");
        let floors = simulation.floors();
        let mut largest: f64 = 0.0;
        for one in floors.beside_all_columns() {
            let states = |floor: usize| &histories.of(floor).states;
            let side = if floors.all()[one.floor].structure == one.gap { 1.0 } else { -1.0 };
            for row in 0..states(one.floor).len() {
                let at = |floor: usize| states(floor)[row].displacement;
                let column = one.upper_part() * at(one.above) + (1.0 - one.upper_part()) * one.below.map_or(0.0, at);
                largest = largest.max(side * (at(one.floor) - column));
            }
        }
        assert!(found >= largest && found < largest + 1e-6, "{found} {largest}");
    }
}

/// Ground that travels a billionth of a second late closes gaps as ground that does not travel: its displacement cancels, that under the foot
/// of a column included. One floor faces one column, so that nothing else can decide.
#[test]
fn limit_ground_that_hardly_travels() {
    let width = |text: &str| {
        Separation::of(&prepared(text)).expect("it runs")[0]
            .beside_columns
            .expect("columns")
    };
    let building = STAGGERED.lines().find(|line| line.contains("\"a\"")).expect("it is there");
    let low = "sdof = { name = \"a\", mass_kg = 2e5, period_s = 0.4, damping.ratio = 0.05, height_m = 2 }";
    let low = STAGGERED.replace(building, low);
    let apart = &low[..low.find("[[contacts]]").expect("it is there")];
    assert_eq!(prepared(apart).floors().beside_all_columns().len(), 1);
    let travels = apart.replace("record.gen", "arrivals_s = [0, 1e-9]\nrecord.gen");
    let [at_once, late] = [apart, travels.as_str()].map(width);
    assert!((late / at_once - 1.0).abs() < 1e-5, "{at_once} {late}");
}
