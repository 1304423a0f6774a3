//! Towers that meet on several levels at once, by Moreau–Jean stepping: energy, the law of impact, convergence.

use std::collections::BTreeMap;

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Bilinear, Elastic, Excitation, Impact, Levels, Node, Recorder, Row, Span, State, TransferredMomentum};

use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::{RK4, clock, ground, moreau_jean};
use crate::random_rows::config;
use crate::storeys_implicit::{DAMPING, Momentum, elastic, facing, off, run};
use crate::towers::{Rayleigh, Tower, row, uniform};
use crate::watch::Watch;

/// A building whose floors are numbered by [`Levels`], moving as a whole.
fn moving(row: &Row<Elastic>, levels: &Levels, velocities: &[f64]) -> Row<Elastic> {
    let node = |(index, node): (usize, &Node<Elastic>)| Node {
        initial_velocity: velocities[levels.place(index).0],
        ..*node
    };
    let nodes = row.nodes().iter().enumerate().map(node).collect();
    Row::new(nodes, row.pairs().to_vec()).expect("a valid row")
}

/// Kinetic and elastic energy of the states of all nodes \[J\].
fn energy(row: &Row<Elastic>, levels: &Levels, states: &[State]) -> f64 {
    let mut sum = 0.0;
    for (index, node) in row.nodes().iter().enumerate() {
        let (building, storey) = levels.place(index);
        let below = storey
            .checked_sub(1)
            .map_or(0.0, |lower| states[levels.of(building)[lower]].displacement);
        let drift = states[index].displacement - below;
        sum += 0.5 * node.column.stiffness * drift * drift;
        if !node.is_wall() {
            sum += 0.5 * states[index].velocity * states[index].velocity / node.inverse_mass;
        }
    }
    sum
}

/// Keeps the states after every step, including impacts, and the reports of impacts.
struct Steps {
    states: Vec<Vec<State>>,
    n: usize,
    /// Impacts at every instant, each with the rate of its pair at the start of the step \[m/s\].
    impacts: BTreeMap<usize, Vec<(Impact, f64)>>,
}

impl Recorder for Steps {
    fn span(&mut self, span: &Span<'_>) {
        if self.states.is_empty() {
            self.states.push(vec![State::default(); self.n]);
        }
        if span.start_time == 0.0 {
            self.states[0][span.structure] = span.start;
        }
        if span.structure == 0 {
            self.states.push(vec![State::default(); self.n]);
        }
        self.states.last_mut().expect("pushed above")[span.structure] = span.end;
    }

    fn impact(&mut self, impact: &Impact) {
        let last = self.states.last_mut().expect("spans come first");
        last[impact.left].velocity = impact.after.left;
        last[impact.right].velocity = impact.after.right;
        let step = self.states.len() - 1;
        let before = &self.states[step - 1];
        let rate = before[impact.left].velocity - before[impact.right].velocity;
        self.impacts.entry(step).or_default().push((*impact, rate));
    }
}

/// Two or three undamped towers that meet on several levels at once, with this restitution.
fn meeting(n: usize, gap: f64, restitution: f64) -> (Row<Elastic>, Levels) {
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution });
    let towers = [
        uniform(4, 1e5, elastic(5e7)),
        uniform(3, 3e5, elastic(4e8)),
        uniform(5, 2e5, elastic(1e8)),
    ];
    let still = Rayleigh { alpha: 0.0, beta: 0.0 };
    let (row, levels) = row(&towers[..n], still, facing(gap, law));
    let row = moving(&row, &levels, &[0.6, 0.0, -0.5][..n]);
    (row, levels)
}

#[test]
fn limit_moreau_jean_between_towers_creates_no_energy() {
    let ground = [0.0, 0.0];
    for n in [2, 3] {
        for theta in [0.5, 1.0] {
            for restitution in [0.0, 0.65, 1.0] {
                for time_step in [2e-2, 5e-3, 5e-4] {
                    let (row, levels) = meeting(n, 0.003, restitution);
                    let mut steps = Steps {
                        states: vec![],
                        n: row.nodes().len(),
                        impacts: BTreeMap::new(),
                    };
                    let clock = clock(time_step, 2.0);
                    run(&row, moreau_jean(theta), (&ground, clock), &mut steps);
                    let place = format!("{n} towers, theta {theta}, e {restitution}, step {time_step}");
                    assert!(!steps.impacts.is_empty(), "{place}: they must meet");
                    check_energy(&row, &levels, (&steps, theta), &place);
                    check_law(&row, &steps, restitution, &place);
                }
            }
        }
    }
}

/// Checks that impacts at an instant together create no energy (one pair may gain energy that another loses), and that no step gains energy
/// if θ = 1/2.
///
/// A larger θ weighs the force at the end of the step, which an impulse does not meet half way. The step then gains or loses energy to
/// first order, with or without an impact.
fn check_energy(row: &Row<Elastic>, levels: &Levels, (steps, theta): (&Steps, f64), place: &str) {
    let energies: Vec<_> = steps.states.iter().map(|states| energy(row, levels, states)).collect();
    let gained = energies.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::NEG_INFINITY, f64::max);
    let instants = steps.impacts.values();
    let most = instants.map(|at_once| created(at_once).0);
    let most = most.fold(f64::NEG_INFINITY, f64::max);
    let together = most / energies[0];
    let gained = gained / energies[0];
    assert!(together < 1e-14, "{place}: created {together:e}");
    assert!(theta > 0.5 || gained < 1e-14, "{place}: gained {gained:e}");
}

/// Checks that pairs that push part, at most as fast as their law states, and that jumps agree with impulses.
fn check_law(row: &Row<Elastic>, steps: &Steps, restitution: f64, place: &str) {
    let mut net = vec![0.0; row.nodes().len()];
    for at_once in steps.impacts.values() {
        net.fill(0.0);
        for (impact, approach) in at_once {
            net[impact.left] -= impact.impulse;
            net[impact.right] += impact.impulse;
            assert!(impact.impulse > 0.0, "{place}: {impact:?}");
            let after = impact.after.left - impact.after.right;
            let allowed = 1e-10 * (1.0 + approach);
            assert!(*approach >= -allowed, "{place}: {impact:?}");
            assert!(after < allowed, "{place}: {after:e}");
            assert!(after > -restitution * approach - allowed, "{place}: {after:e} of {approach:e}");
        }
        for (impact, _) in at_once {
            for (node, jump) in [
                (impact.left, impact.after.left - impact.before.left),
                (impact.right, impact.after.right - impact.before.right),
            ] {
                let wanted = net[node] * row.nodes()[node].inverse_mass;
                assert!((jump - wanted).abs() < 1e-12 * (1.0 + wanted.abs()), "{place}: {jump}");
            }
        }
    }
}

#[test]
fn order_moreau_jean_between_towers_converges_to_velocity_jumps() {
    let ground = [0.0, 0.0];
    for (n, restitution) in [(2, 0.65), (3, 0.65), (2, 1.0), (2, 0.0)] {
        let (row, _) = meeting(n, 0.003, restitution);
        let total = |method, step| {
            let mut momentum = TransferredMomentum::new(row.nodes().len());
            run(&row, method, (&ground, clock(step, 0.1)), &mut momentum);
            let of = (0..row.nodes().len()).map(|node| momentum.of(node));
            of.collect::<Vec<_>>()
        };
        let truth = total(RK4, 2e-7);
        for theta in [0.5, 1.0] {
            let errors = [1e-4, 1e-5, 1e-6].map(|step| off(&total(moreau_jean(theta), step), &truth));
            assert!(errors[2] < 1e-2, "{theta}, e {restitution}: {errors:?}");
        }
    }
}

/// Energy that impacts at an instant create, and the sum of the magnitudes of its parts \[J\].
fn created(at_once: &[(Impact, f64)]) -> (f64, f64) {
    let (mut sum, mut scale) = (0.0, 0.0);
    for (impact, _) in at_once {
        let [before, after] = [impact.before, impact.after].map(|pair| pair.left - pair.right);
        sum -= 0.5 * impact.impulse * (before + after);
        let speeds = [impact.before, impact.after].map(|pair| pair.left.abs() + pair.right.abs());
        scale += impact.impulse * (speeds[0] + speeds[1]);
    }
    (sum, scale)
}

/// Mass \[kg\] and columns of a storey: masses over four decades, periods from 0.02 to 2 s.
fn any_storey() -> impl Strategy<Value = (f64, Bilinear)> {
    (3.0..7.0_f64, -2.0..2.0_f64, 1e-4..0.1_f64).prop_map(|(mass, stiff, yields)| {
        let mass = libm::pow(10.0, mass);
        let omega = 30.0 * libm::pow(10.0, 0.5 * stiff);
        let stiffness = mass * omega * omega;
        let column = Bilinear {
            stiffness,
            yield_force: yields * stiffness / omega,
            hardening: 0.0,
        };
        (mass, column)
    })
}

fn any_towers() -> impl Strategy<Value = Vec<Tower<Bilinear>>> {
    vec(vec(any_storey(), 1..5), 2..5)
}

proptest! {
    #![proptest_config(config(150))]

    #[test]
    fn extreme_any_row_of_towers_gets_its_impulses(
        towers in any_towers(),
        restitution in prop_oneof![Just(0.0), Just(1.0), 0.0..1.0_f64],
        gap in prop_oneof![Just(0.0), 1e-4..1e-2_f64],
        theta in prop_oneof![Just(0.5), Just(1.0), 0.5..1.0_f64],
        time_step in prop_oneof![Just(1e-2), Just(1e-3)],
    ) {
        let law = ContactLaw::Stereomechanical(Stereomechanical { restitution });
        let (row, _) = row(&towers, DAMPING, facing(gap, law));
        let momentum = Momentum::new(&row);
        let steps = Steps {
            states: vec![],
            n: row.nodes().len(),
            impacts: BTreeMap::new(),
        };
        let (ground, clock) = (ground(), clock(time_step, 2.0));
        let excitation = Excitation::new(0.01, &ground).expect("a finite ground motion");
        let mut recorder = (momentum, steps);
        let outcome = moreau_jean(theta).watch(&row, excitation, clock, &mut recorder);
        prop_assert!(outcome.is_ok(), "{:?}", outcome);
        let (momentum, steps) = recorder;
        // A floor of 1 t below a floor of 10 000 t with a storey a million times as stiff: the tolerance of Newton's method limits the
        // balance.
        prop_assert!(momentum.worst < 1e-9, "{}", momentum.worst);
        for at_once in steps.impacts.values() {
            let (created, scale) = created(at_once);
            prop_assert!(created < 1e-11 * scale, "{created} of {scale}: {at_once:?}");
        }
    }
}
