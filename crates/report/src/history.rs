//! `history.csv`: the motion of every structure, and gaps and forces of every pair, row by row in time.

use super::names::Names;
use pounding_scene::{Floors, RunResult, Simulation};
use pounding_solver::{Histories, State, Travel};
use pounding_text::{digits, to_csv};

/// The states of a run at equal intervals.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motion<'a> {
    pub(super) prepared: &'a Simulation,
    histories: &'a Histories,
    /// How the ground motion travels; `None` if all are shaken at once.
    travel: Option<&'a Travel>,
}

impl<'a> Motion<'a> {
    /// The table of a run that kept its histories.
    pub(super) fn of(prepared: &'a Simulation, travel: Option<&'a Travel>, outcome: &'a RunResult) -> Self {
        let kept = outcome.histories.as_ref();
        Self {
            prepared,
            histories: kept.expect("a report keeps histories"),
            travel,
        }
    }

    /// Number of instants.
    pub(super) fn len(&self) -> usize {
        let lengths = (0..self.floors().all().len()).map(|index| self.states(index).len());
        lengths.min().unwrap_or(0)
    }

    /// Time between two states \[s\].
    pub(super) fn interval(&self) -> f64 {
        self.histories.interval()
    }

    /// The floors of these states.
    pub(super) fn floors(&self) -> &'a Floors {
        self.prepared.floors()
    }

    /// Instant \[s\].
    pub(super) fn time(&self, row: usize) -> f64 {
        row as f64 * self.histories.interval()
    }

    /// States of a floor or wall.
    pub(super) fn states(&self, floor: usize) -> &'a [State] {
        &self.histories.of(floor).states
    }

    /// Drift of the storey below a floor over time \[m\].
    pub(super) fn drifts(&self, floor: usize) -> impl Iterator<Item = f64> {
        let below = self.floors().below(floor).map(|below| self.states(below));
        let states = self.states(floor).iter().enumerate();
        states.map(move |(row, state)| state.displacement - below.map_or(0.0, |below| below[row].displacement))
    }

    /// Open width of the gap of a pair \[m\]; negative while its neighbours overlap.
    pub(super) fn opening(&self, pair: usize, row: usize) -> f64 {
        let pair = self.prepared.pairs()[pair];
        let (left, right) = (pair.left(), pair.right());
        let [left_moved, right_moved] = [left, right].map(|node| self.states(node)[row].displacement);
        let own = pair.gap() + right_moved - left_moved;
        let bases = |travel: &Travel| travel.opening([left, right], self.time(row)).displacement;
        own - self.travel.map_or(0.0, bases)
    }

    /// Acceleration of the ground under a floor at an instant \[m/s²\].
    fn ground(&self, floor: usize, time: f64) -> f64 {
        let arrival = self.travel.map_or(0.0, |travel| travel.arrival(floor));
        self.prepared.record().at(time - arrival)
    }

    /// Pounding force of a compliant pair \[N\], ≥ 0.
    pub(super) fn force(&self, pair: usize, row: usize) -> f64 {
        // A wall does not move, whatever pushes it: its neighbour tells the force.
        let facing = self.floors().facing()[pair];
        if self.floors().all()[facing.left].is_wall() {
            self.states(facing.right)[row].force_from_left
        } else {
            -self.states(facing.left)[row].force_from_right
        }
    }
}

/// What a history holds of every floor that moves, or of every pair of floors that face each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HistoryQuantity {
    /// Displacement of a floor relative to the ground, positive to the right \[m\].
    Displacement,
    /// Velocity of a floor relative to the ground \[m/s\].
    Velocity,
    /// Acceleration of a floor, that of the ground included \[m/s²\].
    AbsoluteAcceleration,
    /// Shear force of the storey below a floor \[N\].
    ShearForce,
    /// Displacement of a floor relative to the one below \[m\].
    Drift,
    /// Open width of the gap of a pair \[m\]; negative while its floors overlap.
    Opening,
    /// Pounding force of a pair \[N\], ≥ 0; 0 of laws that act by impulses.
    PoundingForce,
}

/// A history of a run that kept its states: of every floor, walls included, or every pair, its values at t = 0, one
/// [interval](crate::Report::interval), two intervals and so on.
///
/// # Panics
/// If the run kept no histories.
pub fn history_of(prepared: &Simulation, outcome: &RunResult, quantity: HistoryQuantity) -> Vec<Vec<f64>> {
    let travel = prepared.travel();
    let motion = Motion::of(prepared, travel.as_ref(), outcome);
    let floors = 0..prepared.floors().all().len();
    let pairs = 0..prepared.floors().facing().len();
    let rows = || 0..motion.len();
    let of_floors = |value: &dyn Fn(usize, usize) -> f64| {
        let one = |floor| rows().map(|row| value(floor, row)).collect();
        floors.clone().map(one).collect()
    };
    let of_pairs = |value: &dyn Fn(usize, usize) -> f64| {
        let one = |pair| rows().map(|row| value(pair, row)).collect();
        pairs.clone().map(one).collect()
    };
    let state = |floor: usize, row: usize| motion.states(floor)[row];
    match quantity {
        HistoryQuantity::Displacement => of_floors(&|floor, row| state(floor, row).displacement),
        HistoryQuantity::Velocity => of_floors(&|floor, row| state(floor, row).velocity),
        HistoryQuantity::AbsoluteAcceleration => {
            of_floors(&|floor, row| state(floor, row).acceleration + motion.ground(floor, motion.time(row)))
        }
        HistoryQuantity::ShearForce => of_floors(&|floor, row| state(floor, row).restoring_force),
        HistoryQuantity::Drift => floors.map(|floor| motion.drifts(floor).collect()).collect(),
        HistoryQuantity::Opening => of_pairs(&|pair, row| motion.opening(pair, row)),
        HistoryQuantity::PoundingForce => of_pairs(&|pair, row| motion.force(pair, row)),
    }
}

/// The file.
pub(super) fn csv(prepared: &Simulation, motion: &Motion<'_>) -> String {
    let floors = prepared.floors();
    let names = Names::of(floors);
    let moves = |index: &usize| !floors.all()[*index].is_wall();
    let columns: Vec<usize> = (0..floors.all().len()).filter(moves).collect();
    // A full model has more pairs than the scene.
    let facing = floors.facing().iter().enumerate();
    let compliant: Vec<bool> = facing.map(|(pair, _)| prepared.pairs()[pair].law.is_compliant()).collect();
    let drifts: Vec<Option<Vec<f64>>> = (0..floors.all().len())
        .map(|floor| has_drift(floors, floor).then(|| motion.drifts(floor).collect()))
        .collect();
    let row = |row: usize| {
        let time = motion.time(row);
        let ground = prepared.record().at(time);
        let mut values = vec![time, ground];
        for &structure in &columns {
            let state = motion.states(structure)[row];
            values.extend([
                state.displacement,
                state.velocity,
                state.acceleration + motion.ground(structure, time),
                state.restoring_force,
            ]);
            if let Some(drifts) = &drifts[structure] {
                values.push(drifts[row]);
            }
        }
        for (pair, compliant) in compliant.iter().enumerate() {
            if *compliant {
                values.push(motion.force(pair, row));
            }
            values.push(motion.opening(pair, row));
        }
        values.into_iter().map(digits).collect()
    };
    let rows: Vec<Vec<String>> = (0..motion.len()).map(row).collect();
    to_csv(&header(floors, &names, &columns, &compliant), &rows)
}

/// Whether the drift of a storey has a column: in a building of several storeys it is not the displacement.
fn has_drift(floors: &Floors, floor: usize) -> bool {
    let one = &floors.all()[floor];
    one.storey.is_some() && floors.of_structure(one.structure).len() > 1
}

/// Names of the columns.
fn header(floors: &Floors, names: &Names, structures: &[usize], compliant: &[bool]) -> Vec<String> {
    let mut header = vec!["time_s".into(), "ground_acceleration_m_per_s2".into()];
    for &structure in structures {
        let name = &names.structures[structure];
        let quantities = [
            "displacement_m",
            "velocity_m_per_s",
            "absolute_acceleration_m_per_s2",
            "shear_force_n",
        ];
        header.extend(quantities.map(|quantity| format!("{name}_{quantity}")));
        if has_drift(floors, structure) {
            header.push(format!("{name}_storey_drift_m"));
        }
    }
    for (name, compliant) in names.pairs.iter().zip(compliant) {
        if *compliant {
            header.push(format!("{name}_pounding_force_n"));
        }
        header.push(format!("{name}_gap_m"));
    }
    header
}
