//! Transferred momenta of Tables 6 and 7 over the exact ones: published, at every time step, and with a little noise.

use super::quantities::{Quantities, find};
use super::{Converged, LEVELS, TIME_STEPS};
use crate::StudyError;
use crate::paper::tables::Value;
use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Mark, Panel, Shade, render_png};
use pounding_text::digits;

/// Which of the levels of noise is drawn: 1 %, as the bands of the smaller ones are narrower than the marks.
const LEVEL: usize = 4;

/// Marks of the time steps, the coarsest first.
const MARKS: [Mark; TIME_STEPS.len()] = [Mark::HollowSquare, Mark::HollowDiamond, Mark::HollowTriangle, Mark::Ring];

impl Converged {
    /// The figure as PNG.
    ///
    /// # Errors
    /// [`StudyError::Plot`] when it cannot be drawn.
    pub(super) fn figure_png(&self, published: &Quantities) -> Result<Vec<u8>, StudyError> {
        let panels = [("6", "Table 6, stereomechanical impact"), ("7", "Table 7, viscoelastic element")];
        let figure = Figure {
            height_in: 5.4,
            columns: 2,
            x: Axis::auto("Transferred momentum over the exact one"),
            panels: panels.map(|(table, title)| self.panel(table, title, published)).into(),
        };
        render_png(&figure).map_err(|source| StudyError::Plot {
            path: super::FIGURE.into(),
            source,
        })
    }

    fn panel(&self, table: &str, title: &str, published: &Quantities) -> Panel {
        // Nothing is a multiple of what structures transfer that nothing touches.
        let rows = self.exact.get(table).into_iter().flatten().filter(|row| row.value > 0.0);
        let rows: Vec<&Value> = rows.collect();
        let points = |values: &Quantities| -> Vec<(f64, f64)> {
            let of_row = |(y, row): (usize, &&Value)| Some((find(values, table, row)? / row.value, y as f64));
            rows.iter().enumerate().filter_map(of_row).collect()
        };
        let bars: Vec<_> = rows
            .iter()
            .enumerate()
            .filter_map(|(y, row)| {
                let (low, high) = self.band(LEVEL, table, row)?;
                Some((low / row.value, high / row.value, y as f64))
            })
            .collect();
        let mut curves =
            vec![Curve::bars(Shade::Grey, &bars).named(format!("Exact, noise of {} %: 5 to 95 %", digits(100.0 * LEVELS[LEVEL])))];
        for ((values, step), mark) in self.finer.iter().zip(TIME_STEPS).zip(MARKS) {
            curves.push(
                Curve::new(Kind::Points, Shade::Blue, points(values))
                    .marked(mark)
                    .named(format!("Δt = {} ms", digits(1e3 * step))),
            );
        }
        curves.push(
            Curve::new(Kind::Points, Shade::Vermilion, points(published))
                .marked(Mark::Cross)
                .named("Published"),
        );
        curves.push(
            Curve::new(Kind::Points, Shade::Ink, points(&self.exact))
                .marked(Mark::Stroke)
                .named("Exact"),
        );
        Panel {
            title: title.into(),
            y: Axis::names(rows.iter().map(|row| row.row.replace("layout ", "")).collect()),
            curves,
            legend: Legend::Shared,
            ..Panel::default()
        }
    }
}
