//! All results that runs can be asked for, in a single recorder.

use crate::{
    Closings, Collisions, DriftRates, FloorAccelerations, Histories, Impact, LastStates, Ledger, LinkPeaks, Pair, Peaks, Recorder, Span,
    Touch, TransferredMomentum,
};

/// The recorders of a run of an [`AnyRow`](crate::AnyRow).
///
/// They have a single type, so that all methods are compiled once. Any other recorder, or a tuple of recorders, compiles its methods again
/// ([`Integrator::run`](crate::Integrator::run)).
#[derive(Debug)]
pub struct Recorders<'l, 'a> {
    /// Peaks of every structure.
    pub peaks: Peaks,
    /// Collisions of every pair.
    pub collisions: Collisions,
    /// Transferred momentum of every structure.
    pub momentum: TransferredMomentum,
    /// Peak absolute accelerations of every floor, if requested.
    pub accelerations: Option<FloorAccelerations<'a>>,
    /// Peaks of every link; `None` if the row has none.
    pub links: Option<LinkPeaks>,
    /// State of every floor at the end, if requested.
    pub last: Option<LastStates>,
    /// Largest closing of neighbours, if requested.
    pub closings: Option<Closings>,
    /// Peak drift rates of every storey, if requested.
    pub drift_rates: Option<DriftRates>,
    /// Histories of every structure, if requested.
    pub histories: Option<Histories>,
    /// Energy and impulses, if requested.
    pub ledger: Option<&'l mut Ledger<'a>>,
}

impl Recorders<'_, '_> {
    /// The recorders of the standard output, for a row of `n_nodes`, walls included, with these pairs.
    pub fn usual(n_nodes: usize, pairs: &[Pair]) -> Self {
        Self {
            peaks: Peaks::new(n_nodes),
            collisions: Collisions::new(n_nodes, pairs),
            momentum: TransferredMomentum::new(n_nodes),
            accelerations: None,
            links: None,
            last: None,
            closings: None,
            drift_rates: None,
            histories: None,
            ledger: None,
        }
    }

    fn all(&mut self) -> impl Recorder {
        let usual = (&mut self.peaks, &mut self.collisions, &mut self.momentum);
        let asked = (&mut self.ledger, &mut self.accelerations, &mut self.last);
        let more = (&mut self.closings, &mut self.drift_rates, &mut self.links);
        (usual, asked, more, &mut self.histories)
    }
}

impl Recorder for Recorders<'_, '_> {
    #[inline]
    fn reads_weighed(&self) -> bool {
        self.ledger.is_some()
    }

    #[inline]
    fn fallen(&self) -> Option<(usize, f64)> {
        self.peaks.fallen()
    }

    fn falls_at(&self, structure: usize) -> f64 {
        self.peaks.falls_at(structure)
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
