#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

/// Force, tangent and new memory of a column at a displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response<Memory, N = f64> {
    /// Restoring force `f_s` \[N\], positive against a displacement to the right.
    pub force: N,
    /// Tangent stiffness `k_t` \[N/m\].
    pub tangent: N,
    /// Memory of the column if this displacement is accepted.
    pub memory: Memory,
}

/// The restoring force of a structure's columns as a pure function of displacement and memory.
///
/// Because it is pure, an explicit method accepts the response at once, and Newton's method may ask again.
pub trait RestoringForce<N: Number = f64>: Copy {
    /// Memory of the column between steps; `()` if it has none.
    type Memory: Copy + std::fmt::Debug;

    /// Memory of a column before any displacement.
    fn untouched(&self) -> Self::Memory;

    /// Responds to a displacement \[m\], from a memory.
    fn respond(&self, displacement: N, memory: Self::Memory) -> Response<Self::Memory, N>;

    /// Responds to the first displacement \[m\], at t = 0, to rounding: no later step would correct its error.
    fn loaded(&self, displacement: N) -> Response<Self::Memory, N> {
        self.respond(displacement, self.untouched())
    }
}

/// Columns with known loop parameters, as the exact method and the ledger need them in addition to [`RestoringForce`].
pub trait Hysteretic: RestoringForce {
    /// The loop.
    fn hysteresis(&self) -> Hysteresis;

    /// Stiffness of the elastic branch k \[N/m\].
    fn stiffness(&self) -> f64 {
        self.hysteresis().stiffness
    }

    /// Yield force `f_y` \[N\]; infinite for columns that never yield.
    fn yield_force(&self) -> f64 {
        self.hysteresis().yield_force
    }
}

/// The loop of columns: f = a k d + (1 − a) k z under a drift d.
///
/// z \[m\] is the elastic part of the drift. It equals d until it reaches ±`f_y`/k, and stays there while the columns yield; with a smooth
/// knee it approaches this value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hysteresis {
    /// Stiffness k \[N/m\], ≥ 0.
    pub stiffness: f64,
    /// Ratio a of the stiffness after yielding to the stiffness \[–\], a < 1; negative under gravity that takes more than columns gain.
    pub hardening: f64,
    /// Yield force `f_y` \[N\], > 0: with a sharp knee, the force at the drift `f_y`/k. Infinite for columns that never yield.
    pub yield_force: f64,
    /// Shape of the knee.
    pub knee: Knee,
}

/// How columns pass from elastic behaviour to yielding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Knee {
    /// At a point: perfectly plastic, or bilinear.
    Sharp,
    /// Smoothly; see [`BoucWen`](crate::BoucWen).
    Smooth(Smoothness),
    /// Without any elastic drift before; see [`Sliding`](crate::Sliding). Then a is 1, and f = k d + h with |h| ≤ `f_y`.
    Rigid,
}

/// Shape of a smooth knee: dz/dd = 1 − |z k/`f_y`|ⁿ (γ + β sgn(z ḋ)), γ = 1 − β.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Smoothness {
    /// n \[–\], 1 to 20: the larger, the sharper.
    pub exponent: u32,
    /// β \[–\], 0 ..= 1: 1/2 unloads along the elastic line; 0 dissipates nothing.
    pub unloading: f64,
}

impl Hysteresis {
    /// A loop that never yields.
    pub fn elastic(stiffness: f64) -> Self {
        Self::plastic(stiffness, f64::INFINITY)
    }

    /// A loop without hardening.
    pub fn plastic(stiffness: f64, yield_force: f64) -> Self {
        Self {
            stiffness,
            hardening: 0.0,
            yield_force,
            knee: Knee::Sharp,
        }
    }
}

/// Linear elastic columns, without memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic<N = f64> {
    /// Stiffness k \[N/m\], ≥ 0.
    pub stiffness: N,
}

impl<N: Number> RestoringForce<N> for Elastic<N> {
    type Memory = ();

    #[inline(always)]
    fn untouched(&self) {}

    #[inline(always)]
    fn respond(&self, displacement: N, (): ()) -> Response<(), N> {
        Response {
            force: self.stiffness * displacement,
            tangent: self.stiffness,
            memory: (),
        }
    }
}

impl Hysteretic for Elastic {
    fn hysteresis(&self) -> Hysteresis {
        Hysteresis::elastic(self.stiffness)
    }
}

/// The return map of perfectly plastic columns with a sharp knee, from stiffness \[N/m\], yield force \[N\] and the drift of first yielding
/// \[m\]. `tangents` \[N/m\] are those on the elastic branch and beyond.
#[inline(always)]
pub fn returned<N: Number>(
    displacement: N,
    plastic_displacement: N,
    [stiffness, yield_force]: [N; 2],
    at_yield: N,
    [elastic, plastic]: [N; 2],
) -> Response<N, N> {
    let trial = stiffness * (displacement - plastic_displacement);
    let (above, below) = (trial.exceeds(yield_force), (-yield_force).exceeds(trial));
    // A NaN trial stays NaN and stops the run.
    let branch = |beyond: [N; 2], elastic: N| N::select(above, beyond[0], N::select(below, beyond[1], elastic));
    let plastic_displacements = [displacement - at_yield, displacement + at_yield];
    Response {
        force: branch([yield_force, -yield_force], trial),
        tangent: branch([plastic, plastic], elastic),
        memory: branch(plastic_displacements, plastic_displacement),
    }
}

/// The return map of a single column; the drift of first yielding is computed only if the column yields.
#[inline(always)]
pub(crate) fn yielding(
    displacement: f64,
    plastic_displacement: f64,
    [stiffness, yield_force]: [f64; 2],
    at_yield: impl FnOnce() -> f64,
    tangents: [f64; 2],
) -> Response<f64> {
    let trial = stiffness * (displacement - plastic_displacement);
    if trial.abs() <= yield_force {
        return Response {
            force: trial,
            tangent: tangents[0],
            memory: plastic_displacement,
        };
    }
    let limits = [stiffness, yield_force];
    returned(displacement, plastic_displacement, limits, at_yield(), tangents)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Bilinear;

    const COLUMN: Bilinear = Bilinear {
        stiffness: 2.056e6,
        yield_force: 70e3,
        hardening: 0.0,
    };

    #[test]
    fn reference_hysteresis_loop() {
        let mut memory = 0.0;
        let mut force = 0.0;
        // The incremental form of the paper's notes, next to the return map.
        let mut incremental: f64 = 0.0;
        let mut last = 0.0;
        for step in 0..400_i32 {
            let phase = f64::from(step % 100) / 50.0 - 1.0;
            let displacement = 0.001 * f64::from(step) * (1.0 - phase * phase) * phase.signum();
            let response = COLUMN.respond(displacement, memory);
            (memory, force) = (response.memory, response.force);
            incremental = (incremental + COLUMN.stiffness * (displacement - last)).clamp(-70e3, 70e3);
            last = displacement;
            assert!((force - incremental).abs() < 1e-6, "step {step}: {force} against {incremental}");
        }
        assert!(memory != 0.0 && force.is_finite(), "the loop must have yielded");
    }

    #[test]
    fn limit_yield_never_reached_is_elastic() {
        let elastic = Elastic { stiffness: 2.056e6 };
        for yield_force in [1e9, f64::INFINITY] {
            let column = Bilinear { yield_force, ..COLUMN };
            for displacement in [0.0, 1e-300, -0.033, 0.1 / 3.0, 17.0] {
                let (lean, rich) = (elastic.respond(displacement, ()), column.respond(displacement, 0.0));
                assert_eq!((lean.force, lean.tangent, 0.0), (rich.force, rich.tangent, rich.memory));
            }
        }
    }

    #[test]
    fn extreme_not_a_number_stays_one() {
        assert!(COLUMN.respond(f64::NAN, 0.0).force.is_nan(), "a fault must not be clamped away");
    }
}
