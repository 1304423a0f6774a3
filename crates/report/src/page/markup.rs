//! Pieces of HTML that are well-formed XML too.

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

/// Text that cannot be taken for markup, without letters that steer a terminal; letters that XML cannot hold are left out.
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

/// Sentences as markup: what a terminal shows between backticks stands in the letters of code, and no line begins with a per cent sign.
pub(crate) fn prose(text: &str) -> String {
    let text = &text.replace(" %", "\u{a0}%");
    let parts: Vec<&str> = text.split('`').collect();
    if parts.len().is_multiple_of(2) {
        return escaped(text);
    }
    let part = |(index, part): (usize, &&str)| {
        if index.is_multiple_of(2) {
            escaped(part)
        } else {
            format!("<code>{}</code>", escaped(part))
        }
    };
    parts.iter().enumerate().map(part).collect()
}

/// A table of two columns: a name and its value.
pub(crate) fn facts(facts: &[(String, String)]) -> String {
    let row = |(what, value): &(String, String)| format!("<tr><td>{}</td><td>{}</td></tr>\n", prose(what), prose(value));
    let rows: String = facts.iter().map(row).collect();
    format!("<table class=\"facts\">\n<tbody>\n{rows}</tbody>\n</table>\n")
}

/// A list of sentences.
pub(crate) fn list(items: &[String]) -> String {
    let item = |text: &String| format!("<li>{}</li>\n", prose(text));
    let items: String = items.iter().map(item).collect();
    format!("<ul>\n{items}</ul>\n")
}

#[cfg(test)]
mod tests {
    use super::{escaped, prose};

    /// Backticks of the terminal stood in the report of a client.
    #[test]
    fn issue_no_backticks_in_a_page() {
        assert_eq!(prose("`levels = [1]` of <a>"), "<code>levels = [1]</code> of &lt;a&gt;");
        assert_eq!(prose("a ` alone"), "a ` alone");
    }

    #[test]
    fn reference_markup_becomes_text() {
        assert_eq!(
            escaped("<b>\"Süd\" & 'Nord'</b>\u{0}\u{202e}\u{FFFE}\n"),
            "&lt;b&gt;&quot;Süd&quot; &amp; &#39;Nord&#39;&lt;/b&gt;\\u0000\\u202e\n"
        );
    }
}
