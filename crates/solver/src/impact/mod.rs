//! Impulses of impacts at an instant, for a single pair, chains of pairs, and any set of pairs.

pub(crate) mod any_rounds;
pub(crate) mod chain;
pub(crate) mod dense;
pub(crate) mod impacts;
pub(crate) mod rounds;
