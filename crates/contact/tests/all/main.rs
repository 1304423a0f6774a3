//! Tests over all laws: restitution, forces and calibration.

mod calibration;
mod delivered;
mod force;
mod given;
#[expect(unreachable_pub, reason = "in the crate it is reachable")]
mod marhefka_orin;

// The law of CONTRIBUTING.md imports these names from the crate root.
use pounding_contact::{
    About, Action, Calibration, ContactLaw, Exact, Form, FreeImpact, FreePair, Law, LawName, Name, Power, Term, approach_damper, parameter,
};

/// The reduced mass of the paper's left and middle structures, approximately, at a usual speed.
const PAIR: FreePair = FreePair {
    reduced_mass: 73_170.0,
    approach_speed: 0.3,
};

/// The usual stiffness of a law.
fn stiffness(name: LawName) -> f64 {
    match name.stiffness_unit() {
        Some("N/m") => 9.35e7,
        _ => 2.75e9,
    }
}

/// A law calibrated to an e; `None` if this is impossible.
fn law(name: LawName, restitution: f64, calibration: Calibration) -> Option<ContactLaw> {
    name.calibrated(stiffness(name), restitution, calibration, &PAIR).ok()
}

/// The compliant laws whose damping follows from e.
fn damped() -> impl Iterator<Item = LawName> {
    LawName::ALL.into_iter().filter(|name| {
        let law = law(*name, 0.5, Calibration::Exact);
        law.is_some_and(|law| law.is_compliant())
    })
}

/// e = 0.05, 0.10 … 1.
fn restitutions() -> impl Iterator<Item = f64> {
    (1..=20).map(|n| 0.05 * f64::from(n)).map(|e| e.min(1.0))
}

/// The law that CONTRIBUTING.md adds is this law, word for word, and behaves as the page says.
#[test]
fn limit_the_law_of_the_worked_example() {
    let page = include_str!("../../../../CONTRIBUTING.md");
    let block = page.split("```rust\n").nth(1).and_then(|rest| rest.split("```").next());
    assert_eq!(block, Some(include_str!("marhefka_orin.rs")));
    let Exact::Pair(damping, _) = marhefka_orin::MarhefkaOrin::ABOUT.exact else {
        panic!("its e depends on the speed");
    };
    let law = marhefka_orin::MarhefkaOrin {
        impact_stiffness: 2.75e9,
        impact_damping: damping(2.75e9, 0.65, &PAIR),
    };
    let form = law.form(PAIR.reduced_mass, PAIR.approach_speed).expect("compliant");
    let impact = FreeImpact::of_form(&form, &PAIR).expect("it parts");
    assert!((impact.restitution - 0.65).abs() < 1e-9, "{impact:?}");
}
