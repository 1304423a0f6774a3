//! Tables: what a study prints as CSV, and the single numbers in it.

mod pounding_forces;
mod structures;
mod summaries;

use crate::{Completed, Output, StudyError};

/// One computed number with the keys that published numbers carry.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// Row of the table, for example `layout A elastic left`.
    pub row: String,
    /// Quantity, for example `transferred momentum`.
    pub quantity: String,
    /// Unit as printed, for example `kN·s`.
    pub unit: &'static str,
    /// The number in that unit.
    pub value: f64,
}

/// A table as text, and the numbers in it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// Column names.
    pub header: Vec<String>,
    /// Cells.
    pub rows: Vec<Vec<String>>,
    /// The numbers, to be compared with published ones.
    pub values: Vec<Value>,
}

impl Table {
    fn new(header: &[&str]) -> Self {
        Self {
            header: header.iter().map(ToString::to_string).collect(),
            ..Self::default()
        }
    }

    /// The table as CSV text.
    pub fn to_csv(&self) -> String {
        to_csv(&self.header, &self.rows)
    }

    /// The table of a study; nothing for a study that draws a figure.
    ///
    /// # Errors
    /// [`StudyError::Study`] when the scenes do not give what the table shows.
    pub fn of(completed: &Completed) -> Result<Option<Self>, StudyError> {
        match &completed.file.study.output {
            Output::StructuresTable => Ok(Some(structures::table(completed))),
            Output::PoundingForcesTable {
                n_collisions,
                label_offset_s,
            } => pounding_forces::table(
                completed,
                n_collisions.unwrap_or(usize::MAX),
                *label_offset_s,
            )
            .map(Some),
            Output::FirstCollisionTable => Ok(Some(summaries::first_collision(completed))),
            Output::TransferredMomentumTable => {
                Ok(Some(summaries::transferred_momentum(completed)))
            }
            Output::TextTable {
                transferred_momentum,
                peak_forces,
            } => summaries::text(completed, transferred_momentum, peak_forces).map(Some),
            Output::Claims
            | Output::Trade(_)
            | Output::Laws(_)
            | Output::Extremes(_)
            | Output::Beyond(_)
            | Output::Survey(_)
            | Output::RecordFigure
            | Output::DisplacementFigure
            | Output::PoundingFigure
            | Output::FirstCollisionFigure
            | Output::LayoutFigure
            | Output::ShearForceFigure { .. } => Ok(None),
        }
    }
}

/// CSV text of a header and rows.
pub(crate) fn to_csv(header: &[String], rows: &[Vec<String>]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for record in std::iter::once(header).chain(rows.iter().map(Vec::as_slice)) {
        writer
            .write_record(record)
            .expect("rows are as long as the header, and memory takes them");
    }
    let bytes = writer.into_inner().expect("memory takes all");
    String::from_utf8(bytes).expect("cells are text")
}

/// A number with seven significant digits in plain notation, without trailing zeros.
pub fn digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        // A negative zero loses its sign.
        return format!("{}", value + 0.0);
    }
    let scientific = format!("{value:.6e}");
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse().ok());
    match exponent {
        Some(exponent @ -6..=15) => {
            let rounded: f64 = scientific.parse().unwrap_or(value);
            let decimals = usize::try_from(6_i32 - exponent).unwrap_or(0);
            let plain = format!("{rounded:.decimals$}");
            if plain.contains('.') {
                plain
                    .trim_end_matches('0')
                    .trim_end_matches('.')
                    .to_string()
            } else {
                plain
            }
        }
        _ => scientific,
    }
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn reference_seven_significant_digits() {
        for (value, wanted) in [
            (0.0, "0"),
            (-0.0, "0"),
            (3_607.138_612, "3607.139"),
            (-0.030_000_000_1, "-0.03"),
            (1.97, "1.97"),
            (0.999_999_99, "1"),
            (3_000_000.0, "3000000"),
            (123_456_789.0, "123456800"),
            (1.5e-9, "1.500000e-9"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(digits(value), wanted);
        }
    }
}
