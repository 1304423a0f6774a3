//! `pounding motion`: what is printed of record files, and what is written.

use std::fs;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use pounding::motion::{AccelerationUnit, Record, read};
use serde_json::{Value, json};

use crate::runs::printed;
use crate::{Ended, folder, good_scene, pounding, refusal};

const FILES: &str = "../motion/tests/files";
const GRAVITY: f64 = 9.80665;

/// A folder with copies of some of the small files of the readers.
fn folder_with(test: &str, files: &[&str]) -> PathBuf {
    let folder = folder(test);
    for file in files {
        fs::copy(Path::new(FILES).join(file), folder.join(file)).expect("a file can be copied");
    }
    folder
}

fn motion(folder: &Path, arguments: &[&str]) -> Ended {
    pounding(folder, &[&["motion"], arguments].concat())
}

fn json_of(ended: &Ended) -> Value {
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "it answers");
    serde_json::from_str(&ended.stdout).expect("it prints JSON")
}

/// A CSV of this project.
fn record(name: &str, folder: &Path) -> Record {
    let bytes = fs::read(folder.join(name)).expect("the file is there");
    let file = read(&bytes).expect("it is read");
    file.into_record(GRAVITY).expect("it is a record")
}

fn bits(record: &Record) -> Vec<u64> {
    record.samples().iter().map(|one| one.to_bits()).collect()
}

/// What stands beside a converted record.
fn provenance(folder: &Path, stem: &str) -> Value {
    let path = folder.join(format!("{stem}.provenance.json"));
    let text = fs::read_to_string(path).expect("it is there");
    serde_json::from_str(&text).expect("JSON")
}

/// A CSV of numbers with many digits, in a unit.
fn waves(unit: &str) -> String {
    let wave = |index: i32| {
        let x = f64::from(index);
        format!("{},{}\n", x / 100.0, ((x * x / 37.0) % 1.0 - 0.5) / 1.5)
    };
    let lines: String = (0..200).map(wave).collect();
    format!("# waves\ntime_s,acceleration_{unit}\n{lines}")
}

#[test]
fn reference_help() {
    for command in ["info", "convert", "spectrum"] {
        let help = motion(Path::new("."), &[command, "--help"]);
        assert_snapshot!(format!("help_{command}"), printed(&help));
    }
    assert_snapshot!("help", printed(&motion(Path::new("."), &["--help"])));
}

#[test]
fn reference_info_of_one_file() {
    let folder = folder_with("motion_info", &["usgs.smc"]);
    assert_snapshot!(printed(&motion(&folder, &["info", "usgs.smc"])));
}

#[test]
fn reference_info_of_several_files() {
    let files = ["csmip.v2", "esm.asc", "geonet.v1a", "knet.ns"];
    let folder = folder_with("motion_info_several", &files);
    fs::write(folder.join("list.txt"), "0.1\n-0.2\n0.1\n").expect("written");
    fs::write(folder.join("letter.txt"), "Dear Sir\n").expect("written");
    assert_snapshot!(printed(&motion(&folder, &["info", "."])));
    let ended = motion(&folder, &["info", ".", "--csv"]);
    assert_snapshot!("info_csv", ended.stdout);
}

/// What is declared is for the files of a list that need it, and contradicts a single one.
#[test]
fn limit_declared_for_those_that_do_not_say_it() {
    let folder = folder_with("motion_declared", &["esm.asc"]);
    fs::write(folder.join("list.txt"), "0.1\n-0.2\n0.1\n").expect("written");
    let declared = ["--unit", "g", "--time-step", "0.01", "--json"];
    let both = [&["info", "esm.asc", "list.txt"], &declared[..]].concat();
    let both = json_of(&motion(&folder, &both));
    assert_eq!(both["motions"][0]["unit"], "cm_per_s2");
    let list = &both["motions"][1];
    assert_eq!(list["unit"], "g");
    assert_eq!(list["pga_m_per_s2"], 0.2 * GRAVITY);
    assert_eq!(list["time_step_s"], 0.01);
    let one = [&["info", "esm.asc"], &declared[..]].concat();
    assert_snapshot!(refusal(&motion(&folder, &one)));
}

#[test]
fn limit_text_csv_and_json_hold_the_same() {
    let folder = folder_with("motion_same", &["csmip.v2"]);
    let json = json_of(&motion(&folder, &["info", "csmip.v2", "--json"]));
    let csv = motion(&folder, &["info", "csmip.v2", "--csv"]).stdout;
    let mut lines = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().expect("a header");
    let motions = json["motions"].as_array().expect("a list");
    assert_eq!(lines.clone().count(), motions.len());
    for (line, motion) in lines.zip(motions) {
        for (name, value) in header.iter().zip(line) {
            if let Some(number) = motion[name].as_f64() {
                assert_eq!(value.parse::<f64>().ok(), Some(number), "{name}");
            }
        }
    }
}

#[test]
fn extreme_files_that_are_refused() {
    let folder = folder_with("motion_refused", &["csmip.v2"]);
    fs::write(folder.join("list.txt"), "0.1\n-0.2\n0.1\n").expect("written");
    fs::create_dir(folder.join("empty")).expect("made");
    let refused = |arguments: &[&str]| refusal(&motion(&folder, arguments));
    let all = [
        refused(&["info", "list.txt"]),
        refused(&["info", "list.txt", "--unit", "g"]),
        refused(&["info", "empty"]),
        refused(&["info", "csmip.v2", "--component", "4"]),
        refused(&["spectrum", "csmip.v2"]),
        refused(&["info", "list.txt", "list.txt"]),
    ];
    assert_snapshot!(all.join("\n"));
}

/// Every file of the readers, and numbers of many digits, go through the CSV without a change.
#[test]
fn limit_what_is_written_is_read_again_to_the_last_bit() {
    let folder = folder_with("motion_round_trip", &["esm.asc", "usgs.smc", "geonet.v1a"]);
    for unit in ["g", "m_per_s2"] {
        fs::write(folder.join(format!("{unit}.csv")), waves(unit)).expect("written");
    }
    let cases: [(&str, &[&str]); 6] = [
        ("esm.asc", &[]),
        ("usgs.smc", &[]),
        ("geonet.v1a", &["--component", "1"]),
        ("g.csv", &[]),
        ("m_per_s2.csv", &[]),
        ("g.csv", &["--to", "g"]),
    ];
    for (file, options) in cases {
        let arguments = [&["convert", file, "out.csv", "--overwrite"], options].concat();
        printed(&motion(&folder, &arguments));
        let info = |file: &str, options: &[&str]| {
            let arguments = [&["info", file, "--json"], options].concat();
            json_of(&motion(&folder, &arguments))["motions"][0].clone()
        };
        let component = options.contains(&"--component");
        let (before, after) = (
            info(file, if component { options } else { &[] }),
            info("out.csv", &[]),
        );
        for name in [
            "n_samples",
            "time_step_s",
            "peak_m_per_s2",
            "cav_m_per_s",
            "pgd_m",
        ] {
            assert_eq!(before[name], after[name], "{file} {options:?}: {name}");
        }
        if Path::new(file)
            .extension()
            .is_some_and(|ending| ending == "csv")
        {
            assert_eq!(
                bits(&record(file, &folder)),
                bits(&record("out.csv", &folder))
            );
        }
    }
}

/// Of 200 accelerations most are a number of g times g; all come back to rounding.
#[test]
fn limit_written_in_g_is_as_near_as_numbers_are() {
    let folder = folder("motion_in_g");
    fs::write(folder.join("si.csv"), waves("m_per_s2")).expect("written");
    printed(&motion(
        &folder,
        &["convert", "si.csv", "g.csv", "--to", "g"],
    ));
    let text = fs::read(folder.join("g.csv")).expect("written");
    let file = read(&text).expect("it is read");
    assert_eq!(file.unit(), AccelerationUnit::StandardGravity);
    let (si, g) = (record("si.csv", &folder), record("g.csv", &folder));
    for (si, g) in si.samples().iter().zip(g.samples()) {
        assert!((si - g).abs() <= f64::EPSILON * si.abs(), "{si} and {g}");
    }
}

/// The options do what the fields of a scene do, in the same order.
#[test]
fn limit_processing_is_that_of_a_scene() {
    let folder = folder("motion_scene");
    fs::write(folder.join("record.csv"), waves("g")).expect("written");
    let mut scene = good_scene();
    scene["record"] = json!({
        "file": "record.csv", "detrend": "linear", "band_pass": {"low_hz": 0.5, "high_hz": 20, "order": 2, "causal": true},
        "resample_s": 0.02, "scale_to": {"sa": {"period_s": 0.5, "damping_ratio": 0.05, "sa_g": 0.3}}, "scale": -1.5,
        "reversed": true,
    });
    fs::write(folder.join("scene.json"), scene.to_string()).expect("written");
    printed(&motion(&folder, &["convert", "scene.json", "scene.csv"]));
    let options = "convert record.csv file.csv --reverse --scale -1.5 --scale-to-sa 0.5 5% 0.3 --resample 0.02 \
                   --band-pass 0.5 20 --order 2 --causal --detrend linear";
    let options: Vec<&str> = options.split_whitespace().collect();
    printed(&motion(&folder, &options));
    let (of_scene, of_file) = (record("scene.csv", &folder), record("file.csv", &folder));
    assert_eq!(of_scene.samples().len(), 100);
    assert_eq!(bits(&of_scene), bits(&of_file));
    let said = provenance(&folder, "file");
    assert_snapshot!(format!("{said:#}"));
    assert_eq!(
        said["processing"],
        provenance(&folder, "scene")["processing"]
    );
    // Sa of the scaled one times 1.5.
    let spectrum = ["spectrum", "file.csv", "--periods", "0.5,0", "--json"];
    let values = json_of(&motion(&folder, &spectrum))["spectra"][0]["values"].clone();
    let sa = values[0]["pseudo_sa_m_per_s2"].as_f64().expect("a number");
    let wanted = 1.5 * 0.3 * GRAVITY;
    assert!((sa - wanted).abs() < 1e-12 * wanted, "{sa} is {wanted}");
    // A structure of period 0 moves with the ground.
    assert_eq!(
        values[1]["sa_m_per_s2"].as_f64(),
        Some(of_file.peak().1.abs())
    );
}

#[test]
fn extreme_conversions_that_are_refused() {
    let folder = folder("motion_not_converted");
    fs::write(folder.join("record.csv"), waves("g")).expect("written");
    fs::write(folder.join("one.txt"), "0.5\n").expect("written");
    fs::write(folder.join("scene.json"), good_scene().to_string()).expect("written");
    let refused = |options: &[&str]| {
        let arguments = [&["convert"], options].concat();
        refusal(&motion(&folder, &arguments))
    };
    let declared = ["--unit", "g", "--time-step", "0.01"];
    let all = [
        refused(&["record.csv", "record.csv"]),
        refused(&["record.csv", "out.csv", "--band-pass", "5", "1"]),
        refused(&["record.csv", "out.csv", "--band-pass", "1", "80"]),
        refused(&[
            "record.csv",
            "out.csv",
            "--band-pass",
            "1",
            "8",
            "--order",
            "11",
        ]),
        refused(&["record.csv", "out.csv", "--resample", "1e-12"]),
        refused(&["record.csv", "out.csv", "--scale-to-sa", "1", "2", "0.3"]),
        refused(&[
            "record.csv",
            "out.csv",
            "--scale-to-sa",
            "100%",
            "5%",
            "0.3",
        ]),
        refused(&["record.csv", "out.csv", "--scale-to-sa", "1", "5%", "30%"]),
        refused(&["record.csv", "out.csv", "--scale-to-sa", "1", "much", "0.3"]),
        refused(&["record.csv", "out.csv", "--scale-to-sa", "1", "5%", "0"]),
        refused(&["record.csv", "out.csv", "--scale-to-sa", "1e9", "5%", "1"]),
        refused(&["record.csv", "out.csv", "--scale", "1e308"]),
        refused(&["record.csv", "out.csv", "--scale", "inf"]),
        refused(&[&["one.txt", "out.csv"], &declared[..]].concat()),
        refused(&["scene.json", "out.csv", "--reverse"]),
    ];
    assert_snapshot!(all.join("\n"));
    assert!(!folder.join("out.csv").exists(), "nothing is written");
}

#[test]
fn reference_spectrum() {
    let folder = folder("motion_spectrum");
    fs::write(folder.join("record.csv"), waves("g")).expect("written");
    let arguments = [
        "spectrum",
        "record.csv",
        "--count",
        "4",
        "--damping",
        "2%,0.05",
    ];
    assert_snapshot!(printed(&motion(&folder, &arguments)));
    let ended = motion(&folder, &[&arguments[..], &["--csv"]].concat());
    assert_snapshot!("spectrum_csv", ended.stdout);
}

#[test]
fn reference_figures_of_spectra() {
    let folder = folder("motion_figure");
    fs::write(folder.join("record.csv"), waves("g")).expect("written");
    let draw = |name: &str| {
        let arguments = ["spectrum", "record.csv", "--count", "3", "--figure", name];
        motion(&folder, &arguments)
    };
    printed(&draw("a.png"));
    let png = fs::read(folder.join("a.png")).expect("written");
    assert!(png.starts_with(b"\x89PNG\r\n"), "a PNG");
    printed(&draw("a.svg"));
    let svg = fs::read_to_string(folder.join("a.svg")).expect("written");
    assert!(
        svg.starts_with("<svg") && !svg.contains("<text"),
        "letters are outlines"
    );
    assert_snapshot!(refusal(&draw("a.png")), @"error: a.png: is there already, allowed is a new file; name another one or add --overwrite");
    assert_eq!(draw("a.jpg").code, 2);
    // Periods of a table without any of its own: those of the options.
    let arguments = [
        "spectrum",
        "record.csv",
        "--periods",
        "0",
        "--figure",
        "b.png",
    ];
    printed(&motion(&folder, &arguments));
    assert!(folder.join("b.png").exists(), "drawn");
}

/// The figure was drawn through the rows of the table, and looked jagged; now its curves have hundreds of points.
#[test]
fn issue_a_figure_is_drawn_through_many_periods() {
    let folder = folder("motion_smooth");
    fs::write(folder.join("record.csv"), waves("g")).expect("written");
    let arguments = [
        "spectrum",
        "record.csv",
        "--periods",
        "0.3,0.1",
        "--figure",
        "a.svg",
    ];
    printed(&motion(&folder, &arguments));
    let svg = fs::read_to_string(folder.join("a.svg")).expect("written");
    let points = |line: &str| line.matches([' ', 'L']).count();
    let most = svg
        .split("d=\"")
        .map(|path| points(path.split('"').next().unwrap_or_default()));
    assert!(most.max() > Some(300), "a smooth curve");
}

/// Without periods of one's own a table has a screenful of them, in a file for a program a hundred.
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

/// A name that the file does not have was taken for any, where the file holds one component.
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

/// Components were known by their full names alone.
#[test]
fn issue_a_part_of_a_component_name_suffices() {
    let folder = folder_with("motion_part", &["csmip.v2"]);
    let whole = json_of(&motion(
        &folder,
        &[
            "info",
            "csmip.v2",
            "--component",
            "Chan 1: 90 Deg",
            "--json",
        ],
    ));
    let part = json_of(&motion(
        &folder,
        &["info", "csmip.v2", "--component", "90 DEG", "--json"],
    ));
    assert_eq!(whole, part);
    assert_eq!(part["motions"][0]["component"], "Chan 1: 90 Deg");
    let mut scene = good_scene();
    scene["record"] = json!({"file": "csmip.v2", "component": "90 deg"});
    fs::write(folder.join("scene.json"), scene.to_string()).expect("written");
    printed(&motion(&folder, &["convert", "scene.json", "out.csv"]));
    assert_eq!(
        provenance(&folder, "out")["from"]["component"],
        "Chan 1: 90 Deg"
    );
    assert_eq!(
        json!(record("out.csv", &folder).peak().1),
        part["motions"][0]["peak_m_per_s2"]
    );
}

/// The exit code was 0 though a file that was named is refused.
#[test]
fn issue_a_named_file_that_is_refused_fails_after_all_are_printed() {
    let folder = folder_with("motion_named", &["esm.asc", "usgs.smc"]);
    fs::write(folder.join("letter.txt"), "Dear Sir\n").expect("written");
    let info = |arguments: &[&str]| motion(&folder, &[&["info"], arguments].concat());
    for form in ["--json", "--csv", "--gravity=9.81"] {
        let ended = info(&["letter.txt", "esm.asc", "usgs.smc", form]);
        assert_eq!(ended.code, 1, "{form}");
        let begins =
            "error: letter.txt: line 1 reads \"Dear Sir\", which begins none of the formats known";
        assert!(ended.stderr.starts_with(begins), "{}", ended.stderr);
        assert!(ended.stdout.contains("usgs.smc"), "{}", ended.stdout);
    }
    // A folder may hold other files than records.
    printed(&info(&["."]));
}

/// `convert a a --overwrite` left nothing of the raw record.
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
    error: esm.asc: is the file that is read (esm.asc), allowed is another, also with --overwrite: a raw record cannot be made again; name a new file
    error: ./esm.asc: is the file that is read (esm.asc), allowed is another, also with --overwrite: a raw record cannot be made again; name a new file
    error: esm.asc: is the file that is read (esm.asc), allowed is another, also with --overwrite: a raw record cannot be made again; name a new file
    error: scene.json: is the file that is read (scene.json), allowed is another, also with --overwrite: a raw record cannot be made again; name a new file
    ");
    assert_eq!(fs::read(folder.join("esm.asc")).expect("there"), before);
}

/// Comments above the header of a CSV break what others read it with.
#[test]
fn issue_a_converted_csv_is_a_header_and_numbers() {
    let folder = folder_with("motion_bare", &["usgs.smc"]);
    let ended = motion(&folder, &["convert", "usgs.smc", "out.csv", "--to", "g"]);
    assert_snapshot!(printed(&ended), @r"
    wrote out.csv: 21 samples, 0.01 s apart, peak -0.71842 m/s² at 0.01 s
    wrote out.provenance.json: where they come from
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
    // What tells where a record comes from is none.
    let info = printed(&motion(&folder, &["info", "."])).to_string();
    assert!(
        info.contains("out.csv") && !info.contains("provenance"),
        "{info}"
    );
    assert_snapshot!(refusal(&motion(&folder, &["convert", "usgs.smc", "out.csv"])), @"error: out.csv: is there already, allowed is a new file; name another one or add --overwrite");
}

/// An offset of the baseline moved the ground by metres, and nothing was said.
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
    let info = |file: &str, options: &[&str]| {
        printed(&motion(&folder, &[&["info", file], options].concat())).to_string()
    };
    let text = info("offset.txt", &declared);
    let drift: Vec<&str> = text
        .lines()
        .skip_while(|line| !line.starts_with("Drift"))
        .collect();
    assert_snapshot!(drift.join("\n"), @r"
    Drift     0.3811 m/s on average over the last tenth, 95 % of PGV; the ground
              does not come to rest: an offset of the baseline, or a record cut
              short; PGV and PGD are those of the drift. A straight line (--detrend
              linear) or a high-pass (--band-pass) in `motion convert` takes an
              offset away, in a scene `detrend` or `band_pass`

    Notes     PGV and PGD without correction of the baseline; Arias intensity with g
              = 9.80665 m/s²; CAV without threshold; D: while the Arias intensity
              grows from 5 % to 75 % and to 95 %.
    ");
    let arguments = [
        &["convert", "offset.txt", "line.csv", "--detrend", "linear"],
        &declared[..],
    ]
    .concat();
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

/// A file with several components is listed with the unit and the time of the peak of each.
#[test]
fn issue_components_are_listed_with_unit_and_time_of_peak() {
    let folder = folder_with("motion_components", &["csmip.v2"]);
    assert_snapshot!(printed(&motion(&folder, &["info", "csmip.v2"])), @r"
    File      csmip.v2
    Format    CSMIP V2

    Component       Samples   Step   Unit      PGA     at       PGV    D5–95
                               [s]             [g]    [s]     [m/s]      [s]
    Chan 1: 90 Deg       20  0.005  cm/s²  0.09048  0.005  0.007727  0.07249
    Chan 2: Up           19  0.005  cm/s²  0.04395      0  0.002305  0.07025

    Drift     Chan 1: 90 Deg; Chan 2: Up: the ground does not come to rest: an
              offset of the baseline, or a record cut short; PGV and PGD are those
              of the drift. A straight line (--detrend linear) or a high-pass
              (--band-pass) in `motion convert` takes an offset away, in a scene
              `detrend` or `band_pass`

    Notes     --component takes one, by its name, a part of it, or its number
    ");
}
