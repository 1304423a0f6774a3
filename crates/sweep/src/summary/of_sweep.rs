//! The summary of a sweep: its form, and its runs summed up.

use std::ops::Range;

use super::form::{EventsOfMotions, Form, Listed, Summed};
use super::tally::Tally;
use crate::Sweep;
use crate::summary_file::Summary;
use pounding_text::Refused;

impl Sweep {
    /// Of what a summary in these words is made, where each record shakes in so many directions.
    pub(crate) fn form(&self, words: &Summary, n_directions: usize) -> Result<Form, Refused> {
        let (listed, axes) = (self.listed(n_directions), self.plan.axes());
        let value = |name: &str, place: u64| {
            if let Some(axis) = axes.iter().find(|axis| axis.name == name) {
                return axis.text(axis.spread.at(place));
            }
            let place = usize::try_from(place).expect("below the number of motions");
            if name == REVERSED {
                self.motions.all[place].is_reversed().to_string()
            } else {
                self.motions.all[place * n_directions].name.clone()
            }
        };
        let events = (self.motions.all.len() > 1).then(|| EventsOfMotions {
            of_motion: self.motions.all.iter().map(|motion| motion.event).collect(),
            runs: self.n_runs() / self.motions.all.len() as u64,
        });
        let form = Form::of(words, &listed, value, self.summed_columns())?;
        Ok(Form { events, ..form })
    }

    /// Possible axes of cells: the motion, and every field with a list of values.
    fn listed(&self, n_directions: usize) -> Vec<Listed> {
        let n_directions = n_directions as u64;
        let n_motions = self.motions.all.len() as u64;
        let under_one = self.n_runs() / n_motions;
        let record = Listed {
            name: RECORD.into(),
            count: n_motions / n_directions,
            runs: under_one * n_directions,
        };
        let reversed = Listed {
            name: REVERSED.into(),
            count: n_directions,
            runs: under_one,
        };
        let axes = self.plan.axes().iter().filter_map(|axis| {
            let (runs, count) = axis.turns()?;
            Some(Listed {
                name: axis.name.clone(),
                count,
                runs,
            })
        });
        [record, reversed].into_iter().chain(axes).collect()
    }

    /// Its columns of numbers, without thresholds.
    fn summed_columns(&self) -> Vec<Summed> {
        let summed = self.outputs.iter().map(|output| Summed {
            name: output.name.clone(),
            quantity: output.quantity.about().name.into(),
            is_peak: output.quantity.is_peak(),
            thresholds: Vec::new(),
        });
        summed.collect()
    }

    /// Runs a range of runs, some at a time, and sums them up; `None` if stopped before the end. `done` receives the number of runs each
    /// time.
    pub(crate) fn summed_up(&self, form: &Form, runs: Range<u64>, at_a_time: u64, done: &(dyn Fn(u64) + Sync)) -> Option<Tally> {
        let mut tally = Tally::default();
        let mut run = runs.start;
        while run < runs.end {
            let next = (run + at_a_time).min(runs.end);
            tally.add_batch(form, &self.batch_unless_stopped(run..next)?);
            done(next - run);
            run = next;
        }
        Some(tally)
    }
}

/// Names of the axes of motions, as in columns.
const RECORD: &str = "record";
const REVERSED: &str = "reversed";
