//! What a structure costs in rows of 2 to 1000, beside one in a row of two.

use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_lanes::{RowsOf, SceneSums, SideBySide};
use pounding_solver::{Collisions, Elastic, Excitation, Integrator, Node, Pair, Peaks, Row};

use super::lanes;
use super::setting::{
    self, CLOCK, DAMPING, EXACT, GAPS, MASS, PERIODS, RECORDED, RESTITUTION, STEPPING,
};

/// Where the ratios are kept, from the top folder.
const KEPT: &str = "results/bench/structures.csv";
const HEADER: &str = "instructions,run,structures,time_of_a_structure_over_one_of_two";
const SIZES: [usize; 7] = [2, 5, 10, 30, 100, 300, MOST];
const MOST: usize = 1000;
/// Structures that run in a round of each size; rows of the largest then fill all lanes, of any machine.
const IN_ROUND: usize = 16_000;
/// Of these the part that runs one by one, and by the exact method: long rows of which it takes minutes.
const ALONE: usize = 1000;
const MOST_EXACT: usize = 300;
/// Every way to run takes turns over the sizes for as long as this, at least thrice.
const PATIENCE: Duration = Duration::from_secs(6);

/// Rows of one size.
struct Sized {
    structures: usize,
    rows: Vec<Row<Elastic>>,
    /// Times for a structure \[s\].
    times: Vec<f64>,
}

/// Times rows of all sizes in turn and writes medians of ratios.
pub(super) fn run(root: &Path) -> Result<(), String> {
    let words = |error: pounding_solver::ModelError| error.to_string();
    let ground = setting::ground(root, CLOCK.time_step, CLOCK.n_steps)?;
    let recorded = setting::ground(root, RECORDED, CLOCK.n_steps / 2)?;
    let sampled = Excitation::new(CLOCK.time_step, &ground).map_err(words)?;
    let recorded = Excitation::new(RECORDED, &recorded).map_err(words)?;
    let mut lines = Vec::new();
    let beside = SideBySide::new(STEPPING, sampled, CLOCK).map_err(|error| error.to_string())?;
    let mut tallies = SceneSums::default();
    lines.extend(medians(
        "central difference in lanes",
        IN_ROUND,
        MOST,
        &mut |rows| {
            let rows: Vec<_> = rows.iter().collect();
            beside.run(
                RowsOf::Elastic(&rows),
                &vec![CLOCK.n_steps; rows.len()],
                &mut tallies,
            )
        },
    )?);
    for (name, most, (integrator, excitation)) in [
        (
            "central difference",
            MOST,
            (Integrator::CentralDifference(STEPPING), sampled),
        ),
        ("exact", MOST_EXACT, (Integrator::Exact(EXACT), recorded)),
    ] {
        lines.extend(medians(name, ALONE, most, &mut |rows| {
            rows.iter().all(|row| {
                let n = row.nodes().len();
                let mut recorder = (Peaks::new(n), Collisions::new(n, row.pairs()));
                let ran = integrator.run(row, excitation, CLOCK, &mut recorder);
                black_box(recorder);
                ran.is_ok()
            })
        })?);
    }
    let instructions = lanes::instructions().unwrap_or("others");
    let csv = lanes::keep(&root.join(KEPT), HEADER, instructions, &lines)?;
    println!(
        "\nTime of a structure in a row of so many over that of one of two, impacts:\n{csv}\nkept in {KEPT}"
    );
    Ok(())
}

/// Lines of one way to run rows of so many structures in a round, up to a size.
fn medians(
    name: &str,
    in_round: usize,
    most: usize,
    run: &mut dyn FnMut(&[Row<Elastic>]) -> bool,
) -> Result<Vec<String>, String> {
    let sizes = SIZES.into_iter().filter(|size| *size <= most);
    let mut sizes = sizes
        .map(|structures| sized(structures, in_round))
        .collect::<Result<Vec<_>, _>>()?;
    let begun = Instant::now();
    while sizes[0].times.len() < 3 || begun.elapsed() < PATIENCE {
        for one in &mut sizes {
            let start = Instant::now();
            if !run(&one.rows) {
                return Err(format!("{name}: a row of {} does not run", one.structures));
            }
            let time = start.elapsed().as_secs_f64();
            one.times
                .push(time / (one.structures * one.rows.len()) as f64);
        }
    }
    let line = |one: &Sized| {
        let ratios = one.times.iter().zip(&sizes[0].times);
        let mut ratios: Vec<f64> = ratios.map(|(time, two)| time / two).collect();
        ratios.sort_by(f64::total_cmp);
        format!("{name},{},{:.2}", one.structures, ratios[ratios.len() / 2])
    };
    Ok(sizes.iter().map(line).collect())
}

/// Rows of a size at random.
fn sized(structures: usize, in_round: usize) -> Result<Sized, String> {
    let mut random = setting::random();
    let mut between = |range: [f64; 2]| setting::between(&mut random, range);
    let mut row = |_| {
        let node = |period: f64| {
            let omega = 2.0 * std::f64::consts::PI / period;
            let stiffness = MASS * omega * omega;
            Node::structure(MASS, 2.0 * DAMPING * MASS * omega, Elastic { stiffness })
        };
        let nodes = (0..structures).map(|_| node(between(PERIODS))).collect();
        let pair = |left| {
            Pair::of_floors(
                left,
                left + 1,
                between(GAPS),
                ContactLaw::Stereomechanical(Stereomechanical {
                    restitution: RESTITUTION,
                }),
            )
        };
        let pairs = (0..structures - 1).map(pair).collect();
        Row::new(nodes, pairs).map_err(|error| error.to_string())
    };
    Ok(Sized {
        structures,
        rows: (0..in_round.div_ceil(structures))
            .map(&mut row)
            .collect::<Result<_, _>>()?,
        times: Vec::new(),
    })
}
