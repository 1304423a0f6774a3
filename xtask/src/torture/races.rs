//! Two processes for one table.

use std::path::Path;
use std::process::Output;
use std::thread;

use super::bench::{Bench, SWEEPS, TABLE, said};

/// Opponents of the first sweep.
const OPPONENTS: [&[&str]; 6] = [
    &["sweep", SWEEPS[1], "--out", TABLE],
    &["sweep", SWEEPS[0], "--out", TABLE],
    &["sweep", SWEEPS[1], "--out", TABLE, "--overwrite"],
    &["sweep", SWEEPS[0], "--out", TABLE, "--shard", "1/2"],
    &["sweep", SWEEPS[1], "--out", TABLE, "--shard", "2/2"],
    &["merge", TABLE],
];

/// Runs each opponent in turn; either process starts somewhat later.
pub(super) fn run(bench: &mut Bench, rounds: u32) -> Result<(), String> {
    let mut both = 0;
    for round in 0..rounds {
        let opponent = OPPONENTS[round as usize % OPPONENTS.len()];
        let folder = bench.folder("races")?;
        let ended = race(bench, &folder, opponent)?;
        let done = ended.each_ref().map(|one| one.status.success());
        both += u32::from(done == [true, true]);
        held(bench, &folder, opponent, done).map_err(|broken| {
            let [first, second] = ended.each_ref().map(said);
            format!("{broken}, of {opponent:?}: {done:?}\n{first}\n{second}")
        })?;
    }
    println!("{rounds} races, {both} of which both could end: no mixed table.");
    Ok(())
}

fn race(bench: &mut Bench, folder: &Path, opponent: &[&str]) -> Result<[Output; 2], String> {
    let fail = |error: std::io::Error| format!("race: {error}");
    let wait = bench.time.mul_f64(1.2 * bench.random() * bench.random());
    let arguments = ["sweep", SWEEPS[0], "--out", TABLE];
    let first = bench.command(folder, &arguments).spawn().map_err(fail)?;
    thread::sleep(wait);
    let second = bench.command(folder, opponent).spawn().map_err(fail)?;
    let second = second.wait_with_output().map_err(fail)?;
    Ok([first.wait_with_output().map_err(fail)?, second])
}

/// Conditions after the end of both processes; `done` tells which succeeded.
fn held(bench: &Bench, folder: &Path, opponent: &[&str], done: [bool; 2]) -> Result<(), String> {
    let makes_second = opponent[1] == SWEEPS[1] && !opponent.contains(&"--shard");
    if !folder.join(TABLE).exists() {
        // Shards leave parts, and a refused process leaves nothing.
        let lost = done[0] || done[1] && !opponent.contains(&"--shard");
        return if lost { Err("a table is lost".into()) } else { Ok(()) };
    }
    let is_first = bench.is_table_of(folder, 0)?;
    let is_second = bench.is_table_of(folder, 1)?;
    if !is_first && !is_second {
        return Err("a mixed table".into());
    }
    let by = if is_first {
        done[0] || !makes_second && done[1]
    } else {
        makes_second && done[1]
    };
    if by { Ok(()) } else { Err("the table of one that failed".into()) }
}
