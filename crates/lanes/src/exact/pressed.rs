//! The equations of two neighbours that press against each other.
//!
//! Just after a touch, forces are powers of δ such as 1/4, which steps in time follow badly. Motions are therefore functions of s with s⁴
//! the time since the touch; in s they are smooth.

use pounding_contact::{Action, Form, Number};

/// A force closer than this to the end of its branch has just bent, or is about to bend: its branch is evaluated a little later.
const SLOWLY: f64 = 1e-5;

/// Displacement and velocity of the left side, then of the right side, and the impulse so far.
pub(super) type State<N> = [N; 5];

/// A state with its derivative in s.
#[derive(Clone, Copy)]
pub(super) struct PressedPoint<N> {
    /// Fourth root of the time since the touch \[s^¼\].
    pub(super) s: N,
    pub(super) state: State<N>,
    pub(super) slope: State<N>,
}

/// A structure or a wall.
#[derive(Clone, Copy)]
pub(super) struct Half<N> {
    /// 1/m \[1/kg\], c \[N·s/m\], k \[N/m\], and mobility: 1, or 0 for a wall.
    pub(super) inverse_mass: N,
    pub(super) damping: N,
    pub(super) stiffness: N,
    pub(super) mobile: N,
}

/// Constants of the contact.
pub(super) struct Pressed<N> {
    pub(super) left: Half<N>,
    pub(super) right: Half<N>,
    /// Largest inverse mass of the two sides \[1/kg\].
    pub(super) largest_inverse_mass: N,
    /// Gap \[m\].
    pub(super) gap: N,
    pub(super) form: Form<N>,
    /// Approach rate at the touch \[m/s\].
    pub(super) speed: N,
    /// Ground acceleration \[m/s²\] extrapolated to the touch from this interval, and its slope \[m/s³\].
    pub(super) ground: [N; 2],
}

/// Event that ends a smooth piece of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Corner {
    /// The force bends: a damper stops or starts to act.
    Bend,
    /// The neighbours part.
    Parting,
}

impl<N: Number> PressedPoint<N> {
    /// The state moved by a distance along its slope.
    #[inline(always)]
    pub(super) fn moved(&self, by: N) -> State<N> {
        let mut state = self.state;
        for (number, slope) in state.iter_mut().zip(self.slope) {
            *number = *number + by * slope;
        }
        state
    }
}

impl<N: Number> Half<N> {
    /// Acceleration relative to the ground \[m/s²\], from displacement and velocity and a pounding force \[N\].
    #[inline(always)]
    fn acceleration(&self, [u, v]: [N; 2], force: N, ground: N) -> N {
        let force = force - (self.damping * v + self.stiffness * u);
        self.inverse_mass * force - self.mobile * ground
    }
}

impl<N: Number> Pressed<N> {
    #[inline(always)]
    pub(super) fn deformation(&self, state: &State<N>) -> N {
        state[0] - state[2] - self.gap
    }

    /// Pounding force \[N\]; 0 if the neighbours do not touch.
    #[inline(always)]
    pub(super) fn force(&self, state: &State<N>) -> N {
        let (deformation, zero) = (self.deformation(state), self.gap.like(0.0));
        let force = self.form.force(deformation, rate(state));
        N::select(deformation.exceeds(zero), force, zero)
    }

    /// Derivative of a state in s.
    #[inline(always)]
    pub(super) fn slope(&self, s: N, state: &State<N>) -> State<N> {
        let [u, v, w, z, _] = *state;
        let [value, slope] = self.ground;
        let ground = value + slope * fourth_power(s);
        let force = self.force(state);
        let left = self.left.acceleration([u, v], -force, ground);
        let right = self.right.acceleration([w, z], force, ground);
        let factor = s.like(4.0) * s * s * s;
        let mut rates = [v, left, z, right, force];
        for rate in &mut rates {
            *rate = factor * *rate;
        }
        rates
    }

    /// The point of a state.
    #[inline(always)]
    pub(super) fn at(&self, s: N, state: State<N>) -> PressedPoint<N> {
        let slope = self.slope(s, &state);
        PressedPoint { s, state, slope }
    }

    /// A number that passes through zero at a corner.
    ///
    /// At a bend, its sign tells the smooth branch of the force. Either a damper that acts on approach only acts or not, or the force
    /// pushes or is clamped because the formula would pull. Its magnitude is usually 1. Without a deformation it has the sign of a very
    /// small deformation. This finds a force that is clamped before neighbours part if the step ends after both.
    #[inline(always)]
    pub(super) fn side_of(&self, corner: Corner, state: &State<N>) -> N {
        match (corner, self.form.action) {
            (Corner::Parting, _) => self.deformation(state),
            (Corner::Bend, Action::Approach) => rate(state) / self.speed,
            (Corner::Bend, Action::Both) => {
                let (deformation, rate) = (self.deformation(state), rate(state));
                let Form { spring, damper, .. } = &self.form;
                if spring.power == damper.power {
                    return rate.like(1.0) + damper.coefficient / spring.coefficient * rate;
                }
                let zero = rate.like(0.0);
                let side = self.form.unclamped(deformation, rate) / spring.at(deformation);
                let damped = damper.coefficient.exceeds(zero);
                let at_the_touch = N::select(damped, rate / self.speed, rate.like(1.0));
                N::select(deformation.exceeds(zero), side, at_the_touch)
            }
        }
    }

    /// The number at the start of a step. If the force bends there, it is taken a little later, on the branch that follows.
    #[inline(always)]
    pub(super) fn side_behind(&self, corner: Corner, here: &PressedPoint<N>, probe: N) -> N {
        let side = self.side_of(corner, &here.state);
        let bends = !side.abs().exceeds(side.like(SLOWLY));
        if corner == Corner::Parting || !N::any(bends) {
            return side;
        }
        N::select(bends, self.side_of(corner, &here.moved(probe)), side)
    }

    /// Lanes in which neighbours are apart after a step. Neighbours that have just touched are together to rounding, and the rate decides.
    #[inline(always)]
    pub(super) fn parts(&self, here: &PressedPoint<N>, next: &PressedPoint<N>) -> N::Mask {
        let zero = self.gap.like(0.0);
        let overlapped = self.deformation(&here.state).exceeds(zero);
        let opens = zero.exceeds(rate(&next.state));
        zero.exceeds(self.deformation(&next.state)) & (overlapped | opens)
    }

    /// The force \[N\] at a point and its rate \[N/s\], on the branch of an approach where `approaches`, else on the branch of the present
    /// rate.
    #[inline(always)]
    pub(super) fn climb(&self, point: &PressedPoint<N>, approaches: N::Mask) -> [N; 2] {
        let zero = self.gap.like(0.0);
        let (deformation, mut rate) = (self.deformation(&point.state), rate(&point.state));
        if self.form.action == Action::Approach {
            let least = larger(rate, rate.like(f64::MIN_POSITIVE));
            rate = N::select(approaches, least, rate);
        }
        let response = self.form.respond(deformation, rate);
        let time = point.s.like(4.0) * point.s * point.s * point.s;
        let change = (point.slope[1] - point.slope[3]) / time;
        let climb = response.stiffness * rate + response.damping * change;
        let touch = deformation.exceeds(zero);
        [N::select(touch, response.force, zero), N::select(touch, climb, rate.like(-1.0))]
    }
}

/// Approach rate \[m/s\].
#[inline(always)]
pub(super) fn rate<N: Number>(state: &State<N>) -> N {
    state[1] - state[3]
}

/// The larger of two numbers; the second if the first is NaN.
#[inline(always)]
pub(super) fn larger<N: Number>(one: N, other: N) -> N {
    N::select(one.exceeds(other), one, other)
}

#[inline(always)]
pub(super) fn fourth_power<N: Number>(s: N) -> N {
    (s * s) * (s * s)
}
