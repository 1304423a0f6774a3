//! Tests of the studies; the name of a test tells its kind.

mod agreement;
mod beyond;
mod determinism;
mod digits;
mod exact_faults;
mod laws;
mod scenes;
mod second_route;
mod snapshots;
mod surveys;
mod trade;
mod validation;
mod verify;
