//! Rows of the table of `compare`, with differences.

use pounding::text::{NONE, Shown, short};

/// A line of the table: a name, and a cell for every scene.
pub(super) struct ComparedRow {
    pub(super) name: String,
    pub(super) cells: Vec<ComparedValue>,
}

/// The value of a scene in a row.
pub(super) enum ComparedValue {
    Text(String),
    /// A number in the unit of the table; `None` if the scene has none.
    Number(Option<f64>),
}

impl From<String> for ComparedValue {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<Option<f64>> for ComparedValue {
    fn from(number: Option<f64>) -> Self {
        Self::Number(number)
    }
}

impl ComparedValue {
    fn text(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Number(number) => number.map_or(NONE.into(), short),
        }
    }

    /// How much larger the number is than that of another cell, whatever their signs: a peak may lie on the other side.
    fn change(&self, first: &Self) -> Option<f64> {
        let (Self::Number(Some(own)), Self::Number(Some(first))) = (self, first) else {
            return None;
        };
        let change = own.abs() / first.abs() - 1.0;
        change.is_finite().then_some(change)
    }
}

impl ComparedRow {
    /// Whether the row is a heading of those below it.
    fn is_heading(&self) -> bool {
        !self.name.starts_with(' ')
    }

    fn is_alike(&self) -> bool {
        let texts: Vec<String> = self.cells.iter().map(ComparedValue::text).collect();
        texts.windows(2).all(|two| two[0] == two[1])
    }

    /// The name and the cells; numbers after the first stand with their change.
    pub(super) fn cells(&self) -> Vec<Shown> {
        let first = &self.cells[0];
        let cell = |(index, cell): (usize, &ComparedValue)| {
            let text = cell.text();
            match cell.change(first).filter(|_| index > 0) {
                Some(change) if text != first.text() => {
                    let sign = if change < 0.0 { '−' } else { '+' };
                    let (change, digits) = (100.0 * change.abs(), usize::from(change.abs() < 0.1));
                    format!("{text} {sign}{change:.digits$}%")
                }
                Some(_) | None => text,
            }
        };
        let cells = self.cells.iter().enumerate().map(cell);
        std::iter::once(self.name.clone()).chain(cells).map(Shown::from).collect()
    }
}

/// The rows in which scenes differ, each with its heading, and how many others there are.
pub(super) fn changed(rows: Vec<ComparedRow>) -> (Vec<ComparedRow>, usize) {
    let (mut kept, mut alike): (Vec<ComparedRow>, usize) = (Vec::new(), 0);
    let mut heading: Option<ComparedRow> = None;
    for row in rows {
        if row.is_heading() {
            heading = Some(row);
        } else if row.is_alike() {
            alike += 1;
        } else {
            kept.extend(heading.take());
            kept.push(row);
        }
    }
    (kept, alike)
}
