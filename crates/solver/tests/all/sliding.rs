//! Storeys that stick and slide under friction (`D_y` = 0), by closed forms, and by models that must agree.

use pounding_contact::{ContactLaw, LinearSpring, Stereomechanical};
use pounding_solver::{
    Bilinear, Clock, Excitation, Floor, Histories, Impact, LastStates, Laws, Ledger, Mixed, Node, Pair, Peaks, Point, Recorder, Row,
    RunError, Sliding, Span,
};

use crate::common::{METHODS, between, clock, ground, meeting, slope};
use crate::storeys_exact::EXACT;
use crate::watch::Watch;

const GRAVITY: f64 = 9.80665;

fn hard(restitution: f64) -> ContactLaw {
    ContactLaw::Stereomechanical(Stereomechanical { restitution })
}

fn soft(impact_stiffness: f64) -> ContactLaw {
    ContactLaw::LinearSpring(LinearSpring { impact_stiffness })
}

fn elastic(stiffness: f64) -> Mixed {
    Mixed::Sharp(Bilinear {
        stiffness,
        yield_force: f64::INFINITY,
        hardening: 0.0,
    })
}

/// A mass on friction pendulums of radius R under a weight.
fn pendulum(mass: f64, weight: f64, radius: f64, friction: f64) -> Node<Mixed> {
    let column = Sliding {
        stiffness: weight / radius,
        friction: friction * weight,
    };
    Node::structure(mass, 0.0, Mixed::Sliding(column))
}

/// A mass on a surface with friction, without a spring.
fn block(mass: f64, friction: f64) -> Node<Mixed> {
    let column = Sliding {
        stiffness: 0.0,
        friction: friction * mass * GRAVITY,
    };
    Node::structure(mass, 0.0, Mixed::Sliding(column))
}

fn free(mass: f64, velocity: f64) -> Node<Mixed> {
    Node {
        initial_velocity: velocity,
        ..Node::structure(mass, 0.0, elastic(0.0))
    }
}

fn on(below: usize) -> Floor {
    Floor {
        below,
        ground_damping: 0.0,
    }
}

/// A span of a node.
struct SeenSpan {
    node: usize,
    /// Start and end.
    times: [f64; 2],
    /// Displacement and velocity at the end.
    end: [f64; 2],
}

#[derive(Default)]
struct Seen {
    spans: Vec<SeenSpan>,
    impacts: usize,
}

impl Recorder for Seen {
    fn span(&mut self, span: &Span<'_>) {
        let end = [span.end.displacement, span.end.velocity];
        self.spans.push(SeenSpan {
            node: span.structure,
            times: [span.start_time, span.end_time],
            end,
        });
    }
    fn impact(&mut self, _: &Impact) {
        self.impacts += 1;
    }
}

impl Seen {
    /// Instants and displacements at which a node comes to a standstill.
    fn stops(&self, node: usize) -> Vec<[f64; 2]> {
        let mut moves = false;
        let mut stops = Vec::new();
        for SeenSpan {
            times: [_, time],
            end: [displacement, velocity],
            ..
        } in self.spans.iter().filter(|span| span.node == node)
        {
            if moves && *velocity == 0.0 {
                stops.push([*time, *displacement]);
            }
            moves = *velocity != 0.0;
        }
        stops
    }
}

struct Run {
    seen: Seen,
    last: LastStates,
    peaks: Peaks,
    histories: Histories,
}

fn run(row: &Row<Mixed>, (step, samples): (f64, &[f64]), duration: f64) -> Run {
    let excitation = Excitation::new(step, samples).expect("finite");
    let n = row.nodes().len();
    let ledger = Ledger::new(row, excitation).held_to(Laws::Energy { tolerance: 1e-16 });
    let recorders = (
        (Seen::default(), LastStates::new(n)),
        (Peaks::new(n), Histories::new(n, 0.01, duration)),
    );
    let mut recorders = (recorders, ledger);
    let clock = Clock {
        time_step: duration,
        n_steps: 1,
    };
    if let Err(error) = EXACT.watch(row, excitation, clock, &mut recorders) {
        panic!("{error:?} {:?}", row.pairs().first());
    }
    let (((seen, last), (peaks, histories)), ledger) = recorders;
    ledger.verdict().expect("the books add up");
    Run {
        seen,
        last,
        peaks,
        histories,
    }
}

fn close(what: &str, found: f64, wanted: f64, within: f64) {
    assert!((found - wanted).abs() <= within, "{what}: {found} instead of {wanted}");
}

/// Whatever the weight, turning points fall by 2µR each half period π √(R/g), and it sticks at 50 mm.
#[test]
fn reference_a_pendulum_lets_go_and_sticks() {
    let case = include_str!("../../../scene/tests/reach/isolator-friction-pendulum.json");
    let case: serde_json::Value = serde_json::from_str(case).expect("JSON");
    let of = |group: &str, name: &str| -> f64 { case[group][name].as_f64().expect(name) };
    let numbers = |name: &str| -> Vec<f64> {
        let all = case["expected"][name].as_array().expect(name).iter();
        all.map(|one| one.as_f64().expect(name)).collect()
    };
    for (mass, sign) in [(4e5, 1.0), (123.0, -1.0)] {
        let node = Node {
            initial_displacement: sign * of("inputs", "u0_m"),
            ..pendulum(mass, mass * of("inputs", "g"), of("inputs", "R_m"), of("inputs", "mu"))
        };
        let row = Row::new(vec![node], vec![]).expect("a row");
        let Run { seen, last, .. } = run(&row, (0.01, &[0.0; 2]), 8.0);
        let (turns, half) = (numbers("turning_points_m"), of("expected", "half_period_s"));
        let stops = seen.stops(0);
        assert_eq!(stops.len(), 3, "{stops:?}");
        for (n, [time, displacement]) in stops.iter().enumerate() {
            close("turning point", sign * displacement, turns[n + 1], 1e-14);
            close("instant", *time, (n + 1) as f64 * half, 1e-14);
        }
        close("sticks at", stops[2][0], of("expected", "sticks_at_s"), 1e-14);
        close("residual", sign * last.of(0).displacement, of("expected", "residual_m"), 1e-14);
        let mut way = 0.0;
        let (mut from, mut times) = (turns[0], vec![0.0]);
        for [time, displacement] in &stops {
            way += (sign * displacement - from).abs();
            from = sign * displacement;
            times.push(*time);
        }
        close(
            "energy over weight",
            of("inputs", "mu") * way,
            of("expected", "energy_dissipated_over_weight_m"),
            1e-15,
        );
        // The fastest instant is in the middle of a half cycle: a run that ends there has this velocity.
        for (n, wanted) in numbers("largest_velocity_of_half_cycles").iter().enumerate() {
            let middle = run(&row, (0.01, &[0.0; 2]), (n as f64 + 0.5) * half);
            close("velocity", middle.last.of(0).velocity.abs(), *wanted, 1e-14);
        }
    }
}

/// A block on ground that jerks with −J t slides from t₀ = µg/J on: u = J (t − t₀)³/6. After the record friction alone acts.
#[test]
fn reference_a_block_slides_under_a_ramp() {
    let (friction, jerk, end) = (0.1, 4.0, 1.0);
    let row = Row::new(vec![block(2e5, friction)], vec![]).expect("a row");
    let ramp = [0.0, -jerk * end];
    let Run { seen, last, peaks, .. } = run(&row, (end, &ramp), 4.0);
    let limit = friction * GRAVITY;
    let since = end - limit / jerk;
    let (u, v) = (jerk * since * since * since / 6.0, jerk * since * since / 2.0);
    let stops = seen.stops(0);
    assert_eq!(stops.len(), 1, "{stops:?}");
    close("stops at", stops[0][0], end + v / limit, 1e-14);
    close("stops after", last.of(0).displacement, u + v * v / (2.0 * limit), 1e-14);
    close("friction", peaks.of(0).restoring_force.value, limit * 2e5, 1e-9);
    let begins = seen.spans.iter().find(|span| span.end[1] != 0.0).expect("it slides").times[0];
    close("slides from", begins, limit / jerk, 1e-14);
}

/// Friction that holds a floor has its peak inside a piece: (ground acceleration) m − k u of a parabola of elastic neighbours.
#[test]
fn reference_the_peak_of_a_friction_that_holds() {
    // A swinging floor of 1 kg on k = 1 N/m above a floor that sticks pulls with at most k a.
    let above = Node {
        initial_displacement: 0.3,
        initial_velocity: 0.4,
        ..Node::structure(1.0, 0.0, elastic(1.0)).on_floor(on(0))
    };
    let row = Row::new(vec![block(1e3, 0.1), above], vec![]).expect("a row");
    let Run { peaks, last, .. } = run(&row, (1.0, &[0.0; 2]), 3.0);
    close("peak", peaks.of(0).restoring_force.value.abs(), 0.5, 1e-14);
    let wanted = 0.3 * libm::cos(3.0) + 0.4 * libm::sin(3.0);
    close("above", last.of(1).displacement, wanted, 1e-14);
    assert_eq!(last.of(0).displacement.to_bits(), 0.0_f64.to_bits());
}

/// An impact finds the floor with its own mass: v = (1 + e) m₂ v₂/(m₁ + m₂). Then it slides for v²/2µg, and sticks.
#[test]
fn reference_an_impact_makes_it_slide() {
    for (law, sign) in [(hard(0.5), 1.0), (hard(0.5), -1.0)] {
        let mut nodes = vec![free(3e5, 0.8 * sign), block(1e5, 0.2)];
        if sign < 0.0 {
            nodes.reverse();
        }
        let row = Row::new(nodes, vec![Pair::of_floors(0, 1, 0.02, law)]).expect("a row");
        let Run { seen, last, .. } = run(&row, (1.0, &[0.0; 2]), 0.2);
        let own = usize::from(sign > 0.0);
        assert_eq!(seen.impacts, 1);
        let (v, limit) = (1.5 * 0.75 * 0.8, 0.2 * GRAVITY);
        let since = 0.2 - 0.02 / 0.8;
        close(
            "slides",
            sign * last.of(own).displacement,
            v * since - 0.5 * limit * since * since,
            1e-14,
        );
        close("velocity", sign * last.of(own).velocity, v - limit * since, 1e-13);
    }
}

/// Plastic impacts of a pusher on a block: both move on together, and stop after v²/2a, where friction of one slows the mass of both.
#[test]
fn reference_a_plastic_impact_and_a_common_way() {
    let nodes = vec![free(3e5, 0.8), block(1e5, 0.2)];
    let row = Row::new(nodes, vec![Pair::of_floors(0, 1, 0.02, hard(0.0))]).expect("a row");
    let Run { seen, last, .. } = run(&row, (1.0, &[0.0; 2]), 3.0);
    // The pusher has no friction, and presses until both stop.
    let (v, slowed) = (0.75 * 0.8, 0.2 * GRAVITY * 0.25);
    let stops = seen.stops(1);
    assert_eq!(stops.len(), 1, "{stops:?}");
    close("stops at", stops[0][0], 0.02 / 0.8 + v / slowed, 1e-13);
    close("way", last.of(1).displacement, v * v / (2.0 * slowed), 1e-13);
    close("pusher", last.of(0).displacement, 0.02 + v * v / (2.0 * slowed), 1e-13);
}

/// A free mass rests against a block under a ramp: the friction holds both, until both slide as one mass.
#[test]
fn reference_friction_holds_a_neighbour_that_presses() {
    let (jerk, friction, own, other) = (2.0, 0.3, 1e5, 3e5);
    for mirrored in [false, true] {
        let mut nodes = vec![free(other, 0.0), block(own, friction)];
        let sign = if mirrored { -1.0 } else { 1.0 };
        if mirrored {
            nodes.reverse();
        }
        let row = Row::new(nodes, vec![Pair::of_floors(0, 1, 0.0, hard(0.0))]).expect("a row");
        let Run { seen, last, .. } = run(&row, (1.0, &[0.0, -jerk * sign, -2.0 * jerk * sign]), 1.5);
        let from = friction * own * GRAVITY / (own + other) / jerk;
        let since: f64 = 1.5 - from;
        for node in [0, 1] {
            close("way", sign * last.of(node).displacement, jerk * since * since * since / 6.0, 1e-13);
        }
        let begins = seen.spans.iter().find(|span| span.end[1] != 0.0).expect("it slides").times[0];
        close("slides from", begins, from, 1e-14);
    }
}

/// A block that slides against a wall is pressed there by what friction does not hold, and comes away when the ground turns.
#[test]
fn reference_a_block_pressed_against_a_wall() {
    for restitution in [0.0, 0.6] {
        let nodes = vec![block(1e5, 0.1), Node::wall(elastic(0.0))];
        let row = Row::new(nodes, vec![Pair::of_floors(0, 1, 0.01, hard(restitution))]).expect("a row");
        // It is at the wall from 1 s at the latest; the ground then acts to the left with 2 m/s³.
        let ground = [-3.0, -3.0, -3.0, 3.0, 3.0];
        let Run { seen, last, .. } = run(&row, (1.0, &ground), 4.0);
        let limit = 0.1 * GRAVITY;
        // From the wall it slides once 6 (t − 2.5) = µg, to the left.
        let from: f64 = 2.5 + limit / 6.0;
        let ramp = 3.0 - from;
        let (u, v) = (6.0 * ramp * ramp * ramp / 6.0, 6.0 * ramp * ramp / 2.0);
        let wanted = u + v + 0.5 * (3.0 - limit);
        close("way", 0.01 - last.of(0).displacement, wanted, 1e-12);
        let begins = seen.spans.iter().find(|span| span.times[0] > 2.0 && span.end[1] != 0.0);
        close("slides from", begins.expect("it slides").times[0], from, 1e-13);
    }
}

/// A tower on isolators that never slide has the bits of nothing but the fixed tower, with blows above.
#[test]
fn limit_a_base_that_never_slides_is_a_fixed_base() {
    let samples = ground();
    let storey = |below: Option<usize>, mass: f64, stiffness: f64| {
        let node = Node::structure(mass, 2e-3 * stiffness, elastic(stiffness));
        below.map_or(node, |below| node.on_floor(on(below)))
    };
    for law in [hard(0.6), soft(1e8)] {
        let fixed = vec![storey(None, 2e5, 2e8), storey(Some(0), 2e5, 2e8), storey(None, 1e5, 3e8)];
        let fixed = Row::new(fixed, vec![Pair::of_floors(1, 2, 0.005, law)]).expect("a row");
        let held = vec![
            pendulum(3e5, 1e9, 2.0, 0.9),
            storey(Some(0), 2e5, 2e8),
            storey(Some(1), 2e5, 2e8),
            storey(None, 1e5, 3e8),
        ];
        let held = Row::new(held, vec![Pair::of_floors(2, 3, 0.005, law)]).expect("a row");
        let [fixed, held] = [fixed, held].map(|row| run(&row, (0.01, &samples), 5.0));
        assert!(fixed.seen.impacts > 0 || law == soft(1e8));
        for (one, other) in [(0, 1), (1, 2), (2, 3)] {
            let pairs = fixed.histories.of(one).states.iter().zip(&held.histories.of(other).states);
            let apart = pairs.map(|(one, other)| (one.displacement - other.displacement).abs());
            let peak = fixed.peaks.of(one).displacement.value.abs();
            let apart = apart.fold(0.0, f64::max) / peak;
            assert!(apart < 1e-12, "{law:?} {one}: {apart:e}");
        }
        assert_eq!(held.peaks.of(0).displacement.value.to_bits(), 0.0_f64.to_bits());
    }
}

/// How the floors of [`moat`] meet.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Meets {
    /// The base meets its neighbours, of which a wall is one.
    InAChain,
    /// The columns above the base meet the slab of a neighbour, too.
    Columns,
}

/// A tower of two floors on this storey, between a wall and two masses, one of which stands beside a wall; or its mirror image.
fn moat(law: ContactLaw, column: Mixed, meets: Meets, mirrored: bool) -> Row<Mixed> {
    let place = |node: usize| if mirrored && node < 5 { 4 - node } else { node };
    let [mut base, near, far] = [(3e5, column, 1e4), (2e5, elastic(1e8), 2e5), (1e5, elastic(5e7), 1e5)]
        .map(|(mass, column, damping)| Node::structure(mass, damping, column));
    base.initial_velocity = if mirrored { -0.1 } else { 0.1 };
    let wall = Node::wall(elastic(0.0));
    let mut nodes = vec![wall, base, near, far, wall];
    if mirrored {
        nodes.reverse();
    }
    nodes.push(Node::structure(2e5, 3e5, elastic(2e8)).on_floor(on(place(1))));
    let pair = |left: Point, right: Point, gap: f64| {
        let [left, right] = if mirrored { [right, left] } else { [left, right] };
        meeting(left, right, gap, law)
    };
    let of = |left: usize| pair(place(left).into(), place(left + 1).into(), 0.01 * (1 + left % 2) as f64);
    let mut pairs: Vec<_> = (0..4).map(of).collect();
    if mirrored {
        pairs.reverse();
    }
    if meets == Meets::Columns {
        pairs.push(pair(between(Some(place(1)), 5, 0.4), place(2).into(), 0.015));
    }
    Row::new(nodes, pairs).expect("a row")
}

fn sliding() -> Mixed {
    Mixed::Sliding(Sliding {
        stiffness: 1e6,
        friction: 3e5,
    })
}

/// A row of which one mass slides, and its mirror image, under mirrored ground. The books of each add up.
#[test]
fn limit_mirror_images_of_a_row_that_slides() {
    let samples = ground();
    let opposite: Vec<f64> = samples.iter().map(|sample| -sample).collect();
    for law in [soft(2e8), hard(0.6), hard(0.0)] {
        for meets in [Meets::InAChain, Meets::Columns] {
            let one = run(&moat(law, sliding(), meets, false), (0.01, &samples), 3.0);
            let other = run(&moat(law, sliding(), meets, true), (0.01, &opposite), 3.0);
            assert!(one.seen.stops(1).len() > 3);
            for (node, mirrored) in [(1, 3), (2, 2), (3, 1), (5, 5)] {
                let pairs = one.histories.of(node).states.iter().zip(&other.histories.of(mirrored).states);
                let apart = pairs.map(|(one, other)| (one.displacement + other.displacement).abs());
                let apart = apart.fold(0.0, f64::max);
                assert!(apart < 1e-9, "{law:?} {meets:?} {node}: {apart:e}");
            }
        }
    }
}

/// Bilinear isolators of a shorter and shorter yield displacement come nearer to those that stick, but more slowly than in proportion to it:
/// where they should stick they swing, and each stop and start adds an error. A tenth of a millimetre leaves 6 mm.
#[test]
fn order_of_a_yield_displacement_that_vanishes() {
    let samples = ground();
    let of = |column: Mixed| {
        let nodes = vec![
            Node::structure(3e5, 1e4, column),
            Node::structure(2e5, 3e5, elastic(2e8)).on_floor(on(0)),
        ];
        run(&Row::new(nodes, vec![]).expect("a row"), (0.01, &samples), 3.0)
    };
    let limit = of(sliding());
    let yields_at = [1e-4, 1e-5, 1e-6, 1e-7];
    let errors = yields_at.map(|yields_at| {
        let before = 1e6 + 3e5 / yields_at;
        let near = of(Mixed::Sharp(Bilinear {
            stiffness: before,
            yield_force: before * yields_at,
            hardening: 1e6 / before,
        }));
        let pairs = near.histories.of(0).states.iter().zip(&limit.histories.of(0).states);
        let apart = pairs.map(|(one, other)| (one.displacement - other.displacement).abs());
        apart.fold(0.0, f64::max)
    });
    let order = slope(&yields_at, &errors);
    assert!((0.5..1.0).contains(&order), "{order} {errors:?}");
    assert!((0.004..0.008).contains(&errors[0]), "{errors:?}");
}

/// While it sticks, a floor is a wall to what presses it less than friction holds.
#[test]
fn limit_a_floor_that_sticks_is_a_wall() {
    for law in [soft(1e7), hard(0.0)] {
        let end = |other: Node<Mixed>| {
            let row = Row::new(vec![free(1e4, 0.0), other], vec![Pair::of_floors(0, 1, 0.0, law)]).expect("a row");
            let end = run(&row, (1.0, &[0.0, -2.0, 1.0, -1.0]), 4.0);
            [0, 1].map(|node| end.last.of(node).displacement)
        };
        let [[on_wall, _], [on_block, block]] = [end(Node::wall(elastic(0.0))), end(block(1e6, 0.4))];
        assert_eq!(block.to_bits(), 0.0_f64.to_bits(), "{law:?}");
        close("beside", on_block, on_wall, 1e-14);
    }
}

#[test]
fn extreme_only_the_exact_method_takes_friction() {
    let row = Row::new(vec![block(1e5, 0.1)], vec![]).expect("a row");
    let excitation = Excitation::new(0.01, &[0.0; 2]).expect("finite");
    for (name, method) in METHODS {
        let ended = method.watch(&row, excitation, clock(0.001, 0.1), &mut Seen::default());
        assert_eq!(ended.map(|_| ()), Err(RunError::Friction { structure: 0 }), "{name}");
    }
}
