//! Cost of a floor in a step: rows of buildings, timed with rows of as many one-storey structures.
//!
//! All floors have one mass, and every storey is as stiff as the one-storey structure in its place. The fastest oscillation, which a time
//! step has to follow, therefore does not grow with the height.

use pounding_contact::{ContactLaw, NonlinearViscoelastic};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Mark, Panel, PlotError, Shade, render_png};
use pounding_scene::file::RunBudget;
use pounding_scene::{
    Building, Capacities, Columns, ComparedMethod, Contact, Damping, Error, FileUse, FloorHeights, Method, Property, RecordUse,
    STANDARD_GRAVITY, Scene, Simulation, Source, Storey, Structure,
};
use std::f64::consts::PI;
use std::path::Path;

/// Size of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct RowSize {
    /// Storeys of each building, > 0.
    pub(crate) storeys: usize,
    /// Number of buildings, > 0.
    pub(crate) buildings: usize,
}

impl RowSize {
    /// Number of floors.
    pub(crate) fn floors(self) -> usize {
        self.storeys * self.buildings
    }

    /// A row of equally many floors, each a separate structure.
    #[must_use]
    pub(crate) fn of_one_storey(self) -> Self {
        Self {
            storeys: 1,
            buildings: self.floors(),
        }
    }
}

/// Behaviour of the floors of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Condition {
    /// Whether columns yield; otherwise they are elastic.
    pub(crate) yielding: bool,
    /// Whether neighbours are a hundredth of a millimetre apart and touch; otherwise nothing can touch.
    pub(crate) touching: bool,
}

impl Condition {
    /// All conditions.
    pub(crate) const ALL: [Self; 4] = [
        Self::new(false, false),
        Self::new(true, false),
        Self::new(false, true),
        Self::new(true, true),
    ];

    const fn new(yielding: bool, touching: bool) -> Self {
        Self { yielding, touching }
    }

    /// The words of a table: columns, and contact.
    pub(crate) fn words(self) -> [&'static str; 2] {
        [
            if self.yielding { "yielding" } else { "elastic" },
            if self.touching { "touching" } else { "apart" },
        ]
    }
}

/// Time step of the stepping methods \[s\].
const TIME_STEP: f64 = 0.004;
/// Duration of a run \[s\].
const DURATION: f64 = 3.0;
/// Gap between neighbours that touch \[m\].
const GAP: f64 = 1e-5;
/// Mass of a floor \[kg\].
const MASS: f64 = 1e5;
/// Yield force of a storey over the weight of the floors that it carries \[–\].
const YIELDS_AT: f64 = 0.03;

/// A row to time.
#[derive(Debug)]
pub(crate) struct TimedRow {
    prepared: Simulation,
}

impl TimedRow {
    /// The methods to time, with their names in tables.
    pub(crate) fn methods() -> impl Iterator<Item = (&'static str, Method)> {
        let timed = |key: &str| METHODS.iter().any(|(name, ..)| *name == key);
        let contenders = ComparedMethod::ALL.iter().filter(move |one| timed(one.key));
        contenders.map(|contender| {
            let method = (contender.method)(TIME_STEP);
            match method.time_step() {
                Some(_) => (contender.key, method),
                None => (contender.key, Method::EXACT),
            }
        })
    }

    /// A row of buildings under the first seconds of a record.
    ///
    /// # Errors
    /// [`Error`] if the record cannot be read.
    pub(crate) fn new(size: RowSize, condition: Condition, method: Method, record: &Path) -> Result<Self, Error> {
        let name = format!("{} buildings of {} storeys", size.buildings, size.storeys);
        let building = |index| Structure::Building(building(index, size.storeys, condition.yielding));
        let structures = (0..size.buildings).map(building).collect();
        let prepared = timed_row(name, structures, condition.touching.then_some(GAP), method, record, DURATION)?;
        Ok(Self { prepared })
    }

    /// Runs the row.
    ///
    /// Returns the share of steps in which pairs of floors touch, over all pairs \[–\]. `None` without pairs, and for a method without
    /// steps.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early.
    pub(crate) fn run(&self) -> Result<Option<f64>, Error> {
        let work = self.prepared.timed()?;
        let steps = work.steps * self.prepared.floors().facing().len() as u64;
        Ok((steps > 0).then(|| work.touching_steps as f64 / steps as f64))
    }
}

/// A row with equal gaps, or without contacts, under the first seconds of a record, to time.
///
/// # Errors
/// [`Error`] if the record cannot be read.
pub(crate) fn timed_row(
    name: String,
    structures: Vec<Structure>,
    gap: Option<f64>,
    method: Method,
    record: &Path,
    duration: f64,
) -> Result<Simulation, Error> {
    let law = ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
        impact_stiffness: 2.75e9,
        impact_damping_ratio: 0.35,
    });
    let contacts = gap.map(|gap_m| {
        let contact = Contact {
            gap_m,
            law,
            levels: None,
            heights_m: None,
            seat_width_m: None,
            column_shape: pounding_scene::ColumnShape::Fixed,
            property: Property::default(),
        };
        vec![contact; structures.len() - 1]
    });
    let record = FileUse {
        file: record.to_string_lossy().into_owned(),
        ..FileUse::default()
    };
    let scene = Scene {
        name,
        record: RecordUse::of(Source::File(record)),
        duration_s: Some(duration),
        structures,
        contacts,
        neighbour: None,
        p_delta: None,
        collapse_drift_ratio: None,
        links: Vec::new(),
        arrivals_s: None,
        floors: Some(FloorHeights::Level),
        method,
        budget: RunBudget::default(),
        seeks_gaps: false,
    };
    Simulation::new(&scene, Path::new(""))
}

/// Storeys as stiff as a one-storey structure with a period of 0.3 to 0.5 s. Multiples of a prime, modulo another, spread the periods.
fn building(index: usize, storeys: usize, yields: bool) -> Building {
    let period = 0.3 + 0.2 * ((index * 7919) % 101) as f64 / 101.0;
    let omega = 2.0 * PI / period;
    let weight = |storey: usize| MASS * STANDARD_GRAVITY * (storeys - storey) as f64;
    let storey = |storey: usize| Storey {
        mass_kg: MASS,
        height_m: None,
        columns: Columns {
            yield_force_n: yields.then(|| YIELDS_AT * weight(storey)),
            ..Columns::elastic(MASS * omega * omega)
        },
        capacities: Capacities::default(),
        initial_displacement_m: 0.0,
        initial_velocity_m_per_s: 0.0,
    };
    Building {
        name: format!("building {index}"),
        damping: Damping::Ratio(0.05),
        storeys: (0..storeys).map(storey).collect(),
    }
}

/// The cost of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FloorCost {
    /// Name of the method in tables.
    pub(crate) method: &'static str,
    /// Behaviour of the floors.
    pub(crate) condition: Condition,
    /// Size of the row.
    pub(crate) size: RowSize,
    /// Wall time over that of the smallest row with this method and condition \[–\].
    pub(crate) over_smallest: f64,
}

/// Timed methods by their names in tables, with their looks.
const METHODS: [(&str, Shade, Mark); 7] = [
    (ComparedMethod::RIVAL, Shade::Blue, Mark::Disc),
    ("velocity_verlet", Shade::Green, Mark::Diamond),
    ("newmark_average_acceleration", Shade::Vermilion, Mark::Square),
    ("hht", Shade::Amber, Mark::HollowSquare),
    ("moreau_jean", Shade::Grey, Mark::Cross),
    ("rk4", Shade::Rose, Mark::Inverted),
    (ComparedMethod::REFERENCE, Shade::Ink, Mark::HollowTriangle),
];

/// Figure of elastic rows over their storeys and over their buildings, apart and touching, as a PNG. `fixed` is the row that both series
/// share, `smallest` the row whose time is the unit. The dashed line has the slope one: time grows with floors.
///
/// # Errors
/// [`PlotError`] if a time cannot be drawn.
pub(crate) fn floor_cost_figure(costs: &[FloorCost], fixed: RowSize, smallest: RowSize) -> Result<Vec<u8>, PlotError> {
    let mut panels = Vec::new();
    for touching in [false, true] {
        for over_storeys in [true, false] {
            let count = |size: RowSize| if over_storeys { size.storeys } else { size.buildings };
            let held = |size: RowSize| if over_storeys { size.buildings } else { size.storeys };
            let own = Condition { yielding: false, touching };
            let own = costs.iter().filter(|cost| cost.condition == own && held(cost.size) == held(fixed));
            let n = held(fixed);
            let (title, axis) = if over_storeys {
                (format!("{n} buildings"), "Storeys")
            } else {
                (format!("Buildings of {n} storeys"), "Buildings")
            };
            let curves = curves(&own.collect::<Vec<_>>(), |size| count(size) as f64, smallest);
            let y = Axis::auto("Wall time (smallest = 1)").log();
            panels.push(Panel {
                x: Some(Axis::auto(axis).log()),
                ..Panel::shared(format!("{title}, {}", if touching { "touching" } else { "apart" }), y, curves)
            });
        }
    }
    render_png(&Figure::grid(6.2, 2, Axis::default(), panels).labelled_at_left())
}

fn curves(costs: &[&FloorCost], count: impl Fn(RowSize) -> f64, smallest: RowSize) -> Vec<Curve> {
    let slope = |cost: &&FloorCost| (count(cost.size), cost.size.floors() as f64 / smallest.floors() as f64);
    let mut guide: Vec<(f64, f64)> = costs.iter().map(slope).collect();
    guide.sort_by(|one, other| one.0.total_cmp(&other.0));
    guide.dedup();
    let mut curves = vec![Curve::new(CurveKind::Dashed, Shade::Silver, guide).named("Slope one")];
    for (method, shade, mark) in METHODS {
        let own = costs.iter().filter(|cost| cost.method == method);
        let mut points: Vec<_> = own.map(|cost| (count(cost.size), cost.over_smallest)).collect();
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        if !points.is_empty() {
            let curve = Curve::new(CurveKind::Line, shade, points).marked(mark);
            curves.push(curve.named(ComparedMethod::label_of(method)));
        }
    }
    curves
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_all_methods_are_timed() {
        let names: Vec<_> = TimedRow::methods().map(|(name, _)| name).collect();
        assert_eq!(names, METHODS.map(|(name, ..)| name));
    }

    #[test]
    fn limit_a_tower_of_one_storey_stands_in_the_row_of_one_storey() {
        let size = RowSize { storeys: 5, buildings: 6 };
        assert_eq!(size.of_one_storey().floors(), size.floors());
        let [tower, single] = [5, 1].map(|storeys| building(3, storeys, false));
        assert_eq!(tower.storeys[0], single.storeys[0]);
    }
}
