//! The buildings of a row standing alone: one run says what both directions of a motion do to them.

use super::peaks::{FloorPeaks, peaks};
use super::separation::{Separation, separations_of};
use crate::simulation::Extras;
use crate::{Error, Simulation};

/// Peaks and required gaps of a row whose buildings stand alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Alone {
    /// Of every floor.
    pub(super) floors: Vec<FloorPeaks>,
    /// What every gap needs in the direction of the run.
    own: Vec<Separation>,
    /// The same in the other direction; `None` if it takes a run of its own.
    other: Option<Vec<Separation>>,
    /// Whether the run was reversed.
    reversed: bool,
}

impl Simulation {
    /// Runs the buildings alone, by the exact method.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early, [`Error::Broken`] if it breaks a law of mechanics.
    pub fn alone(&self) -> Result<Alone, Error> {
        let apart = self.exact()?.apart()?;
        let mirrors = apart.mirrors();
        let run = apart.run_with(Extras {
            closings: true,
            reversed_closings: mirrors,
            ..Extras::default()
        })?;
        let of = |reversed: bool| {
            separations_of(&apart, &run, |left| {
                let closings = run.closings.as_ref()?;
                if reversed { closings.of_reversed(left) } else { closings.of(left) }
            })
        };
        Ok(Alone {
            floors: peaks(&apart, &run),
            own: of(false),
            other: mirrors.then(|| of(true)),
            reversed: self.is_reversed(),
        })
    }

    /// Whether the motion under reversed shaking is the mirror of the motion, to the last bit, while nothing touches: all begins at
    /// rest, and columns know no direction. Those that yield smoothly know one while they rest.
    fn mirrors(&self) -> bool {
        let mut floors = self.floors().all().iter();
        let rests = floors.all(|floor| {
            let initial = floor.made_of.map_or((0.0, 0.0), |made| made.initial);
            initial.0.abs() + initial.1.abs() <= 0.0
        });
        rests && !self.yields_smoothly()
    }

    pub(super) fn is_reversed(&self) -> bool {
        self.scene().record.reversed
    }
}

impl Alone {
    /// What every gap needs in a direction of the motion; `None` if that takes a run of its own.
    pub(super) fn separations(&self, reversed: bool) -> Option<&[Separation]> {
        if reversed == self.reversed {
            Some(&self.own)
        } else {
            self.other.as_deref()
        }
    }
}
