//! The damping from the requested e, by the literature and exactly.

use crate::{PAIR, damped, law, restitutions};
use pounding_contact::{Calibration, CalibrationError, Clamp, ContactLaw, Exact, Law, LawName, NonlinearViscoelastic};

/// The parameter that damps.
fn damping(mut law: ContactLaw) -> f64 {
    law.parameters().pop().map_or(0.0, |(_, number)| *number)
}

#[test]
fn published_literature_calibrations_give_another_restitution() {
    for (name, asked, gives) in [
        (LawName::KelvinVoigt, 0.65, "0.675"),
        (LawName::KelvinVoigt, 0.2, "0.325"),
        (LawName::ModifiedLinearViscoelastic, 0.65, "0.654"),
        (LawName::HertzDamp, 0.65, "0.775"),
        (LawName::HertzDamp, 0.1, "0.665"),
        (LawName::CorrectedHertzDamp, 0.65, "0.630"),
        (LawName::CorrectedHertzDamp, 0.2, "0.156"),
        (LawName::HuntCrossley, 0.65, "0.739"),
        (LawName::Gonthier, 0.65, "0.623"),
        (LawName::Gonthier, 0.2, "0.205"),
        (LawName::ModifiedKelvin, 0.65, "0.646"),
        (LawName::PantWijeyewickrema, 0.65, "0.667"),
    ] {
        let law = law(name, asked, Calibration::Literature).unwrap();
        let found = format!("{:.3}", law.restitution().unwrap());
        assert_eq!(found, gives, "{name:?} asked for {asked}");
    }
}

#[test]
fn published_nonlinear_viscoelastic_element() {
    let law = NonlinearViscoelastic {
        impact_stiffness: 2.75e9,
        impact_damping_ratio: 0.35,
    };
    let delivered = law.restitution().expect("a closed form");
    assert_eq!(format!("{delivered:.4}"), "0.6618");
}

#[test]
fn limit_calibrations_are_smooth_up_to_elastic() {
    for name in damped() {
        for calibration in [Calibration::Literature, Calibration::Exact] {
            let Some(elastic) = law(name, 1.0, calibration) else {
                continue;
            };
            assert!(damping(elastic).abs() < 1e-300, "{name:?}: {elastic:?}");
            let slope = |lost: f64| {
                let law = law(name, 1.0 - lost, calibration).unwrap();
                damping(law) / (1.0 - (1.0 - lost))
            };
            let (known, mut last) = (slope(1e-4), f64::INFINITY);
            for lost in [1e-5, 1e-6, 1e-8, 1e-10, 1e-12] {
                let found = slope(lost);
                // Numerical integration knows e to rounding only.
                let integrated = matches!(name.about().exact, Exact::Pair(..));
                let noise = if integrated { 1e-14 / lost } else { 1e-11 };
                let change = (found / known - 1.0).abs();
                assert!(change < 1e-3 + noise, "{name:?} at 1 − {lost}: {found} {known}");
                last = last.min(change);
            }
            assert!(last < 1e-3, "{name:?}: the slope has a limit");
        }
    }
}

#[test]
fn limit_more_restitution_needs_less_damping() {
    for name in damped() {
        let dampings = restitutions().map(|e| damping(law(name, e, Calibration::Exact).unwrap()));
        let dampings: Vec<_> = dampings.collect();
        assert!(dampings.is_sorted_by(|a, b| a > b), "{name:?}: {dampings:?}");
    }
}

#[test]
fn extreme_restitutions_are_refused_by_name() {
    for name in damped() {
        for e in [0.0, -0.1, 1.0 + 1e-9, f64::NAN] {
            let refused = name.calibrated(1e9, e, Calibration::Exact, &PAIR);
            let message = refused.unwrap_err().to_string();
            assert!(message.starts_with("restitution: found"), "{message}");
        }
        for stiffness in [0.0, -1.0, f64::INFINITY, f64::NAN] {
            let refused = name.calibrated(stiffness, 0.5, Calibration::Exact, &PAIR);
            let message = refused.unwrap_err().to_string();
            assert!(message.starts_with("impact_stiffness"), "{message}");
        }
    }
    let mut springs = LawName::ALL.into_iter().filter(|name| name.is_elastic());
    assert!(
        springs.all(|name| law(name, 0.99, Calibration::Exact).is_none()),
        "a spring has e = 1"
    );
    let formula = LawName::KuwabaraKono.calibrated(1e9, 0.5, Calibration::Literature, &PAIR);
    assert_eq!(formula, Err(CalibrationError::NoFormula { law: "kuwabara_kono" }));
}

#[test]
fn reference_every_law_is_described() {
    for name in LawName::ALL {
        assert_eq!(LawName::from_name(name.name()), Some(name));
        let law = law(name, 1.0, Calibration::Exact).unwrap();
        assert_eq!(law.clamp(), Clamp::Never, "no damping, no pull: {law:?}");
        // The parameters are those that scene files spell.
        let text = serde_json::to_value(law).unwrap();
        let fields = text[law.name()].as_object().unwrap();
        let spelt: Vec<_> = fields.keys().map(String::as_str).collect();
        let mut described: Vec<_> = name.parameters().iter().map(|row| row.name).collect();
        described.sort_unstable();
        assert_eq!(spelt, described, "{name:?}");
    }
}

/// A law that is ten times as stiff, or a tenth, delivers the same e. Its force at a deformation without rate is ten times, or a tenth.
#[test]
fn limit_stiffer_laws_keep_their_restitution() {
    for name in LawName::ALL {
        // Springs without damping have only e = 1.
        let of = |restitution| law(name, restitution, Calibration::Exact);
        let damped = of(0.65).or_else(|| of(1.0)).expect("one of both");
        for factor in [0.1, 10.0] {
            let other = damped.stiffened(factor);
            let delivered = [other, damped].map(|law| law.restitution());
            assert_eq!(delivered[0], delivered[1], "{name:?}");
            let stiffness = |law: ContactLaw| law.form(PAIR.reduced_mass, PAIR.approach_speed).map(|form| form.spring.coefficient);
            let ratio = stiffness(other).zip(stiffness(damped)).map(|(other, own)| other / own);
            assert!(ratio.is_none_or(|ratio| (ratio / factor - 1.0).abs() < 1e-12), "{name:?} {ratio:?}");
            assert_eq!(ratio.is_none(), name == LawName::Stereomechanical);
        }
    }
}
