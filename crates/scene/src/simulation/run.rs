//! Runs of a prepared scene: what they record, and what is said of those that fail.

use std::ops::Range;

use pounding_solver::{
    Clock, Closings, Collisions, Excitation, FloorAccelerations, Histories, Integrator, LastStates, Ledger, LedgerError, OnRow, Opening,
    Pair, Peak, Peaks, Recorders, RunError, Terms, TransferredMomentum, Travel, Work,
};

use super::Simulation;
use crate::settings::out_of_range;
use crate::{Error, Method, Structure};
use pounding_text::{RefusalKind, Refused, digits, short};

/// Looks at a motion in the shortest natural period, where its series says no better; see [`Closings`].
const LOOKS_PER_PERIOD: f64 = 200.0;

/// What a run leaves behind.
#[derive(Debug, Clone)]
pub struct RunResult {
    /// Peaks of every structure.
    pub peaks: Peaks,
    /// Collisions of every pair.
    pub collisions: Collisions,
    /// Transferred momentum of every structure.
    pub momentum: TransferredMomentum,
    /// Peak absolute accelerations of every floor \[m/s²\]; impulsive impacts, which have none, left out.
    pub accelerations: Vec<Peak>,
    /// Where every floor is at the end.
    pub last: LastStates,
    /// How far neighbours came towards each other, where asked for.
    pub closings: Option<Closings>,
    /// Histories of every structure, where asked for.
    pub histories: Option<Histories>,
    /// What the run cost.
    pub work: Work,
}

/// A run with what its ledger says.
#[derive(Debug)]
pub struct Audited {
    /// What the run leaves behind.
    pub outcome: RunResult,
    /// The law of mechanics that it breaks, if any.
    pub broken: Option<Error>,
    /// Where its energy went.
    pub balance: Balance,
}

/// Where the energy of a run went, and how well its sum closes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance {
    /// Terms of the row at the end \[J\].
    pub terms: Terms,
    /// What of the energies the physical balance leaves unexplained, relative to the scale \[–\]; see
    /// [`Ledger::residual`].
    pub residual: f64,
    /// What energies are measured by \[J\]; see [`Ledger::scale`].
    pub scale: f64,
}

/// What a run records only where it is asked for.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Extras {
    /// Histories of a state every so many seconds.
    pub interval: Option<f64>,
    /// How far neighbours come towards each other.
    pub closings: bool,
    /// How far they do so under the mirror of the shaking; see [`Closings::both_ways`].
    pub reversed_closings: bool,
}

impl Extras {
    /// Everything that [`RunErrors`](crate::RunErrors) compare.
    pub const COMPARED: Self = Self {
        interval: None,
        closings: true,
        reversed_closings: false,
    };
}

impl RunResult {
    /// What recorders have seen of a run.
    fn of(recorders: Recorders<'_, '_>, work: Work) -> Self {
        let accelerations = recorders.accelerations.map(FloorAccelerations::into_peaks);
        Self {
            peaks: recorders.peaks,
            collisions: recorders.collisions,
            momentum: recorders.momentum,
            accelerations: accelerations.unwrap_or_default(),
            last: recorders.last.unwrap_or_else(|| LastStates::new(0)),
            closings: recorders.closings,
            histories: recorders.histories,
            work,
        }
    }
}

impl Simulation {
    /// Runs the scene; histories with a state every `interval` \[s\] only where asked for.
    ///
    /// # Errors
    /// As of [`run_with`](Self::run_with).
    pub fn run(&self, interval: Option<f64>) -> Result<RunResult, Error> {
        self.run_with(Extras {
            interval,
            ..Extras::default()
        })
    }

    /// The same with what is asked for.
    ///
    /// # Errors
    /// [`Error::Run`] when the run ends early, [`Error::Broken`] when it breaks a law of mechanics: nobody reads a
    /// warning here.
    pub fn run_with(&self, asked: Extras) -> Result<RunResult, Error> {
        let Audited { outcome, broken, .. } = self.audited_with(asked)?;
        broken.map_or(Ok(outcome), Err)
    }

    /// Runs the scene; what its ledger says stands beside the outcome.
    ///
    /// # Errors
    /// [`Error::Run`] when the run ends early.
    pub fn audited(&self, interval: Option<f64>) -> Result<Audited, Error> {
        let asked = Extras {
            interval,
            ..Extras::default()
        };
        self.audited_with(asked)
    }

    /// The same with what is asked for.
    ///
    /// # Errors
    /// [`Error::Run`] when the run ends early.
    pub fn audited_with(&self, asked: Extras) -> Result<Audited, Error> {
        let mut ledger = self.ledger().held_to(self.integrator.laws());
        let mut recorders = self.recorders(asked);
        recorders.ledger = Some(&mut ledger);
        let work = self.integrate(&mut recorders)?;
        Ok(Audited {
            outcome: RunResult::of(recorders, work),
            broken: ledger.verdict().err().map(|source| self.broke(source)),
            balance: Balance {
                terms: ledger.terms(),
                residual: ledger.residual(),
                scale: ledger.scale(),
            },
        })
    }

    /// The same without the ledger, which for the exact method takes nearly half of the time: of timings, and of what is judged
    /// elsewhere.
    ///
    /// # Errors
    /// [`Error::Run`] when the run ends early.
    pub fn run_unjudged(&self, asked: Extras) -> Result<RunResult, Error> {
        let mut recorders = self.recorders(asked);
        let work = self.integrate(&mut recorders)?;
        Ok(RunResult::of(recorders, work))
    }

    /// Records a run that `run` makes in another way than the scene's method; histories as of [`run`](Self::run).
    ///
    /// # Errors
    /// [`Error::Run`] where it ends early.
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
        Ok(RunResult::of(recorders, work))
    }

    /// Empty recorders of everything that is asked for.
    fn recorders<'l>(&self, asked: Extras) -> Recorders<'l, '_> {
        let n = self.floors.all().len();
        let duration = self.clock.time(self.clock.n_steps);
        let closings = || {
            if asked.reversed_closings {
                self.closings().both_ways()
            } else {
                self.closings()
            }
        };
        let accelerations = FloorAccelerations::new(n, self.excitation());
        Recorders {
            accelerations: Some(accelerations.travelled(self.travel().as_ref())),
            last: Some(LastStates::new(n)),
            closings: asked.closings.then(closings),
            histories: asked.interval.map(|interval| Histories::new(n, interval, duration)),
            ..self.usual_recorders()
        }
    }

    /// Empty recorders of what is printed of a structure or a pair.
    fn usual_recorders<'l>(&self) -> Recorders<'l, '_> {
        let mut recorders = Recorders::usual(self.floors.all().len(), self.pairs());
        recorders.collisions = recorders.collisions.travelled(self.travel());
        recorders
    }

    /// An empty recorder of how far neighbours come towards each other.
    fn closings(&self) -> Closings {
        let periods = self.scene.structures.iter().filter_map(Structure::period);
        let look = periods.fold(f64::INFINITY, f64::min) / LOOKS_PER_PERIOD;
        Closings::new(self.walls(), look).travelled(self.travel())
    }

    /// How the ground motion travels along the row; nothing where all are shaken at once.
    pub fn travel(&self) -> Option<Travel> {
        let excitation = self.excitation();
        self.row.travel(excitation)
    }

    /// How far the bases of structures that face each other come closest, or apart, during the run, by how the ground
    /// motion travels: of every structure and its right neighbour; empty where all are shaken at once.
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

    /// The pairs that can touch, from left to right.
    pub fn pairs(&self) -> &[Pair] {
        self.row.pairs()
    }

    /// An empty ledger for a run of the scene, held to all laws.
    fn ledger(&self) -> Ledger<'_> {
        let excitation = self.excitation();
        self.row.ledger(excitation)
    }

    /// Works on the row that models the scene, whatever its columns are.
    pub fn on_row<Task: OnRow>(&self, work: Task) -> Task::Output {
        self.row.on(work)
    }

    /// Runs the scene by any method, whatever its own is, with recorders of what is printed of a structure or a pair and a ledger that is
    /// held to the laws of the method.
    ///
    /// # Errors
    /// [`RunError`] when the run ends early.
    pub fn recorded_by(&self, method: Method) -> Result<(RunResult, Ledger<'_>), RunError> {
        let integrator = method.integrator();
        let mut ledger = self.ledger().held_to(integrator.laws());
        let mut recorders = Recorders {
            ledger: Some(&mut ledger),
            ..self.usual_recorders()
        };
        let clock = method.clock(self.duration());
        let work = self.run_by(&integrator, clock, &mut recorders)?;
        Ok((RunResult::of(recorders, work), ledger))
    }

    /// The same with nothing but recorders of what is printed, and nothing kept of them: a run to be timed.
    ///
    /// # Errors
    /// [`RunError`] when the run ends early.
    pub fn timed_by(&self, method: Method) -> Result<Work, RunError> {
        let clock = method.clock(self.duration());
        self.run_by(&method.integrator(), clock, &mut self.usual_recorders())
    }

    /// The same by the scene's own method.
    ///
    /// # Errors
    /// [`Error::Run`] when the run ends early.
    pub fn timed(&self) -> Result<Work, Error> {
        self.timed_by(self.method()).map_err(|error| self.ended(error))
    }

    /// Runs the scene by any method, whatever its own is.
    fn run_by(&self, integrator: &Integrator, clock: Clock, recorders: &mut Recorders<'_, '_>) -> Result<Work, RunError> {
        let excitation = self.excitation();
        let course = clock.within(self.budget());
        self.row.run(integrator, excitation, course, recorders)
    }

    /// Runs the scene by its method.
    ///
    /// # Errors
    /// [`Error::Run`] when the run ends early.
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

    /// Says in the words of the scene which law a run broke.
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

    /// What happened in the scene, with the names of the structures concerned.
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

    /// Says in the words of the scene why a run ended early.
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
            RunError::Diverged { structure, .. } | RunError::TooStiff { structure, .. } | RunError::OutOfNumbers { structure, .. } => {
                structure..structure + 1
            }
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
