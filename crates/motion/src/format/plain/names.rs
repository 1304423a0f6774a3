//! Names of columns above numbers: `time,acc_NS(gal),acc_EW(gal)` or `components: E N Z`.

use super::super::title;
use crate::Direction;
use crate::line::Line;

/// The name of a column, and what stands behind it in brackets.
pub(super) struct Name<'t> {
    pub(super) line: Line<'t>,
    pub(super) text: String,
    /// The unit, as it is written; may be empty.
    pub(super) unit: String,
}

impl Name<'_> {
    pub(super) fn is_time(&self) -> bool {
        let name = self.text.to_ascii_lowercase();
        name == "t" || name.starts_with("time")
    }

    pub(super) fn tells_direction(&self) -> bool {
        Direction::of_component(&self.text).is_some()
    }
}

/// The names of so many columns, in their order, by the titles above them.
///
/// A title of as many words counts only where one of them is a time, a direction or has a unit.
pub(super) fn of_columns<'t>(titles: &[Line<'t>], n_columns: usize) -> Option<Vec<Name<'t>>> {
    let last = titles.iter().rfind(|line| !line.is_blank());
    let above = last.map(|line| named_in(*line, &line.text()));
    let above = above.filter(|names| {
        names.len() == n_columns
            && names
                .iter()
                .all(|name| name.text.starts_with(char::is_alphabetic))
            && names.iter().any(|name| {
                name.is_time() || name.tells_direction() || title::unit_in(&name.unit).is_some()
            })
    });
    above.or_else(|| {
        let line = title::line_with(titles, "COMPONENTS:")?;
        let text = line.text();
        let names = named_in(line, title::after(&text, "COMPONENTS:")?);
        (names.len() == n_columns).then_some(names)
    })
}

fn named_in<'t>(line: Line<'t>, text: &str) -> Vec<Name<'t>> {
    let text = text.trim_start_matches('#').trim();
    let fields: Vec<String> = if text.contains(',') {
        text.split(',').map(str::to_owned).collect()
    } else {
        // A unit belongs to the word before it.
        let glued = text.replace(" (", "(").replace(" [", "[");
        glued.split_whitespace().map(str::to_owned).collect()
    };
    let name = |field: String| {
        let (name, unit) = field.split_once(['(', '[']).unwrap_or((&field, ""));
        let unit = unit.split([')', ']']).next().unwrap_or_default();
        Name {
            line,
            text: name.trim().trim_matches('"').to_owned(),
            unit: unit.trim().to_owned(),
        }
    };
    fields.into_iter().map(name).collect()
}
