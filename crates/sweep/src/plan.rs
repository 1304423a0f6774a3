//! The order of runs: the motion and the values of a run follow from its number alone.

use serde_json::{Number, Value};

use super::field_path::FieldPath;
use super::file::{MOST, Samples, SweepFile, Vary};
use super::sampling::{SamplePoint, Sampler, most_sobol_axes};
use super::spread::Spread;
use pounding_text::Refused;

/// A varying axis.
#[derive(Debug, Clone)]
pub(super) struct Axis {
    /// Name of its column.
    pub(super) name: String,
    /// Its entry in the file.
    pub(super) place: String,
    pub(super) fields: Vec<FieldPath>,
    pub(super) spread: Spread,
    /// Number of runs between changes of its value; `None` for a sampled axis.
    stride: Option<u64>,
}

/// The value of an axis in a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Setting {
    Number(f64),
    /// One of the values of a list, by its index.
    Listed(usize),
}

/// The order of the runs: motions outermost, then grids and lists in the order of the file, samples innermost.
#[derive(Debug, Clone)]
pub(super) struct Plan {
    axes: Vec<Axis>,
    sampler: Option<Sampler>,
    n_samples: u64,
    runs_per_motion: u64,
    n_motions: u64,
}

impl Plan {
    pub(super) fn new(vary: Vec<(Vary, Vec<FieldPath>)>, samples: Option<Samples>, n_motions: usize) -> Result<Self, Refused> {
        let n_motions = n_motions as u64;
        let n_sampled = check_samples(&vary, samples)?;
        let n_samples = samples.map_or(1, |samples| samples.count);
        let counts = vary.iter().map(|(vary, _)| vary.spread.count().unwrap_or(1));
        let total = counts.chain([n_samples, n_motions]).map(|count| count as f64).product::<f64>();
        if total > MOST as f64 {
            let found = Refused::at("vary").found(format!("{total:e} runs")).allowed_are("up to 1e15");
            return Err(found.help("take coarser grids or fewer samples"));
        }
        let mut stride = n_samples;
        let mut axes = Vec::with_capacity(vary.len());
        for (index, (vary, fields)) in vary.into_iter().enumerate().rev() {
            let count = vary.spread.count();
            axes.push(Axis {
                name: vary.name(),
                place: format!("vary[{index}]"),
                fields,
                spread: vary.spread,
                stride: count.is_some().then_some(stride),
            });
            stride *= count.unwrap_or(1);
        }
        axes.reverse();
        Ok(Self {
            axes,
            sampler: samples.map(|samples| Sampler::new(samples, n_sampled)),
            n_samples,
            runs_per_motion: stride,
            n_motions,
        })
    }

    pub(super) fn axes(&self) -> &[Axis] {
        &self.axes
    }

    pub(super) fn n_runs(&self) -> u64 {
        self.runs_per_motion * self.n_motions
    }

    /// The motion of a run, and the first run of the next motion.
    pub(super) fn motion(&self, run: u64) -> (usize, u64) {
        let motion = run / self.runs_per_motion;
        let index = usize::try_from(motion).expect("motions are kept in a list");
        (index, (motion + 1) * self.runs_per_motion)
    }

    /// The first values of grids and lists, and the medians of samples, independent of the seed.
    pub(super) fn typical(&self) -> Vec<Setting> {
        let setting = |axis: &Axis| axis.setting(0, || 0.5);
        self.axes.iter().map(setting).collect()
    }

    /// Writes the values of a run, axis by axis.
    pub(super) fn settings(&self, run: u64, point: &mut SamplePoint, to: &mut Vec<Setting>) {
        let place = run % self.runs_per_motion;
        if let Some(sampler) = &self.sampler {
            sampler.point(place % self.n_samples, point);
        }
        let mut coordinates = point.coordinates.iter();
        to.clear();
        to.extend(
            self.axes
                .iter()
                .map(|axis| axis.setting(place, || *coordinates.next().expect("a coordinate for each sampled axis"))),
        );
    }
}

/// Most values of a list that are checked for unusual ones, besides the last.
const MOST_LISTED: u64 = 16;

/// Fields that must not vary, and their alternatives.
const FIXED: [(&str, &str); 6] = [
    ("name", "it changes no number"),
    ("record.file", "name records in `records`"),
    ("record.component", "name records in `records`"),
    ("record.second_file", "name records in `records`"),
    ("record.axis_deg", "run a sweep for each axis"),
    ("record.reversed", "say `directions`"),
];

/// What varies, with the places of its fields in the scene.
pub(super) fn placed(file: &SweepFile, scene: &Value) -> Result<Vec<(Vary, Vec<FieldPath>)>, Refused> {
    let mut known: Vec<FieldPath> = Vec::new();
    let mut placed = Vec::with_capacity(file.vary.len());
    for (index, vary) in file.vary.iter().enumerate() {
        let place = || format!("vary[{index}]");
        let mut fields = Vec::new();
        for field in &vary.fields {
            let found = FieldPath::all(field, scene).map_err(|refused| refused.in_field(place()))?;
            for one in found {
                if let Some(instead) = fixed(&one, file) {
                    let found = Refused::at(place()).found(format!("the field `{one}`, which does not vary here"));
                    return Err(found.so(": ", instead));
                }
                if known.iter().any(|other| other.meets(&one)) {
                    let found = format!("the field `{one}` a second time, by itself or within another field");
                    return Err(Refused::at(place()).found(found).allowed_is("once").help("delete one"));
                }
                known.push(one.clone());
                fields.push(one);
            }
        }
        placed.push((vary.clone(), fields));
    }
    Ok(placed)
}

/// Whether the method, or a part of it, is among these fields.
pub(super) fn varies_method(fields: &[FieldPath]) -> bool {
    fields.iter().any(|field| field.is_in("method"))
}

/// The alternative to varying a field that must not vary.
fn fixed(place: &FieldPath, file: &SweepFile) -> Option<&'static str> {
    let text = place.to_string();
    if text == "record" {
        return Some("vary fields of it, or name records in `records`");
    }
    if file.records.is_some() && place.is_in("record.generated") {
        return Some("`records` stand in its place; delete one of them");
    }
    let mut all = FIXED.iter();
    all.find(|(fixed, _)| text == *fixed).map(|(_, instead)| *instead)
}

/// Number of sampled axes; refuses samples of nothing, and what is sampled without their number.
fn check_samples(vary: &[(Vary, Vec<FieldPath>)], samples: Option<Samples>) -> Result<usize, Refused> {
    let is_sampled = |(_, (vary, _)): &(usize, &(Vary, Vec<FieldPath>))| vary.spread.count().is_none();
    let mut sampled = vary.iter().enumerate().filter(is_sampled);
    let first = sampled.next().map(|(index, _)| index);
    let n = sampled.count() + usize::from(first.is_some());
    match (first, samples) {
        (Some(index), None) => {
            let random = Refused::at(format!("vary[{index}]")).is("varies at random, but `samples` is missing");
            Err(random.help("add {\"count\": 1024, \"seed\": 1, \"method\": \"sobol\"}"))
        }
        (None, Some(_)) => {
            let found = Refused::at("samples").found("samples, but nothing varies at random");
            Err(found.help("delete them, or let a field be `uniform` or `normal`"))
        }
        (_, Some(samples)) if samples.method == super::file::SampleMethod::Sobol && n > most_sobol_axes() => {
            let found = Refused::at("samples.method").found(format!("`sobol` for {n} fields at random"));
            Err(found
                .allowed_are(format!("up to {}", most_sobol_axes()))
                .help("use `latin_hypercube`"))
        }
        _ => Ok(n),
    }
}

impl Axis {
    /// Its value at a place in the order of a motion's runs.
    fn setting(&self, place: u64, coordinate: impl FnOnce() -> f64) -> Setting {
        let turns = self.turns();
        let Some(index) = turns.map(|(stride, count)| place / stride % count) else {
            let sampled = "an axis without a stride is sampled";
            return Setting::Number(self.spread.sample(coordinate()).expect(sampled));
        };
        self.spread.at(index)
    }

    /// Settings that reveal unusual values of the axis: both ends of a grid or of samples, and the first values of a list.
    pub(super) fn ends(&self) -> Vec<Setting> {
        let Some((_, count)) = self.turns() else {
            return [0.001, 0.999].map(|part| self.setting(0, || part)).into();
        };
        let first = if matches!(self.spread, Spread::Values(_)) {
            count.min(MOST_LISTED)
        } else {
            1
        };
        let places = (0..first).chain((count > first).then(|| count - 1));
        places.map(|place| self.spread.at(place)).collect()
    }

    /// For grids and lists, the number of successive runs with a value, and the number of values.
    pub(super) fn turns(&self) -> Option<(u64, u64)> {
        self.stride.zip(self.spread.count())
    }

    /// Writes a value to the field of the scene; false if this is impossible.
    pub(super) fn put(&self, setting: Setting, scene: &mut Value) -> bool {
        self.fields.iter().all(|place| {
            let Some(slot) = place.slot(scene) else {
                return false;
            };
            *slot = self.value(setting);
            true
        })
    }

    /// A setting as text in a table.
    pub(super) fn text(&self, setting: Setting) -> String {
        let value = self.value(setting);
        let text = value.as_str().map(String::from);
        text.unwrap_or_else(|| value.to_string())
    }

    /// A setting as value in a scene.
    pub(super) fn value(&self, setting: Setting) -> Value {
        match (setting, &self.spread) {
            (Setting::Listed(index), Spread::Values(values)) => values[index].clone(),
            (Setting::Listed(_), _) => Value::Null,
            (Setting::Number(number), _) => value_of(number),
        }
    }
}

impl Spread {
    /// Value number `index` of a grid or a list.
    pub(super) fn at(&self, index: u64) -> Setting {
        match self {
            Self::Values(values) => {
                let index = usize::try_from(index).expect("below the length of a list");
                let number = values[index].as_f64();
                number.map_or(Setting::Listed(index), Setting::Number)
            }
            Self::Grid(grid) => Setting::Number(grid.at(index)),
            Self::Uniform(_) | Self::LogUniform(_) | Self::Normal(_) | Self::LogNormal(_) => {
                unreachable!("what is sampled has no values to count")
            }
        }
    }
}

/// A number as value in a scene: whole numbers have no point, so that they also fit integer fields.
pub(super) fn value_of(number: f64) -> Value {
    const EXACT: f64 = 9_007_199_254_740_992.0;
    let whole = number.trunc().total_cmp(&number).is_eq() && number.abs() < EXACT;
    if whole && (number != 0.0 || number.is_sign_positive()) {
        #[expect(clippy::cast_possible_truncation, reason = "whole, below 2^53")]
        return Value::from(number as i64);
    }
    Number::from_f64(number).map_or(Value::Null, Value::Number)
}
