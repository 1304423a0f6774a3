//! Tests of ground motions; the name of a test tells its kind.

mod at2;
mod band_limited;
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
