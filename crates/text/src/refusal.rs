//! A refusal for a program: the parts of a message.

use serde::Serialize;

/// The parts of a message of the form "place: found this, allowed is that; help". One that a message does not have is `null`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Refusal<'a> {
    /// The whole message.
    pub message: &'a str,
    /// File, line and field.
    pub place: Option<&'a str>,
    /// What stands there.
    pub found: Option<&'a str>,
    /// What may stand there.
    pub allowed: Option<&'a str>,
    /// What to do.
    pub help: Option<&'a str>,
}

/// All messages of the program say what is wrong in these words.
impl<'a> From<&'a str> for Refusal<'a> {
    fn from(message: &'a str) -> Self {
        let (place, rest) = match message.split_once(": found ") {
            Some((place, rest)) => (Some(place), rest),
            None => (None, message.strip_prefix("found ").unwrap_or_default()),
        };
        let found_and = [", allowed is ", ", allowed are ", ", allowed "];
        let split = found_and.iter().find_map(|words| rest.split_once(words));
        let (found, allowed) = match split {
            Some((found, allowed)) => (Some(found), Some(allowed)),
            None => (Some(rest).filter(|rest| !rest.is_empty()), None),
        };
        // The help stands behind whichever comes last.
        let last = allowed.or(found);
        let parts = last.and_then(|last| last.split_once("; ").or_else(|| last.split_once(": ")));
        let (last, help) = match parts {
            Some((last, help)) => (Some(last), Some(help)),
            None => (last, None),
        };
        Self {
            message,
            place,
            found: if allowed.is_some() { found } else { last },
            allowed: allowed.and(last),
            help,
        }
    }
}

/// The message as a line of JSON, `{"error": {…}}`.
///
/// # Panics
/// Never: texts are JSON.
pub fn refusal_json(message: &str) -> String {
    #[derive(Serialize)]
    struct Line<'a> {
        error: Refusal<'a>,
    }
    let error = message.into();
    serde_json::to_string(&Line { error }).expect("texts are JSON")
}

#[cfg(test)]
mod tests {
    use super::Refusal;

    #[test]
    fn reference_parts_of_a_message() {
        let parts = |message: &'static str| {
            let Refusal {
                place,
                found,
                allowed,
                help,
                message: _,
            } = message.into();
            [place, found, allowed, help].map(Option::unwrap_or_default)
        };
        assert_eq!(
            parts("a.toml, line 3: contacts[0].gap_m: found -0.01, allowed is a number >= 0; widen it"),
            ["a.toml, line 3: contacts[0].gap_m", "-0.01", "a number >= 0", "widen it"]
        );
        assert_eq!(
            parts("found 2 of 3 parts: the runs 4 to 5 are missing"),
            ["", "2 of 3 parts", "", "the runs 4 to 5 are missing"]
        );
        assert_eq!(parts("a: found `x`, allowed are `y`, `z`"), ["a", "`x`", "`y`, `z`", ""]);
        assert_eq!(parts("stopped"), [""; 4]);
    }
}
