//! The numbers of a ground motion and what its file says, for people and for programs.

use pounding_motion::{Accelerogram, Drift, Measures, Record};
use pounding_scene::Origin;
use pounding_text::{Cell, Table, Unit, digits};
use serde_json::{Value, json};

use crate::summary::ReadingSummary;

/// A record with its measures.
#[derive(Debug, Clone, Copy)]
pub struct MeasuredRecord<'a> {
    /// The ground acceleration \[m/s²\].
    pub record: &'a Record,
    /// Its measures.
    pub measures: Measures,
    /// The velocity that the ground keeps, if it does not come to rest.
    pub drift: Option<Drift>,
}

/// A time with all its digits.
const TIME: Unit = Unit::SECOND.read(digits);

impl<'a> MeasuredRecord<'a> {
    /// Measures a record.
    pub fn of(record: &'a Record) -> Self {
        Self {
            record,
            measures: record.measures(),
            drift: record.drift(),
        }
    }

    /// Returns the table with the numbers of a motion \[SI\]. They are empty in a row without a motion.
    pub fn columns<Row: 'a>(table: Table<'a, Row>, gravity: f64, found: impl Fn(&Row) -> Option<Self> + Copy + 'a) -> Table<'a, Row> {
        let of = move |number: fn(&Self) -> Option<f64>| move |row: &Row| number(&found(row)?);
        let exact = move |number: fn(&Self) -> Option<f64>| move |row: &Row| Cell::exact(found(row).and_then(|one| number(&one)));
        let samples = move |row: &Row| found(row).map(|one| one.record.samples().len());
        table
            .gravity(gravity)
            .both("n_samples", "Samples", samples, samples)
            .number("time_step_s", "Step", &TIME, of(|one| Some(one.record.time_step())))
            .column("duration_s", exact(|one| Some(one.record.duration())))
            .number("pga_m_per_s2", "PGA", &Unit::ACCELERATION, of(|one| Some(one.measures.pga)))
            .column("peak_m_per_s2", exact(|one| Some(one.record.peak().1)))
            .number("pga_time_s", "at", &TIME, of(|one| Some(one.record.peak().0)))
            .number("pgv_m_per_s", "PGV", &Unit::SPEED, of(|one| Some(one.measures.pgv)))
            .column("pgd_m", exact(|one| Some(one.measures.pgd)))
            .column("arias_m_per_s", exact(|one| Some(one.measures.arias)))
            .column("cav_m_per_s", exact(|one| Some(one.measures.cav)))
            .column("d5_75_start_s", exact(|one| one.measures.d5_75.map(|interval| interval.start)))
            .column("d5_75_s", exact(|one| one.measures.d5_75.map(|interval| interval.duration())))
            .column("d5_95_start_s", exact(|one| one.measures.d5_95.map(|interval| interval.start)))
            .number(
                "d5_95_s",
                "D5–95",
                &Unit::PERIOD,
                of(|one| one.measures.d5_95.map(|interval| interval.duration())),
            )
            .column(
                "bracketed_s",
                exact(|one| one.measures.bracketed.map(|interval| interval.duration())),
            )
            .column("uniform_s", exact(|one| Some(one.measures.uniform)))
            .column("mean_period_s", exact(|one| one.record.mean_period()))
            .column("drift_m_per_s", exact(|one| one.drift.map(|drift| drift.velocity)))
    }

    /// The motion for programs: its numbers, and what its file says if it has one.
    pub fn json(self, origin: Option<&Origin>) -> Value {
        let file = origin.map(|origin| &origin.file);
        let readings = file.into_iter().flat_map(Accelerogram::readings).map(ReadingSummary::from);
        let unusual = file.into_iter().flat_map(Accelerogram::unusual).map(ToString::to_string);
        let mut all = MeasuredRecord::columns(Table::of([self]), 1.0, |one| Some(*one)).json()[0].take();
        all["format"] = json!(file.map(|file| file.format().name()));
        all["unit"] = json!(file.map(|file| file.unit().name()));
        all["readings"] = json!(readings.collect::<Vec<_>>());
        all["unusual"] = unusual.collect();
        all["says"] = json!(file.map(Accelerogram::provenance));
        all["sha256"] = json!(origin.map(|origin| &origin.sha256));
        all
    }
}
