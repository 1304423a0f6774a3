//! Choices in a file: a word, or a table with one key and its settings.
//!
//! A word is short for a table without settings: `"exact"` for `{"exact": {}}`. If the choice needs settings, the message shows an example.

use std::marker::PhantomData;
use std::{fmt, iter};

use pounding_contact::ContactLaw;
use pounding_text::Refused;
use schemars::Schema;
use serde::de::value::{MapAccessDeserializer, MapDeserializer};
use serde::de::{DeserializeOwned, Error, IntoDeserializer, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Value, json};

use super::unfit::CHOICE;

/// A type with variants: a file chooses one of them.
pub(super) trait Choice: DeserializeOwned + Serialize {
    /// Examples that are written by hand, for [`Self::examples`].
    const EXAMPLES: &'static [&'static str] = &[];

    /// An example in JSON of every variant that needs settings.
    fn examples() -> Vec<String> {
        Self::EXAMPLES.iter().copied().map(String::from).collect()
    }
}

/// Reads a choice.
pub(super) fn one<'de, T: Choice, D: Deserializer<'de>>(from: D) -> Result<T, D::Error> {
    from.deserialize_any(OfFile(PhantomData))
}

/// Reads an optional choice.
pub(super) fn maybe<'de, T: Choice, D: Deserializer<'de>>(from: D) -> Result<Option<T>, D::Error> {
    Ok(Option::<Chosen<T>>::deserialize(from)?.map(|Chosen(choice)| choice))
}

/// A choice that was read.
struct Chosen<T>(T);

impl<'de, T: Choice> Deserialize<'de> for Chosen<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        one(from).map(Self)
    }
}

struct OfFile<T>(PhantomData<T>);

impl<'de, T: Choice> Visitor<'de> for OfFile<T> {
    type Value = T;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(CHOICE)
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<T, E> {
        if let Some(example) = example::<T>(word) {
            return Err(E::custom(needs_settings(word, &example)));
        }
        T::deserialize(word.into_deserializer()).or_else(|_: E| {
            let nothing = MapDeserializer::new(iter::empty::<(&str, &str)>());
            let table = MapDeserializer::new(iter::once((word, nothing)));
            T::deserialize(MapAccessDeserializer::new(table))
        })
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<T, A::Error> {
        let choice = T::deserialize(MapAccessDeserializer::new(&mut map))?;
        match map.next_key::<String>()? {
            Some(other) => Err(A::Error::custom(two_choices(&choice, &other))),
            None => Ok(choice),
        }
    }
}

/// Refusal of a choice with a second key beside it.
fn two_choices<T: Choice>(choice: &T, other: &str) -> Refused {
    let choice = json!(choice);
    let table = choice.as_object().and_then(|table| table.keys().next());
    let first = table.map(String::as_str).or(choice.as_str());
    let first = first.unwrap_or_default();
    let both = Refused::default().found(format!("both `{first}` and `{other}`"));
    both.allowed_is("one of them").help("delete the other")
}

/// Help for a choice that needs settings.
fn example<T: Choice>(word: &str) -> Option<String> {
    let begin = format!("{{\"{word}\":");
    let mut examples = T::examples().into_iter();
    examples.find(|example| example.starts_with(&begin))
}

/// Refusal of a word whose choice needs settings.
fn needs_settings(word: &str, json: &str) -> Refused {
    let toml = in_toml(json);
    let alone = Refused::default().found(format!("the word `{word}` alone"));
    alone.allowed_is(format!("a table with its settings, such as {json} in JSON, {toml} in TOML"))
}

/// Converts an example to TOML: keys without quotes, followed by an equals sign.
fn in_toml(json: &str) -> String {
    json.replace("\": ", " = ")
        .replace("{\"", "{ ")
        .replace(", \"", ", ")
        .replace('}', " }")
}

/// Adds a form of a choice to its schema.
pub(super) fn also(schema: &mut Schema, way: Value) {
    if let Some(Value::Array(ways)) = schema.get_mut("oneOf") {
        ways.push(way);
    }
}

impl Choice for ContactLaw {
    fn examples() -> Vec<String> {
        Self::examples().collect()
    }
}

#[cfg(test)]
mod tests {
    use pounding_contact::ContactLaw;
    use serde::Deserialize;
    use serde_json::Value;

    use super::{Choice, Chosen, example, in_toml, needs_settings};
    use crate::file::structure::NamedStructure;
    use crate::file::{Damping, Generated, Ground, Method, ScaleTo};

    /// Words of choices that need no settings.
    const ENOUGH: [&str; 5] = ["exact", "wall", "firm", "medium", "soft"];

    /// Words of all choices of a type, in its own order.
    fn words<T: Choice>() -> Vec<String> {
        let refused = serde_json::from_str::<T>("{\"?\": {}}").err();
        let message = refused.expect("no choice has that name").to_string();
        let words = message.split('`').skip(3).step_by(2);
        words.map(String::from).collect()
    }

    fn check<T: Choice>() {
        let words = words::<T>();
        assert!(words.len() > 1, "{words:?}");
        for word in words {
            let alone = Chosen::<T>::deserialize(Value::from(word.clone()));
            if ENOUGH.contains(&word.as_str()) {
                assert!(alone.is_ok(), "{word} alone");
                continue;
            }
            let message = alone.err().expect("settings are needed").to_string();
            let example = example::<T>(&word).expect("an example");
            assert_eq!(message, needs_settings(&word, &example).to_string());
        }
        for json in T::examples() {
            let value: Value = serde_json::from_str(&json).expect("JSON");
            assert!(Chosen::<T>::deserialize(value.clone()).is_ok(), "{json}");
            let toml = format!("example = {}", in_toml(&json));
            let toml: Value = toml::from_str(&toml).expect("TOML");
            assert_eq!(toml["example"], value, "{json}");
        }
    }

    #[test]
    fn limit_every_word_is_enough_or_has_an_example() {
        check::<ContactLaw>();
        check::<Damping>();
        check::<Generated>();
        check::<Ground>();
        check::<Method>();
        check::<NamedStructure>();
        check::<ScaleTo>();
    }
}
