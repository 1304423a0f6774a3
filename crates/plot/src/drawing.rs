//! Primitives in millimetres.

use super::Shade;

/// A point is x to the right and y upwards, from the lower left corner of the paper \[mm\].
pub type PaperPoint = (f64, f64);

/// A drawing is a sheet of paper with shapes on it, the later ones over the earlier.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// Width of the paper \[mm\].
    pub width: f64,
    /// Height of the paper \[mm\].
    pub height: f64,
    /// The shapes, from back to front.
    pub shapes: Vec<Shape>,
}

/// A pen is the appearance of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    /// Colour.
    pub shade: Shade,
    /// Width of the line in points (1/72 inch).
    pub points: f64,
    /// Whether the line is broken into dashes.
    pub dashed: bool,
}

impl Pen {
    /// Returns the pen of an unbroken line with this width in points.
    pub const fn solid(shade: Shade, points: f64) -> Self {
        Self {
            shade,
            points,
            dashed: false,
        }
    }

    /// Returns the pen of a dashed line with this width in points.
    pub const fn dashed(shade: Shade, points: f64) -> Self {
        Self {
            shade,
            points,
            dashed: true,
        }
    }
}

/// A fill is the appearance of the inside of a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fill {
    /// Colour.
    pub shade: Shade,
    /// Opacity, 0 to 1.
    pub opacity: f64,
}

impl Fill {
    /// Returns an opaque fill.
    pub const fn solid(shade: Shade) -> Self {
        Self { shade, opacity: 1.0 }
    }
}

/// The part of a text that is at its point, along the line of writing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Align {
    /// The first letter.
    Start,
    /// The middle.
    Middle,
    /// The last letter.
    End,
}

/// A shape is an element on the paper. Lengths are in millimetres.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A rectangle, filled or outlined or both.
    Rectangle {
        /// Lower left corner.
        corner: PaperPoint,
        /// Width and height.
        size: PaperPoint,
        /// Inside, if any.
        fill: Option<Fill>,
        /// Outline, if any.
        outline: Option<Pen>,
    },
    /// A disc, filled or outlined or both.
    Circle {
        /// Centre.
        centre: PaperPoint,
        /// Radius.
        radius: f64,
        /// Inside, if any.
        fill: Option<Fill>,
        /// Outline, if any; never dashed.
        outline: Option<Pen>,
    },
    /// A filled polygon.
    Polygon {
        /// Corners in order; the last is joined to the first.
        corners: Vec<PaperPoint>,
        /// Inside.
        fill: Fill,
        /// Outline, if any.
        outline: Option<Pen>,
    },
    /// A line through two or more points.
    Line {
        /// The points in order.
        points: Vec<PaperPoint>,
        /// Appearance of the line.
        pen: Pen,
    },
    /// A straight line with a head at both ends, as in a dimension.
    Arrow {
        /// One end.
        from: PaperPoint,
        /// The other end.
        to: PaperPoint,
        /// Appearance of the shaft; the heads have the same colour.
        pen: Pen,
    },
    /// A line of text; the middle of its capital letters is at the height of `at`.
    Text {
        /// Position.
        at: PaperPoint,
        /// The text.
        text: String,
        /// Size in points.
        points: f64,
        /// Part of the text that is at `at`.
        align: Align,
        /// Whether it is written upwards.
        upright: bool,
        /// Colour.
        shade: Shade,
    },
}

impl Shape {
    /// Returns a straight line.
    pub fn line(from: PaperPoint, to: PaperPoint, pen: Pen) -> Self {
        Self::Line {
            points: vec![from, to],
            pen,
        }
    }

    /// Returns a filled rectangle without outline.
    pub fn filled(corner: PaperPoint, size: PaperPoint, fill: Fill) -> Self {
        Self::Rectangle {
            corner,
            size,
            fill: Some(fill),
            outline: None,
        }
    }

    /// Returns the outline of a rectangle.
    pub fn outlined(corner: PaperPoint, size: PaperPoint, pen: Pen) -> Self {
        Self::Rectangle {
            corner,
            size,
            fill: None,
            outline: Some(pen),
        }
    }

    /// Returns a filled rectangle with an outline.
    pub fn boxed(corner: PaperPoint, size: PaperPoint, fill: Fill, pen: Pen) -> Self {
        Self::Rectangle {
            corner,
            size,
            fill: Some(fill),
            outline: Some(pen),
        }
    }

    /// Returns a text in ink, written upwards.
    pub fn upright(at: PaperPoint, text: impl Into<String>, points: f64, align: Align) -> Self {
        Self::Text {
            at,
            text: text.into(),
            points,
            align,
            upright: true,
            shade: Shade::Ink,
        }
    }

    /// Returns a text in ink, written to the right.
    pub fn text(at: PaperPoint, text: impl Into<String>, points: f64, align: Align) -> Self {
        Self::Text {
            at,
            text: text.into(),
            points,
            align,
            upright: false,
            shade: Shade::Ink,
        }
    }
}
