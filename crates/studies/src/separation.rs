//! The width that the gaps of a row need, and what the rules of codes and literature ask for.

use pounding_solver::State;

use crate::{Prepared, Scene, Structure, StudyError};

/// Intervals of the shortest natural period at which a motion is looked at; between them it is taken as a cubic, which
/// is off by (2π/200)⁴/384 of the amplitude.
const LOOKS_PER_PERIOD: f64 = 200.0;

/// The width of one gap under one record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Index of the structure on the left.
    pub left: usize,
    /// Width below which the neighbours touch \[m\]: the largest closing of the gap while every structure stands alone.
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

impl Prepared {
    /// For every two neighbours but two walls, the width that keeps them apart under this record and direction; by the
    /// exact method.
    ///
    /// Gaps and contact laws of the scene do not matter: wide enough gaps leave every structure alone.
    ///
    /// # Errors
    /// [`StudyError::Run`] when a run ends early.
    ///
    /// # Panics
    /// Never: the histories are asked for.
    pub fn separations(&self) -> Result<Vec<Separation>, StudyError> {
        let apart = Scene {
            contacts: None,
            ..self.scene().clone()
        };
        let apart = self.variant(&apart, self.record().clone())?.exact()?;
        let periods = apart
            .scene()
            .structures
            .iter()
            .filter_map(Structure::period);
        let step = apart.record().time_step();
        let looks = (step * LOOKS_PER_PERIOD / periods.fold(f64::INFINITY, f64::min)).ceil();
        let interval = step / looks.max(1.0);
        let outcome = apart.run_unjudged(Some(interval))?;
        let histories = outcome.histories.as_ref().expect("they were asked for");
        let structures = &apart.scene().structures;
        let neighbours = structures.windows(2).enumerate();
        let separation = |(left, pair): (usize, &[Structure])| {
            let walls = matches!(pair, [Structure::Wall, Structure::Wall]);
            let (time, required) = closing(
                &histories.of(left).states,
                &histories.of(left + 1).states,
                interval,
            );
            (!walls).then(|| Separation {
                left,
                required,
                time,
                peaks: [left, left + 1]
                    .map(|index| outcome.peaks.of(index).displacement.value.abs()),
                level: level(pair),
                oscillations: [left, left + 1].map(|index| oscillation(&structures[index])),
            })
        };
        Ok(neighbours.filter_map(separation).collect())
    }
}

/// Whether both have heights, the same ones.
fn level(pair: &[Structure]) -> bool {
    let height = |structure: &Structure| match structure {
        Structure::Sdof(sdof) => sdof.height_m,
        Structure::Building(_) | Structure::Wall => None,
    };
    let heights = (height(&pair[0]), height(&pair[1]));
    matches!(heights, (Some(left), Some(right)) if left.total_cmp(&right).is_eq())
}

fn oscillation(structure: &Structure) -> Option<(f64, f64)> {
    match structure {
        Structure::Sdof(sdof) => Some((sdof.period(), sdof.damping_ratio())),
        Structure::Building(_) | Structure::Wall => None,
    }
}

/// Largest displacement of the left neighbour against the right one \[m\], at least 0, and its time \[s\].
fn closing(left: &[State], right: &[State], interval: f64) -> (f64, f64) {
    let node = |(left, right): (&State, &State)| {
        (
            left.displacement - right.displacement,
            left.velocity - right.velocity,
        )
    };
    let nodes: Vec<_> = left.iter().zip(right).map(node).collect();
    let mut largest = (0.0, 0.0);
    for (index, pair) in nodes.windows(2).enumerate() {
        let (share, closing) = highest(pair[0], pair[1], interval);
        if closing > largest.1 {
            largest = ((index as f64 + share) * interval, closing);
        }
    }
    largest
}

/// Where, as a share of the interval, and how high the cubic through two nodes of value and slope is at most.
fn highest((y0, v0): (f64, f64), (y1, v1): (f64, f64), interval: f64) -> (f64, f64) {
    let ends = if y1 > y0 { (1.0, y1) } else { (0.0, y0) };
    if !(v0 > 0.0 && v1 < 0.0) {
        return ends;
    }
    // y(s) = y0 + a s + b s² + c s³; one maximum, as the slope goes from above to below zero.
    let (a, end) = (v0 * interval, v1 * interval);
    let rise = y1 - y0;
    let (b, c) = (3.0 * rise - 2.0 * a - end, a + end - 2.0 * rise);
    let slope = |s: f64| a + s * (2.0 * b + 3.0 * s * c);
    let (mut low, mut high) = (0.0, 1.0);
    // 2⁻⁵² of the interval is the last digit.
    for _ in 0..52 {
        let middle = 0.5 * (low + high);
        if slope(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let value = y0 + low * (a + low * (b + low * c));
    if value > ends.1 { (low, value) } else { ends }
}
