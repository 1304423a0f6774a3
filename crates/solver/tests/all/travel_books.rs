//! The ledger of rows with travelling ground motion: grounds that move apart do work through contact.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Elastic, Hysteretic, Laws, Ledger, Node, Row};

use crate::common::{METHODS, STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, book, clock, elastic, ground, pairs, yielding};
use crate::travel::{EXACT, all, towers};
use crate::watch::Watch;

/// The paper's structures and a wall, each with its arrival.
fn rows(law: ContactLaw) -> [Row<Elastic>; 3] {
    let nodes = vec![elastic(WEAK), elastic(STIFF), elastic(WEAK)];
    let three = Row::new(nodes, pairs(3, 0.01, law)).expect("it is valid");
    let walled = vec![elastic(WEAK), Node::wall(Elastic { stiffness: 1.0 })];
    let walled = Row::new(walled, pairs(2, 0.01, law)).expect("it is valid");
    let (towers, of) = towers(law);
    let arrivals = of.iter().map(|of| [0.0, 0.06, 0.15][*of]).collect();
    [
        three.delayed(vec![0.0, 0.06, 0.15]).expect("it is valid"),
        walled.delayed(vec![0.0, 0.1]).expect("it is valid"),
        towers.delayed(arrivals).expect("it is valid"),
    ]
}

fn impulsive(restitution: f64) -> ContactLaw {
    ContactLaw::Stereomechanical(Stereomechanical { restitution })
}

/// Checks both balances, the verdict, and that the energy taken by pairs is that given by floors.
fn check(ledger: &Ledger<'_>, n_pairs: usize, what: &str) {
    assert!(ledger.identity() < 1e-11, "{what}: {:e}", ledger.identity());
    assert!(ledger.momentum() < 1e-11, "{what}: {:e}", ledger.momentum());
    let terms = ledger.verdict().unwrap_or_else(|error| panic!("{what}: {error}"));
    let pairs = (0..n_pairs).map(|pair| ledger.of_pair(pair));
    let (impact, contact) = pairs.fold((0.0, 0.0), |(impact, contact), pair| (impact + pair.impact, contact + pair.contact));
    let apart = (terms.impact - impact).abs() + (terms.contact - contact).abs();
    assert!(apart < 1e-10 * ledger.scale(), "{what}: {apart:e}");
    assert!(impact + contact >= 0.0, "{what}: {impact:e} {contact:e}");
}

#[test]
fn reference_energy_of_exact_runs_balances_while_grounds_move_apart() {
    let samples = ground();
    for law in [impulsive(0.0), STEREOMECHANICAL, impulsive(0.9), VISCOELASTIC] {
        for (index, row) in rows(law).iter().enumerate() {
            let what = format!("{law:?}, row {index}");
            let ledger = book(row, EXACT, &samples, clock(0.01, 5.0));
            check(&ledger, row.pairs().len(), &what);
            assert!(ledger.residual() < 1e-9, "{what}: {:e}", ledger.residual());
            // Without this term the balance does not close.
            let opening = ledger.terms().opening.abs();
            assert!(opening > 1e-4 * ledger.scale(), "{what}: {opening:e}");
        }
    }
}

#[test]
fn reference_every_method_reports_what_it_did_while_grounds_move_apart() {
    let samples = ground();
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        for (name, method) in METHODS {
            for (index, row) in rows(law).iter().enumerate() {
                let what = format!("{name}, {law:?}, row {index}");
                let excitation = pounding_solver::Excitation::new(0.01, &samples).expect("it is valid");
                let mut ledger = Ledger::new(row, excitation).held_to(Laws::All);
                let clock = clock(2e-4, 3.0);
                method.watch(row, excitation, clock, &mut ledger).expect("the run ends");
                check(&ledger, row.pairs().len(), &what);
            }
        }
    }
}

#[test]
fn limit_grounds_that_move_alike_open_nothing() {
    let samples = ground();
    let nodes = vec![yielding(WEAK), yielding(STIFF)];
    let row = Row::new(nodes, pairs(2, 0.02, VISCOELASTIC)).expect("it is valid");
    let late = row.clone().delayed(vec![0.3; 2]).expect("it is valid");
    for (name, method) in all() {
        let [at_once, late] = [&row, &late].map(|row| opening(row, method, &samples));
        assert_eq!((at_once, late), (0.0, 0.0), "{name}");
    }
}

fn opening<Column: Hysteretic>(row: &Row<Column>, method: pounding_solver::Integrator, samples: &[f64]) -> f64 {
    book(row, method, samples, clock(0.002, 3.0)).terms().opening
}
