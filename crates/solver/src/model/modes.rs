//! The natural modes of a building, and Rayleigh damping from modes.

use nalgebra::{DMatrix, SymmetricEigen};

use crate::{Damping, Hysteretic, ModelError, Row, Storey};

/// A natural mode of a building with elastic columns.
///
/// Source: A. K. Chopra, *Dynamics of Structures*, chapters 10 to 13.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Circular frequency ω without damping \[rad/s\], ≥ 0; 0 if nothing holds the floors.
    pub angular_frequency: f64,
    /// Damping ratio ζ = φᵀCφ/(2 √(φᵀKφ φᵀMφ)) \[–\], ≥ 0. Exact for Rayleigh damping; for other damping the coupling of the modes is
    /// neglected.
    pub damping_ratio: f64,
    /// Displacements φ of the floors from the ground up \[–\], scaled so that the largest is 1 and that of the roof positive.
    pub shape: Vec<f64>,
    /// Modal mass φᵀMφ \[kg\], > 0.
    pub modal_mass: f64,
    /// Participation factor Γ = Σ m φ / φᵀMφ \[–\] of the ground motion, of either sign. The sum of Γφ over the modes is 1 at every floor.
    pub participation: f64,
}

/// A linear oscillation that a step must resolve: that of a structure, or of a pair while it touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillation {
    /// Circular frequency ω without damping \[rad/s\], > 0.
    pub angular_frequency: f64,
    /// Damping ratio ζ \[–\], ≥ 0.
    pub damping_ratio: f64,
}

impl Mode {
    /// Natural period T = 2π/ω \[s\]; infinite if nothing holds the floors.
    pub fn period(&self) -> f64 {
        2.0 * std::f64::consts::PI / self.angular_frequency
    }

    /// Effective modal mass Γ² φᵀMφ \[kg\], ≥ 0. The sum over all modes is the mass of the building.
    pub fn effective_mass(&self) -> f64 {
        self.participation * self.participation * self.modal_mass
    }

    /// The oscillation that a step must resolve.
    pub fn oscillation(&self) -> Oscillation {
        Oscillation {
            angular_frequency: self.angular_frequency,
            damping_ratio: self.damping_ratio,
        }
    }
}

/// Most iterations per floor in the search for modes, which needs about two.
const ITERATIONS_PER_FLOOR: usize = 1000;

/// Natural modes of a building from its storeys, given from the ground up; the slowest mode first.
///
/// Shapes are φ = M^(−1/2) y with the eigenvectors y of M^(−1/2) K M^(−1/2) from nalgebra. Its symmetric QR iteration uses only + − × ÷ √,
/// so that every machine finds the same bits. Frequencies are Rayleigh quotients Σ k (Δφ)²/Σ m φ² over drifts. Errors of a shape enter them
/// squared. The slowest mode of a building whose upper storeys are 1e12 times stiffer than its first keeps all its digits, unlike the
/// eigenvalue.
///
/// # Errors
/// [`ModelError::OutOfRange`] if a mass is not positive, a stiffness or damping is negative, or a value is not finite or too large compared
/// with a mass.
///
/// # Panics
/// Panics if the QR iteration does not end. It ends for every finite symmetric matrix.
pub fn modes<Column: Hysteretic>(storeys: &[Storey<Column>]) -> Result<Vec<Mode>, ModelError> {
    for (index, storey) in storeys.iter().enumerate() {
        check(index, storey)?;
    }
    if storeys.is_empty() {
        return Ok(Vec::new());
    }
    let matrix = scaled_stiffness(storeys);
    if let Some(index) = matrix.iter().position(|entry| !entry.is_finite()) {
        let index = index % storeys.len();
        return Err(ModelError::OutOfRange {
            place: format!("storeys[{index}].stiffness"),
            found: storeys[index].column.stiffness(),
            allowed: "stiffnesses that are finite beside the masses",
        });
    }
    let most = ITERATIONS_PER_FLOOR * storeys.len();
    let eigen = SymmetricEigen::try_new(matrix, f64::EPSILON, most).expect("shifted QR iteration of a finite symmetric matrix converges");
    let found = eigen.eigenvectors.column_iter();
    let mut modes: Vec<_> = found
        .map(|vector| {
            let floors = storeys.iter().zip(vector.iter());
            let shape = floors.map(|(storey, part)| part / storey.mass.sqrt());
            mode(storeys, normal(shape.collect()))
        })
        .collect();
    modes.sort_by(|a, b| a.angular_frequency.total_cmp(&b.angular_frequency));
    Ok(modes)
}

/// M^(−1/2) K M^(−1/2) \[1/s²\].
fn scaled_stiffness<Column: Hysteretic>(storeys: &[Storey<Column>]) -> DMatrix<f64> {
    let n = storeys.len();
    let root = |index: usize| storeys[index].mass.sqrt();
    DMatrix::from_fn(n, n, |row, column| {
        let upper = row.max(column);
        if row == column {
            let above = storeys.get(row + 1);
            let above = above.map_or(0.0, |storey| storey.column.stiffness());
            (storeys[row].column.stiffness() + above) / storeys[row].mass
        } else if row.abs_diff(column) == 1 {
            -storeys[upper].column.stiffness() / root(row) / root(column)
        } else {
            0.0
        }
    })
}

/// The shape scaled to a largest magnitude of 1, with a positive roof, or a positive highest floor that moves.
fn normal(shape: Vec<f64>) -> Vec<f64> {
    let largest = shape.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
    let highest = shape.iter().rev().find(|part| **part != 0.0);
    let scale = highest.map_or(1.0, |part| part.signum()) * largest;
    shape.into_iter().map(|part| part / scale).collect()
}

/// The mode with a given shape.
fn mode<Column: Hysteretic>(storeys: &[Storey<Column>], shape: Vec<f64>) -> Mode {
    let (mut modal_mass, mut excited) = (0.0, 0.0);
    let (mut stiffness, mut damping) = (0.0, 0.0);
    let mut below = 0.0;
    for (storey, part) in storeys.iter().zip(&shape) {
        let drift = part - below;
        modal_mass += storey.mass * (part * part);
        excited += storey.mass * part;
        stiffness += storey.column.stiffness() * (drift * drift);
        damping += storey.damping * (drift * drift) + storey.ground_damping * (part * part);
        below = *part;
    }
    Mode {
        angular_frequency: (stiffness / modal_mass).sqrt(),
        // A free floor has no damping: 0/0.
        damping_ratio: if damping > 0.0 {
            damping / (2.0 * (stiffness * modal_mass).sqrt())
        } else {
            0.0
        },
        shape,
        modal_mass,
        participation: excited / modal_mass,
    }
}

fn check<Column: Hysteretic>(index: usize, storey: &Storey<Column>) -> Result<(), ModelError> {
    const NOT_NEGATIVE: &str = "a finite number >= 0";
    let require = |valid: bool, field: &str, found: f64, allowed: &'static str| {
        if valid && found.is_finite() {
            return Ok(());
        }
        Err(ModelError::OutOfRange {
            place: format!("storeys[{index}].{field}"),
            found,
            allowed,
        })
    };
    let (mass, stiffness) = (storey.mass, storey.column.stiffness());
    require(mass > 0.0, "mass", mass, "a finite number > 0")?;
    require(stiffness >= 0.0, "stiffness", stiffness, NOT_NEGATIVE)?;
    require(storey.damping >= 0.0, "damping", storey.damping, NOT_NEGATIVE)?;
    let ground = storey.ground_damping;
    require(ground >= 0.0, "ground_damping", ground, NOT_NEGATIVE)
}

impl Damping {
    /// Rayleigh damping c = αm + βk that gives two `modes` of a building, the slower one first, these damping `ratios` ζ.
    ///
    /// # Errors
    /// [`ModelError`] unless the first mode is slower than the second and both have a frequency > 0.
    pub fn rayleigh_from_modes(modes: [&Mode; 2], ratios: [f64; 2]) -> Result<Self, ModelError> {
        let frequency = |mode: &Mode| mode.angular_frequency / (2.0 * std::f64::consts::PI);
        Self::rayleigh_from_ratios(modes.map(frequency), ratios)
    }
}

impl<Column: Hysteretic> Row<Column> {
    /// Natural modes of the building of a node, the slowest first.
    ///
    /// # Errors
    /// [`ModelError`] for a wall, and for the reasons listed at [`modes`].
    pub fn modes(&self, node: usize) -> Result<Vec<Mode>, ModelError> {
        let storey = |floor: &usize| {
            let node = &self.nodes()[*floor];
            Storey {
                mass: 1.0 / node.inverse_mass,
                damping: node.damping,
                ground_damping: node.support.ground_damping(),
                column: node.column,
            }
        };
        let building = self.buildings().of(node);
        let floors = self.buildings().floors(building);
        let storeys: Vec<_> = floors.iter().map(storey).collect();
        modes(&storeys)
    }
}

#[cfg(test)]
mod tests;
