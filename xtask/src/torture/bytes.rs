//! Changes of every byte of a part and of a manifest.

use std::fs;
use std::path::Path;

use super::bench::{Bench, SWEEPS, TABLE, said};

/// Changes one bit of every byte in turn; `merge` must refuse it or make the correct table.
pub(super) fn run(bench: &Bench) -> Result<(), String> {
    let folder = bench.folder("bytes")?;
    let shards = ["1/2", "2/2"].map(|shard| bench.sweep(&folder, SWEEPS[0], &["--shard", shard]));
    if let Some(failed) = shards.iter().find(|ended| !ended.status.success()) {
        return Err(said(failed));
    }
    let parts = folder.join(format!("{TABLE}.parts"));
    let mut changes = 0;
    for name in ["part-000000007.csv", "manifest.json"] {
        changes += every_byte(bench, &folder, &parts.join(name))?;
    }
    // The sweep detects the damaged part and runs it again.
    let part = parts.join("part-000000007.csv");
    fs::write(&part, "").map_err(|error| format!("{}: {error}", part.display()))?;
    bench.ends_well(&folder)?;
    println!("{changes} changes of a byte: each refused, or the right table.");
    Ok(())
}

fn every_byte(bench: &Bench, folder: &Path, path: &Path) -> Result<usize, String> {
    let fail = |error: std::io::Error| format!("{}: {error}", path.display());
    let whole = fs::read(path).map_err(fail)?;
    for place in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[place] ^= 1 << (place % 8);
        fs::write(path, bytes).map_err(fail)?;
        let merge = ["merge", TABLE, "--overwrite"];
        let ended = bench.command(folder, &merge).output().map_err(fail)?;
        if ended.status.success() && !bench.is_table_of(folder, 0)? {
            return Err(format!("{}: byte {place} changed the table", path.display()));
        }
        if !ended.status.success() && !said(&ended).contains(": found ") {
            return Err(format!("{}: byte {place}: {}", path.display(), said(&ended)));
        }
    }
    fs::write(path, &whole).map_err(fail)?;
    let table = folder.join(TABLE);
    // The sweep must make a new table.
    if table.exists() {
        fs::remove_file(table).map_err(fail)?;
    }
    Ok(whole.len())
}
