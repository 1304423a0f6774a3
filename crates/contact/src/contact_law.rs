use crate::{Action, ContactForce, ContactLaw, FreeImpact, FreePair, ParameterError, Stereomechanical};

/// State of a pair while it touches, as a contact law sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// Deformation at the contact δ = `u_left` − `u_right` − gap \[m\], > 0.
    pub deformation: f64,
    /// Rate of deformation δ̇ \[m/s\], positive while approaching.
    pub rate: f64,
    /// Reduced mass of the pair \[kg\], > 0; see [`reduced_mass`].
    pub reduced_mass: f64,
    /// Rate of deformation at the first touch of the present contact v₀ \[m/s\], ≥ 0; 0 if the pair did not approach.
    pub approach_speed: f64,
}

/// Reduced mass m₁m₂/(m₁+m₂) \[kg\] of two neighbours given by their inverse masses \[1/kg\].
///
/// A fixed wall has inverse mass 0. Two walls never collide: the result is then infinite, and a row refuses them.
pub fn reduced_mass(inverse_mass_left: f64, inverse_mass_right: f64) -> f64 {
    1.0 / (inverse_mass_left + inverse_mass_right)
}

/// Whether the formula of a law would pull and is clamped at F = 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clamp {
    /// The formula never pulls.
    Never,
    /// The formula pulls only if other forces drive the pair apart faster than v₀/a. It never pulls in a free impact.
    DrivenApart,
    /// The formula pulls at the end of every collision.
    EveryCollision,
}

impl FreeImpact {
    /// Integrates the collision of a free pair under a law.
    ///
    /// Returns `None` for an impulsive law, and if [`FreeImpact::of_form`] returns `None`.
    pub fn of(law: &ContactLaw, pair: &FreePair) -> Option<Self> {
        Self::of_form(&law.form(pair.reduced_mass, pair.approach_speed)?, pair)
    }
}

impl ContactLaw {
    /// The law with its stiffness times a factor, and with it each parameter that grows with the stiffness
    /// ([`crate::Parameter::stiffens`]).
    ///
    /// Laws with a damping ratio or factor \[–\] keep their restitution. An impulsive law is unchanged.
    #[must_use]
    pub fn stiffened(mut self, factor: f64) -> Self {
        for (parameter, number) in self.parameters() {
            if parameter.stiffens {
                *number *= factor;
            }
        }
        self
    }

    /// The impact stiffness over the usual one of its kind \[–\] ([`crate::Parameter::usual`]); `None` for an impulsive law.
    pub fn stiffness_over_usual(mut self) -> Option<f64> {
        let usual = [crate::parameter::LINEAR, crate::parameter::HERTZ].map(|one| (one.name, one.usual));
        let parameters = self.parameters().into_iter();
        let mut over = parameters.filter_map(|(parameter, value)| {
            let (_, usual) = usual.iter().find(|(name, _)| *name == parameter.name)?;
            Some(*value / usual)
        });
        over.next()
    }

    /// Name in scene files.
    pub const fn name(&self) -> &'static str {
        self.about().names[0].name
    }

    /// Checks the parameters against their valid range.
    ///
    /// # Errors
    /// [`ParameterError`] names the parameter, what was found and what is allowed.
    pub fn check(&self) -> Result<(), ParameterError> {
        let mut law = *self;
        let mut parameters = law.parameters().into_iter();
        parameters.try_for_each(|(parameter, number)| parameter.allowed.check(parameter.name, *number))
    }

    /// The stereomechanical law, if this law is impulsive.
    pub const fn impulsive(&self) -> Option<Stereomechanical> {
        if let Self::Stereomechanical(law) = self { Some(*law) } else { None }
    }

    /// Whether the law gives a force over time instead of an impulse.
    #[inline]
    pub const fn is_compliant(&self) -> bool {
        self.impulsive().is_none()
    }

    /// Whether the damper depends on the approach speed, as δ̇/v₀.
    pub const fn knows_approach_speed(&self) -> bool {
        self.about().knows_approach_speed
    }

    /// Force and tangents of a compliant law while a pair touches; `None` for an impulsive law.
    ///
    /// Precondition: `overlap.deformation` > 0. Tangents jump at δ̇ = 0 and at the clamp. They may grow without bound as δ → 0.
    #[inline]
    pub fn respond(&self, overlap: &Overlap) -> Option<ContactForce> {
        // The root is written as in the paper: the last digits of the paper's tables depend on it.
        if let Self::NonlinearViscoelastic(law) = self {
            return Some(law.respond(overlap));
        }
        let form = self.form(overlap.reduced_mass, overlap.approach_speed)?;
        Some(form.respond(overlap.deformation, overlap.rate))
    }

    /// Force and tangents of a pair at δ ≤ 0 that a step is about to close, for a solver that iterates.
    ///
    /// A linear dashpot acts from the first touch: its force jumps there, and the end of a step may have no equilibrium on either side of
    /// the jump. The continuation kδ + cδ̇, clamped, has one. Forces that begin at zero need no continuation.
    pub fn before_touch(&self, overlap: &Overlap) -> Option<ContactForce> {
        let form = self.form(overlap.reduced_mass, overlap.approach_speed)?;
        form.before_touch(overlap.deformation, overlap.rate)
    }

    /// Whether the formula of the law would pull and is clamped.
    pub fn clamp(&self) -> Clamp {
        match self.form(1.0, 1.0) {
            Some(form) if form.action == Action::Both && form.damper.coefficient > 0.0 => {
                // If the damper falls more slowly with the deformation than the spring, it prevails at the end of the collision.
                if form.damper.power == form.spring.power {
                    Clamp::DrivenApart
                } else {
                    Clamp::EveryCollision
                }
            }
            Some(_) | None => Clamp::Never,
        }
    }

    /// Largest deformation δmax \[m\] of a free pair, if a closed form exists.
    pub fn max_deformation(&self, pair: &FreePair) -> Option<f64> {
        let stored = self.stored()?;
        let form = self.form(pair.reduced_mass, pair.approach_speed)?;
        Some(pair.deformation(&form, stored))
    }
}
