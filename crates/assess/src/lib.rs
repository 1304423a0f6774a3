//! A row of structures under many records: what pounding does to it, and which gap avoids it.
//!
//! A [`Suite`] is a folder of records, [`MotionLines`] are the runs of a scene under all of its motions, and an [`Assessment`] sums them
//! up. [`Effects`] and [`Separation`] answer the same two questions for a single motion.
//!
//! ```
//! use pounding_assess::{Rule, Separation};
//! use pounding_scene::{Scene, Simulation};
//!
//! let text = r#"
//!     name = "a tower beside a wall, shaken by half a sine of half the tower's period"
//!     record.generated.half_sine = { amplitude_m_per_s2 = -4.0, duration_s = 0.5, time_step_s = 0.001 }
//!     structures = [{ sdof = { name = "tower", mass_kg = 1e5, period_s = 1.0, damping.ratio = 0 } }, { wall = {} }]
//! "#;
//! let scene = Scene::parse(text.as_bytes(), "tower.toml".as_ref())?;
//! let gap = Separation::of(&Simulation::new(&scene, "")?)?[0];
//!
//! // u = A/(2ω²) (sin ωt − ωt cos ωt). The pulse ends at T/2, where the tower stands still: πA/(2ω²) = 1/(2π) m.
//! assert!((gap.required * std::f64::consts::TAU - 1.0).abs() < 1e-5);
//! // A wall does not move, so that rules ask for the peak of the tower.
//! assert_eq!(Rule::Srss.width(&gap), Rule::Abs.width(&gap));
//! # Ok::<(), pounding_scene::Error>(())
//! ```
//!
//! A run that fails does not end the others: its [`MotionLine`] holds the reason. A record that shakes nothing is [`LeftOut`] with a
//! reason.
//!
//! Left out: one run and its errors (`pounding-scene`), one scene over many values of its fields (`pounding-sweep`), pages and figures
//! (`pounding-report`).
//!
//! Where to start:
//!
//! - [`Suite::in_folder`]: the motions of a folder, their events, and what is left out.
//! - [`MotionLines::of`]: runs of a scene under all motions.
//! - [`AssessedRun::of`]: one motion and one direction; [`Assessment::of`] sums up many.
//! - [`Rule`]: widths of gaps by codes and literature; [`Scaling`]: how strong records are made.
//! - [`IntensityMeasure::of`]: how strong a motion is.
//! - [`Bumper::proposed`]: bumpers for the gaps that close, and [`BumperEffect`] for what they change.

mod alone;
mod assessment;
mod bumper;
mod bumper_effect;
mod design;
mod distribution;
mod effects;
mod intensity;
mod peaks;
mod raise;
mod rule;
mod run;
mod scaling;
mod separation;
mod suite;
mod target_fit;

pub use alone::Alone;
pub use assessment::{Assessment, FloorAssessment, GapAssessment, PairAssessment, RequiredGap, RuleAssessment, RunOfCase, StiffnessEffect};
pub use bumper::{Bumper, BumperPair, BumperRun};
pub use bumper_effect::{BumperCase, BumperEffect, BumperHarm, FloorBumperEffect, PairBumperEffect};
pub use design::{DesignSpectrum, Eurocode8Ground};
pub use distribution::{Case, Distribution, wilson, wilson_of};
pub use effects::{Effect, Effects, FloorEffects, FloorFact, Known};
pub use intensity::{AskedMeasure, IntensityMeasure};
pub use peaks::FloorPeaks;
pub use rule::{Rule, RuleWords};
pub use run::{AssessedFloor, AssessedPair, AssessedRun, StiffnessFactors, beyond_belief, says_believed};
pub use scaling::{MotionSpectrum, Scaling, SpectrumTarget, TargetFactors};
pub use separation::{JudgedSeparations, Separation};
pub use suite::{
    FolderUse, HorizontalPair, LeftOut, LeftOutKind, LeftOutReason, MotionLine, MotionLines, SelectionFactors, Suite, SuiteMotion, Watched,
    nothing_found,
};
pub use target_fit::TargetFit;
