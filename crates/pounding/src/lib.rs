//! Earthquake-induced structural pounding: the crate to depend on, and the program `pounding`.
//!
//! | Module | Holds | Knows nothing of |
//! |---|---|---|
//! | [`motion`] | ground motions: formats, processing, measures, formulas | structures |
//! | [`contact`] | contact laws and the restitution each really delivers | time steps, rows |
//! | [`solver`] | structures, rows, methods of time integration, recorders | files, units other than SI |
//! | [`scene`] | scenes as TOML and JSON: read, checked, run, judged | sweeps, figures |
//! | [`sweep`] | one scene over many values | figures |
//! | [`plot`] | figures as data, drawn to SVG and PNG | mechanics |
//! | [`report`] | a run as a folder of tables and figures | sweeps |
//! | [`text`] | numbers as people read them, tables as CSV | units |
//!
//! Two structures 3 cm apart, and what happens when the ground jerks once:
//!
//! ```
//! use pounding::contact::{ContactLaw, Stereomechanical};
//! use pounding::motion::Record;
//! use pounding::solver::{
//!     Clock, Collisions, Damping, Elastic, Excitation, Integrator, Newmark, Node, Pair, Row,
//! };
//!
//! let structure = |mass: f64, stiffness: f64| {
//!     let damping = Damping::Ratio(0.05).coefficient(mass, stiffness);
//!     Node::structure(mass, damping, Elastic { stiffness })
//! };
//! let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.65 });
//! let row = Row::new(
//!     vec![structure(75e3, 2.056e6), structure(3e6, 1.316e9)],
//!     vec![Pair { left: 0, right: 1, gap: 0.03, law }],
//! )?;
//!
//! // −3 m/s² for 0.3 s: the ground goes to the left, so the structures lean to the right.
//! let record = Record::new(0.1, vec![-3.0, -3.0, -3.0, -3.0, 0.0], "a jerk")?;
//! let excitation = Excitation::new(record.time_step(), record.samples())?;
//!
//! let method = Integrator::Newmark(Newmark::AVERAGE_ACCELERATION);
//! let mut collisions = Collisions::new(row.nodes().len(), row.pairs());
//! method.run(&row, excitation, Clock { time_step: 0.005, n_steps: 400 }, &mut collisions)?;
//!
//! let first = collisions.all().first().expect("the gap is too narrow for this jerk");
//! assert!(first.start < 0.3, "the flexible structure reaches the stiff one while the ground accelerates");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Whoever has a scene as a file reads it with [`scene::Scene::read`] and runs it with [`scene::Simulation`].
//!
//! Left out: finding out who can touch whom (neighbours are named), and units other
//! than SI anywhere but in printed tables.

pub use pounding_contact as contact;
pub use pounding_motion as motion;
pub use pounding_plot as plot;
pub use pounding_report as report;
pub use pounding_scene as scene;
pub use pounding_solver as solver;
pub use pounding_sweep as sweep;
pub use pounding_text as text;
