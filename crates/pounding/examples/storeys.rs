//! Two buildings of two storeys that touch at the roofs, and where a slab of the left one meets columns of the right one.
//!
//! `cargo run --package pounding --example storeys` prints:
//!
//! ```text
//! roofs:          5 collisions, 356.4 kN·s in all
//! slab on column: 11 collisions, 612.2 kN·s in all
//! ```
#![expect(clippy::print_stdout, reason = "an example speaks to its reader")]

use std::f64::consts::PI;

use pounding::contact::{ContactLaw, Stereomechanical};
use pounding::solver::{Clock, Collisions, Elastic, Exact, Excitation, Integrator, Levels, Pair, Point, Row, Storey};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A storey is a floor [kg] on columns [N/m] with dashpots [N·s/m]; each building has two alike.
    let storey = |mass: f64, stiffness: f64| Storey {
        mass,
        damping: 0.002 * stiffness,
        ground_damping: 0.0,
        column: Elastic { stiffness },
    };
    let storeys = [storey(1e5, 1e7), storey(2e5, 1e8)];

    // Levels number the floors of a row: level by level, on each from left to right.
    let levels = Levels::new(&[2, 2]);
    let floor = |node: usize| levels.floor(node, storeys[levels.place(node).0]);
    let nodes = (0..levels.n_nodes()).map(floor).collect();
    let (left, right) = (levels.of(0), levels.of(1));

    // The lower slab of the left building is at 35 % of the height of the upper storey of the right one.
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.6 });
    let column = Point::between(Some(right[0]), right[1], 0.35).ok_or("no point")?;
    let roofs = Pair::of_floors(left[1], right[1], 0.02, law);
    let slab = Pair::new(left[0].into(), column, 0.005, law);
    let row = Row::new(nodes, vec![roofs, slab])?;

    // The ground: accelerations [m/s²], a sine of 1 Hz for 1.5 s and rest, and the time between two of them [s].
    let (step, n_steps) = (0.01, 400);
    let sine = |index: usize| match index {
        0..=150 => 3.0 * libm::sin(2.0 * PI * step * index as f64),
        _ => 0.0,
    };
    let samples: Vec<f64> = (0..=n_steps).map(sine).collect();
    let ground = Excitation::new(step, &samples)?;

    let mut collisions = Collisions::new(row.nodes().len(), row.pairs());
    let clock = Clock { time_step: step, n_steps };
    Integrator::Exact(Exact::default()).run(&row, ground, clock, &mut collisions)?;
    for (pair, name) in ["roofs:         ", "slab on column:"].iter().enumerate() {
        let of_pair = collisions.all().iter().filter(|one| one.pair == pair);
        let impulses: Vec<f64> = of_pair.map(|one| one.impulse).collect();
        let all = 1e-3 * impulses.iter().sum::<f64>();
        println!("{name} {} collisions, {all:.1} kN·s in all", impulses.len());
    }
    Ok(())
}
