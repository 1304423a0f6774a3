//! Questions asked beyond the paper.

pub(crate) mod examples;
pub(crate) mod laws;
pub(crate) mod other_motions;
pub(crate) mod stress;
pub(crate) mod surveys;
pub mod verify;
pub(crate) mod work_precision;
