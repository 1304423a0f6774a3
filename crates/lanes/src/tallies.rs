//! What many scenes side by side leave.

/// Displacements that no structure reaches \[m\]: the scene grows without bound, and what its numbers round to breaks laws. Far below, a step
/// rounds less than what methods take for a touch.
const FARTHEST: f64 = 1e3;

/// What happened to one pair of a scene.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PairSums {
    /// Number of collisions, as [`Collisions`](pounding_solver::Collisions) counts them.
    pub collisions: f64,
    /// Sum of their impulses \[N·s\].
    pub impulse: f64,
    /// The largest of them \[N·s\].
    pub largest_impulse: f64,
    /// Largest pounding force \[N\] of a compliant pair; 0 of an impulsive one, whose force has no limit.
    pub peak_force: f64,
    /// Largest displacement of the left neighbour less that of the right one \[m\], as [`Closings`](pounding_solver::Closings) finds it; nothing
    /// unless asked for.
    pub closing: Option<f64>,
}

/// What happened in many scenes of one shape, in their order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SceneSums {
    pub(super) n_structures: usize,
    pub(super) n_pairs: usize,
    displacements: Vec<f64>,
    drifts: Vec<f64>,
    pub(super) pairs: Vec<PairSums>,
    pub(super) told: Vec<bool>,
    doubted: Vec<bool>,
    /// Steps of groups of scenes, as many as a vector of the machine has lanes.
    pub steps: u64,
    /// Those of them in which some scene of the group touched.
    pub touching_steps: u64,
}

impl SceneSums {
    /// Displacement of the largest magnitude of a structure, or of a floor of a building \[m\], with its sign.
    pub fn displacement(&self, scene: usize, structure: usize) -> f64 {
        self.displacements[scene * self.n_structures + structure]
    }

    /// Drift of the largest magnitude of the storey below a floor \[m\], with its sign; on the ground it is the displacement.
    pub fn drift(&self, scene: usize, floor: usize) -> f64 {
        self.drifts[scene * self.n_structures + floor]
    }

    /// What happened to a pair.
    pub fn pair(&self, scene: usize, pair: usize) -> PairSums {
        self.pairs[scene * self.n_pairs + pair]
    }

    /// Whether what happened in a scene is known. It is not where structures have gone further than any does, or a floor or
    /// a storey has gone as far to the left as to the right, so that only the order tells the sign of its peak: a run of the scene alone
    /// says.
    pub fn is_told(&self, scene: usize) -> bool {
        self.told[scene]
    }

    /// Whether the books of its contacts leave open that a scene breaks a law of mechanics: a run of it alone says.
    ///
    /// By stepping methods they book compliant collisions as a [`Ledger`](pounding_solver::Ledger) does, and doubt a little more than it refuses.
    /// Impacts are not booked: every round of them takes energy, or leaves it, as e is 1 at most and no impulse pulls. Nor is the exact
    /// method, which carries impacts and contacts to rounding or tolerance, under laws that take energy and never pull.
    pub fn is_doubted(&self, scene: usize) -> bool {
        self.doubted[scene]
    }

    pub(super) fn doubt(&mut self, scene: usize) {
        self.doubted[scene] = true;
    }

    /// Makes room for so many scenes, with so many structures and pairs each; none is told.
    pub fn begin(&mut self, n_scenes: usize, (n_structures, n_pairs): (usize, usize)) {
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

    /// Takes a scene of others, of the same shape, as one of its own.
    pub fn take(&mut self, scene: usize, (others, place): (&Self, usize)) {
        let range = |place: usize, n: usize| place * n..(place + 1) * n;
        let (own, its) = (range(scene, self.n_structures), range(place, self.n_structures));
        self.displacements[own.clone()].copy_from_slice(&others.displacements[its.clone()]);
        self.drifts[own].copy_from_slice(&others.drifts[its]);
        let (own, its) = (range(scene, self.n_pairs), range(place, self.n_pairs));
        self.pairs[own].copy_from_slice(&others.pairs[its]);
        self.told[scene] = others.told[place];
        self.doubted[scene] = others.doubted[place];
    }

    /// Takes displacement and drift of largest magnitude of a floor of a scene \[m\]; without one of them the scene is not told.
    pub(super) fn take_floor(&mut self, scene: usize, node: usize, peaks: [Option<f64>; 2]) {
        let [displacement, drift] = peaks.map(|peak| peak.unwrap_or(f64::NAN));
        self.displacements[scene * self.n_structures + node] = displacement;
        self.drifts[scene * self.n_structures + node] = drift;
        // The first of a scene says, and any other may take it back.
        let is_known = |peak: f64| peak.abs() < FARTHEST;
        let known = peaks.iter().all(|peak| peak.is_some_and(is_known));
        self.told[scene] = known && (node == 0 || self.told[scene]);
    }

    /// Takes what happened to a pair of a scene.
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
