//! Response of a free pair by three routes: closed forms, the crate's integration, and an integration of the test.

use crate::{PAIR, damped, law, restitutions, stiffness};
use pounding_contact::{Calibration, ContactLaw, FreeImpact, FreePair, KuwabaraKono, LawName, Overlap};

/// e and δmax of a free impact by classical Runge–Kutta steps on z = √δ, with dt = z dσ, and the clamped force.
fn integrated(law: &ContactLaw, pair: &FreePair) -> (f64, f64) {
    // Units in which mass, speed and deformation are of order 1.
    let scale = law.form(1.0, 1.0).expect("compliant");
    let power = scale.spring.power.value() + 1.0;
    let energy = pair.reduced_mass * pair.approach_speed * pair.approach_speed;
    let length = libm::pow(energy / scale.spring.coefficient, 1.0 / power);
    let slopes = |z: f64, v: f64| {
        if z <= 0.0 {
            return (0.5 * v, 0.0);
        }
        let overlap = Overlap {
            deformation: length * z * z,
            rate: pair.approach_speed * v,
            reduced_mass: pair.reduced_mass,
            approach_speed: pair.approach_speed,
        };
        let force = law.respond(&overlap).expect("compliant").force;
        (0.5 * v, -z * force * length / energy)
    };
    let (mut z, mut v, mut largest, h) = (0.0, 1.0, 0.0_f64, 2e-5);
    loop {
        let a = slopes(z, v);
        let b = slopes(z + 0.5 * h * a.0, v + 0.5 * h * a.1);
        let c = slopes(z + 0.5 * h * b.0, v + 0.5 * h * b.1);
        let d = slopes(z + h * c.0, v + h * c.1);
        z += h / 6.0 * (a.0 + 2.0 * b.0 + 2.0 * c.0 + d.0);
        v += h / 6.0 * (a.1 + 2.0 * b.1 + 2.0 * c.1 + d.1);
        largest = largest.max(z);
        if z <= 0.0 {
            return (-v, length * largest * largest);
        }
    }
}

fn close(found: f64, known: f64, tolerance: f64, what: &str) {
    assert!((found - known).abs() <= tolerance * known.abs(), "{what}: {found} against {known}");
}

#[test]
fn reference_a_free_impact_gives_what_the_relations_say() {
    for name in LawName::ALL {
        for e in restitutions() {
            for calibration in [Calibration::Literature, Calibration::Exact] {
                let Some(law) = law(name, e, calibration).filter(ContactLaw::is_compliant) else {
                    continue;
                };
                let what = format!("{law:?} for {e}");
                let impact = FreeImpact::of(&law, &PAIR).expect(&what);
                let given = law.restitution().unwrap_or(e);
                close(impact.restitution, given, 1e-9, &what);
                if calibration == Calibration::Exact {
                    close(given, e, 1e-12, &what);
                }
                if let Some(known) = law.max_deformation(&PAIR) {
                    close(impact.max_deformation, known, 1e-9, &what);
                }
                if let Some(known) = law.peak_force(&PAIR) {
                    close(impact.peak_force, known, 1e-9, &what);
                }
            }
        }
    }
}

#[test]
fn reference_runge_kutta_steps_give_the_same() {
    for name in damped() {
        for e in [0.05, 0.2, 0.65, 0.95, 1.0] {
            let law = law(name, e, Calibration::Exact).unwrap();
            let (given, largest) = integrated(&law, &PAIR);
            close(given, e, 1e-9, &format!("{law:?} for {e}"));
            let impact = FreeImpact::of(&law, &PAIR).unwrap();
            close(impact.max_deformation, largest, 1e-8, &format!("{law:?} for {e}"));
        }
    }
}

#[test]
fn reference_duration_of_linear_contact() {
    for name in [LawName::LinearSpring, LawName::KelvinVoigt] {
        for e in restitutions() {
            let Some(law) = law(name, e, Calibration::Exact) else {
                continue;
            };
            let ratio = if let ContactLaw::KelvinVoigt(law) = law {
                law.impact_damping_ratio
            } else {
                0.0
            };
            // Until the clamp: twice the time to the largest deformation. Afterwards: c/k in free flight.
            let swing = if ratio < 1.0 {
                libm::acos(ratio) / (1.0 - ratio * ratio).sqrt()
            } else {
                libm::acosh(ratio) / (ratio * ratio - 1.0).sqrt()
            };
            let frequency = (stiffness(name) / PAIR.reduced_mass).sqrt();
            let impact = FreeImpact::of(&law, &PAIR).unwrap();
            close(impact.duration, 2.0 * (swing + ratio) / frequency, 1e-9, law.name());
            let forced = 2.0 * swing / frequency;
            close(impact.force_duration, forced, 1e-9, law.name());
        }
    }
}

#[test]
fn reference_duration_of_hertz_contact() {
    // ∫ 2 dδ/v = 2 · 0.4 B(0.4, 0.5) δmax/v₀ over the elastic orbit.
    let law = law(LawName::Hertz, 1.0, Calibration::Exact).unwrap();
    let beta = libm::tgamma(0.4) * libm::tgamma(0.5) / libm::tgamma(0.9);
    let known = 0.8 * beta * law.max_deformation(&PAIR).unwrap() / PAIR.approach_speed;
    let impact = FreeImpact::of(&law, &PAIR).unwrap();
    close(impact.duration, known, 1e-9, "duration");
}

#[test]
fn reference_kuwabara_kono_slightly_damped() {
    // To first order, the work of the damper over the elastic orbit: 1 − e = 0.8 · 1.25^0.6 B(0.6, 1.5) A L^0.5 v₀/(β L^1.5).
    let beta = libm::tgamma(0.6) * libm::tgamma(1.5) / libm::tgamma(2.1);
    let lost = 0.8 * libm::pow(1.25, 0.6) * beta;
    for damping in [1e-4, 1e-5] {
        let speed = PAIR.approach_speed;
        let length = libm::pow(PAIR.reduced_mass * speed * speed / 2.75e9, 0.4);
        let law = ContactLaw::KuwabaraKono(KuwabaraKono {
            impact_stiffness: 2.75e9,
            impact_damping: damping * 2.75e9 * length / speed,
        });
        let impact = FreeImpact::of(&law, &PAIR).unwrap();
        let first_order = (1.0 - impact.restitution) / damping;
        assert!((first_order - lost).abs() < 2.0 * damping, "{first_order} against {lost}");
    }
}

#[test]
fn limit_energy_and_impulse_of_a_free_impact() {
    let impulse = PAIR.impulse(1.0);
    close(impulse, 2.0 * 73_170.0 * 0.3, 1e-15, "elastic impulse");
    assert!(PAIR.energy_lost(1.0).abs() < 1e-300, "elastic loses nothing");
    let energy = 0.5 * 73_170.0 * 0.09;
    close(PAIR.energy_lost(0.0), energy, 1e-15, "plastic loses all");
}
