//! The ledger detects false reports of a method about a building: each fault is put into a correct run and must be found.

use pounding_solver::{Excitation, Hysteretic, Impact, Ledger, LedgerError, Path, Push, Recorder, Span};

use crate::common::{RK4, clock, ground};
use crate::storeys_ledger::{DAMPING, TOWERS, bilinear, elastic, plastic, smooth};
use crate::towers::row;
use crate::watch::Watch;

/// Passes a run of a tower of two storeys on to a ledger, with a fault in both spans of a step.
struct Faulty<'a, F> {
    ledger: Ledger<'a>,
    lower: Option<Span<'static>>,
    fault: F,
}

/// A step without its borrowed data.
fn step(span: &Span<'_>) -> Span<'static> {
    let Path::Cubic(weighed) = span.path else {
        panic!("a step: {span:?}");
    };
    let pushes = span.pushes.iter().map(|push| Push { series: &[], ..*push });
    Span {
        structure: span.structure,
        start_time: span.start_time,
        end_time: span.end_time,
        start: span.start,
        end: span.end,
        impulse_from_left: span.impulse_from_left,
        impulse_from_right: span.impulse_from_right,
        below: span.below,
        path: Path::Cubic(weighed),
        pushes: pushes.collect::<Vec<_>>().leak(),
        links: &[],
    }
}

impl<F: Fn(&mut [Span<'static>; 2])> Recorder for Faulty<'_, F> {
    fn reads_weighed(&self) -> bool {
        true
    }

    fn span(&mut self, span: &Span<'_>) {
        let Some(lower) = self.lower.take() else {
            self.lower = Some(step(span));
            return;
        };
        let mut spans = [lower, step(span)];
        (self.fault)(&mut spans);
        for span in &spans {
            self.ledger.span(span);
        }
    }

    fn impact(&mut self, _: &Impact) {}
}

/// Result of the ledger for a tower with a fault: own balances, physical balance, and verdict.
fn found<Column: Hysteretic>(
    column: impl Fn(f64, f64) -> Column,
    fault: impl Fn(&mut [Span<'static>; 2]),
) -> ([f64; 3], Result<(), LedgerError>) {
    let samples = ground();
    let storeys = TOWERS[1].iter();
    let floors = storeys.map(|(mass, k, force)| (*mass, column(*k, 0.3 * force)));
    let (row, _) = row(&[floors.collect()], DAMPING, |_, _, _| None);
    let excitation = Excitation::new(0.01, &samples).expect("the ground motion is finite");
    let mut faulty = Faulty {
        ledger: Ledger::new(&row, excitation),
        lower: None,
        fault,
    };
    RK4.watch(&row, excitation, clock(0.001, 5.0), &mut faulty).expect("the run ends");
    let ledger = faulty.ledger;
    (
        [ledger.identity(), ledger.momentum(), ledger.residual()],
        ledger.verdict().map(|_| ()),
    )
}

#[test]
fn limit_a_good_tower_shows_nothing() {
    let good = |([identity, momentum, residual], verdict): ([f64; 3], Result<(), LedgerError>)| {
        let balanced = identity < 1e-12 && momentum < 1e-12 && residual < 1e-4;
        assert!(balanced, "{identity:e}, {momentum:e}, {residual:e}");
        assert!(verdict.is_ok(), "{verdict:?}");
    };
    good(found(elastic, |_| ()));
    good(found(plastic, |_| ()));
    good(found(bilinear, |_| ()));
    good(found(smooth, |_| ()));
}

/// The upper storey pulls its floor, but the report of the floor below lacks the reaction.
#[test]
fn limit_a_storey_that_does_not_push_back_shows_in_the_methods_own_balance() {
    let forgets = |spans: &mut [Span<'static>; 2]| {
        if let [Path::Cubic(lower), Path::Cubic(upper)] = [spans[0].path, spans[1].path] {
            let mut lower = lower;
            lower.restoring += upper.restoring;
            spans[0].path = Path::Cubic(lower);
        }
    };
    let ([identity, momentum, residual], _) = found(elastic, forgets);
    assert!(identity > 1e-2 && momentum > 1e-2, "{identity:e}, {momentum:e}");
    assert!(residual < 1e-4, "the motion is right: {residual:e}");
    let slightly = |spans: &mut [Span<'static>; 2]| {
        if let Path::Cubic(lower) = &mut spans[0].path {
            lower.damping *= 1.000_1;
        }
    };
    let ([identity, momentum, _], _) = found(elastic, slightly);
    assert!(identity > 1e-8 && momentum > 1e-8, "{identity:e}, {momentum:e}");
}

/// The method reports another drift than that of its columns.
#[test]
fn limit_a_wrong_drift_shows_in_the_physical_balance() {
    let stands_on_nothing = |spans: &mut [Span<'static>; 2]| spans[1].below = None;
    let ([identity, _, residual], _) = found(bilinear, stands_on_nothing);
    assert!(identity < 1e-12, "the impulses are right: {identity:e}");
    assert!(residual > 1e-3, "the energies are not: {residual:e}");
    let late = |spans: &mut [Span<'static>; 2]| {
        let [start, _] = spans[1].below.expect("a floor below");
        spans[1].below = Some([start, start]);
    };
    let ([identity, _, residual], _) = found(smooth, late);
    assert!(identity < 1e-12, "the impulses are right: {identity:e}");
    assert!(residual > 1e-3, "the drifts are not: {residual:e}");
}

#[test]
fn limit_columns_that_give_energy_in_yielding_are_named() {
    // Yielding against a constant force.
    let backwards = |spans: &mut [Span<'static>; 2]| {
        let upper = &mut spans[1];
        let [start, end] = upper.drifts();
        if end.displacement - start.displacement > 1e-6 {
            upper.end.restoring_force = -1.2 * 3e5;
            upper.start.restoring_force = upper.end.restoring_force;
        }
    };
    for verdict in [
        found(plastic, backwards).1,
        found(bilinear, backwards).1,
        found(smooth, backwards).1,
    ] {
        let named = matches!(verdict, Err(LedgerError::GainInYielding { structure: 1, .. }));
        assert!(named, "{verdict:?}");
    }
}
