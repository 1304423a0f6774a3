//! From millimetres to SVG, by plotters.
//!
//! Plotters counts in whole units, so the canvas is large: a hundred units to the millimetre.
//! Nothing outside this file and `text.rs` knows plotters.
//!
//! The bitmap backend and the charts of plotters are not used: they have whole pixels and bad letter spacing.

use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontTransform, RGBAColor, RGBColor, ShapeStyle, TextStyle};

use super::text::{CAPITAL, FAMILY, MM_PER_POINT};
use super::{Align, Drawing, Fill, PaperPoint, Pen, PlotError, Shade, Shape, text};

/// Units of the canvas in a millimetre.
const UNITS: f64 = 100.0;

/// Plotters divides the size of text by this number.
const TEXT_SIZE: f64 = 1.24;

/// Plotters puts the middle of text this far above its baseline, as a part of the size.
const MIDDLE: f64 = 0.25;

/// Length and half width of the head of an arrow, in widths of the line.
const HEAD: (f64, f64) = (7.0, 2.6);

/// Length of a dash and of the space after it, in widths of the line. Plotters does not split lines of an SVG into dashes.
const DASH: (f64, f64) = (4.0, 2.4);

/// Draws a picture as an SVG whose letters need the bundled font.
pub(super) fn svg(drawing: &Drawing) -> Result<String, PlotError> {
    text::check(drawing)?;
    unchecked(drawing)
}

/// Draws a picture with any characters.
pub(super) fn unchecked(drawing: &Drawing) -> Result<String, PlotError> {
    let (width_mm, height_mm) = (drawing.width, drawing.height);
    let sound = |length: f64| (1.0..=2000.0).contains(&length);
    if !(sound(width_mm) && sound(height_mm)) {
        return Err(PlotError::Size { width_mm, height_mm });
    }
    let mut written = String::new();
    let canvas = SVGBackend::with_string(&mut written, (size(width_mm), size(height_mm)));
    let mut page = Page { canvas, height: height_mm };
    page.rectangle((0.0, 0.0), (width_mm, height_mm), Fill::solid(Shade::White))?;
    for (index, shape) in drawing.shapes.iter().enumerate() {
        if !on_paper(drawing, shape) {
            return Err(PlotError::Coordinate { shape: index });
        }
        page.shape(shape)?;
    }
    page.canvas.present().map_err(|_| REFUSED)?;
    drop(page);
    Ok(with_header(&written, drawing))
}

/// The error of a canvas in memory, which cannot occur.
const REFUSED: PlotError = PlotError::Renderer { stage: "SVG" };

/// Sets the size of the large canvas on paper; lines meet in round corners, so that spikes stay spikes.
fn with_header(written: &str, drawing: &Drawing) -> String {
    let body = written.split_once('>').map_or("", |(_, body)| body);
    let (width, height) = (drawing.width, drawing.height);
    let (columns, rows) = (size(width), size(height));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" \
         viewBox=\"0 0 {columns} {rows}\" stroke-linejoin=\"round\" font-family=\"{FAMILY}\">{body}"
    )
}

/// Whether all of a shape is at finite positions on the paper or close to it.
fn on_paper(drawing: &Drawing, shape: &Shape) -> bool {
    let reach = 10.0 * drawing.width.max(drawing.height);
    let near = |&(x, y): &PaperPoint| x.abs() <= reach && y.abs() <= reach;
    match shape {
        Shape::Rectangle { corner, size, .. } => near(corner) && near(size),
        Shape::Circle { centre, radius, .. } => near(centre) && near(&(*radius, 0.0)),
        Shape::Polygon { corners: points, .. } | Shape::Line { points, .. } => points.iter().all(near),
        Shape::Arrow { from, to, .. } => near(from) && near(to),
        Shape::Text { at, .. } => near(at),
    }
}

/// Returns a length in units, at least one.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "lengths are below 1e5 mm")]
fn size(length: f64) -> u32 {
    (length * UNITS).round().max(1.0) as u32
}

/// Returns a colour for plotters.
fn colour(shade: Shade, opacity: f64) -> RGBAColor {
    let (red, green, blue) = shade.rgb();
    RGBColor(red, green, blue).mix(opacity)
}

/// Returns the look of a line for plotters.
fn stroke(pen: Pen) -> ShapeStyle {
    ShapeStyle {
        color: colour(pen.shade, 1.0),
        filled: false,
        stroke_width: size(pen.points * MM_PER_POINT),
    }
}

/// Returns the look of an inside for plotters.
fn inside(fill: Fill) -> ShapeStyle {
    ShapeStyle {
        color: colour(fill.shade, fill.opacity),
        filled: true,
        stroke_width: 0,
    }
}

/// A page is a canvas that takes millimetres and counts upwards.
struct Page<'a> {
    canvas: SVGBackend<'a>,
    height: f64,
}

impl Page<'_> {
    fn shape(&mut self, shape: &Shape) -> Result<(), PlotError> {
        match shape {
            Shape::Rectangle {
                corner,
                size,
                fill,
                outline,
            } => {
                if let Some(fill) = *fill {
                    self.rectangle(*corner, *size, fill)?;
                }
                let Some(pen) = *outline else { return Ok(()) };
                let ((x, y), (width, height)) = (*corner, *size);
                let (right, top) = (x + width, y + height);
                self.outline(&[(x, y), (right, y), (right, top), (x, top)], pen)
            }
            Shape::Circle {
                centre,
                radius,
                fill,
                outline,
            } => self.circle(*centre, *radius, *fill, *outline),
            Shape::Polygon { corners, fill, outline } => {
                self.polygon(corners, *fill)?;
                outline.map_or(Ok(()), |pen| self.outline(corners, pen))
            }
            Shape::Line { points, pen } => self.line(points, *pen),
            Shape::Arrow { from, to, pen } => self.arrow(*from, *to, *pen),
            Shape::Text { .. } => self.text(shape),
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "`on_paper` bounds coordinates to 2e6 units")]
    fn unit(&self, (x, y): PaperPoint) -> (i32, i32) {
        ((x * UNITS).round() as i32, ((self.height - y) * UNITS).round() as i32)
    }

    fn units(&self, points: &[PaperPoint]) -> Vec<(i32, i32)> {
        let mut units: Vec<_> = points.iter().map(|&point| self.unit(point)).collect();
        units.dedup();
        units
    }

    fn rectangle(&mut self, (x, y): PaperPoint, (width, height): PaperPoint, fill: Fill) -> Result<(), PlotError> {
        let (upper_left, lower_right) = (self.unit((x, y + height)), self.unit((x + width, y)));
        self.canvas
            .draw_rect(upper_left, lower_right, &inside(fill), true)
            .map_err(|_| REFUSED)
    }

    fn circle(&mut self, centre: PaperPoint, radius: f64, fill: Option<Fill>, outline: Option<Pen>) -> Result<(), PlotError> {
        let centre = self.unit(centre);
        if let Some(fill) = fill {
            self.canvas
                .draw_circle(centre, size(radius), &inside(fill), true)
                .map_err(|_| REFUSED)?;
        }
        let Some(pen) = outline else { return Ok(()) };
        self.canvas
            .draw_circle(centre, size(radius), &stroke(pen), false)
            .map_err(|_| REFUSED)
    }

    fn polygon(&mut self, corners: &[PaperPoint], fill: Fill) -> Result<(), PlotError> {
        let corners = self.units(corners);
        self.canvas.fill_polygon(corners, &inside(fill)).map_err(|_| REFUSED)
    }

    /// Draws a line around corners, and on to the second corner, so that it closes with a corner.
    fn outline(&mut self, corners: &[PaperPoint], pen: Pen) -> Result<(), PlotError> {
        let points = corners.iter().chain(corners.iter().take(2));
        self.line(&points.copied().collect::<Vec<_>>(), pen)
    }

    fn line(&mut self, points: &[PaperPoint], pen: Pen) -> Result<(), PlotError> {
        let pieces = if pen.dashed {
            dashes(points, pen.points * MM_PER_POINT)
        } else {
            vec![points.to_vec()]
        };
        for piece in pieces {
            let units = self.units(&piece);
            if units.len() > 1 {
                self.canvas.draw_path(units, &stroke(pen)).map_err(|_| REFUSED)?;
            }
        }
        Ok(())
    }

    fn arrow(&mut self, from: PaperPoint, to: PaperPoint, pen: Pen) -> Result<(), PlotError> {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = (dx * dx + dy * dy).sqrt();
        if length == 0.0 {
            return Ok(());
        }
        let end = self.head(to, (dx / length, dy / length), pen)?;
        let start = self.head(from, (-dx / length, -dy / length), pen)?;
        self.line(&[start, end], pen)
    }

    /// Draws a head in a direction of length 1; returns the end of its shaft.
    fn head(&mut self, tip: PaperPoint, (dx, dy): PaperPoint, pen: Pen) -> Result<PaperPoint, PlotError> {
        let width = pen.points * MM_PER_POINT;
        let (long, wide) = (HEAD.0 * width, HEAD.1 * width);
        let neck = (tip.0 - long * dx, tip.1 - long * dy);
        let sides = [(neck.0 - wide * dy, neck.1 + wide * dx), (neck.0 + wide * dy, neck.1 - wide * dx)];
        self.polygon(&[tip, sides[0], sides[1]], Fill::solid(pen.shade))?;
        // The shaft ends inside the head; otherwise its square end would blunt the tip.
        Ok((tip.0 - 0.8 * long * dx, tip.1 - 0.8 * long * dy))
    }

    fn text(&mut self, shape: &Shape) -> Result<(), PlotError> {
        let Shape::Text {
            at,
            text,
            points,
            align,
            upright,
            shade,
        } = shape
        else {
            return Ok(());
        };
        let em = points * MM_PER_POINT;
        // From the middle of a plotters text down to the middle of its capital letters.
        let drop = (CAPITAL / 2.0 - MIDDLE) * em;
        let (at, turn) = if *upright {
            ((at.0 + drop, at.1), FontTransform::Rotate270)
        } else {
            ((at.0, at.1 - drop), FontTransform::None)
        };
        let across = match align {
            Align::Start => HPos::Left,
            Align::Middle => HPos::Center,
            Align::End => HPos::Right,
        };
        let font = text::font(em * UNITS * TEXT_SIZE).transform(turn);
        let ink = colour(*shade, 1.0);
        let style = TextStyle::from(font).color(&ink).pos(Pos::new(across, VPos::Center));
        self.canvas.draw_text(text, &style, self.unit(at)).map_err(|_| REFUSED)
    }
}

/// Cuts a line into dashes; `width` is that of the line \[mm\].
fn dashes(points: &[PaperPoint], width: f64) -> Vec<Vec<PaperPoint>> {
    let lengths = [DASH.0 * width, DASH.1 * width];
    let mut dashes: Vec<Vec<PaperPoint>> = Vec::new();
    let (mut phase, mut left) = (0, lengths[0]);
    let mut dash: Vec<PaperPoint> = points.first().copied().into_iter().collect();
    for pair in points.windows(2) {
        let (mut from, to) = (pair[0], pair[1]);
        loop {
            let (dx, dy) = (to.0 - from.0, to.1 - from.1);
            let length = (dx * dx + dy * dy).sqrt();
            if length <= left {
                left -= length;
                break;
            }
            from = (from.0 + dx * left / length, from.1 + dy * left / length);
            if phase == 0 {
                dash.push(from);
                dashes.push(std::mem::take(&mut dash));
            } else {
                dash = vec![from];
            }
            phase = 1 - phase;
            left = lengths[phase];
        }
        if phase == 0 {
            dash.push(to);
        }
    }
    dashes.push(dash);
    dashes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extreme_drawings_are_refused() {
        let far = Shape::line((0.0, 0.0), (f64::NAN, 1.0), Pen::solid(Shade::Ink, 1.0));
        let sheet = |width, shapes| Drawing {
            width,
            height: 10.0,
            shapes,
        };
        assert_eq!(svg(&sheet(10.0, vec![far])), Err(PlotError::Coordinate { shape: 0 }));
        assert_eq!(
            svg(&sheet(0.0, vec![])),
            Err(PlotError::Size {
                width_mm: 0.0,
                height_mm: 10.0
            })
        );
    }

    #[test]
    fn limit_an_arrow_without_length_draws_nothing() {
        let arrow = Shape::Arrow {
            from: (1.0, 1.0),
            to: (1.0, 1.0),
            pen: Pen::solid(Shade::Ink, 1.0),
        };
        let blank = Drawing {
            width: 10.0,
            height: 10.0,
            shapes: vec![],
        };
        assert_eq!(
            svg(&Drawing {
                shapes: vec![arrow],
                ..blank.clone()
            }),
            svg(&blank)
        );
    }

    #[test]
    fn reference_dashes_follow_the_line() {
        let dashes = dashes(&[(0.0, 0.0), (3.0, 0.0), (3.0, 7.0)], 1.0);
        let expected = [vec![(0.0, 0.0), (3.0, 0.0), (3.0, 1.0)], vec![(3.0, 3.4), (3.0, 7.0)]];
        assert_eq!(dashes, expected);
    }
}
