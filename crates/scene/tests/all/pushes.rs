//! The longest blow of a contact: a longer touch is a push.

use pounding_scene::PairOutcome;

use crate::beside::prepared;

/// A building of storeys beside a wall, with a linear contact \[N/m\].
fn lasts(storeys: &str, contact: f64) -> f64 {
    let simulation = prepared(&format!(
        r#"
name = "at a wall"
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
structures = [{{ building = {{ name = "a", damping.ratio = 0, storeys = [{storeys}] }} }}, "wall"]
contacts = [{{ gap_m = 0.1, levels = [1], law.linear_spring.impact_stiffness_n_per_m = {contact:e} }}]
"#
    ));
    simulation.longest_blow(0, 1.0)
}

/// A mass on a spring is in contact for half a period, π √(m/k). Storeys at least as stiff as the contact bring their floors along.
#[test]
fn reference_the_longest_blow_is_one_and_a_half_half_periods() {
    let half = |mass: f64, stiffness: f64| std::f64::consts::PI * (mass / stiffness).sqrt();
    let soft = "{ mass_kg = 3e5, stiffness_n_per_m = 1e6 }, { mass_kg = 2e5, stiffness_n_per_m = 9e6 }";
    let tied = "{ mass_kg = 3e5, stiffness_n_per_m = 1e6 }, { mass_kg = 2e5, stiffness_n_per_m = 2e7 }";
    for (storeys, mass) in [(soft, 3e5), (tied, 5e5)] {
        let found = lasts(storeys, 1e7);
        let wanted = 1.5 * half(mass, 1e7);
        assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}");
    }
}

/// A contact as stiff as those of slabs keeps the bound.
#[test]
fn limit_a_stiff_contact_has_the_bound() {
    let found = lasts("{ mass_kg = 3e5, stiffness_n_per_m = 1e8 }", 2e9);
    assert_eq!(found.to_bits(), PairOutcome::LEANS.to_bits());
}
