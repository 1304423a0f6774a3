//! How the structures of a row advance from a node; chosen once per run.

use fearless_simd::Simd;

use super::column::SideBySideColumn;
use super::number::Lanes;
use super::rows::Rows;
use super::scenes::Structure;

/// How the structures of rows of a common shape, or the floors of their buildings, advance from a node under a ground acceleration
/// \[m/s²\].
pub(super) trait Frame<S: Simd, Column: SideBySideColumn>: Sized {
    /// A frame for rows and a time step \[s\].
    fn of(simd: S, rows: Rows<'_, Column>, time_step: f64) -> Self;

    /// Place of the structure of a node among the structures.
    fn place(&self, node: usize) -> usize;

    /// The node of the structure at a place.
    fn node(&self, place: usize) -> usize;

    /// Begins a run on a ground with this acceleration at t = 0 \[m/s²\].
    fn begin(&self, structures: &mut [Structure<S, Column>], ground: Lanes<S>);

    /// The step from a node at which no lane touches.
    fn step(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>);

    /// The step from a node at which some lane touches. `jumps` keeps the state from which velocity jumps start.
    fn step_in_contact(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>, jumps: bool);

    /// Restarts the structures that impacts have hit, and those to which dashpots pass them on, from their new velocities.
    fn restart(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>);

    /// Drift of largest magnitude of the storey below the floor at a place, in a lane \[m\]; `None` if lanes cannot decide its sign.
    fn peak_drift(&self, structures: &[Structure<S, Column>], place: usize, lane: usize) -> Option<f64>;
}

/// Structures of one storey, each separate.
pub(super) struct Single;

impl<S: Simd, Column: SideBySideColumn> Frame<S, Column> for Single {
    #[inline(always)]
    fn of(_: S, _: Rows<'_, Column>, _: f64) -> Self {
        Self
    }

    #[inline(always)]
    fn place(&self, node: usize) -> usize {
        node
    }

    #[inline(always)]
    fn node(&self, place: usize) -> usize {
        place
    }

    #[inline(always)]
    fn begin(&self, structures: &mut [Structure<S, Column>], ground: Lanes<S>) {
        for structure in structures {
            structure.begin(structure.acceleration(ground));
        }
    }

    #[inline(always)]
    fn step(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>) {
        for structure in structures {
            structure.step(ground);
        }
    }

    #[inline(always)]
    fn step_in_contact(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>, jumps: bool) {
        for structure in structures {
            if structure.contact.is_near || jumps {
                structure.step_in_contact(ground, jumps);
            } else {
                structure.step(ground);
            }
        }
    }

    #[inline(always)]
    fn restart(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>) {
        for structure in structures {
            let lanes = structure.contact.restarts();
            structure.restart(structure.acceleration(ground), lanes);
        }
    }

    #[inline(always)]
    fn peak_drift(&self, structures: &[Structure<S, Column>], place: usize, lane: usize) -> Option<f64> {
        structures[place].motion.peak(lane)
    }
}
