//! The sentences of an assessment, for the terminal and the page.

use pounding_assess::{Distribution, FloorAssessment, GapAssessment, PairAssessment};
use pounding_text::two_digits;

use super::AssessmentReport;

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

    /// The answer in full: what it rests on, the gaps, how many records may be missing, the proposals, and the effects of touching.
    pub fn sentences(&self) -> Vec<String> {
        let answers = self.before().into_iter().chain(self.answers());
        let more = self.proposals().into_iter().chain(self.consequences());
        answers.chain(self.folder.missing.clone()).chain(more).collect()
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
        said.extend(self.folder.of_tables.iter().cloned());
        said.push(format!("scaled {}", self.scaling.to));
        if let Some(fit) = &self.fit {
            let (share, period) = fit.least();
            let [first, last] = [fit.periods[0], fit.periods[fit.periods.len() - 1]];
            said.push(format!(
                "their mean spectrum has at least {:.0} % of the target from {} to {} s (least at {} s); their mean peak acceleration is {:.0} % of \
                 the target's",
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
    pub(super) fn touch_in(&self, gap: &GapAssessment) -> String {
        let runs = format!("{} of {} runs", gap.touching_runs, self.assessment.runs);
        match self.assessment.cases {
            1 => format!("the only {} ({runs})", self.sample()),
            _ => format!("{} ({runs})", self.of_cases(gap.touching)),
        }
    }

    /// The storeys that get worse by touching, isolation layers left out, with their numbers in the row: first those whose drift or shear
    /// force grows, then those whose acceleration alone grows; the largest growth first.
    pub fn worse(&self) -> Vec<(usize, &FloorAssessment)> {
        let floors = self.assessment.floors.iter().enumerate();
        let columns = floors.filter(|(index, _)| !self.floors.all()[*index].is_isolation_layer());
        let worse = columns.filter_map(|(index, floor)| Some((index, floor.as_ref()?)));
        let mut worse: Vec<_> = worse.filter(|(_, floor)| floor.is_worse()).collect();
        worse.sort_by(|one, other| {
            let [one, other] = [one.1, other.1].map(Worst::of);
            let first = other.strains.cmp(&one.strains);
            first.then(other.ratio.upper().total_cmp(&one.ratio.upper()))
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

/// The response of a storey that harms it most.
struct Worst<'f> {
    /// Whether it strains the columns.
    strains: bool,
    ratio: &'f Distribution,
}

impl<'f> Worst<'f> {
    /// The response that grows most: drift or shear force if they get worse, else the acceleration.
    fn of(floor: &'f FloorAssessment) -> Self {
        let strain = if floor.drift.upper() >= floor.shear.upper() {
            &floor.drift
        } else {
            &floor.shear
        };
        let strains = strain.upper() > FloorAssessment::WORSE;
        Self {
            strains,
            ratio: if strains { strain } else { &floor.acceleration },
        }
    }
}
