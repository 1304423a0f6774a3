//! The ground motions of scenes side by side: one for all of them, or one for each.

use std::ops::RangeInclusive;

use fearless_simd::Simd;

use super::number::{Lanes, MOST_LANES};
use super::rows::Rows;
use pounding_solver::formulas::require;
use pounding_solver::{Excitation, RunError};

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

/// Groups of scenes that go in step, at most.
pub(super) const GROUPS: usize = 2;

/// Ground accelerations of groups of scenes at the nodes of a clock \[m/s²\].
pub(super) trait Grounds {
    /// What is kept of a node.
    type Node;

    /// The nodes from one step to another one, of groups of rows.
    fn nodes<S: Simd, Column>(
        &mut self,
        groups: &[Rows<'_, Column>; GROUPS],
        steps: RangeInclusive<usize>,
    ) -> &[Self::Node];

    /// The accelerations of the groups at a node.
    fn at<S: Simd>(simd: S, node: &Self::Node) -> [Lanes<S>; GROUPS];
}

/// One motion for all scenes, with all of its nodes.
pub(super) struct Common<'a>(pub(super) &'a [f64]);

impl Grounds for Common<'_> {
    type Node = f64;

    #[inline(always)]
    fn nodes<S: Simd, Column>(
        &mut self,
        _: &[Rows<'_, Column>; GROUPS],
        steps: RangeInclusive<usize>,
    ) -> &[f64] {
        &self.0[steps]
    }

    #[inline(always)]
    fn at<S: Simd>(simd: S, node: &f64) -> [Lanes<S>; GROUPS] {
        [Lanes::splat(simd, *node); GROUPS]
    }
}

/// A motion for every scene, sampled piece by piece.
pub(super) struct Own<'a> {
    each: &'a [Excitation<'a>],
    time_step: f64,
    piece: Vec<[[f64; MOST_LANES]; GROUPS]>,
}

impl<'a> Own<'a> {
    pub(super) fn new(each: &'a [Excitation<'a>], time_step: f64) -> Self {
        Self {
            each,
            time_step,
            piece: Vec::new(),
        }
    }
}

impl Grounds for Own<'_> {
    type Node = [[f64; MOST_LANES]; GROUPS];

    fn nodes<S: Simd, Column>(
        &mut self,
        groups: &[Rows<'_, Column>; GROUPS],
        steps: RangeInclusive<usize>,
    ) -> &[Self::Node] {
        let of_lane = |rows: &Rows<'_, Column>, lane: usize| {
            self.each[rows.scene(lane)].at_steps(self.time_step)
        };
        let motions: [[_; MOST_LANES]; GROUPS] = groups
            .each_ref()
            .map(|rows| std::array::from_fn(|lane| of_lane(rows, lane)));
        // A group without scenes repeats the first one.
        let repeats = groups[1].first == groups[0].first;
        let n_groups = if repeats { 1 } else { GROUPS };
        self.piece.clear();
        // Node by node: lane by lane, all nodes would pass through the cache for every lane.
        self.piece.extend(steps.map(|step| {
            let mut node = Self::Node::default();
            for (lanes, motions) in node.iter_mut().zip(&motions[..n_groups]) {
                for (lane, motion) in lanes.iter_mut().zip(motions).take(Lanes::<S>::N) {
                    *lane = motion(step);
                }
            }
            if repeats {
                node[1] = node[0];
            }
            node
        }));
        &self.piece
    }

    #[inline(always)]
    fn at<S: Simd>(simd: S, [one, other]: &Self::Node) -> [Lanes<S>; GROUPS] {
        [Lanes::new(simd, one), Lanes::new(simd, other)]
    }
}
