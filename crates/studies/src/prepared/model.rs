//! What the solver needs of a scene: the leanest row that models it, integrator and clock.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    CentralDifference, Clock, Elastic, ElastoPlastic, Exact, Hht, Hysteretic, Integrator,
    ModelError, MoreauJean, Newmark, Node, Pair, Rk4, Row, Verlet,
};

use crate::{Contact, Method, Scene, Structure};

/// The row with the columns it needs: decided once per run.
#[derive(Debug, Clone)]
pub(super) enum Model {
    Elastic(Row<Elastic>),
    /// Elastic structures among yielding ones get an infinite yield force.
    ElastoPlastic(Row<ElastoPlastic>),
}

/// Gap of neighbours that a scene lets stand apart, where all pairs are modelled \[m\].
const OUT_OF_REACH: f64 = 1e9;

impl Model {
    /// The leanest row of a checked scene.
    pub(super) fn new(scene: &Scene) -> Result<Self, ModelError> {
        let yields = scene.structures.iter().any(|structure| match structure {
            Structure::Sdof(structure) => structure.yield_force_n.is_some(),
            Structure::Wall => false,
        });
        let contacts = scene.contacts.as_deref().unwrap_or_default();
        if yields {
            row(scene, elasto_plastic, pairs(contacts)).map(Self::ElastoPlastic)
        } else {
            let elastic = |stiffness, _| Elastic { stiffness };
            row(scene, elastic, pairs(contacts)).map(Self::Elastic)
        }
    }

    /// The same with everything that a scene can ask for: columns that remember their yielding, and all neighbours as
    /// pairs.
    pub(super) fn full(scene: &Scene) -> Result<Self, ModelError> {
        let pairs = match &scene.contacts {
            Some(contacts) => pairs(contacts),
            None => pairs_out_of_reach(&scene.structures),
        };
        row(scene, elasto_plastic, pairs).map(Self::ElastoPlastic)
    }

    /// The pairs that can touch, from left to right.
    pub(super) fn pairs(&self) -> &[Pair] {
        match self {
            Self::Elastic(row) => row.pairs(),
            Self::ElastoPlastic(row) => row.pairs(),
        }
    }
}

fn elasto_plastic(stiffness: f64, yield_force: Option<f64>) -> ElastoPlastic {
    ElastoPlastic {
        stiffness,
        yield_force: yield_force.unwrap_or(f64::INFINITY),
    }
}

fn pairs(contacts: &[Contact]) -> Vec<Pair> {
    let pair = |(left, contact): (usize, &Contact)| Pair {
        left,
        right: left + 1,
        gap: contact.gap_m,
        law: contact.law,
    };
    contacts.iter().enumerate().map(pair).collect()
}

fn pairs_out_of_reach(structures: &[Structure]) -> Vec<Pair> {
    let pair = |(left, pair): (usize, &[Structure])| {
        let walls = matches!(pair, [Structure::Wall, Structure::Wall]);
        (!walls).then_some(Pair {
            left,
            right: left + 1,
            gap: OUT_OF_REACH,
            law: ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.0 }),
        })
    };
    structures.windows(2).enumerate().filter_map(pair).collect()
}

fn row<Column: Hysteretic>(
    scene: &Scene,
    column: impl Fn(f64, Option<f64>) -> Column,
    pairs: Vec<Pair>,
) -> Result<Row<Column>, ModelError> {
    let node = |structure: &Structure| match structure {
        Structure::Sdof(sdof) => Node {
            initial_displacement: sdof.initial_displacement_m,
            initial_velocity: sdof.initial_velocity_m_per_s,
            ..Node::structure(
                sdof.mass_kg,
                sdof.damping_coefficient(),
                column(sdof.stiffness_n_per_m, sdof.yield_force_n),
            )
        },
        Structure::Wall => Node::wall(column(1.0, None)),
    };
    Row::new(scene.structures.iter().map(node).collect(), pairs)
}

impl Method {
    /// The method without its time step.
    pub(crate) fn integrator(self) -> Integrator {
        match self {
            Self::CentralDifference {
                start,
                impacts,
                contact_substeps,
                ..
            } => Integrator::CentralDifference(CentralDifference {
                start,
                impacts,
                contact_substeps,
            }),
            Self::Newmark { beta, gamma, .. } => Integrator::Newmark(Newmark { beta, gamma }),
            Self::Hht { alpha, .. } => Integrator::Hht(Hht { alpha }),
            Self::VelocityVerlet { impacts, .. } => Integrator::Verlet(Verlet { impacts }),
            Self::Rk4 { .. } => Integrator::Rk4(Rk4),
            Self::MoreauJean { theta, .. } => Integrator::MoreauJean(MoreauJean { theta }),
            Self::Exact {
                tolerance,
                simultaneous_impacts,
            } => Integrator::Exact(Exact {
                tolerance,
                simultaneous_impacts,
            }),
            Self::Accuracy(_) => unreachable!("the method for an accuracy is found before"),
        }
    }

    /// The time steps of a run of some duration \[s\]; one for the exact method, which asks for the end only.
    pub(crate) fn clock(self, duration: f64) -> Clock {
        let time_step = self.time_step().unwrap_or(duration);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "checked: 0 < n <= 1e8"
        )]
        let n_steps = (duration / time_step).round() as usize;
        Clock { time_step, n_steps }
    }
}
