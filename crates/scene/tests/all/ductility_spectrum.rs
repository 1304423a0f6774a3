//! Spectra of constant ductility against closed forms and printed values.

use pounding_motion::Record;
use pounding_scene::{DuctilityValues, ductility_spectra, response_spectrum};

use crate::spectrum::el_centro;

fn at(record: &Record, period: f64, [damping, ductility]: [f64; 2]) -> DuctilityValues {
    ductility_spectra(record, &[period], [&[damping], &[ductility]], None, &|| ()).expect("spectra")[0].values[0]
}

/// A ground that accelerates by a without end does the work m a u, which the columns take as fy (u − uy/2) before the structure turns:
/// fy/(m a) = 1/(1 − 1/(2µ)). The last samples fall to zero slowly.
#[test]
fn reference_a_lasting_step() {
    let a = 1.7;
    let mut samples = vec![a; 4000];
    samples.extend((0..4000).map(|index| a * (1.0 - f64::from(index) / 4000.0)));
    let step = Record::new(0.01, samples, "").expect("a record");
    for period in [0.2, 1.0] {
        for ductility in [1.5, 2.0, 4.0, 10.0] {
            let found = at(&step, period, [0.0, ductility]);
            let wanted = a / (1.0 - 0.5 / ductility);
            assert!(
                (found.yield_acceleration / wanted - 1.0).abs() < 2e-9,
                "{period}, {ductility}: {found:?}"
            );
            let frequency = std::f64::consts::TAU / period;
            let displacement = ductility * wanted / (frequency * frequency);
            assert!((found.displacement / displacement - 1.0).abs() < 2e-9, "{found:?}");
            assert!(
                (found.strength_reduction * found.yield_acceleration / (2.0 * a) - 1.0).abs() < 1e-9,
                "{found:?}"
            );
        }
    }
}

/// A short push leaves an undamped structure with a velocity v, and its peak comes long after: R = √(2µ − 1).
#[test]
fn reference_a_short_push() {
    let sample = |index: i32| libm::sin(std::f64::consts::PI * f64::from(index) / 20.0);
    let push = Record::new(0.005, (0..=20).map(sample).collect(), "").expect("a record");
    for ductility in [2.0, 20.0, 50.0, 100.0] {
        let found = at(&push, 10.0, [0.0, ductility]);
        let wanted = libm::sqrt(2.0 * ductility - 1.0);
        assert!(
            (found.strength_reduction / wanted - 1.0).abs() < 2e-3,
            "{ductility}: {found:?} {wanted}"
        );
    }
}

/// A period of 0.5 s under El Centro (A. K. Chopra, *Dynamics of Structures*, 7.4): with a quarter and an eighth of the elastic strength the
/// ductility is 3.11 and 7.36, the displacement 1.75 and 2.07 inches.
#[test]
fn reference_printed_ductilities() {
    let record = el_centro();
    for (ductility, reduction, inches) in [(3.11, 4.0, 1.75), (7.36, 8.0, 2.07)] {
        let found = at(&record, 0.5, [0.05, ductility]);
        assert!((found.strength_reduction / reduction - 1.0).abs() < 2e-3, "{found:?}");
        assert!((found.displacement / (0.0254 * inches) - 1.0).abs() < 4e-3, "{found:?}");
    }
}

/// A ductility of 1 is the elastic structure; strength falls and the reduction grows with the ductility.
#[test]
fn limit_ductilities() {
    let record = el_centro();
    let elastic = response_spectrum(&record, &[0.5], 0.05).expect("a spectrum")[0];
    let one = at(&record, 0.5, [0.05, 1.0]);
    assert!(
        (one.yield_acceleration / elastic.pseudo_acceleration - 1.0).abs() < 1e-15,
        "{one:?}"
    );
    assert!((one.strength_reduction - 1.0).abs() < 1e-15, "{one:?}");
    let found = [1.0, 1.5, 3.0, 7.0].map(|ductility| at(&record, 0.5, [0.05, ductility]));
    assert!(
        found.windows(2).all(|two| two[1].yield_acceleration < two[0].yield_acceleration),
        "{found:?}"
    );
}

#[test]
fn extreme_spectra_that_do_not_exist() {
    let record = Record::new(0.01, vec![0.0, 1.0, 0.0], "").expect("a record");
    let still = Record::new(0.01, vec![0.0; 3], "").expect("a record");
    let refused = |record: &Record, period: f64, ductility: f64| {
        let refused = ductility_spectra(record, &[period], [&[0.05], &[ductility]], None, &|| ()).expect_err("it is refused");
        refused.to_string()
    };
    assert!(refused(&record, 0.0, 2.0).contains("above 0 s"));
    assert!(refused(&record, 1.0, 0.5).contains("1 to 100"));
    assert!(
        refused(&still, 1.0, 2.0).contains("without any acceleration"),
        "{}",
        refused(&still, 1.0, 2.0)
    );
}
