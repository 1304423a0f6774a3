//! What is in a scene: classes by which a campaign counts.

use pounding_scene::{Columns, Contact, Generated, RunResult, Scene, Source, Structure};
use strum::EnumCount;

/// Something that a scene has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, EnumCount)]
pub enum Class {
    /// All contacts are impulsive.
    Impulsive,
    /// All contacts have forces over time.
    Compliant,
    /// Some are impulsive and some not.
    BothContacts,
    /// All structures have one storey.
    OneStorey,
    /// Some building has several.
    Storeys,
    /// Columns that never yield.
    Elastic,
    /// Columns that yield at one point.
    Sharp,
    /// Columns that yield smoothly.
    Smooth,
    /// A wall at one end.
    OneWall,
    /// Walls at both.
    TwoWalls,
    /// A ground motion that travels.
    Arrivals,
    /// A gap of 0.
    NoGap,
    /// A restitution of 0.
    Plastic,
    /// A restitution of 1.
    Lossless,
    /// Contacts at some levels alone.
    SomeLevels,
    /// A structure that moves at the start.
    Moving,
    /// Neighbours that come to rest against each other.
    Rests,
    /// A record.
    Record,
    /// Random shaking.
    Stochastic,
    /// A pulse.
    Pulse,
    /// Harmonic shaking.
    Harmonic,
}

impl Class {
    /// All of them, in the order of tables.
    pub const ALL: [Self; Self::COUNT] = [
        Self::Impulsive,
        Self::Compliant,
        Self::BothContacts,
        Self::OneStorey,
        Self::Storeys,
        Self::Elastic,
        Self::Sharp,
        Self::Smooth,
        Self::OneWall,
        Self::TwoWalls,
        Self::Arrivals,
        Self::NoGap,
        Self::Plastic,
        Self::Lossless,
        Self::SomeLevels,
        Self::Moving,
        Self::Rests,
        Self::Record,
        Self::Stochastic,
        Self::Pulse,
        Self::Harmonic,
    ];

    /// Its name in text.
    pub fn words(self) -> &'static str {
        match self {
            Self::Impulsive => "impulsive contacts",
            Self::Compliant => "compliant contacts",
            Self::BothContacts => "both kinds of contact",
            Self::OneStorey => "one storey each",
            Self::Storeys => "several storeys",
            Self::Elastic => "elastic columns",
            Self::Sharp => "yielding columns",
            Self::Smooth => "Bouc–Wen columns",
            Self::OneWall => "a wall at one end",
            Self::TwoWalls => "walls at both ends",
            Self::Arrivals => "arrivals",
            Self::NoGap => "a gap of 0",
            Self::Plastic => "e = 0",
            Self::Lossless => "e = 1",
            Self::SomeLevels => "chosen levels",
            Self::Moving => "moving at the start",
            Self::Rests => "coming to rest",
            Self::Record => "a record",
            Self::Stochastic => "random shaking",
            Self::Pulse => "a pulse",
            Self::Harmonic => "harmonic shaking",
        }
    }

    /// Those of a scene; whether neighbours come to rest is known once it has run.
    pub(super) fn of(scene: &Scene) -> Vec<Self> {
        let contacts = || scene.contacts.iter().flatten();
        let impulsive = contacts().filter(|one| !one.law.is_compliant()).count();
        let restitution = |e: f64| {
            let of = |one: &Contact| one.law.impulsive().map(|law| law.restitution);
            contacts().filter_map(of).any(|one| one.total_cmp(&e).is_eq())
        };
        let walls = scene.structures.iter();
        let walls = walls.filter(|one| matches!(one, Structure::Wall)).count();
        let columns = columns(scene);
        let storeys = scene.structures.iter().any(|one| match one {
            Structure::Building(building) => building.storeys.len() > 1,
            Structure::Sdof(_) | Structure::Wall => false,
        });
        let has = [
            (Self::Impulsive, impulsive == contacts().count()),
            (Self::Compliant, impulsive == 0),
            (Self::BothContacts, impulsive > 0 && impulsive < contacts().count()),
            (Self::OneStorey, !storeys),
            (Self::Storeys, storeys),
            (Self::Elastic, columns.iter().any(|one| one.yield_force_n.is_none())),
            (
                Self::Sharp,
                columns.iter().any(|one| one.yield_force_n.is_some() && one.bouc_wen.is_none()),
            ),
            (Self::Smooth, columns.iter().any(|one| one.bouc_wen.is_some())),
            (Self::OneWall, walls == 1),
            (Self::TwoWalls, walls == 2),
            (Self::Arrivals, scene.arrivals_s.is_some()),
            (Self::NoGap, contacts().any(|one| one.gap_m <= 0.0)),
            (Self::Plastic, restitution(0.0)),
            (Self::Lossless, restitution(1.0)),
            (Self::SomeLevels, contacts().any(|one| one.levels.is_some())),
            (Self::Moving, scene.structures.iter().any(moves)),
        ];
        let motion = match &scene.record.source {
            Source::File(_) => Self::Record,
            Source::Generated(Generated::Stochastic(_)) => Self::Stochastic,
            Source::Generated(Generated::Harmonic { .. }) => Self::Harmonic,
            Source::Generated(Generated::Ricker { .. } | Generated::HalfSine { .. }) => Self::Pulse,
        };
        let found = has.into_iter().filter_map(|(class, is)| is.then_some(class));
        found.chain([motion]).collect()
    }
}

fn columns(scene: &Scene) -> Vec<Columns> {
    let of = |one: &Structure| match one {
        Structure::Sdof(sdof) => vec![sdof.columns()],
        Structure::Building(building) => building.storeys.iter().map(|one| one.columns).collect(),
        Structure::Wall => Vec::new(),
    };
    scene.structures.iter().flat_map(of).collect()
}

fn moves(structure: &Structure) -> bool {
    match structure {
        Structure::Sdof(sdof) => sdof.initial_velocity_m_per_s != 0.0,
        Structure::Building(building) => {
            let mut storeys = building.storeys.iter();
            storeys.any(|one| one.initial_velocity_m_per_s != 0.0)
        }
        Structure::Wall => false,
    }
}

/// Whether neighbours with an impulsive law come to rest against each other: only then does it have a force.
pub(super) fn rests(scene: &pounding_scene::Simulation, outcome: &RunResult) -> bool {
    let mut all = outcome.collisions.all().iter();
    all.any(|one| one.peak_force.is_some() && !scene.pairs()[one.pair].law.is_compliant())
}
