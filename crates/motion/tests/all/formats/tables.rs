//! Formats with one column per component: CWB, AFAD, UNAM, SCEC BBP.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format, components, read_declared};

use super::{accelerogram, component, readings, refusal};

const CWB: &str = "#Earthquake Information\n#StationCode: ZZZ\n#RecordLength(sec): 0.02\n\
                   #SampleRate(Hz): 100\n#AmplitudeUnit:  gal. DCoffset(corr)\n#Data: 4F10.3\n     \
                   0.000    -1.234 -1000.250  2000.500\n     0.010     1.000-12345.125-23456.250\n     \
                   0.020     0.500     0.250     0.125\n";

const BBP: &str = "# made by hand\n# Time (s), NS (cm/s), EW (cm/s), UD (cm/s)\n\
                   0.00 0.5 0.25 0.125\n0.02 -1.5 -1.25 -1.125\n";

fn afad() -> Vec<u8> {
    let mut text = b"STRONG GROUND MOTION RECORDS OF TURKIYE\nPLACE : D\xDCZCE\n".to_vec();
    text.extend(b"KEY : value\n".repeat(10));
    text.extend(b"NUMBER OF DATA : 2\nSAMPLING INTERVAL (sec) : 0.01\nRAW PGA VALUES (gal) : 9\n\n\nN-S E-W U-D\n");
    text.extend(b"  0.500  -0.250   0.125\n  1.500  -1.250   1.125\n");
    text
}

fn unam() -> Vec<u8> {
    let mut text = b"INSTITUTO DE INGENIERIA, UNAM\n\n\n\n\n\nARCHIVO ESTANDAR DE ACELERACION\n".to_vec();
    text.extend(b"ESTACI\xD3N : none\nORIENTACION C1-C6 (rumbo;orientacion) : /N00E;x/V/N90E\n");
    text.extend(b"INTERVALO DE MUESTREO, C1-C6 (s) : /.010/.010/.010\n");
    text.extend(b"NUM. TOTAL DE MUESTRAS, C1-C6 : /   2/   2/   2\n");
    text.extend(b"ACEL. MAX. (GALS), C1-C6 : /  1.50/  -1.25/ 1.13\n\n  C1  C2  C3\n");
    text.extend(b"  0.500  -0.250   0.125\n  1.500  -1.250   1.125\n");
    text
}

/// The refusal of a file with a replaced piece.
fn refused(bytes: &[u8], from: &str, to: &str) -> String {
    let at = bytes.windows(from.len()).position(|piece| piece == from.as_bytes());
    let at = at.unwrap_or_else(|| panic!("no {from:?}"));
    let changed = [&bytes[..at], to.as_bytes(), &bytes[at + from.len()..]].concat();
    refusal(changed, &component("1"))
}

#[test]
fn reference_cwb_in_fixed_columns() {
    assert_eq!(components(CWB.as_bytes()).unwrap(), ["U", "N", "E"]);
    let found = accelerogram(CWB, &component("N"));
    assert_eq!(found.format(), Format::Cwb);
    assert_eq!(found.unit(), AccelerationUnit::CentimetrePerSecondSquared);
    assert_eq!(found.time_step().to_string(), "0.01");
    assert_eq!(found.values(), [-1000.25, -12345.125, 0.25]);
    assert_snapshot!(readings(&found), @r"
    format: CWB
    component (line 6): N
    number of samples: 3
    time step (line 7): 0.01 s
    unit (line 5): cm/s² (gal)
    ");
    let refused = |from, to| refused(CWB.as_bytes(), from, to);
    assert_snapshot!(refused("(sec): 0.02", "(sec): 0.2"), @r##"line 3 reads "#RecordLength(sec): 0.2", but the duration of the values that follow should stand there; fetch the file again"##);
    assert_snapshot!(refused("(Hz): 100", "(Hz): 50"), @r##"line 3 reads "#RecordLength(sec): 0.02", but the duration of the values that follow should stand there; fetch the file again"##);
    assert_snapshot!(refused("(Hz): 100", "(Hz): many"), @r##"line 4 reads "#SampleRate(Hz): many", but a number above 0 should stand there; fetch the file again"##);
    assert_snapshot!(refused("#SampleRate", "#Sampling"), @r#"no line of the header begins with "SampleRate(Hz):"; fetch the file again"#);
    assert_snapshot!(refused("     0.250     0.125", ""), @"line 9 has 2 field(s), allowed are 4; fetch the file again");
    assert_snapshot!(refused("gal. DC", "counts. DC"), @r##"line 5 reads "#AmplitudeUnit:  counts. DCoffset(corr)" and names no unit of an acceleration that is known, such as g, g/10, mg, gal, cm/s/s, mm/s/s or m/s/s; if one of them is meant, write it there"##);
}

#[test]
fn reference_afad_in_another_code_page() {
    assert_eq!(components(&afad()).unwrap(), ["N-S", "E-W", "U-D"]);
    let found = accelerogram(afad(), &component("3"));
    assert_eq!(found.format(), Format::Afad);
    assert_eq!(found.values(), [0.125, 1.125]);
    assert_snapshot!(readings(&found), @r"
    format: AFAD
    component (line 18): U-D
    number of samples (line 13): 2
    time step (line 14): 0.01 s
    unit (line 1): cm/s² (as the format has it)
    ");
    assert_snapshot!(refused(&afad(), "DATA : 2", "DATA : 3"), @"the values end at line 20 after 2 of them, but the header declares 3; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refused(&afad(), "(sec) : 0.01", "(sec) : x"), @r#"line 14 reads "SAMPLING INTERVAL (sec) : x", but a time step should stand there; fetch the file again"#);
    assert_snapshot!(refused(&afad(), "  0.500  -0.250", "  0.500-0.250"), @"line 19 has 2 field(s), allowed are 3; fetch the file again");
    assert_snapshot!(refusal(&afad()[..60], &component("1")), @"the file ends at line 3, before the values; fetch it again");
}

#[test]
fn reference_unam_in_latin_1() {
    assert_eq!(components(&unam()).unwrap(), ["N00E;x", "V", "N90E"]);
    let found = accelerogram(unam(), &component("V"));
    assert_eq!(found.format(), Format::Unam);
    assert_eq!(found.values(), [-0.25, -1.25]);
    assert_snapshot!(readings(&found), @r"
    format: UNAM
    component (line 9): V
    number of samples (line 11): 2
    time step (line 10): 0.01 s
    unit (line 12): cm/s² (ACEL. MAX. (GALS), C1-C6 : /  1.50/  -1.25/ 1.13)
    peak in the header (line 12): ACEL. MAX. (GALS), C1-C6 : /  1.50/  -1.25/ 1.13
    ");
    assert_snapshot!(refused(&unam(), "MUESTRAS, C1-C6 : /   2", "MUESTRAS, C1-C6 : /   3"), @"the values end at line 16 after 2 of them, but the header declares 3; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refused(&unam(), "/  1.50", "/  15.0"), @r#"line 12 states a peak of "ACEL. MAX. (GALS), C1-C6 : /  15.0/  -1.25/ 1.13", but the largest value read is 1.5 cm/s²; one of them is damaged or in another unit: fetch the file again"#);
    assert_snapshot!(refused(&unam(), "INTERVALO", "INTERVAL"), @r#"no line of the header begins with "INTERVALO DE MUESTREO"; fetch the file again"#);
    assert_snapshot!(refused(&unam(), "  0.500  -0.250", "  0.500-0.250"), @"the values end at line 16 after 1 of them, but the header declares 2; fetch the file again, or correct the header if the values are complete");
}

#[test]
fn reference_broadband_platform_leaves_cm_per_s_to_the_caller() {
    assert_eq!(components(BBP.as_bytes()).unwrap(), ["NS", "EW", "UD"]);
    let declared = Declared {
        unit: Some(AccelerationUnit::CentimetrePerSecondSquared),
        acceleration: true,
        ..component("EW")
    };
    let found = accelerogram(BBP, &declared);
    assert_eq!(found.format(), Format::Bbp);
    assert_eq!(found.values(), [0.25, -1.25]);
    assert_eq!(found.time_step().to_string(), "0.02");
    assert_snapshot!(readings(&found), @r"
    format: SCEC BBP
    component (line 2): EW
    number of samples: 2
    time step (line 3): 0.02 s
    unit: cm/s² (declared)
    ");
    let stated = accelerogram(BBP.replace("cm/s)", "cm/s/s)"), &component("EW"));
    assert_eq!(stated.values(), found.values());
    assert_snapshot!(refusal(BBP, &component("EW")), @r##"line 2 reads "# Time (s), NS (cm/s), EW (cm/s), UD (cm/s)", which speaks for velocities, and only histories of acceleration are read; take the record of accelerations, such as channel HNE of an accelerometer, or declare `acceleration` if the values were turned into accelerations"##);
    assert_snapshot!(refusal(BBP.replace("cm/s)", "cm)"), &declared), @r##"line 2 reads "# Time (s), NS (cm), EW (cm), UD (cm)", but only histories of acceleration are read; take the .acc.bbp file of the record"##);
    assert_snapshot!(refusal(BBP.replace("0.00 0.5", "0.00"), &declared), @"line 3 has 3 field(s), allowed are 4; fetch the file again");
}

/// Commas between the columns were refused.
#[test]
fn issue_broadband_platform_with_commas() {
    let declared = Declared {
        acceleration: true,
        ..component("EW")
    };
    let stated = BBP.replace("cm/s)", "cm/s/s)");
    let (header, rows) = stated.split_at(stated.find("0.00").expect("rows"));
    let commas = header.to_owned() + &rows.replace(' ', ",");
    assert_eq!(accelerogram(commas, &declared).values(), accelerogram(&stated, &declared).values());
}

#[test]
fn extreme_every_cut() {
    for text in [CWB.as_bytes(), &afad(), &unam(), BBP.as_bytes()] {
        let declared = Declared {
            unit: Some(AccelerationUnit::CentimetrePerSecondSquared),
            acceleration: true,
            ..component("2")
        };
        let whole = accelerogram(text, &declared);
        for length in 0..text.len() {
            if let Ok(found) = read_declared(&text[..length], &declared) {
                // BBP has no number of values; CWB allows for one more or less.
                assert!(whole.values().len() - found.values().len() <= 1, "cut at {length}");
            }
        }
    }
}
