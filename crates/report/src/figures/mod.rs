//! What a report shows: each picture as plain data, then as SVG and PNG.

mod blow;
mod displacements;
pub(crate) mod effects;
mod gaps;
mod ground;
mod hysteresis;
pub(crate) mod profiles;
mod shown;
mod thin;

use super::history::Motion;
use crate::PairSummary;
use pounding_assess::Effects;
use pounding_plot::{Curve, Figure, PlotError, minus, render_both, writable};
use pounding_scene::{Floor, Floors, RunResult, Simulation};
use pounding_solver::Collision;
use pounding_text::digits;
use rayon::prelude::*;

use shown::Selection;

/// The names that pictures can have, without the ends of their files.
pub(super) const NAMES: [&str; 7] = [
    "profiles",
    "displacements",
    "gaps",
    "effects",
    "blow",
    "hysteresis",
    "ground-motion",
];

/// A picture of a report.
#[derive(Debug)]
pub(crate) struct Illustration {
    /// Its file, without the end.
    pub(crate) name: &'static str,
    /// What it shows, in sentences.
    pub(crate) caption: String,
    /// SVG and PNG, or why it cannot be drawn: the numbers of a run that was forced can be too large for paper.
    pub(crate) drawn: Result<(String, Vec<u8>), PlotError>,
}

impl Illustration {
    /// The files of pictures that could be drawn, by name.
    pub(crate) fn files(all: Vec<Self>) -> impl Iterator<Item = (String, Vec<u8>)> {
        let drawn = all.into_iter().filter_map(|one| Some((one.name, one.drawn.ok()?)));
        drawn.flat_map(|(name, (svg, png))| [(format!("{name}.svg"), svg.into_bytes()), (format!("{name}.png"), png)])
    }

    /// Whether one of these pictures can have a file of this name.
    pub(crate) fn has_file(pictures: &[&str], name: &str) -> bool {
        let is_one = |(stem, end): (&str, &str)| pictures.contains(&stem) && matches!(end, "svg" | "png");
        name.rsplit_once('.').is_some_and(is_one)
    }
}

/// Results of a scene besides its run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known<'a> {
    /// The effects of pounding on every storey.
    pub(super) effects: Option<&'a Effects>,
    /// The run in the other direction.
    pub(super) other: Option<&'a RunResult>,
}

/// All that pictures are made of.
#[derive(Debug, Clone, Copy)]
struct Seen<'a> {
    prepared: &'a Simulation,
    outcome: &'a RunResult,
    motion: Motion<'a>,
    shown: &'a Selection,
    /// Where axes of time end \[s\].
    until: f64,
    /// Whether they end soon after the last touch.
    ends_with_touches: bool,
}

/// Motion below this part of its largest value is at rest in pictures \[–\].
const AT_REST: f64 = 0.02;
/// An axis that would be shortened by less than a fifth goes to the end of the run.
const WORTH: f64 = 0.8;

/// The instant after which pictures have nothing to show: a storey collapses, or everything moves by less than 2 % of its largest motion
/// \[s\].
fn end_of_motion(motion: Motion<'_>, outcome: &RunResult) -> f64 {
    let prepared = motion.prepared;
    if let Some(collapse) = outcome.collapse {
        return collapse.time_s;
    }
    let ends = |values: &mut dyn Iterator<Item = f64>, interval: f64| {
        let values: Vec<f64> = values.collect();
        let last = values.last().copied().unwrap_or(0.0);
        let away = |value: &f64| (value - last).abs();
        let most = values.iter().map(away).fold(0.0, f64::max);
        let moves = values.iter().rposition(|value| away(value) > AT_REST * most);
        moves.map_or(0.0, |row| row as f64 * interval)
    };
    let floors = 0..prepared.floors().all().len();
    let of_floors = floors.map(|floor| ends(&mut motion.states(floor).iter().map(|state| state.displacement), motion.interval()));
    let record = prepared.record();
    let of_ground = ends(&mut record.samples().iter().copied(), record.time_step());
    let of_collisions = outcome.collisions.all().iter().map(|one| one.end);
    let end = of_floors.chain(of_collisions).fold(of_ground, f64::max);
    let end = (1.03 * end).ceil();
    if end < WORTH * prepared.duration() {
        end
    } else {
        prepared.duration()
    }
}

impl<'a> Seen<'a> {
    /// A sentence about what the axes of time leave out; empty if they go to the end of the run.
    fn says_end(&self) -> String {
        let duration = self.prepared.duration();
        if let Some(collapse) = self.outcome.collapse {
            format!(" The run ends by a collapse, at {:.2} s.", collapse.time_s)
        } else if self.ends_with_touches {
            format!(" The axis ends soon after the last touch, the run at {} s.", digits(duration))
        } else if self.until < duration {
            format!(
                " From {} s to the end of the run, at {} s, everything moves by less than 2 % of its largest motion.",
                digits(self.until),
                digits(duration)
            )
        } else {
            String::new()
        }
    }

    /// The same with axes that end soon after the last touch, if that is much earlier.
    fn until_touched(&self) -> Self {
        let ends = self.outcome.collisions.all().iter().map(|one| one.end);
        let last = ends.reduce(f64::max).map(|last| (1.2 * last + 1.0).ceil());
        match last {
            Some(until) if until < WORTH * self.until => Self {
                until,
                ends_with_touches: true,
                ..*self
            },
            _ => *self,
        }
    }

    /// Collisions between these pairs.
    fn collisions<'p>(&self, pairs: &'p [usize]) -> impl Iterator<Item = &'p Collision>
    where
        'a: 'p,
    {
        let all = self.outcome.collisions.all().iter();
        all.filter(|one| pairs.contains(&one.pair))
    }

    /// A quantity of one structure over time.
    fn curve(&self, quantity: impl Fn(usize) -> f64) -> Vec<(f64, f64)> {
        let rows = (0..self.motion.len()).take_while(|row| self.motion.time(*row) <= self.until);
        thin::thinned(rows.map(|row| (self.motion.time(row), quantity(row))).collect())
    }
}

/// The pictures of a run; those that would show nothing are left out.
pub(super) fn illustrations(motion: Motion<'_>, outcome: &RunResult, pairs: &[PairSummary], known: Known<'_>) -> Vec<Illustration> {
    let prepared = motion.prepared;
    let seen = Seen {
        prepared,
        outcome,
        motion,
        shown: &Selection::of(prepared, pairs),
        until: end_of_motion(motion, outcome),
        ends_with_touches: false,
    };
    let close = seen.until_touched();
    let figures: [Option<(Figure, String)>; NAMES.len()] = [
        profiles::figure(prepared, outcome, known),
        Some(displacements::figure(&close)),
        gaps::figure(&close),
        known.effects.and_then(|all| effects::figure(all, prepared)),
        blow::figure(&seen),
        hysteresis::figure(&seen),
        Some(ground::figure(&seen)),
    ];
    NAMES
        .into_par_iter()
        .zip(figures)
        .filter_map(|(name, figure)| figure.map(|(figure, caption)| (name, figure, caption)))
        .map(|(name, figure, caption)| Illustration {
            name,
            caption,
            drawn: render_both(&figure),
        })
        .collect()
}

/// Height of a storey whose height nobody gives \[m\].
const STOREY: f64 = 3.0;

/// Height of a floor above the ground \[m\], for pictures: as if storeys without a height were 3 m high.
pub(crate) fn elevation(floors: &Floors, floor: usize) -> f64 {
    let one = &floors.all()[floor];
    let storeys = one.storey.unwrap_or(1);
    one.elevation_m.unwrap_or(STOREY * storeys as f64)
}

/// Longest name in a picture, in characters.
const LONGEST: usize = 28;

/// A name as a picture can write it: not too long, in the letters of its font.
fn name(floor: &Floor) -> String {
    fitting(&floor.name)
}

pub(crate) fn fitting(name: &str) -> String {
    let name = writable(name);
    if name.chars().count() <= LONGEST {
        return name;
    }
    name.chars().take(LONGEST - 1).chain(['…']).collect()
}

/// Name, and the period where the curve is the first of its building, for a legend; a wall stands for all of its levels.
fn named(prepared: &Simulation, index: usize, first: bool) -> String {
    let floor = &prepared.floors().all()[index];
    if floor.is_wall() {
        return fitting(prepared.scene().structures[floor.structure].name());
    }
    match floor.oscillation(prepared.scene()).filter(|_| first) {
        Some((period, _)) => format!("{} (T = {} s)", name(floor), brief(period, 3)),
        None => name(floor),
    }
}

/// A number with so many significant digits, without zeros at its end.
fn brief(value: f64, significant: usize) -> String {
    let rounded = format!("{value:.*e}", significant - 1);
    minus(&digits(rounded.parse().unwrap_or(value)))
}

/// What an axis shows of some values: all of them, with a margin in parts of their extent below and above.
fn around(values: impl Iterator<Item = f64>, below: f64, above: f64) -> Option<(f64, f64)> {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    let extent = high - low;
    (extent > 0.0).then_some((low - below * extent, high + above * extent))
}

/// The values of all points of some curves.
fn heights(curves: &[Curve]) -> impl Iterator<Item = f64> {
    let points = curves.iter().flat_map(|curve| &curve.points);
    points.map(|point| point.1)
}

/// A unit for an axis that reaches this magnitude, and its factor: of `N`, `kN` and `MN`, or of the same with seconds.
pub(crate) fn unit(largest: f64, of: &str) -> (String, f64) {
    let (prefix, factor) = if largest.abs() >= 2e6 {
        ("M", 1e-6)
    } else if largest.abs() >= 2e3 {
        ("k", 1e-3)
    } else {
        ("", 1.0)
    };
    (format!("{prefix}{of}"), factor)
}
