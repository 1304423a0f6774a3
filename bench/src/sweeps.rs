//! Sweeps as a user runs them, compared with the loop by hand on all cores: time per run, and memory.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use pounding_solver::Clock;
use serde_json::{Value, json};

use crate::measure::{Outcome, RatioTable, median};
use crate::{lanes, setting};

const TABLE: RatioTable = RatioTable {
    path: "results/bench/sweeps.csv",
    title: "Wall time of sweeps side by side, with scenes made, checked and written, over that of the bare loop by hand on as many threads",
    header: "instructions,keeps,runs,steps,threads,time_over_loop_by_hand,largest_memory_mb",
};
/// The timed sweeps.
const SWEEPS: [Sweep; 8] = [
    Sweep(10_000, SHORT, "rows", 5),
    Sweep(100_000, SHORT, "rows", 5),
    Sweep(1_000_000, SHORT, "rows", 3),
    Sweep(10_000_000, SHORT, "rows", 3),
    Sweep(1_000_000, SHORT, SUMMARY, 5),
    Sweep(1_000_000, LONG, SUMMARY, 5),
    Sweep(10_000_000, SHORT, SUMMARY, 3),
    Sweep(100_000_000, SHORT, SUMMARY, 1),
];
/// Name of a sweep that writes statistics instead of rows.
const SUMMARY: &str = "summary";
/// Ten seconds of the record, as in the other benchmarks.
const SHORT: Clock = setting::CLOCK;
/// Almost the whole record, in steps of half the length.
const LONG: Clock = Clock {
    time_step: 0.005,
    n_steps: 6000,
};
/// Interval of memory measurements of a running sweep.
const LOOK: Duration = Duration::from_millis(2);

/// Number of runs, their steps, the output, and the number of timings.
struct Sweep(u64, Clock, &'static str, usize);

/// Times sweeps and keeps the ratios.
pub(super) fn run(root: &Path) -> Outcome<()> {
    super::cargo(root, &["build", "--package", "pounding"])?;
    let own = std::env::current_exe()?;
    let (program, home) = (own.with_file_name("pounding"), own.with_file_name("sweeps"));
    fs::create_dir_all(&home)?;
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut lines = Vec::new();
    for sweep in &SWEEPS {
        let Sweep(runs, clock, keeps, _) = sweep;
        // The loop by hand runs before and after, because the speed of machines drifts.
        let before = lanes::seconds_by_hand(root, threads, *clock)?;
        let (seconds, memory) = sweep.time(&program, &home, root)?;
        let after = lanes::seconds_by_hand(root, threads, *clock)?;
        let ratio = seconds / (0.5 * (before + after) * *runs as f64);
        let (steps, megabytes) = (clock.n_steps, memory.div_ceil(1000));
        lines.push(format!("{keeps},{runs},{steps},{threads},{ratio:.2},{megabytes}"));
    }
    TABLE.write(root, &lines)
}

impl Sweep {
    /// Median time \[s\] and peak memory \[kB\] of a program that runs the sweep from a folder.
    fn time(&self, program: &Path, home: &Path, root: &Path) -> Outcome<(f64, u64)> {
        let file = home.join("sweep.json");
        fs::write(&file, self.text(root).to_string())?;
        let (mut times, mut memory) = (Vec::new(), 0);
        for _ in 0..self.3 {
            let mut command = Command::new(program);
            command.arg("sweep").arg(&file);
            command.args(["--overwrite", "--out"]).arg(home.join("runs.csv"));
            let (seconds, most) = timed(&mut command)?;
            times.push(seconds);
            memory = memory.max(most);
        }
        Ok((median(times), memory))
    }

    /// The scenes of the other benchmarks, with default settings.
    fn text(&self, root: &Path) -> Value {
        let structure =
            |name: &str| json!({"sdof": {"name": name, "mass_kg": setting::MASS, "period_s": 1.0, "damping": {"ratio": setting::DAMPING}}});
        let between = |[from, to]: [f64; 2]| json!({"from": from, "to": to});
        let Sweep(runs, Clock { time_step, n_steps }, keeps, _) = *self;
        let mut sweep = json!({
            "scene": {
                "name": "pair",
                "record": {"file": root.join(setting::RECORD)},
                "duration_s": time_step * n_steps as f64,
                "structures": [structure("left"), structure("right")],
                "contacts": [{"gap_m": 0.05, "law": {"stereomechanical": {"restitution": setting::RESTITUTION}}}],
                "method": {"central_difference": {"time_step_s": time_step}},
            },
            "vary": [
                {"field": "structures[0].sdof.period_s", "uniform": between(setting::PERIODS)},
                {"field": "structures[1].sdof.period_s", "uniform": between(setting::PERIODS)},
                {"field": "contacts[0].gap_m", "uniform": between(setting::GAPS)},
            ],
            "samples": {"count": runs, "seed": 1, "method": "random"},
            "outputs": {"pairs": ["collisions", "total_impulse_n_s"]},
        });
        if keeps == SUMMARY {
            sweep["summary"] = json!({});
        }
        sweep
    }
}

/// Wall time \[s\] of a program, and its peak memory \[kB\] if the system reports it.
fn timed(command: &mut Command) -> Outcome<(f64, u64)> {
    let start = Instant::now();
    let quiet = command.stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = quiet.spawn()?;
    let status = format!("/proc/{}/status", child.id());
    let mut memory = 0;
    loop {
        if let Some(status) = child.try_wait()? {
            if !status.success() {
                return Err(format!("the sweep failed: {status}").into());
            }
            return Ok((start.elapsed().as_secs_f64(), memory));
        }
        let text = fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let number = line.and_then(|line| line.trim().split(' ').next()?.parse().ok());
        memory = memory.max(number.unwrap_or(0));
        std::thread::sleep(LOOK);
    }
}
