//! The ground motions of scenes side by side: one for all of them, or one for each.

use fearless_simd::Simd;

use super::number::Lanes;
use super::rows::Rows;
use crate::error::require;
use crate::{Clock, Excitation, RunError};

/// The ground motions of scenes.
#[derive(Debug, Clone, Copy)]
pub enum Excitations<'a> {
    /// All scenes have this one.
    Common(Excitation<'a>),
    /// Each scene has its own, in the order of the scenes.
    Each(&'a [Excitation<'a>]),
}

impl<'a> From<Excitation<'a>> for Excitations<'a> {
    fn from(excitation: Excitation<'a>) -> Self {
        Self::Common(excitation)
    }
}

impl<'a> Excitations<'a> {
    /// Those of scenes, of which there is at least one: one for all where their samples lie at one place.
    pub fn of(each: &'a [Excitation<'a>]) -> Self {
        let are_one = |two: &[Excitation<'_>]| {
            let at_one_place = std::ptr::eq(two[0].samples(), two[1].samples());
            at_one_place && two[0].time_step().total_cmp(&two[1].time_step()).is_eq()
        };
        match each.first() {
            Some(first) if each.windows(2).all(are_one) => Self::Common(*first),
            _ => Self::Each(each),
        }
    }

    /// Whether there is one for each of so many scenes.
    pub(super) fn are_for(&self, n_scenes: usize) -> bool {
        match self {
            Self::Common(_) => true,
            Self::Each(each) => each.len() == n_scenes,
        }
    }

    /// Time between two samples \[s\].
    ///
    /// # Errors
    /// [`RunError::Setting`] where it is not the same for all.
    pub(super) fn time_step(&self) -> Result<f64, RunError> {
        let all = match self {
            Self::Common(excitation) => std::slice::from_ref(excitation),
            Self::Each(each) => each,
        };
        let step = all.first().map_or(f64::NAN, Excitation::time_step);
        let mut steps = all.iter().map(Excitation::time_step);
        let other = steps.find(|other| other.total_cmp(&step).is_ne());
        let found = other.unwrap_or(step);
        let allowed = "the same for all scenes side by side";
        require(
            found.total_cmp(&step).is_eq(),
            "excitation.time_step",
            found,
            allowed,
        )?;
        Ok(step)
    }

    /// That of a scene.
    pub(super) fn of_scene(&self, scene: usize) -> Excitation<'a> {
        match self {
            Self::Common(excitation) => *excitation,
            Self::Each(each) => each[scene],
        }
    }
}

/// Ground motions at the nodes of a clock.
#[derive(Debug, Clone)]
pub(super) struct Sampled<'a> {
    pub(super) excitations: Excitations<'a>,
    pub(super) clock: Clock,
    /// Acceleration of the common one at every node \[m/s²\]; others are sampled when their scenes run.
    common: Vec<f64>,
}

impl<'a> Sampled<'a> {
    pub(super) fn new(excitations: Excitations<'a>, clock: Clock) -> Self {
        let common = match excitations {
            Excitations::Common(excitation) => excitation.sampled(clock).collect(),
            Excitations::Each(_) => Vec::new(),
        };
        Self {
            excitations,
            clock,
            common,
        }
    }

    /// The motions of groups of rows up to a step; `room` keeps those that differ.
    pub(super) fn in_lanes<'b, S: Simd, Column>(
        &'b self,
        groups: &[Rows<'_, Column>],
        n_steps: usize,
        room: &'b mut Vec<f64>,
    ) -> Grounds<'b> {
        let Excitations::Each(each) = self.excitations else {
            return Grounds::Common(&self.common);
        };
        let clock = Clock {
            n_steps,
            ..self.clock
        };
        let (n_lanes, n_groups) = (Lanes::<S>::N, groups.len());
        room.clear();
        room.resize((n_steps + 1) * n_groups * n_lanes, 0.0);
        let mut last: Option<(usize, usize)> = None;
        for (group, rows) in groups.iter().enumerate() {
            for lane in 0..n_lanes {
                let (scene, column) = (rows.scene(lane), group * n_lanes + lane);
                let nodes = room.chunks_exact_mut(n_groups * n_lanes);
                match last {
                    // Lanes without a scene repeat the one before.
                    Some((before, its)) if before == scene => {
                        nodes.for_each(|node| node[column] = node[its]);
                    }
                    _ => {
                        let samples = each[scene].sampled(clock);
                        nodes
                            .zip(samples)
                            .for_each(|(node, sample)| node[column] = sample);
                    }
                }
                last = Some((scene, column));
            }
        }
        Grounds::Each {
            samples: room,
            n_groups,
        }
    }
}

/// Ground accelerations of some groups of scenes at the nodes of a clock \[m/s²\].
#[derive(Clone, Copy)]
pub(super) enum Grounds<'a> {
    Common(&'a [f64]),
    /// For each node those of all groups, lane by lane.
    Each {
        samples: &'a [f64],
        n_groups: usize,
    },
}

impl Grounds<'_> {
    /// At a node, of the scenes of a group.
    #[inline(always)]
    pub(super) fn at<S: Simd>(&self, simd: S, node: usize, group: usize) -> Lanes<S> {
        match self {
            Self::Common(samples) => Lanes::splat(simd, samples[node]),
            Self::Each { samples, n_groups } => {
                let first = (node * n_groups + group) * Lanes::<S>::N;
                Lanes::from_slice(simd, &samples[first..first + Lanes::<S>::N])
            }
        }
    }

    /// At t = 0, in a lane of a group.
    pub(super) fn first<S: Simd>(&self, group: usize, lane: usize) -> f64 {
        match self {
            Self::Common(samples) => samples[0],
            Self::Each { samples, .. } => samples[group * Lanes::<S>::N + lane],
        }
    }
}
