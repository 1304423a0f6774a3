//! Pairs at rest of a body of any row, and the forces that hold them.
//!
//! With G the rows of their relations and W = G M⁻¹ Gᵀ, the forces F keep the accelerations of touching points equal: W F = c, where c are
//! the accelerations towards each other without these forces. Chains do not use this: they move as blocks.

use crate::exact::contact::{PairState, System};
use crate::impact::dense::basis::{Basis, add, dot};

/// Pairs of a body that rest against each other with a force.
#[derive(Debug, Clone)]
pub(super) struct Tie {
    pub(super) pairs: Vec<usize>,
    /// Factors of W over pairs that do not depend on earlier ones, and the places of these pairs.
    basis: Basis,
    places: Vec<usize>,
    /// Changes of forces that move nothing, orthonormal.
    idle: Basis,
    /// Magnitudes of the inverse of W, row by row.
    sizes: Vec<f64>,
}

impl Tie {
    /// `None` if no pair rests.
    pub(super) fn of(pairs: Vec<usize>, system: System<'_>) -> Option<Self> {
        if pairs.is_empty() {
            return None;
        }
        let n = pairs.len();
        let floors = floors(&pairs, system.contacts);
        let mut tie = Self {
            basis: Basis::new(n, floors.len()),
            places: Vec::with_capacity(n),
            idle: Basis::new(n, n),
            sizes: Vec::with_capacity(n * n),
            pairs,
        };
        let mut shares = Vec::with_capacity(n);
        for place in 0..n {
            if tie.basis.take(&column(tie.pairs[place], &floors, system)) {
                tie.places.push(place);
            } else {
                tie.basis.coefficients(&mut shares);
                let mut change = vec![0.0; n];
                for (other, share) in tie.places.iter().zip(&shares) {
                    change[*other] = -share;
                }
                change[place] = 1.0;
                tie.idle.express(&change);
                tie.idle.keep();
            }
        }
        for place in 0..n {
            let mut unit = vec![0.0; n];
            unit[place] = 1.0;
            tie.solve(&mut unit);
            tie.sizes.extend(unit.iter().map(|size| size.abs()));
        }
        Some(tie)
    }

    /// Replaces accelerations towards each other by the forces that cancel them, or rates by impulses. Of several solutions this is the
    /// smallest.
    pub(super) fn solve(&self, values: &mut [f64]) {
        if self.places.len() == values.len() {
            return self.basis.solve(values);
        }
        let mut found: Vec<_> = self.places.iter().map(|place| values[*place]).collect();
        self.basis.solve(&mut found);
        values.fill(0.0);
        for (place, force) in self.places.iter().zip(found) {
            values[*place] = force;
        }
        for change in self.idle.vectors() {
            let part = dot(change, values, 0);
            add(values, -part, change);
        }
    }

    /// Bound of the force at a place for given magnitudes of accelerations.
    pub(super) fn size(&self, place: usize, magnitudes: &[f64]) -> f64 {
        let n = self.pairs.len();
        dot(&self.sizes[place * n..][..n], magnitudes, 0)
    }
}

/// The floors that carry points of pairs, in ascending order.
pub(super) fn floors(pairs: &[usize], contacts: &[PairState]) -> Vec<usize> {
    let pushes = pairs.iter().flat_map(|pair| contacts[*pair].relation.pushes());
    let mut floors: Vec<_> = pushes.map(|(floor, _)| floor).collect();
    floors.sort_unstable();
    floors.dedup();
    floors
}

/// Elements of the column M^(−½) gᵀ of a pair, by the places of these floors.
pub(super) fn elements<'a>(
    pair: usize,
    floors: &'a [usize],
    System { members, contacts, .. }: System<'a>,
) -> impl Iterator<Item = (usize, f64)> + 'a {
    let pushes = contacts[pair].relation.pushes();
    pushes.filter_map(move |(floor, part)| {
        let place = floors.binary_search(&floor).ok()?;
        Some((place, part * members[floor].inverse_mass.sqrt()))
    })
}

/// The whole column M^(−½) gᵀ of a pair, one element for each of these floors.
pub(super) fn column(pair: usize, floors: &[usize], system: System<'_>) -> Vec<f64> {
    let mut column = vec![0.0; floors.len()];
    for (place, element) in elements(pair, floors, system) {
        column[place] += element;
    }
    column
}
