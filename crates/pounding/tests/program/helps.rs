//! What `--help` says of the program and of each command; those of `motion` and `export` stand with their tests.

use std::path::Path;

use insta::assert_snapshot;

use crate::pounding;
use crate::runs::printed;

/// A command that is cut in two cannot be copied: every line of the examples begins as it was written.
#[test]
fn issue_no_example_is_broken_at_80_columns() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let commands = "advise certify check compare completions demo export gap init laws merge run schema sweep motion";
    let of_motion = ["info", "convert", "spectrum"].map(|command| vec!["motion", command]);
    let commands = commands.split(' ').map(|command| vec![command]);
    for command in commands.chain(of_motion) {
        let help = pounding(here, &[&command[..], &["--help"]].concat());
        let lines = printed(&help).lines();
        let examples = lines.skip_while(|line| !line.starts_with("Example"));
        let examples: Vec<&str> = examples
            .skip(1)
            .take_while(|line| !line.is_empty())
            .collect();
        assert!(!examples.is_empty(), "{command:?} shows how");
        for line in examples {
            let whole = line.starts_with("  pounding ") || line.starts_with("    --");
            let other = line.starts_with("  pip ") || line.starts_with("  python3 ");
            assert!(whole || other, "{command:?}: {line}");
            assert!(
                line.chars().count() < 80,
                "{command:?}: {line} touches the edge"
            );
        }
    }
}

#[test]
fn reference_help() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    assert_snapshot!("help", printed(&pounding(here, &["--help"])));
    for command in [
        "advise",
        "certify",
        "check",
        "compare",
        "completions",
        "demo",
        "gap",
        "init",
        "laws",
        "merge",
        "run",
        "schema",
        "sweep",
    ] {
        let help = pounding(here, &[command, "--help"]);
        let help = printed(&help);
        assert!(help.contains("Example"), "{command} shows how");
        assert_snapshot!(format!("help_{command}"), help);
    }
}
