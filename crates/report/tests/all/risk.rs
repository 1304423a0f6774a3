//! Answers about states of a row under motions of several intensities.

use std::path::Path;

use pounding_report::{RiskAsked, RiskReport};
use pounding_risk::{HazardCurve, RunNumbers, State, StripeMotion, StripeRun, StripeRuns};
use pounding_scene::Scene;
use pounding_text::Form;
use serde_json::Value;

const SCENE: &str = r#"
name = "row"
record.generated.ricker = { amplitude_m_per_s2 = 3, frequency_hz = 1, time_step_s = 0.01 }
structures = [
  { sdof = { name = "a", mass_kg = 1e5, period_s = 1.0, damping.ratio = 0.05 } },
  { sdof = { name = "b", mass_kg = 3e5, period_s = 0.5, damping.ratio = 0.05 } },
]
[[contacts]]
gap_m = 0.05
law.linear_spring.impact_stiffness_n_per_m = 1e8
"#;

const INTENSITIES: [f64; 9] = [0.05, 0.08, 0.12, 0.2, 0.3, 0.5, 0.8, 1.2, 2.0];

/// Runs of events that touch from these intensities on.
fn runs(from: &[f64]) -> StripeRuns {
    let motion = |event: usize| StripeMotion {
        name: format!("event{event}"),
        reversed: false,
        event,
        own_intensity: None,
    };
    let run = |(motion, from): (usize, &f64), stripe: usize| StripeRun {
        motion,
        stripe,
        found: Ok(RunNumbers {
            required: vec![if INTENSITIES[stripe] >= *from { 0.06 } else { 0.01 }],
            ..RunNumbers::default()
        }),
    };
    let all = from
        .iter()
        .enumerate()
        .flat_map(|one| (0..INTENSITIES.len()).map(move |stripe| run(one, stripe)));
    StripeRuns {
        gaps: vec![0.05],
        intensities: INTENSITIES.to_vec(),
        motions: (0..from.len()).map(motion).collect(),
        runs: all.collect(),
        same_events: true,
    }
}

/// The answer for people, its lines joined, and that for programs.
fn answered(from: &[f64]) -> (String, Value) {
    let scene = Scene::parse(SCENE.as_bytes(), Path::new("scene.toml")).expect("a good scene");
    // H = 1e-4 x⁻².
    let hazard = HazardCurve::of(vec![[0.01, 1.0], [10.0, 1e-6]]).expect("a curve");
    let runs = runs(from);
    let asked = RiskAsked {
        states: &[State::Touch(None)],
        gaps: &[],
        hazard: Some(&hazard),
        measure: None,
    };
    let report = RiskReport::of(&scene, Vec::new(), &runs, asked);
    let text = report.answer().text(Form::Brief);
    let json = report.answer().text(Form::Json);
    (
        text.split_whitespace().collect::<Vec<_>>().join(" "),
        serde_json::from_str(&json).expect("JSON"),
    )
}

/// Half of the events touch from 0.12 g on, the others from 1.2 g on: no lognormal has such a plateau, and its frequency went out without a word.
#[test]
fn issue_a_fragility_that_misses_the_shares_is_named() {
    let from: Vec<f64> = (0..20).map(|event| if event < 10 { 0.12 } else { 1.2 }).collect();
    let (text, json) = answered(&from);
    assert!(text.contains("the lognormal fragility of touch misses the share at"), "{text}");
    assert!(text.contains(" 10 of 20 events (95 %: 30 % to 70 %) against "), "{text}");
    // λ of the shares by hand: 0 to 1/2 from 0.08 to 0.12 g, 1/2 to 1 from 0.8 to 1.2 g; each line gives 1/2 (H − H')/(2 ln 1.5).
    let line = |a: f64, b: f64| 0.5 * 1e-4 * (1.0 / (a * a) - 1.0 / (b * b)) / (2.0 * libm::log(b / a));
    let wanted = line(0.08, 0.12) + line(0.8, 1.2);
    let found = json["states"][0]["annual_frequency_of_shares_per_year"].as_f64().expect("a number");
    assert!((found / wanted - 1.0).abs() < 1e-12, "{found} {wanted}");
    let years = format!("once in {:.0} years", wanted.recip());
    assert!(
        text.contains(&format!("the shares of events alone, joined by lines, give {years}")),
        "{text}"
    );
}

/// Events at the quantiles of a lognormal are what the fragility says, to the step of one event.
#[test]
fn limit_lognormal_shares_have_no_caution() {
    let quantiles = [
        -1.96, -1.44, -1.15, -0.93, -0.76, -0.6, -0.45, -0.32, -0.19, -0.06, 0.06, 0.19, 0.32, 0.45, 0.6, 0.76, 0.93, 1.15, 1.44, 1.96,
    ];
    let (text, json) = answered(&quantiles.map(|z: f64| 0.3 * libm::exp(0.6 * z)));
    assert!(!text.contains("misses") && !text.contains("shares of events alone"), "{text}");
    let number = |name: &str| json["states"][0][name].as_f64().expect(name);
    assert!((number("median_g") / 0.3 - 1.0).abs() < 0.1, "{json}");
    assert!(number("annual_frequency_of_shares_per_year") > 0.0, "{json}");
}

/// "Once in 290 years" stood alone where three events gave no bounds.
#[test]
fn issue_few_events_are_told_with_the_fragility() {
    let (text, _) = answered(&[0.12, 0.3, 1.2]);
    assert!(text.contains("; 3 events give it no bounds"), "{text}");
}
