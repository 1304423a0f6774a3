//! Numbers of a scene by both routes, with their distances.

use super::compared::{Compared, NumberPlace, Two};
use super::touch::{Largest, Touch, are_at_once, as_one, matched};
use pounding_reference::Response;
use pounding_scene::{RunErrors, RunResult, RunValues, Simulation};
use pounding_solver::{LinkPeaks, Pair};

/// Smallest scale for the first touch of a pair, as a part of the pair's largest impulse and force \[–\]. If the touch begins at rest, also
/// as a part of the force that shakes the lighter floor. Smaller values are differences of far larger forces.
const SLIGHT: f64 = 1e-6;

/// The numbers of a floor, one for each kind of [`OF_FLOORS`].
type OfFloor = [f64; OF_FLOORS.len()];

/// The kinds of numbers that floors have: the first ones of [`Compared::ALL`].
const OF_FLOORS: [Compared; 5] = [
    Compared::Displacement,
    Compared::Drift,
    Compared::RestoringForce,
    Compared::LastDisplacement,
    Compared::Momentum,
];

/// The numbers of a run to compare.
#[derive(Debug, Clone)]
pub(super) struct Numbers {
    floors: Vec<OfFloor>,
    /// Floors that are hit from both sides at once at some time. The resolution of a route decides whether such hits are one net impulse or
    /// several impulses, so their transferred momentum is not compared.
    pinched: Vec<bool>,
    /// The touches of every pair in their order.
    pairs: Vec<Vec<Touch>>,
    /// The largest deformation of every link \[m\].
    links: Vec<f64>,
    /// The largest force that shakes the lighter floor of every pair \[N\].
    shaking: Vec<f64>,
}

impl Numbers {
    pub(super) fn of_exact(prepared: &Simulation, outcome: &RunResult) -> Self {
        let floor = |index| {
            let peaks = outcome.peaks.of(index);
            let peaks = [peaks.displacement, peaks.drift(), peaks.restoring_force].map(|peak| peak.value.abs());
            let [displacement, drift, force] = peaks;
            [
                displacement,
                drift,
                force,
                outcome.last.of(index).displacement,
                outcome.momentum.of(index),
            ]
        };
        let touches = |(index, pair): (usize, &Pair)| {
            let all = outcome.collisions_of(index);
            all.map(|one| Touch::new(pair, [one.start, one.end], one.impulse, one.peak_force, one.uncertainty))
                .collect()
        };
        let pairs = prepared.pairs().iter().enumerate();
        let floors = (0..prepared.floors().all().len()).map(floor);
        let links = outcome.links.iter().flat_map(LinkPeaks::all).map(|peak| peak.deformation().value);
        Self::new(prepared, floors.collect(), links.collect(), pairs.map(touches).collect())
    }

    pub(super) fn of_second_route(prepared: &Simulation, response: &Response) -> Self {
        let floors = response.structures.iter().map(|one| {
            let [displacement, drift, force] = [&one.displacement, &one.drift, &one.restoring_force].map(|peak| peak.value.abs());
            [displacement, drift, force, one.end_displacement, one.transferred_momentum]
        });
        let pairs = prepared.pairs().iter().zip(&response.collisions);
        let touches = pairs.map(|(pair, all)| {
            let all = all.iter();
            all.map(|one| Touch::new(pair, [one.start, one.end], one.impulse, one.peak_force, None))
                .collect()
        });
        let links = response.links.iter().map(|one| one.value);
        Self::new(prepared, floors.collect(), links.collect(), touches.collect())
    }

    fn new(prepared: &Simulation, floors: Vec<OfFloor>, links: Vec<f64>, mut pairs: Vec<Vec<Touch>>) -> Self {
        for touches in &mut pairs {
            touches.sort_by(|one, other| one.start.total_cmp(&other.start));
        }
        let pinched = |floor| {
            let all = || prepared.pairs().iter().zip(&pairs);
            let left = all().find(|(pair, _)| pair.right() == floor);
            let right = all().find(|(pair, _)| pair.left() == floor);
            left.zip(right).is_some_and(|((_, left), (_, right))| are_at_once(left, right))
        };
        let pinched = (0..floors.len()).map(pinched).collect();
        let pairs = pairs.into_iter().map(as_one).collect();
        let acceleration = prepared.record().peak().1.abs();
        let mass = |floor: usize| Some(prepared.floors().all()[floor].made_of?.mass_kg);
        let shaking = prepared.pairs().iter().map(|pair| {
            let masses = [pair.left(), pair.right()].into_iter().filter_map(mass);
            acceleration * masses.fold(f64::INFINITY, f64::min)
        });
        Self {
            floors,
            pinched,
            pairs,
            links,
            shaking: shaking.collect(),
        }
    }

    /// Magnitude of the largest displacement \[m\].
    pub(super) fn largest_displacement(&self) -> f64 {
        self.floors.iter().map(|[displacement, ..]| *displacement).fold(0.0, f64::max)
    }

    /// Compares every number of this run with that of another run of the same scene.
    pub(super) fn beside(&self, other: &Self) -> Vec<Two> {
        let mut all = Vec::new();
        let largest = self.floors.iter().map(|[.., momentum]| *momentum).fold(0.0, f64::max);
        for (index, (first, second)) in self.floors.iter().zip(&other.floors).enumerate() {
            let pinched = self.pinched[index] || other.pinched[index];
            let place = NumberPlace::Floor(index);
            for (what, (&first_value, &second_value)) in OF_FLOORS.into_iter().zip(first.iter().zip(second)) {
                let scale = if what == Compared::LastDisplacement {
                    first[0]
                } else if what == Compared::Momentum {
                    first_value.max(RunValues::ZERO * largest)
                } else {
                    first_value.abs()
                };
                let apart = RunErrors::relative_to(second_value, first_value, scale.max(NOTHING));
                all.push(Two {
                    what,
                    place,
                    first: first_value,
                    second: second_value,
                    distance: if what == Compared::Momentum && pinched { 0.0 } else { apart },
                });
            }
        }
        for (pair, (first, second)) in self.pairs.iter().zip(&other.pairs).enumerate() {
            let largest = Largest::of(first);
            for (touch, (one, same)) in first.iter().zip(matched(first, second)).enumerate() {
                // Later touches may be bounces that come to rest, which are differences of far larger velocities.
                let scale = if touch == 0 {
                    let mut own = Largest::of(&first[..1]).at_least(SLIGHT, largest);
                    if one.presses_out_of_rest() {
                        own.force = own.force.max(SLIGHT * self.shaking[pair]);
                    }
                    own
                } else {
                    largest
                };
                let place = NumberPlace::Touch { pair, touch };
                all.extend(one.beside(same.map(|same| &second[same]), place, scale));
            }
            all.push(Two {
                what: Compared::Touches,
                place: NumberPlace::Pair(pair),
                first: first.len() as f64,
                second: second.len() as f64,
                distance: if first.len() == second.len() { 0.0 } else { f64::INFINITY },
            });
        }
        let links = self.links.iter().zip(&other.links).enumerate();
        all.extend(links.map(|(link, (&first, &second))| Two {
            what: Compared::Deformation,
            place: NumberPlace::Link(link),
            first,
            second,
            distance: RunErrors::relative_to(second.abs(), first.abs(), first.abs().max(NOTHING)),
        }));
        all
    }

    /// The pair and the start \[s\] of the earliest wrong touch: among the given touches, by pair and index, and those that only the other
    /// run has.
    pub(super) fn first_of(&self, wrong: impl Iterator<Item = (usize, usize)>, other: &Self) -> Option<(usize, f64)> {
        let own = wrong.map(|(pair, touch)| (pair, self.pairs[pair][touch].start));
        let pairs = self.pairs.iter().zip(&other.pairs).enumerate();
        let lone = pairs.flat_map(|(pair, (first, second))| {
            let same = matched(second, first).into_iter();
            let lone = second.iter().zip(same).filter(|(_, same)| same.is_none());
            lone.map(move |(one, _)| (pair, one.start))
        });
        own.chain(lone).min_by(|one, other| one.1.total_cmp(&other.1))
    }

    /// The touches of a pair around an instant, from the last one before it, as text.
    pub(super) fn near(&self, pair: usize, time: f64) -> Vec<String> {
        let touches = &self.pairs[pair];
        let from = touches.iter().rposition(|one| one.start < time);
        let near = touches.iter().enumerate().skip(from.unwrap_or(0).saturating_sub(1)).take(7);
        let words = near.map(|(number, one)| {
            let Touch {
                start,
                lasts,
                impulse,
                peak_force,
                ..
            } = one;
            let force = peak_force.map_or("an impact".into(), |force| format!("{force:e} N"));
            format!("{number}: {start:.15} s for {lasts:e} s, {impulse:e} N·s, {force}")
        });
        words.collect()
    }

    /// Removes touches that the other run does not have and that are within rounding. Returns their number.
    pub(super) fn without_grazes(&mut self, other: &mut Self) -> usize {
        let mut grazes = 0;
        for (first, second) in self.pairs.iter_mut().zip(&mut other.pairs) {
            let [one, other] = [&*first, &*second].map(|touches| Largest::of(touches).impulse);
            let largest = one.max(other);
            let (of_first, of_second) = (matched(first, second), matched(second, first));
            for (touches, same) in [(first, of_first), (second, of_second)] {
                let before = touches.len();
                let mut same = same.into_iter();
                touches.retain(|one| same.next().flatten().is_some() || !one.is_graze(largest));
                grazes += before - touches.len();
            }
        }
        grazes
    }
}

/// Largest magnitude that counts as zero, in any SI unit: iteration leaves 1e-105 m in a row that cannot move.
const NOTHING: f64 = 1e-60;
