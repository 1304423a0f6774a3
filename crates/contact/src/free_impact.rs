//! Numerical integration of a free impact to rounding, for laws without a closed form.
//!
//! With δ = L w⁴, a time σ with dt = w³ dσ, and units in which m = v₀ = K = 1, every law of the crate is a polynomial: 4 w′ = v, v′ = −w³
//! (w⁴ⁿ + C w^4κ v). Extrapolated midpoint steps (W. B. Gragg; R. Bulirsch and J. Stoer, *Numer. Math.* 8 (1966) 1) of order 12 then meet
//! no singularity. The damper of the nonlinear viscoelastic element, which starts like δ^(1/4) at the first touch, becomes smooth, and so
//! does the parting.

use std::f64::consts::PI;

use crate::form::{Action, Form, Power, Slope, Term};
use crate::{FreePair, search};

/// Result of a free impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeImpact {
    /// Coefficient of restitution delivered \[–\].
    pub restitution: f64,
    /// Largest deformation \[m\].
    pub max_deformation: f64,
    /// Largest force \[N\].
    pub peak_force: f64,
    /// Impulse \[N·s\].
    pub impulse: f64,
    /// Time from the first touch to the parting \[s\]: δ = 0 at both. A clamped force may end earlier.
    pub duration: f64,
    /// Time from the first touch to the end of the force \[s\]. A run reports it as the duration of a collision.
    pub force_duration: f64,
}

/// Most steps of an impact. Only damping so strong that almost nothing comes back needs more.
const MOST_STEPS: u32 = 20_000;
/// A step is halved if its estimated error exceeds this value, in the units of the impact.
const TOLERANCE: f64 = 1e-14;
/// Longest step, in the units of the impact.
const LONGEST: f64 = 0.5;
/// Columns of the extrapolation. Column j divides the step into 2(j+1) parts.
const N_COLUMNS: usize = 6;

/// Fourth root of the deformation, its rate, and time, in the units of the impact.
#[derive(Clone, Copy)]
struct State {
    root: f64,
    rate: f64,
    time: f64,
}

/// The impact in units in which mass, approach speed and stiffness are 1.
#[derive(Clone, Copy)]
struct Orbit {
    spring: Power,
    /// The damper acts in both phases, so that a step may look beyond the end of its phase.
    damper: Term,
    length: f64,
    force: f64,
    speed: f64,
}

impl FreeImpact {
    /// Integrates the collision of a free pair under a form.
    ///
    /// Returns `None` if the damping is so strong that the return takes more than 20 000 steps. Takes about a millisecond.
    pub fn of_form(form: &Form, pair: &FreePair) -> Option<Self> {
        if let Some(second) = form.second {
            return Some(two_slopes(form, second, pair));
        }
        let orbit = Orbit::new(form, pair);
        let mut peak = 0.0;
        let middle = orbit.approach(|state, step| {
            let force = |part: f64| orbit.force(orbit.advance(state, part).0);
            peak = search::maximum(0.0, step, force).max(peak);
        })?;
        let end = orbit.returning(form.action).part(middle)?;
        // The rest is free flight: the force of the pair is clamped.
        let flight = deformation(end.root.max(0.0)) / -end.rate;
        let seconds = |time: f64| time * orbit.length / orbit.speed;
        Some(Self {
            restitution: -end.rate,
            max_deformation: orbit.length * deformation(middle.root),
            peak_force: peak * orbit.force,
            impulse: pair.impulse(-end.rate),
            duration: seconds(end.time + flight),
            force_duration: seconds(end.time),
        })
    }
}

/// Coefficient of restitution \[–\]; `None` if the damping is too strong.
pub(crate) fn restitution(form: &Form, pair: &FreePair) -> Option<f64> {
    let orbit = Orbit::new(form, pair);
    let middle = orbit.approach(|_, _| ())?;
    let end = orbit.returning(form.action).part(middle)?;
    Some(-end.rate)
}

/// Impact on a linear spring with a second slope and no damper: two arcs of swings, there and back.
fn two_slopes(form: &Form, Slope { from, added }: Slope, pair: &FreePair) -> FreeImpact {
    let (m, v) = (pair.reduced_mass, pair.approach_speed);
    let (first, stiffness) = (form.spring.at(from), form.spring.coefficient + added);
    let max_deformation = pair.deformation(form, 1.0);
    let (slow, fast) = ((form.spring.coefficient / m).sqrt(), (stiffness / m).sqrt());
    let half = if max_deformation > from {
        let sine = from * slow / v;
        let rate = v * (1.0 - sine * sine).sqrt();
        libm::asin(sine) / slow + libm::atan2(rate * stiffness, first * fast) / fast
    } else {
        0.5 * PI / slow
    };
    FreeImpact {
        restitution: 1.0,
        max_deformation,
        peak_force: form.unclamped(max_deformation, 0.0),
        impulse: pair.impulse(1.0),
        duration: 2.0 * half,
        force_duration: 2.0 * half,
    }
}

fn deformation(root: f64) -> f64 {
    let square = root * root;
    square * square
}

impl Orbit {
    fn new(form: &Form, pair: &FreePair) -> Self {
        let (spring, speed) = (form.spring, pair.approach_speed);
        // m v₀² = K L^(n+1).
        let ratio = pair.reduced_mass * speed * speed / spring.coefficient;
        let length = libm::pow(ratio, 1.0 / (1.0 + spring.power.value()));
        let force = spring.at(length);
        Self {
            spring: spring.power,
            damper: Term {
                coefficient: form.damper.at(length) * speed / force,
                ..form.damper
            },
            length,
            force,
            speed,
        }
    }

    /// The impact after the largest deformation.
    fn returning(mut self, action: Action) -> Self {
        if action == Action::Approach {
            self.damper.coefficient = 0.0;
        }
        self
    }

    /// The force of a state, before the clamp.
    fn force(&self, state: State) -> f64 {
        let deformation = deformation(state.root);
        self.spring.of(deformation) + self.damper.at(deformation) * state.rate
    }

    /// Integrates from the first touch to the largest deformation; `visit` sees every step.
    fn approach(&self, mut visit: impl FnMut(State, f64)) -> Option<State> {
        let mut state = State {
            root: 0.0,
            rate: 1.0,
            time: 0.0,
        };
        let (mut step, mut n_steps) = (LONGEST, 0);
        loop {
            let (end, length) = self.step(state, &mut step, &mut n_steps)?;
            if end.rate <= 0.0 {
                let length = search::root(0.0, length, |part| -self.advance(state, part).0.rate);
                visit(state, length);
                let middle = self.advance(state, length).0;
                return Some(State { rate: 0.0, ..middle });
            }
            visit(state, length);
            state = end;
        }
    }

    /// Integrates from the largest deformation to the end of the force.
    fn part(&self, mut state: State) -> Option<State> {
        let (mut step, mut n_steps) = (LONGEST, 0);
        loop {
            let (end, length) = self.step(state, &mut step, &mut n_steps)?;
            let over = |end: State| end.root <= 0.0 || self.force(end) <= 0.0;
            if over(end) {
                let parted = |part: f64| {
                    let end = self.advance(state, part).0;
                    if over(end) { 1.0 } else { -1.0 }
                };
                return Some(self.advance(state, search::root(0.0, length, parted)).0);
            }
            state = end;
        }
    }

    /// Makes one step, shortened until its error is small. `step` is then the next step to try.
    fn step(&self, state: State, step: &mut f64, n_steps: &mut u32) -> Option<(State, f64)> {
        loop {
            *n_steps += 1;
            if *n_steps > MOST_STEPS {
                return None;
            }
            let taken = *step;
            let (end, error) = self.advance(state, taken);
            if error <= TOLERANCE {
                *step = LONGEST.min(1.5 * taken);
                return Some((end, taken));
            }
            *step = 0.5 * taken;
        }
    }

    /// The state after a step, and its estimated error.
    fn advance(&self, state: State, step: f64) -> (State, f64) {
        let mut columns = [[0.0; 3]; N_COLUMNS];
        let mut error = 0.0_f64;
        for row in 0..N_COLUMNS {
            let parts = 2 * (row + 1);
            let mut better = self.midpoint(state, step, parts);
            for (column, held) in columns.iter_mut().enumerate().take(row) {
                let ratio = (row + 1) as f64 / (row - column) as f64;
                let gain = 1.0 / (ratio * ratio - 1.0);
                let coarse = std::mem::replace(held, better);
                error = 0.0;
                for (value, coarse) in better.iter_mut().zip(coarse) {
                    let change = (*value - coarse) * gain;
                    *value += change;
                    error = error.max(change.abs());
                }
            }
            columns[row] = better;
        }
        let [root, rate, time] = columns[N_COLUMNS - 1];
        (State { root, rate, time }, error)
    }

    /// Gragg's midpoint rule over a step.
    fn midpoint(&self, state: State, step: f64, parts: usize) -> [f64; 3] {
        let h = step / parts as f64;
        let mut before = [state.root, state.rate, state.time];
        let slopes = self.slopes(before);
        let mut now: [f64; 3] = std::array::from_fn(|i| before[i] + h * slopes[i]);
        for _ in 1..parts {
            let slopes = self.slopes(now);
            let next = std::array::from_fn(|i| before[i] + 2.0 * h * slopes[i]);
            (before, now) = (now, next);
        }
        let slopes = self.slopes(now);
        std::array::from_fn(|i| 0.5 * (now[i] + before[i] + h * slopes[i]))
    }

    fn slopes(&self, [root, rate, time]: [f64; 3]) -> [f64; 3] {
        let cube = root * root * root;
        let force = self.force(State { root, rate, time });
        [0.25 * rate, -cube * force, cube]
    }
}
