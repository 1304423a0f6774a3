//! Rounds of impulses between pairs that touch and are no chain: several on a side of a floor, points between floors.
//!
//! The rule is that of `rounds.rs`: pairs that do not separate lose (1+e) of their approach r at least, and those that separate stay out.
//! Rounds repeat while a pair approaches; the last one is plastic and takes all in. Each is a problem of [`Complementarity`].

use crate::impact::dense::{ClosedIn, Complementarity, ROUNDING};
use crate::impact::rounds::{MAX_ROUNDS, Touching};
use crate::{Node, Point, Relation};

/// The pairs that touch at an instant, and scratch.
pub(crate) struct AnyRounds {
    floors: Vec<Floor>,
    touching: Vec<(usize, Relation, Touching<f64>)>,
    /// Impulse of each \[N·s\], all rounds.
    impulses: Vec<f64>,
    /// Net impulse on every floor in a round \[N·s\].
    net: Vec<f64>,
    problem: Complementarity,
}

/// A floor of the row.
struct Floor {
    /// The lowest floor of its building.
    base: usize,
    /// Its row in the columns of the problem: floors are listed building by building.
    place: usize,
    inverse_mass: f64,
    /// Its root.
    weight: f64,
}

impl AnyRounds {
    /// Of a row of nodes, with room for so many pairs.
    pub(crate) fn new<Column>(nodes: &[Node<Column>], n_pairs: usize) -> Self {
        let mut floors: Vec<Floor> = Vec::with_capacity(nodes.len());
        for (index, node) in nodes.iter().enumerate() {
            let below = node.support.below();
            floors.push(Floor {
                base: below.map_or(index, |below| floors[below].base),
                place: 0,
                inverse_mass: node.inverse_mass,
                weight: node.inverse_mass.sqrt(),
            });
        }
        let mut order: Vec<_> = (0..floors.len()).collect();
        order.sort_by_key(|floor| (floors[*floor].base, *floor));
        for (place, floor) in order.into_iter().enumerate() {
            floors[floor].place = place;
        }
        Self {
            touching: Vec::with_capacity(n_pairs),
            impulses: Vec::with_capacity(n_pairs),
            net: vec![0.0; floors.len()],
            problem: Complementarity::new(n_pairs, floors.len()),
            floors,
        }
    }

    /// Forgets the pairs.
    pub(crate) fn clear(&mut self) {
        self.touching.clear();
        self.impulses.clear();
    }

    /// Takes a pair, by its index in the row.
    pub(crate) fn push(&mut self, pair: (usize, Relation), touching: Touching<f64>) {
        self.touching.push((pair.0, pair.1, touching));
        self.impulses.push(0.0);
    }

    /// The pairs taken, each with its impulse \[N·s\].
    pub(crate) fn struck(&self) -> impl Iterator<Item = (usize, f64)> {
        let pairs = self.touching.iter().map(|(pair, ..)| *pair);
        pairs.zip(self.impulses.iter().copied())
    }

    /// Lets the velocities \[m/s\] of all floors jump until no pair approaches that touches; false when none does.
    ///
    /// Errors with a pair that walls on both sides leave no impulse.
    pub(crate) fn strike_all(&mut self, velocities: &mut [f64]) -> Result<bool, usize> {
        for (_, relation, touching) in &mut self.touching {
            let speeds = relation
                .pushes()
                .map(|(floor, part)| (part * velocities[floor]).abs());
            touching.speeds += speeds.sum::<f64>();
        }
        let mut round = 0;
        while round <= MAX_ROUNDS && self.approaches(velocities) {
            if round == 0 {
                self.list();
            }
            self.ask(velocities, round == MAX_ROUNDS);
            let solved = self.problem.solve();
            solved.map_err(|ClosedIn { contact }| self.touching[contact].0)?;
            self.strike(velocities);
            round += 1;
        }
        Ok(round > 0)
    }

    /// Whether a pair approaches beyond rounding.
    fn approaches(&self, velocities: &[f64]) -> bool {
        let approaches = |(_, relation, touching): &(usize, Relation, Touching<f64>)| {
            rate(relation, touching, velocities) > ROUNDING * touching.speeds
        };
        self.touching.iter().any(approaches)
    }

    /// Gives the problem the columns of all pairs.
    fn list(&mut self) {
        let floors = &self.floors;
        let bases = self.touching.iter().flat_map(|(_, relation, _)| {
            let floors_of = relation.points().map(Point::floor);
            floors_of.map(|floor| floors[floor].base)
        });
        // The leftmost building is summed apart: of two buildings, mirrored ones then give mirrored bits.
        let first = bases.min().unwrap_or(0);
        let split = floors.iter().filter(|floor| floor.base <= first);
        self.problem.begin(floors.len(), split.count());
        for (_, relation, _) in &self.touching {
            let column = relation
                .pushes()
                .map(|(floor, part)| (floors[floor].place, part * floors[floor].weight));
            self.problem.push(column);
        }
    }

    /// Asks what each pair has to lose in a round.
    fn ask(&mut self, velocities: &[f64], is_last: bool) {
        for (contact, (_, relation, touching)) in self.touching.iter().enumerate() {
            let rate = rate(relation, touching, velocities);
            let demand = if is_last {
                rate
            } else if rate < 0.0 {
                f64::NEG_INFINITY
            } else {
                touching.factor * rate
            };
            let scale = touching.factor * touching.speeds;
            self.problem.ask(contact, demand, scale);
        }
    }

    /// Changes the velocities by the impulses of a round.
    fn strike(&mut self, velocities: &mut [f64]) {
        self.net.fill(0.0);
        let all = self.impulses.iter_mut().zip(self.problem.impulses());
        for ((sum, impulse), (_, relation, _)) in all.zip(&self.touching) {
            *sum += impulse;
            relation.spread(impulse, |floor, impulse| self.net[floor] += impulse);
        }
        for ((velocity, net), floor) in velocities.iter_mut().zip(&self.net).zip(&self.floors) {
            *velocity += floor.inverse_mass * net;
        }
    }
}

/// Rate of deformation of a pair \[m/s\], positive while approaching.
fn rate(relation: &Relation, touching: &Touching<f64>, velocities: &[f64]) -> f64 {
    relation.ahead(|floor| velocities[floor]) + touching.opening_rate
}
