//! Motions under which a storey collapses: they count, give no width, and no gap is enough.

use std::path::Path;

use pounding_assess::{Alone, AssessedRun, Assessment, RunOfCase};
use pounding_scene::{Scene, Simulation};

/// A building that leans, beside another one out of reach, under a pulse of this peak \[m/s²\]. Drifts of collapse are below those that are not
/// believed.
fn simulation(peak: f64) -> Simulation {
    let text = format!(
        r#"
name = "leaning"
p_delta = "from_masses"
collapse_drift_ratio = 0.03
record.generated.ricker = {{ amplitude_m_per_s2 = {peak}, frequency_hz = 0.8, time_step_s = 0.01 }}
structures = [
  {{ sdof = {{ name = "a", mass_kg = 4e5, period_s = 0.8, damping.ratio = 0.05, height_m = 3, yield_displacement_m = 0.02, gravity_load_n = 1.5e7 }} }},
  {{ sdof = {{ name = "b", mass_kg = 4e5, period_s = 0.4, damping.ratio = 0.05, height_m = 3 }} }},
]
contacts = [{{ gap_m = 1.0, law.stereomechanical.restitution = 0.5 }}]
"#
    );
    let scene = Scene::parse(text.as_bytes(), Path::new("scene.toml")).expect("a scene");
    Simulation::new(&scene, "").expect("it is sound")
}

/// A motion under which a storey collapsed was a failed run, and the assessment went on with the others.
#[test]
fn issue_a_collapse_counts_and_gives_no_width() {
    let runs = [0.5, 6.0].map(|peak| {
        let simulation = simulation(peak);
        let alone = Alone::of(&simulation).expect("it runs");
        AssessedRun::of(&simulation, Some(&alone), AssessedRun::STIFFNESS_FACTORS).expect("it runs")
    });
    assert_eq!(runs.each_ref().map(|run| run.collapsed), [false, true]);
    assert!(runs[0].disbelieved_alone.is_none() && runs[1].disbelieved_alone.is_some());
    let of = |runs: &[AssessedRun]| {
        let cases: Vec<_> = runs
            .iter()
            .enumerate()
            .map(|(event, run)| RunOfCase { event, neighbour: 0, run })
            .collect();
        Assessment::of(simulation(1.0).scene(), &cases)
            .expect("it fits")
            .expect("there are runs")
    };
    let both = of(&runs);
    assert_eq!((both.cases, both.collapsed, both.disbelieved_alone), (2, 1, 1));
    // The width is that of the motion without a collapse.
    let widths = [&both, &of(&runs[..1])].map(|one| one.gaps[0].required.largest());
    assert!(widths[0] > 0.0 && widths[0].to_bits() == widths[1].to_bits(), "{widths:?}");
    assert!(both.gaps[0].touching == 0, "none touches, yet the gap is not enough under all");
}
