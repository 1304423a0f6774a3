use crate::{Impact, Motion, Recorder, Span};

/// Records the motion of every floor at the end of the run, relative to the ground.
///
/// If the run lasts until the free vibration has decayed, the displacement is the residual displacement. In a shorter run it contains the
/// vibration.
#[derive(Debug, Clone, PartialEq)]
pub struct LastStates(Vec<Motion>);

impl LastStates {
    /// A recorder for a row of `n_nodes`, walls included.
    pub fn new(n_nodes: usize) -> Self {
        Self(vec![Motion::default(); n_nodes])
    }

    /// Displacement \[m\] and velocity \[m/s\] of a floor at the end, by its node; 0 for a wall.
    pub fn of(&self, node: usize) -> Motion {
        self.0[node]
    }
}

impl Recorder for LastStates {
    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        self.0[span.structure] = (&span.end).into();
    }

    fn impact(&mut self, impact: &Impact) {
        for struck in impact.struck() {
            self.0[struck.floor].velocity = struck.velocities[1];
        }
    }
}
