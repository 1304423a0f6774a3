//! An unknown neighbour, for which a file gives ranges.

use pounding_text::Refused;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::check::{NOT_NEGATIVE, POSITIVE, no_structures, require};
use super::{Building, Contact};
use crate::{Damping, Scene, Structure};

/// The neighbour to the right of the last structure, if it is unknown.
///
/// Only an assessment accepts it. It assesses many possible neighbours.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Neighbour {
    /// Ranges of the neighbour.
    pub unknown: UnknownNeighbour,
}

/// Ranges of an unknown neighbour, which is an elastic building of equal storeys.
///
/// The logarithms of the period and of the mass ratio are distributed uniformly and independently.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnknownNeighbour {
    /// First natural period \[s\], from and to, > 0.
    pub period_s: [f64; 2],
    /// Ratio of its mass to the mass of the last structure \[–\], from and to, > 0.
    pub mass_ratio: [f64; 2],
    /// Number of its storeys, 1 to 200; by default that of the last structure.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 200))]
    pub storeys: Option<usize>,
    /// Damping ratio \[–\], 0 to less than 1; 0.05 by default.
    #[serde(default = "five_per_cent")]
    pub damping_ratio: f64,
    /// Contact between it and the last structure; required if the scene has `contacts`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<Contact>,
    /// Number of neighbours that are drawn, 1 to 1000; 12 by default.
    #[serde(default = "twelve")]
    #[schemars(range(min = 1, max = 1000))]
    pub samples: usize,
}

fn five_per_cent() -> f64 {
    0.05
}

fn twelve() -> usize {
    12
}

/// Its field in a scene.
const PLACE: &str = "neighbour.unknown";

/// Largest numbers of storeys and of neighbours.
const MOST_STOREYS: usize = 200;
const MOST_SAMPLES: usize = 1000;

/// Step of the mass ratio from neighbour to neighbour, as a part of its range: the golden ratio less one. Its multiples are spread evenly
/// for any number of neighbours.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A possible neighbour.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DrawnNeighbour {
    /// First natural period \[s\].
    pub period_s: f64,
    /// Ratio of its mass to the mass of the structure beside it \[–\].
    pub mass_ratio: f64,
}

impl UnknownNeighbour {
    /// Draws neighbours spread evenly over both ranges: one in the middle of each of equal parts of the logarithm of the period, with mass
    /// ratios on a lattice.
    pub fn drawn(&self) -> Vec<DrawnNeighbour> {
        let between = |[from, to]: [f64; 2], share: f64| from * libm::pow(to / from, share);
        let n = self.samples as f64;
        let one = |index: usize| {
            let place = index as f64 + 0.5;
            DrawnNeighbour {
                period_s: between(self.period_s, place / n),
                mass_ratio: between(self.mass_ratio, (place * GOLDEN).fract()),
            }
        };
        (0..self.samples).map(one).collect()
    }

    fn check(&self) -> Result<(), Refused> {
        let ranges = [("period_s", self.period_s), ("mass_ratio", self.mass_ratio)];
        for (name, [from, to]) in ranges {
            let place = |end: usize| format!("{PLACE}.{name}[{end}]");
            require(from > 0.0 && from.is_finite(), place(0), from, POSITIVE)?;
            let allowed = "a finite number that is no less than the first";
            require(to >= from && to.is_finite(), place(1), to, allowed)?;
        }
        let damping = self.damping_ratio;
        let allowed = "a number >= 0 and < 1";
        let valid = (0.0..1.0).contains(&damping);
        require(valid, format_args!("{PLACE}.damping_ratio"), damping, allowed)?;
        let counts = [
            ("storeys", self.storeys.unwrap_or(1), MOST_STOREYS, "1 to 200"),
            ("samples", self.samples, MOST_SAMPLES, "1 to 1000"),
        ];
        for (name, found, most, allowed) in counts {
            let valid = (1..=most).contains(&found);
            require(valid, format_args!("{PLACE}.{name}"), found as f64, allowed)?;
        }
        Ok(())
    }

    /// Builds a drawn neighbour beside a structure; `None` beside a wall. Its storeys have the heights of that structure's storeys, and
    /// further storeys the height of its top storey.
    fn building(&self, drawn: DrawnNeighbour, beside: &Structure) -> Option<Building> {
        let (mass, heights) = match beside {
            Structure::Sdof(sdof) => (sdof.mass_kg, vec![sdof.height_m]),
            Structure::Building(building) => {
                let storeys = building.storeys.iter();
                (
                    storeys.clone().map(|storey| storey.mass_kg).sum(),
                    storeys.map(|storey| storey.height_m).collect(),
                )
            }
            Structure::Wall => return None,
        };
        let top = heights.last().copied().flatten();
        let heights: Vec<Option<f64>> = (0..self.storeys.unwrap_or(heights.len()))
            .map(|storey| heights.get(storey).copied().unwrap_or(top))
            .collect();
        let damping = Damping::Ratio(self.damping_ratio);
        Building::uniform(drawn.mass_ratio * mass, drawn.period_s, damping, &heights)
    }
}

fn contact_of_none(found: &'static str) -> Refused {
    let place = format!("{PLACE}.contact");
    let allowed = "one if the scene has `contacts` or has one structure, and none if it has none";
    let found = Refused::at(place).found(found).allowed_is(allowed);
    found.so(": ", "gaps are given for all neighbours or for no one")
}

impl Scene {
    /// Returns the scene with each possible neighbour; the scene itself if it has no unknown neighbour.
    ///
    /// # Errors
    /// [`Refused`] with the place of the field that does not fit.
    pub fn beside_neighbours(&self) -> Result<Vec<(Self, Option<DrawnNeighbour>)>, Refused> {
        let Some(Neighbour { unknown }) = &self.neighbour else {
            return Ok(vec![(self.clone(), None)]);
        };
        unknown.check()?;
        let known = Self {
            neighbour: None,
            ..self.clone()
        };
        let last = self.structures.last().ok_or_else(no_structures)?;
        let contacts = match (&self.contacts, &unknown.contact, self.structures.len()) {
            (None, None, _) => None,
            (Some(all), Some(one), _) => Some([&all[..], std::slice::from_ref(one)].concat()),
            (None, Some(one), 1) => Some(vec![one.clone()]),
            (None, Some(_), _) => return Err(contact_of_none("one")),
            (Some(_), None, _) => return Err(contact_of_none("none")),
        };
        if let Some(contact) = &unknown.contact {
            let gap = contact.gap_m;
            let place = format_args!("{PLACE}.contact.gap_m");
            require(gap >= 0.0, place, gap, NOT_NEGATIVE)?;
        }
        let beside = |drawn: DrawnNeighbour| {
            let building = unknown.building(drawn, last);
            let building = building.ok_or_else(|| {
                let wall = Refused::at(PLACE).found("a wall as the last of `structures`");
                wall.allowed_is("a structure that moves").so(
                    ": ",
                    "the mass of the neighbour is a multiple of its; or masses and periods so far from the usual that no building has them",
                )
            })?;
            let mut scene = known.clone();
            scene.structures.push(Structure::Building(building));
            scene.contacts.clone_from(&contacts);
            // The ground motion arrives at both at the same time.
            if let Some(arrivals) = &mut scene.arrivals_s {
                arrivals.extend(arrivals.last().copied());
            }
            Ok((scene, Some(drawn)))
        };
        unknown.drawn().into_iter().map(beside).collect()
    }
}
