//! Finds motions that are components of one record. Such motions belong to one event and are not independent.

use std::collections::BTreeSet;

use super::copies::Copies;
use super::{ReadMotion, SuiteMotion};

/// Largest difference between the times of components of one record \[s\]. The times may differ a little, because some formats leave out
/// fractions of a second and some channels start later than others.
const SAME_TIME: u64 = 10;

/// Gives each motion that shakes rows the number of its event. Numbers start at 0 and follow the order of the motions.
///
/// Returns the number of events. It also returns pairs of motions that differ only by a factor although nothing else shows that they belong
/// together; it then merges their two events.
///
/// The motions of one file belong to one event, and so do copies. Two other motions belong to one event:
///
/// - if the table beside the files gives them the same event, and not if it gives them different ones;
/// - if they have the same record number of PEER;
/// - if they have the same station and the same time, or the same station and event if their times cannot be compared;
/// - if they have the same title, no two motions with this title have the same direction, and their event texts do not differ;
/// - if they are in the same folder and their names differ only in the direction.
///
/// Motions of two files with different record numbers stay apart. If either has no record number, different stations or times keep them
/// apart. Copies always belong together.
pub(super) fn number(all: &mut [ReadMotion], copies: &Copies) -> (usize, Vec<(String, String, f64)>) {
    let shaking = |index: &usize| all[*index].reason.is_none();
    let shaking: Vec<usize> = (0..all.len()).filter(shaking).collect();
    let mut event: Vec<usize> = (0..all.len()).collect();
    let mut join = |one: usize, other: usize| {
        let (to, from) = (event[one], event[other]);
        let of_other = event.iter_mut().filter(|event| **event == from);
        of_other.for_each(|event| *event = to);
        to != from
    };
    let several = titles_of_several(all, copies);
    for (rank, &index) in shaking.iter().enumerate() {
        for &other in &shaking[..rank] {
            let [one, another] = [other, index].map(|index| &all[index].motion);
            if copies.of[index] == Some(other) || copies.of[other] == Some(index) || are_of_one_record(one, another, &several) {
                join(other, index);
            }
        }
    }
    let named = |index: usize| all[index].motion.name.clone();
    // Report only pairs from different events: components of one record are often similar.
    let alike = copies.alike.iter().filter(|(one, other, _)| join(*one, *other));
    let alike = alike.map(|(one, other, factor)| (named(*one), named(*other), *factor));
    let alike = alike.collect();
    let mut known = Vec::new();
    for index in shaking {
        if copies.of[index].is_none() {
            let at = known.iter().position(|one| *one == event[index]);
            all[index].motion.event = at.unwrap_or_else(|| {
                known.push(event[index]);
                known.len() - 1
            });
        }
    }
    (known.len(), alike)
}

/// Titles under which a direction occurs twice. They do not identify a record.
fn titles_of_several(all: &[ReadMotion], copies: &Copies) -> BTreeSet<String> {
    let mut seen = BTreeSet::new();
    let motions = all.iter().zip(&copies.of);
    let motions = motions.filter(|(one, copy)| one.reason.is_none() && copy.is_none());
    let titles = motions.filter_map(|(ReadMotion { motion, .. }, _)| {
        let title = motion.identity.title.clone()?;
        let in_file = motion.origin.file.component().map(str::to_uppercase);
        let direction = in_file.or(motion.named.word.clone());
        (!seen.insert((title.clone(), direction))).then_some(title)
    });
    titles.collect()
}

fn are_of_one_record(one: &SuiteMotion, other: &SuiteMotion, several: &BTreeSet<String>) -> bool {
    if one.path == other.path {
        return true;
    }
    if let (Some(one), Some(other)) = (&one.told.event, &other.told.event) {
        return one == other;
    }
    let number = |motion: &SuiteMotion| motion.identity.rsn.or(motion.named.rsn);
    if let (Some(one), Some(other)) = (number(one), number(other)) {
        return one == other;
    }
    let [own, others] = [&one.identity, &other.identity];
    let same = |a: &Option<String>, b: &Option<String>| Some(a.as_ref()? == b.as_ref()?);
    let station = same(&own.station, &others.station);
    if station == Some(false) {
        return false;
    }
    let time = same_time(own.time.as_deref(), others.time.as_deref());
    if time == Some(false) {
        return false;
    }
    let event = same(&own.event, &others.event);
    if station == Some(true) && time.or(event) == Some(true) {
        return true;
    }
    // The text of an event may name the component. Different texts therefore rule out only the match by title.
    let title = own.title.as_ref().filter(|title| !several.contains(*title));
    let by_title = title.is_some() && own.title == others.title && event != Some(false);
    by_title || (one.path.parent() == other.path.parent() && one.named.same_record(&other.named))
}

/// Whether two times agree: within 10 s in ISO form, otherwise letter by letter. Returns `None` if a time is missing or is no date, or if
/// only one is in ISO form.
fn same_time(one: Option<&str>, other: Option<&str>) -> Option<bool> {
    let (one, other) = (one?, other?);
    let is_date = |text: &str| text.bytes().filter(u8::is_ascii_digit).count() >= 8;
    match (seconds(one), seconds(other)) {
        (Some(one), Some(other)) => Some(one.abs_diff(other) <= SAME_TIME),
        (None, None) if is_date(one) && is_date(other) => Some(one == other),
        _ => None,
    }
}

/// Converts a time such as `1999-09-20T17:47:15` to seconds. It counts 31 days for every month, which is wrong only across midnight at the
/// end of a shorter month.
fn seconds(time: &str) -> Option<i64> {
    let parts = time.split(['-', 'T', ':']).map(str::parse);
    let parts: Vec<i64> = parts.collect::<Result<_, _>>().ok()?;
    let [year, month, day, hour, minute, second] = parts[..] else {
        return None;
    };
    let days = (12 * year + month) * 31 + day;
    Some(((24 * days + hour) * 60 + minute) * 60 + second)
}
