//! What the time step of a method can follow: critical time steps, and the collisions that its steps resolve.

use pounding_contact::{ContactLaw, FreeImpact, FreePair, Overlap};
use pounding_solver::{Collision, Oscillation, Pair};

use crate::{Delivered, FreeCollision, RunResult, Simulation};

/// Steps per contact below which a run is warned of.
///
/// With ten, every method delivers every law's impulse to within 6 %, for e = 0.65 and more; at five some are 11 % off. Laws
/// that damp more need more of them.
pub const STEPS_PER_CONTACT: f64 = 10.0;

/// Steps per natural period below which a run is warned of: the usual rule.
pub const STEPS_PER_PERIOD: f64 = 10.0;

/// What a method can follow of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Limits {
    /// Of every pair that touches, from the left.
    pub contacts: Vec<ContactLimit>,
}

/// What a method can follow of a pair's collisions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactLimit {
    /// Index of the pair.
    pub pair: usize,
    /// The free collision at the largest approach speed that is expected; nothing where the pair presses without approach.
    pub free: Option<FreeLimit>,
    /// Time step \[s\] from which on the pair may be unstable while it touches; nothing for a method or law without such a
    /// limit.
    ///
    /// The least over its collisions, each with the stiffness at its largest force. What of that force is the damper's,
    /// and the columns of both structures, make it smaller than it is; a structure that is pressed from both sides allows
    /// down to 1/√2 of it.
    pub critical_time_step: Option<f64>,
}

/// A free collision of a pair, and how a method follows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeLimit {
    /// Approach speed \[m/s\], > 0.
    pub approach_speed: f64,
    /// e that the law delivers \[–\]; nothing where its damping lets hardly anything come back.
    pub restitution: Option<f64>,
    /// Duration until the force ends \[s\]; nothing for an impulsive law, and as above.
    pub duration: Option<f64>,
    /// Steps, or sub-steps, while the pair overlaps: a clamped force may have ended earlier.
    pub steps: Option<f64>,
    /// What the method delivers; nothing for one without time steps, and where it cannot be measured or has so many steps
    /// (ten thousand) that it need not.
    pub delivered: Option<Delivered>,
}

/// Steps per contact above which what a method delivers is not asked.
const MANY_STEPS: f64 = 1e4;

impl Simulation {
    /// What the method can follow, for the collisions of a run of the same scene: best the exact one.
    ///
    /// Of the collisions of a stepping method the approach speed is not known; it is taken from the largest force, as if
    /// the spring alone had stopped the pair.
    pub fn limits(&self, expected: &RunResult) -> Limits {
        let pairs = self.pairs().iter().enumerate();
        let contacts = pairs.filter_map(|(index, pair)| {
            let collisions: Vec<_> = expected.collisions_of(index).collect();
            (!collisions.is_empty()).then(|| self.contact_limit(index, pair, &collisions))
        });
        Limits {
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

    /// Masses of a pair \[kg\]; that of a wall is infinite.
    fn masses(&self, pair: &Pair) -> [f64; 2] {
        [pair.left(), pair.right()].map(|index| {
            let made = self.floors().all()[index].made_of;
            made.map_or(f64::INFINITY, |made| made.mass_kg)
        })
    }

    /// Circular frequency of a floor \[rad/s\], that of the fastest mode of its building; 0 of a wall.
    fn angular_frequency(&self, index: usize) -> f64 {
        let fastest = self.scene().structures[self.floors().all()[index].structure].fastest();
        fastest.map_or(0.0, |fastest| fastest.angular_frequency)
    }
}

/// e that a law delivers.
fn restitution(law: &ContactLaw, impact: Option<&FreeImpact>) -> Option<f64> {
    impact
        .map(|impact| impact.restitution)
        .or_else(|| law.impulsive().map(|law| law.restitution))
}

/// A collision that is expected.
#[derive(Debug, Clone, Copy)]
struct Expected {
    pair: FreePair,
    /// Largest force \[N\]; 0 of an impulsive law.
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

    /// Oscillation of the pair about the deformation at which its spring has the largest force; nothing for an impulsive
    /// law.
    fn oscillation(&self, law: &ContactLaw) -> Option<Oscillation> {
        let FreePair {
            reduced_mass,
            approach_speed,
        } = self.pair;
        let form = law.form(reduced_mass, approach_speed)?;
        let contact = law.respond(&Overlap {
            deformation: form.spring.deformation(self.peak_force),
            // Approaching, so that every damper acts, but so slowly that it pushes nothing.
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

/// Approach speed \[m/s\] of a pair that a spring alone stops with a force \[N\]: ½ m v² = F δ/(n + 1).
fn speed_to(force: f64, law: &ContactLaw, pair: &FreePair) -> f64 {
    law.form(pair.reduced_mass, 1.0).map_or(0.0, |form| {
        let stored = force * form.spring.deformation(force) / (form.spring.power.value() + 1.0);
        (2.0 * stored / pair.reduced_mass).sqrt()
    })
}

/// The same with the columns of both structures: an upper bound of the frequency.
fn with_columns(contact: Oscillation, own: [f64; 2]) -> Oscillation {
    let column = own[0].max(own[1]);
    let omega = contact.angular_frequency;
    let angular_frequency = (omega * omega + column * column).sqrt();
    Oscillation {
        angular_frequency,
        damping_ratio: contact.damping_ratio * omega / angular_frequency,
    }
}
