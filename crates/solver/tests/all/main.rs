//! Tests of the solver; the kind of each is in its name.

mod allocations;
mod audit;
mod beyond_numbers;
mod chopra;
mod clamped_collisions;
mod common;
mod contact_limits;
mod every_law;
mod exact;
mod exact_laws;
mod found;
mod impacts;
mod ledger;
mod ledger_energies;
mod ledger_faults;
mod limit;
mod momentum;
mod moreau_jean;
mod newton_counts;
mod order;
mod random_rows;
mod refusals;
mod slow_touches;
mod touches;
mod very_start;
