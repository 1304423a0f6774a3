//! What runs are asked for, in one recorder.

use crate::{
    Closings, Collisions, FloorAccelerations, Histories, Impact, LastStates, Ledger, Pair, Peaks, Recorder, Span, Touch,
    TransferredMomentum,
};

/// The recorders of a run of an [`AnyRow`](crate::AnyRow).
///
/// They are of one type, so that all methods are compiled once. Any other recorder, or a tuple of some, compiles those that it is
/// given to anew ([`Integrator::run`](crate::Integrator::run)).
#[derive(Debug)]
pub struct Recorders<'l, 'a> {
    /// Peaks of every structure.
    pub peaks: Peaks,
    /// Collisions of every pair.
    pub collisions: Collisions,
    /// Transferred momentum of every structure.
    pub momentum: TransferredMomentum,
    /// Peak absolute accelerations of every floor, where asked for.
    pub accelerations: Option<FloorAccelerations<'a>>,
    /// Where every floor is at the end, where asked for.
    pub last: Option<LastStates>,
    /// How far neighbours came towards each other, where asked for.
    pub closings: Option<Closings>,
    /// Histories of every structure, where asked for.
    pub histories: Option<Histories>,
    /// Energy and impulses, where asked for.
    pub ledger: Option<&'l mut Ledger<'a>>,
}

impl Recorders<'_, '_> {
    /// Those of what is printed of a structure or a pair, for a row of `n_nodes`, walls included, with these pairs.
    pub fn usual(n_nodes: usize, pairs: &[Pair]) -> Self {
        Self {
            peaks: Peaks::new(n_nodes),
            collisions: Collisions::new(n_nodes, pairs),
            momentum: TransferredMomentum::new(n_nodes),
            accelerations: None,
            last: None,
            closings: None,
            histories: None,
            ledger: None,
        }
    }

    fn all(&mut self) -> impl Recorder {
        let usual = (&mut self.peaks, &mut self.collisions, &mut self.momentum);
        let asked = (&mut self.ledger, &mut self.accelerations, &mut self.last);
        (usual, asked, &mut self.closings, &mut self.histories)
    }
}

impl Recorder for Recorders<'_, '_> {
    #[inline]
    fn reads_weighed(&self) -> bool {
        self.ledger.is_some()
    }

    fn span(&mut self, span: &Span<'_>) {
        self.all().span(span);
    }

    fn impact(&mut self, impact: &Impact) {
        self.all().impact(impact);
    }

    fn touch(&mut self, touch: &Touch) {
        self.all().touch(touch);
    }
}
