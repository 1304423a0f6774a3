//! What is known of a pair between events: whether it touches, its deformation, its force.

use pounding_contact::{ContactLaw, NonlinearViscoelastic};

use crate::exact::member::Member;
use crate::exact::noise::noise;
use crate::exact::roots::CAPACITY;
use crate::span::Power;

/// How a pair is joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Link {
    /// Not at all, or touching without a force.
    Apart,
    /// Impulsive contact that has come to rest: the neighbours move as one while they press.
    Resting,
    /// Compliant contact.
    Touching(Phase),
}

/// Phase of compliant contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Phase {
    Approach,
    Restitution,
    /// What is left of the force is below the tolerance; the neighbours part.
    Parting,
}

/// A pair between events.
#[derive(Debug, Clone)]
pub(super) struct Contact {
    pub(super) law: ContactLaw,
    pub(super) reduced_mass: f64,
    pub(super) link: Link,
    /// The instant of `deformation` and `rate`.
    pub(super) time: f64,
    pub(super) deformation: f64,
    pub(super) rate: f64,
    /// Largest displacements and gap so far \[m\]: what rounding of a difference is measured by.
    pub(super) scale: f64,
    /// A touch has been found and is still to be resolved.
    pub(super) touching: bool,
    /// The contact force has just faded: the relative acceleration is zero.
    pub(super) faded: bool,
    /// Orders in time, from that of the acceleration on, in which the neighbours move alike as they begin to touch.
    pub(super) alike: usize,
    /// The force is known to have an extremum.
    pub(super) peaked: bool,
    /// The next touch that the pieces on both sides lead to; infinite without one.
    pub(super) meets: f64,
    /// The same in the variable of `series`, not rounded to what time can tell apart.
    pub(super) meets_at: f64,
    /// Instant of the last impact.
    pub(super) hit: f64,
    /// Impacts before it that followed each other within the shortest remainder.
    pub(super) burst: u32,
    /// Impacts since the pair last came to rest.
    pub(super) bounces: u32,
    pub(super) series: Deformation,
    /// Pounding force, in the variable of its body.
    pub(super) force: [f64; CAPACITY],
    spring: [f64; CAPACITY],
    quarter: [f64; CAPACITY],
}

/// Deformation as a series in x − `offset`, with t = `origin` + x^p.
#[derive(Debug, Clone)]
pub(super) struct Deformation {
    pub(super) coefficients: [f64; CAPACITY],
    pub(super) len: usize,
    pub(super) origin: f64,
    pub(super) offset: f64,
    pub(super) power: Power,
}

impl Contact {
    pub(super) fn new(law: ContactLaw, reduced_mass: f64, deformation: f64, rate: f64) -> Self {
        Self {
            law,
            reduced_mass,
            link: Link::Apart,
            time: 0.0,
            deformation,
            rate,
            scale: 0.0,
            touching: false,
            faded: false,
            alike: 0,
            peaked: false,
            meets: f64::INFINITY,
            meets_at: 0.0,
            hit: f64::NEG_INFINITY,
            burst: 0,
            bounces: 0,
            series: Deformation {
                coefficients: [0.0; CAPACITY],
                len: 0,
                origin: 0.0,
                offset: 0.0,
                power: Power::One,
            },
            force: [0.0; CAPACITY],
            spring: [0.0; CAPACITY],
            quarter: [0.0; CAPACITY],
        }
    }

    /// Coefficient of restitution of an impulsive law; nothing for a compliant one.
    pub(super) fn restitution(&self) -> Option<f64> {
        match self.law {
            ContactLaw::Stereomechanical(law) => Some(law.restitution),
            ContactLaw::NonlinearViscoelastic(_) => None,
        }
    }

    /// Coefficient `n` of the deformation, from the motion of both sides.
    pub(super) fn deformation(&self, sides: &[Member], power: Power, n: usize) -> f64 {
        if n == 0 {
            self.deformation
        } else if n == power.order() {
            self.rate
        } else if n < (2 + self.alike) * power.order() {
            0.0
        } else {
            sides[0].displacement[n] - sides[1].displacement[n]
        }
    }

    /// Coefficient `n` of the rate of deformation.
    pub(super) fn rate(&self, sides: &[Member], power: Power, n: usize) -> f64 {
        if n == 0 {
            self.rate
        } else if n < (1 + self.alike) * power.order() {
            0.0
        } else {
            sides[0].velocity[n] - sides[1].velocity[n]
        }
    }

    /// Finds coefficient `n` of a compliant force; those below `n` and what they imply are known.
    pub(super) fn find_force(&mut self, sides: &[Member], power: Power, n: usize) {
        self.force[n] = match (self.link, self.law) {
            (Link::Touching(Phase::Approach), ContactLaw::NonlinearViscoelastic(law)) => {
                self.spring(&law, sides, power, n) + self.damper(&law, sides, power, n)
            }
            (Link::Touching(Phase::Restitution), ContactLaw::NonlinearViscoelastic(law)) => {
                self.spring(&law, sides, power, n)
            }
            (Link::Touching(Phase::Parting), ContactLaw::NonlinearViscoelastic(law)) => {
                self.remainder(&law, power, n)
            }
            _ => 0.0,
        };
    }

    /// What is left of the force when a pair parts falls to zero in a line; its impulse is below the tolerance.
    fn remainder(&self, law: &NonlinearViscoelastic, power: Power, n: usize) -> f64 {
        let force = law.impact_stiffness * self.deformation * self.deformation.sqrt();
        if n == 0 {
            force
        } else if n == power.order() {
            force * (self.rate / self.deformation)
        } else {
            0.0
        }
    }

    /// Finds in how many orders neighbours that begin to touch without a rate move alike but for rounding; true when in
    /// any: rounding would part them, or press them, at once.
    pub(super) fn find_alike(&mut self, sides: &[Member], power: Power, len: usize) -> bool {
        let begins = matches!(self.link, Link::Touching(_));
        if !begins || self.deformation > 0.0 || self.rate != 0.0 {
            return false;
        }
        let p = power.order();
        let differ = |n: &usize| {
            let values = [sides[0].displacement[*n], sides[1].displacement[*n]];
            (values[0] - values[1]).abs() > noise(sides, values, p, *n)
        };
        let first = (2 * p..len).find(differ).unwrap_or(len);
        self.alike = first / p - 2;
        self.alike > 0
    }

    /// The power of x with which the deformation begins; nothing as long as it is not known.
    fn leading(&self, sides: &[Member], power: Power, n: usize) -> Option<usize> {
        if self.deformation > 0.0 {
            return Some(0);
        }
        // After n steps of the recurrence the coefficients below n + 2p are known.
        let known = n + 2 * power.order();
        (power.order()..known)
            .step_by(power.order())
            .find(|&index| self.deformation(sides, power, index) > 0.0)
    }

    /// β̄ δ^(3/2): with δ = x^q D it is x^(3q/2) D^(3/2).
    fn spring(
        &mut self,
        law: &NonlinearViscoelastic,
        sides: &[Member],
        power: Power,
        n: usize,
    ) -> f64 {
        let Some(leading) = self.leading(sides, power, n) else {
            return 0.0;
        };
        let shift = 3 * leading / 2;
        if n < shift {
            return 0.0;
        }
        let first = self.deformation(sides, power, leading);
        let m = n - shift;
        self.spring[m] = if m == 0 {
            first * first.sqrt()
        } else {
            let term = |k: usize| {
                (1.5 * k as f64 - (m - k) as f64)
                    * self.deformation(sides, power, leading + k)
                    * self.spring[m - k]
            };
            (1..=m).map(term).sum::<f64>() / (m as f64 * first)
        };
        law.impact_stiffness * self.spring[m]
    }

    /// c̄ δ̇ = 2 ξ̄ √(β̄ m) δ^(1/4) δ̇.
    fn damper(
        &mut self,
        law: &NonlinearViscoelastic,
        sides: &[Member],
        power: Power,
        n: usize,
    ) -> f64 {
        let Some(leading) = self.leading(sides, power, n) else {
            return 0.0;
        };
        // The rate begins with the power leading − p, which is how far the root need not be known.
        let (shift, behind) = (leading / 4, leading.saturating_sub(power.order()));
        if n < shift + behind {
            return 0.0;
        }
        let last = n - shift - behind;
        let first = self.deformation(sides, power, leading);
        let m = last;
        self.quarter[m] = if m == 0 {
            first.sqrt().sqrt()
        } else {
            let term = |k: usize| {
                (0.25 * k as f64 - (m - k) as f64)
                    * self.deformation(sides, power, leading + k)
                    * self.quarter[m - k]
            };
            (1..=m).map(term).sum::<f64>() / (m as f64 * first)
        };
        let product = |k: usize| self.quarter[k] * self.rate(sides, power, n - shift - k);
        let coefficient =
            2.0 * law.impact_damping_ratio * (law.impact_stiffness * self.reduced_mass).sqrt();
        coefficient * (0..=last).map(product).sum::<f64>()
    }
}
