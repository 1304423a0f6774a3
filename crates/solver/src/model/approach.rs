//! The approach speed of pairs in compliant contact, for laws with δ̇/v₀.

use crate::model::ground::Ground;
use crate::{Pair, State};

/// Approach speed of every pair of a run \[m/s\]; `None` while apart.
///
/// Kept for every compliant law: the cost is a comparison while a pair touches, and two kinds of laws would need more explanation.
pub(crate) struct Approaches(Vec<Option<f64>>);

impl Approaches {
    pub(crate) fn new(n_pairs: usize) -> Self {
        Self(vec![None; n_pairs])
    }

    /// Approach speed of a pair that overlaps: `rate` if this is the first overlap of the contact.
    ///
    /// Every method first finds an overlap at the end of a motion without contact force. This is the speed of the touch to first order in
    /// the time step.
    pub(crate) fn of(&mut self, pair: usize, rate: f64) -> f64 {
        speed(&mut self.0[pair], rate)
    }

    /// Ends the contact of a pair.
    pub(crate) fn forget(&mut self, pair: usize) {
        self.0[pair] = None;
    }

    /// Ends the contacts of all pairs that do not overlap at the end of a step.
    pub(crate) fn forget_parted(&mut self, pairs: &[Pair], states: &[State], ground: Ground<'_>) {
        for (speed, pair) in self.0.iter_mut().zip(pairs) {
            if speed.is_some() && ground.deformation_of(pair, states) <= 0.0 {
                *speed = None;
            }
        }
    }
}

/// The known speed, or else this rate; 0 for a pair that overlaps without having approached.
pub(crate) fn speed(known: &mut Option<f64>, rate: f64) -> f64 {
    *known.get_or_insert(rate.max(0.0))
}
