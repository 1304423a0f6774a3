//! Implausible values of a scene: far from those of buildings and earthquakes, but possible.

mod motion;
mod row;
mod storeys;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use serde::{Deserialize, Serialize};

use crate::{Building, Sdof, Simulation, Structure};
use motion::Shaking;
use pounding_text::digits;

/// An implausible value that can still be modelled.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Implausible {
    /// The field, for example `structures[1].sdof.mass_kg`.
    pub place: String,
    /// Found value, in words.
    pub found: String,
    /// Usual values, in words.
    pub usual: String,
    /// Distance from usual values: the logarithm of a ratio \[–\], negative below them. The worst value of a kind is the one with the
    /// largest magnitude.
    #[serde(skip)]
    far: f64,
}

/// Compares the words only: `far` is not part of a file.
impl PartialEq for Implausible {
    fn eq(&self, other: &Self) -> bool {
        let words = [
            (&self.place, &other.place),
            (&self.found, &other.found),
            (&self.usual, &other.usual),
        ];
        words.iter().all(|(one, other)| one == other)
    }
}

impl fmt::Display for Implausible {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, found, usual, .. } = self;
        write!(formatter, "{place}: found {found}, usual is {usual}")
    }
}

/// Place of implausible values of the ground motion.
const RECORD: &str = "record";

/// Implausible values of one kind, in one place or several.
struct DoubtKind<'d> {
    /// Places, or names of ground motions.
    places: BTreeSet<&'d str>,
    worst: &'d Implausible,
    /// Place of the worst value, or the name of its motion.
    at: &'d str,
    differ: bool,
}

impl Implausible {
    /// Usual factors on a record \[–\]. The duration and the shape of a record with another factor belong to other shaking.
    pub const USUAL_FACTORS: [f64; 2] = [0.25, 4.0];

    /// Whether it concerns the row: its structures, their contacts or the arrivals of the motion, and not the motion itself.
    pub fn is_of_row(&self) -> bool {
        ["structures", "contacts", "arrivals_s"]
            .iter()
            .any(|field| self.place.starts_with(field))
    }

    /// Gathers implausible values, one for each kind: the worst value, and the number of places or of ground motions. Every value comes
    /// with the name of its motion, which is empty if there is only one.
    pub fn gathered<'d>(all: impl IntoIterator<Item = (&'d str, &'d Self)>) -> Vec<Self> {
        let mut kinds: Vec<DoubtKind<'d>> = Vec::new();
        for (motion, one) in all {
            let is_named = one.place == RECORD && !motion.is_empty();
            let place = if is_named { motion } else { &one.place };
            let alike = |other: &&mut DoubtKind<'d>| {
                other.worst.usual == one.usual
                    && other.worst.far.is_sign_negative() == one.far.is_sign_negative()
                    && (other.worst.place == RECORD) == (one.place == RECORD)
            };
            let Some(kind) = kinds.iter_mut().find(alike) else {
                kinds.push(DoubtKind {
                    places: BTreeSet::from([place]),
                    worst: one,
                    at: place,
                    differ: false,
                });
                continue;
            };
            kind.differ |= kind.worst.found != one.found;
            kind.places.insert(place);
            if one.far.abs() > kind.worst.far.abs() {
                (kind.worst, kind.at) = (one, place);
            }
        }
        kinds.iter().map(DoubtKind::said).collect()
    }

    /// Gathers implausible values in sentences.
    pub fn lines<'d>(all: impl IntoIterator<Item = (&'d str, &'d Self)>) -> Vec<String> {
        let gathered = Self::gathered(all);
        gathered.iter().map(ToString::to_string).collect()
    }
}

impl DoubtKind<'_> {
    fn said(&self) -> Implausible {
        let (first, n) = (self.at, self.places.len());
        let (is_motion, worst) = (first != self.worst.place, self.worst);
        let place = match (n, is_motion) {
            (1, _) => first.into(),
            (_, true) if worst.far == 0.0 => format!("{n} motions, the first {first}"),
            (_, true) => format!("{n} motions, the farthest off {first}"),
            (_, false) => format!("{first} and {} more", n - 1),
        };
        let at_worst = if n > 1 && self.differ && !is_motion && worst.far.abs() > 0.0 {
            " at worst"
        } else {
            ""
        };
        Implausible {
            place,
            found: format!("{}{at_worst}", worst.found),
            ..worst.clone()
        }
    }
}

/// Implausible values that are found one after another.
#[derive(Default)]
struct Doubts(Vec<Implausible>);

impl Doubts {
    /// Notes a value that is not `usual`, with what was `found` and what is `allowed`, in words.
    fn unless(&mut self, usual: bool, place: impl Into<String>, found: String, allowed: &'static str) {
        self.unless_far(usual, 1.0, place, found, allowed);
    }

    /// Notes a value that is not `usual`, and how `far` it is from what is usual \[–\]: a ratio, 1 if no value is farther than another.
    fn unless_far(&mut self, usual: bool, far: f64, place: impl Into<String>, found: String, allowed: &'static str) {
        if !usual {
            self.0.push(Implausible {
                place: place.into(),
                found,
                usual: allowed.into(),
                far: libm::log(far),
            });
        }
    }
}

impl Simulation {
    /// Finds the implausible values of the scene and its record.
    pub fn doubts(&self) -> Vec<Implausible> {
        let mut doubts = Doubts::default();
        self.doubt_the_record(&mut doubts);
        let scene = self.scene();
        let mut firsts = BTreeMap::new();
        for (index, structure) in scene.structures.iter().enumerate() {
            let name = structure.name();
            let first = *firsts.entry(name).or_insert(index);
            let kind = match structure {
                Structure::Sdof(sdof) => {
                    doubt_a_structure(index, sdof, &mut doubts);
                    "sdof"
                }
                Structure::Building(building) => {
                    doubt_a_building(index, building, &mut doubts);
                    "building"
                }
                Structure::Wall => continue,
            };
            doubts.unless(
                first == index,
                format!("structures[{index}].{kind}.name"),
                format!("\"{name}\", as structures[{first}] is called"),
                "names that differ, by which results tell structures",
            );
        }
        row::doubt(self, &mut doubts);
        doubts.0
    }

    fn doubt_the_record(&self, doubts: &mut Doubts) {
        let (scene, record) = (self.scene(), self.record());
        Shaking {
            used: &scene.record,
            record,
            scale: self.scale(),
            origin: self.origin(),
        }
        .doubt(doubts);
        let shortest = scene.structures.iter().filter_map(Structure::period);
        let shortest = shortest.fold(f64::INFINITY, f64::min);
        let step = record.time_step();
        doubts.unless(
            step <= 0.2 * shortest,
            RECORD,
            format!("samples {} s apart for a structure of period {} s", digits(step), digits(shortest)),
            "five and more in a period",
        );
        doubts.unless(
            self.duration() >= record.duration() * (1.0 - 1e-9),
            "duration_s",
            format!("{} s of a record of {} s", digits(self.duration()), digits(record.duration())),
            "the whole record",
        );
    }
}

fn doubt_a_building(index: usize, building: &Building, doubts: &mut Doubts) {
    let place = |field: &str| format!("structures[{index}].building{field}");
    storeys::doubt(index, building, doubts);
    for (storey, one) in building.storeys.iter().enumerate() {
        doubts.unless_far(
            (1e4..=1e9).contains(&one.mass_kg),
            one.mass_kg / 1e6,
            place(&format!(".storeys[{storey}].mass_kg")),
            format!("{} kg", digits(one.mass_kg)),
            "1e4 to 1e9 kg for a floor",
        );
    }
    let modes = building.modes();
    if let Some(first) = modes.first() {
        doubts.unless(
            (0.03..=10.0).contains(&first.period()),
            place(""),
            format!("a first period of {} s", digits(first.period())),
            "0.03 to 10 s",
        );
    }
    let most = modes.iter().map(|mode| mode.damping_ratio);
    let most = most.fold(0.0, f64::max);
    doubts.unless_far(
        most <= 0.3,
        most / 0.3,
        place(".damping"),
        format!("a damping ratio of {} in some mode", digits(most)),
        "up to 0.3; 0.05 is 5 %",
    );
}

fn doubt_a_structure(index: usize, sdof: &Sdof, doubts: &mut Doubts) {
    let place = |field: &str| format!("structures[{index}].sdof.{field}");
    let (mass, period, ratio) = (sdof.mass_kg, sdof.period(), sdof.damping_ratio());
    doubts.unless_far(
        (1e4..=1e9).contains(&mass),
        mass / 1e6,
        place("mass_kg"),
        format!("{} kg", digits(mass)),
        "1e4 to 1e9 kg for a building",
    );
    doubts.unless_far(
        (0.03..=10.0).contains(&period),
        period,
        format!("structures[{index}].sdof"),
        format!(
            "a period of {} s, as `period_s` or `mass_kg` and `stiffness_n_per_m` say",
            digits(period)
        ),
        "0.03 to 10 s",
    );
    if let Some(height) = sdof.height_m {
        doubts.unless(
            (0.2..=500.0).contains(&height),
            place("height_m"),
            format!("{} m", digits(height)),
            "0.2 to 500 m, of the mass over the ground",
        );
    }
    storeys::doubt_the_start(place, sdof.initial_displacement_m, sdof.initial_velocity_m_per_s, doubts);
    storeys::doubt_the_yielding(&place("yield_drift_ratio"), &sdof.columns(), sdof.height_m, doubts);
    doubts.unless_far(
        ratio <= 0.3,
        ratio / 0.3,
        place("damping"),
        format!("a damping ratio of {}, which is {} %", digits(ratio), digits(100.0 * ratio)),
        "up to 0.3; 0.05 is 5 %",
    );
}
