//! Runs summed up in place of a row for each: counts, sums, quantiles and exceedances, the same bytes whatever the order.

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
