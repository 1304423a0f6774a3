//! HHT-α method (Hilber, Hughes and Taylor) with Newton iterations and a consistent tangent.
//!
//! Source: H. M. Hilber, T. J. R. Hughes & R. L. Taylor, *Earthquake Engng Struct. Dyn.* 5 (1977) 283. The method uses Newmark's formulas
//! with β = (1−α)²/4 and γ = 1/2 − α. Its equation weighs all forces r except inertia over both ends of the step: m ü⁺ + (1+α) r⁺ − α r =
//! 0. Here r = c u̇ + `f_s` + m `a_g` − F. The pounding forces of compliant pairs are included.
//!
//! The accelerations therefore do not satisfy the equation of motion at the end of a step. After a velocity jump, each acceleration is
//! adjusted to the new damping force, as if the velocity one step earlier had jumped too. A restart from equilibrium would give the two
//! structures of a compliant pair different impulses when another neighbour hits either of them.

use crate::error::require;
use crate::implicit::newmark::Family;
use crate::{Course, Excitation, Recorder, RestoringForce, Row, RunError, Work};

/// Settings of the HHT-α method, which damps motions that the time step cannot resolve. Order 2, no critical time step.
///
/// Impulsive laws act after a step, as a jump of the velocities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hht {
    /// α \[–\], −1/3 (most damping) ..= 0 (none: Newmark's average acceleration).
    pub alpha: f64,
}

impl Hht {
    pub(crate) fn check(self) -> Result<(), RunError> {
        let valid = (-1.0 / 3.0..=0.0).contains(&self.alpha);
        require(valid, "alpha", self.alpha, "-1/3 to 0")
    }
}

/// Integrates a row. Every method has a `run` function with these arguments. Clusters form as in Newmark's method.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: Hht,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    course: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    settings.check()?;
    let alpha = settings.alpha;
    let family = Family {
        beta: 0.25 * (1.0 - alpha) * (1.0 - alpha),
        gamma: 0.5 - alpha,
        alpha,
        in_equilibrium: false,
    };
    family.run(row, excitation, course, recorder)
}
