//! A scene with its run.

use std::path::PathBuf;
use std::sync::Arc;

use pounding_report::{
    BothDirections, HistoryQuantity, LinkSummary, PairSummary, Report, Sketch, StructureSummary, Summary, collision_table, history_of, other_direction,
    run_sentence,
};
use pounding_scene::{Error, FloorQuantity, Implausible, LinkQuantity, PairQuantity, QuantityKind, Review, Scene, Simulation, SimulationOptions};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;

use crate::array::Array;
use crate::record::Record;
use crate::refused::OrRefused;
use crate::table::{Column, Table};
use crate::waiting::{Watch, wait};

/// A scene in the words of a file, with the settings for reading it.
pub(crate) struct Given<'a> {
    /// The scene as JSON or TOML.
    pub(crate) text: &'a str,
    /// The file of the scene; if there is none, a path in the folder that names its record.
    pub(crate) path: PathBuf,
    /// The record that replaces the scene's own.
    pub(crate) record: Option<&'a Record>,
    /// Whether a run that would be refused runs with a warning.
    pub(crate) force: bool,
}

impl<'a> Given<'a> {
    /// A scene that is refused if the program refuses it.
    pub(crate) fn of(text: &'a str, path: PathBuf, record: Option<&'a Record>) -> Self {
        Self {
            text,
            path,
            record,
            force: false,
        }
    }

    /// The scene. If it is in a file, a fault has its line.
    pub(crate) fn scene(&self) -> Result<Scene, Error> {
        Scene::parse(self.text.as_bytes(), &self.path)
    }

    /// The error with the file of the scene, if there is one.
    pub(crate) fn in_file(&self, error: Error) -> Error {
        if self.path.is_file() { error.in_file(&self.path) } else { error }
    }

    /// The scene, prepared.
    pub(crate) fn simulation(&self, watch: &Watch) -> Result<Simulation, Error> {
        self.simulation_of(&self.scene()?, watch)
    }

    /// Another scene under the record of this one, prepared.
    pub(crate) fn simulation_of(&self, scene: &Scene, watch: &Watch) -> Result<Simulation, Error> {
        let step = |of: usize| watch.step(1, of as u64);
        let options = SimulationOptions {
            base: self.path.parent(),
            motion: self.record.map(|record| record.motion.clone()),
            force: self.force,
            stop: Some(watch.stop),
            progress: Some(&step),
        };
        Simulation::new(scene, options).map_err(|error| self.in_file(error))
    }
}

/// A run of a scene with its results.
#[pyclass(frozen, module = "pounding._pounding")]
pub(crate) struct Run {
    simulation: Simulation,
    review: Arc<Review>,
}

/// Runs a scene with its histories. `measure` also runs the exact method, for the errors.
///
/// `text` is the scene as JSON or TOML, `path` its file, and `record` replaces the record that it names.
#[pyfunction]
#[pyo3(signature = (text, path, record=None, measure=true, full=false, force=false))]
pub(crate) fn run(
    py: Python<'_>,
    text: &str,
    path: PathBuf,
    record: Option<&Record>,
    measure: bool,
    full: bool,
    force: bool,
) -> PyResult<Run> {
    let given = Given {
        force,
        ..Given::of(text, path, record)
    };
    let ran = wait(py, None, |watch| -> Result<Run, Error> {
        let simulation = given.simulation(watch)?;
        let mut simulation = if full { simulation.full()? } else { simulation };
        let interval = Report::interval(&simulation);
        let review = simulation.review_recorded(measure, Some(interval));
        let review = review.map_err(|error| given.in_file(error))?;
        // The next user of the flag stops other work, so this run must not keep it.
        simulation.set_stop(None);
        Ok(Run {
            simulation,
            review: Arc::new(review),
        })
    })?;
    ran.or_refused(py)
}

/// Numbers whose errors are in the table of peaks.
const ERRORS: [FloorQuantity; 3] = [
    FloorQuantity::PeakDisplacementM,
    FloorQuantity::PeakAccelerationMPerS2,
    FloorQuantity::TransferredMomentumNS,
];

/// A column with a name, if any row has such a number.
fn column(name: String, numbers: impl Iterator<Item = Option<f64>>) -> Option<(String, Column)> {
    let numbers: Vec<_> = numbers.collect();
    let is_known = numbers.iter().any(Option::is_some);
    is_known.then(|| (name, Column::numbers(numbers)))
}

impl Run {
    fn report(&self) -> Report<'_> {
        Report::of_review(&self.simulation, Arc::clone(&self.review))
    }

    /// Table with one row per floor and wall.
    fn peaks(&self) -> Table {
        let floors = self.simulation.floors();
        let all = 0..floors.all().len();
        let structures = StructureSummary::of_run(&self.simulation, &self.review);
        let numbers = FloorQuantity::ALL.iter().filter_map(|one| {
            let numbers = structures.iter().map(|structure| structure.numbers.get(*one));
            column(one.about().name.into(), numbers)
        });
        let errors = ERRORS.iter().filter_map(|one| {
            let errors = structures.iter().map(|structure| structure.errors.as_ref()?.get(*one));
            column(format!("errors_{}", one.about().error_name()?), errors)
        });
        let name = |index: usize| floors.all()[index].name.clone();
        let buildings = &self.simulation.scene().structures;
        let building = |index: usize| buildings[floors.all()[index].structure].name().to_owned();
        let counts = |count: &dyn Fn(usize) -> usize| Column::Counts(all.clone().map(|index| count(index) as u64).collect());
        let first = [
            ("structure".to_owned(), counts(&|index| floors.all()[index].structure)),
            ("storey".to_owned(), counts(&|index| floors.storey_of(index))),
            ("building".to_owned(), Column::texts(all.clone().map(building))),
            ("name".to_owned(), Column::texts(all.clone().map(name))),
        ];
        Table::new(first.into_iter().chain(numbers).chain(errors))
    }

    /// Storey at which a pair of floors faces each other.
    fn level(&self, pair: usize) -> u64 {
        let floors = self.simulation.floors();
        let one = &floors.facing()[pair];
        let is_wall = floors.all()[one.left].is_wall();
        floors.storey_of(if is_wall { one.right } else { one.left }) as u64
    }

    /// Table with one row per pair of floors that face each other.
    fn pairs(&self) -> Table {
        let floors = self.simulation.floors();
        let facing = floors.facing();
        let pairs = PairSummary::of_run(&self.simulation, &self.review);
        let first = [
            (
                "contact".to_owned(),
                Column::Counts(facing.iter().map(|one| one.contact as u64).collect()),
            ),
            (
                "level".to_owned(),
                Column::Counts((0..facing.len()).map(|pair| self.level(pair)).collect()),
            ),
            ("left".to_owned(), Column::texts(pairs.iter().map(|pair| pair.left.clone()))),
            ("right".to_owned(), Column::texts(pairs.iter().map(|pair| pair.right.clone()))),
            ("law".to_owned(), Column::texts(pairs.iter().map(|pair| pair.law.clone()))),
            (
                "collisions".to_owned(),
                Column::Counts(pairs.iter().map(|pair| pair.collisions() as u64).collect()),
            ),
        ];
        let numbers = PairQuantity::ALL.iter().filter(|one| one.about().kind != QuantityKind::Count);
        let numbers = numbers.filter_map(|one| column(one.about().name.into(), pairs.iter().map(|pair| pair.number(*one))));
        Table::new(first.into_iter().chain(numbers))
    }

    /// Table with one row per link.
    fn links(&self) -> Table {
        let links = LinkSummary::of_run(&self.simulation, &self.review);
        let texts = |of: fn(&LinkSummary) -> &String| Column::texts(links.iter().map(|link| of(link).clone()));
        let first = [
            ("left".to_owned(), texts(|link| &link.left)),
            ("right".to_owned(), texts(|link| &link.right)),
            ("law".to_owned(), texts(|link| &link.law)),
        ];
        let numbers = LinkQuantity::ALL.iter();
        let numbers = numbers.filter_map(|one| column(one.about().name.into(), links.iter().map(|link| link.numbers.get(*one))));
        Table::new(first.into_iter().chain(numbers))
    }

    /// Table with one row per collision, in the order of their starts.
    fn impacts(&self) -> Table {
        let floors = self.simulation.floors();
        let collisions = self.review.outcome.collisions.all().iter();
        let table = collision_table(floors, collisions, String::new())
            .column("contact", |one| floors.facing()[one.pair].contact)
            .column("level", |one| self.level(one.pair));
        Table::of_found(&table)
    }
}

#[pymethods]
impl Run {
    /// All results, as the JSON of `pounding run --json`.
    fn summary(&self) -> String {
        Summary::of(&self.simulation, &self.review).to_json()
    }

    /// Warnings about the numbers, the most harmful first.
    fn notices(&self) -> Vec<String> {
        self.review.notices()
    }

    /// The table `peaks`, `pairs`, `links` or `impacts`.
    fn table(&self, name: &str) -> PyResult<Table> {
        match name {
            "peaks" => Ok(self.peaks()),
            "pairs" => Ok(self.pairs()),
            "links" => Ok(self.links()),
            "impacts" => Ok(self.impacts()),
            _ => Err(PyKeyError::new_err(format!(
                "found `{name}`, allowed are `peaks`, `pairs`, `links`, `impacts`"
            ))),
        }
    }

    /// A history by its name, with one row per floor or pair and one column per instant.
    fn history(&self, py: Python<'_>, name: &str) -> PyResult<Array> {
        let quantity = HistoryQuantity::ALL.into_iter().find(|one| one.name() == name);
        let quantity = quantity.ok_or_else(|| PyKeyError::new_err(name.to_owned()))?;
        let rows = py.detach(|| history_of(&self.simulation, &self.review.outcome, quantity));
        Ok(Array::rows(&rows))
    }

    /// Time between two instants of a history [s].
    #[getter]
    fn interval(&self) -> f64 {
        Report::interval(&self.simulation)
    }

    /// Duration of the run [s].
    #[getter]
    fn duration(&self) -> f64 {
        self.simulation.duration()
    }

    /// A sentence on how often and how hard floors touch.
    fn sentence(&self) -> String {
        run_sentence(&self.simulation, &self.review.outcome)
    }

    /// Implausible values of the scene and of its record, one sentence per kind.
    fn unusual(&self) -> Vec<String> {
        Implausible::lines(self.simulation.doubts().iter().map(|one| ("", one)))
    }

    /// Sentences for both directions of shaking, the worse one first, and warnings about both. The other direction runs in this call.
    fn directions(&self, py: Python<'_>) -> PyResult<([String; 2], Vec<String>)> {
        wait(py, None, |watch| {
            let mut simulation = self.simulation.clone();
            simulation.set_stop(Some(watch.stop));
            let other = other_direction(&simulation);
            let both = BothDirections::of(&self.simulation, &self.review, other);
            (both.sentences, both.notices)
        })
    }

    /// The row as SVG, with floors that touch in orange.
    fn sketch(&self, py: Python<'_>) -> PyResult<String> {
        let floors = self.simulation.floors();
        let pairs = self.review.outcome.collisions.all().iter();
        let facing = pairs.map(|one| floors.facing()[one.pair]);
        let touched: Vec<usize> = facing.flat_map(|one| [one.left, one.right]).collect();
        let sketch = Sketch {
            scene: self.simulation.scene(),
            floors,
            touched: &touched,
        };
        sketch.svg().map_err(|error| error.to_string()).or_refused(py)
    }

    /// The files of a report by name. `both` puts both directions of shaking on its first page.
    fn files(&self, py: Python<'_>, both: bool) -> PyResult<std::collections::BTreeMap<String, Vec<u8>>> {
        wait(py, None, |watch| {
            let report = self.report().with_between_samples();
            if !both {
                return report.files();
            }
            let mut simulation = self.simulation.clone();
            simulation.set_stop(Some(watch.stop));
            let other = other_direction(&simulation);
            report.with_other_direction(other).files()
        })
    }
}
