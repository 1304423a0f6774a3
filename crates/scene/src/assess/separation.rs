//! The width that the gaps of a row need, and what the rules of codes and literature ask for.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use pounding_solver::Closing;
use strum::EnumCount;

use crate::simulation::Extras;
use crate::{Contact, Error, Excess, Floors, Method, RunResult, Scene, Simulation};

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
    /// Whether floors of both stand equally high up to the lower roof, by the heights that the scene gives, whichever may touch.
    pub level: bool,
    /// Width that keeps floors of both from columns of the other \[m\], by the sum of both peaks; `None` if no floor faces a column.
    pub beside_columns: Option<f64>,
    /// Height of that level, and of the lower of both buildings \[m\], where the scene gives them.
    pub heights: Option<[f64; 2]>,
}

/// Part of what is required that is not known: looks at a motion leave out 1e-12 of its terms, fewer looks at long series more.
const LOOKED: f64 = 1e-8;

impl Separation {
    /// Whether a width \[m\] is less than what is required, by more than that is known to.
    pub fn asks_for_more(&self, width: f64) -> bool {
        width < self.required * (1.0 - LOOKED)
    }
}

/// A gap that no usual start of a scene closes, and that is not unusual itself \[m\].
const WIDE: f64 = 2.0;

impl Scene {
    /// The same row with wide gaps, by the exact method: to ask which gaps it needs. What does not matter then is neither refused nor
    /// searched for.
    #[must_use]
    pub fn apart(&self) -> Self {
        let wide = |one: &Contact| Contact {
            gap_m: one.gap_m.max(WIDE),
            ..one.clone()
        };
        let contacts = self.contacts.as_ref();
        Self {
            contacts: contacts.map(|all| all.iter().map(wide).collect()),
            method: Method::EXACT,
            ..self.clone()
        }
    }
}

/// A rule for the width of a gap.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount)]
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
    /// ASCE 7-16, 12.12.3: the root of the sum of squares of the inelastic displacements; so do NBCC 2015, 4.1.8.14, and UBC 1997,
    /// 1633.2.11.
    Asce7,
    /// IS 1893 (Part 1):2016, 7.11.3 with Amendment 1: the sum of the inelastic displacements, half of it where floors are level.
    Is1893,
    /// TBDY 2018, 4.9.3: half the root of the sum of squares of the inelastic displacements, a quarter where floors are level; at
    /// least 30 mm, and from a height of 6 m on 10 mm more for every 3 m.
    Tbdy2018,
    /// E.030 of Peru, 2018, art. 33: two thirds of the sum of the inelastic displacements; at least 30 mm and 0.006 of the height.
    E030,
    /// GB 50011-2010, 6.1.4, of concrete frames at intensity 8: 100 mm up to a height of 15 m, and 20 mm more for every 3 m beyond.
    Gb50011,
}

impl Rule {
    /// Those of the literature and the codes that most ask for, which need no heights.
    pub const COMMON: [Self; 5] = [Self::Abs, Self::Srss, Self::Ddc, Self::Eurocode8, Self::Asce7];

    /// All of them.
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

    /// Name of its width in CSV and JSON.
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

    /// The width that the rule asks for \[m\]; `None` if it asks for heights that the scene does not give.
    ///
    /// Displacements are those of the time history itself: behaviour and amplification factors of the codes, by which they
    /// come to such displacements, have no place here.
    pub fn width(self, separation: &Separation) -> Option<f64> {
        let [left, right] = separation.peaks;
        let srss = (left * left + right * right).sqrt();
        let when_level = |factor: f64| if separation.level { factor } else { 1.0 };
        match self {
            Self::Abs => Some(left + right),
            Self::Eurocode8 => Some(when_level(0.7) * srss),
            Self::Srss | Self::Asce7 => Some(srss),
            Self::Ddc => {
                let correlation = correlation(separation.oscillations);
                let square = left * left + right * right - 2.0 * correlation * left * right;
                // Like neighbours move alike; rounding may leave less than nothing.
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
    let below = apart * apart + 4.0 * product * ratio * (1.0 + ratio * ratio) + 4.0 * squares * ratio * ratio;
    if below > 0.0 { above / below } else { 1.0 }
}

impl Simulation {
    /// For every two neighbours but two walls, the width that keeps them apart under this record and direction; by the
    /// exact method.
    ///
    /// Gaps and contact laws of the scene do not matter: wide enough gaps leave every structure alone.
    ///
    /// # Errors
    /// As of [`run_with`](Self::run_with).
    pub fn separations(&self) -> Result<Vec<Separation>, Error> {
        Ok(self.judged_separations()?.0)
    }

    /// The same with what the motion of the structures alone is beyond its model, or codes allow.
    ///
    /// # Errors
    /// As of [`run_with`](Self::run_with).
    pub fn judged_separations(&self) -> Result<(Vec<Separation>, Vec<Excess>), Error> {
        let apart = self.apart()?.exact()?;
        let asked = Extras {
            closings: true,
            ..Extras::default()
        };
        let alone = apart.run_with(asked)?;
        let closings = alone.closings.as_ref();
        let separations = separations_of(&apart, &alone, |left| closings?.of(left));
        Ok((separations, apart.excesses(&alone)))
    }
}

/// The same from a run of the row apart, and how far each floor comes towards its right neighbour.
pub(super) fn separations_of(apart: &Simulation, alone: &RunResult, closing: impl Fn(usize) -> Option<Closing>) -> Vec<Separation> {
    let floors = apart.floors();
    let mut widest: BTreeMap<usize, Separation> = BTreeMap::new();
    let beside_columns = apart.beside_columns(alone);
    for (left, one, other) in floors.all_facing() {
        let Some(closing) = closing(one) else {
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
            peaks: [one, other].map(|index| alone.peaks.of(index).displacement.value.abs()),
            level: floors.are_level(left),
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

/// Height of the level of two floors, and that of the lower of their buildings \[m\]; walls have no height of their own.
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

    /// Widths \[mm\], of floors that are not level and of level ones, for these peaks and heights \[m\].
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
            beside_columns: None,
            heights: None,
        };
        let silent: Vec<_> = Rule::ALL.into_iter().filter(|rule| rule.width(&unknown).is_none()).collect();
        assert_eq!(silent, [Rule::Tbdy2018, Rule::E030, Rule::Gb50011]);
    }
}
