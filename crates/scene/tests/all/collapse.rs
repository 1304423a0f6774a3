//! Collapse under gravity as a result: its instant in closed form, every method, and what a run keeps until then.

use pounding_scene::{Extras, FloorQuantity, PairQuantity, RunResult, Scene, Simulation, Warning};

use crate::beside::{case, number, prepared};

/// A storey of 3 m that leans with θ = P/(k h), from rest with a velocity, without shaking; see `p-delta.json`.
struct Storey {
    mass: f64,
    /// √(k/m) without gravity \[1/s\].
    omega: f64,
    theta: f64,
    yields_at: f64,
    velocity: f64,
}

impl Storey {
    /// The storey of the case at a factor on its critical velocity.
    fn at(factor: f64) -> Self {
        let (inputs, expected) = case("p-delta.json");
        let of = |name: &str| number(&inputs, name);
        Self {
            mass: of("m_kg"),
            omega: std::f64::consts::TAU / of("T_s"),
            theta: of("theta"),
            yields_at: of("uy_m"),
            velocity: factor * number(&expected, "critical_velocity"),
        }
    }

    fn scene(&self, more: &str) -> String {
        let stiffness = self.mass * self.omega * self.omega;
        format!(
            r#"
name = "leaning"
duration_s = 12
{more}
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
structures = [{{ sdof = {{ name = "a", mass_kg = {}, stiffness_n_per_m = {stiffness:e}, damping.ratio = 0, height_m = 3,
  yield_displacement_m = {}, gravity_load_n = {:e}, initial_velocity_m_per_s = {:e} }} }}]
"#,
            self.mass,
            self.yields_at,
            self.theta * stiffness * 3.0,
            self.velocity
        )
    }

    /// Drift of the unstable equilibrium.
    fn unstable(&self) -> f64 {
        self.yields_at / self.theta
    }

    /// The instant at which the drift reaches a value beyond yielding. Before yielding it swings with ω√(1 − θ); after it moves away from
    /// the unstable equilibrium as A e^(λt) + B e^(−λt), λ = ω√θ.
    fn reaches(&self, drift: f64) -> f64 {
        let speed = self.velocity.abs();
        let (elastic, away) = (self.omega * (1.0 - self.theta).sqrt(), self.omega * self.theta.sqrt());
        let yields = libm::asin(elastic * self.yields_at / speed) / elastic;
        let rate = (speed * speed - elastic * self.yields_at * elastic * self.yields_at).sqrt();
        let start = self.yields_at - self.unstable();
        let [grows, decays] = [0.5 * (start + rate / away), 0.5 * (start - rate / away)];
        let beyond = drift - self.unstable();
        let growth = (beyond + (beyond * beyond - 4.0 * grows * decays).sqrt()) / (2.0 * grows);
        yields + libm::log(growth) / away
    }
}

fn run(text: &str) -> (Simulation, RunResult) {
    let simulation = prepared(text);
    let run = simulation.run(Some(0.01)).expect("it runs, and its ledger holds");
    (simulation, run)
}

fn close(found: f64, wanted: f64) {
    assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}");
}

/// A collapse was an error, and nothing that came before was known.
#[test]
fn issue_a_collapse_ends_the_run_as_a_result() {
    for sign in [1.0, -1.0] {
        for (ratio, more) in [(0.2, ""), (0.1, "collapse_drift_ratio = 0.1")] {
            let storey = Storey::at(1.05 * sign);
            let (simulation, run) = run(&storey.scene(more));
            let collapse = run.collapse.expect("it falls");
            assert_eq!((collapse.structure, collapse.storey), (0, 1));
            close(collapse.time_s, storey.reaches(3.0 * ratio));
            let values = run.values(&simulation);
            let of = |quantity| values.of(quantity, 0).expect("it has the number");
            close(of(FloorQuantity::UnstableS), storey.reaches(storey.unstable()));
            close(of(FloorQuantity::CollapseS), collapse.time_s);
            close(of(FloorQuantity::PeakDisplacementM), sign * 3.0 * ratio);
            let states = &run.histories.as_ref().expect("asked for").of(0).states;
            let wanted = (collapse.time_s / 0.01).floor() + 1.0;
            assert!((states.len() as f64 - wanted).abs() < 0.5, "{} {wanted}", states.len());
        }
    }
}

/// Below the critical velocity nothing falls; it passes no unstable equilibrium.
#[test]
fn limit_a_storey_that_stands_has_no_collapse() {
    let (simulation, run) = run(&Storey::at(1.0 - 1e-9).scene(""));
    assert_eq!((run.collapse, run.peaks.of(0).unstable), (None, None));
    assert_eq!(simulation.says_collapse(&run), None);
}

/// Every stepping method tends to the instant of the exact one, and its errors against the exact run are finite.
#[test]
fn order_every_method_ends_at_the_collapse() {
    let storey = Storey::at(1.05);
    for method in [
        "newmark = { beta = 0.25, gamma = 0.5, time_step_s =",
        "central_difference = { time_step_s =",
        "hht = { alpha = -0.05, time_step_s =",
        "velocity_verlet = { time_step_s =",
        "rk4 = { time_step_s =",
        "moreau_jean = { theta = 0.5, time_step_s =",
    ] {
        let off = |step: f64| {
            let simulation = prepared(&storey.scene(&format!("method.{method} {step} }}")));
            let review = simulation.review(true).expect("it runs");
            let errors = review.measured().expect("against the exact run");
            let error = errors.told(FloorQuantity::CollapseS, 0).expect("both fall");
            let (worst, of) = errors.largest(pounding_scene::QuantityGroup::All);
            assert!(worst < 0.03, "{method}: {of} is {worst} off");
            let time = review.outcome.collapse.expect("it falls").time_s;
            let found = (time / storey.reaches(0.6) - 1.0).abs();
            assert!((found - error).abs() < 1e-8, "{method}: {found} {error}");
            found
        };
        let [coarse, fine] = [4e-3, 1e-3].map(off);
        assert!(fine < 1e-3 && fine < 0.5 * coarse, "{method}: {coarse} {fine}");
    }
}

/// Two buildings that touch; one of them falls.
const ROW: &str = r#"
name = "row"
p_delta = "from_masses"
record.generated.ricker = { amplitude_m_per_s2 = 9, frequency_hz = 0.8, time_step_s = 0.01 }
structures = [
  { building = { name = "a", period_s = 0.9, damping.ratio = 0.03, storeys = [{ mass_kg = 2e5, height_m = 3, repeat = 2, yield_drift_ratio = 0.004 }] } },
  { building = { name = "b", period_s = 0.5, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3, repeat = 2 }] } },
]
contacts = [{ gap_m = 0.02, law.linear_spring.impact_stiffness_n_per_m = 1e8 }]
"#;

/// A run that collapses has the numbers of a shorter run that ends just there.
#[test]
fn limit_a_run_that_collapses_is_the_run_until_then() {
    let (simulation, fallen) = run(&format!("{ROW}duration_s = 60\n"));
    let collapse = fallen.collapse.expect("it falls");
    let stands = format!("{ROW}collapse_drift_ratio = 1\nduration_s = {:?}\n", collapse.time_s);
    let (_, shorter) = run(&stands);
    assert_eq!(shorter.collapse, None);
    assert!(fallen.collisions.all().len() == shorter.collisions.all().len() && !fallen.collisions.all().is_empty());
    let same = |one: f64, other: f64| assert!((one - other).abs() <= 1e-9 * other.abs(), "{one} {other}");
    for floor in 0..simulation.floors().all().len() {
        let [one, other] = [&fallen, &shorter].map(|run| run.peaks.of(floor));
        same(one.drift().value, other.drift().value);
        same(one.restoring_force.value, other.restoring_force.value);
        same(fallen.momentum.of(floor), shorter.momentum.of(floor));
        same(fallen.last.of(floor).displacement, shorter.last.of(floor).displacement);
    }
    let of = |run: &RunResult| run.of_pair(0).total_impulse;
    same(of(&fallen), of(&shorter));
    insta::assert_snapshot!(simulation.says_collapse(&fallen).expect("it falls"), @"a, storey 1 collapses under gravity: at t = 2.0344 s its drift passes 20 % of its height, and the run ends");
}

/// The instant beyond which gravity alone would bring a storey down is told, and so is that a neighbour may hold it.
#[test]
fn issue_the_unstable_equilibrium_is_named() {
    let said = |text: &str| {
        let review = prepared(text).review(false).expect("it runs");
        let unstable = review.warnings.iter().filter(|one| matches!(one, Warning::Unstable { .. }));
        unstable.map(ToString::to_string).collect::<Vec<_>>().join("\n")
    };
    let storey = Storey::at(1.05);
    insta::assert_snapshot!(said(&storey.scene("")), @"a passes its unstable equilibrium, a drift of 250.0 mm, at t = 0.8542 s: from there gravity alone brings it down; nothing brought it back");
    // A wall holds it.
    let held = storey.scene("contacts = [{ gap_m = 0.3, law.stereomechanical.restitution = 0.5 }]");
    let held = held.replace("} }]\n", "} }, { wall = {} }]\n");
    insta::assert_snapshot!(said(&held), @"a passes its unstable equilibrium, a drift of 250.0 mm, at t = 0.8542 s: from there gravity alone brings it down; shaking, the floors above or neighbours brought it back, or may still do so");
    // Columns that gain more than gravity takes have no unstable equilibrium.
    let hardens = storey
        .scene("")
        .replace("yield_displacement_m", "hardening_ratio = 0.1, yield_displacement_m");
    assert_eq!(said(&hardens), "");
}

#[test]
fn extreme_the_drift_of_collapse_is_checked() {
    let refused = |ratio: f64| {
        let text = Storey::at(1.0).scene(&format!("collapse_drift_ratio = {ratio:?}"));
        let scene = Scene::parse(text.as_bytes(), std::path::Path::new("scene.toml")).expect("a scene");
        Simulation::new(&scene, "").expect_err("it is refused").to_string()
    };
    insta::assert_snapshot!(refused(0.0), @r#"scene "leaning": collapse_drift_ratio: found 0, allowed a number > 0 and <= 1"#);
    insta::assert_snapshot!(refused(1.5), @r#"scene "leaning": collapse_drift_ratio: found 1.5, allowed a number > 0 and <= 1"#);
    // A storey that begins beyond it has collapsed before it moves.
    let begins = Storey::at(1.0)
        .scene("")
        .replace("initial_velocity", "initial_displacement_m = -0.7, initial_velocity");
    let scene = Scene::parse(begins.as_bytes(), std::path::Path::new("scene.toml")).expect("a scene");
    insta::assert_snapshot!(Simulation::new(&scene, "").expect_err("it is refused"), @r#"scene "leaning": structures[0].sdof.initial_displacement_m: found a drift of -0.7 m, allowed less than 0.6 m, at which the storey has collapsed under gravity; a smaller one, or a larger collapse_drift_ratio"#);
}

/// Closings and drift rates end with the run, too.
#[test]
fn limit_a_collapse_keeps_all_recordings() {
    let simulation = prepared(&format!("{ROW}duration_s = 60\n"));
    let run = simulation.run_with(Extras {
        drift_rates: true,
        ..Extras::COMPARED
    });
    let run = run.expect("it runs");
    let values = run.values(&simulation);
    assert!(run.collapse.is_some() && values.of(PairQuantity::LeastOpeningM, 0) <= Some(0.0));
    assert!(
        values
            .of(FloorQuantity::CollapseS, 0)
            .or(values.of(FloorQuantity::CollapseS, 2))
            .is_some()
    );
}
