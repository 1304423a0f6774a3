//! `history.csv`: the motion of every structure, and gaps and forces of every pair, row by row in time.

use super::names::Names;
use pounding_scene::{Floors, RunResult, Simulation};
use pounding_solver::{Histories, State, Travel};
use pounding_text::Table;

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

    /// A history of a floor or a pair.
    fn values(&self, quantity: HistoryQuantity, place: usize) -> Vec<f64> {
        let rows = 0..self.len();
        let of_states = |value: fn(&State) -> f64| self.states(place)[rows.clone()].iter().map(value).collect();
        match quantity {
            HistoryQuantity::Displacement => of_states(|state| state.displacement),
            HistoryQuantity::Velocity => of_states(|state| state.velocity),
            HistoryQuantity::AbsoluteAcceleration => {
                let states = self.states(place);
                rows.map(|row| states[row].acceleration + self.ground(place, self.time(row)))
                    .collect()
            }
            HistoryQuantity::ShearForce => self.shear_forces(place).collect(),
            HistoryQuantity::Drift => self.drifts(place).collect(),
            HistoryQuantity::PoundingForce if self.floors().shares_floors(place) => rows.map(|_| f64::NAN).collect(),
            HistoryQuantity::PoundingForce => rows.map(|row| self.force(place, row)).collect(),
            HistoryQuantity::Opening => rows.map(|row| self.opening(place, row)).collect(),
        }
    }

    /// Drift of the storey below a floor over time \[m\].
    pub(super) fn drifts(&self, floor: usize) -> impl Iterator<Item = f64> {
        let below = self.floors().below(floor).map(|below| self.states(below));
        let states = self.states(floor).iter().enumerate();
        states.map(move |(row, state)| state.displacement - below.map_or(0.0, |below| below[row].displacement))
    }

    /// Open width of the gap of a pair \[m\]; negative while its neighbours overlap.
    pub(super) fn opening(&self, place: usize, row: usize) -> f64 {
        let pair = self.prepared.pairs()[place];
        let (left, right) = (pair.left(), pair.right());
        let [left_moved, right_moved] = self.points(place, row);
        let own = pair.gap() + right_moved - left_moved;
        let bases = |travel: &Travel| travel.opening([left, right], self.time(row)).displacement;
        own - self.travel.map_or(0.0, bases)
    }

    /// Acceleration of the ground under a floor at an instant \[m/s²\].
    fn ground(&self, floor: usize, time: f64) -> f64 {
        let arrival = self.travel.map_or(0.0, |travel| travel.arrival(floor));
        self.prepared.record().at(time - arrival)
    }

    /// Force of the columns below a floor over time \[N\]: gravity takes its part off what they give.
    pub(super) fn shear_forces(&self, floor: usize) -> impl Iterator<Item = f64> {
        let gravity = self.floors().all()[floor].made_of.map_or(0.0, |made| made.gravity_n_per_m);
        let states = self.states(floor).iter().zip(self.drifts(floor));
        states.map(move |(state, drift)| state.restoring_force + gravity * drift)
    }

    /// Displacements of both points of a pair \[m\].
    pub(super) fn points(&self, pair: usize, row: usize) -> [f64; 2] {
        let points = self.prepared.pairs()[pair].relation.points();
        points.map(|point| point.of(|node| self.states(node)[row].displacement))
    }

    /// Whether a floor tells the force of a compliant pair.
    pub(super) fn tells_force(&self, pair: usize) -> bool {
        self.prepared.pairs()[pair].law.is_compliant() && !self.floors().shares_floors(pair)
    }

    /// Pounding force of a compliant pair whose floors [tell it](Self::tells_force) \[N\], ≥ 0.
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
    /// Pounding force of a pair \[N\], ≥ 0; 0 of laws that act by impulses, NaN where a floor has several contacts on a side.
    PoundingForce,
    /// Open width of the gap of a pair \[m\]; negative while its floors overlap.
    Opening,
}

impl HistoryQuantity {
    /// Every history, in the order of columns: those of floors, then those of pairs.
    pub const ALL: [Self; 7] = [
        Self::Displacement,
        Self::Velocity,
        Self::AbsoluteAcceleration,
        Self::ShearForce,
        Self::Drift,
        Self::PoundingForce,
        Self::Opening,
    ];

    /// Its name in files, with its unit.
    pub fn name(self) -> &'static str {
        match self {
            Self::Displacement => "displacement_m",
            Self::Velocity => "velocity_m_per_s",
            Self::AbsoluteAcceleration => "absolute_acceleration_m_per_s2",
            Self::ShearForce => "shear_force_n",
            Self::Drift => "storey_drift_m",
            Self::PoundingForce => "pounding_force_n",
            Self::Opening => "opening_m",
        }
    }

    fn is_of_pair(self) -> bool {
        matches!(self, Self::PoundingForce | Self::Opening)
    }
}

/// A history of a run that kept its states: of every floor, walls included, or every pair, its values at t = 0, one
/// [interval](crate::Report::interval), two intervals and so on.
///
/// # Panics
/// If the run kept no histories.
pub fn history_of(prepared: &Simulation, outcome: &RunResult, quantity: HistoryQuantity) -> Vec<Vec<f64>> {
    let travel = prepared.travel();
    let motion = Motion::of(prepared, travel.as_ref(), outcome);
    let floors = prepared.floors();
    let places = if quantity.is_of_pair() {
        floors.facing().len()
    } else {
        floors.all().len()
    };
    (0..places).map(|place| motion.values(quantity, place)).collect()
}

/// The file. Walls have no columns, storeys on the ground no drift, and pairs a force only if their law has one.
pub(super) fn csv(prepared: &Simulation, motion: &Motion<'_>) -> String {
    let floors = prepared.floors();
    let names = Names::of(floors);
    let has_column = |quantity: HistoryQuantity, place: usize| match quantity {
        HistoryQuantity::Drift => has_drift(floors, place),
        HistoryQuantity::PoundingForce => motion.tells_force(place),
        HistoryQuantity::Opening => true,
        HistoryQuantity::Displacement | HistoryQuantity::Velocity | HistoryQuantity::AbsoluteAcceleration | HistoryQuantity::ShearForce => {
            !floors.all()[place].is_wall()
        }
    };
    let table = Table::of(0..motion.len())
        .column("time_s", |row| motion.time(*row))
        .column("ground_acceleration_m_per_s2", |row| prepared.record().at(motion.time(*row)));
    let table = [(&names.structures, false), (&names.pairs, true)]
        .into_iter()
        .fold(table, |table, (names, of_pair)| {
            let columns = (0..names.len()).flat_map(|place| HistoryQuantity::ALL.map(|quantity| (place, quantity)));
            let columns = columns.filter(|(place, quantity)| quantity.is_of_pair() == of_pair && has_column(*quantity, *place));
            columns.fold(table, |table, (place, quantity)| {
                let values = motion.values(quantity, place);
                table.column(format!("{}_{}", names[place], quantity.name()), move |row| values[*row])
            })
        });
    table.csv()
}

/// Whether the drift of a storey has a column: in a building of several storeys it is not the displacement.
fn has_drift(floors: &Floors, floor: usize) -> bool {
    let one = &floors.all()[floor];
    one.storey.is_some() && floors.of_structure(one.structure).len() > 1
}
