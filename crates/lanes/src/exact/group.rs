//! Batches of scenes from sample to sample: in lanes by groups, and alone at events.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::fly::{Ahead, Flyer};
use super::pair::{Link, Scene, Side, Stage};
use super::press::press;
use super::{ExactSideBySide, Interval};
use crate::number::{Lanes, MOST_LANES};
use crate::{Excitations, SceneSums};
use pounding_solver::{Elastic, Row};

/// Scenes of a batch: enough that the contacts of an interval fill lanes, and few enough for the near caches.
const BATCH: usize = 256;

/// Runs rows with two structures and reports to `tallies`. Each row comes with its index among the scenes of `tallies`.
#[inline(always)]
pub(super) fn run<S: Simd>(simd: S, method: &ExactSideBySide<'_>, rows: &[(usize, &Row<Elastic>)], tallies: &mut SceneSums) {
    for (batch, rows) in rows.chunks(BATCH).enumerate() {
        let mut scenes: Vec<Scene> = rows.iter().map(|(_, row)| Scene::new(row, method)).collect();
        let scenes_of_groups = scenes.chunks(Lanes::<S>::N);
        let mut groups: Vec<Group<S>> = scenes_of_groups.map(|scenes| Group::new(simd, scenes, method.step)).collect();
        let (mut alone, mut waiting) = (Vec::new(), Vec::new());
        for index in 0..method.n_intervals() {
            if method.budget.is_stopped() {
                return;
            }
            let length = method.length(index);
            let common = match method.excitations {
                Excitations::Common(_) => Some(method.interval(index, length, 0)),
                Excitations::Each(_) => None,
            };
            let interval = |scene: usize| match common {
                Some(interval) => interval,
                None => method.interval(index, length, batch * BATCH + scene.min(rows.len() - 1)),
            };
            alone.clear();
            let scenes_of_groups = scenes.chunks_mut(Lanes::<S>::N);
            for (index, (group, scenes)) in groups.iter_mut().zip(scenes_of_groups).enumerate() {
                let first = index * Lanes::<S>::N;
                let [ground, slope] = match common {
                    Some(one) => [one.value, one.slope].map(|number| Lanes::splat(simd, number)),
                    None => in_lanes(simd, std::array::from_fn(|lane| interval(first + lane))),
                };
                let ahead = Ahead { length, ground, slope };
                let lanes = group.go(ahead, method.step, scenes);
                alone.extend(places(lanes).map(|lane| index * Lanes::<S>::N + lane));
            }
            if alone.is_empty() {
                continue;
            }
            go_alone(simd, &interval, &mut scenes, &alone, &mut waiting);
            for scene in &alone {
                let group = &mut groups[scene / Lanes::<S>::N];
                group.take(scene % Lanes::<S>::N, &scenes[*scene]);
            }
        }
        for (scene, (place, _)) in rows.iter().enumerate() {
            let group = &groups[scene / Lanes::<S>::N];
            group.tell(scene % Lanes::<S>::N, &scenes[scene], *place, tallies);
        }
        for group in &groups {
            tallies.steps += method.n_intervals() as u64;
            tallies.touching_steps += group.alone;
        }
    }
}

/// Brings scenes to the next sample, from event to event: flights scene by scene, contacts in lanes.
#[inline(always)]
fn go_alone<S: Simd>(simd: S, interval: &impl Fn(usize) -> Interval, scenes: &mut [Scene], alone: &[usize], waiting: &mut Vec<usize>) {
    for scene in alone {
        scenes[*scene].set_out();
    }
    loop {
        waiting.clear();
        for place in alone {
            let scene = &mut scenes[*place];
            scene.go_on(&interval(*place));
            if scene.stage == Stage::OnTheWay {
                waiting.push(*place);
            }
        }
        if waiting.is_empty() {
            return;
        }
        waiting.sort_unstable_by_key(|scene| scenes[*scene].branches());
        let mut first = 0;
        while let Some(one) = waiting.get(first) {
            let branches = scenes[*one].branches();
            let alike = |scene: &&usize| scenes[**scene].branches() == branches;
            let end = first + waiting[first..].iter().take_while(alike).count();
            press(simd, interval, scenes, &waiting[first..end]);
            first = end;
        }
    }
}

/// Acceleration of the ground at the start of an interval \[m/s²\], and its slope \[m/s³\], in lanes.
#[inline(always)]
fn in_lanes<S: Simd>(simd: S, intervals: [Interval; MOST_LANES]) -> [Lanes<S>; 2] {
    [
        Lanes::new(simd, &intervals.map(|interval| interval.value)),
        Lanes::new(simd, &intervals.map(|interval| interval.slope)),
    ]
}

/// Positions of the set bits of a number, from the lowest.
fn places(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = (bits != 0).then_some(bits.trailing_zeros() as usize);
        bits &= bits.wrapping_sub(1);
        place
    })
}

/// As many scenes as there are lanes, or fewer.
struct Group<S: Simd> {
    flyers: [Flyer<S>; 2],
    gap: Lanes<S>,
    /// How far neighbours have come towards each other \[m\]; `None` if not requested.
    closing: Option<Lanes<S>>,
    /// Bit masks: lanes whose pair is not clearly apart, and which run alone; lanes whose scenes were given up; lanes with a scene.
    touching: u64,
    lost: u64,
    all: u64,
    /// Intervals in which some scene ran alone.
    alone: u64,
}

impl<S: Simd> Group<S> {
    #[inline(always)]
    fn new(simd: S, scenes: &[Scene], step: f64) -> Self {
        // Lanes without a scene repeat the last scene and never run alone.
        let of = |lane: usize| &scenes[lane.min(scenes.len() - 1)];
        let side = |index: usize| -> [Side; MOST_LANES] { std::array::from_fn(|lane| of(lane).sides[index]) };
        let bits = |is_so: fn(&Scene) -> bool| {
            let lanes = scenes.iter().enumerate().filter(|of| is_so(of.1));
            lanes.fold(0, |bits, (lane, _)| bits | 1 << lane)
        };
        Self {
            flyers: [Flyer::new(simd, &side(0), step), Flyer::new(simd, &side(1), step)],
            gap: Lanes::new(simd, &std::array::from_fn(|lane| of(lane).gap)),
            closing: of(0).tally.closing.map(|_| {
                let closing = |lane: usize| of(lane).tally.closing.unwrap_or(f64::NAN);
                Lanes::new(simd, &std::array::from_fn(closing))
            }),
            touching: bits(|scene| !matches!(scene.link, Link::Apart)),
            lost: bits(|scene| scene.stage == Stage::GivenUp),
            all: !(u64::MAX << scenes.len()),
            alone: 0,
        }
    }

    /// Brings scenes to the next sample; returns the lanes that must run alone, with their motions copied to the scenes.
    #[inline(always)]
    fn go(&mut self, ahead: Ahead<S>, step: f64, scenes: &mut [Scene]) -> u64 {
        let [left, right] = &self.flyers;
        let (one, turns) = left.ahead(ahead);
        let (other, also) = right.ahead(ahead);
        let before = left.displacement - right.displacement;
        let after = one.displacement - other.displacement;
        let reached = before.max(after) + one.bow + other.bow;
        let mut events = turns | also | reached.reaches(self.gap);
        if let Some(closing) = self.closing {
            events = events | reached.exceeds(closing);
        }
        let mut alone = events.bits() | self.touching;
        if ahead.length < step {
            alone = u64::MAX;
        }
        alone &= self.all & !self.lost;
        if alone != 0 {
            self.alone += 1;
            for lane in places(alone) {
                for (flyer, side) in self.flyers.iter().zip(&mut scenes[lane].sides) {
                    flyer.put(lane, side);
                }
            }
        }
        self.flyers[0].land(one);
        self.flyers[1].land(other);
        alone
    }

    /// Copies a scene that ran alone back to its lane.
    #[inline(always)]
    fn take(&mut self, lane: usize, scene: &Scene) {
        let bit = 1 << lane;
        self.touching &= !bit;
        if !matches!(scene.link, Link::Apart) {
            self.touching |= bit;
        }
        if scene.stage == Stage::GivenUp {
            self.lost |= bit;
        }
        for (flyer, side) in self.flyers.iter_mut().zip(&scene.sides) {
            flyer.take(lane, side);
        }
        if let Some((lanes, closing)) = self.closing.as_mut().zip(scene.tally.closing) {
            lanes.set(lane, closing);
        }
    }

    /// Reports the results of a lane as those of its scene.
    #[inline(always)]
    fn tell(&self, lane: usize, scene: &Scene, place: usize, tallies: &mut SceneSums) {
        for (node, flyer) in self.flyers.iter().enumerate() {
            let [least, largest] = flyer.extremes.map(|extreme| extreme.lane(lane));
            let peak = if -least > largest { least } else { largest };
            let differ = (-least).total_cmp(&largest).is_ne() || flyer.rests(lane);
            let known = differ && flyer.displacement.lane(lane).is_finite();
            tallies.take_floor(place, node, [known.then_some(peak); 2]);
        }
        tallies.pairs[place] = scene.tally();
        tallies.told[place] &= self.lost >> lane & 1 == 0;
    }
}
