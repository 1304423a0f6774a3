//! The atlas of contact laws on short ladders: every law is in every table, and no failure is dropped.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use insta::assert_snapshot;
use pounding_contact::{Calibration, FreePair, LawName, reduced_mass};
use pounding_reference::Fineness;
use pounding_scene::{Scene, Simulation, Structure};
use pounding_studies::{Atlas, AtlasSettings, Completed, Output, StudyFile};
use rayon::prelude::*;

fn read() -> StudyFile {
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    StudyFile::read(&studies.join("laws.json")).expect("a readable study")
}

/// The study with two of its scenes and few settings.
fn study() -> (Completed, AtlasSettings) {
    let mut file = read();
    let Output::Laws(settings) = file.study.output.clone() else {
        panic!("a study of laws");
    };
    file.study.scenes.retain(|scene| scene.name.starts_with("two structures"));
    let settings = AtlasSettings {
        restitutions: vec![0.05, 0.65, 1.0],
        approach_speeds_m_per_s: vec![0.03, 0.3],
        steps_per_contact: vec![2.0, 20.0],
        ..settings
    };
    let completed = Completed::run(file, &|| ()).expect("a study that runs");
    (completed, settings)
}

type Files = BTreeMap<PathBuf, Vec<u8>>;

static FILES: LazyLock<Files> = LazyLock::new(|| files(&study()));

fn files((completed, settings): &(Completed, AtlasSettings)) -> Files {
    let atlas = Atlas::draw(completed, settings, &|| ()).expect("settings that laws take");
    atlas.files().expect("figures that can be drawn")
}

fn text<'a>(files: &'a Files, table: &str) -> &'a str {
    std::str::from_utf8(&files[&Path::new("laws").join(table)]).expect("CSV is text")
}

/// Rows of a table as columns by name.
fn rows(files: &Files, table: &str) -> Vec<BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_reader(text(files, table).as_bytes());
    let rows = reader.deserialize();
    rows.map(|row| row.expect("a row of text")).collect()
}

#[test]
fn limit_every_table_names_every_law() {
    let laws: Vec<_> = LawName::ALL.map(LawName::name).into();
    for table in [
        "restitution.csv",
        "approach-speed.csv",
        "free-impact.csv",
        "time-step.csv",
        "scenes.csv",
    ] {
        let mut named: Vec<_> = rows(&FILES, table).iter().map(|row| row["law"].clone()).collect();
        named.dedup();
        // The rows of one scene follow those of another.
        assert_eq!(named[..laws.len()], laws, "{table}");
    }
    // Springs alone lose nothing, the impulsive law has no force, and four names share one force.
    let mut compared: Vec<_> = LawName::ALL.into_iter().filter(|law| !law.is_elastic()).collect();
    compared.retain(|law| law.stiffness().is_some());
    compared.dedup_by_key(|law| law.about().force);
    for row in rows(&FILES, "dependence.csv") {
        assert_eq!(row["laws"], compared.len().to_string(), "{row:?}");
    }
}

#[test]
fn reference_the_exact_calibration_delivers_what_was_asked() {
    let mut compared = 0;
    for row in rows(&FILES, "restitution.csv") {
        let number = |column: &str| row[column].parse::<f64>();
        if row["failed"].is_empty() {
            let found = number("delivered_by_exact_calibration").expect("a number");
            let asked = number("restitution_asked").expect("a number");
            assert!((found - asked).abs() <= 1e-9, "{row:?}");
            compared += 1;
        } else {
            assert!(row["failed"].ends_with("this law has no damping"), "{row:?}");
        }
    }
    let springs = LawName::ALL.into_iter().filter(|law| law.is_elastic()).count();
    assert_eq!(compared, 3 * LawName::ALL.len() - 2 * springs, "springs have e = 1 alone");
}

#[test]
fn limit_laws_agree_until_the_first_touch() {
    for row in rows(&FILES, "dependence.csv") {
        if row["quantity"] == "time_of_first_collision" {
            assert_eq!((&*row["spread"], &*row["stereomechanical_over_mean"]), ("0", "1"));
        }
    }
}

#[test]
fn reference_free_impacts_and_what_depends_on_the_law() {
    let on_threads = |n_threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build();
        pool.expect("threads").install(|| files(&study()))
    };
    for table in ["free-impact.csv", "dependence.csv"] {
        assert_snapshot!(table, text(&FILES, table));
    }
    for n_threads in [1, 2] {
        assert!(*FILES == on_threads(n_threads), "{n_threads} threads give the same bytes");
    }
}

#[test]
fn extreme_a_scene_that_cannot_run_says_why_under_every_law() {
    let (mut completed, settings) = study();
    completed.file.study.scenes[0].duration_s = Some(-1.0);
    let files = files(&(completed, settings));
    let failed = rows(&files, "scenes.csv");
    let failed: Vec<_> = failed.iter().filter(|row| !row["failed"].is_empty()).collect();
    assert_eq!(failed.len(), LawName::ALL.len(), "a row for each");
    for row in failed {
        assert!(row["failed"].contains("duration_s: found -1"), "{row:?}");
        assert!(row["value"].is_empty(), "{row:?}");
    }
}

/// A scene with another law, calibrated for every pair.
fn under(law: LawName, scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    let linear = law.stiffness_unit() == Some("N/m");
    let stiffness = if linear { 9.35e7 } else { 2.75e9 };
    let inverse_mass = |structure: &Structure| match structure {
        Structure::Sdof(structure) => 1.0 / structure.mass_kg,
        Structure::Building(_) | Structure::Wall => 0.0,
    };
    let neighbours = scene.structures.windows(2);
    for (contact, pair) in scene.contacts.iter_mut().flatten().zip(neighbours) {
        let pair = FreePair {
            reduced_mass: reduced_mass(inverse_mass(&pair[0]), inverse_mass(&pair[1])),
            approach_speed: 0.3,
        };
        let calibrated = law.calibrated(stiffness, 0.65, Calibration::Exact, &pair);
        contact.law = calibrated.expect("a law that takes these settings");
    }
    scene
}

#[test]
fn reference_a_second_route_gives_the_same_scenes_under_every_law() {
    let file = read();
    let mut laws = LawName::ALL.to_vec();
    laws.retain(|law| !law.is_elastic());
    laws.dedup_by_key(|law| law.about().force);
    let scenes = &file.study.scenes;
    let runs: Vec<_> = laws
        .into_iter()
        .flat_map(|law| scenes.iter().map(move |scene| (law, scene)))
        .collect();
    runs.into_par_iter().for_each(|(law, scene)| {
        let what = format!("{}, {law:?}", scene.name);
        let prepared = Simulation::new(&under(law, scene), file.base()).expect("a sound scene");
        let exact = prepared.run(None).expect("an exact run");
        let second = pounding_studies::second_route(&prepared, Fineness::FINE).expect("a second run");
        let met: usize = second.collisions.iter().map(Vec::len).sum();
        assert_eq!(exact.collisions.all().len(), met, "{what}: collisions");
        // The allowed distance is that of the study of accuracy, which knows the condition of every result.
        let allowed = if law == LawName::Stereomechanical { 1e-12 } else { 1e-9 };
        for (index, other) in second.structures.iter().enumerate() {
            let close = |one: f64, other: f64| (one - other).abs() <= allowed * other.abs();
            let momentum = exact.momentum.of(index);
            let displacement = exact.peaks.of(index).displacement.value;
            assert!(close(momentum, other.transferred_momentum), "{what}: momentum");
            assert!(close(displacement, other.displacement.value), "{what}: displacement");
        }
    });
}
