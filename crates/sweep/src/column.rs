//! A column of a table in memory.

/// A column of a sweep, with a value for each row.
#[derive(Debug, Clone, PartialEq)]
pub enum SweepColumn {
    /// Numbers of runs.
    Counts(Vec<u64>),
    /// Whether something holds.
    Flags(Vec<bool>),
    /// Numbers; NaN where a row has none.
    Numbers(Vec<f64>),
    /// Texts; nothing where a row has none.
    Texts(Vec<Option<String>>),
}
