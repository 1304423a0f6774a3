//! A row made from numbers: two towers 30 mm apart, shaken by a sine, without a scene file.
//!
//! `cargo run --package pounding --example row` prints:
//!
//! ```text
//! left tower:  peak displacement -115.7 mm
//! right tower: peak displacement 25.7 mm
//! 4 collisions, the hardest with 131 kN·s
//! ```
#![expect(clippy::print_stdout, reason = "an example speaks to its reader")]

use std::f64::consts::PI;

use pounding::contact::{ContactLaw, Stereomechanical};
use pounding::solver::{Clock, Collisions, Elastic, Exact, Excitation, Integrator, Node, Pair, Peaks, Row};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A tower is a mass [kg] on an elastic column with a period [s] and 5 % of critical damping. All numbers are SI.
    let tower = |mass: f64, period: f64| {
        let omega = 2.0 * PI / period;
        let stiffness = mass * omega * omega;
        Node::structure(mass, 2.0 * 0.05 * omega * mass, Elastic { stiffness })
    };
    // Towers stand from left to right. A pair names neighbours, the gap between them [m], and what happens when it closes.
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.65 });
    let gap = Pair::of_floors(0, 1, 0.03, law);
    let row = Row::new(vec![tower(1e5, 1.2), tower(3e5, 0.4)], vec![gap])?;

    // The ground: accelerations [m/s²], here a sine of 1 Hz for four seconds, and the time between two of them [s].
    let (step, n_steps) = (0.02, 200);
    let sine = |index: usize| 2.0 * libm::sin(2.0 * PI * step * index as f64);
    let samples: Vec<f64> = (0..=n_steps).map(sine).collect();
    let ground = Excitation::new(step, &samples)?;

    // Recorders watch the run; a pair of them is a recorder, too.
    let mut recorder = (Peaks::new(2), Collisions::new(2, row.pairs()));
    let clock = Clock { time_step: step, n_steps };
    Integrator::Exact(Exact::default()).run(&row, ground, clock, &mut recorder)?;

    let (peaks, collisions) = recorder;
    for (name, index) in [("left tower: ", 0), ("right tower:", 1)] {
        let peak = peaks.of(index).displacement.value;
        println!("{name} peak displacement {:.1} mm", 1000.0 * peak);
    }
    let impulses = collisions.all().iter().map(|one| one.impulse);
    let (count, hardest) = (impulses.len(), 1e-3 * impulses.fold(0.0, f64::max));
    println!("{count} collisions, the hardest with {hardest:.0} kN·s");
    Ok(())
}
