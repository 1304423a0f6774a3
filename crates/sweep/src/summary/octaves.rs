//! Numbers by their size: exact counts and sums, independent of the order of addition.
//!
//! The bits of a number give its place. Its sign and exponent give an octave, the first six bits of its fraction one of 64 bins in the
//! octave. No logarithm is needed, and all machines agree. All stored values are whole numbers, whose sums do not depend on the order.
//!
//! Own code: `xsum` sums exactly, but its state cannot be stored or merged. Sketches of quantiles (`sketches-ddsketch`) take the logarithm
//! of the platform, and drop bins in the order of their arrival.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// Bits of the fraction that choose a bin: its middle is at most half its width, 1/128 of the number, away.
const BIN_BITS: u32 = 6;
/// Bins of an octave.
const BINS: usize = 1 << BIN_BITS;
/// Bits of the fraction of a number.
const FRACTION_BITS: u32 = f64::MANTISSA_DIGITS - 1;
const FRACTION: u64 = (1 << FRACTION_BITS) - 1;
/// The bit of a key that negative numbers have.
const NEGATIVE: u16 = 1 << 11;

/// Finite numbers by their size.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Octaves(BTreeMap<u16, Box<Octave>>);

/// The numbers of a sign between two powers of two, by the 52 bits of their fractions.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(into = "Kept", try_from = "Kept")]
pub(super) struct Octave {
    /// Sum of the fractions.
    pub(super) sum: u128,
    /// Sum of their squares.
    pub(super) squares: Wide,
    bins: [Bin; BINS],
}

/// A whole number of 192 bits.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Wide {
    /// The lower 128 bits.
    pub(super) low: u128,
    /// The upper 64 bits.
    pub(super) high: u64,
}

impl Wide {
    fn plus(self, other: Self) -> Self {
        let (low, carried) = self.low.overflowing_add(other.low);
        Self {
            low,
            high: self.high + other.high + u64::from(carried),
        }
    }
}

/// The numbers of a bin: their number, and the smallest and the largest fraction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Bin {
    count: u64,
    least: u64,
    largest: u64,
}

const EMPTY: Bin = Bin {
    count: 0,
    least: u64::MAX,
    largest: 0,
};

impl Bin {
    fn merge(&mut self, other: &Self) {
        self.count += other.count;
        self.least = self.least.min(other.least);
        self.largest = self.largest.max(other.largest);
    }
}

impl Octave {
    const EMPTY: Self = Self {
        sum: 0,
        squares: Wide { low: 0, high: 0 },
        bins: [EMPTY; BINS],
    };

    fn add(&mut self, fraction: u64) {
        let one = Bin {
            count: 1,
            least: fraction,
            largest: fraction,
        };
        self.bins[bin_of(fraction)].merge(&one);
        let fraction = u128::from(fraction);
        self.sum += fraction;
        let square = Wide {
            low: fraction * fraction,
            high: 0,
        };
        self.squares = self.squares.plus(square);
    }

    fn merge(&mut self, other: &Self) {
        for (bin, other) in self.bins.iter_mut().zip(&other.bins) {
            bin.merge(other);
        }
        self.sum += other.sum;
        self.squares = self.squares.plus(other.squares);
    }

    pub(super) fn count(&self) -> u64 {
        self.bins.iter().map(|bin| bin.count).sum()
    }
}

fn bin_of(fraction: u64) -> usize {
    usize::try_from(fraction >> (FRACTION_BITS - BIN_BITS)).expect("a fraction has 52 bits")
}

/// An octave as stored in a file: only bins with numbers, each with its place, count, smallest and largest fraction.
#[derive(Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Kept {
    sum: u128,
    squares: (u128, u64),
    bins: Vec<(usize, u64, u64, u64)>,
}

impl From<Octave> for Kept {
    fn from(octave: Octave) -> Self {
        let bins = octave.bins.iter().enumerate();
        let bins = bins.filter(|(_, bin)| bin.count > 0);
        Self {
            sum: octave.sum,
            squares: (octave.squares.low, octave.squares.high),
            bins: bins.map(|(place, bin)| (place, bin.count, bin.least, bin.largest)).collect(),
        }
    }
}

impl TryFrom<Kept> for Octave {
    type Error = &'static str;

    fn try_from(kept: Kept) -> Result<Self, Self::Error> {
        let (low, high) = kept.squares;
        let mut octave = Self {
            sum: kept.sum,
            squares: Wide { low, high },
            ..Self::EMPTY
        };
        for (place, count, least, largest) in kept.bins {
            let bin = octave.bins.get_mut(place).ok_or("a bin beyond an octave")?;
            *bin = Bin { count, least, largest };
        }
        Ok(octave)
    }
}

/// Numbers in a bin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Filled {
    pub(super) count: u64,
    /// The smallest and the largest number.
    pub(super) least: f64,
    pub(super) largest: f64,
}

impl Octaves {
    /// Adds a finite number; a negative zero counts as zero.
    pub(super) fn add(&mut self, number: f64) {
        let bits = (number + 0.0).to_bits();
        let key = u16::try_from(bits >> FRACTION_BITS).expect("sign and exponent have 12 bits");
        self.octave(key).add(bits & FRACTION);
    }

    pub(super) fn merge(&mut self, other: &Self) {
        for (key, octave) in &other.0 {
            self.octave(*key).merge(octave);
        }
    }

    fn octave(&mut self, key: u16) -> &mut Octave {
        let octave = self.0.entry(key);
        octave.or_insert_with(|| Box::new(Octave::EMPTY))
    }

    /// Number of numbers.
    pub(super) fn count(&self) -> u64 {
        self.0.values().map(|octave| octave.count()).sum()
    }

    /// The octaves: whether their numbers are negative, their exponent bits, and their contents.
    pub(super) fn each(&self) -> impl Iterator<Item = (bool, u32, &Octave)> {
        let octaves = self.0.iter();
        octaves.map(|(key, octave)| (key & NEGATIVE != 0, u32::from(key & !NEGATIVE), &**octave))
    }

    /// Bins with numbers, in ascending order.
    pub(super) fn filled(&self) -> impl Iterator<Item = Filled> {
        let negative = self.0.range(NEGATIVE..).rev();
        let negative = negative.flat_map(|(key, octave)| {
            let bins = octave.bins.iter().rev();
            bins.map(|bin| filled(*key, bin.count, [bin.largest, bin.least]))
        });
        let positive = self.0.range(..NEGATIVE).flat_map(|(key, octave)| {
            let bins = octave.bins.iter();
            bins.map(|bin| filled(*key, bin.count, [bin.least, bin.largest]))
        });
        negative.chain(positive).filter(|bin| bin.count > 0)
    }

    /// The smallest and the largest number; `None` without numbers.
    pub(super) fn ends(&self) -> Option<(f64, f64)> {
        let mut filled = self.filled();
        let first = filled.next()?;
        let last = filled.last().unwrap_or(first);
        Some((first.least, last.largest))
    }

    /// Bounds of the smallest number that at least this part of all numbers, 0 to 1, do not exceed; `None` without numbers.
    pub(super) fn quantile(&self, part: f64) -> Option<(f64, f64)> {
        let wanted = part * self.count() as f64;
        let mut below = 0;
        self.filled().find_map(|bin| {
            let first = below + 1;
            below += bin.count;
            if (below as f64) < wanted {
                return None;
            }
            // The first number of the bin is the smallest, and its last the largest.
            if first as f64 >= wanted {
                Some((bin.least, bin.least))
            } else if ((below - 1) as f64) < wanted {
                Some((bin.largest, bin.largest))
            } else {
                Some((bin.least, bin.largest))
            }
        })
    }

    /// Counts over eighths of octaves, in ascending order, without empty bars: bounds towards and away from zero, and the count. Numbers
    /// too small for an octave form a single bar, without width if all are zero.
    pub(super) fn histogram(&self) -> Vec<(f64, f64, u64)> {
        let mut bars: Vec<(f64, f64, u64)> = Vec::new();
        for bin in self.filled() {
            let [near, far] = bar_of(&bin);
            match bars.last_mut() {
                Some((last, end, count)) if last.total_cmp(&near).is_eq() => {
                    *count += bin.count;
                    if far.abs() > end.abs() {
                        *end = far;
                    }
                }
                _ => bars.push((near, far, bin.count)),
            }
        }
        bars
    }
}

/// Bounds, towards and away from zero, of the bar that contains a bin.
fn bar_of(bin: &Filled) -> [f64; 2] {
    const STEP: u64 = 1 << (FRACTION_BITS - 3);
    let furthest = bin.least.abs().max(bin.largest.abs());
    let bounds = if furthest >= f64::MIN_POSITIVE {
        let edge = furthest.to_bits() & !(STEP - 1);
        [edge, edge + STEP].map(f64::from_bits)
    } else if furthest > 0.0 {
        [0.0, f64::MIN_POSITIVE]
    } else {
        [0.0, 0.0]
    };
    bounds.map(|bound| bound * bin.least.signum())
}

fn filled(key: u16, count: u64, ends: [u64; 2]) -> Filled {
    let number = |fraction| f64::from_bits((u64::from(key) << FRACTION_BITS) | fraction);
    let [least, largest] = ends.map(|fraction| number(fraction & FRACTION));
    Filled { count, least, largest }
}
