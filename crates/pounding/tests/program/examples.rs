//! Tests of the library's examples: they run and print what their first lines say.

use std::fs;
use std::path::Path;
use std::process::Command;

/// The output that the first lines of a source announce.
fn said(source: &str) -> String {
    let lines = source.lines().map_while(|line| line.strip_prefix("//!"));
    let lines = lines.map(|line| line.strip_prefix(' ').unwrap_or(line));
    let block = lines.skip_while(|line| *line != "```text").skip(1);
    let block = block.take_while(|line| *line != "```");
    block.fold(String::new(), |text, line| text + line + "\n")
}

#[test]
fn limit_every_example_prints_what_it_says() {
    // Cargo builds the examples with the tests of this package, next to this test's folder.
    let test = std::env::current_exe().unwrap();
    let built = test.parent().unwrap().parent().unwrap().join("examples");
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut count = 0;
    for source in fs::read_dir(sources).unwrap() {
        let source = source.unwrap().path();
        let example = built.join(source.file_stem().unwrap());
        let ran = Command::new(&example)
            .output()
            .unwrap_or_else(|error| panic!("{}: {error}; cargo build --package pounding --examples", example.display()));
        let printed = String::from_utf8(ran.stdout).unwrap();
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        let text = fs::read_to_string(&source).unwrap();
        assert_eq!(printed, said(&text), "{}", source.display());
        count += 1;
    }
    assert_eq!(count, 4, "examples");
}
