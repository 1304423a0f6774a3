//! Floors that leave their seats count as cases.

use std::path::Path;

use pounding_assess::{Alone, AssessedRun, Assessment, RunOfCase};
use pounding_scene::{Scene, Simulation};

/// Two decks under a pulse of this peak \[m/s²\], with this seat.
fn simulation(peak: f64, seat: &str) -> Simulation {
    let text = format!(
        r#"
name = "decks"
record.generated.ricker = {{ amplitude_m_per_s2 = {peak}, frequency_hz = 0.8, time_step_s = 0.01 }}
structures = [
  {{ sdof = {{ name = "a", mass_kg = 4e5, period_s = 0.8, damping.ratio = 0.05 }} }},
  {{ sdof = {{ name = "b", mass_kg = 4e5, period_s = 1.6, damping.ratio = 0.05 }} }},
]
contacts = [{{ gap_m = 1.0{seat}, law.stereomechanical.restitution = 0.5 }}]
"#
    );
    let scene = Scene::parse(text.as_bytes(), Path::new("scene.toml")).expect("a scene");
    Simulation::new(&scene, "").expect("it is sound")
}

/// The number of cases in which the decks are unseated is known only with a seat, though they never touch.
#[test]
fn issue_unseated_decks_are_counted() {
    let unseated = |seat: &str| {
        let runs = [0.1, 4.0].map(|peak| {
            let simulation = simulation(peak, seat);
            let alone = Alone::of(&simulation).expect("it runs");
            AssessedRun::of(&simulation, Some(&alone), AssessedRun::STIFFNESS_FACTORS).expect("it runs")
        });
        let cases: Vec<_> = runs
            .iter()
            .enumerate()
            .map(|(event, run)| RunOfCase { event, neighbour: 0, run })
            .collect();
        let assessment = Assessment::of(simulation(1.0, seat).scene(), &cases);
        let assessment = assessment.expect("it fits").expect("there are runs");
        assert_eq!(assessment.pairs[0].touching, 0);
        (runs.map(|run| run.pairs[0].unseated.is_some()), assessment.pairs[0].unseated)
    };
    assert_eq!(unseated(", seat_width_m = 0.1"), ([false, true], Some(1)));
    assert_eq!(unseated(", seat_width_m = 10"), ([false, false], Some(0)));
    assert_eq!(unseated(""), ([false, false], None));
}
