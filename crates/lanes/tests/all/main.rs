//! Tests of lanes: what is told is what runs of each scene alone tell. The kind of each test is in its name.

mod allocations;
mod at_rest;
mod books;
mod budgets;
mod chains;
#[path = "../../../solver/tests/all/common.rs"]
#[expect(dead_code, reason = "shared with the tests of the solver")]
mod common;
mod exact;
mod in_contact;
#[path = "../../../solver/tests/all/random_rows.rs"]
mod random_rows;
mod steps;
mod storeys;
#[path = "../../../solver/tests/all/towers.rs"]
mod towers;
#[path = "../../../solver/tests/all/watch.rs"]
mod watch;
