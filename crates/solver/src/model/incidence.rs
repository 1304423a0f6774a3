//! Which pairs meet which floors.

use std::ops::Range;

use crate::Pair;

/// A pair at a floor that carries a point of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Incident {
    pub(crate) pair: usize,
    /// Whether the floor carries its left point, and is pushed to the left.
    pub(crate) on_left: bool,
    /// Part of the pair's force that it carries \[–\].
    pub(crate) part: f64,
}

/// The pairs at every floor, and the floors of every pair.
///
/// A slot is one of both: a floor that carries a point of a pair.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Incidence {
    /// Slot by slot, floor after floor.
    incidents: Vec<Incident>,
    /// Where the slots of each floor begin, and where the last ones end.
    of_floor: Vec<usize>,
    /// The slots of the pairs: of the floors that carry the left point, then the right one, each the nearer one first.
    slots: Vec<usize>,
    /// Where those of each pair begin, and where the last ones end.
    of_pair: Vec<usize>,
}

impl Incidence {
    /// Finds them anew, in the memory of the last ones.
    pub(crate) fn renew(&mut self, n_floors: usize, pairs: &[Pair]) {
        let Self {
            incidents,
            of_floor,
            slots,
            of_pair,
        } = self;
        of_floor.clear();
        of_floor.resize(n_floors + 1, 0);
        let (mut n_slots, parts) = (0, |pair: &Pair| {
            let relation = pair.relation;
            let left = relation.left.parts().map(|part| (true, part));
            left.chain(relation.right.parts().map(|part| (false, part)))
        });
        for (_, (floor, _)) in pairs.iter().flat_map(parts) {
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
        for (index, pair) in pairs.iter().enumerate() {
            for (on_left, (floor, part)) in parts(pair) {
                // Filled from its start on, which is put back below.
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

    /// All, slot by slot.
    pub(crate) fn incidents(&self) -> &[Incident] {
        &self.incidents
    }
}
