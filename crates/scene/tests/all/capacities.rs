//! Capacities of storeys, isolation layers, gravity, and damping that no building has.

use std::path::Path;

use pounding_scene::{Excess, ExcessKind, Extras, FloorQuantity, Implausible, Refused, Scene, Simulation};

/// A building on isolators, pulled aside and let go: 150 mm at the base slab, and a little more above. `LOWEST` and `UPPER` stand for more
/// fields of the storeys.
const ISOLATED: &str = r#"
name = "isolated"
record.generated.half_sine = { amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }
duration_s = 4
[[structures]]
wall = {}
[[structures]]
[structures.building]
name = "hospital"
damping.rayleigh = { alpha_per_s = 0, beta_s = 1e-3 }
storeys = [
  { mass_kg = 3.5e5, stiffness_n_per_m = 9.8e7, yield_force_n = 8.4e5, hardening_ratio = 0.1, height_m = 0.5, initial_displacement_m = 0.15 LOWEST },
  { mass_kg = 3e5, stiffness_n_per_m = 6e8, height_m = 3.2, initial_displacement_m = 0.153 UPPER },
  { mass_kg = 3e5, stiffness_n_per_m = 6e8, height_m = 3.2, initial_displacement_m = 0.154 },
]
"#;

fn with(lowest: &str, upper: &str) -> String {
    ISOLATED.replace("LOWEST", lowest).replace("UPPER", upper)
}

fn read(text: &str) -> Result<Simulation, Refused> {
    let scene = Scene::parse(text.as_bytes(), Path::new("scene.toml")).map_err(Refused::from)?;
    Simulation::new(&scene, "").map_err(Refused::from)
}

fn judged(text: &str) -> (Simulation, Vec<Excess>) {
    let simulation = read(text).expect("a sound scene");
    let asked = Extras {
        drift_rates: true,
        ..Extras::default()
    };
    let result = simulation.run_with(asked).expect("it runs");
    let excesses = simulation.excesses(&result);
    (simulation, excesses)
}

fn kinds(excesses: &[Excess]) -> Vec<ExcessKind> {
    excesses.iter().map(|one| one.kind).collect()
}

/// Isolators were judged as columns: 36 % drift, a ductility of 21, gravity that "would bring the storey down".
#[test]
fn issue_isolators_are_no_columns() {
    let of_columns = [
        ExcessKind::Stability,
        ExcessKind::Drift,
        ExcessKind::Ductility,
        ExcessKind::ResidualDrift,
    ];
    let (untold, excesses) = judged(&with("", ""));
    let found = kinds(&excesses);
    assert!(of_columns[..3].iter().all(|kind| found.contains(kind)), "{excesses:?}");
    let asked = untold.doubts().into_iter().filter(Implausible::is_of_row);
    let asked: Vec<String> = asked.map(|one| one.to_string()).collect();
    insta::assert_snapshot!(asked.join("\n"), @"structures[1].building.storeys[0]: found a storey 6.1 times softer than the next, with a period of 2 s under the building, judged as columns, usual is `isolator`, or `isolation_layer = true`, if it stands for isolators, `isolation_layer = false` if it does not");
    let (told, excesses) = judged(&with(", isolation_layer = true", ""));
    assert!(!kinds(&excesses).iter().any(|kind| of_columns.contains(kind)), "{excesses:?}");
    assert!(!told.doubts().iter().any(Implausible::is_of_row));
    // Another soft storey is one of columns, and nobody asks again.
    let (soft, excesses) = judged(&with(", isolation_layer = false", ""));
    assert!(!soft.doubts().iter().any(Implausible::is_of_row));
    assert_eq!(kinds(&excesses), found);
    for (text, place) in [
        (with("", ", isolation_layer = true"), "storeys[1].isolation_layer"),
        (with(", isolation_layer = true, repeat = 2", ""), "storeys[0].isolation_layer"),
    ] {
        let refused = read(&text).expect_err("isolators are below the building").to_string();
        assert!(refused.contains(place), "{refused}");
    }
}

/// "Stability above 0.25: gravity would bring the storey down": the limit is one of design, and 1 − PΔ/(V h) of the strength is left.
#[test]
fn issue_the_limit_of_stability_is_no_collapse() {
    let said = |found: f64| {
        let excess = Excess {
            kind: ExcessKind::Stability,
            floor: 0,
            name: "tower, floor 1".into(),
            found,
            capacity: None,
            often: None,
        };
        excess.to_string()
    };
    insta::assert_snapshot!(said(0.15), @"tower, floor 1: stability coefficient P Δ/(V h) = 0.1500, above 0.1 (EN 1998-1:2004, 4.4.2.2): gravity, which the model leaves out, adds to the drift, and leaves 85 % of the strength where the storey yields");
    insta::assert_snapshot!(said(0.36), @"tower, floor 1: stability coefficient P Δ/(V h) = 0.3600, above the design limit of 0.25 (ASCE 7-16, 12.8.7), which is no collapse: gravity, which the model leaves out, leaves 64 % of the strength where the storey yields; a run with gravity is needed");
    insta::assert_snapshot!(said(2.17), @"tower, floor 1: stability coefficient P Δ/(V h) = 2.170, above the design limit of 0.25 (ASCE 7-16, 12.8.7): at this drift gravity, which the model leaves out, asks for at least the whole shear force of the storey, so that nothing is left against shaking; the drifts of this run cannot be relied on, and a run with gravity is needed");
}

/// A mass let go from a displacement: of 24 mm it drifts 0.8 % of its height, with 2.4 MN.
fn let_go(fields: &str) -> String {
    format!(
        r#"
name = "let go"
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
duration_s = 2
structures = [
  {{ sdof = {{ name = "shop", mass_kg = 5e5, stiffness_n_per_m = 1e8, damping.ratio = 0, height_m = 3, initial_displacement_m = 0.024{fields} }} }},
]
"#
    )
}

/// Masonry and non-ductile frames fail at 0.4 to 1 %, and 2.5 % was the limit of every building.
#[test]
fn issue_capacities_replace_the_limits_of_ductile_construction() {
    let said = |fields: &str| {
        let (_, excesses) = judged(&let_go(fields));
        let said: Vec<String> = excesses.iter().map(ToString::to_string).collect();
        said.join("\n")
    };
    insta::assert_snapshot!(said(", drift_capacity_ratio = 0.01, shear_capacity_n = 3e6"), @"");
    insta::assert_snapshot!(said(", drift_capacity_ratio = 0.004, shear_capacity_n = 2e6"), @r"
    shop: drift of 0.80 % of the height, above its capacity of 0.40 %: columns that lose strength, which the model leaves out, decide
    shop: shear force of 2400 kN, above its capacity of 2000 kN: it fails before it does what the model says
    ");
    // With a capacity of drift the ductility is not judged besides.
    insta::assert_snapshot!(said(", yield_displacement_m = 0.003, drift_capacity_ratio = 0.01"), @r"
    shop: stability coefficient P Δ/(V h) = 0.1308, above 0.1 (EN 1998-1:2004, 4.4.2.2): gravity, which the model leaves out, adds to the drift, and leaves 87 % of the strength where the storey yields
    shop: drift of 0.60 % of the height left at the end, above 0.5 % (McCormick et al. 2008): realignment likely; the value depends on the model of yielding
    ");
    let (simulation, excesses) = judged(&let_go(", shear_capacity_n = 3e6"));
    assert_eq!(excesses, []);
    insta::assert_snapshot!(Excess::says_assumed(simulation.floors(), |_| 0.024).expect("a drift that masonry does not bear"), @"drifts of up to 0.80 % of the height are judged by 2.5 %, the limit of ductile construction, which is assumed; masonry and non-ductile frames fail at 0.4 to 1 % (drift_capacity_ratio)");
    assert_eq!(Excess::says_assumed(simulation.floors(), |_| 0.01), None);
    let none = let_go(", drift_capacity_ratio = 0.01").replace("height_m = 3, ", "");
    for (text, said) in [
        (
            none,
            "drift_capacity_ratio: found 0.01, allowed a capacity of a storey with height_m",
        ),
        (let_go(", shear_capacity_n = 0"), "shear_capacity_n: found 0, allowed"),
    ] {
        let refused = read(&text).expect_err("no capacity").to_string();
        assert!(refused.contains(said), "{refused}");
    }
}

/// An elastic frame with a base shear of 0.55 of its weight had "Warnings none".
#[test]
fn issue_elastic_frames_that_bear_half_their_weight_sideways_are_warned_of() {
    let (_, excesses) = judged(&let_go(""));
    // 2.4 MN over 500 t.
    let [one] = &excesses[..] else { panic!("{excesses:?}") };
    assert!((one.found / (2.4e6 / (5e5 * 9.80665)) - 1.0).abs() < 1e-9, "{one:?}");
    insta::assert_snapshot!(one, @"shop: shear force of 0.49 times the weight above, more than 0.4: few structures are that strong (yield_force_n, shear_capacity_n)");
    assert_eq!(judged(&let_go("").replace("0.024", "0.018")).1, []);
}

/// The force of a damper is its coefficient times the drift rate: ω u₀ in free vibration with little damping. Stepping methods agree.
#[test]
fn reference_the_force_of_a_damper() {
    let text = let_go(", yield_force_n = 2.5e6").replace("damping.ratio = 0", "damping.ratio = 1e-6");
    for method in ["", "method.central_difference.time_step_s = 1e-4"] {
        let simulation = read(&text.replace("duration_s = 2", &format!("duration_s = 2\n{method}"))).expect("a sound scene");
        let review = simulation.review(false).expect("it runs");
        let values = review.outcome.values(&simulation);
        let found = values.of(FloorQuantity::DamperForceRatio, 0).expect("columns that can yield");
        let (omega, stiffness) = ((1e8_f64 / 5e5).sqrt(), 1e8);
        let coefficient = 2e-6 * stiffness / omega;
        let wanted = coefficient * omega * 0.024 / 2.5e6;
        assert!((found / wanted - 1.0).abs() < 1e-5, "{method} {found} {wanted}");
    }
}

/// A dashpot to the ground halved the blows of an isolated building, and nothing warned of it.
#[test]
fn issue_dashpots_to_the_ground_hold_isolators() {
    let told = with(", isolation_layer = true", "");
    let natural = told.replace("damping.rayleigh = { alpha_per_s = 0, beta_s = 1e-3 }", "damping.ratio = 0.05");
    let of = |text: &str| {
        let (simulation, excesses) = judged(text);
        let result = simulation.run(None).expect("it runs");
        let mass = simulation.mass_damping(&result, 1);
        (mass, excesses.into_iter().find(|one| one.kind == ExcessKind::MassDamping))
    };
    assert_eq!(of(&told), (None, None));
    let (mass, excess) = of(&natural);
    let (mass, excess) = (mass.expect("a mass term"), excess.expect("isolators"));
    assert!((mass.ratio - excess.found).abs() < 1e-15);
    insta::assert_snapshot!(excess, @"hospital: the mass term of its damping is 10 % of critical at the period of the peak drifts, above 1 %: dashpots between the floors and the ground, which no building on isolators has, hold it back and lessen its blows; give damping.rayleigh with alpha_per_s = 0");
    // Damping of the mass alone is that of the first mode while nothing yields.
    let elastic = natural
        .replace("damping.ratio = 0.05", "damping.rayleigh = { alpha_per_s = 0.2, beta_s = 0 }")
        .replace("yield_force_n = 8.4e5, hardening_ratio = 0.1, ", "");
    let (simulation, _) = judged(&elastic);
    let result = simulation.run(None).expect("it runs");
    let mass = simulation.mass_damping(&result, 1).expect("a mass term");
    let (period, ratio) = simulation.floors().all()[1].oscillation(simulation.scene()).expect("a building");
    assert!(
        (mass.period_s / period - 1.0).abs() < 1e-12 && (mass.ratio / ratio - 1.0).abs() < 1e-12,
        "{mass:?}"
    );
}

/// An isolated building beside another needed a storey of 0.5 mm: without a height of its isolators no floor had one.
#[test]
fn issue_isolators_need_no_height() {
    let beside = with(", isolation_layer = true", "")
        .replace("height_m = 0.5, ", "")
        .replace("wall = {}", r#"building = { name = "school", period_s = 0.3, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3.2, repeat = 2 }] }"#);
    let beside = format!("{beside}[[contacts]]\ngap_m = 0.1\nlaw.hertz.impact_stiffness_n_per_m1_5 = 2e9\n");
    let (simulation, excesses) = judged(&beside);
    let floors = simulation.floors();
    let pairs: Vec<String> = (0..floors.facing().len()).map(|pair| floors.names(pair).join(" – ")).collect();
    assert_eq!(
        pairs,
        ["school, floor 1 – hospital, floor 2", "school, floor 2 – hospital, floor 3"]
    );
    let foot = excesses
        .iter()
        .find(|one| one.kind == ExcessKind::AtFoot)
        .expect("a base slab that moves 150 mm");
    insta::assert_snapshot!(foot, @"hospital, floor 1: its base slab at the ground faces the foot of its neighbour, where no contact is modelled; it moves up to 50.00 mm farther than the gap");
    // Without the word nothing tells where the floor is.
    assert!(read(&beside.replace(", isolation_layer = true", "")).is_err());
}
