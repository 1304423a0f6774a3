//! Names of structures as parts of the names of columns: letters, digits and underscores.

use pounding_scene::Floors;

/// Part of a column's name for every floor and every pair of a scene, each unlike the others.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Names {
    pub(super) structures: Vec<String>,
    pub(super) pairs: Vec<String>,
}

impl Names {
    pub(super) fn of(floors: &Floors) -> Self {
        let mut structures = Vec::new();
        for (index, floor) in floors.all().iter().enumerate() {
            let plain = plain(&floor.name);
            let name = if plain.is_empty() {
                format!("structure_{}", index + 1)
            } else {
                plain
            };
            add(&mut structures, name);
        }
        let mut pairs = Vec::new();
        for facing in floors.facing() {
            let name = match facing.column {
                None => format!("{}_{}", structures[facing.left], structures[facing.right]),
                Some(_) => floors.names_of(facing).map(|name| plain(&name)).join("_"),
            };
            add(&mut pairs, name);
        }
        Self { structures, pairs }
    }
}

/// Adds a name; one that is taken gets a number behind it.
fn add(names: &mut Vec<String>, name: String) {
    let taken = |wanted: &String| names.contains(wanted);
    let name = if taken(&name) {
        let mut numbered = (2..).map(|number| format!("{name}_{number}"));
        let free = numbered.find(|wanted| !taken(wanted));
        free.expect("there are more numbers than names")
    } else {
        name
    };
    names.push(name);
}

/// Small letters, digits and single underscores between them.
fn plain(name: &str) -> String {
    let mut plain = String::new();
    for letter in name.chars().flat_map(char::to_lowercase) {
        match letter {
            'a'..='z' | '0'..='9' => plain.push(letter),
            'ä' | 'æ' => plain.push_str("ae"),
            'ö' | 'ø' => plain.push_str("oe"),
            'ü' => plain.push_str("ue"),
            'ß' => plain.push_str("ss"),
            'à'..='å' => plain.push('a'),
            'ç' => plain.push('c'),
            'è'..='ë' => plain.push('e'),
            'ì'..='ï' => plain.push('i'),
            'ñ' => plain.push('n'),
            'ò'..='õ' => plain.push('o'),
            'ù'..='û' => plain.push('u'),
            _ if plain.is_empty() || plain.ends_with('_') => {}
            _ => plain.push('_'),
        }
    }
    plain.truncate(plain.trim_end_matches('_').len());
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_names_become_letters_digits_and_underscores() {
        for (name, wanted) in [
            ("old", "old"),
            ("Bürohaus, Süd", "buerohaus_sued"),
            ("<b>Tower</b> 2", "b_tower_b_2"),
            ("  A—B  ", "a_b"),
            ("Señor Müller's", "senor_mueller_s"),
            ("塔", ""),
            ("", ""),
        ] {
            assert_eq!(plain(name), wanted, "{name:?}");
        }
    }

    #[test]
    fn extreme_names_that_become_alike_stay_apart() {
        let mut names = Vec::new();
        for name in ["a", "a", "a_2", "a"] {
            add(&mut names, name.into());
        }
        assert_eq!(names, ["a", "a_2", "a_2_2", "a_3"]);
    }
}
