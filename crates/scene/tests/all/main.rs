//! Tests of scenes; the kind of each is in its name.

mod beside;
mod between_samples;
mod bumpers;
mod capacities;
mod certificates;
mod collapse;
mod ductility_spectrum;
mod errors;
mod extremes;
mod floors;
mod gravity;
mod isolators;
mod judged;
mod lean;
mod links;
mod mirrored;
mod numbers;
mod openings;
mod pair_record;
mod pair_spectrum;
mod pushes;
mod scene_files;
mod spectrum;
mod tangent_damping;
