use crate::{Impact, Motion, Recorder, Span};

/// Records how every floor moves at the end of the run, relative to the ground.
///
/// Of a run that lasts until the free vibration has died away its displacement is the residual one; of a shorter one the vibration is
/// still in it.
#[derive(Debug, Clone, PartialEq)]
pub struct LastStates(Vec<Motion>);

impl LastStates {
    /// For a row of `n_nodes`, walls included.
    pub fn new(n_nodes: usize) -> Self {
        Self(vec![Motion::default(); n_nodes])
    }

    /// Displacement \[m\] and velocity \[m/s\] of one floor at the end, by its node; 0 of a wall.
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
