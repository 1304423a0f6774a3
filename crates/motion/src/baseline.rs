//! Detection of a ground that keeps moving after the record, as with an offset of the baseline.

use crate::Record;

/// The final part of a record over which the velocity is averaged, as one over this number of its steps: waves average out, a drift does
/// not.
const END: usize = 10;

/// Share of the peak velocity above which the mean velocity at the end is called a drift.
///
/// Ten processed components of seven networks (PEER, CSMIP, COSMOS, SMC, ESM, `GeoNet`) have 3e-5 to 0.075. The largest is El Centro 1940,
/// digitised by hand and printed to five decimals. A USC record whose integral from rest misses its own peak displacement by a factor of a
/// hundred has 0.51, a raw record of counts 0.95.
const DRIFT: f64 = 0.1;

/// Residual velocity of the ground at the end of a record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drift {
    /// Mean velocity over the last tenth of the record, with its sign \[m/s\].
    pub velocity: f64,
    /// Its magnitude over the peak velocity \[–\], above 0.1.
    pub share: f64,
}

impl Record {
    /// Returns the velocity that the ground keeps when it should be at rest again; `None` up to a tenth of the peak velocity.
    ///
    /// After an earthquake the ground is at rest, possibly at another place. A velocity that does not return to zero, with a growing
    /// displacement, shows an offset of the baseline (D. M. Boore and J. J. Bommer, *Soil Dyn. Earthq. Eng.* 25 (2005) 93), or a record
    /// that was cut before the motion ended.
    pub fn drift(&self) -> Option<Drift> {
        let integrated = self.integrated();
        let displacement = &integrated.displacement;
        let last = displacement.len() - 1;
        let first = last - last.div_ceil(END);
        if first == last {
            return None;
        }
        let elapsed = (last - first) as f64 * self.time_step();
        let velocity = (displacement[last] - displacement[first]) / elapsed;
        let peak = integrated.velocity.iter().fold(0.0, |peak: f64, one| peak.max(one.abs()));
        let share = velocity.abs() / peak;
        (share > DRIFT && share.is_finite()).then_some(Drift { velocity, share })
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use crate::{Record, Trend};

    /// Ten periods of a sine that starts and ends at rest, and an offset \[m/s²\].
    fn shaken(offset: f64) -> Record {
        let sample = |index: i32| {
            let time = f64::from(index) * 0.01;
            let envelope = libm::sin(TAU * time / 20.0);
            envelope * envelope * libm::sin(TAU * time) + offset
        };
        let samples = (0..=1000).map(sample).collect();
        Record::new(0.01, samples, "a sine").expect("a record")
    }

    /// An offset of 0.5 % of the peak moves the ground by a quarter of a metre, and there was no message.
    #[test]
    fn issue_an_offset_of_the_baseline_is_found() {
        assert_eq!(shaken(0.0).drift(), None);
        let drift = shaken(0.005).drift().expect("a drift");
        // 0.005 m/s² over 9.5 s, the middle of the last second; what fades then of the sine is 3 mm/s.
        assert!((drift.velocity - 0.0475).abs() < 3e-3, "{drift:?}");
        assert!(drift.share > 0.1 && drift.share < 0.5, "{drift:?}");
        let reversed = shaken(0.005).reversed().drift().expect("a drift");
        assert_eq!(reversed.velocity.to_bits(), (-drift.velocity).to_bits());
        let scaled = shaken(0.005).scaled(4.0).expect("finite").drift().expect("a drift");
        assert_eq!(scaled.share.to_bits(), drift.share.to_bits());
        let detrended = shaken(0.005).detrended(Trend::Linear).expect("a record");
        assert_eq!(detrended.drift(), None);
    }

    #[test]
    fn extreme_records_that_cannot_drift() {
        for samples in [vec![1.0], vec![0.0, 0.0], vec![0.0; 50]] {
            assert_eq!(Record::new(0.01, samples, "").expect("a record").drift(), None);
        }
    }
}
