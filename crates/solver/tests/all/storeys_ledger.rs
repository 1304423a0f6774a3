//! The ledger and stability of buildings of several storeys.

use pounding_contact::ContactLaw;
use pounding_solver::{
    Bilinear, BoucWen, Elastic, Excitation, Hysteretic, Ledger, LedgerError, Node, Pair, Row, RunError, Smoothness, modes,
};

use proptest::prelude::*;
use proptest::test_runner::TestCaseError;

use crate::common::{RK4, STEREOMECHANICAL, VISCOELASTIC, book, clock, ground, slope};
use crate::towers::{Rayleigh, Tower, row};
use crate::watch::Watch;

pub(crate) const DAMPING: Rayleigh = Rayleigh { alpha: 0.4, beta: 1.2e-3 };

/// Mass \[kg\], stiffness \[N/m\] and yield force \[N\] of storeys.
pub(crate) type Storeys = &'static [(f64, f64, f64)];

/// Towers of three storeys, of two stiffer storeys, and of four soft storeys.
pub(crate) const TOWERS: [Storeys; 3] = [
    &[(1e5, 6e7, 4e5), (1e5, 5e7, 3e5), (7e4, 4e7, 2e5)],
    &[(3e5, 6e8, 2e6), (2e5, 4e8, 1e6)],
    &[(8e4, 3e7, 2e5), (8e4, 3e7, 2e5), (8e4, 2e7, 1.5e5), (5e4, 2e7, 1e5)],
];

pub(crate) fn elastic(stiffness: f64, _: f64) -> Elastic {
    Elastic { stiffness }
}

pub(crate) fn plastic(stiffness: f64, yield_force: f64) -> Bilinear {
    Bilinear {
        stiffness,
        yield_force,
        hardening: 0.0,
    }
}

pub(crate) fn bilinear(stiffness: f64, yield_force: f64) -> Bilinear {
    Bilinear {
        stiffness,
        yield_force,
        hardening: 0.05,
    }
}

pub(crate) fn smooth(stiffness: f64, yield_force: f64) -> BoucWen {
    BoucWen {
        stiffness,
        yield_force,
        hardening: 0.05,
        smoothness: Smoothness {
            exponent: 2,
            unloading: 0.5,
        },
    }
}

/// The towers in a row, in motion from the start, touching by a law if there is one.
pub(crate) fn towers<Column: Hysteretic>(column: impl Fn(f64, f64) -> Column, law: Option<ContactLaw>) -> Row<Column> {
    let build = |storeys: &Storeys| -> Tower<Column> {
        let floor = |(mass, stiffness, force): &(f64, f64, f64)| (*mass, column(*stiffness, *force));
        storeys.iter().map(floor).collect()
    };
    let buildings: Vec<_> = TOWERS.iter().map(build).collect();
    let (row, levels) = row(&buildings, DAMPING, |_, _, [left, right]| {
        let gap = 0.01;
        law.map(|law| Pair::of_floors(left, right, gap, law))
    });
    let moving = |(index, node): (usize, &Node<Column>)| {
        let (building, storey) = levels.place(index);
        let away = [-1.0, 0.0, 1.0][building] * (storey as f64 + 1.0);
        Node {
            initial_displacement: 1e-3 * away,
            initial_velocity: -0.05 * away,
            ..*node
        }
    };
    let nodes = row.nodes().iter().enumerate().map(moving).collect();
    Row::new(nodes, row.pairs().to_vec()).expect("the row is valid")
}

/// A ground motion under which all floors that face each other collide.
pub(crate) fn strong() -> Vec<f64> {
    ground().iter().map(|sample| 1.5 * sample).collect()
}

const LAWS: [Option<ContactLaw>; 3] = [None, Some(STEREOMECHANICAL), Some(VISCOELASTIC)];

fn check_balances<Column: Hysteretic>(what: &str, column: impl Fn(f64, f64) -> Column, yields: bool) {
    let samples = strong();
    for law in LAWS {
        let row = towers(&column, law);
        for time_step in [0.002, 0.000_5] {
            let ledger = book(&row, RK4, &samples, clock(time_step, 5.0));
            let what = format!("{what}, {law:?}, {time_step}");
            assert!(ledger.identity() < 1e-12, "{what}: {:e}", ledger.identity());
            assert!(ledger.momentum() < 1e-12, "{what}: {:e}", ledger.momentum());
            let verdict = ledger.verdict();
            assert!(verdict.is_ok(), "{what}: {verdict:?}");
            let touched = |pair| ledger.of_pair(pair).impulse > 0.0;
            assert!((0..row.pairs().len()).all(touched), "{what}: no contact");
            let took = ledger.terms().hysteretic > 0.01 * ledger.scale();
            assert_eq!(took, yields, "{what}: {:?}", ledger.terms());
        }
    }
}

#[test]
fn limit_every_tower_balances_its_own_energy() {
    check_balances("elastic", elastic, false);
    check_balances("plastic", plastic, true);
    check_balances("bilinear", bilinear, true);
    check_balances("smooth", smooth, true);
}

/// Works are impulses times mean velocities, an error of order two in each step for any method.
fn check_order<Column: Hysteretic>(what: &str, column: impl Fn(f64, f64) -> Column) {
    let row = towers(column, None);
    let samples = ground();
    let steps = [0.002, 0.001, 0.000_5, 0.000_25];
    let residuals = steps.map(|dt| book(&row, RK4, &samples, clock(dt, 5.0)).residual());
    let found = slope(&steps, &residuals);
    assert!((found - 2.0).abs() < 0.25, "{what}: {found}, {residuals:?}");
    assert!(residuals[3] < 1e-5, "{what}: {residuals:?}");
}

#[test]
fn order_the_physical_balance_of_towers_tends_to_zero() {
    check_order("elastic", elastic);
    check_order("plastic", plastic);
    check_order("bilinear", bilinear);
    check_order("smooth", smooth);
}

#[test]
fn limit_storeys_that_do_not_yield_book_the_same() {
    let samples = ground();
    let run = clock(0.002, 5.0);
    for law in LAWS {
        let lean = towers(elastic, law);
        let lean = book(&lean, RK4, &samples, run);
        let rich = towers(|k, _| plastic(k, f64::INFINITY), law);
        let rich = book(&rich, RK4, &samples, run);
        assert_eq!(lean.terms(), rich.terms(), "plastic");
        let yields = towers(plastic, law);
        let yields = book(&yields, RK4, &samples, run);
        let soft = |k, force| Bilinear {
            hardening: 0.0,
            ..bilinear(k, force)
        };
        let soft = towers(soft, law);
        let soft = book(&soft, RK4, &samples, run);
        assert_eq!(yields.terms(), soft.terms(), "no hardening");
        // With hardening, force and energy are equal, but summed in another order.
        for (name, other) in [
            ("bilinear", book_never(bilinear, law, &samples)),
            ("smooth", book_never(smooth, law, &samples)),
        ] {
            let distance = lean.error(&other);
            assert!(distance < 1e-10, "{name}: {distance:e}");
            assert!(other.terms().hysteretic == 0.0, "{name} does not yield");
        }
    }
}

/// Columns with a yield force that is never reached.
fn book_never<Column: Hysteretic>(column: impl Fn(f64, f64) -> Column, law: Option<ContactLaw>, samples: &[f64]) -> Ledger<'_> {
    let row = towers(|k, _| column(k, f64::INFINITY), law);
    book(&row, RK4, samples, clock(0.002, 5.0))
}

/// Undamped towers keep their initial energy, which is in the drifts.
#[test]
fn limit_free_vibration_of_a_tower_keeps_its_energy() {
    let floors = vec![(1e5, elastic(6e7, 0.0)), (8e4, elastic(4e7, 0.0))];
    let damping = Rayleigh { alpha: 0.0, beta: 0.0 };
    let (still, _) = row(&[floors], damping, |_, _, _| None);
    let mut nodes = still.nodes().to_vec();
    (nodes[0].initial_displacement, nodes[1].initial_displacement) = (0.01, -0.02);
    nodes[1].initial_velocity = 0.4;
    let row = Row::new(nodes, vec![]).unwrap();
    let ledger = book(&row, RK4, &[0.0], clock(0.000_5, 5.0));
    let terms = ledger.terms();
    let energy = 0.5 * (6e7 * 0.01 * 0.01 + 4e7 * 0.03 * 0.03 + 8e4 * 0.4 * 0.4);
    assert!((terms.initial / energy - 1.0).abs() < 1e-14, "{terms:?}");
    let held = terms.kinetic + terms.strain;
    assert!((held / energy - 1.0).abs() < 1e-6, "{terms:?}");
    assert_eq!(ledger.of_building(0), terms);
    // Single floors do not balance: a floor gains energy that another loses.
    assert!(ledger.of(0).balance().abs() > 1e-3 * energy, "{:?}", ledger.of(0));
    assert!(terms.balance().abs() < 1e-6 * energy, "{terms:?}");
}

/// The Runge–Kutta method is stable up to the limit of the fastest mode, and unstable above.
#[test]
fn reference_the_critical_time_step_of_a_tower() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).unwrap();
    let row = towers(elastic, None);
    let stands = |floors: &&[usize]| !row.nodes()[floors[0]].is_wall();
    let limits = row.buildings().each().filter(stands).map(|floors| {
        let modes = row.modes(floors[0]).expect("a building");
        RK4.critical_time_step_of(&modes).expect("a limit")
    });
    let least = limits.fold(f64::INFINITY, f64::min);
    let run = |part: f64| {
        let clock = pounding_solver::Clock {
            time_step: part * least,
            n_steps: 20_000,
        };
        RK4.watch(&row, excitation, clock, &mut ())
    };
    assert!(run(0.999).is_ok(), "below {least}: {:?}", run(0.999));
    let above = run(1.01);
    assert!(matches!(above, Err(RunError::Diverged { .. })), "{above:?}");
    assert_eq!(RK4.critical_time_step_of(&modes::<Elastic>(&[]).unwrap()), None);
}

/// Towers of random storeys: mass \[kg\], period of the floor on its columns \[s\], yield force over mass \[m/s²\].
type Random = Vec<Vec<(f64, f64, f64)>>;

fn balances_at_random<Column: Hysteretic>(
    towers: &Random,
    law: ContactLaw,
    column: impl Fn(f64, f64) -> Column,
) -> Result<(), TestCaseError> {
    let build = |storeys: &Vec<(f64, f64, f64)>| -> Tower<Column> {
        let floor = |&(mass, period, yields): &(f64, f64, f64)| {
            let omega = 2.0 * std::f64::consts::PI / period;
            (mass, column(mass * omega * omega, yields * mass))
        };
        storeys.iter().map(floor).collect()
    };
    let buildings: Vec<_> = towers.iter().map(build).collect();
    let (row, _) = row(&buildings, DAMPING, |_, _, [left, right]| {
        let gap = 0.005;
        Some(Pair::of_floors(left, right, gap, law))
    });
    let stands = |floors: &&[usize]| !row.nodes()[floors[0]].is_wall();
    let limits = row.buildings().each().filter(stands).map(|floors| {
        let modes = row.modes(floors[0]).expect("a building");
        RK4.critical_time_step_of(&modes).expect("a limit")
    });
    let time_step = 0.2 * limits.fold(0.005, f64::min);
    let samples = ground();
    let ledger = book(&row, RK4, &samples, clock(time_step, 2.0));
    prop_assert!(ledger.identity() < 1e-12, "{:e}", ledger.identity());
    prop_assert!(ledger.momentum() < 1e-12, "{:e}", ledger.momentum());
    let allowed = match ledger.verdict() {
        // The steps resolve the towers, but not every contact.
        Ok(_) | Err(LedgerError::GainInContact { .. }) => true,
        Err(_) => false,
    };
    prop_assert!(allowed, "{:?}", ledger.verdict());
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn limit_random_towers_balance(
        towers in prop::collection::vec(
            prop::collection::vec((1e4..1e6_f64, 0.05..0.5_f64, 0.3..10.0_f64), 1..6),
            1..5,
        ),
        compliant in prop::bool::ANY,
        hardening in 0.0..0.6_f64,
        exponent in 1..8_u32,
        unloading in 0.0..=1.0_f64,
    ) {
        let law = if compliant { VISCOELASTIC } else { STEREOMECHANICAL };
        let smoothness = Smoothness { exponent, unloading };
        balances_at_random(&towers, law, elastic)?;
        balances_at_random(&towers, law, plastic)?;
        balances_at_random(&towers, law, |k, force| Bilinear { hardening, ..bilinear(k, force) })?;
        balances_at_random(&towers, law, |k, force| BoucWen {
            hardening,
            smoothness,
            ..smooth(k, force)
        })?;
    }
}
