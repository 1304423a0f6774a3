//! Tests of rows under many records; the kind of each is in its name.

mod collapse;
mod downloads;
mod effects;
mod pairs;
mod seats;
mod separation;
mod suite;
mod suite_events;
