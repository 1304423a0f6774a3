//! The files of a results folder, in memory: histories, impacts, a summary for machines, figures, and a page to forward.
//!
//! They name neither the machine nor the day: the same scene gives the same bytes.
//!
//! ```
//! use pounding_report::Report;
//! use pounding_scene::{Scene, Simulation};
//!
//! let text = r#"
//!     name = "a tower beside a wall, shaken by half a sine of half the tower's period"
//!     record.generated.half_sine = { amplitude_m_per_s2 = -4.0, duration_s = 0.5, time_step_s = 0.001 }
//!     structures = [{ sdof = { name = "tower", mass_kg = 1e5, period_s = 1.0, damping.ratio = 0 } }, { wall = {} }]
//!     contacts = [{ gap_m = 0.2, law.stereomechanical.restitution = 0.65 }]"#;
//! let simulation = Simulation::new(&Scene::parse(text.as_bytes(), "tower.toml".as_ref())?, "")?;
//! let report = Report::of(&simulation, false)?;
//! assert!(report.files().contains_key("report.html"));
//!
//! // The peak is (π/2) A/ω² = A T²/(8π) = 159.155 mm at T/2: 40.845 mm of the gap stay open.
//! let opening = report.summary().pairs[0].least_opening();
//! assert!((opening - 0.040845).abs() < 1e-6);
//! # Ok::<(), pounding_scene::Error>(())
//! ```
//!
//! Left out: the scene and its run (`pounding-scene`), drawing (`pounding-plot`), writing to a disk (the program in `pounding`), tables of
//! sweeps (`pounding-sweep`).
//!
//! Where to start:
//!
//! - [`Report::files`]: the list of files and what each holds.
//! - [`Summary`]: every number of a run under its name with its unit; `summary.json` reads back into it.
//! - [`AssessmentReport`]: the folder of a row under many records.
//! - [`RiskReport`]: the folder of a row under motions of several intensities.
//! - `page/` and `figures/` in the source: the parts of `report.html`.

mod advice;
mod animation;
mod answer;
mod assessment;
mod assumed;
mod blow;
mod certificate;
mod direction;
mod figures;
mod folder;
mod gaps;
mod header;
mod history;
mod impacts;
mod motion;
mod names;
mod not_modelled;
mod opensees;
mod page;
mod player;
mod risk;
mod row;
mod rules;
mod sampling;
mod shown;
mod site;
mod sketch;
mod spectra;
mod summary;
mod whatever_gap;

use std::collections::BTreeMap;
use std::sync::Arc;

pub use advice::advice_answer;
pub use animation::Animation;
pub use answer::{damping_facts, method_facts, record_facts};
pub use assessment::{AssessedMotion, AssessmentReport, FolderOfMotions, ScalingAsked};
pub use assumed::link_parameters;
pub use blow::Blow;
pub use certificate::certificate;
pub use direction::{BothDirections, OffSeat, other_direction, other_direction_exact, run_sentence};
use figures::{Illustration, Known};
pub use folder::{MotionRow, OfFolder, UnderMotion, said_briefly};
pub use gaps::{GapsUnderMotion, gaps_answer, gaps_table};
pub use header::HeaderFacts;
use history::Motion;
pub use history::{HistoryQuantity, history_of};
pub use impacts::collision_table;
pub use motion::MeasuredRecord;
pub use opensees::{OpenSees, OpenSeesError};
pub use page::STYLE;
pub use player::Player;
use pounding_assess::Effects;
use pounding_files::ResultNames;
use pounding_scene::{BetweenSamples, Error, Review, RunResult, Simulation};
pub use risk::{JudgedRun, RiskAsked, RiskReport};
use sampling::Sampling;
pub use shown::{InWords, tables};
pub use site::{Site, SitedNumber};
pub use sketch::Sketch;
pub use spectra::{
    SpectraLabels, ductility_columns, ductility_table, fourier_table, pair_spectra_table, pair_spectral_columns, spectra_figure,
    spectra_table, spectral_columns,
};
pub use summary::{
    CollapseSummary, CollisionSummary, ErrorSummary, LedgerSummary, LinkSummary, MethodSummary, Numbers, PairErrorSummary, PairSummary,
    ReadingSummary, RecordSummary, SCHEMA_VERSION, StructureSummary, Summary, WorkSummary,
};

/// A run with its histories, ready to be written to a folder.
#[derive(Debug)]
pub struct Report<'a> {
    prepared: &'a Simulation,
    review: Arc<Review>,
    sampling: Sampling,
    effects: Option<Effects>,
    directions: Option<BothDirections>,
    between_samples: Option<Result<BetweenSamples, Error>>,
}

impl<'a> Report<'a> {
    /// Runs a scene as [`Simulation::review`] does, and keeps the histories of its structures.
    ///
    /// # Errors
    /// Those of [`Simulation::review`].
    pub fn of(prepared: &'a Simulation, measure: bool) -> Result<Self, Error> {
        let interval = Self::interval(prepared);
        let review = prepared.review_recorded(measure, Some(interval))?;
        Ok(Self::of_review(prepared, Arc::new(review)))
    }

    /// A report of a run that kept histories with a state every [`interval`](Self::interval).
    pub fn of_review(prepared: &'a Simulation, review: Arc<Review>) -> Self {
        Self {
            prepared,
            review,
            sampling: Sampling::of(prepared),
            effects: None,
            directions: None,
            between_samples: None,
        }
    }

    /// Time between two states of the histories of a report \[s\].
    pub fn interval(prepared: &Simulation) -> f64 {
        Sampling::of(prepared).interval
    }

    /// Returns the report with the effects of pounding on every storey.
    #[must_use]
    pub fn with_effects(self, effects: Option<Effects>) -> Self {
        Self { effects, ..self }
    }

    /// Returns the report with both directions of shaking on the first page; `other` is the run in the other direction than the scene's.
    #[must_use]
    pub fn with_other_direction(self, other: Result<RunResult, Error>) -> Self {
        let directions = BothDirections::of(self.prepared, &self.review, other);
        Self {
            directions: Some(directions),
            ..self
        }
    }

    /// Returns the report with how far its numbers hang on the record between its samples; see [`Simulation::between_samples`].
    #[must_use]
    pub fn with_between_samples(self) -> Self {
        let between_samples = self.prepared.between_samples(&self.review.outcome);
        Self { between_samples, ..self }
    }

    /// The results of both directions of shaking, if the other one ran.
    pub fn directions(&self) -> Option<&BothDirections> {
        self.directions.as_ref()
    }

    /// What to know before believing the run, or the runs in both directions, the most harmful first.
    pub fn notices(&self) -> Vec<String> {
        let of_both = self.directions.as_ref().map(|both| both.notices.clone());
        of_both.unwrap_or_else(|| self.review.notices())
    }

    /// The run in the other direction than the scene's, if it is known.
    fn other(&self) -> Option<&RunResult> {
        self.directions.as_ref()?.other.as_ref()
    }

    /// The run with its errors, if they are known.
    pub fn review(&self) -> &Review {
        &self.review
    }

    /// The first screen of [`answer`](Self::answer) as markup for a page.
    pub fn first_screen(&self) -> String {
        page::answer::first_screen(&self.answer())
    }

    /// What came out, for machines.
    pub fn summary(&self) -> Summary {
        Summary {
            effects: self.effects.clone(),
            between_samples: self.between_samples.as_ref().and_then(|found| found.as_ref().ok().copied()),
            warnings: self.notices(),
            ..Summary::of(self.prepared, &self.review)
        }
    }

    /// The files of a results folder, by name:
    ///
    /// | File | Holds |
    /// |---|---|
    /// | `report.html` | everything, for people; it needs no other file |
    /// | `summary.json` | [`Summary`] |
    /// | `history.csv` | motion and forces over time; accelerations are absolute, gaps are open widths |
    /// | `impacts.csv` | a line per collision |
    /// | `effects.csv` | effects of pounding on every storey, if asked for |
    /// | `animation.svg` | the buildings around the hardest collision, in slow motion, if something touches |
    /// | `*.svg`, `*.png` | the figures of the report |
    pub fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let (prepared, outcome) = (self.prepared, &self.review.outcome);
        let travel = prepared.travel();
        let motion = Motion::of(prepared, travel.as_ref(), outcome);
        let summary = self.summary();
        let known = Known {
            effects: self.effects.as_ref(),
            other: self.other(),
        };
        let illustrations = figures::illustrations(motion, outcome, &summary.pairs, known);
        let animation = Animation::of_run(prepared, outcome);
        let moving = animation.as_ref().map_or_else(String::new, Animation::figure);
        let page = page::html(self, &illustrations, &moving);
        let mut files = BTreeMap::from([
            (HISTORY.into(), history::csv(prepared, &motion).into_bytes()),
            (
                IMPACTS.into(),
                collision_table(prepared.floors(), outcome.collisions.all().iter(), String::new())
                    .csv()
                    .into_bytes(),
            ),
            (SUMMARY.into(), summary.to_json().into_bytes()),
            (PAGE.into(), page.into_bytes()),
        ]);
        if let Some(effects) = &self.effects {
            files.insert(EFFECTS.into(), effects.to_csv(prepared.scene(), prepared.floors()).into_bytes());
        }
        if let Some(animation) = animation {
            files.insert(animation::FILE.into(), animation.svg.into_bytes());
        }
        files.extend(Illustration::files(illustrations));
        files
    }

    /// Whether a results folder can have a file of this name.
    pub fn has_file(name: &str) -> bool {
        [HISTORY, IMPACTS, EFFECTS, SUMMARY, PAGE, animation::FILE].contains(&name) || Illustration::has_file(&figures::NAMES, name)
    }
}

/// The files of a run under a folder of records: the lines for programs, and for people.
pub const FILES_OF_RECORDS: [&str; 3] = ["runs.csv", "runs.json", "runs.txt"];

/// What tells a folder of results from any other.
pub const RESULT_NAMES: ResultNames = ResultNames {
    has: |name| {
        Report::has_file(name) || AssessmentReport::has_file(name) || RiskReport::has_file(name) || FILES_OF_RECORDS.contains(&name)
    },
    marks: &[SUMMARY, FILES_OF_RECORDS[1], assessment::JSON, risk::JSON],
};

const HISTORY: &str = "history.csv";
const IMPACTS: &str = "impacts.csv";
const EFFECTS: &str = "effects.csv";
const SUMMARY: &str = "summary.json";
const PAGE: &str = "report.html";

impl Summary {
    /// As JSON, with a line break at the end.
    ///
    /// # Panics
    /// Never: a summary is made of text and numbers.
    pub fn to_json(&self) -> String {
        pounding_text::json_text(self)
    }
}
