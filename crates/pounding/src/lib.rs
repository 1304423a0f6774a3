//! Earthquake-induced structural pounding: the crate to depend on, and the program `pounding`.
//!
//! Two towers 30 mm apart in one pulse, from the words of a scene to the impulse of the first collision:
//!
//! ```
//! use pounding::{contact::reduced_mass, scene::Scene, scene::Simulation};
//!
//! let text = r#"
//!     name = "two towers"
//!     record.generated.ricker = { amplitude_m_per_s2 = 3.0, frequency_hz = 1.0, time_step_s = 0.01 }
//!     contacts = [{ gap_m = 0.03, law.stereomechanical.restitution = 0.65 }]
//!     structures = [
//!         { sdof = { name = "weak", mass_kg = 75e3, stiffness_n_per_m = 2.056e6, damping.ratio = 0.05 } },
//!         { sdof = { name = "stiff", mass_kg = 3e6, stiffness_n_per_m = 1.316e9, damping.ratio = 0.05 } },
//!     ]"#;
//! let run = Simulation::new(&Scene::parse(text.as_bytes(), "towers.toml".as_ref())?, "")?.run(None)?;
//! let first = run.of_pair(0).first.expect("the gap is too narrow for this pulse");
//! // Momentum: towers that meet with v₀ pass on (1+e) m v₀, m = 73 171 kg the reduced mass.
//! let impulse = 1.65 * reduced_mass(1.0 / 75e3, 1.0 / 3e6) * first.approach_speed.expect("the exact method knows it");
//! assert!((first.impulse / impulse - 1.0).abs() < 1e-12);
//! # Ok::<(), pounding::scene::Error>(())
//! ```
//!
//! | Module | Holds | Does not know |
//! |---|---|---|
//! | [`motion`] | ground motions: formats, processing, measures, formulas | structures |
//! | [`contact`] | contact laws and the restitution each really delivers | time steps, rows |
//! | [`solver`] | structures, rows, methods of time integration, recorders | files, units other than SI |
//! | [`scene`] | scenes as TOML and JSON: read, checked, run, judged | folders of records, sweeps, figures |
//! | [`assess`] | a row under many records: effects of pounding, required gaps | sweeps, figures |
//! | [`sweep`] | one scene over many values | figures |
//! | [`risk`] | fragilities and annual frequencies | structures, records |
//! | [`plot`] | figures as data, drawn to SVG and PNG | mechanics |
//! | [`report`] | a run or an assessment as an answer and as a folder | sweeps |
//! | [`files`] | files written whole and durably, read within bounds, locked | what they hold |
//! | [`text`] | numbers, tables, answers and refusals for people and programs | structures, contact |
//!
//! Left out: finding out who can touch whom (it is named), and units other than SI anywhere but in printed tables. The numbers of
//! the paper and the check by a second route are crates of the workspace, `pounding-studies` and `pounding-reference`.
//!
//! Where to start:
//!
//! - [`scene::Scene`] and [`scene::Simulation`], for a scene as a file: [`scene::Simulation::review`] adds errors and warnings.
//! - [`solver::Row`] and [`solver::Integrator`], for a model made in code.
//! - `examples/` beside the source: a row from numbers, a record of your own, a sweep.
//! - [`report::Report`] for a folder of results, [`sweep::Sweep`] for thousands of runs.

pub use pounding_assess as assess;
pub use pounding_contact as contact;
pub use pounding_files as files;
pub use pounding_motion as motion;
pub use pounding_plot as plot;
pub use pounding_report as report;
pub use pounding_risk as risk;
pub use pounding_scene as scene;
pub use pounding_solver as solver;
pub use pounding_sweep as sweep;
pub use pounding_text as text;
