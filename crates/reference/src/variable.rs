//! The variables of integration.

/// The variable of a step. Within the step it runs from 0 to the step's length.
#[derive(Debug, Clone, Copy)]
pub(super) enum Variable {
    /// Time.
    Time,
    /// σ = ⁴√(t − t of first touch); a force that starts like δ^(1/4) is analytic in σ.
    RootOfTime {
        /// First touch on the clock of the segment \[s\].
        touch: f64,
        /// σ at the start of the step.
        start: f64,
    },
    /// s = √δ of a pair on its way to parting, counted backwards. δ^1.5 is analytic in s, and the step ends exactly at the parting.
    RootOfDeformation {
        /// The pair.
        pair: usize,
        /// s at the start of the step \[√m\].
        start: f64,
    },
}

/// Fourth root of a number ≥ 0.
pub(super) fn fourth_root(value: f64) -> f64 {
    value.sqrt().sqrt()
}

impl Variable {
    /// Variable that starts now, at a time after the first touch.
    pub(super) fn since(touch: f64, now: f64) -> Self {
        Self::RootOfTime {
            touch,
            start: fourth_root((now - touch).max(0.0)),
        }
    }

    /// Time per unit of the variable, `position` after the start of the step, from the deformation rate.
    pub(super) fn pace(self, position: f64, rate: impl Fn(usize) -> f64) -> f64 {
        match self {
            Self::Time => 1.0,
            Self::RootOfTime { start, .. } => {
                let root = start + position;
                4.0 * root * root * root
            }
            // Infinite if the pair reverses before it parts: the step is then rejected.
            Self::RootOfDeformation { pair, start } => 2.0 * (start - position) / -rate(pair),
        }
    }

    /// Deformation of a pair from the variable, which is more accurate than the displacements.
    pub(super) fn deformation(self, of: usize, position: f64) -> Option<f64> {
        match self {
            Self::RootOfDeformation { pair, start } if pair == of => Some((start - position) * (start - position)),
            Self::Time | Self::RootOfTime { .. } | Self::RootOfDeformation { .. } => None,
        }
    }
}
