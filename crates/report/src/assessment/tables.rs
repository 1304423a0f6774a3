//! The tables of an assessment, each once for people and for programs.

use pounding_assess::{
    BumperEffect, Distribution, FloorAssessment, FloorBumperEffect, GapAssessment, PairAssessment, PairBumperEffect, RuleAssessment,
};
use pounding_text::{Cell, Shown, Table, Unit, percent, two_decimals, two_digits};
use serde_json::{Value, json};

use super::{AssessedMotion, AssessmentReport};

/// Most rows of a table on the first screen.
const MOST: usize = 6;

/// A distribution for programs.
pub(super) fn statistics(of: &Distribution) -> Value {
    json!({
        "median": of.median(),
        "p84": of.has_quantiles().then(|| of.p84()),
        "largest": of.largest(),
        "dispersion": of.dispersion(),
    })
}

/// Median and 84 % of ratios; of few the largest.
pub(super) fn both(of: &Distribution) -> String {
    if of.has_quantiles() {
        format!("{} / {}", two_decimals(of.median()), two_decimals(of.p84()))
    } else {
        two_decimals(of.largest())
    }
}

/// The largest with the contact that gives least, and with the one that gives most, in thousands.
fn range(of: Option<&[Distribution; 2]>) -> Shown {
    of.map(|[low, high]| format!("{} to {}", two_digits(1e-3 * low.largest()), two_digits(1e-3 * high.largest())))
        .into()
}

fn ends(of: Option<&[Distribution; 2]>) -> Cell {
    of.map(|[low, high]| json!({"least": statistics(low), "largest": statistics(high)}))
        .into()
}

/// A gap and the width that a rule gives it.
pub(super) type RuleOfGap<'a> = (&'a GapAssessment, &'a RuleAssessment);

impl AssessmentReport {
    fn between(&self, gap: &GapAssessment) -> String {
        let [left, right] = self.gap_names(gap);
        format!("{left} – {right}")
    }

    /// The width that every gap needs.
    pub(super) fn gaps(&self) -> Table<'_, &GapAssessment> {
        let touching = match self.sample() {
            "event" => "Events that touch",
            _ => "Cases that touch",
        };
        let table = Table::of(&self.assessment.gaps)
            .shown("Gap", |gap| self.between(gap))
            .column("left", |gap| self.gap_names(gap)[0])
            .column("right", |gap| self.gap_names(gap)[1])
            .number("gap_m", "Scene", &Unit::WIDTH, |gap| gap.own)
            .both(
                "touching",
                touching,
                |gap| gap.touching,
                |gap| format!("{} of {}", gap.touching, self.assessment.cases),
            )
            .column("touching_runs", |gap| gap.touching_runs);
        self.quantiles(table, "required_m", &Unit::NEEDED, |gap| &gap.required)
            .number("required_m.largest", "Largest", &Unit::NEEDED, |gap| gap.required.largest())
            .number("required_m.dispersion", "Spread σ ln", &Unit::RATIO, |gap| {
                gap.required.dispersion()
            })
            .column("required_sorted_m", |gap| json!(gap.required))
            .column("beside_columns_m", |gap| Cell::exact(gap.beside_columns))
            .both(
                "proposed_m",
                (if self.says_enough() { "Proposed" } else { "Keeps apart" }, "mm"),
                |gap| Cell::exact(self.proposal(gap)),
                |gap| {
                    let proposed = self.proposal(gap).filter(|_| self.is_wanting(gap));
                    proposed.map(|width| Unit::WIDTH.text_of(width, 1.0))
                },
            )
            .column("rules", |gap| self.rules_of(gap).json())
    }

    /// Adds the median and what 84 % do not exceed. People read them only of enough events.
    fn quantiles<'a, Row: 'a>(
        &self,
        table: Table<'a, Row>,
        name: &str,
        unit: &'static Unit,
        of: impl Fn(&Row) -> &'a Distribution + Copy + 'a,
    ) -> Table<'a, Row> {
        let [median, p84] = ["median", "p84"].map(|statistic| format!("{name}.{statistic}"));
        let counted = match self.assessment.believed_alone() {
            0 => self.assessment.cases,
            n => n,
        };
        if counted >= Distribution::ENOUGH {
            table
                .number(median, "Median", unit, move |row| of(row).median())
                .number(p84, "84 %", unit, move |row| of(row).p84())
        } else {
            table
                .column(median, move |row| Cell::exact(of(row).median()))
                .column(p84, move |row| Cell::exact(of(row).has_quantiles().then(|| of(row).p84())))
        }
    }

    fn rules_of<'a>(&'a self, gap: &'a GapAssessment) -> Table<'a, RuleOfGap<'a>> {
        self.of_rules(gap.rules.iter().map(move |rule| (gap, rule)))
    }

    /// The widths of the rules of codes for every gap.
    pub(super) fn rules(&self) -> Table<'_, RuleOfGap<'_>> {
        self.of_rules(self.gaps_and_rules())
    }

    /// Every rule of every gap that is no hinge of a bridge: rules for joints between buildings do not size one.
    pub(super) fn gaps_and_rules(&self) -> impl Iterator<Item = RuleOfGap<'_>> {
        let gaps = self.assessment.gaps.iter().filter(|gap| self.seat(gap).is_none());
        gaps.flat_map(|gap| gap.rules.iter().map(move |rule| (gap, rule)))
    }

    fn of_rules<'a>(&'a self, rules: impl Iterator<Item = RuleOfGap<'a>>) -> Table<'a, RuleOfGap<'a>> {
        let table = Table::of(rules)
            .shown("Gap", |(gap, _)| self.between(gap))
            .both("rule", "Rule", |(_, rule)| rule.rule.name(), |(_, rule)| rule.rule.name())
            .column("cited", |(_, rule)| rule.rule.cited())
            .column("width_m.asked", |(_, rule)| Cell::exact(rule.asked().0))
            .column("asked_is_mean", |(_, rule)| rule.asked().1);
        self.quantiles(table, "width_m", &Unit::WIDTH, |(_, rule)| &rule.width)
            .number("width_m.largest", "Largest", &Unit::WIDTH, |(_, rule)| rule.width.largest())
            .column("width_m.dispersion", |(_, rule)| Cell::exact(rule.width.dispersion()))
            .both(
                "too_narrow",
                "Too narrow",
                |(_, rule)| rule.too_narrow,
                |(_, rule)| format!("{} of {}", rule.too_narrow, rule.width.sorted().len()),
            )
            .number("least_share", "At worst", &Unit::WHOLE_PERCENT, |(_, rule)| rule.least_share)
    }

    /// The effects of touching on these storeys.
    pub(super) fn storeys<'a>(&'a self, floors: Vec<(usize, &'a FloorAssessment)>) -> Table<'a, (usize, &'a FloorAssessment)> {
        let floor = |index: usize| &self.floors.all()[index];
        let counted = match self.assessment.cases - self.assessment.disbelieved {
            0 => self.assessment.cases,
            n => n,
        };
        let heading = match counted {
            n if n >= Distribution::ENOUGH => "When they touch, median / 84 % (one: the largest)".into(),
            1 => format!("When they touch, the only {}", self.sample()),
            n => format!("When they touch, largest of {n} {}s", self.sample()),
        };
        Table::of(floors)
            .shown(heading, move |(index, _)| self.storey_name(*index))
            .column("building", move |(index, _)| self.scene.structures[floor(*index).structure].name())
            .column("floor", move |(index, _)| floor(*index).storey.unwrap_or(1))
            .both(
                "drift_amplification",
                "Drift × alone",
                |(_, one)| statistics(&one.drift),
                |(_, one)| both(&one.drift),
            )
            .both(
                "shear_force_amplification",
                "Shear × alone",
                |(_, one)| statistics(&one.shear),
                |(_, one)| both(&one.shear),
            )
            .column("acceleration_amplification", |(_, one)| statistics(&one.acceleration))
            .both(
                "acceleration_amplification_over_stiffness",
                "Acceleration of its floor × alone, range",
                |(_, one)| ends(Some(&one.acceleration_range)),
                |(_, one)| {
                    let [least, largest] = &one.acceleration_range;
                    format!("{} to {}", two_decimals(least.upper()), two_decimals(largest.upper()))
                },
            )
            .both(
                "largest_drift_m",
                ("Largest drift", "mm"),
                |(_, one)| Cell::exact(Self::at_most(one)),
                move |(index, one)| {
                    let height = floor(*index).made_of.and_then(|made| made.height_m);
                    let most = Self::at_most(one);
                    let ratio = height.map_or_else(String::new, |height| format!(" ({})", percent(most / height)));
                    format!("{}{ratio}", Unit::WIDTH.text_of(most, 0.0))
                },
            )
            .column("worse", |(_, one)| one.is_worse())
    }

    /// Every storey in the order of the row.
    pub(super) fn floors_in_order(&self) -> Vec<(usize, &FloorAssessment)> {
        let floors = self.assessment.floors.iter().enumerate();
        floors.filter_map(|(index, one)| Some((index, one.as_ref()?))).collect()
    }

    /// Every storey of every building, from the ground up.
    pub(super) fn every_storey(&self) -> Vec<(usize, &FloorAssessment)> {
        let floors = self.floors.by_structure();
        floors
            .filter_map(|floor| Some((floor, self.assessment.floors[floor].as_ref()?)))
            .collect()
    }

    /// How hard these pairs meet.
    pub(super) fn pairs<'a>(&'a self, pairs: Vec<(usize, &'a PairAssessment)>) -> Table<'a, (usize, &'a PairAssessment)> {
        let names = |index: usize| self.floors.names(index);
        Table::of(pairs)
            .shown("Pair", move |(index, _)| names(*index).join(" – "))
            .column("left", move |(index, _)| names(*index)[0].clone())
            .column("right", move |(index, _)| names(*index)[1].clone())
            .both("touching", "Events that touch", |(_, one)| one.touching, |(_, one)| one.touching)
            .both(
                "peak_force_n",
                ("Force", "kN"),
                |(_, one)| ends(one.peak_force.as_ref()),
                |(_, one)| range(one.peak_force.as_ref()),
            )
            .both(
                "largest_impulse_n_s",
                ("Largest impulse", "kN·s"),
                |(_, one)| ends(one.largest_impulse.as_ref()),
                |(_, one)| range(one.largest_impulse.as_ref()),
            )
            .number("approach_speed_m_per_s", "Speed up to", &Unit::ROUGH_SPEED, |(_, one)| {
                one.approach_speed
            })
            .column("unseated", |(_, one)| json!(one.unseated))
    }

    /// Every run.
    pub(super) fn runs(&self) -> Table<'_, &AssessedMotion> {
        Table::of(&self.motions)
            .shown("Motion", |one| one.shown())
            .column("record", |one| one.name.as_str())
            .column("event", |one| one.event + 1)
            .column("reversed", |one| one.reversed)
            .number("scale_factor", "Scaled by", &Unit::ONE, |one| one.run.scale)
            .column("neighbour", |one| json!(one.neighbour))
            .shown_in("mm", "Widest gap needed", |one| Unit::NEEDED.text_of(one.run.widest_gap(), 0.0))
            .shown("Collisions", |one| one.run.collisions())
            .column("collapsed", |one| one.run.collapsed)
    }

    /// The effects of bumpers on the forces of pairs.
    pub(super) fn bumper_pairs<'a>(&'a self, effect: &'a BumperEffect) -> Table<'a, (usize, &'a PairBumperEffect)> {
        let names = |index: usize| self.floors.names(index);
        let statistic = |of: &Option<Distribution>| Cell::from(of.as_ref().map(statistics));
        let largest = |of: &Option<Distribution>| Shown::from(of.as_ref().map(|of| two_digits(1e-3 * of.largest())));
        let pairs = effect.pairs.iter().enumerate();
        Table::of(pairs.filter_map(|(index, one)| Some((index, one.as_ref()?))))
            .shown("With bumpers", move |(index, _)| names(*index).join(" – "))
            .column("left", move |(index, _)| names(*index)[0].clone())
            .column("right", move |(index, _)| names(*index)[1].clone())
            .both(
                "peak_force_without_bumper_n",
                ("Largest force without", "kN"),
                move |(_, one)| statistic(&one.force_without),
                move |(_, one)| largest(&one.force_without),
            )
            .both(
                "peak_force_with_bumper_n",
                ("With", "kN"),
                move |(_, one)| statistic(&one.force_with),
                move |(_, one)| largest(&one.force_with),
            )
            .number("bumper_compression_m", "Compressed by up to", &Unit::WIDTH, |(_, one)| {
                one.compression
            })
    }

    /// The effects of bumpers on storeys.
    pub(super) fn bumper_storeys<'a>(&'a self, effect: &'a BumperEffect) -> Table<'a, (usize, &'a FloorBumperEffect)> {
        let floors = effect.floors.iter().enumerate();
        Table::of(floors.filter_map(|(index, one)| Some((index, one.as_ref()?))))
            .both(
                "floor",
                "With bumpers over without",
                |(index, _)| self.floor_name(*index),
                |(index, _)| self.storey_name(*index),
            )
            .both(
                "drift_with_over_without",
                "Drift",
                |(_, one)| statistics(&one.drift),
                |(_, one)| both(&one.drift),
            )
            .both(
                "acceleration_with_over_without",
                "Acceleration of its floor",
                |(_, one)| statistics(&one.acceleration),
                |(_, one)| both(&one.acceleration),
            )
    }
}

/// Rows of a table on the first screen.
pub(super) fn first<Row>(table: &Table<'_, Row>) -> pounding_text::Grid {
    table.grid().most(MOST)
}
