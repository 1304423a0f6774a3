//! Band-pass filtering of a record.

use crate::butterworth::Cascade;
use crate::record::within;
use crate::{Record, Refused};
use pounding_text::{Knob, plain};

/// Highest order; filters of a higher order ring for longer than records last.
const HIGHEST_ORDER: u32 = 10;

/// Lowest corner in cycles per sample: compared with one, its square still has five digits.
const LOWEST_CORNER: f64 = 1e-6;

/// How often a filter runs over a record.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Passes {
    /// Forward and backward: there is no delay, and every gain counts twice (one half at the corners). Some of the motion appears before
    /// its cause.
    #[default]
    ForwardAndBackward,
    /// Forward only, from rest: causal, with the delays of the filter.
    Forward,
}

/// A Butterworth band-pass filter.
///
/// Its gain in a single pass is 1/√2 at the corners. The response of the filter before the first and after the last sample is cut off. If
/// velocity and displacement matter, add zeros there first (D. M. Boore, *Bull. Seism. Soc. Am.* 95 (2005) 745).
#[derive(Debug, Clone, PartialEq)]
pub struct BandPass {
    /// Order of the low-pass prototype, 1 ..= 10; the band-pass filter has twice as many poles.
    pub order: u32,
    /// Corner below which the motion is removed \[Hz\], at least 1e-6 over the time step.
    pub low_corner: f64,
    /// Corner above which the motion is removed \[Hz\], above the low corner and below half of one over the time step.
    pub high_corner: f64,
    /// How often the filter runs over the record.
    pub passes: Passes,
}

impl BandPass {
    /// Checks the settings against the time step \[s\] of a record.
    fn check(&self, time_step: f64) -> Result<(), Refused> {
        let order = (1..=HIGHEST_ORDER).contains(&self.order);
        within("order", f64::from(self.order), order, "1 to 10")?;
        let allowed = "a number of Hz, at least 1e-6 over the time step";
        let resolved = self.low_corner * time_step >= LOWEST_CORNER;
        within("low_corner", self.low_corner, resolved, allowed)?;
        // Checked before the highest frequency: otherwise swapped corners would blame the wrong one.
        if self.low_corner >= self.high_corner {
            let [low, high] = [self.low_corner, self.high_corner].map(plain);
            let found = format!("a low corner (below it the motion is taken away) of {low} Hz and a high one (above it) of {high} Hz");
            let found = Refused::default().found(found).allowed_is("the first below the second");
            return Err(found.help(if self.low_corner > self.high_corner {
                "exchange them"
            } else {
                "part them"
            }));
        }
        below_nyquist("high_corner", self.high_corner, time_step)
    }

    /// Number of samples that are reflected at either end: three times the number of poles plus one, as in `scipy`.
    fn padding(&self) -> usize {
        3 * (2 * self.order as usize + 1)
    }
}

/// Refuses a frequency \[Hz\] that samples `time_step` \[s\] apart do not hold, or none.
pub(crate) fn below_nyquist(setting: &'static str, found: f64, time_step: f64) -> Result<(), Refused> {
    let nyquist = 0.5 / time_step;
    if found < nyquist {
        Ok(())
    } else {
        let found = Refused::at(setting).found(format!("{} Hz", plain(found)));
        let allowed = format!("below {} Hz, half of one over the time step", plain(nyquist));
        Err(found.allowed_is(allowed).help("lower it"))
    }
}

impl Record {
    /// Returns the record through a band-pass filter.
    ///
    /// Forward and backward, the record is extended at either end by 3 (2·order + 1) samples, rotated about its end point. The filter
    /// starts in the steady state of the first sample. Both are as in `scipy.signal.sosfiltfilt`.
    ///
    /// # Errors
    /// Refuses settings out of range, a corner that the time step does not allow, and a record no longer than its
    /// extension.
    pub fn band_passed(&self, filter: &BandPass) -> Result<Self, Refused> {
        filter.check(self.time_step())?;
        let [low, high] = [filter.low_corner, filter.high_corner].map(|corner| corner * self.time_step());
        let mut cascade = Cascade::band_pass(filter.order, low, high);
        let samples = match filter.passes {
            Passes::Forward => {
                let samples = self.samples().iter();
                samples.map(|&sample| cascade.next(sample)).collect()
            }
            Passes::ForwardAndBackward => {
                let padding = filter.padding();
                if self.samples().len() <= padding {
                    let found = format!("a record of {} samples", self.samples().len());
                    let (least, order) = (padding + 1, filter.order);
                    return Err(Refused::default()
                        .found(found)
                        .allowed_are(format!("{least} or more to filter forward and backward at order {order}"))
                        .help("lower ")
                        .and(Knob::field("record.band_pass.order"))
                        .and(", or set ")
                        .and(Knob::field("record.band_pass.causal")));
                }
                there_and_back(&mut cascade, self.samples(), padding)
            }
        };
        Self::new(self.time_step(), samples, self.source())
    }
}

/// Filters more samples than `padding` forward, then backward.
fn there_and_back(cascade: &mut Cascade, samples: &[f64], padding: usize) -> Vec<f64> {
    let last = samples.len() - 1;
    let before = (1..=padding).rev().map(|index| 2.0 * samples[0] - samples[index]);
    let after = (1..=padding).map(|index| 2.0 * samples[last] - samples[last - index]);
    let mut extended: Vec<f64> = before.chain(samples.iter().copied()).chain(after).collect();
    cascade.settle(extended[0]);
    for sample in &mut extended {
        *sample = cascade.next(*sample);
    }
    cascade.settle(extended[extended.len() - 1]);
    for sample in extended.iter_mut().rev() {
        *sample = cascade.next(*sample);
    }
    extended[padding..=padding + last].to_vec()
}
