//! How far a run is from the exact one, and the method that keeps an accuracy at the least cost.

pub(crate) mod errors;
pub(crate) mod ladder;
pub(crate) mod methods;
pub(crate) mod opening;
pub(crate) mod price;
pub(crate) mod search;
