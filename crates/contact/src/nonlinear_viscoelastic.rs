#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require_damping, require_restitution, require_stiffness};
use crate::form::{Action, Form, Power, Term};
use crate::given::given;
use crate::{Calibration, ContactForce, Number, Overlap, oscillator};

/// Nonlinear viscoelastic impact element: a Hertz spring, and a damper that acts on approach only.
///
/// Approach (δ̇ > 0): F = β̄ δ^1.5 + c̄ δ̇ with c̄ = 2 ξ̄ √(β̄ √δ m), m the reduced mass; restitution: F = β̄ δ^1.5.
/// The force never pulls. Source: R. Jankowski, *Earthquake Engng Struct. Dyn.* 34 (2005) 595; the paper, Table 3
/// (misprinted there, see the crate's front page).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Words")]
#[schemars(with = "Words")]
pub struct NonlinearViscoelastic {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    #[serde(rename = "impact_stiffness_n_per_m1_5")]
    pub impact_stiffness: f64,
    /// Impact damping ratio ξ̄ \[–\], ≥ 0.
    pub impact_damping_ratio: f64,
}

given!(
    NonlinearViscoelastic,
    "impact_stiffness_n_per_m1_5",
    impact_damping_ratio,
    NonlinearViscoelastic::calibrated
);

impl NonlinearViscoelastic {
    /// The element of this stiffness \[N/m^1.5\] for an e in (0, 1\].
    ///
    /// The literature's formula is ξ̄ = (9√5/2) (1−e²)/(e (e(9π−16) + 16)): R. Jankowski, *Earthquake Engng Struct. Dyn.*
    /// 35 (2006) 517.
    ///
    /// # Errors
    /// [`ParameterError`] for a stiffness or an e out of range.
    pub fn calibrated(
        impact_stiffness: f64,
        restitution: f64,
        calibration: Calibration,
    ) -> Result<Self, ParameterError> {
        require_restitution(restitution)?;
        let root = 5.0_f64.sqrt();
        let impact_damping_ratio = match calibration {
            Calibration::Literature => {
                let e = restitution;
                let slope = 9.0 * std::f64::consts::PI - 16.0;
                4.5 * root * (1.0 - e * e) / (e * (e * slope + 16.0))
            }
            Calibration::Exact => 0.5 * root * oscillator::ratio(restitution),
        };
        let law = Self {
            impact_stiffness,
            impact_damping_ratio,
        };
        law.check().map(|()| law)
    }

    /// The force as a form, for a reduced mass \[kg\].
    pub fn form(&self, reduced_mass: f64) -> Form {
        let critical = 2.0 * (self.impact_stiffness * reduced_mass).sqrt();
        Form {
            spring: Term {
                coefficient: self.impact_stiffness,
                power: Power::ThreeHalves,
            },
            damper: Term {
                coefficient: self.impact_damping_ratio * critical,
                power: Power::Quarter,
            },
            action: Action::Approach,
        }
    }

    /// Force and tangents while a pair touches.
    ///
    /// Precondition: `overlap.deformation` > 0. The tangents jump at δ̇ = 0, and ∂F/∂δ grows without bound as
    /// δ → 0 on approach, like δ^(−3/4).
    pub fn respond(&self, overlap: &Overlap) -> ContactForce {
        let Overlap {
            deformation, rate, ..
        } = *overlap;
        let pair = ViscoelasticPair {
            impact_stiffness: self.impact_stiffness,
            impact_damping_ratio: self.impact_damping_ratio,
            reduced_mass: overlap.reduced_mass,
        };
        let (force, damping) = pair.force(deformation, rate);
        let spring_tangent = 1.5 * self.impact_stiffness * deformation.sqrt();
        ContactForce {
            force,
            stiffness: spring_tangent + 0.25 * damping * rate / deformation,
            damping,
        }
    }

    /// Coefficient of restitution \[–\] delivered to a free pair, exactly: e = exp(−ζ acos ζ/√(1−ζ²)), ζ = 2ξ̄/√5.
    ///
    /// With s = δ^2.5 as the variable the approach is a linear damped oscillator of damping ratio ζ, whence the
    /// relation; it holds for every approach speed.
    pub fn restitution(&self) -> f64 {
        oscillator::given_back(2.0 * self.impact_damping_ratio / 5.0_f64.sqrt())
    }

    /// Part of the kinetic energy \[–\] of a free pair that the spring holds at the largest deformation.
    pub(crate) fn stored(&self) -> f64 {
        self.restitution() * self.restitution()
    }

    /// Checks β̄ > 0 and ξ̄ ≥ 0, both finite.
    ///
    /// # Errors
    /// [`ParameterError`] for the first parameter out of range.
    pub fn check(&self) -> Result<(), ParameterError> {
        require_stiffness("impact_stiffness_n_per_m1_5", self.impact_stiffness)?;
        require_damping("impact_damping_ratio", self.impact_damping_ratio)
    }
}

/// The element between two structures, of one scene or of several side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscoelasticPair<N = f64> {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    pub impact_stiffness: N,
    /// Impact damping ratio ξ̄ \[–\], ≥ 0.
    pub impact_damping_ratio: N,
    /// Reduced mass of the pair \[kg\], > 0.
    pub reduced_mass: N,
}

impl<N: Number> ViscoelasticPair<N> {
    /// Force \[N\] and ∂F/∂δ̇ \[N·s/m\] at a deformation > 0 \[m\] and its rate \[m/s\].
    #[inline(always)]
    pub fn force(&self, deformation: N, rate: N) -> (N, N) {
        let root = deformation.sqrt();
        let spring = self.impact_stiffness * deformation * root;
        let zero = rate.like(0.0);
        let approaches = rate.exceeds(zero);
        if !N::any(approaches) {
            return (spring, zero);
        }
        let critical = (self.impact_stiffness * root * self.reduced_mass).sqrt();
        let damping = rate.like(2.0) * self.impact_damping_ratio * critical;
        let damping = N::select(approaches, damping, zero);
        (
            N::select(approaches, spring + damping * rate, spring),
            damping,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn law(impact_damping_ratio: f64) -> NonlinearViscoelastic {
        NonlinearViscoelastic {
            impact_stiffness: 2.75e9,
            impact_damping_ratio,
        }
    }

    /// A free impact, integrated in small steps of the classical Runge–Kutta method: (e, momentum gained / m v₀).
    fn free_impact(law: &NonlinearViscoelastic, reduced_mass: f64, speed: f64) -> (f64, f64) {
        let force = |deformation: f64, rate: f64| {
            if deformation <= 0.0 {
                return 0.0;
            }
            law.respond(&Overlap {
                deformation,
                rate,
                reduced_mass,
                approach_speed: speed,
            })
            .force
        };
        let (mut x, mut v, dt) = (0.0, speed, 2e-7);
        let acceleration = |x, v| -force(x, v) / reduced_mass;
        loop {
            let (k1, l1) = (v, acceleration(x, v));
            let (k2, l2) = (
                v + 0.5 * dt * l1,
                acceleration(x + 0.5 * dt * k1, v + 0.5 * dt * l1),
            );
            let (k3, l3) = (
                v + 0.5 * dt * l2,
                acceleration(x + 0.5 * dt * k2, v + 0.5 * dt * l2),
            );
            let (k4, l4) = (v + dt * l3, acceleration(x + dt * k3, v + dt * l3));
            x += dt * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
            v += dt * (l1 + 2.0 * l2 + 2.0 * l3 + l4) / 6.0;
            if x <= 0.0 {
                return (-v / speed, (speed - v) / speed);
            }
        }
    }

    #[test]
    fn reference_restitution_of_a_free_impact() {
        for ratio in [0.0, 0.1, 0.35, 0.8, 1.2, 2.5] {
            let (measured, _) = free_impact(&law(ratio), 73_170.0, 0.3);
            let stated = law(ratio).restitution();
            assert!(
                (measured - stated).abs() < 2e-5,
                "damping ratio {ratio}: measured {measured}, stated {stated}"
            );
        }
    }

    #[test]
    fn limit_restitution_is_smooth_through_critical_damping() {
        let at = |zeta: f64| law(zeta * 5.0_f64.sqrt() / 2.0).restitution();
        for offset in [1e-9, 0.999e-3, 1.001e-3] {
            let middle = 0.5 * (at(1.0 - offset) + at(1.0 + offset));
            assert!(
                (middle - at(1.0)).abs() < 1e-6,
                "offset {offset}: {middle} against {}",
                at(1.0)
            );
        }
        let jump = at(1.0 - 0.999_999e-3) - at(1.0 - 1.000_001e-3);
        assert!(jump.abs() < 1e-8, "series meets closed form: {jump}");
    }

    #[test]
    fn limit_no_damping_is_elastic() {
        assert!(
            (law(0.0).restitution() - 1.0).abs() < 1e-15,
            "no damping must return all energy"
        );
    }

    proptest! {
        #[test]
        fn reference_tangents_are_the_derivatives(
            deformation in 1e-5..0.05_f64,
            rate in prop_oneof![-2.0..-1e-3_f64, 1e-3..2.0_f64],
            ratio in 0.0..2.0_f64,
        ) {
            let at = |deformation, rate| law(ratio).respond(&Overlap { deformation, rate, reduced_mass: 7e4, approach_speed: 0.0 });
            let here = at(deformation, rate);
            let (hx, hv) = (1e-5 * deformation, 1e-5 * rate.abs());
            let stiffness = (at(deformation + hx, rate).force - at(deformation - hx, rate).force) / (2.0 * hx);
            let damping = (at(deformation, rate + hv).force - at(deformation, rate - hv).force) / (2.0 * hv);
            prop_assert!((here.stiffness - stiffness).abs() <= 1e-6 * stiffness.abs(), "{here:?} {stiffness}");
            let scale = here.force / rate.abs();
            prop_assert!((here.damping - damping).abs() <= 1e-6 * scale, "{here:?} {damping}");
        }

        #[test]
        fn limit_the_element_is_its_form_to_rounding(
            deformation in 1e-12..1.0_f64, rate in -10.0..10.0_f64, ratio in 0.0..5.0_f64, reduced_mass in 1.0..1e9_f64,
        ) {
            let own = law(ratio).respond(&Overlap { deformation, rate, reduced_mass, approach_speed: 0.0 });
            let form = law(ratio).form(reduced_mass).respond(deformation, rate);
            for (own, form) in [(own.force, form.force), (own.stiffness, form.stiffness), (own.damping, form.damping)] {
                prop_assert!((own - form).abs() <= 8.0 * f64::EPSILON * form.abs(), "{own:e} {form:e}");
            }
        }

        #[test]
        fn limit_never_pulls(
            deformation in 1e-12..1.0_f64, rate in -10.0..10.0_f64, ratio in 0.0..5.0_f64, reduced_mass in 1.0..1e9_f64,
        ) {
            let force = law(ratio).respond(&Overlap { deformation, rate, reduced_mass, approach_speed: 0.0 }).force;
            prop_assert!(force > 0.0, "{force}");
        }
    }
}
