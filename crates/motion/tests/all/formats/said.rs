//! Statements in comments and titles about bare numbers: reading, and comparison with declarations.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, components};

use super::{accelerogram, readings, refusal, rows_of, wave};

fn nothing() -> Declared {
    Declared::default()
}

fn declared(unit: AccelerationUnit, time_step: f64) -> Declared {
    Declared {
        unit: Some(unit),
        time_step: Some(time_step),
        ..nothing()
    }
}

/// Component, number, step and unit on one line.
fn line(text: &str) -> String {
    let found = accelerogram(text, &nothing());
    format!(
        "{}, {} values, {} s, {}",
        found.component().unwrap_or("no name"),
        found.values().len(),
        found.time_step(),
        found.unit().symbol()
    )
}

/// One value per line.
fn column(n_values: usize) -> String {
    rows_of(n_values, |_, value| format!("{value:.6e}\n"))
}

/// Six values per line.
fn in_rows(n_values: usize) -> String {
    let values: Vec<String> = wave(n_values).iter().map(|value| format!("{value:.6e}")).collect();
    let rows = values.chunks(6).map(|row| row.join("  ") + "\n");
    rows.collect()
}

const CSN: &str = "# Tiempo de Origen: 2020-05-25T21:51:52.000000Z\n# Tasa de muestreo: 200.0 muestras/seg\n\
                   # Número total de muestras: 120\n# Estacion: Z99Z Componente: HNZ\n# Latitud: -23.101 Longitud: -70.445\n\
                   # Unidades: m/seg/seg\n";
const SLIST: &str = "TIMESERIES ZZ_STA__HNE_D, 120 samples, 200 sps, 2020-01-01T00:00:00.000000, SLIST, FLOAT, M/S**2\n";
const GEO_CSV: &str = "# dataset: GeoCSV 2.0\n# delimiter: ,\n# SID: ZZ_STA_00_HNZ\n# sample_count: 120\n# sample_rate_hz: 200\n\
                       # start_time: 2020-01-01T00:00:00.000000Z\n# field_unit: M/S**2\n# field_type: FLOAT\nSample\n";
const PROSE: &str = "# Station ABC component N, dt = 0.005 s, acceleration in cm/s2\n";

/// Rate, unit, number and component of such headers were ignored, and contradicting declarations were accepted.
#[test]
fn issue_headers_in_comments_and_titles() {
    let csn = format!("{CSN}{}", column(120));
    assert_snapshot!(line(&csn), @"HNZ, 120 values, 0.005 s, m/s²");
    assert_snapshot!(readings(&accelerogram(&csn, &nothing())), @"
    format: plain text
    component (line 4): HNZ
    number of samples (line 3): 120
    time step (line 2): 0.005 s
    unit (line 6): m/s² (m/seg/seg)
    columns (line 7): 1
    ");
    assert_snapshot!(line(&format!("{SLIST}{}", in_rows(120))), @"HNE, 120 values, 0.005 s, m/s²");
    assert_snapshot!(line(&format!("{GEO_CSV}{}", column(120))), @"HNZ, 120 values, 0.005 s, m/s²");
    assert_snapshot!(line(&format!("{PROSE}{}", column(120))), @"N, 120 values, 0.005 s, cm/s²");
    for header in [
        "dt,0.02\n",
        "dT: 20 ms\n",
        "Sampling rate (Hz)=\t50\n",
        "# fs = 50\n",
        "sampled at 50 Hz\n",
        "Sampling(Hz): 50\n",
        "time step 1/50 s\n",
        "Δt = 0.02 s\n",
    ] {
        let found = accelerogram(format!("acc (g)\n{header}{}", column(30)), &nothing());
        assert_eq!(found.time_step().to_string(), "0.02", "{header}");
        assert_eq!(found.unit(), AccelerationUnit::StandardGravity, "{header}");
    }
}

/// Declarations that contradict such headers were accepted.
#[test]
fn issue_declared_against_comments() {
    let in_mg = declared(AccelerationUnit::MilliG, 0.02);
    let csn = format!("{CSN}{}", column(120));
    assert_snapshot!(refusal(&csn, &in_mg), @"line 2 gives a time step of 0.005 s, but 0.02 s is declared as `time_step`; leave the declaration away");
    let right_step = declared(AccelerationUnit::MilliG, 0.005);
    assert_snapshot!(refusal(&csn, &right_step), @"line 6 says that the values are in m_per_s2, but mg is declared as `unit`; leave the declaration away");
    for header in [CSN, SLIST, GEO_CSV, PROSE] {
        let values = if header == SLIST { in_rows(120) } else { column(120) };
        let text = format!("{header}{values}");
        let silent = accelerogram(&text, &nothing());
        let repeated = declared(silent.unit(), silent.time_step());
        assert_eq!(accelerogram(&text, &repeated), silent, "{header}");
        refusal(&text, &in_mg);
        refusal(&text, &right_step);
        refusal(&text, &declared(silent.unit(), 0.01));
    }
    // Times and the header must agree, too; a caller may declare which one counts.
    let times: String = rows_of(30, |step, value| format!("{:.2} {value}\n", 0.01 * step));
    let both = format!("# dt = 0.02 s, acc in g\n{times}");
    assert_snapshot!(refusal(&both, &nothing()), @"the file gives more than one time step: 0.01 s (line 2), 0.02 s (line 1); declare the right one as `time_step`, or correct the file");
    let meant = Declared {
        time_step: Some(0.01),
        ..nothing()
    };
    assert_eq!(accelerogram(&both, &meant).time_step().to_string(), "0.01");
    let units = format!("# units: g\n# dt = 0.01 s, acceleration in cm/s2\n{}", column(30));
    assert_snapshot!(refusal(&units, &nothing()), @"the file gives more than one unit: g (line 1), cm_per_s2 (line 2); declare the right one as `unit`, or correct the file");
    let meant = Declared {
        unit: Some(AccelerationUnit::StandardGravity),
        ..nothing()
    };
    assert_eq!(accelerogram(&units, &meant).unit(), AccelerationUnit::StandardGravity);
    refusal(
        &units,
        &Declared {
            unit: Some(AccelerationUnit::MilliG),
            ..nothing()
        },
    );
}

/// Cut files were read silently.
#[test]
fn issue_fewer_values_than_comments_count() {
    for (header, values) in [(CSN, column(60)), (GEO_CSV, column(60)), (SLIST, in_rows(60)), (SLIST, in_rows(59))] {
        let said = refusal(format!("{header}{values}"), &nothing());
        assert!(said.contains("the header declares 120"), "{said}");
    }
    // One or two missing of many values are reported, not refused.
    let found = accelerogram(format!("{CSN}{}", column(119)), &nothing());
    assert_eq!(found.values().len(), 119);
    assert!(
        readings(&found).contains("count (line 3): 119 values, where the header declares 120"),
        "{}",
        readings(&found)
    );
    // A damaged last line does not end the values.
    let at2 = |last: &str| {
        format!(
            "A\nB, 180\nACCELERATION IN UNITS OF G\nNPTS= 121, DT= .02 SEC\n{}{last}\n",
            column(120)
        )
    };
    assert_eq!(accelerogram(at2(""), &nothing()).values().len(), 120);
    assert!(refusal(at2("****"), &nothing()).contains("asterisks"), "{}", at2("****"));
    let short = CSN.replace("120", "20");
    refusal(format!("{short}{}", column(19)), &nothing());
}

/// Files with dates instead of times were refused as an unknown format.
#[test]
fn issue_dates_for_times() {
    let stamped = |separator: &str| {
        let row = |(step, value): (usize, &f64)| format!("2020-01-01T23:59:59.{:06}{separator}{value:.6e}\n", 5000 * step);
        wave(120).iter().enumerate().map(row).collect::<String>()
    };
    let pairs = SLIST.replace("SLIST", "TSPAIR") + &stamped("  ");
    assert_snapshot!(line(&pairs), @"HNE, 120 values, 0.005 s, m/s²");
    let csv = GEO_CSV
        .replace("field_unit: M", "field_unit: UTC, M")
        .replace("Sample\n", "Time, Sample\n")
        + &stamped(", ");
    assert_snapshot!(line(&csv), @"HNZ, 120 values, 0.005 s, m/s²");
    assert_snapshot!(refusal(csv.replace("_hz: 200", "_hz: 100"), &nothing()), @"the file gives more than one time step: 0.005 s (line 10), 0.01 s (line 5); declare the right one as `time_step`, or correct the file");
    let rows: String = rows_of(30, |step, value| {
        format!("2011/03/11 14:46:00,{:.2},{value:.6},{:.6},0.0\n", 0.01 * step, -0.5 * value)
    });
    let knet = format!(
        "OriginTime,2011/03/11-14:46:00\nLatitude,38.103\nCode,ZZZ001\nOffset,0.00,0.00,0.00\nTime,RelativeTime(s),NS(gal),EW(gal),UD(gal)\n{rows}"
    );
    assert_eq!(components(knet.as_bytes()).unwrap(), ["NS", "EW", "UD"]);
    let east = Declared {
        component: Some("EW".to_owned()),
        ..nothing()
    };
    let found = accelerogram(&knet, &east);
    assert_eq!(found.time_step().to_string(), "0.01");
    assert_eq!(found.unit(), AccelerationUnit::CentimetrePerSecondSquared);
}

/// Times since 1970 and times in milliseconds gave no step, or a step of 5 s.
#[test]
fn issue_times_in_other_units() {
    let rows = |time: &dyn Fn(usize) -> String| {
        let row = |(step, value): (usize, &f64)| format!("{},{value:.6e}\n", time(step));
        wave(40).iter().enumerate().map(row).collect::<String>()
    };
    let step = |text: String| accelerogram(text, &nothing()).time_step().to_string();
    let milliseconds = rows(&|step| format!("{}", 5 * step));
    assert_eq!(step(format!("time (ms),acc (g)\n{milliseconds}")), "0.005");
    assert_eq!(step(format!("time_ms,acc_g\n{milliseconds}")), "0.005");
    let in_g = Declared {
        unit: Some(AccelerationUnit::StandardGravity),
        ..nothing()
    };
    assert_snapshot!(refusal(&milliseconds, &in_g), @"line 1: the times rise by 5, and nothing states their unit; name the column `time_s` or `time_ms`, or declare `time_step` as 5 or 0.005 s");
    assert_eq!(
        accelerogram(
            &milliseconds,
            &Declared {
                time_step: Some(0.005),
                ..in_g.clone()
            }
        )
        .time_step()
        .to_string(),
        "0.005"
    );
    assert_eq!(
        accelerogram(
            &milliseconds,
            &Declared {
                time_step: Some(5.0),
                ..in_g.clone()
            }
        )
        .time_step()
        .to_string(),
        "5"
    );
    refusal(
        &milliseconds,
        &Declared {
            time_step: Some(0.5),
            ..in_g
        },
    );
    let since_1970 = rows(&|step| format!("15778368{:02}.{:06}", step / 200, 5000 * (step % 200)));
    assert_eq!(step(format!("time,acc_g\n{since_1970}")), "0.005");
    let in_milliseconds = rows(&|step| format!("1577836800{:03}", 5 * step));
    assert_eq!(step(format!("time,acc_g\n{in_milliseconds}")), "0.005");
}

/// Velocities and displacements named in a title were read as accelerations.
#[test]
fn issue_other_quantities_in_titles() {
    let text = |unit: &str| format!("# units: {unit}\n# dt = 0.01 s\n{}", column(30));
    assert_snapshot!(refusal(text("cm/s"), &nothing()), @r##"line 1 reads "# units: cm/s", which speaks for velocities, and only histories of acceleration are read; take the record of accelerations, such as channel HNE of an accelerometer, or declare `acceleration` if the values were turned into accelerations"##);
    assert_snapshot!(refusal(text("cm"), &nothing()), @r##"line 1 reads "# units: cm", but only histories of acceleration are read; take the accelerations of the record, these are displacements"##);
    assert_snapshot!(refusal(text("counts"), &nothing()), @r##"line 1 reads "# units: counts": the values are counts of a digitiser; declare what one is worth as `per_count`, and in which `unit`"##);
    for title in [
        "Velocity time history, dt = 0.01 s",
        "Displacement (cm), dt = 0.01 s",
        "velocity in cm/s, 100 sps",
    ] {
        let declared = declared(AccelerationUnit::StandardGravity, 0.01);
        let said = refusal(format!("{title}\n{}", column(30)), &declared);
        assert!(said.contains("histories of acceleration"), "{title}: {said}");
    }
    let displacement = "Time (s),Displacement (cm)\n0.00,0.1\n0.01,-0.2\n0.02,0.1\n";
    assert_snapshot!(refusal(displacement, &nothing()), @r#"line 1 reads "Displacement (cm)", but only histories of acceleration are read; take the accelerations of the record, these are displacements"#);
    // Next to accelerations they are not components.
    let table = "Time (s),Acceleration (g),Velocity (cm/s),Displacement (cm)\n0.00,0.1,1,1\n0.01,-0.2,2,2\n0.02,0.1,3,3\n";
    assert_snapshot!(line(table), @"no name, 3 values, 0.01 s, g");
}

/// Words that look like such statements but are not.
#[test]
fn limit_other_words_say_nothing() {
    let other = "# El Somewhere, 1940, magnitude 6.9, 8 points across in a row\n# shear wave velocity (m/s): 345, distance 12 km, PGA (g): 0.31\n\
                 # filtered at 25 Hz, according to g\n";
    let found = accelerogram(format!("{other}{}", column(30)), &declared(AccelerationUnit::MilliG, 0.02));
    assert_eq!(found.time_step().to_string(), "0.02");
    assert_eq!(found.unit(), AccelerationUnit::MilliG);
    assert_eq!(found.component(), None);
}

/// Numbers from before processing, or of something else, were applied to the values, and correct declarations were refused.
#[test]
fn issue_numbers_of_something_else() {
    for (title, unit) in [
        (
            "# Original sampling rate: 200 Hz\n# Resampled to 100 Hz",
            AccelerationUnit::StandardGravity,
        ),
        ("# gravitational acceleration (m/s2): 9.81", AccelerationUnit::StandardGravity),
        ("# station FS 12", AccelerationUnit::StandardGravity),
        ("# FS01", AccelerationUnit::StandardGravity),
        ("# units of Vs30: m/s", AccelerationUnit::StandardGravity),
        ("# 8 values, 10 digits", AccelerationUnit::StandardGravity),
        ("# every 10 samples,", AccelerationUnit::StandardGravity),
        ("# Data from 3 points.", AccelerationUnit::StandardGravity),
    ] {
        let text = format!("{title}\n{}", column(120));
        let found = accelerogram(&text, &declared(unit, 0.01));
        assert_eq!((found.values().len(), found.time_step()), (120, 0.01), "{title}");
        assert_eq!(found.unit(), unit, "{title}");
    }
}

/// Such words were ignored: a cut file was read silently, and a wrong step was accepted.
#[test]
fn issue_short_words_for_numbers_and_steps() {
    for title in [
        "samples: 400",
        "No. of samples: 400",
        "N = 400",
        "count: 400",
        "npt: 400",
        "total points: 400",
    ] {
        let text = format!("# {title}\n{}", column(300));
        let said = refusal(&text, &declared(AccelerationUnit::StandardGravity, 0.01));
        assert!(said.contains("400"), "{title}: {said}");
    }
    for title in ["delta: 0.005", "sps: 200", "rate: 200 Hz", "Ts = 0.005", "fs = 200", "fs (Hz): 200"] {
        let text = format!("# {title}\n{}", column(120));
        let said = refusal(&text, &declared(AccelerationUnit::StandardGravity, 0.01));
        assert!(said.contains("0.005"), "{title}: {said}");
    }
}

/// Stations of one town, and records without a time, counted as one record.
#[test]
fn issue_whole_names_of_stations() {
    let station = |title: &str| {
        let text = format!("# {title}\n{}", column(120));
        let found = pounding_motion::contents(text.as_bytes()).expect("it reads");
        (found.identity.station, found.identity.time)
    };
    let told = |title: &str| station(title).0.unwrap_or_default();
    assert_eq!(told("Station: Los Gatos, Start time: 0.0"), "LOS GATOS");
    assert_eq!(told("Station: Los Angeles Hollywood; Component: 90"), "LOS ANGELES HOLLYWOOD");
    assert_eq!(told("Station ABC component N, dt = 0.005 s"), "ABC");
    assert_eq!(station("Start time: 0.0").1, None);
}
