//! Names of columns above numbers: `time,acc_NS(gal),acc_EW(gal)` or `components: E N Z`.

use super::super::component::is_sum;
use super::super::said::Other;
use super::super::title::{self, unit_in, unit_of};
use crate::line::Line;
use crate::{AccelerationUnit, Direction};

/// The name of a column, with the text after it in brackets.
pub(super) struct Name<'t> {
    pub(super) line: Line<'t>,
    pub(super) text: String,
    /// The unit as written; may be empty.
    pub(super) unit: String,
}

/// Words that begin the name of a spectral value, in capitals without characters other than letters.
const SPECTRAL: [&str; 12] = [
    "SA", "PSA", "SE", "SV", "PSV", "SD", "PSD", "FAS", "FOURIER", "SPECTRAL", "SPECTRUM", "RESPONSE",
];

/// Ends of a name that are a unit, in capitals: `acc_g`, `acc_m_s2`.
const ENDS: [(&str, AccelerationUnit); 8] = {
    use AccelerationUnit::{CentimetrePerSecondSquared as Cm, MetrePerSecondSquared as M};
    [
        ("M_S2", M),
        ("MS2", M),
        ("MPS2", M),
        ("M_PER_S2", M),
        ("CM_S2", Cm),
        ("CMS2", Cm),
        ("CMPS2", Cm),
        ("CM_PER_S2", Cm),
    ]
};

impl Name<'_> {
    fn capitals(&self) -> String {
        self.text.to_ascii_uppercase()
    }

    pub(super) fn is_time(&self) -> bool {
        let name = self.text.to_ascii_lowercase();
        let word = name.split(['_', ' ', '.']).next().unwrap_or_default();
        let words = ["t", "sec", "seconds", "zeit", "temps", "tiempo", "tempo", "zaman"];
        words.contains(&word) || name.starts_with("time") || name.ends_with("time")
    }

    /// Number of decimals of a second if the times are whole numbers in the unit of the name: 3 for milliseconds.
    pub(super) fn decimals_of_time(&self) -> Option<usize> {
        let name = self.text.to_ascii_lowercase();
        let (_, end) = name.rsplit_once(['_', ' ']).unwrap_or(("", ""));
        [self.unit.to_ascii_lowercase().as_str(), end]
            .into_iter()
            .find_map(|unit| match unit {
                "s" | "sec" | "secs" | "second" | "seconds" => Some(0),
                "ms" | "msec" | "milliseconds" => Some(3),
                "us" | "µs" | "microseconds" => Some(6),
                "ns" | "nanoseconds" => Some(9),
                _ => None,
            })
    }

    pub(super) fn tells_direction(&self) -> bool {
        Direction::of_component(&self.text).is_some()
    }

    /// The unit of an acceleration in the brackets, or at the end of the name.
    pub(super) fn acceleration_unit(&self) -> Option<AccelerationUnit> {
        let of_end = || unit_at_end(&self.text);
        unit_in(&self.unit).map(|(unit, _)| unit).or_else(of_end)
    }

    pub(super) fn says_acceleration(&self) -> bool {
        let name = self.capitals();
        name.starts_with("ACC") || name.contains("ACCEL") || matches!(name.as_str(), "A" | "AG")
    }

    /// Another quantity than acceleration, from the unit or the name.
    pub(super) fn other(&self) -> Option<Other> {
        Other::of_unit(&self.unit.to_ascii_lowercase()).or_else(|| other_by_name(&self.text))
    }

    /// Whether it is a sensor in a borehole: KiK-net numbers it 1, and the one at the ground 2.
    pub(super) fn is_below(&self, names: &[Self]) -> bool {
        let (below, at_ground) = (["NS1", "EW1", "UD1"], ["NS2", "EW2", "UD2"]);
        let is = |at: usize| names.iter().any(|name| name.capitals() == at_ground[at]);
        let at = below.iter().position(|known| *known == self.capitals());
        at.is_some_and(is)
    }

    /// Whether the column counts rows or does not hold a component.
    pub(super) fn is_no_component(&self) -> bool {
        let name = self.text.to_ascii_lowercase();
        is_sum(&self.text) || matches!(name.as_str(), "no" | "no." | "nr" | "index" | "date")
    }

    /// Whether it is the axis of a spectrum. A capital `T` is a period if it is next to spectral values.
    fn is_axis(&self) -> bool {
        let name = self.capitals();
        ["FREQ", "HZ"].iter().any(|start| name.starts_with(start))
            || name.contains("PERIOD")
            || self.text.contains("周期")
            || self.unit.eq_ignore_ascii_case("hz")
    }

    fn is_spectral(&self) -> bool {
        let name = self.capitals();
        let mut words = name.split(|letter: char| !letter.is_ascii_alphabetic());
        let first = words.next().unwrap_or_default();
        let joined = name.replace('_', "");
        SPECTRAL.contains(&first)
            || SPECTRAL.contains(&joined.as_str())
            || ["SAROT", "ROTD", "GMROT"].iter().any(|start| joined.starts_with(start))
            || name.contains("SPECTR")
    }
}

/// The unit at the end of a name such as `acc_g` or `Acceleration m_per_s2`.
pub(super) fn unit_at_end(name: &str) -> Option<AccelerationUnit> {
    let name = name.to_ascii_uppercase();
    let (first, end) = name.split_once(['_', ' '])?;
    let known = ENDS.iter().find(|(known, _)| *known == end);
    let unit = known.map(|(_, unit)| *unit).or_else(|| unit_of(end))?;
    ["A", "AG", "ACC", "ACCEL", "ACCELERATION"].contains(&first).then_some(unit)
}

/// Another quantity than acceleration, from the beginning of the name.
pub(super) fn other_by_name(name: &str) -> Option<Other> {
    let name = name.to_ascii_uppercase();
    let others = [("VEL", Other::Velocity), ("DIS", Other::Displacement)];
    let mut others = others.into_iter();
    let (_, other) = others.find(|(start, _)| name.starts_with(start))?;
    Some(other)
}

/// Kind of spectrum in the columns with these names.
pub(super) fn spectrum(names: &[Name<'_>]) -> Option<&'static str> {
    let (first, values) = names.split_first()?;
    let is_history = first.text.to_ascii_lowercase().starts_with("time") || first.text == "t";
    let is_short = ["T", "F", "TN"].contains(&first.capitals().as_str());
    // A word such as `SA` may be the name of a station; a unit after it decides.
    let tells = |name: &Name<'_>| name.is_spectral() && (is_short || !name.unit.is_empty());
    let is_spectrum = if values.is_empty() {
        first.is_spectral() && !first.unit.is_empty()
    } else {
        let is_period = |name: &Name<'_>| name.is_axis() || (name.text == "T" && !name.unit.is_empty());
        first.is_axis() || (!is_history && values.iter().any(tells)) || (first.is_spectral() && values.iter().any(is_period))
    };
    let is_fourier = names.iter().any(|name| {
        let name = name.capitals();
        name.contains("FOURIER") || name.starts_with("FAS")
    });
    is_spectrum.then_some(if is_fourier {
        "the record itself, this is a Fourier spectrum"
    } else {
        "the record itself, this is a response spectrum"
    })
}

/// The names of `n_columns` columns, in their order, from the titles above them.
///
/// A title with as many words counts only if one of them is a time or a direction, has a unit, or names accelerations or spectra.
pub(super) fn of_columns<'t>(titles: &[Line<'t>], n_columns: usize) -> Option<Vec<Name<'t>>> {
    let last = titles.iter().rfind(|line| !line.is_blank());
    let above = last.map(|line| named_in(*line, &line.text()));
    let tells = |name: &Name<'_>| {
        let is_history = name.is_time() || name.tells_direction() || name.says_acceleration();
        let is_spectrum = name.is_axis() || name.is_spectral();
        // A velocity without a unit may be a word of a title.
        let is_other = !name.unit.is_empty() && name.other().is_some();
        is_history || is_spectrum || is_other || name.acceleration_unit().is_some()
    };
    let above = above.filter(|names| {
        names.len() == n_columns
            && names
                .iter()
                .all(|name| name.text.starts_with(char::is_alphabetic) && !name.text.contains(['=', ':']))
            && names.iter().any(tells)
    });
    above.or_else(|| {
        let line = title::line_with(titles, "COMPONENTS:")?;
        let text = line.text();
        let names = named_in(line, title::after(&text, "COMPONENTS:")?);
        (names.len() == n_columns).then_some(names)
    })
}

fn named_in<'t>(line: Line<'t>, text: &str) -> Vec<Name<'t>> {
    let text = text.trim_start_matches('#').trim();
    let text = text.trim_end_matches([',', ' ']);
    let fields: Vec<String> = if text.contains([',', '\t']) {
        text.split([',', '\t']).map(str::to_owned).collect()
    } else {
        // A unit belongs to the preceding word.
        let glued = text.replace(" (", "(").replace(" [", "[");
        glued.split_whitespace().map(str::to_owned).collect()
    };
    let name = |field: String| {
        let field = field.trim().trim_matches('"');
        let (name, unit) = field.split_once(['(', '[']).unwrap_or((field, ""));
        let unit = unit.split([')', ']']).next().unwrap_or_default();
        Name {
            line,
            text: name.trim().to_owned(),
            unit: unit.trim().to_owned(),
        }
    };
    fields.into_iter().map(name).collect()
}
