//! Limits of a method's time step: critical time steps, and collisions that the steps resolve.

use pounding_contact::{ContactLaw, FreeImpact, FreePair, Overlap};
use pounding_solver::{Collision, Oscillation, Pair};

use crate::{DeliveredRestitution, FreeCollision, RunResult, Simulation};

/// Limits of a method in a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodLimits {
    /// Limits for every pair that touches, from the left.
    pub contacts: Vec<ContactLimit>,
}

impl MethodLimits {
    /// Number of steps in a contact below which a run gives a warning.
    ///
    /// With ten steps, every method delivers the impulse of every law to within 6 % for e ≥ 0.65; with five, some are 11 % off. Laws with
    /// more damping need more steps.
    pub const STEPS_PER_CONTACT: f64 = 10.0;

    /// Number of steps in a natural period below which a run gives a warning: the usual rule.
    pub const STEPS_PER_PERIOD: f64 = 10.0;
}

/// Limits of a method in the collisions of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactLimit {
    /// Index of the pair.
    pub pair: usize,
    /// Free collision at the largest expected approach speed; `None` if the pair presses without approach.
    pub free: Option<FreeLimit>,
    /// Time step \[s\] above which the pair may be unstable while it touches; `None` for a method or a law without such a limit.
    ///
    /// It is the least over the collisions, each with the stiffness at its largest force. It is too small if the damper contributes to that
    /// force, and because it includes the columns of both structures. For a structure that is pressed from both sides the limit may be 1/√2
    /// of it.
    pub critical_time_step: Option<f64>,
}

/// A free collision of a pair, and its resolution by a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeLimit {
    /// Approach speed \[m/s\], > 0.
    pub approach_speed: f64,
    /// e that the law delivers \[–\]; `None` if its damping leaves almost no rebound.
    pub restitution: Option<f64>,
    /// Duration until the force ends \[s\]; `None` for an impulsive law, and if the damping leaves almost no rebound.
    pub duration: Option<f64>,
    /// Number of steps, or sub-steps, while the pair overlaps; a clamped force may end earlier.
    pub steps: Option<f64>,
    /// Restitution that the method delivers; `None` for a method without time steps, if it cannot be measured, and above ten thousand
    /// steps.
    pub delivered: Option<DeliveredRestitution>,
}

/// Number of steps in a contact above which the delivered restitution is not measured.
const MANY_STEPS: f64 = 1e4;

impl Simulation {
    /// Finds the limits of the method for the collisions of a run of the same scene, preferably the exact run.
    ///
    /// The approach speed of a stepping method's collision is not known. It is estimated from the largest force, as if only the spring had
    /// stopped the pair.
    pub fn limits(&self, expected: &RunResult) -> MethodLimits {
        let pairs = self.pairs().iter().enumerate();
        let contacts = pairs.filter_map(|(index, pair)| {
            let collisions: Vec<_> = expected.collisions_of(index).collect();
            (!collisions.is_empty()).then(|| self.contact_limit(index, pair, &collisions))
        });
        MethodLimits {
            contacts: contacts.collect(),
        }
    }

    fn contact_limit(&self, index: usize, pair: &Pair, collisions: &[&Collision]) -> ContactLimit {
        let masses = self.masses(pair);
        let own = [pair.left(), pair.right()].map(|index| self.angular_frequency(index));
        let expected = collisions.iter().map(|one| Expected::new(one, pair, masses));
        let integrator = self.method().integrator();
        let critical = expected.clone().filter_map(|one| {
            let contact = with_columns(one.oscillation(&pair.law)?, own);
            integrator.critical_time_step_in_contact(&contact)
        });
        let speed = expected.map(|one| one.pair.approach_speed).fold(0.0, f64::max);
        ContactLimit {
            pair: index,
            free: (speed > 0.0).then(|| self.free_limit(&pair.law, FreeCollision { masses, speed })),
            critical_time_step: critical.min_by(f64::total_cmp),
        }
    }

    fn free_limit(&self, law: &ContactLaw, collision: FreeCollision) -> FreeLimit {
        let method = self.method();
        let impact = FreeImpact::of(law, &collision.free_pair());
        let overlap = impact.map(|impact| impact.duration);
        let restitution = restitution(law, impact.as_ref());
        let sub_steps = f64::from(method.contact_substeps());
        let steps = |duration: f64| Some(sub_steps * duration / method.time_step()?);
        let steps = overlap.and_then(steps);
        let asked = method.time_step().is_some() && steps.is_none_or(|steps| steps < MANY_STEPS);
        let delivered = restitution.filter(|_| asked).and_then(|right| {
            let delivered = collision.delivered(*law, &method, right, overlap);
            delivered.ok()
        });
        FreeLimit {
            approach_speed: collision.speed,
            restitution,
            duration: impact.map(|impact| impact.force_duration),
            steps,
            delivered,
        }
    }

    /// Masses of a pair \[kg\]; infinite for a wall.
    fn masses(&self, pair: &Pair) -> [f64; 2] {
        [pair.left(), pair.right()].map(|index| {
            let made = self.floors().all()[index].made_of;
            made.map_or(f64::INFINITY, |made| made.mass_kg)
        })
    }

    /// Circular frequency of the fastest mode of a floor's building \[rad/s\]; 0 for a wall.
    fn angular_frequency(&self, index: usize) -> f64 {
        let fastest = self.scene().structures[self.floors().all()[index].structure].fastest();
        fastest.map_or(0.0, |fastest| fastest.angular_frequency)
    }
}

/// Restitution e that a law delivers \[–\].
fn restitution(law: &ContactLaw, impact: Option<&FreeImpact>) -> Option<f64> {
    impact
        .map(|impact| impact.restitution)
        .or_else(|| law.impulsive().map(|law| law.restitution))
}

/// An expected collision.
#[derive(Debug, Clone, Copy)]
struct Expected {
    pair: FreePair,
    /// Largest force \[N\]; 0 for an impulsive law.
    peak_force: f64,
}

impl Expected {
    fn new(collision: &Collision, pair: &Pair, masses: [f64; 2]) -> Self {
        let free = FreeCollision { masses, speed: 0.0 }.free_pair();
        let peak_force = collision.peak_force.unwrap_or(0.0);
        let known = collision.approach_speed;
        Self {
            pair: FreePair {
                approach_speed: known.unwrap_or_else(|| speed_to(peak_force, &pair.law, &free)),
                ..free
            },
            peak_force,
        }
    }

    /// Oscillation of the pair about the deformation at which its spring has the largest force; `None` for an impulsive law.
    fn oscillation(&self, law: &ContactLaw) -> Option<Oscillation> {
        let FreePair {
            reduced_mass,
            approach_speed,
        } = self.pair;
        let form = law.form(reduced_mass, approach_speed)?;
        let contact = law.respond(&Overlap {
            deformation: form.deformation(self.peak_force),
            // The pair approaches, so that every damper acts, but so slowly that dampers add no force.
            rate: f64::MIN_POSITIVE,
            reduced_mass,
            approach_speed,
        })?;
        let angular_frequency = (contact.stiffness / reduced_mass).sqrt();
        (angular_frequency > 0.0 && angular_frequency.is_finite()).then_some(Oscillation {
            angular_frequency,
            damping_ratio: contact.damping / (2.0 * reduced_mass * angular_frequency),
        })
    }
}

/// Approach speed \[m/s\] of a pair that only a spring stops with a force \[N\]: ½ m v² = F δ/(n + 1).
fn speed_to(force: f64, law: &ContactLaw, pair: &FreePair) -> f64 {
    law.form(pair.reduced_mass, 1.0)
        .map_or(0.0, |form| (2.0 * form.stored(force) / pair.reduced_mass).sqrt())
}

/// Adds the columns of both structures to a contact's oscillation: an upper bound of the frequency.
fn with_columns(contact: Oscillation, own: [f64; 2]) -> Oscillation {
    let column = own[0].max(own[1]);
    let omega = contact.angular_frequency;
    let angular_frequency = (omega * omega + column * column).sqrt();
    Oscillation {
        angular_frequency,
        damping_ratio: contact.damping_ratio * omega / angular_frequency,
    }
}
