//! Tests of the studies; the kind of each is in its name.

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
