//! Tests of `pounding motion`: output about record files, and converted files.

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
pub(crate) fn folder_with(test: &str, files: &[&str]) -> PathBuf {
    let folder = folder(test);
    for file in files {
        fs::copy(Path::new(FILES).join(file), folder.join(file)).expect("a file can be copied");
    }
    folder
}

pub(crate) fn motion(folder: &Path, arguments: &[&str]) -> Ended {
    pounding(folder, &[&["motion"], arguments].concat())
}

pub(crate) fn json_of(ended: &Ended) -> Value {
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "it answers");
    serde_json::from_str(&ended.stdout).expect("it prints JSON")
}

/// A CSV of this project.
pub(crate) fn record(name: &str, folder: &Path) -> Record {
    let bytes = fs::read(folder.join(name)).expect("the file is there");
    let file = read(&bytes).expect("it is read");
    file.into_record(GRAVITY).expect("it is a record")
}

fn bits(record: &Record) -> Vec<u64> {
    record.samples().iter().map(|one| one.to_bits()).collect()
}

/// The file of provenance next to a converted record.
pub(crate) fn provenance(folder: &Path, stem: &str) -> Value {
    let path = folder.join(format!("{stem}.provenance.json"));
    let text = fs::read_to_string(path).expect("it is there");
    serde_json::from_str(&text).expect("JSON")
}

/// A CSV of numbers with many digits, in a unit.
pub(crate) fn waves(unit: &str) -> String {
    let wave = |index: i32| {
        let x = f64::from(index);
        format!("{},{}\n", x / 100.0, ((x * x / 37.0) % 1.0 - 0.5) / 1.5)
    };
    let lines: String = (0..200).map(wave).collect();
    format!("# waves\ntime_s,acceleration_{unit}\n{lines}")
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

/// Declared data apply to the files of a list that lack them, and contradict a single file that has them.
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

/// Every file of the readers, and numbers of many digits, pass through the CSV unchanged.
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
        let (before, after) = (info(file, if component { options } else { &[] }), info("out.csv", &[]));
        for name in ["n_samples", "time_step_s", "peak_m_per_s2", "cav_m_per_s", "pgd_m"] {
            assert_eq!(before[name], after[name], "{file} {options:?}: {name}");
        }
        if Path::new(file).extension().is_some_and(|ending| ending == "csv") {
            assert_eq!(bits(&record(file, &folder)), bits(&record("out.csv", &folder)));
        }
    }
}

/// A number in g times g does not give every acceleration exactly; all 200 come back within rounding.
#[test]
fn limit_written_in_g_is_as_near_as_numbers_are() {
    let folder = folder("motion_in_g");
    fs::write(folder.join("si.csv"), waves("m_per_s2")).expect("written");
    printed(&motion(&folder, &["convert", "si.csv", "g.csv", "--to", "g"]));
    let text = fs::read(folder.join("g.csv")).expect("written");
    let file = read(&text).expect("it is read");
    assert_eq!(file.unit(), AccelerationUnit::StandardGravity);
    let (si, g) = (record("si.csv", &folder), record("g.csv", &folder));
    for (si, g) in si.samples().iter().zip(g.samples()) {
        assert!((si - g).abs() <= f64::EPSILON * si.abs(), "{si} and {g}");
    }
}

/// The options act like the fields of a scene, in the same order.
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
    assert_eq!(said["processing"], provenance(&folder, "scene")["processing"]);
    // The spectrum of the scaled record is 1.5 times as large.
    let spectrum = ["spectrum", "file.csv", "--periods", "0.5,0", "--json"];
    let values = json_of(&motion(&folder, &spectrum))["spectra"][0]["values"].clone();
    let sa = values[0]["pseudo_sa_m_per_s2"].as_f64().expect("a number");
    let wanted = 1.5 * 0.3 * GRAVITY;
    assert!((sa - wanted).abs() < 1e-12 * wanted, "{sa} is {wanted}");
    // A structure of period 0 moves with the ground.
    assert_eq!(values[1]["sa_m_per_s2"].as_f64(), Some(of_file.peak().1.abs()));
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
        refused(&["record.csv", "out.csv", "--band-pass", "1", "8", "--order", "11"]),
        refused(&["record.csv", "out.csv", "--resample", "1e-12"]),
        refused(&["record.csv", "out.csv", "--scale-to-sa", "1", "2", "0.3"]),
        refused(&["record.csv", "out.csv", "--scale-to-sa", "100%", "5%", "0.3"]),
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
    let arguments = ["spectrum", "record.csv", "--count", "4", "--damping", "2%,0.05"];
    assert_snapshot!(printed(&motion(&folder, &arguments)));
    let ended = motion(&folder, &[&arguments[..], &["--csv"]].concat());
    assert_snapshot!("spectrum_csv", ended.stdout);
}

#[test]
fn reference_spectra_of_strength_and_frequency() {
    let folder = folder("motion_further_spectra");
    fs::write(folder.join("record.csv"), waves("g")).expect("written");
    let asked = |more: &[&str]| motion(&folder, &[&["spectrum", "record.csv"], more].concat());
    let strengths = ["--periods", "0.5,1", "--ductility", "1,2"];
    assert_snapshot!("ductilities", printed(&asked(&strengths)));
    assert_snapshot!("ductilities_csv", asked(&[&strengths[..], &["--csv"]].concat()).stdout);
    let json = json_of(&asked(&[&strengths[..], &["--json"]].concat()));
    assert_eq!(json["spectra"][1]["ductility"], 2.0);
    assert_eq!(json["spectra"][0]["values"][0]["strength_reduction"], 1.0);
    let amplitudes = ["--fourier", "--periods", "0,0.01,0.5,2"];
    assert_snapshot!("fourier", printed(&asked(&amplitudes)));
    assert_snapshot!("fourier_csv", asked(&[&amplitudes[..], &["--csv"]].concat()).stdout);
    let refused = asked(&["--fourier", "--periods", "0,0.001"]);
    assert_eq!(refused.code, 1);
    assert!(
        refused.stderr.contains("the samples have no frequencies above"),
        "{}",
        refused.stderr
    );
    let refused = asked(&["--ductility", "2", "--periods", "0"]);
    assert!(refused.stderr.contains("allowed above 0 s"), "{}", refused.stderr);
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
    assert!(svg.starts_with("<svg") && !svg.contains("<text"), "letters are outlines");
    assert_snapshot!(refusal(&draw("a.png")), @"error: a.png: is there already, allowed is a new file; name another one or add --overwrite");
    assert_eq!(draw("a.jpg").code, 2);
    // The periods are those of the options, because the table of periods is empty.
    let arguments = ["spectrum", "record.csv", "--periods", "0", "--figure", "b.png"];
    printed(&motion(&folder, &arguments));
    assert!(folder.join("b.png").exists(), "drawn");
}
