//! Every combination of the choices of the paper's program, and how many of the printed numbers each gives.

use crate::program::{Choice, Program, Start};
use crate::{Comparison, Completed, PrintedDigits, PublishedValues, StudyError, Table};
use pounding_scene::parallel;
use pounding_text::to_csv;
use std::collections::BTreeMap;

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
        let mut programs = vec![Program::printed(Start::Consistent)];
        for choice in Choice::ALL {
            if choice != Choice::Start {
                let both = |program| [program, choice.taken_back(program)];
                programs = programs.into_iter().flat_map(both).collect();
            }
        }
        let starts = [
            None,
            Some(Start::FirstLoadUsed),
            Some(Start::FirstLoadSkipped),
            Some(Start::Consistent),
        ];
        let with = |start| programs.iter().map(move |&program| Self { start, program });
        starts.into_iter().flat_map(with).collect()
    }

    fn of(self, printed: Program) -> Program {
        Program {
            start: self.start.unwrap_or(printed.start),
            ..self.program
        }
    }

    /// A choice in words.
    fn words(self, choice: Choice) -> &'static str {
        match (choice, self.start) {
            (Choice::Start, None) => "of each scene",
            (Choice::Start, Some(start)) => choice.words(Program { start, ..self.program }),
            (_, _) => choice.words(self.program),
        }
    }

    /// The printed numbers beside those of this combination.
    fn compared(self, completed: &[Completed], published: &PublishedValues) -> Result<Vec<Comparison>, StudyError> {
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

/// How many printed digits come out by every combination, as CSV text; with the largest difference of totals of Tables 6 and 7.
///
/// # Errors
/// [`StudyError`] when scenes do not give what their table shows.
pub(super) fn combinations(completed: &[Completed], published: &PublishedValues) -> Result<String, StudyError> {
    let mut header = Choice::ALL.map(Choice::name).to_vec();
    let counts = COUNTED.map(|table| match table {
        "text" => "digits_of_text".into(),
        table => format!("digits_of_table_{table}"),
    });
    header.extend(counts.iter().map(String::as_str));
    header.extend(["digits_of_all", "largest_difference_of_tables_6_and_7"]);
    let row = |combination: &Combination| {
        let compared = combination.compared(completed, published)?;
        let count = |table: Option<&str>| {
            let printed = compared
                .iter()
                .filter(|one| one.digits != PrintedDigits::Other && table.is_none_or(|table| one.published.table == table));
            printed.count().to_string()
        };
        let totals = compared.iter().filter(|one| ["6", "7"].contains(&&*one.published.table));
        let largest = totals
            .filter_map(Comparison::relative_difference)
            // Infinite where 0 is printed and something touches; those digits are not counted either.
            .filter(|difference| difference.is_finite())
            .fold(0.0, f64::max);
        let mut row = Choice::ALL.map(|choice| combination.words(choice).to_string()).to_vec();
        row.extend(COUNTED.map(|table| count(Some(table))));
        row.extend([count(None), format!("{largest:.1e}")]);
        Ok::<_, StudyError>(row)
    };
    let rows = parallel::try_each(&Combination::all(), row)?;
    let header: Vec<_> = header.iter().map(ToString::to_string).collect();
    Ok(to_csv(&header, &rows))
}
