//! Faults of `pounding motion` that users met.

use std::fs;

use insta::assert_snapshot;
use serde_json::{Value, json};

use crate::motions::{folder_with, json_of, motion, provenance, record, waves};
use crate::runs::printed;
use crate::{folder, good_scene, pounding, refusal};

/// The figure had only the points of the table and looked jagged; now its curves have hundreds of points.
#[test]
fn issue_a_figure_is_drawn_through_many_periods() {
    let folder = folder("motion_smooth");
    fs::write(folder.join("record.csv"), waves("g")).expect("written");
    let arguments = ["spectrum", "record.csv", "--periods", "0.3,0.1", "--figure", "a.svg"];
    printed(&motion(&folder, &arguments));
    let svg = fs::read_to_string(folder.join("a.svg")).expect("written");
    let points = |line: &str| line.matches([' ', 'L']).count();
    let most = svg.split("d=\"").map(|path| points(path.split('"').next().unwrap_or_default()));
    assert!(most.max() > Some(300), "a smooth curve");
}

/// Ten thousand damping ratios took minutes without any output, and a hundred thousand periods of each filled the memory.
#[test]
fn issue_more_values_than_anybody_waits_for_are_refused() {
    let folder = folder("motion_issues_many");
    fs::write(folder.join("record.csv"), crate::quiet(40)).expect("a disk");
    let ratios = ["0.05"; 11].join(",");
    let many = ["spectrum", "record.csv", "--count", "100000", "--damping", &ratios];
    let said = motion(&folder, &many).stderr;
    assert!(
        said.contains("found 100000 periods times 11 damping ratios, allowed are up to 1000000"),
        "{said}"
    );
}

/// By default a printed table had more periods than a screen has lines. It now has 20; a CSV has 100.
#[test]
fn issue_the_table_of_a_spectrum_fits_a_screen() {
    let folder = folder("motion_table");
    fs::write(folder.join("record.csv"), waves("g")).expect("written");
    let rows = |arguments: &[&str]| {
        let ended = motion(&folder, &[&["spectrum", "record.csv"], arguments].concat());
        ended
            .stdout
            .lines()
            .filter(|line| line.starts_with(|first: char| first.is_ascii_digit()))
            .count()
    };
    assert_eq!(rows(&[]), 20);
    assert_eq!(rows(&["--from", "0.31", "--to", "0.39"]), 2);
    assert_eq!(rows(&["--csv"]), 100);
    assert_eq!(rows(&["--count", "7"]), 7);
}

/// If the file holds one component, a wrong component name was accepted.
#[test]
fn issue_a_component_that_is_not_there_is_refused_by_all() {
    let folder = folder_with("motion_component", &["esm.asc", "csmip.v2"]);
    let refused = |arguments: &[&str]| refusal(&motion(&folder, arguments));
    let message = "error: esm.asc: \"HNN\" is declared as --component, but the file holds 1 = \"HNE\"; choose one of them by its \
                   name, a part of it, or its number";
    for arguments in [
        &["info", "esm.asc", "--component", "HNN"][..],
        &["convert", "esm.asc", "a.csv", "--component", "HNN"],
        &["spectrum", "esm.asc", "--component", "HNN"],
    ] {
        assert_eq!(refused(arguments), message, "{arguments:?}");
    }
    assert_snapshot!(refused(&["info", "csmip.v2", "--component", "chan"]), @r#"error: csmip.v2: "chan" is declared as --component and fits 2 components: 1 = "Chan 1: 90 Deg", 2 = "Chan 2: Up"; give more of the name, or the number"#);
}

/// Only the full name of a component was accepted.
#[test]
fn issue_a_part_of_a_component_name_suffices() {
    let folder = folder_with("motion_part", &["csmip.v2"]);
    let whole = json_of(&motion(&folder, &["info", "csmip.v2", "--component", "Chan 1: 90 Deg", "--json"]));
    let part = json_of(&motion(&folder, &["info", "csmip.v2", "--component", "90 DEG", "--json"]));
    assert_eq!(whole, part);
    assert_eq!(part["motions"][0]["component"], "Chan 1: 90 Deg");
    let mut scene = good_scene();
    scene["record"] = json!({"file": "csmip.v2", "component": "90 deg"});
    fs::write(folder.join("scene.json"), scene.to_string()).expect("written");
    printed(&motion(&folder, &["convert", "scene.json", "out.csv"]));
    assert_eq!(provenance(&folder, "out")["from"]["component"], "Chan 1: 90 Deg");
    assert_eq!(json!(record("out.csv", &folder).peak().1), part["motions"][0]["peak_m_per_s2"]);
}

/// The exit code was 0 although a named file was refused.
#[test]
fn issue_a_named_file_that_is_refused_fails_after_all_are_printed() {
    let folder = folder_with("motion_named", &["esm.asc", "usgs.smc"]);
    fs::write(folder.join("letter.txt"), "Dear Sir\n").expect("written");
    let info = |arguments: &[&str]| motion(&folder, &[&["info"], arguments].concat());
    for form in ["--json", "--csv", "--gravity=9.81"] {
        let ended = info(&["letter.txt", "esm.asc", "usgs.smc", form]);
        assert_eq!(ended.code, 1, "{form}");
        let begins = "letter.txt: line 1 begins none of the formats known";
        assert!(ended.stderr.contains(begins), "{}", ended.stderr);
        assert!(ended.stdout.contains("usgs.smc"), "{}", ended.stdout);
    }
    // A folder may contain other files besides records.
    printed(&info(&["."]));
}

/// `convert a a --overwrite` destroyed the raw record.
#[test]
fn issue_the_record_that_is_read_is_never_written_over() {
    let folder = folder_with("motion_onto", &["esm.asc"]);
    let before = fs::read(folder.join("esm.asc")).expect("there");
    let mut scene = good_scene();
    scene["record"] = json!({"file": "esm.asc"});
    fs::write(folder.join("scene.json"), scene.to_string()).expect("written");
    fs::write(folder.join("raw.provenance.json"), &before).expect("written");
    let refused = |arguments: &[&str]| {
        let arguments = [&["convert"], arguments, &["--overwrite"]].concat();
        refusal(&motion(&folder, &arguments))
    };
    let all = [
        refused(&["esm.asc", "esm.asc"]),
        refused(&["esm.asc", "./esm.asc"]),
        refused(&["scene.json", "esm.asc"]),
        refused(&["scene.json", "scene.json"]),
    ];
    assert_snapshot!(all.join("\n"), @r"
    error: esm.asc: is the file that is read (esm.asc), allowed is another, also with --overwrite: what was read cannot be made again; name a new file
    error: ./esm.asc: is the file that is read (esm.asc), allowed is another, also with --overwrite: what was read cannot be made again; name a new file
    error: esm.asc: is the file that is read (esm.asc), allowed is another, also with --overwrite: what was read cannot be made again; name a new file
    error: scene.json: is the file that is read (scene.json), allowed is another, also with --overwrite: what was read cannot be made again; name a new file
    ");
    assert_eq!(fs::read(folder.join("esm.asc")).expect("there"), before);
}

/// Comments above the header of a converted CSV broke other programs that read it.
#[test]
fn issue_a_converted_csv_is_a_header_and_numbers() {
    let folder = folder_with("motion_bare", &["usgs.smc"]);
    let ended = motion(&folder, &["convert", "usgs.smc", "out.csv", "--to", "g"]);
    assert_snapshot!(printed(&ended), @r"
    Wrote     out.csv: 21 samples, 0.01 s apart, peak -0.71842 m/s² at 0.01 s
              out.provenance.json: where they come from
    ");
    let text = fs::read_to_string(folder.join("out.csv")).expect("written");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("time_s,acceleration_g"));
    let is_row = |line: &str| {
        let numbers: Vec<_> = line.split(',').map(str::parse::<f64>).collect();
        numbers.len() == 2 && numbers.iter().all(Result::is_ok)
    };
    assert!(lines.all(is_row), "{text}");
    assert_snapshot!(format!("{:#}", provenance(&folder, "out")));
    // A file with the origin of a record is not a record.
    let info = printed(&motion(&folder, &["info", "."])).to_string();
    assert!(info.contains("out.csv") && !info.contains("provenance"), "{info}");
    assert_snapshot!(refusal(&motion(&folder, &["convert", "usgs.smc", "out.csv"])), @"error: out.csv: is there already, allowed is a new file; name another one or add --overwrite");
}

/// An offset of the baseline moved the ground by metres without a remark.
#[test]
fn issue_a_drift_of_the_ground_is_pointed_out() {
    let folder = folder_with("motion_drift", &["usgs.smc"]);
    let sample = |index: i32| {
        let time = f64::from(index) / 50.0;
        let shape = (time * (20.0 - time) / 100.0).max(0.0);
        format!("{}\n", shape * shape * libm::sin(6.0 * time) + 0.02)
    };
    let offset: String = (0..=1000).map(sample).collect();
    fs::write(folder.join("offset.txt"), offset).expect("written");
    let declared = ["--unit", "m_per_s2", "--time-step", "0.02"];
    let info = |file: &str, options: &[&str]| printed(&motion(&folder, &[&["info", file], options].concat())).to_string();
    let text = info("offset.txt", &declared);
    let drift: Vec<&str> = text.lines().skip_while(|line| !line.starts_with("Drift")).collect();
    assert_snapshot!(drift.join("\n"), @r"
    Drift     0.3811 m/s on average over the last tenth, 95 % of PGV; the ground
              does not come to rest: an offset of the baseline, or a record cut
              short; PGV and PGD are those of the drift. A straight line (--detrend
              linear) or a high-pass (--band-pass) in `motion convert` takes an
              offset away, in a scene `detrend` or `band_pass`

    Notes     PGV and PGD without correction of the baseline; Arias intensity with g
              = 9.80665 m/s²; CAV without threshold; D: while the Arias intensity
              grows from 5 % to 75 % and to 95 %; Tm: mean period of Fourier
              amplitudes, 0.25 to 20 Hz; Housner: ∫ PSV dT from 0.1 to 2.5 s, ASI: ∫
              PSA dT from 0.1 to 0.5 s, damping 5 %.
    ");
    let arguments = [&["convert", "offset.txt", "line.csv", "--detrend", "linear"], &declared[..]].concat();
    printed(&motion(&folder, &arguments));
    assert!(!info("line.csv", &[]).contains("Drift"), "detrended");
    let mut scene = good_scene();
    scene["record"] = json!({"file": "offset.txt", "unit": "m_per_s2", "time_step_s": 0.02});
    let check = |scene: &Value| {
        fs::write(folder.join("scene.json"), scene.to_string()).expect("written");
        pounding(&folder, &["check", "scene.json"]).stdout
    };
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let said = "record: found a ground that does not come to rest";
    assert!(words(&check(&scene)).contains(said), "{}", check(&scene));
    scene["record"]["detrend"] = json!("linear");
    assert!(!words(&check(&scene)).contains(said), "{}", check(&scene));
}

/// The list of a file's components lacked the unit and the peak time of each.
#[test]
fn issue_components_are_listed_with_unit_and_time_of_peak() {
    let folder = folder_with("motion_components", &["csmip.v2"]);
    assert_snapshot!(printed(&motion(&folder, &["info", "csmip.v2"])), @r"
    File      csmip.v2
    Format    CSMIP V2

    Component        Unit  Samples   Step      PGA     at       PGV    D5–95
                                      [s]      [g]    [s]     [m/s]      [s]
    Chan 1: 90 Deg  cm/s²       20  0.005  0.09048  0.005  0.007727  0.07249
    Chan 2: Up      cm/s²       19  0.005  0.04395      0  0.002305  0.07025

    Records   1 file: 1 motion of 1 event, 1 component of used files left out
              1 vertical component, by the name in the file: csmip.v2 Chan 2: Up

    Drift     Chan 1: 90 Deg; Chan 2: Up: the ground does not come to rest: an
              offset of the baseline, or a record cut short; PGV and PGD are those
              of the drift. A straight line (--detrend linear) or a high-pass
              (--band-pass) in `motion convert` takes an offset away, in a scene
              `detrend` or `band_pass`

    Notes     --component takes one, by its name, a part of it, or its number
    ");
}

/// Dangling links and folders were skipped silently, messages about a README listed all formats, and copies counted as records. Events were
/// not counted, and `q_U.csv` counted as horizontal although `gap` left it out.
#[cfg(unix)]
#[test]
fn issue_a_folder_is_read_as_others_read_it() {
    let folder = folder_with("motion_folder", &["esm.asc"]);
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("written");
    for (index, name) in ["q_E.csv", "q_N.csv", "q_U.csv"].into_iter().enumerate() {
        let line = |step: usize| {
            let rate = 0.2 + 0.05 * index as f64;
            format!("{},{}\n", 0.02 * step as f64, 0.1 * libm::sin(rate * step as f64))
        };
        let lines: String = (0..200).map(line).collect();
        write(name, &format!("time_s,acceleration_g\n{lines}"));
    }
    fs::copy(folder.join("q_E.csv"), folder.join("the same.csv")).expect("a copy");
    write("README", "Some words.\n");
    fs::create_dir(folder.join("more")).expect("made");
    std::os::unix::fs::symlink("/nowhere", folder.join("lost.csv")).expect("a link");
    let text = printed(&motion(&folder, &["info", "."])).to_string();
    let said = text.lines().skip_while(|line| !line.starts_with("Records"));
    let said: Vec<&str> = said.take_while(|line| !line.is_empty()).collect();
    assert_snapshot!(said.join("\n"), @r"
    Records   8 files, 3 used and 5 left out: 3 motions of 2 events
              lost.csv: cannot be read: No such file or directory (os error 2)
              1 folder, give each as a folder of its own, or --sub-folders: more
              1 copy, each record counts once: the same.csv (of q_E.csv)
              1 vertical component, by the name of the file; rename a horizontal
              one: q_U.csv
              1 file that is no record: README
    ");
    let json = json_of(&motion(&folder, &["info", ".", "--json"]));
    let of = |name: &str| {
        let mut motions = json["motions"].as_array().expect("a list").iter();
        motions.find(|one| one["file"] == name).expect(name)
    };
    assert_eq!(of("./q_E.csv")["event"], of("./q_N.csv")["event"]);
    assert_eq!(of("./q_U.csv")["direction"], "vertical");
    let copy = &of("./the same.csv")["left_out"];
    assert_eq!(copy, "copy (of q_E.csv), each record counts once");
    assert_eq!(json["records"]["files"], 8);
    assert_eq!(json["records"]["events"], 2);
}

/// Every weak record of a folder had a sentence of its own.
#[test]
fn issue_weak_records_of_a_folder_share_a_sentence() {
    let folder = folder("motion_issues_weak");
    fs::create_dir(folder.join("records")).expect("a disk");
    let told = |n: u32| {
        for index in 0..n {
            let text = crate::unusual::record(1.0 + 0.1 * f64::from(index), 0.05 + 0.01 * f64::from(index));
            fs::write(folder.join("records").join(format!("weak-{index}.csv")), text).expect("a disk");
        }
        let printed = printed(&motion(&folder, &["info", "records"])).to_string();
        printed.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    assert_eq!(told(3).matches("usual is 0.02 to 3 g; its unit decides it").count(), 3);
    let many = told(5);
    assert!(
        many.contains("Unusual found 5 peaks of 0.00") && many.contains("their units decide them: weak-0.csv, weak-1.csv,"),
        "{many}"
    );
    assert!(!many.contains("its unit decides it"), "{many}");
}
