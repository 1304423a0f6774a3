//! The form of the files of scenes and sweeps, for editors.

use schemars::generate::SchemaSettings;
use schemars::transform::{RecursiveTransform, Transform};
use schemars::{JsonSchema, Schema, SchemaGenerator};

use crate::Scene;

/// The JSON Schema (2020-12) of a scene file, made from the types that read it.
pub fn scene_schema() -> String {
    schema_of::<Scene>()
}

/// The JSON Schema (2020-12) of a file, made from the type that reads it.
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

/// A description as an editor shows it: the documentation of the types without its marks for links.
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

/// Where the target of a link stands, from its parenthesis to the end.
fn link(text: &str) -> Option<(usize, usize)> {
    let start = text.find("](")? + 1;
    let length = text[start..].find(')')? + 1;
    Some((start, start + length))
}
