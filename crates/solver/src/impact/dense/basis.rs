//! Columns as sums of orthonormal vectors: which depend on earlier ones, and how.

/// A column counts as dependent if the others leave at most this part of it.
pub(super) const DEPENDENT: f64 = 1e-12;

/// Columns as sums of orthonormal vectors, A = Q R, by the modified method of Gram and Schmidt.
#[derive(Debug, Clone)]
pub(crate) struct Basis {
    n_rows: usize,
    /// Row at which products are split.
    pub(super) split: usize,
    /// Number of columns kept; one more may have been expressed.
    pub(crate) len: usize,
    /// Q, vector by vector.
    elements: Vec<f64>,
    /// R, column by column, each down to its diagonal.
    factors: Vec<f64>,
}

impl Basis {
    pub(crate) fn new(n: usize, n_rows: usize) -> Self {
        Self {
            n_rows,
            split: 0,
            len: 0,
            elements: Vec::with_capacity((n.min(n_rows) + 1) * n_rows),
            factors: Vec::with_capacity((n + 1) * (n + 2) / 2),
        }
    }

    #[cfg(test)]
    pub(super) fn capacity(&self) -> usize {
        self.elements.capacity() + self.factors.capacity()
    }

    pub(crate) fn begin(&mut self, n_rows: usize, split: usize) {
        self.n_rows = n_rows;
        self.split = split;
        self.truncate(0);
    }

    pub(super) fn truncate(&mut self, len: usize) {
        self.len = len;
        self.elements.truncate(len * self.n_rows);
        self.factors.truncate(len * (len + 1) / 2);
    }

    /// The orthonormal vectors.
    pub(crate) fn vectors(&self) -> impl Iterator<Item = &[f64]> {
        self.elements.chunks_exact(self.n_rows).take(self.len)
    }

    /// A column of R, down to its diagonal.
    fn factors(&self, column: usize) -> &[f64] {
        &self.factors[column * (column + 1) / 2..][..=column]
    }

    /// Expresses a column by the kept columns; true if it is independent of them.
    pub(crate) fn express(&mut self, column: &[f64]) -> bool {
        self.truncate(self.len);
        let (start, end) = (self.factors.len(), self.elements.len());
        self.factors.resize(start + self.len, 0.0);
        self.elements.extend_from_slice(column);
        let (vectors, rest) = self.elements.split_at_mut(end);
        let whole = norm(rest, self.split);
        let mut left = whole;
        // Two passes suffice, and one if little is lost: B. N. Parlett, *The Symmetric Eigenvalue Problem* (1980), 6-9.
        for _ in 0..2 {
            let vectors = vectors.chunks_exact(self.n_rows);
            for (vector, factor) in vectors.zip(&mut self.factors[start..]) {
                let part = dot(vector, rest, self.split);
                *factor += part;
                add(rest, -part, vector);
            }
            left = norm(rest, self.split);
            if left > 0.5 * whole {
                break;
            }
        }
        self.factors.push(left);
        left > DEPENDENT * whole
    }

    /// The rest of the last expressed column, orthogonal to the kept columns.
    pub(crate) fn rest(&self) -> &[f64] {
        &self.elements[self.len * self.n_rows..]
    }

    /// Keeps a column if it is independent of the kept columns; true if it is.
    pub(crate) fn take(&mut self, column: &[f64]) -> bool {
        let is_new = self.express(column);
        if is_new {
            self.keep();
        }
        is_new
    }

    /// Keeps the last expressed column.
    pub(crate) fn keep(&mut self) {
        let length = self.factors[self.factors.len() - 1];
        for element in &mut self.elements[self.len * self.n_rows..] {
            *element /= length;
        }
        self.len += 1;
    }

    /// Writes the last expressed column as a sum of the kept columns: a factor for each.
    pub(crate) fn coefficients(&self, shares: &mut Vec<f64>) {
        shares.clear();
        shares.extend_from_slice(&self.factors(self.len)[..self.len]);
        self.substitute(shares);
    }

    /// Solves Rᵀ R x = values, in place.
    pub(crate) fn solve(&self, values: &mut [f64]) {
        for column in 0..self.len {
            let (met, unmet) = values.split_at_mut(column);
            let factors = self.factors(column);
            unmet[0] = (unmet[0] - dot(met, factors, 0)) / factors[column];
        }
        self.substitute(values);
    }

    /// Solves R x = values, in place.
    fn substitute(&self, values: &mut [f64]) {
        for column in (0..self.len).rev() {
            let (above, own) = values.split_at_mut(column);
            let factors = self.factors(column);
            own[0] /= factors[column];
            add(above, -own[0], factors);
        }
    }
}

/// The product of two vectors: the sum of the rows before `split`, plus the sum of the others.
pub(crate) fn dot(one: &[f64], other: &[f64], split: usize) -> f64 {
    let product = |(one, other): (&[f64], &[f64])| -> f64 { one.iter().zip(other).map(|(one, other)| one * other).sum() };
    let (one, other) = (one.split_at(split), other.split_at(split));
    product((one.0, other.0)) + product((one.1, other.1))
}

pub(super) fn norm(vector: &[f64], split: usize) -> f64 {
    dot(vector, vector, split).sqrt()
}

/// Adds a multiple of a vector to another vector.
pub(crate) fn add(to: &mut [f64], factor: f64, vector: &[f64]) {
    for (to, element) in to.iter_mut().zip(vector) {
        *to += factor * element;
    }
}
