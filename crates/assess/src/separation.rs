//! Required widths of the gaps of a row, and widths by the rules of codes and literature.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use pounding_scene::{Error, Excess, Extras, Floors, RunResult, Simulation};
use pounding_solver::Closing;
use strum::EnumCount;

/// Required width of one gap under one record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Index of the structure on the left.
    pub left: usize,
    /// Level of the floors that need the largest width, counted from 1 for the lowest, like `levels` of contacts.
    pub at_level: usize,
    /// Width below which the neighbours touch \[m\]: the largest closing of the gap at that level while every structure stands alone.
    pub required: f64,
    /// Instant of the largest closing \[s\].
    pub time: f64,
    /// Largest displacement of each neighbour standing alone \[m\], without sign.
    pub peaks: [f64; 2],
    /// Natural period \[s\] and damping ratio of each neighbour; `None` for a wall.
    pub oscillations: [Option<(f64, f64)>; 2],
    /// Whether the floors of both neighbours are level up to the lower roof, by the heights in the scene; floors that may not touch count,
    /// too.
    pub level: bool,
    /// Whether a neighbour is told to stand on isolators: rules for joints between buildings do not size its moat.
    pub isolated: bool,
    /// Width that keeps the floors of each neighbour from the columns of the other \[m\], by the sum of both peaks; `None` if no floor
    /// faces a column.
    pub beside_columns: Option<f64>,
    /// Height of that level, and of the lower of both buildings \[m\]; `None` if the scene does not give them.
    pub heights: Option<[f64; 2]>,
}

/// Relative uncertainty of the required width \[–\]: the search for the largest closing leaves out terms of 1e-12, and more in long series.
const LOOKED: f64 = 1e-8;

impl Separation {
    /// Returns the required width of every gap under the record of a simulation, by the exact method. Two adjacent walls have no gap.
    ///
    /// Gaps and contact laws of the scene do not matter: every structure moves alone.
    ///
    /// # Errors
    /// Errors of [`Simulation::run_with`].
    pub fn of(simulation: &Simulation) -> Result<Vec<Self>, Error> {
        Ok(Self::judged(simulation)?.0)
    }

    /// Returns the [required widths](Self::of), and the responses of the structures alone that exceed their model or the limits of codes.
    ///
    /// # Errors
    /// Errors of [`Simulation::run_with`].
    pub fn judged(simulation: &Simulation) -> Result<(Vec<Self>, Vec<Excess>), Error> {
        let apart = simulation.apart()?.exact()?;
        let asked = Extras {
            closings: true,
            ..Extras::default()
        };
        let alone = apart.run_with(asked)?;
        let closings = alone.closings.as_ref();
        let separations = Self::all(&apart, &alone, |left| closings?.of(left));
        Ok((separations, apart.excesses(&alone)))
    }

    /// Returns the required width of every gap, from a run of the row alone and the closing of each floor towards its right neighbour.
    pub(crate) fn all(apart: &Simulation, alone: &RunResult, closing: impl Fn(usize) -> Option<Closing>) -> Vec<Self> {
        let floors = apart.floors();
        let mut widest: BTreeMap<usize, Self> = BTreeMap::new();
        let beside_columns = apart.beside_columns(alone);
        for (left, one, other) in floors.all_facing() {
            let Some(closing) = closing(one) else {
                continue;
            };
            // Neighbours that start apart and only move further apart need no gap.
            let (required, time) = if closing.distance > 0.0 {
                (closing.distance, closing.time)
            } else {
                (0.0, 0.0)
            };
            let sides = [one, other].map(|index| &floors.all()[index]);
            let at_level = Self {
                left,
                at_level: floors.levels().level(one) + 1,
                required,
                time,
                peaks: [one, other].map(|index| alone.peaks.of(index).displacement.value.abs()),
                level: floors.are_level(left),
                isolated: [left, left + 1].into_iter().any(|one| floors.is_isolated(one)),
                beside_columns: beside_columns.get(&left).copied(),
                oscillations: sides.map(|floor| floor.oscillation(apart.scene())),
                heights: heights(floors, [one, other]),
            };
            match widest.entry(left) {
                Entry::Vacant(entry) => {
                    entry.insert(at_level);
                }
                Entry::Occupied(mut entry) => {
                    let so_far = entry.get_mut();
                    if at_level.required > so_far.required {
                        *so_far = at_level;
                    }
                }
            }
        }
        widest.into_values().collect()
    }

    /// Whether a width \[m\] is less than the required width, by more than its uncertainty.
    pub fn asks_for_more(&self, width: f64) -> bool {
        width < self.required * (1.0 - LOOKED)
    }
}

/// A rule for the width of a gap.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount)]
pub enum Rule {
    /// Sum of both peak displacements.
    Abs,
    /// Square root of the sum of the squares of both peak displacements.
    Srss,
    /// Double difference combination: the square root of u₁² + u₂² − 2ρu₁u₂, with the correlation ρ of two oscillators under white noise.
    /// It takes elastic periods and damping even if columns yield (V. Jeng, K. Kasai and B. F. Maison, *Earthquake Spectra* 8 (1992) 201).
    Ddc,
    /// EN 1998-1, 4.4.2.7: the square root of the sum of squares, times 0.7 if floors are level.
    Eurocode8,
    /// ASCE 7-16, 12.12.3: the square root of the sum of squares of the inelastic displacements, as in NBCC 2015, 4.1.8.14, and UBC 1997,
    /// 1633.2.11.
    Asce7,
    /// IS 1893 (Part 1):2016, 7.11.3 with Amendment 1: the sum of the inelastic displacements, halved if floors are level.
    Is1893,
    /// TBDY 2018, 4.9.3: half the square root of the sum of squares of the inelastic displacements, a quarter if floors are level. At least
    /// 30 mm, and 10 mm more for every 3 m of height above 6 m.
    Tbdy2018,
    /// E.030 of Peru, 2018, art. 33: two thirds of the sum of the inelastic displacements; at least 30 mm and 0.006 of the height.
    E030,
    /// GB 50011-2010, 6.1.4, for concrete frames at intensity 8: 100 mm up to a height of 15 m, and 20 mm more for every 3 m above.
    Gb50011,
}

impl Rule {
    /// Rules of the literature and of widely used codes that need no heights.
    pub const COMMON: [Self; 5] = [Self::Abs, Self::Srss, Self::Ddc, Self::Eurocode8, Self::Asce7];

    /// Every rule.
    pub const ALL: [Self; Self::COUNT] = [
        Self::Abs,
        Self::Srss,
        Self::Ddc,
        Self::Eurocode8,
        Self::Asce7,
        Self::Is1893,
        Self::Tbdy2018,
        Self::E030,
        Self::Gb50011,
    ];

    /// Name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Abs => "ABS",
            Self::Srss => "SRSS",
            Self::Ddc => "DDC",
            Self::Eurocode8 => "EC 8",
            Self::Asce7 => "ASCE 7",
            Self::Is1893 => "IS 1893",
            Self::Tbdy2018 => "TBDY",
            Self::E030 => "E.030",
            Self::Gb50011 => "GB 50011",
        }
    }

    /// Name of the width in CSV and JSON.
    pub fn key(self) -> &'static str {
        match self {
            Self::Abs => "abs_m",
            Self::Srss => "srss_m",
            Self::Ddc => "ddc_m",
            Self::Eurocode8 => "eurocode_8_m",
            Self::Asce7 => "asce_7_m",
            Self::Is1893 => "is_1893_m",
            Self::Tbdy2018 => "tbdy_2018_m",
            Self::E030 => "e_030_2018_m",
            Self::Gb50011 => "gb_50011_m",
        }
    }

    /// Returns the width by the rule \[m\]; `None` if the rule needs heights that the scene does not give, and beside a building on
    /// isolators for all but the sum of both peaks: rules for joints do not size a moat, and DDC takes periods before yielding.
    ///
    /// Displacements come from the time history. Behaviour and amplification factors, by which codes estimate such displacements, do not
    /// apply.
    pub fn width(self, separation: &Separation) -> Option<f64> {
        let [left, right] = separation.peaks;
        if separation.isolated && self != Self::Abs {
            return None;
        }
        let srss = (left * left + right * right).sqrt();
        let when_level = |factor: f64| if separation.level { factor } else { 1.0 };
        match self {
            Self::Abs => Some(left + right),
            Self::Eurocode8 => Some(when_level(0.7) * srss),
            Self::Srss | Self::Asce7 => Some(srss),
            Self::Ddc => {
                let correlation = correlation(separation.oscillations);
                let square = left * left + right * right - 2.0 * correlation * left * right;
                // For equal neighbours the square is 0; rounding may make it negative.
                Some(square.max(0.0).sqrt())
            }
            Self::Is1893 => Some(when_level(0.5) * (left + right)),
            Self::Tbdy2018 => {
                let [_, building] = separation.heights?;
                let steps = ((building - 6.0).max(0.0) / 3.0).floor();
                Some((when_level(0.5) * 0.5 * srss).max(0.03 + 0.01 * steps))
            }
            Self::E030 => {
                let [level, _] = separation.heights?;
                Some(((left + right) * 2.0 / 3.0).max(0.006 * level).max(0.03))
            }
            Self::Gb50011 => {
                let [_, building] = separation.heights?;
                Some(0.1 + 0.02 * (building - 15.0).max(0.0) / 3.0)
            }
        }
    }
}

/// Correlation ρ \[–\] of the responses of two oscillators, as in the complete quadratic combination. It is 0 beside a wall; without
/// damping it is 0 unless the periods are equal.
fn correlation(oscillations: [Option<(f64, f64)>; 2]) -> f64 {
    let [Some((left, of_left)), Some((right, of_right))] = oscillations else {
        return 0.0;
    };
    let ratio = left / right;
    let product = of_left * of_right;
    let above = 8.0 * product.sqrt() * (of_left + ratio * of_right) * ratio * ratio.sqrt();
    let apart = 1.0 - ratio * ratio;
    let squares = of_left * of_left + of_right * of_right;
    let below = apart * apart + 4.0 * product * ratio * (1.0 + ratio * ratio) + 4.0 * squares * ratio * ratio;
    if below > 0.0 { above / below } else { 1.0 }
}

/// Height of the level of two floors, and height of the lower of their buildings \[m\]; walls have no height.
fn heights(floors: &Floors, sides: [usize; 2]) -> Option<[f64; 2]> {
    let moves = sides.iter().filter(|side| !floors.all()[**side].is_wall());
    let roof = |side: usize| {
        let structure = floors.all()[side].structure;
        let roof = floors.of_structure(structure).last()?;
        floors.all()[*roof].elevation_m
    };
    let mut least = [f64::INFINITY; 2];
    for side in moves {
        least[0] = least[0].min(floors.all()[*side].elevation_m?);
        least[1] = least[1].min(roof(*side)?);
    }
    least[0].is_finite().then_some(least)
}

#[cfg(test)]
mod tests {
    use super::{Rule, Separation};

    /// Widths \[mm\] for floors that are not level and for level floors, with these peaks and heights \[m\].
    fn widths(rule: Rule, peaks: [f64; 2], heights: [f64; 2]) -> String {
        let width = |level: bool| {
            let separation = Separation {
                left: 0,
                at_level: 1,
                required: 0.0,
                time: 0.0,
                peaks,
                oscillations: [None; 2],
                level,
                isolated: false,
                beside_columns: None,
                heights: Some(heights),
            };
            format!("{:.1}", 1e3 * rule.width(&separation).expect("heights are given"))
        };
        format!("{} {}", width(false), width(true))
    }

    /// ASCE 7-16, 12.12.3: a factor of 5.5 times 20 and 15 mm. EN 1998-1, 4.4.2.7: 60 and 80 mm.
    #[test]
    fn reference_asce_7_and_eurocode_8() {
        assert_eq!(widths(Rule::Asce7, [0.11, 0.0825], [3.0; 2]), "137.5 137.5");
        assert_eq!(widths(Rule::Eurocode8, [0.06, 0.08], [3.0; 2]), "100.0 70.0");
    }

    /// IS 1893 (Part 1):2016, 7.11.3: R = 5 times 4 mm beside R = 4 times 3 mm.
    #[test]
    fn reference_is_1893() {
        assert_eq!(widths(Rule::Is1893, [0.02, 0.012], [3.6; 2]), "32.0 16.0");
    }

    /// TBDY 2018, 4.9.3: reduced displacements of 18 and 24 mm and R = 8 are 144 and 192 mm; the least gap at 12 and 18 m.
    #[test]
    fn reference_tbdy_2018() {
        assert_eq!(widths(Rule::Tbdy2018, [0.144, 0.192], [12.0; 2]), "120.0 60.0");
        assert_eq!(widths(Rule::Tbdy2018, [0.01; 2], [12.0; 2]), "50.0 50.0");
        assert_eq!(widths(Rule::Tbdy2018, [0.01; 2], [18.0; 2]), "70.0 70.0");
        assert_eq!(widths(Rule::Tbdy2018, [0.01; 2], [5.0; 2]), "30.0 30.0");
    }

    /// E.030 (2018), art. 33: 90 and 60 mm at 18 m, where 0.006 h decides, and at 4 m.
    #[test]
    fn reference_e_030() {
        assert_eq!(widths(Rule::E030, [0.09, 0.06], [18.0; 2]), "108.0 108.0");
        assert_eq!(widths(Rule::E030, [0.09, 0.06], [4.0; 2]), "100.0 100.0");
        assert_eq!(widths(Rule::E030, [0.01, 0.01], [4.0; 2]), "30.0 30.0");
    }

    /// GB 50011-2010, 6.1.4, frames at intensity 8: 100 mm at 15 m, 200 mm at 30 m.
    #[test]
    fn reference_gb_50011() {
        assert_eq!(widths(Rule::Gb50011, [0.0; 2], [3.0, 12.0]), "100.0 100.0");
        assert_eq!(widths(Rule::Gb50011, [0.0; 2], [3.0, 30.0]), "200.0 200.0");
    }

    #[test]
    fn limit_rules_of_heights_ask_for_them() {
        let unknown = Separation {
            left: 0,
            at_level: 1,
            required: 0.0,
            time: 0.0,
            peaks: [0.1; 2],
            oscillations: [None; 2],
            level: false,
            isolated: false,
            beside_columns: None,
            heights: None,
        };
        let silent: Vec<_> = Rule::ALL.into_iter().filter(|rule| rule.width(&unknown).is_none()).collect();
        assert_eq!(silent, [Rule::Tbdy2018, Rule::E030, Rule::Gb50011]);
    }

    /// A moat was offered 100 mm by GB 50011 and 100.2 mm by TBDY, rules for joints between buildings.
    #[test]
    fn issue_rules_for_joints_do_not_size_a_moat() {
        let moat = Separation {
            left: 0,
            at_level: 1,
            required: 0.2,
            time: 1.0,
            peaks: [0.0, 0.2],
            oscillations: [None; 2],
            level: true,
            isolated: true,
            beside_columns: None,
            heights: Some([0.5, 13.3]),
        };
        let given: Vec<_> = Rule::ALL.into_iter().filter(|rule| rule.width(&moat).is_some()).collect();
        assert_eq!(given, [Rule::Abs]);
    }
}
