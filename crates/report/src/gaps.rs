//! The widths that the gaps of a row need under a folder of records, for people and for programs.

use std::collections::BTreeSet;

use pounding_assess::{Case, RequiredGap, Rule, RuleAssessment, Separation, beyond_belief};
use pounding_scene::{Error, Excess, Floors, Implausible, Scene, Simulation, Structure};
use pounding_text::{Answer, Cell, Table, Where, digits, rounded_up, short};
use serde_json::{Value, json};

use crate::folder::{MotionRow, OfFolder, UnderMotion};

/// The widths that the gaps of a row need under one motion in one direction.
#[derive(Debug)]
pub struct GapsUnderMotion {
    separations: Vec<Separation>,
    /// Responses beyond the model, of the kinds that count for widths.
    cautions: Vec<Excess>,
    /// The response that is farthest beyond belief; `None` if the widths are believed.
    disbelieved: Option<Excess>,
    doubts: Vec<Implausible>,
}

impl GapsUnderMotion {
    /// Looks at a scene whose structures stand apart.
    ///
    /// # Errors
    /// Errors of [`Separation::judged`].
    pub fn of(apart: &Simulation) -> Result<Self, Error> {
        let (separations, mut excesses) = Separation::judged(apart)?;
        let disbelieved = beyond_belief(&excesses).cloned();
        excesses.retain(|one| one.kind.is_caution());
        Ok(Self {
            separations,
            cautions: excesses,
            disbelieved,
            doubts: apart.doubts(),
        })
    }
}

impl UnderMotion for GapsUnderMotion {
    fn doubts(&self) -> &[Implausible] {
        &self.doubts
    }

    fn excesses(&self) -> &[Excess] {
        &self.cautions
    }

    fn warnings(scene: &Scene) -> Vec<String> {
        Floors::of(scene).map_or_else(|_| Vec::new(), |floors| floors.says_no_level())
    }

    fn facts(&self, scene: &Scene) -> Value {
        json!({"gaps": numbers(scene, Table::of(&self.separations), |one| Some(*one)).json()})
    }
}

/// A table for each gap, and which rules are too narrow.
pub fn gaps_answer<'a>(folder: &'a OfFolder<'_, GapsUnderMotion>) -> Answer<'a> {
    let scene = folder.scene;
    let n_gaps = folder.found().next().map_or(0, |(_, found)| found.separations.len());
    let answer = (0..n_gaps).fold(folder.answer(), |answer, gap| of_gap(folder, answer, gap));
    let levels = has_storeys(scene).then_some(LEVELS);
    let travels = scene.arrivals_s.is_some().then_some(TRAVELS);
    let others = (scene.structures.len() > 2).then_some(OTHERS);
    let notes = [Some(NOTES), others, levels, travels].into_iter().flatten();
    answer
        .say(Where::FirstScreen, "Records", folder.records(false))
        .say(Where::Details, "Records", folder.records(true))
        .say(Where::Terminal, "Notes", notes.map(String::from).collect())
        .with_csv(|| gaps_table(folder).csv())
}

/// The table for programs: a row for each gap under each motion.
pub fn gaps_table<'a>(folder: &OfFolder<'a, GapsUnderMotion>) -> Table<'a, MotionRow<Option<&'a Separation>>> {
    let rows = |line, found: &'a GapsUnderMotion| found.separations.iter().map(|one| MotionRow::of(line, Some(one))).collect();
    folder.table(rows, |table| numbers(folder.scene, table, |row| row.found))
}

const LEVELS: &str = "Level: that of the floors that need most and whose displacements the rules take, counted from 1 for the lowest; \
                      all count at which floors face each other, also those that `levels` of a contact leaves out.";

const OTHERS: &str =
    "In a row of three and more a gap as wide stays open if every other gap does, too: a building that is pushed moves farther than alone.";

const TRAVELS: &str = "The ground travels along the row (`arrivals_s`): it is in what a gap needs, while the rules know \
                       displacements relative to each structure's own ground alone.";

const NOTES: &str = "Needs: the largest closing of the gap while every structure stands alone, by the exact method. Rules: from the \
                     peak displacements of both structures under the same record; EC 8 is SRSS, 0.7 times that where \
                     all floors of both are level by the heights given; ASCE 7 is SRSS of the displacements of the time history; DDC takes elastic \
                     periods and damping. * marks what is too narrow.";

/// Adds the numbers of separations to a table: all of them for programs; the width that a gap needs and those of the common rules for
/// people.
fn numbers<'a, Of: 'a>(scene: &'a Scene, table: Table<'a, Of>, one: fn(&Of) -> Option<&Separation>) -> Table<'a, Of> {
    let name = move |row: &Of, side: usize| one(row).map(|one| Cell::from(scene.structures[one.left + side].name()));
    let level = move |row: &Of| one(row).map(|one| one.at_level);
    let table = table
        .column("left", move |row| name(row, 0))
        .column("right", move |row| name(row, 1));
    let table = if has_storeys(scene) {
        table.both("level", "Level", level, level)
    } else {
        table.column("level", level)
    };
    let number = |number: fn(&Separation) -> f64| move |row: &Of| Cell::exact(one(row).map(number));
    let text = |text: fn(&Separation) -> String| move |row: &Of| one(row).map(text);
    let table = table
        // A blank stands in place of a mark, so that the digits stand in line.
        .both(
            "required_m",
            ("Needs", "mm"),
            number(|one| one.required),
            text(|one| format!("{} ", enough(one.required))),
        )
        .both(
            "time_s",
            ("at", "s"),
            number(|one| one.time),
            text(|one| digits((one.time * 1e3).round() * 1e-3)),
        )
        .column("peak_left_m", number(|one| one.peaks[0]))
        .column("peak_right_m", number(|one| one.peaks[1]));
    Rule::COMMON.into_iter().fold(table, |table, rule| {
        let width = move |row: &Of| Cell::exact(one(row).and_then(|one| rule.width(one)));
        let marked = move |row: &Of| one(row).and_then(|one| Some(marked(rule.width(one)?, one)));
        table.both(rule.key(), (rule.name(), "mm"), width, marked)
    })
}

/// Adds the table of one gap and its result.
fn of_gap<'a>(folder: &OfFolder<'a, GapsUnderMotion>, answer: Answer<'a>, gap: usize) -> Answer<'a> {
    let scene = folder.scene;
    let found = folder.found().filter_map(|(line, found)| Some((line, found.separations.get(gap)?)));
    let found: Vec<_> = found.collect();
    let Some((_, first)) = found.first() else {
        return answer;
    };
    let left = first.left;
    let [one, other] = [left, left + 1].map(|index| scene.structures[index].name());
    let own = scene.contacts.as_ref().and_then(|contacts| contacts.get(left)).map(|own| own.gap_m);
    let in_scene = own.map_or_else(String::new, |own| format!(", {} mm in the scene", digits(own * 1e3)));
    let (all, not_counted) = believed(folder, gap);
    let mut said = RequiredGap::of(&all).map_or_else(Vec::new, |all| result(&all, own));
    said.extend(not_counted);
    let table = Table::of(found).shown("Record", |(line, _)| line.name());
    answer
        .say(Where::Terminal, "Gap", vec![format!("{one} – {other}{in_scene}")])
        .table(Where::Terminal, numbers(scene, table, |(_, one)| Some(*one)).grid())
        .say(Where::Terminal, "Result", said)
}

/// Returns the widths of the events under which every building stands alone within belief, and a sentence about the others.
fn believed<'a>(folder: &OfFolder<'a, GapsUnderMotion>, gap: usize) -> (Vec<(Case, &'a Separation)>, Option<String>) {
    let doubted = folder.found().filter_map(|(line, found)| Some((line, found.disbelieved.as_ref()?)));
    let doubted: Vec<_> = doubted.collect();
    let events: BTreeSet<usize> = doubted.iter().map(|(line, _)| line.event).collect();
    let all = folder.found().filter(|(line, _)| !events.contains(&line.event));
    let all = all.filter_map(|(line, found)| Some(([line.event, 0], found.separations.get(gap)?)));
    let worst = beyond_belief(doubted.iter().map(|(_, excess)| *excess)).map(|worst| {
        let n = events.len();
        let s = if n == 1 { "" } else { "s" };
        format!(
            "{n} event{s} not counted: a building would hardly stand even alone, whatever the gap ({}: {})",
            worst.name,
            worst.kind.brief(worst.found)
        )
    });
    (all.collect(), worst)
}

/// Whether floors stand at several levels.
fn has_storeys(scene: &Scene) -> bool {
    let is_building = |one: &Structure| matches!(one, Structure::Building(_));
    scene.structures.iter().any(is_building)
}

/// A width, with a mark if it is too narrow and a blank if not.
fn marked(width: f64, separation: &Separation) -> String {
    let mark = if separation.asks_for_more(width) { "*" } else { " " };
    format!("{}{mark}", millimetres(width))
}

/// A width to a tenth of a millimetre; a width below 1 mm with four digits.
fn millimetres(width: f64) -> String {
    if width < 1e-3 {
        short(width * 1e3)
    } else {
        format!("{:.1}", width * 1e3)
    }
}

/// A width that is rounded up, so that as much is enough.
fn enough(width: f64) -> String {
    let decimals = if width < 1e-3 { 4 } else { 1 };
    rounded_up(width * 1e3, decimals)
}

/// The width that is enough for all events, and whether the rules and the gap of the scene give it.
fn result(all: &RequiredGap, own: Option<f64>) -> Vec<String> {
    let widths = &all.required;
    let n = widths.sorted().len();
    let of = match all.beside_columns {
        Some(_) => " for floors that face floors",
        None => "",
    };
    let largest = enough(widths.largest());
    let mut lines = vec![match n {
        1 => format!("{largest} mm are enough{of} in the only event"),
        n if widths.has_quantiles() => format!(
            "{largest} mm are enough{of} in all {n} events; {} mm for half of them, {} mm for 84 %",
            enough(widths.median()),
            enough(widths.p84())
        ),
        n => format!("{largest} mm are enough{of} in all {n} events: the largest of so few"),
    }];
    let beside = all.beside_columns;
    lines.extend(beside.map(|width| format!("floors beside columns may need {} mm, the sum of both peaks", enough(width))));
    lines.extend(own.map(|own| {
        format!(
            "with the {} mm of the scene the structures touch under {} of them",
            digits(own * 1e3),
            widths.count_above(own)
        )
    }));
    let common = all.rules.iter().filter(|one| Rule::COMMON.contains(&one.rule));
    let rule = |one: &RuleAssessment| {
        let by = if one.too_narrow == 0 {
            String::new()
        } else {
            let share = digits((100.0 * one.least_share).round());
            format!(", at worst {share} % of what is needed")
        };
        let name = one.rule.name();
        format!("{name}: too narrow under {}{by}", one.too_narrow)
    };
    lines.extend(common.map(rule));
    lines
}
