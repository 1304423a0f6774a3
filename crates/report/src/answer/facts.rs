//! Facts about a run: the ground motion, the method, how far the numbers are from the exact run, work and energy.

use pounding_scene::{Collapse, Errors, Method, PairErrors, QuantityGroup, Review, RunValues, Simulation};
use pounding_solver::Work;
use pounding_text::{digits, percent, short};

use super::brief;
use crate::summary::{RecordSummary, Summary};

/// Energies below this part of the scale are rounding.
const ROUNDING: f64 = 1e-12;

/// The ground motion: its source, the readings of its file, and its processing.
pub fn record_facts(prepared: &Simulation) -> Vec<String> {
    let (one, used) = (RecordSummary::of(prepared), &prepared.scene().record);
    let gravity = used.gravity_m_per_s2;
    let mut facts = vec![
        format!("source: {}", used.source),
        format!(
            "as used: {} samples, {} s apart, {} s long; peak {} g = {} m/s² at {} s (g = {gravity} m/s²)",
            one.n_samples,
            digits(one.time_step_s),
            digits(prepared.record().duration()),
            short(one.peak_m_per_s2 / gravity),
            short(one.peak_m_per_s2),
            digits(one.pga_time_s)
        ),
        format!("processing: {}", processed(&one)),
    ];
    facts.extend(one.sha256.iter().map(|hash| format!("SHA-256 of the file: {hash}")));
    if !one.provenance.is_empty() {
        facts.push(format!("its file says: {}", one.provenance.replace('\n', "; ")));
    }
    facts.extend(one.readings.iter().map(|reading| {
        let line = reading.line.map_or_else(String::new, |line| format!(", line {line}"));
        format!("read, {}{line}: {}", reading.what, reading.found)
    }));
    facts
}

/// What was done to the ground motion, and the factor that came of it.
pub(super) fn processed(record: &RecordSummary) -> String {
    if record.processing.is_empty() {
        return "none: as its source has it".into();
    }
    let mut all = record.processing.clone();
    if record.scale_factor.to_bits() != 1.0_f64.to_bits() {
        all.push(format!("in all × {}", short(record.scale_factor)));
    }
    all.join("; ")
}

/// The method, its settings, and how it was chosen, for a run that lasts as long as the scene asks or ends by a collapse.
pub fn method_facts(prepared: &Simulation, collapse: Option<Collapse>) -> Vec<String> {
    let method = prepared.scene().method;
    let name = method.name();
    let mut facts = vec![format!("method: {}, {}", name.replace('_', " "), brief::lasts(prepared, collapse))];
    let settings = serde_json::to_value(method).unwrap_or_default();
    let settings = settings[name].as_object().into_iter().flatten();
    facts.extend(settings.map(|(name, value)| {
        let text = || value.as_str().map_or_else(|| value.to_string(), String::from);
        format!("{name}: {}", value.as_f64().map_or_else(text, digits))
    }));
    facts.extend(prepared.advice().map(|advice| {
        let (best, goal) = (advice.best(), percent(advice.goal.error));
        if best.method == advice.exact.method {
            return format!("chosen: nothing cheaper keeps all errors below {goal}; {SEARCHED}");
        }
        format!(
            "chosen: the cheapest that keeps all errors below {goal}; its largest is {} ({}); {SEARCHED}",
            percent(best.error),
            best.worst
        )
    }));
    facts
}

/// The cost of the search for a method.
const SEARCHED: &str = "looking for it took the exact run and many others, so that for one run it saves nothing";

/// The states that histories keep.
pub(super) fn histories(summary: &Summary, sampling: &str) -> Vec<String> {
    vec![format!(
        "histories: every {} s: {sampling}",
        digits(summary.method.history_interval_s)
    )]
}

/// The errors, or why they are not known.
pub(super) fn errors(prepared: &Simulation, review: &Review) -> Vec<String> {
    let said = match &review.errors {
        Errors::Exact => {
            if let Method::Exact { tolerance, .. } = prepared.scene().method
                && tolerance > 1e-16
            {
                format!("that of the tolerance, {tolerance:e} per piece in compliant contact")
            } else {
                "none beyond rounding: the method is exact".into()
            }
        }
        Errors::Doubtful => "not known: the method is exact, but this run has gone wrong (see the warnings)".into(),
        Errors::NotMeasured => "not measured (--no-error)".into(),
        Errors::Unknown(reason) => format!("not known, the exact run fails: {reason}"),
        Errors::Measured(errors, _) => {
            let (largest, of) = errors.largest(QuantityGroup::All);
            let largest = match largest {
                0.0 => "there is none".into(),
                largest if largest.is_finite() => format!("the largest is {} ({of})", percent(largest)),
                _ if errors.pairs().iter().any(PairErrors::differ) => "the numbers of collisions differ".into(),
                _ => format!("the exact run has no {of}, or this run has none"),
            };
            format!(
                "below each number, its distance from the exact run; that of a residual below {} of the peak is relative to {0} of it; {largest}",
                percent(RunValues::LEAST_PART)
            )
        }
    };
    vec![format!("errors: {said}")]
}

/// What the run cost, and the exact one beside it.
pub(super) fn work(review: &Review) -> Vec<String> {
    let exact = |work: &Work| format!("{} pieces of motion, {} events", work.segments, work.events);
    let own = &review.outcome.work;
    let mut facts = vec![if own.steps == 0 {
        format!("work: {}", exact(own))
    } else {
        format!(
            "work: {} steps, {} force evaluations, {} Newton iterations, {} steps in contact",
            own.steps, own.force_evaluations, own.newton_iterations, own.touching_steps
        )
    }];
    if let Errors::Measured(_, work) = &review.errors {
        facts.push(format!("exact run: {}", exact(work)));
    }
    facts
}

/// Where the energy went.
pub(super) fn ledger(summary: &Summary) -> Vec<String> {
    let one = &summary.ledger;
    let terms = [
        ("energy at the start", one.initial_j),
        ("work of the shaking", one.input_j),
        ("work of bases that move towards each other", one.opening_j),
        ("kinetic energy at the end", one.kinetic_j),
        ("strain energy at the end", one.strain_j),
        ("taken by viscous damping", one.damping_j),
        ("taken by yielding", one.hysteretic_j),
        ("taken by impulsive impacts", one.impact_j),
        ("taken by compliant contact", one.contact_j),
        ("taken by links", one.link_j),
    ];
    let known = terms.iter().filter(|(_, value)| value.abs() > ROUNDING * one.scale_j);
    let known = known.map(|(what, value)| format!("{what}: {} kJ", short(value / 1e3)));
    let rest = format!(
        "left over by the balance: {} of the {} kJ that energies are measured by",
        percent(one.residual),
        short(one.scale_j / 1e3)
    );
    known.chain([rest]).collect()
}
