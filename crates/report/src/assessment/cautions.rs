//! What harms the answer of an assessment: in short beside it, and as warnings.

use pounding_assess::{DesignSpectrum, TargetFit};
use pounding_scene::{Excess, Implausible};
use pounding_text::{digits, short, two_decimals, two_digits};

use super::{AssessedMotion, AssessmentReport};

/// Least number of records whose mean a code takes: ASCE 7-16, 16.2.2.
const ENOUGH: usize = 11;

impl AssessmentReport {
    /// Records that belong to other earthquakes by the factors that they need, once for both directions.
    fn far(&self) -> Vec<&AssessedMotion> {
        let is_usual = |scale| (Implausible::USUAL_FACTORS[0]..=Implausible::USUAL_FACTORS[1]).contains(&scale);
        let first = self.motions.first().and_then(|one| one.neighbour);
        let once = |one: &&AssessedMotion| !one.reversed && one.neighbour == first;
        let once = self.motions.iter().filter(once);
        once.filter(|one| !is_usual(one.run.scale)).collect()
    }

    /// Unusual values in the scene and in its records, which precede the answer.
    pub fn unusual(&self) -> Vec<Implausible> {
        let all = self.motions.iter();
        Implausible::gathered(all.flat_map(|one| {
            let doubts = one.run.unusual.iter();
            doubts.map(|doubt| (one.name.as_str(), doubt))
        }))
    }

    /// What the answer rests on and should not, in a sentence before it, whether or not the gap is enough.
    pub fn cautions(&self) -> Option<String> {
        let beyond = self.excesses().into_iter();
        let beyond = beyond.filter(|one| one.kind.is_caution());
        let mut said: Vec<String> = beyond.map(|one| one.brief()).collect();
        let least = self.fit.as_ref().map(|fit| fit.least().0);
        said.extend(least.filter(|share| *share < TargetFit::LEAST_SHARE).map(|share| {
            let per_cent = (100.0 * share).floor();
            format!("the mean spectrum has {per_cent:.0} % of the target")
        }));
        let more = "the warnings say more";
        (!said.is_empty()).then(|| format!("Caution: {}; {more}.", said.join("; ")))
    }

    /// What harms the answer, the worst first.
    pub fn warnings(&self) -> Vec<String> {
        let mut said: Vec<String> = self.excesses().iter().map(ToString::to_string).collect();
        said.extend(self.misfit());
        let far: Vec<String> = self
            .far()
            .into_iter()
            .map(|one| format!("{} × {}", one.name, short(one.run.scale)))
            .collect();
        if !far.is_empty() {
            said.push(format!(
                "scaled by less than {} or more than {}: {}; records that need such factors belong to other earthquakes",
                digits(Implausible::USUAL_FACTORS[0]),
                digits(Implausible::USUAL_FACTORS[1]),
                far.join(", ")
            ));
        }
        let events = self.assessment.events;
        if events < ENOUGH {
            let found = match events {
                1 => "records of one event".into(),
                n => format!("records of {n} events"),
            };
            said.push(format!(
                "{found}: ASCE 7-16, 16.2.2, wants {ENOUGH} and EN 1998-1, 4.3.3.4.3, 7 for a mean; medians of so few say little"
            ));
        }
        if self.motions.iter().all(|one| (one.run.scale - 1.0).abs() <= 0.0) {
            said.push("the records are not scaled: the answer is one for their earthquakes, not for a site; set one with the options scale and target".into());
        }
        said
    }

    /// What a mean spectrum below the target asks for.
    fn misfit(&self) -> Option<String> {
        let fit = self.fit.as_ref()?;
        let (share, period) = fit.least();
        let (share, what) = if share < TargetFit::LEAST_SHARE {
            (share, format!("at {} s", two_digits(period)))
        } else if fit.peak_share < 1.0 && matches!(self.target(), Some(DesignSpectrum::Eurocode8 { .. })) {
            return Some(format!(
                "the mean peak acceleration of the scaled records is {:.0} % of that of the target; EN 1998-1, 3.2.3.1.2 (4) b, wants all \
                 of it",
                (100.0 * fit.peak_share).floor()
            ));
        } else {
            return None;
        };
        Some(format!(
            "the mean spectrum of the scaled records has {:.0} % of the target {what}; EN 1998-1, 3.2.3.1.2 (4) c, and ASCE 7-16, \
             16.2.3.2, want {:.0} % between 0.2 and 2 T_1: take other records, or scale to {} times the target",
            (100.0 * share).floor(),
            100.0 * TargetFit::LEAST_SHARE,
            two_decimals((100.0 * TargetFit::LEAST_SHARE / share).ceil() / 100.0)
        ))
    }

    /// Responses beyond the model or beyond codes, over all runs.
    pub(super) fn excesses(&self) -> Vec<Excess> {
        let runs = self.motions.iter();
        Excess::gathered(runs.map(|one| &one.run.excesses))
    }

    /// Whether something may touch that nobody looked at.
    pub(super) fn leaves_out(&self) -> bool {
        let mut all = self.excesses().into_iter();
        all.any(|one| one.kind.is_unwatched())
    }
}
