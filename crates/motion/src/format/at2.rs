//! PEER AT2 and similar files: titles, a line with NPTS and DT, then values in columns.

mod header;

use super::{Component, Draft, File, Format, Reader, Scale, Spacing, Stated, reading, values};
use crate::{AccelerationUnit, FilePlace, Refused};

pub(super) const READER: Reader = Reader {
    format: Format::PeerAt2,
    recognises: |file| header::is_at2(&file.lines),
    components: |file| Ok(header::component(&file.lines).into_iter().collect()),
    read: |file, _| read(file),
    identity: |file| header::identity(&file.lines),
};

/// Reads a PEER AT2 file: title lines, a line with NPTS and DT, then acceleration in g.
///
/// The line with NPTS and DT is the last of the first ten lines that names both, in any order and case. Examples are
/// `NPTS=  4000, DT= .01000 SEC` and `4096 0.0100 NPTS, DT`; the poles of filters may follow. Without such a line it is line 4, if this
/// contains a whole number and a time step. A title line must state that the values are acceleration in g; if no line names a unit, the
/// unit must be declared.
///
/// Values are in any number of columns of any width, as written by C or Fortran, and may touch. They end at the end of the file or at a
/// line that does not begin with a number; blank lines are skipped. The first value is at t = 0, because the format has no times: a file
/// without the state of rest is early by a step. The component is the direction after the last comma of PEER's line of earthquake and
/// station, if there is one. The title lines become the provenance.
///
/// # Errors
/// Refuses a file without a readable line of NPTS and DT, and a file of velocities, displacements or other units than g. It also refuses a
/// field that is not a finite number, and more or fewer values than NPTS.
fn read(file: &File<'_>) -> Result<Draft, Refused> {
    let header::Header { titles, line, data } = header::split(&file.lines)?;
    let unit = header::unit(titles)?.or(header::unit(&[line])?);
    let numbers = values::read(line, data)?;
    let mut stated = header::count_and_step(line)?;
    let mut remarks = Vec::new();
    // The NPTS of another record may have stayed in the file. A title with the number of points then decides.
    if stated.count != numbers.values.len()
        && let Some(points) = header::points(titles)
        && points.count == numbers.values.len()
    {
        let found = format!("{:?}, which the values have, and not {:?}", points.line.excerpt(), line.excerpt());
        remarks.push(reading("count", Some(FilePlace::Line(points.line.number)), &found));
        stated = points;
    }
    let of_line = FilePlace::Line(stated.line.number);
    let text = stated.line.excerpt();
    Ok(Draft {
        values: numbers.values,
        end: numbers.end,
        digit: 0.0,
        count: Some(Stated {
            value: stated.count,
            place: of_line,
            text: text.clone(),
        }),
        time_step: Some(Spacing::Even(Stated {
            value: stated.step,
            place: of_line,
            text,
        })),
        scale: unit.map_or(Scale::Unknown, |unit| {
            Scale::Unit(Stated {
                value: AccelerationUnit::StandardGravity,
                place: FilePlace::Line(unit.number),
                text: unit.excerpt(),
            })
        }),
        peak: None,
        provenance: titles
            .iter()
            .map(|line| line.text().trim().to_owned())
            .collect::<Vec<_>>()
            .join("\n"),
        remarks,
    })
}
