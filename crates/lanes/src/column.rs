//! Columns of several scenes side by side.

use pounding_contact::Number;

use pounding_solver::formulas::returned;
use pounding_solver::{Bilinear, Elastic, Response, RestoringForce, Row};

/// Rows with columns of one kind.
///
/// A choice and no type parameter: what runs them is long, has a version for every set of instructions, and is compiled in this
/// crate alone.
#[derive(Debug, Clone, Copy)]
pub enum RowsOf<'a> {
    /// Columns that never yield.
    Elastic(&'a [&'a Row<Elastic>]),
    /// Columns that yield at one point.
    Bilinear(&'a [&'a Row<Bilinear>]),
}

/// Columns that run side by side with their like.
pub(super) trait SideBySideColumn: RestoringForce {
    /// The same columns of several scenes.
    type Beside<N: Number>: RestoringForce<N>;

    /// Gathers a number of every scene's columns.
    fn beside<N: Number>(gather: impl Fn(fn(&Self) -> f64) -> N) -> Self::Beside<N>;
}

impl SideBySideColumn for Elastic {
    type Beside<N: Number> = Elastic<N>;

    fn beside<N: Number>(gather: impl Fn(fn(&Self) -> f64) -> N) -> Elastic<N> {
        Elastic {
            stiffness: gather(|column| column.stiffness),
        }
    }
}

/// Perfectly plastic columns of several scenes, with what every step asks for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plastic<N> {
    /// Stiffness \[N/m\] and yield force \[N\].
    limits: [N; 2],
    /// Drift at which columns that were not displaced yield \[m\].
    at_yield: N,
}

impl<N: Number> RestoringForce<N> for Plastic<N> {
    type Memory = N;

    #[inline(always)]
    fn untouched(&self) -> N {
        self.at_yield.like(0.0)
    }

    #[inline(always)]
    fn respond(&self, displacement: N, plastic_displacement: N) -> Response<N, N> {
        let drift = (displacement, plastic_displacement);
        // Nobody asks for the tangent.
        let tangents = [self.limits[0].like(0.0); 2];
        returned(drift, self.limits, self.at_yield, tangents)
    }
}

/// Columns of several scenes that harden.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hardening<N> {
    plastic: Plastic<N>,
    /// Stiffness after yielding \[N/m\].
    elastic: N,
}

impl<N: Number> RestoringForce<N> for Hardening<N> {
    type Memory = N;

    #[inline(always)]
    fn untouched(&self) -> N {
        self.plastic.untouched()
    }

    #[inline(always)]
    fn respond(&self, displacement: N, plastic_displacement: N) -> Response<N, N> {
        let plastic = self.plastic.respond(displacement, plastic_displacement);
        Response {
            force: self.elastic * displacement + plastic.force,
            ..plastic
        }
    }
}

impl SideBySideColumn for Bilinear {
    type Beside<N: Number> = Hardening<N>;

    fn beside<N: Number>(gather: impl Fn(fn(&Self) -> f64) -> N) -> Hardening<N> {
        Hardening {
            plastic: Plastic {
                limits: [gather(|column| column.plastic()[0]), gather(|column| column.plastic()[1])],
                at_yield: gather(|column| column.yield_force / column.stiffness),
            },
            elastic: gather(Self::elastic),
        }
    }
}
