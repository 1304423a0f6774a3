//! A scene as a script for OpenSeesPy: its numbers, then `opensees.py`.

use std::fmt::Write as _;

use pounding_scene::{PairOutcome, RunResult, Simulation};
use pounding_text::visible;
use serde_json::json;

use super::link::ScriptLink;
use super::material::Material;
use super::row::{ScriptFloor, ScriptRow};

/// What a script holds.
pub(super) struct Contents<'a> {
    pub(super) prepared: &'a Simulation,
    pub(super) row: ScriptRow,
    /// The material of every pair.
    pub(super) materials: Vec<Material>,
    /// What the exact method finds.
    pub(super) exact: &'a RunResult,
    /// Default time step of the script \[s\].
    pub(super) time_step: f64,
}

/// The part of the script after the numbers, equal for every scene.
const PROGRAM: &str = include_str!("opensees.py");

/// Samples of the ground motion in a line.
const SAMPLES: usize = 4;

/// The script.
pub(super) fn script(contents: &Contents<'_>) -> String {
    let scene = contents.prepared.scene();
    let record = contents.prepared.record();
    let mut text = HEADER.to_string();
    let mut line = |line: &str| writeln!(text, "{line}").expect("memory takes all");
    line(&format!("SCENE = {}", quoted(&scene.name)));
    line(&format!("DURATION = {:?}  # s", contents.prepared.duration()));
    line(&format!("TIME_STEP = {:?}  # s", contents.time_step));
    line("\n# Level by level from the ground up, each from left to right; None is a wall.");
    let named = contents.prepared.floors().all().iter();
    let floors = named.zip(&contents.row.floors).map(|(named, one)| {
        let written = one.as_ref().map(|one| floor(&named.name, one));
        written.unwrap_or_else(|| "None".into())
    });
    line(&list("FLOORS", floors));
    let (arrivals, grounds) = grounds(&contents.row.arrivals);
    line("\n# When the ground motion arrives [s], and which of these arrivals each floor has.");
    line(&format!("ARRIVALS = {arrivals:?}"));
    line(&format!("GROUND_OF = {grounds:?}"));
    line("\n# Floors that can touch, by their places; the material with its parameters\n# after the tag, and where it is not the law.");
    let materials = contents.materials.iter().enumerate();
    let contacts = materials.map(|(index, one)| contact(contents.prepared, index, one));
    line(&list("CONTACTS", contacts));
    line("\n# Links: their ends, as floors or the ground below them, and their materials with\n# the parameters after the tag.");
    line(&list("LINKS", contents.row.links.iter().map(ScriptLink::written)));
    line("\n# By the exact method of pounding, which has no time step.");
    line(&exact(contents));
    line("\n# Ground acceleration [m/s^2], linear between samples, zero after the last.");
    line(&format!("GROUND_STEP = {:?}  # s", record.time_step()));
    let samples = record.samples().chunks(SAMPLES);
    let samples = samples.map(|chunk| {
        let numbers: Vec<String> = chunk.iter().map(|one| format!("{one:?}")).collect();
        numbers.join(", ")
    });
    line(&list("GROUND", samples));
    text + PROGRAM
}

const HEADER: &str = "\
# A scene of pounding for OpenSeesPy, to check one program by the other.
#
#   pip install openseespy
#   python3 THIS_FILE [TIME_STEP]
#
# Units: kg, m, s, N. Displacements that are printed are relative to the ground.
import os
import sys

import openseespy.opensees as ops

";

/// A Python list with an entry to a line.
fn list(name: &str, entries: impl Iterator<Item = String>) -> String {
    let lines: String = entries.fold(String::new(), |lines, entry| lines + "    " + &entry + ",\n");
    if lines.is_empty() {
        format!("{name} = []")
    } else {
        format!("{name} = [\n{lines}]")
    }
}

/// A text as Python writes it, which is as JSON does.
fn quoted(text: &str) -> String {
    visible(&json!(text).to_string()).into_owned()
}

/// The arrivals that differ, and which of them each floor has.
fn grounds(arrivals: &[f64]) -> (Vec<f64>, Vec<usize>) {
    let mut different: Vec<f64> = Vec::new();
    let grounds = arrivals.iter().map(|arrival| {
        let same = |one: &f64| one.total_cmp(arrival).is_eq();
        different.iter().position(same).unwrap_or_else(|| {
            different.push(*arrival);
            different.len() - 1
        })
    });
    let grounds = grounds.collect();
    (different, grounds)
}

fn floor(name: &str, floor: &ScriptFloor) -> String {
    let ScriptFloor {
        mass,
        below,
        column,
        damping: [damping, ground_damping],
        start: [displacement, velocity, force],
    } = floor;
    let below = below.map_or("None".into(), |below| below.to_string());
    format!(
        "{{\"name\": {}, \"mass\": {mass:?}, \"below\": {below},\n     \"column\": ({}, {}),\n     \"damping\": {damping:?}, \
         \"ground_damping\": {ground_damping:?},\n     \"start\": ({displacement:?}, {velocity:?}, {force:?})}}",
        quoted(name),
        quoted(column.name),
        column.parameters.join(", ")
    )
}

fn contact(prepared: &Simulation, index: usize, material: &Material) -> String {
    let pair = &prepared.pairs()[index];
    let floors = prepared.floors().all();
    let [left, right] = [pair.left(), pair.right()].map(|side| &floors[side].name);
    let parameters = material.parameters.iter().map(|one| format!("{one:?}"));
    let parameters = parameters.chain(material.option.map(quoted));
    let parameters: Vec<String> = parameters.collect();
    let note = material.note.map_or("None".into(), quoted);
    format!(
        "{{\"name\": {}, \"floors\": ({}, {}), \"gap\": {:?},\n     \"material\": ({}, {}),\n     \"note\": {note}}}",
        quoted(&format!("{left} - {right}")),
        pair.left(),
        pair.right(),
        pair.gap(),
        quoted(material.name),
        parameters.join(", ")
    )
}

/// The exact numbers, in the order of floors and pairs.
fn exact(contents: &Contents<'_>) -> String {
    let pairs = 0..contents.materials.len();
    let pairs: Vec<PairOutcome> = pairs.map(|pair| contents.exact.of_pair(pair)).collect();
    let floors = 0..contents.row.floors.len();
    let peak = |index: usize| contents.exact.peaks.of(index).displacement.value;
    let displacements = floors.map(|index| format!("{:?}", peak(index)));
    let touches = pairs.iter().map(|pair| pair.collisions.to_string());
    let first = pairs.iter().map(|pair| python(pair.first.map(|first| first.start)));
    let force = pairs.iter().map(|pair| python(pair.peak_force.map(|peak| peak.value)));
    let rows = [
        ("displacement", displacements.collect::<Vec<_>>()),
        ("touches", touches.collect()),
        ("first", first.collect()),
        ("force", force.collect()),
    ];
    let rows = rows.map(|(name, values)| format!("    \"{name}\": [{}],\n", values.join(", ")));
    format!("EXACT = {{\n{}}}", rows.concat())
}

fn python(value: Option<f64>) -> String {
    value.map_or("None".into(), |value| format!("{value:?}"))
}
