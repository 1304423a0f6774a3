//! Methods that solve equations for the state at the end of a step.

pub(crate) mod building_impulses;
pub(crate) mod cluster;
pub(crate) mod clusters;
pub(crate) mod contacts;
pub(crate) mod equation;
pub(crate) mod equilibrium;
pub(crate) mod hht;
pub(crate) mod moreau_jean;
pub(crate) mod newmark;
pub(crate) mod newton;
pub(crate) mod step;
pub(crate) mod trial;
