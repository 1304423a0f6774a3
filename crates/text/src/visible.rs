//! Text for terminals.

use std::borrow::Cow;
use std::fmt::Write as _;

/// The text with every letter that steers a terminal, or the direction of writing, spelt as `\u001b`: in JSON it means the same.
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

fn steers(letter: char) -> bool {
    let turns = matches!(letter, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || letter.is_control() && letter != '\n' && letter != '\t'
}

#[cfg(test)]
mod tests {
    use super::visible;

    #[test]
    fn extreme_letters_that_steer_a_terminal() {
        assert_eq!(visible("a\tb\nß – 80 %"), "a\tb\nß – 80 %");
        let text = "\u{1b}]0;x\u{7}\r\u{9b}2J\u{202e}";
        let shown = visible(text);
        assert_eq!(shown, "\\u001b]0;x\\u0007\\u000d\\u009b2J\\u202e");
        let read: String = serde_json::from_str(&format!("\"{shown}\"")).unwrap();
        assert_eq!(read, text);
    }
}
