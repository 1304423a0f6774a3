//! Which format a text is in.

use crate::line::lines;
use crate::{Accelerogram, ReadError, at2, read_at2, read_csv};

/// Reads the text of a file in any format known, recognised by its content and not by a file name.
///
/// The formats are two-column CSV, see [`read_csv`], and PEER AT2, see [`read_at2`]. The text may
/// hold any bytes; those that are not UTF-8 are replaced in titles and refused in numbers.
///
/// # Errors
/// Says which line, what was found there and what is allowed; see [`ReadError`].
pub fn read(text: &[u8]) -> Result<Accelerogram, ReadError> {
    let lines = lines(text);
    if at2::is_at2(&lines) {
        return read_at2(text);
    }
    let first = lines
        .iter()
        .find(|line| !line.is_blank() && !line.is_comment())
        .ok_or(ReadError::Empty)?;
    // Two words and a comma are enough: a CSV without its header is told what the header must be, and
    // not that it is unknown. Titles of other formats have commas too, but more words.
    let fields: Vec<&[u8]> = first.bytes.split(|byte| *byte == b',').collect();
    let is_word = |field: &&[u8]| !field.trim_ascii().contains(&b' ');
    if fields.len() == 2 && fields.iter().all(is_word) {
        return read_csv(text);
    }
    Err(ReadError::UnknownFormat {
        line: first.number,
        found: first.excerpt(),
    })
}
