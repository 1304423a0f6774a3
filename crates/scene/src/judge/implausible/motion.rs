//! Implausible values of a ground motion: in its file, and in its use by a scene.

use pounding_motion::{AccelerationUnit, Direction, Record, Unusual};

use super::{Doubts, Implausible, RECORD};
use crate::{GroundMotion, Origin, RecordUse};
use pounding_text::{digits, short};

impl GroundMotion {
    /// Finds the implausible values of the motion, whatever row it shakes: in its file and, if it is used `as_it_is`, in its use.
    pub fn doubts(&self, used: &RecordUse, as_it_is: bool) -> Vec<Implausible> {
        let mut doubts = Doubts::default();
        let shaking = Shaking {
            used,
            record: &self.record,
            scale: self.scale,
            origin: self.origin.as_deref(),
        };
        if as_it_is {
            shaking.doubt(&mut doubts);
        } else {
            shaking.doubt_the_file(&mut doubts);
        }
        doubts.0
    }
}

/// A ground motion as a scene uses it.
pub(super) struct Shaking<'s> {
    pub(super) used: &'s RecordUse,
    pub(super) record: &'s Record,
    pub(super) scale: f64,
    pub(super) origin: Option<&'s Origin>,
}

impl Shaking<'_> {
    pub(super) fn doubt(&self, doubts: &mut Doubts) {
        let gravity = self.used.gravity_m_per_s2;
        doubts.unless(
            (9.7..=9.9).contains(&gravity),
            "record.gravity_m_per_s2",
            digits(gravity),
            "9.78 to 9.83 m/s²",
        );
        let is_told = self.doubt_the_file(doubts);
        let (peak, factor) = (self.record.peak().1.abs(), self.scale);
        let is_scaled = factor.to_bits() != 1.0_f64.to_bits();
        let worth = AccelerationUnit::MetrePerSecondSquared.worth_in(AccelerationUnit::StandardGravity);
        let in_g = peak * worth;
        doubts.unless_far(
            Unusual::USUAL_PEAKS.contains(&in_g) || (is_told && !is_scaled),
            peak / 2.5,
            RECORD,
            format!("a peak of {} g", short(in_g)),
            "0.02 to 3 g; its unit and scale decide it",
        );
        doubts.unless_far(
            (Implausible::USUAL_FACTORS[0]..=Implausible::USUAL_FACTORS[1]).contains(&factor) || self.origin.is_none(),
            factor,
            RECORD,
            format!("a scale factor of {}", short(factor)),
            "0.25 to 4: a record that needs more belongs to another earthquake",
        );
        self.doubt_the_baseline(doubts);
    }

    /// Notes implausible values in the file of the record, and a vertical component. Returns whether the file has implausible values.
    fn doubt_the_file(&self, doubts: &mut Doubts) -> bool {
        let Some(origin) = self.origin else {
            return false;
        };
        let unusual = origin.file.unusual();
        for one in unusual {
            doubts.unless_far(false, one.ratio(), RECORD, one.found(), one.usual());
        }
        let is_vertical = origin.file.direction() == Some(Direction::Vertical);
        let component = origin.file.component().unwrap_or_default();
        doubts.unless(
            !is_vertical,
            RECORD,
            format!("the vertical component \"{component}\""),
            "a horizontal one: the ground of a row moves sideways",
        );
        !unusual.is_empty()
    }

    /// Notes a ground that does not come to rest. Only for files: a formula may leave the ground moving on purpose.
    fn doubt_the_baseline(&self, doubts: &mut Doubts) {
        let drift = self.record.drift().filter(|_| self.origin.is_some());
        let said = drift.map_or_else(String::new, |drift| {
            format!(
                "a ground that does not come to rest: its mean velocity over the last tenth is {} m/s, {} % of the peak",
                short(drift.velocity.abs()),
                short(1e2 * drift.share)
            )
        });
        doubts.unless_far(
            drift.is_none(),
            drift.map_or(1.0, |drift| drift.share / 0.1),
            RECORD,
            said,
            "up to 10 %; an offset of the baseline goes with record.detrend = \"linear\" or record.band_pass",
        );
    }
}
