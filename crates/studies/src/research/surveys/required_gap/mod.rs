//! How wide a gap must be, against what rules ask for, and what a wider gap that is still too narrow does.
//!
//! Structures at rest touch exactly where the gap is narrower than the largest closing of both standing alone: until they
//! touch first, each moves as if it were alone. Whether they touch is so monotone in the gap, and the required width needs no
//! search. What touching does is not: [`gaps`] looks for wider gaps that are worse than narrower ones.

mod figure;
mod gaps;
mod widths;

use super::cases::{Case, rows, sdof, set_period};
use super::{Files, csv, drawn};
use crate::study::surveys::{RequiredGap, Scan};
use crate::{StudyError, StudyFile};
use pounding_scene::Scene;

/// A pair under a motion.
#[derive(Debug, Clone, Copy)]
struct Asked<'a> {
    case: &'a Case,
    longer: f64,
    ratio: f64,
}

/// Every pair under every motion, pair after pair.
fn asked<'a>(cases: &'a [Case], longer: &[f64], ratios: &[f64]) -> Vec<Asked<'a>> {
    let mut all = Vec::new();
    for &ratio in ratios {
        for &longer in longer {
            let of = |case| Asked { case, longer, ratio };
            all.extend(cases.iter().map(of));
        }
    }
    all
}

impl Asked<'_> {
    /// The scene with both periods.
    fn scene(self, template: &Scene) -> Scene {
        let mut scene = template.clone();
        set_period(sdof(&mut scene, 0), self.longer);
        set_period(sdof(&mut scene, 1), self.longer * self.ratio);
        scene
    }
}

pub(super) fn files(settings: &RequiredGap, file: &StudyFile, cases: &[Case]) -> Result<Files, StudyError> {
    let template = &rows(file, 2)?[0];
    let widths = widths::Widths::of(settings, template, cases)?;
    let gaps = gaps::Gaps::of(&settings.scan, template, cases)?;
    Ok(Files::from([
        ("widths.csv".into(), widths.table()),
        ("rules.csv".into(), widths.rules()),
        ("rules.png".into(), drawn(&figure::rules(&widths), file)?),
        ("unsafe.png".into(), drawn(&figure::shares(&widths), file)?),
        ("gaps.csv".into(), gaps.table()),
        ("wider-and-worse.csv".into(), gaps.summary()),
        ("wider-and-worse.png".into(), drawn(&figure::gaps(&gaps), file)?),
    ]))
}
