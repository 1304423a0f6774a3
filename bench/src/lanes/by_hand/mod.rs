//! The loops of two elastic structures and of two towers, written by hand for the vectors of x86-64: what lanes are measured by.

use pounding_solver::{Bilinear, Storey};

#[cfg(target_arch = "x86_64")]
mod buildings;
#[cfg(target_arch = "x86_64")]
mod element;
#[cfg(target_arch = "x86_64")]
mod steps;
#[cfg(target_arch = "x86_64")]
mod tower;
#[cfg(target_arch = "x86_64")]
mod vector;

/// Scenes in a group.
pub(super) const GROUP: usize = 16;
/// Storeys of both towers, their floors, and the levels at which they touch.
pub(crate) const STOREYS: [usize; 2] = [8, 5];
pub(super) const FLOORS: usize = STOREYS[0] + STOREYS[1];
pub(super) const LEVELS: usize = STOREYS[1];

/// Numbers of a group of scenes, a scene after the other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Group {
    pub(super) masses: [[f64; GROUP]; 2],
    pub(super) stiffnesses: [[f64; GROUP]; 2],
    pub(super) dampings: [[f64; GROUP]; 2],
    pub(super) gaps: [f64; GROUP],
    pub(super) law: Law,
}

/// What acts between the two, in all scenes.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Law {
    /// e \[–\].
    Stereomechanical(f64),
    /// β̄ \[N/m^1.5\] and ξ̄ \[–\].
    Viscoelastic(f64, f64),
}

/// Peak displacements and the sum of the impulses of each scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct Found {
    pub(super) peaks: [[f64; GROUP]; 2],
    pub(super) impulses: [f64; GROUP],
}

/// Two towers in a group of scenes; their storeys from the ground up.
#[derive(Debug, Clone)]
pub(crate) struct Towers {
    pub(super) left: [[Storey<Bilinear>; STOREYS[0]]; GROUP],
    pub(super) right: [[Storey<Bilinear>; STOREYS[1]]; GROUP],
    pub(super) gaps: [f64; GROUP],
}

/// Peak displacements of all floors, those of the left tower first, peak drifts of storeys that stand on a floor, and the sum of the
/// impulses at each level.
#[derive(Debug, Clone, Copy)]
pub(super) struct FoundInTowers {
    pub(super) displacements: [[f64; GROUP]; FLOORS],
    pub(super) drifts: [[f64; GROUP]; FLOORS],
    pub(super) impulses: [[f64; GROUP]; LEVELS],
}

/// The widest instructions of this machine for which the loop is written.
pub(crate) fn instructions() -> Option<&'static str> {
    #[cfg(target_arch = "x86_64")]
    return steps::instructions();
    #[cfg(not(target_arch = "x86_64"))]
    None
}

/// Runs a group, with peaks and impulses or bare; nothing on a machine without [`instructions`].
#[cfg(target_arch = "x86_64")]
pub(super) fn run<const PEAKS: bool>(group: &Group, ground: &[f64], dt: f64) -> Option<Found> {
    steps::run::<PEAKS>(group, ground, dt)
}

/// Nothing: the loop is not written for this machine.
#[cfg(not(target_arch = "x86_64"))]
pub(super) fn run<const PEAKS: bool>(_: &Group, _: &[f64], _: f64) -> Option<Found> {
    None
}

/// Runs a group of towers; nothing on a machine without [`instructions`].
#[cfg(target_arch = "x86_64")]
pub(super) fn run_towers(
    towers: &Towers,
    law: Law,
    ground: &[f64],
    dt: f64,
) -> Option<FoundInTowers> {
    buildings::run(towers, law, ground, dt)
}

/// Nothing: the loop is not written for this machine.
#[cfg(not(target_arch = "x86_64"))]
pub(super) fn run_towers(_: &Towers, _: Law, _: &[f64], _: f64) -> Option<FoundInTowers> {
    None
}
