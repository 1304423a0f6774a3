//! Refusals: place, value found, values allowed and remedy. The finder of a fault makes the parts; they become a sentence at the end.

use std::borrow::Cow;
use std::fmt;
use std::io;
use std::path::Path;

use serde::Serialize;

use crate::words::{Piece, Words};
use crate::{FaultPlace, Knob, Naming, RefusalKind, message};

/// The reason for a refusal in parts: `place: found this, allowed is that; help`.
///
/// [`Display`](fmt::Display) gives the sentence. Leading words of a part, such as `, allowed is `, belong only to the sentence.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Refused(Box<Parts>);

#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Parts {
    place: FaultPlace,
    /// Whether the sentence itself names the line or byte.
    names_spot: bool,
    /// The value found, the values allowed and the remedy.
    said: [RefusalPart; 3],
    /// Index of the part that was added last.
    last: usize,
    kind: RefusalKind,
    wants: Option<Knob>,
    naming: Naming,
}

#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct RefusalPart {
    lead: Cow<'static, str>,
    words: Words,
}

/// The parts in a form that passes through a text without values: the field, and lead and words of every part.
type Packed = (String, [(String, String); 3]);

/// The sentence of a refusal as words of another one.
impl From<&Refused> for Words {
    fn from(refused: &Refused) -> Self {
        let parts = &refused.0;
        let place = parts.written_place();
        let mut pieces = Vec::new();
        if !place.is_empty() {
            let colon = if parts.goes_on() { "" } else { ": " };
            pieces.push(Piece::Text(format!("{place}{colon}").into()));
        }
        for part in parts.said.iter().filter(|part| !part.words.0.is_empty()) {
            pieces.push(Piece::Text(part.lead.clone()));
            pieces.extend(part.words.0.iter().cloned());
        }
        Self(pieces)
    }
}

impl Parts {
    /// The place as in the sentence.
    fn written_place(&self) -> String {
        let mut place = self.place.clone();
        place.spot = place.spot.filter(|_| !self.names_spot);
        place.words(self.naming)
    }

    /// Whether the sentence continues after its place without a colon.
    fn goes_on(&self) -> bool {
        self.said[0].lead.starts_with(' ')
    }
}

impl Refused {
    /// A refusal with a place.
    pub fn at(place: impl Into<FaultPlace>) -> Self {
        let mut new = Self::default();
        new.0.place = place.into();
        new
    }

    /// A refusal with a sentence of the caller and no place.
    pub fn that(sentence: impl Into<Words>) -> Self {
        Self::default().is(sentence)
    }

    /// A refusal with a sentence of the caller that itself names the line or byte.
    pub fn that_at(place: impl Into<FaultPlace>, sentence: impl Into<Words>) -> Self {
        let mut new = Self::at(place).is(sentence);
        new.0.names_spot = true;
        new
    }

    /// The refusal that a deserialiser received as a displayed value; a plain sentence if it received one.
    ///
    /// In the alternate form a refusal displays its parts, which the sentence does not show.
    pub fn handed(said: &impl fmt::Display) -> Self {
        let text = format!("{said:#}");
        let Ok((field, said)) = serde_json::from_str::<Packed>(&text) else {
            return Self::that(text);
        };
        let mut new = Self::default();
        new.0.place.field = Some(field).filter(|field| !field.is_empty()).map(Knob::field);
        new.0.said = said.map(|(lead, words)| RefusalPart {
            lead: lead.into(),
            words: words.into(),
        });
        new
    }

    /// A refusal by the operating system when a file is used.
    pub fn by_system(file: &Path, error: &io::Error) -> Self {
        Self::at(file).is(error.to_string()).kind(RefusalKind::System(error.kind()))
    }

    /// A refusal by the operating system when a file is read.
    pub fn unreadable(file: &Path, error: &io::Error) -> Self {
        let kind = RefusalKind::System(error.kind());
        Self::at(file).is("cannot be read: ").and(error.to_string()).kind(kind)
    }

    /// Adds the value that was found.
    #[must_use]
    pub fn found(self, words: impl Into<Words>) -> Self {
        self.say(0, "found ", words.into())
    }

    /// Adds the fault in words that do not begin with "found".
    #[must_use]
    pub fn is(self, words: impl Into<Words>) -> Self {
        self.say(0, "", words.into())
    }

    /// Adds the fault in words that continue after the place: `line 3 gives a peak of …`.
    #[must_use]
    pub fn goes_on(self, words: impl Into<Words>) -> Self {
        self.say(0, " ", words.into())
    }

    /// Quotes a line or a byte of a file.
    #[must_use]
    pub fn reads(self, text: impl Into<String>) -> Self {
        self.say(0, " reads ", Words(vec![Piece::Quoted(text.into())]))
    }

    /// Adds the values allowed.
    #[must_use]
    pub fn allowed(self, words: impl Into<Words>) -> Self {
        self.but(", allowed ", words)
    }

    /// Adds the only value allowed.
    #[must_use]
    pub fn allowed_is(self, words: impl Into<Words>) -> Self {
        self.but(", allowed is ", words)
    }

    /// Adds a list of the values allowed.
    #[must_use]
    pub fn allowed_are(self, words: impl Into<Words>) -> Self {
        self.but(", allowed are ", words)
    }

    /// Adds the values allowed, after a lead of the caller.
    #[must_use]
    pub fn but(self, lead: &'static str, words: impl Into<Words>) -> Self {
        self.say(1, lead, words.into())
    }

    /// Adds the remedy.
    #[must_use]
    pub fn help(self, words: impl Into<Words>) -> Self {
        self.so("; ", words)
    }

    /// Adds the remedy, after a lead of the caller.
    #[must_use]
    pub fn so(self, lead: &'static str, words: impl Into<Words>) -> Self {
        self.say(2, lead, words.into())
    }

    /// Continues the part that was added last with words or a knob.
    #[must_use]
    pub fn and(mut self, words: impl Into<Words>) -> Self {
        let parts = &mut *self.0;
        parts.said[parts.last].words.0.extend(words.into().0);
        self
    }

    /// Continues with a text in quotes, as its writer wrote it.
    #[must_use]
    pub fn quoted(self, text: impl Into<String>) -> Self {
        self.and(Words(vec![Piece::Quoted(text.into())]))
    }

    /// Adds more to the value found.
    #[must_use]
    pub fn found_also(mut self, words: impl Into<Words>) -> Self {
        self.0.said[0].words.0.extend(words.into().0);
        self
    }

    /// Adds more to the remedy, at the end of the sentence.
    #[must_use]
    pub fn help_also(mut self, words: impl Into<Words>) -> Self {
        self.0.said[2].words.0.extend(words.into().0);
        self
    }

    fn say(mut self, part: usize, lead: &'static str, words: Words) -> Self {
        self.0.last = part;
        let lead = lead.into();
        self.0.said[part] = RefusalPart { lead, words };
        self
    }

    /// Sets the kind of the refusal.
    #[must_use]
    pub fn kind(mut self, kind: RefusalKind) -> Self {
        self.0.kind = kind;
        self
    }

    /// Sets the missing knob that alone would remove the fault.
    #[must_use]
    pub fn wants(mut self, knob: Knob) -> Self {
        self.0.wants = Some(knob);
        self
    }

    /// Sets which names the sentence uses for knobs.
    #[must_use]
    pub fn by(mut self, naming: Naming) -> Self {
        self.0.naming = naming;
        self
    }

    /// Puts the fault into a field, or its field into an outer field, as the caller names it.
    #[must_use]
    pub fn in_field(mut self, field: impl Into<Cow<'static, str>>) -> Self {
        self.0.place.field = Some(Knob::field(field));
        self
    }

    /// Puts the field of the fault inside another one: `law` inside `links[0]` is `links[0].law`.
    #[must_use]
    pub fn inside(mut self, outer: &str) -> Self {
        let field = self.0.place.field.take();
        let path = field.map_or_else(|| outer.to_owned(), |field| format!("{outer}.{}", field.path()));
        self.in_field(path)
    }

    /// Puts the fault into a file, unless a file is known.
    #[must_use]
    pub fn in_file(mut self, file: &Path) -> Self {
        self.0.place.file.get_or_insert_with(|| file.to_path_buf());
        self
    }

    /// The place of the fault.
    pub fn place(&self) -> &FaultPlace {
        &self.0.place
    }

    /// The place of the fault, for additions.
    pub fn place_mut(&mut self) -> &mut FaultPlace {
        &mut self.0.place
    }

    /// Whether the refusal is of a kind.
    pub fn is_kind(&self, kind: RefusalKind) -> bool {
        self.0.kind == kind
    }

    /// The kind of the refusal, to hand it on.
    pub fn own_kind(&self) -> RefusalKind {
        self.0.kind
    }

    /// The knob that is missing.
    pub fn wanted(&self) -> Option<&Knob> {
        self.0.wants.as_ref()
    }

    /// The word found, as its writer wrote it.
    pub fn word(&self) -> Option<&str> {
        let pieces = self.0.said[0].words.0.iter();
        let mut words = pieces.filter_map(|piece| match piece {
            Piece::Quoted(text) => Some(text.as_str()),
            Piece::Text(_) | Piece::Knob(_) => None,
        });
        words.next()
    }

    /// The sentence without the name of the file, for places that show the name already.
    pub fn reason(&self) -> String {
        let mut inner = self.clone();
        inner.0.place.file = None;
        inner.to_string()
    }

    /// The parts for programs; no letter in them steers a terminal.
    pub fn parts(&self) -> Refusal {
        let shown = |text: String| message(&text).into_owned();
        let naming = self.0.naming;
        let [found, allowed, help] = self.0.said.each_ref().map(|part| {
            let text = part.words.by(naming);
            (!text.is_empty()).then(|| shown(text))
        });
        let place = Some(self.0.place.words(naming)).filter(|place| !place.is_empty());
        Refusal {
            message: shown(self.to_string()),
            place: place.map(shown),
            found,
            allowed,
            help,
        }
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let naming = self.0.naming;
        if out.alternate() {
            let field = self.0.place.field.as_ref().map_or("", |field| field.named(naming));
            let said = self.0.said.each_ref().map(|part| (&*part.lead, part.words.by(naming)));
            return out.write_str(&serde_json::json!((field, said)).to_string());
        }
        out.write_str(&Words::from(self).by(naming))
    }
}

impl std::error::Error for Refused {}

impl From<String> for Refused {
    fn from(sentence: String) -> Self {
        Self::that(sentence)
    }
}

impl From<&'static str> for Refused {
    fn from(sentence: &'static str) -> Self {
        Self::that(sentence)
    }
}

/// The parts of a refusal in words; a missing part is `null`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Refusal {
    /// The whole sentence.
    pub message: String,
    /// File, line and field.
    pub place: Option<String>,
    /// The thing found.
    pub found: Option<String>,
    /// The values allowed.
    pub allowed: Option<String>,
    /// The remedy.
    pub help: Option<String>,
}

/// The refusal as a line of JSON, `{"error": {…}}`.
///
/// # Panics
/// Never panics: texts have a JSON form.
pub fn refusal_json(refused: &Refused) -> String {
    #[derive(Serialize)]
    struct JsonLine {
        error: Refusal,
    }
    let error = refused.parts();
    serde_json::to_string(&JsonLine { error }).expect("texts are JSON")
}

#[cfg(test)]
mod tests;
