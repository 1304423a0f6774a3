//! Features of scenes, by which a campaign counts its results.

use crate::listed::listed;
use pounding_scene::{Columns, Contact, Generated, RunResult, Scene, Source, Structure};

listed! {
    /// A feature of scenes: its name, and the test for it.
    pub enum Class { texts: (&'static str, fn(&Scene) -> bool);
        /// All contacts are impulsive.
        Impulsive = ("impulsive contacts", |scene| contacts(scene).all(|one| !one.law.is_compliant())),
        /// All contacts have forces over time.
        Compliant = ("compliant contacts", |scene| contacts(scene).all(|one| one.law.is_compliant())),
        /// Some contacts are impulsive and some are not.
        BothContacts = ("both kinds of contact", |scene| !Class::Impulsive.is_of(scene) && !Class::Compliant.is_of(scene)),
        /// All structures have one storey.
        OneStorey = ("one storey each", |scene| !Class::Storeys.is_of(scene)),
        /// Some building has several storeys.
        Storeys = ("several storeys", |scene| scene.structures.iter().any(|one| columns(one).len() > 1)),
        /// Some columns never yield.
        Elastic = ("elastic columns", |scene| all_columns(scene).any(|one| one.yield_force_n.is_none())),
        /// Some columns yield at one point.
        Sharp = ("yielding columns", |scene| all_columns(scene).any(|one| one.yield_force_n.is_some() && one.bouc_wen.is_none())),
        /// Some columns yield smoothly.
        Smooth = ("Bouc–Wen columns", |scene| all_columns(scene).any(|one| one.bouc_wen.is_some())),
        /// Some isolators stick and slide under friction.
        Sliding = ("friction that sticks", |scene| all_columns(scene).any(|one| one.friction_n.is_some())),
        /// A wall is at one end.
        OneWall = ("a wall at one end", |scene| n_walls(scene) == 1),
        /// Walls are at both ends.
        TwoWalls = ("walls at both ends", |scene| n_walls(scene) == 2),
        /// The ground motion travels along the row.
        Arrivals = ("arrivals", |scene| scene.arrivals_s.is_some()),
        /// Some gap is 0.
        NoGap = ("a gap of 0", |scene| contacts(scene).any(|one| one.gap_m <= 0.0)),
        /// Some restitution is 0.
        Plastic = ("e = 0", |scene| has_restitution(scene, 0.0)),
        /// Some restitution is 1.
        Lossless = ("e = 1", |scene| has_restitution(scene, 1.0)),
        /// Some contacts are at chosen levels only.
        SomeLevels = ("chosen levels", |scene| contacts(scene).any(|one| one.levels.is_some())),
        /// Some structure moves at the start.
        Moving = ("moving at the start", |scene| scene.structures.iter().any(moves)),
        /// Some neighbours come to rest against each other; this is known only after the run.
        Rests = ("coming to rest", |_| false),
        /// The ground motion is a record.
        Record = ("a record", |scene| matches!(scene.record.source, Source::File(_))),
        /// The ground motion is random.
        Stochastic = ("random shaking", |scene| matches!(scene.record.source, Source::Generated(Generated::Stochastic(_)))),
        /// The ground motion is a pulse.
        Pulse = ("a pulse", |scene| matches!(scene.record.source, Source::Generated(Generated::Ricker { .. } | Generated::HalfSine { .. }))),
        /// The ground motion is harmonic.
        Harmonic = ("harmonic shaking", |scene| matches!(scene.record.source, Source::Generated(Generated::Harmonic { .. }))),
    }
}

impl Class {
    /// Name of the feature.
    pub fn words(self) -> &'static str {
        self.texts().0
    }

    fn is_of(self, scene: &Scene) -> bool {
        self.texts().1(scene)
    }

    /// The features of a scene, except [`Self::Rests`], which is known only after the run.
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

/// Whether neighbours with an impulsive law come to rest against each other: only then does their law have a force.
pub(super) fn rests(scene: &pounding_scene::Simulation, outcome: &RunResult) -> bool {
    let mut all = outcome.collisions.all().iter();
    all.any(|one| one.peak_force.is_some() && !scene.pairs()[one.pair].law.is_compliant())
}
