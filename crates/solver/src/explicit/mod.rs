//! Methods whose steps solve no equations.

pub(crate) mod central_difference;
pub(crate) mod rk4;
pub(crate) mod verlet;
