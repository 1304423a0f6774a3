//! A state of a row: its fragility, its bounds, and how often it is reached.

use pounding_text::Refused;

use crate::bootstrap::Bootstrap;
use crate::fragility::{Fragility, FragilityFit};
use crate::hazard::{AnnualFrequency, HazardCurve};
use crate::stripe::Stripes;

/// The fragility of a state, and with a hazard curve its annual frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Risk {
    /// The stripes.
    pub stripes: Stripes,
    /// The fragility, or why the stripes determine none.
    pub fit: Result<FragilityFit, Refused>,
    /// Fragilities of events that were drawn again; `None` without a fragility.
    pub drawn: Option<Bootstrap>,
    /// How often motions of the site reach the state, or why that is not known; `None` without a hazard curve or a fragility.
    pub frequency: Option<Result<AnnualFrequency, Refused>>,
    /// How often motions reach the state by the shares as they are, joined by lines ([`HazardCurve::whole_of_shares`]); `None` as there, without a
    /// hazard curve, or if too much of it lies beyond the curve.
    pub of_shares: Option<AnnualFrequency>,
    /// 95 % bounds of the mean annual frequency \[1/year\], for the hazard curve as given; `None` as [`Self::bounds`].
    pub rate_bounds: Option<[f64; 2]>,
}

impl Risk {
    /// Sums up stripes.
    pub fn of(stripes: Stripes, hazard: Option<&HazardCurve>) -> Self {
        let fit = Fragility::of(&stripes);
        let drawn = fit.as_ref().ok().map(|_| Bootstrap::of(&stripes));
        let both = hazard.zip(fit.as_ref().ok());
        let frequency = both.map(|(hazard, fit)| hazard.annual(&fit.fragility));
        let of_shares = hazard.and_then(|hazard| hazard.whole_of_shares(&stripes, fit.as_ref().ok().map(|fit| &fit.fragility)));
        let is_known = matches!(frequency, Some(Ok(_)));
        let rate_bounds = hazard.filter(|_| is_known).and_then(|hazard| {
            let drawn = drawn.as_ref()?;
            drawn.bounds(|one| hazard.whole(one).rate)
        });
        Self {
            stripes,
            fit,
            drawn,
            frequency,
            of_shares: of_shares.filter(AnnualFrequency::is_within),
            rate_bounds,
        }
    }

    /// The fragility; `None` if the stripes determine none.
    pub fn fragility(&self) -> Option<&Fragility> {
        self.fit.as_ref().ok().map(|fit| &fit.fragility)
    }

    /// The annual frequency; `None` if it is not known.
    pub fn annual(&self) -> Option<&AnnualFrequency> {
        self.frequency.as_ref()?.as_ref().ok()
    }

    /// 95 % bounds of a number of the fragility; `None` without a fragility, or if too many draws have none.
    pub fn bounds(&self, number: impl Fn(&Fragility) -> f64) -> Option<[f64; 2]> {
        self.drawn.as_ref()?.bounds(number)
    }

    /// Why the fragility or the frequency is not known; `None` if both are, or are not asked for.
    pub fn refused(&self) -> Option<&Refused> {
        let of_frequency = self.frequency.as_ref().and_then(|one| one.as_ref().err());
        self.fit.as_ref().err().or(of_frequency)
    }
}
