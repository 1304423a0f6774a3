//! Effect of bumpers over many runs.

use pounding_scene::Floors;

use crate::bumper::{Bumper, BumperRun};
use crate::distribution::Distribution;
use crate::peaks::FloorPeaks;
use crate::run::AssessedRun;

/// Effect of bumpers. It covers the runs in which something touches when there are no bumpers.
#[derive(Debug, Clone, PartialEq)]
pub struct BumperEffect {
    /// The bumpers.
    pub bumpers: Vec<Bumper>,
    /// Number of runs.
    pub runs: usize,
    /// Number of runs that compress a bumper by more than its thickness. In reality the two floors would then hit each other; the model
    /// leaves this collision out.
    pub too_thin: usize,
    /// Ratio of the peak force of a pair with bumpers to its peak force without \[–\], for every pair and run in which the force without
    /// bumpers is known. The force with bumpers is 0 if nothing touches.
    pub force: Option<Distribution>,
    /// Ratio of the peak drift with bumpers to the peak drift without bumpers \[–\]. It includes every storey, except walls, in the runs in
    /// which something hits its building without bumpers.
    pub drift: Distribution,
    /// Ratio of the peak absolute acceleration with bumpers to that without bumpers \[–\]. It includes every floor, except walls, in the
    /// runs in which something hits its building without bumpers.
    pub acceleration: Distribution,
    /// Effect on each floor, in the order of the row. It is `None` for a wall, and for a building that nothing hits in any run.
    pub floors: Vec<Option<FloorBumperEffect>>,
    /// Every pair in the order of the row; `None` if the pair never touches without bumpers.
    pub pairs: Vec<Option<PairBumperEffect>>,
}

/// Effect of bumpers on a floor. Each number is the response with bumpers divided by the response without \[–\].
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
    /// Peak force in every run in which the pair touches without bumpers \[N\]. It is `None` for an impulsive law.
    pub force_without: Option<Distribution>,
    /// Peak force with bumpers in every run in which the pair touches without bumpers \[N\]. It is `None` if no run has a force.
    pub force_with: Option<Distribution>,
    /// Largest compression in the runs in which the pair touches without bumpers \[m\].
    pub compression: f64,
}

/// Largest accepted part of runs that compress a bumper by more than its thickness \[–\]. A proposed bumper is sized for 84 % of the runs,
/// so the other 16 % may do so.
const MOST_THROUGH: f64 = 0.16;

impl BumperEffect {
    /// Whether the bumpers are too thin: more than 16 % of the runs compress one by more than its thickness. Their effect is then not
    /// known.
    pub fn is_too_thin(&self) -> bool {
        self.too_thin as f64 > MOST_THROUGH * self.runs as f64
    }

    /// Compares runs without bumpers and the same runs with bumpers. Returns `None` if there are no runs, or if no building is hit.
    pub fn of(floors: &Floors, bumpers: &[Bumper], runs: &[(&AssessedRun, &BumperRun)]) -> Option<Self> {
        let moving = |floor: &usize| !floors.all()[*floor].is_wall();
        let ratios = |floor: usize, peak: fn(&FloorPeaks) -> f64| {
            let building = floors.all()[floor].structure;
            let hit = runs.iter().filter(move |(without, _)| without.hits(floors, building));
            let both = hit.map(move |(without, with)| {
                let [without, with] = [&without.floors[floor].beside, &with.floors[floor]].map(peak);
                // Equal responses give the ratio 1, also if both are 0.
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
