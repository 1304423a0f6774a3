//! What a floor costs in a step, over the storeys of buildings and over their number.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use pounding_scene::Method;
use pounding_studies::{Condition, FloorCost, RowSize, TimedRow, floor_cost_figure};

/// Where the ratios and their figure are kept, from the top folder.
const KEPT: [&str; 2] = ["results/storeys.csv", "results/storeys.png"];
/// The record that shakes the rows, from the top folder.
const RECORD: &str = "studies/records/el-centro-1940-ns-chopra.csv";
/// Storeys of five buildings, and numbers of buildings of five storeys.
const STOREYS: [usize; 7] = [1, 2, 3, 5, 10, 20, 50];
const BUILDINGS: [usize; 5] = [2, 5, 10, 30, 100];
/// The row that both have in common, and the one whose time is the unit.
const FIXED: RowSize = RowSize {
    storeys: 5,
    buildings: 5,
};
const SMALLEST: RowSize = RowSize {
    storeys: 1,
    buildings: 5,
};
/// Rounds over the rows of a method and condition for as long as this, at least three: their median shrugs off those in which the
/// machine was busy.
const PATIENCE: Duration = Duration::from_secs(2);
const LEAST_ROUNDS: usize = 3;
/// Floors that are timed in a round of each size: what else the machine does weighs on short runs most, which are many.
const FLOORS_PER_ROUND: usize = 100;
/// Floors up to which the exact method is timed in contact: a body of more takes minutes.
const MOST_EXACT: usize = 30;

/// A row beside one of as many structures of one storey, and beside the smallest row.
struct Beside {
    size: RowSize,
    row: TimedRow,
    single: TimedRow,
    smallest: TimedRow,
    /// Times of all three, the smallest run as often as it takes to run as many floors \[s\].
    times: Vec<[f64; 3]>,
    /// In which share of steps pairs touch, in both \[–\].
    touch: [Option<f64>; 2],
}

/// Times rows of buildings beside rows of one storey, in turn, and writes medians of ratios and a figure.
pub(super) fn run(root: &Path) -> Result<(), String> {
    let mut csv = String::from(
        "method,columns,contact,storeys,buildings,floors,touching_share,touching_share_one_storey,\
         wall_time_over_smallest,per_floor_over_one_storey\n",
    );
    let mut costs = Vec::new();
    println!("A floor in a step beside one in a row of structures of one storey:");
    for (name, method) in TimedRow::methods() {
        for condition in Condition::ALL {
            let mut rows = rows((method, condition), &root.join(RECORD))?;
            time(&mut rows)?;
            let words = condition.words().join(",");
            for one in &rows {
                let over_smallest = one.over_smallest();
                writeln!(csv, "{name},{words},{}", one.cells()).expect("a string takes all");
                costs.push(FloorCost {
                    method: name,
                    condition,
                    size: one.size,
                    over_smallest,
                });
            }
            println!("{name}, {}: {}", condition.words().join(", "), worst(&rows));
        }
    }
    let figure = floor_cost_figure(&costs, FIXED, SMALLEST).map_err(|error| error.to_string())?;
    for (path, bytes) in KEPT.into_iter().zip([csv.into_bytes(), figure]) {
        fs::write(root.join(path), bytes).map_err(|error| format!("{path}: {error}"))?;
    }
    println!("kept in {} and {}", KEPT[0], KEPT[1]);
    Ok(())
}

/// The row in which a floor costs the most, in words.
fn worst(rows: &[Beside]) -> String {
    let most = rows
        .iter()
        .max_by(|a, b| a.over_single().total_cmp(&b.over_single()));
    most.map_or_else(String::new, |most| {
        let RowSize { storeys, buildings } = most.size;
        let times = most.over_single();
        format!("at most {times:.2} times ({buildings} buildings of {storeys} storeys)")
    })
}

/// Rows of all sizes for a method and a condition.
fn rows((method, condition): (Method, Condition), record: &Path) -> Result<Vec<Beside>, String> {
    let exact_in_contact = method.time_step().is_none() && condition.touching;
    let most = if exact_in_contact {
        MOST_EXACT
    } else {
        usize::MAX
    };
    let beside = |size: RowSize| {
        let row = |size| {
            TimedRow::new(size, condition, method, record).map_err(|error| error.to_string())
        };
        Ok(Beside {
            size,
            row: row(size)?,
            single: row(size.of_one_storey())?,
            smallest: row(SMALLEST)?,
            times: Vec::new(),
            touch: [None; 2],
        })
    };
    let sizes = sizes().filter(|size| size.floors() <= most);
    sizes.map(beside).collect()
}

/// All rows, each once.
fn sizes() -> impl Iterator<Item = RowSize> {
    let over_storeys = STOREYS.map(|storeys| RowSize { storeys, ..FIXED });
    let over_buildings = BUILDINGS.map(|buildings| RowSize { buildings, ..FIXED });
    let more = over_buildings.into_iter().filter(|size| *size != FIXED);
    over_storeys.into_iter().chain(more)
}

/// Runs all rows round by round; those that are compared follow each other and take about as long, so that what else the machine does
/// meets both.
fn time(rows: &mut [Beside]) -> Result<(), String> {
    let started = Instant::now();
    let mut rounds = 0;
    while rounds < LEAST_ROUNDS || started.elapsed() < PATIENCE {
        for one in &mut *rows {
            for _ in 0..one.runs() {
                let mut times = [0.0; 3];
                // Another one first each time: the machine takes and gives back the processor in a rhythm of its own.
                for place in 0..3 {
                    let turn = (one.times.len() + place) % 3;
                    times[turn] = one.timed(turn)?;
                }
                one.times.push(times);
            }
        }
        rounds += 1;
    }
    Ok(())
}

impl Beside {
    /// Time of one of the three \[s\].
    fn timed(&mut self, which: usize) -> Result<f64, String> {
        let (row, runs) = match which {
            0 => (&self.row, 1),
            1 => (&self.single, 1),
            _ => (
                &self.smallest,
                self.size.floors().div_ceil(SMALLEST.floors()),
            ),
        };
        let mut touch = None;
        let start = Instant::now();
        for _ in 0..runs {
            touch = row.run().map_err(|error| error.to_string())?;
        }
        let seconds = start.elapsed().as_secs_f64();
        if let Some(seen) = self.touch.get_mut(which) {
            *seen = touch;
        }
        Ok(seconds)
    }

    /// Time of the row over that of the smallest one, the median of all runs.
    fn over_smallest(&self) -> f64 {
        let times = self.size.floors().div_ceil(SMALLEST.floors()) as f64;
        times * median(self.times.iter().map(|[own, _, smallest]| own / smallest))
    }

    /// Runs in a round.
    fn runs(&self) -> usize {
        FLOORS_PER_ROUND.div_ceil(self.size.floors())
    }

    /// What is measured, as cells of a table.
    fn cells(&self) -> String {
        let RowSize { storeys, buildings } = self.size;
        let share = |of: Option<f64>| of.map_or_else(String::new, |of| format!("{of:.3}"));
        let [touch, single] = self.touch.map(share);
        format!(
            "{storeys},{buildings},{},{touch},{single},{:.2},{:.2}",
            self.size.floors(),
            self.over_smallest(),
            self.over_single()
        )
    }

    /// Time of a floor over that of one in the row of one storey, the median of all runs.
    fn over_single(&self) -> f64 {
        median(self.times.iter().map(|[own, single, _]| own / single))
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
