//! Incidence of pairs and floors.

use std::ops::Range;

use crate::Relation;

/// A pair at a floor that carries a point of the pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Incident {
    pub(crate) pair: usize,
    /// Whether the floor carries the left point, and is pushed to the left.
    pub(crate) on_left: bool,
    /// Part of the pair's force that the floor carries \[–\].
    pub(crate) part: f64,
}

/// The pairs at every floor, and the floors of every pair; or the same of links.
///
/// A slot is a combination of both: a floor that carries a point of a pair.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Incidence {
    /// Incidents slot by slot, floor after floor.
    incidents: Vec<Incident>,
    /// First slot of each floor, and the end of the last ones.
    of_floor: Vec<usize>,
    /// The slots of the pairs: floors of the left point, then of the right point, each with the nearer floor first.
    slots: Vec<usize>,
    /// First slot of each pair, and the end of the last ones.
    of_pair: Vec<usize>,
}

impl Incidence {
    /// Finds the incidence of other floors and pairs, with reuse of memory.
    pub(crate) fn renew(&mut self, n_floors: usize, relations: impl Iterator<Item = Relation> + Clone) {
        let Self {
            incidents,
            of_floor,
            slots,
            of_pair,
        } = self;
        of_floor.clear();
        of_floor.resize(n_floors + 1, 0);
        let (mut n_slots, parts) = (0, |relation: Relation| {
            let left = relation.left.parts().map(|part| (true, part));
            left.chain(relation.right.parts().map(|part| (false, part)))
        });
        for (_, (floor, _)) in relations.clone().flat_map(parts) {
            of_floor[floor + 1] += 1;
            n_slots += 1;
        }
        for floor in 0..n_floors {
            of_floor[floor + 1] += of_floor[floor];
        }
        let nobody = Incident {
            pair: 0,
            on_left: false,
            part: 0.0,
        };
        incidents.clear();
        incidents.resize(n_slots, nobody);
        slots.clear();
        of_pair.clear();
        of_pair.push(0);
        for (index, relation) in relations.enumerate() {
            for (on_left, (floor, part)) in parts(relation) {
                // Filling moves the start of the floor, which is restored below.
                let slot = of_floor[floor];
                of_floor[floor] += 1;
                incidents[slot] = Incident {
                    pair: index,
                    on_left,
                    part,
                };
                slots.push(slot);
            }
            of_pair.push(slots.len());
        }
        of_floor.rotate_right(1);
        of_floor[0] = 0;
    }

    /// The slots of a floor.
    #[inline]
    pub(crate) fn slots_at(&self, floor: usize) -> Range<usize> {
        self.of_floor[floor]..self.of_floor[floor + 1]
    }

    /// The pairs at a floor.
    #[inline]
    pub(crate) fn at(&self, floor: usize) -> &[Incident] {
        &self.incidents[self.slots_at(floor)]
    }

    /// The slots of a pair.
    #[inline]
    pub(crate) fn slots_of(&self, pair: usize) -> &[usize] {
        &self.slots[self.of_pair[pair]..self.of_pair[pair + 1]]
    }

    /// All incidents, slot by slot.
    pub(crate) fn incidents(&self) -> &[Incident] {
        &self.incidents
    }
}
