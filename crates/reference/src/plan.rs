//! Plan of a step.

use super::equations::{Equations, NOW};
use super::events::Event;
use super::model::TIME;
use super::phases::{ContactPhase, PairPhase};
use super::variable::{Variable, fourth_root};

/// Plan of the next step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plan {
    pub variable: Variable,
    /// Length in the variable.
    pub length: f64,
    /// Event at the end of the full length, met exactly.
    pub target: Option<Event>,
}

impl Plan {
    /// A step of at most `longest` \[s\], within the segment.
    pub(super) fn new(motion: &Equations, y: &[f64], variable: Variable, longest: f64) -> Self {
        let remaining = motion.segment.length - y[TIME];
        // A step that would leave a tiny rest of the segment includes it.
        let (duration, target) = if longest > 0.999 * remaining {
            (remaining, Some(Event::SegmentEnd))
        } else {
            (longest, None)
        };
        let (length, target) = match variable {
            Variable::Time => (duration, target),
            Variable::RootOfTime { touch, start } => {
                let end = fourth_root(y[TIME] + duration - touch);
                // end − start, without cancellation.
                let length = duration / ((end * end + start * start) * (end + start));
                (length, target)
            }
            Variable::RootOfDeformation { pair, start } => {
                let deformation = start * start;
                let left = deformation + motion.model.rate(pair, y) * longest;
                if left < 0.01 * deformation {
                    (start, Some(Event::Part(pair)))
                } else {
                    ((deformation - left) / (start + left.sqrt()), None)
                }
            }
        };
        Self { variable, length, target }
    }

    pub(super) fn shorten(&mut self, length: f64) {
        self.length = length;
        self.target = None;
    }
}

/// Longest time to a parting that a rate can tell \[s\].
const LATEST: f64 = 1e3;

/// The variable in which the next motion is smoothest.
///
/// `scratch` receives a derivative of the unknowns.
pub(super) fn variable(motion: &Equations, y: &[f64], scratch: &mut [f64]) -> Variable {
    let pairs = &motion.phases.pairs;
    let touches = pairs.iter().filter_map(|phase| match phase.contact {
        ContactPhase::Approach { touch, .. } => touch,
        ContactPhase::Apart | ContactPhase::Restitution { .. } | ContactPhase::Clamped | ContactPhase::Resting { .. } => None,
    });
    if let Some(touch) = touches.max_by(f64::total_cmp) {
        return Variable::since(touch, y[TIME]);
    }
    let returns = |phase: &PairPhase| matches!(phase.contact, ContactPhase::Restitution { .. });
    if !pairs.iter().any(returns) {
        return Variable::Time;
    }
    motion.slope(NOW, y, scratch);
    let parting = pairs.iter().enumerate().filter_map(|(index, phase)| {
        let deformation = motion.model.deformation(index, y);
        let rate = motion.model.rate(index, y);
        let acceleration = motion.model.rate(index, scratch);
        // The pair certainly parts: at this acceleration the rate would vanish long after the deformation. Between floors that friction
        // holds the rate is rounding.
        let soon = rate < 0.0 && deformation < -rate * LATEST;
        let parts = returns(phase) && deformation > 0.0 && soon && rate * rate > 2.0 * deformation * acceleration.abs();
        parts.then_some((index, deformation, deformation / -rate))
    });
    match parting.min_by(|left, right| left.2.total_cmp(&right.2)) {
        Some((pair, deformation, _)) => Variable::RootOfDeformation {
            pair,
            start: deformation.sqrt(),
        },
        None => Variable::Time,
    }
}
