//! Shared items of the solver's tests: structures of the paper, a synthetic ground motion, shorthands.
use crate::watch::Watch;
use nalgebra::{DMatrix, DVector};
use pounding_contact::{ContactLaw, NonlinearViscoelastic, Stereomechanical};
use pounding_solver::{
    Bilinear, CentralDifference, Clock, Elastic, Excitation, Floor, Hht, Histories, Hysteretic, Integrator, Ledger, MoreauJean, Newmark,
    Node, Pair, Point, Relation, Rk4, Row, Verlet, VerletImpacts, Work,
};

pub(crate) const WEAK: (f64, f64, f64) = (75e3, 2.056e6, 70e3);
pub(crate) const STIFF: (f64, f64, f64) = (3e6, 1.316e9, 4e6);

pub(crate) const STEREOMECHANICAL: ContactLaw = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.65 });
pub(crate) const VISCOELASTIC: ContactLaw = ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
    impact_stiffness: 2.75e9,
    impact_damping_ratio: 0.35,
});

pub(crate) const fn central(contact_substeps: u32) -> Integrator {
    Integrator::CentralDifference(CentralDifference { contact_substeps })
}

pub(crate) const CENTRAL: Integrator = central(1);
pub(crate) const SUBSTEPPED: Integrator = central(4);
pub(crate) const AVERAGE: Integrator = Integrator::Newmark(Newmark::AVERAGE_ACCELERATION);
pub(crate) const LINEAR: Integrator = Integrator::Newmark(Newmark::LINEAR_ACCELERATION);
pub(crate) const HHT: Integrator = Integrator::Hht(Hht { alpha: -0.1 });
pub(crate) const MOREAU_JEAN: Integrator = moreau_jean(0.5);
pub(crate) const VERLET: Integrator = Integrator::Verlet(Verlet {
    impacts: VerletImpacts::VelocityJump,
});
pub(crate) const LOCATED: Integrator = Integrator::Verlet(Verlet {
    impacts: VerletImpacts::Located,
});
pub(crate) const RK4: Integrator = Integrator::Rk4(Rk4);
pub(crate) const METHODS: [(&str, Integrator); 9] = [
    ("central difference", CENTRAL),
    ("Newmark 1/4", AVERAGE),
    ("Newmark 1/6", LINEAR),
    ("CD, sub-steps", SUBSTEPPED),
    ("HHT -0.1", HHT),
    ("Moreau-Jean 1/2", MOREAU_JEAN),
    ("Verlet", VERLET),
    ("Verlet, located", LOCATED),
    ("RK4", RK4),
];

/// Methods of order one in free motion.
pub(crate) const FIRST_ORDER: [(&str, Integrator); 2] = [("Moreau-Jean 3/4", moreau_jean(0.75)), ("Moreau-Jean 1", moreau_jean(1.0))];

pub(crate) const fn moreau_jean(theta: f64) -> Integrator {
    Integrator::MoreauJean(MoreauJean { theta })
}

pub(crate) fn elastic((mass, stiffness, _): (f64, f64, f64)) -> Node<Elastic> {
    Node::structure(mass, 0.5712 * mass + 0.001_447 * stiffness, Elastic { stiffness })
}

pub(crate) fn yielding((mass, stiffness, yield_force): (f64, f64, f64)) -> Node<Bilinear> {
    let column = Bilinear {
        stiffness,
        yield_force,
        hardening: 0.0,
    };
    Node::structure(mass, 0.5712 * mass + 0.001_447 * stiffness, column)
}

/// Pairs between all neighbours, with a common gap and law.
pub(crate) fn pairs(n: usize, gap: f64, law: ContactLaw) -> Vec<Pair> {
    (1..n).map(|right| Pair::of_floors(right - 1, right, gap, law)).collect()
}

/// Ten seconds of a smooth ground motion sampled every 0.01 s, strong enough for many collisions.
pub(crate) fn ground() -> Vec<f64> {
    (0..=1000)
        .map(|i| {
            let t = 0.01 * f64::from(i);
            let envelope = if t < 2.0 { 0.5 * t } else { 1.0 };
            envelope * (1.9 * libm::sin(5.1 * t) + 1.3 * libm::sin(9.7 * t + 1.0) + 0.9 * libm::cos(21.3 * t))
        })
        .collect()
}

pub(crate) fn clock(time_step: f64, duration: f64) -> Clock {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let n_steps = (duration / time_step).round() as usize;
    Clock { time_step, n_steps }
}

/// Histories at every node of the clock.
pub(crate) fn histories<Column: Hysteretic>(row: &Row<Column>, method: Integrator, ground: &[f64], clock: Clock) -> (Histories, Work) {
    let duration = clock.time_step * clock.n_steps as f64;
    let mut histories = Histories::new(row.nodes().len(), clock.time_step, duration);
    let excitation = Excitation::new(0.01, ground).expect("the ground motion is finite");
    let work = method.watch(row, excitation, clock, &mut histories).expect("the run ends");
    (histories, work)
}

/// Slope of log(error) over log(Δt) by least squares.
pub(crate) fn slope(steps: &[f64], errors: &[f64]) -> f64 {
    let rows = DMatrix::from_fn(steps.len(), 2, |row, column| if column == 0 { libm::log(steps[row]) } else { 1.0 });
    let right = DVector::from_iterator(errors.len(), errors.iter().map(|error| libm::log(*error)));
    rows.svd(true, true).solve(&right, 1e-12).expect("two unknowns, more steps")[0]
}

/// Ledger of a run.
pub(crate) fn book<'a, Column: Hysteretic>(row: &Row<Column>, method: Integrator, samples: &'a [f64], clock: Clock) -> Ledger<'a> {
    let excitation = Excitation::new(0.01, samples).expect("the ground motion is finite");
    let mut ledger = Ledger::new(row, excitation);
    method.watch(row, excitation, clock, &mut ledger).expect("the run ends");
    ledger
}

/// A mass without columns.
pub(crate) fn free(mass: f64, velocity: f64) -> Node<Elastic> {
    Node {
        initial_velocity: velocity,
        ..Node::structure(mass, 0.0, Elastic { stiffness: 0.0 })
    }
}

/// A structure from its period, damping ratio, and displacement and velocity at the start.
pub(crate) fn moving(mass: f64, [period, ratio]: [f64; 2], [displacement, velocity]: [f64; 2]) -> Node<Elastic> {
    let omega = 2.0 * std::f64::consts::PI / period;
    let column = Elastic {
        stiffness: mass * omega * omega,
    };
    Node {
        initial_displacement: displacement,
        initial_velocity: velocity,
        ..Node::structure(mass, 2.0 * ratio * omega * mass, column)
    }
}

/// A building, starting at a node, with these floors from the ground up: (mass, stiffness of the storey below, its damping).
pub(crate) fn building(first: usize, floors: &[(f64, f64, f64)]) -> Vec<Node<Elastic>> {
    let node = |(index, (mass, stiffness, damping)): (usize, &(f64, f64, f64))| {
        let column = Elastic { stiffness: *stiffness };
        let node = Node::structure(*mass, *damping, column);
        match index.checked_sub(1) {
            None => node,
            Some(below) => node.on_floor(Floor {
                below: first + below,
                ground_damping: 0.2 * mass,
            }),
        }
    };
    floors.iter().enumerate().map(node).collect()
}

/// A point between two floors of a building, with this part of the upper one.
pub(crate) fn between(lower: Option<usize>, upper: usize, part: f64) -> Point {
    Point::between(lower, upper, part).expect("it is not the ground")
}

pub(crate) fn meeting(left: impl Into<Point>, right: impl Into<Point>, offset: f64, law: ContactLaw) -> Pair {
    let (left, right) = (left.into(), right.into());
    let relation = Relation { left, right, offset };
    Pair { relation, law }
}

/// Two buildings of three storeys with floors at different heights: nodes 0, 1, 2 and 3, 4, 5. A slab of each meets columns of the other;
/// two floors carry points of several pairs.
pub(crate) fn floors_and_columns(law: ContactLaw) -> Row<Elastic> {
    let left = [(9e4, 4e7, 2e5), (8e4, 3e7, 1.5e5), (6e4, 2e7, 1e5)];
    let right = [(3e5, 6e8, 9e5), (2e5, 5e8, 8e5), (2e5, 4e8, 6e5)];
    let mut nodes = building(0, &left);
    nodes.extend(building(3, &right));
    let pairs = vec![
        meeting(1, between(Some(3), 4, 0.65), 0.006, law),
        meeting(between(Some(1), 2, 0.35), 4, 0.006, law),
        meeting(2, 5, 0.009, law),
        meeting(2, between(Some(4), 5, 0.7), 0.0085, law),
        meeting(0, between(None, 3, 0.65), 0.003, law),
    ];
    Row::new(nodes, pairs).expect("the row is valid")
}
