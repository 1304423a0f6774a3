//! Numbers of a structure in a run, for structures of one storey and for buildings.

use crate::Completed;
use pounding_scene::{Floors, RunResult, Scene, Simulation};

/// A scene and its result.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SceneRun<'a> {
    pub(super) scene: &'a Scene,
    pub(super) outcome: &'a RunResult,
    floors: &'a Floors,
}

impl<'a> SceneRun<'a> {
    /// The scene of a study at a position of its list.
    pub(crate) fn of(study: &'a Completed, index: usize) -> Self {
        Self {
            scene: &study.file.study.scenes[index],
            outcome: &study.outcomes[index],
            floors: Simulation::floors(&study.prepared[index]),
        }
    }

    /// Indices of a structure's floors in the row, from the ground up.
    fn floors(self, structure: usize) -> &'a [usize] {
        self.floors.of_structure(structure)
    }

    /// Whether anything touches.
    pub(super) fn touches(self) -> bool {
        !self.outcome.collisions.all().is_empty()
    }

    /// Momentum transferred to all floors of a structure \[N·s\].
    pub(crate) fn momentum(self, structure: usize) -> f64 {
        let of_floor = |floor: &usize| self.outcome.momentum.of(*floor);
        self.floors(structure).iter().map(of_floor).sum()
    }

    /// Signed peak displacement of a structure's roof \[m\].
    pub(crate) fn peak_displacement(self, structure: usize) -> f64 {
        let roof = self.floors(structure).last();
        roof.map_or(0.0, |roof| self.outcome.peaks.of(*roof).displacement.value)
    }

    /// Signed peak shear force in a structure's first storey \[N\].
    pub(crate) fn peak_shear(self, structure: usize) -> f64 {
        let first = self.floors(structure).first();
        first.map_or(0.0, |first| self.outcome.peaks.of(*first).restoring_force.value)
    }

    /// Number of collisions of a structure, and start \[s\] and impulse \[N·s\] of the first.
    pub(crate) fn collisions(self, structure: usize) -> (usize, Option<(f64, f64)>) {
        let beside = |pair: usize| {
            let facing = self.floors.facing()[pair];
            let places = [facing.left, facing.right];
            places.iter().any(|floor| self.floors(structure).contains(floor))
        };
        let all = self.outcome.collisions.all().iter();
        let own = all.filter(|one| beside(one.pair));
        let first = own.clone().min_by(|a, b| a.start.total_cmp(&b.start));
        (own.count(), first.map(|first| (first.start, first.impulse)))
    }

    /// Plastic drift of every storey of a structure at every instant of the history \[m\]; empty for a wall.
    pub(super) fn plastic_drifts(self, structure: usize) -> Vec<Vec<f64>> {
        let histories = self.outcome.histories.as_ref().expect("the studies used here keep histories");
        let storey = |floor: &usize| {
            let storey = &self.floors.all()[*floor];
            let stiffness = storey.made_of?.columns.stiffness_n_per_m;
            let peak = self.outcome.peaks.of(*floor).drift().value;
            // An elastic storey has no plastic drift; without this test rounding would give one.
            let yielded = storey.ductility(peak).is_some_and(|ductility| ductility.abs() > 1.0);
            let below = self.floors.below(*floor);
            let below = below.map(|below| &histories.of(below).states);
            let states = histories.of(*floor).states.iter().enumerate();
            let plastic = states.map(|(instant, state)| {
                let ground = below.map_or(0.0, |below| below[instant].displacement);
                if yielded {
                    state.displacement - ground - state.restoring_force / stiffness
                } else {
                    0.0
                }
            });
            Some(plastic.collect())
        };
        self.floors(structure).iter().filter_map(storey).collect()
    }

    /// Plastic displacement of a structure's roof at the end of the history \[m\]; `None` for a wall.
    pub(crate) fn residual(self, structure: usize) -> Option<f64> {
        let drifts = self.plastic_drifts(structure);
        let last = |drift: &Vec<f64>| drift.last().copied();
        drifts.iter().map(last).reduce(|below, drift| Some(below? + drift?))?
    }
}
