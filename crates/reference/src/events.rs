//! Events: instants at which the equations of motion, or the recorded values, change.

use pounding_contact::SLOWEST_APPROACH;

use super::equations::{Equations, NOW};
use super::law::Law;
use super::links::Change;
use super::model::{TIME, velocity};
use super::phases::ContactPhase;
use super::storey::Branch;
use super::variable::Variable;

/// An event that the present phases allow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Event {
    /// The segment of the record ends. It is an event only if the variable is not the time.
    SegmentEnd,
    /// A velocity changes sign: peak of displacement; unloading of a storey on the ground.
    Turn(usize),
    /// The drift rate of a storey on another floor changes sign: peak of drift, unloading.
    DriftTurn(usize),
    /// Columns reach their yield force.
    Yield(usize),
    /// The elastic part of the drift of columns that yield smoothly changes sign.
    Straight(usize),
    /// The force of columns that yield smoothly under gravity has a maximum or minimum while they drift on.
    Soften(usize),
    /// The net pounding force on a structure between two touching neighbours changes sign.
    Balance(usize),
    /// The deformation rate of a pair changes sign: largest or smallest distance or deformation.
    Reversal(usize),
    /// A pair touches.
    Touch(usize),
    /// A pair parts.
    Part(usize),
    /// The pounding force of a pair has a maximum or minimum while its damper acts.
    ForcePeak(usize),
    /// The deformation of a pair passes to the other slope of its law.
    Bend(usize),
    /// The formula of a pair begins to pull.
    Clamp(usize),
    /// The formula of a clamped pair pushes again.
    Grip(usize),
    /// The force of a pair at rest fades.
    Fade(usize),
    /// A pair at rest without a force would close or open.
    Stir(usize),
    /// The friction that holds a floor reaches its limit.
    Slip(usize),
    /// The friction that holds a floor has a maximum or minimum.
    FrictionPeak(usize),
    /// A link changes.
    Link(usize, Change),
}

/// Lists the events that the present phases allow while a step runs in a variable.
pub(super) fn list(motion: &Equations, variable: Variable, events: &mut Vec<Event>) {
    events.clear();
    let parting = match variable {
        Variable::RootOfDeformation { pair, .. } => {
            events.push(Event::SegmentEnd);
            Some(pair)
        }
        Variable::Time | Variable::RootOfTime { .. } => None,
    };
    for (index, phase) in motion.phases.structures.iter().enumerate() {
        if phase.held.is_some() {
            events.extend([Event::Slip(index), Event::FrictionPeak(index)]);
            events.extend(phase.push.map(|_| Event::Balance(index)));
        }
        if motion.model.is_wall(index) {
            continue;
        }
        events.push(Event::Turn(index));
        let storey = &motion.model.structures[index];
        if storey.below.is_some() {
            events.push(Event::DriftTurn(index));
        }
        match phase.branch {
            Branch::Elastic { .. } if storey.columns.yield_force.is_finite() => {
                events.push(Event::Yield(index));
            }
            Branch::Elastic { .. } | Branch::Yielding { .. } => {}
            Branch::Smooth { .. } => {
                events.push(Event::Straight(index));
                if storey.columns.hardening < 0.0 {
                    events.push(Event::Soften(index));
                }
            }
        }
        if phase.push.is_some() {
            events.push(Event::Balance(index));
        }
    }
    list_of_pairs(motion, parting, events);
    for (index, link) in motion.model.links.iter().enumerate() {
        let changes = motion.phases.links[index].changes(link);
        events.extend(changes.into_iter().flatten().map(|change| Event::Link(index, change)));
    }
}

/// Lists the events of pairs; the step runs in the root of the deformation of the pair that parts, if any.
fn list_of_pairs(motion: &Equations, parting: Option<usize>, events: &mut Vec<Event>) {
    for (index, phase) in motion.phases.pairs.iter().enumerate() {
        if !matches!(phase.contact, ContactPhase::Resting { .. }) {
            events.push(Event::Reversal(index));
        }
        if let (Law::Compliant(law), true) = (motion.model.pairs[index].law, phase.contact.touches())
            && law.bend().is_some()
            && phase.bent != (phase.direction > 0.0)
        {
            events.push(Event::Bend(index));
        }
        match phase.contact {
            // Deformation grows only while the rate is positive, and every change of its sign ends a step.
            ContactPhase::Apart if phase.direction > 0.0 => events.push(Event::Touch(index)),
            ContactPhase::Apart => {}
            ContactPhase::Approach { .. } => events.push(Event::ForcePeak(index)),
            ContactPhase::Restitution { .. } => {
                if parting != Some(index) {
                    events.push(Event::Part(index));
                }
                if matches!(motion.model.pairs[index].law, Law::Compliant(law) if law.is_damped_throughout) {
                    events.extend([Event::ForcePeak(index), Event::Clamp(index)]);
                }
            }
            ContactPhase::Clamped => events.extend([Event::Part(index), Event::Grip(index)]),
            ContactPhase::Resting { presses: true, .. } => {
                events.extend([Event::ForcePeak(index), Event::Fade(index)]);
            }
            ContactPhase::Resting { presses: false, .. } => events.push(Event::Stir(index)),
        }
    }
}

impl Event {
    /// Function that is negative once the event has happened.
    ///
    /// `scratch` receives a derivative of the unknowns.
    pub(super) fn value(self, motion: &Equations, y: &[f64], scratch: &mut [f64]) -> f64 {
        let Equations { model, phases, .. } = motion;
        match self {
            Self::SegmentEnd => motion.segment.length - y[TIME],
            Self::Turn(structure) => phases.structures[structure].direction * y[velocity(structure)],
            Self::DriftTurn(structure) => phases.structures[structure].drift_direction * model.drift_rate(structure, y),
            Self::Yield(structure) => {
                let direction = phases.structures[structure].drift_direction;
                let limit = model.structures[structure].columns.limit();
                limit - direction * motion.yielding_force(structure, y)
            }
            Self::Straight(structure) => {
                let Branch::Smooth { side } = phases.structures[structure].branch else {
                    return 0.0;
                };
                let smooth = model.structures[structure].columns.smooth;
                smooth.map_or(0.0, |smooth| side * y[smooth.unknown])
            }
            Self::Soften(structure) => phases.structures[structure].hardens * phases.tangent(structure, model, y),
            Self::Balance(structure) => {
                let push = phases.structures[structure].push;
                motion.slope(NOW, y, scratch);
                push.map_or(0.0, |sign| sign * motion.push(structure, scratch))
            }
            Self::Reversal(pair) => phases.pairs[pair].direction * model.rate(pair, y),
            Self::Touch(pair) => -model.deformation(pair, y),
            Self::Part(pair) => model.deformation(pair, y),
            Self::ForcePeak(pair) => {
                motion.slope(NOW, y, scratch);
                match phases.pairs[pair].contact {
                    ContactPhase::Approach { rising, .. } | ContactPhase::Restitution { rising } => {
                        rising * motion.force_rate(pair, y, scratch)
                    }
                    ContactPhase::Resting { .. } => motion.resting_peak(pair, y, scratch),
                    ContactPhase::Apart | ContactPhase::Clamped => 0.0,
                }
            }
            Self::Bend(pair) => motion.before_bend(pair, y).unwrap_or(0.0),
            Self::Clamp(pair) => motion.grip(pair, y),
            Self::Grip(pair) => -motion.grip(pair, y),
            Self::Fade(pair) => {
                motion.slope(NOW, y, scratch);
                scratch[model.impulse(pair)]
            }
            Self::Stir(pair) => motion.idles(pair, y, scratch),
            Self::Slip(floor) => motion.before_slip(floor, y, scratch),
            Self::FrictionPeak(floor) => motion.friction_peak(floor, y, scratch),
            Self::Link(link, change) => motion.before_change(link, change, y),
        }
    }

    /// Whether its function is a velocity or the force of a damper: two changes of sign in a step then show in the middle.
    pub(super) fn is_reversal(self) -> bool {
        matches!(
            self,
            Self::Turn(_) | Self::DriftTurn(_) | Self::Reversal(_) | Self::Link(_, Change::Turns | Change::Crosses)
        )
    }

    /// Changes the phases by the event. Touches and rest of impulsive pairs are decided afterwards.
    pub(super) fn apply(self, motion: &mut Equations, y: &[f64]) {
        let Equations { model, phases, .. } = motion;
        match self {
            // Pairs at rest and friction are decided again after every event.
            Self::SegmentEnd | Self::Fade(_) | Self::Stir(_) | Self::Slip(_) | Self::FrictionPeak(_) => {}
            Self::Turn(structure) => phases.turn(structure, model, y),
            Self::DriftTurn(structure) => phases.turn_drift(structure, model, y),
            Self::Yield(structure) => motion.yields(structure, y),
            Self::Straight(structure) => phases.straighten(structure),
            Self::Soften(structure) => phases.structures[structure].hardens *= -1.0,
            Self::Link(link, change) => motion.change_link(link, change, y),
            Self::Balance(structure) => {
                let push = &mut phases.structures[structure].push;
                *push = push.map(|sign| -sign);
            }
            Self::Reversal(pair) => {
                let phase = &mut phases.pairs[pair];
                phase.direction = -phase.direction;
                phase.contact = phase.contact.turned(phase.direction);
            }
            Self::Touch(pair) => {
                if matches!(model.pairs[pair].law, Law::Compliant(_)) {
                    let phase = &mut phases.pairs[pair];
                    phase.contact = ContactPhase::Approach {
                        touch: Some(y[TIME]),
                        rising: 1.0,
                    };
                    phase.approach_speed = model.rate(pair, y).max(SLOWEST_APPROACH);
                }
            }
            Self::Part(pair) => phases.pairs[pair].contact = ContactPhase::Apart,
            Self::ForcePeak(pair) => {
                if let ContactPhase::Approach { rising, .. } | ContactPhase::Restitution { rising } | ContactPhase::Resting { rising, .. } =
                    &mut phases.pairs[pair].contact
                {
                    *rising = -*rising;
                }
            }
            Self::Bend(pair) => phases.pairs[pair].bent = !phases.pairs[pair].bent,
            // If a parting or a reversal happens at the same instant, the phase has changed already.
            Self::Clamp(pair) => {
                let contact = &mut phases.pairs[pair].contact;
                if matches!(contact, ContactPhase::Restitution { .. }) {
                    *contact = ContactPhase::Clamped;
                }
            }
            Self::Grip(pair) => {
                let contact = &mut phases.pairs[pair].contact;
                if matches!(contact, ContactPhase::Clamped) {
                    *contact = ContactPhase::Restitution { rising: 1.0 };
                }
            }
        }
    }
}
