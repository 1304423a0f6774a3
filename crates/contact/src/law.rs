use crate::{Form, FreePair, Parameter, Range};

/// A law of the literature: its parameters, its force and its facts.
///
/// Everything else follows from it: checks, the words of files and their schema, lists, calibration, sweeps.
pub trait Law: Copy + Default {
    /// The facts.
    const ABOUT: About;

    /// The parameters with their numbers, the stiffness first and the damping last.
    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)>;

    /// The force, for a reduced mass \[kg\] and an approach speed \[m/s\]; `None` if the law is impulsive.
    fn form(&self, reduced_mass: f64, approach_speed: f64) -> Option<Form>;

    /// Coefficient of restitution \[–\] delivered to a free pair, where it depends on the law alone.
    fn restitution(&self) -> Option<f64> {
        None
    }

    /// Part of the kinetic energy \[–\] of a free pair that the spring holds at the largest deformation, where a closed form exists.
    fn stored(&self) -> Option<f64> {
        None
    }

    /// Largest force \[N\] in the collision of a free pair, where a closed form exists.
    fn peak_force(&self, _pair: &FreePair) -> Option<f64> {
        None
    }
}

/// Facts of a law.
#[derive(Debug, Clone, Copy)]
pub struct About {
    /// Names of the literature, which differ in the formula that chooses the damping; scene files know the first.
    pub names: &'static [Name],
    /// Force or impulse; δ the deformation, v₀ the approach speed, m the reduced mass.
    pub force: &'static str,
    /// Exact relation to the e delivered, where one is known.
    pub relation: Option<&'static str>,
    /// The damping that delivers an e.
    pub exact: Exact,
    /// Whether the damper depends on the approach speed, as δ̇/v₀.
    pub knows_approach_speed: bool,
}

/// A name of the literature: a force, and a formula that chooses its damping for an e.
#[derive(Debug, Clone, Copy)]
pub struct Name {
    /// Name, as commands spell it.
    pub name: &'static str,
    /// Name, as figures and documents print it.
    pub label: &'static str,
    /// The literature's formula for the damping, where it gives one.
    pub formula: Option<Formula>,
    /// Source.
    pub citation: &'static str,
}

/// A formula in words, and the damping that it gives for an e in (0, 1\].
pub type Formula = (&'static str, fn(f64) -> f64);

/// The damping that delivers an e to a free pair, exactly.
#[derive(Debug, Clone, Copy)]
pub enum Exact {
    /// The law is impulsive, and e is its parameter.
    Parameter,
    /// The law has no damping, and delivers e = 1.
    Elastic,
    /// Of an e in (0, 1\], for every stiffness and pair. Files may give the e in place of the damping.
    Any(fn(f64) -> f64),
    /// Of a stiffness, an e and a pair.
    Pair(fn(f64, f64, &FreePair) -> f64, Range),
}

impl Exact {
    /// The e that a damped law can deliver: it takes infinite damping to e = 0.
    pub const ABOVE_0: Range = Range {
        words: "more than 0, up to 1",
        holds: |e| e > 0.0 && e <= 1.0,
    };

    /// The e that it delivers.
    pub(crate) const fn allowed(self) -> Range {
        match self {
            Self::Parameter => crate::parameter::RESTITUTION.allowed,
            Self::Elastic => Range {
                words: "1: this law has no damping",
                holds: |e| (1.0..=1.0).contains(&e),
            },
            Self::Any(_) => Self::ABOVE_0,
            Self::Pair(_, allowed) => allowed,
        }
    }
}
