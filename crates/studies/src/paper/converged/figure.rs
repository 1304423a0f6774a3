//! Transferred momenta of Tables 6 and 7 over the exact ones: published, at every time step, and with a little noise.

use super::quantities::{Quantities, find};
use super::{Converged, LEVELS, TIME_STEPS};
use crate::StudyError;
use crate::files::drawn;
use crate::paper::tables::Value;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Mark, Panel, Shade};
use pounding_text::digits;

/// Index of the drawn level of noise, 1 %: the bands of smaller levels are narrower than the marks.
const LEVEL: usize = 4;

/// Marks of the time steps, the coarsest first.
const MARKS: [Mark; TIME_STEPS.len()] = [Mark::HollowSquare, Mark::HollowDiamond, Mark::HollowTriangle, Mark::Ring];

impl Converged {
    /// The figure as PNG.
    ///
    /// # Errors
    /// [`StudyError::Plot`] if the figure cannot be drawn.
    pub(super) fn figure_png(&self, published: &Quantities) -> Result<Vec<u8>, StudyError> {
        let panels = TOTALS.map(|(table, title)| self.panel(table, title, published));
        let x = Axis::auto("Transferred momentum over the exact one");
        drawn(&Figure::grid(5.4, 2, x, panels.into()), super::FIGURE.as_ref())
    }

    fn panel(&self, table: &'static str, title: &str, published: &Quantities) -> Panel {
        // Rows with zero momentum are left out: nothing can be divided by them.
        let rows = self.exact.get(table).into_iter().flatten().filter(|row| row.value > 0.0);
        let over = Over::new(table, rows.map(|row| (row, row.value)));
        let bar = |(y, (row, value)): (usize, &(&Value, f64))| {
            let (low, high) = self.band(LEVEL, table, row)?;
            Some((low / value, high / value, y as f64))
        };
        let bars: Vec<_> = over.rows.iter().enumerate().filter_map(bar).collect();
        let noise = format!("Exact, noise of {} %: 5 to 95 %", digits(100.0 * LEVELS[LEVEL]));
        let mut curves = vec![Curve::bars(Shade::Grey, &bars).named(noise)];
        for ((values, step), mark) in self.finer.iter().zip(TIME_STEPS).zip(MARKS) {
            curves.push(over.curve(values, Shade::Blue, mark, &format!("Δt = {} ms", digits(1e3 * step))));
        }
        curves.push(over.curve(published, Shade::Vermilion, Mark::Cross, "Published"));
        curves.push(over.curve(&self.exact, Shade::Ink, Mark::Stroke, "Exact"));
        over.panel(title, curves)
    }
}

/// Tables of totals, a panel each.
pub(crate) const TOTALS: [(&str, &str); 2] = [("6", "Table 6, stereomechanical impact"), ("7", "Table 7, viscoelastic element")];

/// Rows of a table, each one line of a panel, with the numbers that divide theirs.
pub(crate) struct Over<'a> {
    table: &'static str,
    rows: Vec<(&'a Value, f64)>,
}

impl<'a> Over<'a> {
    pub(crate) fn new(table: &'static str, rows: impl Iterator<Item = (&'a Value, f64)>) -> Self {
        Self {
            table,
            rows: rows.collect(),
        }
    }

    /// The quotients of all rows as marks.
    pub(crate) fn curve(&self, values: &Quantities, shade: Shade, mark: Mark, name: &str) -> Curve {
        let point = |(y, (row, over)): (usize, &(&Value, f64))| Some((find(values, self.table, row)? / over, y as f64));
        let points = self.rows.iter().enumerate().filter_map(point);
        Curve::new(CurveKind::Points, shade, points.collect()).marked(mark).named(name)
    }

    /// A panel with one line per row.
    pub(crate) fn panel(&self, title: &str, curves: Vec<Curve>) -> Panel {
        let names = self.rows.iter().map(|(row, _)| row.row.replace("layout ", ""));
        Panel::shared(title, Axis::names(names.collect()), curves)
    }
}
