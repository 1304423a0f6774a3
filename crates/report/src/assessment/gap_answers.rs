//! The sentences of an assessment about gaps: whether each is enough, and which width is proposed.

use pounding_assess::{Distribution, GapAssessment, Separation, TargetFit};
use pounding_scene::ExcessKind;
use pounding_text::{millimetres, millimetres_up, percent, two_decimals, two_digits};

use super::cautions::BESIDE;
use super::{AssessedMotion, AssessmentReport};
use crate::folder::factor;
use crate::rules::{RuledGap, asked};
use crate::whatever_gap::{Standing, says_beyond};

impl AssessmentReport {
    /// The least part of the target that the mean spectrum has, and its period, if a code asks for more.
    pub(super) fn too_weak(&self) -> Option<(f64, f64)> {
        let least = self.fit.as_ref().map(TargetFit::least);
        least.filter(|(share, _)| *share < TargetFit::LEAST_SHARE)
    }

    /// Why these records do not show which gap is enough; `None` if they do.
    pub(super) fn unfounded(&self) -> Option<String> {
        if let Some((share, period)) = self.too_weak() {
            return Some(format!(
                "the mean spectrum of the records has {:.0} % of the target at {} s, and codes want {:.0} %",
                (100.0 * share).floor(),
                two_digits(period),
                100.0 * TargetFit::LEAST_SHARE
            ));
        }
        (self.assessment.believed_alone() == 0).then(|| self.says_fallen(&format!("under every {}", self.sample())))
    }

    /// The width that is proposed for a gap: the largest that is needed, or that of the named code if it asks for more. `None` if these records
    /// do not show which one is enough.
    pub(super) fn proposal(&self, gap: &GapAssessment) -> Option<f64> {
        let width = self.asked_width(gap);
        (width > Separation::ALIKE && self.unfounded().is_none()).then(|| gap.built(width))
    }

    /// The largest width that is needed, or that of the named code if it asks for more \[m\].
    fn asked_width(&self, gap: &GapAssessment) -> f64 {
        gap.largest().max(self.by_named_code(gap).unwrap_or(0.0))
    }

    /// Whether the scene gives no gap, or a narrower one than is asked for.
    pub(super) fn is_wanting(&self, gap: &GapAssessment) -> bool {
        let width = self.asked_width(gap);
        // A wider hinge takes away the contact that holds a deck on its seat.
        width > Separation::ALIKE && self.seat(gap).is_none() && gap.own.is_none_or(|own| own < width)
    }

    /// The width that the named code asks for \[m\]; `None` if none is named, or if it has no width here: a code takes all events.
    fn by_named_code(&self, gap: &GapAssessment) -> Option<f64> {
        let code = self
            .code
            .filter(|_| self.assessment.disbelieved_alone == 0 && self.seat(gap).is_none())?;
        let rule = gap.rules.iter().find(|one| one.rule == code)?;
        Some(asked(rule, self.sample()).0)
    }

    /// Whether a width may be called enough, by [`Standing`].
    pub(super) fn says_enough(&self) -> bool {
        let standing = Standing {
            over: self.over_capacity(),
            isolators: self.isolators_over(),
            may_fall: self.has_untold_seats(),
            strained: self.strained_alone(),
            fallen: self.fallen(),
        };
        standing.may_be_enough()
    }

    /// Width of the seat in a gap \[m\], and in how many samples some floor leaves it; `None` without a seat.
    pub(super) fn seat(&self, gap: &GapAssessment) -> Option<(f64, usize)> {
        let contact = self.scene.contacts.as_ref()?.get(gap.left)?;
        let pairs = self.assessment.pairs.iter().zip(self.floors.facing());
        let own = pairs.filter(|(_, facing)| facing.contact == gap.left);
        let unseated = own.filter_map(|(pair, _)| pair.unseated).max();
        Some((contact.seat_width_m?, unseated.unwrap_or(0)))
    }

    /// Whether a deck stays on its seat, in a sentence; empty without a seat.
    fn says_seat(&self, gap: &GapAssessment) -> String {
        match self.seat(gap) {
            None => String::new(),
            Some((width, 0)) => {
                let wider = if gap.touching > 0 {
                    "; at a wider gap decks move farther"
                } else {
                    ""
                };
                format!(
                    " The seat of {} mm is wide enough at the gap of the scene{wider}.",
                    millimetres(width)
                )
            }
            Some((width, n)) => format!(
                " At the gap of the scene a deck leaves its seat of {} mm in {}: no wider gap helps, but longer seats or restrainers.",
                millimetres(width),
                self.of_cases(n)
            ),
        }
    }

    /// "the largest of 4 events".
    pub(super) fn largest_of(&self, of: &Distribution) -> String {
        match of.sorted().len() {
            1 => format!("the only {}", self.sample()),
            n => format!("the largest of {n} {}s", self.sample()),
        }
    }

    /// The answer: a sentence or two for each gap, those first whose neighbours touch in most runs.
    pub fn answers(&self) -> Vec<String> {
        let mut gaps: Vec<&GapAssessment> = self.assessment.gaps.iter().collect();
        gaps.sort_by_key(|gap| std::cmp::Reverse(gap.touching));
        let answers = gaps.into_iter().map(|gap| self.answer_of(gap));
        answers.chain(self.prior()).chain(self.by_code()).collect()
    }

    /// The widths that the named code asks for.
    fn by_code(&self) -> Vec<String> {
        let code = self.code.filter(|_| self.assessment.believed_alone() > 0);
        let gaps = code.into_iter().flat_map(|code| {
            let ruled = self.ruled_gaps().into_iter();
            ruled.map(move |gap| gap.by_code(&self.scene, code))
        });
        gaps.collect()
    }

    /// Every gap as rules see it.
    pub(super) fn ruled_gaps<'a>(&'a self) -> Vec<RuledGap<'a>> {
        let ruled = |gap: &'a GapAssessment| RuledGap {
            left: gap.left,
            own: gap.own,
            needed: gap.required.largest(),
            rules: &gap.rules,
            not_counted: self.says_not_counted(),
            sample: self.sample(),
        };
        self.assessment.gaps.iter().map(ruled).collect()
    }

    /// Whether a gap is enough, and the danger of floors that face columns.
    fn answer_of(&self, gap: &GapAssessment) -> String {
        if self.assessment.believed_alone() == 0 {
            return self.says_no_width(gap) + &self.says_seat(gap);
        }
        let answer = self.answer_of_floors(gap);
        let danger = gap.beside_columns.zip(self.floors.says_columns(gap.left)).map(|(width, columns)| {
            let keeps = if width < gap.required.largest() {
                let counted = if self.assessment.disbelieved_alone > 0 {
                    "the motions that count"
                } else {
                    "these motions"
                };
                format!(" {} mm keep floors from columns under {counted}.", millimetres_up(width))
            } else {
                " So wide a gap keeps them apart, too.".into()
            };
            format!("{answer} {columns}{keeps}")
        });
        danger.unwrap_or(answer) + &self.says_seat(gap)
    }

    /// Why a gap has no width, and whether its neighbours touch.
    fn says_no_width(&self, gap: &GapAssessment) -> String {
        let [left, right] = self.gap_names(gap);
        let why = self.says_fallen(&format!("under every {}", self.sample()));
        let touch = gap.own.map_or_else(String::new, |own| {
            format!(
                " With the {} mm of the scene they touch in {}.",
                millimetres(own),
                self.touch_in(gap)
            )
        });
        format!("No width is given for {left} and {right}: {why}.{touch}")
    }

    fn answer_of_floors(&self, gap: &GapAssessment) -> String {
        let [left, right] = self.gap_names(gap);
        let runs = self.assessment.runs;
        let needed = gap.required.largest();
        let Some(own) = gap.own else {
            return format!("{left} and {right}: {}", self.would_do(gap, "is enough"));
        };
        let width = millimetres(own);
        if gap.touching == 0 && needed <= Separation::ALIKE {
            return format!(
                "{left} and {right} touch in none of {runs} runs, because they move alike: the gap closes by less than 1 mm. That rests on \
                 equal periods and masses; change one of them by a few per cent before {width} mm is called enough."
            );
        }
        if gap.touching == 0 && own >= needed {
            let floors = if own < gap.largest() { " for floors that face floors" } else { "" };
            let n = gap.required.sorted().len();
            let samples = if n == 1 {
                format!("the only {}", self.sample())
            } else {
                format!("these {n} {}s", self.sample())
            };
            let apart = format!(
                "they touch in none of {runs} runs, and need {} mm under {samples}",
                millimetres_up(needed)
            );
            return match self.unfounded().or_else(|| self.says_not_counted()) {
                None if !self.says_enough() || self.seat(gap).is_some_and(|(_, off)| off > 0) => format!(
                    "{width} mm keeps{floors} {left} and {right} apart: {apart}.{}",
                    self.margin(own, gap)
                ),
                None => format!(
                    "{width} mm is enough{floors} between {left} and {right}: {apart}.{}",
                    self.margin(own, gap)
                ),
                Some(why) => format!("{width} mm is not shown to be enough{floors} between {left} and {right}: {apart}, but {why}."),
            };
        }
        if gap.touching == 0 {
            let why = self.floors.left_out(gap.left);
            let why = why.map_or_else(
                || "because their other neighbours hold them".into(),
                |levels| format!("because {levels} were not looked at"),
            );
            return format!(
                "{width} mm is not enough between {left} and {right}: they need {} mm while nothing touches. In these runs they do not touch, {why}.",
                millimetres_up(needed)
            );
        }
        if own >= needed {
            return self.wide_but_touching(own, gap);
        }
        format!(
            "{width} mm is not enough between {left} and {right}: they touch in {}. {}",
            self.touch_in(gap),
            self.would_do(gap, "would be enough")
        )
    }

    /// Neighbours that touch although their gap is as wide as they need: in events that do not count, or pushed by another neighbour.
    fn wide_but_touching(&self, own: f64, gap: &GapAssessment) -> String {
        let [left, right] = self.gap_names(gap);
        let (width, touch) = (millimetres(own), self.touch_in(gap));
        match self.says_not_counted() {
            Some(why) => format!(
                "{width} mm is not shown to be enough between {left} and {right}: it is as wide as the events that count need, but they touch \
                 in {touch}, and {why}."
            ),
            None => format!(
                "{width} mm is as wide as {left} and {right} need while nothing touches, but they touch in {touch}, pushed by another \
                 neighbour: the other gaps decide."
            ),
        }
    }

    /// The width that is enough, in a sentence: "130 mm would be enough for all 11 events."
    fn would_do(&self, gap: &GapAssessment, enough: &str) -> String {
        let enough = if !self.says_enough() {
            "would keep floors apart"
        } else if self.seat(gap).is_some() {
            "would keep the decks apart"
        } else {
            enough
        };
        if let Some(why) = self.unfounded() {
            let needed = millimetres_up(gap.required.largest());
            return format!(
                "Under these records they need {needed} mm, {}, but {why}.{}",
                self.largest_of(&gap.required),
                self.decides(gap)
            );
        }
        let [most, all] = [gap.built(gap.required.upper()), gap.proposal()].map(millimetres);
        let samples = self.sample();
        let is_one = !gap.required.has_quantiles() || most == all || gap.own.is_some_and(|own| gap.built(gap.required.upper()) <= own);
        let others = if self.assessment.gaps.len() > 1 {
            ", if every other gap of the row stays open, too"
        } else {
            ""
        };
        let fallen = self.fallen();
        if fallen.doubted > 0 {
            let keeps = if is_one {
                format!("{all} mm keeps floors apart in {}", fallen.others())
            } else {
                format!("{most} mm keeps floors apart in 84 % of {}, {all} mm in all", fallen.others())
            };
            return format!("{keeps}{others}{}.{}", fallen.whatever(), self.decides(gap));
        }
        let said = match gap.required.sorted().len() {
            1 => format!("{all} mm {enough} for the only {samples}"),
            2 => format!("{all} mm {enough} for both {samples}s"),
            n if is_one => format!("{all} mm {enough} for all {n} {samples}s"),
            n => format!("{most} mm {enough} for 84 % of the {n} {samples}s, {all} mm for all"),
        };
        format!("{said}{others}.{}", self.decides(gap))
    }

    /// The motion that asks for the largest width, in a sentence; empty for a single event.
    fn decides(&self, gap: &GapAssessment) -> String {
        let widest = gap.required.largest();
        let asks = |one: &&AssessedMotion| {
            let mut own = one.run.separations.iter().filter(|own| own.left == gap.left);
            own.any(|own| own.required.total_cmp(&widest).is_eq())
        };
        let believed = self.motions.iter().filter(|one| one.run.disbelieved_alone.is_none());
        let motion = believed.chain(&self.motions).find(asks);
        let motion = motion.filter(|_| self.assessment.events > 1 && widest > Separation::ALIKE);
        motion.map_or_else(String::new, |one| {
            let past = one.run.disbelieved_beside.as_ref().filter(|_| one.run.disbelieved_alone.is_none());
            let past = past.map_or_else(String::new, |past| {
                format!(
                    ", where with the gap of the scene {} is past the model {BESIDE} ({})",
                    past.name,
                    past.kind.brief(past.found)
                )
            });
            format!(" Largest under {}{}{past}.", one.shown(), factor(one.run.scale))
        }) + &self.beyond(gap)
    }

    /// The motion that does not count and asks for the largest width, in a sentence, if that is more than those ask that count. A building that
    /// falls needs no width.
    fn beyond(&self, gap: &GapAssessment) -> String {
        let asked = self.motions.iter().filter_map(|one| {
            let doubted = one
                .run
                .disbelieved_alone
                .as_ref()
                .filter(|doubted| doubted.kind != ExcessKind::Collapse)?;
            let own = one.run.separations.iter().find(|own| own.left == gap.left)?;
            Some((own.required, one, doubted))
        });
        let largest = asked.max_by(|one, other| one.0.total_cmp(&other.0));
        let largest = largest.filter(|(required, ..)| *required > gap.required.largest());
        largest.map_or_else(String::new, |(required, one, doubted)| {
            format!(
                " Under {}{}, which does not count ({}), they would need {} mm.",
                one.shown(),
                factor(one.run.scale),
                says_beyond(doubted),
                millimetres_up(required)
            )
        })
    }

    /// Why a gap that stays open under some events is not enough under all; `None` if all events count.
    fn says_not_counted(&self) -> Option<String> {
        let n = self.assessment.disbelieved_alone;
        (n > 0).then(|| self.says_fallen(&format!("in {}", self.of_cases(n))))
    }

    /// "a building would hardly stand even alone in 2 of 9 events".
    fn says_fallen(&self, when: &str) -> String {
        let fallen = self.fallen();
        format!("{} even {} {when}", fallen.says(), fallen.words.alone)
    }

    /// The proposed width of every gap that is not enough, and the chance that remains; what bumpers do, if they were asked for.
    pub fn proposals(&self) -> Vec<String> {
        let gaps = self.assessment.gaps.iter();
        let wanting: Vec<&GapAssessment> = gaps.filter(|gap| self.is_wanting(gap)).collect();
        // Where no event counts, the answer of every gap says so.
        if wanting.is_empty() || self.assessment.believed_alone() == 0 {
            return self.bumper_says();
        }
        let mut said = vec![match self.unfounded() {
            Some(why) => format!("No gap is proposed: {why}."),
            None => self.proposed(&wanting),
        }];
        said.extend(self.bumper_says());
        said
    }

    fn proposed(&self, wanting: &[&GapAssessment]) -> String {
        let widths = wanting.iter().map(|gap| {
            let [left, right] = self.gap_names(gap);
            let width = self.proposal(gap).unwrap_or_else(|| gap.proposal());
            format!("{} mm between {left} and {right}", millimetres(width))
        });
        let widths: Vec<String> = widths.collect();
        let neighbours = self.neighbours().len();
        let n = match neighbours {
            0 => self.assessment.believed_alone(),
            _ => self.assessment.events,
        };
        let together = if widths.len() > 1 { ", together" } else { "" };
        let code = self.code.map(|code| code.words().edition);
        let asks = wanting
            .iter()
            .any(|gap| self.by_named_code(gap).is_some_and(|width| width > gap.largest()));
        let why = match code.filter(|_| asks) {
            Some(code) => format!("the largest needed, and what {code} asks for, rounded up"),
            None if self.assessment.disbelieved_alone > 0 => format!("the largest needed in {}, rounded up", self.fallen().others()),
            None => "the largest needed, rounded up".into(),
        };
        let chance = self.chance(n, asks);
        let is_moat = |gap: &&GapAssessment| [gap.left, gap.left + 1].into_iter().any(|one| self.floors.is_isolated(one));
        let moat = if wanting.iter().any(is_moat) {
            " Beside isolators that is their displacement under these motions: codes size a moat for their largest earthquake, with torsion, and \
             the isolators have to bear it."
        } else {
            ""
        };
        let only = if self.says_enough() {
            ""
        } else {
            " to keep floors apart, for no more"
        };
        format!("Proposed{only}{together}: {} ({why}).{moat}{chance}", widths.join(", "))
    }

    /// The chance that the next earthquake needs more than these `n` samples did, in a sentence; `asks` tells whether a code asks for more.
    fn chance(&self, n: usize, asks: bool) -> String {
        // The events that count are no sample if others were left out because a building would not stand, or if most belong elsewhere.
        if self.assessment.disbelieved_alone > 0 || 2 * self.far().len() > self.records() {
            return String::new();
        }
        let like = if n == 1 {
            "of the kind of this one".into()
        } else {
            format!("of the kind of these {n}")
        };
        let beside = match self.neighbours().len() {
            0 => String::new(),
            n => format!(" beside one of the {n} neighbours that were drawn; others may need more"),
        };
        // The share that exceeds the largest of n is below 1 − 0.05^(1/n) with 95 %.
        let at_most = 1.0 - libm::pow(0.05, 1.0 / n as f64);
        let at_most = if n < Distribution::ENOUGH {
            String::new()
        } else {
            format!("; with so few events it may be one in {}", two_digits(1.0 / at_most))
        };
        let more = if asks {
            "more than they did (not more than the code asks)"
        } else {
            "more"
        };
        format!(
            " If the next earthquake is {like}, it needs {more} in about one case of {}{at_most}{beside}.",
            n + 1
        )
    }

    /// How much wider a gap is than the widest needed, if that is less than the standard deviation of the logarithms of the widths. Then
    /// another motion of the kind may well need more.
    fn margin(&self, own: f64, gap: &GapAssessment) -> String {
        let widths = [gap.largest(), gap.required.largest()];
        let more = own / widths.into_iter().find(|width| *width <= own).unwrap_or(own);
        match gap.required.dispersion() {
            Some(spread) if libm::log(more) < spread => format!(
                " It is {} times as wide, less than a standard deviation of the widths ({} times): another motion may well need more.",
                two_decimals(more),
                two_decimals(libm::exp(spread))
            ),
            Some(_) => String::new(),
            None => format!(
                " The margin is {}, and one {} tells no spread: another motion may well need more.",
                percent(more - 1.0),
                self.sample()
            ),
        }
    }
}
