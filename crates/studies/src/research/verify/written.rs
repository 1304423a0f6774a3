//! The numbers of a scene in the form of a file.

use pounding_scene::Scene;
use serde_json::{Number, Value};

/// The scene with its numbers replaced in some of its fields. Numbers that can only be whole stay.
pub(super) fn rewritten(scene: &Scene, fields: &[&str], each: &mut dyn FnMut(f64) -> f64) -> Scene {
    let mut written = serde_json::to_value(scene).expect("a scene is written without errors");
    for field in fields {
        if let Some(value) = written.get_mut(field) {
            rewrite(value, each);
        }
    }
    Scene::of_words(&written).expect("other numbers of their kind are read")
}

fn rewrite(value: &mut Value, each: &mut dyn FnMut(f64) -> f64) {
    match value {
        Value::Number(number) if number.is_f64() => {
            let other = number.as_f64().and_then(|known| Number::from_f64(each(known)));
            *value = other.map_or(Value::Null, Value::Number);
        }
        Value::Array(all) => all.iter_mut().for_each(|one| rewrite(one, each)),
        Value::Object(fields) => fields.values_mut().for_each(|one| rewrite(one, each)),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}
