//! Random scenes with contact, and their exact answers.

use std::error::Error;
use std::path::Path;

use pounding_contact::ContactLaw;
use pounding_lanes::{SceneSums, SideBySide};
use pounding_solver::{Bilinear, Clock, Collisions, Elastic, Excitation, Hysteretic, Integrator, Levels, Peaks, Row, Support};
use serde_json::{Value, json};

use crate::measure::{Outcome, median};
use crate::scenes::{Beside, LEFT, RIGHT, laws, numbers, rows, structures, towers};
use crate::setting::{self, CLOCK, STEPPING, exact, recorded};

/// Number of scenes with measured errors, and of scenes in lanes (as many as a sweep passes at once). The former are the first of the
/// latter.
pub(super) const SCENES: usize = 8;
pub(super) const IN_LANES: usize = 256;
/// Least ratio of the smallest to the largest impact. Scenes below are left out: bounces that come to rest need a rule that packages lack.
const LEAST_IMPACT: f64 = 1e-3;

/// The tolerance of answers, and the tops of two structures of one storey.
const ANSWER: f64 = 1e-16;
const STRUCTURES: [usize; 2] = [0, 1];

/// Peak displacements of both tops \[m\] and the sum of impulses \[N·s\] of a scene.
pub(super) type Answers = [f64; 3];

/// Kinds of scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SceneKind {
    /// Two elastic structures with impacts.
    Impulsive,
    /// Two elastic structures with the nonlinear viscoelastic element.
    Compliant,
    /// Two towers of bilinear storeys, with the nonlinear viscoelastic element at every common level.
    Towers,
}

impl SceneKind {
    /// Name in tables, and in figures.
    pub(super) const fn names(self) -> [&'static str; 2] {
        match self {
            Self::Impulsive => ["stereomechanical", "Impacts, e = 0.65"],
            Self::Compliant => ["nonlinear_viscoelastic", "Nonlinear viscoelastic element"],
            Self::Towers => ["towers", "Towers, same element"],
        }
    }
}

/// Rows of scenes, by their columns.
pub(super) enum Rows {
    Structures(Vec<Row<Elastic>>),
    Towers(Vec<Row<Bilinear>>),
}

/// Scenes of a kind.
pub(super) struct Scenes<'a> {
    pub(super) kind: SceneKind,
    law: ContactLaw,
    /// All rows; errors are measured on the first ones.
    pub(super) rows: Rows,
    /// The nodes of the tops of both buildings.
    pub(super) tops: [usize; 2],
    pub(super) n_pairs: usize,
    pub(super) excitation: Excitation<'a>,
    /// Exact answers of the first scenes.
    answers: Vec<Answers>,
}

/// The clock of a time step \[s\].
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "time steps of the ladder: some millions of steps at most"
)]
pub(super) fn clock(time_step: f64) -> Clock {
    Clock {
        time_step,
        n_steps: (CLOCK.time_step * CLOCK.n_steps as f64 / time_step).round() as usize,
    }
}

/// The numbers to compare, from the exact method at a tolerance, and the collisions; `None` if it fails.
pub(super) fn solved<Column: Hysteretic>(
    row: &Row<Column>,
    tops: [usize; 2],
    excitation: Excitation<'_>,
    tolerance: f64,
) -> Option<(Answers, Collisions)> {
    let n = row.nodes().len();
    let mut recorder = (Peaks::new(n), Collisions::new(n, row.pairs()));
    let integrator = Integrator::Exact(exact(tolerance));
    let ran = integrator.run(row, excitation, recorded(), &mut recorder);
    let (peaks, collisions) = recorder;
    let [left, right] = tops.map(|node| peaks.of(node).displacement.value.abs());
    let impulse = collisions.all().iter().map(|one| one.impulse).sum();
    ran.ok().map(|_| ([left, right, impulse], collisions))
}

/// Accelerations of the record at its step \[m/s²\].
pub(super) fn ground(root: &Path) -> Outcome<Vec<f64>> {
    setting::ground(root, recorded())
}

impl<'a> Scenes<'a> {
    /// The scenes of all kinds. Those of structures are equal for both laws, among the scenes with contact.
    pub(super) fn of_all_kinds(ground: &'a [f64]) -> Outcome<[Self; 3]> {
        let excitation = Excitation::new(setting::RECORDED, ground)?;
        let [impacts, element] = laws()?;
        let of_structures = |kind, law| {
            let (rows, answers) = plain(&rows(&structures(), law)?, excitation)?;
            Ok::<_, Box<dyn Error>>(Self {
                kind,
                law,
                rows: Rows::Structures(rows),
                tops: STRUCTURES,
                n_pairs: 1,
                excitation,
                answers,
            })
        };
        let levels = Levels::new(&[LEFT, RIGHT]);
        let tops = [levels.of(0)[LEFT - 1], levels.of(1)[RIGHT - 1]];
        let rows = touching(rows(&towers(), element)?, excitation)?;
        let answer = |row| match solved(row, tops, excitation, ANSWER) {
            None | Some(([.., 0.0], _)) => Err("towers that touch in coarse steps alone, or fail"),
            Some((found, _)) => Ok(found),
        };
        Ok([
            of_structures(SceneKind::Impulsive, impacts)?,
            of_structures(SceneKind::Compliant, element)?,
            Self {
                kind: SceneKind::Towers,
                law: element,
                answers: rows[..SCENES].iter().map(answer).collect::<Result<_, _>>()?,
                rows: Rows::Towers(rows),
                tops,
                n_pairs: RIGHT,
                excitation,
            },
        ])
    }

    /// The median over the scenes of the largest relative error of a scene; infinite if half of them have none.
    pub(super) fn error(&self, found: &[Answers]) -> f64 {
        let of_scene = |(found, answer): (&Answers, &Answers)| {
            let errors = found.iter().zip(answer);
            let errors = errors.map(|(found, answer)| (found - answer).abs() / answer);
            // NaN counts as an error, too.
            errors.fold(
                0.0,
                |worst: f64, error| {
                    if error.is_finite() { worst.max(error) } else { f64::INFINITY }
                },
            )
        };
        median(found.iter().zip(&self.answers).map(of_scene))
    }
}

/// Structures that touch, without decaying bounces, with the answers of the first.
fn plain(all: &[Row<Elastic>], excitation: Excitation<'_>) -> Outcome<(Vec<Row<Elastic>>, Vec<Answers>)> {
    let (mut rows, mut answers) = (Vec::new(), Vec::new());
    for row in all {
        let solved = solved(row, STRUCTURES, excitation, ANSWER);
        let (found, collisions) = solved.ok_or("the exact method fails in a scene")?;
        let impulses = || collisions.all().iter().map(|one| one.impulse);
        let largest = impulses().fold(0.0, f64::max);
        if largest > 0.0 && impulses().all(|impulse| impulse > LEAST_IMPACT * largest) {
            rows.push(row.clone());
            answers.push(found);
        }
        if rows.len() == IN_LANES {
            break;
        }
    }
    answers.truncate(SCENES);
    Ok((rows, answers))
}

/// Towers that touch in steps of the loop by hand.
fn touching(all: Vec<Row<Bilinear>>, excitation: Excitation<'_>) -> Outcome<Vec<Row<Bilinear>>> {
    let mut sums = SceneSums::default();
    let together = SideBySide::new(STEPPING, excitation, CLOCK)?;
    let rows: Vec<_> = all.iter().collect();
    together.run(Bilinear::rows(&rows), &vec![CLOCK.n_steps; rows.len()], &mut sums);
    let touches = |scene: usize| (0..RIGHT).any(|pair| sums.pair(scene, pair).collisions > 0.0);
    let rows = all.into_iter().enumerate();
    let rows = rows.filter(|(scene, _)| touches(*scene));
    Ok(rows.map(|(_, row)| row).take(IN_LANES).collect())
}

/// The scenes in the format of the worker.
pub(super) fn as_json(all: &[Scenes<'_>], ground: &[f64]) -> Value {
    let kind = |scenes: &Scenes<'_>| {
        let rows: Vec<Value> = match &scenes.rows {
            Rows::Structures(rows) => rows[..SCENES].iter().map(structures_as_json).collect(),
            Rows::Towers(rows) => rows[..SCENES].iter().map(towers_as_json).collect(),
        };
        let (impulsive, [a, b]) = numbers(scenes.law);
        let (name, kind) = (scenes.kind.names()[0], u8::from(!impulsive));
        json!({"name": name, "kind": kind, "a": a, "b": b, "scenes": rows})
    };
    let duration = CLOCK.time_step * CLOCK.n_steps as f64;
    let laws: Vec<Value> = all.iter().map(kind).collect();
    json!({"duration": duration, "ground_step": setting::RECORDED, "ground": ground, "laws": laws})
}

fn structures_as_json(row: &Row<Elastic>) -> Value {
    let [left, right] = [&row.nodes()[0], &row.nodes()[1]];
    json!([
        1.0 / left.inverse_mass,
        1.0 / right.inverse_mass,
        left.column.stiffness,
        right.column.stiffness,
        left.damping,
        right.damping,
        row.pairs()[0].gap()
    ])
}

/// Storeys of both towers from the ground up (mass, dampings against the floor below and against the ground, stiffness, yield force and
/// hardening), and the gap.
fn towers_as_json(row: &Row<Bilinear>) -> Value {
    let levels = Levels::new(&[LEFT, RIGHT]);
    let storey = |node: &usize| {
        let node = &row.nodes()[*node];
        let column = &node.column;
        let ground_damping = match node.support {
            Support::Floor(floor) => floor.ground_damping,
            // The lowest storey has a single damping.
            Support::Ground => 0.0,
        };
        json!([
            1.0 / node.inverse_mass,
            node.damping,
            ground_damping,
            column.stiffness,
            column.yield_force,
            column.hardening
        ])
    };
    let towers = [0, 1].map(|tower| levels.of(tower).iter().map(storey).collect::<Vec<_>>());
    json!({"towers": towers, "gap": row.pairs()[0].gap()})
}

/// Result of a measurement.
#[derive(Debug, Clone)]
pub(super) struct Measured {
    /// CPU time of a scene \[s\].
    pub(super) seconds: f64,
    /// Results of each scene.
    pub(super) found: Vec<Answers>,
}
