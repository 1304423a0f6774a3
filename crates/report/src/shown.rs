//! The numbers of a run for people: their tables and their words.

use pounding_scene::{Collapse, FloorQuantity, PairQuantity, Quantity, QuantityKind, Review, RunErrors, RunValues, Simulation};
use pounding_text::{milliseconds, percent};

/// The choice of each table for people, in the order of its columns or rows.
pub mod tables {
    use pounding_scene::{FloorQuantity as Floor, LinkQuantity as Link, PairQuantity as Pair};

    /// Structures.
    pub const STRUCTURES: &[Floor] = &[
        Floor::PeriodS,
        Floor::DampingRatio,
        Floor::PeakDisplacementM,
        Floor::PeakDisplacementTimeS,
        Floor::PeakShearForceN,
        Floor::Ductility,
        Floor::TransferredMomentumNS,
    ];
    /// Numbers of structures that belong to a storey, not to the floor above it.
    pub const OF_STOREYS: &[Floor] = &[Floor::PeakShearForceN, Floor::Ductility];
    /// The motion of structures that is left at the end, and the shaking of objects on their floors.
    pub const MOTIONS: &[Floor] = &[
        Floor::ResidualDisplacementAtEndM,
        Floor::PeakAccelerationMPerS2,
        Floor::PeakAccelerationTimeS,
    ];
    /// Storeys.
    pub const STOREYS: &[Floor] = &[
        Floor::PeakDriftM,
        Floor::PeakDriftTimeS,
        Floor::ResidualDriftAtEndM,
        Floor::DriftRatio,
        Floor::PeakShearForceN,
        Floor::Ductility,
        Floor::DamperForceRatio,
    ];
    /// Pairs.
    pub const PAIRS: &[Pair] = &[
        Pair::GapM,
        Pair::LeastOpeningM,
        Pair::Collisions,
        Pair::FirstStartS,
        Pair::LargestImpulseNS,
        Pair::PeakForceN,
        Pair::PeakForceTimeS,
    ];
    /// Links.
    pub const LINKS: &[Link] = &[
        Link::PeakPushN,
        Link::PeakPullN,
        Link::LargestShorteningM,
        Link::LargestElongationM,
        Link::LinkEnergyJ,
    ];
    /// The numbers of a building whose worst floor is on the first screen.
    pub const WORST: &[Floor] = &[
        Floor::PeakDisplacementM,
        Floor::PeakDriftM,
        Floor::DriftRatio,
        Floor::PeakShearForceN,
        Floor::BaseShearRatio,
        Floor::Ductility,
    ];
    /// Structures of scenes side by side.
    pub const STRUCTURES_BESIDE: &[Floor] = &[
        Floor::PeriodS,
        Floor::PeakDisplacementM,
        Floor::PeakDriftM,
        Floor::ResidualDisplacementAtEndM,
        Floor::PeakAccelerationMPerS2,
        Floor::PeakShearForceN,
        Floor::TransferredMomentumNS,
    ];
    /// Pairs of scenes side by side.
    pub const PAIRS_BESIDE: &[Pair] = &[
        Pair::GapM,
        Pair::Collisions,
        Pair::FirstStartS,
        Pair::LargestImpulseNS,
        Pair::PeakForceN,
        Pair::PeakForceTimeS,
    ];
}

/// A run in the words of tables.
#[derive(Debug)]
pub struct InWords<'a> {
    simulation: &'a Simulation,
    values: RunValues<'a>,
    errors: Option<&'a RunErrors>,
    /// Acceleration of gravity \[m/s²\].
    gravity: f64,
    collapse: Option<Collapse>,
}

impl<'a> InWords<'a> {
    /// A run with its errors, if they are known.
    pub fn of(simulation: &'a Simulation, review: &'a Review) -> Self {
        Self {
            simulation,
            values: review.outcome.values(simulation),
            errors: review.measured(),
            gravity: simulation.scene().record.gravity_m_per_s2,
            collapse: review.outcome.collapse,
        }
    }

    /// Whether a storey of a structure collapses.
    pub fn falls(&self, structure: usize) -> bool {
        self.collapse.is_some_and(|collapse| collapse.structure == structure)
    }

    /// A number in SI units. A storey that falls has no base shear over weight, ductility or damper force: they would be those of the instant
    /// at which the run ends. Nothing is left at the end of a run that a collapse ends.
    fn known(&self, quantity: Quantity, place: usize) -> Option<f64> {
        use FloorQuantity as Floor;
        let of_fall = [Floor::BaseShearRatio, Floor::Ductility, Floor::DamperForceRatio].map(Quantity::from);
        let left = [Floor::ResidualDisplacementAtEndM, Floor::ResidualDriftAtEndM].map(Quantity::from);
        let is_unknown = |collapse: Collapse| left.contains(&quantity) || (collapse.floor == place && of_fall.contains(&quantity));
        self.values.of(quantity, place).filter(|_| !self.collapse.is_some_and(is_unknown))
    }

    /// A number in the unit that people read; `None` if the place has no such number.
    pub fn value(&self, quantity: impl Into<Quantity>, place: usize) -> Option<f64> {
        let quantity = quantity.into();
        Some(quantity.about().unit.of(self.known(quantity, place)?, self.gravity))
    }

    /// A number in words; `None` if the place has no such number.
    pub fn text(&self, quantity: impl Into<Quantity>, place: usize) -> Option<String> {
        let quantity = quantity.into();
        let value = self.known(quantity, place);
        let value = value.map(|value| quantity.about().text_of(value, self.gravity));
        let is_impulsive = || quantity == PairQuantity::PeakForceN.into() && self.values.of(PairQuantity::Collisions, place) > Some(0.0);
        value.or_else(|| is_impulsive().then(|| "impulsive".into()))
    }

    /// The error of a number in words: of a count that of the exact run. `None` if it was not measured, or neither run has the number.
    pub fn error(&self, quantity: impl Into<Quantity>, place: usize) -> Option<String> {
        let (errors, quantity) = (self.errors?, quantity.into());
        let about = quantity.about();
        if about.kind == QuantityKind::Count {
            let pair = &errors.pairs()[place];
            return Some(match pair.collisions {
                _ if pair.rests => "rests".into(),
                [own, exact] if own != exact => format!("exact {exact}"),
                _ => "equal".into(),
            });
        }
        let measured = match about.error_of {
            Some(other) => {
                self.values.of(quantity, place)?;
                self.of_storey(other, place)
            }
            None => quantity,
        };
        let words = if about.absolute.is_some() { milliseconds } else { percent };
        errors.told(measured, place).map(words)
    }

    /// Whether errors were measured.
    pub fn is_measured(&self) -> bool {
        self.errors.is_some()
    }

    /// The number of the floor in place of that of its storey, if the storey stands on the ground.
    pub fn of_storey(&self, quantity: FloorQuantity, floor: usize) -> Quantity {
        Quantity::from(quantity).of_storey(self.simulation.floors().all()[floor].is_upper())
    }
}
