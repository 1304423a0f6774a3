//! The plan of a scene as JSON: fields of [`Summary`](pounding::report::Summary) where it has them, SI units.

use pounding::report::RecordSummary;
use pounding::scene::{ContactLimit, FloorPair, Implausible, Structure};
use pounding::solver::Opening;
use serde_json::{Value, json};

use super::Plan;
use pounding::text::json_text;

/// The plan as JSON. Facts that are not known or do not apply are null; all that follow from the exact run are null if it fails.
pub(super) fn of(plan: &Plan<'_>) -> String {
    let prepared = plan.prepared;
    let scene = prepared.scene();
    let limits = prepared.critical_time_steps();
    let structures = scene.structures.iter().zip(&limits);
    let doubt = |doubt: &Implausible| json!({"place": doubt.place, "found": doubt.found, "usual": doubt.usual});
    let exact = plan.expected.as_ref().map(|expected| {
        let work = &expected.outcome.work;
        json!({"segments": work.segments, "events": work.events})
    });
    let unneeded = plan.expected.as_ref().map(|expected| &expected.unneeded);
    json_text(&json!({
        "scene": scene,
        "record": RecordSummary::of(prepared),
        "method": {
            "name": scene.method.name(),
            "time_step_s": scene.method.time_step(),
            "duration_s": prepared.duration(),
            "chosen_for_error": prepared.advice().map(|advice| advice.goal.error),
        },
        "structures": structures.map(|(one, limit)| structure(one, *limit)).collect::<Vec<_>>(),
        "base_approaches": approaches(plan),
        "pairs": plan.expected.as_ref().map(|_| pairs(plan)),
        "exact_run": exact,
        "not_needed": unneeded,
        "unusual": prepared.doubts().iter().map(doubt).collect::<Vec<_>>(),
        "warnings": plan.warnings,
    }))
}

/// The largest distance that the bases of neighbours move towards each other, or apart (negative), for every structure and its right
/// neighbour; null if all are shaken at once.
fn approaches(plan: &Plan<'_>) -> Option<Vec<Value>> {
    let openings = plan.prepared.openings();
    let approach = |one: &Opening| json!({"largest_approach_m": one.distance, "time_s": one.time});
    (!openings.is_empty()).then(|| openings.iter().map(approach).collect())
}

fn structure(structure: &Structure, limit: Option<f64>) -> Value {
    let Some(period) = structure.period() else {
        return json!({"name": structure.name()});
    };
    // One for each storey, from the ground up; the first also has its own field.
    let yield_forces = structure.yield_forces();
    json!({
        "name": structure.name(),
        "period_s": period,
        "damping_ratio": structure.damping_ratio(),
        "yield_force_n": yield_forces.first(),
        "yield_forces_n": yield_forces,
        "critical_time_step_s": limit,
    })
}

/// Every pair; the expected collision is null if the pair does not touch in the direction of the scene.
fn pairs(plan: &Plan<'_>) -> Vec<Value> {
    let scene = plan.prepared.scene();
    let limits = plan.expected.as_ref().map(|expected| &expected.limits.contacts);
    let reversed = plan.expected.as_ref().and_then(|expected| expected.reversed.as_ref());
    let contacts: Vec<_> = scene.contacts.iter().flatten().collect();
    let floors = plan.prepared.floors();
    let pair = |(index, facing): (usize, &FloorPair)| {
        let contact = contacts[facing.contact];
        let [left, right] = floors.names(index);
        let limit = limits.into_iter().flatten().find(|limit| limit.pair == index);
        json!({
            "left": left,
            "right": right,
            "gap_m": contact.gap_m,
            "law": contact.law.name(),
            "touches": limit.map(touches),
            "touches_reversed": reversed.map(|run| run.collisions_of(index).next().is_some()),
        })
    };
    floors.facing().iter().enumerate().map(pair).collect()
}

/// A free collision at the largest speed, exact and by the method.
fn touches(limit: &ContactLimit) -> Value {
    let free = limit.free;
    let delivered = free.and_then(|free| free.delivered);
    json!({
        "critical_time_step_s": limit.critical_time_step,
        "approach_speed_m_per_s": free.map(|free| free.approach_speed),
        "contact_duration_s": free.and_then(|free| free.duration),
        "steps_per_contact": free.and_then(|free| free.steps),
        "restitution": free.and_then(|free| free.restitution),
        "least_restitution": delivered.map(|delivered| delivered.range[0]),
        "largest_restitution": delivered.map(|delivered| delivered.range[1]),
    })
}
