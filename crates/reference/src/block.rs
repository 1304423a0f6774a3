//! Pairs that push at once, whatever floors they meet and however many of one floor.
//!
//! With G the parts that floors have in the rates of pairs, M their masses and a₀ the accelerations without them, pairs that press have
//! W F = G a₀, W = G M⁻¹ Gᵀ. Where some ask for what others ask for, they share the force so that Σ F² is least. After that G a = 0: some
//! floors follow others, which elimination finds, the lightest following. The others have a₀ − M⁻¹ Gᵀ F, and floors that follow what this
//! makes of their own, to the last digit. Which pairs push is found by trying all sets of them.

use super::model::Model;

/// Part of itself to which elimination brings a row that follows from others.
const DEPENDENT: f64 = 1e-12;

/// Pairs that press, and the floors and walls that they meet.
#[derive(Debug, Clone)]
pub(super) struct Block {
    pairs: Vec<usize>,
    floors: Vec<usize>,
    /// N: how much every floor is moved by every floor; those that lead are by themselves alone.
    ways: Vec<Vec<f64>>,
    /// Force of every pair per acceleration of every floor without the block \[kg\].
    forces: Vec<Vec<f64>>,
    /// Acceleration of every floor per acceleration of every floor without the block.
    accelerations: Vec<Vec<f64>>,
}

impl Block {
    pub(super) fn new(model: &Model, pairs: Vec<usize>) -> Self {
        let mut floors: Vec<usize> = Vec::new();
        for (floor, _) in pairs.iter().flat_map(|&pair| model.pairs[pair].parts()) {
            if !floors.contains(&floor) {
                floors.push(floor);
            }
        }
        let part = |pair: usize, floor: usize| model.pairs[pair].part(floor);
        let rows = matrix(&pairs, &floors, part);
        let forces = least(&mobility(model, &pairs), &rows);
        let inverse_mass = |position: usize| model.structures[floors[position]].inverse_mass;
        let all: Vec<_> = (0..floors.len()).collect();
        let lead = |floor: usize, other: usize| -> f64 {
            let pushed = rows.iter().zip(&forces);
            let pushed = pushed.map(|(row, forces)| row[floor] * forces[other]);
            f64::from(u8::from(floor == other)) - inverse_mass(floor) * pushed.sum::<f64>()
        };
        let leads = matrix(&all, &all, lead);
        let ways = ways(rows, |position| inverse_mass(position).sqrt());
        let follow = |floor: usize, other: usize| {
            let leaders = ways[floor].iter().zip(&leads);
            leaders.map(|(way, lead)| way * lead[other]).sum()
        };
        Self {
            accelerations: matrix(&all, &all, follow),
            pairs,
            floors,
            ways,
            forces,
        }
    }

    /// How many of the pairs do not ask for what the others ask for.
    pub(super) fn rank(&self) -> usize {
        self.followers().count()
    }

    pub(super) fn has(&self, pair: usize) -> bool {
        self.pairs.contains(&pair)
    }

    /// Force of every pair \[N\], of the accelerations of floors without the block; with the magnitudes of both, what it is the sum of.
    pub(super) fn forces(
        &self,
        sign: fn(f64) -> f64,
        without: impl Fn(usize) -> f64,
    ) -> Vec<(usize, f64)> {
        self.product(&self.pairs, &self.forces, sign, without)
    }

    /// Acceleration of every floor \[m/s²\], likewise.
    pub(super) fn accelerations(
        &self,
        sign: fn(f64) -> f64,
        without: impl Fn(usize) -> f64,
    ) -> Vec<(usize, f64)> {
        self.product(&self.floors, &self.accelerations, sign, without)
    }

    fn product(
        &self,
        of: &[usize],
        rows: &[Vec<f64>],
        sign: fn(f64) -> f64,
        without: impl Fn(usize) -> f64,
    ) -> Vec<(usize, f64)> {
        let row = |row: &Vec<f64>| -> f64 {
            let terms = row.iter().zip(&self.floors);
            terms.map(|(one, floor)| sign(*one) * without(*floor)).sum()
        };
        of.iter().copied().zip(rows.iter().map(row)).collect()
    }

    /// Floors that follow others, and how much each of those moves them.
    pub(super) fn followers(&self) -> impl Iterator<Item = (usize, Vec<(usize, f64)>)> {
        let of = self.ways.iter().enumerate();
        let followers = of.filter(|(floor, way)| way[*floor] == 0.0);
        followers.map(|(floor, way)| {
            let leaders = self.floors.iter().copied().zip(way.iter().copied());
            let leaders = leaders.filter(|(_, part)| *part != 0.0);
            (self.floors[floor], leaders.collect())
        })
    }
}

fn matrix(rows: &[usize], columns: &[usize], of: impl Fn(usize, usize) -> f64) -> Vec<Vec<f64>> {
    let row = |row: &usize| columns.iter().map(|column| of(*row, *column)).collect();
    rows.iter().map(row).collect()
}

/// W = G M⁻¹ Gᵀ of some pairs \[1/kg\].
pub(super) fn mobility(model: &Model, pairs: &[usize]) -> Vec<Vec<f64>> {
    let of = |one: usize, other: usize| {
        let common = |(floor, part): (usize, f64)| {
            part * model.pairs[other].part(floor) * model.structures[floor].inverse_mass
        };
        model.pairs[one].parts().map(common).sum()
    };
    matrix(pairs, pairs, of)
}

/// N, of G and √M⁻¹.
fn ways(mut rows: Vec<Vec<f64>>, lightness: impl Fn(usize) -> f64) -> Vec<Vec<f64>> {
    let n = rows.first().map_or(0, Vec::len);
    let weights: Vec<_> = (0..n).map(lightness).collect();
    let mut ways = unit(n);
    for (floor, row) in eliminate(&mut rows, &weights).into_iter().zip(&rows) {
        let Some(floor) = floor else { continue };
        ways[floor] = row.iter().map(|part| -part).collect();
        ways[floor][floor] = 0.0;
    }
    ways
}

fn unit(n: usize) -> Vec<Vec<f64>> {
    let all: Vec<_> = (0..n).collect();
    matrix(&all, &all, |row, column| f64::from(u8::from(row == column)))
}

/// Solutions x of A x = b with least Σ x², for a symmetric A and several right-hand sides, of which rows that follow from others ask nothing.
pub(super) fn least(matrix: &[Vec<f64>], sides: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let n = matrix.len();
    let unit = unit(n);
    let row = |row: usize| [&matrix[row][..], &sides[row], &unit[row]].concat();
    let mut rows: Vec<_> = (0..n).map(row).collect();
    let columns = eliminate(&mut rows, &vec![1.0; n]);
    let m = sides.first().map_or(0, Vec::len);
    let mut found = vec![vec![0.0; m]; n];
    let (mut free, dot) = (
        Vec::<Vec<f64>>::new(),
        |one: &[f64], other: &[f64]| -> f64 {
            one.iter().zip(other).map(|(one, other)| one * other).sum()
        },
    );
    for (column, row) in columns.into_iter().zip(&rows) {
        let (solution, mut way) = (&row[n..n + m], row[n + m..].to_vec());
        if let Some(column) = column {
            found[column].copy_from_slice(solution);
            continue;
        }
        // A combination of rows that vanishes, and so a change of x that changes nothing.
        for other in &free {
            let along = dot(&way, other);
            way.iter_mut()
                .zip(other)
                .for_each(|(own, other)| *own -= along * other);
        }
        let length = dot(&way, &way).sqrt();
        free.push(way.into_iter().map(|own| own / length).collect());
    }
    for way in free {
        for side in 0..m {
            let along: f64 = way.iter().zip(&found).map(|(own, of)| own * of[side]).sum();
            found
                .iter_mut()
                .zip(&way)
                .for_each(|(of, own)| of[side] -= along * own);
        }
    }
    found
}

/// Eliminates the first columns from all rows but one each, by the largest entry of all that are left, weighed and as a part of its row;
/// the column of every row, and none for rows that follow from others.
fn eliminate(rows: &mut [Vec<f64>], weights: &[f64]) -> Vec<Option<usize>> {
    let weighed = |row: &[f64], column: usize| row[column].abs() * weights[column];
    let size = |row: &Vec<f64>| {
        (0..weights.len())
            .map(|column| weighed(row, column))
            .fold(0.0, f64::max)
    };
    let sizes: Vec<f64> = rows.iter().map(size).collect();
    let mut columns = vec![None; rows.len()];
    loop {
        let (mut largest, mut place) = (DEPENDENT, None);
        for row in (0..rows.len()).filter(|row| columns[*row].is_none()) {
            for column in (0..weights.len()).filter(|column| !columns.contains(&Some(*column))) {
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

/// Those of some pairs that depend on each other: they meet floors that others of them meet; walls carry nothing from one to another.
pub(super) fn groups(model: &Model, pairs: &[usize]) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for &pair in pairs {
        let floors = || {
            model.pairs[pair]
                .parts()
                .filter(|(floor, _)| !model.is_wall(*floor))
        };
        let meets = |group: &Vec<usize>| {
            group
                .iter()
                .any(|other| floors().any(|(floor, _)| model.pairs[*other].part(floor) != 0.0))
        };
        let (met, mut others): (Vec<_>, Vec<_>) = groups.into_iter().partition(meets);
        let mut group = met.concat();
        group.push(pair);
        group.sort_unstable();
        others.push(group);
        groups = others;
    }
    groups
}

/// What is found for the set of numbers below `n` that misses least what is asked, and of such sets for that with least Σ x².
pub(super) fn best<Found>(
    n: usize,
    judge: impl Fn(&[usize]) -> (f64, f64, Found),
) -> Option<Found> {
    let mut best: Option<(f64, f64, Found)> = None;
    for set in (0..1_usize << n).rev() {
        let members: Vec<_> = (0..n).filter(|member| (set >> member) & 1 == 1).collect();
        let (miss, squares, found) = judge(&members);
        // Nothing has less than all together.
        let done = miss == 0.0 && members.len() == n;
        if best
            .as_ref()
            .is_none_or(|best| (miss, squares) < (best.0, best.1))
        {
            best = Some((miss, squares, found));
        }
        if done {
            break;
        }
    }
    best.map(|(_, _, found)| found)
}
