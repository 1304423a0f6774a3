//! The parts of an answer as markup.

use pounding_text::{Answer, Grid, Heading, Manner, Part, Sentences, Shown, Where};

use super::markup::{escaped, facts, list, prose, signed};
use super::{beside, boxed};

/// The parts of an answer for a page; `figure` draws the figure of a name, or returns `None` if the answer has no such figure.
pub(crate) fn html(answer: &Answer<'_>, mut figure: impl FnMut(&str) -> String) -> String {
    let shown = |place: Where| matches!(place, Where::Everywhere | Where::Details | Where::Page);
    let parts = answer.parts().iter().filter(|(place, _)| shown(*place)).map(|(_, part)| part);
    let mut parts = parts.peekable();
    let mut page = String::new();
    while let Some(part) = parts.next() {
        let markup = match part {
            Part::Heading(text) => format!("<h2>{}</h2>\n", escaped(text)),
            Part::Appendix(text) => format!("<h2 class=\"appendix\">Appendix: {}</h2>\n", escaped(text)),
            Part::Words(words) => sentences(words),
            Part::Table(grid) => table(grid),
            Part::Markup(markup) => markup.clone(),
            Part::Figure(name) => match parts.peek() {
                Some(Part::Words(words)) if words.manner == Manner::Beside => {
                    parts.next();
                    beside(&[figure(name), list(&words.lines)])
                }
                _ => figure(name),
            },
        };
        page += &markup;
    }
    page
}

/// The parts of an answer that a terminal shows first, each with its label in front.
pub(crate) fn first_screen(answer: &Answer<'_>) -> String {
    let shown = |place: Where| matches!(place, Where::Everywhere | Where::Terminal | Where::FirstScreen);
    let parts = answer.parts().iter().filter(|(place, _)| shown(*place));
    let markup = parts.map(|(_, part)| match part {
        Part::Words(words) => format!("<section>\n<h3>{}</h3>\n{}</section>\n", escaped(words.label), sentences(words)),
        Part::Table(grid) => table(grid),
        Part::Markup(_) | Part::Heading(_) | Part::Appendix(_) | Part::Figure(_) => String::new(),
    });
    markup.collect()
}

fn sentences(words: &Sentences) -> String {
    let paragraph = |class: &str, line: &String| format!("<p{class}>{}</p>\n", prose(line));
    let lines = words.lines.iter();
    match words.manner {
        Manner::Plain => lines.map(|line| paragraph("", line)).collect(),
        Manner::Soft => lines.map(|line| paragraph(" class=\"soft\"", line)).collect(),
        Manner::List | Manner::Beside => list(&words.lines),
        Manner::Box(title) => boxed(title, &words.lines),
        Manner::Verdict { before, touch } => {
            let (before, answer) = words.lines.split_at(before.min(words.lines.len()));
            let before: String = before.iter().map(|line| paragraph("", line)).collect();
            let (first, more) = answer.split_first().map_or(("", answer), |(first, more)| (first, more));
            let touch = if touch { " touch" } else { "" };
            let more = if more.is_empty() { String::new() } else { list(more) };
            format!(
                "<div class=\"verdict{touch}\">\n{before}<p><strong>{}</strong></p>\n{more}</div>\n",
                prose(first)
            )
        }
        Manner::Facts => {
            let fact = |line: &String| {
                let (what, value) = line.split_once(": ").unwrap_or((line, ""));
                (what.to_owned(), value.to_owned())
            };
            facts(&lines.map(fact).collect::<Vec<_>>())
        }
    }
}

/// A table under its headings.
pub(crate) fn table(grid: &Grid) -> String {
    let heading = |(column, heading): (usize, &Heading)| {
        let is_long = grid.rows.iter().any(|row| row.get(column).is_some_and(|shown| shown.is_long));
        let class = if is_long { " class=\"text\"" } else { "" };
        format!("<th{class}>{}</th>", prose(&heading.title()))
    };
    let headings: String = grid.headings.iter().enumerate().map(heading).collect();
    let row = |cells: &Vec<Shown>| {
        let cells: String = cells.iter().map(cell).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let rows: String = grid.rows.iter().map(row).collect();
    format!("<div class=\"wide\"><table>\n<thead><tr>{headings}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n")
}

fn cell(shown: &Shown) -> String {
    let below = shown.below.as_ref();
    let below = below.map_or_else(String::new, |text| format!("<small>{}</small>", prose(text)));
    let class = if shown.is_long { " class=\"text\"" } else { "" };
    let is_number = shown
        .text
        .strip_prefix('-')
        .is_some_and(|rest| rest.starts_with(|letter: char| letter.is_ascii_digit()));
    let text = if is_number { signed(&shown.text) } else { shown.text.clone() };
    format!("<td{class}>{}{below}</td>", prose(&text))
}
