//! Effect of bumpers over many runs.

use pounding_scene::Floors;

use crate::assessment::FloorAssessment;
use crate::bumper::{Bumper, BumperRun};
use crate::distribution::{Case, Distribution, ratios_of_cases};
use crate::peaks::FloorPeaks;
use crate::run::AssessedRun;

/// A run with bumpers and the same run without, and their case.
#[derive(Debug, Clone, Copy)]
pub struct BumperCase<'r> {
    /// The case.
    pub case: Case,
    /// The run without bumpers.
    pub without: &'r AssessedRun,
    /// The run with bumpers.
    pub with: &'r BumperRun,
}

/// Effect of bumpers. It covers the runs in which something touches, with or without bumpers: a bumper that fills half of a gap may be hit
/// where the gap would stay open. Each ratio is one of a case: the largest number of its runs with bumpers over the largest without.
#[derive(Debug, Clone, PartialEq)]
pub struct BumperEffect {
    /// The bumpers.
    pub bumpers: Vec<Bumper>,
    /// Number of runs.
    pub runs: usize,
    /// Number of runs that compress a bumper by more than its thickness. In reality the two floors would then hit each other; the model
    /// leaves this collision out, so that the run has no result.
    pub too_thin: usize,
    /// Ratio of the largest force of a gap with bumpers to its largest force without \[–\], where the latter is known. The force with bumpers
    /// is 0 if nothing touches.
    pub force: Option<Distribution>,
    /// Ratio of the peak drift with bumpers to the peak drift without bumpers \[–\]. It includes every storey of the buildings that are hit.
    pub drift: Distribution,
    /// Ratio of the peak absolute acceleration with bumpers to that without bumpers \[–\]. It includes every floor of the buildings that are
    /// hit.
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
    /// Peak force in every case in which the pair touches without bumpers \[N\]. It is `None` for an impulsive law.
    pub force_without: Option<Distribution>,
    /// Peak force with bumpers in every case in which the pair touches without bumpers \[N\]. It is `None` if no run has a force.
    pub force_with: Option<Distribution>,
    /// Largest compression in the runs in which the pair touches without bumpers \[m\].
    pub compression: f64,
}

/// What bumpers make worse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BumperHarm {
    /// The largest force of a gap.
    Force,
    /// The drift of the storey below a floor, by its index.
    Drift(usize),
    /// The acceleration of a floor, by its index.
    Acceleration(usize),
}

impl BumperEffect {
    /// Whether a run compresses a bumper by more than its thickness. The effect is then not known.
    pub fn is_too_thin(&self) -> bool {
        self.too_thin > 0
    }

    /// What the bumpers make worse most, in any case, and how many times as large it becomes; `None` if nothing becomes more than
    /// [`FloorAssessment::WORSE`] times as large.
    pub fn harm(&self) -> Option<(BumperHarm, f64)> {
        let floors = self.floors.iter().enumerate();
        let floors = floors.filter_map(|(floor, one)| Some((floor, one.as_ref()?)));
        let of_floors = floors.flat_map(|(floor, one)| {
            [
                (BumperHarm::Drift(floor), one.drift.largest()),
                (BumperHarm::Acceleration(floor), one.acceleration.largest()),
            ]
        });
        let force = self.force.iter().map(|force| (BumperHarm::Force, force.largest()));
        let worst = of_floors.chain(force).max_by(|one, other| one.1.total_cmp(&other.1));
        worst.filter(|(_, ratio)| *ratio > FloorAssessment::WORSE)
    }

    /// Whether the effect is known and nothing gets worse.
    pub fn helps(&self) -> bool {
        !self.is_too_thin() && self.harm().is_none()
    }

    /// Compares runs without bumpers and the same runs with bumpers. Returns `None` if no building is hit.
    pub fn of(floors: &Floors, bumpers: &[Bumper], runs: &[BumperCase<'_>]) -> Option<Self> {
        let touch = |one: &&BumperCase<'_>| one.without.collisions() > 0 || one.with.pairs.iter().any(|pair| pair.peak_force.is_some());
        let runs: Vec<BumperCase<'_>> = runs.iter().filter(touch).copied().collect();
        let compared = Compared {
            floors,
            bumpers,
            runs: &runs,
        };
        let moving: Vec<usize> = (0..floors.all().len()).filter(|floor| !floors.all()[*floor].is_wall()).collect();
        let all = |peak: fn(&FloorPeaks) -> f64| {
            let ratios = moving.iter().flat_map(|floor| compared.ratios(*floor, peak));
            Distribution::of_cases(ratios)
        };
        let forces = bumpers.iter().flat_map(|bumper| compared.forces(bumper.contact));
        Some(Self {
            bumpers: bumpers.to_vec(),
            runs: runs.len(),
            too_thin: runs.iter().filter(|one| compared.is_too_thin(one.with)).count(),
            force: Distribution::of_cases(forces),
            drift: all(|peaks| peaks.drift)?,
            acceleration: all(|peaks| peaks.acceleration)?,
            floors: (0..floors.all().len())
                .map(|floor| moving.contains(&floor).then(|| compared.floor(floor))?)
                .collect(),
            pairs: (0..floors.facing().len()).map(|pair| compared.pair(pair)).collect(),
        })
    }
}

/// Runs with and without bumpers.
struct Compared<'r> {
    floors: &'r Floors,
    bumpers: &'r [Bumper],
    runs: &'r [BumperCase<'r>],
}

impl Compared<'_> {
    /// Whether something hits a building, with or without bumpers.
    fn hits(&self, one: &BumperCase<'_>, building: usize) -> bool {
        let facing = self.floors.facing().iter().zip(&one.with.pairs);
        let touching = facing.filter(|(_, pair)| pair.peak_force.is_some());
        let mut sides = touching.flat_map(|(facing, _)| [facing.left, facing.right]);
        one.without.hits(self.floors, building) || sides.any(|side| self.floors.all()[side].structure == building)
    }

    /// Responses of a floor with bumpers over those without, in the runs in which something hits its building.
    fn ratios(&self, floor: usize, peak: fn(&FloorPeaks) -> f64) -> Vec<(Case, f64)> {
        let building = self.floors.all()[floor].structure;
        let hit = self.runs.iter().filter(|one| self.hits(one, building));
        let both = hit.map(|one| (one.case, [&one.without.floors[floor].beside, &one.with.floors[floor]].map(peak)));
        ratios_of_cases(both)
    }

    fn floor(&self, floor: usize) -> Option<FloorBumperEffect> {
        Some(FloorBumperEffect {
            drift: Distribution::of_cases(self.ratios(floor, |peaks| peaks.drift))?,
            acceleration: Distribution::of_cases(self.ratios(floor, |peaks| peaks.acceleration))?,
        })
    }

    /// Largest forces of a gap with bumpers over those without, where the latter are known.
    fn forces(&self, contact: usize) -> Vec<(Case, f64)> {
        let facing = self.floors.facing().iter().enumerate();
        let own: Vec<usize> = facing.filter(|(_, one)| one.contact == contact).map(|(pair, _)| pair).collect();
        let both = self.runs.iter().filter_map(|one| {
            let with = own.iter().filter_map(|pair| one.with.pairs[*pair].peak_force);
            let without = own.iter().filter_map(|pair| one.without.pairs[*pair].own_force);
            Some((one.case, [without.reduce(f64::max)?, with.fold(0.0, f64::max)]))
        });
        ratios_of_cases(both)
    }

    fn is_too_thin(&self, with: &BumperRun) -> bool {
        let thickness = |pair: usize| {
            let contact = self.floors.facing()[pair].contact;
            let own = self.bumpers.iter().find(|bumper| bumper.contact == contact);
            own.map_or(f64::INFINITY, |bumper| bumper.thickness)
        };
        let mut pairs = with.pairs.iter().enumerate();
        pairs.any(|(pair, found)| found.compression > thickness(pair))
    }

    fn pair(&self, pair: usize) -> Option<PairBumperEffect> {
        let touching = self.runs.iter().filter(|one| one.without.pairs[pair].collisions > 0);
        let compressions = touching.clone().map(|one| one.with.pairs[pair].compression);
        let forces = |of: fn(&BumperCase<'_>, usize) -> Option<f64>| {
            let forces = touching.clone().filter_map(|one| Some((one.case, of(one, pair)?)));
            Distribution::of_cases(forces)
        };
        Some(PairBumperEffect {
            force_without: forces(|one, pair| one.without.pairs[pair].own_force),
            force_with: forces(|one, pair| one.with.pairs[pair].peak_force),
            compression: compressions.reduce(f64::max)?,
        })
    }
}
