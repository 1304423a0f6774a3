//! A run with its errors and its warnings.

use pounding_contact::SLOWEST_APPROACH;
use pounding_solver::{Collision, LedgerError, Work};

use crate::judge::limits::{ContactLimit, MethodLimits};
use crate::simulation::{AuditedRun, Extras};
use crate::{
    DeliveredRestitution, EnergyBalance, Error, Excess, Method, Quantity, RunErrors, RunResult, Simulation, Structure, Warning,
    WarningPlace,
};

/// Tolerance for rounding in a number of steps \[–\].
const SLACK: f64 = 1.0 - 1e-9;

/// Largest part of the energy that an exact run may leave unexplained \[–\], with a warning. Its numbers are off by about as much, which
/// changes no decision. Above it the run fails.
const DECIDES_NOTHING: f64 = 1e-8;

/// Largest error of the delivered impulse of a free collision \[–\] without a warning.
const IMPULSE_OFF: f64 = 0.05;

/// A run with its errors and its warnings.
#[derive(Debug)]
pub struct Review {
    /// Results of the run.
    pub outcome: RunResult,
    /// Terms of its energy.
    pub balance: EnergyBalance,
    /// Errors against the exact run.
    pub errors: Errors,
    /// Responses beyond the model or beyond the limits of codes.
    pub excesses: Vec<Excess>,
    /// Warnings about the numbers.
    pub warnings: Vec<Warning>,
}

impl Review {
    /// Relative error of a printed number \[–\] above which a run gives a warning.
    pub const DOUBTFUL: f64 = 0.03;

    /// Sentences about warnings and responses beyond the model, the most harmful first.
    pub fn notices(&self) -> Vec<String> {
        let excesses = self.excesses.iter().map(ToString::to_string);
        let warnings = self.warnings.iter().map(ToString::to_string);
        excesses.chain(warnings).collect()
    }
}

/// Errors of a run, or the reason why they are not known.
#[derive(Debug)]
pub enum Errors {
    /// The method is exact.
    Exact,
    /// The method is exact, but its ledger shows that this run went wrong.
    Doubtful,
    /// The errors were not asked for.
    NotMeasured,
    /// The exact run failed.
    Unknown(Error),
    /// Errors against an exact run, and the work of that run.
    Measured(RunErrors, Work),
}

impl Review {
    /// Returns the errors; `None` if they were not measured.
    pub fn measured(&self) -> Option<&RunErrors> {
        match &self.errors {
            Errors::Measured(errors, _) => Some(errors),
            Errors::Exact | Errors::Doubtful | Errors::NotMeasured | Errors::Unknown(_) => None,
        }
    }
}

impl Simulation {
    /// Runs the scene and finds its errors.
    ///
    /// With `measure`, the exact method runs, too, and every number is compared. Otherwise warnings follow from the collisions of the run
    /// itself.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early, [`Error::Broken`] if it breaks a law of mechanics and was not forced.
    pub fn review(&self, measure: bool) -> Result<Review, Error> {
        self.review_recorded(measure, None)
    }

    /// Runs the scene and finds its errors, with histories of a state every `interval` \[s\] if it is given.
    ///
    /// # Errors
    /// Errors of [`Self::review`].
    pub fn review_recorded(&self, measure: bool, interval: Option<f64>) -> Result<Review, Error> {
        let asked = Extras {
            interval,
            closings: true,
            reversed_closings: true,
            drift_rates: true,
        };
        let AuditedRun { outcome, broken, balance } = self.audited_with(asked)?;
        let mut warnings = Vec::new();
        let refusal = self.refusal();
        warnings.extend(refusal.map(|refusal| Warning::BeyondFreeLimit { refusal }));
        let is_broken = broken.is_some();
        if let Some(broken) = broken {
            warnings.push(self.told(broken)?);
        }
        warnings.extend(self.passed(&outcome));
        let errors = if matches!(self.method(), Method::Exact { .. }) {
            warnings.extend(self.warnings_before(&outcome));
            if is_broken { Errors::Doubtful } else { Errors::Exact }
        } else if measure {
            match self.reference() {
                Ok((exact, doubt)) => {
                    let (errors, of_errors) = self.warnings(&outcome, &exact);
                    warnings.extend(doubt);
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
            excesses: self.excesses(&outcome),
            outcome,
            balance,
            errors,
            warnings,
        })
    }

    /// Turns a broken law into a warning, if the run was forced or the law is broken by a negligible amount.
    ///
    /// # Errors
    /// The broken law otherwise.
    fn told(&self, broken: Error) -> Result<Warning, Error> {
        if let Some(energy) = broken.doubt() {
            let reference = self.method().time_step().is_some();
            Ok(Warning::Doubtful { reference, energy })
        } else if self.is_forced() {
            let law = broken.to_string();
            Ok(Warning::Broken { law })
        } else {
            Err(broken)
        }
    }

    /// Makes the exact run of the scene, the reference for other methods, and returns it with the warnings about it.
    ///
    /// # Errors
    /// [`Error`] if it fails or breaks a law of mechanics, even if the scene is forced.
    fn reference(&self) -> Result<(RunResult, Option<Warning>), Error> {
        let exact = self.exact()?;
        let audited = exact.audited_with(Extras::COMPARED)?;
        let doubt = match audited.broken {
            None => None,
            Some(broken) => match broken.doubt() {
                Some(_) => Some(self.told(broken)?),
                None => return Err(broken),
            },
        };
        Ok((audited.outcome, doubt))
    }

    /// Compares a run of the scene with the exact run, and finds the warnings of both.
    pub fn warnings(&self, run: &RunResult, exact: &RunResult) -> (RunErrors, Vec<Warning>) {
        let errors = RunErrors::between(run, exact, self);
        let mut warnings = self.warnings_before(exact);
        let pairs = errors.pairs().iter().enumerate();
        let rests = pairs.filter(|(_, pair)| pair.rests);
        warnings.extend(rests.map(|(pair, _)| Warning::Rests {
            names: self.names(pair),
            contact: self.contact(pair),
        }));
        warnings.extend(errors.warnings());
        (errors, warnings)
    }

    /// Returns the warnings that can be given before a run, for the collisions of a run of the same scene, preferably the exact run.
    pub fn warnings_before(&self, expected: &RunResult) -> Vec<Warning> {
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
        (steps < SLACK * MethodLimits::STEPS_PER_PERIOD).then(|| Warning::FewStepsPerPeriod {
            structure: index,
            name: structure.name().into(),
            steps,
            time_step: self.knob(time_step),
        })
    }

    /// Field of the time step, and its value \[s\].
    fn knob(&self, time_step: f64) -> (String, f64) {
        let field = format!("method.{}.time_step_s", self.method().name());
        (field, time_step)
    }

    /// Returns the warnings about a pair's collisions, the smallest limit of the time step first.
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
        let is_off = |(right, delivered): (f64, DeliveredRestitution)| delivered.error > IMPULSE_OFF * (1.0 + right);
        let off = restitution.is_some_and(is_off);
        let few = |steps: &f64| off || *steps < SLACK * MethodLimits::STEPS_PER_CONTACT;
        free.steps.filter(few).map(|steps| Warning::UnderResolved {
            place: place(),
            steps,
            restitution,
        })
    }

    /// What the motion of a run passes: unstable equilibria of storeys under gravity, and ends of seats.
    pub fn passed(&self, outcome: &RunResult) -> Vec<Warning> {
        let floors = self.floors().all().iter().enumerate();
        let unstable = floors.filter_map(|(floor, one)| {
            Some(Warning::Unstable {
                name: self.floors().storey_name(floor),
                drift: one.made_of?.unstable_drift_m()?,
                time: outcome.peaks.of(floor).unstable?,
                collapses: outcome.collapse.is_some_and(|collapse| collapse.floor == floor),
            })
        });
        let contacts = self.scene().contacts.as_deref().unwrap_or_default();
        let unseated = (0..self.floors().facing().len()).filter_map(|pair| {
            let contact = self.contact(pair);
            Some(Warning::Unseated {
                contact,
                names: self.floors().of_seat(pair),
                width: contacts.get(contact)?.seat_width_m?,
                time: outcome.widening(self, pair)?.unseated?,
            })
        });
        unstable.chain(unseated).collect()
    }

    /// Warns about slow touches under a law whose damper grows with 1/v₀, for a run with known approach speeds.
    fn slow_touches(&self, expected: &RunResult) -> impl Iterator<Item = Warning> {
        let pairs = self.pairs().iter().enumerate();
        pairs.filter_map(|(index, pair)| {
            let slow = |one: &&Collision| {
                let speed = one.approach_speed;
                one.pair == index && speed.is_some_and(|speed| speed < SLOWEST_APPROACH)
            };
            let count = expected.collisions.all().iter().filter(slow).count();
            (pair.law.knows_approach_speed() && count > 0).then(|| Warning::SlowTouches {
                contact: self.contact(index),
                names: self.names(index),
                count,
            })
        })
    }

    fn place(&self, pair: usize, time_step: f64) -> WarningPlace {
        WarningPlace {
            contact: self.contact(pair),
            names: self.names(pair),
            time_step: self.knob(time_step),
        }
    }

    /// Index of the contact of a pair in the scene: a contact between buildings has several pairs.
    fn contact(&self, pair: usize) -> usize {
        let facing = self.floors().facing().get(pair);
        facing.map_or(pair, |facing| facing.contact)
    }

    /// Names of the structures of a pair.
    fn names(&self, pair: usize) -> [String; 2] {
        if pair < self.floors().facing().len() {
            return self.floors().names(pair);
        }
        // A full model has pairs that the scene does not have.
        let pair = &self.pairs()[pair];
        [pair.left(), pair.right()].map(|index| self.floors().all()[index].name.clone())
    }
}

impl RunErrors {
    /// Warns about numbers far from those of the exact run.
    fn warnings(&self) -> impl Iterator<Item = Warning> {
        Quantity::compared().filter_map(|quantity| {
            let error = self.of(quantity);
            (error > Review::DOUBTFUL).then_some(Warning::Error { quantity, error })
        })
    }
}

impl Error {
    /// Warns about the energy that an exact run leaves unexplained, if it is so little that the numbers remain usable with the warning.
    fn doubt(&self) -> Option<LedgerError> {
        if let Self::Broken {
            source: energy @ LedgerError::EnergyUnexplained { found, .. },
            ..
        } = self
            && *found <= DECIDES_NOTHING
        {
            Some(*energy)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use pounding_solver::LedgerError;
    use pounding_text::Refused;

    use super::*;

    const SCENE: &str = r#"{
        "name": "two",
        "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}}},
        "duration_s": 1.0,
        "structures": [
            {"sdof": {"name": "left", "mass_kg": 1e5, "period_s": 0.8, "damping": {"ratio": 0.05}}},
            "wall"
        ],
        "contacts": [{"gap_m": 0.01, "law": {"linear_spring": {"impact_stiffness_n_per_m": 1e8}}}]
    }"#;

    fn broken(found: f64) -> Error {
        let source = LedgerError::EnergyUnexplained { found, allowed: 1e-11 };
        let mut refused = Refused::that(source.to_string());
        refused.place_mut().scene = Some("two".into());
        Error::Broken { refused, source }
    }

    /// A run that left 4e-5 of its energy unexplained was printed with "none beyond rounding".
    #[test]
    fn issue_an_exact_run_is_not_exact_whatever_its_ledger_says() {
        let scene = serde_json::from_str(SCENE).expect("a scene");
        let prepare = [
            Simulation::new(&scene, std::path::Path::new("")),
            Simulation::new(
                &scene,
                crate::SimulationOptions {
                    force: true,
                    ..crate::SimulationOptions::default()
                },
            ),
        ];
        let [usual, forced] = prepare.map(|prepared| prepared.expect("it is sound"));
        let review = usual.review(true).expect("it runs");
        assert!(matches!(review.errors, Errors::Exact) && review.warnings.is_empty());

        let doubt = usual.told(broken(2e-10)).expect("it decides nothing");
        insta::assert_snapshot!(doubt, @"this run, which should be exact: energy: found 2.0e-10 of it unexplained, allowed 1.0e-11, which rounding leaves of a right run; some number of this run is wrong, which is a fault of the method: use another one, and report it");
        let wrong = usual.told(broken(4e-5)).expect_err("it is wrong");
        insta::assert_snapshot!(wrong, @r#"scene "two": energy: found 4.0e-5 of it unexplained, allowed 1.0e-11, which rounding leaves of a right run; some number of this run is wrong, which is a fault of the method: use another one, and report it"#);
        let forced = forced.told(broken(4e-5)).expect("it is forced");
        assert!(matches!(forced, Warning::Broken { .. }), "{forced:?}");
        for quantity in Quantity::compared() {
            assert!(doubt.concerns(quantity) && forced.concerns(quantity));
        }
    }
}
