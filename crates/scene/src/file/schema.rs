//! JSON Schemas of the files of scenes and sweeps, for editors.

use schemars::generate::SchemaSettings;
use schemars::transform::{RecursiveTransform, Transform};
use schemars::{JsonSchema, Schema, SchemaGenerator};

use crate::Scene;

/// Returns the JSON Schema (2020-12) of a scene file, made from the types that read it.
pub fn schema() -> String {
    schema_of::<Scene>()
}

/// Returns the JSON Schema (2020-12) of a file, made from the type that reads it.
///
/// # Panics
/// Never: a schema is JSON.
pub fn schema_of<File: JsonSchema>() -> String {
    let settings = SchemaSettings::draft2020_12();
    let generator = SchemaGenerator::new(settings);
    let mut schema = generator.into_root_schema_for::<File>();
    RecursiveTransform(plain).transform(&mut schema);
    let mut text = serde_json::to_string_pretty(&schema).expect("a schema is JSON");
    text.push('\n');
    text
}

/// Removes the marks of links from a description, which is the documentation of a type.
fn plain(schema: &mut Schema) {
    let Some(serde_json::Value::String(text)) = schema.get_mut("description") else {
        return;
    };
    let mut plain = text.clone();
    while let Some((start, end)) = link(&plain) {
        plain.replace_range(start..end, "");
    }
    for mark in ["\\[", "\\]"] {
        plain = plain.replace(mark, if mark == "\\[" { "(" } else { ")" });
    }
    plain = plain.replace(['[', ']'], "");
    *text = plain.split_whitespace().collect::<Vec<_>>().join(" ");
}

/// Range of the target of a link, from its parenthesis to the end.
fn link(text: &str) -> Option<(usize, usize)> {
    let start = text.find("](")? + 1;
    let length = text[start..].find(')')? + 1;
    Some((start, start + length))
}
