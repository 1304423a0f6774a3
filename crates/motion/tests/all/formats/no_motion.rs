//! Numbers that are not histories of accelerations: spectra, sums, numbers of a header; and similar numbers that are.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Accelerogram, Declared, Unusual, components};

use super::{accelerogram, readings, refusal, rows_of};

const IN_G: Declared = Declared {
    unit: Some(AccelerationUnit::StandardGravity),
    time_step: None,
    component: None,
    per_count: None,
    acceleration: false,
    in_rows: false,
};

const LIST: Declared = Declared {
    time_step: Some(0.01),
    ..IN_G
};

const TURNED: Declared = Declared {
    acceleration: true,
    ..LIST
};

/// A table below a header, with values that rise and fall above zero.
fn spectrum(header: &str, separator: &str) -> String {
    let rows = (0..40).map(|step| {
        let (period, value) = (f64::from(step) * 0.02, 0.2 + 0.01 * f64::from(step.min(40 - step)));
        format!("{period:.2}{separator}{value:.4}\n")
    });
    format!("{header}\n{}", rows.collect::<String>())
}

fn unusual(found: &Accelerogram) -> String {
    let said: Vec<String> = found.unusual().iter().map(Unusual::to_string).collect();
    said.join("\n")
}

/// Spectra shook the row: a gap of 107 mm became one of 266 mm.
#[test]
fn issue_spectra_are_no_motion() {
    assert_snapshot!(refusal(spectrum("Period (s),Sa (g)", ","), &IN_G), @r#"line 1 reads "Period (s),Sa (g)", but only histories of acceleration are read; take the record itself, this is a response spectrum"#);
    for header in [
        "T (s),SA (g)",
        "T[s] Sa[g]",
        "Period,pSa",
        "Frequency (Hz),Acceleration (g)",
        "period_s,sa_g",
        "f (Hz),PSA (g)",
        "Periods (s),SaRotD50 (g)",
        "T,Se",
        "T (s)\tSpectral acceleration (g)",
    ] {
        let text = spectrum(header, if header.contains(',') { "," } else { "\t" });
        for declared in [&IN_G, &LIST, &TURNED] {
            let said = refusal(&text, declared);
            assert!(said.contains("this is a response spectrum"), "{header}: {said}");
        }
        assert!(components(text.as_bytes()).is_err(), "{header}");
    }
    let of_fourier = "Frequency (Hz),Fourier amplitude (cm/s),Acceleration (g)\n0,0.4,0.3\n0.05,0.5,0.3\n0.1,0.5,0.3\n";
    assert!(refusal(of_fourier, &IN_G).contains("this is a Fourier spectrum"));
    let of_program = "Period [sec]\tAcceleration [g]\tVelocity [cm/sec]\tDisplacement [cm]\n0.00\t0.25\t1.0\t0.1\n0.02\t0.3\t1.0\t0.1\n0.04\t0.3\t1.0\t0.1\n";
    assert!(refusal(of_program, &IN_G).contains("this is a response spectrum"));
    // A time in capitals and the axis of a direction are not spectra.
    let titled: String = "Station SA\n".to_owned() + &rows_of(20, |step, value| format!("{:.2} {value:.4}\n", 0.01 * step));
    assert_eq!(accelerogram(titled, &IN_G).values().len(), 20);
    for header in ["T (s),acc (g)", "time,SE (g)", "t,a"] {
        let rows: String = rows_of(20, |step, value| format!("{:.2},{value:.4}\n", 0.01 * step));
        accelerogram(
            format!("{header}\n{rows}"),
            &Declared {
                unit: IN_G.unit.filter(|_| header == "t,a"),
                ..IN_G
            },
        );
    }
}

/// Spectra without headings, times and sums counted as motions.
#[test]
fn issue_values_of_one_sign_are_asked_about() {
    let bare = spectrum("a spectrum of the code", " ");
    assert_snapshot!(refusal(&bare, &IN_G), @"the 40 values that end at line 41 never change sign, like a spectrum and unlike shaking, and the file does not call them accelerations; take the record itself, or declare `acceleration` if they are accelerations");
    let rising = rows_of(20, |step, _| format!("{}\n", step * 0.01 - 0.05));
    assert_snapshot!(refusal(&rising, &LIST), @"the 20 values that end at line 20 only rise, like a spectrum and unlike shaking, and the file does not call them accelerations; take the record itself, or declare `acceleration` if they are accelerations");
    let declared = Declared { time_step: None, ..TURNED };
    assert_snapshot!(unusual(&accelerogram(&bare, &declared)), @"found 40 values in the file that never change sign, usual is shaking both ways; a spectrum, a column of times or an offset has one sign");
    // If the file calls them accelerations, they may be a pulse.
    let pulse = spectrum("time_s,acceleration_g", ",");
    assert_snapshot!(unusual(&accelerogram(&pulse, &Declared::default())), @"found 40 values in the file that never change sign, usual is shaking both ways; a spectrum, a column of times or an offset has one sign");
    // The unit of a spectrum made its values accelerations.
    for names in [
        "T (s),S_a (g)",
        "T (s),Sae (g)",
        "T (s),RotD50 (g)",
        "natural period (s),acceleration (g)",
        "Sa (g),T (s)",
        "周期(s),加速度(gal)",
    ] {
        let said = refusal(spectrum(names, ","), &Declared::default());
        assert!(said.contains("spectrum") || said.contains("time"), "{names}: {said}");
    }
    let named = spectrum("time (s),acc (g)", ",");
    assert!(matches!(
        accelerogram(&named, &Declared::default()).unusual(),
        [Unusual::OneSigned { .. }]
    ));
    let zeros = "0.0\n".repeat(20);
    assert_snapshot!(unusual(&accelerogram(zeros, &LIST)), @"found 20 values in the file that are all zero, usual is shaking");
    let sums = "time,NS (g),EW (g),SUM (g)\n0,0.1,0.2,0.22\n0.01,-0.1,-0.2,0.22\n0.02,0.1,0.2,0.22\n";
    assert_eq!(components(sums.as_bytes()).unwrap(), ["NS", "EW"]);
}

/// A scale and a step above the values became the first two values: the peak was 1.000 g at 0 s.
#[test]
fn issue_numbers_of_a_header_are_no_samples() {
    let values: String = rows_of(40, |_, value| format!("{:.6}\n", 0.3 * value));
    let scaled = accelerogram(format!("1\n0.01\n{values}"), &IN_G);
    assert_eq!(scaled.values().len(), 40);
    assert_snapshot!(readings(&scaled), @"
    format: plain text
    number of samples: 40
    time step (line 2): 0.01 s
    unit: g (declared)
    columns (line 3): 1
    ");
    let counted = accelerogram(format!("40\n0.005\n{values}"), &IN_G);
    assert_eq!((counted.values().len(), counted.time_step()), (40, 0.005));
    let turned = accelerogram(format!("0.005\n40\n{values}"), &IN_G);
    assert_eq!(
        turned,
        accelerogram(
            format!("0.005\n40\n{values}"),
            &Declared {
                time_step: Some(0.005),
                ..IN_G
            }
        )
    );
    assert_snapshot!(refusal(format!("9.80665e+02\n0.01\n{values}"), &LIST), @"lines 1 to 2 read \"9.80665e+02, 0.01\": perhaps a scale and a time step, unlike the values below; delete them, or put # before each line");
    // Numbers in the style of the values may be values.
    let coarse: String = rows_of(40, |_, value| format!("{value:.2}\n"));
    assert_snapshot!(refusal(format!("1.00\n0.01\n{coarse}"), &LIST), @"lines 1 to 2 read \"1.00, 0.01\": perhaps a scale and a time step, unlike the values below; delete them, or put # before each line");
    assert_snapshot!(unusual(&accelerogram(format!("4.5\n0.01\n{values}"), &LIST)), @"
    found a peak of 4.5 g in the file, usual is 0.02 to 3 g; its unit decides it
    found a first value of 4.500 in the file, where no other is above 0.2686, usual is a motion that begins near zero; the first may be a number of the header
    found value 2 of the file, 0.01, equal to its time step, usual is a step that stands above the values, not among them
    ");
    let pairs: String = rows_of(40, |step, value| format!("{:.2} {value:.4}\n", 0.01 * step));
    assert_snapshot!(refusal(format!("4000 2\n35.10 120.30\n{pairs}"), &IN_G), @r#"lines 1 to 2 read "4000 2; 35.10 120.30": no pairs of time and value, unlike the values below; delete them, or put # before each line"#);
}

/// Resampling of uneven pairs silently removed up to 1.8 % of the peak.
#[test]
fn issue_what_resampling_takes_off_the_peak_is_told() {
    let uneven = "time_s,acceleration_g\n0,0.1\n0.01,-0.2\n0.025,0.5\n0.03,-0.1\n0.045,0.1\n";
    let found = accelerogram(
        uneven,
        &Declared {
            time_step: Some(0.01),
            ..Declared::default()
        },
    );
    assert_snapshot!(readings(&found), @"
    format: CSV
    number of samples: 5
    time step (line 2): 0.01 s (declared; 5 uneven pairs resampled to 5, linear between)
    resampled peak: 46.67 % lower than before, 0.5000 became 0.2667
    unit (line 1): g (time_s,acceleration_g)
    ");
    assert_snapshot!(unusual(&found), @"found a peak that is 46.7 % lower after resampling, usual is up to 0.1 %; a shorter step keeps more");
    let kept = accelerogram(
        uneven,
        &Declared {
            time_step: Some(0.005),
            ..Declared::default()
        },
    );
    assert_eq!(unusual(&kept), "");
}

/// Weak peaks, such as those of a wrong unit, had no warning.
#[test]
fn issue_peaks_that_no_strong_motion_has() {
    let peak = |peak: f64| {
        let text = format!("time_s,acceleration_g\n0,0\n0.01,{peak}\n0.02,{}\n", -peak);
        unusual(&accelerogram(text, &Declared::default()))
    };
    assert_snapshot!(peak(0.013), @"found a peak of 0.013 g in the file, usual is 0.02 to 3 g; its unit decides it");
    assert_eq!(peak(0.02), "");
    assert_eq!(peak(3.0), "");
    assert_snapshot!(peak(3.1), @"found a peak of 3.1 g in the file, usual is 0.02 to 3 g; its unit decides it");
}
