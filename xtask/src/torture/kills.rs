//! Kills sweeps at random moments and checks that nothing is lost.

use std::path::Path;
use std::thread;

use super::bench::{Bench, SWEEPS, TABLE};

/// Kills a sweep three times and then runs it to its end. Repeats this with new sweeps until there are at least `rounds` kills. A sweep may
/// have ended before a kill.
pub(super) fn run(bench: &mut Bench, rounds: u32) -> Result<(), String> {
    let (mut kills, mut with_table) = (0, 0);
    while kills < rounds {
        let folder = bench.folder("kills")?;
        let mut parts = 0;
        for _ in 0..3 {
            killed(bench, &folder)?;
            kills += 1;
            let is_joined = folder.join(TABLE).exists();
            let there = n_parts(&folder);
            if !is_joined && there < parts {
                return Err(format!(
                    "{}: a kill lost finished parts: {there} of {parts} are left",
                    folder.display()
                ));
            }
            parts = there;
            with_table += u32::from(is_joined);
        }
        bench.ends_well(&folder)?;
    }
    println!(
        "After {kills} kills, {with_table} of them after the table was written, every sweep ended with the right table and lost no part."
    );
    Ok(())
}

fn killed(bench: &mut Bench, folder: &Path) -> Result<(), String> {
    let wait = bench.time.mul_f64(1.2 * bench.random());
    let arguments = ["sweep", SWEEPS[0], "--out", TABLE];
    let fail = |error: std::io::Error| format!("a sweep to be killed: {error}");
    let mut child = bench.command(folder, &arguments).spawn().map_err(fail)?;
    thread::sleep(wait);
    child.kill().map_err(fail)?;
    child.wait().map(drop).map_err(fail)
}

/// Counts the finished parts, whose files already have their final names.
fn n_parts(folder: &Path) -> usize {
    let entries = std::fs::read_dir(folder.join(format!("{TABLE}.parts")));
    let names = entries.into_iter().flatten().flatten();
    names
        .filter(|entry| entry.file_name().to_string_lossy().starts_with("part-"))
        .count()
}
