//! Impulses of impacts at one instant: one pair, chains of pairs, any set of pairs.

pub(crate) mod any_rounds;
pub(crate) mod chain;
pub(crate) mod dense;
pub(crate) mod impacts;
pub(crate) mod rounds;
