//! `pounding schema`: the form of a scene file, for editors.

use pounding::studies::scene_schema;

pub(crate) const EXAMPLES: &str = "\
Example:
  pounding schema > scene.schema.json

Most editors complete and check a TOML scene that begins with
  #:schema scene.schema.json
and a JSON scene by a setting of their own.";

/// The JSON Schema of a scene.
pub(crate) fn answer() -> String {
    scene_schema()
}
