//! What harms the answer of an assessment: in short beside it, and as warnings.

use std::collections::{BTreeMap, BTreeSet};

use pounding_assess::{AssessedRun, Case, DesignSpectrum, Distribution, RunOfCase, Scaling, TargetFit, beyond_belief};
use pounding_scene::{Excess, ExcessKind, Implausible};
use pounding_text::{digits, short, two_decimals, two_digits};

use super::{AssessedMotion, AssessmentReport, runs_of_cases};
use crate::folder::CONVERT;
use crate::whatever_gap::{Fallen, NO_SEATS, isolators_over, over_capacity, says_beyond, says_isolators, says_over_capacity};

/// Where buildings meet.
pub(super) const BESIDE: &str = "beside its neighbours";

/// Least number of records whose mean a code takes: ASCE 7-16, 16.2.2.
const ENOUGH: usize = 11;

impl AssessmentReport {
    /// Records that belong to other earthquakes by the factors that they need, once for both directions.
    pub(super) fn far(&self) -> Vec<&AssessedMotion> {
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

    /// Sentences before the answer, whether or not the gap is enough: buildings that no gap helps, how records were raised, what is not
    /// believed and does not count, and on what the answer rests and should not.
    pub fn before(&self) -> Vec<String> {
        let widths = self.assessment.believed_alone() > 0;
        let first = says_over_capacity(&self.over_capacity(), self.scene.words(), widths)
            .into_iter()
            .chain(self.isolators_over().map(|over| says_isolators(&over, widths)))
            .chain(self.off_seats())
            .chain(self.has_untold_seats().then(|| NO_SEATS.into()))
            .chain(self.raised());
        first.chain(self.disbelieved()).chain(self.cautions()).collect()
    }

    /// Every building that exceeds a capacity of the scene even alone.
    pub(super) fn over_capacity(&self) -> Vec<Excess> {
        let runs = runs_of_cases(&self.motions);
        let all = runs
            .iter()
            .flat_map(|one| one.run.over_capacity_alone.iter().map(|excess| (one.case(), excess)));
        over_capacity(&self.floors, &all.collect::<Vec<_>>(), self.assessment.cases, self.sample())
    }

    /// The cases that are not believed while the buildings stand alone.
    pub(super) fn fallen(&self) -> Fallen {
        Fallen {
            of: self.assessment.cases,
            doubted: self.assessment.disbelieved_alone,
            collapsed: self.assessment.collapsed_alone,
            sample: self.sample(),
            words: self.scene.words(),
        }
    }

    /// How much stronger all records are than their own factors make them.
    pub fn raised(&self) -> Option<String> {
        let Scaling::Raised { by, from, .. } = &self.scaling.to else {
            return None;
        };
        let [from, least] = [*from, self.fit.as_ref()?.least().0].map(|share| (100.0 * share).floor());
        Some(format!(
            "Scaled one by one, the records have a mean spectrum with {from:.0} % of the target at worst. All numbers are for records {} times \
             as strong, whose mean has {least:.0} %.",
            digits(*by)
        ))
    }

    /// Events whose runs are beyond belief, and do not count.
    fn disbelieved(&self) -> Vec<String> {
        let runs = runs_of_cases(&self.motions);
        let found = |of: fn(&AssessedRun) -> Option<&Excess>| {
            let found = self.motions.iter().zip(&runs);
            let found = found.filter_map(move |(motion, one)| Some((one.case(), motion, of(&motion.run)?)));
            found.collect::<Vec<_>>()
        };
        let alone = found(|run| run.disbelieved_alone.as_ref());
        let not_alone: BTreeSet<Case> = alone.iter().map(|(case, ..)| *case).collect();
        let mut beside = found(|run| run.disbelieved_beside.as_ref());
        beside.retain(|(case, ..)| !not_alone.contains(case));
        let said = [
            self.says_disbelieved(&alone, &format!("even {}, whatever the gap", self.scene.words().alone), "these"),
            self.says_disbelieved(&beside, BESIDE, "forces and effects of these"),
        ];
        said.into_iter().flatten().collect()
    }

    /// Cases that are not believed, in a sentence that names the worst; `None` if there are none.
    fn says_disbelieved(&self, all: &[(Case, &AssessedMotion, &Excess)], when: &str, what: &str) -> Option<String> {
        let worst = beyond_belief(all.iter().map(|(.., excess)| *excess))?;
        let (_, motion, _) = all.iter().find(|(.., excess)| std::ptr::eq(*excess, worst))?;
        let cases: BTreeSet<Case> = all.iter().map(|(case, ..)| *case).collect();
        let collapsed = all.iter().filter(|(.., excess)| excess.kind == ExcessKind::Collapse);
        let collapsed: BTreeSet<Case> = collapsed.map(|(case, ..)| *case).collect();
        let fallen = Fallen {
            doubted: cases.len(),
            collapsed: collapsed.len(),
            ..self.fallen()
        };
        let counts = if fallen.doubted == fallen.of {
            "nothing below is to be believed".into()
        } else if self.assessment.disbelieved == fallen.of && when == BESIDE {
            "no effect of touching below is to be believed".into()
        } else {
            format!("{what} do not count below")
        };
        Some(format!(
            "In {} {} {when} ({}, under {}): {counts}.",
            self.of_cases(fallen.doubted),
            fallen.says(),
            says_beyond(worst),
            motion.name
        ))
    }

    /// On what the answer rests and should not.
    fn cautions(&self) -> Option<String> {
        // The first sentences say what exceeds its capacity even alone.
        let over: Vec<Excess> = self.over_capacity().into_iter().chain(self.isolators_over()).collect();
        let is_said = |one: &Excess| {
            over.iter()
                .any(|other| (other.kind, other.floor) == (one.kind, one.floor) && other.found >= one.found)
        };
        let beyond = self.excesses().into_iter();
        let beyond = beyond.filter(|one| one.is_caution() && !is_said(one));
        let mut said: Vec<String> = beyond.map(|one| one.brief()).collect();
        said.extend(self.folder.units_apart.clone());
        said.extend(self.too_weak().map(|(share, _)| {
            let per_cent = (100.0 * share).floor();
            format!("the mean spectrum has {per_cent:.0} % of the target")
        }));
        let far = self.far();
        let how_far = |one: &&AssessedMotion| libm::log(one.run.scale.abs()).abs();
        if let Some(most) = far.iter().copied().max_by(|one, other| how_far(one).total_cmp(&how_far(other))) {
            said.push(format!(
                "{} of {} motions scaled too far, the farthest by {} ({})",
                far.len(),
                self.records(),
                short(most.run.scale),
                most.name
            ));
        }
        if self.is_unscaled() {
            said.push("the records are not scaled to a site".into());
        }
        let more = "the warnings say more";
        (!said.is_empty()).then(|| format!("Caution: {}; {more}.", said.join("; ")))
    }

    /// Whether every record shakes the row as strongly as its file says.
    fn is_unscaled(&self) -> bool {
        self.motions.iter().all(|one| (one.run.scale - 1.0).abs() <= 0.0)
    }

    /// What harms the answer, the worst first.
    pub fn warnings(&self) -> Vec<String> {
        let mut said: Vec<String> = self.excesses().iter().map(ToString::to_string).collect();
        let counted = RunOfCase::believed(&runs_of_cases(&self.motions));
        said.extend(Excess::says_assumed(&self.floors, |floor| {
            let floors = counted.iter().map(|one| &one.run.floors[floor]);
            let drifts = floors.map(|one| one.over_stiffness[1].drift.max(one.alone.drift));
            drifts.fold(0.0, f64::max)
        }));
        said.extend(self.folder.units_apart.as_ref().map(|said| format!("{said}: {CONVERT}")));
        said.extend(self.unseated());
        said.extend(self.misfit());
        let far: Vec<String> = self
            .far()
            .into_iter()
            .map(|one| format!("{} × {}", one.name, short(one.run.scale)))
            .collect();
        if !far.is_empty() {
            said.push(format!(
                "scaled by less than {} or more than {}: {}; records that need such factors belong to other earthquakes; \
                 --max-scale {} leaves out those that need more",
                digits(Implausible::USUAL_FACTORS[0]),
                digits(Implausible::USUAL_FACTORS[1]),
                far.join(", "),
                digits(Implausible::USUAL_FACTORS[1])
            ));
        }
        let events = self.assessment.events;
        if events < ENOUGH {
            let found = match events {
                1 => "records of one event".into(),
                n => format!("records of {n} events"),
            };
            said.push(format!(
                "{found}: ASCE 7-16, 16.2.2, wants {ENOUGH}; EN 1998-1, 4.3.3.4.3, takes the mean of {} or more and the largest of fewer",
                Distribution::ENOUGH
            ));
        }
        if self.is_unscaled() {
            said.push(
                "the records are not scaled: the answer is one for their earthquakes, not for a site; set one with --scale or --target"
                    .into(),
            );
        }
        said
    }

    /// The isolators that move farthest beyond their capacity.
    pub(super) fn isolators_over(&self) -> Option<Excess> {
        isolators_over(self.excesses())
    }

    /// Whether the row is a bridge whose seats the scene does not tell.
    pub(super) fn has_untold_seats(&self) -> bool {
        self.floors.is_bridge() && !self.scene.has_seats()
    }

    /// Number of samples in which a building alone exceeds a general limit of drift or ductility.
    pub(super) fn strained_alone(&self) -> usize {
        let runs = runs_of_cases(&self.motions);
        let strained = runs.iter().filter(|one| !one.run.excesses_alone.is_empty());
        strained.map(RunOfCase::case).collect::<BTreeSet<Case>>().len()
    }

    /// The decks that leave their seats at the gaps of the scene, in a sentence.
    pub(super) fn off_seats(&self) -> Option<String> {
        let pairs = self.assessment.pairs.iter().enumerate();
        let off = pairs.filter_map(|(pair, one)| Some((one.unseated.filter(|n| *n > 0)?, pair)));
        let off: Vec<String> = off
            .map(|(n, pair)| format!("{} in {}", self.floors.names(pair).join(" – "), self.of_cases(n)))
            .collect();
        (!off.is_empty()).then(|| format!("Decks leave their seats at the gaps of the scene: {}.", off.join(", ")))
    }

    /// Floors that leave their seats.
    fn unseated(&self) -> Vec<String> {
        let pairs = self.assessment.pairs.iter().enumerate();
        let unseated = pairs.filter_map(|(pair, one)| {
            let n = one.unseated.filter(|n| *n > 0)?;
            let names = self.floors.names(pair).join(" – ");
            Some(format!(
                "{names}: unseated in {}: the right side moves farther away from the left one than its seat is wide, and may fall (seat_width_m)",
                self.of_cases(n)
            ))
        });
        unseated.collect()
    }

    /// What a mean spectrum below the target asks for.
    fn misfit(&self) -> Option<String> {
        let fit = self.fit.as_ref()?;
        if let Some((share, period)) = self.too_weak() {
            let raise = two_decimals((100.0 * TargetFit::LEAST_SHARE / share).ceil() / 100.0);
            let is_maximum = self.scaling.to.target().is_some_and(|target| target.maximum_direction);
            let (which, asce) = if is_maximum {
                ("in the maximum direction", "ASCE/SEI 7-16, 16.2.3.2, compares the same with MCE_R")
            } else {
                (
                    "component by component",
                    "ASCE/SEI 7-16, 16.2.3.2, compares maximum-direction spectra with MCE_R, which is not done here",
                )
            };
            return Some(format!(
                "the mean spectrum of the scaled records, {which}, has {:.0} % of the target at {} s; EN 1998-1:2004, \
                 3.2.3.1.2 (4) c, wants {:.0} % between 0.2 and 2 T_1: take records with a spectrum like the target, since records that are \
                 {raise} times as strong would belong to other earthquakes. {asce}",
                (100.0 * share).floor(),
                two_digits(period),
                100.0 * TargetFit::LEAST_SHARE
            ));
        }
        let spectrum = self.scaling.to.target().map(|target| &target.spectrum);
        let is_eurocode = matches!(spectrum, Some(DesignSpectrum::Eurocode8 { .. }));
        (is_eurocode && fit.peak_share < 1.0).then(|| {
            format!(
                "the mean peak acceleration of the scaled records is {:.0} % of that of the target; EN 1998-1, 3.2.3.1.2 (4) b, wants all \
                 of it",
                (100.0 * fit.peak_share).floor()
            )
        })
    }

    /// Responses beyond the model or beyond codes, event by event. Responses alone are those of the events that widths come from, responses
    /// beside the neighbours those of the events that effects come from; slabs and columns that meet count in every event.
    pub(super) fn excesses(&self) -> Vec<Excess> {
        let runs = runs_of_cases(&self.motions);
        let mut cases: BTreeMap<Case, Vec<Excess>> = runs.iter().map(|one| (one.case(), Vec::new())).collect();
        let cases_of = |runs: &[RunOfCase<'_>]| runs.iter().map(RunOfCase::case).collect::<BTreeSet<Case>>();
        let [alone, beside] = [RunOfCase::believed_alone(&runs), RunOfCase::believed(&runs)].map(|runs| cases_of(&runs));
        for one in &runs {
            let found = cases.entry(one.case()).or_default();
            let counts = |excess: &&Excess| beside.contains(&one.case()) || excess.kind.is_of_contact();
            found.extend(one.run.excesses.iter().filter(counts).cloned());
            let of_alone = one.run.excesses_alone.iter().filter(|_| alone.contains(&one.case()));
            found.extend(of_alone.cloned());
        }
        Excess::gathered(cases.values(), self.sample())
    }

    /// Whether something may touch that nobody looked at.
    pub(super) fn leaves_out(&self) -> bool {
        let mut all = self.excesses().into_iter();
        all.any(|one| one.kind.is_unwatched())
    }
}
