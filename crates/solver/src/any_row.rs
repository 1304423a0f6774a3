//! A row with the leanest columns that it needs.

use crate::{Bilinear, Course, Elastic, Excitation, Hysteretic, Integrator, Ledger, Mixed, Pair, Recorders, Row, RunError, Travel, Work};

/// A row with the leanest columns that it needs: decided once per run.
#[derive(Debug, Clone)]
pub enum AnyRow {
    /// No column yields.
    Elastic(Row<Elastic>),
    /// Some yield at one point. Elastic storeys among them have an infinite yield force, perfectly plastic ones a hardening of 0.
    Bilinear(Row<Bilinear>),
    /// Some yield smoothly.
    Mixed(Row<Mixed>),
}

/// Work on a row that does not ask what its columns are.
pub trait OnRow {
    /// What comes of it.
    type Output;

    /// Works on a row.
    fn on<Column: Hysteretic>(self, row: &Row<Column>) -> Self::Output;
}

/// Does the same with the row of any columns.
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

    /// Whether the pairs are a chain ([`Row::is_chain`]).
    pub fn is_chain(&self) -> bool {
        with_row!(self, row => row.is_chain())
    }

    /// Returns how an excitation travels along the row; `None` if it arrives everywhere at t = 0.
    pub fn travel(&self, excitation: Excitation<'_>) -> Option<Travel> {
        with_row!(self, row => row.travel(excitation))
    }

    /// Returns an empty ledger for a run, held to all laws.
    pub fn ledger<'a>(&'a self, excitation: Excitation<'a>) -> Ledger<'a> {
        with_row!(self, row => Ledger::new(row, excitation))
    }

    /// Integrates the row, in code that is compiled here once; see [`Integrator::run`].
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
