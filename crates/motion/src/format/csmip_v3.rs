//! CSMIP volume 3: spectra and no history, refused with advice.

use super::{File, Format, Reader, no_identity, title};
use crate::{Place, ReadError};

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

fn refused<T>(file: &File<'_>) -> Result<T, ReadError> {
    let line = file.lines[0];
    Err(ReadError::NotAcceleration {
        place: Place::Line(line.number),
        found: line.excerpt(),
        instead: "the volume 2 file (.V2) of the record, these are spectra",
    })
}
