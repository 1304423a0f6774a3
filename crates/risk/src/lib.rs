//! How often a state is reached at a site: from shares of motions at each intensity to a fragility, and to an annual frequency.
//!
//! ```
//! use pounding_risk::{EventShare, Fragility, HazardCurve, Stripe, Stripes};
//!
//! // Of 40 motions at each intensity so many touch.
//! let stripe = |(intensity, touching): (f64, usize)| Stripe {
//!     intensity,
//!     events: (0..40).map(|event| EventShare { event, share: f64::from(u8::from(event < touching)) }).collect(),
//! };
//! let all = [(0.2, 3), (0.3, 9), (0.5, 24), (0.8, 36)].map(stripe).to_vec();
//! let fit = Fragility::of(&Stripes { all, same_events: true })?;
//! let Fragility { median, dispersion } = fit.fragility;
//!
//! // A hazard of 2e-4 per year at 1 g that falls with the power 2.3: λ = k₀ θ^−k exp(k² β²/2) by C. A. Cornell.
//! let hazard = HazardCurve::of([0.001, 1.0, 50.0].map(|x: f64| [x, 2e-4 * x.powf(-2.3)]).to_vec())?;
//! let closed = 2e-4 * median.powf(-2.3) * (0.5 * (2.3 * dispersion).powi(2)).exp();
//! assert!((hazard.annual(&fit.fragility)?.rate / closed - 1.0).abs() < 1e-12);
//! # Ok::<(), pounding_text::Refused>(())
//! ```
//!
//! This crate knows neither structures nor records: `pounding-sweep` runs motions at each intensity, `pounding-report` prints the answer.
//!
//! Where to start: [`Risk::of`], with [`Fragility::of`], [`Bootstrap::of`] for its bounds, and [`HazardCurve::annual`]; [`StripeRuns`] for the runs.

mod bootstrap;
mod fragility;
mod hazard;
mod normal;
mod risk;
mod runs;
mod state;
mod stripe;

pub use bootstrap::Bootstrap;
pub use fragility::{Fragility, FragilityFit};
pub use hazard::{AnnualFrequency, Contribution, HazardCurve};
pub use risk::Risk;
pub use runs::{Reached, StripeMotion, StripeRun, StripeRuns};
pub use state::{RunNumbers, State};
pub use stripe::{EventShare, Stripe, Stripes};
