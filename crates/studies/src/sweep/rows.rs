//! Batches as rows of CSV.

use super::plan::{Axis, Setting};
use super::quantity::name;
use super::{Batch, Sweep};

/// Rows of CSV in memory.
struct Rows(csv::Writer<Vec<u8>>);

impl Rows {
    fn new() -> Self {
        // The number of fields is ours.
        let builder = csv::WriterBuilder::new()
            .flexible(true)
            .from_writer(Vec::new());
        Self(builder)
    }

    /// A text; its line breaks become blanks, so that a row is a line.
    fn field(&mut self, field: &str) {
        let field = field.replace(['\n', '\r'], " ");
        self.0.write_field(field).expect("memory takes all");
    }

    /// A number in the shortest digits that read back to the same bits; nothing for NaN.
    fn number(&mut self, number: f64) {
        if number.is_nan() {
            return self.field("");
        }
        let mut digits = zmij::Buffer::new();
        let digits = digits.format(number);
        let digits = digits.strip_suffix(".0").unwrap_or(digits);
        self.0.write_field(digits).expect("memory takes all");
    }

    fn end(&mut self) {
        let nothing: [&[u8]; 0] = [];
        self.0.write_record(nothing).expect("memory takes all");
    }

    fn bytes(self) -> Vec<u8> {
        self.0.into_inner().expect("memory takes all")
    }
}

impl Sweep {
    /// The row that names the columns.
    pub fn header(&self) -> Vec<u8> {
        let mut rows = Rows::new();
        for column in self.columns() {
            rows.field(&column);
        }
        rows.end();
        rows.bytes()
    }

    /// Names of the columns: the run, its record and direction, what varies, what came out, and why it failed.
    pub fn columns(&self) -> Vec<String> {
        let mut columns = vec!["run".into(), "record".into(), "reversed".into()];
        columns.extend(self.plan.axes().iter().map(|axis| axis.name.clone()));
        let of = |names: &[String], asked: &[String]| {
            let column = |name: &String| {
                let asked = asked.iter();
                asked
                    .map(|one| format!("{name}: {one}"))
                    .collect::<Vec<_>>()
            };
            unique(names).iter().flat_map(column).collect::<Vec<_>>()
        };
        let pairs = self.row.pairs.iter();
        let pairs: Vec<String> = pairs
            .map(|[left, right]| format!("{left} – {right}"))
            .collect();
        let structures: Vec<String> = self.outputs.structures.iter().map(name).collect();
        columns.extend(of(&self.row.floors, &structures));
        let quantities: Vec<String> = self.outputs.pairs.iter().map(name).collect();
        columns.extend(of(&pairs, &quantities));
        columns.push("failed".into());
        columns
    }

    /// A row for each run of a batch; each is one line.
    pub fn rows(&self, batch: &Batch) -> Vec<u8> {
        let mut rows = Rows::new();
        let (mut point, mut settings) = (Vec::new(), Vec::new());
        for (index, run) in batch.runs.clone().enumerate() {
            let shaking = &self.motions.all[self.plan.motion(run).0];
            rows.field(&run.to_string());
            rows.field(&shaking.name);
            rows.field(if shaking.is_reversed() {
                "true"
            } else {
                "false"
            });
            self.plan.settings(run, &mut point, &mut settings);
            for (axis, setting) in self.plan.axes().iter().zip(&settings) {
                rows.setting(axis, *setting);
            }
            for column in &batch.columns {
                rows.number(column[index]);
            }
            let reason = batch.failed[index].as_deref().unwrap_or_default();
            rows.field(reason);
            rows.end();
        }
        rows.bytes()
    }
}

impl Rows {
    fn setting(&mut self, axis: &Axis, setting: Setting) {
        match setting {
            Setting::Number(number) => self.number(number),
            Setting::Listed(_) => {
                let value = axis.value(setting);
                let text = value
                    .as_str()
                    .map_or_else(|| value.to_string(), String::from);
                self.field(&text);
            }
        }
    }
}

/// Names that are told apart by their number where they are the same.
fn unique(names: &[String]) -> Vec<String> {
    let same = |index: usize| names.iter().filter(move |name| **name == names[index]);
    let own = |index: usize| {
        let before = names[..index].iter().filter(|name| **name == names[index]);
        match same(index).count() {
            1 => names[index].clone(),
            _ => format!("{} ({})", names[index], before.count() + 1),
        }
    };
    (0..names.len()).map(own).collect()
}
