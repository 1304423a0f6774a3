//! Every combination of the choices of the paper's program, with the number of printed numbers that each gives.

use crate::program::{Choice, Program, Start};
use crate::{Comparison, Completed, PrintedDigits, PublishedValues, StudyError, StudyTable};
use pounding_scene::parallel;
use pounding_text::Table;
use std::collections::BTreeMap;

/// Tables whose numbers are counted, and the running text.
const COUNTED: [&str; 6] = ["2", "4", "5", "6", "7", "text"];

/// A value for every choice. A start of `None` leaves each scene its own start.
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
                let both = |program: Program| [program, program.with_described(choice)];
                programs = programs.into_iter().flat_map(both).collect();
            }
        }
        let starts = std::iter::once(None).chain(Start::ALL.map(Some));
        let with = |start| programs.iter().map(move |&program| Self { start, program });
        starts.flat_map(with).collect()
    }

    fn of(self, printed: Program) -> Program {
        Program {
            start: self.start.unwrap_or(printed.start),
            ..self.program
        }
    }

    /// The value of a choice in words.
    fn words(self, choice: Choice) -> &'static str {
        match (choice, self.start) {
            (Choice::Start, None) => "of each scene",
            (Choice::Start, Some(start)) => start.words(),
            (_, _) => self.program.words(choice),
        }
    }

    /// Compares the printed numbers with those of this combination.
    fn compared(self, completed: &[Completed], published: &PublishedValues) -> Result<Vec<Comparison>, StudyError> {
        let mut values = BTreeMap::new();
        for study in completed {
            let id = study.file.id.trim_start_matches("table-");
            if !COUNTED.contains(&id) {
                continue;
            }
            let again = study.by_program(|printed| self.of(printed))?;
            let table = StudyTable::of(&again)?.unwrap_or_default();
            values.insert(id.to_string(), table.values);
        }
        Ok(published.compare(&values))
    }
}

/// Counts the printed digits that every combination gives, as CSV text with the largest difference of totals of Tables 6 and 7.
///
/// # Errors
/// [`StudyError`] if a study's scenes do not give the contents of its table.
pub(super) fn combinations(completed: &[Completed], published: &PublishedValues) -> Result<String, StudyError> {
    let all = Combination::all();
    let compared = parallel::try_each(&all, |combination| combination.compared(completed, published))?;
    let count = |compared: &[Comparison], table: Option<&str>| {
        let counted = |one: &&Comparison| table.is_none_or(|table| one.published.table == table);
        let printed = compared.iter().filter(|one| one.digits != PrintedDigits::Other);
        printed.filter(counted).count()
    };
    let largest = |compared: &[Comparison]| {
        let totals = compared.iter().filter(|one| ["6", "7"].contains(&&*one.published.table));
        let differences = totals.filter_map(Comparison::relative_difference);
        // The difference is infinite if 0 is printed and the structures touch; such digits are not counted either.
        differences.filter(|difference| difference.is_finite()).fold(0.0, f64::max)
    };
    let name = |table| match table {
        "text" => "digits_of_text".into(),
        table => format!("digits_of_table_{table}"),
    };
    Ok(Table::of(all.iter().zip(&compared))
        .columns(Choice::ALL, |choice| choice.texts()[0].into(), |(one, _), choice| one.words(choice))
        .columns(COUNTED, name, |(_, compared), table| count(compared, Some(table)))
        .column("digits_of_all", |(_, compared)| count(compared, None))
        .column("largest_difference_of_tables_6_and_7", |(_, compared)| {
            format!("{:.1e}", largest(compared))
        })
        .csv())
}
