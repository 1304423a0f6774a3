//! A column of a table in memory.

/// A column of a sweep, with a value for each row.
#[derive(Debug, Clone, PartialEq)]
pub enum SweepColumn {
    /// Numbers of runs.
    Counts(Vec<u64>),
    /// Yes or no for each row.
    Flags(Vec<bool>),
    /// Numbers; NaN if a row has none.
    Numbers(Vec<f64>),
    /// Texts; `None` if a row has none.
    Texts(Vec<Option<String>>),
}
