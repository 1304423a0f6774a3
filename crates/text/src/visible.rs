//! Text without letters that steer a terminal or the direction of reading.

use std::borrow::Cow;
use std::fmt::Write as _;

/// The text with every letter that steers a terminal, or the direction of writing, spelt as in `\u001b`, which means that letter in JSON.
/// Line ends and tabulators stay.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(steers) {
        return text.into();
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for letter in text.chars() {
        if steers(letter) {
            write!(shown, "\\u{:04x}", u32::from(letter)).expect("memory takes all");
        } else {
            shown.push(letter);
        }
    }
    shown.into()
}

/// Whether [`visible`] spells a letter: control characters, marks of direction, and line ends that most programs do not know.
pub fn steers(letter: char) -> bool {
    let turns = matches!(
        letter,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
    );
    turns || letter.is_control() && letter != '\n' && letter != '\t'
}

/// Longest line of a message that is shown in full \[letters\]: room for some paths, each as long as systems allow.
const LONGEST: usize = 10_000;
/// Numbers of letters shown from the beginning and from the end of a longer line.
const SHOWN: [usize; 2] = [1500, 500];

/// A message for people: [`visible`], with the middle of overlong lines left out. A file can name a path of a megabyte.
pub fn message(text: &str) -> Cow<'_, str> {
    if text.len() <= LONGEST {
        return visible(text);
    }
    let lines: Vec<Cow<'_, str>> = text.split('\n').map(excerpt).collect();
    visible(&lines.join("\n")).into_owned().into()
}

fn excerpt(line: &str) -> Cow<'_, str> {
    let letters = if line.len() <= LONGEST { 0 } else { line.chars().count() };
    if letters <= LONGEST {
        return line.into();
    }
    let [first, last] = SHOWN;
    let begin: String = line.chars().take(first).collect();
    let end: String = line.chars().skip(letters - last).collect();
    format!("{begin} … ({} letters are left out) … {end}", letters - first - last).into()
}

#[cfg(test)]
mod tests {
    use super::{message, visible};

    #[test]
    fn extreme_letters_that_steer_a_terminal() {
        assert_eq!(visible("a\tb\nß – 80 %"), "a\tb\nß – 80 %");
        let text = "\u{1b}]0;x\u{7}\r\u{9b}2J\u{202e}";
        let shown = visible(text);
        assert_eq!(shown, "\\u001b]0;x\\u0007\\u000d\\u009b2J\\u202e");
        let read: String = serde_json::from_str(&format!("\"{shown}\"")).unwrap();
        assert_eq!(read, text);
    }

    /// Marks of direction that open nothing, and line ends of Unicode, were printed unchanged.
    #[test]
    fn issue_marks_of_direction_are_spelt() {
        let marks = "\u{61c}\u{200e}\u{200f}\u{2028}\u{2029}\u{2067}\u{0}";
        assert_eq!(visible(marks), "\\u061c\\u200e\\u200f\\u2028\\u2029\\u2067\\u0000");
    }

    /// A path of a megabyte made a message of a megabyte.
    #[test]
    fn issue_a_message_has_an_end() {
        let path = "ä/\u{1b}".repeat(400_000);
        let said = message(&format!("one\n{path}: found nothing\nthree")).into_owned();
        let lines: Vec<&str> = said.split('\n').collect();
        assert_eq!([lines[0], lines[2], lines.get(3).unwrap_or(&"end")], ["one", "three", "end"]);
        assert!(lines[1].chars().count() < 6000, "{}", lines[1].len());
        let wanted = "(1198015 letters are left out)";
        assert!(lines[1].starts_with("ä/\\u001bä/") && lines[1].contains(wanted), "{said}");
        assert!(lines[1].ends_with(": found nothing"), "{said}");
        let path = "p".repeat(4096);
        let whole = format!("{path}: is the file that is read ({path})");
        assert_eq!(message(&whole), whole);
    }
}
