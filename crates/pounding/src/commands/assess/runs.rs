//! The runs of an assessment: every motion in both directions, beside every neighbour, and once more with bumpers.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use pounding::assess::{Alone, AssessedRun, Bumper, BumperRun, MotionSpectrum, Scaling, Suite, SuiteMotion};
use pounding::report::{Animation, AssessedMotion};
use pounding::scene::file::DrawnNeighbour;
use pounding::scene::{Error, RecordUse, Scene, Simulation};
use pounding::text::Refused;

use super::super::suite;

/// The rows and settings of an assessment, the same for every motion.
pub(super) struct Asked<'a> {
    /// The scene of the file.
    pub(super) scene: Scene,
    /// The structures that are known.
    pub(super) known: Scene,
    /// The row beside each neighbour that it may have; one row if all are known.
    pub(super) rows: Vec<(Scene, Option<DrawnNeighbour>)>,
    pub(super) scaling: Scaling,
    /// Range of the stiffness of contact, as factors on that of the scene.
    pub(super) stiffness: [f64; 2],
    pub(super) records: &'a Suite,
}

/// The runs under a motion in one direction, row by row.
pub(super) struct RunsUnderMotion {
    runs: Vec<AssessedRun>,
    spectrum: Option<MotionSpectrum>,
    /// The record as it was used.
    record: RecordUse,
}

/// The data that both directions of a motion share.
struct Shared {
    spectrum: Option<MotionSpectrum>,
    record: RecordUse,
    /// The buildings alone, row by row; `None` if that run failed: each direction then reports its failure.
    alone: Vec<OnceLock<Option<Alone>>>,
}

impl Asked<'_> {
    /// Assesses every row under every motion.
    pub(super) fn run(&self) -> Result<suite::Ran<RunsUnderMotion>, Refused> {
        let [from, to] = self.stiffness;
        let shared = |motion: &SuiteMotion| {
            let (scene, spectrum) = self.scaling.applied(&self.known, motion)?;
            let shared = Shared {
                spectrum,
                record: scene.record.clone(),
                alone: self.rows.iter().map(|_| OnceLock::new()).collect(),
            };
            Ok((scene, shared))
        };
        let both = [false, true];
        let site = self.scaling.target().and_then(|target| target.spectrum.ground_acceleration());
        suite::lines_of(self.records, &both, shared, |prepared, shared| {
            let assessed = |(row, alone): (usize, &OnceLock<Option<Alone>>)| {
                let row = self.row(prepared, row)?;
                let alone = alone.get_or_init(|| Alone::of(&row).ok());
                Ok(AssessedRun::of(&row, alone.as_ref(), [from, 1.0, to])?.at_site(site))
            };
            let runs: Result<_, Error> = shared.alone.iter().enumerate().map(assessed).collect();
            Ok(RunsUnderMotion {
                runs: runs?,
                spectrum: shared.spectrum.clone(),
                record: shared.record.clone(),
            })
        })
    }

    fn row(&self, prepared: &Simulation, row: usize) -> Result<Simulation, Error> {
        match &self.rows[row] {
            (_, None) => Ok(prepared.clone()),
            (row, Some(_)) => prepared.under_row(row),
        }
    }

    /// Bumpers for the gaps that close: as stiff as given, or as the hardest of all rows asks for.
    pub(super) fn bumpers(&self, lines: &[suite::MotionLine<RunsUnderMotion>], stiffness: Option<f64>) -> Result<Vec<Bumper>, Error> {
        let mut stiffest: BTreeMap<usize, Bumper> = BTreeMap::new();
        for (index, (row, _)) in self.rows.iter().enumerate() {
            let found = lines.iter().filter_map(|line| line.found.as_ref().ok());
            let runs: Vec<&AssessedRun> = found.map(|found| &found.runs[index]).collect();
            for bumper in Bumper::proposed(row, &runs, stiffness)? {
                let so_far = stiffest.entry(bumper.contact).or_insert(bumper);
                so_far.stiffness = so_far.stiffness.max(bumper.stiffness);
            }
        }
        Ok(stiffest.into_values().collect())
    }

    /// Runs with bumpers, by motion, direction and row; runs that fail are left out. Runs in which nothing touches without bumpers are run,
    /// too: a bumper may be hit where the gap stays open.
    pub(super) fn with_bumpers(&self, lines: &[suite::MotionLine<RunsUnderMotion>], bumpers: &[Bumper]) -> Result<BumperRuns, Refused> {
        if bumpers.is_empty() {
            return Ok(BumperRuns::new());
        }
        let scene = |motion: &SuiteMotion| {
            let mut own = lines.iter().filter(|line| line.motion == motion.name);
            let record = own.find_map(|line| Some(line.found.as_ref().ok()?.record.clone()));
            let scene = Scene {
                record: record.unwrap_or_else(|| self.known.record.clone()),
                ..self.known.clone()
            };
            Ok((scene, ()))
        };
        let both = [false, true];
        let ran = suite::lines_of(self.records, &both, scene, |prepared, ()| {
            let rows = 0..self.rows.len();
            let run = |row: usize| BumperRun::of(&self.row(prepared, row).ok()?, bumpers).ok();
            Ok(rows.map(run).collect::<Vec<Option<BumperRun>>>())
        })?;
        let mut runs = BumperRuns::new();
        for line in ran.lines {
            for (row, run) in line.found.into_iter().flatten().enumerate() {
                if let Some(run) = run {
                    runs.insert((line.motion.clone(), line.reversed, row), run);
                }
            }
        }
        Ok(runs)
    }

    /// The hardest collision of all runs in motion; `None` if nothing touches, or if it cannot be shown.
    pub(super) fn animation(&self, lines: &[suite::MotionLine<RunsUnderMotion>]) -> Option<Animation> {
        let hardest = lines.iter().flat_map(|line| {
            let found = line.found.as_ref().ok();
            let runs = found.into_iter().flat_map(|found| found.runs.iter().enumerate());
            runs.flat_map(move |(row, run)| {
                let pairs = run.pairs.iter().filter(|pair| pair.collisions > 0);
                pairs.map(move |pair| (line, row, pair))
            })
        });
        let (line, row, _) = hardest.max_by(|(.., one), (.., other)| {
            let of = |value: Option<f64>| value.unwrap_or(0.0);
            let by_force = of(one.own_force).total_cmp(&of(other.own_force));
            by_force.then(of(one.approach_speed).total_cmp(&of(other.approach_speed)))
        })?;
        let mut motions = self.records.motions.iter();
        let motion = motions.find(|motion| motion.name == line.motion)?;
        let scene = Scene {
            record: line.found.as_ref().ok()?.record.clone(),
            ..self.known.clone()
        };
        let shaken = motion.shake(&scene, line.reversed, None).ok()?;
        Animation::of(&self.row(&shaken, row).ok()?).ok()?
    }

    /// Every run of every line that was finished.
    pub(super) fn motions(&self, lines: &[suite::MotionLine<RunsUnderMotion>], bumpers: &BumperRuns) -> Vec<AssessedMotion> {
        let of_line = |line: &suite::MotionLine<RunsUnderMotion>| {
            let found = line.found.as_ref().ok();
            let runs = found.into_iter().flat_map(|found| {
                let spectrum = &found.spectrum;
                let runs = found.runs.iter().enumerate();
                runs.map(move |(row, run)| (row, run.clone(), spectrum.clone()))
            });
            let motion = |(row, run, spectrum): (usize, AssessedRun, _)| AssessedMotion {
                name: line.motion.clone(),
                event: line.event,
                reversed: line.reversed,
                neighbour: self.rows[row].1,
                bumper: bumpers.get(&(line.motion.clone(), line.reversed, row)).cloned(),
                spectrum,
                run,
            };
            runs.map(motion).collect::<Vec<_>>()
        };
        lines.iter().flat_map(of_line).collect()
    }
}

/// Runs with bumpers, by motion, whether reversed, and row.
pub(super) type BumperRuns = BTreeMap<(String, bool, usize), BumperRun>;
