//! Figures of print quality, described as plain data and identical in every run.
//!
//! A [`Figure`] describes the contents: panels with curves, marks, notes, and axes that are linear, logarithmic or of names. A [`Drawing`]
//! gives the position of every line and letter in millimetres; schematic pictures are drawings from the start. Both are a [`Picture`] for
//! [`render_png`] or [`render_both`]. A figure is laid out into a drawing, so that there is only one way to paper.
//!
//! ```
//! use pounding_plot::{Axis, Curve, Figure, CurveKind, Panel, Shade, render_png};
//!
//! // A structure of T = 1.2 s swings freely from 30 mm: u = 30 cos(2πt/T).
//! let swing = |t: f64| (t, 30.0 * (std::f64::consts::TAU * t / 1.2).cos());
//! let curve = Curve::new(CurveKind::Line, Shade::Blue, (0..=240).map(|i| swing(f64::from(i) * 0.01)).collect());
//! let y = Axis::auto("Displacement (mm)");
//! let panels = vec![Panel { y, curves: vec![curve], ..Panel::default() }];
//! let figure = Figure { height_in: 3.0, x: Axis::over("Time (s)", 0.0, 2.4), panels, ..Figure::default() };
//!
//! // The paper is 7 inches wide: 2100 × 900 dots at 300 dots per inch, which a PNG states in its bytes 16 to 23.
//! let png = render_png(&figure)?;
//! let dots = |at: usize| png[at..at + 4].iter().fold(0, |sum, byte| 256 * sum + u32::from(*byte));
//! assert_eq!((dots(16), dots(20)), (2100, 900));
//! # Ok::<(), pounding_plot::PlotError>(())
//! ```
//!
//! Quantities are in the units of their axis: this crate converts nothing and knows no mechanics. The only font is bundled; no font of the
//! machine is read.
//!
//! Not in this crate: second y axes, colour maps, interactivity. `pounding-report` chooses the figures of a run.
//!
//! Where to start: [`Figure`] and [`Panel`], which consist of fields; [`Drawing`] and [`Shape`] for a schematic; [`PlotError`] for all
//! reasons of a refusal.

mod clip;
mod curves;
mod decades;
mod drawing;
mod error;
mod figure;
mod layout;
mod legend;
mod marks;
mod page;
mod panel;
mod raster;
mod ruler;
mod scale;
mod shade;
mod text;
mod ticks;

#[cfg(test)]
mod tests;

use std::borrow::Cow;

pub use drawing::{Align, Drawing, Fill, PaperPoint, Pen, Shape};
pub use error::PlotError;
pub use figure::{Axis, Curve, CurveKind, Figure, Legend, Mark, Note, Panel, Scale, sparse_markers};
pub use shade::Shade;

/// A picture gives the position of each of its lines and letters.
pub trait Picture {
    /// Returns the picture as primitives in millimetres.
    ///
    /// # Errors
    ///
    /// [`PlotError`] if the picture cannot be drawn.
    fn drawing(&self) -> Result<Cow<'_, Drawing>, PlotError>;
}

impl Picture for Drawing {
    fn drawing(&self) -> Result<Cow<'_, Drawing>, PlotError> {
        Ok(Cow::Borrowed(self))
    }
}

impl Picture for Figure {
    fn drawing(&self) -> Result<Cow<'_, Drawing>, PlotError> {
        layout::lay_out(self).map(Cow::Owned)
    }
}

/// Renders a picture as a PNG with 300 dots per inch, eight bits per colour, on white.
///
/// # Errors
///
/// [`PlotError`] if the picture cannot be drawn.
pub fn render_png(picture: &impl Picture) -> Result<Vec<u8>, PlotError> {
    raster::png(&page::svg(&*picture.drawing()?)?)
}

/// Renders a picture as SVG and as the PNG of [`render_png`].
///
/// The letters of the SVG are outlines, so that it looks the same without the font.
///
/// # Errors
///
/// [`PlotError`] if the picture cannot be drawn.
pub fn render_both(picture: &impl Picture) -> Result<(String, Vec<u8>), PlotError> {
    let svg = page::svg(&*picture.drawing()?)?;
    Ok((raster::outlined(&svg)?, raster::png(&svg)?))
}

/// The text with a question mark for each character that the bundled font lacks.
pub fn writable(text: &str) -> String {
    let known = |character| {
        if text::covered(character) { character } else { '?' }
    };
    text.chars().map(known).collect()
}

/// Writes the real minus sign.
pub fn minus(text: &str) -> String {
    text.replace('-', "\u{2212}")
}
