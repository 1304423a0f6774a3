//! Velocity jumps of several scenes side by side.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::column::SideBySideColumn;
use super::group::{Pair, Rows, Structure};
use super::law::Law;
use super::number::{Lanes, Mask};
use crate::ground::Ground;
use crate::impacts::{self, Impacts};
use crate::{Impact, Recorder, Span, State};

/// The rule of [`Impacts`]. A single pair of a row is hit in all lanes at once; of several pairs, impulses depend on each other,
/// and the few scenes in which one is hit are solved one by one.
pub(super) struct Jumps<'a, Column> {
    rows: Rows<'a, Column>,
    /// Of every lane; none where rows have a single pair.
    impacts: Vec<Impacts>,
    states: Vec<State>,
    struck: Struck,
}

/// Impulses of every pair at an instant \[N·s\].
struct Struck(Vec<f64>);

impl Recorder for Struck {
    fn span(&mut self, _: &Span<'_>) {}

    fn impact(&mut self, impact: &Impact) {
        self.0[impact.pair] = impact.impulse;
    }
}

/// The structures and pairs of a group.
type Scenes<'a, S, Column> = (&'a mut [Structure<S, Column>], &'a mut [Option<Pair<S>>]);

impl<'a, Column: SideBySideColumn> Jumps<'a, Column> {
    pub(super) fn new(rows: Rows<'a, Column>, n_lanes: usize) -> Self {
        let n_pairs = rows.lane(0).pairs().len();
        let lanes = if n_pairs > 1 { 0..n_lanes } else { 0..0 };
        Self {
            rows,
            impacts: lanes.map(|lane| Impacts::new(rows.lane(lane))).collect(),
            states: vec![State::default(); rows.lane(0).nodes().len()],
            struck: Struck(vec![0.0; n_pairs]),
        }
    }

    /// Lets the velocities at a node jump where impulsive pairs touch and approach; what has jumped begins anew from there.
    #[inline(always)]
    pub(super) fn jump<S: Simd>(
        &mut self,
        (structures, pairs): Scenes<'_, S, Column>,
        ground: Lanes<S>,
        instant: (f64, f64),
    ) {
        let hits = approaching::<S, Column>(structures, pairs, ground);
        if !Lanes::any(hits) {
            return;
        }
        for structure in structures.iter_mut() {
            structure.contact.jumped = structure.contact.velocity;
        }
        if self.impacts.is_empty() {
            for left in 1..structures.len() {
                let (before, after) = structures.split_at_mut(left);
                if let Some(pair) = &mut pairs[left - 1] {
                    strike::<S, Column>([&mut before[left - 1], &mut after[0]], pair, hits);
                }
            }
        } else {
            for lane in (0..Lanes::<S>::N).filter(|lane| hits.test(*lane)) {
                self.strike_alone((structures, pairs), lane, instant);
            }
        }
        for structure in structures {
            structure.restart(ground);
        }
    }

    /// Finds all impulses of one scene, as it does alone.
    fn strike_alone<S: Simd>(
        &mut self,
        (structures, pairs): Scenes<'_, S, Column>,
        lane: usize,
        (acceleration, time): (f64, f64),
    ) {
        let row = self.rows.lane(lane);
        let impacts = &mut self.impacts[lane];
        for (state, structure) in self.states.iter_mut().zip(structures.iter()) {
            state.velocity = structure.contact.velocity.lane(lane);
        }
        for pair in pairs.iter().flatten() {
            let impulsive = matches!(pair.law, Law::Impulsive(_));
            impacts.touching[pair.index] = impulsive && pair.deformation.lane(lane) >= 0.0;
        }
        self.struck.0.fill(0.0);
        let instant = (Ground::Common(acceleration), time);
        impacts.jump(row, &mut self.states, instant, &mut self.struck);
        for (state, structure) in self.states.iter().zip(structures) {
            structure.contact.jumped.set(lane, state.velocity);
        }
        for pair in pairs.iter_mut().flatten() {
            let mut impulses = pair.deformation.like(0.0);
            impulses.set(lane, self.struck.0[pair.index]);
            pair.tally.strike(impulses);
        }
    }
}

/// Where an impulsive pair touches and approaches.
#[inline(always)]
fn approaching<S: Simd, Column: SideBySideColumn>(
    structures: &[Structure<S, Column>],
    pairs: &[Option<Pair<S>>],
    like: Lanes<S>,
) -> Mask<S> {
    let zero = like.like(0.0);
    let mut hits = zero.exceeds(zero);
    for left in 1..structures.len() {
        if let Some(pair) = &pairs[left - 1]
            && let Law::Impulsive(_) = pair.law
        {
            let [left, right] = [&structures[left - 1].contact, &structures[left].contact];
            let approaches = (left.velocity - right.velocity).exceeds(zero);
            hits = hits.or(pair.deformation.reaches(zero).and(approaches));
        }
    }
    hits
}

/// Strikes a pair that is the only one of every scene. A scene that rounding would let approach once more, which takes further
/// rounds, is given up: its velocities are no numbers from then on, and it runs alone.
#[inline(always)]
fn strike<S: Simd, Column: SideBySideColumn>(
    [left, right]: [&mut Structure<S, Column>; 2],
    pair: &mut Pair<S>,
    hits: Mask<S>,
) {
    let Law::Impulsive(law) = pair.law else {
        return;
    };
    let (v, w) = (left.contact.velocity, right.contact.velocity);
    let mobility = |structure: &Structure<S, Column>| structure.constants.coefficients.inverse_mass;
    let mobilities = [mobility(left), mobility(right)];
    let impulse = law.factor * (v - w) / (mobilities[0] + mobilities[1]);
    let after = (v - mobilities[0] * impulse, w + mobilities[1] * impulse);
    // What rounding leaves of an approach; more would be solved in further rounds.
    let left_over = impulse.like(impacts::ROUNDING) * (v.abs() + w.abs());
    let again = (after.0 - after.1).exceeds(left_over);
    let given_up = |velocity: Lanes<S>| Number::select(again, velocity.like(f64::NAN), velocity);
    pair.tally
        .strike(Number::select(hits, impulse, impulse.like(0.0)));
    left.contact.jumped = Number::select(hits, given_up(after.0), v);
    right.contact.jumped = Number::select(hits, given_up(after.1), w);
}
