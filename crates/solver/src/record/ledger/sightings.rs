//! Bookkeeping of instants at which all floors of a building have been seen.

use crate::model::buildings::Buildings;

/// Last instants at which the floors of every building were seen.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sightings {
    all: Vec<Sighting>,
    /// Buildings whose floors were last seen at different instants.
    n_apart: usize,
}

/// Last instant at which a floor of a building was seen \[s\], and how many floors were seen then.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sighting {
    time: f64,
    n_seen: usize,
}

impl Sightings {
    /// The sightings at the start, when all floors have been seen.
    pub(super) fn new(buildings: &Buildings) -> Self {
        let whole = |floors: &[usize]| Sighting {
            time: 0.0,
            n_seen: floors.len(),
        };
        Self {
            all: buildings.each().map(whole).collect(),
            n_apart: 0,
        }
    }

    /// Notes that a floor was seen at the end of a span.
    #[inline]
    pub(super) fn see(&mut self, buildings: &Buildings, node: usize, time: f64) {
        if !buildings.are_single() {
            self.count(buildings, node, time);
        }
    }

    fn count(&mut self, buildings: &Buildings, node: usize, time: f64) {
        let building = buildings.of(node);
        let n_floors = buildings.floors(building).len();
        let sighting = &mut self.all[building];
        if time < sighting.time {
            return;
        }
        self.n_apart -= usize::from(sighting.n_seen < n_floors);
        if time > sighting.time {
            (sighting.time, sighting.n_seen) = (time, 0);
        }
        sighting.n_seen += 1;
        self.n_apart += usize::from(sighting.n_seen < n_floors);
    }

    /// Whether the floors of every building were last seen at a common instant of the building.
    pub(super) fn are_whole(&self) -> bool {
        self.n_apart == 0
    }
}
