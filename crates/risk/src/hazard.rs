//! The hazard curve of a site, and how often motions exceed a state there.

use pounding_text::{CurveWords, Refused, curve_points, digits, percent};

use crate::fragility::Fragility;
use crate::normal::{below, density, mills};
use crate::stripe::Stripes;

/// How often the ground motion of a site exceeds an intensity: a power law between two points of the curve.
#[derive(Debug, Clone, PartialEq)]
pub struct HazardCurve {
    /// Intensity \[g\], rising, and mean annual frequency \[1/year\], falling; two or more.
    points: Vec<[f64; 2]>,
}

/// How often motions exceed a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnnualFrequency {
    /// Mean annual frequency λ \[1/year\].
    pub rate: f64,
    /// Parts of λ from intensities below and above the ends of the hazard curve \[–\].
    pub beyond: [f64; 2],
}

/// Part of a frequency that comes from intensities of one range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contribution {
    /// Least and largest intensity \[g\].
    pub intensities: [f64; 2],
    /// Their part of the mean annual frequency \[1/year\].
    pub rate: f64,
}

impl AnnualFrequency {
    /// Largest part of λ beyond the ends of the hazard curve \[–\].
    pub const MOST_BEYOND: f64 = 0.05;

    /// Whether at most [`Self::MOST_BEYOND`] of λ lies beyond the ends; a part that is no number is too much, too.
    pub fn is_within(&self) -> bool {
        self.beyond[0] + self.beyond[1] <= Self::MOST_BEYOND
    }

    /// Mean return period \[years\].
    pub fn return_period(&self) -> f64 {
        self.rate.recip()
    }

    /// Probability of one exceedance or more in some years \[–\], if exceedances are a Poisson process.
    pub fn probability_in(&self, years: f64) -> f64 {
        -libm::expm1(-self.rate * years)
    }
}

impl HazardCurve {
    /// Makes a curve of points: intensity \[g\] and mean annual frequency \[1/year\].
    ///
    /// # Errors
    /// Refuses fewer than two points, numbers that are not > 0, and intensities that do not rise or frequencies that do not fall.
    pub fn of(points: Vec<[f64; 2]>) -> Result<Self, Refused> {
        let mut before = None;
        for (index, point) in points.iter().enumerate() {
            if !fits(before, *point) {
                let found = Refused::at(format!("{PLACE}: point {}", index + 1)).found(format!("{} g, {} per year", point[0], point[1]));
                return Err(found.allowed_are(ALLOWED));
            }
            before = Some(*point);
        }
        if points.len() < 2 {
            let found = Refused::at(PLACE).found(format!("{} points", points.len()));
            return Err(found.allowed_are("two or more, each an intensity in g and a mean annual frequency"));
        }
        Ok(Self { points })
    }

    /// Reads a curve: an intensity \[g\] and a mean annual frequency \[1/year\] to a line, as [`curve_points`] reads them.
    ///
    /// # Errors
    /// Names the line, and those of [`Self::of`].
    pub fn parse(text: &str) -> Result<Self, Refused> {
        let words = CurveWords {
            place: PLACE,
            allowed: ALLOWED,
        };
        Self::of(curve_points(text, words, fits)?)
    }

    /// Least and largest intensity of the curve \[g\].
    pub fn ends(&self) -> [f64; 2] {
        [self.points[0][0], self.points[self.points.len() - 1][0]]
    }

    /// Mean annual frequency of motions above an intensity \[1/year\]; `None` beyond the ends of the curve.
    pub fn frequency(&self, intensity: f64) -> Option<f64> {
        let segment = self.segments().find(|one| intensity <= one.to[0])?;
        (intensity >= self.ends()[0]).then(|| segment.frequency(intensity))
    }

    /// Mean annual frequency λ = ∫ P |dH| at which motions exceed a state. Beyond the ends, the curve continues with the power of its first and
    /// last part.
    ///
    /// # Errors
    /// Refuses a curve beyond whose ends more than [`AnnualFrequency::MOST_BEYOND`] of λ lies.
    pub fn annual(&self, fragility: &Fragility) -> Result<AnnualFrequency, Refused> {
        let found = self.whole(fragility);
        let beyond = found.beyond[0] + found.beyond[1];
        if found.is_within() {
            return Ok(found);
        }
        let [from, to] = self.ends().map(digits);
        let side = if found.beyond[0] > found.beyond[1] { "lower" } else { "higher" };
        let how_much = if beyond.is_finite() { percent(beyond) } else { "nearly all".into() };
        let found = format!("{how_much} of the annual frequency beyond {from} to {to} g");
        let found = Refused::at(PLACE).found(found).allowed_is("up to 5 %");
        Err(found.help(format!("give the curve to {side} intensities")))
    }

    /// Mean annual frequency, whatever lies beyond the ends.
    pub fn whole(&self, fragility: &Fragility) -> AnnualFrequency {
        self.in_parts(|from, to| self.rate_between(fragility, from, to))
    }

    /// Mean annual frequency by the shares of stripes, without a distribution, whatever lies beyond the ends. Between two stripes the share is
    /// linear in the logarithm of the intensity. Below a first share of 0 it stays 0, above a last share of 1 it stays 1. Beyond other ends of
    /// the stripes it is the fragility.
    ///
    /// `None` if stripes have no events, or if their shares need a fragility and there is none.
    pub fn whole_of_shares(&self, stripes: &Stripes, fragility: Option<&Fragility>) -> Option<AnnualFrequency> {
        let known = stripes.all.iter().filter(|one| one.n() > 0);
        let known: Vec<[f64; 2]> = known.map(|one| [one.intensity, one.share()]).collect();
        let ([least, first], [most, last]) = (*known.first()?, *known.last()?);
        let (is_none, is_all) = (first <= 0.0, last >= 1.0);
        if fragility.is_none() && !(is_none && is_all) {
            return None;
        }
        let of_fit = |from: f64, to: f64| fragility.map_or(0.0, |one| self.rate_between(one, from, to));
        let exceeding = |from: f64, to: f64| {
            self.pieces(from, to)
                .map(|(one, from, to)| one.frequency(from) - one.frequency(to))
                .sum()
        };
        Some(self.in_parts(|from, to| {
            let below = if is_none { 0.0 } else { of_fit(from, to.min(least)) };
            let above: f64 = if is_all {
                exceeding(from.max(most), to)
            } else {
                of_fit(from.max(most), to)
            };
            let joined = known.windows(2).flat_map(|two| {
                let pieces = self.pieces(from.max(two[0][0]), to.min(two[1][0]));
                pieces.map(|(one, from, to)| one.rate_of_line([two[0], two[1]], from, to))
            });
            below + above + joined.sum::<f64>()
        }))
    }

    /// A frequency as the sum of its part within the ends of the curve, and of those below and above.
    fn in_parts(&self, between: impl Fn(f64, f64) -> f64) -> AnnualFrequency {
        let [from, to] = self.ends();
        let [lower, within, upper] = [between(0.0, from), between(from, to), between(to, f64::INFINITY)];
        let rate = within + lower + upper;
        AnnualFrequency {
            rate,
            beyond: [lower / rate, upper / rate],
        }
    }

    /// Frequency of exceedances by motions between two intensities, 0 to infinity \[1/year\].
    fn rate_between(&self, fragility: &Fragility, from: f64, to: f64) -> f64 {
        self.pieces(from, to).map(|(one, from, to)| one.rate(fragility, from, to)).sum()
    }

    /// The power laws between two intensities, each with its range: the first begins at 0, the last one goes to infinity.
    fn pieces(&self, from: f64, to: f64) -> impl Iterator<Item = (Segment, f64, f64)> {
        let last = self.points.len() - 2;
        let piece = move |(index, one): (usize, Segment)| {
            let begin = if index == 0 { 0.0 } else { one.from[0] };
            let end = if index == last { f64::INFINITY } else { one.to[0] };
            let (from, to) = (from.max(begin), to.min(end));
            (from < to).then_some((one, from, to))
        };
        self.segments().enumerate().filter_map(piece)
    }

    /// Parts of λ from ranges of intensity that have equal ratios, over the whole curve.
    pub fn contributions(&self, fragility: &Fragility, n: u32) -> Vec<Contribution> {
        let [from, to] = self.ends();
        let end = |index: u32| match index {
            0 => from,
            index if index == n => to,
            index => from * libm::pow(to / from, f64::from(index) / f64::from(n)),
        };
        let range = |index: u32| {
            let intensities = [end(index), end(index + 1)];
            Contribution {
                intensities,
                rate: self.rate_between(fragility, intensities[0], intensities[1]),
            }
        };
        (0..n).map(range).collect()
    }

    fn segment(&self, index: usize) -> Segment {
        let [from, to] = [self.points[index], self.points[index + 1]];
        Segment {
            from,
            to,
            power: -libm::log(to[1] / from[1]) / libm::log(to[0] / from[0]),
        }
    }

    fn segments(&self) -> impl Iterator<Item = Segment> {
        (1..self.points.len()).map(|to| self.segment(to - 1))
    }
}

/// Place of a refusal.
const PLACE: &str = "hazard";

/// The numbers of a point in words.
const ALLOWED: &str = "an intensity in g and a mean annual frequency, both > 0, intensities rising and frequencies falling";

/// Whether a point may follow another one.
fn fits(last: Option<[f64; 2]>, [intensity, frequency]: [f64; 2]) -> bool {
    let are_numbers = [intensity, frequency].iter().all(|one| *one > 0.0 && one.is_finite());
    are_numbers && last.is_none_or(|[before, above]| intensity > before && frequency < above)
}

/// A power law H = H₁ (x/x₁)^−k between two points.
///
/// Integration by parts gives ∫ P |dH| = −[H P] + ∫ H dP. With z = ln(x/θ)/β and y = z + kβ, H φ(z)/φ(y) does not depend on x. It is the
/// factor of Φ(y) in ∫ H dP. From x to infinity this integral is H φ(z) R(y) with Mills' ratio R, and from zero to x it is H φ(z) R(−y):
/// neither overflows.
#[derive(Debug, Clone, Copy)]
struct Segment {
    from: [f64; 2],
    to: [f64; 2],
    /// The power k \[–\], > 0.
    power: f64,
}

impl Segment {
    fn frequency(&self, intensity: f64) -> f64 {
        self.from[1] * libm::pow(intensity / self.from[0], -self.power)
    }

    /// H, z and y at an intensity.
    fn at(&self, fragility: &Fragility, intensity: f64) -> [f64; 3] {
        let z = fragility.deviation(intensity);
        [self.frequency(intensity), z, z + self.power * fragility.dispersion]
    }

    /// Frequency of exceedances by motions between two intensities \[1/year\]; the lower one may be 0, or the upper one infinity.
    fn rate(&self, fragility: &Fragility, from: f64, to: f64) -> f64 {
        if from <= 0.0 {
            return self.rate_below(fragility, to);
        }
        if to.is_infinite() {
            return self.rate_above(fragility, from);
        }
        let (a, b) = (self.at(fragility, from), self.at(fragility, to));
        let parts = a[0] * below(a[1]) - b[0] * below(b[1]);
        // Each difference is taken of tails on its own side, so that no digits are lost.
        let moved = if a[2] >= 0.0 {
            tail_above(a) - tail_above(b)
        } else if b[2] <= 0.0 {
            tail_below(b) - tail_below(a)
        } else {
            // At y = 0, z = −kβ.
            let shift = self.power * fragility.dispersion;
            let whole = a[0] * libm::exp(shift * (a[1] + 0.5 * shift));
            whole - tail_below(a) - tail_above(b)
        };
        (parts + moved).max(0.0)
    }

    /// Frequency of exceedances by motions between two intensities, if a share is a line over ln x through two points \[1/year\]: by parts
    /// −[H P] + (dP/d ln x) [−H]/k.
    fn rate_of_line(&self, [[x, share], [next, last]]: [[f64; 2]; 2], from: f64, to: f64) -> f64 {
        let slope = (last - share) / libm::log(next / x);
        let of = |at: f64| self.frequency(at) * (share + slope * (libm::log(at / x) + self.power.recip()));
        of(from) - of(to)
    }

    /// Frequency of exceedances by motions below an intensity \[1/year\].
    fn rate_below(&self, fragility: &Fragility, to: f64) -> f64 {
        let at = self.at(fragility, to);
        // The tail is largely −[H P], so that the difference of both is taken as it stands only where it keeps digits.
        (tail_below(at) - at[0] * below(at[1])).max(0.0)
    }

    /// Frequency of exceedances by motions above an intensity \[1/year\].
    fn rate_above(&self, fragility: &Fragility, from: f64) -> f64 {
        let at = self.at(fragility, from);
        at[0] * below(at[1]) + tail_above(at)
    }
}

/// ∫ H dP from an intensity to infinity.
fn tail_above([frequency, z, y]: [f64; 3]) -> f64 {
    if y > 0.0 {
        frequency * density(z) * mills(y)
    } else {
        frequency * libm::exp(0.5 * (y * y - z * z)) * below(-y)
    }
}

/// ∫ H dP from zero to an intensity.
fn tail_below([frequency, z, y]: [f64; 3]) -> f64 {
    if y < 0.0 {
        frequency * density(z) * mills(-y)
    } else {
        frequency * libm::exp(0.5 * (y * y - z * z)) * below(y)
    }
}
