//! Tests of reports; the kind of each is in its name.

mod opensees;
mod risk;
mod separation;
