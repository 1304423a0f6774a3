//! What was done to a ground motion, in words.

use crate::{Detrend, RecordUse, ScaleTo};
use pounding_text::digits;

impl RecordUse {
    /// What is done to the ground motion on its way from its source to the row, in this order; nothing of what is left as it is.
    pub fn processing(&self) -> Vec<String> {
        let detrend = self.detrend.map(|line| match line {
            Detrend::Constant => "mean taken away".into(),
            Detrend::Linear => "straight line of least squares taken away".into(),
        });
        let band = self.band_pass.map(|band| {
            let passes = if band.causal { "forward" } else { "forward and backward" };
            format!(
                "band-pass {} to {} Hz, Butterworth, order {}, {passes}",
                digits(band.low_hz),
                digits(band.high_hz),
                band.order
            )
        });
        let resampled = self.resample_s.map(|step| format!("resampled every {step} s"));
        let target = self.scale_to.map(|target| match target {
            ScaleTo::PgaG(peak) => format!("scaled to a PGA of {peak} g"),
            ScaleTo::Sa {
                period_s,
                damping_ratio,
                sa_g,
            } => format!("scaled to Sa({period_s} s, damping {damping_ratio}) = {sa_g} g"),
        });
        let needs_g = target.is_some();
        let gravity = needs_g.then(|| format!("with g = {} m/s²", self.gravity_m_per_s2));
        let one = 1.0_f64.to_bits();
        let scale = (self.scale.to_bits() != one).then(|| format!("multiplied by {}", self.scale));
        let reversed = self.reversed.then(|| "reversed".into());
        let all = [detrend, band, resampled, target, gravity, scale, reversed];
        all.into_iter().flatten().collect()
    }
}
