//! The widths that the gaps of a row need under a folder of records, for people and for programs.

use std::collections::BTreeSet;

use pounding_assess::{Case, JudgedSeparations, MotionLine, RequiredGap, Rule, RuleAssessment, Scaling, Separation, beyond_belief};
use pounding_scene::{Error, Excess, ExcessKind, Floors, Implausible, RecordUse, Scene, Simulation, Structure};
use pounding_text::{Answer, Cell, Shown, Table, Where, digits, rounded_up, short};
use serde_json::{Value, json};

use crate::folder::{MotionRow, OfFolder, UnderMotion, factor};
use crate::rules::{RuledGap, notes, sources};
use crate::whatever_gap::{Fallen, NO_SEATS, Standing, isolators_over, over_capacity, says_beyond, says_isolators, says_over_capacity};

/// The widths that the gaps of a row need under one motion in one direction.
#[derive(Debug)]
pub struct GapsUnderMotion {
    separations: Vec<Separation>,
    /// Responses beyond the model.
    excesses: Vec<Excess>,
    /// Those of buildings that exceed a capacity of the scene even alone.
    over_capacity: Vec<Excess>,
    /// The response that is farthest beyond belief; `None` if the widths are believed.
    disbelieved: Option<Excess>,
    doubts: Vec<Implausible>,
    /// Factor by which the source of the record was multiplied \[–\].
    scale: f64,
}

impl GapsUnderMotion {
    /// Looks at a scene whose structures stand apart.
    ///
    /// # Errors
    /// Errors of [`JudgedSeparations::of`].
    pub fn of(apart: &Simulation) -> Result<Self, Error> {
        let JudgedSeparations {
            separations,
            excesses,
            over_capacity,
        } = JudgedSeparations::of(apart)?;
        Ok(Self {
            separations,
            disbelieved: beyond_belief(&excesses).cloned(),
            excesses,
            over_capacity,
            doubts: apart.doubts(),
            scale: apart.scale(),
        })
    }
}

impl UnderMotion for GapsUnderMotion {
    fn doubts(&self) -> &[Implausible] {
        &self.doubts
    }

    fn excesses(&self) -> &[Excess] {
        &self.excesses
    }

    fn warns(excess: &Excess) -> bool {
        excess.is_caution()
    }

    fn cautions(folder: &OfFolder<'_, Self>) -> Vec<String> {
        let counts = |found: &GapsUnderMotion| found.disbelieved.is_none();
        let widths = folder.found().any(|(_, found)| counts(found));
        let over = says_over_capacity(&over_capacity_of(folder), folder.scene.words(), widths);
        let isolators = isolators_of(folder).map(|over| says_isolators(&over, widths));
        let seats = folder.scene.is_bridge().then(|| {
            let of_run = "Decks may leave their seats: `pounding run` and `pounding assess` tell at the gaps of the scene, and at wider gaps they move farther.";
            if folder.scene.has_seats() { of_run } else { NO_SEATS }
        });
        over.into_iter().chain(isolators).chain(seats.map(String::from)).collect()
    }

    fn warnings(scene: &Scene) -> Vec<String> {
        let RecordUse { scale, scale_to, .. } = &scene.record;
        let is_unscaled = scale_to.is_none() && (scale - 1.0).abs() <= 0.0;
        let said = "the records are as strong as in their files: the widths are for their earthquakes, not for a site (`pounding assess --target`)";
        is_unscaled.then(|| said.to_owned()).into_iter().collect()
    }

    fn facts(&self, scene: &Scene) -> Value {
        json!({"gaps": numbers(scene, &Rule::COMMON, Table::of(&self.separations), |one| Some(*one)).json()})
    }
}

/// Every building that exceeds a capacity of the scene even alone.
fn over_capacity_of(folder: &OfFolder<'_, GapsUnderMotion>) -> Vec<Excess> {
    let all = folder
        .found()
        .flat_map(|(line, found)| found.over_capacity.iter().map(|one| ([line.event, 0], one)));
    let all: Vec<(Case, &Excess)> = all.collect();
    // Structures of a row that ran are sound.
    let floors = Floors::of(&folder.scene.apart()).ok();
    floors.map_or_else(Vec::new, |floors| over_capacity(&floors, &all, events(folder.found()), EVENT))
}

/// The isolators that move farthest beyond their capacity.
fn isolators_of(folder: &OfFolder<'_, GapsUnderMotion>) -> Option<Excess> {
    isolators_over(Excess::gathered(folder.found().map(|(_, found)| found.excesses()), "run"))
}

/// Number of events in which a structure exceeds a general limit.
fn strained(folder: &OfFolder<'_, GapsUnderMotion>) -> usize {
    let strains = |found: &GapsUnderMotion| found.excesses.iter().any(|one| one.kind.strains());
    events(folder.found().filter(|(_, found)| strains(found)))
}

/// The word for a sample.
const EVENT: &str = "event";

/// Number of the events of these motions.
fn events<'a, T: 'a>(found: impl Iterator<Item = (&'a MotionLine<GapsUnderMotion>, T)>) -> usize {
    found.map(|(line, _)| line.event).collect::<BTreeSet<usize>>().len()
}

/// A table for each gap, and which rules are too narrow. `code` names the rule of a code whose width is told in a sentence.
pub fn gaps_answer<'a>(folder: &'a OfFolder<'_, GapsUnderMotion>, code: Option<Rule>) -> Answer<'a> {
    let scene = folder.scene;
    let n_gaps = folder.found().next().map_or(0, |(_, found)| found.separations.len());
    let all: Vec<RequiredAt> = (0..n_gaps).filter_map(|gap| RequiredAt::of(folder, gap)).collect();
    let ruled: Vec<RuledGap<'_>> = all.iter().filter_map(RequiredAt::ruled).collect();
    let others = code.filter(|code| !Rule::COMMON.contains(code));
    let shown: Vec<Rule> = Rule::COMMON.into_iter().chain(others).collect();
    let by_code = code.map(|code| ruled.iter().map(|gap| gap.by_code(scene, code)).collect::<Vec<_>>());
    let answer = folder.answer();
    let answer = answer
        .say(Where::Terminal, "Code", by_code.clone().unwrap_or_default())
        .fact("by_code", by_code.unwrap_or_default());
    let answer = all.iter().fold(answer, |answer, gap| of_gap(folder, answer, gap, &shown));
    let levels = has_storeys(scene).then_some(LEVELS);
    let travels = scene.arrivals_s.is_some().then_some(TRAVELS);
    let moat = Floors::of(scene).ok().and_then(|floors| says_moat(&floors));
    let others = (scene.structures.len() > 2).then_some(OTHERS);
    let scaled = says_scaled(scene);
    let mut said: Vec<String> = scaled.into_iter().collect();
    if all.iter().any(|gap| gap.all.is_some()) {
        let of_widths = [Some(NOTES), others, levels, travels].into_iter().flatten().map(String::from);
        said.extend(of_widths.chain(moat).chain([sources(&shown)]).chain(notes(scene, &ruled, &shown)));
    }
    answer
        .say(Where::Terminal, "Warnings", folder.warnings())
        .say(Where::FirstScreen, "Records", folder.records(false))
        .say(Where::Details, "Records", folder.records(true))
        .say(Where::Terminal, "Notes", said)
        .with_csv(|| gaps_table(folder).csv())
}

/// Names what the scene does to its own record and so to every record of the folder; `None` if it scales nothing.
fn says_scaled(scene: &Scene) -> Option<String> {
    let RecordUse { scale, scale_to, .. } = &scene.record;
    let to = scale_to.map(|to| format!("scaled {}", Scaling::To(to)));
    let by = ((scale - 1.0).abs() > 0.0).then(|| format!("multiplied by {}", digits(*scale)));
    let both: Vec<String> = to.into_iter().chain(by).collect();
    (!both.is_empty()).then(|| format!("Every record is {}, since the scene does so with its own.", both.join(" and ")))
}

/// A sentence about gaps without rules, beside buildings that are told to stand on isolators; `None` if there are none.
pub(crate) fn says_moat(floors: &Floors) -> Option<String> {
    let names = floors.structures().iter().enumerate();
    let isolated: Vec<&str> = names
        .filter(|(index, _)| floors.is_isolated(*index))
        .map(|(_, name)| name.as_str())
        .collect();
    (!isolated.is_empty()).then(|| {
        format!(
            "Beside {} only the sum of both peaks is given: rules for joints between buildings do not size the moat of a building on \
             isolators, and whether these bear their displacement is judged by `displacement_capacity_m` alone. GB 50011-2010, 12.2.7, asks for 1.2 times the displacement in the rare earthquake, and at least 200 mm.",
            isolated.join(" and ")
        )
    })
}

/// A gap and the width that it needs under all motions.
struct RequiredAt {
    /// Index of the gap among those of every motion.
    index: usize,
    left: usize,
    own: Option<f64>,
    /// Its widths; `None` if no event is believed.
    all: Option<RequiredGap>,
    /// The motion that asks for the largest width; `None` for a single event, and if the gap never closes.
    widest: Option<String>,
    /// Why events do not count, if there are any.
    not_counted: Option<String>,
    /// The events that do not count.
    fallen: Fallen,
    /// Their indices.
    fallen_events: BTreeSet<usize>,
}

impl RequiredAt {
    fn of(folder: &OfFolder<'_, GapsUnderMotion>, index: usize) -> Option<Self> {
        let left = folder.found().find_map(|(_, found)| Some(found.separations.get(index)?.left))?;
        let BelievedWidths {
            found,
            widest,
            not_counted,
            fallen,
            fallen_events,
        } = believed(folder, index);
        let contacts = folder.scene.contacts.as_ref();
        Some(Self {
            index,
            left,
            own: contacts.and_then(|contacts| contacts.get(left)).map(|own| own.gap_m),
            all: RequiredGap::of(&found),
            widest,
            not_counted,
            fallen,
            fallen_events,
        })
    }

    fn ruled(&self) -> Option<RuledGap<'_>> {
        let all = self.all.as_ref()?;
        Some(RuledGap {
            left: self.left,
            own: self.own,
            needed: all.required.largest(),
            rules: &all.rules,
            not_counted: self.not_counted.clone(),
            sample: EVENT,
        })
    }
}

/// The table for programs: a row for each gap under each motion.
pub fn gaps_table<'a>(folder: &OfFolder<'a, GapsUnderMotion>) -> Table<'a, MotionRow<Option<&'a Separation>>> {
    let rows = |line, found: &'a GapsUnderMotion| found.separations.iter().map(|one| MotionRow::of(line, Some(one))).collect();
    folder.table(rows, |table| numbers(folder.scene, &Rule::COMMON, table, |row| row.found))
}

const LEVELS: &str = "Level: that of the floors that need most and whose displacements the rules take, counted from 1 for the lowest; \
                      all count at which floors face each other, also those that `levels` of a contact leaves out. A height is that of a \
                      floor that faces a column.";

const OTHERS: &str =
    "In a row of three and more a gap as wide stays open if every other gap does, too: a building that is pushed moves farther than alone.";

const TRAVELS: &str = "The ground travels along the row (`arrivals_s`): it is in what a gap needs, while the rules know \
                       displacements relative to each structure's own ground alone.";

const NOTES: &str = "Needs: the largest closing of the gap while nothing touches, by the exact method. Rules: from the \
                     peak displacements of both structures under the same record; DDC takes elastic periods and damping. * marks what is too narrow.";

/// Adds the numbers of separations to a table: all of them for programs; the width that a gap needs and those of the common rules for
/// people.
fn numbers<'a, Of: 'a>(scene: &'a Scene, shown: &[Rule], table: Table<'a, Of>, one: fn(&Of) -> Option<&Separation>) -> Table<'a, Of> {
    let name = move |row: &Of, side: usize| one(row).map(|one| scene.structures[one.left + side].name().to_owned());
    let level = move |row: &Of| one(row).map(|one| one.at_level);
    let faced = move |row: &Of| one(row).map(faced);
    let table = table
        .column("left", move |row| name(row, 0))
        .column("right", move |row| name(row, 1));
    let table = if has_storeys(scene) {
        table.both("level", "Level", level, faced)
    } else {
        table.column("level", level)
    };
    let table = table.column("at_column", move |row| one(row).map(|one| one.at_column));
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
    Rule::ALL.into_iter().fold(table, |table, rule| {
        let width = move |row: &Of| Cell::exact(one(row).and_then(|one| rule.width(one)));
        let marked = move |row: &Of| one(row).and_then(|one| Some(marked(rule.width(one)?, one)));
        if shown.contains(&rule) {
            table.both(rule.key(), (rule.name(), "mm"), width, marked)
        } else {
            table.column(rule.key(), width)
        }
    })
}

/// The level at which floors face each other, or the height of a floor that faces a column \[m\].
fn faced(one: &Separation) -> String {
    match one.heights {
        Some([height, _]) if one.at_column => format!("{} m", digits(height)),
        _ => one.at_level.to_string(),
    }
}

/// Adds the result of one gap and its table.
fn of_gap<'a>(folder: &OfFolder<'a, GapsUnderMotion>, answer: Answer<'a>, gap: &RequiredAt, shown: &[Rule]) -> Answer<'a> {
    let scene = folder.scene;
    let found = folder
        .found()
        .filter_map(|(line, found)| Some((line, found.separations.get(gap.index)?)));
    let found: Vec<_> = found.collect();
    let [one, other] = [gap.left, gap.left + 1].map(|index| scene.structures[index].name());
    let in_scene = gap
        .own
        .map_or_else(String::new, |own| format!(", {} mm in the scene", digits(own * 1e3)));
    let told = || says_columns(scene, gap.left);
    let mut said: Vec<String> = gap.not_counted.iter().cloned().collect();
    let may_be_enough = Standing {
        over: over_capacity_of(folder),
        isolators: isolators_of(folder),
        may_fall: folder.scene.is_bridge(),
        strained: strained(folder),
        fallen: gap.fallen,
    }
    .may_be_enough();
    said.extend(gap.all.as_ref().into_iter().flat_map(|all| {
        let enough = says_enough(all, &gap.fallen, may_be_enough);
        std::iter::once(enough).chain(result(all, gap.own, told(), shown))
    }));
    said.extend(gap.widest.iter().map(|widest| format!("largest under {widest}")));
    let is_counted = |line: &MotionLine<GapsUnderMotion>| !gap.fallen_events.contains(&line.event);
    let table = Table::of(found).shown("Record", |(line, _)| {
        let name = line.name();
        Shown::from(name).over((!is_counted(line)).then(|| "not counted".into()))
    });
    let answer = answer
        .say(Where::Terminal, "Gap", vec![format!("{one} – {other}{in_scene}")])
        .say(Where::Terminal, "Result", said);
    if gap.all.is_none() {
        return answer;
    }
    answer.table(Where::Terminal, numbers(scene, shown, table, |(_, one)| Some(*one)).grid())
}

/// The floors of a gap that face columns, in a sentence.
fn says_columns(scene: &Scene, gap: usize) -> Option<String> {
    let floors = Floors::of(&scene.clone().seeking_gaps()).ok()?;
    floors.says_columns(gap)
}

/// The widths of a gap under the events that count.
struct BelievedWidths<'a> {
    found: Vec<(Case, &'a Separation)>,
    /// The motion that asks for the largest, with its factor.
    widest: Option<String>,
    /// A sentence about the events that do not count.
    not_counted: Option<String>,
    /// The events that do not count.
    fallen: Fallen,
    /// Their indices.
    fallen_events: BTreeSet<usize>,
}

/// Returns the widths of the events under which every building stands alone within belief.
fn believed<'a>(folder: &OfFolder<'a, GapsUnderMotion>, gap: usize) -> BelievedWidths<'a> {
    let doubted = folder.found().filter_map(|(line, found)| Some((line, found.disbelieved.as_ref()?)));
    let doubted: Vec<_> = doubted.collect();
    let not_counted: BTreeSet<usize> = doubted.iter().map(|(line, _)| line.event).collect();
    let collapsed = doubted.iter().filter(|(_, excess)| excess.kind == ExcessKind::Collapse);
    let fallen = Fallen {
        of: events(folder.found()),
        doubted: not_counted.len(),
        collapsed: events(collapsed.copied()),
        sample: EVENT,
        words: folder.scene.words(),
    };
    let all = folder.found().filter(|(line, _)| !not_counted.contains(&line.event));
    let all: Vec<_> = all
        .filter_map(|(line, found)| Some((line, found, found.separations.get(gap)?)))
        .collect();
    let widest = all.iter().rev().max_by(|one, other| one.2.required.total_cmp(&other.2.required));
    let widest = widest.filter(|(.., one)| folder.suite.n_events > 1 && one.required > 0.0);
    let widest = widest.map(|(line, found, _)| format!("{}{}", line.name(), factor(found.scale)));
    let worst = beyond_belief(doubted.iter().map(|(_, excess)| *excess)).map(|worst| {
        let (says, alone, worst) = (fallen.says(), fallen.words.alone, says_beyond(worst));
        match fallen.doubted {
            n if n == fallen.of => format!("no width is given: under every event {says} even {alone}, whatever the gap ({worst})"),
            1 => format!("1 event is not counted, under which {says} even {alone}, whatever the gap ({worst})"),
            n => format!("{n} events are not counted, under which {says} even {alone}, whatever the gap ({worst})"),
        }
    });
    BelievedWidths {
        found: all.iter().map(|(line, _, one)| ([line.event, 0], *one)).collect(),
        widest,
        not_counted: worst,
        fallen,
        fallen_events: not_counted,
    }
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

/// The width that is enough for all events, or that keeps floors apart, and no more.
fn says_enough(all: &RequiredGap, fallen: &Fallen, may_be_enough: bool) -> String {
    let widths = &all.required;
    let n = widths.sorted().len();
    let largest = enough(widths.largest());
    if widths.largest() <= Separation::ALIKE {
        return "they move alike: the gap closes by less than 1 mm. That rests on equal periods and masses; change one of them by a few per cent before \
                a width is called enough"
            .into();
    }
    let all_events = match n {
        _ if fallen.doubted > 0 => fallen.others(),
        1 => "the only event".into(),
        2 => "both events".into(),
        n => format!("all {n} events"),
    };
    let enough_for = if may_be_enough { "are enough for" } else { "keep floors apart in" };
    let spread = if widths.has_quantiles() {
        format!(
            "; {} mm for half of them, {} mm for 84 %",
            enough(widths.median()),
            enough(widths.p84())
        )
    } else if n > 1 {
        ": the largest of so few".into()
    } else {
        String::new()
    };
    format!("{largest} mm {enough_for} {all_events}{spread}{}", fallen.whatever())
}

/// Whether the rules and the gap of the scene give the width that is needed.
fn result(all: &RequiredGap, own: Option<f64>, columns: Option<String>, shown: &[Rule]) -> Vec<String> {
    let widths = &all.required;
    let mut lines = Vec::new();
    let width = all.beside_columns.map(enough);
    lines.extend(
        columns
            .zip(width)
            .map(|(columns, width)| format!("{columns} {width} mm keep floors from columns")),
    );
    lines.extend(own.map(|own| {
        format!(
            "with the {} mm of the scene the structures touch under {} of them",
            digits(own * 1e3),
            widths.count_above(own)
        )
    }));
    let common = all.rules.iter().filter(|one| shown.contains(&one.rule));
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
