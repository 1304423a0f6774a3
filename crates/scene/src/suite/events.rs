//! Which motions of a folder are components of one event: two components are no two independent motions.

use std::collections::BTreeMap;

use pounding_motion::Direction;

use super::Motion;

/// Numbers of the events of motions, from 0 in the order of the motions.
///
/// Motions of one file are of one event. So are those of files in one folder whose names differ in a word for the direction alone, as
/// `ABC001.EW` and `ABC001.NS`. So are two whose names end in azimuths a right angle apart, as `A-ELC180.AT2` and `A-ELC270.AT2`.
pub fn events(motions: &[Motion]) -> Vec<usize> {
    let names: Vec<String> = motions.iter().map(Motion::file_name).collect();
    let mut azimuths: BTreeMap<String, Vec<u32>> = BTreeMap::new();
    for (stem, azimuth) in names.iter().filter_map(|name| azimuth(name)) {
        let all = azimuths.entry(stem).or_default();
        if !all.contains(&azimuth) {
            all.push(azimuth);
        }
    }
    let is_pair = |stem: &String| {
        let all = &azimuths[stem][..];
        matches!(all, [one, other] if matches!(one.abs_diff(*other), 90 | 270))
    };
    let key = |(motion, name): (&Motion, &String)| {
        let shared = match azimuth(name) {
            Some((stem, _)) if is_pair(&stem) => stem,
            _ => without_direction(name),
        };
        motion.path.with_file_name(shared)
    };
    let keys: Vec<_> = motions.iter().zip(&names).map(key).collect();
    let mut known = Vec::new();
    let number = |key| {
        let found = known.iter().position(|one| *one == key);
        found.unwrap_or_else(|| {
            known.push(key);
            known.len() - 1
        })
    };
    keys.iter().map(number).collect()
}

/// The name of a file without the word for its direction at the end.
fn without_direction(name: &str) -> String {
    let end = Direction::of_file_name(name).map(|(_, end)| end);
    let at = end.and_then(|end| Some((name.rfind(end)?, end.len())));
    at.map_or_else(
        || name.into(),
        |(at, len)| format!("{}*{}", &name[..at], &name[at + len..]),
    )
}

/// The name of a file without the azimuth of three digits at its end or as its ending, and that azimuth \[°\].
fn azimuth(name: &str) -> Option<(String, u32)> {
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let degrees = |digits: &str| {
        let is_number = digits.len() == 3 && digits.bytes().all(|byte| byte.is_ascii_digit());
        let number: u32 = digits.parse().ok()?;
        (is_number && number <= 360).then_some(number)
    };
    if let Some(azimuth) = degrees(ending) {
        return Some((format!("{stem}.*"), azimuth));
    }
    let start = stem.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let azimuth = degrees(&stem[start.len()..])?;
    Some((format!("{start}*.{ending}"), azimuth))
}

#[cfg(test)]
mod tests {
    use super::events;
    use crate::{Motion, Orientation};

    fn of(names: &[(&str, Option<&str>)]) -> Vec<usize> {
        let motion = |&(name, component): &(&str, Option<&str>)| Motion {
            path: format!("records/{name}").into(),
            component: component.map(String::from),
            orientation: Orientation::Untold,
        };
        events(&names.iter().map(motion).collect::<Vec<_>>())
    }

    /// Twenty-two components of eleven events counted as twenty-two motions.
    #[test]
    fn issue_components_of_one_event_are_no_two_events() {
        let file = |name| (name, None);
        assert_eq!(
            of(&[("a.V2", Some("90")), ("a.V2", Some("360")), file("b.V2")]),
            [0, 0, 1]
        );
        assert_eq!(
            of(&[file("ABC001.EW"), file("ABC001.NS"), file("ABC002.EW")]),
            [0, 0, 1]
        );
        assert_eq!(of(&[file("RSN6-H1.AT2"), file("RSN6-H2.AT2")]), [0, 0]);
        assert_eq!(of(&[file("A-ELC180.AT2"), file("A-ELC270.AT2")]), [0, 0]);
        assert_eq!(of(&[file("LPCC_20.000"), file("LPCC_20.090")]), [0, 0]);
    }

    /// Numbers of records are no azimuths.
    #[test]
    fn limit_other_files_are_events_of_their_own() {
        let file = |name| (name, None);
        assert_eq!(of(&[file("RSN001.AT2"), file("RSN002.AT2")]), [0, 1]);
        assert_eq!(
            of(&[file("r001.txt"), file("r002.txt"), file("r091.txt")]),
            [0, 1, 2]
        );
        assert_eq!(of(&[file("elCentro.AT2"), file("A-ELC180.AT2")]), [0, 1]);
    }
}
