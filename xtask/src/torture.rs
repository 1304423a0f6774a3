//! Sweeps that are killed, raced, damaged, cut off from their disk and refused by it. Exit code 0 must never come with a wrong table, and
//! finished runs must not be lost.

mod bench;
mod bytes;
mod kills;
mod power;
mod races;
mod writes;

use std::path::Path;

use bench::Bench;

/// Number of repetitions of each test.
#[derive(Debug, clap::Args)]
pub(crate) struct Rounds {
    /// Power failures. They need root, ext4 and Python, and are skipped if any is missing.
    #[arg(long, default_value_t = 100)]
    power_failures: u32,
    /// Kills at random moments.
    #[arg(long, default_value_t = 200)]
    kills: u32,
    /// Races of two processes for one table.
    #[arg(long, default_value_t = 100)]
    races: u32,
    /// Skip errors of writing, which need strace.
    #[arg(long)]
    no_write_errors: bool,
    /// Skip changed bytes, which a test of the sweeps has, too.
    #[arg(long)]
    no_changed_bytes: bool,
    /// Seed of the random moments.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

impl Rounds {
    /// Few rounds for `check`, without power failures and refused calls, which need special machines.
    pub(crate) const FEW: Self = Self {
        power_failures: 0,
        kills: 10,
        races: 5,
        no_write_errors: true,
        no_changed_bytes: true,
        seed: 1,
    };
}

/// Runs all tests.
///
/// # Errors
/// Names the first broken promise, and leaves the folder in its state.
pub(crate) fn run(root: &Path, rounds: &Rounds) -> Result<(), String> {
    let mut bench = Bench::new(root, rounds.seed)?;
    if !rounds.no_changed_bytes {
        bytes::run(&bench)?;
    }
    kills::run(&mut bench, rounds.kills)?;
    races::run(&mut bench, rounds.races)?;
    if !rounds.no_write_errors {
        writes::run(&bench)?;
    }
    power::run(&mut bench, rounds.power_failures)?;
    println!("No promise was broken.");
    Ok(())
}
