use crate::{Impact, Recorder, Span};

/// Records where every floor is at the end of the run, relative to the ground \[m\].
///
/// Of a run that lasts until the free vibration has died away it is the residual displacement; of a shorter one the
/// vibration is still in it.
#[derive(Debug, Clone, PartialEq)]
pub struct LastDisplacements(Vec<f64>);

impl LastDisplacements {
    /// For a row of `n_nodes`, walls included.
    pub fn new(n_nodes: usize) -> Self {
        Self(vec![0.0; n_nodes])
    }

    /// Displacement of one floor at the end, by its node \[m\]; 0 of a wall.
    pub fn of(&self, node: usize) -> f64 {
        self.0[node]
    }
}

impl Recorder for LastDisplacements {
    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        self.0[span.structure] = span.end.displacement;
    }

    fn impact(&mut self, _: &Impact) {}
}
