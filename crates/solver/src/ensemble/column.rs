//! Columns of several scenes side by side.

use pounding_contact::Number;

use crate::{Bilinear, Elastic, ElastoPlastic, RestoringForce, Row};

/// Rows with columns of one kind.
///
/// A choice and no type parameter: what runs them is long, has a version for every set of instructions, and is compiled in this
/// crate alone.
#[derive(Debug, Clone, Copy)]
pub enum RowsOf<'a> {
    /// Columns that never yield.
    Elastic(&'a [&'a Row<Elastic>]),
    /// Columns that are perfectly plastic once they yield.
    ElastoPlastic(&'a [&'a Row<ElastoPlastic>]),
    /// Columns that harden.
    Bilinear(&'a [&'a Row<Bilinear>]),
}

/// Columns that run side by side with their like.
pub(super) trait SideBySideColumn: RestoringForce {
    /// The same columns of several scenes.
    type Beside<N: Number>: RestoringForce<N>;

    /// Gathers a number of every scene's columns.
    fn beside<N: Number>(gather: impl Fn(fn(&Self) -> f64) -> N) -> Self::Beside<N>;

    /// What is remembered: the first where the mask says yes, else the second.
    fn select<N: Number>(
        mask: N::Mask,
        yes: MemoryOf<N, Self>,
        no: MemoryOf<N, Self>,
    ) -> MemoryOf<N, Self>;
}

/// What columns remember in several scenes.
pub(super) type MemoryOf<N, Column> =
    <<Column as SideBySideColumn>::Beside<N> as RestoringForce<N>>::Memory;

impl SideBySideColumn for Elastic {
    type Beside<N: Number> = Elastic<N>;

    fn beside<N: Number>(gather: impl Fn(fn(&Self) -> f64) -> N) -> Elastic<N> {
        Elastic {
            stiffness: gather(|column| column.stiffness),
        }
    }

    #[inline(always)]
    fn select<N: Number>(_: N::Mask, (): (), (): ()) {}
}

impl SideBySideColumn for ElastoPlastic {
    type Beside<N: Number> = ElastoPlastic<N>;

    fn beside<N: Number>(gather: impl Fn(fn(&Self) -> f64) -> N) -> ElastoPlastic<N> {
        ElastoPlastic {
            stiffness: gather(|column| column.stiffness),
            yield_force: gather(|column| column.yield_force),
        }
    }

    #[inline(always)]
    fn select<N: Number>(mask: N::Mask, yes: N, no: N) -> N {
        N::select(mask, yes, no)
    }
}

impl SideBySideColumn for Bilinear {
    type Beside<N: Number> = Bilinear<N>;

    fn beside<N: Number>(gather: impl Fn(fn(&Self) -> f64) -> N) -> Bilinear<N> {
        Bilinear {
            stiffness: gather(|column| column.stiffness),
            yield_force: gather(|column| column.yield_force),
            hardening: gather(|column| column.hardening),
        }
    }

    #[inline(always)]
    fn select<N: Number>(mask: N::Mask, yes: N, no: N) -> N {
        N::select(mask, yes, no)
    }
}
