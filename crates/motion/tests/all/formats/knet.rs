//! K-NET and KiK-net.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format, components};

use super::{accelerogram, file, readings, refusal, with};

#[test]
fn reference_counts_are_scaled_and_their_mean_removed() {
    let text = file("knet.ns");
    let found = accelerogram(&text, &Declared::default());
    assert_eq!(found.format(), Format::KNet);
    assert_eq!(found.unit(), AccelerationUnit::CentimetrePerSecondSquared);
    assert_eq!(found.time_step().to_string(), "0.01");
    assert_eq!(components(text.as_bytes()).unwrap(), ["N-S"]);
    let counts: Vec<f64> = text
        .lines()
        .skip(17)
        .flat_map(str::split_whitespace)
        .map(|count| count.parse().unwrap())
        .collect();
    let mean = counts.iter().sum::<f64>() / 20.0;
    for (value, count) in found.values().iter().zip(&counts) {
        assert!((value - (count - mean) * 3920.0 / 6_182_761.0).abs() < 1e-12);
    }
    assert_eq!(found.values().len(), counts.len());
    assert_snapshot!(readings(&found), @r"
    format: K-NET
    component (line 13): N-S
    number of samples (line 12): 20
    time step (line 11): 0.01 s
    unit (line 14): cm/s² (Scale Factor      3920(gal)/6182761)
    peak in the header (line 15): Max. Acc. (gal)   30.740
    scale factor (line 14): 3920(gal)/6182761
    mean removed: 4.729955 gal, the mean of the record, taken off
    ");
}

#[test]
fn extreme_header_and_values() {
    let refused = |from: &str, to: &str| refusal(with("knet.ns", from, to), &Declared::default());
    assert_snapshot!(refused("Duration Time(s)  0.2", "Duration Time(s)  0.3"), @"the values end at line 20 after 20 of them, but the header declares 30; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refused("100Hz", "0Hz"), @"line 11: the time step is inf s, and must be finite and above 0 s; correct it there");
    assert_snapshot!(refused("3920(gal)/6182761", "3920(gal)/0"), @r#"line 14 reads "Scale Factor      3920(gal)/0", but a scale factor such as 3920(gal)/6182761 should stand there; fetch the file again"#);
    assert_snapshot!(refused("3920(gal)/6182761", "7840(gal)/6182761"), @r#"line 15 states a peak of "Max. Acc. (gal)   30.740", but the largest value read is 61.47943 cm/s²; one of them is damaged or in another unit: fetch the file again"#);
    assert_snapshot!(refused("Memo.", "Note."), @r#"no line of the header begins with "Memo"; fetch the file again"#);
    assert_snapshot!(refused("    22052", "    22o52"), @r#"line 18, field 1: "22o52" is not a number; write it like -0.00640 or -.6403182E-02"#);
    let declared = Declared {
        per_count: Some(2.0),
        ..Declared::default()
    };
    assert_snapshot!(refusal(file("knet.ns"), &declared), @"line 14 says that the values are in cm_per_s2, but `per_count` is declared as 2; leave it away, there are no counts to scale");
}

#[test]
fn reference_directions_of_kik_net_are_numbers() {
    for (stated, name) in [("1", "1: N-S"), ("5", "5: E-W"), ("3", "3: UP"), ("6", "6: UP"), ("U-D", "U-D")] {
        let text = with("knet.ns", "N-S", stated);
        assert_eq!(components(text.as_bytes()).unwrap(), [name]);
    }
}
