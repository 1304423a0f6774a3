//! Refusals that several readers make.

use pounding_text::{Knob, RefusalKind, Refused, Spot, plain};

use crate::FilePlace;

impl From<FilePlace> for pounding_text::FaultPlace {
    fn from(place: FilePlace) -> Self {
        let spot = match place {
            FilePlace::Line(line) => Spot::Line(line),
            FilePlace::Byte(byte) => Spot::Byte(byte),
        };
        spot.into()
    }
}

/// The text contains only blank lines and comments.
pub(crate) fn empty() -> Refused {
    let said = Refused::that("the text holds nothing but blank lines and comments");
    said.help("give a header followed by numbers").kind(RefusalKind::NoRecord)
}

/// A part of a header does not follow the format.
pub(crate) fn header(place: FilePlace, found: String, allowed: &str) -> Refused {
    let read = Refused::at(place).reads(found);
    read.but(", but ", format!("{allowed} should stand there"))
        .help("fetch the file again")
}

/// No line of a header begins with a required key.
pub(crate) fn no_key(key: &str) -> Refused {
    Refused::that(format!("no line of the header begins with {key:?}")).help("fetch the file again")
}

/// A file ends before its required contents.
pub(crate) fn truncated(place: FilePlace, allowed: &'static str) -> Refused {
    let ends = Refused::that_at(place, format!("the file ends at {place}"));
    ends.but(", before ", allowed).help("fetch it again")
}

/// A file does not contain a history of accelerations.
pub(crate) fn not_acceleration(place: FilePlace, found: String, instead: &str) -> Refused {
    let kind = kind_of_quantity(&found);
    let read = Refused::at(place).reads(found).kind(kind);
    read.but(", but ", "only histories of acceleration are read")
        .help(format!("take {instead}"))
}

/// The kind of a refusal of another quantity, by its words.
pub(crate) fn kind_of_quantity(found: &str) -> RefusalKind {
    let words = found.to_ascii_uppercase();
    let is = |start: &str| words.contains(start);
    match (is("ACCEL"), is("VELOC"), is("DISPL")) {
        (false, true, false) => RefusalKind::Velocity,
        (false, false, true) => RefusalKind::Displacement,
        _ => RefusalKind::OtherQuantity,
    }
}

/// A file names a unit that is not a known unit of acceleration.
pub(crate) fn unknown_unit(place: FilePlace, found: String) -> Refused {
    let read = Refused::at(place).reads(found);
    read.and(" and names no unit of an acceleration that is known")
        .but(", such as ", "g, g/10, mg, gal, cm/s/s, mm/s/s or m/s/s")
        .help("if one of them is meant, write it there")
}

/// The time step is not a finite number above zero.
pub(crate) fn time_step(place: FilePlace, found: f64) -> Refused {
    let is = Refused::at(place).is(format!("the time step is {} s", plain(found)));
    is.but(", and must be ", "finite and above 0 s").help("correct it there")
}

/// A file holds more or fewer values than its header declares.
pub(crate) fn sample_count(place: FilePlace, found: usize, allowed: usize) -> Refused {
    let kind = if found < allowed {
        RefusalKind::CutShort
    } else {
        RefusalKind::Wrong
    };
    Refused::that_at(place, format!("the values end at {place} after {found} of them"))
        .kind(kind)
        .but(", but the header declares ", allowed.to_string())
        .help("fetch the file again, or correct the header if the values are complete")
}

/// A field is not a number.
pub(crate) fn not_a_number(line: usize, field: usize, found: String) -> Refused {
    let how = if found.contains("**") {
        "a program writes asterisks for a number that did not fit: fetch the file again, or print it with wider columns"
    } else if found.contains(',') {
        "write a decimal point for the comma, as in -0.00640"
    } else {
        "write it like -0.00640 or -.6403182E-02"
    };
    let at = Refused::at(Spot::Field(line, field)).is("");
    at.quoted(found).and(" is not a number").help(how)
}

/// Numbers above the rows do not belong to them: first and last line, their text, and their likely meaning.
pub(crate) fn header_numbers([first, last]: [usize; 2], found: String, what: &'static str) -> Refused {
    let (reading, them) = if first == last { ("reads ", "it") } else { ("read ", "them") };
    Refused::at(Spot::Lines(first, last))
        .goes_on(reading)
        .quoted(found)
        .and(": ")
        .and(what)
        .and(", unlike the values below")
        .help(format!("delete {them}, or put # before each line"))
}

/// A file contradicts itself about its values: the property, the knob to declare it, and the statements with their places.
pub(crate) fn several(what: &str, knob: Knob, said: impl Iterator<Item = (FilePlace, String)>) -> Refused {
    let said: Vec<_> = said.take(MOST_LISTED).map(|(place, text)| format!("{text} ({place})")).collect();
    let said = Refused::that(format!("the file gives more than one {what}: {}", said.join(", ")));
    said.help("declare the right one as ").and(knob).and(", or correct the file")
}

/// Most components that a message lists.
const MOST_LISTED: usize = 50;

/// Components with their numbers; `components` counts them from 0.
pub(crate) fn listed(components: &[(usize, &str)]) -> String {
    let first = components.iter().take(MOST_LISTED);
    let mut listed: Vec<String> = first.map(|(index, name)| format!("{} = {name:?}", index + 1)).collect();
    if components.len() > MOST_LISTED {
        listed.push("…".to_owned());
    }
    listed.join(", ")
}
