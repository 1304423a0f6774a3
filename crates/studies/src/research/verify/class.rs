//! What is in a scene: classes by which a campaign counts.

use crate::listed::listed;
use pounding_scene::{Columns, Contact, Generated, RunResult, Scene, Source, Structure};

listed! {
    /// Something that a scene has.
    pub enum Class { words: &'static str;
        /// All contacts are impulsive.
        Impulsive = "impulsive contacts",
        /// All contacts have forces over time.
        Compliant = "compliant contacts",
        /// Some are impulsive and some not.
        BothContacts = "both kinds of contact",
        /// All structures have one storey.
        OneStorey = "one storey each",
        /// Some building has several.
        Storeys = "several storeys",
        /// Columns that never yield.
        Elastic = "elastic columns",
        /// Columns that yield at one point.
        Sharp = "yielding columns",
        /// Columns that yield smoothly.
        Smooth = "Bouc–Wen columns",
        /// A wall at one end.
        OneWall = "a wall at one end",
        /// Walls at both.
        TwoWalls = "walls at both ends",
        /// A ground motion that travels.
        Arrivals = "arrivals",
        /// A gap of 0.
        NoGap = "a gap of 0",
        /// A restitution of 0.
        Plastic = "e = 0",
        /// A restitution of 1.
        Lossless = "e = 1",
        /// Contacts at some levels alone.
        SomeLevels = "chosen levels",
        /// A structure that moves at the start.
        Moving = "moving at the start",
        /// Neighbours that come to rest against each other.
        Rests = "coming to rest",
        /// A record.
        Record = "a record",
        /// Random shaking.
        Stochastic = "random shaking",
        /// A pulse.
        Pulse = "a pulse",
        /// Harmonic shaking.
        Harmonic = "harmonic shaking",
    }
}

impl Class {
    /// Those of a scene; whether neighbours come to rest is known once it has run.
    pub(super) fn of(scene: &Scene) -> Vec<Self> {
        let contacts = || scene.contacts.iter().flatten();
        let impulsive = contacts().filter(|one| !one.law.is_compliant()).count();
        let restitution = |e: f64| {
            let of = |one: &Contact| one.law.impulsive().map(|law| law.restitution);
            contacts().filter_map(of).any(|one| one.total_cmp(&e).is_eq())
        };
        let walls = scene.structures.iter().filter(|one| matches!(one, Structure::Wall)).count();
        let columns = columns(scene);
        let storeys = scene.structures.iter().any(|one| columns_of(one).len() > 1);
        let sharp = |one: &Columns| one.yield_force_n.is_some() && one.bouc_wen.is_none();
        let has = [
            (Self::Impulsive, impulsive == contacts().count()),
            (Self::Compliant, impulsive == 0),
            (Self::BothContacts, impulsive > 0 && impulsive < contacts().count()),
            (Self::OneStorey, !storeys),
            (Self::Storeys, storeys),
            (Self::Elastic, columns.iter().any(|one| one.yield_force_n.is_none())),
            (Self::Sharp, columns.iter().any(sharp)),
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
    scene.structures.iter().flat_map(columns_of).collect()
}

fn columns_of(structure: &Structure) -> Vec<Columns> {
    match structure {
        Structure::Sdof(sdof) => vec![sdof.columns()],
        Structure::Building(building) => building.storeys.iter().map(|one| one.columns).collect(),
        Structure::Wall => Vec::new(),
    }
}

fn moves(structure: &Structure) -> bool {
    match structure {
        Structure::Sdof(sdof) => sdof.initial_velocity_m_per_s != 0.0,
        Structure::Building(building) => building.storeys.iter().any(|one| one.initial_velocity_m_per_s != 0.0),
        Structure::Wall => false,
    }
}

/// Whether neighbours with an impulsive law come to rest against each other: only then does it have a force.
pub(super) fn rests(scene: &pounding_scene::Simulation, outcome: &RunResult) -> bool {
    let mut all = outcome.collisions.all().iter();
    all.any(|one| one.peak_force.is_some() && !scene.pairs()[one.pair].law.is_compliant())
}
