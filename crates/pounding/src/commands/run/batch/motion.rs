//! A run of the scene under one motion of a folder, for tables, sentences and programs.

use pounding::assess::{Effects, MotionLine};
use pounding::report::{CollapseSummary, CollisionSummary, MotionRow, PairSummary, Site, SitedNumber, StructureSummary, UnderMotion};
use pounding::scene::{
    Errors, Excess, FloorQuantity, Floors, Implausible, PairOutcome, PairQuantity, Quantity, QuantityGroup, QuantityKind, Review, Scene,
    Simulation,
};
use pounding::text::NONE;
use serde_json::{Value, json};

/// A run under one motion in one direction.
pub(super) struct RunUnderMotion {
    /// Peak ground acceleration \[m/s²\], without sign.
    pub(super) pga: f64,
    /// Product of all scales of the record.
    pub(super) scale: f64,
    /// Largest error, if it was measured.
    pub(super) error: Option<f64>,
    /// Why the error was not measured, in a word.
    pub(super) why: &'static str,
    doubts: Vec<Implausible>,
    excesses: Vec<Excess>,
    pub(super) warnings: Vec<String>,
    /// The collapse that ended the run, if there is one.
    pub(super) collapse: Option<CollapseSummary>,
    /// The collisions of all pairs.
    pub(super) all: PairOutcome,
    structures: Vec<StructureSummary>,
    pub(super) pairs: Vec<PairSummary>,
    /// The effects of pounding on every storey, in both directions, if they were asked for.
    pub(super) effects: Option<Effects>,
    pub(super) floors: Floors,
}

impl RunUnderMotion {
    pub(super) fn new(prepared: &Simulation, review: &Review, effects: Option<Effects>) -> Self {
        let (error, why) = match &review.errors {
            Errors::Measured(errors, _) => (Some(errors.largest(QuantityGroup::All).0), ""),
            Errors::Exact => (None, "exact"),
            Errors::Doubtful | Errors::NotMeasured | Errors::Unknown(_) => (None, NONE),
        };
        Self {
            pga: prepared.record().peak().1.abs(),
            scale: prepared.scale(),
            error,
            why,
            doubts: prepared.doubts(),
            excesses: prepared.all_excesses(&review.outcome),
            warnings: review.notices(),
            collapse: CollapseSummary::of_run(prepared, &review.outcome),
            all: PairOutcome::of(review.outcome.collisions.all()),
            structures: StructureSummary::of_run(prepared, review),
            pairs: PairSummary::of_run(prepared, review),
            effects,
            floors: prepared.floors().clone(),
        }
    }

    /// The largest pounding force \[N\] of the pairs that have one: an impulse has none.
    pub(super) fn force(&self) -> Option<f64> {
        let forces = self.pairs.iter().filter_map(|pair| pair.number(PairQuantity::PeakForceN));
        forces.max_by(f64::total_cmp)
    }

    /// The pair with the largest impulse and that impulse \[N·s\]; the first of equal ones, `None` if nothing touches.
    pub(super) fn hardest(&self) -> Option<(&PairSummary, f64)> {
        let hits = self.pairs.iter().filter_map(|pair| Some((pair, pair.largest?.impulse_n_s)));
        hits.reduce(|most, next| if next.1 > most.1 { next } else { most })
    }

    /// Whether exact motion touches and this run does not.
    pub(super) fn misses(&self) -> bool {
        let errors = self.pairs.iter().filter_map(|pair| pair.errors.as_ref());
        self.all.collisions == 0 && errors.map(|errors| errors.exact_collisions).sum::<usize>() > 0
    }

    /// The largest peak displacement of a structure \[m\], without sign.
    pub(super) fn displacement(&self) -> f64 {
        let peaks = self.structures.iter();
        let peaks = peaks.filter_map(|one| one.numbers.get(FloorQuantity::PeakDisplacementM));
        peaks.map(f64::abs).fold(0.0, f64::max)
    }

    /// Every number of the run as a row for programs: of the run as a whole, of each floor, of each pair, and the effects.
    pub(super) fn rows(&self, scene: &Scene, line: &MotionLine<Self>) -> Vec<MotionRow<SitedNumber>> {
        let whole = [
            ("pga_m_per_s2", Some(self.pga)),
            ("scale_factor", Some(self.scale)),
            ("largest_error", self.error),
            ("warnings", Some(self.warnings.len() as f64)),
        ];
        let whole = whole.map(|(name, value)| SitedNumber::at(&Site::default(), name, value));
        let at_floor = |floor: usize| Site::floor(scene, &self.floors, floor);
        let floors = self.structures.iter().enumerate().flat_map(|(floor, structure)| {
            let known = measured(FloorQuantity::ALL).filter_map(|(one, name)| Some((name, structure.numbers.get(one)?)));
            known.map(move |(name, value)| SitedNumber::at(&at_floor(floor), name, value))
        });
        let pairs = self.floors.facing().iter().zip(&self.pairs).flat_map(|(facing, pair)| {
            let site = Site::pair(scene, &self.floors, facing);
            measured(PairQuantity::ALL).map(move |(one, name)| SitedNumber::at(&site, name, pair.number(one)))
        });
        let own = whole
            .into_iter()
            .chain(floors)
            .chain(pairs)
            .map(|number| MotionRow::of(line, number));
        let directions = self.effects.iter().flat_map(|one| [(false, &one.as_given), (true, &one.reversed)]);
        let effects = directions.flat_map(|(reversed, floors)| {
            floors.iter().enumerate().flat_map(move |(floor, effects)| {
                effects.facts().into_iter().map(move |fact| {
                    let number = SitedNumber::at(&at_floor(floor), format!("effect_{}", fact.quantity), fact.value);
                    MotionRow::of(line, number).shaken(reversed)
                })
            })
        });
        own.chain(effects).collect()
    }
}

impl UnderMotion for RunUnderMotion {
    fn doubts(&self) -> &[Implausible] {
        &self.doubts
    }

    fn excesses(&self) -> &[Excess] {
        &self.excesses
    }

    fn facts(&self, _: &Scene) -> Value {
        json!({
            "pga_m_per_s2": self.pga,
            "scale_factor": self.scale,
            "largest_error": self.error,
            "unusual": self.doubts,
            "warnings": self.warnings,
            "collapse": self.collapse,
            "structures": self.structures,
            "pairs": self.pairs,
            "effects": self.effects,
        })
    }
}

/// The quantities that a run yields, with their names; those of the model are left out.
fn measured<Q: Into<Quantity> + Copy>(all: &[Q]) -> impl Iterator<Item = (Q, &'static str)> {
    let named = all.iter().map(|one| (*one, (*one).into().about()));
    let measured = named.filter(|(_, about)| about.kind != QuantityKind::Model);
    measured.map(|(one, about)| (one, about.name))
}

/// Duration of the largest impulse of a pair \[s\] if it is a push; `None` if it is a blow.
pub(super) fn push_of(pair: &PairSummary) -> Option<f64> {
    let start = |one: Option<CollisionSummary>| one.map(|one| one.start_s.to_bits());
    let is_largest = start(pair.leaning) == start(pair.largest);
    pair.leaning.filter(|_| is_largest).map(|one| one.end_s - one.start_s)
}

/// A pair by its names, and whether its largest impulse is a push.
pub(super) fn between(pair: &PairSummary) -> String {
    let leans = if push_of(pair).is_some() { " (leaning)" } else { "" };
    format!("{} – {}{leans}", pair.left, pair.right)
}
