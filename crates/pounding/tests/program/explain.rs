//! Tests of `pounding explain`.

use crate::runs::printed;
use crate::{folder, pounding, refusal};
use insta::assert_snapshot;

#[test]
fn reference_a_word_is_explained() {
    let folder = folder("explain");
    assert_snapshot!(printed(&pounding(&folder, &["explain", "ductility"])));
    let all = pounding(&folder, &["explain"]);
    assert!(printed(&all).contains("leaning"), "{}", all.stdout);
}

#[test]
fn extreme_a_word_that_nobody_knows_has_a_nearest() {
    let folder = folder("explain_none");
    assert_snapshot!(refusal(&pounding(&folder, &["explain", "ductillity"])), @r#"error: found no word "ductillity", allowed are those that `pounding explain` lists; the nearest is "ductility [μ]""#);
}

/// Words that newcomers looked up were missing, both of modelled and of unmodelled things.
#[test]
fn issue_words_of_newcomers_are_explained() {
    let folder = folder("explain_more");
    for (word, says) in [
        ("p-delta", "let it act"),
        ("P-Δ", "let it act"),
        ("pdelta", "let it act"),
        ("base isolator", "first storey"),
        ("event", "components and copies"),
        ("bumper", "pressed flat"),
        ("link", "restrainer between two floors"),
        ("isolator", "first storey"),
        ("isolation", "first storey"),
        ("damper", "is a link"),
        ("lanes", "vector"),
        ("hunt_crossley", "Hunt & Crossley"),
    ] {
        let said = printed(&pounding(&folder, &["explain", word])).replace('\n', " ");
        let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains(says), "{word}: {said}");
    }
}
