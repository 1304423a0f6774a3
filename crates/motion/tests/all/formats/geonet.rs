//! `GeoNet` V1A and V2A.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format, components};

use super::{accelerogram, component, file, readings, refusal, with};

#[test]
fn reference_three_components_in_millimetres() {
    let bytes = file("geonet.v2a");
    assert_eq!(components(bytes.as_bytes()).unwrap(), ["S16W", "S74E", "Up"]);
    let found = accelerogram(&bytes, &component("s16w"));
    assert_eq!(found.format(), Format::GeoNet);
    assert_eq!(found.unit(), AccelerationUnit::MillimetrePerSecondSquared);
    assert_eq!(found.time_step().to_string(), "0.02");
    assert_eq!(found.values().len(), 25);
    assert_eq!(found.values()[..3], [-65447.6, -83518.1, -40077.6]);
    assert_eq!(found.values()[24..=24], [5317.6]);
    assert_snapshot!(readings(&found), @r"
    format: GeoNet
    component (line 13): S16W
    number of samples (line 20): 25
    time step (line 23): 0.02 s
    unit (line 14): mm/s² (mm/s/s)
    peak in the header (line 14): Acceleration:  peak -83518.1 mm/s/s at   0.04 sec     rms   …
    ");
    // Tenths of a millimetre, exact to the last digit.
    let record = found.into_record(9.81).unwrap();
    assert_eq!(record.samples()[0].to_string(), "-65.4476");
}

#[test]
fn reference_uncorrected() {
    let found = accelerogram(file("geonet.v1a"), &Declared::default());
    assert_eq!(found.values().len(), 23);
    assert_eq!(found.time_step().to_string(), "0.02");
}

#[test]
fn extreme_header_and_values() {
    let refused = |from: &str, to: &str| refusal(with("geonet.v2a", from, to), &component("1"));
    assert_snapshot!(refused("-83518.1 mm/s/s", "-83518.1 cm/s"), @r#"line 14 reads "Acceleration:  peak -83518.1 cm/s at   0.04 sec     rms     …" and names no unit of an acceleration that is known, such as g, g/10, mg, gal, cm/s/s, mm/s/s or m/s/s; if one of them is meant, write it there"#);
    assert_snapshot!(refused("-83518.1 mm/s/s", "-8351.8 mm/s/s"), @r#"line 14 states a peak of "Acceleration:  peak -8351.8 mm/s/s at   0.04 sec     rms    …", but the largest value read is 83518.1 mm/s²; one of them is damaged or in another unit: fetch the file again"#);
    assert_snapshot!(refused("      25      25      25", "      29      25      25"), @r#"line 23 reads "0.0000  0.0000  0.0000  0.0000  0.0050  0.0200  0.0000  0.00…", but a time step should stand there; fetch the file again"#);
    assert_snapshot!(refused("0.0050  0.0200", "0.0051  0.0210"), @r#"line 23 reads "0.0000  0.0000  0.0000  0.0000  0.0051  0.0210  0.0000  0.00…", but a time step should stand there; fetch the file again"#);
    assert_snapshot!(refused("-65447.6", "-654476."), @r#"line 14 states a peak of "Acceleration:  peak -83518.1 mm/s/s at   0.04 sec     rms   …", but the largest value read is 654476 mm/s²; one of them is damaged or in another unit: fetch the file again"#);
    assert_snapshot!(refusal("Corrected accelerogram GNS Science\nx\n", &Declared::default()), @"the file ends at line 2, before the numbers of its header; fetch it again");
}
