//! Folders of records: which motions are of one event.

use crate::suite::{Folder, list, motion};

/// An AT2 file of PEER with this title.
fn at2(title: &str, rate: f64) -> String {
    format!(
        "PEER STRONG MOTION DATABASE RECORD\n{title}\nACCELERATION TIME HISTORY IN UNITS OF G\n\
         NPTS= 300, DT= .02 SEC\n{}",
        list(rate)
    )
}

/// Returns the events of files, in the order of their names. Each file is another motion with its own header.
fn events_of(files: &[(&str, &str)]) -> Vec<usize> {
    let mut folder = Folder::new();
    for (index, (name, header)) in files.iter().enumerate() {
        let rate = 5.0 + 0.7 * index as f64;
        let text = match header.strip_prefix("AT2 ") {
            Some(title) => at2(title, rate),
            None => format!("{header}# dt = 0.02 s, unit: g\n{}", list(rate)),
        };
        folder = folder.with(name, text);
    }
    let suite = folder.suite();
    assert_eq!(suite.left_out, [], "all are used");
    suite.motions.iter().map(|one| one.event).collect()
}

/// Components of one record belong to one event, however the files tell it.
#[test]
fn issue_components_of_one_record_are_one_event() {
    let events = |files: &[&str]| {
        let mut folder = Folder::new();
        for (index, name) in files.iter().enumerate() {
            folder = folder.with(name, motion(5.0 + 0.7 * index as f64));
        }
        let suite = folder.suite();
        suite.motions.iter().map(|one| one.event).collect::<Vec<_>>()
    };
    assert_eq!(events(&["ABC001.EW.csv", "ABC001.NS.csv", "ABC002.EW.csv"]), [0, 0, 1]);
    assert_eq!(events(&["RSN6-H1.csv", "RSN6-H2.csv"]), [0, 0]);
    // Numbers of records are not azimuths.
    assert_eq!(events(&["r001.csv", "r002.csv", "r091.csv"]), [0, 1, 2]);
}

/// The same name of an event counted more than origin times twelve days apart.
#[test]
fn issue_times_far_apart_are_two_events() {
    let at = |time: &str| format!("# Station: ABC\n# Event: Chile\n# Origin time: {time}\n");
    let [first, soon, later] = ["2010-02-27T06:34:00", "2010-02-27T06:34:01", "2010-03-11T14:39:00"].map(at);
    let files = [
        ("a.txt", &*first),
        ("b.txt", &*soon),
        ("c.txt", &*later),
        ("d.txt", "# Station: ABC\n# Event: Chile\n"),
    ];
    assert_eq!(events_of(&files[..3]), [0, 0, 1]);
    // Components that begin a millisecond before and after the full second.
    let files = [
        ("ABC_EW.txt", "# Station: ABC\n# Start time: 2010-02-27T06:34:00.998\n"),
        ("ABC_NS.txt", "# Station: ABC\n# Start time: 2010-02-27T06:34:01.001\n"),
    ];
    assert_eq!(events_of(&files), [0, 0]);
    // No moment: the time of the first sample.
    let relative = "# Station: 1\n# Start time: 0.0\n";
    assert_eq!(events_of(&[("a.txt", relative), ("b.txt", relative)]), [0, 1]);
}

/// Station and event in the comments of the project's own CSV were not read.
#[test]
fn issue_comments_of_a_csv_tell_the_event() {
    let csv = |event: &str, rate: f64| format!("# Station: ABC\n# Event: {event}\n{}", motion(rate));
    let folder = Folder::new()
        .with("first.csv", csv("Chile", 5.0))
        .with("second.csv", csv("Chile", 5.7))
        .with("third.csv", csv("Kobe", 6.4));
    let events: Vec<usize> = folder.suite().motions.iter().map(|one| one.event).collect();
    assert_eq!(events, [0, 0, 1]);
}

/// Files whose event texts name the component were separate events, although their names show one record.
#[test]
fn issue_events_whose_texts_name_the_component_are_one() {
    let files = [
        ("k_EW.txt", "# Station: ABC\n# Earthquake: Kobe 1995, EW component\n"),
        ("k_NS.txt", "# Station: ABC\n# Earthquake: Kobe 1995, NS component\n"),
        ("q.txt", "# Station: ABC\n# Earthquake: Kobe 1995, another day\n"),
    ];
    assert_eq!(events_of(&files), [0, 0, 1]);
}

/// Four files with the title of a generator were one event.
#[test]
fn issue_a_title_that_stands_above_several_records_joins_none() {
    let titles = ["AT2 Generated motion, 000", "AT2 Generated motion, 090"];
    let names = ["gm1_x.AT2", "gm1_y.AT2", "gm2_x.AT2", "gm2_y.AT2"];
    let files: Vec<_> = names.into_iter().zip(titles.into_iter().cycle()).collect();
    assert_eq!(events_of(&files), [0, 0, 1, 1]);
    assert_eq!(events_of(&[("a.AT2", titles[0]), ("b.AT2", titles[1])]), [0, 0]);
}
