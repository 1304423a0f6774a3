#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use crate::Number;

/// The form of every compliant law: F = K δ^n + C δ^κ δ̇, never below 0.
///
/// A law gives K, C and the powers. C already contains the reduced mass and the approach speed of the pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Form<N = f64> {
    /// Spring: K \[N/m^n\] and n.
    pub spring: Term<N>,
    /// Damper: C \[N·s/m^(1+κ)\] and κ.
    pub damper: Term<N>,
    /// When the damper acts.
    pub action: Action,
}

/// Force of a compliant law and its consistent tangents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForce<N = f64> {
    /// Pounding force F \[N\], ≥ 0; the left structure gets −F, the right one +F.
    pub force: N,
    /// ∂F/∂δ \[N/m\].
    pub stiffness: N,
    /// ∂F/∂δ̇ \[N·s/m\].
    pub damping: N,
}

/// A coefficient times a power of the deformation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term<N = f64> {
    /// The coefficient, ≥ 0.
    pub coefficient: N,
    /// The power.
    pub power: Power,
}

/// Powers of the deformation in the laws of the literature.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Power {
    /// 0.
    Zero,
    /// 1/4.
    Quarter,
    /// 1/2.
    Half,
    /// 1.
    One,
    /// 3/2.
    ThreeHalves,
}

/// When a damper acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// While approaching and while parting.
    Both,
    /// While approaching (δ̇ > 0) only.
    Approach,
}

impl Power {
    /// The power as a number.
    pub const fn value(self) -> f64 {
        match self {
            Self::Zero => 0.0,
            Self::Quarter => 0.25,
            Self::Half => 0.5,
            Self::One => 1.0,
            Self::ThreeHalves => 1.5,
        }
    }

    /// This power of x ≥ 0, computed from products and square roots.
    #[inline(always)]
    pub fn of<N: Number>(self, x: N) -> N {
        match self {
            Self::Zero => x.like(1.0),
            Self::Quarter => x.sqrt().sqrt(),
            Self::Half => x.sqrt(),
            Self::One => x,
            Self::ThreeHalves => x * x.sqrt(),
        }
    }
}

impl<N: Number> Term<N> {
    /// Value at a deformation ≥ 0.
    #[inline(always)]
    pub fn at(&self, deformation: N) -> N {
        self.coefficient * self.power.of(deformation)
    }
}

impl Term {
    /// No force.
    pub const NONE: Self = Self::new(0.0, Power::Zero);

    /// A coefficient ≥ 0 times a power of the deformation.
    pub const fn new(coefficient: f64, power: Power) -> Self {
        Self { coefficient, power }
    }

    /// Deformation ≥ 0 \[m\] at which the term has a given value ≥ 0. The term must not be constant.
    pub fn deformation(&self, value: f64) -> f64 {
        libm::pow(value / self.coefficient, 1.0 / self.power.value())
    }
}

impl<N: Number> Form<N> {
    /// The force before the clamp \[N\]. It is negative if the law would pull.
    #[inline(always)]
    pub fn unclamped(&self, deformation: N, rate: N) -> N {
        self.spring.at(deformation) + self.damping(deformation, rate) * rate
    }

    /// The force at δ > 0 \[N\]; 0 if the law would pull.
    #[inline(always)]
    pub fn force(&self, deformation: N, rate: N) -> N {
        let (force, zero) = (self.unclamped(deformation, rate), rate.like(0.0));
        N::select(zero.exceeds(force), zero, force)
    }

    /// Force and tangents at δ > 0. All are 0 if the law would pull.
    #[inline(always)]
    pub fn respond(&self, deformation: N, rate: N) -> ContactForce<N> {
        let spring = self.spring.at(deformation);
        let damping = self.damping(deformation, rate);
        let force = spring + damping * rate;
        let power = |term: &Term<N>| deformation.like(term.power.value());
        let slope = power(&self.spring) * spring + power(&self.damper) * damping * rate;
        let zero = deformation.like(0.0);
        let pushes = |number: N| N::select(zero.exceeds(force), zero, number);
        ContactForce {
            force: pushes(force),
            stiffness: pushes(slope / deformation),
            damping: pushes(damping),
        }
    }

    /// ∂F/∂δ̇ before the clamp.
    #[inline(always)]
    fn damping(&self, deformation: N, rate: N) -> N {
        let zero = rate.like(0.0);
        match self.action {
            Action::Both => self.damper.at(deformation),
            Action::Approach => {
                let approaches = rate.exceeds(zero);
                if N::any(approaches) {
                    N::select(approaches, self.damper.at(deformation), zero)
                } else {
                    zero
                }
            }
        }
    }
}

impl Form {
    /// A spring, and a damper that acts at these times.
    pub const fn new(spring: Term, damper: Term, action: Action) -> Self {
        Self { spring, damper, action }
    }

    /// Force and tangents at δ ≤ 0 if the damper is a linear dashpot, else `None`; see [`crate::ContactLaw::before_touch`].
    pub(crate) fn before_touch(&self, deformation: f64, rate: f64) -> Option<ContactForce> {
        let (stiffness, damping) = (self.spring.coefficient, self.damper.coefficient);
        let force = stiffness * deformation + damping * rate;
        let jumps = self.damper.power == Power::Zero && self.spring.power == Power::One;
        (jumps && force > 0.0).then_some(ContactForce { force, stiffness, damping })
    }
}
