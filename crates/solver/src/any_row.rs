//! The row of a run, with the leanest columns that suffice.

use crate::{
    Bilinear, Course, Elastic, Excitation, Hysteretic, Integrator, Ledger, Link, Mixed, Pair, Recorders, Row, RunError, Travel, Work,
};

/// A row with the leanest columns that suffice, chosen once per run.
#[derive(Debug, Clone)]
pub enum AnyRow {
    /// No column yields.
    Elastic(Row<Elastic>),
    /// Some columns yield at a sharp knee. Elastic storeys among them have an infinite yield force; perfectly plastic ones have a hardening
    /// of 0.
    Bilinear(Row<Bilinear>),
    /// Some columns yield smoothly.
    Mixed(Row<Mixed>),
}

/// Work on a row, independent of the type of its columns.
pub trait OnRow {
    /// The result.
    type Output;

    /// Works on a row.
    fn on<Column: Hysteretic>(self, row: &Row<Column>) -> Self::Output;
}

/// Evaluates an expression for the row of whichever column type.
macro_rules! with_row {
    ($any:expr, $row:ident => $done:expr) => {
        match $any {
            AnyRow::Elastic($row) => $done,
            AnyRow::Bilinear($row) => $done,
            AnyRow::Mixed($row) => $done,
        }
    };
}

impl AnyRow {
    /// Works on the row, whatever its columns are.
    pub fn on<Task: OnRow>(&self, work: Task) -> Task::Output {
        with_row!(self, row => work.on(row))
    }

    /// Returns the pairs that can touch.
    pub fn pairs(&self) -> &[Pair] {
        with_row!(self, row => row.pairs())
    }

    /// Returns the links.
    pub fn links(&self) -> &[Link] {
        with_row!(self, row => row.links())
    }

    /// Whether the pairs form a chain ([`Row::is_chain`]).
    pub fn is_chain(&self) -> bool {
        with_row!(self, row => row.is_chain())
    }

    /// Returns how an excitation travels along the row; `None` if it arrives everywhere at t = 0.
    pub fn travel(&self, excitation: Excitation<'_>) -> Option<Travel> {
        with_row!(self, row => row.travel(excitation))
    }

    /// Returns an empty ledger for a run, which checks all laws.
    pub fn ledger<'a>(&'a self, excitation: Excitation<'a>) -> Ledger<'a> {
        with_row!(self, row => Ledger::new(row, excitation))
    }

    /// Integrates the row with code that is compiled once, in this crate; see [`Integrator::run`].
    ///
    /// # Errors
    /// Those of [`Integrator::run`].
    pub fn run(
        &self,
        integrator: &Integrator,
        excitation: Excitation<'_>,
        course: Course,
        recorders: &mut Recorders<'_, '_>,
    ) -> Result<Work, RunError> {
        with_row!(self, row => integrator.run(row, excitation, course, recorders))
    }
}
