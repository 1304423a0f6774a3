//! Layouts of real files that were refused, or read wrongly, in small files made by hand.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Accelerogram, Declared, Direction, Format, Unusual, components};

use super::{accelerogram, component, file, readings, refusal, with};

const NOTHING: Declared = Declared {
    unit: None,
    time_step: None,
    component: None,
    per_count: None,
    acceleration: false,
    in_rows: false,
};

const IN_GAL: Declared = Declared {
    unit: Some(AccelerationUnit::CentimetrePerSecondSquared),
    ..NOTHING
};

fn with_step(time_step: f64) -> Declared {
    Declared {
        time_step: Some(time_step),
        ..NOTHING
    }
}

/// Format, component, step, unit and values on a line.
fn line(found: &Accelerogram) -> String {
    format!(
        "{}, {}, {} s, {}, {:?}",
        found.format().name(),
        found.component().unwrap_or("no name"),
        found.time_step(),
        found.unit().symbol(),
        found.values()
    )
}

fn directions(text: impl AsRef<[u8]>) -> Vec<Option<Direction>> {
    let names = components(text.as_ref()).expect("components");
    names.iter().map(|name| Direction::of_component(name)).collect()
}

const SIDEWAYS: Option<Direction> = Some(Direction::Horizontal);
const UPRIGHT: Option<Direction> = Some(Direction::Vertical);

/// The vertical component of such files shook rows: only the last word of a name was checked, or the word was not known.
#[test]
fn issue_vertical_components_wherever_a_format_puts_the_word() {
    let at2 = |title: &str| {
        format!(
            "PEER NGA STRONG MOTION DATABASE RECORD\n{title}\nACCELERATION TIME HISTORY IN UNITS OF G\n\
             NPTS= 2, DT= .01 SEC\n.1 .2\n"
        )
    };
    assert_eq!(directions(at2("Somewhere, 1/2/2011, CCM, BHZ00")), [UPRIGHT]);
    assert_eq!(directions(at2("Somewhere, 1/2/2011, CCM, BHE00")), [SIDEWAYS]);
    assert_eq!(directions(at2("Somewhere, 1/2/2011, A School, 1 Up")), [UPRIGHT]);
    let csmip = |to| directions(file("csmip.v2").replace("Chan  1:  90 Deg", to));
    let upright = csmip("CHAN  1: UP      (STA CHN: 15)     LOCATION: FOOTING, W. EDGE");
    assert_eq!(upright[0], UPRIGHT);
    assert_eq!(csmip("CHAN  1: V       (STA CHN:  2)")[0], UPRIGHT);
    assert_eq!(csmip("CHAN  1: L       (STA CHN:  1)")[0], SIDEWAYS);
    assert_eq!(csmip("COMP  1 UP")[0], UPRIGHT);
    // A word of a place is not a direction.
    assert_eq!(csmip("CHAN  1:  90 DEG (STA CHN: 1)  LOCATION: UP THE HILL")[0], SIDEWAYS);
    let smc = |to| directions(with("usgs.smc", "component=     27", to));
    assert_eq!(smc("component=   1 Up"), [UPRIGHT]);
}

/// Any step and any large peak were accepted.
#[test]
fn issue_steps_and_peaks_that_no_record_has() {
    let impossible = with("usgs.smc", "0.1000000E+03", "0.1000000E+13");
    assert_snapshot!(refusal(&impossible, &NOTHING), @"line 18 gives a time step of 1e-12 s, allowed are 1e-6 to 10 s: the header lacks it, or is damaged; if it is right, declare the same as `time_step`");
    // A user who repeats the value means it.
    let found = accelerogram(&impossible, &with_step(1e-12));
    assert_eq!(found.unusual(), [Unusual::TimeStep { found: 1e-12 }]);
    assert_snapshot!(refusal("time_s,acceleration_g\n0,1\n3600,2\n", &NOTHING), @"line 2 gives a time step of 3600.0 s, allowed are 1e-6 to 10 s: the header lacks it, or is damaged; if it is right, declare the same as `time_step`");
    let found = accelerogram("time_s,acceleration_g\n0,0.25\n0.5,-12\n", &NOTHING);
    let said: Vec<String> = found.unusual().iter().map(Unusual::to_string).collect();
    assert_snapshot!(said.join("\n"), @r"
    found a time step of 0.5 s in the file, usual is 0.0001 to 0.1 s
    found a peak of 12.0 g in the file, usual is 0.02 to 3 g; its unit decides it
    ");
    let usual = accelerogram("time_s,acceleration_g\n0,0.25\n0.1,-3\n", &NOTHING);
    assert!(usual.unusual().is_empty(), "{:?}", usual.unusual());
}

/// Velocities became accelerations once their unit was declared.
#[test]
fn issue_velocities_of_the_broadband_platform() {
    let text = "# LP Sim NGAH, stat=s01\n#    time(sec)      N-S(cm/s)      E-W(cm/s)      U-D(cm/s)\n\
                0.0\t1.0\t2.0\t3.0\n0.1\t1.0\t-2.0\t3.0\n";
    let declared = Declared {
        component: Some("E-W".replace('-', "")),
        ..IN_GAL
    };
    assert_snapshot!(refusal(text, &declared), @r##"line 2 reads "#    time(sec)      N-S(cm/s)      E-W(cm/s)      U-D(cm/s)", which speaks for velocities, and only histories of acceleration are read; take the record of accelerations, such as channel HNE of an accelerometer, or declare `acceleration` if the values were turned into accelerations"##);
    let turned = Declared {
        acceleration: true,
        ..declared
    };
    let found = accelerogram(text, &turned);
    assert_eq!(found.values(), [2.0, -2.0]);
    assert!(matches!(found.unusual(), [Unusual::Peak { .. }, Unusual::Velocity { .. }]));
}

/// Files that name each column on a separate line were refused.
#[test]
fn issue_broadband_columns_in_comments() {
    let text = "# Strong motion recording\n# Column 1: Time (s)\n# Column 2: East-west acceleration (cm/s/s) (+ is eastward)\n\
                # Column 3: North-south acceleration (cm/s/s) (+ is northward)\n\
                # Column 4: Up-down acceleration (cm/s/s) (+ is upward)\n#\n0.00 1.5 2.5 3.5\n0.02 1.0 2.0 3.0\n";
    assert_eq!(directions(text), [SIDEWAYS, SIDEWAYS, UPRIGHT]);
    assert_snapshot!(line(&accelerogram(text, &component("NS"))), @"SCEC BBP, NS, 0.02 s, cm/s², [2.5, 2.0]");
}

/// A blank line ended the header.
#[test]
fn issue_cwb_with_a_blank_line_in_its_header() {
    let text = "#Earthquake Information\n#Magnitude(Ml): 6.0\n\n#Station Information\n#RecordLength(sec): 0.04\n\
                #SampleRate(Hz): 50\n#AmplitudeUnit:  gal. DCoffset(corr)\n#Data: 4F10.3\n     \
                0.000     0.250     0.500     0.750\n     0.020    -0.250    -0.500    -0.750\n";
    assert_snapshot!(line(&accelerogram(text, &component("N"))), @"CWB, N, 0.02 s, cm/s², [0.5, -0.5]");
    assert_eq!(directions(text), [UPRIGHT, SIDEWAYS, SIDEWAYS]);
}

/// The poles of filters after the time step were refused as excess numbers.
#[test]
fn issue_at2_with_poles_of_filters() {
    let text = |line: &str| format!("PEER\nSomewhere, UP\nACCELERATION IN UNITS OF G\n{line}\n.1 .2\n");
    let poles = "NPTS=   2, DT=   .0100 SEC,   0 POLE @    30.00000 HZ,  -5 POLE @      .40000";
    assert_snapshot!(line(&accelerogram(text(poles), &NOTHING)), @"PEER AT2, UP, 0.01 s, g, [0.1, 0.2]");
    let filter = "NPTS=   2, DT=   .0100 SEC, 4 POLE @ 40 HZ";
    assert_snapshot!(line(&accelerogram(text(filter), &NOTHING)), @"PEER AT2, UP, 0.01 s, g, [0.1, 0.2]");
}

/// The NPTS of another record, in a title, was believed.
#[test]
fn issue_at2_with_the_count_of_another_record() {
    let text = "El Somewhere\n3 points at equal spacing of 0.02 sec\nThe units are (g) NPTS=  7818, DT= .0200 SEC\n\
                *** Begin data ***\n0.25\n-0.5\n0.75\n";
    let found = accelerogram(text, &NOTHING);
    assert_eq!(found.values(), [0.25, -0.5, 0.75]);
    assert_snapshot!(readings(&found), @r#"
    format: PEER AT2
    number of samples (line 2): 3
    time step (line 2): 0.02 s
    unit (line 3): g (The units are (g) NPTS=  7818, DT= .0200 SEC)
    count (line 2): "3 points at equal spacing of 0.02 sec", which the values have, and not "The units are (g) NPTS=  7818, DT= .0200 SEC"
    "#);
    assert_snapshot!(refusal(text.replace("0.75\n", ""), &NOTHING), @"the values end at line 6 after 2 of them, but the header declares 7818; fetch the file again, or correct the header if the values are complete");
}

/// Type 0, `UNKNOWN`, and columns of 14 bytes were refused.
#[test]
fn issue_smc_of_unknown_type() {
    let text = file("usgs.smc");
    let (header, _) = text.split_once("-2.4676E+1").expect("the values");
    let wide = " 2.5000000E-01-7.1842000E+01 5.5757000E+01 1.0000000E+00-2.0000000E+00\n 3.0000000E+00\n";
    let header = header.replace("2 CORRECTED ACCELEROGRAM", "0 UNKNOWN               ");
    let header = header.replace("        21    -32768", "         6    -32768");
    let said = header.replace("hand-made", "ACCELERATION TIME HISTORY, hand-made");
    assert_snapshot!(readings(&accelerogram(format!("{said}{wide}"), &NOTHING)), @r"
    format: USGS SMC
    component (line 6): 27
    number of samples (line 14): 6
    time step (line 18): 0.01 s
    unit (line 29): cm/s² (as the format has it for accelerations: the type is unknown, but a comment says so)
    peak in the header (line 23): 71.842 cm/s²
    ");
    assert_snapshot!(refusal(format!("{header}{wide}"), &NOTHING), @"the file does not say in which unit its values are; declare it as `unit`, one of g, m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10");
}

/// Columns began one byte late, and pieces with two numbers were read as one.
#[test]
fn issue_usc_volume_1_in_columns_behind_a_blank() {
    let text = file("csmip-old.v1");
    let behind = text.lines().map(|line| {
        let is_data = line.starts_with("   .0") || line.starts_with("   .1");
        if is_data { format!(" {line}\n") } else { format!("{line}\n") }
    });
    let behind: String = behind.collect();
    assert_ne!(behind, text);
    let declared = Declared {
        unit: Some(AccelerationUnit::TenthG),
        ..component("1")
    };
    let read = |text: &str| {
        pounding_motion::read_declared(text.as_bytes(), &declared)
            .or_else(|_| pounding_motion::read_declared(text.as_bytes(), &component("1")))
    };
    assert_eq!(read(&behind).expect("a record").values(), read(&text).expect("a record").values());
}

/// Only the peak has a unit in these files, and a declaration was refused too.
#[test]
fn issue_usc_volume_2_with_the_unit_of_the_peak() {
    let text = file("usc.s0a");
    let block = text.lines().find(|line| line.contains("POINTS OF ACC DATA")).expect("a block");
    let (before, _) = block.split_once("SEC.").expect("a step");
    let text = text.replace(block, &format!("{before}SEC."));
    assert_eq!(accelerogram(&text, &NOTHING).unit(), AccelerationUnit::CentimetrePerSecondSquared);
    let peak = text.lines().find(|line| line.contains("PEAK ACCELERATION")).expect("a peak");
    let silent = text.replace(peak, "");
    assert_eq!(
        accelerogram(silent.replacen("PEAK   VELOCITY", "\nPEAK   VELOCITY", 1), &IN_GAL)
            .unit()
            .symbol(),
        "cm/s²"
    );
}

/// `EQUALLY SPACED AT` was not searched in volume 1.
#[test]
fn issue_csmip_volume_1_with_its_step() {
    let text = file("csmip-new.v1");
    let block = text.lines().find(|line| line.contains("points at")).expect("a block");
    let count = block.split_whitespace().next().expect("a count");
    let spaced = format!("{count} POINTS OF ACCEL DATA EQUALLY SPACED AT .005 SEC.  (UNITS: G)");
    let found = accelerogram(text.replace(block, &spaced), &component("1"));
    let before = accelerogram(&text, &component("1"));
    assert_eq!(found.values(), before.values());
    assert_eq!(found.time_step().to_string(), "0.005");
}

/// A file with one row more than declared was refused.
#[test]
fn issue_unam_with_one_row_more() {
    let text = "INSTITUTO DE INGENIERIA, UNAM\nARCHIVO ESTANDAR DE ACELERACION\nORIENTACION C1-C6 (rumbo;orientacion) : /V;+/N90E;-\n\
                INTERVALO DE MUESTREO, C1-C6 (s) : /0.01/0.01\nNUM. TOTAL DE MUESTRAS, C1-C6 : /2/2\nACEL. MAX.(Gal), C1-C6 : /-5.28/11.90\n\n\
                 0.46      2.33\n     -5.28    11.90\n      0.32      0.42\n";
    assert_eq!(directions(text), [UPRIGHT, SIDEWAYS]);
    let found = accelerogram(text, &component("2"));
    assert_snapshot!(readings(&found), @r"
    format: UNAM
    component (line 3): N90E;-
    number of samples (line 5): 3
    time step (line 4): 0.01 s
    unit (line 6): cm/s² (ACEL. MAX.(Gal), C1-C6 : /-5.28/11.90)
    peak in the header (line 6): ACEL. MAX.(Gal), C1-C6 : /-5.28/11.90
    rows (line 5): one more than the header declares, 2
    ");
    let two_more = format!("{text}      0.32      0.42\n");
    assert_snapshot!(refusal(two_more, &component("2")), @"the values end at line 11 after 4 of them, but the header declares 2; fetch the file again, or correct the header if the values are complete");
}

const BHRC: [&str; 13] = [
    "* VOL1DS FILE:  1/01",
    "Inst Type = ABC",
    "Origin Time : 2001/02/03",
    "",
    "V",
    "",
    "COMP V2      ",
    "A Town",
    "Epicentre",
    "INSTR PERIOD =  .020 SEC   DAMPING =  .640",
    "NO. OF POINTS =   3      DURATION =  .015",
    "UNITS ARE SECONDS AND G/10",
    "",
];

/// Files of these networks were refused with advice for other formats.
#[test]
fn issue_formats_of_other_networks() {
    let whole = "    0    0    0\n".repeat(7);
    let real = format!(
        "  .202020E-01  .640000E+00\n  .200000E+03  .000000E+00\n{}",
        "  .000000E+00\n".repeat(5)
    );
    let bhrc = format!("{}\n{whole}{real}  .921041E-02 -.140956E-01  .189808E-01\n/&\n", BHRC.join("\n"));
    assert_snapshot!(line(&accelerogram(bhrc, &NOTHING)), @"BHRC, COMP V2, 0.005 s, g/10, [0.00921041, -0.0140956, 0.0189808]");

    let csmnc = "065XYZ\nSOMEWHERE\nCOMP. EW\nUNCORRECTED ACCELERATION          UNIT: CM/SEC/SEC\n\
                 NO. OF POINTS:  4  EQUALLY SPACED INTERVALS OF:  0.005  SEC\nPEAK VALUE:    0.052   AT   0.01 SEC    DURATION:  1 SEC\n\
                 CSMNC\n\n-1.151609E-2  5.210162E-2 -2.321052E-2 -2.894372E-4 \n";
    assert_snapshot!(line(&accelerogram(csmnc, &NOTHING)), @"CSMNC, EW, 0.005 s, cm/s², [-0.01151609, 0.05210162, -0.02321052, -0.0002894372]");

    let dyna = "Event Date & Time             : 2001-02-03\nOrientation                   : NS\n\
                Time Increment (s)            : 0.005\nNumber of Data                : 4\n\
                PGA (m/s/s)                   : 2.5000000E-03\nAccelaration time series in m/s/s\n \
                1.2448884E-04-2.5000000E-03\n 1.2440317E-04 1.2438789E-04\n";
    assert_snapshot!(line(&accelerogram(dyna, &NOTHING)), @"DYNA, NS, 0.005 s, m/s², [0.00012448884, -0.0025, 0.00012440317, 0.00012438789]");

    let emod3d = "XYZ        ver \n3  5.00000e-03 0 0  0.00000e+00  0.00000e+00  0.00000e+00  0.00000e+00\n \
                  -3.93256e-08  -3.92474e-08  -3.91694e-08\n";
    assert_eq!(directions(emod3d), [UPRIGHT]);
    assert_snapshot!(refusal(emod3d, &NOTHING), @"the file does not say in which unit its values are; declare it as `unit`, one of g, m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10");
    assert_snapshot!(line(&accelerogram(emod3d, &IN_GAL)), @"EMOD3D, ver, 0.005 s, cm/s², [-3.93256e-8, -3.92474e-8, -3.91694e-8]");

    let block = |kind: &str| {
        format!(
            " A TOWN, 10TH FLOOR\n 090 DEGREES\n EARTHQUAKE\n BUTTERWORTH\n YEAR=2001 COMPONENT=  90\n \
             SAMPLES/SEC=200 FILTER TYPE=BUTTERWORTH DATA TYPE={kind}\n NO OF POINTS=  3, UNITS=CM/SEC**2, CM/SEC, AND CM\n   \
             -1.95   -2.05\n    2.50\n"
        )
    };
    let usgs = block("AC") + &block("VL") + &block("DP");
    assert_snapshot!(line(&accelerogram(usgs, &NOTHING)), @"USGS text, 90, 0.005 s, cm/s², [-1.95, -2.05, 2.5]");
    assert_snapshot!(refusal(block("VL"), &NOTHING), @r#"line 6 reads "SAMPLES/SEC=200 FILTER TYPE=BUTTERWORTH DATA TYPE=VL", but only histories of acceleration are read; take the file with DATA TYPE=AC"#);
}

/// Columns after words were refused under any declaration.
#[test]
fn issue_components_in_columns() {
    let csv = "time,acc_NS(gal),acc_EW(gal),acc_UD(gal)\n0.00,1.5,2.5,3.5\n0.01,-1.5,-2.5,-3.5\n";
    assert_eq!(directions(csv), [SIDEWAYS, SIDEWAYS, UPRIGHT]);
    assert_snapshot!(line(&accelerogram(csv, &component("acc_EW"))), @"plain text, acc_EW, 0.01 s, cm/s², [2.5, -2.5]");
    let words = "type of record: accelerogram\nunits: cm/s^2\n   components: E N Z\n ------\n\n 0.5 1.5 2.5\n -0.5 -1.5 -2.5\n";
    assert_eq!(directions(words), [SIDEWAYS, SIDEWAYS, UPRIGHT]);
    let declared = Declared {
        component: Some("Z".to_owned()),
        time_step: Some(0.005),
        ..IN_GAL
    };
    assert_snapshot!(line(&accelerogram(words, &declared)), @"plain text, Z, 0.005 s, cm/s², [2.5, -2.5]");
    // Without names the first column may be a time, and the directions of the others are unknown.
    let bare = "0.00 1 2 3\n0.01 4 5 6\n0.02 7 8 9\n";
    assert_eq!(components(bare.as_bytes()).expect("columns"), ["column 2", "column 3", "column 4"]);
    assert_eq!(directions(bare), [None, None, None]);
    let velocity = csv.replace("(gal)", "(cm/s)");
    assert_snapshot!(refusal(velocity, &component("acc_EW")), @r#"line 1 reads "acc_EW (cm/s)", which speaks for velocities, and only histories of acceleration are read; take the record of accelerations, such as channel HNE of an accelerometer, or declare `acceleration` if the values were turned into accelerations"#);
}

/// Values line after line could not be declared in any way.
#[test]
fn issue_bare_values_line_after_line() {
    let declared = Declared {
        time_step: Some(0.02),
        ..IN_GAL
    };
    let text = " 0.1 0.2 0.3\n 0.4 0.5 0.6\n 0.7\n";
    let found = accelerogram(text, &declared);
    assert_eq!(found.values(), [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]);
    assert_snapshot!(readings(&found), @r"
    format: plain text
    number of samples: 7
    time step: 0.02 s (declared)
    unit: cm/s² (declared)
    columns (line 1): 3, values line after line
    ");
    let counted = accelerogram(" 6  0.02\n 0.1 0.2 0.3\n 0.4 0.5 0.6\n", &IN_GAL);
    assert_eq!(counted.values(), [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
    assert_eq!(counted.time_step().to_string(), "0.02");
}

/// A line with the number of pairs became the first time. Times in single precision counted as uneven, and a first time other than zero was
/// refused.
#[test]
fn issue_pairs_behind_a_count_in_single_precision_and_from_anywhere() {
    let counted = accelerogram(" 3  0.005\n 0.005 1.5\n 0.01 -2.5\n 0.015 3.5\n", &IN_GAL);
    assert_eq!(counted.values(), [0.0, 1.5, -2.5, 3.5]);
    assert_snapshot!(refusal(" 3  0.004\n 0.005 1.5\n 0.01 -2.5\n 0.015 3.5\n", &IN_GAL), @"the file gives more than one time step: 0.005 s (line 2), 0.004 s (line 1); declare the right one as `time_step`, or correct the file");
    let single = |step: u16| {
        let time = 240.0_f32 + 0.025 * f32::from(step);
        let sign = if step.is_multiple_of(2) { "" } else { "-" };
        format!("{time:.6} {sign}{step}.5\n")
    };
    let text: String = (0..40).map(single).collect();
    assert!(text.contains("240.024994"), "rounded to single precision: {text}");
    let found = accelerogram(text, &IN_GAL);
    assert_eq!(found.format(), Format::Plain);
    assert_eq!(found.time_step().to_string(), "0.025");
    assert_eq!(found.values().len(), 40);
    let start = found.readings().iter().find(|one| one.what == "start");
    assert_snapshot!(start.expect("a remark").found, @"the 240 s of the first line, taken as t = 0");
}
