//! A scene shaken by a record of your own: accelerations that you have in memory, not in a file.
//!
//! `cargo run --package pounding --example record` prints:
//!
//! ```text
//! record: 4.0 s, peak 2.0 m/s²
//! collisions: 6
//! first at 0.779 s with 177.9 kN·s
//! ```
#![expect(clippy::print_stdout, reason = "an example speaks to its reader")]

use pounding::motion::Record;
use pounding::scene::{GroundMotion, Scene, Simulation};

/// Two towers. A scene must name a motion: the record below takes its place, and the scale of the scene applies to it.
const SCENE: &str = r#"
    name = "two towers"
    record = { generated.ricker = { amplitude_m_per_s2 = 1.0, frequency_hz = 1.0, time_step_s = 0.01 }, scale = 1.5 }
    contacts = [{ gap_m = 0.03, law.stereomechanical.restitution = 0.65 }]
    structures = [
        { sdof = { name = "weak", mass_kg = 75e3, period_s = 1.2, damping.ratio = 0.05 } },
        { sdof = { name = "stiff", mass_kg = 3e6, period_s = 0.3, damping.ratio = 0.05 } },
    ]"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Two steps of the ground's velocity, one forth and one back: accelerations [m/s²] that are 0.01 s apart.
    let pulse = |length: usize, acceleration: f64| vec![acceleration; length];
    let samples = [pulse(50, 2.0), pulse(100, -2.0), pulse(50, 2.0), pulse(200, 0.0)].concat();
    let record = Record::new(0.01, samples, "two steps")?;
    println!("record: {:.1} s, peak {:.1} m/s²", record.duration(), record.peak().1);

    // Whatever a scene says of its record, such as scale or processing, is done to yours.
    let scene = Scene::parse(SCENE.as_bytes(), "towers.toml".as_ref())?;
    let motion = GroundMotion::of_record(&scene.record, record)?;
    let run = Simulation::shaken(&scene, motion.into())?.run(None)?;

    let pair = run.of_pair(0);
    println!("collisions: {}", pair.collisions);
    if let Some(first) = pair.first {
        println!("first at {:.3} s with {:.1} kN·s", first.start, 1e-3 * first.impulse);
    }
    Ok(())
}
