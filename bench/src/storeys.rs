//! Cost of a floor in a step, over the number of storeys and the number of buildings.

use std::path::Path;

use pounding_scene::Method;

use crate::measure::{Outcome, RatioTable, Rounds, in_turn, keep, ratio};
use crate::rows::{Condition, FloorCost, RowSize, TimedRow, floor_cost_figure};
use crate::setting::RECORD;

const TABLE: RatioTable = RatioTable {
    path: "results/storeys.csv",
    title: "A floor in a step beside one in a row of structures of one storey",
    header: "method,columns,contact,storeys,buildings,floors,touching_share,touching_share_one_storey,\
             wall_time_over_smallest,per_floor_over_one_storey",
};
const FIGURE: &str = "results/storeys.png";
/// Storeys of five buildings, and numbers of buildings of five storeys.
const STOREYS: [usize; 7] = [1, 2, 3, 5, 10, 20, 50];
const BUILDINGS: [usize; 4] = [2, 10, 30, 100];
/// The row common to both series, and the row whose time is the unit.
const FIXED: RowSize = RowSize { storeys: 5, buildings: 5 };
const SMALLEST: RowSize = RowSize { storeys: 1, buildings: 5 };
/// Least number and duration of rounds over the rows of a method and condition: their median ignores rounds in which the machine was busy.
const ROUNDS: Rounds = Rounds::new(3, 2);
/// Floors per round and size. Other load affects short runs most, which are therefore many.
const FLOORS_PER_ROUND: usize = 100;
/// Most floors in contact for the exact method: larger bodies take minutes.
const MOST_EXACT: usize = 30;

/// Times rows of buildings against rows of one storey, in turn, and keeps medians of ratios and a figure.
pub(super) fn run(root: &Path) -> Outcome<()> {
    let (mut lines, mut costs) = (Vec::new(), Vec::new());
    for (name, method) in TimedRow::methods() {
        for condition in Condition::ALL {
            let words = condition.words().join(",");
            for (size, over_smallest, cells) in timed(method, condition, &root.join(RECORD))? {
                lines.push(format!("{name},{words},{cells}"));
                costs.push(FloorCost {
                    method: name,
                    condition,
                    size,
                    over_smallest,
                });
            }
            println!("{name}, {words}: timed");
        }
    }
    keep(root, FIGURE, &floor_cost_figure(&costs, FIXED, SMALLEST)?)?;
    TABLE.write(root, &lines)
}

/// All rows that are timed, each once.
fn sizes(method: Method, condition: Condition) -> impl Iterator<Item = RowSize> {
    let over_storeys = STOREYS.map(|storeys| RowSize { storeys, ..FIXED });
    let over_buildings = BUILDINGS.map(|buildings| RowSize { buildings, ..FIXED });
    let exact_in_contact = method.time_step().is_none() && condition.touching;
    let sizes = over_storeys.into_iter().chain(over_buildings);
    sizes.filter(move |size| !exact_in_contact || size.floors() <= MOST_EXACT)
}

/// For every size, its time over that of the smallest row, and the cells of its line.
fn timed(method: Method, condition: Condition, record: &Path) -> Outcome<Vec<(RowSize, f64, String)>> {
    let row = |size| TimedRow::new(size, condition, method, record);
    let sizes: Vec<RowSize> = sizes(method, condition).collect();
    let mut rows = Vec::new();
    for size in &sizes {
        // The smallest row runs as often as needed for the same number of floors.
        let times = size.floors().div_ceil(SMALLEST.floors());
        rows.extend([(row(*size)?, 1), (row(size.of_one_storey())?, 1), (row(SMALLEST)?, times)]);
    }
    // Compared rows follow each other, each time in another order, because the machine changes its speed in a rhythm.
    let turns = |(one, size): (usize, &RowSize)| {
        let rotated = |turn: usize| (0..3).map(move |place| 3 * one + (turn + place) % 3);
        let turns = 0..FLOORS_PER_ROUND.div_ceil(size.floors());
        turns.flat_map(rotated).collect::<Vec<_>>()
    };
    let order: Vec<usize> = sizes.iter().enumerate().flat_map(turns).collect();
    let mut touch = vec![None; rows.len()];
    let times = in_turn(&order, ROUNDS, |one| {
        let (row, times) = &rows[one];
        for _ in 0..*times {
            touch[one] = row.run()?;
        }
        Ok(())
    })?;
    let line = |(one, size): (usize, &RowSize)| {
        let [own, single, smallest] = [0, 1, 2].map(|of| times[3 * one + of].as_slice());
        let over_smallest = rows[3 * one + 2].1 as f64 * ratio(own, smallest);
        let share = |of: Option<f64>| of.map_or_else(String::new, |of| format!("{of:.3}"));
        let cells = format!(
            "{},{},{},{},{},{over_smallest:.2},{:.2}",
            size.storeys,
            size.buildings,
            size.floors(),
            share(touch[3 * one]),
            share(touch[3 * one + 1]),
            ratio(own, single)
        );
        (*size, over_smallest, cells)
    };
    Ok(sizes.iter().enumerate().map(line).collect())
}
