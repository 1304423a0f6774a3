//! Steps in which a force or a displacement turns twice, which the ends do not show.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::Pressing;
use super::reach::Reached;
use crate::exact::pressed::State;
use crate::number::{Lanes, Mask};

/// The cubic through a number at both ends of a step, with its derivatives with respect to the part of the step.
struct Cubic<S: Simd> {
    values: [Lanes<S>; 2],
    slopes: [Lanes<S>; 2],
}

impl<S: Simd> Cubic<S> {
    /// Whether it turns twice, the part of the step at which it is steepest between its turns, and its slope there.
    ///
    /// The slope at a part τ is start − 2 falls τ + bends τ². Its extremum is at τ = falls / bends.
    #[inline(always)]
    fn turns_twice(&self) -> (Mask<S>, Lanes<S>, Lanes<S>) {
        let Self {
            values: [from, to],
            slopes: [start, end],
        } = *self;
        let [zero, two, three] = [0.0, 2.0, 3.0].map(|number| from.like(number));
        let change = to - from;
        let falls = two * start + end - three * change;
        let bends = three * (start + end - two * change);
        let between = (falls * start).exceeds(zero) & bends.abs().exceeds(falls.abs());
        let turns = (falls * falls).exceeds(bends * start) & (bends * start).exceeds(zero);
        let turns = turns & between & (start * end).exceeds(zero);
        let part = falls / bends;
        (turns, part, start - falls * part)
    }
}

impl<S: Simd> Pressing<S> {
    /// Shortens a step in which the force or a displacement turns twice and may have its largest value in between, so that each turn is in
    /// a separate step.
    ///
    /// A cubic may show false turns in the first steps of a contact, which costs a trial. After a touch, a bend or a jump of the ground's
    /// acceleration, the rate of the force is unknown. Two turns of the force in such a step are not detected.
    #[inline(always)]
    pub(super) fn stop_between_turns(&self, force: [Lanes<S>; 2], reached: &mut Reached<S>) {
        let (here, next) = (&self.here, reached.next);
        let [start, end] = [here.s, next.s].map(|s| s.like(4.0) * s * s * s);
        let length = next.s - here.s;
        let zero = length.like(0.0);
        let forces = Cubic {
            values: [here.slope[4] / start, force[0]],
            slopes: [length * start * self.climb, length * end * force[1]],
        };
        let peak = self.peak_force;
        self.stop_between(&forces, [zero - peak, peak], reached);
        for side in 0..2 {
            let u = 2 * side;
            let displacements = Cubic {
                values: [here.state[u], next.state[u]],
                slopes: [length * here.slope[u], length * next.slope[u]],
            };
            self.stop_between(&displacements, self.extremes[side], reached);
        }
        if let Some(closing) = self.closing {
            let ahead = |state: &State<Lanes<S>>| state[0] - state[2];
            let distances = Cubic {
                values: [ahead(&here.state), ahead(&next.state)],
                slopes: [&here.slope, &next.slope].map(|slope| length * ahead(slope)),
            };
            self.stop_between(&distances, [zero - closing, closing], reached);
        }
    }

    /// Shortens a step in which a single quantity turns twice.
    #[inline(always)]
    fn stop_between(&self, cubic: &Cubic<S>, [least, largest]: [Lanes<S>; 2], reached: &mut Reached<S>) {
        let (turns, part, slope) = cubic.turns_twice();
        let wanted = turns & self.used.exceeds(part.like(0.0));
        if !Lanes::any(wanted) {
            return;
        }
        let [from, to] = cubic.values;
        // The excursion between the turns is at most this value.
        let excursion = slope.abs();
        let beyond = (from.max(to) + excursion).exceeds(largest) | least.exceeds(from.min(to) - excursion);
        let allowed = self.tolerance * largest.abs().max(least.abs());
        reached.try_again(wanted & beyond & excursion.exceeds(allowed), part);
    }
}
