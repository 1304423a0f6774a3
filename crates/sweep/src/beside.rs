//! Runs several scenes of a sweep at once in SIMD lanes, if the method and the outputs allow it.

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::Sweep;
use super::output::Output;
use crate::side_by_side::{alone_because, side_by_side};
use pounding_lanes::{PairSums, SceneSums};
use pounding_scene::{Floor, FloorQuantity, PairOutcome, PairQuantity, Quantity, RunValues, Simulation};
use pounding_solver::Pair;

impl Sweep {
    /// Runs prepared scenes in lanes. Returns `None` if they cannot run in lanes.
    pub(super) fn beside(&self, ready: &[(u64, Box<Simulation>)]) -> Option<SceneSums> {
        if !self.asks_for_tallies() {
            return None;
        }
        let scenes: Vec<_> = ready.iter().map(|(_, prepared)| &**prepared).collect();
        catch_unwind(AssertUnwindSafe(|| side_by_side(&scenes, self.closings)))
            .ok()
            .flatten()
    }

    /// Whether lanes can run this sweep: they can compute every requested number, which are peaks and sums, and the scene sets no limit
    /// that needs separate runs.
    pub(super) fn asks_for_tallies(&self) -> bool {
        self.untallied().is_none() && self.limit().is_none()
    }

    /// Returns the first requested number that lanes cannot compute.
    fn untallied(&self) -> Option<&Output> {
        self.outputs.iter().find(|output| tallied(output.quantity).is_none())
    }

    /// Returns the name of a limit in the scene's budget that lanes cannot obey: `pieces` or `seconds`.
    fn limit(&self) -> Option<&'static str> {
        let budget = self.scene.get("budget");
        let is_named = |name: &&str| {
            let cost = budget.and_then(|budget| budget.get(name));
            cost.is_some_and(|cost| !cost.is_null())
        };
        ["pieces", "seconds"].into_iter().find(is_named)
    }

    /// Says why every scene must run separately, which takes many times as long. It tests one typical scene. Returns `None` if that scene
    /// can run in lanes, or cannot be prepared.
    pub fn alone_because(&self) -> Option<String> {
        if let Some(output) = self.untallied() {
            return Some(format!(
                "`{}` in the `outputs` needs separate runs: lanes do not compute it",
                output.quantity.about().name
            ));
        }
        if let Some(limit) = self.limit() {
            return Some(format!(
                "`{limit}` in the `budget` limits a single run, so the runs cannot share lanes"
            ));
        }
        let typical = self.plan.typical();
        let typical = self.prepared(self.motions.longest(), &typical, &mut self.scene.clone());
        alone_because(&typical.ok()?, self.closings).map(String::from)
    }

    /// Appends the numbers of a scene to `numbers`, in the order of the columns. If least openings are requested, it also appends to
    /// `least` the smallest magnitude by which each error is divided.
    ///
    /// Returns false if the lanes have no results for the scene, or doubt them and a verdict is requested. Also returns false if a storey comes
    /// near a collapse, which ends a run. The scene then runs separately.
    pub(super) fn tell(
        &self,
        prepared: &Simulation,
        tallies: &SceneSums,
        scene: usize,
        numbers: &mut Vec<f64>,
        least: &mut Vec<f64>,
    ) -> bool {
        let falls = |floor: usize| tallies.drift(scene, floor).abs() >= NEAR_COLLAPSE * prepared.collapse_drift_m(floor);
        let unknown = !tallies.is_told(scene) || (0..prepared.floors().all().len()).any(falls);
        if unknown || (self.verdict && tallies.is_doubted(scene)) {
            return false;
        }
        for output in &self.outputs {
            let (number, counts_as) = output.severest(|place| {
                let quantity = output.asked_of(prepared.floors(), place);
                let one = One {
                    prepared,
                    tallies,
                    scene,
                    place,
                };
                let number = tallied(quantity).and_then(|take| take(&one));
                (number.unwrap_or(f64::NAN), one.least(quantity))
            });
            numbers.push(number);
            if self.closings {
                least.push(counts_as);
            }
        }
        true
    }
}

/// Part of the drift of a collapse \[–\] above which a run alone decides: by the exact method the drift in lanes has an error of about the
/// tolerance.
const NEAR_COLLAPSE: f64 = 0.9;

/// A floor or a pair of a scene that ran in lanes.
struct One<'a> {
    prepared: &'a Simulation,
    tallies: &'a SceneSums,
    scene: usize,
    place: usize,
}

/// A function that reads a number from the results of the lanes. It returns `None` if the floor or pair has no such number.
type Take = fn(&One<'_>) -> Option<f64>;

/// The numbers that lanes compute. Every other number needs a separate run.
const TALLIED: &[(Quantity, Take)] = &[
    (Quantity::Floor(FloorQuantity::PeakDisplacementM), |one| {
        let displacement = one.tallies.displacement(one.scene, one.place);
        (!one.floor().is_wall()).then_some(displacement)
    }),
    (Quantity::Floor(FloorQuantity::PeakDriftM), |one| {
        one.floor().is_upper().then_some(one.drift())
    }),
    (Quantity::Floor(FloorQuantity::Ductility), |one| one.floor().ductility(one.drift())),
    (Quantity::Floor(FloorQuantity::DriftRatio), |one| {
        one.floor().drift_ratio(one.drift())
    }),
    // Runs that collapse go alone.
    (Quantity::Floor(FloorQuantity::CollapseS), |_| None),
    (Quantity::Pair(PairQuantity::Collisions), |one| Some(one.sums().collisions)),
    (Quantity::Pair(PairQuantity::LargestImpulseNS), |one| {
        one.touches().then_some(one.sums().largest_impulse)
    }),
    (Quantity::Pair(PairQuantity::PeakForceN), |one| {
        let has_force = one.touches() && one.pair().law.is_compliant();
        has_force.then_some(one.sums().peak_force)
    }),
    (Quantity::Pair(PairQuantity::TotalImpulseNS), |one| Some(one.sums().impulse)),
    (Quantity::Pair(PairQuantity::LeastOpeningM), |one| {
        Some(PairOutcome::opening_after(one.pair().gap(), one.sums().closing?, one.touches()))
    }),
];

/// Returns the function that reads this number from the lanes, or `None` if they do not compute it.
fn tallied(quantity: Quantity) -> Option<Take> {
    let found = TALLIED.iter().find(|(known, _)| *known == quantity);
    found.map(|(_, take)| *take)
}

impl One<'_> {
    fn floor(&self) -> &Floor {
        &self.prepared.floors().all()[self.place]
    }

    fn drift(&self) -> f64 {
        self.tallies.drift(self.scene, self.place)
    }

    fn pair(&self) -> &Pair {
        &self.prepared.pairs()[self.place]
    }

    fn sums(&self) -> PairSums {
        self.tallies.pair(self.scene, self.place)
    }

    fn touches(&self) -> bool {
        self.sums().collisions > 0.0
    }

    /// Returns the smallest magnitude by which an error of this number is divided: for a least opening, 5 % of the larger peak displacement
    /// of the two floors; for all others, 0.
    fn least(&self, quantity: Quantity) -> f64 {
        if quantity != PairQuantity::LeastOpeningM.into() {
            return 0.0;
        }
        let peak = |floor| self.tallies.displacement(self.scene, floor).abs();
        RunValues::LEAST_PART * peak(self.pair().left()).max(peak(self.pair().right()))
    }
}
