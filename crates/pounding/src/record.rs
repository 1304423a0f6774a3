//! What is said of a ground motion: where it came from, what was read, and what was done to it.

use pounding::scene::Simulation;
use pounding::text::digits;

use crate::text::short;

/// Source and peak.
pub(crate) fn brief(prepared: &Simulation) -> String {
    let scene = prepared.scene();
    let (_, peak) = prepared.record().peak();
    format!(
        "{}, peak {} g",
        scene.record.source,
        short(peak.abs() / scene.record.gravity_m_per_s2)
    )
}

/// Source, peak, what was read and from which line, what was done, and what the file says of itself.
pub(crate) fn lines(prepared: &Simulation) -> Vec<String> {
    let (scene, record) = (prepared.scene(), prepared.record());
    let (time, peak) = record.peak();
    let mut lines = vec![
        scene.record.source.to_string(),
        format!(
            "peak {} g = {} m/s² at {} s, {} s long in steps of {} s",
            short(peak / scene.record.gravity_m_per_s2),
            short(peak),
            digits(time),
            digits(record.duration()),
            digits(record.time_step()),
        ),
    ];
    let readings = prepared.origin().map(|origin| origin.file.readings());
    let read = readings.into_iter().flatten().map(|reading| {
        let line = reading.line.map_or(String::new(), |line| format!(" (line {line})"));
        format!("{} {}{line}", reading.what, reading.found)
    });
    let read: Vec<String> = read.collect();
    if !read.is_empty() {
        lines.push(format!("read: {}", read.join(", ")));
    }
    let done = scene.record.processing();
    if !done.is_empty() {
        let scale = prepared.scale();
        let scaled = if scale.to_bits() == 1.0_f64.to_bits() {
            String::new()
        } else {
            format!("; in all × {}", short(scale))
        };
        lines.push(format!("then: {}{scaled}", done.join("; ")));
    }
    lines.extend(record.source().lines().map(String::from));
    lines
}
