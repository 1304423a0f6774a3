//! Summaries of runs instead of rows: counts, sums, quantiles and exceedances, with equal bytes for any order of runs.

mod exact;
mod form;
mod octaves;
mod of_sweep;
mod table;
mod tally;

#[cfg(test)]
mod tests;

pub(super) use form::Form;
pub use table::{Exceedance, SummaryTable, SummedCell, SummedColumn};
pub(super) use tally::Tally;
