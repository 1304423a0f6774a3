//! Budgets of runs: a run ends within its budget with unchanged bits, or names the setting to change.

use std::sync::atomic::{AtomicBool, Ordering};

use pounding_contact::{ContactLaw, KelvinVoigt, Stereomechanical};
use pounding_solver::{Budget, Clock, Elastic, Exact, Excitation, Histories, Impact, Integrator, Recorder, Row, RunError, Span, Work};

use crate::common::{METHODS, STIFF, VISCOELASTIC, WEAK, clock, elastic, ground, pairs};

const EXACT: Integrator = Integrator::Exact(Exact {
    tolerance: 1e-16,
    simultaneous_impacts: pounding_solver::SimultaneousImpacts::Together,
});
/// A stop flag that is set before the run begins.
static STOPPED: AtomicBool = AtomicBool::new(true);
const STOP: Budget = Budget {
    pieces: Budget::PIECES,
    seconds: None,
    stop: Some(&STOPPED),
};
/// More steps than between two checks of the budget.
const LONG: Clock = Clock {
    time_step: 1e-4,
    n_steps: 40_000,
};

fn two(law: ContactLaw) -> Row<Elastic> {
    let nodes = vec![elastic(WEAK), elastic(STIFF)];
    Row::new(nodes, pairs(2, 0.01, law)).expect("a row")
}

fn run(method: Integrator, row: &Row<Elastic>, (clock, budget): (Clock, Budget)) -> Result<Work, RunError> {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("the motion is finite");
    method.run(row, excitation, clock.within(budget), &mut ())
}

fn pieces(pieces: f64) -> Budget {
    Budget {
        pieces,
        ..Budget::default()
    }
}

fn kelvin_voigt(impact_damping_ratio: f64) -> ContactLaw {
    ContactLaw::KelvinVoigt(KelvinVoigt {
        impact_stiffness: 9e7,
        impact_damping_ratio,
    })
}

/// Ctrl-C did not end a run that had begun.
#[test]
fn issue_whoever_stops_ends_a_run_of_every_method() {
    let row = two(VISCOELASTIC);
    for (name, method) in METHODS.into_iter().chain([("exact", EXACT)]) {
        let ended = run(method, &row, (LONG, STOP));
        assert!(matches!(ended, Err(RunError::Stopped { .. })), "{name}: {ended:?}");
        let hurried = Budget {
            seconds: Some(0.0),
            ..Budget::default()
        };
        let ended = run(method, &row, (LONG, hurried));
        assert!(matches!(ended, Err(RunError::TooLong { .. })), "{name}: {ended:?}");
    }
}

/// Stops the run at the first report, and counts the reports after that.
#[derive(Default)]
struct Impatient {
    told: usize,
}

static TIRED: AtomicBool = AtomicBool::new(false);

impl Recorder for Impatient {
    fn span(&mut self, _: &Span<'_>) {
        TIRED.store(true, Ordering::Relaxed);
        self.told += 1;
    }

    fn impact(&mut self, _: &Impact) {
        TIRED.store(true, Ordering::Relaxed);
        self.told += 1;
    }
}

/// The budget was not checked between two instants. In a long row all pieces were made, and all neighbours examined, before a run of 2 s
/// ended after minutes.
#[test]
fn issue_a_long_row_ends_between_two_pieces() {
    let n = 500;
    let structures = [WEAK, STIFF].into_iter().cycle().take(n);
    let nodes: Vec<_> = structures.map(elastic).collect();
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("the motion is finite");
    let tired = Budget {
        stop: Some(&TIRED),
        ..Budget::default()
    };
    let plastic = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.0 });
    for (gap, law) in [(0.01, VISCOELASTIC), (0.0, plastic), (0.0, VISCOELASTIC)] {
        let row = Row::new(nodes.clone(), pairs(n, gap, law)).expect("a row");
        TIRED.store(false, Ordering::Relaxed);
        let mut impatient = Impatient::default();
        let ended = EXACT.run(&row, excitation, LONG.within(tired), &mut impatient);
        assert!(matches!(ended, Err(RunError::Stopped { .. })), "{ended:?}");
        // A body whose floors rest against each other is a single piece.
        let most = if gap > 0.0 { 2 } else { n };
        assert!(impatient.told <= most, "{gap}: {} pieces", impatient.told);
    }
}

/// A run whose budget is spent before it begins makes no piece.
#[test]
fn extreme_a_run_without_time_makes_no_piece() {
    let row = two(VISCOELASTIC);
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("the motion is finite");
    let hurried = Budget {
        seconds: Some(0.0),
        ..Budget::default()
    };
    let mut histories = Histories::new(2, 0.01, 1.0);
    let ended = EXACT.run(&row, excitation, LONG.within(hurried), &mut histories);
    assert_eq!(ended.err(), Some(RunError::TooLong { time: 0.0, seconds: 0.0 }));
    assert!(histories.of(0).states.is_empty(), "it made a piece");
}

/// ξ̄ = 1e7 took ten seconds, 1e8 over forty.
#[test]
fn issue_a_contact_damped_without_measure_is_refused_before_it_runs() {
    let clock = clock(0.01, 10.0);
    for ratio in [1e7, 1e8, 1e12, 1e300] {
        let ended = run(EXACT, &two(kelvin_voigt(ratio)), (clock, Budget::default()));
        let refused = matches!(ended, Err(RunError::TooDamped { left: 0, right: 1, .. }));
        assert!(refused, "{ratio:e}: {ended:?}");
    }
    // A run that needs few pieces succeeds; a run that needs more than allowed ends.
    for (ratio, allowed, ends) in [(1e2, 1e7, true), (1e4, 1e7, true), (1e4, 5e3, false)] {
        let ended = run(EXACT, &two(kelvin_voigt(ratio)), (clock, pieces(allowed)));
        let over = matches!(ended, Err(RunError::TooManyPieces { .. } | RunError::TooDamped { .. }));
        assert!(if ends { ended.is_ok() } else { over }, "{ratio:e}, {allowed:e}: {ended:?}");
    }
}

/// A budget changes no run that ends within it; any other run ends where the budget is spent.
#[test]
fn limit_a_budget_changes_no_bit() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("the motion is finite");
    let (row, clock) = (two(VISCOELASTIC), clock(0.01, 10.0));
    let histories = |budget: Option<Budget>| {
        let mut histories = Histories::new(2, 0.01, 10.0);
        let work = match budget {
            None => EXACT.run(&row, excitation, clock, &mut histories),
            Some(budget) => EXACT.run(&row, excitation, clock.within(budget), &mut histories),
        };
        (work, histories)
    };
    let (work, wanted) = histories(None);
    let needed = work.expect("the run ends").segments as f64;
    let within = Budget {
        seconds: Some(1e6),
        ..pieces(needed)
    };
    assert_eq!(histories(Some(within)).1, wanted);
    let (spent, _) = histories(Some(pieces(needed - 100.0)));
    let ended = matches!(spent, Err(RunError::TooManyPieces { time, .. }) if time > 9.0);
    assert!(ended, "{needed} pieces: {spent:?}");
}

/// A row of 100 000 structures was accepted.
#[test]
fn issue_a_row_without_measure_is_refused_before_it_runs() {
    let row = |n: usize| Row::new(vec![elastic(WEAK); n], pairs(n, 0.1, VISCOELASTIC)).expect("a row");
    let clock = clock(0.01, 10.0);
    let ended = run(EXACT, &row(100_000), (clock, Budget::default()));
    assert!(matches!(ended, Err(RunError::TooLarge { .. })), "{ended:?}");
    let ended = run(EXACT, &row(1000), (clock, Budget::default()));
    assert!(ended.is_ok(), "{ended:?}");
}

/// Two hundred structures that press against each other took over 240 s.
#[test]
fn issue_long_rows_at_rest_against_each_other_took_the_cube_of_their_number() {
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.0 });
    let n = 200;
    let structure = |index: usize| {
        let (mass, stiffness, strength) = WEAK;
        elastic((mass, stiffness * (1.0 + 0.1 * (index * 7 % 13) as f64), strength))
    };
    let nodes = (0..n).map(structure).collect();
    let row = Row::new(nodes, pairs(n, 0.0, law)).expect("a row");
    let ended = run(EXACT, &row, (clock(0.01, 2.0), pieces(1e6)));
    // Within its budget it ends like any other run.
    let fair = matches!(ended, Ok(_) | Err(RunError::TooManyPieces { .. } | RunError::NoProgress { .. }));
    assert!(fair, "{ended:?}");
}
