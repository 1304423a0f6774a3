use crate::{Impact, Path, Recorder, Span};

/// Records the transferred momentum of every structure: H = ∫ |net pounding force| dt \[N·s\].
///
/// Forces from both sides at one instant cancel before the magnitude is taken, so a structure hit from left and right
/// at once gets little. Impulses over a span are the method's own; impacts of one instant are summed first, and with what
/// forces did in the step that ends there: a structure that rests between an impulsive and a compliant neighbour gets an
/// impact in every step, whose limit is a force.
#[derive(Debug, Clone, PartialEq)]
pub struct TransferredMomentum {
    structures: Vec<Sum>,
}

#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Sum {
    closed: f64,
    /// Net impulse of the instant `open_time`; its magnitude counts once the instant has passed.
    open: f64,
    open_time: f64,
}

impl TransferredMomentum {
    /// For a row of `n_structures`, walls included.
    pub fn new(n_structures: usize) -> Self {
        Self {
            structures: vec![Sum::default(); n_structures],
        }
    }

    /// Transferred momentum of one structure, counted from the left \[N·s\].
    pub fn of(&self, structure: usize) -> f64 {
        let sum = self.structures[structure];
        sum.closed + sum.open.abs()
    }

    fn add(&mut self, structure: usize, impulse: f64, time: f64) {
        let sum = &mut self.structures[structure];
        if time > sum.open_time {
            sum.closed += sum.open.abs();
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
            // All that is known of a step in which the net force changes its sign are its ends.
            Path::Cubic(_) if span.start.pounding_force() * span.end.pounding_force() < 0.0 => {
                let ends = span.start.pounding_force().abs() + span.end.pounding_force().abs();
                self.add(span.structure, 0.0, span.end_time);
                self.structures[span.structure].closed += 0.5 * span.duration() * ends;
            }
            Path::Cubic(_) => self.add(span.structure, impulse, span.end_time),
            // A series ends where the net force changes its sign.
            Path::Series(_) => self.structures[span.structure].closed += impulse.abs(),
        }
    }

    fn impact(&mut self, impact: &Impact) {
        self.add(impact.left, -impact.impulse, impact.time);
        self.add(impact.right, impact.impulse, impact.time);
    }
}
