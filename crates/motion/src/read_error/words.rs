//! Parts of messages that depend on what was found.

use crate::Place;

/// Most components that a message lists.
const MOST_LISTED: usize = 50;

/// What may be chosen instead of a component that is not there.
pub(super) fn choice(names: &[String]) -> String {
    if names.is_empty() {
        return "one, which has no name; leave the declaration away".to_owned();
    }
    format!("{}; choose one of them by its name, a part of it, or its number", listed(names))
}

/// Components with their numbers.
pub(super) fn listed(names: &[String]) -> String {
    let names = names.iter().cloned().enumerate();
    let all: Vec<_> = names.map(|(index, name)| (index + 1, name)).collect();
    numbered(&all)
}

/// Components with their numbers.
pub(super) fn numbered(components: &[(usize, String)]) -> String {
    let first = components.iter().take(MOST_LISTED);
    let mut listed: Vec<String> = first.map(|(number, name)| format!("{number} = {name:?}")).collect();
    if components.len() > MOST_LISTED {
        listed.push("…".to_owned());
    }
    listed.join(", ")
}

/// How to write a number, by what stands in its place.
pub(super) fn of_number(found: &str) -> &'static str {
    if found.contains("**") {
        "a program writes asterisks for a number that did not fit: fetch the file again, or print it with wider columns"
    } else if found.contains(',') {
        "write a decimal point for the comma, as in -0.00640"
    } else {
        "write it like -0.00640 or -.6403182E-02"
    }
}

/// The lines from one to another, or one alone, which read something.
pub(super) fn reading([first, last]: [usize; 2]) -> String {
    if first == last {
        format!("line {first} reads")
    } else {
        format!("lines {first} to {last} read")
    }
}

/// What several places say.
pub(super) fn several(said: &[(Place, String)]) -> String {
    let said = said.iter().take(MOST_LISTED);
    let said = said.map(|(place, text)| format!("{text} ({place})"));
    said.collect::<Vec<_>>().join(", ")
}

/// What may be done about several numbers to a line.
pub(super) fn rows(found: usize) -> String {
    let names = ["NS", "EW", "UD"].get(..found).unwrap_or(&["NS", "EW", "UD", "…"]);
    format!(
        "if they follow one another, declare `in_rows`; if they are columns, write their names above, such as `{}` or `time {}`",
        names.join(" "),
        names[..names.len().max(2) - 1].join(" ")
    )
}

/// The line before which values end.
pub(super) fn before(next: Option<&(usize, String)>) -> String {
    next.map_or_else(String::new, |(line, found)| format!(" (line {line} reads {found:?})"))
}

/// Which numbers of columns a plain text may have, and how to get there.
pub(super) fn columns(allowed: Option<usize>) -> String {
    match allowed {
        Some(allowed) => {
            format!("{allowed} as in the first line of numbers; write time and acceleration alone, or one acceleration to a line")
        }
        None => "1 or 2, or more with a time or with names; write a line such as `time NS EW UD` above them, or one \
                 acceleration to a line"
            .to_owned(),
    }
}
