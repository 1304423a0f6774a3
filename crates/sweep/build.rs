//! Hashes the sources of the crates that compute, which identify a sweep: other code must not continue it.

use std::fmt::Write as _;
use std::fs;
use std::io::Result;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// The folders of these crates, relative to this crate.
const SOURCES: [&str; 9] = [
    "../assess/src",
    "../contact/src",
    "../lanes/src",
    "../motion/src",
    "../risk/src",
    "../scene/src",
    "../solver/src",
    "../text/src",
    "src",
];
/// The lock files with the versions of dependencies; a source distribution of Python has only its own.
const LOCKS: [&str; 2] = ["../../Cargo.lock", "../python/Cargo.lock"];

fn main() -> Result<()> {
    let mut hash = Sha256::new();
    let exists = |path: &&str| Path::new(path).exists();
    let lock = LOCKS.into_iter().find(exists);
    // In a package from a registry the other crates are absent: all have its version.
    hash.update(env!("CARGO_PKG_VERSION"));
    let packaged = !SOURCES[..SOURCES.len() - 1].iter().any(exists);
    let sources = SOURCES.into_iter().skip(if packaged { SOURCES.len() - 1 } else { 0 });
    for source in sources.chain(lock) {
        println!("cargo::rerun-if-changed={source}");
        let mut files = files(Path::new(source))?;
        files.sort();
        for file in files {
            let bytes = fs::read(&file)?;
            // A checkout on Windows has other line ends, and may use backslashes in paths.
            let bytes: Vec<u8> = bytes.into_iter().filter(|byte| *byte != b'\r').collect();
            hash.update(file.to_string_lossy().replace('\\', "/"));
            hash.update((bytes.len() as u64).to_le_bytes());
            hash.update(bytes);
        }
    }
    let mut digits = String::new();
    for byte in hash.finalize() {
        write!(digits, "{byte:02x}").expect("memory takes all");
    }
    println!("cargo::rustc-env=POUNDING_SOURCES={digits}");
    Ok(())
}

/// All files in a folder, or the file.
fn files(path: &Path) -> Result<Vec<PathBuf>> {
    if !path.is_dir() {
        return Ok(vec![path.to_path_buf()]);
    }
    let mut found = Vec::new();
    for entry in fs::read_dir(path)? {
        found.extend(files(&entry?.path())?);
    }
    Ok(found)
}
