//! The program, two sweeps, their tables, and folders to break them in.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use serde_json::json;

/// The table in every folder.
pub(super) const TABLE: &str = "runs.csv";

/// Two sweeps that differ only in their seed, as file and as table.
pub(super) struct Bench {
    pub(super) program: PathBuf,
    home: PathBuf,
    /// The bytes of their tables.
    tables: [Vec<u8>; 2],
    /// Duration of the first sweep.
    pub(super) time: Duration,
    random: Pcg64,
}

/// The sweeps.
pub(super) const SWEEPS: [&str; 2] = ["first.json", "second.json"];

impl Bench {
    /// Builds the program and runs both sweeps.
    pub(super) fn new(root: &Path, seed: u64) -> Result<Self, String> {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut build = Command::new(cargo);
        // Built together with this task, so that the lower packages have the same features.
        let build = build
            .args(["build", "--package", "pounding", "--package", "xtask"])
            .current_dir(root)
            .status();
        if !build.is_ok_and(|status| status.success()) {
            return Err("the program cannot be built".into());
        }
        let own = std::env::current_exe().map_err(|error| format!("this program: {error}"))?;
        let home = own.with_file_name("torture");
        let fail = |error: std::io::Error| format!("{}: {error}", home.display());
        fs::create_dir_all(&home).map_err(fail)?;
        // A later build would be another program, which does not continue the sweeps of this one.
        let program = home.join("pounding");
        fs::copy(own.with_file_name("pounding"), &program).map_err(fail)?;
        let mut bench = Self {
            program,
            home,
            tables: [Vec::new(), Vec::new()],
            time: Duration::ZERO,
            random: Pcg64::new(seed.into(), 0),
        };
        for (index, sweep) in SWEEPS.into_iter().enumerate() {
            let folder = bench.folder("alone")?;
            let since = Instant::now();
            let ended = bench.sweep(&folder, sweep, &[]);
            bench.time = since.elapsed();
            if !ended.status.success() {
                return Err(format!("alone: {}", said(&ended)));
            }
            bench.tables[index] = read(&folder)?;
        }
        Ok(bench)
    }

    /// A folder with only the sweeps.
    pub(super) fn folder(&self, name: &str) -> Result<PathBuf, String> {
        let folder = self.home.join(name);
        if folder.exists() {
            fs::remove_dir_all(&folder).map_err(|error| format!("{name}: {error}"))?;
        }
        write_sweeps(&folder).map(|()| folder)
    }

    /// A command for the program in a folder.
    pub(super) fn command(&self, folder: &Path, arguments: &[&str]) -> Command {
        let mut command = Command::new(&self.program);
        command.args(arguments).current_dir(folder);
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        command
    }

    /// Runs a sweep to its end.
    pub(super) fn sweep(&self, folder: &Path, sweep: &str, more: &[&str]) -> Output {
        let arguments = [&["sweep", sweep, "--out", TABLE], more].concat();
        let ended = self.command(folder, &arguments).output();
        ended.expect("the program was built")
    }

    /// Whether the table of a folder is the table of this sweep.
    pub(super) fn is_table_of(&self, folder: &Path, sweep: usize) -> Result<bool, String> {
        Ok(read(folder)? == self.tables[sweep])
    }

    /// Ends the first sweep after any damage, and checks the table. An existing table must be correct.
    pub(super) fn ends_well(&self, folder: &Path) -> Result<(), String> {
        let was_there = folder.join(TABLE).exists();
        // While anything shows the owner of the table, this command ends with 0.
        let left = [format!("{TABLE}.parts"), format!(".{TABLE}.joined.json")];
        let was_begun = left.iter().any(|name| folder.join(name).exists());
        if was_there && !self.is_table_of(folder, 0)? {
            return Err(format!("{}: a wrong table", folder.display()));
        }
        let ended = self.sweep(folder, SWEEPS[0], &[]);
        let is_done = was_there && !was_begun && said(&ended).contains("is there already");
        if !ended.status.success() && !is_done {
            return Err(format!("{}: the same command again: {}", folder.display(), said(&ended)));
        }
        if !self.is_table_of(folder, 0)? {
            return Err(format!("{}: a wrong table in the end", folder.display()));
        }
        match left.iter().find(|name| folder.join(name).exists()) {
            Some(left) => Err(format!("{}: {left} was left", folder.display())),
            None => Ok(()),
        }
    }

    /// A random number from 0 to 1.
    pub(super) fn random(&mut self) -> f64 {
        (self.random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Writes both sweeps into a folder.
pub(super) fn write_sweeps(folder: &Path) -> Result<(), String> {
    let fail = |error: std::io::Error| format!("{}: {error}", folder.display());
    fs::create_dir_all(folder).map_err(fail)?;
    for (seed, name) in SWEEPS.into_iter().enumerate() {
        fs::write(folder.join(name), sweep(seed).to_string()).map_err(fail)?;
    }
    Ok(())
}

/// Two structures under half a sine, with 400 gaps and periods.
fn sweep(seed: usize) -> serde_json::Value {
    let structure =
        |name: &str, period: f64| json!({"sdof": {"name": name, "mass_kg": 1e5, "period_s": period, "damping": {"ratio": 0.05}}});
    json!({
        "scene": {
            "name": "two",
            "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}}},
            "duration_s": 1.0,
            "structures": [structure("left", 0.8), structure("right", 0.4)],
            "contacts": [{"gap_m": 0.01, "law": {"linear_spring": {"impact_stiffness_n_per_m": 1e8}}}],
            "method": {"central_difference": {"time_step_s": 0.002}},
        },
        "vary": [
            {"field": "contacts[0].gap_m", "uniform": {"from": 0.0, "to": 0.02}},
            {"field": "structures[0].sdof.period_s", "log_uniform": {"from": 0.3, "to": 1.5}},
        ],
        "samples": {"count": 400, "seed": seed, "method": "sobol"},
        // In lanes they would fit into two parts.
        "outputs": {"pairs": ["first_start_s", "total_impulse_n_s"]},
    })
}

/// The table of a folder.
pub(super) fn read(folder: &Path) -> Result<Vec<u8>, String> {
    fs::read(folder.join(TABLE)).map_err(|error| format!("{}: {error}", folder.join(TABLE).display()))
}

/// Standard error.
pub(super) fn said(ended: &Output) -> String {
    String::from_utf8_lossy(&ended.stderr).trim().to_owned()
}
