//! The file beside a converted record: the source of its numbers, and their processing.

use std::path::Path;

use pounding::report::SCHEMA_VERSION;
use pounding::scene::Origin;
use serde_json::{Value, json};

use super::{Arguments, Motion, To};
use pounding::text::json_text;

/// The file, its component and hash, and every step of processing, as JSON.
pub(super) fn json_of(args: &Arguments, motion: &Motion) -> String {
    let record = &motion.record;
    let unit = match args.to {
        To::MPerS2 => "m_per_s2",
        To::G => "g",
    };
    let said = json!({
        "schema_version": SCHEMA_VERSION,
        "file": name(&args.out),
        "unit": unit,
        "gravity_m_per_s2": motion.gravity,
        "n_samples": record.samples().len(),
        "time_step_s": record.time_step(),
        "from": motion.origin.as_deref().map(from),
        "scene": motion.scene.as_ref().map(|scene| json!({"file": name(&args.file), "name": scene})),
        "processing": motion.processing,
        "says": record.source().lines().collect::<Vec<_>>(),
        "program": concat!("pounding ", env!("CARGO_PKG_VERSION")),
    });
    json_text(&said)
}

/// The file of a record.
fn from(origin: &Origin) -> Value {
    let mut readings = origin.file.readings().iter();
    let component = readings.find(|one| one.what == "component");
    json!({
        "file": name(&origin.path),
        "format": origin.file.format().name(),
        "component": component.map(|one| &one.found),
        "unit": origin.file.unit().name(),
        "sha256": origin.sha256,
    })
}

/// Name of a file without its folder, which other machines do not have.
fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}
