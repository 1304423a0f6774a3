//! Elastic design spectra of codes, and spectra from a table.

use std::fmt;
use std::path::Path;
use std::str::FromStr;

use pounding_scene::STANDARD_GRAVITY;
use pounding_text::{CurveWords, Refused, curve_points, digits, short};

/// A spectrum of accelerations.
#[derive(Debug, Clone, PartialEq)]
pub enum DesignSpectrum {
    /// Elastic response spectrum of EN 1998-1:2004, 3.2.2.2, for 5 % of damping.
    Eurocode8 {
        /// Design ground acceleration on ground A, `a_g` \[g\], > 0.
        ground_acceleration: f64,
        /// Corner values of the ground type.
        ground: Eurocode8Ground,
    },
    /// Design response spectrum of ASCE 7-16, 11.4.6.
    Asce7 {
        /// `S_DS` \[g\], > 0.
        short: f64,
        /// `S_D1` \[g\], > 0.
        one_second: f64,
        /// Long-period transition period `T_L` \[s\], > 0.
        long_period: f64,
    },
    /// Points of period \[s\] and acceleration \[g\], in rising order of periods; linear between them and constant beyond.
    Table(Vec<[f64; 2]>),
}

/// Soil factor S \[–\] and corner periods `T_B`, `T_C`, `T_D` \[s\] of a ground type: EN 1998-1:2004, tables 3.2 and 3.3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eurocode8Ground {
    /// Ground type, and type of spectrum.
    names: [char; 2],
    soil: f64,
    corners: [f64; 3],
}

impl DesignSpectrum {
    /// Spectral acceleration \[g\] at a period ≥ 0 \[s\].
    pub fn acceleration(&self, period: f64) -> f64 {
        match self {
            Self::Eurocode8 {
                ground_acceleration,
                ground,
            } => ground_acceleration * ground.amplification(period),
            Self::Asce7 {
                short,
                one_second,
                long_period,
            } => {
                let end = one_second / short;
                let start = 0.2 * end;
                if period < start {
                    short * (0.4 + 0.6 * period / start)
                } else if period <= end {
                    *short
                } else if period <= *long_period {
                    one_second / period
                } else {
                    one_second * long_period / (period * period)
                }
            }
            Self::Table(points) => between(points, period),
        }
    }

    /// Ground acceleration of the spectrum of a code \[g\], such as `a_g` S of EN 1998-1; `None` of a table, which may begin anywhere.
    pub fn ground_acceleration(&self) -> Option<f64> {
        match self {
            Self::Eurocode8 { .. } | Self::Asce7 { .. } => Some(self.acceleration(0.0)),
            Self::Table(_) => None,
        }
    }

    /// Reads an acceleration > 0 with its unit, `0.25g` or `2.45m/s2`, and returns it in g; `None` for any other text, such as a number
    /// without a unit.
    pub fn in_g(text: &str) -> Option<f64> {
        let text = text.trim();
        let metres = text.strip_suffix("m/s2").or(text.strip_suffix("m/s²"));
        let (number, unit) = match metres {
            Some(number) => (number, STANDARD_GRAVITY),
            None => (text.strip_suffix('g')?, 1.0),
        };
        let number: f64 = number.trim().parse().ok()?;
        (number > 0.0 && number.is_finite()).then_some(number / unit)
    }

    /// Periods at which the spectrum bends \[s\].
    pub(crate) fn corners(&self) -> Vec<f64> {
        match self {
            Self::Eurocode8 { ground, .. } => ground.corners.to_vec(),
            Self::Asce7 {
                short,
                one_second,
                long_period,
            } => vec![0.2 * one_second / short, one_second / short, *long_period],
            Self::Table(points) => points.iter().map(|point| point[0]).collect(),
        }
    }

    /// Returns the spectrum of a code, such as `ec8:a_g=0.25g,ground=C`, or of a CSV file with periods in s and accelerations in g.
    ///
    /// # Errors
    /// Refuses an unknown code or setting, and a file that is not such a table.
    pub fn named(text: &str) -> Result<Self, Refused> {
        let is_code = ["ec8:", "asce7:"].iter().any(|code| text.starts_with(code));
        let path = Path::new(text);
        if is_code || !path.is_file() {
            return text.parse();
        }
        let unreadable = |error: std::io::Error| Refused::unreadable(path, &error);
        let read = pounding_scene::file::bytes(path).map_err(unreadable)?;
        let read = String::from_utf8(read).map_err(|error| unreadable(std::io::Error::other(error)))?;
        Self::table(&read).map_err(|refused| refused.in_file(path))
    }

    /// Reads the table of a file. Each line has a period \[s\] and an acceleration \[g\], separated by commas, semicolons or blanks. It
    /// skips a heading in the first line and lines that begin with #.
    ///
    /// # Errors
    /// Refuses the first line that is not a point, and a file without points.
    pub fn table(text: &str) -> Result<Self, Refused> {
        let words = CurveWords {
            place: "target",
            allowed: "a period in s and an acceleration in g, periods rising",
        };
        let rises = |last: Option<[f64; 2]>, [period, acceleration]: [f64; 2]| {
            period >= 0.0 && acceleration > 0.0 && last.is_none_or(|[before, _]| period > before)
        };
        let points = curve_points(text, words, rises)?;
        if points.is_empty() {
            return Err(unknown("a file without numbers"));
        }
        Ok(Self::Table(points))
    }
}

impl Eurocode8Ground {
    /// Values of a ground type A to E, for the spectrum of type 1 or 2; `None` for any other.
    fn of(ground: &str, kind: &str) -> Option<Self> {
        let (soil, corners) = match (kind, ground) {
            ("1", "A") => (1.0, [0.15, 0.4, 2.0]),
            ("1", "B") => (1.2, [0.15, 0.5, 2.0]),
            ("1", "C") => (1.15, [0.2, 0.6, 2.0]),
            ("1", "D") => (1.35, [0.2, 0.8, 2.0]),
            ("1", "E") => (1.4, [0.15, 0.5, 2.0]),
            ("2", "A") => (1.0, [0.05, 0.25, 1.2]),
            ("2", "B") => (1.35, [0.05, 0.25, 1.2]),
            ("2", "C") => (1.5, [0.1, 0.25, 1.2]),
            ("2", "D") => (1.8, [0.1, 0.3, 1.2]),
            ("2", "E") => (1.6, [0.05, 0.25, 1.2]),
            _ => return None,
        };
        let [ground, kind] = [ground, kind].map(|name| name.chars().next());
        Some(Self {
            names: [ground?, kind?],
            soil,
            corners,
        })
    }

    /// Ratio of spectral to ground acceleration \[–\], for 5 % of damping.
    fn amplification(&self, period: f64) -> f64 {
        let [begin, end, long] = self.corners;
        let plateau = 2.5 * self.soil;
        if period < begin {
            self.soil * (1.0 + 1.5 * period / begin)
        } else if period <= end {
            plateau
        } else if period <= long {
            plateau * end / period
        } else {
            plateau * end * long / (period * period)
        }
    }
}

impl fmt::Display for DesignSpectrum {
    /// Describes the spectrum in words.
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Eurocode8 {
                ground_acceleration,
                ground:
                    Eurocode8Ground {
                        names: [ground, kind],
                        soil,
                        corners,
                    },
            } => write!(
                to,
                "EN 1998-1, type {kind}, ground {ground}, with a_g = {} g = {} m/s², S = {}, T_B, T_C, T_D = {} s",
                digits(*ground_acceleration),
                short(ground_acceleration * STANDARD_GRAVITY),
                digits(*soil),
                corners.map(digits).join(", ")
            ),
            Self::Asce7 {
                short,
                one_second,
                long_period,
            } => write!(
                to,
                "ASCE 7-16 with S_DS = {} g, S_D1 = {} g, T_L = {} s",
                digits(*short),
                digits(*one_second),
                digits(*long_period)
            ),
            Self::Table(points) => {
                let largest = points.iter().map(|point| point[1]).fold(0.0, f64::max);
                let [first, last] = [points[0][0], points[points.len() - 1][0]];
                write!(
                    to,
                    "a table, {} to {} s, at most {} g",
                    digits(first),
                    digits(last),
                    digits(largest)
                )
            }
        }
    }
}

/// Value of a table at a period, linear between its points.
fn between(points: &[[f64; 2]], period: f64) -> f64 {
    let above = points.iter().position(|point| point[0] >= period);
    match above {
        Some(0) => points[0][1],
        None => points[points.len() - 1][1],
        Some(above) => {
            let [[from, low], [to, high]] = [points[above - 1], points[above]];
            low + (high - low) * (period - from) / (to - from)
        }
    }
}

/// Name of a setting of the spectrum in messages.
fn in_target(field: &str) -> String {
    format!("target: {field}")
}

/// Refuses a text that is neither a known code nor a table.
fn unknown(found: &str) -> Refused {
    Refused::at("target").found(format!("\"{found}\"")).allowed_are(
        "\"ec8:a_g=0.25g,ground=C\" (and type=2), \"asce7:s_ds=1.0,s_d1=0.6,t_l=8\" and a CSV file of periods in s and accelerations \
         in g",
    )
}

/// Settings such as `a_g=0.25g,ground=C`.
struct SpectrumSettings<'a>(Vec<(&'a str, &'a str)>);

impl<'a> SpectrumSettings<'a> {
    fn of(text: &'a str, known: &[&str]) -> Result<Self, Refused> {
        let setting = |one: &'a str| {
            let (field, value) = one.split_once('=').unwrap_or((one, ""));
            (field.trim(), value.trim())
        };
        let all: Vec<_> = text.split(',').map(setting).collect();
        match all.iter().find(|(field, _)| !known.contains(field)) {
            Some((field, value)) => Err(Refused::at(in_target(field))
                .found(if value.is_empty() {
                    (*field).to_owned()
                } else {
                    (*value).to_owned()
                })
                .allowed_are("a_g, ground and type after ec8:, and s_ds, s_d1 and t_l after asce7:")),
            None => Ok(Self(all)),
        }
    }

    fn text(&self, field: &str) -> Option<&'a str> {
        self.0.iter().find(|one| one.0 == field).map(|one| one.1)
    }

    /// Returns an acceleration with its unit, in g: some codes give it in m/s², others in g.
    fn acceleration(&self, field: &str) -> Result<f64, Refused> {
        let text = self.text(field);
        let found = text.and_then(DesignSpectrum::in_g);
        found.ok_or_else(|| {
            let found = Refused::at(in_target(field)).found(text.unwrap_or("nothing").to_owned());
            found.allowed_is("a number > 0 with its unit, such as 0.25g or 2.45m/s2")
        })
    }

    /// Returns a number > 0 that may be followed by its unit.
    fn positive(&self, field: &str, unit: &str) -> Result<f64, Refused> {
        let text = self.text(field);
        let number = text.and_then(|text| text.strip_suffix(unit).unwrap_or(text).trim().parse::<f64>().ok());
        let number = number.filter(|number| *number > 0.0 && number.is_finite());
        number.ok_or_else(|| {
            let found = Refused::at(in_target(field)).found(text.unwrap_or("nothing").to_owned());
            found.allowed_is("a number > 0")
        })
    }
}

impl FromStr for DesignSpectrum {
    type Err = Refused;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text.split_once(':') {
            Some(("ec8", settings)) => {
                let settings = SpectrumSettings::of(settings, &["a_g", "ground", "type"])?;
                let kind = settings.text("type").unwrap_or("1");
                let field = |field: &str, found: &str, allowed: &'static str| {
                    let found = Refused::at(in_target(field)).found(found.to_owned());
                    found.allowed_are(allowed)
                };
                if !["1", "2"].contains(&kind) {
                    return Err(field("type", kind, "1 and 2"));
                }
                let ground = settings.text("ground").unwrap_or("nothing");
                let corners =
                    Eurocode8Ground::of(ground, kind).ok_or_else(|| field("ground", ground, "A to E, as in \"ec8:a_g=0.25g,ground=C\""))?;
                Ok(Self::Eurocode8 {
                    ground_acceleration: settings.acceleration("a_g")?,
                    ground: corners,
                })
            }
            Some(("asce7", settings)) => {
                let settings = SpectrumSettings::of(settings, &["s_ds", "s_d1", "t_l"])?;
                Ok(Self::Asce7 {
                    short: settings.positive("s_ds", "g")?,
                    one_second: settings.positive("s_d1", "g")?,
                    long_period: settings.positive("t_l", "s")?,
                })
            }
            _ => Err(unknown(text)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::DesignSpectrum;

    fn at(spectrum: &str, periods: &[f64]) -> Vec<f64> {
        let spectrum: DesignSpectrum = spectrum.parse().expect("a spectrum");
        periods.iter().map(|period| spectrum.acceleration(*period)).collect()
    }

    fn are_close(found: &[f64], wanted: &[f64]) {
        for (found, wanted) in found.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12, "{found} {wanted}");
        }
    }

    /// EN 1998-1:2004, (3.2) to (3.5), of ground C: S = 1.15, and corners at 0.2, 0.6 and 2 s.
    #[test]
    fn reference_eurocode_8() {
        let found = at("ec8:a_g=0.25g,ground=C", &[0.0, 0.1, 0.2, 0.6, 1.2, 2.0, 4.0]);
        let top = 0.25 * 1.15 * 2.5;
        are_close(
            &found,
            &[0.2875, 0.2875 * 1.75, top, top, top / 2.0, top * 0.3, top * 0.6 * 2.0 / 16.0],
        );
        are_close(&at("ec8:a_g=0.980665m/s2,ground=D,type=2", &[0.2]), &[0.1 * 1.8 * 2.5]);
    }

    /// ASCE 7-16, (11.4-5) to (11.4-7): corners at 0.12 and 0.6 s.
    #[test]
    fn reference_asce_7() {
        let found = at("asce7:s_ds=1.0g,s_d1=0.6g,t_l=8s", &[0.0, 0.06, 0.12, 0.6, 1.0, 8.0, 16.0]);
        are_close(&found, &[0.4, 0.7, 1.0, 1.0, 0.6, 0.075, 0.6 * 8.0 / 256.0]);
    }

    #[test]
    fn reference_a_table() {
        let table = DesignSpectrum::table("period_s,sa_g\n# of the site\n0.1, 0.5\n0.3;0.9\n").expect("a table");
        are_close(&[0.0, 0.2, 5.0].map(|period| table.acceleration(period)), &[0.5, 0.7, 0.9]);
        for bad in ["0.1,0.5\n0.1,0.6", "0.1", "period", "a\n0.1,-1"] {
            assert!(DesignSpectrum::table(bad).is_err(), "{bad}");
        }
    }

    /// The message "found "0,1;0,5", allowed are a period in s and an acceleration in g" did not mention the decimal comma.
    #[test]
    fn issue_decimal_commas_of_a_table_are_named() {
        let refused = |text: &str| DesignSpectrum::table(text).expect_err("refused").to_string();
        insta::assert_snapshot!(refused("T;Sa\n0,1;0,5\n"), @r#"target: line 2: found "0,1;0,5" with decimal commas, allowed are decimal points: "0.1; 0.5""#);
        insta::assert_snapshot!(refused("0,1 0,5\n"), @r#"target: line 1: found "0,1 0,5" with decimal commas, allowed are decimal points: "0.1; 0.5""#);
        insta::assert_snapshot!(refused("0.1,-1"), @r#"target: line 1: found "0.1,-1", allowed are a period in s and an acceleration in g, periods rising"#);
    }

    #[test]
    fn extreme_what_is_no_spectrum_says_what_is() {
        let refused = |text: &str| text.parse::<DesignSpectrum>().expect_err("refused").to_string();
        insta::assert_snapshot!(
            [
                "ec9:a_g=1",
                "ec8:a_g=0.25g",
                "ec8:a_g=-1g,ground=C",
                "ec8:a_g=0.25,ground=C",
                "ec8:ground=C",
                "ec8:ag=1,ground=C",
                "asce7:s_ds=1,s_d1=0.6"
            ]
            .map(refused)
            .join("\n"),
            @r#"
        target: found "ec9:a_g=1", allowed are "ec8:a_g=0.25g,ground=C" (and type=2), "asce7:s_ds=1.0,s_d1=0.6,t_l=8" and a CSV file of periods in s and accelerations in g
        target: ground: found nothing, allowed are A to E, as in "ec8:a_g=0.25g,ground=C"
        target: a_g: found -1g, allowed is a number > 0 with its unit, such as 0.25g or 2.45m/s2
        target: a_g: found 0.25, allowed is a number > 0 with its unit, such as 0.25g or 2.45m/s2
        target: a_g: found nothing, allowed is a number > 0 with its unit, such as 0.25g or 2.45m/s2
        target: ag: found 1, allowed are a_g, ground and type after ec8:, and s_ds, s_d1 and t_l after asce7:
        target: t_l: found nothing, allowed is a number > 0
        "#
        );
    }
}
