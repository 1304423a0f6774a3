//! Summary of the collisions of one pair: its printed numbers.

use pounding_solver::{Closing, Collision, Peak, Widening};

use super::{RunResult, Simulation};

/// Summary of collisions, usually those of one pair.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PairOutcome {
    /// Number of collisions.
    pub collisions: usize,
    /// First collision.
    pub first: Option<Collision>,
    /// Collision with the largest impulse; of equal ones the first.
    pub largest: Option<Collision>,
    /// Largest pounding force \[N\] and its first instant. `None` if a collision is an impulse without force: the force of rest between
    /// impacts would hide it.
    pub peak_force: Option<Peak>,
    /// Sum of the impulses \[N·s\].
    pub total_impulse: f64,
    /// Longest collision; of equal ones the first.
    pub longest: Option<Collision>,
    /// Sum of the durations \[s\].
    pub touching: f64,
}

/// Rounding error of a closed gap \[m\].
const ROUNDING: f64 = 1e-12;

/// Whether an opening is zero or negative. Impulses close a gap only to rounding, and a stepping method may find an impact before the
/// neighbours overlap.
fn is_closed(opening: f64) -> bool {
    opening > -ROUNDING
}

impl PairOutcome {
    /// Neighbours that touch longer than this lean on each other \[s\], unless their contact is [so soft](Simulation::longest_blow) that blows
    /// last as long. Collisions last some hundredths of a second. Slow collisions of heavy buildings with Hertz contact last up to 0.15 s.
    pub const LEANS: f64 = 0.25;

    /// Least opening of a gap of this width whose neighbours closed it by `closing` \[m\]; 0 for neighbours that touch without a
    /// deformation.
    pub fn opening_after(gap: f64, closing: f64, touches: bool) -> f64 {
        let opening = gap - closing;
        if touches && is_closed(opening) { 0.0 } else { opening }
    }

    /// Least opening of a gap of this width \[m\] and its instant \[s\], from the largest closing.
    fn least_opening(&self, gap: f64, closing: Option<Closing>) -> (f64, f64) {
        let (distance, time) = closing.map_or((0.0, 0.0), |closing| (closing.distance, closing.time));
        let opening = Self::opening_after(gap, distance, self.first.is_some());
        match self.first {
            Some(first) if is_closed(opening) => (opening, first.start),
            _ => (opening, time),
        }
    }

    /// Sums up collisions in the order in which they begin: those of one pair, or of all pairs.
    pub fn of<'a, All: IntoIterator<Item = &'a Collision>>(all: All) -> Self {
        all.into_iter().fold(Self::default(), Self::and)
    }

    fn and(self, next: &Collision) -> Self {
        let is_largest = self.largest.is_none_or(|largest| next.impulse > largest.impulse);
        let force = next.peak_force.zip(next.peak_force_time);
        let force = force.map(|(value, time)| Peak { value, time });
        let peak_force = match (self.collisions, self.peak_force, force) {
            (0, _, force) => force,
            (_, Some(peak), Some(force)) if force.value > peak.value => Some(force),
            (_, Some(peak), Some(_)) => Some(peak),
            _ => None,
        };
        Self {
            collisions: self.collisions + 1,
            first: self.first.or(Some(*next)),
            largest: if is_largest { Some(*next) } else { self.largest },
            peak_force,
            total_impulse: self.total_impulse + next.impulse,
            longest: self.longest.filter(|longest| duration(longest) >= duration(next)).or(Some(*next)),
            touching: self.touching + duration(next),
        }
    }
}

/// Duration of a touch \[s\].
fn duration(one: &Collision) -> f64 {
    one.end - one.start
}

impl RunResult {
    /// Collisions of a pair, in the order in which they begin.
    pub fn collisions_of(&self, pair: usize) -> impl Iterator<Item = &Collision> {
        let all = self.collisions.all().iter();
        all.filter(move |one| one.pair == pair)
    }

    /// Least opening of the gap of a pair \[m\] and its instant \[s\]; `found` is the summary of the pair. `None` if closings were not
    /// recorded.
    pub(crate) fn least_opening(&self, simulation: &Simulation, pair: usize, found: &PairOutcome) -> Option<(f64, f64)> {
        let closings = self.closings.as_ref()?;
        let facing = simulation.floors().facing().get(pair);
        let model = &simulation.pairs()[pair];
        let closing = match facing.and_then(|one| one.column) {
            Some(column) => closings.of_column(column, false),
            None => closings.of(model.left()),
        };
        Some(found.least_opening(model.gap(), closing))
    }

    /// How far the sides of a pair moved away from each other. `None` if openings were not recorded.
    pub(crate) fn widening(&self, simulation: &Simulation, pair: usize) -> Option<Widening> {
        let closings = self.closings.as_ref()?;
        let facing = simulation.floors().facing().get(pair);
        match facing.and_then(|one| one.column) {
            Some(column) => closings.widening_of_column(column),
            None => closings.widening(simulation.pairs()[pair].left()),
        }
    }

    /// Sums up the collisions of a pair.
    pub fn of_pair(&self, pair: usize) -> PairOutcome {
        PairOutcome::of(self.collisions_of(pair))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn collision(start: f64, impulse: f64, peak_force: Option<f64>) -> Collision {
        Collision {
            pair: 0,
            start,
            uncertainty: None,
            approach_speed: None,
            end: start,
            peak_force,
            peak_force_time: peak_force.map(|_| start + 0.1),
            impulse,
        }
    }

    #[test]
    fn reference_first_largest_and_sum() {
        let all = [
            collision(1.0, 2.0, Some(7.0)),
            collision(2.0, 5.0, Some(6.0)),
            collision(3.0, 5.0, Some(9.0)),
        ];
        let found = PairOutcome::of(&all);
        let wanted = PairOutcome {
            collisions: 3,
            first: Some(all[0]),
            largest: Some(all[1]),
            peak_force: Some(Peak { value: 9.0, time: 3.1 }),
            total_impulse: 12.0,
            longest: Some(all[0]),
            touching: 0.0,
        };
        assert_eq!(found, wanted);
        assert_eq!(PairOutcome::of(&[]), PairOutcome::default());
    }

    #[test]
    fn reference_the_longest_touch() {
        let lasting = |start: f64, duration: f64| Collision {
            end: start + duration,
            ..collision(start, 1.0, Some(1.0))
        };
        let found = PairOutcome::of(&[lasting(1.0, 0.02), lasting(2.0, 0.5), lasting(3.0, 0.04)]);
        assert_eq!(found.longest.map(|one| one.start), Some(2.0));
        assert!((found.touching - 0.56).abs() < 1e-12, "{found:?}");
        let brief = PairOutcome::of(&[lasting(1.0, 0.02), lasting(3.0, 0.04)]);
        assert_eq!(brief.longest.map(|one| one.start), Some(3.0));
    }

    #[test]
    fn limit_rest_does_not_hide_an_impulse() {
        let (rest, impact) = (collision(1.0, 2.0, Some(7.0)), collision(2.0, 1.0, None));
        let force = PairOutcome::of(&[rest]).peak_force;
        assert_eq!(force.map(|peak| peak.value), Some(7.0));
        for both in [[rest, impact], [impact, rest]] {
            assert_eq!(PairOutcome::of(&both).peak_force, None);
        }
    }
}
