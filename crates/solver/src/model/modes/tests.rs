use std::f64::consts::PI;

use nalgebra::DVector;

use super::*;
use crate::{Elastic, Floor, Node};

fn storey(mass: f64, stiffness: f64) -> Storey<Elastic> {
    Storey {
        mass,
        damping: 0.0,
        ground_damping: 0.0,
        column: Elastic { stiffness },
    }
}

fn damped(storeys: &[Storey<Elastic>], damping: Damping) -> Vec<Storey<Elastic>> {
    let Damping::Rayleigh { alpha, beta } = damping else {
        panic!("Rayleigh damping");
    };
    let with = |storey: &Storey<Elastic>| Storey {
        damping: beta * storey.column.stiffness,
        ground_damping: alpha * storey.mass,
        ..*storey
    };
    storeys.iter().map(with).collect()
}

/// Floors of uneven masses and stiffnesses.
fn uneven(n: u32) -> Vec<Storey<Elastic>> {
    let wave = |i: u32, rate: f64| 1.2 + libm::sin(rate * f64::from(i));
    (0..n).map(|i| storey(1e5 * wave(i, 2.3), 8e7 * wave(i, 1.7))).collect()
}

fn assert_close(found: f64, wanted: f64, what: &str) {
    let allowed = 1e-12 * wanted.abs().max(1.0);
    assert!((found - wanted).abs() <= allowed, "{what}: {found} {wanted}");
}

/// Three storeys with masses m, m, m/2 and equal columns, by hand: ω² = (2 − √3), 2, (2 + √3) k/m.
#[test]
fn reference_a_frame_of_three_storeys_by_hand() {
    let (m, k) = (45e3, 5.7e7);
    let found = modes(&[storey(m, k), storey(m, k), storey(0.5 * m, k)]).unwrap();
    let root = 3.0_f64.sqrt();
    let shapes = [[0.5, 0.5 * root, 1.0], [-1.0, 0.0, 1.0], [0.5, -0.5 * root, 1.0]];
    // Γ by hand: (1.5 ± √3/2 … )/1.5 and so on, from Σ m φ and Σ m φ².
    let factors = [(1.0 + 0.5 * root) / 1.5, -0.5 / 1.5, (1.0 - 0.5 * root) / 1.5];
    for (n, factor) in [2.0 - root, 2.0, 2.0 + root].into_iter().enumerate() {
        let mode = &found[n];
        let omega: f64 = (factor * k / m).sqrt();
        assert_close(mode.angular_frequency / omega, 1.0, "frequency");
        assert_close(mode.period() * omega, 2.0 * PI, "period");
        for (part, wanted) in mode.shape.iter().zip(shapes[n]) {
            assert_close(*part, wanted, "shape");
        }
        assert_close(mode.modal_mass / m, 1.5, "modal mass");
        assert_close(mode.participation, factors[n], "participation");
        let effective = 1.5 * factors[n] * factors[n];
        assert_close(mode.effective_mass() / m, effective, "effective mass");
    }
}

/// A uniform shear building: ω = 2 √(k/m) sin((2j − 1) π/(4n + 2)), φ ∝ sin((2j − 1) i π/(2n + 1)).
#[test]
fn reference_uniform_buildings_in_closed_form() {
    let (m, k) = (3e5, 2e8);
    for n in [1_u32, 2, 3, 5, 10, 40] {
        let storeys = vec![storey(m, k); n as usize];
        let found = modes(&storeys).unwrap();
        assert_eq!(found.len(), storeys.len());
        for (mode, j) in found.iter().zip(1_u32..) {
            let angle = f64::from(2 * j - 1) * PI / f64::from(2 * n + 1);
            let omega = 2.0 * (k / m).sqrt() * libm::sin(0.5 * angle);
            assert_close(mode.angular_frequency / omega, 1.0, "frequency");
            let wanted: Vec<_> = (1..=n).map(|i| libm::sin(f64::from(i) * angle)).collect();
            for (part, wanted) in mode.shape.iter().zip(normal(wanted)) {
                // nalgebra's eigenvectors of 40 floors are known to about 1e-13 over the distance of the eigenvalues.
                assert!((part - wanted).abs() < 1e-11, "{n}, {j}: {part} {wanted}");
            }
        }
    }
}

#[test]
fn reference_periods_are_those_of_the_eigenvalues_of_nalgebra() {
    for n in [1, 2, 3, 7, 20] {
        let storeys = uneven(n);
        let found = modes(&storeys).unwrap();
        let mut eigenvalues: Vec<_> = scaled_stiffness(&storeys).symmetric_eigenvalues().iter().copied().collect();
        eigenvalues.sort_by(f64::total_cmp);
        for (mode, eigenvalue) in found.iter().zip(eigenvalues) {
            let wanted = 2.0 * PI / eigenvalue.sqrt();
            assert_close(mode.period() / wanted, 1.0, "period");
        }
    }
}

/// Modes solve their equation, are orthogonal, and make up the whole building.
#[test]
fn limit_modes_are_complete() {
    let storeys = uneven(12);
    let found = modes(&storeys).unwrap();
    let stiffness = scaled_stiffness(&storeys);
    let vector = |mode: &Mode| {
        let floors = storeys.iter().zip(&mode.shape);
        let parts = floors.map(|(storey, part)| storey.mass.sqrt() * part);
        DVector::from_iterator(storeys.len(), parts)
    };
    let fastest = found[11].angular_frequency * found[11].angular_frequency;
    for mode in &found {
        let y = vector(mode);
        let left = &stiffness * &y - mode.angular_frequency * mode.angular_frequency * &y;
        assert!(left.norm() < 1e-12 * fastest * y.norm(), "{}", left.norm());
        assert!(mode.shape[11] > 0.0, "the roof is positive");
        for other in found.iter().filter(|other| *other != mode) {
            let both = y.norm() * vector(other).norm();
            let common = y.dot(&vector(other));
            assert!(common.abs() < 1e-12 * both, "{common:e}");
        }
    }
    for floor in 0..12 {
        let sum: f64 = found.iter().map(|mode| mode.participation * mode.shape[floor]).sum();
        assert_close(sum, 1.0, "the ground moves all floors alike");
    }
    let total: f64 = storeys.iter().map(|storey| storey.mass).sum();
    let effective: f64 = found.iter().map(Mode::effective_mass).sum();
    assert_close(effective / total, 1.0, "mass");
}

#[test]
fn reference_rayleigh_damping_of_every_mode() {
    let storeys = uneven(6);
    let free = modes(&storeys).unwrap();
    let damping = Damping::rayleigh_from_modes([&free[0], &free[2]], [0.05, 0.03]).unwrap();
    let Damping::Rayleigh { alpha, beta } = damping else {
        panic!("{damping:?}");
    };
    let found = modes(&damped(&storeys, damping)).unwrap();
    assert_close(found[0].damping_ratio, 0.05, "first");
    assert_close(found[2].damping_ratio, 0.03, "third");
    for mode in &found {
        let omega = mode.angular_frequency;
        let wanted = 0.5 * (alpha / omega + beta * omega);
        assert_close(mode.damping_ratio, wanted, "ζ = α/2ω + βω/2");
    }
    let swapped = Damping::rayleigh_from_modes([&free[2], &free[0]], [0.05, 0.03]);
    assert!(swapped.is_err(), "{swapped:?}");
}

#[test]
fn limit_one_storey_is_the_structure_that_it_was() {
    let (mass, stiffness) = (75e3, 2.056e6);
    for damping in [
        Damping::Ratio(0.05),
        Damping::Rayleigh {
            alpha: 0.5712,
            beta: 0.001_447,
        },
    ] {
        let coefficient = damping.coefficient(mass, stiffness);
        let found = modes(&[Storey {
            damping: coefficient,
            ..storey(mass, stiffness)
        }])
        .unwrap();
        let oscillation = Oscillation {
            angular_frequency: (stiffness / mass).sqrt(),
            damping_ratio: coefficient / (2.0 * (stiffness * mass).sqrt()),
        };
        assert_eq!(found[0].oscillation(), oscillation, "bit for bit");
        assert_eq!(found[0].shape, [1.0]);
        assert_eq!(found[0].participation.to_bits(), 1.0_f64.to_bits());
    }
}

/// With rigid upper storeys the first mode is that of a single storey with the whole mass, to all digits.
#[test]
fn limit_rigid_upper_storeys_move_as_one() {
    let (m, k) = (2e5, 1e8);
    for ratio in [1e2, 1e5, 1e8, 1e12] {
        let found = modes(&[storey(m, k), storey(3.0 * m, ratio * k)]).unwrap();
        // λ² − (1 + r + r/3) λ + r/3 = 0 in k/m: the small root without cancellation.
        let sum = 1.0 + ratio + ratio / 3.0;
        let root = (sum * sum - 4.0 * ratio / 3.0).sqrt();
        let slow = (2.0 * ratio / 3.0) / (sum + root);
        let wanted = (slow * k / m).sqrt();
        let omega = found[0].angular_frequency;
        assert!((omega / wanted - 1.0).abs() < 1e-14, "{ratio:e}: {omega} {wanted}");
        let rigid = (k / (4.0 * m)).sqrt();
        assert!((omega / rigid - 1.0).abs() < 1.0 / ratio, "{ratio:e}: {omega}");
    }
    // Five storeys over nine decades of stiffness.
    let tower = [1.0, 1e3, 1e5, 1e7, 1e9].map(|ratio| storey(m, ratio * k));
    let first = &modes(&tower).unwrap()[0];
    let rigid = (k / (5.0 * m)).sqrt();
    assert!((first.angular_frequency / rigid - 1.0).abs() < 1e-3, "{first:?}");
    assert!((first.effective_mass() / (5.0 * m) - 1.0).abs() < 1e-6, "{first:?}");
}

#[test]
fn extreme_buildings_that_nothing_holds() {
    // The second floor floats.
    let found = modes(&[storey(1e5, 1e7), storey(1e5, 0.0)]).unwrap();
    assert_eq!(found[0].angular_frequency.to_bits(), 0.0_f64.to_bits());
    assert_eq!(found[0].damping_ratio.to_bits(), 0.0_f64.to_bits());
    assert!(found[0].period().is_infinite(), "{found:?}");
    assert_close(found[1].angular_frequency, 10.0, "the first");
    assert!(modes::<Elastic>(&[]).unwrap().is_empty(), "no storey, no mode");
}

#[test]
fn extreme_bad_storeys_are_refused() {
    for (mass, stiffness, field) in [
        (0.0, 1.0, "storeys[1].mass"),
        (f64::NAN, 1.0, "storeys[1].mass"),
        (f64::INFINITY, 1.0, "storeys[1].mass"),
        (1.0, -1.0, "storeys[1].stiffness"),
        (1e-200, 1e200, "storeys[1].stiffness"),
    ] {
        let found = modes(&[storey(1.0, 1.0), storey(mass, stiffness)]);
        let Err(ModelError::OutOfRange { place, .. }) = found else {
            panic!("{found:?}");
        };
        assert_eq!(place, field);
    }
}

#[test]
fn limit_a_row_knows_its_buildings() {
    // The inverse of the inverse of this mass is exact.
    const MASS: f64 = 131_072.0;
    let column = Elastic { stiffness: 1e7 };
    let node = Node::structure(MASS, 1e4, column);
    let upper = node.on_floor(Floor {
        below: 1,
        ground_damping: 2e3,
    });
    let row = Row::new(vec![Node::wall(column), node, node, upper], vec![]).unwrap();
    let buildings: Vec<_> = row.buildings().each().collect();
    assert_eq!(buildings, [&[0][..], &[1, 3], &[2]]);
    let own = Storey {
        damping: 1e4,
        ..storey(MASS, 1e7)
    };
    let upper = Storey {
        ground_damping: 2e3,
        ..own
    };
    assert_eq!(row.modes(1), modes(&[own, upper]));
    assert_eq!(row.modes(2), modes(&[own]));
    assert!(row.modes(0).is_err(), "a wall does not swing");
}
