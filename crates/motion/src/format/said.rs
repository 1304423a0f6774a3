//! Statements in comments and titles about the numbers below: step or rate, number, unit, component, station, event, time.
//!
//! A single reader for `key: value`, `key = value` and a few phrases, as written by networks, programs and people. It takes unambiguous
//! statements and ignores the rest. The values, and the caller's declarations, are then compared with them.

mod phrases;

use super::stamp;
use super::title::{unit_in, unit_of};
use super::{Component, Scale, Stated};
use crate::line::Line;
use crate::{AccelerationUnit, Direction, FilePlace, Identity};
use phrases::{around, counts, other_quantity, steps, unit_of_accelerations};

/// Lines above the numbers in which statements are searched.
const MOST_LINES: usize = 200;

/// Keys of a unit.
const UNIT: [&str; 7] = [
    "unit",
    "units",
    "field unit",
    "amplitude unit",
    "amplitudeunit",
    "unidad",
    "unidades",
];

/// Words of other numbers with units.
const OF_OTHERS: [&str; 4] = ["gravit", "vs30", "vs 30", "wave"];

/// Keys of a component.
const COMPONENT: [&str; 8] = [
    "component",
    "comp",
    "componente",
    "channel",
    "orientation",
    "direction",
    "dir",
    "canal",
];

/// Keys of a station, an event and a time.
const STATION: [&str; 6] = ["station code", "station name", "station", "estacion", "stat", "code"];
const EVENT: [&str; 4] = ["event id", "event name", "earthquake", "event"];
const TIME: [&str; 7] = [
    "origin time",
    "origintime",
    "event time",
    "tiempo de origen",
    "start time",
    "datetime of first sample",
    "time of first sample",
];

/// Statements of a text about its numbers.
#[derive(Debug, Default)]
pub(super) struct Said {
    /// Time steps \[s\], above zero.
    pub(super) steps: Vec<Stated<f64>>,
    /// Numbers of samples, above zero.
    pub(super) counts: Vec<Stated<usize>>,
    pub(super) units: Vec<Stated<AccelerationUnit>>,
    /// Another quantity than acceleration.
    pub(super) other: Option<Stated<Other>>,
    pub(super) component: Option<Component>,
    pub(super) station: Option<String>,
    pub(super) event: Option<String>,
    pub(super) time: Option<String>,
}

/// Another quantity than acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Other {
    Velocity,
    Displacement,
    /// Counts of a digitiser.
    Counts,
}

impl Other {
    /// The quantity of a unit that is not a unit of acceleration.
    pub(super) fn of_unit(unit: &str) -> Option<Self> {
        match unit.trim() {
            "cm/s" | "m/s" | "mm/s" | "cm/sec" | "m/sec" | "mm/sec" | "in/s" | "in/sec" | "cm/seg" | "m/seg" => Some(Self::Velocity),
            "cm" | "m" | "mm" | "in" => Some(Self::Displacement),
            "count" | "counts" | "cuentas" => Some(Self::Counts),
            _ => None,
        }
    }
}

impl Said {
    /// Reads the lines above the numbers, except the line with this index, which names columns.
    pub(super) fn new(titles: &[Line<'_>], names: Option<usize>) -> Self {
        let mut said = Self::default();
        let titles = titles.iter().filter(|line| Some(line.number) != names);
        for line in titles.take(MOST_LINES) {
            said.read(*line);
        }
        said
    }

    /// Quantity and unit of the values.
    pub(super) fn scale(&self) -> Scale {
        self.scale_with(Vec::new())
    }

    /// Quantity and unit of the values, including units stated at other places.
    pub(super) fn scale_with(&self, mut units: Vec<Stated<AccelerationUnit>>) -> Scale {
        units.extend(self.units.iter().cloned());
        if let Some(first) = units.first().cloned() {
            let is_one = units.iter().all(|unit| unit.value == first.value);
            return if is_one { Scale::Unit(first) } else { Scale::Several(units) };
        }
        let Some(other) = &self.other else {
            return Scale::Unknown;
        };
        let stated = Stated {
            value: (),
            place: other.place,
            text: other.text.clone(),
        };
        match other.value {
            Other::Velocity => Scale::Velocity(stated),
            Other::Displacement => Scale::Displacement(stated),
            Other::Counts => Scale::Counts(stated),
        }
    }

    /// Place and time of the recording.
    pub(super) fn identity(self) -> Identity {
        Identity {
            station: self.station,
            event: self.event,
            time: self.time,
            ..Identity::default()
        }
    }

    fn read(&mut self, line: Line<'_>) {
        let text = spelt(&line.text());
        let stated = |value| Stated {
            value,
            place: FilePlace::Line(line.number),
            text: line.excerpt(),
        };
        let steps = steps(&text);
        self.steps.extend(steps.into_iter().map(stated));
        let counts = counts(&text);
        let stated = |value| Stated {
            value,
            place: FilePlace::Line(line.number),
            text: line.excerpt(),
        };
        self.counts.extend(counts.into_iter().map(stated));
        self.read_unit(line, &text);
        self.read_names(line, &text);
        self.read_time_series(line);
    }

    fn read_unit(&mut self, line: Line<'_>, text: &str) {
        let place = FilePlace::Line(line.number);
        // The unit of another number, such as that of gravity or of a speed of waves.
        if OF_OTHERS.iter().any(|word| text.contains(word)) {
            return;
        }
        let named = UNIT.iter().find_map(|key| {
            let (before, behind) = around(text, key).next()?;
            Some((before, behind.trim_start_matches([' ', ':', '=', ','])))
        });
        let alone = text.trim_matches(['(', ')', '[', ']', ' ']);
        let known = named
            .and_then(|(_, behind)| unit_in(behind))
            .or_else(|| unit_of_accelerations(text))
            .or_else(|| Some((unit_of(alone)?, alone)));
        if let Some((value, word)) = known {
            let text = word.to_owned();
            self.units.push(Stated { value, place, text });
            return;
        }
        // Other quantities than the values have units too, but after another word.
        let is_of_values = |before: &str| matches!(before.trim(), "" | "field" | "data" | "amplitude");
        let other = named
            .filter(|(before, _)| is_of_values(before))
            .and_then(|(_, behind)| behind.split([',', ';', ' ']).find_map(Other::of_unit))
            .or_else(|| other_quantity(text));
        let is_new = self.other.is_none();
        if let Some(value) = other.filter(|_| is_new) {
            let text = line.excerpt();
            self.other = Some(Stated { value, place, text });
        }
    }

    fn read_names(&mut self, line: Line<'_>, text: &str) {
        // The whole name counts: stations of one town share their first word.
        let name_of = |keys: &[&str]| {
            let mut found = keys.iter().filter_map(|key| around(text, key).next());
            let (_, behind) = found.next()?;
            let behind = behind.trim_start_matches([' ', ':', '=', ',', '(']);
            let end = [&COMPONENT[..], &EVENT, &TIME].concat().into_iter();
            let end = end.filter_map(|key| around(behind, key).next());
            let end = end.map(|(before, _)| before.len()).min();
            let name = &behind[..end.unwrap_or(behind.len())];
            let name = name.split([',', ';', ')', '(', '|']).next()?;
            let name: Vec<&str> = name.split_whitespace().collect();
            (!name.is_empty()).then(|| name.join(" ").to_ascii_uppercase())
        };
        let word_of = |keys: &[&str]| {
            let mut found = keys.iter().filter_map(|key| around(text, key).next());
            let (_, behind) = found.next()?;
            let behind = behind.trim_start_matches([' ', ':', '=', ',', '(']);
            let word = behind.split([' ', ',', ';', ')', '\t']).next()?;
            (!word.is_empty()).then(|| word.to_ascii_uppercase())
        };
        // Blanks separate the names of a stream here: the channel is the last word of `XX TEST 00 HNZ`.
        let stream = around(text, "sid").next();
        let stream: Option<Vec<String>> = stream.map(|(_, behind)| {
            let names = behind.split([' ', ':']).filter(|name| !name.is_empty());
            names.map(str::to_ascii_uppercase).collect()
        });
        if let Some([station @ .., _channel]) = stream.as_deref() {
            self.station = Some(station.join("."));
        }
        if self.component.is_none() {
            let word = stream.and_then(|mut names| names.pop());
            let word = word.or_else(|| word_of(&COMPONENT));
            let word = word.filter(|word| word.len() > 1 || !word.bytes().all(|byte| byte.is_ascii_digit()));
            self.component = word
                .filter(|word| Direction::of_component(word).is_some())
                .map(|name| Component::new(name, FilePlace::Line(line.number)));
        }
        self.station = self.station.take().or_else(|| name_of(&STATION));
        let rest_of = |keys: &[&str]| {
            let (_, behind) = keys.iter().find_map(|key| {
                let (before, behind) = around(text, key).next()?;
                before.trim().is_empty().then_some((before, behind))
            })?;
            let rest = behind.trim_matches([' ', ':', '=', ',', '-']);
            (!rest.is_empty()).then(|| stamp::normal(&rest.to_ascii_uppercase()))
        };
        self.event = self.event.take().or_else(|| rest_of(&EVENT));
        // `Start time: 0.0` does not identify a record.
        let time = || rest_of(&TIME).filter(|time| stamp::Stamp::new(time).is_some());
        self.time = self.time.take().or_else(time);
    }

    /// The line of a time series of the IRIS web services: `TIMESERIES XX_TEST__HNE_D, 4000 samples, 200 sps, 2020-01-01T00:00:00,
    /// SLIST, FLOAT, M/S**2`.
    fn read_time_series(&mut self, line: Line<'_>) {
        let text = line.text();
        let Some(behind) = text.trim_start_matches(['#', ' ']).strip_prefix("TIMESERIES ") else {
            return;
        };
        let fields: Vec<&str> = behind.split(',').map(str::trim).collect();
        let place = FilePlace::Line(line.number);
        let names: Vec<&str> = fields[0].split('_').collect();
        if let [network, station, .., channel, _quality] = names[..] {
            self.station = Some(format!("{network}.{station}"));
            self.component = Some(Component::new(channel.to_owned(), place));
        }
        self.time = fields.get(3).map(|time| stamp::normal(time));
        let unit = fields.last().copied().unwrap_or_default();
        let text = unit.to_owned();
        if let Some((value, _)) = unit_in(unit) {
            self.units.push(Stated { value, place, text });
        } else if let Some(value) = Other::of_unit(&unit.to_ascii_lowercase()) {
            self.other = Some(Stated { value, place, text });
        }
    }
}

/// Small letters without accents, quotes, underscores and marks of comments.
fn spelt(text: &str) -> String {
    let letter = |letter: char| match letter {
        'á' | 'Á' => 'a',
        'é' | 'É' | 'è' => 'e',
        'í' | 'Í' => 'i',
        'ó' | 'Ó' => 'o',
        'ú' | 'Ú' => 'u',
        'Δ' | 'δ' => 'd',
        '_' | '"' | '\t' => ' ',
        other => other.to_ascii_lowercase(),
    };
    let text: String = text.chars().map(letter).collect();
    text.trim_start_matches(['#', '%', '!', '/', ' ']).to_owned()
}
