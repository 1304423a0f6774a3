//! What everybody solves: random scenes that touch, and their exact answers.

use std::path::Path;

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName, Stereomechanical};
use pounding_lanes::{RowsOf, SceneSums, SideBySide};
use pounding_solver::{
    Bilinear, Clock, Collisions, Elastic, Exact, Excitation, Hysteretic, Integrator, Levels, Node,
    Pair, Peaks, Row, SimultaneousImpacts, Support,
};
use rand_pcg::Pcg64;
use serde_json::{Value, json};

use crate::lanes::{Law, STOREYS, towers};
use crate::setting::{self, DAMPING, GAPS, MASS, PERIODS, RESTITUTION, STIFFNESS};

/// Scenes whose errors are measured, and those that run in lanes: as many as a sweep hands over at once, of which the former are the first.
pub(super) const SCENES: usize = 8;
pub(super) const IN_LANES: usize = 256;
/// Time step of the record \[s\], and how long the scenes last \[s\].
const GROUND_STEP: f64 = 0.02;
pub(super) const DURATION: f64 = 10.0;
/// A scene whose least impact is a smaller part of its largest is left out: bounces that come to rest ask for a rule that packages lack.
const LEAST_IMPACT: f64 = 1e-3;

/// Peak displacements of both tops \[m\] and the sum of impulses \[N·s\] of a scene.
pub(super) type Found = [f64; 3];

/// Kinds of scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Two elastic structures with impacts.
    Impulsive,
    /// The same with the nonlinear viscoelastic element.
    Compliant,
    /// Two towers of bilinear storeys, with that element at every level that faces another.
    Towers,
}

impl Kind {
    /// Its name in tables, and in figures.
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

/// Scenes of one kind.
pub(super) struct Scenes<'a> {
    pub(super) kind: Kind,
    /// All rows; errors are measured on the first.
    pub(super) rows: Rows,
    /// The last node of either building.
    pub(super) tops: [usize; 2],
    pub(super) excitation: Excitation<'a>,
    /// Exact answers of the first.
    pub(super) answers: Vec<Found>,
}

/// Accelerations of the record at its own step \[m/s²\].
pub(super) fn ground(root: &Path) -> Result<Vec<f64>, String> {
    setting::ground(root, GROUND_STEP, clock(GROUND_STEP).n_steps)
}

/// The exact method at a tolerance.
pub(super) fn exact(tolerance: f64) -> Integrator {
    Integrator::Exact(Exact {
        tolerance,
        simultaneous_impacts: SimultaneousImpacts::Together,
    })
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
        n_steps: (DURATION / time_step).round() as usize,
    }
}

/// A run of a row, with the recorders that find what is compared.
pub(super) fn solved<Column: Hysteretic>(
    row: &Row<Column>,
    tops: [usize; 2],
    excitation: Excitation<'_>,
    (integrator, clock): (Integrator, Clock),
) -> Option<(Found, Collisions)> {
    let n = row.nodes().len();
    let mut recorder = (Peaks::new(n), Collisions::new(n, row.pairs()));
    integrator.run(row, excitation, clock, &mut recorder).ok()?;
    let (peaks, collisions) = recorder;
    let [left, right] = tops.map(|node| peaks.of(node).displacement.value.abs());
    let impulse = collisions.all().iter().map(|one| one.impulse).sum();
    Some(([left, right, impulse], collisions))
}

impl<'a> Scenes<'a> {
    /// The scenes of all kinds: those of structures are the same with both laws as far as they touch.
    pub(super) fn of_all_kinds(ground: &'a [f64]) -> Result<[Self; 3], String> {
        let asked = (RESTITUTION, Calibration::Exact);
        let compliant =
            LawName::NonlinearViscoelastic.calibrated(STIFFNESS, asked, &FreePair::UNIT);
        let compliant = compliant.map_err(|error| error.to_string())?;
        let impact = ContactLaw::Stereomechanical(Stereomechanical {
            restitution: RESTITUTION,
        });
        let excitation = Excitation::new(GROUND_STEP, ground).map_err(|error| error.to_string())?;
        Ok([
            Self::of_structures((Kind::Impulsive, impact), excitation)?,
            Self::of_structures((Kind::Compliant, compliant), excitation)?,
            Self::of_towers(compliant, excitation)?,
        ])
    }

    fn of_structures(
        (kind, law): (Kind, ContactLaw),
        excitation: Excitation<'a>,
    ) -> Result<Self, String> {
        let mut random = setting::random();
        let (mut rows, mut answers) = (Vec::new(), Vec::new());
        let tops = [0, 1];
        while rows.len() < IN_LANES {
            let row = drawn(law, &mut random)?;
            let (found, collisions) = answered(&row, tops, excitation)?;
            if !plain(&collisions) {
                continue;
            }
            rows.push(row);
            if answers.len() < SCENES {
                answers.push(found);
            }
        }
        Ok(Self {
            kind,
            rows: Rows::Structures(rows),
            tops,
            excitation,
            answers,
        })
    }

    /// Those of the loop by hand that touch.
    fn of_towers(mut element: ContactLaw, excitation: Excitation<'a>) -> Result<Self, String> {
        let words = |error: pounding_solver::ModelError| error.to_string();
        let levels = Levels::new(&STOREYS);
        let numbers: Vec<_> = element
            .parameters()
            .into_iter()
            .map(|(_, number)| *number)
            .collect();
        let law = Law::Viscoelastic(numbers[0], numbers[1]);
        let groups = towers::groups();
        let all = groups
            .iter()
            .flat_map(|group| towers::rows(group, &levels, law));
        let all = all.collect::<Result<Vec<_>, _>>().map_err(words)?;
        let clock = clock(setting::CLOCK.time_step);
        let together = SideBySide::new(setting::STEPPING, excitation, clock);
        let together = together.map_err(|error| error.to_string())?;
        let mut tallies = SceneSums::default();
        let n_steps = vec![clock.n_steps; all.len()];
        together.run(
            RowsOf::Bilinear(&all.iter().collect::<Vec<_>>()),
            &n_steps,
            &mut tallies,
        );
        let n_pairs = all[0].pairs().len();
        let touches =
            |scene: usize| (0..n_pairs).any(|pair| tallies.pair(scene, pair).collisions > 0.0);
        let rows = all
            .into_iter()
            .enumerate()
            .filter(|(scene, _)| touches(*scene));
        let rows: Vec<_> = rows.map(|(_, row)| row).take(IN_LANES).collect();
        let tops = [0, 1].map(|tower| levels.of(tower)[STOREYS[tower] - 1]);
        let answer = |row| match answered(row, tops, excitation)?.0 {
            [.., 0.0] => Err(String::from("towers touch in coarse steps alone")),
            found => Ok(found),
        };
        let answers = rows[..SCENES]
            .iter()
            .map(answer)
            .collect::<Result<_, _>>()?;
        Ok(Self {
            kind: Kind::Towers,
            rows: Rows::Towers(rows),
            tops,
            excitation,
            answers,
        })
    }

    /// Pairs of a row.
    pub(super) fn n_pairs(&self) -> usize {
        match &self.rows {
            Rows::Structures(rows) => rows[0].pairs().len(),
            Rows::Towers(rows) => rows[0].pairs().len(),
        }
    }

    /// The median over the scenes of the largest relative error of a scene; infinite where half of them have none.
    pub(super) fn error(&self, found: &[Found]) -> f64 {
        let of_scene = |(found, answer): (&Found, &Found)| {
            let errors = found.iter().zip(answer);
            let errors = errors.map(|(found, answer)| (found - answer).abs() / answer);
            // Not a number is an error, too.
            errors.fold(0.0, |worst: f64, error| {
                if error.is_finite() {
                    worst.max(error)
                } else {
                    f64::INFINITY
                }
            })
        };
        let errors: Vec<f64> = found.iter().zip(&self.answers).map(of_scene).collect();
        super::work::median(errors)
    }
}

/// The exact answer of a row.
fn answered<Column: Hysteretic>(
    row: &Row<Column>,
    tops: [usize; 2],
    excitation: Excitation<'_>,
) -> Result<(Found, Collisions), String> {
    let run = (exact(1e-16), clock(GROUND_STEP));
    solved(row, tops, excitation, run).ok_or_else(|| "the exact method fails in a scene".into())
}

/// Whether a scene touches, and no bounce dies away.
fn plain(collisions: &Collisions) -> bool {
    let impulses = || collisions.all().iter().map(|one| one.impulse);
    let largest = impulses().fold(0.0, f64::max);
    largest > 0.0 && impulses().all(|impulse| impulse > LEAST_IMPACT * largest)
}

fn drawn(law: ContactLaw, random: &mut Pcg64) -> Result<Row<Elastic>, String> {
    let mut between = |range: [f64; 2]| setting::between(random, range);
    let mut node = || {
        let omega = 2.0 * std::f64::consts::PI / between(PERIODS);
        let column = Elastic {
            stiffness: MASS * omega * omega,
        };
        Node::structure(MASS, 2.0 * DAMPING * MASS * omega, column)
    };
    let nodes = vec![node(), node()];
    let pair = Pair {
        left: 0,
        right: 1,
        gap: between(GAPS),
        law,
    };
    Row::new(nodes, vec![pair]).map_err(|error| error.to_string())
}

/// The scenes as the worker reads them.
pub(super) fn as_json(all: &[Scenes<'_>], ground: &[f64]) -> Value {
    let kinds: Vec<Value> = all.iter().map(kind_as_json).collect();
    json!({"duration": DURATION, "ground_step": GROUND_STEP, "ground": ground, "laws": kinds})
}

fn kind_as_json(scenes: &Scenes<'_>) -> Value {
    let (law, rows): (_, Vec<Value>) = match &scenes.rows {
        Rows::Structures(rows) => (
            rows[0].pairs()[0].law,
            rows[..SCENES].iter().map(structures_as_json).collect(),
        ),
        Rows::Towers(rows) => (
            rows[0].pairs()[0].law,
            rows[..SCENES].iter().map(towers_as_json).collect(),
        ),
    };
    let (kind, a, b) = if let ContactLaw::NonlinearViscoelastic(law) = law {
        (1, law.impact_stiffness, law.impact_damping_ratio)
    } else {
        (0, RESTITUTION, 0.0)
    };
    json!({"name": scenes.kind.names()[0], "kind": kind, "a": a, "b": b, "scenes": rows})
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
        row.pairs()[0].gap
    ])
}

/// Storeys of both towers from the ground up: mass, dampings against the floor below and against the ground, stiffness, yield force and
/// hardening; and the gap.
fn towers_as_json(row: &Row<Bilinear>) -> Value {
    let levels = Levels::new(&STOREYS);
    let storey = |node: &usize| {
        let node = &row.nodes()[*node];
        let column = &node.column;
        let ground_damping = match node.support {
            Support::Floor(floor) => floor.ground_damping,
            // Those of the lowest storey are one.
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
    json!({"towers": towers, "gap": row.pairs()[0].gap})
}

/// What one measurement gives.
#[derive(Debug, Clone)]
pub(super) struct Measured {
    /// CPU time of a scene \[s\].
    pub(super) seconds: f64,
    /// What was found in each.
    pub(super) found: Vec<Found>,
}
