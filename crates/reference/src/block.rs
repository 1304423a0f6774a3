//! Pairs that push at once, on any floors, several per floor included.
//!
//! G has the parts of floors in the rates of pairs, M their masses, and W = G M⁻¹ Gᵀ. With a₀ the accelerations without contact, pressing
//! pairs have W F = G a₀. Dependent pairs share the force with the least Σ F².
//!
//! Then G a = 0, and elimination finds floors that follow others: the lightest ones. The others have a₀ − M⁻¹ Gᵀ F. A floor that follows
//! takes its acceleration from theirs, to the last digit. All sets of pairs are tried to find the pushing set.

use super::model::Model;

/// Relative size below which a row, after elimination, depends on others.
const DEPENDENT: f64 = 1e-12;

type Matrix = Vec<Vec<f64>>;

/// Pairs that press, and their effect on the accelerations of all floors and walls.
#[derive(Debug, Clone)]
pub(super) struct Block {
    pub pairs: Vec<usize>,
    /// Motion of every floor per motion of every other floor; 1 on the diagonal for a floor that leads.
    ways: Matrix,
    /// Force of every pair per acceleration of every floor without the block \[kg\].
    forces: Matrix,
    /// Acceleration of every floor per acceleration of every floor without the block.
    accelerations: Matrix,
}

impl Block {
    pub(super) fn new(model: &Model, pairs: Vec<usize>) -> Self {
        let floors: Vec<_> = (0..model.structures.len()).collect();
        let part = |floor: usize, pair: usize| model.pairs[pair].ends.part(floor);
        let by_floor = least(&mobility(model, &pairs), &matrix(&floors, &pairs, part));
        let inverse_mass = |floor: usize| model.structures[floor].inverse_mass;
        let leads = matrix(&floors, &floors, |floor, other| {
            let pushed = pairs.iter().zip(&by_floor[other]);
            let pushed = pushed.map(|(pair, force)| part(floor, *pair) * force);
            f64::from(u8::from(floor == other)) - inverse_mass(floor) * pushed.sum::<f64>()
        });
        let lightness = floors.iter().map(|floor| inverse_mass(*floor).sqrt());
        let rows = matrix(&pairs, &floors, |pair, floor| part(floor, pair));
        let ways = ways(rows, &lightness.collect::<Vec<_>>());
        let accelerations = matrix(&floors, &floors, |floor, other| {
            let leaders = ways[floor].iter().zip(&leads);
            leaders.map(|(way, lead)| way * lead[other]).sum()
        });
        Self {
            forces: (0..pairs.len()).map(|pair| by_floor.iter().map(|of| of[pair]).collect()).collect(),
            pairs,
            ways,
            accelerations,
        }
    }

    /// Number of independent pairs.
    pub(super) fn rank(&self) -> usize {
        self.followers().count()
    }

    /// Force of every pair \[N\] from the accelerations of floors without the block. With magnitudes on both sides, the size of its terms.
    pub(super) fn forces(&self, sign: fn(f64) -> f64, without: &[f64]) -> Vec<f64> {
        product(&self.forces, sign, without)
    }

    /// Acceleration of every floor and wall \[m/s²\], from the accelerations without the block; with magnitudes, the size of its terms.
    pub(super) fn accelerations(&self, sign: fn(f64) -> f64, without: &[f64]) -> Vec<f64> {
        product(&self.accelerations, sign, without)
    }

    /// Floors that follow others, and how much each of the others moves them.
    pub(super) fn followers(&self) -> impl Iterator<Item = (usize, &[f64])> {
        let of = self.ways.iter().map(Vec::as_slice).enumerate();
        of.filter(|(floor, way)| way[*floor] == 0.0)
    }
}

fn product(rows: &[Vec<f64>], sign: fn(f64) -> f64, of: &[f64]) -> Vec<f64> {
    let row = |row: &Vec<f64>| row.iter().zip(of).map(|(one, of)| sign(*one) * of).sum();
    rows.iter().map(row).collect()
}

fn matrix(rows: &[usize], columns: &[usize], of: impl Fn(usize, usize) -> f64) -> Matrix {
    let row = |row: &usize| columns.iter().map(|column| of(*row, *column)).collect();
    rows.iter().map(row).collect()
}

/// W = G M⁻¹ Gᵀ of some pairs \[1/kg\].
pub(super) fn mobility(model: &Model, pairs: &[usize]) -> Matrix {
    let of = |one: usize, other: usize| {
        let common = |(floor, part): (usize, f64)| part * model.pairs[other].ends.part(floor) * model.structures[floor].inverse_mass;
        model.pairs[one].ends.parts().map(common).sum()
    };
    matrix(pairs, pairs, of)
}

/// How floors follow each other, from G and √M⁻¹.
fn ways(mut rows: Matrix, lightness: &[f64]) -> Matrix {
    let mut ways = unit(lightness.len());
    for (floor, row) in eliminate(&mut rows, lightness).into_iter().zip(&rows) {
        let Some(floor) = floor else { continue };
        ways[floor] = row.iter().map(|part| -part).collect();
        ways[floor][floor] = 0.0;
    }
    ways
}

fn unit(n: usize) -> Matrix {
    let all: Vec<_> = (0..n).collect();
    matrix(&all, &all, |row, column| f64::from(u8::from(row == column)))
}

/// Solutions x of A x = b with least Σ x², for a symmetric A and several b. Dependent rows are left out.
pub(super) fn least(matrix: &[Vec<f64>], sides: &[Vec<f64>]) -> Matrix {
    let n = matrix.len();
    let row = |(row, (own, unit)): (usize, (&Vec<f64>, Vec<f64>))| {
        let sides = sides.iter().map(|side| side[row]);
        own.iter().copied().chain(unit).chain(sides).collect()
    };
    let mut rows: Matrix = matrix.iter().zip(unit(n)).enumerate().map(row).collect();
    let columns = eliminate(&mut rows, &vec![1.0; n]);
    let mut found = vec![vec![0.0; n]; sides.len()];
    // Combinations of rows that vanish: these changes of x have no effect.
    let mut free = Matrix::new();
    for (column, row) in columns.into_iter().zip(rows) {
        match column {
            Some(column) => {
                for (found, solution) in found.iter_mut().zip(&row[2 * n..]) {
                    found[column] = *solution;
                }
            }
            None => free.push(row[n..2 * n].to_vec()),
        }
    }
    let dot = |one: &[f64], other: &[f64]| -> f64 { one.iter().zip(other).map(|(one, other)| one * other).sum() };
    while let Some(way) = free.pop() {
        let square = dot(&way, &way);
        for other in free.iter_mut().chain(&mut found) {
            let along = dot(&way, other) / square;
            for (other, way) in other.iter_mut().zip(&way) {
                *other -= along * way;
            }
        }
    }
    found
}

/// Eliminates each of the first columns from all rows except one; returns the column of every row, and `None` for dependent rows.
///
/// The next pivot is the largest weighted entry relative to its row.
fn eliminate(rows: &mut [Vec<f64>], weights: &[f64]) -> Vec<Option<usize>> {
    let weighed = |row: &[f64], column: usize| row[column].abs() * weights[column];
    let all = 0..weights.len();
    let size = |row: &Vec<f64>| all.clone().map(|one| weighed(row, one)).fold(0.0, f64::max);
    let sizes: Vec<f64> = rows.iter().map(size).collect();
    let mut columns = vec![None; rows.len()];
    loop {
        let (mut largest, mut place) = (DEPENDENT, None);
        for row in (0..rows.len()).filter(|row| columns[*row].is_none()) {
            for column in all.clone().filter(|column| !columns.contains(&Some(*column))) {
                let part = weighed(&rows[row], column) / sizes[row];
                if part > largest {
                    (largest, place) = (part, Some((row, column)));
                }
            }
        }
        let Some((row, column)) = place else {
            return columns;
        };
        columns[row] = Some(column);
        let mut taken = std::mem::take(&mut rows[row]);
        let scale = taken[column];
        for entry in &mut taken {
            *entry /= scale;
        }
        for entries in rows.iter_mut().filter(|entries| !entries.is_empty()) {
            let factor = entries[column];
            let changes = entries.iter_mut().zip(&taken);
            changes.for_each(|(entry, taken)| *entry -= factor * taken);
            entries[column] = 0.0;
        }
        rows[row] = taken;
    }
}

/// Groups of pairs that meet each other's floors. Walls do not connect pairs.
pub(super) fn groups(model: &Model, pairs: &[usize]) -> Vec<Vec<usize>> {
    let depend = |one: usize, other: usize| {
        let mut met = model.pairs[one].ends.parts();
        met.any(|(floor, _)| !model.is_wall(floor) && model.pairs[other].ends.part(floor) != 0.0)
    };
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for &pair in pairs {
        let meets = |group: &Vec<usize>| group.iter().any(|other| depend(pair, *other));
        let (met, mut others): (Vec<_>, Vec<_>) = groups.into_iter().partition(meets);
        others.push([met.concat(), vec![pair]].concat());
        groups = others;
    }
    groups
}

/// Tries all sets of numbers below `n`; returns the finding of the set with the smallest miss and, among equal ones, the least Σ x².
pub(super) fn best<Found>(n: usize, judge: impl Fn(&[usize]) -> (f64, f64, Found)) -> Option<Found> {
    let mut best: Option<(f64, f64, Found)> = None;
    for set in (0..1_usize << n).rev() {
        let members: Vec<_> = (0..n).filter(|member| (set >> member) & 1 == 1).collect();
        let (miss, squares, found) = judge(&members);
        // No other set has a smaller sum.
        let done = miss == 0.0 && members.len() == n;
        if best.as_ref().is_none_or(|best| (miss, squares) < (best.0, best.1)) {
            best = Some((miss, squares, found));
        }
        if done {
            break;
        }
    }
    best.map(|(_, _, found)| found)
}
