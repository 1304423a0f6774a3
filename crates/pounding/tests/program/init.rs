//! Tests of `pounding init`.

use std::fs;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use serde_json::Value;

use crate::runs::printed;
use crate::suites::suite;
use crate::{folder, pounding, refusal};

/// Writes a scene for a record, both named relative to a folder. Returns the line that names the record, with the lines up to the next
/// blank one.
fn named(folder: &Path, scene: &str, record: &str) -> String {
    let wrote = pounding(folder, &["init", scene, "--record", record, "--overwrite"]);
    assert_eq!((wrote.code, wrote.stderr.as_str()), (0, ""), "{record}");
    let text = fs::read_to_string(folder.join(scene)).expect("it is there");
    let lines = text.lines().skip_while(|line| !line.starts_with("file"));
    let lines = lines.take_while(|line| !line.starts_with("# scale"));
    lines.collect::<Vec<_>>().join("\n")
}

fn text(path: PathBuf) -> String {
    fs::read_to_string(path).expect("a text")
}

#[test]
fn reference_a_scene_to_begin_with() {
    let folder = suite("init");
    let wrote = pounding(&folder, &["init"]);
    assert_snapshot!(printed(&wrote));
    let checked = pounding(&folder, &["check", "scene.toml"]);
    assert_snapshot!(printed(&checked));
    assert_snapshot!(refusal(&pounding(&folder, &["init"])), @"error: scene.toml: is there already, allowed is a new file; name another one or add --overwrite");
    assert_snapshot!(refusal(&pounding(&folder, &["init", "x.toml", "--record", "records"])), @"error: --record records: found a folder, allowed is a file; `pounding run SCENE --records` takes a folder");
    let missing = refusal(&pounding(&folder, &["init", "x.toml", "--record", "none.AT2"]));
    assert!(missing.starts_with("error: --record none.AT2: cannot be read: "), "{missing}");
    assert!(!folder.join("x.toml").exists(), "nothing was written");
}

/// A scene and the records in its folder, below it or beside it, can be moved together.
#[test]
fn reference_a_record_is_named_from_the_folder_of_the_scene() {
    let folder = suite("init_named");
    fs::create_dir_all(folder.join("scenes/old")).expect("a folder");
    for (scene, record, path) in [
        ("own.toml", "records/pulse.csv", "records/pulse.csv"),
        ("records/own.toml", "records/pulse.csv", "pulse.csv"),
        ("scenes/own.toml", "records/pulse.csv", "../records/pulse.csv"),
        ("scenes/old/own.toml", "./scenes/../records/pulse.csv", "../../records/pulse.csv"),
    ] {
        let file = format!("file = '{path}'    # seen from the folder of this file");
        assert_eq!(named(&folder, scene, record), file, "{scene}");
        let ran = pounding(&folder, &["run", scene]);
        assert_eq!((ran.code, ran.stderr.as_str()), (0, ""), "{scene}");
        assert!(!text(folder.join(scene)).contains(env!("CARGO_TARGET_TMPDIR")));
    }
    // A relative path from here would be too long to help, so the scene has an absolute path.
    fs::create_dir_all(folder.join("a/b/c/d")).expect("a folder");
    let far = named(&folder, "a/b/c/d/own.toml", "records/pulse.csv");
    assert!(
        far.starts_with("file = '") && far.ends_with("'    # absolute: other machines do not have it there"),
        "{far}"
    );
    assert_eq!(pounding(&folder, &["run", "a/b/c/d/own.toml"]).code, 0);
}

/// Data that a file lacks are comments in the scene, and must be given before the first run.
#[test]
fn reference_what_a_record_does_not_say_is_to_be_filled_in() {
    let folder = suite("init_missing");
    assert_snapshot!(named(&folder, "own.toml", "records/column.txt"));
    let wrote = pounding(&folder, &["init", "again.toml", "--record", "records/column.txt"]);
    assert_snapshot!(printed(&wrote));
    assert_eq!(pounding(&folder, &["run", "again.toml"]).code, 1, "it asks");
    let filled = text(folder.join("again.toml"))
        .replace("# unit", "unit")
        .replace("# time_step_s", "time_step_s");
    fs::write(folder.join("again.toml"), filled).expect("a file");
    let ran = pounding(&folder, &["run", "again.toml"]);
    assert_eq!((ran.code, ran.stderr.as_str()), (0, ""), "and runs");
    // The order of several records does not choose one.
    let several = "../../motion/tests/files/geonet.v2a";
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let several = here.join(several);
    fs::copy(several, folder.join("several.V2A")).expect("a file");
    assert_snapshot!(named(&folder, "own.toml", "several.V2A"));
}

#[test]
fn extreme_records_that_are_none() {
    let folder = suite("init_refused");
    let refused = |record: &str| refusal(&pounding(&folder, &["init", "--record", record]));
    assert_snapshot!(refused("records/spectra.V3"), @r#"error: --record records/spectra.V3: line 1 reads "Response and Fourier amplitude spectra (86 periods)", but only histories of acceleration are read; take the volume 2 file (.V2) of the record, these are spectra"#);
    let message = refused("towers.toml");
    let begins = "error: --record towers.toml: line 2 begins none of the formats";
    assert!(message.starts_with(begins), "{message}");
    assert!(!folder.join("scene.toml").exists(), "nothing was written");
}

/// The commented lines of the template.
#[test]
fn reference_a_wall_as_the_comments_show_it() {
    let folder = folder("init_wall");
    let wrote = pounding(&folder, &["init"]);
    assert_eq!(wrote.code, 0, "{}", wrote.stderr);
    let template = text(folder.join("scene.toml"));
    let begins = [
        "# [[structures]]",
        "# wall = {}",
        "# [[contacts]]",
        "# gap_m",
        "# height_m",
        "# duration_s",
        "# yield_drift_ratio",
    ];
    let mut shown = 0;
    let with_wall: Vec<String> = template
        .lines()
        .skip_while(|line| !line.starts_with("[[structures]]"))
        .map(|line| {
            let is_shown = begins.iter().any(|begin| line.starts_with(begin));
            shown += usize::from(is_shown);
            if is_shown { line[2..].into() } else { line.into() }
        })
        .collect();
    assert_eq!(shown, begins.len() - 1, "each once, but for the duration above");
    let (above, _) = template.split_once("[[structures]]\n").expect("structures");
    // The law of the wall is the last line.
    let below = with_wall.join("\n").replace(
        "\n# law.stereomechanical = { restitution = 0.5 }",
        "\nlaw.stereomechanical = { restitution = 0.5 }",
    );
    fs::write(folder.join("wall.toml"), format!("{above}{below}\n")).expect("a file");
    let checked = pounding(&folder, &["check", "wall.toml"]);
    for words in ["2 moving and 1 fixed;", "of which 1 can", "right – wall"] {
        let text = printed(&checked).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(words), "{words}: {text}");
    }
}

/// An apostrophe ends a literal string of TOML.
#[test]
fn extreme_a_record_with_an_apostrophe_in_its_name() {
    let folder = suite("quote");
    fs::copy(folder.join("records/pulse.csv"), folder.join("it's.csv")).expect("a file");
    let wrote = pounding(&folder, &["init", "quote.toml", "--record", "it's.csv"]);
    assert_eq!(wrote.code, 0, "{}", wrote.stderr);
    let ran = pounding(&folder, &["run", "quote.toml"]);
    assert_eq!(ran.code, 0, "{}", ran.stderr);
}

/// A file with the extension `.json` got TOML.
#[test]
fn issue_a_scene_in_json_is_json() {
    let folder = suite("init_json");
    printed(&pounding(&folder, &["init", "own.json", "--record", "records/pulse.csv"]));
    printed(&pounding(&folder, &["init", "own.toml", "--record", "records/pulse.csv"]));
    let json: Value = serde_json::from_str(&text(folder.join("own.json"))).expect("JSON");
    assert_eq!(json["structures"][0]["sdof"]["period_s"], 1.0, "in the words of a file");
    let run = |scene: &str| printed(&pounding(&folder, &["run", scene])).to_string();
    assert_eq!(run("own.json"), run("own.toml"));
    let asked = pounding(&folder, &["init", "asks.json", "--record", "records/column.txt"]);
    assert_snapshot!(printed(&asked), @r#"
    Wrote     asks.json

    Record    it needs `time_step_s` (the file does not say it) and `unit` (the file
              does not say it): add to "record" in asks.json, for example,
              "time_step_s": 0.01 (time between samples [s]); "unit": "g" (one of g,
              m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10)

    next:
      pounding check asks.json
      pounding run asks.json --out results
    "#);
}

#[test]
fn reference_buildings_to_begin_with() {
    let folder = folder("init_storeys");
    let wrote = pounding(&folder, &["init", "--storeys", "8,5,3", "--gap", "0.04"]);
    assert_eq!((wrote.code, wrote.stderr.as_str()), (0, ""));
    let scene = fs::read(folder.join("scene.toml")).expect("a scene");
    let scene = pounding::scene::Scene::parse(&scene, Path::new("scene.toml")).expect("a scene");
    let storeys = scene.structures.iter().map(|one| match one {
        pounding::scene::Structure::Building(building) => building.storeys.len(),
        pounding::scene::Structure::Sdof(_) | pounding::scene::Structure::Wall => 0,
    });
    assert_eq!(storeys.collect::<Vec<_>>(), [8, 5, 3]);
    let gaps = scene.contacts.iter().flatten().map(|one| one.gap_m);
    assert_eq!(gaps.collect::<Vec<_>>(), [0.04, 0.04]);
    let refused = pounding(&folder, &["init", "x.toml", "--storeys", "8,0"]);
    assert_eq!(refused.code, 2);
    let message = refused.stderr.lines().next();
    assert_snapshot!(message.expect("a message"), @"error: invalid value '0' for '--storeys <N,N…>': allowed is a whole number from 1 to 200");
}

/// A scene may come from standard input.
#[test]
fn limit_standard_input_is_a_scene() {
    let folder = suite("standard_input");
    let file = pounding(&folder, &["run", "towers.toml", "--json"]);
    let mut command = assert_cmd::Command::cargo_bin("pounding").expect("the program");
    let scene = fs::read(folder.join("towers.toml")).expect("a scene");
    let piped = command
        .current_dir(&folder)
        .args(["run", "-", "--json"])
        .write_stdin(scene)
        .output()
        .expect("it runs");
    assert_eq!(String::from_utf8_lossy(&piped.stdout), file.stdout);
}
