//! Kills at random moments.

use std::path::Path;
use std::thread;

use super::bench::{Bench, SWEEPS, TABLE};

/// Kills a sweep up to three times, then runs it to its end.
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
                return Err(format!("{}: {there} parts of {parts} are left", folder.display()));
            }
            parts = there;
            with_table += u32::from(is_joined);
        }
        bench.ends_well(&folder)?;
    }
    println!("{kills} kills, {with_table} of them with the table in its place: the right table in the end, and no part lost.");
    Ok(())
}

fn killed(bench: &mut Bench, folder: &Path) -> Result<(), String> {
    let wait = bench.time.mul_f64(1.2 * bench.random());
    let arguments = ["sweep", SWEEPS[0], "--out", TABLE];
    let fail = |error: std::io::Error| format!("kill: {error}");
    let mut child = bench.command(folder, &arguments).spawn().map_err(fail)?;
    thread::sleep(wait);
    child.kill().map_err(fail)?;
    child.wait().map(drop).map_err(fail)
}

/// Number of parts with their final name.
fn n_parts(folder: &Path) -> usize {
    let entries = std::fs::read_dir(folder.join(format!("{TABLE}.parts")));
    let names = entries.into_iter().flatten().flatten();
    names
        .filter(|entry| entry.file_name().to_string_lossy().starts_with("part-"))
        .count()
}
