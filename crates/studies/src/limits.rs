//! What the time step of a method can follow: critical time steps, and the collisions that its steps resolve.

use pounding_contact::{ContactLaw, FreeImpact, FreePair, Overlap};
use pounding_solver::{Collision, Oscillation, Pair};

use crate::free_collision::{Collision as FreeCollision, Delivered};
use crate::{Method, Outcome, Prepared, Structure};

/// Steps per contact below which a run is warned of.
///
/// With ten, every method delivers every law's impulse to within 6 %, for e = 0.65 and more; at five some are 11 % off. Laws
/// that damp more need more of them.
pub const STEPS_PER_CONTACT: f64 = 10.0;

/// What a method can follow of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Limits {
    /// Of every structure and wall, from the left, the time step \[s\] from which on it grows without bound, though it
    /// touch nobody; nothing for a wall, and for a method without such a limit.
    pub structures: Vec<Option<f64>>,
    /// Of every pair that touches, from the left.
    pub contacts: Vec<ContactLimit>,
}

/// What a method can follow of a pair's collisions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactLimit {
    /// Index of the pair.
    pub pair: usize,
    /// Approach speed that is expected \[m/s\]: the largest, or that of the largest impulse where none is known.
    pub approach_speed: f64,
    /// e that the law delivers to a free collision at that speed \[–\]; nothing where its damping lets hardly anything
    /// come back.
    pub restitution: Option<f64>,
    /// Duration of that collision \[s\]; nothing for an impulsive law, and as above.
    pub duration: Option<f64>,
    /// Steps, or sub-steps, in it.
    pub steps: Option<f64>,
    /// Time step \[s\] from which on the pair is unstable while it touches, at the largest force that is expected; nothing
    /// for a method or law without such a limit.
    pub critical_time_step: Option<f64>,
}

impl Prepared {
    /// What the method can follow, for the collisions of a run of the same scene: best the exact one.
    pub fn limits(&self, expected: &Outcome) -> Limits {
        let pairs = self.pairs().iter().enumerate();
        let contacts = pairs.filter_map(|(index, pair)| {
            let all = expected.collisions.all().iter();
            let collisions: Vec<_> = all.filter(|one| one.pair == index).collect();
            self.contact_limit((index, pair), &collisions)
        });
        Limits {
            structures: self.scene().critical_time_steps().collect(),
            contacts: contacts.collect(),
        }
    }

    fn contact_limit(
        &self,
        (index, pair): (usize, &Pair),
        collisions: &[&Collision],
    ) -> Option<ContactLimit> {
        let method = self.method();
        let collision = self.free_collision(pair, collisions)?;
        let free = collision.free_pair();
        let impact = FreeImpact::of(&pair.law, &free);
        let duration = impact.map(|impact| impact.duration);
        let sub_steps = sub_steps(&method);
        let steps = |duration: f64| Some(sub_steps * duration / method.time_step()?);
        let forces = collisions.iter().filter_map(|one| one.peak_force);
        let oscillation = oscillation(&pair.law, &free, forces.fold(0.0, f64::max));
        let critical = |pair: Oscillation| {
            let integrator = method.integrator();
            integrator.critical_time_step_in_contact(&pair)
        };
        let own = [pair.left, pair.right].map(|index| self.angular_frequency(index));
        Some(ContactLimit {
            pair: index,
            approach_speed: collision.speed,
            restitution: restitution(&pair.law, impact.as_ref()),
            duration,
            steps: duration.and_then(steps),
            critical_time_step: oscillation
                .map(|contact| with_columns(contact, own))
                .and_then(critical),
        })
    }

    /// What the method delivers to the collision that is expected of a pair; nothing where that cannot be measured.
    pub fn delivered(&self, limit: &ContactLimit) -> Option<Delivered> {
        let pair = &self.pairs()[limit.pair];
        let collision = FreeCollision {
            masses: self.masses(pair),
            speed: limit.approach_speed,
        };
        let right = (limit.restitution?, limit.duration);
        collision.delivered(pair.law, &self.method(), right).ok()
    }

    /// The collision that is expected of a pair, as if nothing else acted on it; nothing where it never touches.
    fn free_collision(&self, pair: &Pair, collisions: &[&Collision]) -> Option<FreeCollision> {
        let masses = self.masses(pair);
        let one = FreeCollision { masses, speed: 1.0 }.free_pair();
        let known = collisions.iter().filter_map(|one| one.approach_speed);
        let impulses = collisions.iter().map(|one| one.impulse);
        // H = m (1+e) v₀.
        let of_impulse =
            |impulse: f64| impulse / one.impulse(pair.law.restitution().unwrap_or(0.0));
        let speed = known
            .max_by(f64::total_cmp)
            .or_else(|| impulses.max_by(f64::total_cmp).map(of_impulse))?;
        (speed > 0.0).then_some(FreeCollision { masses, speed })
    }

    /// Masses of a pair \[kg\]; that of a wall is infinite.
    fn masses(&self, pair: &Pair) -> [f64; 2] {
        [pair.left, pair.right].map(|index| match &self.scene().structures[index] {
            Structure::Sdof(sdof) => sdof.mass_kg,
            Structure::Wall => f64::INFINITY,
        })
    }

    /// Circular frequency of a structure \[rad/s\]; 0 of a wall.
    fn angular_frequency(&self, index: usize) -> f64 {
        match &self.scene().structures[index] {
            Structure::Sdof(sdof) => sdof.oscillation().angular_frequency,
            Structure::Wall => 0.0,
        }
    }
}

/// e that a law delivers.
fn restitution(law: &ContactLaw, impact: Option<&FreeImpact>) -> Option<f64> {
    impact
        .map(|impact| impact.restitution)
        .or_else(|| law.impulsive().map(|law| law.restitution))
}

/// Steps that a method takes in a time step while structures touch.
fn sub_steps(method: &Method) -> f64 {
    match method {
        Method::CentralDifference {
            contact_substeps, ..
        } => f64::from(*contact_substeps),
        Method::Newmark { .. }
        | Method::Hht { .. }
        | Method::VelocityVerlet { .. }
        | Method::Rk4 { .. }
        | Method::MoreauJean { .. }
        | Method::Exact { .. }
        | Method::Accuracy(_) => 1.0,
    }
}

/// Oscillation of a pair about the deformation at which its spring has the peak force; nothing for an impulsive law.
///
/// What of the force is the damper's makes that deformation, and so the stiffness, larger than it is.
fn oscillation(law: &ContactLaw, pair: &FreePair, peak_force: f64) -> Option<Oscillation> {
    let form = law.form(pair.reduced_mass, pair.approach_speed)?;
    let power = form.spring.power.value();
    let deformation = libm::pow(peak_force / form.spring.coefficient, 1.0 / power);
    let contact = law.respond(&Overlap {
        deformation,
        // Approaching, so that every damper acts, but so slowly that it pushes nothing.
        rate: f64::MIN_POSITIVE,
        reduced_mass: pair.reduced_mass,
        approach_speed: pair.approach_speed,
    })?;
    let angular_frequency = (contact.stiffness / pair.reduced_mass).sqrt();
    (angular_frequency > 0.0 && angular_frequency.is_finite()).then_some(Oscillation {
        angular_frequency,
        damping_ratio: contact.damping / (2.0 * pair.reduced_mass * angular_frequency),
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
