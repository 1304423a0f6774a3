//! What is compared: six quantities and a count.

use pounding_solver::{Collision, Collisions, Peaks, TransferredMomentum};

/// A quantity in which methods are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantity {
    FirstTime,
    FirstImpulse,
    Momentum,
    ContactPeak,
    Displacement,
    Shear,
}

impl Quantity {
    pub(crate) const ALL: [Self; 6] = [
        Self::FirstTime,
        Self::FirstImpulse,
        Self::Momentum,
        Self::ContactPeak,
        Self::Displacement,
        Self::Shear,
    ];

    /// Name in tables.
    pub(crate) fn key(self) -> &'static str {
        match self {
            Self::FirstTime => "time_of_first_collision",
            Self::FirstImpulse => "impulse_of_first_collision",
            Self::Momentum => "transferred_momentum",
            Self::ContactPeak => "peak_pounding_force_or_impulse",
            Self::Displacement => "peak_displacement",
            Self::Shear => "peak_shear_force",
        }
    }

    /// Name in figures; a compliant contact has a peak force, an impulsive one a peak impulse.
    pub(crate) fn words(self, compliant: bool) -> &'static str {
        match self {
            Self::FirstTime => "Time of first collision",
            Self::FirstImpulse => "Impulse of first collision",
            Self::Momentum => "Transferred momentum",
            Self::ContactPeak if compliant => "Peak pounding force",
            Self::ContactPeak => "Peak impulse",
            Self::Displacement => "Peak displacement",
            Self::Shear => "Peak shear force",
        }
    }

    /// SI unit.
    pub(crate) fn unit(self, compliant: bool) -> &'static str {
        match self {
            Self::FirstTime => "s",
            Self::FirstImpulse | Self::Momentum => "N·s",
            Self::ContactPeak if compliant => "N",
            Self::ContactPeak => "N·s",
            Self::Displacement => "m",
            Self::Shear => "N",
        }
    }
}

/// The quantities of a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Quantities {
    /// For each quantity a value, or one for each structure; none where nothing collides.
    values: [Vec<f64>; Quantity::ALL.len()],
    /// Number of collisions of all pairs; of an impulsive law, of impacts.
    pub(crate) n_collisions: usize,
}

/// What a run must record.
pub(crate) type Recorded = (Peaks, Collisions, TransferredMomentum);

impl Quantities {
    /// The quantities of a run of so many structures.
    pub(crate) fn of((peaks, collisions, momentum): &Recorded, n_structures: usize) -> Self {
        let all = collisions.all();
        let first = all.first();
        let contact = |collision: &Collision| collision.peak_force.unwrap_or(collision.impulse);
        let structures = 0..n_structures;
        let values = Quantity::ALL.map(|quantity| {
            let structures = structures.clone();
            match quantity {
                Quantity::FirstTime => first.map(|first| first.start).into_iter().collect(),
                Quantity::FirstImpulse => first.map(|first| first.impulse).into_iter().collect(),
                Quantity::ContactPeak => all
                    .iter()
                    .map(contact)
                    .reduce(f64::max)
                    .into_iter()
                    .collect(),
                Quantity::Momentum if all.is_empty() => Vec::new(),
                Quantity::Momentum => structures.map(|index| momentum.of(index)).collect(),
                Quantity::Displacement => structures
                    .map(|index| peaks.of(index).displacement.value.abs())
                    .collect(),
                Quantity::Shear => structures
                    .map(|index| peaks.of(index).restoring_force.value.abs())
                    .collect(),
            }
        });
        Self {
            values,
            n_collisions: all.len(),
        }
    }

    /// Values of a quantity: one, or one for each structure from the left; none where nothing collides.
    pub(crate) fn values(&self, quantity: Quantity) -> &[f64] {
        &self.values[quantity as usize]
    }

    /// Relative distance from other quantities, of the structure where it is largest \[–\].
    ///
    /// Infinite where only one of both has a collision, or a structure is hit in one of both; nothing where neither
    /// has one.
    pub(crate) fn distance(&self, truth: &Self, quantity: Quantity) -> Option<f64> {
        let (found, wanted) = (self.values(quantity), truth.values(quantity));
        if found.len() != wanted.len() {
            return Some(f64::INFINITY);
        }
        let distances = found.iter().zip(wanted).map(|(found, wanted)| {
            let difference = (found - wanted).abs();
            if difference == 0.0 {
                0.0
            } else {
                difference / wanted.abs()
            }
        });
        distances.reduce(f64::max)
    }
}
