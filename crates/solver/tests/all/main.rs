//! Tests of the solver; the kind of each is in its name.

mod allocations;
mod audit;
mod chopra;
mod common;
mod impacts;
mod limit;
mod momentum;
mod order;
mod refusals;
