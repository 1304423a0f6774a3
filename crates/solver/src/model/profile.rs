//! A symmetric positive definite matrix with nonzero elements only near its diagonal, and its factors L D Lᵀ.
//!
//! Source: K.-J. Bathe, *Finite Element Procedures*, 8.2. Each row stores the elements from the diagonal to the last column that it, or a
//! row above, is joined to. Elimination fills no other element and needs no pivoting. Along a line of neighbours it is the tridiagonal
//! elimination.
//!
//! Each row is subtracted from the rows below it. The other order, in which the rows above are subtracted from each row, makes every
//! division wait for the one before.

/// Half of a matrix, later replaced by its factors.
#[derive(Default)]
pub(crate) struct Profile {
    rows: Vec<Kept>,
    /// Elements row by row; then D on the diagonal and Lᵀ beside it.
    elements: Vec<f64>,
    /// The right-hand side, then the solution.
    pub(crate) vector: Vec<f64>,
}

/// The stored part of a row.
struct Kept {
    /// Index of its first element, on the diagonal.
    start: usize,
    /// The column after its last element.
    end: usize,
}

impl Profile {
    /// Room for this many rows and elements. It grows if a row of buildings needs more.
    pub(crate) fn with_capacity(n: usize, n_elements: usize) -> Self {
        Self {
            rows: Vec::with_capacity(n),
            elements: Vec::with_capacity(n_elements),
            vector: Vec::with_capacity(n),
        }
    }

    /// Begins a matrix of n rows without off-diagonal elements.
    pub(crate) fn begin(&mut self, n: usize) {
        self.rows.clear();
        self.rows.extend((1..=n).map(|end| Kept { start: 0, end }));
        self.vector.clear();
        self.vector.resize(n, 0.0);
    }

    /// Makes room for the element that joins two rows.
    #[inline]
    pub(crate) fn join(&mut self, one: usize, other: usize) {
        let row = &mut self.rows[one.min(other)];
        row.end = row.end.max(one.max(other) + 1);
    }

    /// Lays out the joined rows. Their elements must then be [cleared](Self::clear).
    pub(crate) fn lay_out(&mut self) {
        let (mut start, mut end) = (0, 0);
        for (index, row) in self.rows.iter_mut().enumerate() {
            end = row.end.max(end);
            *row = Kept { start, end };
            start += end - index;
        }
        self.elements.resize(start, 0.0);
    }

    /// Sets all elements to zero.
    pub(crate) fn clear(&mut self) {
        self.elements.fill(0.0);
    }

    /// Adds to the element that joins two rows, or to a diagonal element.
    #[inline]
    pub(crate) fn add(&mut self, one: usize, other: usize, value: f64) {
        let (row, column) = (one.min(other), one.max(other));
        self.elements[self.rows[row].start + column - row] += value;
    }

    /// Replaces the matrix by its factors, and the right-hand side in [`Self::vector`] by the solution.
    pub(crate) fn solve(&mut self) {
        for (index, row) in self.rows.iter().enumerate() {
            let (own, mut below) = self.elements[row.start..].split_at_mut(row.end - index);
            let Some((pivot, own)) = own.split_first_mut() else {
                return;
            };
            let (known, unknown) = self.vector.split_at_mut(index + 1);
            let next = self.rows[index + 1..row.end].iter().zip(unknown);
            for (place, (next, unknown)) in next.enumerate() {
                let factor = own[place] / *pivot;
                *unknown -= factor * known[index];
                // Backwards: forwards, these few elements would be loaded in pairs that differ from those just stored.
                for column in (place..own.len()).rev() {
                    below[column - place] -= factor * own[column];
                }
                own[place] = factor;
                below = &mut below[next.end - (index + 1 + place)..];
            }
        }
        self.substitute();
    }

    /// Replaces the right-hand side b by D^(−½) L⁻¹ b, after the factorisation.
    ///
    /// The product of two such vectors equals the product of the first right-hand side with the solution for the second. For a matrix that
    /// is not positive definite they are NaN.
    pub(crate) fn halve(&mut self) {
        for (index, row) in self.rows.iter().enumerate() {
            let elements = &self.elements[row.start..row.start + row.end - index];
            let (known, unknown) = self.vector.split_at_mut(index + 1);
            for (unknown, factor) in unknown.iter_mut().zip(&elements[1..]) {
                *unknown -= factor * known[index];
            }
            known[index] /= elements[0].sqrt();
        }
    }

    /// Finds the unknowns, from the last one to the first.
    fn substitute(&mut self) {
        for (index, row) in self.rows.iter().enumerate().rev() {
            let elements = &self.elements[row.start..row.start + row.end - index];
            let (value, known) = (self.vector[index], &self.vector[index + 1..row.end]);
            let taken = elements[1..].iter().zip(known).rev();
            self.vector[index] = taken.fold(value / elements[0], |value, (factor, known)| value - factor * known);
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
        let mut profile = Profile::with_capacity(n, 3 * n);
        let joined = [(0, 1), (0, 2), (1, 3), (2, 4), (3, 5), (4, 5)];
        profile.begin(n);
        for (one, other) in joined {
            profile.join(one, other);
        }
        profile.lay_out();
        let element = |row: usize, column: usize| {
            let (row, column) = (row as f64, column as f64);
            -1.0 - 0.3 * (row + column) - 0.1 * row * column
        };
        let mut matrix = nalgebra::DMatrix::zeros(n, n);
        for (one, other) in joined {
            profile.add(one, other, element(one, other));
            matrix[(one, other)] = element(one, other);
            matrix[(other, one)] = element(one, other);
        }
        let wanted = nalgebra::DVector::from_fn(n, |row, _| 1.0 - 0.7 * row as f64);
        for row in 0..n {
            matrix[(row, row)] = 20.0 + row as f64;
            profile.add(row, row, matrix[(row, row)]);
        }
        let right = &matrix * &wanted;
        profile.vector.copy_from_slice(right.as_slice());
        profile.solve();
        for (found, wanted) in profile.vector.iter().zip(&wanted) {
            assert!((found - wanted).abs() < 1e-13, "{found} {wanted}");
        }
        // The half-way vectors give the products of the inverse.
        let halves = [right.as_slice(), wanted.as_slice()].map(|vector| {
            profile.vector.copy_from_slice(vector);
            profile.halve();
            profile.vector.clone()
        });
        let products = halves[0].iter().zip(&halves[1]);
        let product: f64 = products.map(|(one, other)| one * other).sum();
        assert!((product - wanted.dot(&wanted)).abs() < 1e-13 * wanted.dot(&wanted));
    }
}
