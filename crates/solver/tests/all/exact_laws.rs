//! Laws of mechanics for the exact method on random rows.

use pounding_contact::{ContactLaw, NonlinearViscoelastic, Stereomechanical};
use pounding_solver::{
    Bilinear, Clock, Collisions, Exact, Excitation, Histories, Impact, Integrator, Ledger, Recorder, Row, RunError, Span,
    TransferredMomentum,
};
use proptest::prelude::*;

use crate::random_rows::{Case, SI, Units, any_law, cases, config, stereomechanical};
use crate::watch::Watch;

const CLOCK: Clock = Clock {
    time_step: 0.01,
    n_steps: 60,
};

/// Runs a case. Returns `None` if the method refuses it, about two rows in a thousand. Then e is so close to 1 that a pair bounces without
/// end, or a damper with 1/v₀ is too strong to follow the contact.
fn run(case: &Case, units: Units) -> Option<Outcome> {
    let row = case.row(units);
    let n = row.nodes().len();
    let acceleration = units.length / (units.time * units.time);
    let ground: Vec<_> = case.ground.iter().map(|a| a * acceleration).collect();
    let excitation = Excitation::new(0.01 * units.time, &ground).expect("the ground motion is finite");
    let time_step = CLOCK.time_step * units.time;
    let clock = Clock { time_step, ..CLOCK };
    let duration = clock.time(clock.n_steps);
    let mut recorders = (
        TransferredMomentum::new(n),
        Histories::new(n, time_step, duration),
        (Ledger::new(&row, excitation), Overlap::new(&row)),
        (Collisions::new(n, row.pairs()), Histories::new(n, time_step / 32.0, duration)),
    );
    match Integrator::Exact(Exact::default()).watch(&row, excitation, clock, &mut recorders) {
        Ok(_) => {}
        Err(RunError::BouncesWithoutEnd { restitution, .. }) if restitution > 0.999 => return None,
        Err(RunError::CrawlsInContact { .. }) => return None,
        Err(error) => panic!("the run ends early: {error}"),
    }
    let (momentum, histories, (ledger, overlap), (collisions, dense)) = recorders;
    let laws = ledger.verdict().map(|_| ()).map_err(|error| error.to_string());
    Some(Outcome {
        momentum: (0..n).map(|index| momentum.of(index)).collect(),
        histories,
        dense,
        first_touch: collisions.all().first().map(|first| first.start),
        balances: [ledger.residual(), ledger.identity(), ledger.momentum()],
        laws,
        overlap: overlap.largest,
    })
}

#[derive(Debug)]
struct Outcome {
    momentum: Vec<f64>,
    histories: Histories,
    /// A state at every 32nd part of a sample interval.
    dense: Histories,
    first_touch: Option<f64>,
    balances: [f64; 3],
    laws: Result<(), String>,
    overlap: f64,
}

/// The largest overlap of an impulsive pair relative to displacements and gap, at common ends of spans of both sides.
struct Overlap {
    /// Gap on the right of each structure; infinite without a pair, and for a compliant pair.
    gaps: Vec<f64>,
    /// Last instant and displacement of every structure.
    ends: Vec<(f64, f64)>,
    largest: f64,
    /// Largest displacement of each structure so far.
    reach: Vec<f64>,
}

impl Overlap {
    fn new(row: &Row<Bilinear>) -> Self {
        let n = row.nodes().len();
        let mut gaps = vec![f64::INFINITY; n];
        for pair in row.pairs() {
            if matches!(pair.law, ContactLaw::Stereomechanical(_)) {
                gaps[pair.left()] = pair.gap();
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

/// Largest overlap of impulsive pairs at the instants of histories, relative to displacements and gap. It would show a touch that was
/// missed between two events.
fn overlap_between_events(case: &Case, dense: &Histories) -> f64 {
    let mut largest: f64 = 0.0;
    for (left, (gap, law)) in case.contacts.iter().enumerate() {
        if !matches!(law, ContactLaw::Stereomechanical(_)) {
            continue;
        }
        let states = dense.of(left).states.iter().zip(&dense.of(left + 1).states);
        let reach = states.clone().map(|(a, b)| a.displacement.abs() + b.displacement.abs());
        let scale = reach.fold(*gap, f64::max).max(1e-12);
        let overlaps = states.map(|(a, b)| (a.displacement - b.displacement - gap) / scale);
        largest = largest.max(overlaps.fold(0.0, f64::max));
    }
    largest
}

/// Largest difference of two histories relative to the largest displacement; the second history is multiplied by a factor.
fn distance(a: &Histories, b: &Histories, (left, right): (usize, usize), factor: f64) -> f64 {
    let (a, b) = (&a.of(left).states, &b.of(right).states);
    let largest = a.iter().fold(0.0, |m: f64, state| m.max(state.displacement.abs()));
    let differences = a.iter().zip(b).map(|(a, b)| (a.displacement - factor * b.displacement).abs());
    differences.fold(0.0, f64::max) / largest.max(1e-12)
}

/// The outcome of a run; skips a case without outcome.
macro_rules! ended {
    ($run:expr) => {
        match $run {
            Some(outcome) => outcome,
            None => return Err(TestCaseError::reject("a limit of the method")),
        }
    };
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn limit_balances_and_contact_laws_hold(case in cases(any_law)) {
        let outcome = ended!(run(&case, SI));
        for balance in outcome.balances {
            prop_assert!(balance < 1e-10, "residual, identity, momentum: {:?}", outcome.balances);
        }
        prop_assert_eq!(&outcome.laws, &Ok(()));
        prop_assert!(outcome.overlap < 1e-12, "overlap {:e}", outcome.overlap);
        let between = overlap_between_events(&case, &outcome.dense);
        prop_assert!(between < 1e-11, "overlap between events {between:e}");
    }
}

proptest! {
    #![proptest_config(config(100))]

    #[test]
    fn limit_mirrored_rows_mirror(case in cases(any_law)) {
        let mut mirrored = case.clone();
        mirrored.structures.reverse();
        mirrored.velocities.reverse();
        for velocity in &mut mirrored.velocities {
            *velocity = -*velocity;
        }
        mirrored.contacts.reverse();
        for sample in &mut mirrored.ground {
            *sample = -*sample;
        }
        let (one, other) = (ended!(run(&case, SI)), ended!(run(&mirrored, SI)));
        let n = case.structures.len();
        // Chaos amplifies the rounding of sums over three and more structures; rows of two are equal to the bit.
        if n <= 2 {
            for index in 0..n {
                prop_assert!(distance(&one.histories, &other.histories, (index, n - 1 - index), -1.0) == 0.0);
                prop_assert!(one.momentum[index].to_bits() == other.momentum[n - 1 - index].to_bits());
            }
        }
        // Before the first touch nothing is amplified.
        match (one.first_touch, other.first_touch) {
            (None, None) => {}
            (Some(one), Some(other)) => prop_assert!((one - other).abs() <= 1e-12, "{one} {other}"),
            touches => prop_assert!(false, "{touches:?}"),
        }
    }

    #[test]
    fn limit_units_of_length_and_mass_scale(case in cases(stereomechanical)) {
        // Powers of two: nothing is rounded, and every bit scales.
        let units = Units { length: 8.0, mass: 0.25, time: 1.0 };
        let (one, other) = (ended!(run(&case, SI)), ended!(run(&case, units)));
        for index in 0..case.structures.len() {
            prop_assert!(distance(&one.histories, &other.histories, (index, index), 0.125) == 0.0);
            let scaled = other.momentum[index] / (units.mass * units.length);
            prop_assert!(one.momentum[index].to_bits() == scaled.to_bits());
        }
    }

    #[test]
    fn limit_the_unit_of_time_scales(mut case in cases(stereomechanical)) {
        // The shortest remainder of bounces is 1e-12 s in any unit; rows of two do not amplify this difference.
        case.structures.truncate(2);
        case.velocities.truncate(2);
        case.contacts.truncate(1);
        let units = Units { length: 1.0, mass: 1.0, time: 2.0 };
        let (one, other) = (ended!(run(&case, SI)), ended!(run(&case, units)));
        for index in 0..case.structures.len() {
            let apart = distance(&one.histories, &other.histories, (index, index), 1.0);
            prop_assert!(apart < 1e-9, "{apart:e}");
        }
    }

    #[test]
    fn limit_rows_apart_superpose(case in cases(any_law), other in cases(any_law)) {
        superpose(&case, &other)?;
    }
}

/// Two rows without a common pair, run as a single row, keep every bit; so do structures alone.
fn superpose(case: &Case, other: &Case) -> Result<(), TestCaseError> {
    let gap = 1e3;
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.5 });
    let mut joined = case.clone();
    joined.contacts.push((gap, law));
    joined.contacts.extend(&other.contacts);
    joined.structures.extend(&other.structures);
    joined.velocities.extend(&other.velocities);
    let other = Case {
        ground: case.ground.clone(),
        ..other.clone()
    };
    let (alone, beside, joined) = (ended!(run(case, SI)), ended!(run(&other, SI)), ended!(run(&joined, SI)));
    let n = case.structures.len();
    for index in 0..n {
        prop_assert_eq!(alone.histories.of(index), joined.histories.of(index));
    }
    for index in 0..other.structures.len() {
        prop_assert_eq!(beside.histories.of(index), joined.histories.of(n + index));
    }
    Ok(())
}

/// The duration of a piece was rounded to the clock, which other structures set back.
#[test]
fn issue_a_piece_lasts_as_long_whatever_others_do() {
    let far = Case {
        structures: vec![[100.0, 0.158_375_968_098_102_23, 0.197_359_394_736_922_63, f64::INFINITY]],
        contacts: Vec::new(),
        velocities: vec![0.0],
        ground: vec![
            7.853_006_373_945_575,
            -3.595_953_562_096_795,
            -6.743_423_554_719_269,
            -7.005_784_558_382_150_5,
            -1.106_884_062_799_197_2,
            -7.265_003_555_961_634,
            -1.058_283_927_619_250_6,
            -0.961_297_062_812_280_8,
            -3.854_432_901_093_711,
            -4.621_591_389_538_059,
            -7.870_356_621_011_59,
            -2.861_862_823_353_198,
            3.317_639_639_367_164_8,
            0.797_060_456_207_802,
            -0.430_316_000_635_922_46,
            4.747_710_285_199_355,
            6.486_997_901_800_348,
            2.886_986_199_373_668_5,
        ],
    };
    let spring = NonlinearViscoelastic {
        impact_stiffness: 1_552_698_754.168_155_7,
        impact_damping_ratio: 0.0,
    };
    let pair = Case {
        structures: vec![
            [109.116_972_365_469_12, 0.076_212_568_156_493_77, 0.0, f64::INFINITY],
            [13_509_602.725_892_49, 0.507_764_349_832_866_3, 0.0, 0.017_111_160_139_678_127],
        ],
        contacts: vec![(5.215_754_543_734_229e-6, ContactLaw::NonlinearViscoelastic(spring))],
        velocities: vec![-0.387_636_964_617_318_84, 0.020_296_529_101_826_218],
        ground: Vec::new(),
    };
    superpose(&far, &pair).expect("no bit changes");
}
