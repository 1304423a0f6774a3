//! The equation of motion of a cluster at the end of an implicit step: residuals per unit of mass, and their tangents.

use pounding_contact::Overlap;

use crate::implicit::equation::{Cluster, Slopes, StepEnd};
use crate::implicit::trial::{PairTrial, Trial};
use crate::{Floor, Node, RestoringForce, Row, Support, Work};

/// Relative rounding of a displacement, a velocity or a deformation, each the result of up to four operations.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Evaluates the residuals of a cluster; returns the sum of their squares, each times its mass.
///
/// This weight gives light and heavy floors equal importance. Walls have no residual.
#[inline]
pub(crate) fn residual<Column: RestoringForce, C: Cluster>(
    row: &Row<Column>,
    trials: &mut [Trial<Column::Memory>],
    pairs: &mut [PairTrial],
    cluster: &C,
    end: StepEnd<'_>,
    work: &mut Work,
) -> f64 {
    let StepEnd { slopes, ground } = end;
    let mut n_nodes = 0;
    for index in cluster.nodes() {
        let node = &row.nodes()[index];
        match node.support {
            Support::Floor(floor) if C::STOREYS => {
                let (before, rest) = trials.split_at_mut(index);
                let (below, trial) = (&mut before[floor.below], &mut rest[0]);
                follow(trial, slopes);
                let (drift, rate) = (trial.displacement - below.displacement, trial.velocity - below.velocity);
                evaluate(node, trial, drift, rate, slopes, ground.under(index));
                let carrying = &row.nodes()[floor.below];
                stand(node, trial, carrying, below, &floor, slopes);
            }
            Support::Ground | Support::Floor(_) => {
                let trial = &mut trials[index];
                follow(trial, slopes);
                let (drift, rate) = (trial.displacement, trial.velocity);
                evaluate(node, trial, drift, rate, slopes, ground.under(index));
            }
        }
        n_nodes += 1;
    }
    work.force_evaluations += n_nodes;
    for pair in cluster.pairs() {
        couple(row, pair, trials, &mut pairs[pair], end);
    }
    let mut sum = 0.0;
    for index in cluster.nodes() {
        let (node, trial) = (&row.nodes()[index], &mut trials[index]);
        // The net contact force is summed before it is added, so that a mirrored row gives mirrored bits.
        trial.residual -= node.inverse_mass * (trial.force_from_left + trial.force_from_right);
        if !node.is_wall() {
            sum += trial.residual * trial.residual / node.inverse_mass;
        }
    }
    sum
}

/// Updates displacement and velocity from the acceleration.
#[inline]
fn follow<Memory>(trial: &mut Trial<Memory>, slopes: Slopes) {
    trial.displacement = trial.predicted.0 + slopes.displacement * trial.acceleration;
    trial.velocity = trial.predicted.1 + slopes.velocity * trial.acceleration;
}

/// Residual and tangent of a floor with the forces of its storey; floors above and neighbours are excluded.
#[inline]
fn evaluate<Column: RestoringForce>(
    node: &Node<Column>,
    trial: &mut Trial<Column::Memory>,
    drift: f64,
    rate: f64,
    slopes: Slopes,
    ground: f64,
) {
    let w = node.inverse_mass;
    trial.response = node.column.respond(drift, trial.memory);
    let ground = if node.is_wall() { 0.0 } else { ground };
    let (damping, restoring) = (w * node.damping * rate, w * trial.response.force);
    let inertia = slopes.inertia * trial.acceleration;
    trial.residual = inertia + damping + restoring + ground + trial.carried;
    trial.scale = inertia.abs() + damping.abs() + restoring.abs() + ground.abs();
    trial.scale += trial.carried.abs();
    let (displacement, velocity) = extent(trial);
    trial.rounding = ROUNDING * w * (trial.response.tangent.abs() * displacement + node.damping * velocity);
    trial.diagonal = slopes.inertia + w * (node.damping * slopes.velocity + trial.response.tangent * slopes.displacement);
    (trial.lower, trial.upper) = (0.0, 0.0);
    (trial.force_from_left, trial.force_from_right) = (0.0, 0.0);
}

/// Largest displacement and velocity that enter those of a trial. If they far exceed the response of the structure, the prediction is large
/// and cancels.
fn extent<Memory>(trial: &Trial<Memory>) -> (f64, f64) {
    // Unlike `f64::max`, this spends no operations on NaN: no equation with NaN is balanced.
    let larger = |a: f64, b: f64| if a > b { a } else { b };
    (
        larger(trial.displacement.abs(), trial.predicted.0.abs()),
        larger(trial.velocity.abs(), trial.predicted.1.abs()),
    )
}

/// Adds the forces of a storey on the floor below, and the effect of the floor below on the storey.
#[inline]
fn stand<Column: RestoringForce>(
    node: &Node<Column>,
    trial: &mut Trial<Column::Memory>,
    carrying: &Node<Column>,
    below: &mut Trial<Column::Memory>,
    floor: &Floor,
    slopes: Slopes,
) {
    let (w, w_below) = (node.inverse_mass, carrying.inverse_mass);
    let (restoring, stiffness) = (trial.response.force, trial.response.tangent);
    let damping = node.damping * (trial.velocity - below.velocity);
    let tangent = node.damping * slopes.velocity + stiffness * slopes.displacement;
    let (extent, extent_below) = (extent(trial), extent(below));
    let rounding = |(displacement, velocity): (f64, f64)| ROUNDING * (stiffness.abs() * displacement + node.damping * velocity);
    below.residual -= w_below * (restoring + damping);
    let both = rounding(extent) + rounding(extent_below);
    below.push(w_below, restoring.abs() + damping.abs(), tangent, both);
    below.above = -w_below * tangent;
    trial.below = -w * tangent;
    trial.rounding += w * rounding(extent_below);
    // Damping against the ground.
    let against = floor.ground_damping * trial.velocity;
    trial.residual += w * against;
    let (tangent, rounding) = (floor.ground_damping * slopes.velocity, ROUNDING * floor.ground_damping * extent.1);
    trial.push(w, against.abs(), tangent, rounding);
}

/// Adds the pounding force of one pair.
fn couple<Column: RestoringForce>(
    row: &Row<Column>,
    index: usize,
    trials: &mut [Trial<Column::Memory>],
    known: &mut PairTrial,
    StepEnd { slopes, ground }: StepEnd<'_>,
) {
    let pair = &row.pairs()[index];
    (known.force, known.tangent) = (0.0, 0.0);
    let ahead = pair.relation.ahead(|floor| trials[floor].displacement);
    let deformation = ground.deformation(pair, ahead);
    // Impulsive contact acts between steps. A compliant pair that this step brings together may touch a little earlier.
    let near = deformation > 0.0 || known.approach_speed.is_some();
    if !(near && pair.law.is_compliant()) {
        return;
    }
    let faster = pair.relation.ahead(|floor| trials[floor].velocity);
    let overlap = Overlap {
        deformation,
        rate: ground.rate(pair, faster),
        reduced_mass: row.reduced_mass(pair),
        // A building alone has no pairs; pairs that overlap afterwards were marked, with their speed.
        approach_speed: known.approach_speed.unwrap_or(0.0),
    };
    let contact = if deformation > 0.0 {
        pair.law.respond(&overlap)
    } else {
        pair.law.before_touch(&overlap)
    };
    let Some(contact) = contact else {
        return;
    };
    let [left, right] = pair.relation.points();
    let displaced = |floor: usize| trials[floor].displacement.abs();
    let fast = |floor: usize| trials[floor].velocity.abs();
    let (displaced, fast, grounds) = (
        left.of(displaced) + right.of(displaced) + pair.gap(),
        left.of(fast) + right.of(fast),
        ground.extent(pair),
    );
    let rounding = ROUNDING * (contact.stiffness * (displaced + grounds.displacement) + contact.damping * (fast + grounds.velocity));
    let tangent = contact.stiffness * slopes.displacement + contact.damping * slopes.velocity;
    (known.force, known.tangent) = (contact.force, tangent);
    for (floor, part) in pair.relation.pushes() {
        let (inverse_mass, trial) = (row.nodes()[floor].inverse_mass, &mut trials[floor]);
        let (size, off) = (part.abs(), -inverse_mass * tangent);
        // A floor of a line has at most these two neighbours.
        if part < 0.0 {
            trial.force_from_right -= size * contact.force;
            trial.upper = off;
        } else {
            trial.force_from_left += size * contact.force;
            trial.lower = off;
        }
        trial.push(size * inverse_mass, contact.force, size * tangent, rounding);
    }
}
