//! Tests of scenes; the kind of each is in its name.

mod beside;
mod capacities;
mod certificates;
mod errors;
mod extremes;
mod floors;
mod gravity;
mod isolators;
mod judged;
mod lean;
mod mirrored;
mod numbers;
mod pair_record;
mod pair_spectrum;
mod scene_files;
mod spectrum;
