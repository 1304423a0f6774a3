//! Buildings of several storeys by the implicit methods.

use pounding_contact::{ContactLaw, LinearSpring};
use pounding_solver::{
    Bilinear, BoucWen, Clock, Elastic, ElastoPlastic, Excitation, Histories, Hysteretic, Impact,
    Integrator, Levels, Node, Pair, Path, Recorder, Row, Smoothness, Span, State, Storey,
    TransferredMomentum, Work,
};

use crate::allocations::ALLOCATIONS;
use crate::common::{
    AVERAGE, HHT, LINEAR, MOREAU_JEAN, RK4, STEREOMECHANICAL, VISCOELASTIC, clock, ground,
    moreau_jean, slope,
};
use crate::towers::{Rayleigh, Tower, row, uniform};

const IMPLICIT: [(&str, Integrator); 4] = [
    ("Newmark 1/4", AVERAGE),
    ("Newmark 1/6", LINEAR),
    ("HHT -0.1", HHT),
    ("Moreau-Jean 1/2", MOREAU_JEAN),
];
pub(crate) const DAMPING: Rayleigh = Rayleigh {
    alpha: 0.3,
    beta: 0.002,
};
const SPRING: ContactLaw = ContactLaw::LinearSpring(LinearSpring {
    impact_stiffness: 9.35e7,
});

/// All levels that face each other, with one gap and one law.
pub(crate) fn facing(
    gap: f64,
    law: ContactLaw,
) -> impl Fn(usize, usize, [usize; 2]) -> Option<Pair> {
    move |_, _, [left, right]| {
        Some(Pair {
            left,
            right,
            gap,
            law,
        })
    }
}

/// A tower of three floors and a stiffer, heavier one of two.
fn towers<Column: Copy>(column: impl Fn(f64) -> Column) -> [Tower<Column>; 2] {
    [uniform(3, 1e5, column(5e7)), uniform(2, 3e5, column(4e8))]
}

pub(crate) fn elastic(stiffness: f64) -> Elastic {
    Elastic { stiffness }
}

fn plastic(stiffness: f64) -> ElastoPlastic {
    let yield_force = 0.006 * stiffness;
    ElastoPlastic {
        stiffness,
        yield_force,
    }
}

fn bilinear(stiffness: f64) -> Bilinear {
    Bilinear {
        stiffness,
        yield_force: 0.006 * stiffness,
        hardening: 0.05,
    }
}

fn smooth(stiffness: f64) -> BoucWen {
    BoucWen {
        stiffness,
        yield_force: 0.006 * stiffness,
        hardening: 0.05,
        smoothness: Smoothness {
            exponent: 2,
            unloading: 0.5,
        },
    }
}

pub(crate) fn run<Column: Hysteretic, R: Recorder>(
    row: &Row<Column>,
    method: Integrator,
    (ground, clock): (&[f64], Clock),
    recorder: &mut R,
) -> Work {
    let excitation = Excitation::new(0.01, ground).expect("a finite ground motion");
    method
        .run(row, excitation, clock, recorder)
        .unwrap_or_else(|error| panic!("{method:?}: {error}"))
}

/// States of every node every 0.02 s.
fn sampled<Column: Hysteretic>(
    row: &Row<Column>,
    method: Integrator,
    ground: &[f64],
    clock: Clock,
) -> (Vec<Vec<State>>, Work) {
    let n = row.nodes().len();
    let duration = clock.time_step * clock.n_steps as f64;
    let mut histories = Histories::new(n, 0.02, duration);
    let work = run(row, method, (ground, clock), &mut histories);
    let states = |node: usize| histories.of(node).states.clone();
    ((0..n).map(states).collect(), work)
}

/// Largest difference of displacements.
fn apart(one: &[Vec<State>], other: &[Vec<State>]) -> f64 {
    let states = one.iter().flatten().zip(other.iter().flatten());
    states
        .map(|(one, other)| (one.displacement - other.displacement).abs())
        .fold(0.0, f64::max)
}

#[test]
fn order_without_contact_is_two() {
    let (row, _) = row(&[uniform(3, 1e5, elastic(5e7))], DAMPING, |_, _, _| None);
    let (truth, _) = sampled(&row, RK4, &ground(), clock(2e-4, 5.0));
    let steps = [0.01, 0.005, 0.0025, 0.00125];
    for (name, method) in IMPLICIT {
        let error = |step: &f64| {
            apart(
                &sampled(&row, method, &ground(), clock(*step, 5.0)).0,
                &truth,
            )
        };
        let errors: Vec<_> = steps.iter().map(error).collect();
        let slope = slope(&steps, &errors);
        assert!((slope - 2.0).abs() < 0.15, "{name}: {slope} {errors:?}");
    }
}

/// Momentum transferred by all pairs of a row \[N·s\], step by step smaller, and that of the Runge–Kutta method at last.
fn totals<Column: Hysteretic>(row: &Row<Column>, method: Integrator, step: f64) -> Vec<f64> {
    let mut momentum = TransferredMomentum::new(row.nodes().len());
    let work = run(row, method, (&ground(), clock(step, 2.0)), &mut momentum);
    assert!(work.touching_steps > 0, "the row must collide");
    (0..row.nodes().len())
        .map(|node| momentum.of(node))
        .collect()
}

/// Largest difference of totals relative to the largest of them.
pub(crate) fn off(found: &[f64], wanted: &[f64]) -> f64 {
    let largest = wanted
        .iter()
        .fold(0.0, |most: f64, total| most.max(total.abs()));
    let pairs = found.iter().zip(wanted);
    pairs
        .map(|(found, wanted)| (found - wanted).abs() / largest)
        .fold(0.0, f64::max)
}

#[test]
fn order_pounding_towers_converge_to_the_totals_of_the_runge_kutta_method() {
    for (law, allowed) in [(SPRING, 1e-4), (VISCOELASTIC, 1e-3)] {
        let (row, _) = row(&towers(elastic), DAMPING, facing(0.005, law));
        let truth = totals(&row, RK4, 1e-5);
        for (name, method) in IMPLICIT {
            let errors = [1e-3, 1e-4].map(|step| off(&totals(&row, method, step), &truth));
            assert!(
                errors[1] < allowed && errors[1] < 0.3 * errors[0],
                "{name}: {errors:?}"
            );
        }
    }
}

/// The implicit methods against the Runge–Kutta method at a small step.
fn compare<Column: Hysteretic>(name: &str, column: impl Fn(f64) -> Column, allowed: f64) {
    let (row, _) = row(&towers(column), DAMPING, facing(0.005, SPRING));
    let truth = sampled(&row, RK4, &ground(), clock(1e-5, 2.0)).0;
    for (method_name, method) in IMPLICIT {
        let errors = [1e-3, 1e-4].map(|step| {
            let (states, work) = sampled(&row, method, &ground(), clock(step, 2.0));
            assert!(work.touching_steps > 0, "the row must collide");
            apart(&states, &truth)
        });
        assert!(
            errors[1] < allowed && errors[1] < 0.5 * errors[0],
            "{name}, {method_name}: {errors:?}"
        );
    }
}

#[test]
fn order_yielding_storeys_converge() {
    compare("elastic", elastic, 1e-5);
    compare("perfectly plastic", plastic, 1e-5);
    compare("bilinear", bilinear, 1e-5);
    compare("Bouc-Wen", smooth, 1e-5);
}

/// Keeps how far each step is from its own balance of momentum.
pub(crate) struct Momentum {
    masses: Vec<f64>,
    /// Stiffness \[N/m\] and damping \[N·s/m\] of the storeys below and above each floor: what rounding of its motion does
    /// to its forces.
    storeys: Vec<[f64; 2]>,
    pub(crate) worst: f64,
}

impl Momentum {
    pub(crate) fn new<Column: Hysteretic>(row: &Row<Column>) -> Self {
        let own = |node: usize| {
            let node = &row.nodes()[node];
            [node.column.stiffness(), node.damping]
        };
        let both = |node: usize| {
            let above = row.above(node).map_or([0.0; 2], own);
            [own(node)[0] + above[0], own(node)[1] + above[1]]
        };
        let masses = row.nodes().iter().map(|node| 1.0 / node.inverse_mass);
        Self {
            masses: masses.collect(),
            storeys: (0..row.nodes().len()).map(both).collect(),
            worst: 0.0,
        }
    }
}

impl Recorder for Momentum {
    const READS_WEIGHED: bool = true;

    fn span(&mut self, span: &Span<'_>) {
        let Path::Cubic(weighed) = span.path else {
            return;
        };
        let mass = self.masses[span.structure];
        let terms = [
            weighed.restoring,
            weighed.damping,
            -mass * weighed.ground_velocity,
            span.impulse_from_left,
            span.impulse_from_right,
            -mass * span.end.velocity,
            mass * span.start.velocity,
        ];
        let scale = terms.iter().map(|term| term.abs()).sum::<f64>().max(1.0);
        let [stiffness, damping] = self.storeys[span.structure];
        let [start, end] = [&span.start, &span.end]
            .map(|state| stiffness * state.displacement.abs() + damping * state.velocity.abs());
        let rounding = 32.0 * f64::EPSILON * start.max(end) * span.duration();
        let left = (terms.iter().sum::<f64>().abs() - rounding).max(0.0);
        self.worst = self.worst.max(left / scale);
    }

    fn impact(&mut self, _: &Impact) {}
}

#[test]
fn limit_every_floor_keeps_its_balance_of_momentum() {
    for law in [SPRING, VISCOELASTIC, STEREOMECHANICAL] {
        let (row, _) = row(&towers(bilinear), DAMPING, facing(0.005, law));
        for (name, method) in IMPLICIT
            .into_iter()
            .chain([("Moreau-Jean 1", moreau_jean(1.0))])
        {
            let mut momentum = Momentum::new(&row);
            run(&row, method, (&ground(), clock(2e-3, 5.0)), &mut momentum);
            assert!(momentum.worst < 1e-11, "{name}: {:e}", momentum.worst);
        }
    }
}

/// The four implicit methods and the most damped Moreau–Jean.
fn all() -> impl Iterator<Item = (&'static str, Integrator)> {
    IMPLICIT
        .into_iter()
        .chain([("Moreau-Jean 1", moreau_jean(1.0))])
}

#[test]
fn limit_one_storey_beside_towers_is_a_structure() {
    // Three structures of one storey, and the same with a tower out of reach, which makes them buildings.
    let kinds = [(75e3, 2.056e6), (3e6, 1.316e9), (120e3, 5e6)];
    let structures: Vec<Tower<ElastoPlastic>> = kinds
        .iter()
        .map(|&(mass, stiffness)| vec![(mass, plastic(stiffness))])
        .collect();
    let mut beside = structures.clone();
    beside.push(uniform(4, 1e5, plastic(5e7)));
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let near = |left: usize, _, [a, b]: [usize; 2]| {
            let gap = if left < 2 { 0.01 } else { 10.0 };
            facing(gap, law)(left, 0, [a, b])
        };
        let (lean, _) = row(&structures, DAMPING, near);
        let (rich, levels) = row(&beside, DAMPING, near);
        let plain = kinds.iter().map(|&(mass, stiffness)| {
            let damping = DAMPING.alpha * mass + DAMPING.beta * stiffness;
            Node::structure(mass, damping, plastic(stiffness))
        });
        assert_eq!(
            lean.nodes(),
            plain.collect::<Vec<_>>(),
            "the nodes themselves"
        );
        let alone = row(&beside[3..], DAMPING, near).0;
        for (name, method) in all() {
            let run = |row| sampled(row, method, &ground(), clock(5e-3, 10.0));
            let ((lean, work), (rich, _), (alone, _)) = (run(&lean), run(&rich), run(&alone));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            assert_eq!(lean[..], rich[..3], "{name}");
            let tower: Vec<_> = levels
                .of(3)
                .iter()
                .map(|node| rich[*node].clone())
                .collect();
            assert_eq!(tower, alone, "{name}: the tower");
        }
    }
}

#[test]
fn limit_buildings_out_of_reach_change_nothing() {
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let [left, right] = towers(plastic);
        let far = uniform(5, 2e5, plastic(6e7));
        let pair = |building: usize, _, nodes| {
            let gap = if building == 0 { 0.005 } else { 10.0 };
            facing(gap, law)(building, 0, nodes)
        };
        let (two, levels) = row(&[left.clone(), right.clone()], DAMPING, pair);
        let (three, more) = row(&[left, right, far], DAMPING, pair);
        for (name, method) in all() {
            let run = |row| sampled(row, method, &ground(), clock(5e-3, 10.0));
            let ((two, work), (three, _)) = (run(&two), run(&three));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            for building in 0..2 {
                for (one, other) in levels.of(building).iter().zip(more.of(building)) {
                    assert_eq!(two[*one], three[*other], "{name}");
                }
            }
        }
    }
}

#[test]
fn limit_a_mirrored_row_of_towers_mirrors() {
    let reversed: Vec<f64> = ground().iter().map(|sample| -sample).collect();
    for law in [STEREOMECHANICAL, SPRING, VISCOELASTIC] {
        let towers = towers(plastic);
        let mirrored: Vec<_> = towers.iter().rev().cloned().collect();
        let (there, levels) = row(&towers, DAMPING, facing(0.005, law));
        let (back, other) = row(&mirrored, DAMPING, facing(0.005, law));
        for (name, method) in all() {
            let (there, work) = sampled(&there, method, &ground(), clock(5e-3, 10.0));
            let (back, _) = sampled(&back, method, &reversed, clock(5e-3, 10.0));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            let mut apart: f64 = 0.0;
            for building in 0..2 {
                let floors = levels.of(building).iter().zip(other.of(1 - building));
                for (left, right) in floors {
                    for (left, right) in there[*left].iter().zip(&back[*right]) {
                        apart = apart.max((left.displacement + right.displacement).abs());
                    }
                }
            }
            let allowed = if law == STEREOMECHANICAL { 0.0 } else { 1e-12 };
            assert!(apart <= allowed, "{law:?} {name}: {apart:e}");
        }
    }
}

/// Newton iterations do not grow with the stiffness of the contact.
#[test]
fn limit_newton_iterations_up_to_a_thousand_times_the_stiffness() {
    for factor in [1.0, 10.0, 100.0, 1000.0] {
        for (kind, law) in [
            (
                "spring",
                ContactLaw::LinearSpring(LinearSpring {
                    impact_stiffness: 9.35e7 * factor,
                }),
            ),
            (
                "viscoelastic",
                ContactLaw::NonlinearViscoelastic(pounding_contact::NonlinearViscoelastic {
                    impact_stiffness: 2.75e9 * factor,
                    impact_damping_ratio: 0.35,
                }),
            ),
        ] {
            let (row, _) = row(&towers(smooth), DAMPING, facing(0.005, law));
            for (name, method) in [
                ("Newmark", AVERAGE),
                ("HHT", HHT),
                ("Moreau-Jean", MOREAU_JEAN),
            ] {
                let work = run(&row, method, (&ground(), clock(1e-3, 5.0)), &mut ());
                let each =
                    work.newton_iterations as f64 / (2 * work.steps + work.touching_steps) as f64;
                assert!(each < 6.0, "{kind} {factor} {name}: {each}");
            }
        }
    }
}

#[test]
fn extreme_moreau_jean_with_yielding_storeys_and_compliant_neighbours() {
    for theta in [0.5, 0.75, 1.0] {
        for time_step in [2e-2, 5e-3, 1e-3] {
            let mut towers = towers(plastic).to_vec();
            towers.push(uniform(4, 2e4, plastic(1e7)));
            let pair = |left: usize, storey: usize, nodes| {
                let law = if (left + storey).is_multiple_of(2) {
                    STEREOMECHANICAL
                } else {
                    VISCOELASTIC
                };
                facing(0.004, law)(left, storey, nodes)
            };
            let (row, _) = row(&towers, DAMPING, pair);
            let work = run(
                &row,
                moreau_jean(theta),
                (&ground(), clock(time_step, 10.0)),
                &mut (),
            );
            assert!(work.touching_steps > 0, "the row must collide");
        }
    }
}

#[test]
fn extreme_towers_against_a_wall_on_every_level() {
    let columns = uniform(3, 1e5, elastic(5e7));
    let levels = Levels::new(&[3, 3]);
    let node = |index: usize| match levels.place(index) {
        (0, storey) => {
            let (mass, column) = columns[storey];
            levels.floor(
                index,
                Storey {
                    mass,
                    damping: 1e5,
                    ground_damping: 3e4,
                    column,
                },
            )
        }
        _ => Node::wall(elastic(1.0)),
    };
    let nodes: Vec<_> = (0..6).map(node).collect();
    for law in [SPRING, VISCOELASTIC, STEREOMECHANICAL] {
        let pairs = levels
            .facing(0)
            .filter_map(|(a, b)| facing(0.003, law)(0, 0, [a, b]));
        let row = Row::new(nodes.clone(), pairs.collect()).expect("a valid row");
        for (name, method) in all() {
            let (states, work) = sampled(&row, method, &ground(), clock(2e-3, 5.0));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            for (_, wall) in levels.facing(0) {
                assert!(
                    states[wall].iter().all(|state| state.displacement == 0.0),
                    "a wall stands still"
                );
            }
        }
    }
}

#[test]
fn limit_a_step_of_buildings_allocates_nothing() {
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let (row, _) = row(&towers(plastic), DAMPING, facing(0.005, law));
        for (name, method) in all() {
            let count = |duration| {
                let before = ALLOCATIONS.get();
                let clock = clock(5e-3, duration);
                let work = run(&row, method, (&ground(), clock), &mut ());
                (ALLOCATIONS.get() - before, work)
            };
            let ((short, _), (long, work)) = (count(1.0), count(10.0));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            assert_eq!(
                short, long,
                "{name}: ten times the steps, the same allocations"
            );
        }
    }
}
