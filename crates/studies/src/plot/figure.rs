//! What a figure shows, as plain data.

use super::Shade;

/// A figure is a stack of panels over one x axis, or a grid of panels.
///
/// Panels fill the rows from left to right, `columns` to a row. A panel without an x axis of its own shares
/// [`Figure::x`]; the numbers of a shared axis are written under the lowest panel only.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Figure {
    /// Height on paper \[inch\].
    pub(crate) height_in: f64,
    /// How many panels stand side by side.
    pub(crate) columns: usize,
    /// The x axis of all panels that have none of their own.
    pub(crate) x: Axis,
    /// The panels, row by row.
    pub(crate) panels: Vec<Panel>,
}

impl Default for Figure {
    fn default() -> Self {
        Self {
            height_in: 4.2,
            columns: 1,
            x: Axis::default(),
            panels: Vec::new(),
        }
    }
}

/// An axis is a label with its unit, and the range shown.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Axis {
    /// Quantity and unit, as in `Time (s)`; may be empty.
    pub(crate) label: String,
    /// Lowest and highest value shown; `None` takes them from the data.
    pub(crate) range: Option<(f64, f64)>,
}

impl Axis {
    /// Returns an axis that takes its range from the data.
    pub(crate) fn auto(label: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            range: None,
        }
    }

    /// Returns an axis that runs between two values.
    pub(crate) fn over(label: impl Into<String>, from: f64, to: f64) -> Self {
        Self {
            label: label.into(),
            range: Some((from, to)),
        }
    }
}

/// A panel is one plot of a figure.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Panel {
    /// Written above, at the left; may be empty.
    pub(crate) title: String,
    /// The x axis, if it is not that of the figure.
    pub(crate) x: Option<Axis>,
    /// The y axis.
    pub(crate) y: Axis,
    /// The curves, from back to front.
    pub(crate) curves: Vec<Curve>,
    /// Values of x marked by thin grey lines through the panel.
    pub(crate) markers: Vec<f64>,
    /// Values of y marked by thin dark lines through the panel.
    pub(crate) levels: Vec<f64>,
    /// Texts beside points.
    pub(crate) notes: Vec<Note>,
    /// Where the labels of the curves are explained.
    pub(crate) legend: Legend,
    /// Height in comparison with the other panels of the column; positive.
    pub(crate) weight: f64,
}

impl Default for Panel {
    fn default() -> Self {
        Self {
            title: String::new(),
            x: None,
            y: Axis::default(),
            curves: Vec::new(),
            markers: Vec::new(),
            levels: Vec::new(),
            notes: Vec::new(),
            legend: Legend::Above,
            weight: 1.0,
        }
    }
}

/// Where the legend of a panel stands. Only curves with a label enter it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Legend {
    /// In rows above the panel, where it hides nothing.
    Above,
    /// Inside, in the corner with the least to hide.
    Inside,
    /// Nowhere.
    Hidden,
}

/// A curve is a list of points and how they are shown.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    /// Name in the legend, if any.
    pub(crate) label: Option<String>,
    /// The points, in the units of the axes; all must be finite.
    pub(crate) points: Vec<(f64, f64)>,
    /// How they are shown.
    pub(crate) kind: Kind,
    /// Colour.
    pub(crate) shade: Shade,
}

impl Curve {
    /// Returns a curve without a name.
    pub(crate) fn new(kind: Kind, shade: Shade, points: Vec<(f64, f64)>) -> Self {
        Self {
            label: None,
            points,
            kind,
            shade,
        }
    }

    /// Returns the curve with a name for the legend.
    #[must_use]
    pub(crate) fn named(self, label: impl Into<String>) -> Self {
        Self {
            label: Some(label.into()),
            ..self
        }
    }
}

/// How the points of a curve are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Joined by a line.
    Line,
    /// Joined by a thin line, for dense records.
    Thin,
    /// Joined by a dashed line.
    Dashed,
    /// Each at the end of a stem from zero.
    Stems,
    /// Joined by a line, and filled down to zero; stretches at zero stay empty.
    Area,
    /// Each by itself; every shade has its own form.
    Points,
}

/// A note is a text beside a point of a panel: to its right, or on the first side where it hides less.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Note {
    /// The point, in the units of the axes.
    pub(crate) at: (f64, f64),
    /// What is written.
    pub(crate) text: String,
}

impl Note {
    /// Returns a note beside a point.
    pub(crate) fn new(at: (f64, f64), text: impl Into<String>) -> Self {
        Self {
            at,
            text: text.into(),
        }
    }
}
