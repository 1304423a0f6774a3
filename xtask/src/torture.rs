//! Sweeps that are killed, raced, damaged, cut off from their disk and refused by it: never a wrong table with exit code 0, and
//! nothing lost that was finished.

mod bench;
mod bytes;
mod kills;
mod power;
mod races;
mod writes;

use std::path::Path;

use bench::Bench;

/// How often each is tried.
#[derive(Debug, clap::Args)]
pub(crate) struct Rounds {
    /// Power failures, which need root, ext4 and Python; are left out where one is missing.
    #[arg(long, default_value_t = 100)]
    power_failures: u32,
    /// Kills at random moments.
    #[arg(long, default_value_t = 200)]
    kills: u32,
    /// Races of two processes for one table.
    #[arg(long, default_value_t = 100)]
    races: u32,
    /// Leave out errors of writing, which need strace.
    #[arg(long)]
    no_write_errors: bool,
    /// Seed of the random moments.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

impl Rounds {
    /// As many as a check has time for; no power failures and refused calls, which not every machine can make.
    pub(crate) const FEW: Self = Self {
        power_failures: 0,
        kills: 10,
        races: 5,
        no_write_errors: true,
        seed: 1,
    };
}

/// Runs all of it.
///
/// # Errors
/// Names the first promise that was broken, and leaves the folder as it was then.
pub(crate) fn run(root: &Path, rounds: &Rounds) -> Result<(), String> {
    let mut bench = Bench::new(root, rounds.seed)?;
    bytes::run(&bench)?;
    kills::run(&mut bench, rounds.kills)?;
    races::run(&mut bench, rounds.races)?;
    if !rounds.no_write_errors {
        writes::run(&bench)?;
    }
    power::run(&mut bench, rounds.power_failures)?;
    println!("No promise was broken.");
    Ok(())
}
