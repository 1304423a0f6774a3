//! A sweep: one scene with many gaps and two restitutions, as columns in memory.
//!
//! `cargo run --package pounding --example sweep` prints:
//!
//! ```text
//! gap    collisions  impulse, kN·s (restitution 0.4 and 0.8)
//! 10 mm  32 and 7    140.0 and 280.4
//! 30 mm  3 and 5     136.2 and 279.2
//! 50 mm  3 and 4     138.5 and 280.5
//! 70 mm  1 and 2     90.9 and 175.6
//! ```
#![expect(clippy::print_stdout, reason = "an example speaks to its reader")]

use pounding::sweep::{Sweep, SweepFile};

/// The text of a sweep file: the numbers to keep, the values to try, and the scene. Every combination of values is a run.
const FILE: &str = r#"
    outputs = { structures = [], pairs = ["collisions", "total_impulse_n_s"] }
    vary = [
        { field = "contacts[0].gap_m", values = [0.01, 0.03, 0.05, 0.07] },
        { field = "contacts[0].law.stereomechanical.restitution", values = [0.4, 0.8] },
    ]
    [scene]
    name = "two towers"
    record.generated.ricker = { amplitude_m_per_s2 = 3.0, frequency_hz = 1.0, time_step_s = 0.01 }
    contacts = [{ gap_m = 0.03, law.stereomechanical.restitution = 0.65 }]
    structures = [
        { sdof = { name = "weak", mass_kg = 75e3, period_s = 1.2, damping.ratio = 0.05 } },
        { sdof = { name = "stiff", mass_kg = 3e6, period_s = 0.3, damping.ratio = 0.05 } },
    ]"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = "sweep.toml".as_ref();
    let file = SweepFile::parse(FILE.as_bytes(), path)?;
    let sweep = Sweep::of(&file, FILE.as_bytes(), path, None)?;

    // Runs are numbered. Any range of them is a batch, so machines can share a sweep; here one batch has all.
    let batch = sweep.batch(0..sweep.n_runs());
    let [collisions, impulses] = [&batch.columns[0], &batch.columns[1]];

    // The field that is named last varies fastest.
    println!("gap    collisions  impulse, kN·s (restitution 0.4 and 0.8)");
    for (run, gap) in ["10 mm", "30 mm", "50 mm", "70 mm"].iter().enumerate() {
        let of = |column: &[f64], scale: f64| [2 * run, 2 * run + 1].map(|run| scale * column[run]);
        let [low, high] = of(collisions, 1.0);
        let [soft, hard] = of(impulses, 1e-3);
        let collisions = format!("{low:.0} and {high:.0}");
        println!("{gap}  {collisions:10}  {soft:.1} and {hard:.1}");
    }
    Ok(())
}
