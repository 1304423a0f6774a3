//! The branch of the columns.

/// Sign of a number as a factor, 1 or −1.
///
/// Zero counts as negative: if the number then rises, this is an ordinary event, at once.
pub(super) fn sign(value: f64) -> f64 {
    if value > 0.0 { 1.0 } else { -1.0 }
}

/// Branch of the columns.
#[derive(Debug, Clone, Copy)]
pub(super) enum Branch {
    /// The force is k (d − plastic displacement).
    Elastic { plastic_displacement: f64 },
    /// The yielding part has this force \[N\].
    Yielding { force: f64 },
    /// Columns that yield smoothly, while the elastic part of their drift has the sign `side`.
    Smooth { side: f64 },
}
