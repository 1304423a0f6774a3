//! Tests of `pounding ida`: fragilities and annual frequencies of a row.

use std::fs;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use serde_json::Value;

use crate::runs::printed;
use crate::{folder, pounding};

const TOWERS: &str = r#"
name = "towers"
record = { file = "records/event0_000.csv" }

structures = [
  { sdof = { name = "left", mass_kg = 1e5, period_s = 0.8, damping.ratio = 0.05 } },
  { sdof = { name = "right", mass_kg = 2e5, period_s = 0.4, damping.ratio = 0.05 } },
]

[[contacts]]
gap_m = 0.03
law.linear_spring.impact_stiffness_n_per_m = 1e8
"#;

/// Seven events of two components, and a hazard curve.
fn with_records(test: &str) -> PathBuf {
    let folder = folder(test);
    let records = folder.join("records");
    fs::create_dir_all(&records).expect("a folder");
    for event in 0..7 {
        for axis in [0, 90] {
            let rate = 3.0 + 1.3 * f64::from(event) + 0.02 * f64::from(axis);
            let sample = |step: i32| {
                let time = 0.02 * f64::from(step);
                let noise = libm::sin(rate * time) + 0.8 * libm::sin((1.9 * rate + 1.0) * time) + 0.5 * libm::sin(7.7 * time);
                format!("{time:.2},{:.5}", libm::exp(-0.3 * time) * noise)
            };
            let rows: Vec<String> = (0..400).map(sample).collect();
            let text = format!("time_s,acceleration_m_per_s2\n{}\n", rows.join("\n"));
            fs::write(records.join(format!("event{event}_{axis:03}.csv")), text).expect("a file");
        }
    }
    fs::write(folder.join("towers.toml"), TOWERS).expect("a file");
    let curve = [0.02, 0.1, 0.3, 1.0, 3.0].map(|im: f64| format!("{im},{}", 2e-4 * libm::pow(im, -2.3)));
    fs::write(folder.join("hazard.csv"), format!("sa_g,frequency\n{}\n", curve.join("\n"))).expect("a file");
    folder
}

fn json_of(folder: &Path, arguments: &[&str]) -> Value {
    let run = pounding(folder, &[arguments, &["--json"]].concat());
    serde_json::from_str(&run.stdout).expect("JSON")
}

#[test]
fn reference_the_frequency_of_touching() {
    let folder = with_records("ida");
    let asked = [
        "ida",
        "towers.toml",
        "--records",
        "records",
        "--im",
        "sa(0.8)",
        "--hazard",
        "hazard.csv",
        "--n",
        "12",
    ];
    let asked = [&asked[..], &["--from", "0.1", "--to", "0.5", "--gaps", "0.02,0.04"]].concat();
    assert_snapshot!(printed(&pounding(&folder, &asked)));
    let json = json_of(&folder, &asked);
    // λ in closed form by C. A. Cornell: the curve is one power law.
    let touch = &json["states"][0];
    let number = |name: &str| touch[name].as_f64().expect(name);
    let (median, dispersion) = (number("median_g"), number("dispersion"));
    let closed = 2e-4 * libm::pow(median, -2.3) * libm::exp(0.5 * (2.3 * dispersion) * (2.3 * dispersion));
    assert!((number("annual_frequency_per_year") / closed - 1.0).abs() < 1e-12, "{touch}");
    // A gap of the scene has the same numbers in the table of gaps.
    let again = json_of(&folder, &[&asked[..asked.len() - 1], &["0.03"]].concat());
    assert_eq!(again["by_gap"][0]["median_g"], touch["median_g"]);
    // A wider gap closes less often.
    let frequency = |index: usize| json["by_gap"][index]["annual_frequency_per_year"].as_f64().expect("a number");
    assert!(frequency(0) > number("annual_frequency_per_year") && number("annual_frequency_per_year") > frequency(1));
}

#[test]
fn reference_the_folder_of_stripes() {
    let folder = with_records("ida-out");
    let asked = [
        "ida",
        "towers.toml",
        "--records",
        "records",
        "--im",
        "sa(0.8)",
        "--hazard",
        "hazard.csv",
    ];
    let asked = [&asked[..], &["--state", "touch,force=3e5", "--both", "--out", "out"]].concat();
    let text = printed(&pounding(&folder, &asked)).to_owned();
    assert!(text.contains("force > 300 kN"), "{text}");
    let mut names: Vec<String> = fs::read_dir(folder.join("out"))
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .filter(|name| !name.starts_with('.'))
        .collect();
    names.sort();
    let wanted = [
        "contributions.png",
        "contributions.svg",
        "fragility.png",
        "fragility.svg",
        "ida-curves.png",
        "ida-curves.svg",
        "ida.csv",
        "ida.json",
        "ida.txt",
        "stripes.csv",
    ];
    assert_eq!(names, wanted);
    let read = |name: &str| fs::read_to_string(folder.join("out").join(name)).expect(name);
    assert_eq!(
        read("ida.csv").lines().next(),
        Some("record,reversed,event,intensity_g,scale,gap_1_required_m,touch,force=300000,peak_force_n,failed")
    );
    assert_eq!(
        read("stripes.csv").lines().next(),
        Some("state,intensity_g,events,exceeding,share,fitted")
    );
    // 14 motions in two directions at 16 intensities.
    assert_eq!(read("ida.csv").lines().count(), 1 + 14 * 2 * 16);
    // It is a folder of results: the same command writes it again.
    let again = pounding(&folder, &asked);
    assert_eq!(printed(&again), text);
}

#[test]
fn extreme_what_gives_no_fragility_prints_its_stripes() {
    let folder = with_records("ida-refused");
    let few = ["ida", "towers.toml", "--records", "records", "--stripes", "0.01,3"];
    let run = pounding(&folder, &few);
    assert!(run.code == 1 && run.stdout.contains("7 of 7"), "{}", run.stdout);
    let said = |arguments: &[&str]| {
        let run = pounding(&folder, &[&["ida", "towers.toml"], arguments].concat());
        assert!(run.code > 0 && run.stdout.is_empty(), "{}", run.stdout);
        // The hint at the options, after an empty line, is that of every command.
        run.stderr.split("\n\n").next().unwrap_or_default().trim_end().to_owned()
    };
    let records = ["--records", "records"];
    let refused = [
        run.stderr.trim_end().to_owned(),
        said(&[&records[..], &["--hazard", "hazard.csv"]].concat()),
        said(&[&records[..], &["--stripes", "0.1,0.1"]].concat()),
        said(&[&records[..], &["--from", "3"]].concat()),
        said(&["--stripe", "records"]),
        said(&[&records[..], &["--state", "lean"]].concat()),
        said(&[&records[..], &["--im", "sv(1)"]].concat()),
    ];
    assert_snapshot!(refused.join("\n"));
}

/// Two frames with floors at different heights, elastic, whose drift is asked for.
const STAGGERED: &str = r#"
name = "staggered"
record = { file = "records/event0_000.csv" }

structures = [
  { building = { name = "left", period_s = 2.4, damping.ratio = 0.05, storeys = [{ mass_kg = 1e5, height_m = 3, repeat = 3 }] } },
  { building = { name = "right", period_s = 0.4, damping.ratio = 0.05, storeys = [{ mass_kg = 1e5, height_m = 4, repeat = 2 }] } },
]

[[contacts]]
gap_m = 0.03
law.linear_spring.impact_stiffness_n_per_m = 1e8
"#;

/// The answer said nothing of columns that floors face, of gravity, and of elastic frames that bear more than their weight.
#[test]
fn issue_cautions_about_the_model_stand_before_the_tables() {
    let folder = with_records("ida-cautions");
    fs::write(folder.join("staggered.toml"), STAGGERED).expect("a file");
    let asked = ["ida", "staggered.toml", "--records", "records", "--im", "Sa(0.8)"];
    let drift = [&asked[..], &["--state", "drift=0.02", "--from", "0.2"]].concat();
    let said = printed(&pounding(&folder, &drift)).to_owned();
    let flat = said.split_whitespace().collect::<Vec<_>>().join(" ");
    for words in [
        "a slab of the neighbour hits it between its floors",
        "stability coefficient P Δ/(V h)",
        "times the weight above",
        "in 14 of 14 runs",
    ] {
        assert!(flat.contains(words), "{words}: {said}");
    }
    let at = |words: &str| said.find(words).unwrap_or_else(|| panic!("{words}: {said}"));
    assert!(at("Answer") < at("Warnings") && at("Warnings") < at("Intensity"), "{said}");
    assert_snapshot!(said);
    // Touching is asked of a row whose structures stand apart; two tables follow the warnings there, too.
    let touch = [&asked[..5], &["SA_avg(0.2..2)", "--gaps", "0.02"]].concat();
    let said = printed(&pounding(&folder, &touch)).to_owned();
    let flat = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(flat.contains("faces columns of its neighbour"), "{said}");
    let at = |words: &str| said.find(words).unwrap_or_else(|| panic!("{words}: {said}"));
    assert!(at("Warnings") < at("Gap "), "{said}");
}

/// What no row can reach, and what changes nothing, was taken without a word.
#[test]
fn issue_what_has_no_effect_is_refused() {
    let folder = with_records("ida-no-effect");
    let table = "Result ID,Record Sequence Number,Scale Factor,Horizontal-1 Acc. Filename,Horizontal-2 Acc. Filename\n\
                 1,1,2.5,event0_000.csv,event0_090.csv\n";
    let table = format!(" -- Summary of Metadata of Selected Records --\n{table}");
    fs::write(folder.join("records/_SearchResults.csv"), table).expect("a file");
    let asked = ["ida", "towers.toml", "--records", "records"];
    let refused = |more: &[&str]| {
        let run = pounding(&folder, &[&asked[..], more].concat());
        assert!(run.code > 0 && run.stdout.is_empty(), "{}", run.stdout);
        run.stderr
    };
    let factors = refused(&["--selection-factors"]);
    assert!(factors.contains("--stripe in place of --records"), "{factors}");
    let collapse = refused(&["--state", "collapse"]);
    assert!(collapse.contains("p_delta = \"from_masses\""), "{collapse}");
    // Every motion is scaled to every intensity, so that factors of a selection are no matter of this answer.
    let scaled = pounding(&folder, &[&asked[..], &["--from", "0.1", "--to", "0.5"]].concat());
    assert!(!scaled.stdout.contains("scale factors"), "{}", scaled.stdout);
    let own = [
        "ida",
        "towers.toml",
        "--stripe",
        "0.1=records",
        "--stripe",
        "0.3=records",
        "--details",
    ];
    let own = pounding(&folder, &own);
    assert!(own.stdout.contains("scale factors"), "{}", own.stdout);
}
