//! Tests of folders of results: allowed places, and messages about others.

use std::fs;

use insta::assert_snapshot;
use serde_json::json;

use crate::assess::{TOWERS, assess, workplace};
use crate::results::{files, meeting, results, run_in, text};
use crate::{folder, pounding, refusal};

#[test]
fn extreme_folders_that_hold_other_things() {
    let folder = folder("other_things");
    let out = folder.join("out");
    fs::create_dir(&out).expect("made");
    fs::write(out.join("thesis.tex"), "years of work").expect("written");
    let refused = run_in(&folder, &meeting(), &["--out", "out"]);
    assert_snapshot!(refusal(&refused), @r#"error: --out: out holds other things than results, such as "thesis.tex"; allowed is a folder that does not exist, is empty or holds the results of an earlier run: name another, or let --overwrite put the results beside them"#);
    assert_eq!(files(&out).len(), 1, "nothing was written");
    let forced = run_in(&folder, &meeting(), &["--out", "out", "--overwrite"]);
    assert_eq!((forced.code, forced.stderr.as_str()), (0, ""));
    assert_eq!(text(out.join("thesis.tex")), "years of work");
    assert_eq!(
        files(&out).len(),
        12,
        "three figures twice, the animation, four files, and the thesis"
    );
    assert_eq!(
        fs::read_dir(&folder).expect("there").count(),
        3,
        "scene, record and results: nothing else is left"
    );
}

#[test]
fn extreme_files_of_our_names_that_are_not_ours() {
    let folder = folder("not_ours");
    fs::create_dir(folder.join("out")).expect("made");
    fs::write(folder.join("out/history.csv"), "measured").expect("written");
    let refused = run_in(&folder, &meeting(), &["--out", "out"]);
    assert_snapshot!(refusal(&refused), @r#"error: --out: out holds other things than results, such as "history.csv"; allowed is a folder that does not exist, is empty or holds the results of an earlier run: name another, or let --overwrite put the results beside them"#);
}

#[test]
fn limit_results_of_an_earlier_run_are_replaced() {
    let mut yielding = meeting();
    yielding["structures"][0]["sdof"]["yield_force_n"] = json!(1e-9);
    let out = results("replaced", &yielding);
    assert!(out.join("hysteresis.svg").exists(), "one can yield");
    let folder = out.parent().expect("a folder");
    let again = run_in(folder, &meeting(), &["--out", "out"]);
    assert_eq!((again.code, again.stderr.as_str()), (0, ""));
    assert!(!out.join("hysteresis.svg").exists(), "nobody yields now");
}

#[test]
fn extreme_places_that_are_no_folder() {
    let folder = folder("no_folder");
    fs::write(folder.join("taken"), "").expect("written");
    let refused = run_in(&folder, &meeting(), &["--out", "taken"]);
    assert_snapshot!(refusal(&refused), @"error: --out: taken is a file, allowed is a folder; name another");
    let refused = run_in(&folder, &meeting(), &["--out", "taken/deeper"]);
    let missing = fs::create_dir_all(folder.join("taken/deeper")).expect_err("a file is no folder");
    let message = refusal(&refused).replace(&missing.to_string(), "[what the system says]");
    assert_snapshot!(message, @"error: --out: taken/deeper: [what the system says]");
    let deeper = run_in(&folder, &meeting(), &["--out", "new/and/deeper"]);
    assert_eq!(deeper.code, 0, "folders on the way are made: {}", deeper.stderr);
    let here = run_in(&folder, &meeting(), &["--out", ".."]);
    assert_snapshot!(refusal(&here), @"error: --out: .. has no name to write a folder under; name a folder in it");
}

/// Twelve result files among the records were reported as unreadable motions.
#[test]
fn issue_results_do_not_go_among_the_records() {
    let work = workplace("among_records", TOWERS);
    for command in ["assess", "run"] {
        let asked = [command, "scene.toml", "--records", "records", "--out", "records", "--overwrite"];
        let refused = pounding(&work, &asked);
        assert_eq!(files(&work.join("records")).len(), 2, "{command}");
        assert!(refusal(&refused).contains("is the folder of the records"), "{command}");
    }
}

/// `assess` refused to replace the folder of its own earlier run.
#[test]
fn issue_an_earlier_assessment_is_replaced() {
    let work = workplace("assessed_again", TOWERS);
    for scale in ["pga=0.6g", "pga=0.2g"] {
        let ended = assess(&work, &["--scale", scale, "--out", "out"]);
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
        assert!(text(work.join("out/report.html")).contains(scale), "{scale}");
    }
}
