//! What bumpers change over many runs.

use super::bumper::{Bumper, BumperRun};
use super::distribution::Distribution;
use super::peaks::FloorPeaks;
use super::run::AssessedRun;
use crate::Floors;

/// What bumpers change, over the runs in which something touches without them.
#[derive(Debug, Clone, PartialEq)]
pub struct BumperEffect {
    /// The bumpers.
    pub bumpers: Vec<Bumper>,
    /// Number of runs.
    pub runs: usize,
    /// Number of runs in which some bumper is compressed by more than its thickness: what is behind it then hits, which is left out.
    pub too_thin: usize,
    /// Force with a bumper over that without \[–\], of every pair and run in which both are known.
    pub force: Option<Distribution>,
    /// Peak drift with bumpers over that without \[–\], of every storey that moves, over the runs that hit its building.
    pub drift: Distribution,
    /// Peak absolute acceleration of a floor likewise.
    pub acceleration: Distribution,
    /// Of every floor in the order of the row, over the runs that hit its building; `None` of a wall, and if none does.
    pub floors: Vec<Option<FloorBumperEffect>>,
    /// Of every pair in the order of the row; `None` if it never touches without bumpers.
    pub pairs: Vec<Option<PairBumperEffect>>,
}

/// What bumpers change at a floor: with over without \[–\].
#[derive(Debug, Clone, PartialEq)]
pub struct FloorBumperEffect {
    /// Of the peak drift of the storey below.
    pub drift: Distribution,
    /// Of the peak absolute acceleration.
    pub acceleration: Distribution,
}

/// What a bumper changes at a pair.
#[derive(Debug, Clone, PartialEq)]
pub struct PairBumperEffect {
    /// Largest force of every run without a bumper \[N\], with the contact stiffness of the scene; `None` of a law without force.
    pub force_without: Option<Distribution>,
    /// The same with a bumper; `None` if nothing touches it.
    pub force_with: Option<Distribution>,
    /// Largest compression of all runs \[m\].
    pub compression: f64,
}

/// Part of the runs \[–\] that may compress bumpers by more than their thickness: what 84 % of the runs leave out.
const MOST_THROUGH: f64 = 0.16;

impl BumperEffect {
    /// Whether bumpers are compressed by more than their thickness so often that nothing is known of what they change.
    pub fn is_too_thin(&self) -> bool {
        self.too_thin as f64 > MOST_THROUGH * self.runs as f64
    }

    /// Sums up runs without bumpers and with them; `None` if there are none.
    pub fn of(floors: &Floors, bumpers: &[Bumper], runs: &[(&AssessedRun, &BumperRun)]) -> Option<Self> {
        let moving = |floor: &usize| !floors.all()[*floor].is_wall();
        let ratios = |floor: usize, peak: fn(&FloorPeaks) -> f64| {
            let building = floors.all()[floor].structure;
            let hit = runs.iter().filter(move |(without, _)| without.hits(floors, building));
            let both = hit.map(move |(without, with)| {
                let [without, with] = [&without.floors[floor].beside, &with.floors[floor]].map(peak);
                // What nothing moves is as well off.
                if without.to_bits() == with.to_bits() { 1.0 } else { with / without }
            });
            both.filter(|ratio| ratio.is_finite())
        };
        let all = |peak: fn(&FloorPeaks) -> f64| {
            let floors = (0..floors.all().len()).filter(moving);
            Distribution::of(floors.flat_map(|floor| ratios(floor, peak)))
        };
        let thickness = |pair: usize| {
            let contact = floors.facing()[pair].contact;
            let own = bumpers.iter().find(|bumper| bumper.contact == contact);
            own.map_or(f64::INFINITY, |bumper| bumper.thickness)
        };
        let too_thin = |with: &BumperRun| {
            let mut pairs = with.pairs.iter().enumerate();
            pairs.any(|(pair, found)| found.compression > thickness(pair))
        };
        let forces = runs.iter().flat_map(|(without, with)| {
            let both = without.pairs.iter().zip(&with.pairs);
            both.filter_map(|(without, with)| Some(with.peak_force.unwrap_or(0.0) / without.own_force?))
        });
        let of_floor = |floor: usize| {
            moving(&floor).then(|| {
                Some(FloorBumperEffect {
                    drift: Distribution::of(ratios(floor, |peaks| peaks.drift))?,
                    acceleration: Distribution::of(ratios(floor, |peaks| peaks.acceleration))?,
                })
            })?
        };
        Some(Self {
            bumpers: bumpers.to_vec(),
            runs: runs.len(),
            too_thin: runs.iter().filter(|(_, with)| too_thin(with)).count(),
            force: Distribution::of(forces.filter(|ratio| ratio.is_finite())),
            drift: all(|peaks| peaks.drift)?,
            acceleration: all(|peaks| peaks.acceleration)?,
            floors: (0..floors.all().len()).map(of_floor).collect(),
            pairs: (0..floors.facing().len()).map(|pair| of_pair(runs, pair)).collect(),
        })
    }
}

fn of_pair(runs: &[(&AssessedRun, &BumperRun)], pair: usize) -> Option<PairBumperEffect> {
    let touching = runs.iter().filter(|(run, _)| run.pairs[pair].collisions > 0);
    let compressions = touching.clone().map(|(_, with)| with.pairs[pair].compression);
    Some(PairBumperEffect {
        force_without: Distribution::of(touching.clone().filter_map(|(run, _)| run.pairs[pair].own_force)),
        force_with: Distribution::of(touching.filter_map(|(_, with)| with.pairs[pair].peak_force)),
        compression: compressions.reduce(f64::max)?,
    })
}
