//! The runs of one scene at the edge: every method, the exact one, and the second route.

use super::class::{ACCURATE, Class};
use crate::research::work_precision::{MethodQuantity, Quantities};
use crate::study::axis::Pushed;
use pounding_reference::Fineness;
use pounding_scene::{AuditedRun, FloorQuantity, Method, PairQuantity, Quantity, RunResult, RunValues, Simulation, StepMethod, Warning};
use pounding_solver::Collision;

/// Longest row that the second route, which steps all structures together, is asked for.
const MOST_OF_SECOND_ROUTE: usize = 10;

/// What becomes of a scene.
#[derive(Debug)]
pub(super) struct Measured {
    /// The exact method by the second route, then every stepping method by the exact one.
    pub(super) runs: Vec<Run>,
}

/// What becomes of a scene under one method.
#[derive(Debug)]
pub(super) struct Run {
    /// Name of the method.
    pub(super) method: &'static str,
    /// Time step \[s\]; nothing for the exact method.
    pub(super) time_step: Option<f64>,
    /// Of every quantity.
    pub(super) numbers: [Judged; MethodQuantity::ALL.len()],
    /// Largest part of the energy that the balance of the run leaves unexplained \[–\].
    pub(super) residual: Option<f64>,
    /// Why it was refused or caught.
    pub(super) reason: String,
}

/// What becomes of one number of a run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Judged {
    pub(super) class: Class,
    /// Relative error \[–\]; of a refused run, that of the same run forced.
    pub(super) error: Option<f64>,
    /// Whether the program warns of it, as it does by default.
    pub(super) warned: bool,
    /// Class had the program not measured the errors (`--no-error`).
    pub(super) unmeasured: Class,
    /// Whether it then warns.
    pub(super) warned_unmeasured: bool,
}

impl Judged {
    /// A warning of a number that is within 1 %.
    pub(super) fn is_false_alarm(&self) -> bool {
        self.warned && self.is_good() && self.is_printed()
    }

    /// The same without measured errors.
    pub(super) fn is_false_alarm_unmeasured(&self) -> bool {
        self.warned_unmeasured && self.is_good() && self.is_printed()
    }

    /// A refusal of a run that would have been within 1 %.
    pub(super) fn is_wrong_refusal(&self) -> bool {
        matches!(self.class, Class::Refused | Class::Caught) && self.is_good()
    }

    /// A refusal of a run that ends early when forced, so that nobody knows.
    pub(super) fn is_unchecked_refusal(&self) -> bool {
        matches!(self.class, Class::Refused | Class::Caught) && self.error.is_none()
    }

    /// A number that is printed, and compared.
    pub(super) fn is_compared(&self) -> bool {
        self.error.is_some() && self.is_printed()
    }

    /// A number without warnings.
    fn plain(class: Class, error: Option<f64>) -> Self {
        Self {
            class,
            error,
            warned: false,
            unmeasured: class,
            warned_unmeasured: false,
        }
    }

    fn is_good(&self) -> bool {
        self.error.is_some_and(|error| error <= ACCURATE)
    }

    fn is_printed(&self) -> bool {
        !matches!(self.class, Class::Refused | Class::Caught | Class::NoReference | Class::NotVerified)
    }
}

/// Runs every method on a scene; `base` lends what does not change.
pub(super) fn measure(base: &Simulation, pushed: &Pushed) -> Measured {
    let all = |first, impulsive, of_method: &dyn Fn(StepMethod) -> Run| {
        let methods = StepMethod::differing(impulsive).map(of_method);
        let runs = std::iter::once(first).chain(methods).collect();
        Measured { runs }
    };
    let exact = match base.variant(&pushed.scene, pushed.record.clone()) {
        Ok(prepared) => prepared,
        // The scene is refused whatever the method.
        Err(error) => {
            let run = |method| Run::all(method, None, Class::Refused, error.to_string());
            return all(run("exact"), is_impulsive(base), &|method| run(method.name()));
        }
    };
    let (first, reference) = match exact.audited(None) {
        Ok(AuditedRun {
            outcome,
            broken: None,
            balance,
        }) => {
            let by_second_route = Run {
                residual: Some(balance.residual),
                ..of_exact(&exact, &outcome)
            };
            (by_second_route, Some(outcome))
        }
        Ok(AuditedRun { broken: Some(error), .. }) | Err(error) => (Run::all("exact", None, Class::Caught, error.to_string()), None),
    };
    all(first, is_impulsive(&exact), &|method| {
        of_method(&exact, method.name(), method.at(pushed.time_step), reference.as_ref())
    })
}

fn is_impulsive(prepared: &Simulation) -> bool {
    prepared.pairs().iter().any(|pair| !pair.law.is_compliant())
}

/// The exact run by the second route.
fn of_exact(exact: &Simulation, reference: &RunResult) -> Run {
    let n = exact.scene().structures.len();
    let not_verified = |reason: String| Run::all("exact", None, Class::NotVerified, reason);
    if n > MOST_OF_SECOND_ROUTE {
        return not_verified(format!("the second route is asked for rows of up to {MOST_OF_SECOND_ROUTE}"));
    }
    if hits_at_once(reference) {
        return not_verified("several pairs hit at one instant, which rounding of the second route takes apart".into());
    }
    let own = Quantities::of(reference, n);
    match crate::second_route(exact, Fineness::FINE) {
        Ok(second) => Run {
            numbers: MethodQuantity::ALL.map(|quantity| {
                let error = own.distance(&Quantities::of_second_route(&second), quantity);
                Judged::plain(Class::of(error, false), error)
            }),
            ..Run::all("exact", None, Class::Nothing, String::new())
        },
        Err(error) => not_verified(error.to_string()),
    }
}

/// Whether impacts of different pairs are apart by rounding alone: together and one by one they end otherwise.
fn hits_at_once(outcome: &RunResult) -> bool {
    let all = outcome.collisions.all();
    let impulsive = |one: &&Collision| one.peak_force.is_none();
    let hits: Vec<_> = all.iter().filter(impulsive).collect();
    hits.windows(2)
        .any(|two| two[0].pair != two[1].pair && (two[1].start - two[0].start).abs() < RunValues::AT_ONCE)
}

/// A stepping method by the exact run.
fn of_method(exact: &Simulation, name: &'static str, method: Method, reference: Option<&RunResult>) -> Run {
    let time_step = method.time_step();
    let stopped = |class, reason| Run::all(name, time_step, class, reason);
    let prepared = match exact.with_any_method(method) {
        Ok(prepared) => prepared,
        Err(error) => return stopped(Class::Refused, error.to_string()),
    };
    let refusal = prepared.refusal();
    let AuditedRun { outcome, broken, balance } = match prepared.audited(None) {
        Ok(run) => run,
        Err(error) => {
            let class = if refusal.is_some() { Class::Refused } else { Class::Caught };
            return stopped(class, refusal.unwrap_or(error.to_string()));
        }
    };
    let wrong = match (&refusal, &broken) {
        (Some(_), _) => Some(Class::Refused),
        (None, Some(_)) => Some(Class::Caught),
        (None, None) => None,
    };
    let reason = refusal.or(broken.map(|error| error.to_string()));
    Run {
        numbers: judge(&prepared, &outcome, reference, wrong),
        residual: Some(balance.residual),
        ..stopped(Class::Nothing, reason.unwrap_or_default())
    }
}

/// What becomes of every number of a run that ends; `wrong` where none of them is printed.
fn judge(
    prepared: &Simulation,
    outcome: &RunResult,
    reference: Option<&RunResult>,
    wrong: Option<Class>,
) -> [Judged; MethodQuantity::ALL.len()] {
    let before = prepared.warnings_before(outcome);
    let warnings = match reference {
        Some(reference) => prepared.warnings(outcome, reference).1,
        None => vec![Warning::ErrorUnknown],
    };
    let quantities = |of: &RunResult| Quantities::of(of, prepared.scene().structures.len());
    let (found, truth) = (quantities(outcome), reference.map(quantities));
    MethodQuantity::ALL.map(|quantity| {
        let asked = number(quantity, !is_impulsive(prepared));
        let concerns = |all: &[Warning]| all.iter().any(|warning| warning.concerns(asked));
        let (warned, warned_unmeasured) = (concerns(&warnings), concerns(&before));
        let error = truth.as_ref().map(|truth| found.distance(truth, quantity));
        let class = |warned| match (wrong, error) {
            (Some(wrong), _) => wrong,
            (None, None) => Class::NoReference,
            (None, Some(error)) => Class::of(error, warned),
        };
        Judged {
            class: class(warned),
            error: error.flatten(),
            warned,
            unmeasured: class(warned_unmeasured),
            warned_unmeasured,
        }
    })
}

/// The printed number that a quantity is.
fn number(quantity: MethodQuantity, compliant: bool) -> Quantity {
    match quantity {
        MethodQuantity::FirstTime => PairQuantity::FirstStartS.into(),
        MethodQuantity::FirstImpulse => PairQuantity::FirstImpulseNS.into(),
        MethodQuantity::Momentum => FloorQuantity::TransferredMomentumNS.into(),
        MethodQuantity::ContactPeak if compliant => PairQuantity::PeakForceN.into(),
        MethodQuantity::ContactPeak => PairQuantity::LargestImpulseNS.into(),
        MethodQuantity::Displacement => FloorQuantity::PeakDisplacementM.into(),
        MethodQuantity::Shear => FloorQuantity::PeakShearForceN.into(),
    }
}

impl Run {
    /// A run without numbers of its own.
    fn all(method: &'static str, time_step: Option<f64>, class: Class, reason: String) -> Self {
        Self {
            method,
            time_step,
            numbers: [Judged::plain(class, None); MethodQuantity::ALL.len()],
            residual: None,
            reason,
        }
    }
}
