//! What `--help` says of the program and of each command; those of `motion` and `export` stand with their tests.

use std::path::Path;

use insta::assert_snapshot;

use crate::pounding;
use crate::runs::printed;

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
        "run",
        "schema",
    ] {
        let help = pounding(here, &[command, "--help"]);
        let help = printed(&help);
        assert!(help.contains("Example"), "{command} shows how");
        assert_snapshot!(format!("help_{command}"), help);
    }
}
