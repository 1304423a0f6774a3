//! A circle in a graph.

use std::collections::{BTreeMap, BTreeSet};

/// A circle of arrows, from a name back to itself; `None` if there is none.
pub(super) fn circle(arrows: &BTreeMap<String, BTreeSet<String>>) -> Option<Vec<&str>> {
    let mut done = BTreeSet::new();
    arrows.keys().find_map(|name| from(name, arrows, (&mut Vec::new(), &mut done)))
}

/// A circle that is reached from a name. No name occurs twice on the `way`. Names that are `done` reach no circle.
fn from<'a>(
    name: &'a str,
    arrows: &'a BTreeMap<String, BTreeSet<String>>,
    (way, done): (&mut Vec<&'a str>, &mut BTreeSet<&'a str>),
) -> Option<Vec<&'a str>> {
    if let Some(start) = way.iter().position(|known| *known == name) {
        let mut found = way[start..].to_vec();
        found.push(name);
        return Some(found);
    }
    if done.contains(name) {
        return None;
    }
    way.push(name);
    let next = arrows.get(name).into_iter().flatten();
    for next in next {
        let found = from(next, arrows, (way, done));
        if found.is_some() {
            return found;
        }
    }
    way.pop();
    done.insert(name);
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(arrows: &[(&str, &[&str])]) -> BTreeMap<String, BTreeSet<String>> {
        let owned = |names: &[&str]| names.iter().map(ToString::to_string).collect();
        let arrows = arrows.iter();
        arrows.map(|(from, to)| ((*from).into(), owned(to))).collect()
    }

    #[test]
    fn reference_circles_of_two_and_three() {
        let tree = graph(&[("a", &["b", "c"]), ("b", &["c"]), ("c", &[])]);
        assert_eq!(circle(&tree), None);
        let two = graph(&[("a", &["b"]), ("b", &["c"]), ("c", &["b"])]);
        assert_eq!(circle(&two), Some(vec!["b", "c", "b"]));
        let three = graph(&[("a", &["b"]), ("b", &["c"]), ("c", &["a"])]);
        assert_eq!(circle(&three), Some(vec!["a", "b", "c", "a"]));
    }
}
