//! As many scenes of two structures as there are lanes.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::NEAR;
use super::body::{self, Constants, Motion};
use crate::ensemble::books;
use crate::ensemble::closings::{Apart, Nearest};
use crate::ensemble::column::SideBySideColumn;
use crate::ensemble::jump::struck;
use crate::ensemble::law::{Impulsive, Law};
use crate::ensemble::number::{Lanes, Mask};
use crate::ensemble::rows::Rows;
use crate::ensemble::scenes::Pair;
use crate::ensemble::{PairSums, Shaken};
use crate::explicit::verlet::formulas::Closing;
use crate::{Verlet, VerletImpacts};

/// Motions of the left and the right structure.
pub(super) type Motions<S, Column> = [Motion<S, Column>; 2];

/// Scenes of two structures.
pub(super) struct Group<S: Simd, Column: SideBySideColumn> {
    pub(super) constants: [Constants<S, Column>; 2],
    pub(super) motions: Motions<S, Column>,
    /// Nothing where they cannot touch.
    pub(super) pair: Option<Pair<S>>,
    /// Nothing where nobody asks how close they come.
    nearest: Option<Nearest<S>>,
    /// Whether impacts are located.
    located: bool,
    /// Whether a compliant pair that touched at the node before has its books to close.
    busy: bool,
    /// Steps in which some lane touches.
    pub(super) touching_steps: u64,
}

impl<S: Simd, Column: SideBySideColumn> Group<S, Column> {
    #[inline(always)]
    pub(super) fn new(
        simd: S,
        (rows, ground): (Rows<'_, Column>, Lanes<S>),
        method: &Shaken<Verlet>,
    ) -> Self {
        let start = (method.time_step, ground);
        let (left, left_motion) = Constants::new((simd, rows, 0), start);
        let (right, right_motion) = Constants::new((simd, rows, 1), start);
        Self {
            constants: [left, right],
            motions: [left_motion, right_motion],
            pair: rows.pair(simd, 0),
            nearest: method.closings.then(|| Nearest::new(simd)),
            located: method.settings.impacts == VerletImpacts::Located,
            busy: false,
            touching_steps: 0,
        }
    }

    /// In which lanes the structures may touch in a step to these displacements \[m\]: there, or, as a parabola that starts at the
    /// rate of the motions stays below the line at that rate or below that to its end, on the way.
    #[inline(always)]
    pub(super) fn may_touch(
        &self,
        [left, right]: &Motions<S, Column>,
        ends: [Lanes<S>; 2],
    ) -> Mask<S> {
        let zero = ends[0].like(0.0);
        let Some(pair) = &self.pair else {
            return zero.exceeds(zero);
        };
        let deformation = left.displacement - right.displacement - pair.gap;
        let rate = left.velocity - right.velocity;
        let on_the_way = deformation + self.constants[0].step.whole * rate;
        let end = ends[0] - ends[1] - pair.gap;
        end.max(on_the_way).reaches(zero.like(-NEAR))
    }

    /// Whether structures have nothing to do but to go on, as long as no lane touches.
    #[inline(always)]
    pub(super) fn is_plain(&self) -> bool {
        !self.busy && self.nearest.is_none()
    }

    /// How far the left structure is ahead of the right one at an instant \[s\].
    #[inline(always)]
    fn apart(&self, time: Lanes<S>) -> Apart<S> {
        let [left, right] = &self.motions;
        Apart {
            time,
            displacement: left.displacement - right.displacement,
            velocity: left.velocity - right.velocity,
        }
    }

    /// Follows the structures from an instant to where they are, at another one, in these lanes.
    #[inline(always)]
    fn follow(&mut self, start: &Apart<S>, time: Lanes<S>, lanes: Mask<S>) {
        let end = self.apart(time);
        if let Some(nearest) = &mut self.nearest {
            nearest.follow(start, &end, lanes);
        }
    }

    /// A step between nodes with these accelerations of the ground \[m/s²\], at these instants \[s\].
    #[inline(always)]
    pub(super) fn step(&mut self, [from, to]: [Lanes<S>; 2], times: [f64; 2]) {
        let times = times.map(|time| to.like(time));
        let start = self.apart(times[0]);
        let mut ends = [to; 2];
        for (end, (constants, motion)) in ends
            .iter_mut()
            .zip(self.constants.iter().zip(&self.motions))
        {
            let [displacement, _] = constants.step.predict(motion.kinematics());
            *end = displacement;
        }
        let near = self.busy || Lanes::any(self.may_touch(&self.motions, ends));
        match self.pair.as_ref().map(|pair| &pair.law) {
            Some(Law::Impulsive(law)) if near => {
                let law = *law;
                return self.step_with_impacts(law, [from, to], times);
            }
            Some(Law::Viscoelastic(_) | Law::Formed(_)) if near => self.step_with_force(to, ends),
            _ => {
                for (constants, motion) in self.constants.iter().zip(&mut self.motions) {
                    let ahead = constants.step.predict(motion.kinematics());
                    constants.finish(motion, ahead, to);
                }
            }
        }
        self.follow(&start, times[1], Mask::splat(to.token(), true));
    }

    /// A step at the end of which compliant pairs push each other.
    #[inline(always)]
    fn step_with_force(&mut self, ground: Lanes<S>, ends: [Lanes<S>; 2]) {
        let Self {
            constants,
            motions,
            pair,
            ..
        } = self;
        let Some(pair) = pair else {
            return;
        };
        let length = constants[0].step;
        let [left, right] = &*motions;
        let deformation = ends[0] - ends[1] - pair.gap;
        let rate = (left.velocity + length.whole * left.acceleration)
            - (right.velocity + length.whole * right.acceleration);
        let Some(force) = pair.law.force(deformation, rate) else {
            return;
        };
        let overlaps = deformation.exceeds(rate.like(0.0));
        let last = length.half * force;
        let push = books::Push {
            force,
            impulse: length.half * pair.tally.last() + last,
            rate: left.velocity - right.velocity,
        };
        pair.tally.follow(push, overlaps);
        self.touching_steps += u64::from(Lanes::any(overlaps));
        self.busy = pair.tally.lingers();
        let pushes = [
            body::Push {
                impulse: -last,
                force: -force,
            },
            body::Push {
                impulse: last,
                force,
            },
        ];
        let all = Mask::splat(ground.token(), true);
        for ((constants, motion), push) in constants.iter().zip(motions).zip(pushes) {
            constants.finish_span(motion, &constants.step, all, push, ground);
        }
    }

    /// A step in which, or at the end of which, velocities jump.
    #[inline(always)]
    fn step_with_impacts(
        &mut self,
        law: Impulsive<S>,
        [from, to]: [Lanes<S>; 2],
        times: [Lanes<S>; 2],
    ) {
        let duration = self.constants[0].step.whole;
        let zero = to.like(0.0);
        let all = Mask::splat(to.token(), true);
        let nothing = body::Push {
            impulse: zero,
            force: zero,
        };
        let (mut rest, mut touched) = (duration, false);
        let mut start = self.apart(times[0]);
        if self.located
            && let Some((closes, instant)) = self.closes()
        {
            let ground = from + instant / duration * (to - from);
            let moves = closes & instant.exceeds(zero);
            for (constants, motion) in self.constants.iter().zip(&mut self.motions) {
                let length = constants.span(instant);
                constants.finish_span(motion, &length, moves, nothing, ground);
            }
            let time = times[0] + instant;
            self.follow(&start, time, moves);
            self.strike(closes, law, ground);
            start = self.apart(time);
            (rest, touched) = (duration - instant, true);
        }
        for (constants, motion) in self.constants.iter().zip(&mut self.motions) {
            let length = constants.span(rest);
            constants.finish_span(motion, &length, all, nothing, to);
        }
        self.follow(&start, times[1], all);
        let touches = self.touches();
        self.touching_steps += u64::from(touched | Lanes::any(touches));
        self.strike(touches, law, to);
    }

    /// In which lanes the gap closes within the step, and when \[s\], 0 in others; nothing where it does in none.
    #[inline(always)]
    fn closes(&self) -> Option<(Mask<S>, Lanes<S>)> {
        let pair = self.pair.as_ref()?;
        let [left, right] = &self.motions;
        let (zero, half) = (pair.gap.like(0.0), pair.gap.like(0.5));
        let gap = pair.gap - (left.displacement - right.displacement);
        let closing = Closing {
            gap,
            rate: left.velocity - right.velocity,
            curvature: half * left.acceleration - half * right.acceleration,
        };
        let instant = closing.instant();
        let in_time = self.constants[0].step.whole.exceeds(instant);
        let closes = gap.reaches(zero) & in_time;
        Lanes::any(closes).then(|| (closes, Number::select(closes, instant, zero)))
    }

    /// Where the gap is closed.
    #[inline(always)]
    fn touches(&self) -> Mask<S> {
        let [left, right] = &self.motions;
        let ahead = left.displacement - right.displacement;
        let zero = ahead.like(0.0);
        match &self.pair {
            Some(pair) => (ahead - pair.gap).reaches(zero),
            None => zero.exceeds(zero),
        }
    }

    /// Lets velocities jump in the lanes that touch and approach.
    #[inline(always)]
    fn strike(&mut self, touches: Mask<S>, law: Impulsive<S>, ground: Lanes<S>) {
        let [left, right] = &mut self.motions;
        let mobilities = [
            self.constants[0].inverse_mass,
            self.constants[1].inverse_mass,
        ];
        let velocities = [left.velocity, right.velocity];
        let Some(struck) = struck((touches, law.factor), velocities, mobilities) else {
            return;
        };
        if let Some(pair) = &mut self.pair {
            pair.tally.strike(struck.impulse);
        }
        self.constants[0].jump(left, struck.velocities[0], ground);
        self.constants[1].jump(right, struck.velocities[1], ground);
    }

    /// What happened to the pair in a lane.
    #[inline(always)]
    pub(super) fn sums(&self, pair: &Pair<S>, lane: usize) -> PairSums {
        PairSums {
            closing: self.nearest.map(|nearest| nearest.lane(lane)),
            ..pair.tally.lane(lane)
        }
    }
}
