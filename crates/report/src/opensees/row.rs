//! The row of a scene for OpenSees: floors, their columns, and the pairs that can touch.

use super::link::ScriptLink;
use pounding_scene::{Columns, Floors, Simulation, StoreyProperties};
use pounding_solver::OnRow;
use pounding_solver::{Hysteretic, Node, Row, Support};

/// A uniaxial material of columns, as Python writes it: its name, and its parameters after the tag.
pub(super) struct ColumnMaterial {
    pub(super) name: &'static str,
    pub(super) parameters: Vec<String>,
}

/// A floor and the storey below it.
pub(super) struct ScriptFloor {
    pub(super) mass: f64,
    /// The floor below, by its place in the row; `None` on the ground.
    pub(super) below: Option<usize>,
    pub(super) column: ColumnMaterial,
    /// Damping of the storey, and of the floor against the ground \[N·s/m\].
    pub(super) damping: [f64; 2],
    /// Displacement \[m\], velocity \[m/s\] and force of the columns \[N\] at t = 0.
    pub(super) start: [f64; 3],
}

/// The row, in the order of its floors.
pub(super) struct ScriptRow {
    /// `None` for a wall.
    pub(super) floors: Vec<Option<ScriptFloor>>,
    /// When the ground motion arrives at each \[s\].
    pub(super) arrivals: Vec<f64>,
    pub(super) links: Vec<ScriptLink>,
}

impl ScriptRow {
    pub(super) fn of(simulation: &Simulation) -> Self {
        simulation.on_row(Reading(simulation.floors()))
    }
}

struct Reading<'a>(&'a Floors);

impl OnRow for Reading<'_> {
    type Output = ScriptRow;

    fn on<Column: Hysteretic>(self, row: &Row<Column>) -> ScriptRow {
        let nodes = row.nodes();
        let floors = nodes.iter().zip(self.0.all());
        ScriptRow {
            floors: floors.map(|(node, floor)| Some(floor_of(nodes, node, &floor.made_of?))).collect(),
            arrivals: (0..nodes.len()).map(|node| row.arrival(node)).collect(),
            links: row.links().iter().map(ScriptLink::of).collect(),
        }
    }
}

fn floor_of<Column: Hysteretic>(nodes: &[Node<Column>], node: &Node<Column>, made: &StoreyProperties) -> ScriptFloor {
    let (below, ground_damping) = match node.support {
        Support::Ground => (None, 0.0),
        Support::Floor(floor) => (Some(floor.below), floor.ground_damping),
    };
    let carried = below.map_or(0.0, |below| nodes[below].initial_displacement);
    let drift = node.initial_displacement - carried;
    ScriptFloor {
        mass: made.mass_kg,
        below,
        column: material(&made.leaning_columns()),
        damping: [node.damping, ground_damping],
        start: [node.initial_displacement, node.initial_velocity, node.column.loaded(drift).force],
    }
}

/// The columns of a storey as a material.
fn material(columns: &Columns) -> ColumnMaterial {
    let of = |name, parameters: &[f64]| ColumnMaterial {
        name,
        parameters: parameters.iter().map(|one| format!("{one:?}")).collect(),
    };
    let stiffness = columns.stiffness_n_per_m;
    let Some(force) = columns.yield_force_n else {
        return of("Elastic", &[stiffness]);
    };
    let hardening = columns.hardening_ratio;
    if let Some(bend) = columns.bouc_wen {
        let unit = (0..bend.exponent).fold(1.0, |unit, _| unit * (stiffness / force));
        let (gamma, beta) = ((1.0 - bend.beta) * unit, bend.beta * unit);
        let own = [hardening.unwrap_or(0.0), stiffness, f64::from(bend.exponent)];
        let shape = [gamma, beta, 1.0, 0.0, 0.0, 0.0];
        let mut smooth = of("BoucWen", &[&own[..], &shape].concat());
        // Tolerance of its own iteration [m], and its most rounds.
        smooth.parameters.extend(["1e-16", "50"].map(String::from));
        return smooth;
    }
    match hardening {
        Some(hardening) => of("Steel01", &[force, stiffness, hardening]),
        None => of("ElasticPP", &[stiffness, force / stiffness]),
    }
}
