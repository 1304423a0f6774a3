//! Fuzzing of readers and scene files, by cargo-fuzz and libFuzzer.

use std::fs;
use std::path::Path;
use std::process::Command;

/// Folder of the targets, from the top folder.
const TARGETS: &str = "fuzz/fuzz_targets";
/// Seconds after which an input counts as a hang. With overflow checks an exact run of huge numbers takes a few.
const HANG: u32 = 30;
/// Memory of a run \[MB\].
const MEMORY: u32 = 1024;

/// Runs every target, or a given one, for a number of seconds; findings stay in fuzz/artifacts.
pub(crate) fn run(root: &Path, seconds: u32, only: Option<&str>) -> Result<(), String> {
    let mut all = targets(root)?;
    if let Some(only) = only {
        if !all.iter().any(|target| target == only) {
            return Err(format!("--target: found {only}, allowed are {}", all.join(", ")));
        }
        all.retain(|target| target == only);
    }
    for target in all {
        println!("── {target}: {seconds} s");
        let dictionary = format!("fuzz/{target}.dict");
        let dictionary = root.join(&dictionary).exists().then(|| format!("-dict={dictionary}"));
        // New inputs go to a folder that is not committed. The run also starts from the seeds.
        let made = root.join("target/fuzz").join(&target);
        fs::create_dir_all(&made).map_err(|error| format!("{}: {error}", made.display()))?;
        let seeds = Path::new("fuzz/corpus").join(&target);
        // Without a sanitizer it runs on stable Rust; there is no unsafe code to watch.
        let arguments = ["fuzz", "run", "--sanitizer", "none", &target];
        let folders = [made.as_path(), &seeds, Path::new("--")];
        let limits = [
            format!("-max_total_time={seconds}"),
            format!("-timeout={HANG}"),
            format!("-rss_limit_mb={MEMORY}"),
            format!("-malloc_limit_mb={MEMORY}"),
        ];
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let status = Command::new(cargo)
            .args(arguments)
            .args(folders)
            .args(limits)
            .args(dictionary)
            .current_dir(root)
            .status()
            .map_err(|error| format!("cannot start cargo: {error}"))?;
        if !status.success() {
            return Err(format!(
                "{target}: a finding in fuzz/artifacts/{target}, or cargo-fuzz is missing (`cargo install cargo-fuzz`)"
            ));
        }
    }
    Ok(())
}

/// Names of the targets, in order.
fn targets(root: &Path) -> Result<Vec<String>, String> {
    let fail = |error: std::io::Error| format!("{TARGETS}: {error}");
    let mut names = Vec::new();
    for entry in fs::read_dir(root.join(TARGETS)).map_err(fail)? {
        let path = entry.map_err(fail)?.path();
        names.extend(path.file_stem().map(|stem| stem.to_string_lossy().into_owned()));
    }
    names.sort();
    Ok(names)
}
