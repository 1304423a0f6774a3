//! Common mistakes in files, for messages that say more than the reader of JSON or TOML.

use pounding_text::Refused;

/// Refuses an unknown field. It may show what kind of file this is instead.
pub(super) fn unknown_field(found: &str, allowed: &[&str]) -> Refused {
    let allows = |field: &str| allowed.contains(&field);
    let (of_scene, of_sweep) = (allows("structures") && allows("contacts"), allows("vary"));
    let has = |kind: &str| Refused::default().found(format!("`{found}`, which a {kind} has"));
    match found {
        "title" | "scenes" | "output" | "notes" if of_scene => {
            has("study").so(": ", "a scene is one entry of its `scenes`, in a file of its own")
        }
        "scene" | "vary" | "samples" | "directions" | "outputs" | "verdict" if of_scene => {
            has("sweep").allowed_is("a scene").help("`pounding sweep` runs a sweep")
        }
        "name" | "duration_s" | "structures" | "contacts" | "arrivals_s" | "method" if of_sweep => has("scene")
            .allowed_is("a sweep, which names a scene in `scene` and what varies in `vary`")
            .help("`pounding run` runs a scene alone"),
        _ => {
            let field = Refused::default().found(format!("the field `{found}`"));
            if allowed.is_empty() {
                field.allowed_are("none").help("delete it")
            } else {
                listed(field, found, allowed)
            }
        }
    }
}

/// Refuses an unknown choice.
pub(super) fn unknown_choice(found: &str, allowed: &[&str]) -> Refused {
    listed(Refused::default().found(format!("`{found}`")), found, allowed)
}

/// Replacements for a backslash.
pub(crate) const FOR_A_BACKSLASH: [&str; 2] = [
    "/ in its place, or single quotes: 'records\\quake.csv'",
    "/ in its place, or two of them",
];

/// Recognizes a common mistake in a line that is not valid TOML or JSON.
pub(crate) fn of_line(line: &str, is_json: bool) -> Option<Refused> {
    let assigns = if is_json { ':' } else { '=' };
    let mut values = line.split(assigns).skip(1).map(str::trim_start);
    if let Some(number) = values.find_map(decimal_comma) {
        let right = number.replace('.', "").replace(',', ".");
        let comma = Refused::default().found(format!("`{number}` with a decimal comma"));
        return Some(comma.allowed_is(format!("a decimal point: `{right}`")));
    }
    let is_quoted = line.find('\\') > line.find('"') && line.contains('"');
    let backslash = Refused::default().found("a backslash in double quotes, where it begins an escape such as \\n");
    is_quoted.then(|| backslash.allowed_is(FOR_A_BACKSLASH[usize::from(is_json)]))
}

/// Returns the number with a decimal comma at the start of a text.
fn decimal_comma(text: &str) -> Option<String> {
    let (whole, rest) = text.split_once(',')?;
    let is_number = |text: &str| {
        let digits = text.trim_start_matches(['+', '-']);
        let mut parts = digits.split('.');
        let is_digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        // Points may separate thousands: `500.000,0`.
        parts.next().is_some_and(is_digits) && parts.all(|part| part.len() == 3 && is_digits(part))
    };
    let end = rest.find(|letter: char| !letter.is_ascii_digit());
    let part = &rest[..end.unwrap_or(rest.len())];
    (is_number(whole) && !part.is_empty()).then(|| format!("{whole},{part}"))
}

/// Least similarity at which a word counts as a misspelling of another \[–\].
const ALIKE: f64 = 0.8;

/// Lists the allowed words, and suggests the nearest one.
fn listed(refused: Refused, found: &str, allowed: &[&str]) -> Refused {
    let words: Vec<_> = allowed.iter().map(|word| format!("`{word}`")).collect();
    let refused = refused.allowed_are(words.join(", "));
    let likeness = |word: &&&str| strsim::jaro_winkler(found, word);
    let nearest = allowed.iter().max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
    match nearest.filter(|word| likeness(word) > ALIKE) {
        Some(word) => refused.help(format!("perhaps `{word}` is meant")),
        None => refused,
    }
}
