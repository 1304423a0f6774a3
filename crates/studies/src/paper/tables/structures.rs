//! Dynamic characteristics of structures (the paper's Table 1).

use super::Table;
use crate::Completed;
use pounding_scene::Structure;
use pounding_text::digits;

pub(super) fn table(completed: &Completed) -> Table {
    let scene = &completed.file.study.scenes[0];
    let mut table = Table::new(&[
        "structure",
        "mass_kg",
        "stiffness_kn_per_m",
        "period_s",
        "damping_ratio",
        "yield_force_kn",
        "yield_displacement_m",
    ]);
    for structure in &scene.structures {
        let Structure::Sdof(structure) = structure else {
            continue;
        };
        let force = structure.yield_force_n;
        table.rows.push(vec![
            structure.name.clone(),
            digits(structure.mass_kg),
            digits(structure.stiffness_n_per_m / 1e3),
            digits(structure.period()),
            digits(structure.damping_ratio()),
            force.map(|force| digits(force / 1e3)).unwrap_or_default(),
            force.map(|force| digits(force / structure.stiffness_n_per_m)).unwrap_or_default(),
        ]);
    }
    table
}
