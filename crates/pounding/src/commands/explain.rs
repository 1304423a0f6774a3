//! `pounding explain`: what a word of the program means.

use pounding::contact::LawName;
use pounding::text::{Answer, Form, Refused, Where};

const EXAMPLES: &str = "\
Examples:
  pounding explain ductility
  pounding explain \"transferred momentum\"
  pounding explain                       # all words";

/// The page of words: each has a line that begins with the word in bold.
const GLOSSARY: &str = include_str!("../../assets/glossary.md");

/// The arguments of `explain`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The word, or a part of it; by default all words are listed.
    #[arg(value_name = "WORD", num_args = 0..)]
    words: Vec<String>,
}

/// A word, and what it means.
struct Entry {
    word: String,
    meaning: String,
}

/// Says what a word means.
///
/// # Errors
/// Names the nearest word, if the word is not known.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let entries = entries();
    if args.words.is_empty() {
        let words: Vec<&str> = entries.iter().map(|one| one.word.as_str()).collect();
        return Ok(Answer::new()
            .say(Where::Terminal, "Words", vec![words.join("; ")])
            .text(Form::Brief));
    }
    let asked = args.words.join(" ");
    let wanted = asked.to_lowercase();
    // The page has words in the singular.
    let singular = wanted.strip_suffix('s').unwrap_or(&wanted);
    // `pdelta` is P-Δ's other spelling.
    let bare = |text: &str| -> String { text.chars().filter(|one| one.is_alphanumeric()).collect() };
    let bare_word = bare(singular);
    let names = |entry: &&Entry| {
        let word = entry.word.to_lowercase();
        word.contains(&wanted) || (!bare_word.is_empty() && bare(&word).contains(&bare_word))
    };
    let mentions = |entry: &&Entry| entry.meaning.to_lowercase().contains(&wanted);
    // The last word is the noun: a `base isolator` is an isolator.
    let noun = wanted.rsplit(' ').next().filter(|noun| noun.len() > 3);
    let is_kind = |entry: &&Entry| noun.is_some_and(|noun| entry.word.to_lowercase().contains(noun));
    let ways: [&dyn Fn(&&Entry) -> bool; 3] = [&names, &mentions, &is_kind];
    let found = ways.iter().map(|way| entries.iter().filter(*way).collect::<Vec<_>>());
    let found = found.into_iter().find(|found| !found.is_empty()).unwrap_or_default();
    if found.is_empty() {
        return Err(not_known(&asked, &entries));
    }
    let answer = found.into_iter().fold(Answer::new(), |answer, one| {
        answer.say(Where::Terminal, "Word", vec![one.word.clone(), one.meaning.clone()])
    });
    Ok(answer.text(Form::Brief))
}

fn not_known(asked: &str, entries: &[Entry]) -> Refused {
    let likeness = |entry: &Entry| strsim::jaro_winkler(&entry.word, asked);
    let nearest = entries.iter().max_by(|one, other| likeness(one).total_cmp(&likeness(other)));
    let nearest = nearest.map_or("", |entry| entry.word.as_str());
    let none = Refused::default().found(format!("no word \"{asked}\""));
    let none = none.allowed_are("those that `pounding explain` lists");
    none.help(format!("the nearest is \"{nearest}\""))
}

/// The words of the page, whose meanings continue over indented lines, and the contact laws.
fn entries() -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for line in GLOSSARY.lines() {
        if let Some((word, meaning)) = line.strip_prefix("- **").and_then(|line| line.split_once("**")) {
            // The symbol and unit stand between the word and the colon.
            let (unit, meaning) = meaning.split_once(':').unwrap_or(("", meaning));
            entries.push(Entry {
                word: format!("{word}{unit}"),
                meaning: meaning.trim().into(),
            });
        } else if let (Some(text), Some(last)) = (line.strip_prefix("  "), entries.last_mut()) {
            last.meaning.push(' ');
            last.meaning.push_str(text.trim());
        }
    }
    let law = |law: LawName| Entry {
        word: law.name().into(),
        meaning: format!(
            "contact law {}, {}. Source: {}. `pounding laws` prints its fields and formulas.",
            law.named().label,
            law.about().force,
            law.named().citation
        ),
    };
    entries.extend(LawName::ALL.map(law));
    entries
}
