//! Pairs of horizontal components in a folder, and motions along the axis of a row.

use pounding_assess::{DesignSpectrum, LeftOutKind, Scaling, SpectrumTarget, TargetFactors};
use pounding_scene::{FileUse, Scene};

use crate::suite::{Folder, list};

fn at2(title: &str, rate: f64) -> String {
    format!(
        "PEER STRONG MOTION DATABASE RECORD\n{title}\nACCELERATION TIME HISTORY IN UNITS OF G\nNPTS= 300, DT= .02 SEC\n{}",
        list(rate)
    )
}

fn folder() -> Folder {
    Folder::new()
        .with("RSN6_A180.AT2", at2("A, 180", 5.0))
        .with("RSN6_A270.AT2", at2("A, 270", 5.7))
        .with("RSN6_A-UP.AT2", at2("A, UP", 6.1))
        .with("RSN7_B090.AT2", at2("B, 90", 7.7))
        .with("k_H1.AT2", at2("K, H1", 8.3))
        .with("k_H2.AT2", at2("K, H2", 8.9))
}

#[test]
fn reference_the_horizontals_of_a_record_are_a_pair() {
    let suite = folder().suite();
    let pairs = suite.pairs();
    let found: Vec<_> = pairs
        .iter()
        .map(|pair| (pair.name(), pair.angles.degrees, pair.angles.from_north))
        .collect();
    assert_eq!(
        found,
        [
            ("RSN6_A*.AT2".to_owned(), [180.0, 270.0], true),
            ("k*.AT2".to_owned(), [0.0, 90.0], false),
        ]
    );
    assert_eq!(suite.n_events, 3);
}

/// One pair is one motion along the axis, and one event. Positive values of the components 180 and 270 point south and west.
#[test]
fn reference_a_folder_along_an_axis() {
    let along = |axis: f64| {
        folder().declared(&FileUse {
            axis_deg: Some(axis),
            ..FileUse::default()
        })
    };
    let single = folder().suite();
    let values = |motions: &[pounding_assess::SuiteMotion], index: usize| motions[index].origin().file.values().to_vec();
    let [south, west] = [0, 1].map(|index| values(&single.motions, index));
    for (axis, factors) in [
        (180.0, [1.0, 0.0]),
        (270.0, [0.0, 1.0]),
        (0.0, [-1.0, 0.0]),
        (225.0, [0.5_f64.sqrt(); 2]),
    ] {
        let suite = along(axis);
        let names: Vec<_> = suite.motions.iter().map(|one| one.name.as_str()).collect();
        assert_eq!(names, ["RSN6_A*.AT2", "k*.AT2"]);
        assert_eq!((suite.n_events, suite.motions[1].event), (2, 1));
        for (step, found) in values(&suite.motions, 0).iter().enumerate() {
            let wanted = factors[0] * south[step] + factors[1] * west[step];
            assert!((found - wanted).abs() < 1e-15, "{axis}° {step}: {found} against {wanted}");
        }
    }
    let suite = along(30.0);
    let alone = suite
        .left_out
        .iter()
        .find(|one| one.reason.kind == LeftOutKind::Unpaired)
        .expect("one alone");
    assert_eq!(alone.name, "RSN7_B090.AT2");
    assert_eq!(suite.counts(), "6 files, 4 used and 2 left out: 2 motions of 2 events");
    let said = suite.remarks(false).join("\n");
    assert!(said.contains("the axis counts from the first component: k*.AT2"), "{said}");
    assert!(
        said.contains("1 horizontal component alone, an axis needs two of one recording: RSN7_B090.AT2"),
        "{said}"
    );
}

/// Three horizontals of one event, or components of different lengths of step, are no pair.
#[test]
fn extreme_events_that_are_no_pair() {
    let step = |rate: f64| at2("A, 90", rate).replace("DT= .02", "DT= .01");
    let suite = Folder::new()
        .with("RSN6_A000.AT2", at2("A, 0", 5.0))
        .with("RSN6_A090.AT2", step(5.7))
        .suite();
    assert_eq!((suite.n_events, suite.pairs().len()), (1, 0));
    let folder = Folder::new()
        .with("RSN6_A000.AT2", at2("A, 0", 5.0))
        .with("RSN6_A090.AT2", at2("A, 90", 5.7));
    assert_eq!(folder.with("RSN6_A045.AT2", at2("A, 45", 6.3)).suite().pairs().len(), 0);
    let suite = Folder::new()
        .with("RSN6_A000.AT2", at2("A, 0", 5.0))
        .with("RSN6_A045.AT2", at2("A, 45", 6.3))
        .suite();
    assert_eq!((suite.n_events, suite.pairs().len()), (1, 0), "not at right angles");
}

const TOWERS: &str = r#"
name = "towers"
record.generated.half_sine = { amplitude_m_per_s2 = 4.0, duration_s = 0.4, time_step_s = 0.01 }
structures = [
  { sdof = { name = "left", mass_kg = 1e5, period_s = 0.8, damping.ratio = 0.05 } },
  { sdof = { name = "right", mass_kg = 2e5, period_s = 0.4, damping.ratio = 0.05 } },
]
"#;

/// A second component of 0.75 times the first: in the maximum direction the spectrum is 1.25 times that of the first, so that both components get
/// 1/1.25 of its factor. The common factor is the geometric mean of the four factors.
#[test]
fn reference_factors_of_pairs_to_a_target() {
    let scene = Scene::parse(TOWERS.as_bytes(), "towers.toml".as_ref()).expect("a scene");
    let weaker: String = list(5.0)
        .lines()
        .map(|line| format!("{:e}\n", 0.75 * line.parse::<f64>().expect("a number")))
        .collect();
    let second = at2("A, 90", 1.0).replace(&list(1.0), &weaker);
    let mut suite = Folder::new()
        .with("RSN6_A000.AT2", at2("A, 0", 5.0))
        .with("RSN6_A090.AT2", second)
        .with("RSN7_B000.AT2", at2("B, 0", 7.7))
        .with("RSN7_B090.AT2", at2("B, 90", 8.3))
        .suite();
    assert_eq!(suite.pairs().len(), 2);
    let target = SpectrumTarget::from(DesignSpectrum::Table(vec![[0.0, 0.3], [3.0, 0.3]]));
    let factors = |target: &SpectrumTarget, suite: &pounding_assess::Suite| {
        let scaling = Scaling::Target(target.clone());
        let factor = |motion: &pounding_assess::SuiteMotion| scaling.applied(&scene, motion).expect("a factor").0.record.scale;
        suite.motions.iter().map(factor).collect::<Vec<f64>>()
    };
    let close = |one: f64, other: f64| assert!((one / other - 1.0).abs() < 1e-7, "{one} against {other}");
    let each = factors(&target, &suite);
    close(each[1], each[0] / 0.75);
    let maximum = SpectrumTarget {
        maximum_direction: true,
        ..target.clone()
    };
    let of_maximum = factors(&maximum, &suite);
    close(of_maximum[0], each[0] / 1.25);
    close(of_maximum[1], of_maximum[0]);
    close(of_maximum[3], of_maximum[2]);
    assert!(of_maximum[2] < each[2].min(each[3]), "{of_maximum:?} {each:?}");
    let common = Scaling::Target(SpectrumTarget {
        factors: TargetFactors::Common,
        ..target
    });
    let raised = common.raised(&scene, &mut suite, None);
    let found = match raised {
        Scaling::Target(target) | Scaling::Raised { target, .. } => target.factors,
        other => panic!("{other:?}"),
    };
    let mean = each.iter().product::<f64>().sqrt().sqrt();
    match found {
        TargetFactors::Known(factor) => close(factor, mean),
        other => panic!("{other:?}"),
    }
}

/// A lone component has no maximum direction.
#[test]
fn extreme_a_maximum_direction_needs_a_pair() {
    let scene = Scene::parse(TOWERS.as_bytes(), "towers.toml".as_ref()).expect("a scene");
    let suite = Folder::new().with("RSN6_A000.AT2", at2("A, 0", 5.0)).suite();
    let scaling = Scaling::Target(SpectrumTarget {
        maximum_direction: true,
        ..DesignSpectrum::Table(vec![[0.0, 0.3]]).into()
    });
    let refused = scaling
        .applied(&scene, &suite.motions[0])
        .expect_err("a lone component")
        .to_string();
    assert!(refused.contains("without a second horizontal component"), "{refused}");
}
