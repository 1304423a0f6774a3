//! Impulses of any set of contacts, found together.
//!
//! The problem is 0 ≤ P ⟂ W P − demand ≥ 0 with W = Aᵀ A. The column of a contact is M^(−½) gᵀ: the weights of its points, left minus
//! right, over the square roots of the masses. Or it is D^(−½) L⁻¹ gᵀ, with L D Lᵀ the matrix of a step. P is a minimum of ½ Pᵀ W P −
//! demandᵀ P over P ≥ 0. A push on a floor may help other contacts of its building, so that a contact that pushes may have to leave again.
//! The growing set of `chain.rs` does not suffice.
//!
//! Source: C. L. Lawson & R. J. Hanson, *Solving Least Squares Problems* (1974), ch. 23: contacts enter in turn; contacts that would pull
//! leave on the way to the next solution. The minimum falls each time, so that no set occurs twice.
//!
//! We depart in one step. Contacts may depend on each other, such as three points between a slab and a storey, or two walls beside a mass.
//! If their restitution differs, the demand is no Aᵀb, and the least-squares problem has no solution. A contact that depends on pushing
//! contacts then replaces one of them: impulses move along the dependence, which changes no velocity, until the first is zero.
//!
//! A P is unique, and so are the velocities. P may not be unique if contacts that get exactly their demand depend on each other. The answer
//! is then the least Σ P², the limit of equal springs, for any order of the contacts. It is a second problem of this kind.

pub(crate) mod basis;

use basis::{Basis, DEPENDENT, add, dot, norm};

/// Rounding of a demand that was met, relative to its terms.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Largest number of entries per contact; tests needed at most one. It prevents endless entries by rounding.
const ENTRIES: usize = 16;
/// Contacts that are solved together without further allocation.
const USUAL: usize = 64;

/// No impulses meet the demands: the contacts that hold a body take back the demand of another contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ClosedIn {
    pub(crate) contact: usize,
}

/// The problem, its answer and scratch.
pub(crate) struct Complementarity {
    search: Search,
    /// Contacts that get exactly their demand; pushing contacts come first.
    tight: Vec<usize>,
    /// Places of those among them that do not depend on earlier ones.
    members: Vec<usize>,
    /// Changes of their impulses that change no velocity, orthonormal.
    idle: Basis,
    /// Their impulses without these changes.
    fixed: Vec<f64>,
    /// Search for the change with the least Σ P².
    change: Search,
}

impl Complementarity {
    /// A problem with room for this many contacts and rows per column.
    pub(crate) fn new(n_contacts: usize, n_rows: usize) -> Self {
        let n = n_contacts.min(USUAL);
        Self {
            search: Search::new(n, n_rows),
            tight: Vec::with_capacity(n),
            members: Vec::with_capacity(n),
            idle: Basis::new(n, n),
            fixed: Vec::with_capacity(n),
            change: Search::new(n, n),
        }
    }

    /// Begins a problem with this many rows per column.
    ///
    /// Products sum the rows before `split` and the rows after it separately. Two bodies, one on each side, may then be swapped without a
    /// change of bits.
    pub(crate) fn begin(&mut self, n_rows: usize, split: usize) {
        self.search.begin(n_rows, split);
    }

    /// Adds a contact by the nonzero elements of its column.
    pub(crate) fn push(&mut self, column: impl Iterator<Item = (usize, f64)>) {
        self.search.push(column);
    }

    /// Sets the velocity that a contact must lose at least \[m/s\]; `scale` is the magnitude of its rounding.
    pub(crate) fn ask(&mut self, contact: usize, demand: f64, scale: f64) {
        self.search.contacts[contact].demand = demand;
        self.search.contacts[contact].scale = scale;
    }

    /// Applies impulses \[N·s\], in the order of the contacts, for [`Self::taken`].
    pub(crate) fn apply(&mut self, impulses: impl Iterator<Item = f64>) {
        for (contact, impulse) in self.search.contacts.iter_mut().zip(impulses) {
            contact.impulse = impulse;
        }
        self.search.drive();
    }

    /// Velocity that the last applied impulses remove from a contact \[m/s\].
    pub(crate) fn taken(&self, contact: usize) -> f64 {
        self.search.taken(contact)
    }

    /// Impulse of every contact \[N·s\], ≥ 0.
    pub(crate) fn impulses(&self) -> impl Iterator<Item = f64> {
        self.search.contacts.iter().map(|contact| contact.impulse)
    }

    /// Finds the impulses; true if they are unique: no pushing contact depends on others that get exactly their demand.
    ///
    /// Rarely, those others are zero in every answer: the impulses are then unique although the result is false. The caller checks the
    /// demands against rounding.
    pub(crate) fn solve(&mut self) -> Result<bool, ClosedIn> {
        self.search.solve()?;
        self.gather();
        Ok(self.idle.len == 0 || self.spread())
    }

    /// Lists the contacts that get exactly their demand, and the changes of their impulses that change no velocity.
    fn gather(&mut self) {
        let search = &mut self.search;
        self.tight.clone_from(&search.pushing);
        for contact in 0..search.contacts.len() {
            if search.contacts[contact].impulse == 0.0 && search.is_tight(contact) {
                self.tight.push(contact);
            }
        }
        self.idle.begin(self.tight.len(), 0);
        self.members.clear();
        self.members.extend(0..search.pushing.len());
        for place in search.pushing.len()..self.tight.len() {
            if search.express(self.tight[place]) {
                search.basis.keep();
                self.members.push(place);
            } else {
                search.basis.coefficients(&mut search.free);
                self.fixed.clear();
                self.fixed.resize(self.tight.len(), 0.0);
                for (member, share) in self.members.iter().zip(&search.free) {
                    self.fixed[*member] = -share;
                }
                self.fixed[place] = 1.0;
                self.idle.express(&self.fixed);
                self.idle.keep();
            }
        }
    }

    /// Finds the least Σ P²; true if no pushing contact can change.
    ///
    /// Without idle changes Σ P² is least, but some contacts may pull. With N the idle changes as columns, N Nᵀμ corrects this: 0 ≤ μ ⟂ N
    /// Nᵀ μ + those impulses ≥ 0.
    fn spread(&mut self) -> bool {
        let (contacts, change) = (&mut self.search.contacts, &mut self.change);
        self.fixed.clear();
        let before = self.tight.iter().map(|contact| contacts[*contact].impulse);
        self.fixed.extend(before);
        let largest = self.fixed.iter().copied().fold(0.0, f64::max);
        for vector in self.idle.vectors() {
            let part = dot(vector, &self.fixed, 0);
            add(&mut self.fixed, -part, vector);
        }
        change.begin(self.idle.len, 0);
        for (place, impulse) in self.fixed.iter().enumerate() {
            let elements = self.idle.vectors().map(|vector| vector[place]);
            change.push(elements.enumerate());
            let contact = &mut change.contacts[place];
            contact.scale = largest;
            contact.demand = if contact.norm > DEPENDENT { -impulse } else { f64::NEG_INFINITY };
        }
        // The impulses meet the demands without a change, too. If rounding hides the least ones, they stay.
        let found = change.solve().is_ok();
        let mut unique = true;
        for (place, contact) in self.tight.iter().enumerate() {
            let impulse = &mut contacts[*contact].impulse;
            if found {
                let least = self.fixed[place] + change.taken(place);
                let pushes = change.contacts[place].impulse == 0.0 && least > ROUNDING * largest;
                *impulse = if pushes { least } else { 0.0 };
            }
            unique &= *impulse == 0.0 || change.contacts[place].norm <= DEPENDENT;
        }
        unique
    }
}

/// A contact of a search.
struct SearchContact {
    /// Length of its column.
    norm: f64,
    demand: f64,
    /// Magnitude of the rounding of the demand.
    scale: f64,
    impulse: f64,
    /// Whether only rounding lets the contact enter.
    refused: bool,
}

/// The search for pushing contacts with independent columns.
struct Search {
    contacts: Vec<SearchContact>,
    /// A, column by column.
    columns: Vec<f64>,
    /// Contacts that push, in the order of the basis.
    pushing: Vec<usize>,
    basis: Basis,
    /// Impulses of the pushing contacts if none may leave.
    free: Vec<f64>,
    /// A P.
    driven: Vec<f64>,
    /// Sum of the magnitudes of the terms of A P.
    sizes: Vec<f64>,
}

impl Search {
    fn new(n: usize, n_rows: usize) -> Self {
        Self {
            contacts: Vec::with_capacity(n),
            columns: Vec::with_capacity(n * n_rows),
            pushing: Vec::with_capacity(n),
            basis: Basis::new(n, n_rows),
            free: Vec::with_capacity(n),
            driven: Vec::with_capacity(n_rows),
            sizes: Vec::with_capacity(n_rows),
        }
    }

    fn begin(&mut self, n_rows: usize, split: usize) {
        let n_rows = n_rows.max(1);
        self.contacts.clear();
        self.columns.clear();
        self.basis.begin(n_rows, split);
        self.driven.resize(n_rows, 0.0);
        self.sizes.resize(n_rows, 0.0);
    }

    fn push(&mut self, column: impl Iterator<Item = (usize, f64)>) {
        let start = self.columns.len();
        self.columns.resize(start + self.driven.len(), 0.0);
        let elements = &mut self.columns[start..];
        for (row, element) in column {
            elements[row] += element;
        }
        self.contacts.push(SearchContact {
            norm: norm(elements, self.basis.split),
            demand: 0.0,
            scale: 0.0,
            impulse: 0.0,
            refused: false,
        });
    }

    fn column(&self, contact: usize) -> &[f64] {
        let n_rows = self.driven.len();
        &self.columns[contact * n_rows..][..n_rows]
    }

    fn solve(&mut self) -> Result<(), ClosedIn> {
        for contact in &mut self.contacts {
            contact.impulse = 0.0;
            contact.refused = false;
        }
        self.pushing.clear();
        self.basis.truncate(0);
        self.drive();
        for _ in 0..ENTRIES * self.contacts.len() {
            let Some(index) = self.most_lacking() else {
                break;
            };
            if self.express(index) {
                self.basis.keep();
                self.pushing.push(index);
            } else {
                self.exchange(index)?;
            }
            self.shrink();
            let contact = &mut self.contacts[index];
            contact.refused = contact.impulse == 0.0;
        }
        Ok(())
    }

    /// The contact without impulse that lacks most, relative to the length of its column.
    fn most_lacking(&self) -> Option<usize> {
        let (mut found, mut most) = (None, 0.0);
        for (index, contact) in self.contacts.iter().enumerate() {
            if !contact.refused && contact.impulse == 0.0 {
                let (lack, terms) = self.lack(index);
                if lack > ROUNDING * terms && lack / contact.norm > most {
                    (found, most) = (Some(index), lack / contact.norm);
                }
            }
        }
        found
    }

    fn taken(&self, index: usize) -> f64 {
        dot(self.column(index), &self.driven, self.basis.split)
    }

    /// The velocity that a contact still has to lose, and the magnitude of its terms.
    fn lack(&self, index: usize) -> (f64, f64) {
        let SearchContact { demand, scale, .. } = self.contacts[index];
        let column = self.column(index).iter().zip(&self.sizes);
        let terms: f64 = column.map(|(element, size)| element.abs() * size).sum();
        (demand - self.taken(index), demand.abs().max(scale) + terms)
    }

    /// Whether a contact gets no more than its demand.
    fn is_tight(&self, index: usize) -> bool {
        let (lack, terms) = self.lack(index);
        lack > -DEPENDENT * terms
    }

    /// Expresses a column by the columns of the basis; true if it is independent of them.
    fn express(&mut self, index: usize) -> bool {
        let n_rows = self.driven.len();
        self.basis.express(&self.columns[index * n_rows..][..n_rows])
    }

    /// Lets a contact push instead of a contact on which it depends.
    fn exchange(&mut self, index: usize) -> Result<(), ClosedIn> {
        self.basis.coefficients(&mut self.free);
        let negligible = DEPENDENT * self.contacts[index].norm;
        let (mut blocking, mut least) = (None, f64::INFINITY);
        for (place, share) in self.free.iter().enumerate() {
            let SearchContact { norm, impulse, .. } = self.contacts[self.pushing[place]];
            if share * norm > negligible && impulse / share < least {
                (blocking, least) = (Some(place), impulse / share);
            }
        }
        let place = blocking.ok_or(ClosedIn { contact: index })?;
        for (other, share) in self.pushing.iter().zip(&self.free) {
            let impulse = &mut self.contacts[*other].impulse;
            *impulse = (*impulse - share * least).max(0.0);
        }
        self.contacts[self.pushing.remove(place)].impulse = 0.0;
        self.pushing.push(index);
        self.contacts[index].impulse = least;
        self.factorize(place);
        Ok(())
    }

    /// Moves to the solution over the pushing contacts. Contacts that would pull leave on the way.
    fn shrink(&mut self) {
        loop {
            self.free.clear();
            let pushing = self.pushing.iter().map(|index| &self.contacts[*index]);
            self.free.extend(pushing.map(|contact| contact.demand));
            self.basis.solve(&mut self.free);
            // The part of the way at which a contact that would pull reaches zero. A contact that has just entered gives 0 / 0, counts as
            // zero, and leaves.
            let ratio = |contact: &SearchContact, free: f64| {
                if free > 0.0 {
                    f64::INFINITY
                } else {
                    (contact.impulse / (contact.impulse - free)).max(0.0)
                }
            };
            let pairs = self.pushing.iter().zip(&self.free);
            let ratios = pairs.map(|(index, free)| ratio(&self.contacts[*index], *free));
            let part = ratios.fold(1.0, f64::min);
            let (mut kept, mut first) = (0, self.free.len());
            for (place, free) in self.free.iter().enumerate() {
                let index = self.pushing[place];
                let contact = &mut self.contacts[index];
                if ratio(contact, *free) <= part {
                    contact.impulse = 0.0;
                    first = first.min(place);
                } else {
                    contact.impulse += part * (free - contact.impulse);
                    self.pushing[kept] = index;
                    kept += 1;
                }
            }
            if kept == self.free.len() {
                break;
            }
            self.pushing.truncate(kept);
            self.factorize(first);
        }
        for (index, free) in self.pushing.iter().zip(&self.free) {
            self.contacts[*index].impulse = *free;
        }
        self.drive();
    }

    /// Factorises the columns of the pushing contacts, starting from one of them.
    fn factorize(&mut self, from: usize) {
        self.basis.truncate(from);
        for place in from..self.pushing.len() {
            self.express(self.pushing[place]);
            self.basis.keep();
        }
    }

    fn drive(&mut self) {
        self.driven.fill(0.0);
        self.sizes.fill(0.0);
        let columns = self.columns.chunks_exact(self.driven.len());
        for (contact, column) in self.contacts.iter().zip(columns) {
            if contact.impulse > 0.0 {
                add(&mut self.driven, contact.impulse, column);
                for (size, element) in self.sizes.iter_mut().zip(column) {
                    *size += contact.impulse * element.abs();
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
