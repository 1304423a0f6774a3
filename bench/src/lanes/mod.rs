//! Scenes in lanes, compared with these scenes alone, the exact method, and the loop written by hand.

mod by_hand;
mod tower;

use std::hint::black_box;
use std::path::Path;

use by_hand::Keeps;
use fearless_simd::Level;
use pounding_contact::ContactLaw;
use pounding_lanes::{SceneSums, SideBySide};
use pounding_solver::{Clock, Levels, Peaks, Row};

use crate::measure::{Outcome, RatioTable, Rounds, in_turn, median};
use crate::scenes::{self, Beside, GROUP, Group, alone, laws};
use crate::setting::{self, CLOCK, Ground, STEPPING};

const STRUCTURES: RatioTable = RatioTable {
    path: "results/bench/lanes.csv",
    title: "Scenes of two structures per second on one core, over those of the loop by hand that records peaks and impulses",
    header: "instructions,law,run,rate_ratio,scenes_that_touch,steps_in_which_a_lane_touches",
};
const TOWERS: RatioTable = RatioTable {
    path: "results/bench/buildings.csv",
    title: "The same of two towers of bilinear storeys",
    header: "instructions,law,run,rate_ratio,scenes_that_touch,steps_in_which_a_lane_touches,error",
};

/// A way to run scenes.
#[derive(Clone, Copy)]
enum Way {
    ByHand(Keeps),
    /// In lanes, this many scenes at a time.
    Lanes(usize),
    /// Scene after scene with recorders: by central differences, or by the exact method.
    Alone(usize),
}

/// Ways in tables, and number of scenes that run: all, or the first. The first way is the unit.
type Ways = &'static [(&'static str, Way, usize)];
const ALL: usize = usize::MAX;
const OF_STRUCTURES: Ways = &[
    ("by hand", Way::ByHand(Keeps::Peaks), ALL),
    ("by hand, bare", Way::ByHand(Keeps::Nothing), ALL),
    ("lanes", Way::Lanes(ALL), ALL),
    ("alone", Way::Alone(0), 128),
    ("exact, alone", Way::Alone(1), 128),
];
const OF_TOWERS: Ways = &[
    ("by hand", Way::ByHand(Keeps::Peaks), ALL),
    ("lanes", Way::Lanes(ALL), ALL),
    ("lanes, one scene each", Way::Lanes(1), 64),
    ("alone", Way::Alone(0), 64),
    ("exact, alone", Way::Alone(1), MEASURED),
];
/// Scenes of towers whose errors are measured.
const MEASURED: usize = 16;
/// Largest relative distance of lanes and the loop by hand; nothing is measured beyond. Sums may be taken in another order, and impacts
/// enlarge the effect of rounding.
const MOST_APART: f64 = 1e-9;
/// Least number and duration of rounds over all ways of a law.
const ROUNDS: Rounds = Rounds::new(5, 10);

/// Runs all timings and keeps the ratios.
pub(super) fn run(root: &Path) -> Outcome<()> {
    let ground = Ground::new(root)?;
    let (mut of_structures, mut of_towers) = (Vec::new(), Vec::new());
    for law in laws()? {
        let structures = Compared::<1, 1, 2>(&scenes::structures(), law, &ground);
        of_structures.extend(structures.lines::<pounding_solver::Elastic>(OF_STRUCTURES)?);
        let towers = Compared::<8, 5, 1>(&scenes::towers(), law, &ground);
        of_towers.extend(towers.lines::<pounding_solver::Bilinear>(OF_TOWERS)?);
    }
    STRUCTURES.write(root, &of_structures)?;
    TOWERS.write(root, &of_towers)
}

/// Time of a scene with this number of steps in the bare loop by hand with impacts, on this number of threads \[s\].
pub(super) fn seconds_by_hand(root: &Path, threads: usize, clock: Clock) -> Outcome<f64> {
    let ground = setting::ground(root, clock)?;
    let (groups, law) = (scenes::structures(), laws()?[0]);
    let run = || {
        for group in &groups {
            by_hand::<1, 1, 2>(group, law, Keeps::Nothing, &ground, clock.time_step);
        }
    };
    let times = in_turn(&[0], ROUNDS, |_| {
        std::thread::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(run);
            }
        });
        Ok(())
    })?;
    let scenes = groups.len() * GROUP * threads;
    Ok(median(times.concat()) / scenes as f64)
}

/// Scenes of a law with varying numbers; the loop by hand runs `IN_STEP` vectors in step.
struct Compared<'a, const L: usize, const R: usize, const IN_STEP: usize>(&'a [Group<L, R>], ContactLaw, &'a Ground);

fn by_hand<const L: usize, const R: usize, const IN_STEP: usize>(
    group: &Group<L, R>,
    law: ContactLaw,
    keeps: Keeps,
    ground: &[f64],
    dt: f64,
) -> by_hand::LoopNumbers {
    black_box(by_hand::run::<L, R, IN_STEP>(Level::new(), group, law, keeps, ground, dt))
}

impl<const L: usize, const R: usize, const IN_STEP: usize> Compared<'_, L, R, IN_STEP> {
    /// Times the scenes in all ways. Returns a line for each, with the error of central differences if the exact method runs storeys.
    fn lines<Column: Beside>(&self, ways: Ways) -> Outcome<Vec<String>> {
        let Self(groups, law, ground) = self;
        let rows = scenes::rows::<Column, L, R>(groups, *law)?;
        let rows: Vec<&Row<Column>> = rows.iter().collect();
        let methods = ground.methods()?;
        let together = SideBySide::new(STEPPING, methods[0].1, CLOCK)?;
        let steps = vec![CLOCK.n_steps; rows.len()];
        let mut sums = SceneSums::default();
        if !together.run(Column::rows(&rows), &steps, &mut sums) {
            return Err("scenes do not run side by side".into());
        }
        self.hold(&sums)?;
        let mut others = SceneSums::default();
        let order: Vec<usize> = (0..ways.len()).collect();
        let times = in_turn(&order, ROUNDS, |one| {
            let (_, way, scenes) = ways[one];
            let some = &rows[..scenes.min(rows.len())];
            match way {
                Way::ByHand(keeps) => groups.iter().for_each(|group| {
                    by_hand::<L, R, IN_STEP>(group, *law, keeps, &ground.sampled, CLOCK.time_step);
                }),
                Way::Lanes(at_once) => some.chunks(at_once).for_each(|rows| {
                    together.run(Column::rows(rows), &steps[..rows.len()], &mut others);
                    black_box(&others);
                }),
                Way::Alone(method) => some.iter().for_each(|row| {
                    black_box(alone(row, methods[method]).is_ok());
                }),
            }
            Ok(())
        })?;
        let error = if L > 1 { Some(error(&rows[..MEASURED], methods)?) } else { None };
        let touches = |scene: &usize| (0..R).any(|pair| sums.pair(*scene, pair).collisions > 0.0);
        let touch = (0..rows.len()).filter(touches).count() as f64 / rows.len() as f64;
        let share = sums.touching_steps as f64 / sums.steps as f64;
        let seconds = |one: usize| median(times[one].clone()) / ways[one].2.min(rows.len()) as f64;
        let law = law.name();
        let line = |(one, (name, way, _)): (usize, &(&str, Way, usize))| {
            let of_floor = 1e9 * seconds(one) / ((L + R) * CLOCK.n_steps) as f64;
            println!("{L} and {R} storeys, {law}, {name}: {of_floor:.3} ns per floor and step");
            let exact = matches!(way, Way::Alone(1));
            let error = error.map_or_else(String::new, |error| {
                let of_steps = if exact { String::new() } else { format!("{error:.1e}") };
                format!(",{of_steps}")
            });
            let ratio = seconds(0) / seconds(one);
            format!("{law},\"{name}\",{ratio:.5},{touch:.2},{share:.3}{error}")
        };
        Ok(ways.iter().enumerate().map(line).collect())
    }

    /// Compares peaks and impulses of lanes with those of the loop by hand.
    fn hold(&self, sums: &SceneSums) -> Outcome<()> {
        let Self(groups, law, ground) = self;
        let levels = Levels::new(&[L, R]);
        let nodes = [levels.of(0), levels.of(1)].concat();
        let mut largest: f64 = 0.0;
        for (index, group) in groups.iter().enumerate() {
            let found = by_hand::<L, R, IN_STEP>(group, *law, Keeps::Peaks, &ground.sampled, CLOCK.time_step);
            for scene in index * GROUP..(index + 1) * GROUP {
                let mut compare = |ours: f64, of: usize| {
                    let theirs = found[of][scene % GROUP];
                    let apart = (ours.abs() - theirs).abs() / theirs.max(f64::MIN_POSITIVE);
                    largest = largest.max(if apart.is_nan() { f64::INFINITY } else { apart });
                };
                for (floor, node) in nodes.iter().enumerate() {
                    compare(sums.displacement(scene, *node), floor);
                    if levels.place(*node).1 > 0 {
                        compare(sums.drift(scene, *node), L + R + floor);
                    }
                }
                for pair in 0..R {
                    compare(sums.pair(scene, pair).impulse, 2 * (L + R) + pair);
                }
            }
        }
        if largest > MOST_APART {
            return Err(format!("lanes and the loop by hand are {largest:.1e} apart").into());
        }
        Ok(())
    }
}

/// The median over scenes of the largest relative error of the peak displacements of a scene, of the first method relative to the second.
fn error<Column: Beside>(rows: &[&Row<Column>], methods: [setting::Way<'_>; 2]) -> Outcome<f64> {
    let mut errors = Vec::new();
    for row in rows {
        let [(found, _), (answer, _)] = [alone(row, methods[0])?, alone(row, methods[1])?];
        let of_floor = |node: usize| {
            let peak = |peaks: &Peaks| peaks.of(node).displacement.value.abs();
            (peak(&found) - peak(&answer)).abs() / peak(&answer)
        };
        errors.push((0..row.nodes().len()).map(of_floor).fold(0.0, f64::max));
    }
    Ok(median(errors))
}
