//! Buildings of a row that stand alone: one run usually gives the answer for both directions of a motion.

use pounding_scene::{Error, Excess, Extras, Simulation, StoreyProperties};

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
    /// Responses of the row with its links that exceed the model or the limits of codes.
    pub(crate) excesses: Vec<Excess>,
    /// The drift or force of every building of the row with its links that is farthest above a capacity of the scene.
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
        let floors = if apart.scene().links.is_empty() {
            FloorPeaks::all(&apart, &run)
        } else {
            let alone = apart.unlinked()?;
            FloorPeaks::all(&alone, &alone.run_with(Extras::default())?)
        };
        let separations = |reversed: bool| {
            let closings = run.closings.as_ref();
            closings.map_or_else(Vec::new, |closings| Separation::all(&apart, &run, closings, reversed))
        };
        Ok(Self {
            floors,
            own: separations(false),
            other: mirrors.then(|| separations(true)),
            excesses: apart.all_excesses(&run),
            over_capacity: apart.over_capacity(&run),
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
