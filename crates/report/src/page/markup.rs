//! Pieces of HTML that are well-formed XML too.

/// What stands where there is no number.
pub(crate) const NONE: &str = "–";

/// A number with four significant digits and the real minus sign.
pub(crate) fn short(value: f64) -> String {
    signed(&pounding_text::short(value))
}

/// A number with seven significant digits and the real minus sign.
pub(crate) fn digits(value: f64) -> String {
    signed(&pounding_text::digits(value))
}

/// A number with the real minus sign.
pub(crate) fn signed(number: &str) -> String {
    match number.strip_prefix('-') {
        Some(magnitude) => format!("\u{2212}{magnitude}"),
        None => number.into(),
    }
}

/// Text that cannot be taken for markup, and steers nothing; what XML cannot hold even then is left out.
pub(crate) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in pounding_text::visible(text).chars() {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            '\u{FFFE}' | '\u{FFFF}' => {}
            _ => safe.push(letter),
        }
    }
    safe
}

/// A cell of a table: text, and perhaps smaller text below it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cell {
    text: String,
    below: Option<String>,
    /// Whether it is a text of several lines, and no number.
    wrapped: bool,
}

impl Cell {
    /// A cell with text as it is.
    pub(crate) fn new(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            below: None,
            wrapped: false,
        }
    }

    /// A cell with a value, or without one.
    pub(crate) fn known(value: Option<String>) -> Self {
        Self::new(value.unwrap_or_else(|| NONE.into()))
    }

    /// The cell with smaller text below, if there is any.
    #[must_use]
    pub(crate) fn over(self, below: Option<String>) -> Self {
        Self { below, ..self }
    }

    /// The cell as text of several lines.
    #[must_use]
    pub(crate) fn wrapped(self) -> Self {
        Self { wrapped: true, ..self }
    }

    fn html(&self) -> String {
        let below = self.below.as_ref();
        let below = below.map_or_else(String::new, |text| format!("<small>{}</small>", escaped(text)));
        let class = if self.wrapped { " class=\"text\"" } else { "" };
        format!("<td{class}>{}{below}</td>", escaped(&self.text))
    }
}

/// A table of numbers under names.
pub(crate) fn table<Name: AsRef<str>>(header: &[Name], rows: &[Vec<Cell>]) -> String {
    let name = |name: &Name| format!("<th>{}</th>", escaped(name.as_ref()));
    let names: Vec<String> = header.iter().map(name).collect();
    let names = names.concat();
    let row = |cells: &Vec<Cell>| {
        let cells: String = cells.iter().map(Cell::html).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let rows: String = rows.iter().map(row).collect();
    format!("<div class=\"wide\"><table>\n<thead><tr>{names}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n")
}

/// A table of two columns: what it is, and what it is here.
pub(crate) fn facts(facts: &[(String, String)]) -> String {
    let row = |(what, value): &(String, String)| format!("<tr><td>{}</td><td>{}</td></tr>\n", escaped(what), escaped(value));
    let rows: String = facts.iter().map(row).collect();
    format!("<table class=\"facts\">\n<tbody>\n{rows}</tbody>\n</table>\n")
}

/// A list of sentences.
pub(crate) fn list(items: &[String]) -> String {
    let item = |text: &String| format!("<li>{}</li>\n", escaped(text));
    let items: String = items.iter().map(item).collect();
    format!("<ul>\n{items}</ul>\n")
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn reference_markup_becomes_text() {
        assert_eq!(
            escaped("<b>\"Süd\" & 'Nord'</b>\u{0}\u{202e}\u{FFFE}\n"),
            "&lt;b&gt;&quot;Süd&quot; &amp; &#39;Nord&#39;&lt;/b&gt;\\u0000\\u202e\n"
        );
    }
}
