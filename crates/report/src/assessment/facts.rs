//! An assessment for machines: JSON, and a table with a line per number.

use pounding_assess::{Distribution, FloorAssessment, GapAssessment, PairAssessment, Rule, RuleAssessment, TargetFit};
use pounding_text::{Cell, csv_text};
use serde_json::{Value, json};

use super::{AssessedMotion, AssessmentReport};
use crate::SCHEMA_VERSION;

pub(super) fn statistics(of: &Distribution) -> Value {
    json!({
        "median": of.median(),
        "p84": of.p84(),
        "largest": of.largest(),
        "dispersion": of.dispersion(),
    })
}

pub(super) fn json(report: &AssessmentReport) -> Value {
    let assessment = &report.assessment;
    let gaps = assessment.gaps.iter().map(|one| gap(report, one));
    let floors = assessment.floors.iter().enumerate();
    let floors = floors.filter_map(|(index, one)| Some(floor(report, index, one.as_ref()?)));
    let pairs = assessment.pairs.iter().enumerate();
    let pairs = pairs.map(|(index, one)| pair(report, index, one));
    let motion = |one: &AssessedMotion| json!({"record": one.name, "event": one.event + 1, "reversed": one.reversed, "scale_factor": one.run.scale, "neighbour": one.neighbour});
    json!({
        "schema_version": SCHEMA_VERSION,
        "version": env!("CARGO_PKG_VERSION"),
        "unusual": report.unusual(),
        "cautions": report.before(),
        "answers": report.answers(),
        "proposals": report.proposals(),
        "neighbour": report.prior_json(),
        "bumper": report.bumper_json(),
        "warnings": report.warnings(),
        "runs": assessment.runs,
        "stiffness_factors": report.stiffness,
        "scaling": report.scaling.words,
        "scaled": report.scaling.to.to_string(),
        "target": report.fit.as_ref().map(fit),
        "events": assessment.events,
        "cases": assessment.cases,
        "left_out": report.folder.left_out,
        "by_stiffness": assessment.by_stiffness.as_ref().map(|effect| json!({
            "drift_largest_over_least": statistics(&effect.drift),
            "acceleration_largest_over_least": statistics(&effect.acceleration),
            "impulse_largest_over_least": statistics(&effect.impulse),
        })),
        "gaps": gaps.collect::<Vec<_>>(),
        "floors": floors.collect::<Vec<_>>(),
        "pairs": pairs.collect::<Vec<_>>(),
        "motions": report.motions.iter().map(motion).collect::<Vec<_>>(),
        "scene": report.asked,
    })
}

fn fit(fit: &TargetFit) -> Value {
    let (share, period) = fit.least();
    json!({
        "least_share": share,
        "least_share_at_s": period,
        "peak_share": fit.peak_share,
        "periods_s": fit.periods,
        "target_g": fit.target,
        "mean_g": fit.mean,
    })
}

fn gap(report: &AssessmentReport, one: &GapAssessment) -> Value {
    let [left, right] = report.gap_names(one);
    let rule = |rule: &RuleAssessment| {
        json!({
            "rule": rule.rule.name(),
            "width_m": statistics(&rule.width),
            "too_narrow": rule.too_narrow,
            "least_share": rule.least_share,
        })
    };
    json!({
        "left": left,
        "right": right,
        "gap_m": one.own,
        "touching": one.touching,
        "touching_runs": one.touching_runs,
        "required_m": statistics(&one.required),
        "required_sorted_m": one.required,
        "beside_columns_m": one.beside_columns,
        "proposed_m": one.proposal(),
        "rules": one.rules.iter().map(rule).collect::<Vec<_>>(),
    })
}

fn floor(report: &AssessmentReport, index: usize, one: &FloorAssessment) -> Value {
    let floor = &report.floors.all()[index];
    json!({
        "building": report.scene.structures[floor.structure].name(),
        "floor": floor.storey.unwrap_or(1),
        "drift_amplification": statistics(&one.drift),
        "shear_amplification": statistics(&one.shear),
        "acceleration_amplification": statistics(&one.acceleration),
        "acceleration_amplification_over_stiffness": {
            "least": statistics(&one.acceleration_range[0]),
            "largest": statistics(&one.acceleration_range[1]),
        },
        "largest_drift_m": one.largest_drift,
        "worse": one.is_worse(),
    })
}

fn pair(report: &AssessmentReport, index: usize, one: &PairAssessment) -> Value {
    let facing = report.floors.facing()[index];
    let both = |range: &Option<[Distribution; 2]>| {
        let range = range.as_ref();
        range.map(|[low, high]| json!({"least": statistics(low), "largest": statistics(high)}))
    };
    json!({
        "left": report.floor_name(facing.left),
        "right": report.floor_name(facing.right),
        "touching": one.touching,
        "peak_force_n": both(&one.peak_force),
        "largest_impulse_n_s": both(&one.largest_impulse),
        "approach_speed_m_per_s": one.approach_speed,
    })
}

const HEADER: [&str; 11] = [
    "record",
    "reversed",
    "scale_factor",
    "neighbour_period_s",
    "neighbour_mass_ratio",
    "building",
    "floor",
    "neighbour",
    "neighbour_floor",
    "quantity",
    "value",
];

/// Where a number is: building and floor, and those of its neighbour.
type Place = [Cell; 4];

pub(super) fn csv(report: &AssessmentReport) -> String {
    let rows = report.motions.iter().flat_map(|motion| {
        let line = move |(place, quantity, value): (Place, &'static str, f64)| {
            let mut row: Vec<Cell> = vec![motion.name.as_str().into(), motion.reversed.into(), Cell::exact(motion.run.scale)];
            let drawn = motion.neighbour.as_ref();
            row.push(drawn.map_or_else(Cell::default, |one| Cell::exact(one.period_s)));
            row.push(drawn.map_or_else(Cell::default, |one| Cell::exact(one.mass_ratio)));
            row.extend(place);
            row.extend([quantity.into(), Cell::exact(value)]);
            row
        };
        lines(report, motion).into_iter().map(line)
    });
    csv_text(&HEADER, rows)
}

/// A number with its place and its name.
type Line = (Place, &'static str, f64);

fn lines(report: &AssessmentReport, motion: &AssessedMotion) -> Vec<Line> {
    let mut lines = of_gaps(report, motion);
    lines.extend(of_floors(report, motion));
    lines.extend(of_pairs(report, motion));
    lines.extend(of_bumpers(report, motion));
    lines
}

fn building(report: &AssessmentReport, structure: usize) -> Cell {
    report.scene.structures[structure].name().into()
}

/// Building and number of a floor.
fn at(report: &AssessmentReport, floor: usize) -> [Cell; 2] {
    let one = &report.floors.all()[floor];
    [building(report, one.structure), one.storey.unwrap_or(1).into()]
}

fn of_gaps(report: &AssessmentReport, motion: &AssessedMotion) -> Vec<Line> {
    let mut lines = Vec::new();
    for gap in &motion.run.separations {
        let [left, right] = [gap.left, gap.left + 1].map(|index| building(report, index));
        let place = [left, Cell::default(), right, Cell::default()];
        lines.push((place.clone(), "required_gap_m", gap.required));
        let ruled = Rule::ALL.into_iter();
        lines.extend(ruled.filter_map(|rule| Some((place.clone(), rule.key(), rule.width(gap)?))));
    }
    lines
}

fn of_floors(report: &AssessmentReport, motion: &AssessedMotion) -> Vec<Line> {
    let floors = motion.run.floors.iter().enumerate();
    let moving = floors.filter(|(index, _)| !report.floors.all()[*index].is_wall());
    let lines = moving.flat_map(|(index, floor)| {
        let (alone, beside) = (floor.alone, floor.beside);
        let [least, largest] = floor.over_stiffness;
        let [structure, storey] = at(report, index);
        let place = [structure, storey, Cell::default(), Cell::default()];
        [
            ("drift_alone_m", alone.drift),
            ("drift_m", beside.drift),
            ("shear_force_alone_n", alone.shear),
            ("shear_force_n", beside.shear),
            ("acceleration_alone_m_per_s2", alone.acceleration),
            ("acceleration_m_per_s2", beside.acceleration),
            ("drift_least_m", least.drift),
            ("drift_largest_m", largest.drift),
            ("acceleration_least_m_per_s2", least.acceleration),
            ("acceleration_largest_m_per_s2", largest.acceleration),
        ]
        .map(|(quantity, value)| (place.clone(), quantity, value))
    });
    lines.collect()
}

fn of_pairs(report: &AssessmentReport, motion: &AssessedMotion) -> Vec<Line> {
    let mut lines = Vec::new();
    for (pair, facing) in motion.run.pairs.iter().zip(report.floors.facing()) {
        let [left, left_floor] = at(report, facing.left);
        let [right, right_floor] = at(report, facing.right);
        let place = [left, left_floor, right, right_floor];
        let end = |range: Option<[f64; 2]>, end: usize| range.map(|range| range[end]);
        let numbers = [
            ("collisions", Some(pair.collisions as f64)),
            ("peak_force_least_n", end(pair.peak_force, 0)),
            ("peak_force_largest_n", end(pair.peak_force, 1)),
            ("largest_impulse_least_n_s", end(pair.largest_impulse, 0)),
            ("largest_impulse_largest_n_s", end(pair.largest_impulse, 1)),
            ("approach_speed_m_per_s", pair.approach_speed),
        ];
        let known = numbers.into_iter();
        lines.extend(known.filter_map(|(quantity, value)| Some((place.clone(), quantity, value?))));
    }
    lines
}

fn of_bumpers(report: &AssessmentReport, motion: &AssessedMotion) -> Vec<Line> {
    let Some(run) = &motion.bumper else {
        return Vec::new();
    };
    let mut lines = Vec::new();
    for (index, floor) in run.floors.iter().enumerate() {
        if !report.floors.all()[index].is_wall() {
            let [structure, storey] = at(report, index);
            let place = [structure, storey, Cell::default(), Cell::default()];
            lines.extend([
                (place.clone(), "drift_with_bumper_m", floor.drift),
                (place.clone(), "shear_force_with_bumper_n", floor.shear),
                (place, "acceleration_with_bumper_m_per_s2", floor.acceleration),
            ]);
        }
    }
    for (pair, facing) in run.pairs.iter().zip(report.floors.facing()) {
        let [left, left_floor] = at(report, facing.left);
        let [right, right_floor] = at(report, facing.right);
        let place = [left, left_floor, right, right_floor];
        let force = pair.peak_force;
        lines.extend(force.map(|force| (place.clone(), "peak_force_with_bumper_n", force)));
        lines.push((place, "bumper_compression_m", pair.compression));
    }
    lines
}
