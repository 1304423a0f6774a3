//! Bumpers of two slopes and backfills that yield: cases with closed forms, through scenes.

use pounding_contact::{ContactLaw, FreeImpact, FreePair, TwoSlopes};
use pounding_scene::{FloorQuantity, PairQuantity, Simulation};

use crate::beside::{case, number, prepared};

fn is_close(found: f64, wanted: f64, within: f64, what: &str) {
    assert!((found / wanted - 1.0).abs() < within, "{what}: {found} {wanted}");
}

/// A mass that flies against a wall with a bumper.
fn bumper(method: &str) -> Simulation {
    let (inputs, _) = case("bumper-densification-and-power.json");
    let of = |name: &str| number(&inputs, name);
    prepared(&format!(
        r#"
name = "bumper"
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
duration_s = 0.65
method = {method}
structures = [
  {{ sdof = {{ name = "deck", mass_kg = {}, stiffness_n_per_m = 1e-3, damping.ratio = 0, initial_velocity_m_per_s = {} }} }},
  {{ wall = {{}} }},
]
contacts = [{{ gap_m = 0, law.two_slopes = {{ impact_stiffness_n_per_m = {}, second_stiffness_n_per_m = {}, second_from_m = {} }} }}]
"#,
        of("m"),
        of("v0"),
        of("k1"),
        of("k2"),
        of("d1")
    ))
}

#[test]
fn reference_a_bumper_of_two_slopes() {
    let (inputs, expected) = case("bumper-densification-and-power.json");
    let of = |name: &str| number(&inputs, name);
    let simulation = bumper("\"exact\"");
    let run = simulation.run(None).expect("it runs");
    let values = run.values(&simulation);
    let pair = |quantity| values.of(quantity, 0).expect("they touch");
    let peak = run.peaks.of(0).displacement;
    let law = ContactLaw::TwoSlopes(TwoSlopes {
        impact_stiffness: of("k1"),
        second_stiffness: of("k2"),
        second_from: of("d1"),
    });
    let free = FreePair {
        reduced_mass: of("m"),
        approach_speed: of("v0"),
    };
    let impact = FreeImpact::of(&law, &free).expect("compliant");
    let largest = law.max_deformation(&free).expect("a closed form");
    for (found, closed, name) in [
        (peak.value, impact.max_deformation, "peak_deformation_m"),
        (peak.value, largest, "peak_deformation_m"),
        (pair(PairQuantity::PeakForceN), impact.peak_force, "peak_force_n"),
        (pair(PairQuantity::TouchingS), impact.duration, "contact_s"),
        (peak.time, 0.5 * impact.duration, "time_to_peak_s"),
    ] {
        let wanted = number(&expected, name);
        is_close(closed, wanted, 1e-13, name);
        is_close(found, wanted, 1e-9, name);
    }
    is_close(pair(PairQuantity::TotalImpulseNS), impact.impulse, 1e-9, "impulse");
}

/// A stepping method passes the bend anywhere within a step: its error falls with the square of the step.
#[test]
fn order_central_differences_over_the_bend() {
    let (_, expected) = case("bumper-densification-and-power.json");
    let wanted = number(&expected, "peak_force_n");
    let error = |step: f64| {
        let simulation = bumper(&format!("{{ central_difference = {{ time_step_s = {step} }} }}"));
        let run = simulation.run(None).expect("it runs");
        let force = run.values(&simulation).of(PairQuantity::PeakForceN, 0).expect("they touch");
        (force / wanted - 1.0).abs()
    };
    let (coarse, fine) = (error(1e-3), error(1e-4));
    assert!(fine < 2e-4 && fine < 0.05 * coarse, "{coarse} {fine}");
}

/// A backfill is a light body on columns that yield: it pushes the deck only, and leaves a gap that is wider by its plastic displacement.
#[test]
fn reference_a_backfill_that_yields_and_leaves_a_gap() {
    let (deck, speed, body, stiffness, bears, gap) = (1e6, 0.5, 1e4, 1e8, 3e6, 0.02);
    let simulation = prepared(&format!(
        r#"
name = "abutment"
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
duration_s = 1
structures = [
  {{ sdof = {{ name = "deck", mass_kg = {deck}, stiffness_n_per_m = 1e-3, damping.ratio = 0, initial_velocity_m_per_s = {speed} }} }},
  {{ sdof = {{ name = "backfill", mass_kg = {body}, stiffness_n_per_m = {stiffness}, damping.ratio = 0, yield_force_n = {bears} }} }},
]
contacts = [{{ gap_m = {gap}, law.stereomechanical.restitution = 0 }}]
"#
    ));
    let run = simulation.run(Some(0.01)).expect("it runs");
    // Both move on together, until the backfill has no force left.
    let both: f64 = deck + body;
    let together = speed * deck / both;
    let elastic = bears / stiffness;
    let plastic = (0.5 * both * together * together - 0.5 * bears * elastic) / bears;
    let histories = run.histories.as_ref().expect("asked for");
    let last = |structure: usize| histories.of(structure).states.last().expect("states");
    let moved = last(1).displacement - last(1).restoring_force / stiffness;
    is_close(moved, plastic, 1e-9, "plastic displacement");
    is_close(
        last(0).velocity,
        -elastic * (stiffness / both).sqrt(),
        1e-9,
        "speed of the deck that leaves",
    );
    let shear = run.values(&simulation).of(FloorQuantity::PeakShearForceN, 1).expect("it is pushed");
    is_close(shear, bears, 1e-12, "force of the backfill");
}
