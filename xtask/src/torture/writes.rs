//! Every system call that changes the disk, refused once, and the program killed at it.

use std::path::Path;
use std::process::{Command, Stdio};

use super::bench::{Bench, SWEEPS, TABLE, said};

/// System calls and their descriptions. Those of a line are counted together.
const CALLS: [(&str, &str); 5] = [
    ("write,pwrite64", "ENOSPC"),
    ("fsync,fdatasync", "EIO"),
    ("rename,renameat,renameat2,link,linkat", "EIO"),
    ("unlink,unlinkat,rmdir", "EIO"),
    ("mkdir,mkdirat,ftruncate,flock", "EIO"),
];
/// Most tested calls of a kind. The last calls, which move the table to its place, are included.
const MOST: usize = 60;

/// Refuses the calls in turn.
pub(super) fn run(bench: &Bench) -> Result<(), String> {
    if !super::power::is_there("strace") {
        println!("Errors of writing are left out: strace is not installed.");
        return Ok(());
    }
    let (mut tried, mut killed) = (0, 0);
    for (calls, error) in CALLS {
        let n = count(bench, calls)?;
        let step = n.div_ceil(MOST).max(1);
        let last = n.saturating_sub(8)..=n;
        for at in (1..=n).step_by(step).chain(last).filter(|at| *at > 0) {
            let folder = bench.folder("writes")?;
            let inject = format!("inject={calls}:error={error}:when={at}");
            let mut refused = traced(bench, &folder, &["-e", &inject]);
            let ended = refused.output().map_err(|error| format!("strace: {error}"))?;
            let code = ended.status.code();
            if code == Some(0) && !bench.is_table_of(&folder, 0)? || !matches!(code, Some(0 | 1)) {
                return Err(format!("{inject}: exit code {code:?}: {}", said(&ended)));
            }
            bench.ends_well(&folder).map_err(|broken| format!("{inject}: {broken}"))?;
            tried += 1;
            killed_at(bench, calls, at)?;
            killed += 1;
        }
    }
    println!("After each of {tried} refused system calls, the program ended with exit code 1 or wrote the right table.");
    println!("After each of {killed} kills at a system call, the same command finished the work.");
    Ok(())
}

/// Kills the program before a system call. The same command must then finish the work.
fn killed_at(bench: &Bench, calls: &str, at: usize) -> Result<(), String> {
    let folder = bench.folder("writes")?;
    let inject = format!("inject={calls}:signal=SIGKILL:when={at}");
    let ended = traced(bench, &folder, &["-e", &inject]).output();
    let ended = ended.map_err(|error| format!("strace: {error}"))?;
    // A run with fewer calls this time ended normally.
    if ended.status.code().is_some_and(|code| code != 0) {
        return Err(format!("{inject}: {}", said(&ended)));
    }
    let ends = bench.ends_well(&folder);
    ends.map_err(|broken| format!("{inject}: {broken}"))
}

fn traced(bench: &Bench, folder: &Path, more: &[&str]) -> Command {
    let mut command = Command::new("strace");
    command.args(["-f", "-q", "-o", "trace"]).args(more).arg(&bench.program);
    command.args(["sweep", SWEEPS[0], "--out", TABLE]).current_dir(folder);
    // A single thread, so that calls have reproducible numbers.
    command.env("RAYON_NUM_THREADS", "1").stdout(Stdio::null());
    command
}

/// Counts the system calls of a kind in a sweep.
fn count(bench: &Bench, calls: &str) -> Result<usize, String> {
    let folder = bench.folder("writes")?;
    let trace = format!("trace={calls}");
    let ended = traced(bench, &folder, &["-e", &trace]).output();
    let ended = ended.map_err(|error| format!("strace: {error}"))?;
    if !ended.status.success() {
        return Err(format!("strace: {}", said(&ended)));
    }
    let trace = std::fs::read_to_string(folder.join("trace")).unwrap_or_default();
    Ok(trace.lines().filter(|line| line.contains('(')).count())
}
