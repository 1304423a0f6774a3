//! Two towers of three storeys in OpenSees: studies/opensees/three-storey-pair.csv, made by the script in that folder.

use pounding_reference::Fineness;
use pounding_solver::{Clock, Collisions, Elastic, Excitation, Integrator, Peaks, Rk4, Row};

use super::storeys::{buildings, elastic, spring};

/// Results of the pair: peak displacements of the floors, left and right, from the ground up \[m\]; touches and peak forces \[N\] of the
/// levels.
#[derive(Debug, Default)]
struct Numbers {
    displacements: [[f64; 3]; 2],
    touches: [usize; 3],
    forces: [f64; 3],
}

/// Results of OpenSees for a time step, in the notation of the table.
fn opensees(time_step: &str) -> Numbers {
    let table = include_str!("../../../../studies/opensees/three-storey-pair.csv");
    let mut numbers = Numbers::default();
    let mut n_lines = 0;
    for line in table.lines() {
        let fields: Vec<_> = line.split(',').collect();
        let [step, quantity, building, storey, value] = fields[..] else {
            panic!("{line}");
        };
        if step != time_step {
            continue;
        }
        let level = storey.parse::<usize>().expect("a storey") - 1;
        let side = usize::from(building == "right");
        let number = || value.parse().expect("a number");
        match quantity {
            "touches" => numbers.touches[level] = value.parse().expect("a count"),
            "peak force [N]" => numbers.forces[level] = number(),
            _ => numbers.displacements[side][level] = number(),
        }
        n_lines += 1;
    }
    assert_eq!(n_lines, 12, "{time_step}");
    numbers
}

/// The pair of the script.
fn pair() -> Row<Elastic> {
    let left = elastic(&[(100e3, 60e6), (100e3, 50e6), (80e3, 40e6)]);
    let right = elastic(&[(250e3, 500e6), (250e3, 400e6), (200e3, 300e6)]);
    buildings(&[left, right], (0.3, 0.0015), (0.02, spring(2e8)))
}

/// Ground acceleration every 0.02 s \[m/s²\].
fn record() -> Vec<f64> {
    let text = include_str!("../../../../studies/records/el-centro-1940-ns-chopra.csv");
    let samples = text.lines().filter_map(|line| line.split_once(','));
    samples
        .filter_map(|(_, acceleration)| acceleration.parse::<f64>().ok())
        .map(|acceleration| 9.806_65 * acceleration)
        .collect()
}

fn by_second_route(row: &Row<Elastic>, excitation: Excitation<'_>) -> Numbers {
    let found = pounding_reference::run(row, excitation, 10.0, Fineness::FINE).expect("the run ends");
    let peak = |side: usize, level: usize| found.structures[2 * level + side].displacement.value;
    let levels = [0, 1, 2];
    Numbers {
        displacements: [0, 1].map(|side| levels.map(|level| peak(side, level))),
        touches: levels.map(|level| found.collisions[level].len()),
        forces: levels.map(|level| {
            let peaks = found.collisions[level].iter();
            peaks.filter_map(|touch| touch.peak_force).fold(0.0, f64::max)
        }),
    }
}

fn by_runge_kutta(row: &Row<Elastic>, excitation: Excitation<'_>) -> Numbers {
    let clock = Clock {
        time_step: 1e-5,
        n_steps: 1_000_000,
    };
    let mut recorders = (Peaks::new(6), Collisions::new(6, row.pairs()));
    Integrator::Rk4(Rk4)
        .run(row, excitation, clock, &mut recorders)
        .expect("the run ends");
    let (peaks, collisions) = recorders;
    let peak = |side: usize, level: usize| peaks.of(2 * level + side).displacement.value;
    let of = |level: usize| collisions.all().iter().filter(move |touch| touch.pair == level);
    let levels = [0, 1, 2];
    Numbers {
        displacements: [0, 1].map(|side| levels.map(|level| peak(side, level))),
        touches: levels.map(|level| of(level).count()),
        forces: levels.map(|level| of(level).filter_map(|touch| touch.peak_force).fold(0.0, f64::max)),
    }
}

impl Numbers {
    fn all(&self) -> Vec<f64> {
        let displacements = self.displacements.as_flattened();
        [displacements, &self.forces].concat()
    }

    /// Largest relative distance of peaks.
    fn distance(&self, other: &Self) -> f64 {
        let pairs = self.all().into_iter().zip(other.all());
        pairs.map(|(one, other)| ((one - other) / other).abs()).fold(0.0, f64::max)
    }
}

/// The error of OpenSees falls with the square of its step. Both stepping methods see forces only at their nodes, which limits peak forces
/// to about 1e-8.
#[test]
fn reference_opensees_comes_near_two_towers() {
    let (row, ground) = (pair(), record());
    let excitation = Excitation::new(0.02, &ground).expect("finite samples");
    let known = by_second_route(&row, excitation);
    let rk4 = by_runge_kutta(&row, excitation);
    for (time_step, within) in [
        ("0.001", 1e-3),
        ("0.0001", 1e-5),
        ("4e-05", 2e-6),
        ("2e-05", 4e-7),
        ("1e-05", 1.5e-7),
    ] {
        let found = opensees(time_step);
        let distance = found.distance(&known);
        assert!(distance < within, "{time_step} s: {distance:e}");
        assert_eq!(found.touches, known.touches, "{time_step} s");
    }
    let distance = rk4.distance(&known);
    assert!(distance < 1.5e-7, "Runge–Kutta: {distance:e}");
    assert_eq!(rk4.touches, known.touches, "Runge–Kutta");
}
