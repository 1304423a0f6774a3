//! The manifest of a folder of parts: their sweep, and the division of its runs.

use std::ops::Range;
use std::path::{Path, PathBuf};

use pounding_files::{Existing, Length};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::Sweep;
use super::error::{self, MANIFEST};
use super::summary::Form;
use pounding_text::{RefusalKind, Refused};

/// Path of a second manifest while the parts of a finished table are deleted. It is deleted last: while it exists, the next process
/// completes the clean-up.
pub(super) fn joined_beside(out: &Path) -> PathBuf {
    pounding_files::hidden(out, "joined.json")
}

/// Version of the format of parts and manifests. Increment it with every change of either.
const SCHEMA_VERSION: u32 = 2;

/// Longest manifest: the columns of some thousand floors.
const LONGEST: Length = Length::new(64 << 20, "it is none that a sweep wrote");

/// Division of a table into parts.
struct Cut {
    /// Approximate number of parts: the loss of an incomplete part must be small.
    parts: u64,
    /// Fewest runs of a part, for cheap runs.
    least: u64,
    /// Most runs of a part, which a thread holds in memory.
    most: u64,
}

/// Least and largest cost of a part of runs alone, in force evaluations: about a tenth of a second, and ten seconds. A stop loses at most
/// this much.
pub(super) const PRICES: [f64; 2] = [5e5, 5e7];

/// Bounds of the runs of a file or a batch: their number and their cost.
#[derive(Clone, Copy)]
struct Most {
    runs: u64,
    price: f64,
}

impl Most {
    /// Number of runs with this cost each: a power of two, which fills lanes and divides all larger ones.
    fn of(self, price: f64) -> u64 {
        let halves = std::iter::successors(Some(self.runs), |count| Some(count / 2));
        let mut halves = halves.take_while(|count| *count > 1);
        let found = halves.find(|count| *count as f64 * price <= self.price);
        found.unwrap_or(1)
    }
}

/// For runs that take longer than writing a file.
const ALONE: Cut = Cut {
    parts: 1024,
    least: 1,
    most: 4096,
};
/// For runs in lanes: writing the file of a part takes as long as about fifty runs.
const BESIDE: Cut = Cut {
    parts: 128,
    least: 256,
    most: 16_384,
};

/// For a part with a summary: its size does not depend on the number of runs, and a kill loses it.
const SUMMED: Most = Most {
    runs: 1 << 22,
    price: 8.0 * PRICES[1],
};

impl Cut {
    fn of(sweep: &Sweep) -> Self {
        if sweep.asks_for_tallies() { BESIDE } else { ALONE }
    }

    /// For a part with rows.
    fn with_rows(&self) -> Most {
        Most {
            runs: self.most,
            price: PRICES[1],
        }
    }

    /// Runs per part, from the number of runs and their cost.
    fn of_runs(&self, runs: u64, price: f64, most: Most) -> u64 {
        let least = Most {
            runs: self.least,
            price: PRICES[0],
        };
        let wanted = (runs / self.parts).next_power_of_two();
        wanted.clamp(least.of(price), most.of(price))
    }
}

/// The sweep whose parts a folder holds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Manifest {
    schema_version: u32,
    /// SHA-256 of all inputs of the rows, including the program.
    pub(super) sweep: String,
    /// Number of runs.
    pub(super) runs: u64,
    /// Number of runs of every part except the last.
    pub(super) runs_per_part: u64,
    /// The row that names the columns.
    pub(super) header: String,
    /// Form of the summary, if requested.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(super) summary: Option<Form>,
    /// SHA-256 of all fields above.
    sha256: String,
}

/// Only the version: other versions may have other fields.
#[derive(Deserialize)]
struct Versioned {
    schema_version: Option<u32>,
}

impl Manifest {
    pub(super) fn of(sweep: &Sweep) -> Self {
        let (runs, cut) = (sweep.n_runs(), Cut::of(sweep));
        let most = match sweep.without_rows() {
            Some(_) => SUMMED,
            None => cut.with_rows(),
        };
        Self {
            schema_version: SCHEMA_VERSION,
            sweep: sweep.sha256().into(),
            runs,
            runs_per_part: cut.of_runs(runs, sweep.expected_price(), most),
            header: String::from_utf8_lossy(&sweep.header()).into_owned(),
            summary: sweep.summary.clone(),
            sha256: String::new(),
        }
        .signed()
    }

    /// Number of runs of a sweep that are prepared at a time. The grouping in lanes affects the bits of the exact method, so that it must
    /// be the same with and without rows.
    pub(super) fn runs_per_batch(sweep: &Sweep) -> u64 {
        let cut = Cut::of(sweep);
        cut.of_runs(sweep.n_runs(), sweep.expected_price(), cut.with_rows())
    }

    /// Form of the summary that parts hold instead of rows.
    pub(super) fn without_rows(&self) -> Option<&Form> {
        self.summary.as_ref().filter(|form| !form.rows)
    }

    fn signed(self) -> Self {
        Self {
            sha256: self.hash(),
            ..self
        }
    }

    /// A manifest of this many runs, in parts of this size.
    #[cfg(test)]
    pub(super) fn for_tests(runs: u64, runs_per_part: u64) -> Self {
        Self {
            schema_version: SCHEMA_VERSION,
            sweep: "5eed".into(),
            runs,
            runs_per_part,
            header: "run,failed\n".into(),
            summary: None,
            sha256: String::new(),
        }
        .signed()
    }

    /// SHA-256 of all fields except this hash.
    fn hash(&self) -> String {
        let Self {
            schema_version,
            sweep,
            runs,
            runs_per_part,
            header,
            summary,
            sha256: _,
        } = self;
        let summary = serde_json::to_string(summary).unwrap_or_default();
        let text = format!("{schema_version}\n{sweep}\n{runs}\n{runs_per_part}\n{header}{summary}");
        pounding_scene::hexadecimal(&Sha256::digest(text))
    }

    /// That of a folder; nothing where it has none.
    pub(super) fn of_folder(folder: &Path) -> Result<Option<Self>, Refused> {
        Self::read(folder.join(MANIFEST))
    }

    /// That of a file; nothing where it is not there.
    pub(super) fn read(path: PathBuf) -> Result<Option<Self>, Refused> {
        let bytes = match pounding_files::read(&path, LONGEST) {
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            read => read.map_err(error::file(&path))?,
        };
        let version = serde_json::from_slice::<Versioned>(&bytes);
        let version = version.map_err(|_| damaged(&path))?;
        if version.schema_version != Some(SCHEMA_VERSION) {
            let version = version.schema_version;
            let version = version.map_or_else(|| "no version".into(), |found| format!("version {found}"));
            let other = Refused::at(path)
                .found(format!("{version} of the form of parts"))
                .kind(RefusalKind::Damaged);
            let other = other.allowed_is(format!("version {SCHEMA_VERSION}"));
            return Err(other.so(
                ": ",
                "another version of the program wrote them; end the sweep with that one, name another file, or let --overwrite begin anew",
            ));
        }
        let manifest: Option<Self> = serde_json::from_slice(&bytes).ok();
        let whole = |one: &Self| one.sha256 == one.hash() && one.runs_per_part > 0;
        let manifest = manifest.filter(whole);
        manifest.map(Some).ok_or_else(|| damaged(&path))
    }

    /// Writes it into a folder that has none.
    pub(super) fn write(&self, folder: &Path) -> Result<(), Refused> {
        self.put(&folder.join(MANIFEST), Existing::Kept)
    }

    /// Writes it as a file.
    pub(super) fn put(&self, path: &Path, existing: Existing) -> Result<(), Refused> {
        let mut text = serde_json::to_string_pretty(self).unwrap_or_default();
        text.push('\n');
        pounding_files::write(path, text.as_bytes(), existing).map_err(error::file(path))
    }

    pub(super) fn n_parts(&self) -> u64 {
        self.runs.div_ceil(self.runs_per_part)
    }

    /// The runs of a part.
    pub(super) fn runs_of(&self, part: u64) -> Range<u64> {
        let start = part * self.runs_per_part;
        start..(start + self.runs_per_part).min(self.runs)
    }

    pub(super) fn n_runs_of(&self, part: u64) -> u64 {
        let runs = self.runs_of(part);
        runs.end - runs.start
    }
}

/// The file of a part.
pub(super) fn path_of(folder: &Path, part: u64) -> PathBuf {
    folder.join(format!("{PART}{part:09}{CSV}"))
}

const PART: &str = "part-";
const CSV: &str = ".csv";

/// Whether a file with this name is written by a sweep: a part, a manifest, or either under a hidden name.
pub(super) fn is_own(name: &str) -> bool {
    let part = |name: &str| {
        let number = name.strip_prefix(PART).and_then(|rest| rest.strip_suffix(CSV));
        number.is_some_and(|number| number.bytes().all(|digit| digit.is_ascii_digit()))
    };
    let shown = match name.strip_prefix('.') {
        Some(begun) => begun.rsplitn(3, '.').nth(2).unwrap_or_default(),
        None => name,
    };
    part(shown) || shown == MANIFEST
}

/// A manifest that is not as it was written.
fn damaged(path: &Path) -> Refused {
    let other = Refused::at(path).found("other bytes than a sweep wrote").kind(RefusalKind::Damaged);
    let other = other.allowed_is("the file as it was");
    other.help("delete it, then the sweep goes on with the parts that are whole")
}

#[cfg(test)]
mod tests {
    use super::{BESIDE, SUMMED, is_own};

    /// 256 runs of towers were a single part: a sweep stopped after minutes had nothing, and small sweeps had only one shard.
    #[test]
    fn issue_a_part_costs_seconds() {
        let part = |runs, price| BESIDE.of_runs(runs, price, BESIDE.with_rows());
        assert_eq!(part(200_000, 2e3), 2048, "two structures of one storey");
        assert_eq!(part(20, 2e3), 128, "a file takes longer than fewer of them");
        assert_eq!(part(80, 1e6), 1);
        assert_eq!(part(1_000_000, 1e6), 32);
        assert_eq!(part(1_000_000, 1e12), 1);
        for price in [0.0, 2e3, 1e6, 1e12] {
            for runs in [1, 80, 1_000_000, 100_000_000] {
                let (summed, batch) = (BESIDE.of_runs(runs, price, SUMMED), part(runs, price));
                assert_eq!(summed % batch, 0, "{runs} of {price}: whole batches");
            }
        }
    }

    #[test]
    fn limit_names_of_a_sweep() {
        for own in ["part-000000012.csv", "manifest.json", ".part-000000001.csv.aB3x.new"] {
            assert!(is_own(own), "{own}");
        }
        for other in [
            "notes.txt",
            "part-a.csv",
            "part-1.csv.bak",
            ".notes",
            ".a.b.new",
            "",
            ".",
            "manifest",
        ] {
            assert!(!is_own(other), "{other}");
        }
    }
}
