//! The ground motion of a random scene: a record of the project, random shaking or a pulse, scaled as earthquakes are.

use super::random::Random;
use pounding_scene::{FileUse, Generated, Ground, RecordUse, ScaleTo, Source, Stochastic};

/// The project's records, from the folder of the studies.
const RECORDS: [&str; 2] = [
    "records/el-centro-1940-ns-chopra.csv",
    "records/el-centro-1940-ns-peer-pacific-engineering.csv",
];

/// A ground motion.
pub(super) fn one(random: &mut Random) -> RecordUse {
    let reversed = random.chance(0.5);
    let (source, scale_to) = match random.below(20) {
        0..=6 => (file(random), Some(ScaleTo::PgaG(random.log_within(0.1, 0.8)))),
        7..=13 => (stochastic(random), None),
        14..=15 => (ricker(random), None),
        16..=17 => (half_sine(random), None),
        _ => (harmonic(random), None),
    };
    RecordUse {
        scale_to,
        reversed,
        ..RecordUse::of(source)
    }
}

fn file(random: &mut Random) -> Source {
    Source::File(FileUse {
        file: random.one_of(&RECORDS).into(),
        ..FileUse::default()
    })
}

fn stochastic(random: &mut Random) -> Source {
    let strong_from_s = random.within(0.5, 2.0);
    Source::Generated(Generated::Stochastic(Stochastic {
        ground: random.one_of(&[Ground::Firm, Ground::Medium, Ground::Soft]),
        pga_m_per_s2: random.log_within(1.0, 8.0),
        strong_from_s,
        strong_until_s: strong_from_s + random.within(2.0, 8.0),
        decay_per_s: random.within(0.2, 1.0),
        cutoff_hz: None,
        duration_s: 15.0,
        time_step_s: random.one_of(&[0.005, 0.01, 0.02]),
        seed: random.seed(),
    }))
}

fn ricker(random: &mut Random) -> Source {
    Source::Generated(Generated::Ricker {
        amplitude_m_per_s2: random.within(1.0, 8.0),
        frequency_hz: random.log_within(0.4, 4.0),
        time_step_s: random.one_of(&[0.005, 0.01, 0.02]),
    })
}

fn half_sine(random: &mut Random) -> Source {
    Source::Generated(Generated::HalfSine {
        amplitude_m_per_s2: random.within(1.0, 6.0),
        duration_s: random.log_within(0.1, 1.5),
        time_step_s: random.one_of(&[0.005, 0.01, 0.02]),
    })
}

fn harmonic(random: &mut Random) -> Source {
    let frequency_hz = random.log_within(0.3, 5.0);
    Source::Generated(Generated::Harmonic {
        amplitude_m_per_s2: random.within(0.5, 4.0),
        frequency_hz,
        phase_rad: if random.chance(0.5) { 0.0 } else { random.within(0.0, 6.0) },
        ramp_periods: random.one_of(&[0.0, 1.0, 2.0]),
        // At least five periods, of which ramps take up to four.
        duration_s: random.within(3.0, 12.0).max(5.0 / frequency_hz),
        time_step_s: random.one_of(&[0.005, 0.01, 0.02]),
    })
}
