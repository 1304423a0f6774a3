//! PEER AT2 and what goes by that name: titles, a line with NPTS and DT, then values in columns.

mod header;
mod values;

use crate::line::lines;
use crate::{AccelerationUnit, Accelerogram, ReadError};
pub(crate) use header::is_at2;

/// Reads a PEER AT2 file: title lines, a line with NPTS and DT, then acceleration in g.
///
/// The line with NPTS and DT is the last among the first ten that names both, in any order and
/// case, such as `NPTS=  4000, DT= .01000 SEC` or `4096 0.0100 NPTS, DT`; without any, line 4 if it
/// is a whole number and a time step. A title line must say that the values are acceleration in g.
/// Values stand in any number of columns of any width, as C or Fortran writes them, and may touch.
/// They end at the end of the file or at a line that does not begin with a number; blank lines are
/// skipped. The first value is at t = 0, since the format has no times: a file that leaves out the
/// state of rest is early by one step. The title lines become the provenance.
///
/// # Errors
/// Refuses a file without a readable line of NPTS and DT, velocity and displacement, other units
/// than g or none, a field that is not a finite number, and more or fewer values than NPTS.
pub fn read_at2(text: &[u8]) -> Result<Accelerogram, ReadError> {
    let lines = lines(text);
    if lines.iter().all(|line| line.is_blank()) {
        return Err(ReadError::Empty);
    }
    let (titles, count, data) = header::split(&lines)?;
    header::check_quantity(titles, count)?;
    let (n_samples, time_step) = header::count_and_step(count)?;
    let (values, last_line) = values::read(count, data)?;
    if values.len() != n_samples {
        return Err(ReadError::SampleCount {
            line: last_line,
            found: values.len(),
            allowed: n_samples,
        });
    }
    let titles: Vec<String> = titles
        .iter()
        .map(|line| line.text().trim().to_owned())
        .collect();
    Ok(Accelerogram {
        time_step,
        values,
        unit: AccelerationUnit::StandardGravity,
        provenance: titles.join("\n"),
    })
}
