//! Buildings of a row that stand alone: one run usually gives the answer for both directions of a motion.

use pounding_scene::{Error, Excess, Extras, RunResult, Simulation, StoreyProperties};

use crate::peaks::FloorPeaks;
use crate::separation::Separation;

/// Peaks of a row whose buildings stand alone, and required gaps of the row with its links.
#[derive(Debug, Clone, PartialEq)]
pub struct Alone {
    /// Peaks of every floor.
    pub(crate) floors: Vec<FloorPeaks>,
    /// Required width of every gap in the direction of the run.
    own: Vec<Separation>,
    /// Required width of every gap in the opposite direction; `None` if that direction needs a separate run.
    other: Option<Vec<Separation>>,
    /// Responses that exceed the model or the limits of codes.
    pub(crate) excesses: Vec<Excess>,
    /// The drift or force of every building that is farthest above a capacity of the scene.
    pub(crate) over_capacity: Vec<Excess>,
    /// Whether the run was reversed.
    reversed: bool,
}

impl Alone {
    /// Runs the buildings of a row alone, by the exact method.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early, [`Error::Broken`] if it breaks a law of mechanics.
    pub fn of(simulation: &Simulation) -> Result<Self, Error> {
        let apart = simulation.exact()?.apart()?;
        let mirrors = mirrors(&apart);
        let run = apart.run_with(Extras {
            closings: true,
            reversed_closings: mirrors,
            ..Extras::default()
        })?;
        // Links change how floors come closer. What pounding does is measured against buildings without them.
        let alone =
            unlinked(&apart)?.map(|(alone, run)| (FloorPeaks::all(&alone, &run), alone.all_excesses(&run), alone.over_capacity(&run)));
        let separations = |reversed: bool| {
            let closings = run.closings.as_ref();
            closings.map_or_else(Vec::new, |closings| Separation::all(&apart, &run, closings, reversed))
        };
        let of_apart = || (FloorPeaks::all(&apart, &run), apart.all_excesses(&run), apart.over_capacity(&run));
        let (floors, excesses, over_capacity) = alone.unwrap_or_else(of_apart);
        Ok(Self {
            floors,
            own: separations(false),
            other: mirrors.then(|| separations(true)),
            excesses,
            over_capacity,
            reversed: simulation.scene().record.reversed,
        })
    }

    /// Required width of every gap in a direction of the motion; `None` if that direction needs a separate run.
    pub(crate) fn separations(&self, reversed: bool) -> Option<&[Separation]> {
        if reversed == self.reversed {
            Some(&self.own)
        } else {
            self.other.as_deref()
        }
    }
}

/// The buildings of a row that stands apart without its links, and their run; `None` if it has no links.
pub(crate) fn unlinked(apart: &Simulation) -> Result<Option<(Simulation, RunResult)>, Error> {
    if apart.scene().links.is_empty() {
        return Ok(None);
    }
    let alone = apart.unlinked()?;
    let run = alone.run_with(Extras::default())?;
    Ok(Some((alone, run)))
}

/// Whether reversed shaking mirrors the motion to the last bit while nothing touches. That holds if all floors begin at rest and all
/// columns and links behave alike in both directions. Columns that yield smoothly do not, even at rest, nor do restrainers.
fn mirrors(apart: &Simulation) -> bool {
    let mut floors = apart.floors().all().iter();
    let rests = floors.all(|floor| {
        let moves = |made: StoreyProperties| made.initial_displacement_m.abs() + made.initial_velocity_m_per_s.abs();
        floor.made_of.map_or(0.0, moves) <= 0.0
    });
    let has_sides = apart.scene().links.iter().any(|link| link.law.has_sides());
    rests && !has_sides && !apart.yields_smoothly()
}
