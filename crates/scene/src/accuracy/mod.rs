//! Errors of a run against the exact run, and the cheapest method that keeps an accuracy.

pub(crate) mod errors;
pub(crate) mod ladder;
pub(crate) mod methods;
pub(crate) mod opening;
pub(crate) mod price;
pub(crate) mod search;
