use crate::{Form, FreePair, Parameter, Range};

/// A law of the literature: its parameters, its force and facts about it.
///
/// The checks, the words of files and their schema, lists, calibration and sweeps all follow from it.
pub trait Law: Copy + Default {
    /// Facts about the law.
    const ABOUT: About;

    /// The parameters with their values: the stiffness first, the damping last.
    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)>;

    /// The force for a reduced mass \[kg\] and an approach speed \[m/s\]; `None` if the law is impulsive.
    fn form(&self, reduced_mass: f64, approach_speed: f64) -> Option<Form>;

    /// Coefficient of restitution \[–\] delivered to a free pair; `None` if it depends on the pair.
    fn restitution(&self) -> Option<f64> {
        None
    }

    /// Part of the kinetic energy \[–\] of a free pair that the spring holds at the largest deformation, if a closed form exists.
    fn stored(&self) -> Option<f64> {
        None
    }

    /// Largest force \[N\] in the collision of a free pair, if a closed form exists.
    fn peak_force(&self, _pair: &FreePair) -> Option<f64> {
        None
    }
}

/// Facts about a law.
#[derive(Debug, Clone, Copy)]
pub struct About {
    /// Names in the literature, which differ in the formula for the damping. Scene files use the first.
    pub names: &'static [Name],
    /// Formula of the force or impulse; δ is the deformation, v₀ the approach speed, m the reduced mass.
    pub force: &'static str,
    /// Exact relation between the damping and the delivered e, if known.
    pub relation: Option<&'static str>,
    /// How to find the damping that delivers an e.
    pub exact: Exact,
    /// Whether the damper depends on the approach speed, as δ̇/v₀.
    pub knows_approach_speed: bool,
}

/// A name in the literature: a force, and a formula that chooses its damping for an e.
#[derive(Debug, Clone, Copy)]
pub struct Name {
    /// Name in commands.
    pub name: &'static str,
    /// Name in figures and documents.
    pub label: &'static str,
    /// The literature's formula for the damping, if there is one.
    pub formula: Option<Formula>,
    /// Source.
    pub citation: &'static str,
}

/// A formula in words, and the damping that it gives for an e in (0, 1\].
pub type Formula = (&'static str, fn(f64) -> f64);

/// How to find the damping that delivers an e to a free pair exactly.
#[derive(Debug, Clone, Copy)]
pub enum Exact {
    /// The law is impulsive, and e is its parameter.
    Parameter,
    /// The law has no damping, and delivers e = 1.
    Elastic,
    /// The damping for an e in (0, 1\] holds for every stiffness and pair. Files may give the e instead of the damping.
    Any(fn(f64) -> f64),
    /// The damping depends on the stiffness, the e and the pair.
    Pair(fn(f64, f64, &FreePair) -> f64, Range),
}

impl Exact {
    /// The e that a damped law can deliver. e = 0 would need infinite damping.
    pub const ABOVE_0: Range = Range {
        words: "more than 0, up to 1",
        holds: |e| e > 0.0 && e <= 1.0,
    };

    /// The allowed e.
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
