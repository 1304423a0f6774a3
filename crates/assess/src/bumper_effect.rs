//! Effect of bumpers over many runs.

use pounding_scene::Floors;

use crate::bumper::{Bumper, BumperRun};
use crate::distribution::Distribution;
use crate::peaks::FloorPeaks;
use crate::run::AssessedRun;

/// Effect of bumpers, over the runs in which something touches without them.
#[derive(Debug, Clone, PartialEq)]
pub struct BumperEffect {
    /// The bumpers.
    pub bumpers: Vec<Bumper>,
    /// Number of runs.
    pub runs: usize,
    /// Number of runs in which some bumper is compressed by more than its thickness. The collision of the floors behind the bumper is then
    /// left out.
    pub too_thin: usize,
    /// Ratio of the force with a bumper to the force without \[–\], for every pair and run in which both are known.
    pub force: Option<Distribution>,
    /// Ratio of the peak drift with bumpers to the peak drift without \[–\], for every storey that moves, over the runs that hit its
    /// building.
    pub drift: Distribution,
    /// Ratio of peak absolute accelerations \[–\], for every floor that moves, over the runs that hit its building.
    pub acceleration: Distribution,
    /// Every floor in the order of the row, over the runs that hit its building; `None` for a wall, and if no run hits the building.
    pub floors: Vec<Option<FloorBumperEffect>>,
    /// Every pair in the order of the row; `None` if the pair never touches without bumpers.
    pub pairs: Vec<Option<PairBumperEffect>>,
}

/// Effect of bumpers on a floor: ratios of responses with bumpers to responses without \[–\].
#[derive(Debug, Clone, PartialEq)]
pub struct FloorBumperEffect {
    /// Ratio of peak drifts of the storey below.
    pub drift: Distribution,
    /// Ratio of peak absolute accelerations.
    pub acceleration: Distribution,
}

/// Effect of a bumper on a pair.
#[derive(Debug, Clone, PartialEq)]
pub struct PairBumperEffect {
    /// Largest force of every run without a bumper \[N\], with the contact stiffness of the scene; `None` for a law without force.
    pub force_without: Option<Distribution>,
    /// Largest force of every run with a bumper \[N\]; `None` if nothing touches the bumper.
    pub force_with: Option<Distribution>,
    /// Largest compression of all runs \[m\].
    pub compression: f64,
}

/// Part of the runs \[–\] that may compress bumpers by more than their thickness: the runs beyond 84 %.
const MOST_THROUGH: f64 = 0.16;

impl BumperEffect {
    /// Whether so many runs compress bumpers by more than their thickness that the effect of the bumpers is not known.
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
                // A floor that never moves responds alike.
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
