//! Links between floors, by closed forms, by a second integration, and by the laws of mechanics.

use pounding_contact::ContactLaw;
use pounding_solver::{
    AnyRow, Bilinear, Braced, Clock, Collisions, Elastic, Exact, Excitation, Floor, Hysteretic, Integrator, LastStates, Laws, Ledger, Link,
    LinkLaw, LinkPeak, LinkPeaks, Motion, Node, Pair, Peaks, Point, Relation, Restrainer, Row, Spring, Viscous,
};
use serde_json::Value;

use crate::common::{CENTRAL, STEREOMECHANICAL, STIFF, SUBSTEPPED, VISCOELASTIC, WEAK, clock, ground, pairs, slope, yielding};
use crate::watch::Watch;

const EXACT: Integrator = Integrator::Exact(Exact {
    tolerance: 1e-16,
    simultaneous_impacts: pounding_solver::SimultaneousImpacts::Together,
});

/// Inputs and expected values of a case.
fn case(text: &str) -> (Value, Value) {
    let case: Value = serde_json::from_str(text).expect("JSON");
    (case["inputs"].clone(), case["expected"].clone())
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_str().expect(name).parse().expect(name)
}

fn between(left: Point, right: Point, law: LinkLaw) -> Link {
    let offset = 0.0;
    Link {
        relation: Relation { left, right, offset },
        law,
    }
}

fn moving(mass: f64, stiffness: f64, displacement: f64, velocity: f64) -> Node<Elastic> {
    Node {
        initial_displacement: displacement,
        initial_velocity: velocity,
        ..Node::structure(mass, 0.0, Elastic { stiffness })
    }
}

/// A run without shaking.
struct LetGo {
    last: LastStates,
    peaks: Peaks,
    /// Peaks of the first link, and the energy that it took \[J\].
    link: Option<LinkPeak>,
    energy: f64,
}

fn let_go<Column: Hysteretic>(row: &Row<Column>, duration: f64) -> LetGo {
    let still = [0.0; 1001];
    let excitation = Excitation::new(0.01, &still).expect("finite");
    let clock = Clock {
        time_step: duration / 8.0,
        n_steps: 8,
    };
    let n = row.nodes().len();
    let ledger = Ledger::new(row, excitation).held_to(Laws::Energy { tolerance: 1e-16 });
    let links = LinkPeaks::new(row.links());
    let mut recorders = ((LastStates::new(n), Peaks::new(n)), (links, ledger));
    EXACT.watch(row, excitation, clock, &mut recorders).expect("it runs");
    let ((last, peaks), (links, ledger)) = recorders;
    ledger.verdict().expect("the books add up");
    let energy = if row.links().is_empty() { 0.0 } else { ledger.of_link(0).energy };
    LetGo {
        last,
        peaks,
        link: links.all().next(),
        energy,
    }
}

fn close(what: &str, found: f64, wanted: f64, tolerance: f64) {
    assert!(
        (found - wanted).abs() <= tolerance * wanted.abs(),
        "{what}: {found} instead of {wanted}"
    );
}

#[test]
fn reference_dashpot_and_maxwell() {
    let (inputs, expected) = case(include_str!("../../../scene/tests/reach/link-dashpot-and-maxwell.json"));
    let of = |name: &str| number(&inputs, name);
    let dashpot = Spring {
        stiffness: 0.0,
        yield_force: f64::INFINITY,
        hardening: 0.0,
        damping: of("c_n_s_per_m"),
    };
    let maxwell = Braced {
        stiffness: of("k_maxwell_n_per_m"),
        coefficient: of("c_n_s_per_m"),
        inverse_exponent: 1,
    };
    for (name, law) in [("dashpot", LinkLaw::Spring(dashpot)), ("maxwell", LinkLaw::Braced(maxwell))] {
        let nodes = vec![
            moving(of("m1_kg"), of("k1_n_per_m"), of("u1_0_m"), 0.0),
            moving(of("m2_kg"), of("k2_n_per_m"), 0.0, 0.0),
        ];
        let link = between(0.into(), 1.into(), law);
        let row = Row::new(nodes, vec![]).and_then(|row| row.linked(vec![link])).expect("a row");
        let LetGo { last, energy, .. } = let_go(&row, 2.0);
        let wanted = &expected[name];
        let [one, two] = [0, 1].map(|node| last.of(node));
        for (found, field) in [
            (one.displacement, "u1_at_2s_m"),
            (two.displacement, "u2_at_2s_m"),
            (one.velocity, "v1_at_2s"),
            (two.velocity, "v2_at_2s"),
        ] {
            close(field, found, number(wanted, field), 1e-9);
        }
        // The brace of the Maxwell element holds F²/2k.
        let force = number(wanted, "link_force_at_2s_n");
        let stored = if name == "maxwell" {
            0.5 * force * force / of("k_maxwell_n_per_m")
        } else {
            0.0
        };
        close("energy", energy, number(wanted, "energy_dissipated_j") + stored, 1e-9);
    }
}

#[test]
fn reference_a_restrainer_with_slack_that_yields() {
    let (inputs, expected) = case(include_str!("../../../scene/tests/reach/link-restrainer-slack-yield.json"));
    let of = |name: &str| number(&inputs, name);
    let wanted = |name: &str| number(&expected, name);
    let law = LinkLaw::Restrainer(Restrainer {
        stiffness: of("k_n_per_m"),
        yield_force: of("fy_n"),
        slack: of("slack_m"),
    });
    // The neighbour on the left is the ground, or a wall.
    let wall = Node::wall(Elastic { stiffness: 1.0 });
    for (nodes, ends) in [
        (vec![moving(of("m_kg"), 0.0, 0.0, of("v0"))], [Point::Ground(0), Point::Floor(0)]),
        (
            vec![wall, moving(of("m_kg"), 0.0, 0.0, of("v0"))],
            [Point::Floor(0), Point::Floor(1)],
        ),
    ] {
        let deck = nodes.len() - 1;
        let link = between(ends[0], ends[1], law);
        let row = Row::new(nodes, vec![]).and_then(|row| row.linked(vec![link])).expect("a row");
        let LetGo { last, peaks, energy, .. } = let_go(&row, wanted("back_at_zero_s"));
        close("turn", peaks.of(deck).displacement.time, wanted("turns_at_s"), 1e-9);
        close("opening", peaks.of(deck).displacement.value, wanted("largest_opening_m"), 1e-9);
        let Motion { displacement, velocity } = last.of(deck);
        assert!(displacement.abs() < 1e-9, "{displacement}");
        close("return", velocity, wanted("returns_at_m_per_s"), 1e-9);
        close("energy", energy, wanted("energy_dissipated_j"), 1e-9);
    }
}

/// A cable that never tightens has extremes all the same, the first at the start.
#[test]
fn reference_deformations_of_a_link_that_starts_deformed_and_stays_slack() {
    let law = LinkLaw::Restrainer(Restrainer {
        stiffness: 1e7,
        yield_force: 1e6,
        slack: 0.1,
    });
    let (mass, rate) = (1e5, 2.0 * std::f64::consts::PI);
    let link = between(Point::Ground(0), Point::Floor(0), law);
    let nodes = vec![moving(mass, mass * rate * rate, -0.03, 0.0)];
    let row = Row::new(nodes, vec![]).and_then(|row| row.linked(vec![link])).expect("a row");
    let peak = let_go(&row, 1.3).link.expect("a link");
    close("shortening", peak.shortening.value, 0.03, 1e-12);
    close("elongation", peak.elongation.value, -0.03, 1e-12);
    close("its instant", peak.elongation.time, 0.5, 1e-9);
    assert!(peak.push.value == 0.0 && peak.pull.value == 0.0, "{peak:?}");
}

/// A second route: many steps of the classical Runge–Kutta method on u, u̇ and F. Returns u and u̇ at the end, and the largest |F|.
fn braced_by_steps(damper: Braced, mass: f64, stiffness: f64, velocity: f64, duration: f64) -> ([f64; 2], f64) {
    let Braced {
        stiffness: brace,
        coefficient,
        inverse_exponent,
    } = damper;
    let slope = |[u, v, f]: [f64; 3]| {
        let power = (0..inverse_exponent).fold(1.0, |power, _| power * f.abs() / coefficient);
        let flow = power * f.signum();
        [v, -(stiffness * u + f) / mass, brace * (v - flow)]
    };
    let n = 400_000;
    let h = duration / f64::from(n);
    let mut at = [0.0, velocity, 0.0];
    let mut largest = 0.0_f64;
    for _ in 0..n {
        let ahead = |k: [f64; 3], by: f64| [0, 1, 2].map(|i| at[i] + by * k[i]);
        let k1 = slope(at);
        let k2 = slope(ahead(k1, 0.5 * h));
        let k3 = slope(ahead(k2, 0.5 * h));
        let k4 = slope(ahead(k3, h));
        at = [0, 1, 2].map(|i| at[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        largest = largest.max(at[2].abs());
    }
    ([at[0], at[1]], largest)
}

#[test]
fn reference_braced_dampers_by_a_second_integration() {
    for inverse_exponent in [1, 2, 3, 5] {
        let damper = Braced {
            stiffness: 8e7,
            coefficient: 6e5,
            inverse_exponent,
        };
        let nodes = vec![moving(5e5, 2e7, 0.0, 0.5)];
        let link = between(Point::Floor(0), Point::Ground(0), LinkLaw::Braced(damper));
        let row = Row::new(nodes, vec![]).and_then(|row| row.linked(vec![link])).expect("a row");
        let LetGo { last, link, energy, .. } = let_go(&row, 2.0);
        let ([displacement, velocity], force) = braced_by_steps(damper, 5e5, 2e7, 0.5, 2.0);
        let found = last.of(0);
        let error = (found.displacement - displacement).abs().max((found.velocity - velocity).abs());
        assert!(
            error < 1e-10,
            "1/{inverse_exponent}: {found:?} instead of {displacement} {velocity}"
        );
        let kinetic = 0.5 * 5e5 * (0.25 - velocity * velocity);
        close("energy", energy, kinetic - 0.5 * 2e7 * displacement * displacement, 1e-8);
        let link = link.expect("a link");
        // Between its steps the second route misses h²/8 of the curvature.
        close("force", link.push.value.max(-link.pull.value), force, 1e-8);
    }
}

fn laws() -> Vec<(&'static str, LinkLaw)> {
    let spring = Spring {
        stiffness: 3e6,
        yield_force: f64::INFINITY,
        hardening: 0.0,
        damping: 0.0,
    };
    let restrainer = Restrainer {
        stiffness: 2e7,
        yield_force: 2e5,
        slack: 0.01,
    };
    let braced = |inverse_exponent| {
        LinkLaw::Braced(Braced {
            stiffness: 5e7,
            coefficient: 3e5,
            inverse_exponent,
        })
    };
    vec![
        ("spring", LinkLaw::Spring(spring)),
        (
            "dashpot",
            LinkLaw::Spring(Spring {
                stiffness: 0.0,
                damping: 2e5,
                ..spring
            }),
        ),
        ("both", LinkLaw::Spring(Spring { damping: 2e5, ..spring })),
        (
            "bilinear",
            LinkLaw::Spring(Spring {
                yield_force: 5e4,
                hardening: 0.1,
                ..spring
            }),
        ),
        (
            "friction",
            LinkLaw::Spring(Spring {
                stiffness: 1e8,
                yield_force: 5e4,
                ..spring
            }),
        ),
        ("restrainer", LinkLaw::Restrainer(restrainer)),
        ("maxwell", braced(1)),
        ("square", braced(2)),
        ("cube", braced(3)),
    ]
}

fn row_of_three(law: ContactLaw, links: Vec<Link>, mirrored: bool) -> Row<Bilinear> {
    let mut nodes = vec![yielding(WEAK), yielding(STIFF), yielding((2e5, 8e6, 3e5))];
    let mut links = links;
    if mirrored {
        nodes.reverse();
        for link in &mut links {
            let [left, right] = link.relation.points().map(|point| match point {
                Point::Floor(floor) => Point::Floor(2 - floor),
                Point::Ground(floor) => Point::Ground(2 - floor),
                Point::Share(_) => panic!("no share"),
            });
            (link.relation.left, link.relation.right) = (right, left);
        }
    }
    let row = Row::new(nodes, pairs(3, 0.02, law)).expect("a row");
    row.linked(links).expect("links")
}

/// Rows that collide, with every kind of link: energies and impulses add up, and the mirrored row mirrors the motion.
#[test]
fn reference_books_and_mirrors_of_rows_with_links() {
    let motion = ground();
    let mirror: Vec<f64> = motion.iter().map(|value| -value).collect();
    let clock = Clock {
        time_step: 0.01,
        n_steps: 600,
    };
    for contact in [STEREOMECHANICAL, VISCOELASTIC] {
        for (name, law) in laws() {
            let links = vec![between(0.into(), 1.into(), law), between(0.into(), 2.into(), law)];
            let mut ends = [[0.0; 3]; 2];
            for (mirrored, ends) in [false, true].into_iter().zip(&mut ends) {
                let row = row_of_three(contact, links.clone(), mirrored);
                let excitation = Excitation::new(0.01, if mirrored { &mirror } else { &motion }).expect("finite");
                let ledger = Ledger::new(&row, excitation).held_to(Laws::Energy { tolerance: 1e-16 });
                let mut recorders = (Peaks::new(3), ledger);
                EXACT
                    .watch(&row, excitation, clock, &mut recorders)
                    .unwrap_or_else(|error| panic!("{name}: {error}"));
                let (peaks, ledger) = recorders;
                ledger.verdict().unwrap_or_else(|error| panic!("{name}: {error}"));
                assert!(ledger.momentum() < 1e-11, "{name}: {}", ledger.momentum());
                assert!(ledger.of_link(0).energy.abs() > 0.0, "{name}: the link must act");
                *ends = [0, 1, 2].map(|node| peaks.of(if mirrored { 2 - node } else { node }).displacement.value);
            }
            for (one, other) in ends[0].iter().zip(&ends[1]) {
                assert!((one.abs() / other.abs() - 1.0).abs() < 1e-9, "{name}: {one} {other}");
            }
        }
    }
}

/// A link without stiffness and dashpot changes nothing but rounding, and one that is stiff makes two structures one.
#[test]
fn limit_of_weak_and_stiff_links() {
    let spring = |stiffness: f64| {
        LinkLaw::Spring(Spring {
            stiffness,
            yield_force: f64::INFINITY,
            hardening: 0.0,
            damping: 0.0,
        })
    };
    let run = |stiffness: f64| {
        let nodes = vec![moving(3e5, 1.2e7, 0.05, 0.0), moving(2e5, 4e7, 0.05, 0.0)];
        let link = between(0.into(), 1.into(), spring(stiffness));
        let row = Row::new(nodes, vec![]).and_then(|row| row.linked(vec![link])).expect("a row");
        let LetGo { last, .. } = let_go(&row, 1.0);
        [0, 1].map(|node| last.of(node).displacement)
    };
    let free = |mass: f64, stiffness: f64| 0.05 * libm::cos((stiffness / mass).sqrt());
    let weak = run(1e-3);
    assert!((weak[0] - free(3e5, 1.2e7)).abs() < 1e-10, "{weak:?}");
    assert!((weak[1] - free(2e5, 4e7)).abs() < 1e-10, "{weak:?}");
    let stiff = run(1e13);
    let joined = free(5e5, 5.2e7);
    assert!(
        (stiff[0] - joined).abs() < 1e-5 && (stiff[1] - joined).abs() < 1e-5,
        "{stiff:?} {joined}"
    );
}

/// Two structures, the right one of two storeys, with a link between the left one and the upper floor, and one to the ground.
fn tower_beside_house(law: LinkLaw, pairs: Vec<Pair>) -> Row<Elastic> {
    let house = Node::structure(3e5, 1e5, Elastic { stiffness: 1.2e7 });
    let storey = Node::structure(2e5, 1e5, Elastic { stiffness: 4e7 });
    let upper = storey.on_floor(Floor {
        below: 1,
        ground_damping: 4e4,
    });
    let links = vec![between(0.into(), 2.into(), law), between(1.into(), Point::Ground(1), law)];
    let row = Row::new(vec![house, storey, upper], pairs).expect("a row");
    row.linked(links).expect("links")
}

/// Displacements of all floors at the end.
fn at_the_end(row: &Row<Elastic>, method: Integrator, time_step: f64) -> [f64; 3] {
    let motion = ground();
    let excitation = Excitation::new(0.01, &motion).expect("finite");
    let mut last = LastStates::new(3);
    method.watch(row, excitation, clock(time_step, 2.0), &mut last).expect("it runs");
    [0, 1, 2].map(|node| last.of(node).displacement)
}

/// Central differences keep their order with links: dashpots do not lower it, and few kinks of springs hardly do.
#[test]
fn order_central_differences_with_links_against_the_exact_method() {
    for (name, law) in laws() {
        let row = tower_beside_house(law, vec![]);
        let exact = at_the_end(&row, EXACT, 0.01);
        let steps = [2e-3, 1e-3, 5e-4, 2.5e-4];
        let errors = steps.map(|step| {
            let found = at_the_end(&row, CENTRAL, step);
            let off = found.iter().zip(&exact).map(|(found, exact)| (found - exact).abs());
            off.fold(0.0, f64::max)
        });
        let order = slope(&steps, &errors);
        let least = if matches!(name, "bilinear" | "friction" | "restrainer") {
            1.0
        } else {
            1.9
        };
        assert!(order > least, "{name}: order {order}, errors {errors:?}");
    }
}

/// The books of steps with links: impulses are those of the equations, between impacts and across them.
#[test]
fn reference_books_of_central_differences_with_links() {
    let motion = ground();
    let excitation = Excitation::new(0.01, &motion).expect("finite");
    for contact in [STEREOMECHANICAL, VISCOELASTIC] {
        for (name, law) in laws() {
            for method in [CENTRAL, SUBSTEPPED] {
                let row = tower_beside_house(law, vec![Pair::of_floors(0, 1, 0.005, contact)]);
                let mut recorders = (Ledger::new(&row, excitation), Collisions::new(3, row.pairs()));
                method.watch(&row, excitation, clock(2e-4, 4.0), &mut recorders).expect("it runs");
                let (ledger, collisions) = recorders;
                ledger.verdict().unwrap_or_else(|error| panic!("{name}: {error}"));
                assert!(ledger.momentum() < 1e-11, "{name}: {}", ledger.momentum());
                assert!(collisions.all().len() > 1, "{name}: nothing touches");
                assert!(ledger.of_link(0).energy.abs() > 0.0, "{name}: the link must act");
            }
        }
    }
}

/// Peaks of links approach those of the exact method, which finds them inside its pieces.
#[test]
fn reference_peaks_of_links_in_central_differences() {
    let motion = ground();
    let excitation = Excitation::new(0.01, &motion).expect("finite");
    for (name, law) in laws() {
        let row = tower_beside_house(law, vec![]);
        let peaks = |method: Integrator| {
            let mut peaks = LinkPeaks::new(row.links());
            method.watch(&row, excitation, clock(2.5e-4, 4.0), &mut peaks).expect("it runs");
            let LinkPeak {
                push,
                pull,
                shortening,
                elongation,
            } = peaks.of(0);
            [push, pull, shortening, elongation].map(|peak| peak.value)
        };
        let (found, exact) = (peaks(CENTRAL), peaks(EXACT));
        assert!(exact[1] < -1e3 && exact[3] < -1e-3, "{name}: the link must act, {exact:?}");
        for (found, exact) in found.iter().zip(&exact) {
            assert!((found - exact).abs() <= 1e-4 * exact.abs(), "{name}: {found} instead of {exact}");
        }
    }
}

/// Impacts restart what dashpots join: the response approaches that of the exact method.
#[test]
fn order_central_differences_with_impacts_and_dashpots() {
    let (_, law) = laws()[1];
    let row = tower_beside_house(law, vec![Pair::of_floors(0, 1, 0.02, STEREOMECHANICAL)]);
    let exact = at_the_end(&row, EXACT, 0.01);
    let steps = [1e-3, 2.5e-4, 6.25e-5, 1.5625e-5];
    let errors = steps.map(|step| {
        let found = at_the_end(&row, CENTRAL, step);
        let off = found.iter().zip(&exact).map(|(found, exact)| (found - exact).abs());
        off.fold(0.0, f64::max)
    });
    let order = slope(&steps, &errors);
    assert!(order > 0.9, "order {order}, errors {errors:?}");
}

/// Just below the limit a motion stays, just above it grows.
#[test]
fn limit_of_the_time_step_with_links() {
    let spring = Spring {
        stiffness: 5e8,
        yield_force: f64::INFINITY,
        hardening: 0.0,
        damping: 0.0,
    };
    let dashpot = Spring {
        stiffness: 0.0,
        damping: 5e6,
        ..spring
    };
    let both = Spring { damping: 5e6, ..spring };
    for law in [spring, dashpot, both] {
        let row = tower_beside_house(LinkLaw::Spring(law), vec![]);
        let any = AnyRow::Elastic(row.clone());
        let limit = CENTRAL.limit_of_links(&any, 1.0).expect("a limit");
        assert_eq!(CENTRAL.limit_of_links(&any, 0.999 * limit), None);
        assert_eq!(EXACT.limit_of_links(&any, 1.0), None);
        let peak = |time_step: f64| {
            let motion = ground();
            let excitation = Excitation::new(0.01, &motion).expect("finite");
            let mut peaks = Peaks::new(3);
            let n_steps = 20_000;
            CENTRAL.watch(&row, excitation, Clock { time_step, n_steps }, &mut peaks).map(|_| {
                [0, 1, 2]
                    .map(|node| peaks.of(node).displacement.value.abs())
                    .into_iter()
                    .fold(0.0, f64::max)
            })
        };
        let below = peak(0.999 * limit).expect("it stays");
        assert!(below < 1.0, "{law:?}: {below} m");
        assert!(peak(1.001 * limit).map_or(true, |above| above > 1e3), "{law:?}: it must grow");
    }
}

/// At 0.97 of the limit of a spring, a restrainer that became taut again and again made the motion three times as large.
#[test]
fn extreme_restrainers_gain_no_energy_below_their_limit() {
    for (stiffness, slack) in [(5e8, 0.0), (5e7, 0.02), (2e9, 0.005)] {
        let law = LinkLaw::Restrainer(Restrainer {
            stiffness,
            yield_force: f64::INFINITY,
            slack,
        });
        let storey = |mass: f64, stiffness: f64| Node::structure(mass, 0.0, Elastic { stiffness });
        let on = |below: usize| Floor {
            below,
            ground_damping: 0.0,
        };
        let nodes = vec![
            storey(3e5, 1.2e7),
            storey(2e5, 4e7),
            storey(3e5, 1.2e7).on_floor(on(0)),
            storey(2e5, 4e7).on_floor(on(1)),
        ];
        let row = Row::new(nodes, vec![]).and_then(|row| row.linked(vec![between(2.into(), 3.into(), law)]));
        let row = row.expect("a row");
        let limit = CENTRAL.limit_of_links(&AnyRow::Elastic(row.clone()), 1.0).expect("a limit");
        let motion = ground();
        let excitation = Excitation::new(0.01, &motion).expect("finite");
        let run = |method: Integrator, time_step: f64| {
            let mut recorders = (Ledger::new(&row, excitation), Peaks::new(4));
            method
                .watch(&row, excitation, clock(time_step, 12.0), &mut recorders)
                .expect("it runs");
            let (ledger, peaks) = recorders;
            let peak = [0, 1, 2, 3].map(|node| peaks.of(node).displacement.value.abs());
            (ledger.of_link(0).energy, peak.into_iter().fold(0.0, f64::max))
        };
        let (_, exact) = run(EXACT, 0.01);
        let (energy, found) = run(CENTRAL, 0.999 * limit);
        assert!(
            (0.8..1.1).contains(&(found / exact)),
            "{stiffness}, {slack}: {found} m against {exact} m"
        );
        // A tenth of what the link can store at the peak.
        let stored = 0.5 * stiffness * (0.1 * exact) * (0.1 * exact);
        assert!(energy > -stored, "{stiffness}, {slack}: {energy} J");
    }
}

#[test]
fn extreme_bare_dampers_are_refused_by_central_differences() {
    let law = LinkLaw::Viscous(Viscous {
        coefficient: 1e5,
        exponent: 0.5,
    });
    let row = tower_beside_house(law, vec![]);
    let still = Excitation::new(0.01, &[0.0]).expect("finite");
    let refused = CENTRAL.watch(&row, still, clock(1e-3, 1.0), &mut Peaks::new(3));
    insta::assert_snapshot!(refused.expect_err("a refusal"), @"links[0]: found a viscous damper without a brace, whose force is too steep at rest for central differences; allowed is one with a brace, or the method rk4");
}

#[test]
fn extreme_links_of_nothing_are_refused() {
    let node = || moving(1.0, 1.0, 0.0, 0.0);
    let spring = LinkLaw::Spring(Spring {
        stiffness: -1.0,
        yield_force: f64::INFINITY,
        hardening: 0.0,
        damping: 0.0,
    });
    let cable = LinkLaw::Restrainer(Restrainer {
        stiffness: 1.0,
        yield_force: 1.0,
        slack: 0.0,
    });
    let refused = |link: Link| {
        let row = Row::new(vec![node(), node()], vec![]).expect("a row");
        row.linked(vec![link]).expect_err("a refusal").to_string()
    };
    insta::assert_snapshot!(refused(between(0.into(), 1.into(), spring)), @"links[0].stiffness: found -1, allowed a finite number >= 0");
    insta::assert_snapshot!(refused(between(0.into(), 0.into(), cable)), @"links[0]: found two ends at one point, or none on a floor; allowed are two ends, one of them on a floor");
    insta::assert_snapshot!(refused(between(0.into(), 2.into(), cable)), @"links[0].right: found node 2, allowed are those below 2");
    let ground = Pair::new(Point::Ground(0), 1.into(), 0.0, STEREOMECHANICAL);
    let pair = Row::new(vec![node(), node()], vec![ground]).expect_err("a refusal").to_string();
    insta::assert_snapshot!(pair, @"pairs[0].left: found no floor, allowed are a floor, and a point between a floor and what it stands on");
}
