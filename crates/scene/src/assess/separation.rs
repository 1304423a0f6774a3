//! The width that the gaps of a row need, and what the rules of codes and literature ask for.

use std::collections::BTreeMap;

use crate::simulation::Extras;
use crate::simulation::floors::EQUAL_HEIGHTS;
use crate::{Error, Floor, RunResult, Simulation};

/// The width of one gap under one record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Index of the structure on the left.
    pub left: usize,
    /// Level of the floors that need most, counted from 1 for the lowest, as `levels` of contacts count.
    pub at_level: usize,
    /// Width below which the neighbours touch \[m\]: at the level that needs most, the largest closing of the gap while every structure stands alone.
    pub required: f64,
    /// When it is needed \[s\].
    pub time: f64,
    /// Largest displacement of each neighbour standing alone \[m\], without sign.
    pub peaks: [f64; 2],
    /// Natural period \[s\] and damping ratio of each; nothing for a wall.
    pub oscillations: [Option<(f64, f64)>; 2],
    /// Whether both stand equally high, by the heights that the scene gives.
    pub level: bool,
}

/// A rule for the width of a gap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    /// Sum of both peak displacements.
    Abs,
    /// Root of the sum of their squares.
    Srss,
    /// Double difference combination: the square root of u₁² + u₂² − 2ρu₁u₂ with the correlation ρ of two oscillators
    /// under white noise, of elastic periods and damping also where columns yield (V. Jeng, K. Kasai and B. F. Maison, *Earthquake Spectra* 8 (1992) 201).
    Ddc,
    /// EN 1998-1, 4.4.2.7: the root of the sum of squares, 0.7 times that where floors are level.
    Eurocode8,
    /// ASCE 7-16, 12.12.3: the root of the sum of squares of the inelastic displacements.
    Asce7,
}

impl Rule {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Abs,
        Self::Srss,
        Self::Ddc,
        Self::Eurocode8,
        Self::Asce7,
    ];

    /// Name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Abs => "ABS",
            Self::Srss => "SRSS",
            Self::Ddc => "DDC",
            Self::Eurocode8 => "EC 8",
            Self::Asce7 => "ASCE 7",
        }
    }

    /// Name of its width in CSV and JSON.
    pub fn key(self) -> &'static str {
        match self {
            Self::Abs => "abs_m",
            Self::Srss => "srss_m",
            Self::Ddc => "ddc_m",
            Self::Eurocode8 => "eurocode_8_m",
            Self::Asce7 => "asce_7_m",
        }
    }

    /// The width that the rule asks for \[m\].
    ///
    /// Displacements are those of the time history itself: behaviour and amplification factors of the codes, by which they
    /// come to such displacements, have no place here.
    pub fn width(self, separation: &Separation) -> f64 {
        let [left, right] = separation.peaks;
        let srss = (left * left + right * right).sqrt();
        match self {
            Self::Abs => left + right,
            Self::Eurocode8 if separation.level => 0.7 * srss,
            Self::Srss | Self::Eurocode8 | Self::Asce7 => srss,
            Self::Ddc => {
                let correlation = correlation(separation.oscillations);
                let square = left * left + right * right - 2.0 * correlation * left * right;
                // Like neighbours move alike; rounding may leave less than nothing.
                square.max(0.0).sqrt()
            }
        }
    }
}

/// Correlation ρ \[–\] of the responses of two oscillators, as of the complete quadratic combination; 0 beside a wall, and of two
/// without damping unless their periods are the same.
fn correlation(oscillations: [Option<(f64, f64)>; 2]) -> f64 {
    let [Some((left, of_left)), Some((right, of_right))] = oscillations else {
        return 0.0;
    };
    let ratio = left / right;
    let product = of_left * of_right;
    let above = 8.0 * product.sqrt() * (of_left + ratio * of_right) * ratio * ratio.sqrt();
    let apart = 1.0 - ratio * ratio;
    let squares = of_left * of_left + of_right * of_right;
    let below = apart * apart
        + 4.0 * product * ratio * (1.0 + ratio * ratio)
        + 4.0 * squares * ratio * ratio;
    if below > 0.0 { above / below } else { 1.0 }
}

impl Simulation {
    /// For every two neighbours but two walls, the width that keeps them apart under this record and direction; by the
    /// exact method.
    ///
    /// Gaps and contact laws of the scene do not matter: wide enough gaps leave every structure alone.
    ///
    /// # Errors
    /// [`Error::Run`] when a run ends early.
    pub fn separations(&self) -> Result<Vec<Separation>, Error> {
        let apart = self.apart()?.exact()?;
        let floors = apart.floors();
        let asked = Extras {
            closings: true,
            ..Extras::default()
        };
        let RunResult {
            peaks, closings, ..
        } = apart.run_unjudged(asked)?;
        let mut widest: BTreeMap<usize, Separation> = BTreeMap::new();
        for (left, one, other) in self.floors().neighbours() {
            let closing = closings.as_ref().and_then(|closings| closings.of(one));
            let Some(closing) = closing else {
                continue;
            };
            // Neighbours that are apart from the start on, and further, need no gap.
            let (required, time) = if closing.distance > 0.0 {
                (closing.distance, closing.time)
            } else {
                (0.0, 0.0)
            };
            let sides = [one, other].map(|index| &floors.all()[index]);
            let at_level = Separation {
                left,
                at_level: floors.levels().level(one) + 1,
                required,
                time,
                peaks: [one, other].map(|index| peaks.of(index).displacement.value.abs()),
                level: level(sides),
                oscillations: sides.map(|floor| floor.oscillation(apart.scene())),
            };
            let so_far = widest.entry(left).or_insert(at_level);
            if at_level.required > so_far.required {
                *so_far = at_level;
            }
        }
        Ok(widest.into_values().collect())
    }
}

/// Whether both have heights, the same ones.
fn level([left, right]: [&Floor; 2]) -> bool {
    let heights = (left.elevation_m, right.elevation_m);
    matches!(heights, (Some(left), Some(right)) if (left - right).abs() <= EQUAL_HEIGHTS)
}
