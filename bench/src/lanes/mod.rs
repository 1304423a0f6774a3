//! Scenes side by side, beside the same scenes alone, the exact method, and loops written by hand for the machine's
//! vectors.

mod buildings;
mod by_hand;
pub(super) mod towers;

use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

use by_hand::{GROUP, Group};
pub(super) use by_hand::{Law, STOREYS, instructions};
use pounding_contact::{
    Calibration, ContactLaw, FreePair, LawName, NonlinearViscoelastic, Stereomechanical,
};
use pounding_lanes::{RowsOf, SceneSums, SideBySide};
use pounding_solver::{
    Clock, Collisions, Elastic, Excitation, Hysteretic, Integrator, Node, Pair, Peaks, Row,
};

use super::setting::{
    self, CLOCK, DAMPING, EXACT, GAPS, MASS, PERIODS, RECORDED, RESTITUTION, STEPPING, STIFFNESS,
};

/// Where the ratios are kept, from the top folder.
const KEPT: &str = "results/bench/lanes.csv";
/// Scenes of each law, and those of them that run one by one.
const SCENES: usize = 4096;
const ALONE: usize = 128;
/// Why nothing is measured.
pub(super) const NO_LOOP: &str =
    "the loop by hand needs AVX-512 or AVX2, and this machine has neither: nothing is measured";
const HEADER: &str =
    "instructions,law,run,rate_ratio,scenes_that_touch,steps_in_which_a_lane_touches";
/// Relative distance of lanes and the loop by hand above which nothing is measured: sums may be taken in another order, and impacts enlarge
/// what rounding makes of it.
const MOST_APART: f64 = 1e-9;
/// Every law takes turns for as long as this.
const PATIENCE: Duration = Duration::from_secs(10);

/// Runs scenes of a law, whose numbers vary.
struct Scenes<'a> {
    groups: Vec<Group>,
    rows: Vec<Row<Elastic>>,
    excitation: Excitation<'a>,
    /// The same motion at its own samples, which is all that the exact method needs.
    recorded: Excitation<'a>,
    ground: &'a [f64],
}

/// Times all and keeps the ratios.
pub(super) fn run(root: &Path) -> Result<(), String> {
    let words = |error: pounding_solver::ModelError| error.to_string();
    let ground = ground(root)?;
    let recorded = setting::ground(root, RECORDED, CLOCK.n_steps / 2)?;
    let Some(instructions) = instructions() else {
        return Err(NO_LOOP.into());
    };
    let mut lines = Vec::new();
    for law in laws()? {
        let groups = groups(law);
        let rows = groups.iter().flat_map(rows).collect::<Result<_, _>>()?;
        let scenes = Scenes {
            groups,
            rows,
            excitation: Excitation::new(CLOCK.time_step, &ground).map_err(words)?,
            recorded: Excitation::new(RECORDED, &recorded).map_err(words)?,
            ground: &ground,
        };
        lines.extend(scenes.compare()?);
    }
    let csv = keep(&root.join(KEPT), HEADER, instructions, &lines)?;
    println!(
        "\nScenes per second on one core, over those of the loop by hand that records peaks and impulses:\n{csv}\nkept in {KEPT}"
    );
    buildings::run(root, instructions)
}

/// Impacts, and the element.
fn laws() -> Result<[Law; 2], String> {
    let asked = (RESTITUTION, Calibration::Exact);
    let mut element = LawName::NonlinearViscoelastic
        .calibrated(STIFFNESS, asked, &FreePair::UNIT)
        .map_err(|error| error.to_string())?;
    let numbers: Vec<_> = element
        .parameters()
        .into_iter()
        .map(|(_, number)| *number)
        .collect();
    Ok([
        Law::Stereomechanical(RESTITUTION),
        Law::Viscoelastic(numbers[0], numbers[1]),
    ])
}

/// Puts lines, each begun with the instructions of this machine, into a table in place of those of the same instructions before,
/// and leaves those of others; returns the table.
pub(super) fn keep(
    path: &Path,
    header: &str,
    instructions: &str,
    lines: &[String],
) -> Result<String, String> {
    let before = fs::read_to_string(path).unwrap_or_default();
    let own = format!("{instructions},");
    let others = before
        .lines()
        .skip(1)
        .filter(|line| !line.starts_with(&own));
    let lines = lines.iter().map(|line| format!("{own}{line}"));
    let all = others.map(str::to_owned).chain(lines);
    let csv = all.fold(format!("{header}\n"), |csv, line| csv + &line + "\n");
    let words = |error: std::io::Error| format!("{}: {error}", path.display());
    fs::create_dir_all(path.parent().unwrap_or(path)).map_err(words)?;
    fs::write(path, &csv).map_err(words)?;
    Ok(csv)
}

/// Time of a scene of so many steps in the bare loop by hand with impacts, on so many threads at once \[s\]; nothing on a machine
/// without its instructions.
pub(super) fn seconds_by_hand(
    root: &Path,
    threads: usize,
    clock: Clock,
) -> Result<Option<f64>, String> {
    if instructions().is_none() {
        return Ok(None);
    }
    let ground = setting::ground(root, clock.time_step, clock.n_steps)?;
    let groups = groups(Law::Stereomechanical(RESTITUTION));
    let run = || {
        for group in &groups {
            black_box(by_hand::run::<false>(group, &ground, clock.time_step));
        }
    };
    let all = &mut || {
        std::thread::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(run);
            }
        });
    };
    let times = medians(&mut [("by hand", all)]);
    Ok(Some(times[0].1 / (SCENES * threads) as f64))
}

impl Scenes<'_> {
    /// Times the scenes by all routes; a line for each.
    fn compare(&self) -> Result<Vec<String>, String> {
        let together = SideBySide::new(STEPPING, self.excitation, CLOCK);
        let together = together.map_err(|error| error.to_string())?;
        let mut tallies = SceneSums::default();
        let rows: Vec<_> = self.rows.iter().collect();
        let n_steps = vec![CLOCK.n_steps; rows.len()];
        together.run(RowsOf::Elastic(&rows), &n_steps, &mut tallies);
        let distance = self.distance(&tallies)?;
        if distance > MOST_APART {
            return Err(format!(
                "lanes and the loop by hand are {distance:.1e} apart"
            ));
        }
        let exact = Integrator::Exact(EXACT);
        let mut hand = || self.by_hand::<true>();
        let mut bare = || self.by_hand::<false>();
        let mut lanes = || {
            together.run(RowsOf::Elastic(&rows), &n_steps, &mut tallies);
            black_box(&tallies);
        };
        let stepping = Integrator::CentralDifference(STEPPING);
        let mut alone = || self.alone(stepping, self.excitation);
        let mut exactly = || self.alone(exact, self.recorded);
        let times = medians(&mut [
            ("by hand", &mut hand),
            ("by hand, bare", &mut bare),
            ("lanes", &mut lanes),
            ("alone", &mut alone),
            ("exact, alone", &mut exactly),
        ]);
        let touch = (0..SCENES).filter(|scene| tallies.pair(*scene, 0).collisions > 0.0);
        let touch = touch.count() as f64 / SCENES as f64;
        let law = self.rows[0].pairs()[0].law.name();
        let share = tallies.touching_steps as f64 / tallies.steps as f64;
        let line = |(name, time): &(&str, f64)| {
            let scenes = if name.contains("alone") {
                ALONE
            } else {
                SCENES
            };
            let ratio = times[0].1 / time * (scenes as f64 / SCENES as f64);
            format!("{law},\"{name}\",{ratio:.4},{touch:.2},{share:.3}")
        };
        Ok(times.iter().map(line).collect())
    }

    /// How far peaks and impulses of both are apart, relative to them.
    fn distance(&self, tallies: &SceneSums) -> Result<f64, String> {
        let mut largest: f64 = 0.0;
        for (index, group) in self.groups.iter().enumerate() {
            let found = by_hand::run::<true>(group, self.ground, CLOCK.time_step).ok_or(NO_LOOP)?;
            for lane in 0..GROUP {
                let scene = index * GROUP + lane;
                let mut compare = |ours, theirs| largest = largest.max(apart(ours, theirs));
                for (structure, peaks) in found.peaks.iter().enumerate() {
                    compare(tallies.displacement(scene, structure), peaks[lane]);
                }
                compare(tallies.pair(scene, 0).impulse, found.impulses[lane]);
            }
        }
        Ok(largest)
    }

    fn by_hand<const PEAKS: bool>(&self) {
        for group in &self.groups {
            black_box(by_hand::run::<PEAKS>(group, self.ground, CLOCK.time_step));
        }
    }

    /// Some scenes one by one.
    fn alone(&self, integrator: Integrator, excitation: Excitation<'_>) {
        for row in &self.rows[..ALONE] {
            black_box(solved(row, integrator, excitation).is_ok());
        }
    }
}

/// Distance of two magnitudes, relative to that of the loop; infinite where one is no number.
fn apart(ours: f64, theirs: f64) -> f64 {
    let apart = (ours.abs() - theirs).abs() / theirs.max(f64::MIN_POSITIVE);
    if apart.is_nan() { f64::INFINITY } else { apart }
}

/// Peaks of a scene that runs alone, with the recorders that give the same numbers.
fn solved<Column: Hysteretic>(
    row: &Row<Column>,
    integrator: Integrator,
    excitation: Excitation<'_>,
) -> Result<Peaks, String> {
    let n = row.nodes().len();
    let mut recorder = (Peaks::new(n), Collisions::new(n, row.pairs()));
    let ran = integrator.run(row, excitation, CLOCK, &mut recorder);
    ran.map_err(|error| error.to_string())?;
    black_box(&recorder);
    Ok(recorder.0)
}

/// Accelerations at the nodes of the clock \[m/s²\].
fn ground(root: &Path) -> Result<Vec<f64>, String> {
    setting::ground(root, CLOCK.time_step, CLOCK.n_steps)
}

/// Scenes of a law, in groups.
fn groups(law: Law) -> Vec<Group> {
    let mut random = setting::random();
    let mut between = |range: [f64; 2]| setting::between(&mut random, range);
    let mut group = || {
        let mut group = Group {
            masses: [[MASS; GROUP]; 2],
            stiffnesses: [[0.0; GROUP]; 2],
            dampings: [[0.0; GROUP]; 2],
            gaps: [0.0; GROUP],
            law,
        };
        for lane in 0..GROUP {
            for structure in 0..2 {
                let omega = 2.0 * std::f64::consts::PI / between(PERIODS);
                group.stiffnesses[structure][lane] = MASS * omega * omega;
                group.dampings[structure][lane] = 2.0 * DAMPING * MASS * omega;
            }
            group.gaps[lane] = between(GAPS);
        }
        group
    };
    (0..SCENES / GROUP).map(|_| group()).collect()
}

/// The same law of the library.
fn contact(law: Law) -> ContactLaw {
    match law {
        Law::Stereomechanical(restitution) => {
            ContactLaw::Stereomechanical(Stereomechanical { restitution })
        }
        Law::Viscoelastic(impact_stiffness, impact_damping_ratio) => {
            ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
                impact_stiffness,
                impact_damping_ratio,
            })
        }
    }
}

/// The same scenes as rows.
fn rows(group: &Group) -> Vec<Result<Row<Elastic>, String>> {
    let law = contact(group.law);
    let row = |lane: usize| {
        let node = |structure: usize| {
            let column = Elastic {
                stiffness: group.stiffnesses[structure][lane],
            };
            let damping = group.dampings[structure][lane];
            Node::structure(group.masses[structure][lane], damping, column)
        };
        let pair = Pair {
            left: 0,
            right: 1,
            gap: group.gaps[lane],
            law,
        };
        Row::new(vec![node(0), node(1)], vec![pair]).map_err(|error| error.to_string())
    };
    (0..GROUP).map(row).collect()
}

/// Median wall time of each run \[s\]; they take turns, so that what else the machine does meets all of them.
fn medians<'a>(runs: &mut [(&'a str, &mut dyn FnMut())]) -> Vec<(&'a str, f64)> {
    let started = Instant::now();
    let mut times = vec![Vec::new(); runs.len()];
    while times[0].len() < 5 || started.elapsed() < PATIENCE {
        for ((_, run), times) in runs.iter_mut().zip(&mut times) {
            let start = Instant::now();
            run();
            times.push(start.elapsed().as_secs_f64());
        }
    }
    let median = |times: &mut Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    let names = runs.iter().map(|(name, _)| *name);
    names.zip(times.iter_mut().map(median)).collect()
}
