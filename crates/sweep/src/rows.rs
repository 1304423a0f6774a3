//! Batches as rows of CSV.

use std::io::Write as _;

use super::plan::{Axis, Setting};
use super::sampling::SamplePoint;
use super::{Batch, Sweep};

/// Rows of CSV in memory, field by field. Every field ends with a comma, which the end of a row replaces.
#[derive(Default)]
struct Rows(Vec<u8>);

impl Rows {
    /// Writes a text; its line breaks become blanks, so that a row is a line.
    fn field(&mut self, field: &str) {
        if is_plain(field) {
            self.0.extend_from_slice(field.as_bytes());
        } else if !field.is_empty() {
            let line = field.replace(['\n', '\r'], " ");
            self.0.extend(quoted(&pounding_text::harmless(&line)));
        }
        self.0.push(b',');
    }

    /// Writes a number in the shortest digits that read back to equal bits; empty if it is not finite, as in a
    /// [`Cell`](pounding_text::Cell). Digits need no quotes.
    fn number(&mut self, number: f64) {
        if number.is_finite() {
            let mut digits = zmij::Buffer::new();
            let digits = digits.format(number);
            let digits = digits.strip_suffix(".0").unwrap_or(digits);
            self.0.extend_from_slice(digits.as_bytes());
        }
        self.0.push(b',');
    }

    fn count(&mut self, count: u64) {
        write!(self.0, "{count},").expect("memory takes all");
    }

    fn end(&mut self) {
        if let Some(last) = self.0.last_mut() {
            *last = b'\n';
        }
    }
}

/// Whether a text is a word that neither CSV nor a spreadsheet interprets: this holds for almost all fields of a long table.
fn is_plain(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_alphabetic())
        && text.bytes().all(|byte| byte.is_ascii_alphanumeric() || b" _.-".contains(&byte))
}

/// A text as a field of CSV, in quotes if needed.
fn quoted(text: &str) -> Vec<u8> {
    // A buffer of the usual size would be cleared for every field.
    let mut writer = csv::WriterBuilder::new()
        .buffer_capacity(2 * text.len() + 4)
        .from_writer(Vec::new());
    writer.write_record([text]).expect("memory takes all");
    let mut bytes = writer.into_inner().expect("memory takes all");
    bytes.pop();
    bytes
}

impl Sweep {
    /// The row that names the columns.
    pub fn header(&self) -> Vec<u8> {
        let mut rows = Rows::default();
        for column in self.columns() {
            rows.field(&column);
        }
        rows.end();
        rows.0
    }

    /// Names of the columns: run, record and direction, varying fields, results, kind of check, and reason of failure.
    pub fn columns(&self) -> Vec<String> {
        let mut columns = vec!["run".into(), "record".into(), "reversed".into()];
        columns.extend(self.plan.axes().iter().map(|axis| axis.name.clone()));
        columns.extend(self.outputs.iter().map(|output| output.name.clone()));
        columns.extend(["checked".into(), "failed".into()]);
        columns
    }

    /// A row for each run of a batch; each is a line.
    pub fn rows(&self, batch: &Batch) -> Vec<u8> {
        let mut rows = Rows::default();
        let (mut point, mut settings) = (SamplePoint::default(), Vec::new());
        let (mut shaken, mut of_motion) = (None, Vec::new());
        for (index, run) in batch.runs.clone().enumerate() {
            let motion = self.plan.motion(run).0;
            if shaken != Some(motion) {
                (shaken, of_motion) = (Some(motion), self.fields_of_motion(motion));
            }
            rows.count(run);
            rows.0.extend_from_slice(&of_motion);
            self.plan.settings(run, &mut point, &mut settings);
            for (axis, setting) in self.plan.axes().iter().zip(&settings) {
                rows.setting(axis, *setting);
            }
            for column in &batch.columns {
                rows.number(column[index]);
            }
            rows.field(batch.checked[index].name());
            let reason = batch.failed[index].as_deref().unwrap_or_default();
            rows.field(reason);
            rows.end();
            if index == 0 {
                // The other rows are about as long.
                rows.0.reserve(batch.failed.len() * rows.0.len());
            }
        }
        rows.0
    }

    /// Name and direction of a motion, as fields.
    fn fields_of_motion(&self, motion: usize) -> Vec<u8> {
        let shaking = &self.motions.all[motion];
        let mut fields = Rows::default();
        fields.field(&shaking.name);
        fields.field(if shaking.is_reversed() { "true" } else { "false" });
        fields.0
    }
}

impl Rows {
    fn setting(&mut self, axis: &Axis, setting: Setting) {
        match setting {
            Setting::Number(number) => self.number(number),
            Setting::Listed(_) => {
                self.field(&axis.text(setting));
            }
        }
    }
}
