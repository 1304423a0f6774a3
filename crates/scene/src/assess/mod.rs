//! What pounding does to buildings, and the gap that prevents it.

pub(crate) mod alone;
pub(crate) mod assessment;
pub(crate) mod bumper;
pub(crate) mod bumper_effect;
pub(crate) mod design;
pub(crate) mod distribution;
pub(crate) mod effects;
mod peaks;
pub(crate) mod run;
pub(crate) mod scaling;
pub(crate) mod separation;
mod target;
pub(crate) mod target_fit;

pub use peaks::FloorPeaks;
