//! Removal of a straight line from a record.

use crate::{Record, Refused};

/// The line that [`Record::detrended`] removes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trend {
    /// The mean of all samples.
    Constant,
    /// The straight line of least squares through all samples.
    Linear,
}

impl Record {
    /// Returns the record less the trend of its samples.
    ///
    /// The trend is fitted to all samples, including quiet ones before and after the shaking. A digital offset is a constant. A single
    /// sample becomes zero.
    ///
    /// # Errors
    /// Refuses samples whose sum is not finite.
    pub fn detrended(&self, trend: Trend) -> Result<Self, Refused> {
        let samples = self.samples();
        let n = samples.len() as f64;
        let mean = samples.iter().sum::<f64>() / n;
        // Counted from the middle, index and constant are orthogonal, and the two fits independent.
        let centred = |index: usize| index as f64 - 0.5 * (n - 1.0);
        let slope = match trend {
            Trend::Constant => 0.0,
            Trend::Linear if samples.len() < 2 => 0.0,
            Trend::Linear => {
                let (mut product, mut square) = (0.0, 0.0);
                for (index, sample) in samples.iter().enumerate() {
                    product += centred(index) * (sample - mean);
                    square += centred(index) * centred(index);
                }
                product / square
            }
        };
        let less = |(index, sample): (usize, &f64)| sample - (mean + slope * centred(index));
        let samples = samples.iter().enumerate().map(less).collect();
        Self::new(self.time_step(), samples, self.source())
    }
}
