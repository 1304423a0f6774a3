//! CSMIP volumes 1 to 3, USC volume 2, RENADIC volume 1.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format, components};

use super::{accelerogram, component, file, readings, refusal, with};

const NOTHING: Declared = Declared {
    unit: None,
    time_step: None,
    component: None,
    per_count: None,
    acceleration: false,
    in_rows: false,
};

#[test]
fn reference_volume_2_has_several_channels_and_takes_the_first_block() {
    let bytes = file("csmip.v2");
    assert_eq!(components(bytes.as_bytes()).unwrap(), ["Chan 1: 90 Deg", "Chan 2: Up"]);
    let found = accelerogram(&bytes, &component("chan 1: 90 deg"));
    assert_eq!(found.format(), Format::CsmipV2);
    assert_eq!(found.unit(), AccelerationUnit::CentimetrePerSecondSquared);
    assert_eq!(found.time_step().to_string(), "0.005");
    assert_eq!(found.values().len(), 20);
    assert_eq!(found.values()[..3], [-77.314_366, -88.728_8, -35.945_465]);
    assert_eq!(found.values()[19..=19], [16.211_459]);
    assert_snapshot!(readings(&found), @r"
    format: CSMIP V2
    component (line 8): Chan 1: 90 Deg
    number of samples (line 46): 20
    time step (line 46): 0.005 s
    unit (line 46): cm/s² (cm/sec2)
    peak in the header (line 18): Peak acceleration =  -88.728800   cm/sec/sec  at    .010   s…
    columns (line 46): 8 to a line, 10 bytes each
    ");
    assert_eq!(accelerogram(&bytes, &component("2")).values().len(), 19);
    assert_snapshot!(refusal(&bytes, &NOTHING), @r#"the file holds 2 components: 1 = "Chan 1: 90 Deg", 2 = "Chan 2: Up"; choose one by its name or its number as `component`"#);
    assert_snapshot!(refusal(&bytes, &component("3")), @r#""3" is declared as `component`, but the file holds 1 = "Chan 1: 90 Deg", 2 = "Chan 2: Up"; choose one of them by its name, a part of it, or its number"#);
}

#[test]
fn reference_volume_2_of_usc() {
    let found = accelerogram(file("usc.s0a"), &NOTHING);
    assert_eq!(found.format(), Format::UscV2);
    assert_eq!(found.values()[..3], [-5.945, -11.28, -7.88]);
    assert_snapshot!(readings(&found), @r"
    format: USC V2
    component (line 8): COMP N08W
    number of samples (line 46): 20
    time step (line 46): 0.005 s
    unit (line 46): cm/s² (CM/SEC/SEC)
    peak in the header (line 18): PEAK ACCELERATION =  -11.280   CM/SEC/SEC  AT    .010   SEC.
    columns (line 46): 8 to a line, 10 bytes each, as usual: the line does not say
    ");
}

#[test]
fn reference_volume_1_of_values_alone() {
    let found = accelerogram(file("csmip-new.v1"), &NOTHING);
    assert_eq!(found.format(), Format::CsmipV1);
    assert_eq!(found.unit(), AccelerationUnit::StandardGravity);
    assert_eq!(found.time_step().to_string(), "0.005");
    assert_eq!(found.values()[..3], [-0.325_072, -0.946_419, -0.809_136]);
    assert_eq!(found.values().len(), 20);
    assert_snapshot!(readings(&found), @r"
    format: CSMIP V1
    component (line 7): Chan 3: 0 Deg
    number of samples (line 28): 20
    time step (line 28): 0.005 s
    unit (line 28): g (g)
    peak in the header (line 13): Uncor Max = -.946419 g, at .010 sec.   RMS accel = .010 g.
    ");
}

#[test]
fn reference_volume_1_of_pairs() {
    let found = accelerogram(file("csmip-old.v1"), &NOTHING);
    assert_eq!(found.unit(), AccelerationUnit::TenthG);
    assert_eq!(found.time_step().to_string(), "0.01");
    assert_eq!(found.values()[..3], [-2.807, -8.174, -6.988]);
    assert_eq!(found.values().len(), 12);
    assert_snapshot!(readings(&found), @r"
    format: CSMIP V1
    component (line 7): Chan 1: N08W
    number of samples (line 11): 12
    time step (line 28): 0.01 s
    unit (line 12): g/10 (g/10)
    peak in the header (line 13): Uncor Max = -0.8174 g, at .010 sec.   RMS accel = .010 g.
    columns (line 28): pairs of time and value
    ");
    let renadic = accelerogram(file("renadic.v1"), &NOTHING);
    assert_eq!(renadic.format(), Format::RenadicV1);
    assert_eq!(renadic.values(), found.values());
}

#[test]
fn issue_pairs_without_a_title_of_their_unit() {
    // Such files were refused as ending too early.
    let text = with("csmip-old.v1", "Units are sec and g/10", "");
    assert_snapshot!(refusal(&text, &NOTHING), @"the file does not say in which unit its values are; declare it as `unit`, one of g, m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10");
    let declared = Declared {
        unit: Some(AccelerationUnit::TenthG),
        ..NOTHING
    };
    let found = accelerogram(&text, &declared);
    assert_eq!(found.values()[..3], [-2.807, -8.174, -6.988]);
    // The peak of the header still reveals a wrong unit.
    let wrong = Declared {
        unit: Some(AccelerationUnit::StandardGravity),
        ..NOTHING
    };
    assert_snapshot!(refusal(&text, &wrong), @r#"line 13 states a peak of "Uncor Max = -0.8174 g, at .010 sec.   RMS accel = .010 g.", but the largest value read is 8.174 g; one of them is damaged or in another unit: fetch the file again"#);
}

#[test]
fn extreme_volume_1() {
    let refused = |from, to| refusal(with("csmip-old.v1", from, to), &NOTHING);
    assert_snapshot!(refused("points =     12", "points =     13"), @r#"the values end at line 30 after 12 of them (line 31 reads "/&  ----------  End of data for channel  1  ----------"), but the header declares 13; fetch the file again, or correct the header if the values are complete"#);
    assert_snapshot!(refused("   .110  2.758", "   .110"), @r#"line 30 reads ".100  -.531   .110", but a value behind each time should stand there; fetch the file again"#);
    assert_snapshot!(refused("   .100  -.531", "   .105  -.531"), @"the times rise in uneven steps, from 0.005 to 0.015 s: at line 30 by 0.005 s, where 0.01 s are the median; declare the step to which they are to be resampled, linear between them, as `time_step`, or print them with more decimals");
    assert_snapshot!(refused("sec and g/10", "sec and volts"), @r#"line 12 reads "Units are sec and volts" and names no unit of an acceleration that is known, such as g, g/10, mg, gal, cm/s/s, mm/s/s or m/s/s; if one of them is meant, write it there"#);
    assert_snapshot!(refused("Max = -0.8174", "Max = -8.174"), @r#"line 13 states a peak of "Uncor Max = -8.174 g, at .010 sec.   RMS accel = .010 g.", but the largest value read is 8.174 g/10; one of them is damaged or in another unit: fetch the file again"#);
    let refused = |from, to| refusal(with("csmip-new.v1", from, to), &NOTHING);
    assert_snapshot!(refused("   20 Accelerogram", "   19 Accelerogram"), @"the values end at line 31 after 20 of them, but the header declares 19; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refused("units of g.", "units of mm."), @r#"line 28 reads "20 Accelerogram points at 200 pts/sec in units of mm. Format…" and names no unit of an acceleration that is known, such as g, g/10, mg, gal, cm/s/s, mm/s/s or m/s/s; if one of them is meant, write it there"#);
    assert_snapshot!(refused("at 200 pts", "at 0 pts"), @"line 28: the time step is inf s, and must be finite and above 0 s; correct it there");
    let text = file("csmip-new.v1");
    let header: Vec<&str> = text.lines().take(20).collect();
    assert_snapshot!(refusal(header.join("\n"), &NOTHING), @"the file ends at line 20, before the values; fetch it again");
}

#[test]
fn extreme_volume_2() {
    let refused = |from, to| refusal(with("csmip.v2", from, to), &component("1"));
    assert_snapshot!(refused("   20 points of accel data", "   21 points of accel data"), @r#"the values end at line 49 after 20 of them (line 50 reads "20 points of veloc data equally spaced at .005 sec, in cm/se…"), but the header declares 21; fetch the file again, or correct the header if the values are complete"#);
    assert_snapshot!(refused("in cm/sec2. (8f10.6)", "in inches. (8f10.6)"), @r#"line 46 reads "20 points of accel data equally spaced at .005 sec, in inche…" and names no unit of an acceleration that is known, such as g, g/10, mg, gal, cm/s/s, mm/s/s or m/s/s; if one of them is meant, write it there"#);
    assert_snapshot!(refused("in cm/sec2. (8f10.6)", "in mg. (8f10.6)"), @r#"line 18 states a peak of "Peak acceleration =  -88.728800   cm/sec/sec  at    .010   s…", but the largest value read is 88.7288 mg; one of them is damaged or in another unit: fetch the file again"#);
    assert_snapshot!(refused("in cm/sec2. (8f10.6)", "in cm/sec2. (8f11.6)"), @r#"line 47, field 1: "-77.314366-" is not a number; write it like -0.00640 or -.6403182E-02"#);
    assert_snapshot!(refused("in cm/sec2. (8f10.6)", "in cm/sec2. (8f5.3)"), @r#"line 47, field 2: "14366" is not a number; write it like -0.00640 or -.6403182E-02"#);
    assert_snapshot!(refused("spaced at .005 sec", "spaced at .000 sec"), @"line 46: the time step is 0 s, and must be finite and above 0 s; correct it there");
    assert_snapshot!(refused("   20 points of accel data", "   20 points of some data"), @"the file ends at line 58, before a line such as `3251 POINTS OF ACCEL DATA`; fetch it again");
    assert_snapshot!(refused("Peak acceleration =  -88.728800", "Peak acceleration =  -8.8728800"), @r#"line 18 states a peak of "Peak acceleration =  -8.8728800   cm/sec/sec  at    .010   s…", but the largest value read is 88.7288 cm/s²; one of them is damaged or in another unit: fetch the file again"#);
}

#[test]
fn limit_volume_2_without_its_format_has_the_usual_one() {
    let text = with("csmip.v2", "in cm/sec2. (8f10.6)", "in cm/sec2.");
    let found = accelerogram(text, &component("1"));
    assert_eq!(found.values().len(), 20);
}

#[test]
fn extreme_spectra_of_volume_3() {
    let text = "Response and Fourier amplitude spectra (86 periods,  .04 - 10.0 sec)   for\n\
                Corrected accelerogram\nUncorrected Accelerogram Data\n";
    assert_snapshot!(refusal(text, &NOTHING), @r#"line 1 reads "Response and Fourier amplitude spectra (86 periods,  .04 - 1…", but only histories of acceleration are read; take the volume 2 file (.V2) of the record, these are spectra"#);
}
