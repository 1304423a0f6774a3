//! CSMIP volume 3: it holds spectra instead of a history, and is refused with advice.

use super::{File, Format, Reader, no_identity, title};
use crate::refusals;
use crate::{FilePlace, Refused};

pub(super) const READER: Reader = Reader {
    format: Format::CsmipV2,
    recognises: |file| {
        let first = file.lines.first();
        first.is_some_and(|line| title::holds(*line, "AMPLITUDE SPECTRA") && title::holds(*line, "RESPONSE"))
    },
    components: refused,
    read: |file, _| refused(file),
    identity: no_identity,
};

fn refused<T>(file: &File<'_>) -> Result<T, Refused> {
    let line = file.lines[0];
    Err(refusals::not_acceleration(
        FilePlace::Line(line.number),
        line.excerpt(),
        "the volume 2 file (.V2) of the record, these are spectra",
    ))
}
