//! Sweeps as a user runs them, beside the loop by hand on all cores: time for a run, and memory.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use pounding_solver::Clock;
use serde_json::{Value, json};

use super::{lanes, setting};

/// Where the ratios are kept, from the top folder.
const KEPT: &str = "results/bench/sweeps.csv";
/// What is timed.
const SWEEPS: [Sweep; 8] = [
    Sweep::of(10_000, SHORT, Keeps::Rows, 5),
    Sweep::of(100_000, SHORT, Keeps::Rows, 5),
    Sweep::of(1_000_000, SHORT, Keeps::Rows, 3),
    Sweep::of(10_000_000, SHORT, Keeps::Rows, 3),
    Sweep::of(1_000_000, SHORT, Keeps::Summary, 5),
    Sweep::of(1_000_000, LONG, Keeps::Summary, 5),
    Sweep::of(10_000_000, SHORT, Keeps::Summary, 3),
    Sweep::of(100_000_000, SHORT, Keeps::Summary, 1),
];
/// Ten seconds of the record, as in the other benchmarks.
const SHORT: Clock = setting::CLOCK;
/// Nearly all of it, in steps of half the length.
const LONG: Clock = Clock {
    time_step: 0.005,
    n_steps: 6000,
};
const HEADER: &str =
    "instructions,keeps,runs,steps,threads,time_over_loop_by_hand,largest_memory_mb";
/// How often a sweep that runs is asked for its memory.
const LOOK: Duration = Duration::from_millis(2);

/// So many runs of so many steps, and how often they are timed.
struct Sweep {
    runs: u64,
    clock: Clock,
    keeps: Keeps,
    repeats: usize,
}

/// What is written: a row for every run, or statistics of all.
#[derive(Clone, Copy, PartialEq)]
enum Keeps {
    Rows,
    Summary,
}

/// Times sweeps and keeps the ratios.
pub(super) fn run(root: &Path) -> Result<(), String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut build = Command::new(cargo);
    let build = build
        .args(["build", "--package", "pounding"])
        .current_dir(root)
        .status();
    if !build.is_ok_and(|status| status.success()) {
        return Err("the program cannot be built".into());
    }
    let own = std::env::current_exe().map_err(|error| format!("this program: {error}"))?;
    let (program, home) = (own.with_file_name("pounding"), own.with_file_name("sweeps"));
    fs::create_dir_all(&home).map_err(|error| format!("{}: {error}", home.display()))?;
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let by_hand =
        |clock| lanes::seconds_by_hand(root, threads, clock)?.ok_or(lanes::NO_LOOP.to_owned());
    let instructions = lanes::instructions().ok_or(lanes::NO_LOOP)?;
    let mut lines = Vec::new();
    for sweep in &SWEEPS {
        // The loop by hand before and after: the speed of machines drifts.
        let before = by_hand(sweep.clock)?;
        let (seconds, memory) = sweep.time(&program, &home, root)?;
        let after = by_hand(sweep.clock)?;
        let ratio = seconds / (0.5 * (before + after) * sweep.runs as f64);
        let (runs, steps) = (sweep.runs, sweep.clock.n_steps);
        let keeps = sweep.keeps.name();
        let megabytes = memory.div_ceil(1000);
        lines.push(format!(
            "{keeps},{runs},{steps},{threads},{ratio:.2},{megabytes}"
        ));
    }
    let csv = lanes::keep(&root.join(KEPT), HEADER, instructions, &lines)?;
    println!(
        "\nWall time of sweeps side by side, with scenes made, checked and written, over that of the bare loop by hand on as many threads:\n{csv}\nkept in {KEPT}"
    );
    Ok(())
}

impl Keeps {
    fn name(self) -> &'static str {
        match self {
            Self::Rows => "rows",
            Self::Summary => "summary",
        }
    }
}

impl Sweep {
    const fn of(runs: u64, clock: Clock, keeps: Keeps, repeats: usize) -> Self {
        Self {
            runs,
            clock,
            keeps,
            repeats,
        }
    }

    /// Median time \[s\], and the most memory \[kB\], of a program that runs it from a folder.
    fn time(&self, program: &Path, home: &Path, root: &Path) -> Result<(f64, u64), String> {
        let file = home.join("sweep.json");
        let text = self.text(root).to_string();
        fs::write(&file, text).map_err(|error| format!("{}: {error}", file.display()))?;
        let (mut times, mut memory) = (Vec::new(), 0);
        for _ in 0..self.repeats {
            let mut command = Command::new(program);
            command.arg("sweep").arg(&file);
            command
                .args(["--overwrite", "--out"])
                .arg(home.join("runs.csv"));
            let (seconds, most) = timed(&mut command)?;
            times.push(seconds);
            memory = memory.max(most);
        }
        times.sort_by(f64::total_cmp);
        Ok((times[self.repeats / 2], memory))
    }

    /// The scenes of the other benchmarks, with what is the default.
    fn text(&self, root: &Path) -> Value {
        let structure = |name: &str| json!({"sdof": {"name": name, "mass_kg": setting::MASS, "period_s": 1.0, "damping": {"ratio": setting::DAMPING}}});
        let between = |[from, to]: [f64; 2]| json!({"from": from, "to": to});
        let Clock { time_step, n_steps } = self.clock;
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
            "samples": {"count": self.runs, "seed": 1, "method": "random"},
            "outputs": {"pairs": ["collisions", "total_impulse_n_s"]},
        });
        if self.keeps == Keeps::Summary {
            sweep["summary"] = json!({});
        }
        sweep
    }
}

/// Wall time \[s\] of a program, and the most memory that it held \[kB\], where the system tells.
fn timed(command: &mut Command) -> Result<(f64, u64), String> {
    let start = Instant::now();
    let quiet = command.stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = quiet.spawn().map_err(|error| error.to_string())?;
    let status = format!("/proc/{}/status", child.id());
    let mut memory = 0;
    loop {
        if let Some(status) = child.try_wait().map_err(|error| error.to_string())? {
            if !status.success() {
                return Err(format!("the sweep failed: {status}"));
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
