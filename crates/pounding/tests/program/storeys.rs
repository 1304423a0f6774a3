//! Tests of pairs of storeys: gaps, comparisons, effects and figures of rows of buildings.

use std::fs;
use std::path::{Path, PathBuf};

use pounding::report::Summary;
use pounding::scene::{FloorQuantity, PairQuantity};
use serde_json::Value;

use crate::runs::printed;
use crate::{folder, pounding};

/// Four storeys beside seven, with a wall on the other side.
const ROW: &str = r#"
name = "row"
record.generated.stochastic = { ground = "medium", pga_m_per_s2 = 4, strong_from_s = 1, strong_until_s = 4, decay_per_s = 0.8, duration_s = 8, time_step_s = 0.02, cutoff_hz = 20, seed = 3 }
[[structures]]
[structures.building]
name = "four"
period_s = 0.45
damping.ratio = 0.05
storeys = [{ mass_kg = 2e5, height_m = 3.0, repeat = 4 }]
[[structures]]
[structures.building]
name = "seven"
period_s = 0.9
damping.ratio = 0.05
storeys = [{ mass_kg = 2e5, height_m = 3.0, repeat = 7 }]
[[structures]]
wall = {}
[[contacts]]
gap_m = 0.01
law.kelvin_voigt = { impact_stiffness_n_per_m = 1e9, restitution = 0.6 }
[[contacts]]
gap_m = 0.02
law.kelvin_voigt = { impact_stiffness_n_per_m = 1e9, restitution = 0.6 }
"#;

/// A folder with the row and changed copies of it: file name, old text, new text.
fn rows(test: &str, changes: &[[&str; 3]]) -> PathBuf {
    let folder = folder(test);
    fs::write(folder.join("row.toml"), ROW).expect("a file");
    for [file, from, to] in changes {
        let text = ROW.replacen(from, to, 1);
        assert_ne!(text, ROW, "{from}");
        fs::write(folder.join(file), text).expect("a file");
    }
    folder
}

fn summary(folder: &Path, file: &str) -> Summary {
    let ended = pounding(folder, &["run", file, "--no-error", "--json"]);
    serde_json::from_str(&ended.stdout).expect("a summary")
}

/// The cells of a line of a comparison, as words.
fn cells(text: &str, heading: &str, name: &str) -> Vec<String> {
    let (_, below) = text.split_once(heading).unwrap_or_else(|| panic!("{heading}: {text}"));
    let line = below.lines().find(|line| line.trim_start().starts_with(name));
    let line = line.expect("a line").trim_start().trim_start_matches(name);
    let words = line.split_whitespace().map(String::from);
    // Columns of changes are left out.
    words.filter(|word| !word.ends_with('%')).collect()
}

/// Pairs of storeys were looked up by the index of their contact and had no names: they showed gaps of others and no collisions. Drifts
/// were not compared.
#[test]
fn issue_pairs_of_storeys_are_compared_with_their_own_likes() {
    let folder = rows("storeys_compare", &[["top.toml", "gap_m = 0.01", "gap_m = 0.015\nlevels = [4]"]]);
    let ended = pounding(&folder, &["compare", "row.toml", "top.toml", "--no-error", "--all"]);
    let text = printed(&ended);
    let runs = [summary(&folder, "row.toml"), summary(&folder, "top.toml")];
    let hits = |run: &Summary, left: &str| {
        let pair = run.pairs.iter().find(|pair| pair.left == left);
        pair.map_or("–".to_string(), |pair| pair.collisions().to_string())
    };
    for (floor, gaps) in [(3, ["10.00", "–"]), (4, ["10.00", "15.00"])] {
        let heading = format!("Pair 1, floor {floor}");
        assert_eq!(cells(text, &heading, "gap [mm]"), gaps);
        let wanted = [0, 1].map(|run| hits(&runs[run], &format!("four, floor {floor}")));
        assert_eq!(cells(text, &heading, "collisions"), wanted);
    }
    let wanted = [0, 1].map(|run| hits(&runs[run], "seven, floor 7"));
    assert_ne!(wanted[0], "0", "it hits the wall");
    assert_eq!(cells(text, "Pair 2, floor 7", "collisions"), wanted);
    let drift = |run: &Summary| {
        let floor = run.structures.iter().find(|one| one.name == "seven, floor 5");
        let drift = floor.and_then(|one| one.numbers.get(FloorQuantity::PeakDriftM)).expect("a drift");
        pounding::text::short(1e3 * drift)
    };
    let found = cells(text, "Structure 2, floor 5", "peak drift [mm]");
    assert_eq!(found, [drift(&runs[0]), drift(&runs[1])]);
}

/// The widths were those of all facing floors, whatever `levels` said, and no level was named.
#[test]
fn issue_gaps_look_at_the_floors_that_can_touch() {
    let folder = rows(
        "storeys_gap",
        &[
            ["low.toml", "gap_m = 0.02", "gap_m = 0.02\nlevels = [1, 2]"],
            ["travels.toml", "name = \"row\"", "name = \"row\"\narrivals_s = [0, 0.1, 0.2]"],
        ],
    );
    let records = folder.join("records");
    fs::create_dir(&records).expect("a folder");
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let record = "el-centro-1940-ns-chopra.csv";
    fs::copy(here.join("../../studies/records").join(record), records.join(record)).expect("a copy");
    let gap = |file: &str| {
        let ended = pounding(&folder, &["gap", file, "--records", "records", "--json"]);
        let json: Value = serde_json::from_str(&ended.stdout).expect("JSON");
        json["motions"][0]["gaps"][1].clone()
    };
    let (all, low) = (gap("row.toml"), gap("low.toml"));
    assert_eq!((&all["level"], &low["level"]), (&7.into(), &2.into()));
    let [all, low] = [all, low].map(|gap| gap["required_m"].as_f64().expect("a width"));
    assert!(low < 0.6 * all, "{low} {all}");
    let text = |file: &str| {
        let ended = pounding(&folder, &["gap", file, "--records", "records"]);
        printed(&ended).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let words = "The ground travels along the row";
    assert!(text("travels.toml").contains(words) && !text("row.toml").contains(words));
    assert!(text("row.toml").contains("Record Level Needs"), "{}", text("row.toml"));
}

/// Storeys that did not touch filled tables with ones.
#[test]
fn issue_effects_say_what_there_is_none_of() {
    let folder = rows("storeys_effects", &[["far.toml", "gap_m = 0.01", "gap_m = 1.0"]]);
    let far = fs::read_to_string(folder.join("far.toml")).expect("a file");
    fs::write(folder.join("far.toml"), far.replace("gap_m = 0.02", "gap_m = 1.0")).expect("a file");
    let ended = pounding(&folder, &["run", "far.toml", "--effects", "--out", "far"]);
    let text = printed(&ended);
    assert!(text.contains("none: nothing touches") && !text.contains("× alone"), "{text}");
    let page = fs::read_to_string(folder.join("far/report.html")).expect("a page");
    assert!(page.contains("None: nothing touches") && !page.contains("× alone"));
}

/// The caption "curves that meet are structures that touch" was also under figures of moving bases and of several levels, where it is
/// false.
#[test]
fn issue_captions_say_what_is_true_of_their_figures() {
    let travels = ["travels.toml", "name = \"row\"", "name = \"row\"\narrivals_s = [0, 0.05, 0.1]"];
    let folder = rows("storeys_figure", &[travels]);
    for (file, caption) in [
        ("row.toml", "Floors touch where their curves meet"),
        ("travels.toml", "so that floors need not touch where their curves meet"),
    ] {
        let ended = pounding(&folder, &["run", file, "--json", "--out", "out", "--overwrite"]);
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{file}");
        let page = fs::read_to_string(folder.join("out/report.html")).expect("a page");
        assert!(page.contains(caption), "{file}");
        assert!(!page.contains("curves that meet are structures that touch"), "{file}");
        assert!(page.contains("pairs of floors the 4 that are hit hardest"), "{file}");
    }
}

/// A touch of almost half a second counted as an ordinary collision.
#[test]
fn issue_what_leans_is_said() {
    // The ground motion presses the tower against the wall.
    let scene = r#"
name = "pressed"
record.generated.half_sine = { amplitude_m_per_s2 = 3, duration_s = 1.5, time_step_s = 0.01 }
[[structures]]
sdof = { name = "tower", mass_kg = 2e5, period_s = 0.2, damping.ratio = 0.3 }
[[structures]]
wall = {}
[[contacts]]
gap_m = 0.0005
law.kelvin_voigt = { impact_stiffness_n_per_m = 1e9, restitution = 0.3 }
"#;
    let folder = folder("storeys_leaning");
    fs::write(folder.join("left.toml"), scene).expect("a file");
    let reversed = scene.replace("[[structures]]\nsdof", "record.reversed = true\n[[structures]]\nsdof");
    fs::write(folder.join("right.toml"), reversed).expect("a file");
    let texts = ["left.toml", "right.toml"].map(|file| {
        let run = summary(&folder, file);
        let ended = pounding(&folder, &["run", file, "--no-error"]);
        let text = printed(&ended).to_string();
        assert_eq!(run.pairs[0].leaning.is_some(), text.contains("Leaning"), "{text}");
        (run.pairs[0].leaning, run.pairs[0].number(PairQuantity::TouchingS).expect("a time"))
    });
    let leans = texts.iter().find_map(|(leaning, touching)| Some(((*leaning)?, *touching)));
    let (longest, touching) = leans.expect("one of the directions presses");
    let longest = longest.end_s - longest.start_s;
    assert!(longest > 0.3 && touching >= longest, "{longest} {touching}");
}
