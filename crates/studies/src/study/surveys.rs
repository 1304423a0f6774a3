//! What surveys ask.

use crate::listed::listed;
use serde::{Deserialize, Serialize};

/// What a survey asks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Survey {
    /// The width of a gap against the rules for it, and what wider gaps do.
    RequiredGap(RequiredGap),
    /// Pounding forces, impulses and amplifications over both periods.
    PoundingSpectra(PoundingSpectra),
    /// Probability of touching, and of larger drifts, over gap and intensity.
    Fragility(Fragility),
    /// What pounding does to the middle of three structures, over the stiffness of the others.
    StiffnessRatio(StiffnessRatio),
    /// Which inputs matter.
    Sensitivity(Sensitivity),
}

/// Pairs of elastic structures that stand side by side, under every motion in both directions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RequiredGap {
    /// Natural periods of the left structure, the longer ones \[s\], > 0.
    pub longer_periods_s: Vec<f64>,
    /// Natural periods of the right one over those \[–\], > 0, other than 1: equal neighbours need no gap.
    pub period_ratios: Vec<f64>,
    /// Where wider gaps are looked at that still are too narrow.
    pub scan: Scan,
}

/// Gaps from 0 to the required one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scan {
    /// Natural periods of the left structure \[s\], > 0.
    pub longer_periods_s: Vec<f64>,
    /// Natural periods of the right one over those \[–\].
    pub period_ratios: Vec<f64>,
    /// Number of gaps, at equal distances from 0 to just below the required one.
    pub n_gaps: usize,
}

/// Two structures with uncertain inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sensitivity {
    /// Rows of either matrix of samples; a power of two is the most even.
    pub samples: usize,
    /// Repetitions of the bootstrap.
    pub bootstrap: usize,
    /// Gap \[m\], uniform.
    pub gap_m: Range,
    /// Coefficient of restitution e \[–\], uniform.
    pub restitution: Range,
    /// Impact stiffness β̄ \[N/m^1.5\], its logarithm uniform.
    pub impact_stiffness_n_per_m1_5: Range,
    /// Damping ratio of both structures \[–\], uniform.
    pub damping_ratio: Range,
    /// Factor on the ground acceleration \[–\], uniform.
    pub intensity: Range,
    /// Whether the motion is one of the list of `beyond.json` by chance, too, all equally likely; else it is the first.
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

/// Two elastic structures of every pair of periods, under some motions in both directions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PoundingSpectra {
    /// Natural periods of either structure \[s\], > 0, rising at equal ratios.
    pub periods_s: Vec<f64>,
    /// Gaps over the root of the sum of squares of both peak displacements alone \[–\].
    pub gaps_over_srss: Vec<f64>,
    /// Mass of the right structure over that of the left one \[–\], > 0.
    pub mass_ratios: Vec<f64>,
    /// Names of the motions, of the list of `beyond.json`.
    pub motions: Vec<String>,
    /// How many runs, chosen at random, are made once more to see what their digits are worth.
    pub checked: usize,
}

/// Layouts of three structures, the stiffness of some of which varies.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StiffnessRatio {
    /// Name of the structures whose stiffness varies; their yield displacement stays.
    pub stiff: String,
    /// Name of the structures by whose stiffness theirs is counted.
    pub weak: String,
    /// Stiffness of the stiff over that of the weak ones \[–\], > 0, rising.
    pub stiffness_ratios: Vec<f64>,
    /// What of the stiff structures stays as the scenes have it.
    pub keeps: Vec<HeldConstant>,
    /// The case of the paper among the motions: its name, and whether it is reversed.
    pub papers: (String, bool),
}

listed! {
    /// What stays as stiffness varies.
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
    /// Number of motions; their seeds count from that of the scene's own motion.
    pub motions: u64,
    /// Peak ground accelerations to which each is scaled \[m/s²\], > 0.
    pub pga_m_per_s2: Vec<f64>,
    /// Gaps \[m\], ≥ 0.
    pub gaps_m: Vec<f64>,
    /// Peak displacements over those alone that are exceeded \[–\].
    pub amplifications: Vec<f64>,
}
