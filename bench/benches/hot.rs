//! The hot loops separately: a step of every method, of lanes, a piece of the exact method in flight and in contact.
//!
//! `cargo bench --profile dev --package pounding-bench --bench hot`. An element is a step; in lanes a step of a scene; for the exact method
//! a piece of a structure's motion.

use std::f64::consts::PI;
use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput};
use pounding_contact::{ContactLaw, NonlinearViscoelastic, Stereomechanical};
use pounding_lanes::{RowsOf, SceneSums, SideBySide};
use pounding_solver::{
    CentralDifference, Clock, Collisions, Elastic, Exact, Excitation, Hht, Integrator, MoreauJean, Newmark, Node, Pair, Peaks, Rk4, Row,
    SimultaneousImpacts, Verlet, VerletImpacts,
};

const MASS: f64 = 1e5;
/// Scenes in lanes: as many as run in step on the machine with the widest vectors.
const LANES: usize = 16;
const CLOCK: Clock = Clock {
    time_step: 0.01,
    n_steps: 1000,
};
const CENTRAL: CentralDifference = CentralDifference { contact_substeps: 1 };
const METHODS: [(&str, Integrator); 7] = [
    ("central difference", Integrator::CentralDifference(CENTRAL)),
    ("Newmark", Integrator::Newmark(Newmark::AVERAGE_ACCELERATION)),
    ("HHT", Integrator::Hht(Hht { alpha: -0.1 })),
    (
        "Verlet",
        Integrator::Verlet(Verlet {
            impacts: VerletImpacts::VelocityJump,
        }),
    ),
    ("Runge-Kutta", Integrator::Rk4(Rk4)),
    ("Moreau-Jean", Integrator::MoreauJean(MoreauJean { theta: 0.5 })),
    (
        "exact",
        Integrator::Exact(Exact {
            tolerance: 1e-10,
            simultaneous_impacts: SimultaneousImpacts::Together,
        }),
    ),
];
const IMPACTS: ContactLaw = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.65 });
const ELEMENT: ContactLaw = ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
    impact_stiffness: 2.75e9,
    impact_damping_ratio: 0.35,
});

fn main() {
    let ground = ground();
    let excitation = Excitation::new(CLOCK.time_step, &ground).expect("finite samples");
    let mut criterion = Criterion::default()
        .configure_from_args()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    for (name, gap, law) in [
        ("nothing touches", 10.0, IMPACTS),
        ("impacts", 0.02, IMPACTS),
        ("viscoelastic", 0.02, ELEMENT),
    ] {
        let row = row(gap, law);
        let mut group = criterion.benchmark_group(name);
        for (method, integrator) in METHODS {
            let run = || {
                let mut recorder = (Peaks::new(2), Collisions::new(2, row.pairs()));
                let work = integrator.run(&row, excitation, CLOCK, &mut recorder);
                black_box(recorder);
                work.expect("the run ends")
            };
            let work = run();
            // The exact method counts only pieces, the others only steps.
            group.throughput(Throughput::Elements(work.steps.max(work.segments)));
            group.bench_function(method, |bencher| bencher.iter(run));
        }
        let together = SideBySide::new(CENTRAL, excitation, CLOCK).expect("valid settings");
        let (rows, n_steps) = (vec![&row; LANES], [CLOCK.n_steps; LANES]);
        let mut tallies = SceneSums::default();
        group.throughput(Throughput::Elements((LANES * CLOCK.n_steps) as u64));
        group.bench_function("lanes", |bencher| {
            bencher.iter(|| {
                assert!(
                    together.run(RowsOf::Elastic(&rows), &n_steps, &mut tallies),
                    "lanes take rows of one shape"
                );
                black_box(&tallies);
            });
        });
        group.finish();
    }
    criterion.final_summary();
}

/// Two structures with periods of 0.9 and 0.4 s.
fn row(gap: f64, law: ContactLaw) -> Row<Elastic> {
    let node = |period: f64| {
        let omega = 2.0 * PI / period;
        let stiffness = MASS * omega * omega;
        Node::structure(MASS, 0.1 * MASS * omega, Elastic { stiffness })
    };
    let pair = Pair::of_floors(0, 1, gap, law);
    Row::new(vec![node(0.9), node(0.4)], vec![pair]).expect("a valid row")
}

/// Accelerations of about 3 m/s² at the nodes of the clock.
fn ground() -> Vec<f64> {
    let at = |step: usize| {
        let time = CLOCK.time_step * step as f64;
        1.9 * libm::sin(5.1 * time) + 1.3 * libm::sin(9.7 * time + 1.0)
    };
    (0..=CLOCK.n_steps).map(at).collect()
}
