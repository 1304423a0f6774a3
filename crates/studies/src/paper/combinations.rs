//! Every combination of the choices of the paper's program, and how many of the printed numbers each gives.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::program::{Impacts, Joined, Length, Loads, Program, Shared, Start};
use crate::cell::to_csv;
use crate::{Comparison, Completed, Digits, PublishedValues, StudyError, Table};

/// Tables whose numbers are counted, and the text.
const COUNTED: [&str; 6] = ["2", "4", "5", "6", "7", "text"];

/// One choice each; the start of each scene is its own unless one is given for all.
#[derive(Clone, Copy)]
struct Combination {
    start: Option<Start>,
    program: Program,
}

impl Combination {
    fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for start in [
            None,
            Some(Start::FirstLoadUsed),
            Some(Start::FirstLoadSkipped),
            Some(Start::Consistent),
        ] {
            for loads in [Loads::Rounded, Loads::AsRecorded] {
                for length in [Length::RunsOn, Length::OfLoads] {
                    for impacts in [Impacts::AnyOverlap, Impacts::OnApproach] {
                        for velocities in [Shared::HandedOn, Shared::Before] {
                            for forces in [Joined::Replaced, Joined::Added] {
                                let program = Program {
                                    loads,
                                    length,
                                    impacts,
                                    velocities,
                                    forces,
                                    ..Program::DESCRIBED
                                };
                                all.push(Self { start, program });
                            }
                        }
                    }
                }
            }
        }
        all
    }

    fn of(self, printed: Program) -> Program {
        Program {
            start: self.start.unwrap_or(printed.start),
            ..self.program
        }
    }

    /// The choices in words, in the order of the columns.
    fn words(self) -> [&'static str; 6] {
        let Program {
            loads,
            length,
            impacts,
            velocities,
            forces,
            ..
        } = self.program;
        [
            match self.start {
                None => "of each scene",
                Some(Start::FirstLoadUsed) => "first load used",
                Some(Start::FirstLoadSkipped) => "first load skipped",
                Some(Start::Consistent) => "consistent",
            },
            match loads {
                Loads::Rounded => "rounded",
                Loads::AsRecorded => "as recorded",
            },
            match length {
                Length::RunsOn => "runs on",
                Length::OfLoads => "of loads",
            },
            match impacts {
                Impacts::AnyOverlap => "any overlap",
                Impacts::OnApproach => "on approach",
            },
            match velocities {
                Shared::HandedOn => "handed on",
                Shared::Before => "before both",
            },
            match forces {
                Joined::Replaced => "replaced",
                Joined::Added => "added",
            },
        ]
    }

    /// The printed numbers beside those of this combination.
    fn compared(
        self,
        completed: &[Completed],
        published: &PublishedValues,
    ) -> Result<Vec<Comparison>, StudyError> {
        let mut values = BTreeMap::new();
        for study in completed {
            let id = study.file.id.trim_start_matches("table-");
            if !COUNTED.contains(&id) {
                continue;
            }
            let again = study.by_program(|printed| self.of(printed))?;
            let table = Table::of(&again)?.unwrap_or_default();
            values.insert(id.to_string(), table.values);
        }
        Ok(published.compare(&values))
    }
}

/// How many printed digits come out by every combination, as CSV text; `largest_difference` is that of totals of Tables 6 and 7.
///
/// # Errors
/// [`StudyError`] when scenes do not give what their table shows.
pub(super) fn combinations(
    completed: &[Completed],
    published: &PublishedValues,
) -> Result<String, StudyError> {
    let mut header = [
        "start",
        "loads",
        "length",
        "impacts",
        "velocities",
        "forces",
    ]
    .to_vec();
    let counts = COUNTED.map(|table| match table {
        "text" => "digits_of_text".into(),
        table => format!("digits_of_table_{table}"),
    });
    header.extend(counts.iter().map(String::as_str));
    header.extend(["digits_of_all", "largest_difference"]);
    let row = |combination: Combination| {
        let compared = combination.compared(completed, published)?;
        let count = |table: Option<&str>| {
            let printed = compared.iter().filter(|one| {
                one.digits != Digits::Other
                    && table.is_none_or(|table| one.published.table == table)
            });
            printed.count().to_string()
        };
        let totals = compared
            .iter()
            .filter(|one| ["6", "7"].contains(&&*one.published.table));
        let largest = totals
            .filter_map(Comparison::relative_difference)
            // Infinite where 0 is printed and something touches; those digits are not counted either.
            .filter(|difference| difference.is_finite())
            .fold(0.0, f64::max);
        let mut row = combination.words().map(String::from).to_vec();
        row.extend(COUNTED.map(|table| count(Some(table))));
        row.extend([count(None), format!("{largest:.1e}")]);
        Ok(row)
    };
    let rows: Vec<Result<Vec<String>, StudyError>> =
        Combination::all().into_par_iter().map(row).collect();
    let rows = rows.into_iter().collect::<Result<Vec<_>, _>>()?;
    let header: Vec<_> = header.iter().map(ToString::to_string).collect();
    Ok(to_csv(&header, &rows))
}
