//! Many scenes at once, side by side in the lanes of the machine's vectors.
//!
//! Rows of one shape, which differ in numbers, run through the central difference method together: what a step does to one
//! number it does to those of up to sixteen scenes at the same time. The formulas are those of the method itself, generic over
//! [`Number`](pounding_contact::Number), and every lane gives the bits of its scene alone. A step looks at contact laws only
//! where some lane touches. What a run leaves is little: peaks and sums ([`Tallies`]); who wants histories runs a scene alone.
//!
//! Left out: buildings of several storeys, motions that travel, sub-steps in contact, columns that yield smoothly.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

mod body;
mod column;
mod exact;
mod group;
mod jump;
mod law;
mod number;
mod run;
mod tallies;
mod tally;
#[cfg(all(test, target_arch = "x86_64"))]
mod tests;

use fearless_simd::{Level, dispatch};

pub use column::RowsOf;
use column::SideBySideColumn;
pub use exact::ExactSideBySide;
pub use tallies::{PairTally, Tallies};

use crate::{CentralDifference, Clock, Excitation, RestoringForce, Row, RunError, Support};

/// One ground motion, method and time step, under which many rows run.
#[derive(Debug, Clone)]
pub struct SideBySide {
    settings: CentralDifference,
    time_step: f64,
    /// Acceleration at every node of the clock \[m/s²\].
    ground: Vec<f64>,
    level: Level,
}

impl SideBySide {
    /// Samples the ground motion for a clock, that of the longest run.
    ///
    /// # Errors
    /// [`RunError::Setting`] for settings out of range, and for sub-steps in contact.
    pub fn new(
        settings: CentralDifference,
        excitation: Excitation<'_>,
        clock: Clock,
    ) -> Result<Self, RunError> {
        settings.check()?;
        let substeps = settings.contact_substeps;
        let allowed = "1 side by side; scenes with more run alone";
        crate::error::require(substeps == 1, "contact_substeps", substeps.into(), allowed)?;
        Ok(Self {
            settings,
            time_step: clock.time_step,
            ground: excitation.sampled(clock),
            level: Level::new(),
        })
    }

    /// Runs rows of one shape, each for its own number of steps, and takes what happened in them; false, and nothing, where they
    /// cannot run side by side.
    ///
    /// Rows of one shape have as many structures, all of one storey, and the same pairs with laws of the same kinds; the ground
    /// motion arrives everywhere at once, and no row has more steps than the clock.
    pub fn run(&self, rows: RowsOf<'_>, n_steps: &[usize], tallies: &mut Tallies) -> bool {
        match rows {
            RowsOf::Elastic(rows) => self.run_alike(rows, n_steps, tallies),
            RowsOf::ElastoPlastic(rows) => self.run_alike(rows, n_steps, tallies),
            RowsOf::Bilinear(rows) => self.run_alike(rows, n_steps, tallies),
        }
    }

    fn run_alike<Column: SideBySideColumn>(
        &self,
        rows: &[&Row<Column>],
        n_steps: &[usize],
        tallies: &mut Tallies,
    ) -> bool {
        let reach = 1..self.ground.len();
        let in_reach = rows.len() == n_steps.len() && n_steps.iter().all(|n| reach.contains(n));
        let Some(first) = rows.first().filter(|_| in_reach && are_alike(rows)) else {
            tallies.begin(0, (0, 0));
            return false;
        };
        tallies.begin(rows.len(), (first.nodes().len(), first.pairs().len()));
        dispatch!(self.level, simd => run::run(simd, self, (rows, n_steps), tallies));
        true
    }
}

/// Whether rows are of one shape that can run side by side.
fn are_alike<Column: RestoringForce>(rows: &[&Row<Column>]) -> bool {
    let single = |row: &Row<Column>| {
        let nodes = row.nodes();
        let on_ground = nodes.iter().all(|node| node.support == Support::Ground);
        on_ground && (0..nodes.len()).all(|node| row.arrival(node) == 0.0)
    };
    let alike = |row: &Row<Column>, other: &Row<Column>| {
        let mut pairs = row.pairs().iter().zip(other.pairs());
        row.nodes().len() == other.nodes().len()
            && row.pairs().len() == other.pairs().len()
            && pairs
                .all(|(pair, other)| pair.left == other.left && pair.law.name() == other.law.name())
    };
    rows.iter().all(|row| single(row) && alike(row, rows[0]))
}
