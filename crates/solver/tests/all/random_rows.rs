//! Random rows under random records, and the configuration of property tests.

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName, NonlinearViscoelastic, Stereomechanical};
use pounding_solver::{Bilinear, Node, Pair, Row};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// This many cases, equal in every run; `PROPTEST_CASES` and `PROPTEST_RNG_SEED` choose others.
pub(crate) fn config(cases: u32) -> ProptestConfig {
    let asked = |name: &str| std::env::var_os(name).is_some();
    let mut config = ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    if !asked("PROPTEST_CASES") {
        config.cases = cases;
    }
    if !asked("PROPTEST_RNG_SEED") {
        config.rng_seed = RngSeed::Fixed(0);
    }
    config
}

/// A row under a record.
#[derive(Debug, Clone)]
pub(crate) struct Case {
    /// Mass \[kg\], period \[s\], damping ratio, yield displacement \[m\].
    pub(crate) structures: Vec<[f64; 4]>,
    /// Gap \[m\] and law of every pair.
    pub(crate) contacts: Vec<(f64, ContactLaw)>,
    /// Velocities at the start \[m/s\].
    pub(crate) velocities: Vec<f64>,
    /// Samples every 0.01 s \[m/s²\].
    pub(crate) ground: Vec<f64>,
}

/// Factors on the units of length, mass and time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units {
    pub(crate) length: f64,
    pub(crate) mass: f64,
    pub(crate) time: f64,
}

pub(crate) const SI: Units = Units {
    length: 1.0,
    mass: 1.0,
    time: 1.0,
};

impl Case {
    pub(crate) fn row(&self, units: Units) -> Row<Bilinear> {
        let node = |(&[mass, period, ratio, yields], velocity): (&[f64; 4], &f64)| {
            let omega = 2.0 * std::f64::consts::PI / (period * units.time);
            let mass = mass * units.mass;
            let stiffness = mass * omega * omega;
            let column = Bilinear {
                stiffness,
                yield_force: stiffness * yields * units.length,
                hardening: 0.0,
            };
            Node {
                initial_velocity: velocity * units.length / units.time,
                ..Node::structure(mass, 2.0 * ratio * omega * mass, column)
            }
        };
        let pair = |(left, &(gap, law)): (usize, &(f64, ContactLaw))| Pair::of_floors(left, left + 1, gap * units.length, law);
        Row::new(
            self.structures.iter().zip(&self.velocities).map(node).collect(),
            self.contacts.iter().enumerate().map(pair).collect(),
        )
        .expect("the row is valid")
    }
}

fn power_of_ten(exponents: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    exponents.prop_map(|exponent| libm::pow(10.0, exponent))
}

/// The whole range of e. Near 1, neighbours that press against each other may bounce without end.
pub(crate) fn stereomechanical() -> BoxedStrategy<ContactLaw> {
    prop_oneof![2 => Just(0.0), 4 => 0.0..0.95_f64, 1 => 0.95..=1.0_f64, 1 => Just(1.0)]
        .prop_map(|restitution| ContactLaw::Stereomechanical(Stereomechanical { restitution }))
        .boxed()
}

/// Every other law, with a suitable stiffness and damping.
fn calibrated() -> BoxedStrategy<ContactLaw> {
    let names = LawName::ALL.into_iter().skip(1).collect::<Vec<_>>();
    let pair = FreePair {
        reduced_mass: 1e5,
        approach_speed: 0.3,
    };
    let law = move |(name, exponent, e): (LawName, f64, f64)| {
        let stiffness = libm::pow(10.0, exponent);
        let exact = |e| name.calibrated(stiffness, e, Calibration::Exact, &pair);
        // Springs have only e = 1.
        exact(e).or_else(|_| exact(1.0)).expect("the stiffness is positive")
    };
    (prop::sample::select(names), 6.0..11.0_f64, 0.1..1.0_f64).prop_map(law).boxed()
}

pub(crate) fn any_law() -> BoxedStrategy<ContactLaw> {
    let viscoelastic = (power_of_ten(7.0..11.0), 0.0..1.5_f64).prop_map(|(impact_stiffness, impact_damping_ratio)| {
        ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
            impact_stiffness,
            impact_damping_ratio,
        })
    });
    prop_oneof![2 => stereomechanical(), 2 => viscoelastic, 3 => calibrated()].boxed()
}

/// Rows of 1 to 6 structures with mass ratios up to 1e6 and gaps of 0 to 1 m.
pub(crate) fn cases(law: fn() -> BoxedStrategy<ContactLaw>) -> impl Strategy<Value = Case> {
    let structure = || {
        let yields = prop_oneof![Just(f64::INFINITY), power_of_ten(-4.0..-1.0)];
        let ratio = prop_oneof![Just(0.0), 0.0..1.2_f64];
        (power_of_ten(2.0..8.0), power_of_ten(-1.3..0.5), ratio, yields)
            .prop_map(|(mass, period, ratio, yields)| [mass, period, ratio, yields])
    };
    let gap = || prop_oneof![Just(0.0), power_of_ten(-8.0..-3.0), 0.0..0.1_f64, 0.0..1.0_f64];
    (1..=6_usize).prop_flat_map(move |n| {
        let structures = prop::collection::vec(structure(), n);
        let contacts = prop::collection::vec((gap(), law()), n - 1);
        let ground = prop::collection::vec(-8.0..8.0_f64, 2..60);
        let moving = prop::collection::vec(-0.5..0.5_f64, n);
        let velocities = prop_oneof![3 => Just(vec![0.0; n]), 1 => moving];
        let all = (structures, contacts, velocities, ground);
        all.prop_map(|(structures, contacts, velocities, ground)| Case {
            structures,
            contacts,
            velocities,
            ground,
        })
    })
}
