//! What words mean.

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
