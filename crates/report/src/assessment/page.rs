//! `report.html` of an assessment: the answer on the first page, the rest behind it.

use pounding_assess::{Distribution, FloorAssessment, GapAssessment};

use pounding_text::{millimetres, millimetres_up, two_decimals, two_digits};

use super::AssessmentReport;
use crate::animation::Animation;
use crate::figures::Illustration;
use crate::page::markup::{Cell, NONE, escaped, facts, list, short, table};
use crate::page::{BEFORE, UNUSUAL, beside, boxed, document, illustrated, sentence};

pub(super) fn html(report: &AssessmentReport, figures: &[Illustration]) -> String {
    let title = escaped(&report.scene.name);
    // Numbered as they are read.
    let shown = std::cell::Cell::new(0);
    let figure = |name: &str| {
        let found = figures.iter().find(|one| one.name == name);
        found.map_or_else(String::new, |one| {
            shown.set(shown.get() + 1);
            illustrated(shown.get(), one)
        })
    };
    let first = [
        format!("<h1>{title}: is the gap enough?</h1>\n<p>{}</p>\n", escaped(&lead(report))),
        unusual(report),
        verdict(report),
        beside(&[
            report.animation.as_ref().map_or_else(|| figure("row"), Animation::figure),
            list(&report.shaking()),
        ]),
        format!("<h2>Required gap</h2>\n{}", gaps(report)),
        figure("gap"),
        boxed(BEFORE, &report.warnings()),
        figure("profiles"),
    ];
    let row = if report.animation.is_some() { figure("row") } else { String::new() };
    let appendix = [
        "<h2 class=\"appendix\">Appendix: what touching does</h2>\n".into(),
        row,
        touching(report),
        bumpers(report),
        figure("amplification"),
        figure("neighbour"),
        format!("<h2>Rules of codes</h2>\n{}", rules(report)),
        format!("<h2>Motions</h2>\n{}{}", motions(report), list(report.remarks())),
        format!("<h2>Every storey</h2>\n{}", storeys(report, &all(report))),
        again(report),
    ];
    let signed = signed(report).unwrap_or_default();
    document(&report.scene.name, &signed, &[first.concat(), appendix.concat()].concat())
}

/// Author and date, as far as they are given.
fn signed(report: &AssessmentReport) -> Option<String> {
    let signed = [&report.author, &report.date].into_iter().flatten();
    let signed: Vec<&str> = signed.map(String::as_str).collect();
    (!signed.is_empty()).then(|| signed.join(", "))
}

fn lead(report: &AssessmentReport) -> String {
    let signed = signed(report).map_or_else(String::new, |signed| format!(" {signed}."));
    format!(
        "{} structures in a row under {}, each in both directions, computed by pounding {} with the exact method.{signed}",
        report.scene.structures.len(),
        report.motions_of_events(),
        env!("CARGO_PKG_VERSION"),
    )
}

fn unusual(report: &AssessmentReport) -> String {
    let all: Vec<String> = report.unusual().iter().map(ToString::to_string).collect();
    boxed(UNUSUAL, &all)
}

fn verdict(report: &AssessmentReport) -> String {
    let touch = if report.hit().is_empty() { "" } else { " touch" };
    let before = report.before().into_iter();
    let before = before.map(|one| format!("<p>{}</p>\n", escaped(&one)));
    let before: Vec<String> = before.collect();
    let answers = report.answers();
    let first = answers.first().map_or("", String::as_str);
    let more: Vec<String> = answers
        .iter()
        .skip(1)
        .cloned()
        .chain(report.proposals())
        .chain(report.consequences())
        .collect();
    format!(
        "<div class=\"verdict{touch}\">\n{}<p><strong>{}</strong></p>\n{}</div>\n",
        before.concat(),
        escaped(first),
        list(&more)
    )
}

fn width(of: f64) -> Cell {
    Cell::new(millimetres(of))
}

fn needed(of: f64) -> Cell {
    Cell::new(millimetres_up(of))
}

fn gaps(report: &AssessmentReport) -> String {
    let row = |gap: &GapAssessment| {
        let [left, right] = report.gap_names(gap);
        let dispersion = gap.required.dispersion();
        vec![
            Cell::new(format!("{left} – {right}")),
            Cell::known(gap.own.map(millimetres)),
            Cell::new(report.of_cases(gap.touching)),
            needed(gap.required.median()),
            needed(gap.required.p84()),
            needed(gap.required.largest()),
            Cell::known(dispersion.map(two_decimals)),
            width(gap.proposal()),
        ]
    };
    let rows: Vec<_> = report.assessment.gaps.iter().map(row).collect();
    let header = [
        "Gap",
        "Scene [mm]",
        "They touch",
        "Median [mm]",
        "84 % [mm]",
        "Largest [mm]",
        "Spread σ ln",
        "Proposed [mm]",
    ];
    format!(
        "<p>The width that keeps the neighbours apart under an event: the largest closing of the gap while every building stands alone, of its \
         components in both directions.</p>\n{}",
        table(&header, &rows)
    )
}

fn touching(report: &AssessmentReport) -> String {
    let hit = report.hit();
    if hit.is_empty() {
        let why = report.floors.says_no_contact();
        let none = if report.leaves_out() {
            "No floors that were looked at touch."
        } else {
            "Nothing touches."
        };
        let why = why.map_or_else(|| none.into(), sentence);
        return format!("<p>{why}</p>\n");
    }
    let [from, to] = report.stiffness.map(pounding_text::digits);
    let range = |of: &Option<[Distribution; 2]>, unit: f64| match of {
        Some([low, high]) => Cell::new(format!(
            "{} to {}",
            two_digits(low.median() / unit),
            two_digits(high.largest() / unit)
        )),
        None => Cell::new(NONE),
    };
    let rows: Vec<_> = hit
        .iter()
        .map(|(index, pair)| {
            let facing = report.floors.facing()[*index];
            vec![
                Cell::new(format!("{} – {}", report.floor_name(facing.left), report.floor_name(facing.right))),
                Cell::new(pair.touching.to_string()),
                range(&pair.peak_force, 1e3),
                range(&pair.largest_impulse, 1e3),
                Cell::known(pair.approach_speed.map(two_digits)),
            ]
        })
        .collect();
    let header = ["Pair", "They touch", "Force [kN]", "Largest impulse [kN·s]", "Speed ≤ [m/s]"];
    let worse = report.worse();
    let storeys = if worse.is_empty() {
        "<p>No storey gets worse by more than 10 % in more than 16 % of the events.</p>\n".into()
    } else {
        format!(
            "<p>Storeys that get worse by more than 10 % in more than 16 % of the events:</p>\n{}",
            storeys(report, &worse)
        )
    };
    format!(
        "{storeys}<p>Forces and impulses from the median of the events with the contact that gives least to the largest of all runs and \
         contacts, {from} to {to} times as stiff as in the scene: nobody knows the stiffness better, and it decides forces and accelerations.</p>\n{}",
        table(&header, &rows)
    )
}

/// What bumpers change, pair by pair; nothing without bumpers.
fn bumpers(report: &AssessmentReport) -> String {
    let Some(effect) = report.bumpers() else {
        return String::new();
    };
    let force = |of: &Option<Distribution>| Cell::known(of.as_ref().map(|of| two_digits(1e-3 * of.median())));
    let pairs = effect.pairs.iter().enumerate();
    let pairs = pairs.filter_map(|(index, one)| Some((report.floors.facing()[index], one.as_ref()?)));
    let rows: Vec<_> = pairs
        .map(|(facing, one)| {
            let [left, right] = [facing.left, facing.right].map(|floor| report.floor_name(floor));
            vec![
                Cell::new(format!("{left} – {right}")),
                force(&one.force_without),
                force(&one.force_with),
                width(one.compression),
            ]
        })
        .collect();
    let floors = effect.floors.iter().enumerate();
    let floors = floors.filter_map(|(index, one)| Some((report.floor_name(index), one.as_ref()?)));
    let storeys: Vec<_> = floors
        .map(|(name, one)| {
            let both = |of: &Distribution| Cell::new(format!("{} / {}", two_decimals(of.median()), two_decimals(of.p84())));
            vec![Cell::new(name), both(&one.drift), both(&one.acceleration)]
        })
        .collect();
    let said = escaped(&report.bumper_says().join(" "));
    if effect.is_too_thin() {
        return format!("<h2>Bumpers in the gaps</h2>\n<p>{said}</p>\n");
    }
    format!(
        "<h2>Bumpers in the gaps</h2>\n<p>{said}</p>\n{}<p class=\"soft\">With bumpers over without, median / 84 % of the {} runs that touch.</p>\n{}",
        table(
            &["Pair", "Force without [kN], median", "With [kN], median", "Compressed by ≤ [mm]"],
            &rows
        ),
        effect.runs,
        table(&["Storey", "Drift", "Acceleration"], &storeys)
    )
}

fn all(report: &AssessmentReport) -> Vec<(usize, &FloorAssessment)> {
    let floors = report.floors.by_structure();
    floors
        .filter_map(|floor| Some((floor, report.assessment.floors[floor].as_ref()?)))
        .collect()
}

fn storeys(report: &AssessmentReport, floors: &[(usize, &FloorAssessment)]) -> String {
    let both = |of: &Distribution| Cell::new(format!("{} / {}", two_decimals(of.median()), two_decimals(of.p84())));
    let row = |(floor, one): &(usize, &FloorAssessment)| {
        vec![
            Cell::new(report.floor_name(*floor)),
            both(&one.drift),
            both(&one.shear),
            Cell::new(format!(
                "{} to {}",
                two_decimals(one.acceleration_range[0].median()),
                two_decimals(one.acceleration_range[1].p84())
            )),
            width(one.largest_drift),
        ]
    };
    let rows: Vec<_> = floors.iter().map(row).collect();
    let header = [
        "Storey",
        "Drift × alone",
        "Shear × alone",
        "Acceleration × alone, range",
        "Largest drift [mm]",
    ];
    format!(
        "<p class=\"soft\">Median / 84 % of the events in which their building touches; accelerations from the median with the contact that \
         gives least to 84 % with the one that gives most, as forces.</p>\n{}",
        table(&header, &rows)
    )
}

fn rules(report: &AssessmentReport) -> String {
    let mut rows = Vec::new();
    for gap in &report.assessment.gaps {
        let [left, right] = report.gap_names(gap);
        for rule in &gap.rules {
            rows.push(vec![
                Cell::new(format!("{left} – {right}")),
                Cell::new(rule.rule.name()),
                width(rule.width.median()),
                width(rule.width.p84()),
                width(rule.width.largest()),
                Cell::new(report.of_cases(rule.too_narrow)),
                Cell::new(format!("{:.0} %", 100.0 * rule.least_share)),
            ]);
        }
    }
    let header = ["Gap", "Rule", "Median [mm]", "84 % [mm]", "Largest [mm]", "Too narrow", "At worst"];
    format!(
        "<p>Each rule takes the displacements of the time history of both buildings standing alone. “At worst” is its width as a part of \
         the one that is needed.</p>\n{}",
        table(&header, &rows)
    )
}

fn motions(report: &AssessmentReport) -> String {
    let rows: Vec<_> = report
        .motions
        .iter()
        .map(|one| {
            let reversed = if one.reversed { ", reversed" } else { "" };
            vec![
                Cell::new(format!("{}{reversed}", one.name)),
                Cell::new(short(one.run.scale)),
                needed(one.run.widest_gap()),
                Cell::new(one.run.collisions().to_string()),
            ]
        })
        .collect();
    table(&["Motion", "Scaled by", "Widest gap needed [mm]", "Collisions"], &rows)
}

fn again(report: &AssessmentReport) -> String {
    let words = [&report.scaling.words, &report.bumper_words];
    let words: Vec<&str> = words.into_iter().flatten().map(String::as_str).collect();
    let words = words.iter().map(|words| [" ", words].concat());
    let scaling = words.collect::<Vec<_>>().concat();
    let scene = serde_json::to_string_pretty(&report.asked).unwrap_or_default();
    let said = facts(&[
        ("Records".into(), "those named under Motions; assess.json lists them".into()),
        ("Scaling of records".into(), report.scaling.to.to_string()),
        (
            "Stiffness of impacts".into(),
            format!(
                "{} to {} times that of the scene",
                short(report.stiffness[0]),
                short(report.stiffness[1])
            ),
        ),
    ]);
    format!(
        "<h2>How to repeat it</h2>\n<p>Save the scene below as <code>scene.json</code> and run, with pounding {},</p>\n\
         <pre>pounding assess scene.json --records FOLDER{} --stiffness {}..{} --out assessed</pre>\n{said}<pre class=\"scene\">{}</pre>\n",
        env!("CARGO_PKG_VERSION"),
        escaped(&scaling),
        short(report.stiffness[0]),
        short(report.stiffness[1]),
        escaped(&scene)
    )
}
