//! Forces and tangents of all laws.

use crate::{PAIR, damped, law};
use pounding_contact::{
    Action, Calibration, Clamp, ContactForce, ContactLaw, Hertz, LawName, LinearSpring, Overlap, SLOWEST_APPROACH, TwoSlopes,
};
use proptest::prelude::*;

fn any_law() -> impl Strategy<Value = ContactLaw> {
    let names: Vec<_> = damped().collect();
    let damped = (prop::sample::select(names), 0.05..1.0_f64).prop_map(|(name, e)| law(name, e, Calibration::Exact).expect("within range"));
    let linear = ContactLaw::LinearSpring(LinearSpring { impact_stiffness: 9.35e7 });
    let hertz = ContactLaw::Hertz(Hertz { impact_stiffness: 2.75e9 });
    let bumper = ContactLaw::TwoSlopes(TwoSlopes {
        impact_stiffness: 1e7,
        second_stiffness: 1e9,
        second_from: 0.01,
    });
    prop_oneof![8 => damped, 1 => Just(linear), 1 => Just(hertz), 1 => Just(bumper)]
}

fn respond(law: &ContactLaw, deformation: f64, rate: f64, approach_speed: f64) -> ContactForce {
    law.respond(&Overlap {
        deformation,
        rate,
        reduced_mass: PAIR.reduced_mass,
        approach_speed,
    })
    .expect("compliant")
}

#[test]
fn limit_laws_that_would_pull_have_powers_that_differ_by_0_or_1() {
    // The exact method clamps these laws by K δ^(n − κ) + C δ̇ and accepts only 0 or 1 for n − κ.
    for name in damped() {
        let law = law(name, 0.5, Calibration::Exact).expect("within range");
        let form = law.form(PAIR.reduced_mass, PAIR.approach_speed);
        let form = form.expect("compliant");
        let apart = form.spring.power.value() - form.damper.power.value();
        let known = [0.0, 1.0].iter().any(|one| apart.total_cmp(one).is_eq());
        assert!(form.action == Action::Approach || known, "{name:?}: {apart}");
    }
}

proptest! {
    #[test]
    fn reference_tangents_are_the_derivatives(
        law in any_law(),
        deformation in 1e-5..0.05_f64,
        rate in prop_oneof![-2.0..-1e-3_f64, 1e-3..2.0_f64],
        speed in 1e-3..2.0_f64,
    ) {
        let at = |deformation, rate| respond(&law, deformation, rate, speed);
        let here = at(deformation, rate);
        let (hx, hv) = (1e-5 * deformation, 1e-5 * rate.abs());
        let around = [at(deformation + hx, rate), at(deformation - hx, rate), at(deformation, rate + hv), at(deformation, rate - hv)];
        // The tangent does not exist at the clamp and where a slope begins, so that both sides of it are skipped.
        prop_assume!(here.force > 0.0 && around.iter().all(|near| near.force > 0.0));
        let form = law.form(PAIR.reduced_mass, speed).unwrap();
        prop_assume!(form.second.is_none_or(|second| (deformation - second.from).abs() > hx));
        let spring = form.spring.at(deformation);
        let scale = spring + (here.force - spring).abs();
        let stiffness = (around[0].force - around[1].force) / (2.0 * hx);
        let damping = (around[2].force - around[3].force) / (2.0 * hv);
        prop_assert!((here.stiffness - stiffness).abs() <= 1e-6 * scale / deformation, "{here:?} {stiffness}");
        prop_assert!((here.damping - damping).abs() <= 1e-6 * scale / rate.abs(), "{here:?} {damping}");
    }

    #[test]
    fn limit_never_pulls(
        law in any_law(),
        deformation in 1e-12..1.0_f64,
        rate in -10.0..10.0_f64,
        speed in prop_oneof![Just(0.0), 1e-9..10.0_f64],
    ) {
        let ContactForce { force, stiffness, damping } = respond(&law, deformation, rate, speed);
        prop_assert!(force >= 0.0 && damping >= 0.0, "{force} {damping}");
        prop_assert!(force > 0.0 || law.clamp() != Clamp::Never, "{law:?} clamped");
        prop_assert!(force > 0.0 || (stiffness == 0.0 && damping == 0.0), "a clamped force has no tangents");
    }

    #[test]
    fn limit_slower_touches_count_as_the_slowest(
        law in any_law(), deformation in 1e-9..1.0_f64, rate in -1.0..1.0_f64,
        speed in prop_oneof![Just(0.0), Just(f64::MIN_POSITIVE), 0.0..SLOWEST_APPROACH],
    ) {
        let respond = |speed| respond(&law, deformation, rate, speed);
        let [found, known] = [speed, SLOWEST_APPROACH].map(respond);
        prop_assert_eq!(found, known);
        let faster = respond(2.0 * SLOWEST_APPROACH);
        let is_damped = known.force > 0.0 && known.damping > 0.0;
        prop_assert!(!is_damped || law.knows_approach_speed() == (faster.damping < known.damping));
    }

    #[test]
    fn limit_the_form_is_the_law(law in any_law(), deformation in 1e-9..1.0_f64, rate in -1.0..1.0_f64) {
        let form = law.form(PAIR.reduced_mass, 0.3).unwrap();
        let (known, found) = (form.unclamped(deformation, rate).max(0.0), respond(&law, deformation, rate, 0.3).force);
        let second = form.second.map_or(0.0, |second| second.at(deformation).0);
        let scale = form.spring.at(deformation) + second + form.damper.at(deformation);
        prop_assert!((known - found).abs() <= 1e-14 * scale, "{known} {found}");
    }
}

#[test]
fn limit_impulsive_law_has_no_force() {
    let law = law(LawName::Stereomechanical, 0.5, Calibration::Exact).unwrap();
    let overlap = Overlap {
        deformation: 0.01,
        rate: 0.1,
        reduced_mass: 1.0,
        approach_speed: 0.1,
    };
    assert_eq!(law.respond(&overlap), None);
    assert!(!law.is_compliant(), "it acts at an instant");
}
