//! Contents of a file before a component is chosen: directions, places of sensors, place and time of the recording.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Direction, Site, contents};

use super::{accelerogram, component, file, readings, refusal, rows_of, wave, with};

/// Components with their directions and the places of their sensors, then the identity of the record, one per line.
fn told(bytes: impl AsRef<[u8]>) -> String {
    let found = contents(bytes.as_ref()).expect("contents");
    assert!(!found.channels.is_empty(), "at least one");
    let mut lines: Vec<String> = vec![found.format.name().to_owned()];
    for channel in &found.channels {
        let name = channel.name.as_deref().unwrap_or("no name");
        let direction = match channel.direction {
            Some(Direction::Horizontal) => "horizontal",
            Some(Direction::Vertical) => "vertical",
            None => "untold",
        };
        lines.push(match &channel.site {
            Site::Ground => format!("{name}, {direction}"),
            Site::Borehole(said) => format!("{name}, {direction}, borehole: {said}"),
            Site::Structure(said) => format!("{name}, {direction}, structure: {said}"),
        });
    }
    let identity = &found.identity;
    let said = [
        ("station", &identity.station),
        ("event", &identity.event),
        ("time", &identity.time),
        ("title", &identity.title),
    ];
    lines.extend(said.iter().filter_map(|(what, said)| Some(format!("{what} {}", said.as_deref()?))));
    lines.join("\n")
}

#[test]
fn reference_layouts_tell_what_their_headers_have() {
    assert_snapshot!(told(file("esm.asc")), @"
    ESM ASC
    HNE, horizontal
    station ZZ.ZZZ1
    event NONE
    time 20010203
    ");
    assert_snapshot!(told(file("csmip.v2")), @"
    CSMIP V2
    Chan 1: 90 Deg, horizontal
    Chan 2: Up, vertical
    station 99999
    event SOMEWHERE EARTHQUAKE
    time FEB 3, 2001 04:05 PST
    ");
    assert_snapshot!(told(file("csmip-new.v1")), @"
    CSMIP V1
    Chan 3: 0 Deg, horizontal
    station 99999
    event SOMEWHERE EARTHQUAKE
    time FEB 3, 2001 04:05 PST
    ");
    assert_snapshot!(told(file("usc.s0a")), @"
    USC V2
    COMP N08W, horizontal
    station 9999
    event SOMEWHERE EARTHQUAKE
    time FEB 3, 2001 04:05 PST
    ");
    assert_snapshot!(told(file("renadic.v1")), @"
    RENADIC V1
    COMPONENT NS, horizontal
    station 99999
    event SOMEWHERE EARTHQUAKE
    time FEB 3, 2001 04:05 PST
    ");
    assert_snapshot!(told(file("cosmos.v2")), @"
    COSMOS 1.2
    Sta Cha: 1: 340 deg, horizontal
    Sta Cha: 2: up, vertical
    station ZZ-0000
    event SOMEWHERE FEB 3,2001 04:05 PST
    ");
}

#[test]
fn reference_other_layouts_tell_what_their_headers_have() {
    assert_snapshot!(told(file("usgs.smc")), @"
    USGS SMC
    27, horizontal
    station A TOWN, A SCHOOL
    event 2001 2 3 0405 SOMEWHERE
    ");
    assert_snapshot!(told(file("geonet.v2a")), @"
    GeoNet
    S16W, horizontal
    S74E, horizontal
    Up, vertical
    station ZZZZ
    event 20010203_0405_ZZZZ
    ");
    assert_snapshot!(told(file("knet.ns")), @"
    K-NET
    N-S, horizontal
    station ZZZ001
    time 2001-02-03T04:05:00
    ");
    let at2 = "PEER STRONG MOTION DATABASE RECORD. PROCESSING BY SOMEBODY.\nSOMEWHERE 10/15/79  2316, A TOWN ARRAY #6, 140 (AGENCY STATION 942)\n\
               ACCELERATION TIME HISTORY IN UNITS OF G\nNPTS= 1, DT= .01 SEC\n .1\n";
    assert_snapshot!(told(at2), @"
    PEER AT2
    140, horizontal
    title SOMEWHERE 10/15/79 2316, A TOWN ARRAY #6
    ");
    assert_eq!(
        contents(at2.replace("140 (", "230 (").as_bytes()).unwrap().identity,
        contents(at2.as_bytes()).unwrap().identity
    );
    let comments = "# station: ABC\n# event: Somewhere 1940\n# start time: 1940-05-19T04:36:41Z\n# dt = 0.01 s\n0.1\n-0.2\n";
    assert_snapshot!(told(comments), @"
    plain text
    no name, untold
    station ABC
    event SOMEWHERE 1940
    time 1940-05-19T04:36:41
    ");
    assert_snapshot!(told("time_s,acceleration_g\n0,0.1\n0.1,0.2\n"), @"
    CSV
    no name, untold
    ");
}

/// The borehole of KiK-net counted as the ground.
#[test]
fn issue_boreholes() {
    let of = |direction: &str| {
        let text = file("knet.ns");
        let line = text.lines().find(|line| line.starts_with("Dir.")).expect("a direction");
        contents(text.replace(line, &format!("Dir.              {direction}")).as_bytes())
            .expect("contents")
            .channels
            .remove(0)
    };
    for direction in ["1", "2", "3"] {
        assert!(matches!(of(direction).site, Site::Borehole(_)), "{direction}");
    }
    for direction in ["4", "5", "6", "N-S", "E-W"] {
        assert_eq!(of(direction).site, Site::Ground, "{direction}");
    }
    assert_eq!(of("3").direction, Some(Direction::Vertical));
    let deep = with("esm.asc", "STREAM: HNE", "STREAM: HNE\nSENSOR_DEPTH_M: 30.0");
    assert!(matches!(contents(deep.as_bytes()).unwrap().channels[0].site, Site::Borehole(_)));
    let shallow = with("esm.asc", "STREAM: HNE", "STREAM: HNE\nSENSOR_DEPTH_M: 0.0");
    assert_eq!(contents(shallow.as_bytes()).unwrap().channels[0].site, Site::Ground);
}

/// Components recorded on roofs, decks and crests of dams shook rows.
#[test]
fn issue_sensors_on_structures() {
    let site = |text: String| contents(text.as_bytes()).expect("contents").channels.remove(0).site;
    let csmip = |location: &str| {
        site(
            with("csmip.v2", "Chan  1:  90 Deg", "CHAN  1:  90 DEG")
                .replace(
                    "\nCHAN  1:  90 DEG",
                    &format!("\nCHAN  1:  90 DEG (STA CHN:  1)     LOCATION: {location}"),
                )
                .replace(
                    "\nChan  1:  90 Deg",
                    &format!("\nChan  1:  90 Deg (STA CHN:  1)     LOCATION: {location}"),
                ),
        )
    };
    for location in ["ROOF: CENTER", "10TH FLOOR, N. WALL", "DECK: MIDSPAN", "Top of Tower"] {
        assert_eq!(csmip(location), Site::Structure(location.to_owned()));
    }
    for location in ["FREE FIELD", "GROUND FLOOR", "BASEMENT", "FOOTING OF CENTER COLUMN: W. EDGE"] {
        assert_eq!(csmip(location), Site::Ground, "{location}");
    }
    let smc = |station: &str| site(with("usgs.smc", "A Town, a school", station));
    assert_eq!(smc("A Valley Dam, crest"), Site::Structure("crest".to_owned()));
    assert_eq!(smc("A Canyon Dam"), Site::Ground);
    assert_eq!(smc("Hot Springs - Roof St"), Site::Ground);
    let usgs = " A TOWN, 7215 AN AVENUE, 10TH FLOOR\n 090 DEGREES\n EARTHQUAKE\n BUTTERWORTH\n YEAR=2001 COMPONENT=  90\n \
                SAMPLES/SEC=200 FILTER TYPE=BUTTERWORTH DATA TYPE=AC\n NO OF POINTS=  3, UNITS=CM/SEC**2, CM/SEC, AND CM\n -1.95 -2.05\n 2.50\n";
    assert_eq!(site(usgs.to_owned()), Site::Structure("10TH FLOOR".to_owned()));
}

/// Vertical components shook rows if the channel line of COSMOS said `Other`.
#[test]
fn issue_verticals_that_other_places_of_a_file_tell() {
    let text = file("cosmos.v2");
    let line = text.lines().find(|line| line.starts_with("Sta Cha")).expect("a channel");
    let untold = text.replace(line, "Sta Chan   ?:Other   (Rcrdr Chan  ?) Location:");
    let names = |text: &str| {
        let found = contents(text.as_bytes()).expect("contents");
        found
            .channels
            .into_iter()
            .map(|channel| channel.name.unwrap_or_default())
            .collect::<Vec<_>>()
    };
    assert_eq!(names(&untold)[0], "Sta Chan ?:Other");
    let coded = |from: &str, code: &str| untold.replace(from, code);
    let comment = untold.lines().find(|line| line.starts_with('|')).expect("a comment").to_owned();
    for code in ["|<SCNL>BMR.BNZ.AK.--    <AUTH> 2019/02/01", "| RcrdId: US.1000.AK.BMR.BNZ.--"] {
        let told = coded(&comment, code);
        assert_eq!(names(&told)[0], "BNZ", "{code}");
        assert_eq!(contents(told.as_bytes()).unwrap().channels[0].direction, Some(Direction::Vertical));
    }
}

/// The order of columns of CWB is in a key that was not read: a vertical component shook rows.
#[test]
fn issue_cwb_in_another_order_and_without_its_first_line() {
    let names = |text: &str| {
        let found = contents(text.as_bytes()).expect("contents");
        let names = found.channels.into_iter().map(|channel| channel.name);
        names.map(Option::unwrap_or_default).collect::<Vec<_>>()
    };
    let rows: String = rows_of(40, |step, value| {
        format!("{:10.3}{:10.3}{:10.3}{:10.3}\n", 0.005 * step, value, 2.0 * value, 3.0 * value)
    });
    let header = "#StationCode: ZZZ080\n#StartTime: 1999/09/20-17:46:37.0\n#RecordLength(Sec): 0.20\n#SampleRate(Hz): 200\n#AmplitudeUnit: gal. DCoffset(corr)\n";
    let of_1999 = format!("{header}#DataSequence: Time N(+); E(+); U(+)\n#Data: 4F10.3\n{rows}");
    assert_snapshot!(told(&of_1999), @"
    CWB
    N, horizontal
    E, horizontal
    U, vertical
    station ZZZ080
    time 1999-09-20T17:46:37
    ");
    assert_snapshot!(told(of_1999.replace('#', "")), @"
    CWB
    N, horizontal
    E, horizontal
    U, vertical
    station ZZZ080
    time 1999-09-20T17:46:37
    ");
    let up = accelerogram(&of_1999, &component("U"));
    assert!((up.values()[1] - 3.0 * wave(2)[1]).abs() < 1e-3);
    let usual = of_1999.replace("#DataSequence: Time N(+); E(+); U(+)\n", "");
    assert_eq!(names(&usual), ["U", "N", "E"]);
    // Words were skipped and the order of other files was assumed: the vertical component shook the row.
    for sequence in ["Time, North, East, Up", "Time NS EW UD"] {
        let said = of_1999.replace("Time N(+); E(+); U(+)", sequence);
        let found: Vec<_> = names(&said).iter().map(|name| name.chars().next()).collect();
        assert_eq!(found, ["N", "E", "U"].map(|name| name.chars().next()));
    }
    let other = of_1999.replace("Time N(+); E(+); U(+)", "Time, A, B, C");
    assert_snapshot!(refusal(&other, &Declared::default()), @"line 6 reads \"Time, A, B, C\", but a time and three directions, such as `Time U(+); N(+); E(+)`, should stand there; fetch the file again");
}

/// A missing row was not noticed.
#[test]
fn issue_cwb_with_one_row_missing() {
    let rows: String = rows_of(39, |step, value| {
        format!("{:10.3}{value:10.3}{value:10.3}{value:10.3}\n", 0.005 * step)
    });
    let text = format!("#Earthquake Information\n#RecordLength(sec): 0.20\n#SampleRate(Hz): 200\n#AmplitudeUnit: gal\n{rows}");
    assert!(
        readings(&accelerogram(&text, &component("N"))).contains("rows (line 2): 39, one fewer than the header's duration and rate give")
    );
}

/// The message about pairs with some equal times asked for a rate.
#[test]
fn issue_smc_of_pairs_with_ties() {
    let text = file("usgs.smc");
    let (header, _) = text.split_once("-2.4676E+1").expect("the values");
    let header = header
        .replace("0.1000000E+03", "0.1700000E+39")
        .replace("0.5575700E+02", "0.1700000E+39")
        .replace("-0.7184200E+02", " 0.1700000E+39");
    let header = header.replace("        21    -32768    -32768", "         8    -32768    -32768");
    let pairs = format!("{header} 0.0000E+0 1.0000E+0 4.0000E-2 3.0000E+0 4.0000E-2 2.0000E+0 1.0000E-1-6.0000E+0\n");
    let said = refusal(&pairs, &Declared::default());
    assert!(said.contains("uneven steps") && said.contains("`time_step`"), "{said}");
    let declared = Declared {
        time_step: Some(0.02),
        ..Declared::default()
    };
    assert_eq!(
        accelerogram(&pairs, &declared).values(),
        [1.0, 2.0, 2.0, -0.666_666_666_666_666_1, -3.333_333_333_333_333, -6.0]
    );
}

/// A sum of components counted as a component, and other volumes of a known format were refused as unknown.
#[test]
fn issue_other_files_are_named() {
    let refused = |text: &str| refusal(text, &Declared::default());
    assert_snapshot!(refused("000001V 010009602.3121970,001,00:00:00.0000~2038,001~\n"), @"the file is a full SEED volume, whose headers are not read, allowed is a record as text, SAC or miniSEED; save its waveforms as miniSEED");
    let table = "PEER NGA-West2 Ground Motion Database Search\n\n -- Summary of PEER Search Criteria -- \nRSN,1\n -- Summary of Metadata of Selected Records --\n1,2,3\n";
    assert_snapshot!(refused(table), @"the file is PEER's table of selected records, allowed is a record as text, SAC or miniSEED; take the .AT2 files that it lists");
}

/// JSON was refused as an unknown format.
#[test]
fn issue_json_of_the_simcenter() {
    let list = |factor: f64| {
        wave(30)
            .iter()
            .map(|value| format!("{}", factor * value))
            .collect::<Vec<_>>()
            .join(", ")
    };
    let text = format!(
        "{{\n\"name\": \"RSN1\",\n\"dT\": 0.005,\n\"numSteps\": 30,\n\"data_x\": [{}],\n\"data_y\": [{}]\n}}\n",
        list(1.0),
        list(0.5)
    );
    assert_snapshot!(told(&text), @"
    SimCenter JSON
    x, horizontal
    y, horizontal
    ");
    let declared = Declared {
        unit: Some(AccelerationUnit::StandardGravity),
        ..component("y")
    };
    let found = accelerogram(&text, &declared);
    assert_eq!((found.values().len(), found.time_step()), (30, 0.005));
    assert_eq!(found.values()[1].to_string(), (0.5 * wave(2)[1]).to_string());
    refusal(text.replace("0.005", "\"\""), &declared);
    // The header of another program, in a known unit.
    let other = "time_s,acceleration_ms2\n0.00,0.5\n0.01,-0.25\n";
    assert_eq!(
        accelerogram(other, &Declared::default()).unit(),
        AccelerationUnit::MetrePerSecondSquared
    );
}

/// Peaks that differ a little from the header's were refused: agencies state those before their last correction.
#[test]
fn issue_peaks_a_little_off_are_told() {
    let off = |value: &str| with("usgs.smc", "-7.1842E+1", value);
    let found = accelerogram(off("-7.0000E+1"), &Declared::default());
    assert!(
        readings(&found).contains("peak in the header (line 23): 71.842 cm/s², but the values reach 70.00 cm/s², 2.6 % off"),
        "{}",
        readings(&found)
    );
    assert!(found.unusual().is_empty(), "{:?}", found.unusual());
    let more = accelerogram(off("-6.0000E+1"), &Declared::default());
    assert_snapshot!(more.unusual()[0].to_string(), @"found a peak that is 15 % off that in the header of the file, usual is up to 5 %; the file may be cut, damaged or corrected");
    assert!(refusal(off("-9.9000E+1"), &Declared::default()).contains("states a peak"));
}
