//! Intensity of the motions of a suite, by which stripes scale them and hazard curves count them.

use std::fmt;
use std::str::FromStr;

use pounding_scene::{Error, Scene, Structure, pair_spectra, periods_between};
use pounding_text::{Refused, digits};

use crate::scaling::{DAMPING, PLACE, accelerations, unscaled};
use crate::suite::SuiteMotion;

/// A number that says how strong a motion is. Two horizontal components of one recording have one intensity, `RotD50`, the median over all
/// directions. Any other motion has its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IntensityMeasure {
    /// Pseudo-spectral acceleration at this period \[s\], 5 % of damping.
    Sa(f64),
    /// Peak ground acceleration.
    Pga,
    /// Geometric mean of [`Self::Sa`] at periods between two \[s\], in equal ratios.
    SaAverage([f64; 2]),
}

/// Number of periods of a mean.
const PERIODS: u32 = 20;

impl IntensityMeasure {
    /// Returns the intensity of a motion as recorded, with the processing of the scene but without its scale \[g\].
    ///
    /// # Errors
    /// Refuses a motion that the scene cannot use, one at rest, and one whose spectrum cannot be computed.
    pub fn of(self, motion: &SuiteMotion, scene: &Scene) -> Result<f64, Error> {
        let record = unscaled(&scene.record);
        let periods = match self {
            Self::Sa(period) => vec![period],
            Self::Pga => vec![0.0],
            Self::SaAverage([from, to]) => periods_between(from, to, PERIODS),
        };
        let refused = |refused: Refused| Error::in_scene(&scene.name, refused.in_field(PLACE));
        let found = if let Some([one, other]) = motion.both_components(&record, &scene.name)? {
            let found = pair_spectra([&one, &other], &periods, &[DAMPING], None, &|| ()).map_err(refused)?;
            found[0].values.iter().map(|one| one.rotd50).collect()
        } else {
            let (_, ground) = motion.used_as(&record, &scene.name)?;
            accelerations(&ground.record, &periods, scene)?
        };
        let logs: f64 = found.iter().map(|one| libm::log(*one)).sum();
        let mean = libm::exp(logs / found.len() as f64) / record.gravity_m_per_s2;
        if mean > 0.0 && mean.is_finite() {
            Ok(mean)
        } else {
            Err(refused(pounding_motion::at_rest()))
        }
    }
}

impl fmt::Display for IntensityMeasure {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sa(period) => write!(to, "Sa({} s)", digits(*period)),
            Self::Pga => to.write_str("PGA"),
            Self::SaAverage([first, last]) => write!(to, "Sa_avg({}..{} s)", digits(*first), digits(*last)),
        }
    }
}

/// A measure of intensity as it is asked for, before the row is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AskedMeasure {
    /// This one.
    Of(IntensityMeasure),
    /// [`IntensityMeasure::Sa`] at the longest first period of the row, `T1`.
    LongestPeriod,
}

impl AskedMeasure {
    /// The measure for a row.
    ///
    /// # Errors
    /// Refuses a period of a row that has none.
    pub fn of_row(self, scene: &Scene) -> Result<IntensityMeasure, Refused> {
        let longest = || scene.structures.iter().filter_map(Structure::longest_period).reduce(f64::max);
        match self {
            Self::Of(measure) => Ok(measure),
            Self::LongestPeriod => {
                let none = || Refused::at("structures").found("walls alone").allowed_are("one or more that move");
                longest().map(IntensityMeasure::Sa).ok_or_else(none)
            }
        }
    }
}

impl FromStr for AskedMeasure {
    type Err = Refused;

    fn from_str(text: &str) -> Result<Self, Refused> {
        let refused = || {
            let found = Refused::default().found(format!("\"{text}\""));
            found
                .allowed_are("pga, sa(0.8), sa(T1) of the longest first period of the row, and sa_avg(0.2..2), periods from 0.001 to 100 s")
        };
        let period = |text: &str| {
            let text = text.trim();
            let period = text.strip_suffix('s').unwrap_or(text).trim().parse::<f64>().ok();
            period.filter(|period| (1e-3..=100.0).contains(period))
        };
        let lower = text.trim().to_ascii_lowercase();
        let inner = |name: &str| lower.strip_prefix(name)?.strip_suffix(')');
        match &*lower {
            "pga" => return Ok(Self::Of(IntensityMeasure::Pga)),
            "t1" | "sa(t1)" => return Ok(Self::LongestPeriod),
            _ => (),
        }
        let found = match (inner("sa("), inner("sa_avg(")) {
            (Some(of), _) => period(of).map(IntensityMeasure::Sa),
            (None, Some(of)) => of.split_once("..").and_then(|(from, to)| {
                let ends = [period(from)?, period(to)?];
                (ends[0] < ends[1]).then_some(IntensityMeasure::SaAverage(ends))
            }),
            (None, None) => None,
        };
        found.map(Self::Of).ok_or_else(refused)
    }
}
