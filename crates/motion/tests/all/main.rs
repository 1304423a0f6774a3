//! Tests of ground motions; the kind of each is in its name.

mod at2;
mod committed_records;
mod csv;
mod damaged;
mod formats;
mod fuzz_seeds;
mod generated;
mod laws;
mod measures;
mod named_files;
mod named_folders;
mod processing;
mod record;
mod stochastic;
