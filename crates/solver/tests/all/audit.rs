//! Properties of spans and impacts: continuity, equilibrium at both ends, jumps equal to the reported impulses.

use insta::assert_snapshot;
use pounding_contact::ContactLaw;
use pounding_solver::{Bilinear, Clock, Excitation, Impact, Integrator, Node, Recorder, Row, Span, State};
use std::fmt::Write;

use crate::common::{CENTRAL, METHODS, STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, ground, histories, pairs, yielding};
use crate::watch::Watch;

/// Checks every span and impact of a run on the grid of the ground motion.
struct Audit<'a> {
    row: &'a Row<Bilinear>,
    /// α of the HHT method, 0 for the others.
    alpha: f64,
    ground: &'a [f64],
    time_step: f64,
    /// End of the last span of each structure.
    ends: Vec<Option<State>>,
    /// Net impulse since that end.
    impulses: Vec<f64>,
    /// Velocity after the impacts since that end, as reported.
    after: Vec<Option<f64>>,
    /// Largest residual of equilibrium, relative to the sum of the magnitudes of its terms.
    residual: f64,
    /// Largest difference of m·Δv from the net impulse, relative to it.
    jump: f64,
    n_impacts: usize,
}

impl Audit<'_> {
    /// Inertia, and damping, restoring, pounding and ground forces on a structure.
    fn forces(&self, structure: usize, time: f64, state: &State) -> (f64, [f64; 4]) {
        let node = &self.row.nodes()[structure];
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
        let sample = (time / self.time_step + 1e-9) as usize;
        // Spans may end between two samples.
        let fraction = time / self.time_step - sample as f64;
        let (before, after) = (self.ground[sample], self.ground[sample + 1]);
        let ground = before + fraction * (after - before);
        let mass = 1.0 / node.inverse_mass;
        let others = [
            node.damping * state.velocity,
            state.restoring_force,
            -state.pounding_force(),
            mass * ground,
        ];
        (mass * state.acceleration, others)
    }

    /// Equilibrium at both ends of a span; for the HHT method (α < 0), its weighted equation.
    fn equilibrium(&mut self, span: &Span<'_>) {
        if self.row.nodes()[span.structure].is_wall() {
            return;
        }
        let start = self.forces(span.structure, span.start_time, &span.start);
        let end = self.forces(span.structure, span.end_time, &span.end);
        let mut check = |terms: &[f64]| {
            let scale: f64 = terms.iter().map(|term| term.abs()).sum();
            if scale > 0.0 {
                self.residual = self.residual.max(terms.iter().sum::<f64>().abs() / scale);
            }
        };
        let weighted = |weight: f64, others: [f64; 4]| others.map(|term| weight * term);
        let now = weighted(1.0 + self.alpha, end.1);
        check(&[&[end.0], &now[..], &weighted(-self.alpha, start.1)[..]].concat());
        if self.alpha == 0.0 {
            check(&[&[start.0], &start.1[..]].concat());
        }
    }
}

impl Recorder for Audit<'_> {
    fn span(&mut self, span: &Span<'_>) {
        let index = span.structure;
        if let Some(before) = self.ends[index] {
            assert!(
                (before.displacement - span.start.displacement).abs() == 0.0,
                "displacements are continuous"
            );
            assert!((before.restoring_force - span.start.restoring_force).abs() == 0.0, "so are forces");
            let change = span.start.velocity - before.velocity;
            let impulse = std::mem::take(&mut self.impulses[index]);
            if impulse == 0.0 {
                assert!(change == 0.0, "velocities jump only where an impact was reported");
            } else if !self.row.nodes()[index].is_wall() {
                let expected = impulse * self.row.nodes()[index].inverse_mass;
                self.jump = self.jump.max((change - expected).abs() / expected.abs());
            }
            if let Some(after) = self.after[index].take() {
                assert!(
                    (after - span.start.velocity).abs() == 0.0,
                    "the velocity after an impact is the next start"
                );
            }
        }
        self.equilibrium(span);
        self.ends[index] = Some(span.end);
    }

    fn impact(&mut self, impact: &Impact) {
        self.n_impacts += 1;
        for (index, sign, before, after) in [
            (impact.left, -1.0, impact.before.left, impact.after.left),
            (impact.right, 1.0, impact.before.right, impact.after.right),
        ] {
            self.impulses[index] += sign * impact.impulse;
            let end = self.ends[index].expect("the spans that end at an impact came before");
            assert!(
                (end.velocity - before).abs() <= 1e-14 * end.velocity.abs().max(1.0),
                "{} against {before}",
                end.velocity
            );
            self.after[index] = Some(after);
        }
    }
}

/// Rows of three structures with each law, with both laws, and with a wall on either side.
fn rows() -> Vec<Row<Bilinear>> {
    let wall = || {
        Node::wall(Bilinear {
            stiffness: 1.0,
            yield_force: f64::INFINITY,
            hardening: 0.0,
        })
    };
    let row = |nodes: Vec<Node<Bilinear>>, laws: [ContactLaw; 2]| {
        let mut pairs = pairs(3, 0.02, laws[0]);
        pairs[1].law = laws[1];
        Row::new(nodes, pairs).expect("the row is valid")
    };
    let (weak, other, stiff) = (yielding(WEAK), yielding((120e3, 5e6, 90e3)), yielding(STIFF));
    vec![
        row(vec![weak, other, stiff], [STEREOMECHANICAL; 2]),
        row(vec![weak, stiff, other], [VISCOELASTIC; 2]),
        row(vec![weak, other, stiff], [STEREOMECHANICAL, VISCOELASTIC]),
        row(vec![wall(), weak, other], [STEREOMECHANICAL; 2]),
        row(vec![weak, other, wall()], [VISCOELASTIC, STEREOMECHANICAL]),
    ]
}

#[test]
fn limit_spans_and_impacts_keep_their_promises() {
    let time_step = 0.002;
    let samples: Vec<f64> = (0..=5001).map(|i| libm::sin(f64::from(i) * 0.011) * 3.0).collect();
    for row in rows() {
        let impulsive = row.pairs().iter().all(|pair| pair.law == STEREOMECHANICAL);
        for (name, method) in METHODS {
            let mut audit = Audit {
                row: &row,
                alpha: if let Integrator::Hht(settings) = method {
                    settings.alpha
                } else {
                    0.0
                },
                ground: &samples,
                time_step,
                ends: vec![None; 3],
                impulses: vec![0.0; 3],
                after: vec![None; 3],
                residual: 0.0,
                jump: 0.0,
                n_impacts: 0,
            };
            let excitation = Excitation::new(time_step, &samples).unwrap();
            let work = method.watch(&row, excitation, clock(time_step, 10.0), &mut audit).unwrap();
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            assert!(audit.n_impacts > 0 || !impulsive, "{name}: impacts are reported");
            assert!(audit.jump < 1e-11, "{name}: jump {:e}", audit.jump);
            // A viscoelastic force belongs to the rate before a jump of its neighbour: mixed rows are excluded.
            let mixed = !impulsive && audit.n_impacts > 0;
            assert!(mixed || audit.residual < 1e-11, "{name}: residual {:e}", audit.residual);
        }
    }
}

#[test]
fn limit_no_overlap_is_without_a_force() {
    // When the first structure is pushed into the second, the second gap closes in the same step: the cluster must grow.
    let free = |mass: f64, velocity: f64| Node {
        initial_velocity: velocity,
        ..Node::structure(
            mass,
            0.0,
            Bilinear {
                stiffness: 1.0,
                yield_force: f64::INFINITY,
                hardening: 0.0,
            },
        )
    };
    let mut between = pairs(3, 1e-3, VISCOELASTIC);
    between[1].relation.offset = 1e-7;
    let row = Row::new(vec![free(1e6, 1.0), free(1e3, 0.0), free(1e3, 0.0)], between).unwrap();
    for (name, method) in METHODS {
        let (histories, work) = histories(&row, method, &[0.0], clock(1e-3, 0.01));
        assert!(work.touching_steps > 2, "{name}: the row must collide");
        for step in 0..=10 {
            for (left, pair) in row.pairs().iter().enumerate() {
                let states = [left, left + 1].map(|index| histories.of(index).states[step]);
                let overlap = states[0].displacement - states[1].displacement - pair.gap();
                assert_eq!(
                    overlap > 0.0,
                    states[0].force_from_right < 0.0,
                    "{name}, step {step}, pair {left}: {overlap:e}"
                );
            }
        }
    }
}

#[test]
fn reference_a_start_with_an_initial_velocity() {
    // Free vibration from 0.01 m at 0.2 m/s: the error falls with order two.
    let node = Node {
        initial_displacement: 0.01,
        initial_velocity: 0.2,
        ..Node::structure(1.0, 0.0, pounding_solver::Elastic { stiffness: 25.0 })
    };
    let row = Row::new(vec![node], vec![]).unwrap();
    let error = |time_step: f64| {
        let (histories, _) = histories(&row, CENTRAL, &[0.0], clock(time_step, 2.0));
        let exact = |time: f64| 0.01 * libm::cos(5.0 * time) + 0.04 * libm::sin(5.0 * time);
        let states = histories.of(0).states.iter().enumerate();
        states
            .map(|(i, state)| (state.displacement - exact(i as f64 * time_step)).abs())
            .fold(0.0, f64::max)
    };
    let errors = [error(1e-3), error(5e-4)];
    let order = libm::log(errors[0] / errors[1]) / libm::log(2.0);
    assert!((order - 2.0).abs() < 0.1, "{order}, {errors:?}");
}

#[test]
fn limit_work_is_counted() {
    let mut table = String::new();
    for (what, row) in ["stereomechanical", "viscoelastic", "both laws"].into_iter().zip(rows()) {
        for (name, method) in METHODS {
            let (_, work) = histories(&row, method, &ground(), clock(0.005, 10.0));
            writeln!(table, "{what:<18}{name:<20}{work:?}").expect("a string takes all");
        }
    }
    assert_snapshot!(table);
}

#[test]
fn limit_a_wall_does_not_move() {
    for row in rows().into_iter().skip(3) {
        for (name, method) in METHODS {
            let (histories, _) = histories(
                &row,
                method,
                &ground(),
                Clock {
                    time_step: 0.002,
                    n_steps: 2000,
                },
            );
            for (index, node) in row.nodes().iter().enumerate().filter(|(_, node)| node.is_wall()) {
                let still = |state: &State| state.displacement == 0.0 && state.velocity == 0.0 && state.acceleration == 0.0;
                assert!(histories.of(index).states.iter().all(still), "{name}: {node:?}");
            }
        }
    }
}
