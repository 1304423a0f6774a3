//! Results of many scenes in lanes.

/// Displacements that no structure reaches \[m\]: beyond, the scene grows without bound, and its rounding breaks laws. Far below, the
/// rounding of a step is less than the tolerance of a touch.
const FARTHEST: f64 = 1e3;

/// Results of a pair of a scene.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PairSums {
    /// Number of collisions, counted as in [`Collisions`](pounding_solver::Collisions).
    pub collisions: f64,
    /// Sum of the impulses of the collisions \[N·s\].
    pub impulse: f64,
    /// Largest impulse of a collision \[N·s\].
    pub largest_impulse: f64,
    /// Largest pounding force \[N\] of a compliant pair; 0 for an impulsive pair, whose force is unbounded.
    pub peak_force: f64,
    /// Largest displacement of the left neighbour minus that of the right neighbour \[m\], as in [`Closings`](pounding_solver::Closings);
    /// `None` unless requested.
    pub closing: Option<f64>,
}

/// Results of many scenes of a common shape, in their order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SceneSums {
    pub(super) n_structures: usize,
    pub(super) n_pairs: usize,
    displacements: Vec<f64>,
    drifts: Vec<f64>,
    pub(super) pairs: Vec<PairSums>,
    pub(super) told: Vec<bool>,
    doubted: Vec<bool>,
    /// Steps of groups of scenes; a group has as many scenes as a vector has lanes.
    pub steps: u64,
    /// Steps in which some scene of the group touched.
    pub touching_steps: u64,
}

impl SceneSums {
    /// Displacement of largest magnitude of a structure, or of a floor of a building \[m\], with its sign.
    pub fn displacement(&self, scene: usize, structure: usize) -> f64 {
        self.displacements[scene * self.n_structures + structure]
    }

    /// Drift of largest magnitude of the storey below a floor \[m\], with its sign; on the ground, the displacement.
    pub fn drift(&self, scene: usize, floor: usize) -> f64 {
        self.drifts[scene * self.n_structures + floor]
    }

    /// Results of a pair.
    pub fn pair(&self, scene: usize, pair: usize) -> PairSums {
        self.pairs[scene * self.n_pairs + pair]
    }

    /// Whether the lanes know the results of a scene. If not, the scene needs a separate run.
    ///
    /// The results are unknown if a structure has moved beyond all bounds. They are also unknown if a floor or a storey has moved equally
    /// far to both sides, because the sign of its peak then depends on the order.
    pub fn is_told(&self, scene: usize) -> bool {
        self.told[scene]
    }

    /// Whether the books of a scene's contacts cannot exclude that it breaks a law of mechanics. The scene then needs a separate run.
    ///
    /// In stepping methods the books treat compliant collisions like a [`Ledger`](pounding_solver::Ledger), and doubt a little more than it
    /// refuses. Impacts are not booked: no round of impacts adds energy, because e is at most 1 and no impulse pulls. The exact method is
    /// not booked either: it computes impacts and contacts to rounding or tolerance, under laws that take energy and never pull.
    pub fn is_doubted(&self, scene: usize) -> bool {
        self.doubted[scene]
    }

    pub(super) fn doubt(&mut self, scene: usize) {
        self.doubted[scene] = true;
    }

    /// Makes room for `n_scenes` scenes with these numbers of structures and pairs; none is told yet.
    pub fn begin(&mut self, n_scenes: usize, n_structures: usize, n_pairs: usize) {
        (self.n_structures, self.n_pairs) = (n_structures, n_pairs);
        self.displacements.clear();
        self.displacements.resize(n_scenes * n_structures, 0.0);
        self.drifts.clear();
        self.drifts.resize(n_scenes * n_structures, 0.0);
        self.pairs.clear();
        self.pairs.resize(n_scenes * n_pairs, PairSums::default());
        self.told.clear();
        self.told.resize(n_scenes, false);
        self.doubted.clear();
        self.doubted.resize(n_scenes, false);
        (self.steps, self.touching_steps) = (0, 0);
    }

    /// Copies a scene from the results of others of this shape.
    pub fn take(&mut self, scene: usize, others: &Self, place: usize) {
        let range = |place: usize, n: usize| place * n..(place + 1) * n;
        let (own, its) = (range(scene, self.n_structures), range(place, self.n_structures));
        self.displacements[own.clone()].copy_from_slice(&others.displacements[its.clone()]);
        self.drifts[own].copy_from_slice(&others.drifts[its]);
        let (own, its) = (range(scene, self.n_pairs), range(place, self.n_pairs));
        self.pairs[own].copy_from_slice(&others.pairs[its]);
        self.told[scene] = others.told[place];
        self.doubted[scene] = others.doubted[place];
    }

    /// Sets the displacement and drift of largest magnitude of a floor of a scene \[m\]. If either is `None`, the scene is not told.
    pub(super) fn take_floor(&mut self, scene: usize, node: usize, peaks: [Option<f64>; 2]) {
        let [displacement, drift] = peaks.map(|peak| peak.unwrap_or(f64::NAN));
        self.displacements[scene * self.n_structures + node] = displacement;
        self.drifts[scene * self.n_structures + node] = drift;
        // The first floor of a scene marks it as known, and any other floor may revoke this.
        let is_known = |peak: f64| peak.abs() < FARTHEST;
        let known = peaks.iter().all(|peak| peak.is_some_and(is_known));
        self.told[scene] = known && (node == 0 || self.told[scene]);
    }

    /// Sets the results of a pair of a scene.
    pub(super) fn take_pair(&mut self, scene: usize, pair: usize, tally: PairSums) {
        self.pairs[scene * self.n_pairs + pair] = tally;
    }

    /// Number of scenes.
    pub fn len(&self) -> usize {
        self.told.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.told.is_empty()
    }
}
