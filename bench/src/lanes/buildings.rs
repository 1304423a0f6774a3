//! Two towers side by side with others like them, beside the same towers alone, the exact method, and the loop by hand.

use std::hint::black_box;
use std::path::Path;

use pounding_lanes::{RowsOf, SceneSums, SideBySide};
use pounding_solver::{Bilinear, Excitation, Integrator, Levels, ModelError, Peaks, Row};

use super::by_hand::{self, FLOORS, GROUP, LEVELS, Law, STOREYS, Towers};
use super::towers::{SCENES, groups, rows};
use super::{MOST_APART, NO_LOOP, apart, ground, keep, laws, medians, solved};
use crate::setting::{self, CLOCK, EXACT, RECORDED, STEPPING};

/// Where the ratios are kept, from the top folder.
const KEPT: &str = "results/bench/buildings.csv";
const HEADER: &str =
    "instructions,law,run,rate_ratio,scenes_that_touch,steps_in_which_a_lane_touches,error";
/// Those of the scenes that run one by one, and those by the exact method.
const ALONE: usize = 64;
const EXACTLY: usize = 16;

/// Runs towers of a law, whose numbers vary.
struct Scenes<'a> {
    law: Law,
    groups: &'a [Towers],
    levels: Levels,
    rows: Vec<Row<Bilinear>>,
    excitation: Excitation<'a>,
    /// The same motion at its own samples, which is all that the exact method needs.
    recorded: Excitation<'a>,
    ground: &'a [f64],
}

/// Times all and keeps the ratios.
pub(super) fn run(root: &Path, instructions: &str) -> Result<(), String> {
    let words = |error: ModelError| error.to_string();
    let ground = ground(root)?;
    let recorded = setting::ground(root, RECORDED, CLOCK.n_steps / 2)?;
    let groups = groups();
    let mut lines = Vec::new();
    println!("\nTwo towers of {STOREYS:?} bilinear storeys, ns per floor and step:");
    for law in laws()? {
        let levels = Levels::new(&STOREYS);
        let rows = groups.iter().flat_map(|group| rows(group, &levels, law));
        let scenes = Scenes {
            law,
            groups: &groups,
            rows: rows.collect::<Result<_, _>>().map_err(words)?,
            levels,
            excitation: Excitation::new(CLOCK.time_step, &ground).map_err(words)?,
            recorded: Excitation::new(RECORDED, &recorded).map_err(words)?,
            ground: &ground,
        };
        lines.extend(scenes.compare()?);
    }
    let csv = keep(&root.join(KEPT), HEADER, instructions, &lines)?;
    println!("Rates over those of the loop by hand:\n{csv}\nkept in {KEPT}");
    Ok(())
}

impl Scenes<'_> {
    /// Times the scenes by all routes; a line for each.
    fn compare(&self) -> Result<Vec<String>, String> {
        let together = SideBySide::new(STEPPING, self.excitation, CLOCK);
        let together = together.map_err(|error| error.to_string())?;
        let mut tallies = SceneSums::default();
        let rows: Vec<_> = self.rows.iter().collect();
        let n_steps = vec![CLOCK.n_steps; rows.len()];
        if !together.run(RowsOf::Bilinear(&rows), &n_steps, &mut tallies) {
            return Err("the towers do not run side by side".into());
        }
        let distance = self.distance(&tallies)?;
        if distance > MOST_APART {
            return Err(format!(
                "lanes and the loop by hand are {distance:.1e} apart in towers"
            ));
        }
        let methods = [
            Integrator::CentralDifference(STEPPING),
            Integrator::Exact(EXACT),
        ];
        let error = self.error(methods)?;
        let mut hand = || {
            for group in self.groups {
                let dt = CLOCK.time_step;
                black_box(by_hand::run_towers(group, self.law, self.ground, dt));
            }
        };
        let mut lanes = || {
            together.run(RowsOf::Bilinear(&rows), &n_steps, &mut tallies);
            black_box(&tallies);
        };
        let mut of_one = SceneSums::default();
        let mut one_by_one = || {
            for row in &rows[..ALONE] {
                together.run(RowsOf::Bilinear(&[*row]), &n_steps[..1], &mut of_one);
                black_box(&of_one);
            }
        };
        let alone = |method, excitation, scenes| {
            for row in &self.rows[..scenes] {
                black_box(solved(row, method, excitation).is_ok());
            }
        };
        let times = medians(&mut [
            ("by hand", &mut hand),
            ("lanes", &mut lanes),
            ("lanes, one scene each", &mut one_by_one),
            ("alone", &mut || alone(methods[0], self.excitation, ALONE)),
            ("exact, alone", &mut || {
                alone(methods[1], self.recorded, EXACTLY);
            }),
        ]);
        Ok(self.lines(&times, error, &tallies))
    }

    /// Lines of the table, from times of all routes \[s\] and the error of central differences.
    fn lines(&self, times: &[(&str, f64)], error: f64, tallies: &SceneSums) -> Vec<String> {
        let touches =
            |scene: &usize| (0..LEVELS).any(|pair| tallies.pair(*scene, pair).collisions > 0.0);
        let touch = (0..SCENES).filter(touches).count() as f64 / SCENES as f64;
        let share = tallies.touching_steps as f64 / tallies.steps as f64;
        let law = self.rows[0].pairs()[0].law.name();
        let by_hand = times[0].1 / SCENES as f64;
        let line = |((name, time), scenes): (&(&str, f64), usize)| {
            let of_scene = time / scenes as f64;
            let of_floor = 1e9 * of_scene / (FLOORS * CLOCK.n_steps) as f64;
            println!("{law}, {name}: {of_floor:.3}");
            let is_exact = name.contains("exact");
            let error = (!is_exact).then(|| format!("{error:.1e}"));
            format!(
                "{law},\"{name}\",{:.5},{touch:.2},{share:.3},{}",
                by_hand / of_scene,
                error.unwrap_or_default()
            )
        };
        let scenes = [SCENES, SCENES, ALONE, ALONE, EXACTLY];
        times.iter().zip(scenes).map(line).collect()
    }

    /// How far peaks and impulses of both are apart, relative to them.
    fn distance(&self, tallies: &SceneSums) -> Result<f64, String> {
        let mut largest: f64 = 0.0;
        for (index, group) in self.groups.iter().enumerate() {
            let found = by_hand::run_towers(group, self.law, self.ground, CLOCK.time_step);
            let found = found.ok_or(NO_LOOP)?;
            for lane in 0..GROUP {
                let scene = index * GROUP + lane;
                let mut compare = |ours, theirs| largest = largest.max(apart(ours, theirs));
                for node in 0..FLOORS {
                    let (tower, storey) = self.levels.place(node);
                    let floor = tower * STOREYS[0] + storey;
                    compare(
                        tallies.displacement(scene, node),
                        found.displacements[floor][lane],
                    );
                    if storey > 0 {
                        compare(tallies.drift(scene, node), found.drifts[floor][lane]);
                    }
                }
                for (pair, impulses) in found.impulses.iter().enumerate() {
                    compare(tallies.pair(scene, pair).impulse, impulses[lane]);
                }
            }
        }
        Ok(largest)
    }

    /// The median over scenes of the largest relative error of the peak displacements of a scene, of the first method.
    fn error(&self, [stepping, exact]: [Integrator; 2]) -> Result<f64, String> {
        let mut errors = Vec::new();
        for row in &self.rows[..EXACTLY] {
            let found = solved(row, stepping, self.excitation)?;
            let answer = solved(row, exact, self.recorded)?;
            let of_floor = |node: usize| {
                let peak = |peaks: &Peaks| peaks.of(node).displacement.value.abs();
                (peak(&found) - peak(&answer)).abs() / peak(&answer)
            };
            errors.push((0..FLOORS).map(of_floor).fold(0.0, f64::max));
        }
        errors.sort_by(f64::total_cmp);
        Ok(errors[errors.len() / 2])
    }
}
