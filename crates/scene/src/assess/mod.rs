//! What pounding does to buildings, and the gap that prevents it.

pub(crate) mod effects;
pub(crate) mod separation;
