//! An assessment on one screen: the answer, what touching does, what is proposed, and how sure that is.

use pounding::assess::{Distribution, FloorAssessment, GapAssessment};
use pounding::report::AssessmentReport;
use pounding::text::{millimetres, millimetres_up, two_decimals, two_digits};

use crate::text::{NONE, paragraph, short, table, unusual};

/// Most lines of a table on the first screen.
const MOST: usize = 6;

pub(super) fn text(report: &AssessmentReport, details: bool) -> String {
    let mut parts: Vec<String> = unusual(&report.unusual()).into_iter().collect();
    parts.extend([
        paragraph("Answer", &report.sentences().join("\n")),
        paragraph("Motions", &report.shaking().join("\n")),
    ]);
    let warnings = report.warnings();
    if !warnings.is_empty() {
        parts.push(paragraph("Warnings", &warnings.join("\n")));
    }
    parts.push(gaps(report));
    parts.push(rules(report));
    let most = if details { usize::MAX } else { MOST };
    parts.extend(storeys(report, most));
    parts.extend(pairs(report, most));
    if !report.remarks().is_empty() {
        parts.push(paragraph("Records", &report.remarks().join("\n")));
    }
    if details {
        parts.push(runs(report));
    } else {
        parts.push(paragraph(
            "More",
            "--details prints every run and storey, --out FOLDER writes a report, --bumper proposed says what bumpers in the gaps change",
        ));
    }
    parts.join("\n")
}

fn gaps(report: &AssessmentReport) -> String {
    let header = [
        ["Gap", ""],
        ["Scene", "[mm]"],
        ["Events that", "touch"],
        ["Median", "[mm]"],
        ["84 %", "[mm]"],
        ["Largest", "[mm]"],
        ["Spread", "σ ln"],
        ["Proposed", "[mm]"],
    ];
    let row = |gap: &GapAssessment| {
        let [left, right] = report.gap_names(gap);
        vec![
            format!("{left} – {right}"),
            gap.own.map_or(NONE.into(), millimetres),
            format!("{} of {}", gap.touching, report.assessment().cases),
            millimetres_up(gap.required.median()),
            millimetres_up(gap.required.p84()),
            millimetres_up(gap.required.largest()),
            gap.required.dispersion().map_or(NONE.into(), two_decimals),
            millimetres(gap.proposal()),
        ]
    };
    let rows: Vec<_> = report.assessment().gaps.iter().map(row).collect();
    table(&header, &rows)
}

/// Median widths of rules, and in how many runs they are too narrow.
fn rules(report: &AssessmentReport) -> String {
    let gaps = &report.assessment().gaps;
    let Some(first) = gaps.first() else {
        return String::new();
    };
    let names: Vec<[&str; 2]> = first.rules.iter().map(|rule| [rule.rule.name(), ""]).collect();
    let header: Vec<[&str; 2]> = std::iter::once(["Rules", ""]).chain(names).collect();
    let mut rows = Vec::new();
    for gap in gaps {
        let [left, right] = report.gap_names(gap);
        let widths = gap.rules.iter().map(|rule| millimetres(rule.width.median()));
        rows.push(std::iter::once(format!("{left} – {right}, median [mm]")).chain(widths).collect());
        let narrow = gap.rules.iter().map(|rule| rule.too_narrow.to_string());
        rows.push(std::iter::once("  events in which it is too narrow".into()).chain(narrow).collect());
    }
    table(&header, &rows)
}

fn both(of: &Distribution) -> String {
    format!("{} / {}", two_decimals(of.median()), two_decimals(of.p84()))
}

fn storeys(report: &AssessmentReport, most: usize) -> Option<String> {
    let header = [
        ["When they touch", "median / 84 %"],
        ["Drift", "× alone"],
        ["Shear", "× alone"],
        ["Acceleration", "range × alone"],
        ["Largest", "drift [mm]"],
    ];
    let all: Vec<(usize, &FloorAssessment)> = if most == usize::MAX {
        let floors = report.floors().by_structure();
        floors
            .filter_map(|floor| Some((floor, report.assessment().floors[floor].as_ref()?)))
            .collect()
    } else {
        report.worse()
    };
    let row = |(floor, one): &(usize, &FloorAssessment)| {
        vec![
            report.floor_name(*floor),
            both(&one.drift),
            both(&one.shear),
            format!(
                "{} to {}",
                two_decimals(one.acceleration_range[0].median()),
                two_decimals(one.acceleration_range[1].p84())
            ),
            millimetres(one.largest_drift),
        ]
    };
    let rows: Vec<_> = all.iter().take(most).map(row).collect();
    (!rows.is_empty()).then(|| table(&header, &rows) + &rest(all.len(), most))
}

fn pairs(report: &AssessmentReport, most: usize) -> Option<String> {
    let header = [
        ["Pair", ""],
        ["Events that", "touch"],
        ["Force", "[kN]"],
        ["Largest impulse", "[kN·s]"],
        ["Speed up to", "[m/s]"],
    ];
    let range = |of: &Option<[Distribution; 2]>| match of {
        Some([low, high]) => format!("{} to {}", two_digits(1e-3 * low.median()), two_digits(1e-3 * high.largest())),
        None => NONE.into(),
    };
    let hit = report.hit();
    let rows: Vec<_> = hit
        .iter()
        .take(most)
        .map(|(index, pair)| {
            let facing = report.floors().facing()[*index];
            vec![
                format!("{} – {}", report.floor_name(facing.left), report.floor_name(facing.right)),
                pair.touching.to_string(),
                range(&pair.peak_force),
                range(&pair.largest_impulse),
                pair.approach_speed.map_or(NONE.into(), two_digits),
            ]
        })
        .collect();
    (!rows.is_empty()).then(|| table(&header, &rows) + &rest(hit.len(), most))
}

/// What a table leaves out.
fn rest(all: usize, most: usize) -> String {
    match all.saturating_sub(most) {
        0 => String::new(),
        left => format!("and {left} more: --details\n"),
    }
}

fn runs(report: &AssessmentReport) -> String {
    let header = [["Motion", ""], ["Scaled", "by"], ["Widest gap", "needed [mm]"], ["Collisions", ""]];
    let row = |one: &pounding::report::AssessedMotion| {
        let reversed = if one.reversed { " rev." } else { "" };
        vec![
            format!("{}{reversed}", one.name),
            short(one.run.scale),
            millimetres_up(one.run.widest_gap()),
            one.run.collisions().to_string(),
        ]
    };
    let rows: Vec<_> = report.motions().iter().map(row).collect();
    table(&header, &rows)
}
