//! Questions of the surveys, with their settings.

use crate::listed::listed;
use serde::{Deserialize, Serialize};

/// The question of a survey.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Survey {
    /// Widths of gaps against design rules, and the effect of wider gaps.
    RequiredGap(RequiredGap),
    /// Pounding forces, impulses and amplifications over both periods.
    PoundingSpectra(PoundingSpectra),
    /// Probability of touching and of larger drifts, over gap and intensity.
    Fragility(Fragility),
    /// Effect of pounding on the middle one of three structures, over the stiffness of the others.
    StiffnessRatio(StiffnessRatio),
    /// Influence of uncertain inputs.
    Sensitivity(Sensitivity),
}

/// Pairs of neighbouring elastic structures under every motion in both directions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RequiredGap {
    /// Natural periods of the left structure, the longer ones \[s\], > 0.
    pub longer_periods_s: Vec<f64>,
    /// Natural period of the right structure over that of the left one \[–\], > 0, not 1: equal neighbours need no gap.
    pub period_ratios: Vec<f64>,
    /// Pairs for which gaps narrower than required are compared.
    pub scan: Scan,
}

/// A series of gaps from 0 to the required one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scan {
    /// Natural periods of the left structure \[s\], > 0.
    pub longer_periods_s: Vec<f64>,
    /// Natural period of the right structure over that of the left one \[–\].
    pub period_ratios: Vec<f64>,
    /// Number of gaps, equally spaced from 0 to just below the required one.
    pub n_gaps: usize,
}

/// Two structures with uncertain inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sensitivity {
    /// Number of rows of each sample matrix; powers of two spread most evenly.
    pub samples: usize,
    /// Repetitions of the bootstrap.
    pub bootstrap: usize,
    /// Gap \[m\], uniformly distributed.
    pub gap_m: Range,
    /// Coefficient of restitution e \[–\], uniformly distributed.
    pub restitution: Range,
    /// Impact stiffness β̄ \[N/m^1.5\] with a uniformly distributed logarithm.
    pub impact_stiffness_n_per_m1_5: Range,
    /// Damping ratio of both structures \[–\], uniformly distributed.
    pub damping_ratio: Range,
    /// Factor on the ground acceleration \[–\], uniformly distributed.
    pub intensity: Range,
    /// Whether the motion varies too: each of the list of `beyond.json` is equally likely. Otherwise the first one is used.
    pub vary_motion: bool,
}

/// The ends of an interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
}

impl Range {
    pub(crate) fn uniform(self, part: f64) -> f64 {
        self.from + part * (self.to - self.from)
    }

    pub(crate) fn log_uniform(self, part: f64) -> f64 {
        self.from * libm::exp(part * libm::log(self.to / self.from))
    }
}

/// Two elastic structures with every pair of periods, under some motions in both directions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PoundingSpectra {
    /// Natural periods of either structure \[s\], > 0, rising by a constant ratio.
    pub periods_s: Vec<f64>,
    /// Gap over the root of the sum of squares of both peak displacements without a neighbour \[–\].
    pub gaps_over_srss: Vec<f64>,
    /// Mass of the right structure over that of the left one \[–\], > 0.
    pub mass_ratios: Vec<f64>,
    /// Names of motions from the list of `beyond.json`.
    pub motions: Vec<String>,
    /// Number of randomly chosen runs that are repeated to test how many of their digits are reliable.
    pub checked: usize,
}

/// Layouts of three structures in which the stiffness of some varies.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StiffnessRatio {
    /// Name of the structures whose stiffness varies; their yield displacement stays.
    pub stiff: String,
    /// Name of the structures whose stiffness is the unit of the ratio.
    pub weak: String,
    /// Stiffness of the stiff structures over that of the weak ones \[–\], > 0, rising.
    pub stiffness_ratios: Vec<f64>,
    /// Properties of the stiff structures that stay as in the scenes.
    pub keeps: Vec<HeldConstant>,
    /// The paper's case among the motions: its name, and whether it is reversed.
    pub papers: (String, bool),
}

listed! {
    /// A property that stays while the stiffness varies.
    #[derive(Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum HeldConstant { word: &'static str;
        /// The mass: the natural period falls as stiffness grows.
        Mass = "mass",
        /// The natural period: mass grows with stiffness.
        Period = "period",
    }
}

/// Two structures under random motions of one kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fragility {
    /// Number of motions. Their seeds count up from the seed of the scene's own motion.
    pub motions: u64,
    /// Peak ground accelerations to which each motion is scaled \[m/s²\], > 0.
    pub pga_m_per_s2: Vec<f64>,
    /// Gaps \[m\], ≥ 0.
    pub gaps_m: Vec<f64>,
    /// Thresholds for the peak displacement over that without a neighbour \[–\].
    pub amplifications: Vec<f64>,
}
