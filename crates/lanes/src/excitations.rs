//! The ground motions of scenes in lanes: one for all, or one for each.

use std::ops::RangeInclusive;

use fearless_simd::Simd;

use super::number::{Lanes, MOST_LANES};
use super::rows::Rows;
use pounding_solver::formulas::require;
use pounding_solver::{Excitation, RunError};

/// The ground motions of scenes.
#[derive(Debug, Clone, Copy)]
pub enum Excitations<'a> {
    /// A motion for all scenes.
    Common(Excitation<'a>),
    /// A motion for each scene, in the order of the scenes.
    Each(&'a [Excitation<'a>]),
}

impl<'a> From<Excitation<'a>> for Excitations<'a> {
    fn from(excitation: Excitation<'a>) -> Self {
        Self::Common(excitation)
    }
}

impl<'a> Excitations<'a> {
    /// The motions of at least one scene: a common motion if all samples are at the same address.
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

    /// Whether there is a motion for each of this many scenes.
    pub(super) fn are_for(&self, n_scenes: usize) -> bool {
        match self {
            Self::Common(_) => true,
            Self::Each(each) => each.len() == n_scenes,
        }
    }

    /// Time between two samples \[s\].
    ///
    /// # Errors
    /// [`RunError::Setting`] if it differs between motions.
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
        require(found.total_cmp(&step).is_eq(), "excitation.time_step", found, allowed)?;
        Ok(step)
    }

    /// The motion of a scene.
    pub(super) fn of_scene(&self, scene: usize) -> Excitation<'a> {
        match self {
            Self::Common(excitation) => *excitation,
            Self::Each(each) => each[scene],
        }
    }
}

/// Ground accelerations of a group of scenes at the nodes of a clock \[m/s²\].
pub(super) enum Grounds<'a> {
    /// A motion for all scenes, sampled at all nodes.
    Common(&'a [f64]),
    /// A motion for each scene, sampled piece by piece.
    Own(Own<'a>),
}

/// A motion for each scene.
pub(super) struct Own<'a> {
    each: &'a [Excitation<'a>],
    time_step: f64,
    /// Number of the first node of the piece.
    first: usize,
    piece: Vec<[f64; MOST_LANES]>,
}

impl<'a> Grounds<'a> {
    /// Grounds with a motion for each scene.
    pub(super) fn own(each: &'a [Excitation<'a>], time_step: f64) -> Self {
        Self::Own(Own {
            each,
            time_step,
            first: 0,
            piece: Vec::new(),
        })
    }

    /// Samples the nodes of some steps of a group.
    pub(super) fn sample<S: Simd, Column>(&mut self, rows: Rows<'_, Column>, steps: RangeInclusive<usize>) {
        let Self::Own(own) = self else {
            return;
        };
        let motion = |lane: usize| own.each[rows.scene(lane)].at_steps(own.time_step);
        let motions: [_; MOST_LANES] = std::array::from_fn(motion);
        own.first = *steps.start();
        own.piece.clear();
        // Node by node: lane by lane, all nodes would pass through the cache for every lane.
        own.piece.extend(steps.map(|step| {
            let mut node = [0.0; MOST_LANES];
            for (value, motion) in node.iter_mut().zip(&motions).take(Lanes::<S>::N) {
                *value = motion(step);
            }
            node
        }));
    }

    /// The accelerations at a sampled node.
    #[inline(always)]
    pub(super) fn at<S: Simd>(&self, simd: S, step: usize) -> Lanes<S> {
        match self {
            Self::Common(nodes) => Lanes::splat(simd, nodes[step]),
            Self::Own(own) => Lanes::new(simd, &own.piece[step - own.first]),
        }
    }
}
