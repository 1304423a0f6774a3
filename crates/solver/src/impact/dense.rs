//! Impulses of several pairs of the same buildings, found together.
//!
//! Asked is P with 0 ≤ W P − demand ⟂ P ≥ 0. A push on one storey helps the pairs of the same two buildings on others, so
//! that W has positive elements off its diagonal, and a pair once taken in may have to leave: growing the set, as
//! `chain.rs` does, is not enough. W is symmetric and positive definite; P then is the one minimum of ½ Pᵀ W P − demandᵀ P
//! over P ≥ 0.
//!
//! Source: C. L. Lawson & R. J. Hanson, *Solving Least Squares Problems* (1974), ch. 23: pairs enter one by one, those
//! that would pull leave on the way to the next solution, the minimum falls each time and no set comes twice.

/// What rounding leaves of a demand that was met, relative to its terms.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// A pivot less than so much of its diagonal element is none: of a mass held between two walls one pair says all.
const PIVOT: f64 = 1e-14;
/// Pairs of one cluster that are solved together without further allocation.
const USUAL: usize = 64;

/// The problem, its answer and scratch.
pub(crate) struct Complementarity {
    /// W, row by row \[1/kg\].
    matrix: Vec<f64>,
    /// Relative velocity every pair is to lose at least \[m/s\].
    pub(crate) demand: Vec<f64>,
    /// Impulse of every pair \[N·s\], ≥ 0.
    pub(crate) impulses: Vec<f64>,
    /// Pairs that push, in order.
    active: Vec<usize>,
    /// Pairs left out for good: rounding alone asks for them.
    refused: Vec<bool>,
    /// Cholesky factor of W over the active pairs, row by row.
    factors: Vec<f64>,
    /// Impulses of the active pairs if none of them may leave.
    free: Vec<f64>,
}

impl Complementarity {
    pub(crate) fn new(n_pairs: usize) -> Self {
        let n = n_pairs.min(USUAL);
        Self {
            matrix: Vec::with_capacity(n * n),
            demand: Vec::with_capacity(n),
            impulses: Vec::with_capacity(n),
            active: Vec::with_capacity(n),
            refused: Vec::with_capacity(n),
            factors: Vec::with_capacity(n * n),
            free: Vec::with_capacity(n),
        }
    }

    /// Begins a problem of n pairs.
    pub(crate) fn begin(&mut self, n: usize) {
        for (values, length) in [
            (&mut self.matrix, n * n),
            (&mut self.factors, n * n),
            (&mut self.demand, n),
            (&mut self.impulses, n),
            (&mut self.free, n),
        ] {
            values.clear();
            values.resize(length, 0.0);
        }
        self.refused.clear();
        self.refused.resize(n, false);
    }

    /// Sets what a unit impulse of one pair takes off the approach of another.
    pub(crate) fn set(&mut self, pair: usize, by: usize, taken: f64) {
        let n = self.demand.len();
        self.matrix[pair * n + by] = taken;
    }

    /// What some impulses take off the approach of a pair.
    pub(crate) fn taken(&self, pair: usize, impulses: impl Iterator<Item = f64>) -> f64 {
        let n = self.demand.len();
        let row = &self.matrix[pair * n..(pair + 1) * n];
        row.iter()
            .zip(impulses)
            .map(|(by, impulse)| by * impulse)
            .sum()
    }

    /// Finds the impulses.
    pub(crate) fn solve(&mut self) {
        self.impulses.fill(0.0);
        self.active.clear();
        let asks = |(pair, demand): (usize, &f64)| (*demand > 0.0).then_some(pair);
        self.active
            .extend(self.demand.iter().enumerate().filter_map(asks));
        self.shrink();
        while let Some(pair) = self.most_lacking() {
            let place = self.active.partition_point(|other| *other < pair);
            self.active.insert(place, pair);
            self.shrink();
            if self.impulses[pair] == 0.0 {
                self.refused[pair] = true;
            }
        }
    }

    /// The pair outside the active ones that lacks most.
    fn most_lacking(&self) -> Option<usize> {
        let n = self.demand.len();
        let (mut found, mut most) = (None, 0.0);
        for pair in 0..n {
            if self.refused[pair] || self.impulses[pair] > 0.0 {
                continue;
            }
            let (mut lack, mut scale) = (self.demand[pair], self.demand[pair].abs());
            for (by, impulse) in self.matrix[pair * n..].iter().zip(&self.impulses) {
                lack -= by * impulse;
                scale += (by * impulse).abs();
            }
            if lack > ROUNDING * scale && lack > most {
                (found, most) = (Some(pair), lack);
            }
        }
        found
    }

    /// Goes to the solution over the active pairs; those that would pull leave on the way.
    fn shrink(&mut self) {
        loop {
            while let Some(singular) = self.factorize() {
                let pair = self.active.remove(singular);
                self.impulses[pair] = 0.0;
                self.refused[pair] = true;
            }
            self.solve_active();
            let Self {
                active,
                free,
                impulses,
                ..
            } = self;
            let ratio = |impulse: f64, free: f64| {
                if free > 0.0 {
                    1.0
                } else if impulse > 0.0 {
                    impulse / (impulse - free)
                } else {
                    0.0
                }
            };
            let ratios = active.iter().zip(&*free);
            let part = ratios
                .map(|(pair, free)| ratio(impulses[*pair], *free))
                .fold(1.0, f64::min);
            let mut kept = 0;
            for index in 0..active.len() {
                let (pair, free) = (active[index], free[index]);
                let leaves = free <= 0.0 && ratio(impulses[pair], free) <= part;
                if leaves {
                    impulses[pair] = 0.0;
                } else {
                    impulses[pair] += part * (free - impulses[pair]);
                    active[kept] = pair;
                    kept += 1;
                }
            }
            if kept == active.len() {
                for (pair, free) in active.iter().zip(free) {
                    impulses[*pair] = *free;
                }
                return;
            }
            active.truncate(kept);
        }
    }

    /// Cholesky factors of W over the active pairs; the first of them that says no more than those before.
    fn factorize(&mut self) -> Option<usize> {
        let (n, size) = (self.demand.len(), self.active.len());
        for row in 0..size {
            for column in 0..=row {
                let mut value = self.matrix[self.active[row] * n + self.active[column]];
                let diagonal = value;
                for inner in 0..column {
                    value -= self.factors[row * size + inner] * self.factors[column * size + inner];
                }
                if column < row {
                    value /= self.factors[column * size + column];
                } else if value > PIVOT * diagonal {
                    value = value.sqrt();
                } else {
                    return Some(row);
                }
                self.factors[row * size + column] = value;
            }
        }
        None
    }

    /// Impulses that meet the demand of every active pair exactly.
    fn solve_active(&mut self) {
        let size = self.active.len();
        for row in 0..size {
            let mut value = self.demand[self.active[row]];
            for inner in 0..row {
                value -= self.factors[row * size + inner] * self.free[inner];
            }
            self.free[row] = value / self.factors[row * size + row];
        }
        for row in (0..size).rev() {
            let mut value = self.free[row];
            for inner in row + 1..size {
                value -= self.factors[inner * size + row] * self.free[inner];
            }
            self.free[row] = value / self.factors[row * size + row];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers between −1 and 1.
    fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) + 1;
        move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        }
    }

    #[test]
    fn reference_every_problem_is_solved() {
        let mut problem = Complementarity::new(12);
        for seed in 0..2000 {
            let mut number = numbers(seed);
            let n = 1 + (seed % 12) as usize;
            let factor = nalgebra::DMatrix::from_fn(n, n + 2, |_, _| number());
            let matrix = &factor * factor.transpose();
            problem.begin(n);
            for pair in 0..n {
                problem.demand[pair] = number();
                for by in 0..n {
                    problem.set(pair, by, matrix[(pair, by)]);
                }
            }
            problem.solve();
            for pair in 0..n {
                let impulse = problem.impulses[pair];
                let given = problem.taken(pair, problem.impulses.iter().copied());
                let left = given - problem.demand[pair];
                let close = 1e-9 * (1.0 + given.abs());
                assert!(impulse >= 0.0 && left > -close, "{seed}, {pair}: {left}");
                assert!(impulse == 0.0 || left < close, "{seed}, {pair}: {left}");
            }
        }
    }

    #[test]
    fn extreme_a_mass_between_two_walls() {
        // Both pairs say the same with opposite signs; what one asks for the other may not take back.
        let mut problem = Complementarity::new(2);
        problem.begin(2);
        for (pair, by, taken) in [(0, 0, 1.0), (0, 1, -1.0), (1, 0, -1.0), (1, 1, 1.0)] {
            problem.set(pair, by, taken);
        }
        for (demand, wanted) in [
            ([1.0, -1.0], [1.0, 0.0]),
            ([-1.0, 0.5], [0.0, 0.5]),
            ([0.0, 0.0], [0.0, 0.0]),
        ] {
            problem.demand.copy_from_slice(&demand);
            problem.solve();
            assert_eq!(problem.impulses, wanted);
        }
    }
}
