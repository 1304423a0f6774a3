//! A run with what is known of its errors, and what it warns of.

use pounding_contact::SLOWEST_APPROACH;
use pounding_solver::{Collision, Work};

use crate::limits::{ContactLimit, STEPS_PER_CONTACT};
use crate::prepared::{Asked, Audited};
use crate::{
    Balance, Delivered, Method, Number, Outcome, Place, Prepared, RunErrors, Structure, StudyError,
    Warning,
};

/// Where rounding leaves a whole number of steps.
const SLACK: f64 = 1.0 - 1e-9;

/// Relative error of a printed number above which a run is warned of \[–\].
pub const DOUBTFUL: f64 = 0.03;

/// Part of the impulse of a free collision \[–\] by which the one that is delivered may be off without a warning.
const IMPULSE_OFF: f64 = 0.05;

/// Steps per natural period below which a run is warned of: the usual rule.
pub const STEPS_PER_PERIOD: f64 = 10.0;

/// A run with what is known of its errors.
#[derive(Debug)]
pub struct Review {
    /// What the run leaves behind.
    pub outcome: Outcome,
    /// Where its energy went.
    pub balance: Balance,
    /// How far it is from the exact run.
    pub errors: Errors,
    /// What a user should know before believing it.
    pub warnings: Vec<Warning>,
}

/// What is known of the errors of a run.
#[derive(Debug)]
pub enum Errors {
    /// The method is exact.
    Exact,
    /// Nobody asked.
    NotMeasured,
    /// The exact run failed.
    Unknown(StudyError),
    /// Measured against an exact run, which cost this.
    Measured(RunErrors, Work),
}

impl Review {
    /// The errors, where they were measured.
    pub fn measured(&self) -> Option<&RunErrors> {
        match &self.errors {
            Errors::Measured(errors, _) => Some(errors),
            Errors::Exact | Errors::NotMeasured | Errors::Unknown(_) => None,
        }
    }
}

impl Prepared {
    /// Runs the scene and says what is known of its errors.
    ///
    /// With `measure` the exact method runs too and every number is compared with its own; without it, warnings rest on
    /// the collisions of the run itself.
    ///
    /// # Errors
    /// [`StudyError::Run`] when the run ends early, [`StudyError::Broken`] when it breaks a law of mechanics and was not
    /// forced.
    pub fn review(&self, measure: bool) -> Result<Review, StudyError> {
        self.review_recorded(measure, None)
    }

    /// The same, with histories of a state every `interval` \[s\] where asked for.
    pub(crate) fn review_recorded(
        &self,
        measure: bool,
        interval: Option<f64>,
    ) -> Result<Review, StudyError> {
        let asked = Asked {
            interval,
            closings: true,
        };
        let Audited {
            outcome,
            broken,
            balance,
        } = self.audited_with(asked)?;
        let mut warnings = Vec::new();
        let refusal = self.refusal();
        warnings.extend(refusal.map(|refusal| Warning::BeyondFreeLimit { refusal }));
        if let Some(broken) = broken {
            if !self.is_forced() {
                return Err(broken);
            }
            let law = broken.to_string();
            warnings.push(Warning::Broken { law });
        }
        let errors = if matches!(self.method(), Method::Exact { .. }) {
            warnings.extend(self.warnings_before(&outcome));
            Errors::Exact
        } else if measure {
            match self.exact().and_then(|exact| exact.run_compared()) {
                Ok(exact) => {
                    let (errors, of_errors) = self.warnings(&outcome, &exact);
                    warnings.extend(of_errors);
                    Errors::Measured(errors, exact.work)
                }
                Err(error) => {
                    warnings.push(Warning::ErrorUnknown);
                    Errors::Unknown(error)
                }
            }
        } else {
            warnings.extend(self.warnings_before(&outcome));
            Errors::NotMeasured
        };
        Ok(Review {
            outcome,
            balance,
            errors,
            warnings,
        })
    }

    /// Errors of a run of the scene against the exact one, and what it has to be warned of.
    pub(crate) fn warnings(&self, run: &Outcome, exact: &Outcome) -> (RunErrors, Vec<Warning>) {
        let errors = RunErrors::between(run, exact, self);
        let mut warnings = self.warnings_before(exact);
        let pairs = errors.pairs.iter().enumerate();
        let rests = pairs.filter(|(_, pair)| pair.rests);
        warnings.extend(rests.map(|(pair, _)| Warning::Rests {
            names: self.names(pair),
            pair,
        }));
        warnings.extend(errors.warnings());
        (errors, warnings)
    }

    /// What can be said before a run, for the collisions that are expected: those of a run of the same scene, best the
    /// exact one.
    pub fn warnings_before(&self, expected: &Outcome) -> Vec<Warning> {
        let structures = self.scene().structures.iter().enumerate();
        let periods = structures.filter_map(|(index, structure)| self.few_steps(index, structure));
        let limits = self.limits(expected);
        let contacts = limits.contacts.iter();
        let contacts = contacts.filter_map(|limit| self.contact_warning(limit));
        let slow = self.slow_touches(expected);
        periods.chain(contacts).chain(slow).collect()
    }

    fn few_steps(&self, index: usize, structure: &Structure) -> Option<Warning> {
        let time_step = self.method().time_step()?;
        let steps = structure.period()? / time_step;
        (steps < SLACK * STEPS_PER_PERIOD).then(|| Warning::FewStepsPerPeriod {
            structure: index,
            name: structure.name().into(),
            steps,
            time_step: self.knob(time_step),
        })
    }

    /// The field of the time step, and its value \[s\].
    fn knob(&self, time_step: f64) -> (String, f64) {
        let field = format!("method.{}.time_step_s", self.method().name());
        (field, time_step)
    }

    /// What a pair's collisions are to be warned of: the least time step first.
    fn contact_warning(&self, limit: &ContactLimit) -> Option<Warning> {
        let time_step = self.method().time_step()?;
        let place = || self.place(limit.pair, time_step);
        if let Some(critical) = limit.critical_time_step
            && time_step >= critical
        {
            return Some(Warning::BeyondContactLimit {
                place: place(),
                limit: critical,
            });
        }
        let free = limit.free?;
        let restitution = free.restitution.zip(free.delivered);
        let is_off =
            |(right, delivered): (f64, Delivered)| delivered.error > IMPULSE_OFF * (1.0 + right);
        let off = restitution.is_some_and(is_off);
        match (free.steps, restitution) {
            (Some(steps), _) if off || steps < SLACK * STEPS_PER_CONTACT => {
                Some(Warning::UnderResolved {
                    place: place(),
                    steps,
                    restitution,
                })
            }
            (None, Some(restitution)) if off => Some(Warning::PublishedImpacts {
                place: place(),
                restitution,
            }),
            _ => None,
        }
    }

    /// Slow touches of a law whose damper grows with 1/v₀, of a run that knows its approach speeds.
    fn slow_touches(&self, expected: &Outcome) -> impl Iterator<Item = Warning> {
        let pairs = self.pairs().iter().enumerate();
        pairs.filter_map(|(index, pair)| {
            let slow = |one: &&Collision| {
                let speed = one.approach_speed;
                one.pair == index && speed.is_some_and(|speed| speed < SLOWEST_APPROACH)
            };
            let count = expected.collisions.all().iter().filter(slow).count();
            (pair.law.knows_approach_speed() && count > 0).then(|| Warning::SlowTouches {
                pair: index,
                names: self.names(index),
                count,
            })
        })
    }

    fn place(&self, pair: usize, time_step: f64) -> Place {
        Place {
            pair,
            names: self.names(pair),
            time_step: self.knob(time_step),
        }
    }

    /// Names of the structures of a pair.
    fn names(&self, pair: usize) -> [String; 2] {
        let pair = &self.pairs()[pair];
        [pair.left, pair.right].map(|index| self.floors().all()[index].name.clone())
    }
}

impl RunErrors {
    /// What is far from the exact run.
    fn warnings(&self) -> impl Iterator<Item = Warning> {
        Number::ALL.into_iter().filter_map(|number| {
            let error = self.of(number);
            (error > DOUBTFUL).then_some(Warning::Error { number, error })
        })
    }
}
