//! Runs of a simulation: their recorders, and their errors.

use std::ops::Range;

use pounding_solver::{
    BesideColumn, Clock, Closings, Collisions, DriftRates, Excitation, FloorAccelerations, Histories, Integrator, LastStates, Ledger,
    LedgerError, LinkPeaks, OnRow, Opening, Pair, Peak, Peaks, Recorder, Recorders, RunError, Terms, TransferredMomentum, Travel, Work,
};

use super::Simulation;
use crate::settings::out_of_range;
use crate::{Collapse, ColumnBeside, Error, Method, Structure};
use pounding_text::{RefusalKind, Refused, digits, percent, short};

/// Number of looks at a motion in the shortest natural period, unless its series allows fewer; see [`Closings`].
const LOOKS_PER_PERIOD: f64 = 200.0;

/// Results of a run.
#[derive(Debug, Clone)]
pub struct RunResult {
    /// Peaks of every structure.
    pub peaks: Peaks,
    /// Collisions of every pair.
    pub collisions: Collisions,
    /// Transferred momentum of every structure.
    pub momentum: TransferredMomentum,
    /// Peak absolute accelerations of every floor \[m/s²\]. Impulsive impacts, whose acceleration has no bound, are left out.
    pub accelerations: Vec<Peak>,
    /// Peaks of every link; `None` if the row has none.
    pub links: Option<LinkPeaks>,
    /// Energy that every link took \[J\]; empty for runs without a ledger.
    pub link_energies: Vec<f64>,
    /// State of every floor at the end.
    pub last: LastStates,
    /// Largest closing between neighbours; `None` if it was not asked for.
    pub closings: Option<Closings>,
    /// Peak drift rates of every storey; `None` if they were not asked for.
    pub drift_rates: Option<DriftRates>,
    /// Histories of every structure; `None` if they were not asked for.
    pub histories: Option<Histories>,
    /// The collapse that ended the run before its duration; `None` if all storeys stand.
    pub collapse: Option<Collapse>,
    /// Work of the run.
    pub work: Work,
}

/// A run with the verdict of its ledger.
#[derive(Debug)]
pub struct AuditedRun {
    /// Results of the run.
    pub outcome: RunResult,
    /// Error if it breaks a law of mechanics.
    pub broken: Option<Error>,
    /// Terms of its energy.
    pub balance: EnergyBalance,
}

/// Terms of the energy of a run, and the error of their sum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyBalance {
    /// Terms of the row at the end \[J\].
    pub terms: Terms,
    /// Energy that the physical balance leaves unexplained, relative to the scale \[–\]; see [`Ledger::residual`].
    pub residual: f64,
    /// Scale of the energies \[J\]; see [`Ledger::scale`].
    pub scale: f64,
}

/// Optional recordings of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Extras {
    /// Interval between the states of histories \[s\]; `None` for no histories.
    pub interval: Option<f64>,
    /// Largest closing between neighbours.
    pub closings: bool,
    /// Largest opening between neighbours, which is the closing under mirrored shaking; see [`Closings::both_ways`].
    pub reversed_closings: bool,
    /// Peak drift rates, from which the forces of dampers follow.
    pub drift_rates: bool,
}

impl Extras {
    /// Everything that [`RunErrors`](crate::RunErrors) compares.
    pub const COMPARED: Self = Self {
        interval: None,
        closings: true,
        reversed_closings: true,
        drift_rates: false,
    };
}

impl Simulation {
    /// Takes the results from recorders.
    fn result(&self, recorders: Recorders<'_, '_>, work: Work) -> RunResult {
        let accelerations = recorders.accelerations.map(FloorAccelerations::into_peaks);
        RunResult {
            collapse: recorders.peaks.fallen().map(|fallen| self.collapse(fallen)),
            peaks: recorders.peaks,
            collisions: recorders.collisions,
            momentum: recorders.momentum,
            accelerations: accelerations.unwrap_or_default(),
            links: recorders.links,
            link_energies: Vec::new(),
            last: recorders.last.unwrap_or_else(|| LastStates::new(0)),
            closings: recorders.closings,
            drift_rates: recorders.drift_rates,
            histories: recorders.histories,
            work,
        }
    }
}

impl Simulation {
    /// Runs the scene, with histories of a state every `interval` \[s\] if it is given.
    ///
    /// # Errors
    /// Errors of [`run_with`](Self::run_with).
    pub fn run(&self, interval: Option<f64>) -> Result<RunResult, Error> {
        self.run_with(Extras {
            interval,
            ..Extras::default()
        })
    }

    /// Runs the scene with optional recordings.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early, [`Error::Broken`] if it breaks a law of mechanics, however slightly: this method gives no
    /// warnings.
    pub fn run_with(&self, asked: Extras) -> Result<RunResult, Error> {
        let AuditedRun { outcome, broken, .. } = self.audited_with(asked)?;
        broken.map_or(Ok(outcome), Err)
    }

    /// Runs the scene and returns the verdict of its ledger with the results.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early.
    pub fn audited(&self, interval: Option<f64>) -> Result<AuditedRun, Error> {
        let asked = Extras {
            interval,
            ..Extras::default()
        };
        self.audited_with(asked)
    }

    /// Runs the scene with optional recordings, and returns the verdict of its ledger with the results.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early.
    pub fn audited_with(&self, asked: Extras) -> Result<AuditedRun, Error> {
        let mut ledger = self.ledger().held_to(self.integrator.laws());
        let mut recorders = self.recorders(asked);
        recorders.ledger = Some(&mut ledger);
        let work = self.integrate(&mut recorders)?;
        let mut outcome = self.result(recorders, work);
        let links = 0..self.row.links().len();
        outcome.link_energies = links.map(|link| ledger.of_link(link).energy).collect();
        Ok(AuditedRun {
            outcome,
            broken: ledger.verdict().err().map(|source| self.broke(source)),
            balance: EnergyBalance {
                terms: ledger.terms(),
                residual: ledger.residual(),
                scale: ledger.scale(),
            },
        })
    }

    /// Runs the scene without a ledger, for timings and for runs that are judged elsewhere. In the exact method a ledger takes nearly half
    /// of the time.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early.
    pub fn run_unjudged(&self, asked: Extras) -> Result<RunResult, Error> {
        let mut recorders = self.recorders(asked);
        let work = self.integrate(&mut recorders)?;
        Ok(self.result(recorders, work))
    }

    /// Records a run that `run` makes in another way than the scene's method, with histories as in [`run`](Self::run).
    ///
    /// # Errors
    /// [`Error::Run`] if it ends early.
    pub fn recorded(
        &self,
        interval: Option<f64>,
        run: impl FnOnce(&mut Recorders<'_, '_>) -> Result<Work, RunError>,
    ) -> Result<RunResult, Error> {
        let mut recorders = self.recorders(Extras {
            interval,
            ..Extras::default()
        });
        let work = run(&mut recorders).map_err(|source| self.ended(source))?;
        Ok(self.result(recorders, work))
    }

    /// The collapse that ended a run, in a sentence without a full stop; `None` if all storeys stand.
    pub fn says_collapse(&self, result: &RunResult) -> Option<String> {
        let collapse = result.collapse?;
        Some(format!(
            "{} collapses under gravity: at t = {:.4} s its drift passes {} of its height, and the run ends",
            self.floors.storey_name(collapse.floor),
            collapse.time_s,
            percent(self.scene.collapse_drift())
        ))
    }

    /// Empty recorders of everything that was asked for.
    fn recorders<'l>(&self, asked: Extras) -> Recorders<'l, '_> {
        let n = self.floors.all().len();
        let duration = self.clock.time(self.clock.n_steps);
        let closings = || {
            if asked.reversed_closings {
                self.closings().both_ways().seated(self.seats())
            } else {
                self.closings()
            }
        };
        let accelerations = FloorAccelerations::new(n, self.excitation());
        Recorders {
            accelerations: Some(accelerations.travelled(self.travel().as_ref())),
            last: Some(LastStates::new(n)),
            closings: asked.closings.then(closings),
            drift_rates: asked.drift_rates.then(|| DriftRates::new(n)),
            histories: asked.interval.map(|interval| Histories::new(n, interval, duration)),
            ..self.usual_recorders()
        }
    }

    /// Empty recorders for the printed numbers of floors and pairs.
    fn usual_recorders<'l>(&self) -> Recorders<'l, '_> {
        let mut recorders = Recorders::usual(self.floors.all().len(), self.pairs());
        recorders.collisions = recorders.collisions.travelled(self.travel());
        let links = self.row.links();
        recorders.links = (!links.is_empty()).then(|| LinkPeaks::new(links).travelled(self.travel()));
        if self.floors.has_gravity() {
            let floors = self.floors.all().iter();
            recorders.peaks = recorders.peaks.under_gravity(floors.map(|floor| self.leaning(floor)));
        }
        recorders
    }

    /// Empty recorder of the closing between neighbours.
    fn closings(&self) -> Closings {
        let periods = self.scene.structures.iter().filter_map(Structure::period);
        let look = periods.fold(f64::INFINITY, f64::min) / LOOKS_PER_PERIOD;
        let closings = Closings::new(self.walls(), look).travelled(self.travel());
        let columns = self.floors.beside_all_columns();
        closings.beside(columns.iter().map(|one| self.beside_column(one)).collect())
    }

    /// Left floors of the pairs with a seat, and its width \[m\].
    fn seats(&self) -> impl Iterator<Item = (usize, f64)> {
        let contacts = self.scene.contacts.as_deref().unwrap_or_default();
        let facing = self.floors.facing().iter().filter(|one| one.column.is_none());
        facing.filter_map(|one| Some((one.left, contacts[one.contact].seat_width_m?)))
    }

    fn beside_column(&self, one: &ColumnBeside) -> BesideColumn {
        BesideColumn {
            floor: one.floor,
            is_left: self.floors.is_on_left(one),
            below: one.below,
            above: one.above,
            upper_part: one.upper_part(),
        }
    }

    /// Travel of the ground motion along the row; `None` if it arrives everywhere at once.
    pub fn travel(&self) -> Option<Travel> {
        let excitation = self.excitation();
        self.row.travel(excitation)
    }

    /// Largest change of distance between the bases of every structure and its right neighbour during the run, because the ground motion
    /// travels; empty if it arrives everywhere at once.
    pub fn openings(&self) -> Vec<Opening> {
        let Some(travel) = self.travel() else {
            return Vec::new();
        };
        let base = |structure: usize| self.floors.of_structure(structure)[0];
        let neighbours = 1..self.scene.structures.len();
        let opening = |right: usize| {
            let bases = [base(right - 1), base(right)];
            travel.largest_opening(bases, self.duration())
        };
        neighbours.map(opening).collect()
    }

    /// Pairs that can touch, from left to right.
    pub fn pairs(&self) -> &[Pair] {
        self.row.pairs()
    }

    /// Empty ledger for a run of the scene, which checks all laws.
    fn ledger(&self) -> Ledger<'_> {
        let excitation = self.excitation();
        self.row.ledger(excitation)
    }

    /// Applies `work` to the row that models the scene, whatever its columns are.
    pub fn on_row<Task: OnRow>(&self, work: Task) -> Task::Output {
        self.row.on(work)
    }

    /// Runs the scene with another method. Records the printed numbers of floors and pairs, and a ledger that checks the laws of this
    /// method.
    ///
    /// # Errors
    /// [`RunError`] if the run ends early.
    pub fn recorded_by(&self, method: Method) -> Result<(RunResult, Ledger<'_>), RunError> {
        let integrator = method.integrator();
        let mut ledger = self.ledger().held_to(integrator.laws());
        let mut recorders = Recorders {
            ledger: Some(&mut ledger),
            ..self.usual_recorders()
        };
        let clock = method.clock(self.duration());
        let work = self.run_by(&integrator, clock, &mut recorders)?;
        Ok((self.result(recorders, work), ledger))
    }

    /// Runs the scene with another method for timing: with the recorders of printed numbers only, and without results.
    ///
    /// # Errors
    /// [`RunError`] if the run ends early.
    pub fn timed_by(&self, method: Method) -> Result<Work, RunError> {
        let clock = method.clock(self.duration());
        self.run_by(&method.integrator(), clock, &mut self.usual_recorders())
    }

    /// Runs the scene with its own method for timing.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early.
    pub fn timed(&self) -> Result<Work, Error> {
        self.timed_by(self.method()).map_err(|error| self.ended(error))
    }

    /// Runs the scene with any method.
    fn run_by(&self, integrator: &Integrator, clock: Clock, recorders: &mut Recorders<'_, '_>) -> Result<Work, RunError> {
        let excitation = self.excitation();
        let course = clock.within(self.budget());
        self.row.run(integrator, excitation, course, recorders)
    }

    /// Runs the scene with its own method.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early.
    fn integrate(&self, recorders: &mut Recorders<'_, '_>) -> Result<Work, Error> {
        self.run_by(&self.integrator, self.clock, recorders)
            .map_err(|error| self.ended(error))
    }

    /// The ground motion of its run.
    ///
    /// # Panics
    /// Never: a record has samples and a time step > 0.
    pub fn excitation(&self) -> Excitation<'_> {
        Excitation::new(self.record.time_step(), self.record.samples()).expect("a record has samples and a time step > 0")
    }

    /// Describes the broken law of a run in the words of the scene.
    fn broke(&self, source: LedgerError) -> Error {
        let concerned = match source {
            LedgerError::GainInYielding { structure, .. } => structure..structure + 1,
            LedgerError::Tension { pair, .. }
            | LedgerError::PullingImpact { pair, .. }
            | LedgerError::GainAtImpact { pair, .. }
            | LedgerError::GainInContact { pair, .. }
            | LedgerError::Imbalance { pair, .. } => self.pairs()[pair].left()..self.pairs()[pair].right() + 1,
            LedgerError::EnergyUnexplained { .. } | _ => 0..0,
        };
        let refused = self.said(Refused::that(source.to_string()), concerned);
        Error::Broken { refused, source }
    }

    /// Adds the names of the scene and of the structures concerned.
    fn said(&self, mut refused: Refused, concerned: Range<usize>) -> Refused {
        refused.place_mut().scene = Some(self.scene.name.clone());
        let name = |index: usize| format!("structure {index} is \"{}\"", self.floors.all()[index].name);
        let names: Vec<String> = concerned.map(name).collect();
        if names.is_empty() {
            refused
        } else {
            refused.help(names.join("; "))
        }
    }

    /// Describes in the words of the scene why a run ended early.
    pub(super) fn ended(&self, source: RunError) -> Error {
        let concerned = match source {
            RunError::Setting { setting, found, allowed } => {
                let place = format!("method.{}.{setting}", self.scene.method.name());
                return Error::in_scene(&self.scene.name, out_of_range(place, found, allowed));
            }
            RunError::TooStiff {
                structure,
                pieces,
                allowed,
            } if pieces * self.record.duration() <= allowed * self.duration() => {
                let structure = self.floors.all()[structure].structure;
                let name = self.scene.structures[structure].name();
                let duration = self.duration();
                let most = format!(
                    "up to about {} by the exact method, which would need {pieces:.1e} pieces of the motion of structures[{structure}], \
                     \"{name}\", of {allowed:e} at most (`budget.pieces`)",
                    short(duration / pieces * allowed)
                );
                let found = Refused::at("duration_s").found(digits(duration)).allowed(most);
                let help = "use a shorter duration_s, or leave it out for that of the record and two periods";
                return Error::in_scene(&self.scene.name, found.so(": ", help).kind(RefusalKind::Together));
            }
            RunError::Diverged { structure, .. }
            | RunError::TangentDamping { structure }
            | RunError::Friction { structure }
            | RunError::TooStiff { structure, .. }
            | RunError::OutOfNumbers { structure, .. } => structure..structure + 1,
            RunError::NotConverged { first, last, .. } | RunError::ImpulsesNotFound { first, last, .. } => first..last + 1,
            RunError::BouncesWithoutEnd { left, right, .. }
            | RunError::TooDamped { left, right, .. }
            | RunError::NoSeries { left, right, .. }
            | RunError::ClosedIn { left, right, .. }
            | RunError::CrawlsInContact { left, right, .. } => left..right + 1,
            RunError::NoProgress { .. } | _ => 0..0,
        };
        let refused = self.said(Error::ended(&source), concerned);
        Error::Run { refused, source }
    }
}
