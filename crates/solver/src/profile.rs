//! The matrix of several buildings that touch, and its elimination within the profile.
//!
//! Source: K.-J. Bathe, *Finite Element Procedures*, 8.2.3: in every row, and in the column of the same number, only the
//! elements from the first that is not zero to the diagonal are kept; elimination fills no other.
//!
//! Times the masses the matrix is symmetric and, as tangents are ≥ 0, positive definite: no pivoting is needed. Along a
//! line of neighbours it is the tridiagonal elimination.

use crate::trial::Trial;

/// A matrix and its factors, in place.
#[derive(Default)]
pub(crate) struct Profile {
    /// Of every row the first column, and of every column the first row.
    first: Vec<usize>,
    /// Where their elements start.
    start: Vec<usize>,
    /// Rows of the lower triangle, one after the other.
    lower: Vec<f64>,
    /// Columns of the upper triangle, one after the other.
    upper: Vec<f64>,
    diagonal: Vec<f64>,
    /// A right-hand side, then the solution.
    pub(crate) vector: Vec<f64>,
}

impl Profile {
    /// Room for so many rows and elements on either side of the diagonal; it grows where a row of buildings needs more.
    pub(crate) fn with_capacity(n: usize, n_elements: usize) -> Self {
        Self {
            first: Vec::with_capacity(n),
            start: Vec::with_capacity(n),
            lower: Vec::with_capacity(n_elements),
            upper: Vec::with_capacity(n_elements),
            diagonal: Vec::with_capacity(n),
            vector: Vec::with_capacity(n),
        }
    }

    /// Begins a matrix of n rows with nothing off the diagonal.
    pub(crate) fn begin(&mut self, n: usize) {
        self.first.clear();
        self.first.extend(0..n);
        self.vector.clear();
        self.vector.resize(n, 0.0);
    }

    /// Makes room for the two elements that join two rows.
    pub(crate) fn join(&mut self, one: usize, other: usize) {
        let (row, column) = (one.max(other), one.min(other));
        self.first[row] = self.first[row].min(column);
    }

    /// Lays out the rows joined so far.
    pub(crate) fn lay_out(&mut self) {
        self.start.clear();
        let mut n_elements = 0;
        for (row, first) in self.first.iter().enumerate() {
            self.start.push(n_elements);
            n_elements += row - first;
        }
        for triangle in [&mut self.lower, &mut self.upper] {
            triangle.clear();
            triangle.resize(n_elements, 0.0);
        }
        self.diagonal.clear();
        self.diagonal.resize(self.first.len(), 0.0);
    }

    /// Sets all elements to those of an equation: of node `nodes[i]` in row i, whose neighbours are at `place` of theirs.
    pub(crate) fn assemble<Memory>(
        &mut self,
        trials: &[Trial<Memory>],
        (nodes, place): (&[usize], &[usize]),
        pairs: impl Iterator<Item = (usize, usize)>,
        below: impl Fn(usize) -> Option<usize>,
    ) {
        self.lower.fill(0.0);
        self.upper.fill(0.0);
        for (row, &node) in nodes.iter().enumerate() {
            self.diagonal[row] = trials[node].diagonal;
            if let Some(under) = below(node) {
                self.add(row, place[under], trials[node].below);
                self.add(place[under], row, trials[under].above);
            }
        }
        for (left, right) in pairs {
            self.add(place[right], place[left], trials[right].lower);
            self.add(place[left], place[right], trials[left].upper);
        }
    }

    fn add(&mut self, row: usize, column: usize, value: f64) {
        if column < row {
            self.lower[self.start[row] + column - self.first[row]] += value;
        } else {
            self.upper[self.start[column] + row - self.first[column]] += value;
        }
    }

    /// Replaces the matrix by its factors: below the diagonal those of the rows above, on and above it what they leave.
    pub(crate) fn factorize(&mut self) {
        for row in 0..self.first.len() {
            let (first, start) = (self.first[row], self.start[row]);
            for column in first..row {
                let from = first.max(self.first[column]);
                let own = start + column - first;
                let other = self.start[column] + column - self.first[column];
                let [mut below, mut above] = [self.lower[own], self.upper[own]];
                // What rows and columns have in common before this element: as slices, so that no index is checked in the loop.
                let [mine, its] = [own, other].map(|end| end - (column - from)..end);
                let lower = self.lower[mine.clone()]
                    .iter()
                    .zip(&self.upper[its.clone()]);
                let upper = self.lower[its].iter().zip(&self.upper[mine]);
                for (left, right) in lower.zip(upper) {
                    below -= left.0 * left.1;
                    above -= right.0 * right.1;
                }
                self.upper[own] = above;
                self.lower[own] = below / self.diagonal[column];
            }
            let elements = start..start + row - first;
            let taken = self.lower[elements.clone()]
                .iter()
                .zip(&self.upper[elements]);
            for (below, above) in taken {
                self.diagonal[row] -= below * above;
            }
        }
    }

    /// Solves for [`Self::vector`] with the factors.
    pub(crate) fn solve(&mut self) {
        for row in 0..self.first.len() {
            let elements = self.start[row]..self.start[row] + row - self.first[row];
            let (before, rest) = self.vector.split_at_mut(row);
            let known = self.lower[elements].iter().zip(&before[self.first[row]..]);
            for (factor, known) in known {
                rest[0] -= factor * known;
            }
        }
        for row in (0..self.first.len()).rev() {
            self.vector[row] /= self.diagonal[row];
            let elements = self.start[row]..self.start[row] + row - self.first[row];
            let (before, rest) = self.vector.split_at_mut(row);
            let unknown = before[self.first[row]..].iter_mut();
            for (unknown, element) in unknown.zip(&self.upper[elements]) {
                *unknown -= element * rest[0];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_elimination_within_a_profile() {
        // Two towers of three floors that touch on the first and the third, level by level.
        let n = 6;
        let mut profile = Profile::with_capacity(n, 8);
        let joined = [(0, 1), (0, 2), (1, 3), (2, 4), (3, 5), (4, 5)];
        profile.begin(n);
        for (one, other) in joined {
            profile.join(one, other);
        }
        profile.lay_out();
        let element = |row: usize, column: usize| {
            let (row, column) = (row as f64, column as f64);
            -1.0 - 0.3 * row - 0.1 * column * column
        };
        let mut matrix = nalgebra::DMatrix::zeros(n, n);
        for (one, other) in joined {
            for (row, column) in [(one, other), (other, one)] {
                profile.add(row, column, element(row, column));
                matrix[(row, column)] = element(row, column);
            }
        }
        let wanted = nalgebra::DVector::from_fn(n, |row, _| 1.0 - 0.7 * row as f64);
        for row in 0..n {
            profile.diagonal[row] = 20.0 + row as f64;
            matrix[(row, row)] = profile.diagonal[row];
        }
        let right = &matrix * &wanted;
        profile.factorize();
        profile.vector.copy_from_slice(right.as_slice());
        profile.solve();
        for (found, wanted) in profile.vector.iter().zip(&wanted) {
            assert!((found - wanted).abs() < 1e-13, "{found} {wanted}");
        }
    }
}
