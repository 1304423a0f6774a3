//! How far a run is from the exact run of the same scene, for every number that is printed of it.
//!
//! A [`Quantity`] is what an accuracy promises; here stands how the error of each is measured. Left out are the instants of
//! peaks, which jump where two peaks are nearly equal, and the terms of the energy.

use crate::simulation::LEANS;
use crate::{FloorQuantity, PairQuantity, Quantity, QuantityGroup, RunResult, Simulation, Values};

/// Part of a peak \[–\] below which what is left of it is measured by this part: it may be next to nothing itself.
pub const LEAST_PART: f64 = 0.05;

/// How errors are measured, and what is not, in words.
pub const MEASURE: &str = "each relative to the exact number; residuals and least openings below 5 % of the peak to 5 % of \
                           it, times of touching below 0.25 s to 0.25 s. Times of peaks and energies are left out";

/// Errors of a run against the exact run of the same scene.
#[derive(Debug, Clone, PartialEq)]
pub struct RunErrors {
    /// Of the numbers of floors by place, in the order of [`Quantity::COMPARED`].
    floors: Vec<Vec<Option<f64>>>,
    /// Of the instant of every peak displacement \[s\]; large where two peaks are nearly equal.
    peak_times: Vec<Option<f64>>,
    pairs: Vec<PairErrors>,
}

/// Errors of the numbers of a pair, and what comparing them needs to know.
#[derive(Debug, Clone, PartialEq)]
pub struct PairErrors {
    /// Whether the pair rests in contact in the exact run, and gets an impact in every step in this one: how many and how
    /// large depends on the step, so that only the time of the first is compared.
    pub rests: bool,
    /// Number of collisions of the run and of the exact run.
    pub collisions: [usize; 2],
    /// Of the time of the first collision, absolute \[s\]; infinite if only one run has a collision.
    pub first_start_s: Option<f64>,
    errors: Vec<Option<f64>>,
}

impl Values<'_> {
    /// What the magnitude of a number counts as at least where an error is relative to it; 0 for most.
    ///
    /// # Panics
    /// If the row has no such floor or pair.
    pub fn least(&self, quantity: impl Into<Quantity>, place: usize) -> f64 {
        let part = |peak: FloorQuantity, floor: usize| LEAST_PART * self.of(peak, floor).unwrap_or(0.0).abs();
        match quantity.into() {
            Quantity::Floor(FloorQuantity::TransferredMomentumNS) => {
                let floors = 0..self.simulation.floors().all().len();
                let momenta = floors.map(|floor| self.result.momentum.of(floor));
                ZERO * momenta.fold(0.0, f64::max)
            }
            Quantity::Floor(quantity) => {
                let peak = quantity.left_over_of();
                peak.map_or(0.0, |peak| part(peak, place))
            }
            Quantity::Pair(PairQuantity::LeastOpeningM) => {
                let pair = &self.simulation.pairs()[place];
                let [left, right] = [pair.left(), pair.right()].map(|floor| part(FloorQuantity::PeakDisplacementM, floor));
                left.max(right)
            }
            Quantity::Pair(PairQuantity::TouchingS) => LEANS,
            Quantity::Pair(PairQuantity::FirstStartS) => {
                let start = self.of(PairQuantity::FirstStartS, place);
                f64::from(u8::from(start.is_some_and(|start| start < AT_ONCE)))
            }
            Quantity::Pair(_) => 0.0,
        }
    }
}

/// Distance of a number of a run from that of the exact one, relative or absolute; `None` if neither has it, infinite if one has.
fn error([run, exact]: [&Values<'_>; 2], quantity: Quantity, place: usize, relative: bool) -> Option<f64> {
    match (run.of(quantity, place), exact.of(quantity, place)) {
        (None, None) => None,
        (Some(run), Some(value)) if relative => {
            let scale = value.abs().max(exact.least(quantity, place));
            Some(relative_to(run, value, scale))
        }
        (Some(run), Some(exact)) => Some((run - exact).abs()),
        (Some(_), None) | (None, Some(_)) => Some(f64::INFINITY),
    }
}

impl RunErrors {
    /// Compares a run of a scene with the exact one.
    pub fn between(run: &RunResult, exact: &RunResult, simulation: &Simulation) -> Self {
        let values = [run, exact].map(|one| one.values(simulation));
        let both = [&values[0], &values[1]];
        let at = |place: usize, is_compared: &dyn Fn(Quantity) -> bool| {
            let compared = |quantity| is_compared(quantity).then(|| error(both, quantity, place, true));
            Quantity::COMPARED.map(|quantity| compared(quantity).flatten()).to_vec()
        };
        let of_floor = |floor| at(floor, &|quantity| matches!(quantity, Quantity::Floor(_)));
        let start = Quantity::Pair(PairQuantity::FirstStartS);
        let of_pair = |pair| {
            let rests = rests([run, exact], pair);
            let is_compared = |quantity| match quantity {
                Quantity::Pair(_) => !rests || quantity == start,
                Quantity::Floor(_) => false,
            };
            PairErrors {
                rests,
                collisions: [run, exact].map(|one| one.collisions_of(pair).count()),
                first_start_s: error(both, start, pair, false),
                errors: at(pair, &is_compared),
            }
        };
        let peak_time = FloorQuantity::PeakDisplacementTimeS.into();
        let floors = 0..simulation.floors().all().len();
        Self {
            floors: floors.clone().map(of_floor).collect(),
            peak_times: floors.map(|floor| error(both, peak_time, floor, false)).collect(),
            pairs: (0..simulation.pairs().len()).map(of_pair).collect(),
        }
    }

    /// Relative error of a number of a floor or a pair \[–\], of the instant of a peak displacement absolute \[s\]; infinite if one of
    /// both runs lacks the number, or of unequal numbers of collisions. `None` if neither has it, or if it is not compared.
    ///
    /// # Panics
    /// If the row has no such floor or pair.
    pub fn at(&self, quantity: impl Into<Quantity>, place: usize) -> Option<f64> {
        let quantity = quantity.into();
        if quantity == Quantity::Floor(FloorQuantity::PeakDisplacementTimeS) {
            return self.peak_times[place];
        }
        let index = Quantity::COMPARED.iter().position(|one| *one == quantity)?;
        match quantity {
            Quantity::Floor(_) => self.floors[place][index],
            Quantity::Pair(PairQuantity::Collisions) => self.pairs[place].differ().then_some(f64::INFINITY),
            Quantity::Pair(_) => self.pairs[place].errors[index],
        }
    }

    /// Of the pairs by place.
    pub fn pairs(&self) -> &[PairErrors] {
        &self.pairs
    }

    /// Largest relative error of a group \[–\], and of what; infinite where the numbers of collisions differ or only
    /// one of the runs has the quantity.
    pub fn largest(&self, group: QuantityGroup) -> (f64, &'static str) {
        Quantity::COMPARED
            .into_iter()
            .filter(|one| group == QuantityGroup::All || one.group() == group)
            .map(|one| (self.of(one), one.words()))
            .fold((0.0, ""), |largest, next| if next.0 > largest.0 { next } else { largest })
    }

    /// Largest relative error of a number, over all floors or pairs \[–\].
    pub fn of(&self, quantity: Quantity) -> f64 {
        let places = match quantity {
            Quantity::Floor(_) => 0..self.floors.len(),
            Quantity::Pair(_) => 0..self.pairs.len(),
        };
        places.filter_map(|place| self.at(quantity, place)).fold(0.0, f64::max)
    }
}

impl PairErrors {
    /// Whether the run and the exact run have different numbers of collisions, where these can be compared.
    pub fn differ(&self) -> bool {
        !self.rests && self.collisions[0] != self.collisions[1]
    }
}

/// Whether a pair rests in the exact run, and gets impacts in the other one.
fn rests([run, exact]: [&RunResult; 2], pair: usize) -> bool {
    // Of an impulsive law only rest lasts; a stepping method tells it from bounces where e = 0.
    let mut of_run = run.collisions_of(pair).peekable();
    let impulsive = of_run.peek().is_some() && of_run.all(|one| one.peak_force.is_none());
    let lasts = |of: &RunResult| of.collisions_of(pair).any(|one| one.end > one.start);
    impulsive && lasts(exact) && !lasts(run)
}

/// Part of a row's largest momentum below which one is zero: forces from both sides cancel but for rounding.
pub const ZERO: f64 = 1e-9;

/// A first touch before this instant \[s\] is at the start: its error is relative to 1 s.
pub const AT_ONCE: f64 = 1e-9;

/// Distance relative to a scale; 0 of equal numbers, infinite of what is not a number.
pub fn relative_to(run: f64, exact: f64, scale: f64) -> f64 {
    let distance = (run - exact).abs();
    if distance == 0.0 {
        return 0.0;
    }
    let relative = distance / scale;
    if relative.is_nan() { f64::INFINITY } else { relative }
}

/// Distance relative to the exact magnitude; infinite where that is 0 and the other is not.
pub fn relative(run: f64, exact: f64) -> f64 {
    relative_to(run, exact, exact.abs())
}
