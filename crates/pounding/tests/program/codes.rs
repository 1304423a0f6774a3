//! Tests of gaps as codes ask for them: floors beside columns, floors that may not be level, property lines, and the code that is named.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use serde_json::Value;

use crate::pounding;
use crate::unusual::{OF_FOLDERS, flat, record, workplace};

/// Nine storeys beside six, with storeys of 3.1 m.
const TOWERS: &str = r#"
name = "nine and six"
record.file = "records/good.csv"
structures = [
  { building = { name = "nine", period_s = 0.95, damping.ratio = 0.05, storeys = [{ mass_kg = 310e3, height_m = 3.1, repeat = 9 }] } },
  { building = { name = "six", period_s = 0.55, damping.ratio = 0.05, storeys = [{ mass_kg = 260e3, height_m = 3.1, repeat = 6 }] } },
]
contacts = [{ gap_m = 0.05, law.hertz_damp = { impact_stiffness_n_per_m1_5 = 2e9, restitution = 0.65 } }]
"#;

/// The same with storeys of 3.6 m in the lower one.
fn staggered() -> String {
    TOWERS.replace("height_m = 3.1, repeat = 6", "height_m = 3.6, repeat = 6")
}

fn refusal(work: &Path, arguments: &[&str]) -> String {
    let ended = pounding(work, arguments);
    assert_eq!(ended.code, 1, "{}", ended.stdout);
    ended.stderr.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn json(work: &Path, arguments: &[&str]) -> Value {
    let ended = pounding(work, &[arguments, &["--json"]].concat());
    serde_json::from_str(&ended.stdout).unwrap_or_else(|_| panic!("{}", ended.stderr))
}

/// Storeys of 3.1 and 3.6 m got no answer at all: "no gap from here is safe for it", "none of the records shakes the row".
#[test]
fn issue_storeys_that_do_not_align_get_their_gap() {
    let work = workplace("codes_staggered", &staggered(), false);
    // In `assess` the largest width is that of the columns; `gap` gives every width apart.
    for (arguments, apart) in OF_FOLDERS[..2]
        .iter()
        .zip(["So wide a gap keeps them apart, too.", "mm keep floors from columns"])
    {
        let said = flat(&pounding(&work, arguments));
        for words in [
            "12 floors face columns of the neighbour (\"nine, floor 1\" and others): a floor that hits a column can bring the building down.",
            apart,
        ] {
            assert!(said.contains(words), "{words}: {said}");
        }
    }
    let motion = &json(&work, OF_FOLDERS[1])["motions"][0]["gaps"][0];
    let [required, abs] = ["required_m", "abs_m"].map(|name| motion[name].as_f64().expect("a width"));
    assert!(required > 0.5 * abs && required <= abs * (1.0 + 1e-9), "{required} {abs}");
    assert_eq!(motion["at_column"], true);
    let assessed = json(&work, OF_FOLDERS[0]);
    let gap = &assessed["gaps"][0];
    assert_eq!(gap["touching"], 2, "{gap}");
    assert!(gap["proposed_m"].as_f64() >= gap["beside_columns_m"].as_f64(), "{gap}");
    // The proposed gap is enough, and nothing else is said of it.
    let proposed = gap["proposed_m"].as_f64().expect("a width");
    fs::write(
        work.join("scene.toml"),
        staggered().replace("gap_m = 0.05", &format!("gap_m = {proposed}")),
    )
    .expect("it can be written");
    let said = flat(&pounding(&work, OF_FOLDERS[0]));
    assert!(
        said.contains("mm is enough between nine and six") && !said.contains("hit by a slab"),
        "{said}"
    );
    // A run has the force of every slab, and the shear force and the moment of the column.
    fs::write(work.join("scene.toml"), staggered()).expect("it can be written");
    let said = flat(&pounding(&work, &["run", "scene.toml"]));
    assert!(said.contains("nine, column of storey 7 – six, floor 6"), "{said}");
    assert!(
        said.contains("a slab of the neighbour hits it between its floors: a shear force of") && said.contains("column_capacity_n"),
        "{said}"
    );
    let run = json(&work, &["run", "scene.toml"]);
    let pairs = run["pairs"].as_array().expect("pairs");
    assert_eq!(pairs.len(), 12);
    let hit = pairs
        .iter()
        .find(|one| one["collisions"].as_u64() > Some(0))
        .expect("one that is hit");
    let number = |name: &str| hit[name].as_f64().expect("a number");
    assert!(
        number("column_shear_n") < number("peak_force_n") && number("column_moment_nm") > 0.0,
        "{hit}"
    );
    // `floors = "level"` contradicts these heights.
    let told = staggered().replace("record.file", "floors = \"level\"\nrecord.file");
    fs::write(work.join("scene.toml"), told).expect("it can be written");
    let said = refusal(&work, &["run", "scene.toml"]);
    assert!(
        said.contains("beside the columns of \"six\"") && said.contains("leave out `floors`"),
        "{said}"
    );
}

/// Buildings were matched by the numbers of their storeys after a mere warning: 84.0 mm by number, 89.1 by height.
#[test]
fn issue_floors_that_may_not_be_level_are_asked_for() {
    let counted = TOWERS.replace("height_m = 3.1, repeat = 6", "repeat = 6");
    let work = workplace("codes_counted", &counted, false);
    let alone: [&[&str]; 2] = [&["run", "scene.toml"], &["check", "scene.toml"]];
    for arguments in alone.into_iter().chain(OF_FOLDERS) {
        let said = refusal(&work, arguments);
        let place = "structures[1].building.storeys[0].height_m: found none";
        assert!(said.contains(place) && said.contains("floors = \"level\""), "{arguments:?}: {said}");
    }
    assert_snapshot!(refusal(&work, OF_FOLDERS[1]), @r#"error: scene.toml: scene "nine and six": structures[1].building.storeys[0].height_m: found none, so that nothing tells which floors face floors, allowed is the height of every storey of the row; or write floors = "level" in the scene if storeys of one number are at one height. A floor that faces a column can bring a building down"#);
    let told = format!("floors = \"level\"\n{}", counted.trim_start());
    fs::write(work.join("scene.toml"), &told).expect("it can be written");
    for arguments in alone.into_iter().chain(OF_FOLDERS) {
        let said = flat(&pounding(&work, arguments));
        assert!(!said.contains("taken to be level"), "{arguments:?}: {said}");
    }
    let by_number = json(&work, OF_FOLDERS[1])["motions"][0]["gaps"][0]["required_m"].clone();
    fs::write(work.join("scene.toml"), TOWERS).expect("it can be written");
    assert_eq!(json(&work, OF_FOLDERS[1])["motions"][0]["gaps"][0]["required_m"], by_number);
    // Heights that are given decide themselves.
    let contradicts = format!("floors = \"level\"\n{}", staggered().trim_start());
    fs::write(work.join("scene.toml"), contradicts).expect("it can be written");
    let said = refusal(&work, OF_FOLDERS[1]);
    assert!(said.contains("floors: found a floor of \"nine\""), "{said}");
}

/// A building beside a wall, or structures of one storey, need no heights.
#[test]
fn limit_walls_and_single_storeys_ask_for_no_heights() {
    let wall = r#"
name = "tower beside a wall"
record.file = "records/good.csv"
structures = [{ building = { name = "a", period_s = 0.5, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, repeat = 3 }] } }, { wall = {} }]
contacts = [{ gap_m = 0.05, law.stereomechanical.restitution = 0.5 }]
"#;
    let work = workplace("codes_walls", wall, false);
    for arguments in OF_FOLDERS {
        flat(&pounding(&work, arguments));
    }
}

/// "Is it enough by my code?" was never said: no mean, no largest, SRSS for any two owners, and no word about what 0.7 accepts.
#[test]
fn issue_the_named_code_gives_its_own_width() {
    let work = workplace("codes_named", TOWERS, false);
    let asked = |arguments: &[&str], code: &str| flat(&pounding(&work, &[arguments, &["--code", code]].concat()));
    for arguments in &OF_FOLDERS[..2] {
        let said = asked(arguments, "en-1998-1");
        let by = "By EN 1998-1:2004, 4.4.2.7: ";
        assert!(said.contains(by), "{said}");
        for words in [
            "mm between nine and six (largest of 2 events; the code wants 3 or more), for two owners of the ground, with 0.7 for level floors, which accepts that slabs meet.",
            "Between nine and six: a property line is assumed",
            "Factors for level floors accept that slabs meet: EN 1998-1 (0.7)",
            "C_d, q, R and I_e of the codes are not applied",
            "the given 50 mm do not meet it.",
        ] {
            assert!(said.contains(words), "{words}: {said}");
        }
    }
    for index in 0..5_u32 {
        let path = work.join("records").join(format!("more-{index}.csv"));
        fs::write(path, record(0.7 + 0.17 * f64::from(index), 1.5)).expect("it can be written");
    }
    let said = asked(OF_FOLDERS[1], "en-1998-1");
    assert!(said.contains("(mean of 7 events)"), "{said}");
    let said = asked(OF_FOLDERS[1], "asce-7-16");
    assert!(
        said.contains("By ASCE/SEI 7-16, 12.12.3: ") && said.contains("(largest of 7 events; the code wants 11 or more)"),
        "{said}"
    );
    let ruled = |work: &Path| {
        let all = json(work, OF_FOLDERS[0]);
        let rules = all["gaps"][0]["rules"].as_array().expect("rules").clone();
        let one = rules.into_iter().find(|one| one["rule"] == "EN 1998-1").expect("a rule");
        assert_eq!(one["asked_is_mean"], true);
        one["width_m"]["asked"].as_f64().expect("a width")
    };
    let other = ruled(&work);
    fs::write(
        work.join("scene.toml"),
        TOWERS.replace("gap_m = 0.05,", "gap_m = 0.05, property = \"same\","),
    )
    .expect("it can be written");
    let same = ruled(&work);
    assert!(same < 0.95 * other && same > 0.7 * other, "{same} {other}");
    assert!(asked(OF_FOLDERS[1], "en-1998-1").contains("Between nine and six: both stand on one property, as the scene says"));
}

/// The halving credited to Amendment 1 of IS 1893 led like any other rule, though nobody had read its clause.
#[test]
fn issue_a_clause_that_was_not_seen_never_leads() {
    let work = workplace("codes_unseen", TOWERS, false);
    let ended = pounding(&work, &[OF_FOLDERS[1], &["--code", "is-1893"]].concat());
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("allowed are en-1998-1, asce-7-16"), "{}", ended.stderr);
    let said = flat(&pounding(&work, OF_FOLDERS[0]));
    assert!(said.contains("IS 1893 (Part 1):2016: clause not seen"), "{said}");
}

/// NTC took the peak of each record for `a_g` S, though a spectrum of the site was given.
#[test]
fn issue_the_site_gives_the_ground_acceleration_of_a_code() {
    let work = workplace("codes_site", TOWERS, false);
    let width = |target: &str| {
        let all = json(&work, &[OF_FOLDERS[0], &["--target", target]].concat());
        let rules = all["gaps"][0]["rules"].as_array().expect("rules").clone();
        let one = rules.into_iter().find(|one| one["rule"] == "NTC 2018").expect("a rule");
        one["width_m"]["median"].as_f64().expect("a width")
    };
    // The level of both roofs is at 18.6 m: 1 % of it times a_g S/(0.5 g) = 0.9 exceeds any sum of peaks of these weak plateaus.
    fs::write(work.join("weak.csv"), "0.01,0.001\n10,0.001\n").expect("it can be written");
    let [site, table] = ["ec8:a_g=0.45g,ground=A", "weak.csv"].map(width);
    assert!(site >= 0.186 * 0.9 * (1.0 - 1e-12), "{site}");
    assert!(table < 0.05, "{table}");
}

/// The record that decides a width was named nowhere, and `gap` did not say that the scene's own factor holds for every record.
#[test]
fn issue_the_deciding_record_and_its_factor_are_named() {
    let scaled = TOWERS.replace(
        "record.file = \"records/good.csv\"",
        "record = { file = \"records/good.csv\", scale = 5 }",
    );
    assert_ne!(scaled, TOWERS);
    let work = workplace("codes_decides", &scaled, false);
    for arguments in &OF_FOLDERS[..2] {
        let said = flat(&pounding(&work, arguments));
        assert!(
            said.contains("argest under other.csv (× 5.000, which belongs to another earthquake)"),
            "{said}"
        );
    }
    let said = flat(&pounding(&work, OF_FOLDERS[1]));
    assert!(
        said.contains("Every record is multiplied by 5, since the scene does so with its own."),
        "{said}"
    );
}
