//! Tests of `--help` for the program and each command.

use std::path::Path;

use insta::assert_snapshot;

use crate::pounding;
use crate::runs::printed;

/// The commands that a help lists.
fn commands(help: &str) -> Vec<String> {
    let lines = help.lines().skip_while(|line| !line.starts_with("Commands:"));
    let listed = lines.skip(1).take_while(|line| !line.is_empty());
    let named = listed.filter(|line| !line.starts_with("   "));
    let words = named.filter_map(|line| line.split_whitespace().next());
    words.filter(|word| *word != "help").map(String::from).collect()
}

/// The words of every command and subcommand with its help.
fn every_help(here: &Path) -> Vec<(Vec<String>, String)> {
    let help_of = |words: &[&str]| printed(&pounding(here, &[words, &["--help"]].concat())).to_string();
    let mut all = Vec::new();
    for command in commands(&help_of(&[])) {
        let help = help_of(&[&command]);
        for second in commands(&help) {
            let help = help_of(&[&command, &second]);
            all.push((vec![command.clone(), second], help));
        }
        all.push((vec![command], help));
    }
    assert!(all.len() > 15, "the list of commands is not found");
    all
}

/// A command that is broken over two lines cannot be copied: every line of the examples begins as written.
#[test]
fn issue_no_example_is_broken_at_80_columns() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (command, help) in every_help(here) {
        let lines = help.lines();
        let examples = lines.skip_while(|line| !line.starts_with("Example"));
        let examples: Vec<&str> = examples.skip(1).take_while(|line| !line.is_empty()).collect();
        assert!(!examples.is_empty(), "{command:?} shows how");
        for line in examples {
            let whole = line.starts_with("  pounding ") || line.starts_with("    --");
            let other = line.starts_with("  pip ") || line.starts_with("  python3 ");
            assert!(whole || other, "{command:?}: {line}");
            assert!(line.chars().count() < 80, "{command:?}: {line} touches the edge");
        }
    }
}

#[test]
fn reference_help() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    assert_snapshot!("help", printed(&pounding(here, &["--help"])));
    for (command, help) in every_help(here) {
        assert!(help.contains("Example"), "{command:?} shows how");
        assert_snapshot!(format!("help_{}", command.join("_")), help);
    }
}
