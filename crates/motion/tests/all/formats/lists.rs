//! Formats with one value per line: ESM, eqsig.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format};

use super::{accelerogram, file, readings, refusal, with};

#[test]
fn reference_esm() {
    let found = accelerogram(file("esm.asc"), &Declared::default());
    assert_eq!(found.format(), Format::Esm);
    assert_eq!(found.unit(), AccelerationUnit::CentimetrePerSecondSquared);
    assert_eq!(found.time_step().to_string(), "0.005");
    assert_eq!(found.values().len(), 20);
    assert_eq!(found.values()[..2], [-3.634_899, -10.582_68]);
    assert_snapshot!(readings(&found), @r"
    format: ESM ASC
    component (line 9): HNE
    number of samples (line 7): 20
    time step (line 6): 0.005 s
    unit (line 10): cm/s² (cm/s^2)
    peak in the header (line 11): PGA_CM/S^2: -10.582680
    ");
}

#[test]
fn extreme_esm() {
    let refused = |from: &str, to: &str| refusal(with("esm.asc", from, to), &Declared::default());
    assert_snapshot!(refused("NDATA: 20", "NDATA: 21"), @"the values end at line 35 after 20 of them, but the header declares 21; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refused("NDATA: 20", "NDATA: "), @r#"line 7 reads "NDATA:", but a whole number of samples above 0 should stand there; fetch the file again"#);
    assert_snapshot!(refused("NDATA: 20", "N: 20"), @r#"no line of the header begins with "NDATA:"; fetch the file again"#);
    assert_snapshot!(refused("UNITS: cm/s^2", "UNITS: cm/s"), @r#"line 10 reads "UNITS: cm/s" and names no unit of an acceleration that is known, such as g, g/10, mg, gal, cm/s/s, mm/s/s or m/s/s; if one of them is meant, write it there"#);
    assert_snapshot!(refused("DATA_TYPE: ACCELERATION", "DATA_TYPE: VELOCITY"), @r#"line 13 reads "DATA_TYPE: VELOCITY", but only histories of acceleration are read; take the .ACC.ASC file of the record"#);
    assert_snapshot!(refused("SAMPLING_INTERVAL_S: 0.005000", "SAMPLING_INTERVAL_S: -0.005"), @"line 6: the time step is -0.005 s, and must be finite and above 0 s; correct it there");
    assert_snapshot!(refused("PGA_CM/S^2: -10.58", "PGA_CM/S^2: -1058"), @r#"line 11 states a peak of "PGA_CM/S^2: -10582680", but the largest value read is 10.58268 cm/s²; one of them is damaged or in another unit: fetch the file again"#);
    assert_snapshot!(refused("-3.634899", "-3.634899 1.0"), @r#"line 16, field 1: "-3.634899 1.0" is not a number; write it like -0.00640 or -.6403182E-02"#);
}

#[test]
fn reference_eqsig() {
    let declared = Declared {
        unit: Some(AccelerationUnit::MetrePerSecondSquared),
        ..Declared::default()
    };
    let text = "Somewhere\n3 0.0100\n0.5\n-0.25\n0.125\n";
    let found = accelerogram(text, &declared);
    assert_eq!(found.format(), Format::Eqsig);
    assert_eq!(found.values(), [0.5, -0.25, 0.125]);
    assert_eq!(found.provenance(), "Somewhere");
    assert_snapshot!(readings(&found), @r"
    format: eqsig
    number of samples (line 2): 3
    time step (line 2): 0.01 s
    unit: m/s² (declared)
    ");
    assert_snapshot!(refusal(text, &Declared::default()), @"the file does not say in which unit its values are; declare it as `unit`, one of g, m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10");
    assert_snapshot!(refusal(text.replace("3 0", "4 0"), &declared), @"the values end at line 5 after 3 of them, but the header declares 4; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refusal(text.replace("-0.25", "-0.25 7"), &declared), @r#"line 4, field 1: "-0.25 7" is not a number; write it like -0.00640 or -.6403182E-02"#);
}
