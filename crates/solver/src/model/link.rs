//! Links between floors: springs, dampers and restrainers.
//!
//! A link has the signs of a contact. Its deformation δ is the displacement of its left end minus that of its right end, so that r = δ̇ is
//! the rate of compression. Its force F is positive if it pushes both ends apart. A link may pull.

use crate::{Bilinear, Relation, RestoringForce};

/// A link between two floors, or between a floor and the ground or a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// The ends. The offset is 0: a link has no force at rest.
    pub relation: Relation,
    /// The law of its force.
    pub law: LinkLaw,
}

/// The law of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LinkLaw {
    /// A spring that may yield, with a dashpot beside it.
    Spring(Spring),
    /// A cable that pulls once its slack is used up, and may yield.
    Restrainer(Restrainer),
    /// A viscous damper with its brace.
    Braced(Braced),
    /// A viscous damper without a brace.
    Viscous(Viscous),
}

/// A bilinear spring and a dashpot side by side; either may be absent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Stiffness k \[N/m\], ≥ 0.
    pub stiffness: f64,
    /// Force at which the spring yields \[N\], > 0; infinite for an elastic spring.
    pub yield_force: f64,
    /// Ratio of the stiffness after yielding to that before \[–\], 0 ≤ a < 1.
    pub hardening: f64,
    /// Coefficient of the dashpot c \[N·s/m\], ≥ 0.
    pub damping: f64,
}

/// A restrainer: no force until it is longer by its slack, then elastic and perfectly plastic. Plastic elongation adds to the slack.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restrainer {
    /// Stiffness k \[N/m\], > 0.
    pub stiffness: f64,
    /// Pull at which it yields \[N\], > 0; infinite for an elastic restrainer.
    pub yield_force: f64,
    /// Elongation without a force \[m\], ≥ 0.
    pub slack: f64,
}

/// A viscous damper F = c |v|^α sgn v in series with its brace: Ḟ = k (r − sgn F (|F|/c)^(1/α)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Braced {
    /// Stiffness of the brace k \[N/m\], > 0.
    pub stiffness: f64,
    /// Coefficient of the damper c \[N·(s/m)^α\], > 0.
    pub coefficient: f64,
    /// 1/α \[–\], 1 to 10; 1 is a Maxwell element.
    pub inverse_exponent: u32,
}

/// A viscous damper F = c |v|^α sgn v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viscous {
    /// Coefficient of the damper c \[N·(s/m)^α\], > 0.
    pub coefficient: f64,
    /// Exponent α \[–\], 0 < α ≤ 2.
    pub exponent: f64,
}

/// A number of a link out of its range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinkFault {
    /// The field.
    pub field: &'static str,
    /// The value found.
    pub found: f64,
    /// The values allowed, in words.
    pub allowed: &'static str,
}

/// What a link remembers from step to step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct LinkMemory {
    /// Deformation of the last step \[m\].
    deformation: f64,
    /// Plastic deformation \[m\]; for a braced damper its force \[N\].
    inner: f64,
}

/// Largest inverse of the exponent of a braced damper.
const MOST_INVERSE: u32 = 10;
/// Most steps of the search for the force of a braced damper.
const MOST_STEPS: usize = 100;

impl LinkLaw {
    /// Checks the numbers.
    ///
    /// # Errors
    /// The first number out of its range.
    pub fn check(&self) -> Result<(), LinkFault> {
        const POSITIVE: &str = "a finite number > 0";
        const NOT_NEGATIVE: &str = "a finite number >= 0";
        let positive = |field, found: f64| (field, found, found > 0.0 && found.is_finite(), POSITIVE);
        let not_negative = |field, found: f64| (field, found, found >= 0.0 && found.is_finite(), NOT_NEGATIVE);
        let yields = |found: f64| ("yield_force", found, found > 0.0, "a number > 0; infinite if it never yields");
        let numbers = match *self {
            Self::Spring(spring) => vec![
                not_negative("stiffness", spring.stiffness),
                yields(spring.yield_force),
                (
                    "hardening",
                    spring.hardening,
                    (0.0..1.0).contains(&spring.hardening),
                    "0 to less than 1",
                ),
                not_negative("damping", spring.damping),
            ],
            Self::Restrainer(restrainer) => vec![
                positive("stiffness", restrainer.stiffness),
                yields(restrainer.yield_force),
                not_negative("slack", restrainer.slack),
            ],
            Self::Braced(damper) => vec![
                positive("stiffness", damper.stiffness),
                positive("coefficient", damper.coefficient),
                (
                    "inverse_exponent",
                    f64::from(damper.inverse_exponent),
                    (1..=MOST_INVERSE).contains(&damper.inverse_exponent),
                    "a whole number from 1 to 10",
                ),
            ],
            Self::Viscous(damper) => vec![
                positive("coefficient", damper.coefficient),
                (
                    "exponent",
                    damper.exponent,
                    damper.exponent > 0.0 && damper.exponent <= 2.0,
                    "more than 0, at most 2",
                ),
            ],
        };
        match numbers.into_iter().find(|(.., valid, _)| !valid) {
            None => Ok(()),
            Some((field, found, _, allowed)) => Err(LinkFault { field, found, allowed }),
        }
    }

    /// Largest tangent stiffness \[N/m\].
    pub fn stiffness(&self) -> f64 {
        match self {
            Self::Spring(spring) => spring.stiffness,
            Self::Restrainer(restrainer) => restrainer.stiffness,
            Self::Braced(damper) => damper.stiffness,
            Self::Viscous(_) => 0.0,
        }
    }

    /// Coefficient of a linear dashpot between the ends \[N·s/m\]; 0 if there is none.
    pub fn dashpot(&self) -> f64 {
        match self {
            Self::Spring(spring) => spring.damping,
            Self::Restrainer(_) | Self::Braced(_) | Self::Viscous(_) => 0.0,
        }
    }

    /// Force \[N\] and memory after a step \[s\] to a deformation \[m\] and its rate \[m/s\].
    ///
    /// The flow of a braced damper is that of the trapezoidal rule; all other forces follow from deformation and rate.
    pub(crate) fn respond(&self, deformation: f64, rate: f64, memory: LinkMemory, step: f64) -> (f64, LinkMemory) {
        let (force, inner) = match self {
            Self::Spring(spring) => spring.respond(deformation, rate, memory.inner),
            Self::Restrainer(restrainer) => restrainer.respond(deformation, memory.inner),
            Self::Braced(damper) => {
                let force = damper.flowed(memory.inner, deformation - memory.deformation, step);
                (force, force)
            }
            Self::Viscous(damper) => (damper.force(rate), 0.0),
        };
        let memory = LinkMemory { deformation, inner };
        (force, memory)
    }
}

impl LinkMemory {
    /// The memory at t = 0, in a deformation \[m\].
    pub(crate) fn at(deformation: f64) -> Self {
        Self {
            deformation,
            ..Self::default()
        }
    }
}

impl Spring {
    fn respond(&self, deformation: f64, rate: f64, plastic: f64) -> (f64, f64) {
        let response = self.alone().respond(deformation, plastic);
        (response.force + self.damping * rate, response.memory)
    }

    /// The spring without the dashpot.
    pub fn alone(&self) -> Bilinear {
        Bilinear {
            stiffness: self.stiffness,
            yield_force: self.yield_force,
            hardening: self.hardening,
        }
    }
}

impl Restrainer {
    fn respond(&self, deformation: f64, plastic: f64) -> (f64, f64) {
        let stretch = -deformation - self.slack - plastic;
        if stretch <= 0.0 {
            return (0.0, plastic);
        }
        let pull = self.stiffness * stretch;
        if pull <= self.yield_force {
            return (-pull, plastic);
        }
        (-self.yield_force, plastic + stretch - self.yield_force / self.stiffness)
    }
}

impl Braced {
    /// Rate of deformation of the damper under a force \[m/s\].
    pub(crate) fn flow(&self, force: f64) -> f64 {
        let part = force.abs() / self.coefficient;
        let power = (0..self.inverse_exponent).fold(1.0, |power, _| power * part);
        if force < 0.0 { -power } else { power }
    }

    /// The force after a step \[s\] with a change of deformation \[m\]: F + k h/2 flow(F) equals its value at the start minus the flow
    /// there, plus k Δδ. The left side grows with F, so that there is one solution.
    fn flowed(&self, force: f64, change: f64, step: f64) -> f64 {
        let weight = 0.5 * step * self.stiffness;
        let wanted = force - weight * self.flow(force) + self.stiffness * change;
        let slope = |force: f64| {
            let part = force.abs() / self.coefficient;
            let power = (1..self.inverse_exponent).fold(1.0, |power, _| power * part);
            1.0 + weight * f64::from(self.inverse_exponent) * power / self.coefficient
        };
        // The left side bends away from zero: from a value beyond the solution Newton's method goes towards it without leaving its side.
        // The solution is below either term alone; from the lesser bound even a tenth power is solved in some ten steps.
        let by_flow = self.coefficient * libm::pow(wanted.abs() / weight, 1.0 / f64::from(self.inverse_exponent));
        let mut found = wanted.abs().min(by_flow).copysign(wanted);
        for _ in 0..MOST_STEPS {
            let next = found - (found + weight * self.flow(found) - wanted) / slope(found);
            if (next - found).abs() <= f64::EPSILON * next.abs() {
                return next;
            }
            found = next;
        }
        found
    }
}

impl Viscous {
    /// Force at a rate of compression \[N\].
    pub(crate) fn force(&self, rate: f64) -> f64 {
        let force = self.coefficient * libm::pow(rate.abs(), self.exponent);
        if rate < 0.0 { -force } else { force }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_a_restrainer_by_hand() {
        let restrainer = Restrainer {
            stiffness: 4e7,
            yield_force: 1.6e6,
            slack: 0.02,
        };
        // Yields 40 mm after the slack; from 130 mm the plastic elongation is 70 mm.
        let mut plastic = 0.0;
        for (elongation, pull) in [
            (0.02, 0.0),
            (0.04, 8e5),
            (0.13, 1.6e6),
            (0.11, 8e5),
            (0.09, 0.0),
            (0.05, 0.0),
            (0.1, 4e5),
        ] {
            let (force, memory) = restrainer.respond(-elongation, plastic);
            assert!((force + pull).abs() < 1e-6, "{elongation}: {force}");
            plastic = memory;
        }
        assert!((plastic - 0.07).abs() < 1e-15, "{plastic}");
    }

    /// Newton's method must arrive wherever it begins: the residual is rounding after any step.
    #[test]
    fn extreme_forces_of_braced_dampers_in_long_steps() {
        for inverse_exponent in 1..=10 {
            for change in [1e-9, 1e-3, 1.0, 1e3] {
                for step in [1e-6, 1e-2, 10.0] {
                    let damper = Braced {
                        stiffness: 1e8,
                        coefficient: 6e5,
                        inverse_exponent,
                    };
                    let force = damper.flowed(1e4, change, step);
                    let weight = 0.5 * step * damper.stiffness;
                    let wanted = 1e4 - weight * damper.flow(1e4) + damper.stiffness * change;
                    let flowed = weight * damper.flow(force);
                    let terms = force.abs() + flowed.abs() + wanted.abs();
                    assert!(
                        (force + flowed - wanted).abs() < 1e-13 * terms,
                        "{inverse_exponent} {change} {step}: {force}"
                    );
                }
            }
        }
    }

    #[test]
    fn reference_a_braced_damper_under_a_steady_rate_has_the_force_of_the_damper() {
        let damper = Braced {
            stiffness: 1e8,
            coefficient: 6e5,
            inverse_exponent: 3,
        };
        let (step, rate) = (1e-3, 0.2);
        let force = (0..2000).fold(0.0, |force, _| damper.flowed(force, rate * step, step));
        let wanted = 6e5 * libm::cbrt(rate);
        assert!((force / wanted - 1.0).abs() < 1e-13, "{force} {wanted}");
    }
}
