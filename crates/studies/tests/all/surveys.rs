//! Parts of the surveys. Rows that do not depend on others are compared with the committed tables; others are snapshots.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use pounding_scene::Scene;
use pounding_studies::{Output, StudyFile, Survey, SurveyStudy};
use sha2::{Digest, Sha256};

type Files = BTreeMap<PathBuf, Vec<u8>>;

const SURVEYS: [&str; 5] = ["fragility", "pounding-spectra", "required-gap", "sensitivity", "stiffness-ratio"];

fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn studies() -> Vec<StudyFile> {
    StudyFile::read_all(&top().join("studies")).expect("readable studies")
}

/// The tables of a survey whose scenes and settings are cut down.
fn run(id: &str, cut: impl FnOnce(&mut Vec<Scene>, &mut Survey)) -> Files {
    let mut files = studies();
    let study = files.iter_mut().find(|file| file.id == id);
    let study = &mut study.expect("a survey").study;
    if let Output::Survey(survey) = &mut study.output {
        cut(&mut study.scenes, survey);
    }
    let surveys = SurveyStudy::all(&files).expect("motions that can be read");
    let survey = surveys.iter().find(|survey| survey.id() == id);
    survey.expect("a survey").run().expect("runs that do not fail")
}

fn text<'a>(files: &'a Files, path: &str) -> &'a str {
    std::str::from_utf8(&files[Path::new(path)]).expect("CSV is text")
}

fn committed(path: &str) -> String {
    std::fs::read_to_string(top().join("results").join(path)).expect("a committed table")
}

/// Asserts that every row of a part is in the committed table.
fn hold(files: &Files, path: &str) {
    let whole = committed(path);
    let whole: BTreeSet<&str> = whole.lines().collect();
    let part = text(files, path);
    assert!(part.lines().count() > 1, "{path}");
    for line in part.lines() {
        assert!(whole.contains(line), "{path}: {line}");
    }
}

#[test]
fn limit_committed_tables_are_those_of_their_command() {
    for id in SURVEYS {
        let made_by = committed(&format!("{id}/made-by.txt"));
        let mut lines = made_by.lines();
        assert_eq!(lines.next(), Some(&*format!("cargo xtask studies {id}")));
        let mut n = 0;
        for line in lines {
            let (name, hash) = line
                .strip_prefix("SHA-256 of ")
                .and_then(|line| line.split_once(": "))
                .expect("a hash");
            let found = Sha256::digest(committed(&format!("{id}/{name}")).as_bytes());
            assert_eq!(hash, format!("{found:x}"), "{id}/{name}");
            n += 1;
        }
        assert!(n > 0, "{id}");
    }
}

#[test]
fn reference_required_gaps_of_some_pairs() {
    let files = run("required-gap", |_, survey| {
        if let Survey::RequiredGap(settings) = survey {
            settings.longer_periods_s = vec![0.8];
            settings.period_ratios = vec![0.3, 0.9];
            settings.scan.longer_periods_s = vec![0.8];
            settings.scan.period_ratios = vec![0.9];
            settings.scan.n_gaps = 4;
        }
    });
    hold(&files, "required-gap/widths.csv");
    assert_snapshot!("wider-and-worse.csv", text(&files, "required-gap/wider-and-worse.csv"));
}

#[test]
fn reference_spectra_of_two_periods() {
    let files = run("pounding-spectra", |_, survey| {
        if let Survey::PoundingSpectra(settings) = survey {
            let last = settings.periods_s.len() - 1;
            settings.periods_s = vec![settings.periods_s[5], settings.periods_s[last]];
            settings.mass_ratios = vec![4.0];
            settings.checked = 1;
        }
    });
    hold(&files, "pounding-spectra/spectra.csv");
}

#[test]
fn reference_fragility_of_eight_motions() {
    let files = run("fragility", |_, survey| {
        if let Survey::Fragility(settings) = survey {
            settings.motions = 8;
            settings.pga_m_per_s2 = vec![0.5, 2.0];
            settings.gaps_m = vec![0.03, 0.15];
        }
    });
    assert_snapshot!("fragility.csv", text(&files, "fragility/fragility.csv"));
}

#[test]
fn reference_the_middle_structure_at_the_papers_ratio() {
    let files = run("stiffness-ratio", |scenes, survey| {
        scenes.retain(|scene| scene.name == "layout C, nonlinear");
        if let Survey::StiffnessRatio(settings) = survey {
            let near = |ratio: &f64| (560.0..760.0).contains(ratio);
            settings.stiffness_ratios.retain(near);
        }
    });
    hold(&files, "stiffness-ratio/middle.csv");
}

#[test]
fn reference_sensitivity_of_four_samples() {
    let files = run("sensitivity", |_, survey| {
        if let Survey::Sensitivity(settings) = survey {
            settings.samples = 4;
            settings.bootstrap = 20;
        }
    });
    assert_snapshot!("indices.csv", text(&files, "sensitivity/indices.csv"));
}
