//! The components of a file, and the choice of one.

use crate::refusals::listed;
use crate::{FilePlace, Refused, Site};
use pounding_text::Knob;

/// One component of a file.
#[derive(Debug)]
pub(super) struct Component {
    pub(super) name: String,
    pub(super) place: FilePlace,
    /// Place of its sensor.
    pub(super) site: Site,
}

impl Component {
    /// A component whose file does not give the place of its sensor.
    pub(super) fn new(name: impl Into<String>, place: FilePlace) -> Self {
        Self {
            name: name.into(),
            place,
            site: Site::Ground,
        }
    }

    /// The component with the place of its sensor.
    pub(super) fn at(self, site: Site) -> Self {
        Self { site, ..self }
    }
}

/// Whether a name is not that of a component but of a sum of several, or of their resultant.
pub(super) fn is_sum(name: &str) -> bool {
    let sums = ["SUM", "RES", "RESULTANT", "VECTOR SUM", "SRSS"];
    sums.iter().any(|sum| name.trim().eq_ignore_ascii_case(sum))
}

/// Index of the declared component, or of the only one.
///
/// The declaration may be a name, a number from 1, or a part of only one name. Whole words such as `90 Deg` of `CHAN 1: 90 DEG` come first,
/// then any part that does not cut a number.
pub(super) fn chosen(components: &[Component], declared: Option<&str>) -> Result<usize, Refused> {
    let named: Vec<(usize, &str)> = components.iter().map(|one| one.name.as_str()).enumerate().collect();
    let Some(declared) = declared else {
        if components.len() < 2 {
            return Ok(0);
        }
        let said = format!("the file holds {} components: {}", components.len(), listed(&named));
        let said = Refused::that(said).help("choose one by its name or its number as ");
        return Err(said.and(Knob::Component).wants(Knob::Component));
    };
    let wanted = folded(declared);
    let folded: Vec<String> = components.iter().map(|component| folded(&component.name)).collect();
    let where_it = |fits: &dyn Fn(&String) -> bool| -> Vec<usize> {
        let indices = 0..folded.len();
        indices.filter(|index| fits(&folded[*index])).collect()
    };
    // A name precedes a number: channels may be called 3, 1, 2.
    let by_name = where_it(&|name| *name == wanted);
    let by_number = wanted.parse().ok().filter(|number: &usize| {
        let numbers = 1..=components.len().max(1);
        numbers.contains(number)
    });
    if let Some(index) = by_name.first().copied().or(by_number.map(|one| one - 1)) {
        return Ok(index);
    }
    let words = where_it(&|name| holds(name, &wanted, cuts_word));
    let parts = where_it(&|name| holds(name, &wanted, cuts_number));
    let found = if words.is_empty() { parts } else { words };
    if let [index] = found[..] {
        return Ok(index);
    }
    let declared = Refused::that("").quoted(declared.trim());
    let declared = declared.and(" is declared as ").and(Knob::Component);
    Err(if components.is_empty() {
        let alone = declared.but(", but ", "the file holds one, which has no name");
        alone.help("leave the declaration away")
    } else if found.is_empty() {
        let all = declared.but(", but ", format!("the file holds {}", listed(&named)));
        all.help("choose one of them by its name, a part of it, or its number")
    } else {
        let fitting: Vec<(usize, &str)> = found.iter().map(|index| named[*index]).collect();
        let fits = declared.and(format!(" and fits {} components: {}", found.len(), listed(&fitting)));
        fits.help("give more of the name, or the number")
    })
}

/// The text in small letters with single blanks between words.
fn folded(text: &str) -> String {
    let words: Vec<String> = text.split_whitespace().map(str::to_lowercase).collect();
    words.join(" ")
}

/// Whether a text contains a part at a position where neither of its ends cuts a pair of neighbouring letters that `cuts` protects.
fn holds(text: &str, part: &str, cuts: fn(char, char) -> bool) -> bool {
    let cut_at = |byte: usize| {
        let (before, behind) = text.split_at(byte);
        let pair = before.chars().next_back().zip(behind.chars().next());
        pair.is_some_and(|(left, right)| cuts(left, right))
    };
    !part.is_empty()
        && text
            .match_indices(part)
            .any(|(start, found)| !cut_at(start) && !cut_at(start + found.len()))
}

fn cuts_word(left: char, right: char) -> bool {
    left.is_alphanumeric() && right.is_alphanumeric()
}

/// Whether a cut divides a number: `0 DEG` is not a part of `90 DEG`, nor the number 1 of `12`.
fn cuts_number(left: char, right: char) -> bool {
    left.is_ascii_digit() && right.is_ascii_digit()
}

#[cfg(test)]
mod tests {
    use super::{Component, chosen};
    use crate::FilePlace;

    fn components(names: &[&str]) -> Vec<Component> {
        let component = |name: &&str| Component::new(*name, FilePlace::Line(1));
        names.iter().map(component).collect()
    }

    const CHANNELS: [&str; 4] = ["CHAN 1: 90 DEG", "CHAN 2: UP", "CHAN 3: 0 DEG", "CHAN 12: N08W"];

    /// Names had to be given in full, including the number of the channel.
    #[test]
    fn issue_a_unique_part_of_a_name_suffices() {
        let channels = components(&CHANNELS);
        for (declared, index) in [
            ("90 Deg", 0),
            ("90", 0),
            ("chan 2: up", 1),
            (" up ", 1),
            ("0 deg", 2),
            ("0", 2),
            ("CHAN  3:", 2),
            ("n08w", 3),
            ("08W", 3),
            ("12", 3),
            // Numbers of four components precede parts of names.
            ("2", 1),
            ("4", 3),
        ] {
            assert_eq!(chosen(&channels, Some(declared)), Ok(index), "{declared}");
        }
        assert_eq!(chosen(&components(&["HNE", "HNN", "HNZ"]), Some("nz")), Ok(2));
        assert_eq!(chosen(&components(&["3", "1", "2"]), Some("1")), Ok(1));
        assert_eq!(chosen(&components(&["UP", "UP 2"]), Some("Up")), Ok(0));
        assert_eq!(chosen(&[], Some("1")), Ok(0));
    }

    #[test]
    fn extreme_parts_of_several_names_and_of_none() {
        let channels = components(&CHANNELS);
        let ambiguous = |declared: &str| match chosen(&channels, Some(declared)) {
            Err(refused) => refused.to_string(),
            Ok(_) => String::new(),
        };
        let deg = "fits 2 components: 1 = \"CHAN 1: 90 DEG\", 3 = \"CHAN 3: 0 DEG\";";
        assert!(ambiguous("deg").contains(deg), "{}", ambiguous("deg"));
        assert!(ambiguous("chan").contains("fits 4 components"), "{}", ambiguous("chan"));
        for declared in ["9", "5", "", " ", "45", "chan 1: up", "8W"] {
            let found = chosen(&channels, Some(declared));
            let unknown = matches!(&found, Err(refused) if refused.to_string().contains("but the file holds"));
            assert!(unknown, "{declared}: {found:?}");
        }
    }
}
