use crate::sum::Sum;
use crate::{Impact, Path, Recorder, Span};

/// Records the transferred momentum of every floor: H = ∫ |net pounding force| dt \[N·s\].
///
/// The value belongs to a floor: neighbours at different levels of a building push at different floors, and their effects do not cancel. A
/// structure of one storey is a single floor.
///
/// Forces from both sides at an instant cancel before the magnitude is taken: a structure hit from left and right at once gets little.
/// Impulses over a span are those of the method. Impacts at an instant are summed first, together with the impulses of forces in the step
/// that ends there. A structure that rests between an impulsive and a compliant neighbour has an impact in every step, and the limit of
/// these impacts is a force.
#[derive(Debug, Clone, PartialEq)]
pub struct TransferredMomentum {
    structures: Vec<Transferred>,
}

#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Transferred {
    /// Momentum of past instants. The rounding of the pieces of the exact method is kept as well; lanes of stepping methods do not need it.
    closed: Sum,
    /// Net impulse at the instant `open_time`; its magnitude is added once the instant has passed.
    open: f64,
    open_time: f64,
}

impl TransferredMomentum {
    /// A recorder for a row of `n_structures` nodes, walls included.
    pub fn new(n_structures: usize) -> Self {
        Self {
            structures: vec![Transferred::default(); n_structures],
        }
    }

    /// Transferred momentum of a floor, by its node \[N·s\].
    pub fn of(&self, structure: usize) -> f64 {
        let sum = self.structures[structure];
        sum.closed.rounded() + sum.open.abs()
    }

    fn add(&mut self, structure: usize, impulse: f64, time: f64) {
        let sum = &mut self.structures[structure];
        if time > sum.open_time {
            sum.closed.value += sum.open.abs();
            sum.open = 0.0;
            sum.open_time = time;
        }
        sum.open += impulse;
    }
}

impl Recorder for TransferredMomentum {
    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        let impulse = span.impulse_from_left + span.impulse_from_right;
        match span.path {
            // If the net force changes sign in a step, only its values at the ends are known.
            Path::Cubic(_) if span.start.pounding_force() * span.end.pounding_force() < 0.0 => {
                let ends = span.start.pounding_force().abs() + span.end.pounding_force().abs();
                self.add(span.structure, 0.0, span.end_time);
                self.structures[span.structure].closed.value += 0.5 * span.duration() * ends;
            }
            Path::Cubic(_) => self.add(span.structure, impulse, span.end_time),
            // A series ends where the net force changes sign.
            Path::Series(_) | Path::Flight(_) => {
                let closed = &mut self.structures[span.structure].closed;
                *closed = closed.plus(impulse.abs());
            }
        }
    }

    fn impact(&mut self, impact: &Impact) {
        for struck in impact.struck() {
            self.add(struck.floor, struck.part * impact.impulse, impact.time);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{State, Struck, Velocities, Weighed};

    fn step(start: f64, end: f64, impulse_from_left: f64) -> Span<'static> {
        Span {
            structure: 1,
            start_time: start,
            end_time: end,
            start: State::default(),
            end: State::default(),
            impulse_from_left,
            impulse_from_right: 0.0,
            below: None,
            path: Path::Cubic(Weighed::default()),
            pushes: &[],
            links: &[],
        }
    }

    fn impact(time: f64, impulse: f64) -> Impact {
        let velocities = Velocities { left: 0.0, right: 0.0 };
        Impact {
            pair: 1,
            left: 1,
            right: 2,
            floors: [(1, -1.0), (2, 1.0), (0, 0.0), (0, 0.0)].map(|(floor, part)| {
                let velocities = [0.0; 2];
                let struck = Struck { floor, part, velocities };
                (part != 0.0).then_some(struck)
            }),
            time,
            impulse,
            before: velocities,
            after: velocities,
            opening_rate: 0.0,
        }
    }

    #[test]
    fn limit_an_impact_counts_net_of_the_forces_of_its_step() {
        let mut momentum = TransferredMomentum::new(3);
        for n in 0..3 {
            let (start, end) = (f64::from(n), f64::from(n + 1));
            momentum.span(&step(start, end, 5.0));
            momentum.impact(&impact(end, 4.0));
        }
        assert!((momentum.of(1) - 3.0).abs() < 1e-15, "{}", momentum.of(1));
        assert!((momentum.of(2) - 12.0).abs() < 1e-15, "{}", momentum.of(2));
    }
}
