//! Tests of the pages that a client reads: their order, what was assumed, and what the model leaves out.

use std::fs;
use std::path::Path;

use crate::assess::{TOWERS, assess, workplace};
use crate::{folder, pounding};

fn page(work: &Path) -> String {
    fs::read_to_string(work.join("out/report.html")).expect("a page")
}

/// Where words stand in a page.
fn at(page: &str, words: &str) -> usize {
    page.find(words).unwrap_or_else(|| panic!("no {words}"))
}

/// Words of a page in their order.
fn in_order(page: &str, words: &[&str]) {
    let places: Vec<usize> = words.iter().map(|one| at(page, one)).collect();
    assert!(places.is_sorted(), "{words:?}: {places:?}");
}

/// The page had two boxes with one answer, its warnings stood below the numbers, and it spoke of gaps where it meant pairs of floors. Neither
/// assumptions nor limits of the model were in it.
#[test]
fn issue_a_report_says_what_it_assumes_and_leaves_out() {
    let weak = TOWERS.replace("yield_drift_ratio = 0.005", "yield_drift_ratio = 0.001");
    let work = workplace("page_of_a_run", &weak);
    let ended = pounding(&work, &["run", "scene.toml", "--out", "out"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let page = page(&work);
    in_order(
        &page,
        &[
            "Before the numbers are believed",
            "class=\"verdict",
            "<strong>Shaken ",
            " pairs of floors.</li>",
            "Not modelled here, and important for this scene",
            "What was assumed",
            "Appendix",
        ],
    );
    assert_eq!(page.matches("class=\"verdict").count(), 1, "one box answers");
    for said in [
        "Loss of strength",
        "Eccentricity in plan",
        "Slabs as distributed masses",
        "<td>Damping<small>Tower 8, Tower 5</small></td>",
        "a stiffness of the literature, not of these slabs",
        "level, by the heights of the storeys",
        "Tower 8 (left end) – Tower 5",
        "Workshop (right end)",
        "Force of the hardest blow",
    ] {
        at(&page, said);
    }
    assert!(!page.contains("Soil behind a wall") && !page.contains('`'));
    assert!(work.join("out/blow.svg").is_file());
}

/// The spectra were missing, and rules of codes stood in the appendix without their form.
#[test]
fn issue_an_assessment_shows_spectra_and_rules_first() {
    let work = workplace("page_of_an_assessment", TOWERS);
    let options = ["--target", "ec8:a_g=0.25g,ground=C", "--out", "out"];
    let ended = assess(&work, &options);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let page = page(&work);
    in_order(
        &page,
        &[
            "Before the numbers are believed",
            "class=\"verdict",
            "Not modelled here, and important for this scene",
            "Spectra for 5 % of damping",
            "Required gap",
            "Rules of codes beside the time history",
            "Time history, largest",
            "√(u₁² + u₂²)",
            "What was assumed",
            "Appendix",
        ],
    );
    at(&page, "dashed: the target");
    at(&page, "Tower 8 (left end) – Tower 5");
    at(&page, "(0.");
    assert!(work.join("out/spectra.svg").is_file() && !page.contains('`'));
    // Without a target there are the records and their mean.
    let ended = assess(&work, &["--out", "out"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let page = self::page(&work);
    at(&page, "Spectra for 5 % of damping");
    assert!(!page.contains("dashed: the target"));
}

/// Sixty-seven seconds of axis showed twenty of motion.
#[test]
fn issue_time_axes_end_with_the_motion() {
    let work = folder("page_axes");
    let scene = r#"
name = "a push"
record.generated.half_sine = { amplitude_m_per_s2 = -4.0, duration_s = 0.5, time_step_s = 0.01 }
duration_s = 60.0
structures = [
  { sdof = { name = "a", mass_kg = 1e5, period_s = 1.0, damping.ratio = 0.2 } },
  { sdof = { name = "b", mass_kg = 1e5, period_s = 0.4, damping.ratio = 0.2 } },
]
contacts = [{ gap_m = 0.01, law.linear_spring.impact_stiffness_n_per_m = 1e8 }]
"#;
    fs::write(work.join("scene.toml"), scene).expect("a file");
    let ended = pounding(&work, &["run", "scene.toml", "--out", "out"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    at(&page(&work), "The axis ends soon after the last touch, the run at 60 s.");
    fs::write(work.join("scene.toml"), scene.replace("gap_m = 0.01", "gap_m = 1")).expect("a file");
    let ended = pounding(&work, &["run", "scene.toml", "--out", "out", "--overwrite"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let page = page(&work);
    let caption = &page[at(&page, "s to the end of the run, at 60 s") - 12..];
    let until: f64 = caption
        .split("From ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next()?.parse().ok())
        .expect("an instant");
    assert!((2.0..10.0).contains(&until), "{until}");
    // Whoever reads it on a phone is told that figures can be moved.
    at(&page, "Swipe sideways");
}
