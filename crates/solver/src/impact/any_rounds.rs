//! Rounds of impulses between touching pairs that are no chain: several pairs on a side of a floor, points between floors.
//!
//! The rule is that of `rounds.rs`: pairs that do not separate lose at least (1+e) of their approach r; pairs that separate stay out.
//! Rounds repeat while a pair approaches. The last rounds are plastic and include all pairs. Each round solves 0 ≤ W P − (1 + e) r ⟂ P ≥ 0,
//! a problem of [`Complementarity`].

use crate::impact::dense::{ClosedIn, Complementarity, ROUNDING};
use crate::impact::rounds::MAX_ROUNDS;
use crate::{Point, Relation, RestoringForce, Row};

/// A pair that touches.
#[derive(Debug, Clone, Copy)]
pub struct Closed {
    /// Rate of deformation \[m/s\], positive while approaching. A rate within rounding counts as 0.
    pub(crate) rate: f64,
    /// Coefficient of restitution e \[–\].
    pub(crate) restitution: f64,
    /// Whether the pair passes on a hit if it neither approaches nor separates.
    pub(crate) passes_on: bool,
    /// Magnitude of the velocities whose rounding the rate has \[m/s\].
    pub(crate) scale: f64,
    /// Impulse of all rounds \[N·s\].
    pub(crate) impulse: f64,
}

impl Closed {
    /// A pair whose grounds do not move relative to each other, with a coefficient of restitution \[–\].
    pub fn on_one_ground(restitution: f64) -> Self {
        Self {
            rate: 0.0,
            restitution,
            passes_on: true,
            scale: 0.0,
            impulse: 0.0,
        }
    }
}

/// The pairs that touch at an instant, and scratch.
pub(crate) struct AnyRounds {
    pub(crate) pairs: Vec<Closed>,
    pub(crate) problem: Complementarity,
    /// Which pairs take part in a round.
    parts: Vec<bool>,
}

impl AnyRounds {
    /// Scratch for at most `n_pairs` pairs in a row of `n_floors` floors.
    pub(crate) fn new(n_pairs: usize, n_floors: usize) -> Self {
        Self {
            pairs: Vec::with_capacity(n_pairs),
            problem: Complementarity::new(n_pairs, n_floors),
            parts: Vec::with_capacity(n_pairs),
        }
    }

    /// Gives impulses until no pair approaches; false if none did. With `alone` each pair is treated alone, from first to last. The problem
    /// already has the columns.
    ///
    /// The error is the place of a pair that walls on both sides leave no impulse, which is possible if grounds move towards each other
    /// (`opens`). Otherwise only rounding leads there, and the pair is left out. `look` may end the rounds.
    pub(crate) fn collide<E>(&mut self, alone: bool, opens: bool, look: impl Fn() -> Result<(), E>) -> Result<Result<bool, ClosedIn>, E> {
        let mut round = 0;
        while self.approaches() {
            let plastic = round >= MAX_ROUNDS;
            let alone = alone && !plastic;
            for only in 0..if alone { self.pairs.len() } else { 1 } {
                look()?;
                self.choose(plastic, alone.then_some(only));
                if let Err(closed_in) = self.strike(plastic, opens) {
                    return Ok(Err(closed_in));
                }
            }
            if round >= 2 * MAX_ROUNDS {
                // Only rounding is left.
                for pair in &mut self.pairs {
                    pair.rate = pair.rate.min(0.0);
                }
            }
            round += 1;
        }
        Ok(Ok(round > 0))
    }

    /// Whether a pair approaches by more than rounding.
    fn approaches(&mut self) -> bool {
        for pair in &mut self.pairs {
            if pair.rate > 0.0 && pair.rate <= ROUNDING * pair.scale {
                pair.rate = 0.0;
            }
        }
        self.pairs.iter().any(|pair| pair.rate > 0.0)
    }

    /// Chooses the pairs that take part in a round.
    fn choose(&mut self, plastic: bool, only: Option<usize>) {
        let takes_part = |(index, pair): (usize, &Closed)| match only {
            Some(only) => index == only && pair.rate > 0.0,
            None => plastic || pair.rate > 0.0 || (pair.rate >= 0.0 && pair.passes_on),
        };
        self.parts.clear();
        self.parts.extend(self.pairs.iter().enumerate().map(takes_part));
    }

    /// Applies the impulses of a round.
    fn strike(&mut self, plastic: bool, opens: bool) -> Result<(), ClosedIn> {
        let restitution = |pair: &Closed| if plastic { 0.0 } else { pair.restitution };
        for (index, pair) in self.pairs.iter().enumerate() {
            let wanted = (1.0 + restitution(pair)) * pair.rate;
            let demand = if self.parts[index] { wanted } else { f64::NEG_INFINITY };
            self.problem.ask(index, demand, pair.scale);
        }
        while let Err(closed_in) = self.problem.solve() {
            let contact = closed_in.contact;
            if opens {
                return Err(closed_in);
            }
            self.problem.ask(contact, f64::NEG_INFINITY, 0.0);
            self.parts[contact] = false;
            self.pairs[contact].rate = 0.0;
        }
        for (index, impulse) in self.problem.impulses().enumerate() {
            let pair = &mut self.pairs[index];
            let kept = pair.rate - self.problem.taken(index);
            let returned = -restitution(pair) * pair.rate;
            pair.rate = match self.parts[index] {
                true if impulse > 0.0 => returned,
                true => kept.min(returned),
                false => kept,
            };
            pair.impulse += impulse;
        }
        Ok(())
    }
}

/// The rounds of a stepping method, from the velocities of all floors.
#[expect(missing_debug_implementations, reason = "scratch")]
pub struct Jumps {
    floors: Vec<Floor>,
    touching: Vec<(usize, Relation)>,
    /// Whether grounds move under a pair.
    opens: bool,
    /// Net impulse on every floor \[N·s\].
    net: Vec<f64>,
    rounds: AnyRounds,
}

/// A floor of the row.
struct Floor {
    building: usize,
    /// Its row in the columns of the problem: floors are listed building by building.
    place: usize,
    inverse_mass: f64,
    /// Square root of the inverse mass.
    weight: f64,
}

impl Jumps {
    /// Rounds for the pairs of a row.
    pub fn new<Column: RestoringForce>(row: &Row<Column>) -> Self {
        let (buildings, n_pairs) = (row.buildings(), row.pairs().len());
        let floor = |(index, node): (usize, &crate::Node<Column>)| Floor {
            building: buildings.of(index),
            place: 0,
            inverse_mass: node.inverse_mass,
            weight: node.inverse_mass.sqrt(),
        };
        let mut floors: Vec<_> = row.nodes().iter().enumerate().map(floor).collect();
        for (place, floor) in buildings.all().iter().enumerate() {
            floors[*floor].place = place;
        }
        Self {
            touching: Vec::with_capacity(n_pairs),
            opens: false,
            net: vec![0.0; floors.len()],
            rounds: AnyRounds::new(n_pairs, floors.len()),
            floors,
        }
    }

    /// Forgets the pairs.
    pub fn clear(&mut self) {
        self.touching.clear();
        self.rounds.pairs.clear();
        self.opens = false;
    }

    /// Adds a pair by its index in the row. `rate` and `scale` are those of the grounds under it.
    pub fn push(&mut self, pair: usize, relation: Relation, closed: Closed) {
        self.touching.push((pair, relation));
        self.rounds.pairs.push(closed);
        self.opens |= closed.rate != 0.0;
    }

    /// The pairs, each with its impulse \[N·s\].
    pub fn struck(&self) -> impl Iterator<Item = (usize, f64)> {
        let pairs = self.touching.iter().zip(&self.rounds.pairs);
        pairs.map(|((pair, _), closed)| (*pair, closed.impulse))
    }

    /// Applies jumps to the velocities \[m/s\] of all floors until no touching pair approaches; false if none did.
    ///
    /// # Errors
    /// A pair that walls on both sides leave no impulse.
    pub fn strike_all(&mut self, velocities: &mut [f64]) -> Result<bool, usize> {
        for ((_, relation), closed) in self.touching.iter().zip(&mut self.rounds.pairs) {
            let speeds = relation.pushes().map(|(floor, part)| (part * velocities[floor]).abs());
            closed.scale += speeds.sum::<f64>();
            closed.rate += relation.ahead(|floor| velocities[floor]);
            // Points at rest take part in impacts on them, even if rounding parts them.
            if closed.rate.abs() <= ROUNDING * closed.scale {
                closed.rate = 0.0;
            }
        }
        if !self.rounds.approaches() {
            return Ok(false);
        }
        self.list();
        let look = || Ok::<_, usize>(());
        let collided = self.rounds.collide(false, self.opens, look)?;
        collided.map_err(|ClosedIn { contact }| self.touching[contact].0)?;
        self.net.fill(0.0);
        for ((_, relation), closed) in self.touching.iter().zip(&self.rounds.pairs) {
            relation.spread(closed.impulse, |floor, impulse| self.net[floor] += impulse);
        }
        for ((velocity, net), floor) in velocities.iter_mut().zip(&self.net).zip(&self.floors) {
            *velocity += floor.inverse_mass * net;
        }
        Ok(true)
    }

    /// Gives the problem the columns of all pairs.
    fn list(&mut self) {
        let (floors, problem) = (&self.floors, &mut self.rounds.problem);
        let buildings = self.touching.iter().flat_map(|(_, relation)| {
            let floors_of = relation.points().map(Point::floor);
            floors_of.map(|floor| floors[floor].building)
        });
        // The leftmost building is summed separately, so that mirroring two buildings mirrors the bits.
        let first = buildings.min().unwrap_or(0);
        let split = floors.iter().filter(|floor| floor.building <= first);
        problem.begin(floors.len(), split.count());
        for (_, relation) in &self.touching {
            let column = relation
                .pushes()
                .map(|(floor, part)| (floors[floor].place, part * floors[floor].weight));
            problem.push(column);
        }
    }
}

#[cfg(test)]
mod tests {
    use pounding_contact::{ContactLaw, Stereomechanical};

    use super::*;
    use crate::{Elastic, Node, Pair};

    /// Two floors at rest against each other, separated only by rounding, were hit in sequence: the second got 0.75 N·s instead of 1.
    #[test]
    fn issue_rounding_does_not_keep_floors_at_rest_out_of_an_impact() {
        let law = |restitution| ContactLaw::Stereomechanical(Stereomechanical { restitution });
        let nodes = vec![Node::structure(1.0, 0.0, Elastic { stiffness: 1.0 }); 3];
        // The order of the pairs makes the row no chain.
        let pairs = vec![Pair::of_floors(1, 2, 0.0, law(0.5)), Pair::of_floors(0, 1, 0.0, law(0.0))];
        let row = Row::new(nodes, pairs).expect("a valid row");
        let mut jumps = Jumps::new(&row);
        for (index, pair) in row.pairs().iter().enumerate() {
            let law = pair.law.impulsive().expect("an impulsive law");
            jumps.push(index, pair.relation, Closed::on_one_ground(law.restitution));
        }
        let mut velocities = [1.0, 1.0 + f64::EPSILON, -1.0];
        assert_eq!(jumps.strike_all(&mut velocities), Ok(true));
        for (found, wanted) in velocities.into_iter().zip([0.0, 0.0, 1.0]) {
            assert!((found - wanted).abs() < 1e-12, "{velocities:?}");
        }
    }
}
