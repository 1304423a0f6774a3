//! Laws of mechanics that the exact method keeps on random rows.

use pounding_contact::{ContactLaw, NonlinearViscoelastic, Stereomechanical};
use pounding_solver::{
    Clock, ElastoPlastic, Exact, Excitation, Histories, Impact, Integrator, Ledger, Node, Pair,
    Recorder, Row, Span, TransferredMomentum,
};
use proptest::prelude::*;

const CLOCK: Clock = Clock {
    time_step: 0.01,
    n_steps: 60,
};

/// A row under a record.
#[derive(Debug, Clone)]
struct Case {
    /// Mass \[kg\], period \[s\], damping ratio, yield displacement \[m\].
    structures: Vec<[f64; 4]>,
    /// Gap \[m\] and law of every pair.
    contacts: Vec<(f64, ContactLaw)>,
    /// Samples every 0.01 s \[m/s²\].
    ground: Vec<f64>,
}

/// Factors on the units of length, mass and time.
#[derive(Debug, Clone, Copy)]
struct Units {
    length: f64,
    mass: f64,
    time: f64,
}

const SI: Units = Units {
    length: 1.0,
    mass: 1.0,
    time: 1.0,
};

impl Case {
    fn row(&self, units: Units) -> Row<ElastoPlastic> {
        let node = |&[mass, period, ratio, yields]: &[f64; 4]| {
            let omega = 2.0 * std::f64::consts::PI / (period * units.time);
            let mass = mass * units.mass;
            let stiffness = mass * omega * omega;
            let column = ElastoPlastic {
                stiffness,
                yield_force: stiffness * yields * units.length,
            };
            Node::structure(mass, 2.0 * ratio * omega * mass, column)
        };
        let pair = |(left, &(gap, law)): (usize, &(f64, ContactLaw))| Pair {
            left,
            right: left + 1,
            gap: gap * units.length,
            law,
        };
        Row::new(
            self.structures.iter().map(node).collect(),
            self.contacts.iter().enumerate().map(pair).collect(),
        )
        .expect("the row is valid")
    }

    fn run(&self, units: Units) -> Outcome {
        let row = self.row(units);
        let n = row.nodes().len();
        let acceleration = units.length / (units.time * units.time);
        let ground: Vec<_> = self.ground.iter().map(|a| a * acceleration).collect();
        let excitation =
            Excitation::new(0.01 * units.time, &ground).expect("the ground motion is finite");
        let time_step = CLOCK.time_step * units.time;
        let clock = Clock { time_step, ..CLOCK };
        let duration = clock.time(clock.n_steps);
        let mut recorders = (
            TransferredMomentum::new(n),
            Histories::new(n, time_step, duration),
            (Ledger::new(&row, excitation), Overlap::new(&row)),
        );
        Integrator::Exact(Exact::default())
            .run(&row, excitation, clock, &mut recorders)
            .expect("the run ends");
        let (momentum, histories, (ledger, overlap)) = recorders;
        let laws = ledger
            .verdict()
            .map(|_| ())
            .map_err(|error| error.to_string());
        Outcome {
            momentum: (0..n).map(|index| momentum.of(index)).collect(),
            histories,
            balances: [ledger.residual(), ledger.identity(), ledger.momentum()],
            laws,
            overlap: overlap.largest,
        }
    }
}

#[derive(Debug)]
struct Outcome {
    momentum: Vec<f64>,
    histories: Histories,
    balances: [f64; 3],
    laws: Result<(), String>,
    overlap: f64,
}

/// The largest overlap of an impulsive pair relative to displacements and gap, at the ends of spans of both sides.
struct Overlap {
    /// Gap of the pair on the right of each structure; infinite where there is none, or a compliant one.
    gaps: Vec<f64>,
    /// Last instant and displacement of every structure.
    ends: Vec<(f64, f64)>,
    largest: f64,
    /// Largest displacement of each structure so far.
    reach: Vec<f64>,
}

impl Overlap {
    fn new(row: &Row<ElastoPlastic>) -> Self {
        let n = row.nodes().len();
        let mut gaps = vec![f64::INFINITY; n];
        for pair in row.pairs() {
            if matches!(pair.law, ContactLaw::Stereomechanical(_)) {
                gaps[pair.left] = pair.gap;
            }
        }
        Self {
            gaps,
            ends: vec![(0.0, 0.0); n],
            largest: 0.0,
            reach: vec![0.0; n],
        }
    }
}

impl Recorder for Overlap {
    fn span(&mut self, span: &Span<'_>) {
        self.ends[span.structure] = (span.end_time, span.end.displacement);
        let reach = &mut self.reach[span.structure];
        *reach = reach.max(span.end.displacement.abs());
        for left in span.structure.saturating_sub(1)..=span.structure {
            let (Some(&right), gap) = (self.ends.get(left + 1), self.gaps[left]) else {
                continue;
            };
            let scale = self.reach[left] + self.reach[left + 1] + gap;
            let left = self.ends[left];
            let together = left.0 <= right.0 && right.0 <= left.0;
            if together && gap.is_finite() {
                let overlap = left.1 - right.1 - gap;
                if overlap > 0.0 {
                    self.largest = self.largest.max(overlap / scale);
                }
            }
        }
    }

    fn impact(&mut self, _: &Impact) {}
}

fn power_of_ten(exponents: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    exponents.prop_map(|exponent| libm::pow(10.0, exponent))
}

/// At e = 1 neighbours that press against each other would bounce for ever.
fn stereomechanical() -> BoxedStrategy<ContactLaw> {
    prop_oneof![Just(0.0), 0.0..0.95_f64]
        .prop_map(|restitution| ContactLaw::Stereomechanical(Stereomechanical { restitution }))
        .boxed()
}

fn any_law() -> BoxedStrategy<ContactLaw> {
    let viscoelastic = (power_of_ten(7.0..11.0), 0.0..1.5_f64).prop_map(
        |(impact_stiffness, impact_damping_ratio)| {
            ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
                impact_stiffness,
                impact_damping_ratio,
            })
        },
    );
    prop_oneof![stereomechanical(), viscoelastic].boxed()
}

/// Rows of 1 to 6 structures with mass ratios up to 1e6 and gaps of 0 to 1 m.
fn cases(law: fn() -> BoxedStrategy<ContactLaw>) -> impl Strategy<Value = Case> {
    let structure = || {
        let yields = prop_oneof![Just(f64::INFINITY), power_of_ten(-4.0..-1.0)];
        let ratio = prop_oneof![Just(0.0), 0.0..1.2_f64];
        (
            power_of_ten(2.0..8.0),
            power_of_ten(-1.3..0.5),
            ratio,
            yields,
        )
            .prop_map(|(mass, period, ratio, yields)| [mass, period, ratio, yields])
    };
    let gap = || {
        prop_oneof![
            Just(0.0),
            power_of_ten(-8.0..-3.0),
            0.0..0.1_f64,
            0.0..1.0_f64
        ]
    };
    (1..=6_usize).prop_flat_map(move |n| {
        let structures = prop::collection::vec(structure(), n);
        let contacts = prop::collection::vec((gap(), law()), n - 1);
        let ground = prop::collection::vec(-8.0..8.0_f64, 2..60);
        (structures, contacts, ground).prop_map(|(structures, contacts, ground)| Case {
            structures,
            contacts,
            ground,
        })
    })
}

/// Largest difference of two histories relative to the largest displacement, with a factor on the second.
fn distance(a: &Histories, b: &Histories, (left, right): (usize, usize), factor: f64) -> f64 {
    let (a, b) = (&a.of(left).states, &b.of(right).states);
    let largest = a
        .iter()
        .fold(0.0, |m: f64, state| m.max(state.displacement.abs()));
    let differences = a
        .iter()
        .zip(b)
        .map(|(a, b)| (a.displacement - factor * b.displacement).abs());
    differences.fold(0.0, f64::max) / largest.max(1e-12)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn limit_balances_and_contact_laws_hold(case in cases(any_law)) {
        let outcome = case.run(SI);
        for balance in outcome.balances {
            prop_assert!(balance < 1e-10, "residual, identity, momentum: {:?}", outcome.balances);
        }
        prop_assert_eq!(&outcome.laws, &Ok(()));
        prop_assert!(outcome.overlap < 1e-12, "overlap {:e}", outcome.overlap);
    }

    #[test]
    fn limit_mirrored_rows_mirror(case in cases(any_law)) {
        let mut mirrored = case.clone();
        mirrored.structures.reverse();
        mirrored.contacts.reverse();
        for sample in &mut mirrored.ground {
            *sample = -*sample;
        }
        let (one, other) = (case.run(SI), mirrored.run(SI));
        let n = case.structures.len();
        // Chaos amplifies the rounding of sums over three and more structures; rows of two are the same to the bit.
        if n <= 2 {
            for index in 0..n {
                prop_assert!(distance(&one.histories, &other.histories, (index, n - 1 - index), -1.0) == 0.0);
                prop_assert!(one.momentum[index].to_bits() == other.momentum[n - 1 - index].to_bits());
            }
        }
    }

    #[test]
    fn limit_units_of_length_and_mass_scale(case in cases(stereomechanical)) {
        // By powers of two: nothing is rounded, and every bit scales.
        let units = Units { length: 8.0, mass: 0.25, time: 1.0 };
        let (one, other) = (case.run(SI), case.run(units));
        for index in 0..case.structures.len() {
            prop_assert!(distance(&one.histories, &other.histories, (index, index), 0.125) == 0.0);
            let scaled = other.momentum[index] / (units.mass * units.length);
            prop_assert!(one.momentum[index].to_bits() == scaled.to_bits());
        }
    }

    #[test]
    fn limit_the_unit_of_time_scales(mut case in cases(stereomechanical)) {
        // The shortest remainder of bounces is 1e-12 s in any unit; rows of two do not amplify that into another motion.
        case.structures.truncate(2);
        case.contacts.truncate(1);
        let units = Units { length: 1.0, mass: 1.0, time: 2.0 };
        let (one, other) = (case.run(SI), case.run(units));
        for index in 0..case.structures.len() {
            let apart = distance(&one.histories, &other.histories, (index, index), 1.0);
            prop_assert!(apart < 1e-9, "{apart:e}");
        }
    }

    #[test]
    fn limit_rows_apart_superpose(case in cases(any_law), other in cases(any_law)) {
        // Two rows that share no pair, run as one, keep every bit; so do structures alone.
        let gap = 1e3;
        let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.5 });
        let mut joined = case.clone();
        joined.contacts.push((gap, law));
        joined.contacts.extend(&other.contacts);
        joined.structures.extend(&other.structures);
        let other = Case { ground: case.ground.clone(), ..other };
        let (alone, beside, joined) = (case.run(SI), other.run(SI), joined.run(SI));
        let n = case.structures.len();
        for index in 0..n {
            prop_assert_eq!(alone.histories.of(index), joined.histories.of(index));
        }
        for index in 0..other.structures.len() {
            prop_assert_eq!(beside.histories.of(index), joined.histories.of(n + index));
        }
    }
}
