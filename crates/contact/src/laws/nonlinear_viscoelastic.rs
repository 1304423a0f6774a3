#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use std::f64::consts::PI;

use crate::form::{Action, Form, Power, Term};
use crate::law::{About, Exact, Law, Name};
use crate::parameter::{HERTZ, RATIO};
use crate::{ContactForce, Number, Overlap, Parameter, oscillator};

/// Nonlinear viscoelastic impact element: a Hertz spring, and a damper that acts on approach only.
///
/// Approach (δ̇ > 0): F = β̄ δ^1.5 + c̄ δ̇ with c̄ = 2 ξ̄ √(β̄ √δ m), m the reduced mass; restitution: F = β̄ δ^1.5.
/// The force never pulls. Source: R. Jankowski, *Earthquake Engng Struct. Dyn.* 34 (2005) 595; the paper, Table 3
/// (misprinted there, see the crate's front page).
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct NonlinearViscoelastic {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    pub impact_stiffness: f64,
    /// Impact damping ratio ξ̄ \[–\], ≥ 0.
    pub impact_damping_ratio: f64,
}

impl Law for NonlinearViscoelastic {
    const ABOUT: About = About {
        names: &[Name {
            name: "nonlinear_viscoelastic",
            label: "Nonlinear viscoelastic",
            formula: Some(("ξ = (9√5/2)(1−e²)/(e(e(9π−16)+16))", |e| {
                let slope = 9.0 * PI - 16.0;
                4.5 * 5.0_f64.sqrt() * (1.0 - e * e) / (e * (e * slope + 16.0))
            })),
            citation: "Jankowski, EESD 34 (2005) 595 and 35 (2006) 517",
        }],
        force: "approach βδ^1.5 + cδ̇, c = 2ξ√(β√δ m); return βδ^1.5",
        relation: Some("e = exp(−ζ acos ζ/√(1−ζ²)), ζ = 2ξ/√5"),
        exact: Exact::Any(|e| 0.5 * 5.0_f64.sqrt() * oscillator::ratio(e)),
        knows_approach_speed: false,
    };

    fn parameters(&mut self) -> Vec<(&'static Parameter, &mut f64)> {
        vec![(&HERTZ, &mut self.impact_stiffness), (&RATIO, &mut self.impact_damping_ratio)]
    }

    fn form(&self, reduced_mass: f64, _approach_speed: f64) -> Option<Form> {
        let critical = 2.0 * (self.impact_stiffness * reduced_mass).sqrt();
        let damper = Term::new(self.impact_damping_ratio * critical, Power::Quarter);
        let spring = Term::new(self.impact_stiffness, Power::ThreeHalves);
        Some(Form::new(spring, damper, Action::Approach))
    }

    /// With s = δ^2.5 as the variable, the approach is a linear damped oscillator of damping ratio ζ. The relation follows from it and
    /// holds for every approach speed.
    fn restitution(&self) -> Option<f64> {
        let ratio = 2.0 * self.impact_damping_ratio / 5.0_f64.sqrt();
        Some(oscillator::given_back(ratio))
    }

    fn stored(&self) -> Option<f64> {
        self.restitution().map(|e| e * e)
    }
}

impl NonlinearViscoelastic {
    /// Force and tangents while a pair touches.
    ///
    /// Precondition: `overlap.deformation` > 0. The tangents jump at δ̇ = 0, and ∂F/∂δ grows without bound as
    /// δ → 0 on approach, like δ^(−3/4).
    pub fn respond(&self, overlap: &Overlap) -> ContactForce {
        let Overlap { deformation, rate, .. } = *overlap;
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
}

/// The element between two structures, for a single scene or for several scenes in lanes.
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
        (N::select(approaches, spring + damping * rate, spring), damping)
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

    fn delivered(impact_damping_ratio: f64) -> f64 {
        law(impact_damping_ratio).restitution().expect("a closed form")
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
            let (k2, l2) = (v + 0.5 * dt * l1, acceleration(x + 0.5 * dt * k1, v + 0.5 * dt * l1));
            let (k3, l3) = (v + 0.5 * dt * l2, acceleration(x + 0.5 * dt * k2, v + 0.5 * dt * l2));
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
            let stated = delivered(ratio);
            assert!(
                (measured - stated).abs() < 2e-5,
                "damping ratio {ratio}: measured {measured}, stated {stated}"
            );
        }
    }

    #[test]
    fn limit_restitution_is_smooth_through_critical_damping() {
        let at = |zeta: f64| delivered(zeta * 5.0_f64.sqrt() / 2.0);
        for offset in [1e-9, 0.999e-3, 1.001e-3] {
            let middle = 0.5 * (at(1.0 - offset) + at(1.0 + offset));
            assert!((middle - at(1.0)).abs() < 1e-6, "offset {offset}: {middle} against {}", at(1.0));
        }
        let jump = at(1.0 - 0.999_999e-3) - at(1.0 - 1.000_001e-3);
        assert!(jump.abs() < 1e-8, "series meets closed form: {jump}");
    }

    #[test]
    fn limit_no_damping_is_elastic() {
        assert!((delivered(0.0) - 1.0).abs() < 1e-15, "no damping must return all energy");
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
            let form = law(ratio).form(reduced_mass, 0.0).expect("compliant").respond(deformation, rate);
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
