//! What is in a scene: classes by which a campaign counts.

use crate::listed::listed;
use pounding_scene::{Columns, Contact, Generated, RunResult, Scene, Source, Structure};

listed! {
    /// Something that a scene has: its name, and which scenes have it.
    pub enum Class { texts: (&'static str, fn(&Scene) -> bool);
        /// All contacts are impulsive.
        Impulsive = ("impulsive contacts", |scene| contacts(scene).all(|one| !one.law.is_compliant())),
        /// All contacts have forces over time.
        Compliant = ("compliant contacts", |scene| contacts(scene).all(|one| one.law.is_compliant())),
        /// Some are impulsive and some not.
        BothContacts = ("both kinds of contact", |scene| !Class::Impulsive.is_of(scene) && !Class::Compliant.is_of(scene)),
        /// All structures have one storey.
        OneStorey = ("one storey each", |scene| !Class::Storeys.is_of(scene)),
        /// Some building has several.
        Storeys = ("several storeys", |scene| scene.structures.iter().any(|one| columns(one).len() > 1)),
        /// Columns that never yield.
        Elastic = ("elastic columns", |scene| all_columns(scene).any(|one| one.yield_force_n.is_none())),
        /// Columns that yield at one point.
        Sharp = ("yielding columns", |scene| all_columns(scene).any(|one| one.yield_force_n.is_some() && one.bouc_wen.is_none())),
        /// Columns that yield smoothly.
        Smooth = ("Bouc–Wen columns", |scene| all_columns(scene).any(|one| one.bouc_wen.is_some())),
        /// A wall at one end.
        OneWall = ("a wall at one end", |scene| n_walls(scene) == 1),
        /// Walls at both.
        TwoWalls = ("walls at both ends", |scene| n_walls(scene) == 2),
        /// A ground motion that travels.
        Arrivals = ("arrivals", |scene| scene.arrivals_s.is_some()),
        /// A gap of 0.
        NoGap = ("a gap of 0", |scene| contacts(scene).any(|one| one.gap_m <= 0.0)),
        /// A restitution of 0.
        Plastic = ("e = 0", |scene| has_restitution(scene, 0.0)),
        /// A restitution of 1.
        Lossless = ("e = 1", |scene| has_restitution(scene, 1.0)),
        /// Contacts at some levels alone.
        SomeLevels = ("chosen levels", |scene| contacts(scene).any(|one| one.levels.is_some())),
        /// A structure that moves at the start.
        Moving = ("moving at the start", |scene| scene.structures.iter().any(moves)),
        /// Neighbours that come to rest against each other, which is known once the scene has run.
        Rests = ("coming to rest", |_| false),
        /// A record.
        Record = ("a record", |scene| matches!(scene.record.source, Source::File(_))),
        /// Random shaking.
        Stochastic = ("random shaking", |scene| matches!(scene.record.source, Source::Generated(Generated::Stochastic(_)))),
        /// A pulse.
        Pulse = ("a pulse", |scene| matches!(scene.record.source, Source::Generated(Generated::Ricker { .. } | Generated::HalfSine { .. }))),
        /// Harmonic shaking.
        Harmonic = ("harmonic shaking", |scene| matches!(scene.record.source, Source::Generated(Generated::Harmonic { .. }))),
    }
}

impl Class {
    /// Its name in text.
    pub fn words(self) -> &'static str {
        self.texts().0
    }

    fn is_of(self, scene: &Scene) -> bool {
        self.texts().1(scene)
    }

    /// Those of a scene; whether neighbours come to rest is known once it has run.
    pub(super) fn of(scene: &Scene) -> Vec<Self> {
        Self::ALL.into_iter().filter(|class| class.is_of(scene)).collect()
    }
}

fn contacts(scene: &Scene) -> impl Iterator<Item = &Contact> {
    scene.contacts.iter().flatten()
}

fn has_restitution(scene: &Scene, restitution: f64) -> bool {
    let mut laws = contacts(scene).filter_map(|one| one.law.impulsive());
    laws.any(|law| law.restitution.total_cmp(&restitution).is_eq())
}

fn n_walls(scene: &Scene) -> usize {
    scene.structures.iter().filter(|one| matches!(one, Structure::Wall)).count()
}

fn all_columns(scene: &Scene) -> impl Iterator<Item = Columns> {
    scene.structures.iter().flat_map(columns)
}

fn columns(structure: &Structure) -> Vec<Columns> {
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
