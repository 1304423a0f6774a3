//! What looks wrong in a scene that could be right: values far from those of buildings and earthquakes.

mod row;
mod storeys;

use std::collections::BTreeMap;
use std::fmt;

use pounding_motion::{Direction, Unusual};
use serde::{Deserialize, Serialize};

use crate::{Building, Sdof, Simulation, Structure};
use pounding_text::{digits, short};

/// Factors outside this range are far for a record: its duration and shape belong to another shaking \[–\].
pub const USUAL_FACTORS: [f64; 2] = [0.25, 4.0];

/// A value that looks wrong, though it can be modelled.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Implausible {
    /// The field, for example `structures[1].sdof.mass_kg`.
    pub place: String,
    /// What was found, in words.
    pub found: String,
    /// What is usual, in words.
    pub usual: String,
}

impl fmt::Display for Implausible {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            place,
            found,
            usual,
        } = self;
        write!(formatter, "{place}: found {found}, usual is {usual}")
    }
}

impl Implausible {
    /// A line each, of those that say the same of several places one.
    pub fn lines(all: &[Self]) -> Vec<String> {
        let mut groups: Vec<(&Self, usize)> = Vec::new();
        let mut known = BTreeMap::new();
        for one in all {
            let group = *known
                .entry((&one.found, &one.usual))
                .or_insert(groups.len());
            match groups.get_mut(group) {
                Some((_, count)) => *count += 1,
                None => groups.push((one, 1)),
            }
        }
        let line = |(one, count): (&Self, usize)| match count {
            1 => one.to_string(),
            _ => format!(
                "{} and {} more: found {}, usual is {}",
                one.place,
                count - 1,
                one.found,
                one.usual
            ),
        };
        groups.into_iter().map(line).collect()
    }
}

/// Doubts on their way into a list.
#[derive(Default)]
struct Doubts(Vec<Implausible>);

impl Doubts {
    fn unless(&mut self, usual: bool, place: impl Into<String>, words: (String, &'static str)) {
        if !usual {
            let (found, usual) = words;
            let (place, usual) = (place.into(), usual.into());
            self.0.push(Implausible {
                place,
                found,
                usual,
            });
        }
    }
}

impl Simulation {
    /// What looks wrong.
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
                (
                    format!("\"{name}\", as structures[{first}] is called"),
                    "names that differ, by which results tell structures",
                ),
            );
        }
        row::doubt(self, &mut doubts);
        doubts.0
    }

    fn doubt_the_record(&self, doubts: &mut Doubts) {
        let (scene, record) = (self.scene(), self.record());
        let gravity = scene.record.gravity_m_per_s2;
        doubts.unless(
            (9.7..=9.9).contains(&gravity),
            "record.gravity_m_per_s2",
            (digits(gravity), "9.78 to 9.83 m/s²"),
        );
        let is_large = self.doubt_the_file(doubts);
        let peak = record.peak().1.abs();
        doubts.unless(
            (0.01..=30.0).contains(&peak) || is_large,
            "record",
            (
                format!("a peak of {} m/s²", digits(peak)),
                "0.01 to 30 m/s²; its unit and scale decide it",
            ),
        );
        let factor = self.scale();
        doubts.unless(
            (USUAL_FACTORS[0]..=USUAL_FACTORS[1]).contains(&factor) || self.origin().is_none(),
            "record",
            (
                format!("a scale factor of {}", short(factor)),
                "0.25 to 4: a record that needs more belongs to another earthquake",
            ),
        );
        self.doubt_the_baseline(doubts);
        let shortest = scene.structures.iter().filter_map(Structure::period);
        let shortest = shortest.fold(f64::INFINITY, f64::min);
        let step = record.time_step();
        doubts.unless(
            step <= 0.2 * shortest,
            "record",
            (
                format!(
                    "samples {} s apart for a structure of period {} s",
                    digits(step),
                    digits(shortest)
                ),
                "five and more in a period",
            ),
        );
        doubts.unless(
            self.duration() >= record.duration() * (1.0 - 1e-9),
            "duration_s",
            (
                format!(
                    "{} s of a record of {} s",
                    digits(self.duration()),
                    digits(record.duration())
                ),
                "the whole record",
            ),
        );
    }

    /// What looks wrong in the file of the record, or lies upright; whether its peak is too large.
    fn doubt_the_file(&self, doubts: &mut Doubts) -> bool {
        let Some(origin) = self.origin() else {
            return false;
        };
        let unusual = origin.file.unusual();
        for one in unusual {
            doubts.unless(false, "record", (one.found(), one.usual()));
        }
        let is_vertical = origin.file.direction() == Some(Direction::Vertical);
        let component = origin.file.component().unwrap_or_default();
        doubts.unless(
            !is_vertical,
            "record",
            (
                format!("the vertical component \"{component}\""),
                "a horizontal one: the ground of a row moves sideways",
            ),
        );
        unusual
            .iter()
            .any(|one| matches!(one, Unusual::Peak { .. }))
    }

    /// Of a record alone: a formula may leave the ground moving on purpose.
    fn doubt_the_baseline(&self, doubts: &mut Doubts) {
        let drift = self.record().drift().filter(|_| self.origin().is_some());
        let said = drift.map_or_else(String::new, |drift| {
            format!(
                "a ground that does not come to rest: its mean velocity over the last tenth is {} m/s, {} % of the peak",
                short(drift.velocity.abs()),
                short(1e2 * drift.share)
            )
        });
        doubts.unless(
            drift.is_none(),
            "record",
            (
                said,
                "up to 10 %; an offset of the baseline goes with record.detrend = \"linear\" or record.band_pass",
            ),
        );
    }
}

fn doubt_a_building(index: usize, building: &Building, doubts: &mut Doubts) {
    let place = |field: &str| format!("structures[{index}].building{field}");
    storeys::doubt(index, building, doubts);
    for (storey, one) in building.storeys.iter().enumerate() {
        doubts.unless(
            (1e3..=1e9).contains(&one.mass_kg),
            place(&format!(".storeys[{storey}].mass_kg")),
            (
                format!("{} kg", digits(one.mass_kg)),
                "1e3 to 1e9 kg for a floor",
            ),
        );
    }
    let modes = building.modes();
    if let Some(first) = modes.first() {
        doubts.unless(
            (0.03..=10.0).contains(&first.period()),
            place(""),
            (
                format!("a first period of {} s", digits(first.period())),
                "0.03 to 10 s",
            ),
        );
    }
    let most = modes.iter().map(|mode| mode.damping_ratio);
    let most = most.fold(0.0, f64::max);
    doubts.unless(
        most <= 0.3,
        place(".damping"),
        (
            format!("a damping ratio of {} in some mode", digits(most)),
            "up to 0.3; 0.05 is 5 %",
        ),
    );
}

fn doubt_a_structure(index: usize, sdof: &Sdof, doubts: &mut Doubts) {
    let place = |field: &str| format!("structures[{index}].sdof.{field}");
    let (mass, period, ratio) = (sdof.mass_kg, sdof.period(), sdof.damping_ratio());
    doubts.unless(
        (1e3..=1e9).contains(&mass),
        place("mass_kg"),
        (
            format!("{} kg", digits(mass)),
            "1e3 to 1e9 kg for a building",
        ),
    );
    doubts.unless(
        (0.03..=10.0).contains(&period),
        format!("structures[{index}].sdof"),
        (
            format!(
                "a period of {} s, as `period_s` or `mass_kg` and `stiffness_n_per_m` say",
                digits(period)
            ),
            "0.03 to 10 s",
        ),
    );
    if let Some(height) = sdof.height_m {
        doubts.unless(
            (0.2..=500.0).contains(&height),
            place("height_m"),
            (
                format!("{} m", digits(height)),
                "0.2 to 500 m, of the mass over the ground",
            ),
        );
    }
    let start = [sdof.initial_displacement_m, sdof.initial_velocity_m_per_s];
    storeys::doubt_the_start(place, start, doubts);
    storeys::doubt_the_yielding(
        &place("yield_drift_ratio"),
        &sdof.columns(),
        sdof.height_m,
        doubts,
    );
    doubts.unless(
        ratio <= 0.3,
        place("damping"),
        (
            format!(
                "a damping ratio of {}, which is {} %",
                digits(ratio),
                digits(100.0 * ratio)
            ),
            "up to 0.3; 0.05 is 5 %",
        ),
    );
}
