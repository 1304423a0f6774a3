//! Tests of lanes: their results must be those of runs of each scene alone. The name of each test states its kind.

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
