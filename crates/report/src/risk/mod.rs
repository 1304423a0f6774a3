//! A row under motions of several intensities, as an answer and as a folder.

mod answer;
mod cautions;
mod figures;

use std::collections::BTreeMap;

use pounding_assess::{IntensityMeasure, Suite};
use pounding_risk::{HazardCurve, Risk, State, Stripe, StripeRuns};
use pounding_scene::{Scene, parallel};
use pounding_text::{Form, Refused, digits};

use crate::figures::Illustration;

pub use cautions::JudgedRun;

/// The states of a row under motions of several intensities, and how often it reaches them.
#[derive(Debug)]
pub struct RiskReport<'a> {
    scene: &'a Scene,
    /// The folders of records.
    suites: Vec<&'a Suite>,
    /// How the intensity of motions is measured; `None` if intensities are those of folders.
    measure: Option<IntensityMeasure>,
    runs: &'a StripeRuns,
    hazard: Option<&'a HazardCurve>,
    /// The states in the order in which they were asked for; one or more.
    states: Vec<(State, Risk)>,
    /// Touching by the width of all gaps \[m\].
    by_gap: Vec<(f64, Risk)>,
    /// What the model leaves out or cannot bear, in sentences.
    cautions: Vec<String>,
}

/// The questions to runs.
#[derive(Debug, Clone, Copy)]
pub struct RiskAsked<'a> {
    /// The states; one or more.
    pub states: &'a [State],
    /// Widths of all gaps for which touching is told \[m\].
    pub gaps: &'a [f64],
    /// How often motions of the site exceed an intensity.
    pub hazard: Option<&'a HazardCurve>,
    /// How the intensity of motions is measured; `None` if intensities are those of folders.
    pub measure: Option<IntensityMeasure>,
}

impl<'a> RiskReport<'a> {
    /// Sums up the runs of a scene under the records of some folders. If a run collapses, that is a further state.
    pub fn of(scene: &'a Scene, suites: Vec<&'a Suite>, runs: &'a StripeRuns, asked: RiskAsked<'a>) -> Self {
        let mut states = asked.states.to_vec();
        if runs.n_collapsed() > 0 && !states.contains(&State::Collapse) {
            states.push(State::Collapse);
        }
        let of_state = |state: &State| (*state, Risk::of(runs.stripes_of(*state), asked.hazard));
        let of_gap = |gap: &f64| (*gap, Risk::of(runs.stripes_with_gaps(*gap), asked.hazard));
        Self {
            scene,
            suites,
            measure: asked.measure,
            runs,
            hazard: asked.hazard,
            states: parallel::each(&states, of_state),
            by_gap: parallel::each(asked.gaps, of_gap),
            cautions: Vec::new(),
        }
    }

    /// Why the fragility or the frequency of the first state is not known; `None` if both are.
    pub fn refused(&self) -> Option<&Refused> {
        self.states.first().and_then(|(_, risk)| risk.refused())
    }

    /// The files of a folder by name.
    pub fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let answer = self.answer();
        let texts = [Form::Details, Form::Csv, Form::Json].map(|form| answer.text(form));
        let mut files: BTreeMap<String, Vec<u8>> = [TEXT, RUNS, JSON]
            .into_iter()
            .zip(texts)
            .map(|(name, text)| (name.to_owned(), text.into_bytes()))
            .collect();
        files.insert(STRIPES.into(), self.stripes_table().csv().into_bytes());
        files.extend(Illustration::files(figures::all(self)));
        files
    }

    /// Whether a folder of stripes can have a file of this name.
    pub fn has_file(name: &str) -> bool {
        [TEXT, RUNS, JSON, STRIPES].contains(&name) || Illustration::has_file(&figures::NAMES, name)
    }

    /// The measure of intensity in words.
    fn measured(&self) -> String {
        self.measure.map_or_else(|| "intensity".into(), |measure| measure.to_string())
    }
}

/// The number that a state limits, in words.
struct Demand {
    /// Name of its column.
    column: &'static str,
    /// Label of its axis, in the unit that people read.
    label: &'static str,
    /// How many of these units are one SI unit.
    factor: f64,
}

impl Demand {
    /// The number of a state; `None` of a collapse.
    fn of(state: State) -> Option<Self> {
        let (column, label, factor) = match state {
            State::Touch(_) => ("required_m", "Width that the gap needs (mm)", 1e3),
            State::Drift(_) => ("drift_ratio", "Largest drift (%)", 100.0),
            State::Force(_) => ("peak_force_n", "Largest force (kN)", 1e-3),
            State::Shear(_) => ("peak_shear_force_n", "Largest shear force (kN)", 1e-3),
            State::Collapse => return None,
        };
        Some(Self { column, label, factor })
    }
}

const TEXT: &str = "ida.txt";
const RUNS: &str = "ida.csv";
pub(crate) const JSON: &str = "ida.json";
const STRIPES: &str = "stripes.csv";

/// How many events of a stripe exceed the state.
fn counted(stripe: &Stripe) -> String {
    format!("{} of {}", digits((stripe.exceeding() * 100.0).round() / 100.0), stripe.n())
}

/// A number with three significant digits, without zeros at its end: fragilities are known to one or two.
fn three(value: f64) -> String {
    digits(format!("{value:.2e}").parse().unwrap_or(value))
}
