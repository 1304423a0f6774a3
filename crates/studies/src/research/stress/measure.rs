//! Runs of one extreme scene: by every method, by the exact method, and by the second route.

use super::class::{ACCURATE, Class};
use crate::research::work_precision::{MethodQuantity, Quantities};
use crate::study::axis::Pushed;
use pounding_reference::Fineness;
use pounding_scene::{AuditedRun, FloorQuantity, Method, PairQuantity, Quantity, RunResult, RunValues, Simulation, StepMethod, Warning};
use pounding_solver::Collision;

/// Largest number of structures for the second route, which steps them all together.
const MOST_OF_SECOND_ROUTE: usize = 10;

/// Results of a scene under all methods.
#[derive(Debug)]
pub(super) struct JudgedScene {
    /// First the exact method, measured by the second route; then every stepping method, measured by the exact one.
    pub(super) runs: Vec<JudgedRun>,
}

/// Results of a scene under one method.
#[derive(Debug)]
pub(super) struct JudgedRun {
    /// Name of the method.
    pub(super) method: &'static str,
    /// Time step \[s\]; `None` for the exact method.
    pub(super) time_step: Option<f64>,
    /// A judgement of every quantity.
    pub(super) numbers: [Judged; MethodQuantity::ALL.len()],
    /// Largest share of the energy that the balance of the run cannot explain \[–\].
    pub(super) residual: Option<f64>,
    /// Reason why the run was refused or caught; else empty.
    pub(super) reason: String,
}

/// Judgement of one number of a run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Judged {
    pub(super) class: Class,
    /// Relative error \[–\]. For a refused run it is that of the run when forced.
    pub(super) error: Option<f64>,
    /// Whether the program warns about the number by default.
    pub(super) warned: bool,
    /// Class of the number if the program does not measure errors (`--no-error`).
    pub(super) unmeasured: Class,
    /// Whether the program warns about the number with `--no-error`.
    pub(super) warned_unmeasured: bool,
}

impl Judged {
    /// Whether the program warns about a number that is within 1 %.
    pub(super) fn is_false_alarm(&self) -> bool {
        self.warned && self.is_good() && self.is_printed()
    }

    /// Whether the program warns with `--no-error` about a number that is within 1 %.
    pub(super) fn is_false_alarm_unmeasured(&self) -> bool {
        self.warned_unmeasured && self.is_good() && self.is_printed()
    }

    /// Whether the run was refused although the number would have been within 1 %.
    pub(super) fn is_wrong_refusal(&self) -> bool {
        matches!(self.class, Class::Refused | Class::Caught) && self.is_good()
    }

    /// Whether the run was refused, and the number stays unknown because the forced run ends early.
    pub(super) fn is_unchecked_refusal(&self) -> bool {
        matches!(self.class, Class::Refused | Class::Caught) && self.error.is_none()
    }

    /// Whether the number is printed and has an error.
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

/// Runs every method on a scene; `base` lends the unchanged parts.
pub(super) fn measure(base: &Simulation, pushed: &Pushed) -> JudgedScene {
    let all = |first, impulsive, of_method: &dyn Fn(StepMethod) -> JudgedRun| {
        let methods = StepMethod::differing(impulsive).map(of_method);
        let runs = std::iter::once(first).chain(methods).collect();
        JudgedScene { runs }
    };
    let exact = match base.variant(&pushed.scene, pushed.record.clone()) {
        Ok(prepared) => prepared,
        // The scene is refused whatever its method.
        Err(error) => {
            let run = |method| JudgedRun::all(method, None, Class::Refused, error.to_string());
            return all(run("exact"), is_impulsive(base), &|method| run(method.name()));
        }
    };
    let (first, reference) = match exact.audited(None) {
        Ok(AuditedRun {
            outcome,
            broken: None,
            balance,
        }) => {
            let by_second_route = JudgedRun {
                residual: Some(balance.residual),
                ..of_exact(&exact, &outcome)
            };
            (by_second_route, Some(outcome))
        }
        Ok(AuditedRun { broken: Some(error), .. }) | Err(error) => (JudgedRun::all("exact", None, Class::Caught, error.to_string()), None),
    };
    all(first, is_impulsive(&exact), &|method| {
        of_method(&exact, method.name(), method.at(pushed.time_step), reference.as_ref())
    })
}

fn is_impulsive(prepared: &Simulation) -> bool {
    prepared.pairs().iter().any(|pair| !pair.law.is_compliant())
}

/// Measures the exact run by the second route.
fn of_exact(exact: &Simulation, reference: &RunResult) -> JudgedRun {
    let n = exact.scene().structures.len();
    let not_verified = |reason: String| JudgedRun::all("exact", None, Class::NotVerified, reason);
    if n > MOST_OF_SECOND_ROUTE {
        return not_verified(format!("the second route is asked for rows of up to {MOST_OF_SECOND_ROUTE}"));
    }
    if hits_at_once(reference) {
        return not_verified("several pairs hit at one instant, which rounding of the second route takes apart".into());
    }
    let own = Quantities::of(reference, n);
    match crate::second_route(exact, Fineness::FINE) {
        Ok(second) => JudgedRun {
            numbers: MethodQuantity::ALL.map(|quantity| {
                let error = own.distance(&Quantities::of_second_route(&second), quantity);
                Judged::plain(Class::of(error, false), error)
            }),
            ..JudgedRun::all("exact", None, Class::Nothing, String::new())
        },
        Err(error) => not_verified(error.to_string()),
    }
}

/// Whether impacts of different pairs coincide up to rounding: their order then changes the result.
fn hits_at_once(outcome: &RunResult) -> bool {
    let all = outcome.collisions.all();
    let impulsive = |one: &&Collision| one.peak_force.is_none();
    let hits: Vec<_> = all.iter().filter(impulsive).collect();
    hits.windows(2)
        .any(|two| two[0].pair != two[1].pair && (two[1].start - two[0].start).abs() < RunValues::AT_ONCE)
}

/// Measures a stepping method by the exact run.
fn of_method(exact: &Simulation, name: &'static str, method: Method, reference: Option<&RunResult>) -> JudgedRun {
    let time_step = method.time_step();
    let stopped = |class, reason| JudgedRun::all(name, time_step, class, reason);
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
    JudgedRun {
        numbers: judge(&prepared, &outcome, reference, wrong),
        residual: Some(balance.residual),
        ..stopped(Class::Nothing, reason.unwrap_or_default())
    }
}

/// Judges every number of a run that ended. `wrong` is the class of all numbers of a run that prints none.
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

/// The printed number that belongs to a quantity.
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

impl JudgedRun {
    /// A run whose numbers all have one class, and no errors.
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
