//! Tests of pairs of horizontal components, and of a download of PEER as it is.

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use serde_json::Value;

use crate::suites::TOWERS;
use crate::{folder, pounding, refusal};

/// A decaying motion in g; each rate is another one.
fn value(rate: f64, step: i32) -> f64 {
    let time = 0.02 * f64::from(step);
    0.4 * time * libm::exp(-time) * (libm::sin(rate * time) + 0.6 * libm::sin(2.3 * rate * time))
}

fn at2(title: &str, quantity: &str, value: impl Fn(i32) -> f64) -> String {
    let values: Vec<String> = (0..300).map(|step| format!("{:e}\n", value(step))).collect();
    let values = values.concat();
    format!("PEER NGA STRONG MOTION DATABASE RECORD\n{title}\n{quantity}\nNPTS=   300, DT=   .0200 SEC,\n{values}")
}

const ACCELERATION: &str = "ACCELERATION TIME SERIES IN UNITS OF G";

/// A folder with a scene and a ZIP archive in the layout of a download of PEER. The second component of RSN7 is 0.75 times the first.
fn download(test: &str) -> PathBuf {
    let folder = folder(test);
    fs::write(folder.join("towers.toml"), TOWERS).expect("a file");
    let selection = " -- Summary of Metadata of Selected Records --\n\
         Result ID, Record Sequence Number, Scale Factor, Earthquake Name, Horizontal-1 Acc. Filename, Horizontal-2 Acc. Filename\n\
         1, 6, 2.5, \"Chi-Chi, Taiwan\", RSN6_A180.AT2, RSN6_A270.AT2\n2, 7, 0.5, B, RSN7_B000.AT2, RSN7_B090.AT2\n\n";
    let files = [
        ("_SearchResults.csv", selection.to_owned()),
        ("RSN6_A180.AT2", at2("A, 180", ACCELERATION, |step| value(5.0, step))),
        (
            "RSN6_A180.VT2",
            at2("A, 180", "VELOCITY TIME SERIES IN UNITS OF CM/S", |step| value(5.0, step)),
        ),
        ("RSN6_A270.AT2", at2("A, 270", ACCELERATION, |step| value(5.7, step))),
        ("RSN6_A-UP.AT2", at2("A, UP", ACCELERATION, |step| value(6.1, step))),
        ("RSN7_B000.AT2", at2("B, 0", ACCELERATION, |step| value(7.7, step))),
        ("RSN7_B090.AT2", at2("B, 90", ACCELERATION, |step| 0.75 * value(7.7, step))),
    ];
    let mut archive = rawzip::ZipArchiveWriter::new(Vec::new());
    for (name, text) in &files {
        let name = format!("PEERNGARecords_Unscaled/{name}");
        let (mut entry, config) = archive.new_file(name.as_str()).start().expect("an entry");
        let mut writer = config.wrap(&mut entry);
        writer.write_all(text.as_bytes()).expect("memory");
        let (_, descriptor) = writer.finish().expect("memory");
        entry.finish(descriptor).expect("an entry");
    }
    fs::write(folder.join("peer.zip"), archive.finish().expect("an archive")).expect("a file");
    folder
}

fn json(folder: &std::path::Path, arguments: &[&str]) -> Value {
    let ended = pounding(folder, &[arguments, &["--json"]].concat());
    serde_json::from_str(&ended.stdout).unwrap_or_else(|error| panic!("{arguments:?}: {error}: {}", ended.stderr))
}

/// The width along the second component of a polarised pair is 0.75 times that along the first, and one pair is one event.
#[test]
fn reference_gaps_under_a_download_along_an_axis() {
    let folder = download("peer");
    let elastic = TOWERS.replace(", yield_displacement_m = 0.02", "");
    fs::write(folder.join("towers.toml"), elastic).expect("a file");
    let widths = |axis: &str| {
        let found = json(&folder, &["gap", "towers.toml", "--records", "peer.zip", "--axis", axis]);
        let motions = found["motions"].as_array().expect("motions").clone();
        assert_eq!((motions.len(), &found["records"]["events"]), (4, &Value::from(2)), "{found}");
        let of = |name: &str| {
            let own = motions
                .iter()
                .filter(|one| one["record"].as_str().is_some_and(|one| one.starts_with(name)));
            own.map(|one| one["gaps"][0]["required_m"].as_f64().expect("a width"))
                .collect::<Vec<_>>()
        };
        of("RSN7_B*.AT2")
    };
    let [north, east] = ["0", "90"].map(widths);
    assert_eq!(north.len(), 2, "both directions");
    for (north, east) in north.iter().zip(&east) {
        assert!((east / north - 0.75).abs() < 1e-9, "{east} {north}");
    }
}

#[test]
fn reference_spectra_of_pairs_by_the_program() {
    let folder = download("peer-spectra");
    let found = json(
        &folder,
        &["motion", "spectrum", "--pairs", "peer.zip", "--periods", "0.3,1", "--damping", "5%"],
    );
    let pair = &found["pairs"][1];
    assert_eq!(pair["pair"], "RSN7_B*.AT2");
    assert_eq!(pair["angles_deg"], serde_json::json!([0.0, 90.0]));
    for values in pair["spectra"][0]["values"].as_array().expect("values") {
        let of = |name: &str| values[name].as_f64().expect("a number") / values["first_sa_m_per_s2"].as_f64().expect("a number");
        for (name, wanted) in [
            ("second_sa_m_per_s2", 0.75),
            ("rotd100_sa_m_per_s2", 1.25),
            ("rotd50_sa_m_per_s2", 0.883_883_476_483_184_4),
            ("geometric_mean_sa_m_per_s2", 0.866_025_403_784_438_6),
        ] {
            assert!((of(name) / wanted - 1.0).abs() < 1e-7, "{name}: {} against {wanted}", of(name));
        }
    }
    let csv = pounding(
        &folder,
        &["motion", "spectrum", "--pairs", "peer.zip", "--periods", "0.3,1", "--csv"],
    )
    .stdout;
    assert_eq!(csv.lines().count(), 5, "{csv}");
    let text = pounding(&folder, &["motion", "info", "peer.zip"]).stdout;
    assert!(text.contains("RSN7_B*.AT2: PGA"), "{text}");
    assert!(text.contains("2 motions") || text.contains("4 motions of 2 events"), "{text}");
    let alone = refusal(&pounding(&folder, &["motion", "spectrum", "peer.zip", "towers.toml"]));
    assert!(alone.contains("give --pairs"), "{alone}");
}

/// Collects all numbers of one name.
fn numbers(name: &str, of: &Value, to: &mut Vec<f64>) {
    match of {
        Value::Object(fields) => {
            to.extend(fields.get(name).and_then(Value::as_f64));
            fields.values().for_each(|one| numbers(name, one, to));
        }
        Value::Array(all) => all.iter().for_each(|one| numbers(name, one, to)),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// A download, a target over a range of periods, one factor for all records.
#[test]
fn reference_assess_a_download_with_one_factor() {
    let folder = download("peer-assess");
    let base = [
        "assess",
        "towers.toml",
        "--records",
        "peer.zip",
        "--axis",
        "30",
        "--target",
        "ec8:a_g=0.3g,ground=C",
    ];
    let scales = |more: &[&str]| {
        let found = json(&folder, &[&base[..], more].concat());
        let mut scales = Vec::new();
        numbers("scale_factor", &found, &mut scales);
        scales.sort_by(f64::total_cmp);
        scales.dedup();
        scales
    };
    let each = scales(&["--target-periods", "0.2..1"]);
    let one = scales(&["--target-periods", "0.2..1", "--one-factor"]);
    assert_eq!((each.len(), one.len()), (2, 1), "{each:?} {one:?}");
    let other_range = scales(&["--target-periods", "0.1..2"]);
    assert!(
        each.iter().zip(&other_range).any(|(one, other)| (one / other - 1.0).abs() > 1e-3),
        "{each:?} {other_range:?}"
    );
}
