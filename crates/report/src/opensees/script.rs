//! A scene as a script for OpenSeesPy: its numbers, then `opensees.py`.

use std::fmt::Write as _;

use pounding_scene::{PairOutcome, RunResult, Scene, Sdof, Simulation, Structure};
use serde_json::json;

use super::material::Material;

/// What a script holds.
pub(super) struct Contents<'a> {
    pub(super) prepared: &'a Simulation,
    /// The material of every contact.
    pub(super) materials: Vec<Material>,
    /// What the exact method finds.
    pub(super) exact: &'a RunResult,
    /// Time step where the script is run without one \[s\].
    pub(super) time_step: f64,
}

/// What follows the numbers; the same for every scene.
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
    line(&format!(
        "DURATION = {:?}  # s",
        contents.prepared.duration()
    ));
    line(&format!("TIME_STEP = {:?}  # s", contents.time_step));
    line("\n# From left to right; None is a wall.");
    line(&list("STRUCTURES", scene.structures.iter().map(structure)));
    line(
        "\n# Between each structure and its right neighbour; the material with its\n# parameters after the tag, and where it is not the law.",
    );
    let materials = contents.materials.iter().enumerate();
    let contacts = materials.map(|(index, one)| contact(scene, index, one));
    line(&list("CONTACTS", contacts));
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
# Units: kg, m, s, N. Displacements are relative to the ground.
import os
import sys

import openseespy.opensees as ops

";

/// A Python list with an entry to a line.
fn list(name: &str, entries: impl Iterator<Item = String>) -> String {
    let lines: String = entries.fold(String::new(), |lines, entry| {
        lines + "    " + &entry + ",\n"
    });
    if lines.is_empty() {
        format!("{name} = []")
    } else {
        format!("{name} = [\n{lines}]")
    }
}

/// A text as Python writes it, which is as JSON does.
fn quoted(text: &str) -> String {
    json!(text).to_string()
}

fn structure(structure: &Structure) -> String {
    match structure {
        // Buildings were refused.
        Structure::Building(_) | Structure::Wall => "None".into(),
        Structure::Sdof(sdof) => sdof_of(sdof),
    }
}

fn sdof_of(sdof: &Sdof) -> String {
    let yield_force = sdof
        .yield_force_n
        .map_or("None".into(), |force| format!("{force:?}"));
    format!(
        "{{\"name\": {}, \"mass\": {:?}, \"stiffness\": {:?}, \"damping\": {:?},\n     \"yield_force\": {yield_force}, \
         \"displacement\": {:?}, \"velocity\": {:?}}}",
        quoted(&sdof.name),
        sdof.mass_kg,
        sdof.stiffness_n_per_m,
        sdof.damping_coefficient(),
        sdof.initial_displacement_m,
        sdof.initial_velocity_m_per_s
    )
}

fn contact(scene: &Scene, index: usize, material: &Material) -> String {
    let [left, right] = [index, index + 1].map(|index| scene.structures[index].name());
    let gap = scene.contacts.iter().flatten().nth(index);
    let parameters = material.parameters.iter().map(|one| format!("{one:?}"));
    let parameters = parameters.chain(material.option.map(quoted));
    let parameters: Vec<String> = parameters.collect();
    let note = material.note.map_or("None".into(), quoted);
    format!(
        "{{\"name\": {}, \"gap\": {:?},\n     \"material\": ({}, {}),\n     \"note\": {note}}}",
        quoted(&format!("{left} - {right}")),
        gap.map_or(0.0, |contact| contact.gap_m),
        quoted(material.name),
        parameters.join(", ")
    )
}

/// The exact numbers, in the order of structures and contacts.
fn exact(contents: &Contents<'_>) -> String {
    let pairs = 0..contents.materials.len();
    let pairs: Vec<PairOutcome> = pairs.map(|pair| contents.exact.of_pair(pair)).collect();
    let structures = 0..contents.prepared.scene().structures.len();
    let peak = |index: usize| contents.exact.peaks.of(index).displacement.value;
    let displacements = structures.map(|index| format!("{:?}", peak(index)));
    let touches = pairs.iter().map(|pair| pair.collisions.to_string());
    let first = pairs
        .iter()
        .map(|pair| python(pair.first.map(|first| first.start)));
    let force = pairs
        .iter()
        .map(|pair| python(pair.peak_force.map(|peak| peak.value)));
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
