//! The sentences of an assessment, for the terminal and the page.

use pounding_assess::{Distribution, FloorAssessment, GapAssessment, PairAssessment};
use pounding_text::{digits, millimetres, millimetres_up, percent, two_decimals, two_digits};

use super::AssessmentReport;
use crate::rules::RuledGap;

impl AssessmentReport {
    /// Name of a floor: that of its building, and its number; of a structure of one storey and a wall its own.
    pub fn floor_name(&self, floor: usize) -> String {
        self.floors.all()[floor].name.clone()
    }

    /// Names of the neighbours of a gap.
    pub fn gap_names(&self, gap: &GapAssessment) -> [&str; 2] {
        [gap.left, gap.left + 1].map(|index| self.scene.structures[index].name())
    }

    /// Number of records: each shakes the row in both directions.
    pub(super) fn records(&self) -> usize {
        let mut names: Vec<&str> = self.motions.iter().map(|one| one.name.as_str()).collect();
        names.dedup();
        names.len()
    }

    /// Number of motions, and of events if those are fewer: "22 motions of 11 events".
    pub fn motions_of_events(&self) -> String {
        let (motions, events) = (self.records(), self.assessment.events);
        let number = |n: usize, word: &str| match n {
            1 => format!("one {word}"),
            n => format!("{n} {word}s"),
        };
        if events == motions {
            return number(motions, "motion");
        }
        format!("{} of {}", number(motions, "component"), number(events, "event"))
    }

    /// The answer in full: missing records and doubtful assumptions, the gaps, the proposals, and the effects of touching.
    pub fn sentences(&self) -> Vec<String> {
        let answers = self.before().into_iter().chain(self.answers());
        let more = self.proposals().into_iter().chain(self.consequences());
        answers.chain(more).collect()
    }

    /// Sentences before the answer: how many records of the folder may be missing, and doubtful assumptions.
    pub fn before(&self) -> Vec<String> {
        let missing = self.folder.missing.clone();
        missing.into_iter().chain(self.cautions()).collect()
    }

    /// The motions in a few lines: how many, of how many events, and how strong they are compared with the target.
    pub fn shaking(&self) -> Vec<String> {
        let neighbours = match self.neighbours().len() {
            0 => String::new(),
            n => format!(" beside each of {n} neighbours"),
        };
        let of = if self.folder.counts.is_empty() {
            self.motions_of_events()
        } else {
            self.folder.counts.clone()
        };
        let runs = self.assessment.runs;
        let mut said = vec![format!("{of}; both directions each{neighbours}: {runs} runs")];
        said.push(format!("scaled {}", self.scaling.to));
        if let Some(fit) = &self.fit {
            let (share, period) = fit.least();
            let [first, last] = [fit.periods[0], fit.periods[fit.periods.len() - 1]];
            said.push(format!(
                "their mean spectrum has at least {:.0} % of the target from {} to {} s (at {} s), and {:.0} % of its peak ground \
                 acceleration",
                (100.0 * share).floor(),
                two_digits(first),
                two_digits(last),
                two_digits(period),
                (100.0 * fit.peak_share).floor()
            ));
        }
        said
    }

    /// The word for a sample: an event, or an event beside a neighbour that was drawn.
    pub(super) fn sample(&self) -> &'static str {
        if self.neighbours().is_empty() { "event" } else { "case" }
    }

    /// "9 of 11 events".
    pub fn of_cases(&self, count: usize) -> String {
        let n = self.assessment.cases;
        let s = if n == 1 { "" } else { "s" };
        format!("{count} of {n} {}{s}", self.sample())
    }

    /// "9 of 11 events (18 of 44 runs)".
    fn touch_in(&self, gap: &GapAssessment) -> String {
        let runs = format!("{} of {} runs", gap.touching_runs, self.assessment.runs);
        match self.assessment.cases {
            1 => format!("the only {} ({runs})", self.sample()),
            _ => format!("{} ({runs})", self.of_cases(gap.touching)),
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
        let gaps = self.code.into_iter().flat_map(|code| {
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
            sample: self.sample(),
        };
        self.assessment.gaps.iter().map(ruled).collect()
    }

    /// Whether a gap is enough, and the danger of floors that face columns.
    fn answer_of(&self, gap: &GapAssessment) -> String {
        let answer = self.answer_of_floors(gap);
        let danger = gap.beside_columns.zip(self.floors.says_columns(gap.left)).map(|(width, columns)| {
            let keeps = format!("{} mm keep floors from columns under these motions.", millimetres_up(width));
            format!("{answer} {columns} {keeps}")
        });
        danger.unwrap_or(answer)
    }

    fn answer_of_floors(&self, gap: &GapAssessment) -> String {
        let [left, right] = self.gap_names(gap);
        let (runs, samples) = (self.assessment.runs, self.sample());
        let needed = gap.required.largest();
        let [most, all] = [gap.built(gap.required.p84()), gap.proposal()].map(millimetres);
        match gap.own {
            None => format!("{left} and {right} need {most} mm for 84 % of the {samples}s, {all} mm for all."),
            Some(own) if gap.touching == 0 && own >= needed => format!(
                "{} mm is enough between {left} and {right}: they touch in none of {runs} runs, and need {} mm at most.{}",
                millimetres(own),
                millimetres_up(needed),
                margin(own, gap)
            ),
            Some(own) if gap.touching == 0 => {
                let why = self.floors.left_out(gap.left);
                let why = why.map_or_else(
                    || "because their other neighbours hold them".into(),
                    |levels| format!("because {levels} were not looked at"),
                );
                format!(
                    "{} mm is not enough between {left} and {right}: alone they need {} mm. In these runs they do not touch, {why}.",
                    millimetres(own),
                    millimetres_up(needed)
                )
            }
            // Buildings that stand alone need less; one that is pushed by its other neighbour may need more.
            Some(own) if own >= needed => format!(
                "{} mm would be enough between {left} and {right}, but they touch in {}, pushed by another neighbour: \
                 the other gaps decide.",
                millimetres(own),
                self.touch_in(gap)
            ),
            Some(own) => {
                let most = if most == all || gap.built(gap.required.p84()) <= own {
                    format!("{all} mm would be enough for all")
                } else {
                    format!("{most} mm would be enough for 84 % of the {samples}s, {all} mm for all")
                };
                format!(
                    "{} mm is not enough between {left} and {right}: they touch in {}. {most}.",
                    millimetres(own),
                    self.touch_in(gap)
                )
            }
        }
    }

    /// The proposed width of every gap that is not enough, and the chance that remains.
    pub fn proposals(&self) -> Vec<String> {
        let n = self.assessment.events;
        let gaps = self.assessment.gaps.iter();
        let wanting = gaps.filter(|gap| gap.own.is_none_or(|own| own < gap.largest()));
        let widths = wanting.map(|gap| {
            let [left, right] = self.gap_names(gap);
            format!("{} mm between {left} and {right}", millimetres(gap.proposal()))
        });
        let widths: Vec<String> = widths.collect();
        if widths.is_empty() {
            return Vec::new();
        }
        let like = if n == 1 {
            "like this one".into()
        } else {
            format!("like these {n}")
        };
        let together = if widths.len() > 1 { ", together" } else { "" };
        let beside = match self.neighbours().len() {
            0 => String::new(),
            n => format!(" beside one of the {n} neighbours that were drawn; others may need more"),
        };
        let mut said = vec![format!(
            "Proposed{together}: {} (the largest needed, rounded up). A further event {like} needs more with a chance of at most 1 in {} for \
             each gap{beside}.",
            widths.join(", "),
            n + 1
        )];
        said.extend(self.bumper_says());
        said
    }

    /// The storeys that get worse by touching, isolation layers left out, with their numbers in the row: first those whose drift or shear force grows, then those whose
    /// acceleration alone grows; the largest growth first.
    pub fn worse(&self) -> Vec<(usize, &FloorAssessment)> {
        let floors = self.assessment.floors.iter().enumerate();
        let columns = floors.filter(|(index, _)| !self.floors.all()[*index].is_isolation_layer());
        let worse = columns.filter_map(|(index, floor)| Some((index, floor.as_ref()?)));
        let mut worse: Vec<_> = worse.filter(|(_, floor)| floor.is_worse()).collect();
        worse.sort_by(|one, other| {
            let [one, other] = [one.1, other.1].map(Worst::of);
            let first = other.strains.cmp(&one.strains);
            first.then(other.ratio.p84().total_cmp(&one.ratio.p84()))
        });
        worse
    }

    /// The pairs that touch, those first with the largest force, or without forces the largest speed; their numbers in the row.
    pub fn hit(&self) -> Vec<(usize, &PairAssessment)> {
        let pairs = self.assessment.pairs.iter().enumerate();
        let mut hit: Vec<_> = pairs.filter(|(_, pair)| pair.touching > 0).collect();
        let force = |pair: &PairAssessment| pair.peak_force.as_ref().map_or(0.0, |[_, high]| high.largest());
        let speed = |pair: &PairAssessment| pair.approach_speed.unwrap_or(0.0);
        hit.sort_by(|(_, one), (_, other)| {
            let by_force = force(other).total_cmp(&force(one));
            by_force.then(speed(other).total_cmp(&speed(one)))
        });
        hit
    }
}

/// How much wider a gap is than the widest needed, if that is less than the standard deviation of the logarithms of the widths. Then another
/// motion of the kind may well need more.
fn margin(own: f64, gap: &GapAssessment) -> String {
    let more = own / gap.largest();
    match gap.required.dispersion() {
        Some(spread) if libm::log(more) < spread => format!(
            " The margin of {} is less than the spread of the widths (σ ln {}): another motion may well need more.",
            percent(more - 1.0),
            two_decimals(spread)
        ),
        Some(_) => String::new(),
        None => format!(
            " The margin is {}, and one event tells no spread: another motion may well need more.",
            percent(more - 1.0)
        ),
    }
}

/// So many storeys that get worse.
fn get_worse(count: usize) -> String {
    match count {
        1 => "one storey gets worse".into(),
        n => format!("{n} storeys get worse"),
    }
}

/// The response of a storey that harms it most.
struct Worst<'f> {
    /// Whether it strains the columns.
    strains: bool,
    what: &'static str,
    ratio: &'f Distribution,
}

impl<'f> Worst<'f> {
    /// The response that grows most: drift or shear force if they get worse, else the acceleration.
    fn of(floor: &'f FloorAssessment) -> Self {
        let (what, ratio) = if floor.drift.p84() >= floor.shear.p84() {
            ("drift", &floor.drift)
        } else {
            ("shear force", &floor.shear)
        };
        if ratio.p84() > FloorAssessment::WORSE {
            return Self {
                strains: true,
                what,
                ratio,
            };
        }
        Self {
            strains: false,
            what: "acceleration",
            ratio: &floor.acceleration,
        }
    }
}

impl AssessmentReport {
    /// The effects of touching, in a sentence each: the storey that gets worst, and the hardest pair.
    pub fn consequences(&self) -> Vec<String> {
        let mut said = Vec::new();
        let worse = self.worse();
        if let Some((floor, one)) = worse.first() {
            let Worst { what, ratio, .. } = Worst::of(one);
            said.push(format!(
                "When they touch, {} by more than 10 %; {} most: its {what} becomes up to {} times as large in 84 % of those \
                 {}s, and {} times in the median.",
                get_worse(worse.len()),
                self.floor_name(*floor),
                two_decimals(ratio.p84()),
                self.sample(),
                two_decimals(ratio.median()),
            ));
        }
        if let Some((index, pair)) = self.hit().first() {
            let facing = self.floors.facing()[*index];
            let [left, right] = [facing.left, facing.right].map(|floor| self.floor_name(floor));
            let [from, to] = self.stiffness.map(digits);
            said.push(match &pair.peak_force {
                Some([low, high]) => format!(
                    "Hardest pair: {left} – {right}, {} kN (median of the {}s with the contact that gives least) to {} kN (largest of all \
                     runs and contacts), for {from} to {to} times the impact stiffness of the scene, which nobody knows better.",
                    two_digits(1e-3 * low.median()),
                    self.sample(),
                    two_digits(1e-3 * high.largest())
                ),
                None => format!(
                    "{left} – {right} meet with up to {} m/s; the contact law of the scene has no force.",
                    two_digits(pair.approach_speed.unwrap_or(0.0))
                ),
            });
        }
        said.extend(self.by_stiffness());
        said
    }

    /// What the range of the stiffness of contact changes besides forces.
    fn by_stiffness(&self) -> Option<String> {
        let effect = self.assessment.by_stiffness.as_ref()?;
        let all = [&effect.drift, &effect.impulse, &effect.acceleration];
        let ratios = all.map(Distribution::p84);
        let [drift, impulse, acceleration] = ratios.map(by);
        (ratios.iter().any(|ratio| *ratio >= 1.01)).then(|| {
            format!(
                "In 84 % of all cases that stiffness changes a drift {drift}, the largest impulse of a pair {impulse}, and a floor's \
                 acceleration {acceleration} at most."
            )
        })
    }
}

/// A ratio of the largest over the least in words: by a per cent, from twice on a factor.
fn by(ratio: f64) -> String {
    if ratio > 2.0 {
        format!("to {} times", two_digits(ratio))
    } else {
        format!("by {:.0} %", 100.0 * (ratio - 1.0))
    }
}
