//! Sentences and parts of refusals.

use std::path::Path;

use super::Refused;
use crate::{Knob, Naming, RefusalKind, Spot};

fn parts(refused: &Refused) -> [String; 5] {
    let of = refused.parts();
    let rest = [of.place, of.found, of.allowed, of.help].map(Option::unwrap_or_default);
    let [place, found, allowed, help] = rest;
    [of.message, place, found, allowed, help]
}

#[test]
fn reference_parts_and_sentence() {
    let mut gap = Refused::at("contacts[0].gap_m")
        .found("-0.01")
        .allowed_is("a number >= 0")
        .help("widen it");
    gap.place_mut().spot = Some(Spot::Letter(3, 1));
    assert_eq!(
        parts(&gap.in_file(Path::new("a.toml"))),
        [
            "a.toml, line 3, column 1: contacts[0].gap_m: found -0.01, allowed is a number >= 0; widen it",
            "a.toml, line 3, column 1: contacts[0].gap_m",
            "-0.01",
            "a number >= 0",
            "widen it"
        ]
    );
    let line = Refused::at(Spot::Line(7))
        .reads("DT=")
        .but(", but ", "a time step should stand there");
    assert_eq!(line.word(), Some("DT="));
    assert_eq!(
        parts(&line.in_file(Path::new("q.AT2"))),
        [
            "q.AT2: line 7 reads \"DT=\", but a time step should stand there",
            "q.AT2: line 7",
            "\"DT=\"",
            "a time step should stand there",
            ""
        ]
    );
    let end = Refused::that_at(Spot::Line(9), "the values end at line 9").help("fetch it again");
    assert_eq!(
        parts(&end),
        [
            "the values end at line 9; fetch it again",
            "line 9",
            "the values end at line 9",
            "",
            "fetch it again"
        ]
    );
    assert_eq!(parts(&"stopped".into()), ["stopped", "", "stopped", "", ""]);
}

/// Parts were recovered from sentences, so a name that contains ": found " was cut.
#[test]
fn issue_a_deserialiser_hands_on_parts_and_no_sentence() {
    let own = Refused::at("count").found("x: found y, allowed z; q").allowed_is("1").help("w");
    let handed = Refused::handed(&own);
    assert_eq!(parts(&handed), parts(&own));
    assert_eq!(
        Refused::handed(&"found 1, allowed 2"),
        Refused::that("found 1, allowed 2".to_owned())
    );
}

/// The program and Python named fields of a scene that nobody had written, or replaced words in finished sentences.
#[test]
fn issue_a_knob_is_named_by_whom_it_is_turned() {
    let unit = Refused::that("no unit").help("declare it as ").and(Knob::Unit).wants(Knob::Unit);
    let switch = Refused::that("rows").help("declare ").and(Knob::InRows);
    let corner = Refused::at("record.band_pass.low_hz").found("0").so(", see ", Knob::field("x.y"));
    for (naming, wanted) in [
        (
            Naming::Scene,
            [
                "`record.unit`",
                "`record.in_rows` as true",
                "record.band_pass.low_hz: found 0, see `x.y`",
            ],
        ),
        (Naming::Option, ["--unit", "--in-rows", "--band-pass LOW: found 0, see `x.y`"]),
        (
            Naming::Argument,
            ["`unit`", "`in_rows`", "record.band_pass.low_hz: found 0, see `x.y`"],
        ),
    ] {
        let said = [&unit, &switch, &corner].map(|one| one.clone().by(naming).to_string());
        assert!(said.iter().zip(wanted).all(|(said, wanted)| said.ends_with(wanted)), "{said:?}");
    }
    assert_eq!(unit.wanted(), Some(&Knob::Unit));
    assert!(unit.is_kind(RefusalKind::Wrong));
}
