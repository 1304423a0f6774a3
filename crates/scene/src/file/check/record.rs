//! Checks the use of a ground motion, field by field, as far as that takes no motion.

use super::{FINITE, POSITIVE, require};
use crate::{RecordUse, ScaleTo};
use pounding_text::Refused;

/// Refuses the first field of a record that cannot be used, in the order of the file.
pub(crate) fn check(record: &RecordUse) -> Result<(), Refused> {
    let gravity = record.gravity_m_per_s2;
    require(gravity > 0.0, "record.gravity_m_per_s2", gravity, POSITIVE)?;
    if let Some(step) = record.resample_s {
        require(step > 0.0, "record.resample_s", step, POSITIVE)?;
    }
    let is_finite = |target: f64| (target * gravity).is_finite();
    match record.scale_to {
        None => {}
        Some(ScaleTo::PgaG(peak)) => {
            let (valid, allowed) = (peak >= 0.0 && is_finite(peak), "a number >= 0 that is finite in m/s²");
            require(valid, "record.scale_to.pga_g", peak, allowed)?;
        }
        Some(ScaleTo::Sa { sa_g, .. }) => {
            let (valid, allowed) = (sa_g > 0.0 && is_finite(sa_g), "a number > 0 that is finite in m/s²");
            require(valid, "record.scale_to.sa.sa_g", sa_g, allowed)?;
        }
    }
    require(true, "record.scale", record.scale, FINITE)
}
