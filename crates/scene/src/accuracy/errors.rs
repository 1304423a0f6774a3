//! Errors of a run against the exact run of the same scene, for every printed number.
//!
//! An accuracy promises every [`Quantity`]; this module measures the errors. It leaves out the instants of peaks, which jump if two peaks
//! are nearly equal, and the terms of the energy.

use crate::{FloorQuantity, PairQuantity, Quantity, QuantityGroup, QuantityKind, RunResult, RunValues, Simulation};

/// Errors of a run against the exact run of the same scene.
#[derive(Debug, Clone, PartialEq)]
pub struct RunErrors {
    floors: Vec<PlaceErrors>,
    pairs: Vec<PairErrors>,
}

/// Errors of the numbers of a floor or a pair, in the order of the table; `None` for numbers that are not compared.
#[derive(Debug, Clone, PartialEq)]
struct PlaceErrors {
    relative: Vec<Option<f64>>,
    absolute: Vec<Option<f64>>,
}

/// Errors of the numbers of a pair, and facts that comparing them needs.
#[derive(Debug, Clone, PartialEq)]
pub struct PairErrors {
    /// Whether the pair rests in contact in the exact run, but gets an impact in every step of this run. The number and the size of these
    /// impacts depend on the step, so that only the time of the first touch is compared.
    pub rests: bool,
    /// Numbers of collisions of the run and of the exact run.
    pub collisions: [usize; 2],
    errors: PlaceErrors,
}

impl PlaceErrors {
    /// Compares some numbers of a place.
    fn of(runs: [&RunValues<'_>; 2], all: impl Iterator<Item = Quantity>, place: usize, is_compared: impl Fn(Quantity) -> bool) -> Self {
        let errors = all.map(|quantity| {
            let about = quantity.about();
            let error = |relative| is_compared(quantity).then(|| error(runs, quantity, place, relative)).flatten();
            (about.group.and_then(|_| error(true)), about.absolute.and_then(|_| error(false)))
        });
        let (relative, absolute) = errors.unzip();
        Self { relative, absolute }
    }
}

/// Returns the distance of a number from that of the exact run, relative or absolute. It is `None` if neither run has the number, infinite
/// if one run lacks it. For counts it is `None` if they are equal, else infinite.
fn error([run, exact]: [&RunValues<'_>; 2], quantity: Quantity, place: usize, relative: bool) -> Option<f64> {
    match (run.of(quantity, place), exact.of(quantity, place)) {
        (None, None) => None,
        (Some(run), Some(exact)) if quantity.about().kind == QuantityKind::Count => ((run - exact).abs() > 0.0).then_some(f64::INFINITY),
        (Some(run), Some(value)) if relative => {
            let scale = value.abs().max(exact.least(quantity, place));
            Some(RunErrors::relative_to(run, value, scale))
        }
        (Some(run), Some(exact)) => Some((run - exact).abs()),
        (Some(_), None) | (None, Some(_)) => Some(f64::INFINITY),
    }
}

impl RunErrors {
    /// Describes how errors are measured, and which numbers are left out.
    pub const MEASURE: &str = "each relative to the exact number; residuals and least openings below 5 % of the peak to 5 % of \
                               it, times of touching below 0.25 s to 0.25 s. Times of peaks and energies are left out";

    /// Returns the distance relative to a scale; 0 for equal numbers, infinite if the result is not a number.
    pub fn relative_to(run: f64, exact: f64, scale: f64) -> f64 {
        let distance = (run - exact).abs();
        if distance == 0.0 {
            return 0.0;
        }
        let relative = distance / scale;
        if relative.is_nan() { f64::INFINITY } else { relative }
    }

    /// Returns the distance relative to the exact magnitude; infinite if that is 0 and the other number is not.
    pub fn relative(run: f64, exact: f64) -> f64 {
        Self::relative_to(run, exact, exact.abs())
    }

    /// Compares a run of a scene with the exact one.
    pub fn between(run: &RunResult, exact: &RunResult, simulation: &Simulation) -> Self {
        let values = [run, exact].map(|one| one.values(simulation));
        let both = [&values[0], &values[1]];
        let of_floor = |floor| PlaceErrors::of(both, FloorQuantity::ALL.iter().map(|one| (*one).into()), floor, |_| true);
        let of_pair = |pair| {
            let rests = rests([run, exact], pair);
            let is_compared = |quantity| !rests || quantity == PairQuantity::FirstStartS.into();
            PairErrors {
                rests,
                collisions: both.map(|one| one.pair(pair).collisions),
                errors: PlaceErrors::of(both, PairQuantity::ALL.iter().map(|one| (*one).into()), pair, is_compared),
            }
        };
        Self {
            floors: (0..simulation.floors().all().len()).map(of_floor).collect(),
            pairs: (0..simulation.pairs().len()).map(of_pair).collect(),
        }
    }

    /// Relative error of a number of a floor or a pair \[–\]. It is infinite if one of both runs lacks the number, or if numbers of
    /// collisions differ. It is `None` if neither run has the number, or if it is not compared.
    ///
    /// # Panics
    /// If the row has no such floor or pair.
    pub fn at(&self, quantity: impl Into<Quantity>, place: usize) -> Option<f64> {
        let (errors, index) = self.of_place(quantity.into(), place)?;
        errors.relative[index]
    }

    /// Error of a number as files and pages give it: absolute \[SI\] if the absolute error has a name, else relative \[–\].
    ///
    /// # Panics
    /// If the row has no such floor or pair.
    pub fn told(&self, quantity: impl Into<Quantity>, place: usize) -> Option<f64> {
        let quantity = quantity.into();
        let (errors, index) = self.of_place(quantity, place)?;
        let is_absolute = quantity.about().absolute.is_some();
        if is_absolute {
            errors.absolute[index]
        } else {
            errors.relative[index]
        }
    }

    /// Returns the errors of a place, and the index of a number in them.
    fn of_place(&self, quantity: Quantity, place: usize) -> Option<(&PlaceErrors, usize)> {
        match quantity {
            Quantity::Floor(quantity) => Some((&self.floors[place], quantity as usize)),
            Quantity::Pair(quantity) => Some((&self.pairs[place].errors, quantity as usize)),
            Quantity::Link(_) => None,
        }
    }

    /// Errors of all pairs, in the order of the row.
    pub fn pairs(&self) -> &[PairErrors] {
        &self.pairs
    }

    /// Largest relative error of a group \[–\], and the number that has it. It is infinite if numbers of collisions differ, or if only one
    /// of the runs has a number.
    pub fn largest(&self, group: QuantityGroup) -> (f64, &'static str) {
        Quantity::compared()
            .filter(|one| group == QuantityGroup::All || one.about().group == Some(group))
            .map(|one| (self.of(one), one.about().words))
            .fold((0.0, ""), |largest, next| if next.0 > largest.0 { next } else { largest })
    }

    /// Largest relative error of a number over all floors or pairs \[–\].
    pub fn of(&self, quantity: Quantity) -> f64 {
        let places = match quantity {
            Quantity::Floor(_) => 0..self.floors.len(),
            Quantity::Pair(_) => 0..self.pairs.len(),
            Quantity::Link(_) => 0..0,
        };
        places.filter_map(|place| self.at(quantity, place)).fold(0.0, f64::max)
    }
}

impl PairErrors {
    /// Whether the run and the exact run have different numbers of collisions, if they can be compared.
    pub fn differ(&self) -> bool {
        !self.rests && self.collisions[0] != self.collisions[1]
    }
}

/// Whether a pair rests in the exact run and gets impacts in the other run.
fn rests([run, exact]: [&RunResult; 2], pair: usize) -> bool {
    // Contact of an impulsive law lasts only at rest. A stepping method can distinguish rest from bounces if e = 0.
    let mut of_run = run.collisions_of(pair).peekable();
    let impulsive = of_run.peek().is_some() && of_run.all(|one| one.peak_force.is_none());
    let lasts = |of: &RunResult| of.collisions_of(pair).any(|one| one.end > one.start);
    impulsive && lasts(exact) && !lasts(run)
}
