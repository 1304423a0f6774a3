//! A row under motions of several intensities, as sweeps. Motions are scaled to each intensity, or each intensity has other motions.

use std::path::Path;

use pounding_assess::Watched;
use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_risk::{RunNumbers, State, StripeMotion, StripeRun, StripeRuns};
use pounding_scene::file::Contact;
use pounding_scene::{FloorQuantity, Floors, PairQuantity, Quantity, RecordUse, Scene, parallel};
use pounding_text::{RefusalKind, Refused};
use serde_json::json;

use crate::Sweep;
use crate::batch::Batch;
use crate::file::{Directions, Outputs, SceneOf, SweepFile, Vary};
use crate::motions::ScaledSuite;
use crate::spread::Spread;
use crate::stripe_motions::StripeMotions;

/// The questions to a row under motions of several intensities.
#[derive(Debug, Clone, Copy)]
pub struct StripesAsked<'a> {
    /// The row. Its record gives the processing, but neither the motion nor its scale.
    pub scene: &'a Scene,
    /// File of the scene, which messages name.
    pub path: &'a Path,
    /// The motions.
    pub motions: &'a StripeMotions,
    /// Directions in which every motion shakes.
    pub directions: Directions,
    /// The states that are counted.
    pub states: &'a [State],
    /// Whether the widths that gaps need are asked for, besides what the states need.
    pub closings: bool,
}

/// Width of the gaps of a row whose structures stand apart \[m\]. Nothing closes it, and differences to it keep fourteen digits.
const WIDE: f64 = 100.0;

/// Runs of a piece of work.
const AT_A_TIME: u64 = 64;

/// Motions that run at once, with the intensities to which each is scaled; empty if they are as strong as in their files.
struct Part<'a> {
    given: ScaledSuite,
    intensities: &'a [f64],
    /// Index of their first intensity.
    stripe: usize,
    own: Vec<Option<f64>>,
    /// Number of the first event.
    event: usize,
}

impl StripesAsked<'_> {
    /// Runs the row under all motions.
    ///
    /// Gaps are those of the row with all structures apart, by the exact method: neighbours touch if a gap needs more than it has. Drifts and
    /// forces are those of the row as it is, by the method of the scene.
    ///
    /// # Errors
    /// Refuses a row without contacts, states that no run has, and those of [`Sweep::under`]. Of [`RefusalKind::Stopped`] after a stop.
    pub fn run(&self, watched: Watched<'_>) -> Result<StripeRuns, Refused> {
        self.check()?;
        let parts = self.parts()?;
        let [apart, beside] = self.rows();
        let rows = [apart.then(|| self.apart()), beside.then(|| self.beside())];
        let mut runs = StripeRuns {
            gaps: Vec::new(),
            intensities: match self.motions {
                StripeMotions::Scaled { intensities, .. } => intensities.clone(),
                StripeMotions::Own(all) => all.iter().map(|one| one.0).collect(),
            },
            motions: Vec::new(),
            runs: Vec::new(),
            same_events: matches!(self.motions, StripeMotions::Scaled { .. }),
        };
        let sweeps = parts.iter().map(|part| {
            let [apart, beside] = &rows;
            let apart = apart.as_ref().map(|file| self.widths(part, file, watched)).transpose()?;
            let beside = beside.as_ref().map(|file| self.all_runs(part, file, watched)).transpose()?;
            Ok([apart, beside])
        });
        let sweeps: Vec<[Option<Runs>; 2]> = sweeps.collect::<Result<_, Refused>>()?;
        let all = sweeps.iter().flatten().flatten();
        let n_runs = self.n_runs();
        let contacts = all.clone().next().map_or_else(Vec::new, |runs| runs.sweep.row.contacts());
        let own = self.scene.contacts.iter().flatten();
        let gaps: Vec<f64> = own.map(|one| one.gap_m).collect();
        runs.gaps = contacts.iter().map(|contact| gaps[*contact]).collect();
        for (part, sweeps) in parts.iter().zip(&sweeps) {
            let [apart, beside] = [0, 1].map(|row| sweeps[row].as_ref().map(|runs| runs.numbers(n_runs, watched)));
            part.take(self.directions, both(apart.transpose()?, beside.transpose()?), &mut runs);
        }
        for state in self.states {
            Self::says_missing(*state, &runs)?;
        }
        Ok(runs)
    }

    /// A run for every motion, direction and intensity.
    fn all_runs(&self, part: &Part<'_>, file: &SweepFile, watched: Watched<'_>) -> Result<Runs, Refused> {
        let file = varied(file, part.intensities);
        Ok(Runs {
            sweep: Sweep::under(&file, self.path, &part.given, Some(watched.stop))?,
            shares: vec![1.0],
            of_motion: part.n_stripes() as u64,
        })
    }

    /// The runs for the widths that gaps need. Those of a proportional row are proportional to the intensity: the strongest motion suffices.
    fn widths(&self, part: &Part<'_>, file: &SweepFile, watched: Watched<'_>) -> Result<Runs, Refused> {
        let &[_, .., strongest] = part.intensities else {
            return self.all_runs(part, file, watched);
        };
        let runs = Runs {
            sweep: Sweep::under(&varied(file, &[strongest]), self.path, &part.given, Some(watched.stop))?,
            shares: part.intensities.iter().map(|one| one / strongest).collect(),
            of_motion: 1,
        };
        if runs.sweep.first_row().is_some_and(|row| row.is_proportional()) {
            Ok(runs)
        } else {
            self.all_runs(part, file, watched)
        }
    }

    /// Number of all runs: those of the row apart and those of the row as it is.
    pub fn n_runs(&self) -> usize {
        let under = match self.motions {
            StripeMotions::Scaled { suite, intensities, .. } => suite.motions.len() * intensities.len(),
            StripeMotions::Own(all) => all.iter().map(|one| one.1.motions.len()).sum(),
        };
        let rows = self.rows().into_iter().filter(|asked| *asked).count();
        under * self.directions.reversed().len() * rows
    }

    /// Whether the row is asked for with its structures apart, and as it is.
    fn rows(&self) -> [bool; 2] {
        let touch = |state: &State| matches!(state, State::Touch(_));
        [
            self.closings || self.states.iter().any(touch),
            self.states.iter().any(|state| !touch(state)),
        ]
    }

    fn check(&self) -> Result<(), Refused> {
        let n = self.scene.contacts.as_ref().map_or(0, Vec::len);
        if n == 0 {
            let found = Refused::at("contacts").found("none").allowed_are("one or more");
            return Err(found.so(": ", "what stands apart does not touch"));
        }
        let beyond = |state: &State| matches!(state, State::Touch(Some(gap)) if *gap >= n);
        if let Some(state) = self.states.iter().find(|state| beyond(state)) {
            let found = Refused::at("state").found(state.name());
            return Err(found.allowed_are(format!("gaps 1 to {n}")));
        }
        let forces = self.states.iter().any(|state| matches!(state, State::Force(_)));
        if forces && self.scene.is_impulsive() {
            let found = Refused::at("state").found("a force of a law that has impulses alone");
            return Err(found.allowed_is("a compliant law").help("choose one with `pounding laws`"));
        }
        // A scene that gives no floors is refused where it is run.
        let has_gravity = Floors::of(self.scene).map_or(true, |floors| floors.has_gravity());
        if self.states.contains(&State::Collapse) && !has_gravity {
            let found = Refused::at("state").found("collapse of a row on which no gravity acts");
            let found = found.allowed_is("collapse of storeys under a weight");
            return Err(found.help("set p_delta = \"from_masses\" at the top of the scene, or gravity_load_n of its floors"));
        }
        Ok(())
    }

    /// Refuses a state whose number no run has.
    fn says_missing(state: State, runs: &StripeRuns) -> Result<(), Refused> {
        let mut found = runs.runs.iter().filter_map(|run| run.found.as_ref().ok()).peekable();
        let is_missing = found.peek().is_some() && found.all(|numbers| state.is_reached(numbers, &runs.gaps).is_none());
        if !is_missing {
            return Ok(());
        }
        let found = Refused::at("state").found(format!("{}, of which no run has a number", state.name()));
        Err(found
            .allowed_are("states of this row")
            .help("a drift needs height_m of storeys, a shear force columns"))
    }

    fn parts(&self) -> Result<Vec<Part<'_>>, Refused> {
        match self.motions {
            StripeMotions::Scaled {
                suite,
                measure,
                intensities,
            } => {
                let own = parallel::try_each(&suite.motions, |motion| measure.of(motion, self.scene))?;
                let given = ScaledSuite {
                    suite: suite.clone(),
                    factors: own.iter().map(|own| own.recip()).collect(),
                };
                Ok(vec![Part {
                    given,
                    intensities,
                    stripe: 0,
                    own: own.into_iter().map(Some).collect(),
                    event: 0,
                }])
            }
            StripeMotions::Own(all) => {
                let mut event = 0;
                let parts = all.iter().enumerate().map(|(stripe, (_, suite))| {
                    let first = event;
                    event += suite.n_events;
                    let n = suite.motions.len();
                    Part {
                        given: ScaledSuite {
                            suite: suite.clone(),
                            factors: vec![1.0; n],
                        },
                        intensities: &[],
                        stripe,
                        own: vec![None; n],
                        event: first,
                    }
                });
                Ok(parts.collect())
            }
        }
    }

    /// The sweep of the row with its gaps.
    fn beside(&self) -> SweepFile {
        let asks = |of: fn(&State) -> bool| self.states.iter().any(of);
        let quantities = [
            (asks(|one| matches!(one, State::Drift(_))), FloorQuantity::DriftRatio),
            (asks(|one| matches!(one, State::Shear(_))), FloorQuantity::PeakShearForceN),
        ];
        let buildings = quantities.into_iter().filter(|(asked, _)| *asked).map(|(_, quantity)| quantity);
        // A run without any number would have no columns.
        let outputs = Outputs {
            buildings: buildings.collect(),
            neighbours: vec![PairQuantity::Collisions, PairQuantity::PeakForceN],
            ..none()
        };
        self.sweep(self.scene.clone(), outputs)
    }

    /// The sweep of the row with its structures apart.
    fn apart(&self) -> SweepFile {
        let mut scene = self.scene.apart();
        let wide = |one: Contact| Contact {
            gap_m: WIDE,
            // Nothing touches; runs of this law go side by side.
            law: ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.5 }),
            seat_width_m: None,
            ..one
        };
        scene.contacts = scene.contacts.map(|all| all.into_iter().map(wide).collect());
        let outputs = Outputs {
            neighbours: vec![PairQuantity::LeastOpeningM],
            ..none()
        };
        self.sweep(scene, outputs)
    }

    fn sweep(&self, scene: Scene, outputs: Outputs) -> SweepFile {
        let scene = Scene {
            record: RecordUse {
                scale: 1.0,
                scale_to: None,
                ..scene.record
            },
            ..scene
        };
        SweepFile {
            scene: SceneOf::Inline(json!(scene)),
            vary: Vec::new(),
            samples: None,
            records: None,
            directions: Some(self.directions),
            outputs,
            verdict: true,
            budget: None,
            summary: None,
        }
    }
}

/// No output.
fn none() -> Outputs {
    Outputs {
        structures: Vec::new(),
        buildings: Vec::new(),
        pairs: Vec::new(),
        neighbours: Vec::new(),
        links: Vec::new(),
    }
}

/// The sweep with its motions scaled to intensities, if there are any.
fn varied(file: &SweepFile, intensities: &[f64]) -> SweepFile {
    let mut file = file.clone();
    if !intensities.is_empty() {
        file.vary = vec![Vary {
            fields: vec!["record.scale".into()],
            spread: Spread::Values(intensities.iter().map(|one| json!(one)).collect()),
        }];
    }
    file
}

impl Part<'_> {
    fn n_stripes(&self) -> usize {
        self.intensities.len().max(1)
    }

    /// Adds the runs of all motions.
    fn take(&self, directions: Directions, found: Vec<Result<RunNumbers, String>>, to: &mut StripeRuns) {
        let reversed = directions.reversed();
        let first = to.motions.len();
        for (motion, own) in self.given.suite.motions.iter().zip(&self.own) {
            to.motions.extend(reversed.iter().map(|reversed| StripeMotion {
                name: motion.name.clone(),
                reversed: *reversed,
                event: self.event + motion.event,
                own_intensity: *own,
            }));
        }
        to.runs.extend(found.into_iter().enumerate().map(|(run, found)| StripeRun {
            motion: first + run / self.n_stripes(),
            stripe: self.stripe + run % self.n_stripes(),
            found,
        }));
    }
}

/// Runs of a row, in the order of their numbers.
type Found = Vec<Result<RunNumbers, String>>;

/// The runs of a part.
struct Runs {
    sweep: Sweep,
    /// The numbers of each run also hold for motions of these parts of its strength, once their widths are multiplied by it.
    shares: Vec<f64>,
    /// Number of runs of a motion in one direction.
    of_motion: u64,
}

impl Runs {
    /// Runs the sweep in pieces of whole motions, which do not depend on the number of threads.
    fn numbers(&self, n_runs: usize, watched: Watched<'_>) -> Result<Found, Refused> {
        let sweep = &self.sweep;
        let piece = self.of_motion * AT_A_TIME.div_ceil(self.of_motion);
        let pieces: Vec<u64> = (0..sweep.n_runs().div_ceil(piece)).collect();
        let found = parallel::each(&pieces, |index| {
            if sweep.is_stopped() {
                return Vec::new();
            }
            let batch = sweep.batch(index * piece..((index + 1) * piece).min(sweep.n_runs()));
            let of_run = |run: usize| {
                let strongest = sweep.numbers_of(&batch, run);
                self.shares
                    .iter()
                    .map(move |share| strongest.clone().map(|numbers| numbers.of_part(*share)))
            };
            let numbers: Found = (0..batch.failed.len()).flat_map(of_run).collect();
            for _ in &numbers {
                (watched.step)(n_runs);
            }
            numbers
        });
        if sweep.is_stopped() {
            return Err(Refused::that("stopped before all runs were finished").kind(RefusalKind::Stopped));
        }
        Ok(found.into_iter().flatten().collect())
    }
}

impl Sweep {
    /// The numbers of a run of a batch, by its place.
    fn numbers_of(&self, batch: &Batch, run: usize) -> Result<RunNumbers, String> {
        if let Some(reason) = &batch.failed[run] {
            return Err(reason.clone());
        }
        let columns = self.outputs.iter().zip(&batch.columns);
        let of = |quantity: Quantity| {
            let own = columns.clone().filter(move |(output, _)| output.quantity == quantity);
            own.map(|(_, column)| column[run])
        };
        let largest = |quantity: Quantity| {
            let numbers = of(quantity).map(f64::abs).filter(|number| !number.is_nan());
            numbers.reduce(f64::max)
        };
        let touches = of(PairQuantity::Collisions.into()).next().is_some();
        let required = of(PairQuantity::LeastOpeningM.into()).map(|opening| (WIDE - opening).max(0.0));
        Ok(RunNumbers {
            required: required.collect(),
            drift: largest(FloorQuantity::DriftRatio.into()),
            force: touches.then(|| largest(PairQuantity::PeakForceN.into()).unwrap_or(0.0)),
            shear: largest(FloorQuantity::PeakShearForceN.into()),
            collapsed: largest(FloorQuantity::CollapseS.into()).is_some(),
        })
    }
}

/// The numbers of the row apart and as it is, if both are known; a run fails if either does.
fn both(apart: Option<Found>, beside: Option<Found>) -> Found {
    match (apart, beside) {
        (Some(apart), Some(beside)) => {
            let joined = |(apart, beside): (Result<RunNumbers, String>, Result<RunNumbers, String>)| {
                Ok(RunNumbers {
                    required: apart?.required,
                    ..beside?
                })
            };
            apart.into_iter().zip(beside).map(joined).collect()
        }
        (apart, beside) => apart.or(beside).unwrap_or_default(),
    }
}
