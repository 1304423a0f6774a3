//! Rules of codes and literature for the width of a gap: one table with the edition, the clause and the words of each.
//!
//! Displacements come from the time history. Behaviour and amplification factors (q, `C_d`, R, `I_e`), by which codes estimate such
//! displacements from elastic ones, do not apply.

use pounding_scene::Property;
use strum::EnumCount;

use crate::Separation;

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
    /// EN 1998-1:2004, 4.4.2.7.
    Eurocode8,
    /// ASCE/SEI 7-16, 12.12.3.
    Asce7,
    /// NTC 2018 of Italy, 7.2.1.
    Ntc2018,
    /// IS 1893 (Part 1):2016, 7.11.3; the halving for level floors, credited to Amendment 1, could not be confirmed.
    Is1893,
    /// TBDY 2018 of Turkey, 4.9.3.
    Tbdy2018,
    /// E.030 of Peru, 2018, art. 33.
    E030,
    /// GB 50011-2010, 6.1.4, for concrete frames at intensity 8.
    Gb50011,
}

/// What people see of a rule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RuleWords {
    /// Short name for tables.
    pub name: &'static str,
    /// Edition, in full.
    pub edition: &'static str,
    /// Clause; `None` for the literature.
    pub clause: Option<&'static str>,
    /// Word by which options choose the code; `None` for the literature, and for a clause that was not seen.
    pub code: Option<&'static str>,
    /// Name of the width in CSV and JSON.
    pub key: &'static str,
    /// The rule in a sentence of our own.
    pub says: &'static str,
    /// The rule as a formula of both displacements u or δ.
    pub form: &'static str,
    /// Factor for floors that are all level: the code accepts then that slabs meet.
    pub when_level: f64,
    /// Least number of events of which the code takes the mean; `None` if the largest counts always.
    pub mean_from: Option<usize>,
    /// Least number of events that the code asks for.
    pub least_events: usize,
}

/// Codes without a mean of several time histories.
const LITERATURE: RuleWords = RuleWords {
    name: "ABS",
    edition: "ABS",
    clause: None,
    code: None,
    key: "abs_m",
    says: "the sum of both displacements",
    form: "u₁ + u₂",
    when_level: 1.0,
    mean_from: None,
    least_events: 1,
};

/// The words of every rule, in the order of [`Rule`].
const WORDS: [RuleWords; Rule::COUNT] = [
    LITERATURE,
    RuleWords {
        name: "SRSS",
        edition: "SRSS",
        key: "srss_m",
        form: "√(u₁² + u₂²)",
        says: "the root of the sum of squares",
        ..LITERATURE
    },
    RuleWords {
        name: "DDC",
        edition: "DDC (Jeng, Kasai and Maison 1992)",
        key: "ddc_m",
        form: "√(u₁² + u₂² − 2ρ u₁ u₂)",
        says: "SRSS less the correlation of elastic periods and damping",
        ..LITERATURE
    },
    RuleWords {
        name: "EN 1998-1",
        edition: "EN 1998-1:2004",
        clause: Some("4.4.2.7"),
        code: Some("en-1998-1"),
        key: "eurocode_8_m",
        form: "√(u₁² + u₂²) on one property, u₁ + u₂ across a line; × 0.7 if floors are level",
        says: "SRSS on one property, the sum across a property line; 0.7 of it for level floors",
        when_level: 0.7,
        mean_from: Some(7),
        least_events: 3,
    },
    RuleWords {
        name: "ASCE 7-16",
        edition: "ASCE/SEI 7-16",
        clause: Some("12.12.3"),
        code: Some("asce-7-16"),
        key: "asce_7_m",
        form: "√(δ_M1² + δ_M2²) on one property, δ_M1 + δ_M2 across a line",
        says: "SRSS on one property, the sum across a property line",
        mean_from: Some(11),
        least_events: 11,
        ..LITERATURE
    },
    RuleWords {
        name: "NTC 2018",
        edition: "NTC 2018",
        clause: Some("7.2.1"),
        code: Some("ntc-2018"),
        key: "ntc_2018_m",
        form: "u₁ + u₂, at least h/100 · min(1, a_g S/(0.5 g))",
        says: "the sum; at least h/100 times a_g S/(0.5 g), which counts up to 1: that of the target spectrum of a code, or else the peak \
               ground acceleration of the record",
        mean_from: Some(7),
        least_events: 3,
        ..LITERATURE
    },
    RuleWords {
        name: "IS 1893",
        edition: "IS 1893 (Part 1):2016",
        clause: Some("clause not seen"),
        key: "is_1893_m",
        form: "R₁Δ₁ + R₂Δ₂, × 0.5 if floors are level",
        says: "the sum; half of it for level floors, which could not be confirmed",
        when_level: 0.5,
        ..LITERATURE
    },
    RuleWords {
        name: "TBDY 2018",
        edition: "TBDY 2018",
        clause: Some("4.9.3"),
        code: Some("tbdy-2018"),
        key: "tbdy_2018_m",
        form: "α √(u₁² + u₂²), α = 0.5, or 0.25 if floors are level; at least 30 mm, 10 mm more per 3 m above 6 m",
        says: "half of SRSS, a quarter for level floors; at least 30 mm, and 10 mm more for every 3 m above 6 m",
        when_level: 0.5,
        ..LITERATURE
    },
    RuleWords {
        name: "E.030",
        edition: "E.030 (2018)",
        clause: Some("art. 33"),
        code: Some("e-030"),
        key: "e_030_2018_m",
        form: "2/3 (u₁ + u₂), at least 30 mm and 0.006 h",
        says: "two thirds of the sum; at least 30 mm and 0.006 of the height",
        ..LITERATURE
    },
    RuleWords {
        name: "GB 50011",
        edition: "GB 50011-2010",
        clause: Some("6.1.4"),
        code: Some("gb-50011"),
        key: "gb_50011_m",
        form: "100 mm up to 15 m, 20 mm more per 3 m above",
        says: "by height alone, of concrete frames at intensity 8: 100 mm up to 15 m, and 20 mm more for every 3 m above",
        ..LITERATURE
    },
];

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
        Self::Ntc2018,
        Self::Is1893,
        Self::Tbdy2018,
        Self::E030,
        Self::Gb50011,
    ];

    /// The words of the rule.
    pub const fn words(self) -> RuleWords {
        WORDS[self as usize]
    }

    /// Whether the text of its clause could be read.
    pub fn is_seen(self) -> bool {
        let RuleWords { clause, code, .. } = self.words();
        clause.is_none() || code.is_some()
    }

    /// Finds the rule of a code by the word of options.
    ///
    /// # Errors
    /// The words that are allowed.
    pub fn of_code(word: &str) -> Result<Self, String> {
        let mut all = Self::ALL.into_iter();
        all.find(|rule| rule.words().code == Some(word)).ok_or_else(|| {
            let words: Vec<&str> = Self::ALL.iter().filter_map(|rule| rule.words().code).collect();
            format!("allowed are {}", words.join(", "))
        })
    }

    /// Name for tables.
    pub fn name(self) -> &'static str {
        self.words().name
    }

    /// Name of the width in CSV and JSON.
    pub fn key(self) -> &'static str {
        self.words().key
    }

    /// Edition and clause, such as "EN 1998-1:2004, 4.4.2.7".
    pub fn cited(self) -> String {
        let RuleWords { edition, clause, .. } = self.words();
        clause.map_or_else(|| edition.into(), |clause| format!("{edition}, {clause}"))
    }

    /// Returns the width by the rule \[m\]; `None` if the rule needs heights that the scene does not give, and beside a building on
    /// isolators for all but the sum of both peaks: rules for joints do not size a moat, and DDC takes periods before yielding.
    pub fn width(self, separation: &Separation) -> Option<f64> {
        if separation.isolated && self != Self::Abs {
            return None;
        }
        let [left, right] = separation.peaks;
        let sum = left + right;
        let srss = (left * left + right * right).sqrt();
        let to_the_line = match separation.property {
            Property::Same => srss,
            Property::Other => sum,
        };
        let factor = if separation.level { self.words().when_level } else { 1.0 };
        match self {
            Self::Abs => Some(sum),
            Self::Srss => Some(srss),
            Self::Eurocode8 | Self::Asce7 => Some(factor * to_the_line),
            Self::Ddc => {
                let correlation = correlation(separation.oscillations);
                let square = left * left + right * right - 2.0 * correlation * left * right;
                // For equal neighbours the square is 0; rounding may make it negative.
                Some(square.max(0.0).sqrt())
            }
            Self::Ntc2018 => {
                let [level, _] = separation.heights?;
                Some(sum.max(0.01 * level * (separation.pga_g / 0.5).min(1.0)))
            }
            Self::Is1893 => Some(factor * sum),
            Self::Tbdy2018 => {
                let [_, building] = separation.heights?;
                let steps = ((building - 6.0).max(0.0) / 3.0).floor();
                Some((factor * 0.5 * srss).max(0.03 + 0.01 * steps))
            }
            Self::E030 => {
                let [level, _] = separation.heights?;
                Some((sum * 2.0 / 3.0).max(0.006 * level).max(0.03))
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

#[cfg(test)]
mod tests {
    use pounding_scene::Property;

    use super::{Rule, Separation};

    /// A gap on one property between buildings with these peaks \[m\].
    fn gap(peaks: [f64; 2]) -> Separation {
        Separation {
            left: 0,
            at_level: 1,
            at_column: false,
            required: 0.0,
            time: 0.0,
            peaks,
            oscillations: [None; 2],
            level: false,
            isolated: false,
            beside_columns: None,
            heights: None,
            property: Property::Same,
            pga_g: 0.0,
        }
    }

    /// Widths \[mm\] for floors that are not level and for level floors, with these peaks and heights \[m\].
    fn widths(rule: Rule, peaks: [f64; 2], heights: [f64; 2]) -> String {
        let width = |level: bool| {
            let separation = Separation {
                level,
                heights: Some(heights),
                ..gap(peaks)
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

    /// SRSS was given for any two buildings. To a property line each keeps its own displacement: EN 1998-1:2004, 4.4.2.7 (2), and
    /// ASCE/SEI 7-16, 12.12.3.
    #[test]
    fn issue_across_a_property_line_displacements_add_up() {
        let other = Separation {
            property: Property::Other,
            ..gap([0.06, 0.08])
        };
        let width = |rule: Rule, level: bool| rule.width(&Separation { level, ..other }).expect("a width");
        for (rule, level, wanted) in [
            (Rule::Eurocode8, false, 0.14),
            (Rule::Eurocode8, true, 0.098),
            (Rule::Asce7, true, 0.14),
            (Rule::Srss, true, 0.1),
        ] {
            assert!((width(rule, level) - wanted).abs() < 1e-15, "{rule:?} {level}");
        }
        assert_eq!(Property::default(), Property::Other);
    }

    /// NTC 2018, 7.2.1: the sum of 60 and 80 mm; at 27 m and 0.3 g 27/100 times 0.6 are 162 mm.
    #[test]
    fn reference_ntc_2018() {
        let of = |level: f64| {
            let one = Separation {
                heights: Some([level, 30.0]),
                pga_g: 0.3,
                ..gap([0.06, 0.08])
            };
            Rule::Ntc2018.width(&one).expect("heights are given")
        };
        assert!((of(3.0) - 0.14).abs() < 1e-15 && (of(27.0) - 0.162).abs() < 1e-15);
    }

    /// A rule whose text could not be read is no choice of an option.
    #[test]
    fn limit_a_clause_that_was_not_seen_is_no_code() {
        let words = |rule: &Rule| (rule.words().clause, rule.words().code);
        for rule in &Rule::ALL {
            let (clause, code) = words(rule);
            assert_eq!(Rule::ALL[*rule as usize], *rule, "the order of the table");
            assert_eq!(code.is_some(), clause.is_some_and(|clause| clause != "clause not seen"), "{rule:?}");
        }
        assert_eq!(Rule::of_code("ntc-2018"), Ok(Rule::Ntc2018));
        assert!(Rule::of_code("is-1893").is_err_and(|said| said.contains("en-1998-1, asce-7-16")));
    }

    /// A moat was offered 100 mm by GB 50011 and 100.2 mm by TBDY, rules for joints between buildings.
    #[test]
    fn issue_rules_for_joints_do_not_size_a_moat() {
        let moat = Separation {
            isolated: true,
            heights: Some([0.5, 13.3]),
            ..gap([0.0, 0.2])
        };
        let given: Vec<_> = Rule::ALL.into_iter().filter(|rule| rule.width(&moat).is_some()).collect();
        assert_eq!(given, [Rule::Abs]);
    }

    #[test]
    fn limit_rules_of_heights_ask_for_them() {
        let unknown = gap([0.1; 2]);
        let silent: Vec<_> = Rule::ALL.into_iter().filter(|rule| rule.width(&unknown).is_none()).collect();
        assert_eq!(silent, [Rule::Ntc2018, Rule::Tbdy2018, Rule::E030, Rule::Gb50011]);
    }
}
