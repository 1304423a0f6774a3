//! What looks wrong in a ground motion: in its file, and in how a scene uses it.

use pounding_motion::{AccelerationUnit, Direction, Record};

use super::{Doubts, Implausible, RECORD, USUAL_FACTORS};
use crate::{GroundMotion, Origin, RecordUse, Source};
use pounding_text::{digits, short, two_digits};

/// Peak accelerations of strong motion \[m/s²\]: from 0.02 g, which moves no building much, to 3 g.
const USUAL_PEAKS: std::ops::RangeInclusive<f64> = 0.2..=30.0;

/// Those of records that are chosen for buildings \[g\]: from 0.1 g, below which a declared unit is doubted, to 1.5 g, which few exceed.
const CHOSEN_PEAKS: std::ops::RangeInclusive<f64> = 0.1..=1.5;

impl GroundMotion {
    /// What looks wrong in the motion itself, whatever row it shakes: in its file, and if it is used `as_it_is`, in how it is used.
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
            (digits(gravity), "9.78 to 9.83 m/s²"),
        );
        let is_told = self.doubt_the_file(doubts);
        let (peak, factor) = (self.record.peak().1.abs(), self.scale);
        let is_scaled = factor.to_bits() != 1.0_f64.to_bits();
        doubts.unless_far(
            (
                USUAL_PEAKS.contains(&peak) || (is_told && !is_scaled),
                peak / 2.5,
            ),
            RECORD,
            (
                format!("a peak of {} m/s²", digits(peak)),
                "0.2 to 30 m/s²; its unit and scale decide it",
            ),
        );
        doubts.unless_far(
            (
                (USUAL_FACTORS[0]..=USUAL_FACTORS[1]).contains(&factor) || self.origin.is_none(),
                factor,
            ),
            RECORD,
            (
                format!("a scale factor of {}", short(factor)),
                "0.25 to 4: a record that needs more belongs to another earthquake",
            ),
        );
        self.doubt_the_declared_unit(doubts);
        self.doubt_the_baseline(doubts);
    }

    /// What looks wrong in the file of the record, or lies upright; whether anything does.
    fn doubt_the_file(&self, doubts: &mut Doubts) -> bool {
        let Some(origin) = self.origin else {
            return false;
        };
        let unusual = origin.file.unusual();
        let peak = self.record.peak().1.abs() / self.scale;
        for one in unusual {
            doubts.unless_far((false, peak), RECORD, (one.found(), one.usual()));
        }
        let is_vertical = origin.file.direction() == Some(Direction::Vertical);
        let component = origin.file.component().unwrap_or_default();
        doubts.unless(
            !is_vertical,
            RECORD,
            (
                format!("the vertical component \"{component}\""),
                "a horizontal one: the ground of a row moves sideways",
            ),
        );
        !unusual.is_empty()
    }

    /// A weak motion in a declared unit that would be a usual one in another.
    fn doubt_the_declared_unit(&self, doubts: &mut Doubts) {
        let (Source::File(file), Some(origin)) = (&self.used.source, self.origin) else {
            return;
        };
        let gravity = self.used.gravity_m_per_s2;
        let peak = self.record.peak().1.abs() / self.scale / gravity;
        let declared = origin.file.unit();
        let in_unit = |unit: &AccelerationUnit| {
            peak * unit.to_si(1.0, gravity) / declared.to_si(1.0, gravity)
        };
        // The plain units: thousandths and tenths of g are no slip.
        let mut others = AccelerationUnit::ALL[..3].iter();
        let other = others.find(|unit| CHOSEN_PEAKS.contains(&in_unit(unit)));
        let is_weak = (0.02..*CHOSEN_PEAKS.start()).contains(&peak);
        let Some(other) = other.filter(|_| is_weak && file.unit.is_some()) else {
            return;
        };
        let found = format!(
            "a peak of {} g, with the unit {} as declared; in {} the values would peak at {} g",
            two_digits(peak),
            declared.symbol(),
            other.symbol(),
            two_digits(in_unit(other))
        );
        let usual = "0.1 to 1.5 g, where the unit is declared";
        doubts.unless_far((false, peak), RECORD, (found, usual));
    }

    /// Of a record alone: a formula may leave the ground moving on purpose.
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
            (drift.is_none(), drift.map_or(1.0, |drift| drift.share)),
            RECORD,
            (
                said,
                "up to 10 %; an offset of the baseline goes with record.detrend = \"linear\" or record.band_pass",
            ),
        );
    }
}
