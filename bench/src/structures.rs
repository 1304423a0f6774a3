//! Cost of a structure in rows of 2 to 1000, relative to a structure in a row of two.

use std::path::Path;

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_lanes::{RowsOf, SceneSums, SideBySide};
use pounding_solver::{Elastic, Node, Pair, Row};

use crate::measure::{Outcome, RatioTable, Rounds, in_turn, ratio};
use crate::scenes::{Beside as _, alone};
use crate::setting::{CLOCK, GAPS, Ground, RESTITUTION, STEPPING, between, random, structure};

const TABLE: RatioTable = RatioTable {
    path: "results/bench/structures.csv",
    title: "Time of a structure in a row of so many over that of one of two, impacts",
    header: "instructions,run,structures,time_of_a_structure_over_one_of_two",
};
const SIZES: [usize; 7] = [2, 5, 10, 30, 100, 300, 1000];
/// Ways to run rows, with the number of structures per round and the number of sizes. The largest rows fill all lanes of any machine. The
/// exact method would take minutes with rows of a thousand.
const WAYS: [(&str, usize, usize); 3] = [
    ("central difference in lanes", 16_000, 7),
    ("central difference", 1000, 7),
    ("exact", 1000, 6),
];
/// Least number and duration of rounds over the sizes.
const ROUNDS: Rounds = Rounds::new(3, 6);

/// Times rows of all sizes in turn and keeps medians of ratios.
pub(super) fn run(root: &Path) -> Outcome<()> {
    let ground = Ground::new(root)?;
    let [stepping, exact] = ground.methods()?;
    let beside = SideBySide::new(STEPPING, stepping.1, CLOCK)?;
    let mut sums = SceneSums::default();
    let mut lines = Vec::new();
    for (way, (name, in_round, n_sizes)) in WAYS.into_iter().enumerate() {
        let sizes = &SIZES[..n_sizes];
        let drawn = sizes.iter().map(|size| rows(*size, in_round));
        let drawn = drawn.collect::<Outcome<Vec<_>>>()?;
        let order: Vec<usize> = (0..n_sizes).collect();
        let times = in_turn(&order, ROUNDS, |size| {
            let rows = &drawn[size];
            match way {
                0 => {
                    let rows: Vec<_> = rows.iter().collect();
                    let steps = vec![CLOCK.n_steps; rows.len()];
                    if !beside.run(RowsOf::Elastic(&rows), &steps, &mut sums) {
                        return Err("rows do not run side by side".into());
                    }
                }
                _ => {
                    for row in rows {
                        alone(row, [stepping, exact][way - 1])?;
                    }
                }
            }
            Ok(())
        })?;
        for ((size, times_of), rows) in sizes.iter().zip(&times).zip(&drawn) {
            let of_two = (drawn[0].len() * SIZES[0]) as f64 / (rows.len() * size) as f64;
            let ratio = of_two * ratio(times_of, &times[0]);
            lines.push(format!("{name},{size},{ratio:.2}"));
        }
    }
    TABLE.write(root, &lines)
}

/// Random rows of a size, with this many structures together.
fn rows(size: usize, in_round: usize) -> Outcome<Vec<Row<Elastic>>> {
    let mut random = random();
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: RESTITUTION });
    let mut row = || {
        let mut node = |_| {
            let drawn = structure(&mut random);
            Node::structure(drawn.mass, drawn.damping, Elastic::of(drawn.column))
        };
        let nodes = (0..size).map(&mut node).collect();
        let pair = |left| Pair::of_floors(left, left + 1, between(&mut random, GAPS), law);
        Row::new(nodes, (0..size - 1).map(pair).collect())
    };
    let rows = (0..in_round.div_ceil(size)).map(|_| row());
    Ok(rows.collect::<Result<_, _>>()?)
}
