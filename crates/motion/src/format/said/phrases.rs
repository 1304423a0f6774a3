//! Phrases that state a step, a rate, a number of samples or a unit.

use super::super::title::unit_of;
use super::Other;
use crate::AccelerationUnit;
use crate::line::number;

/// Keys of a time step \[s\], or of a rate \[Hz\] if the unit after the number shows this.
const STEP: [&str; 15] = [
    "dt",
    "delta t",
    "time step",
    "timestep",
    "time interval",
    "time increment",
    "sampling interval",
    "sampling period",
    "sampling step",
    "sample interval",
    "sample spacing",
    "spacing of",
    "spaced at",
    "intervalo de muestreo",
    "paso de tiempo",
];

/// Keys of a rate \[Hz\], or of a step.
const RATE: [&str; 10] = [
    "sampling rate",
    "sampling frequency",
    "sampling freq",
    "sample rate",
    "sample frequency",
    "samplingrate",
    "samplerate",
    "samples/sec",
    "tasa de muestreo",
    "frecuencia de muestreo",
];

/// Keys of the number of samples.
const COUNT: [&str; 15] = [
    "npts",
    "npoints",
    "nsamples",
    "ndata",
    "sample count",
    "number of points",
    "number of samples",
    "number of values",
    "number of data",
    "number of data points",
    "no. of points",
    "no of points",
    "total de muestras",
    "numero de muestras",
    "nombre de points",
];

/// Short keys, which count only before `:` or `=`: of a step, a rate and a number of samples.
const SHORT_STEP: [&str; 2] = ["delta", "ts"];
const SHORT_RATE: [&str; 3] = ["fs", "sps", "rate"];
const SHORT_COUNT: [&str; 7] = ["samples", "no. of samples", "count", "points", "npt", "total points", "n"];

/// Words of a number that was true before the file was processed.
const BEFORE: [&str; 5] = ["original", "raw", "decimat", "before", "downsampled from"];

/// Words before a unit that belong to the phrase, such as `acceleration time history in units of`.
const BETWEEN: [&str; 15] = [
    "in",
    "units",
    "unit",
    "of",
    "time",
    "history",
    "histories",
    "series",
    "data",
    "values",
    "is",
    "are",
    "record",
    "the",
    "given",
];

/// Text before and after each occurrence of a key as a separate word.
pub(super) fn around<'t>(text: &'t str, key: &str) -> impl Iterator<Item = (&'t str, &'t str)> {
    let length = key.len();
    text.match_indices(key).filter_map(move |(at, _)| {
        let (before, behind) = (&text[..at], &text[at + length..]);
        let cuts = before.ends_with(|letter: char| letter.is_alphanumeric()) || behind.starts_with(|letter: char| letter.is_alphabetic());
        (!cuts).then_some((before, behind))
    })
}

/// A number with the unit before or after it.
struct Printed<'t> {
    value: f64,
    unit: &'t str,
}

/// The number of a key. A unit and signs may be in between, as in ` (Hz) = 200`, ` is 0.005 s` or `s: 0.005`.
fn printed(behind: &str) -> Option<Printed<'_>> {
    let mut rest = behind;
    let mut unit = "";
    loop {
        rest = rest.trim_start_matches([' ', ':', '=', ',']);
        let word_end = rest.find(|letter: char| !letter.is_ascii_alphabetic()).unwrap_or(rest.len());
        let (word, after) = rest.split_at(word_end);
        match word {
            "" => {}
            "is" | "are" | "of" | "in" => {
                rest = after;
                continue;
            }
            _ if is_of_time(word) => {
                (unit, rest) = (word, after);
                continue;
            }
            _ => return None,
        }
        let Some(inside) = rest.strip_prefix(['(', '[']) else {
            break;
        };
        (unit, rest) = inside.split_once([')', ']'])?;
    }
    let number_end = rest.find(|letter: char| !(letter.is_ascii_digit() || "+-.e".contains(letter)));
    let (digits, after) = rest.split_at(number_end.unwrap_or(rest.len()));
    let mut value = number(digits.trim_end_matches(['.', 'e']).as_bytes())?;
    let mut after = after;
    // A step may be printed as a fraction, `1/200 s`.
    if let Some(fraction) = after.strip_prefix('/') {
        let end = fraction.find(|letter: char| !letter.is_ascii_digit()).unwrap_or(fraction.len());
        if let Some(divisor) = number(&fraction.as_bytes()[..end]) {
            value /= divisor;
            after = &fraction[end..];
        }
    }
    let after = after.trim_start_matches([' ', '(', '[']);
    let end = after.find(|letter: char| !(letter.is_ascii_alphabetic() || letter == '/'));
    let behind = &after[..end.unwrap_or(after.len())];
    Some(Printed {
        value,
        unit: if unit.is_empty() { behind } else { unit.trim() },
    })
}

/// Whether a word is a unit of a step or a rate.
fn is_of_time(word: &str) -> bool {
    is_seconds(word) || is_milliseconds(word) || matches!(word, "hz" | "hertz" | "sps")
}

fn is_seconds(word: &str) -> bool {
    matches!(word, "s" | "sec" | "secs" | "second" | "seconds" | "seg" | "segundos")
}

fn is_milliseconds(word: &str) -> bool {
    matches!(word, "ms" | "msec" | "msecs" | "millisecond" | "milliseconds")
}

/// The time steps \[s\] that a line states.
pub(super) fn steps(text: &str) -> Vec<f64> {
    if is_of_before(text) {
        return Vec::new();
    }
    let found = |keys: &'static [&'static str]| {
        let places = keys.iter().flat_map(|key| around(text, key));
        places.filter_map(|(_, behind)| printed(behind))
    };
    let short = |keys: &'static [&'static str]| {
        let places = keys.iter().flat_map(|key| around(text, key));
        let stated = places.filter(|(_, behind)| is_stated(behind));
        stated.filter_map(|(_, behind)| printed(behind))
    };
    let step = |one: Printed<'_>| match one.unit {
        unit if is_milliseconds(unit) => one.value / 1000.0,
        "hz" | "hertz" | "sps" => 1.0 / one.value,
        _ => one.value,
    };
    let rate = |one: Printed<'_>| match one.unit {
        unit if is_milliseconds(unit) => one.value / 1000.0,
        "hz" | "hertz" | "sps" => 1.0 / one.value,
        unit if is_seconds(unit) || one.value < 1.0 => one.value,
        _ => 1.0 / one.value,
    };
    let by_words = words_behind_numbers(text).filter(|(_, words)| {
        ["sps", "samples/s", "samples per s", "pts/s", "points per s", "muestras/s"]
            .iter()
            .any(|start| words.starts_with(start))
    });
    let sampled = found(&["sampling", "sampled at"]).filter(|one| is_of_time(one.unit));
    let rates = found(&RATE).chain(short(&SHORT_RATE)).chain(sampled);
    found(&STEP)
        .chain(short(&SHORT_STEP))
        .map(step)
        .chain(rates.map(rate))
        .chain(by_words.map(|(rate, _)| 1.0 / rate))
        .filter(|step| super::super::spacing::POSSIBLE.contains(step))
        .collect()
}

/// The numbers of samples that a line states.
pub(super) fn counts(text: &str) -> Vec<usize> {
    if is_of_before(text) {
        return Vec::new();
    }
    let short = SHORT_COUNT.iter().flat_map(|key| around(text, key));
    let short = short.filter(|(_, behind)| is_stated(behind));
    let named = COUNT.iter().flat_map(|key| around(text, key)).chain(short);
    let named = named.filter_map(|(_, behind)| printed(behind)).map(|one| one.value);
    // `4000 samples,` and `1559 points at`, but not `8 points across`.
    let by_words = words_behind_numbers(text).filter(|(_, words)| {
        let what = ["samples", "points", "data points", "pts", "muestras", "values"];
        let rest = what.iter().find_map(|what| words.strip_prefix(what));
        rest.is_some_and(|rest| {
            let rest = rest.trim_start();
            ["at ", "equally", "of data", ",", ";", "."]
                .iter()
                .any(|next| rest.starts_with(next))
                || rest.is_empty()
        })
    });
    named
        .chain(by_words.map(|(count, _)| count))
        .filter_map(|count| format!("{count}").parse().ok())
        .filter(|count| *count > 0)
        .collect()
}

/// Whether the sign of a value follows a key, with at most its unit in between: `fs = 200`, `rate (Hz): 200`.
fn is_stated(behind: &str) -> bool {
    let behind = behind.trim_start();
    let behind = match behind.strip_prefix(['(', '[']) {
        Some(inside) => inside.split_once([')', ']']).map_or("", |(_, rest)| rest),
        None => behind,
    };
    behind.trim_start().starts_with([':', '='])
}

/// Whether a line describes the record before it was processed.
fn is_of_before(text: &str) -> bool {
    BEFORE.iter().any(|word| text.contains(word))
}

/// The separate numbers of a line, each with the words after it.
fn words_behind_numbers(text: &str) -> impl Iterator<Item = (f64, &str)> {
    let starts = text.match_indices(|letter: char| letter.is_ascii_digit());
    starts.filter_map(|(at, _)| {
        let is_start = !text[..at].ends_with(|letter: char| letter.is_alphanumeric() || letter == '.');
        let rest = &text[at..];
        let end = rest.find([' ', '\t'])?;
        let value = number(&rest.as_bytes()[..end]).filter(|_| is_start)?;
        Some((value, rest[end..].trim_start()))
    })
}

/// The quantity of a phrase such as `velocity time history` or `displacement (cm)`.
pub(super) fn other_quantity(text: &str) -> Option<Other> {
    let words = [
        ("velocit", Other::Velocity),
        ("velocidad", Other::Velocity),
        ("displacement", Other::Displacement),
        ("desplazamiento", Other::Displacement),
    ];
    words.into_iter().find_map(|(start, other)| {
        let (before, behind) = text.split_at(text.find(start)?);
        let of_another = ["wave", "peak", "max", "initial"].iter().any(|word| before.contains(word));
        let end = behind.find(|letter: char| !letter.is_ascii_alphabetic())?;
        let separates = |letter: char| !(letter.is_ascii_alphanumeric() || letter == '/');
        let mut words = behind[end..].split(separates).filter(|word| !word.is_empty());
        let next = words.find(|word| !["in", "units", "of"].contains(word))?;
        let is_history = ["time", "history", "series", "record"].contains(&next);
        (!of_another && (is_history || Other::of_unit(next) == Some(other))).then_some(other)
    })
}

/// The unit after a word for accelerations, as in `acceleration in cm/s2` or `acc (g)`.
pub(super) fn unit_of_accelerations(text: &str) -> Option<(AccelerationUnit, &str)> {
    let mut starts = text.match_indices("acc").chain(text.match_indices("acel"));
    starts.find_map(|(at, _)| {
        let (before, behind) = text.split_at(at);
        let of_peak = ["max", "peak", "pga", "pk"].iter().any(|word| before.contains(word));
        let is_word = !before.ends_with(|letter: char| letter.is_alphanumeric());
        if of_peak || !is_word {
            return None;
        }
        let end = behind.find(|letter: char| !letter.is_ascii_alphabetic())?;
        let separates = |letter: char| matches!(letter, ' ' | '(' | '[' | ')' | ']' | ',' | ':' | '=');
        let mut words = behind[end..].split(separates).filter(|word| !word.is_empty());
        let word = words.find(|word| !BETWEEN.contains(word))?.trim_end_matches('.');
        Some((unit_of(word)?, word))
    })
}
