//! A sweep by cluster schedulers on this machine, compared byte by byte with this sweep without them.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::step::step;

/// The sweep, from the top folder.
const SWEEP: &str = "studies/sweeps/gap-and-period.json";
/// The script that submits it to `HyperQueue`, from the top folder, and the packages that it needs.
const HYPERQUEUE: &str = "studies/jobs/hyperqueue.py";
const PACKAGE: &str = "hyperqueue==0.27.0";
const SHARDS: &str = "5";
/// The script that starts SLURM and submits it, from the top folder.
const SLURM: &str = "studies/jobs/slurm_here.sh";

/// Runs the sweep by `HyperQueue` from the Python package index, in an environment next to the built program.
pub(crate) fn hyperqueue(root: &Path) -> Result<(), String> {
    compare(root, "hyperqueue", |home, sweep, table| {
        let install = &mut Command::new("python3");
        step(install.args(["-m", "venv"]).arg(home), root)?;
        let pip = &mut Command::new(home.join("bin/pip"));
        step(pip.args(["install", "--quiet", PACKAGE]), root)?;
        let mut submit = Command::new(home.join("bin/python"));
        submit.arg(root.join(HYPERQUEUE)).args([sweep, table]);
        submit.arg(SHARDS);
        Ok(submit)
    })
}

/// Runs the sweep by SLURM on this machine only, from Debian's packages; needs root.
pub(crate) fn slurm(root: &Path) -> Result<(), String> {
    compare(root, "slurm", |home, sweep, table| {
        let mut submit = Command::new(root.join(SLURM));
        submit.args([home, sweep, table]);
        Ok(submit)
    })
}

/// Runs the sweep without a scheduler, and by the command of `submit`, which receives an empty folder, the sweep and the table.
fn compare(root: &Path, scheduler: &str, submit: impl Fn(&Path, &Path, &Path) -> Result<Command, String>) -> Result<(), String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    step(Command::new(cargo).args(["build", "--package", "pounding"]), root)?;
    let own = std::env::current_exe().map_err(|error| format!("this program: {error}"))?;
    let program = own.with_file_name("pounding");
    let home = own.with_file_name(scheduler);
    let sweep = root.join(SWEEP);
    let [alone, shared] = ["alone.csv", "shared.csv"].map(|name| home.join(name));
    let fail = |error: std::io::Error| format!("{}: {error}", home.display());
    if home.exists() {
        fs::remove_dir_all(&home).map_err(fail)?;
    }
    fs::create_dir_all(&home).map_err(fail)?;
    let mut submit = submit(&home, &sweep, &shared)?;
    step(submit.env("POUNDING", &program), &home)?;
    step(Command::new(&program).arg("merge").arg(&shared), root)?;
    let run = &mut Command::new(&program);
    step(run.arg("sweep").arg(&sweep).arg("--out").arg(&alone), root)?;
    let [alone, shared] = [alone, shared].map(|path| fs::read(path).map_err(fail));
    if alone? != shared? {
        return Err(format!("the sweep by {scheduler} has other bytes than the one without it"));
    }
    println!("The sweep by {scheduler} has the bytes of the one without it.");
    Ok(())
}
