//! What the solver needs of a scene: the leanest row that models it, integrator and clock.

use pounding_solver::{
    CentralDifference, Clock, Elastic, ElastoPlastic, Exact, Hht, Integrator, ModelError,
    MoreauJean, Newmark, Node, Pair, PiecewiseLinear, Rk4, Row, Verlet,
};

use crate::{Method, Scene, Structure};

/// The row with the columns it needs: decided once per run.
#[derive(Debug, Clone)]
pub(super) enum Model {
    Elastic(Row<Elastic>),
    /// Elastic structures among yielding ones get an infinite yield force.
    ElastoPlastic(Row<ElastoPlastic>),
}

impl Model {
    /// The row of a checked scene.
    pub(super) fn new(scene: &Scene) -> Result<Self, ModelError> {
        let yields = scene.structures.iter().any(|structure| match structure {
            Structure::Sdof(structure) => structure.yield_force_n.is_some(),
            Structure::Wall => false,
        });
        if yields {
            let column = |stiffness, yield_force: Option<f64>| ElastoPlastic {
                stiffness,
                yield_force: yield_force.unwrap_or(f64::INFINITY),
            };
            row(scene, column).map(Self::ElastoPlastic)
        } else {
            row(scene, |stiffness, _| Elastic { stiffness }).map(Self::Elastic)
        }
    }

    /// The pairs that can touch, from left to right.
    pub(super) fn pairs(&self) -> &[Pair] {
        match self {
            Self::Elastic(row) => row.pairs(),
            Self::ElastoPlastic(row) => row.pairs(),
        }
    }
}

fn row<Column: PiecewiseLinear>(
    scene: &Scene,
    column: impl Fn(f64, Option<f64>) -> Column,
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
    let contacts = scene.contacts.as_deref().unwrap_or_default();
    let pair = |(left, contact): (usize, &crate::Contact)| Pair {
        left,
        right: left + 1,
        gap: contact.gap_m,
        law: contact.law,
    };
    Row::new(
        scene.structures.iter().map(node).collect(),
        contacts.iter().enumerate().map(pair).collect(),
    )
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
