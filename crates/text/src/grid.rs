//! A table for people: texts under headings, with smaller texts below them.

use crate::visible;

/// The cell of a number that does not exist.
pub const NONE: &str = "–";

/// A cell for people: a text, and perhaps another below it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Shown {
    /// The text.
    pub text: String,
    /// The text below it, such as the error of a number.
    pub below: Option<String>,
    /// Whether it is a text that may be broken into lines, and no number.
    pub is_long: bool,
}

impl Shown {
    /// Returns the cell with another text below, if there is one.
    #[must_use]
    pub fn over(self, below: Option<String>) -> Self {
        Self { below, ..self }
    }

    /// Returns the cell as a text that may be broken into lines.
    #[must_use]
    pub fn long(self) -> Self {
        Self { is_long: true, ..self }
    }
}

impl From<String> for Shown {
    fn from(text: String) -> Self {
        Self { text, ..Self::default() }
    }
}

impl From<&str> for Shown {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<usize> for Shown {
    fn from(count: usize) -> Self {
        count.to_string().into()
    }
}

impl From<&String> for Shown {
    fn from(text: &String) -> Self {
        text.as_str().into()
    }
}

impl<T: Into<Shown>> From<Option<T>> for Shown {
    /// A dash if there is nothing.
    fn from(value: Option<T>) -> Self {
        value.map_or_else(|| NONE.into(), Into::into)
    }
}

/// The name of a column and its unit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Heading {
    /// The name.
    pub text: String,
    /// The unit; empty if there is none.
    pub unit: &'static str,
}

impl From<String> for Heading {
    fn from(text: String) -> Self {
        (text, "").into()
    }
}

impl From<&str> for Heading {
    fn from(text: &str) -> Self {
        (text, "").into()
    }
}

impl<T: Into<String>> From<(T, &'static str)> for Heading {
    fn from((text, unit): (T, &'static str)) -> Self {
        Self { text: text.into(), unit }
    }
}

impl Heading {
    /// The name with its unit in brackets.
    pub fn title(&self) -> String {
        format!("{} {}", self.text, self.bracketed()).trim_end().into()
    }

    /// The unit in brackets; empty if there is none.
    pub(crate) fn bracketed(&self) -> String {
        match self.unit {
            "" => String::new(),
            unit => format!("[{unit}]"),
        }
    }
}

/// A table for people. The first column holds names, the others numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Grid {
    /// The columns.
    pub headings: Vec<Heading>,
    /// Rows as long as the headings.
    pub rows: Vec<Vec<Shown>>,
    /// Most rows of the first screen; the others are counted there.
    pub most: usize,
    /// Whether columns that are too many for a line follow below, with the names again.
    pub is_in_blocks: bool,
}

impl Grid {
    /// A table of headings, and rows as long as they are.
    pub fn of(headings: impl IntoIterator<Item: Into<Heading>>, rows: Vec<Vec<Shown>>) -> Self {
        let spelt = |shown: Shown| Shown {
            text: visible(&shown.text).into_owned(),
            below: shown.below.map(|below| visible(&below).into_owned()),
            ..shown
        };
        Self {
            headings: headings.into_iter().map(Into::into).collect(),
            rows: rows.into_iter().map(|row| row.into_iter().map(spelt).collect()).collect(),
            most: usize::MAX,
            is_in_blocks: false,
        }
    }

    /// Returns the table with at most this many rows on the first screen.
    #[must_use]
    pub fn most(self, most: usize) -> Self {
        Self { most, ..self }
    }

    /// Returns the table in blocks, each with the names in front.
    #[must_use]
    pub fn in_blocks(self) -> Self {
        Self {
            is_in_blocks: true,
            ..self
        }
    }

    /// Whether it has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}
