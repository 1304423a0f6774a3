//! Largest openings of gaps, and floors that leave their seats.

use pounding_scene::{Extras, PairQuantity, RunResult, Scene, Simulation, Warning};

use crate::beside::prepared;

/// Two undamped structures without shaking, which start with opposite velocities: u = ∓v/ω sin ωt.
const V: f64 = 0.2;

fn scene(periods: [f64; 2], contact: &str, more: &str) -> String {
    let [left, right] = periods;
    format!(
        r#"
name = "apart"
duration_s = 2.5
{more}
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
structures = [
  {{ sdof = {{ name = "a", mass_kg = 1e5, period_s = {left}, damping.ratio = 0, initial_velocity_m_per_s = -{V} }} }},
  {{ sdof = {{ name = "b", mass_kg = 2e5, period_s = {right}, damping.ratio = 0, initial_velocity_m_per_s = {V} }} }},
]
contacts = [{{ {contact}, law.stereomechanical.restitution = 0.5 }}]
"#
    )
}

fn run(text: &str) -> (Simulation, RunResult) {
    let simulation = prepared(text);
    let run = simulation.run_with(Extras::COMPARED).expect("it runs");
    (simulation, run)
}

fn number(text: &str, quantity: PairQuantity) -> Option<f64> {
    let (simulation, run) = run(text);
    run.values(&simulation).of(quantity, 0)
}

/// Of equal periods the opening is gap + 2v/ω sin ωt: largest after a quarter of the period, and beyond a seat of d at asin(dω/2v)/ω.
#[test]
fn reference_the_opening_of_free_vibration() {
    let (omega, seat) = (std::f64::consts::TAU / 0.8, 0.03);
    let text = scene([0.8, 0.8], &format!("gap_m = 0.2, seat_width_m = {seat}"), "").replace("duration_s = 2.5", "duration_s = 0.8");
    let close = |quantity, wanted: f64| {
        let found = number(&text, quantity).expect("it has the number");
        assert!((found / wanted - 1.0).abs() < 1e-11, "{quantity:?}: {found} {wanted}");
    };
    close(PairQuantity::LargestOpeningM, 0.2 + 2.0 * V / omega);
    close(PairQuantity::UnseatedS, libm::asin(0.5 * seat * omega / V) / omega);
    // The least opening is as far below the gap, half a period later: the run ends before it opens again.
    close(PairQuantity::LeastOpeningM, 0.2 - 2.0 * V / omega);
    // At the peak the instant is known to the root of its rounding.
    let time = number(&text, PairQuantity::LargestOpeningTimeS).expect("it opens");
    assert!((time - 0.2).abs() < 1e-6, "{time}");
    let wide = text.replace("seat_width_m = 0.03", "seat_width_m = 0.06");
    assert_eq!(number(&wide, PairQuantity::UnseatedS), None);
    let none = text.replace(", seat_width_m = 0.03", "");
    assert_eq!(number(&none, PairQuantity::UnseatedS), None);
}

/// Of different periods, by half a million looks at v/ω₁ sin ω₁t + v/ω₂ sin ω₂t.
#[test]
fn reference_the_opening_of_different_periods() {
    let omegas = [0.83, 0.61].map(|period| std::f64::consts::TAU / period);
    let away = |t: f64| omegas.iter().map(|omega| V / omega * libm::sin(omega * t)).sum::<f64>();
    let looks = |end: f64| (0..500_000).map(move |look| end * f64::from(look) / 500_000.0);
    let seat = 0.04;
    let text = scene([0.83, 0.61], &format!("gap_m = 0.2, seat_width_m = {seat}"), "");
    let largest = looks(2.5).map(away).fold(0.0, f64::max);
    let found = number(&text, PairQuantity::LargestOpeningM).expect("it opens") - 0.2;
    assert!((found - largest).abs() < 1e-9, "{found} {largest}");
    let first = looks(2.5).find(|t| away(*t) > seat).expect("it leaves the seat");
    let found = number(&text, PairQuantity::UnseatedS).expect("it leaves the seat");
    assert!((first - 5e-6..=first).contains(&found), "{found} {first}");
}

/// Mirroring a row changes nothing: the right floor moves away from the left one as far.
#[test]
fn limit_a_mirrored_row_opens_as_far() {
    let contact = "gap_m = 0.01, seat_width_m = 0.02";
    let text = |more: &str| scene([0.8, 0.5], contact, more).replace("amplitude_m_per_s2 = 0,", "amplitude_m_per_s2 = 3,");
    let mirrored = text("").replace("amplitude_m_per_s2 = 3", "amplitude_m_per_s2 = -3");
    let [a, b] = ["  { sdof = { name = \"a\"", "  { sdof = { name = \"b\""].map(|start| {
        let from = mirrored.find(start).expect("it is there");
        let line = &mirrored[from..];
        &line[..line.find('\n').expect("a line")]
    });
    // The velocities have opposite signs, so that a change of places mirrors them.
    let turn = |line: &str, velocity: &str| {
        line.replace(
            &format!("{velocity}{V}"),
            &format!("{}{V}", if velocity == "= -" { "= " } else { "= -" }),
        )
    };
    let turned = mirrored.replace(&format!("{a}\n{b}"), &format!("{}\n{}", turn(b, "= "), turn(a, "= -")));
    assert_ne!(turned, mirrored);
    for quantity in [PairQuantity::LargestOpeningM, PairQuantity::UnseatedS] {
        let [one, other] = [text(""), turned.clone()].map(|text| number(&text, quantity).expect("it has the number"));
        assert!((one / other - 1.0).abs() < 1e-12, "{quantity:?}: {one} {other}");
    }
}

/// Every stepping method tends to the exact openings, while floors touch and after.
#[test]
fn order_every_method_finds_the_openings() {
    let of = |method: &str| {
        let text =
            scene([0.8, 0.5], "gap_m = 0.01, seat_width_m = 0.02", method).replace("amplitude_m_per_s2 = 0,", "amplitude_m_per_s2 = 3,");
        [PairQuantity::LargestOpeningM, PairQuantity::UnseatedS].map(|quantity| number(&text, quantity).expect("it has the number"))
    };
    let exact = of("");
    for method in [
        "newmark = { beta = 0.25, gamma = 0.5, time_step_s =",
        "central_difference = { time_step_s =",
        "velocity_verlet = { time_step_s =",
        "rk4 = { time_step_s =",
    ] {
        let off = |step: f64| {
            let found = of(&format!("method.{method} {step} }}"));
            found
                .iter()
                .zip(exact)
                .map(|(found, exact)| (found / exact - 1.0).abs())
                .fold(0.0, f64::max)
        };
        let [coarse, fine] = [2e-3, 2.5e-4].map(off);
        assert!(fine < 2e-3 && fine < 0.5 * coarse, "{method}: {coarse} {fine}");
    }
}

/// Grounds that move apart unseat floors, too: states a thousandth of a second apart, over the grounds.
#[test]
fn reference_grounds_that_move_apart() {
    let text = scene([0.8, 0.5], "gap_m = 0.5, seat_width_m = 0.05", "arrivals_s = [0, 0.15]");
    let text = text.replace(
        "half_sine = { amplitude_m_per_s2 = 0, duration_s = 0.4,",
        "ricker = { amplitude_m_per_s2 = 6, frequency_hz = 0.7,",
    );
    let (simulation, run) = run(&text);
    let values = run.values(&simulation);
    let histories = simulation.run(Some(1e-3)).expect("it runs").histories.expect("asked for");
    let travel = simulation.travel().expect("it travels");
    let away = |row: usize| {
        let [left, right] = [0, 1].map(|node| histories.of(node).states[row].displacement);
        right - left - travel.opening([0, 1], 1e-3 * row as f64).displacement
    };
    let rows = 0..histories.of(0).states.len();
    let largest = rows.clone().map(away).fold(0.0, f64::max);
    let found = values.of(PairQuantity::LargestOpeningM, 0).expect("it opens") - 0.5;
    assert!(found >= largest && found - largest < 1e-5, "{found} {largest}");
    let first = rows.clone().find(|row| away(*row) > 0.05).expect("it leaves the seat");
    let found = values.of(PairQuantity::UnseatedS, 0).expect("it leaves the seat");
    assert!(
        (1e-3 * (first as f64 - 1.0)..=1e-3 * first as f64).contains(&found),
        "{found} {first}"
    );
}

#[test]
fn issue_a_floor_that_leaves_its_seat_is_named() {
    let text = scene([0.8, 0.8], "gap_m = 0.2, seat_width_m = 0.03", "");
    let review = prepared(&text).review(false).expect("it runs");
    let unseated: Vec<&Warning> = review
        .warnings
        .iter()
        .filter(|one| matches!(one, Warning::Unseated { .. }))
        .collect();
    insta::assert_snapshot!(unseated[0], @"contacts[0] (a – b): unseated at t = 0.0802 s, where b has moved 30.00 mm away from a, the width of its seat: it may fall, which the model leaves out");
    let narrow = text.replace("seat_width_m = 0.03", "seat_width_m = 0");
    let scene = Scene::parse(narrow.as_bytes(), std::path::Path::new("scene.toml")).expect("a scene");
    insta::assert_snapshot!(Simulation::new(&scene, "").expect_err("it is refused"), @r#"scene "apart": contacts[0].seat_width_m: found 0, allowed a finite number > 0"#);
}
