//! The numbers of data in the form of a file.

use serde::{Serialize, de::DeserializeOwned};
use serde_json::{Number, Value};

/// Data with every number with a fraction, or that may have one, replaced.
pub(super) fn rewritten<T: Serialize + DeserializeOwned>(
    data: &T,
    each: &mut dyn FnMut(f64) -> f64,
) -> T {
    let mut written =
        serde_json::to_value(data).expect("data of a file are written without errors");
    rewrite(&mut written, each);
    serde_json::from_value(written).expect("other numbers of their kind are read")
}

fn rewrite(value: &mut Value, each: &mut dyn FnMut(f64) -> f64) {
    match value {
        Value::Number(number) if number.is_f64() => {
            let other = number
                .as_f64()
                .and_then(|known| Number::from_f64(each(known)));
            *value = other.map_or(Value::Null, Value::Number);
        }
        Value::Array(all) => all.iter_mut().for_each(|one| rewrite(one, each)),
        Value::Object(fields) => fields.values_mut().for_each(|one| rewrite(one, each)),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}
