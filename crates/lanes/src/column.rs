//! Columns of several scenes in lanes.

use pounding_contact::Number;

use pounding_solver::formulas::returned;
use pounding_solver::{Bilinear, Elastic, Response, RestoringForce, Row};

/// Rows with columns of a common type.
///
/// An enum instead of a type parameter: the code behind it is long, has a version for every instruction set, and must be compiled only in
/// this crate.
#[derive(Debug, Clone, Copy)]
pub enum RowsOf<'a> {
    /// Columns that never yield.
    Elastic(&'a [&'a Row<Elastic>]),
    /// Columns that yield at a sharp knee.
    Bilinear(&'a [&'a Row<Bilinear>]),
}

/// Columns that can run in lanes.
pub(super) trait SideBySideColumn: RestoringForce {
    /// The columns of several scenes.
    type Beside<N: Number>: RestoringForce<N>;

    /// Collects the columns of all scenes; `gather` collects a number from each.
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

/// Perfectly plastic columns of several scenes, with the values that every step needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plastic<N> {
    /// Stiffness \[N/m\] and yield force \[N\].
    limits: [N; 2],
    /// Drift of first yielding \[m\].
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
        // The tangent is not used.
        let tangents = [self.limits[0].like(0.0); 2];
        returned(displacement, plastic_displacement, self.limits, self.at_yield, tangents)
    }
}

/// Hardening columns of several scenes.
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
