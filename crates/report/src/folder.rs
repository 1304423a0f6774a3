//! A scene under a folder of records: the parts of every answer about it.

use pounding_assess::{MotionLine, Suite};
use pounding_scene::{Excess, Implausible, Scene};
use pounding_text::{Answer, Table, Where, short};
use serde_json::{Value, json};

/// Sentences about the records of a folder, with `hint` behind them if they leave names out.
pub fn said_briefly(suite: &Suite, hint: &str) -> Vec<String> {
    let (mut said, all) = (suite.said(false), suite.said(true));
    if said != all {
        said.push(hint.into());
    }
    said
}

/// What helps where one unit is declared for records of several.
pub(crate) const CONVERT: &str = "take only records of that unit into the folder; `pounding motion convert` writes one in m/s²";

/// Names the factor on a record in parentheses; empty for a record that is not scaled. Warns of one that belongs to other earthquakes.
pub(crate) fn factor(scale: f64) -> String {
    let [least, most] = Implausible::USUAL_FACTORS;
    if (scale - 1.0).abs() <= 0.0 {
        String::new()
    } else if (least..=most).contains(&scale.abs()) {
        format!(" (× {})", short(scale))
    } else {
        format!(" (× {}, which belongs to another earthquake)", short(scale))
    }
}

/// Findings under one motion.
pub trait UnderMotion {
    /// Unusual values in the scene or in the record.
    fn doubts(&self) -> &[Implausible];

    /// All responses beyond the model or codes.
    fn excesses(&self) -> &[Excess];

    /// Whether a response over all motions is worth a warning.
    fn warns(_excess: &Excess) -> bool {
        true
    }

    /// Sentences before all but unusual values.
    fn cautions(_folder: &OfFolder<'_, Self>) -> Vec<String>
    where
        Self: Sized,
    {
        Vec::new()
    }

    /// Warnings about the scene, whatever the motion.
    fn warnings(_scene: &Scene) -> Vec<String> {
        Vec::new()
    }

    /// The facts of this motion for programs, as an object.
    fn facts(&self, scene: &Scene) -> Value;
}

/// A scene under the motions of a folder.
#[derive(Debug)]
pub struct OfFolder<'a, T> {
    /// The scene.
    pub scene: &'a Scene,
    /// The records of the folder.
    pub suite: &'a Suite,
    /// The findings under each motion, or why there are none.
    pub lines: &'a [MotionLine<T>],
}

/// A row of a table about a folder: a motion, and a number under it, or why there is none.
#[derive(Debug)]
pub struct MotionRow<N> {
    motion: String,
    /// Number of its event, from 1; `None` for a record that is left out.
    event: Option<usize>,
    reversed: Option<bool>,
    /// The number.
    pub found: N,
    refused: Option<String>,
}

impl<N> MotionRow<N> {
    /// A row for a number under a motion.
    pub fn of<T>(line: &MotionLine<T>, found: N) -> Self {
        Self {
            motion: line.motion.clone(),
            event: Some(line.event + 1),
            reversed: Some(line.reversed),
            found,
            refused: None,
        }
    }

    /// Returns the row as one of shaking in this direction, whatever that of its line.
    #[must_use]
    pub fn shaken(self, reversed: bool) -> Self {
        Self {
            reversed: Some(reversed),
            ..self
        }
    }
}

impl<'a, T: UnderMotion> OfFolder<'a, T> {
    /// The lines that were not refused, with their findings.
    pub fn found(&self) -> impl Iterator<Item = (&'a MotionLine<T>, &'a T)> + use<'a, T> {
        self.lines.iter().filter_map(|line| Some((line, line.found.as_ref().ok()?)))
    }

    /// Unusual values in the scene and in its records, once for each kind.
    pub fn unusual(&self) -> Vec<Implausible> {
        Implausible::gathered(self.found().flat_map(|(line, found)| {
            let doubts = found.doubts().iter();
            doubts.map(|doubt| (line.motion.as_str(), doubt))
        }))
    }

    /// Records that are missing, the worst response of each kind beyond the model or codes, and the other warnings.
    pub fn warnings(&self) -> Vec<String> {
        let excesses = Excess::gathered(self.found().map(|(_, found)| found.excesses()), "run");
        let missing = self.suite.says_missing(MotionLine::failed(self.lines).len()).into_iter();
        let units = self.suite.says_units_apart().map(|said| format!("{said}: {CONVERT}"));
        let excesses = excesses.iter().filter(|one| T::warns(one));
        let said = missing.chain(units).chain(excesses.map(ToString::to_string));
        said.chain(T::warnings(self.scene)).collect()
    }

    /// The parts that every answer about a folder begins with, and its facts for programs. [Warnings](Self::warnings) follow its result.
    pub fn answer(&self) -> Answer<'a> {
        let unusual = self.unusual();
        let motions: Vec<Value> = self.lines.iter().map(|line| self.motion(line)).collect();
        Answer::new()
            .say(Where::Terminal, "Unusual", unusual.iter().map(ToString::to_string).collect())
            .say(Where::Terminal, "Answer", T::cautions(self))
            .say(Where::Terminal, "Scene", vec![self.scene.name.clone()])
            .fact("scene", json!(self.scene))
            .fact("unusual", json!(unusual))
            .fact("cautions", T::cautions(self))
            .fact("records", self.suite.json())
            .fact("warnings", self.warnings())
            .fact("motions", motions)
            .fact("left_out", self.suite.left_out_json())
    }

    fn motion(&self, line: &MotionLine<T>) -> Value {
        let mut motion = match &line.found {
            Ok(found) => found.facts(self.scene),
            Err(reason) => json!({"refused": reason}),
        };
        motion["record"] = json!(line.motion);
        motion["event"] = json!(line.event + 1);
        motion["reversed"] = json!(line.reversed);
        motion
    }

    /// How many files became how many events, and which failed or are left out; with `details` every name.
    pub fn records(&self, details: bool) -> Vec<String> {
        let said = if details {
            self.suite.said(true)
        } else {
            said_briefly(self.suite, "--details names every one")
        };
        let (counts, remarks) = said.split_at(1);
        [counts, &MotionLine::failed(self.lines), remarks].concat()
    }

    /// The table for programs. `rows` makes the rows of a motion, and `columns` adds their columns. Motions that are refused and records that
    /// are left out have a row with the reason.
    pub fn table<N: Default + 'a>(
        &self,
        rows: impl Fn(&'a MotionLine<T>, &'a T) -> Vec<MotionRow<N>>,
        columns: impl FnOnce(Table<'a, MotionRow<N>>) -> Table<'a, MotionRow<N>>,
    ) -> Table<'a, MotionRow<N>> {
        let of_lines = self.lines.iter().flat_map(|line| match &line.found {
            Ok(found) => rows(line, found),
            Err(reason) => vec![MotionRow {
                refused: Some(reason.clone()),
                ..MotionRow::of(line, N::default())
            }],
        });
        let left_out = self.suite.left_out.iter().map(|one| MotionRow {
            motion: one.name.clone(),
            event: None,
            reversed: None,
            found: N::default(),
            refused: Some(one.reason.sentence()),
        });
        let table = Table::of(of_lines.chain(left_out))
            .column("record", |row| row.motion.clone())
            .column("event", |row| row.event)
            .column("reversed", |row| row.reversed);
        columns(table).column("refused", |row| row.refused.clone())
    }
}
