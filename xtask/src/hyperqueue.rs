//! A sweep by `HyperQueue` from the Python package index, held to the bytes of the same sweep without it.

use std::fs;
use std::path::Path;
use std::process::Command;

/// The sweep, from the top folder.
const SWEEP: &str = "studies/sweeps/gap-and-period.json";
/// The script that submits it, from the top folder.
const SCRIPT: &str = "studies/jobs/hyperqueue.py";
/// What is installed.
const PACKAGE: &str = "hyperqueue==0.27.0";
const SHARDS: &str = "5";

/// Sets up a Python environment beside the built program and runs the sweep twice.
pub(crate) fn run(root: &Path) -> Result<(), String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    step(
        Command::new(cargo).args(["build", "--package", "pounding"]),
        root,
    )?;
    let own = std::env::current_exe().map_err(|error| format!("this program: {error}"))?;
    let program = own.with_file_name("pounding");
    let home = own.with_file_name("hyperqueue");
    let (sweep, script) = (root.join(SWEEP), root.join(SCRIPT));
    let [alone, shared] = ["alone.csv", "shared.csv"].map(|name| home.join(name));
    let fail = |error: std::io::Error| format!("{}: {error}", home.display());
    if home.exists() {
        fs::remove_dir_all(&home).map_err(fail)?;
    }
    step(
        Command::new("python3").args(["-m", "venv"]).arg(&home),
        root,
    )?;
    let pip = home.join("bin/pip");
    step(
        Command::new(pip).args(["install", "--quiet", PACKAGE]),
        root,
    )?;
    step(
        Command::new(&program)
            .arg("sweep")
            .arg(&sweep)
            .arg("--out")
            .arg(&alone),
        root,
    )?;
    let submit = &mut Command::new(home.join("bin/python"));
    submit.arg(script).arg(&sweep).arg(&shared).arg(SHARDS);
    step(submit.env("POUNDING", &program).current_dir(&home), &home)?;
    step(Command::new(&program).arg("merge").arg(&shared), root)?;
    let [alone, shared] = [alone, shared].map(|path| fs::read(path).map_err(fail));
    if alone? != shared? {
        return Err("the sweep by HyperQueue has other bytes than the one without it".into());
    }
    println!("The sweep by HyperQueue has the bytes of the one without it.");
    Ok(())
}

fn step(command: &mut Command, folder: &Path) -> Result<(), String> {
    println!("── {command:?}");
    let status = command.current_dir(folder).status();
    let status = status.map_err(|error| format!("{command:?}: {error}"))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{command:?}: {status}"))
    }
}
