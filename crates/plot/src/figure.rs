//! The contents of a figure, as plain data.

use super::Shade;

/// A figure is a stack of panels over a common x axis, or a grid of panels.
///
/// Panels fill the rows from left to right, `columns` per row. A panel without a separate x axis shares [`Figure::x`]; the numbers of a
/// shared axis are below the lowest panel only. A panel whose y axis has no label and equals that of its left neighbour shares it in the
/// same way.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Height on paper \[inch\].
    pub height_in: f64,
    /// Number of panels per row.
    pub columns: usize,
    /// The x axis of all panels without a separate x axis.
    pub x: Axis,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
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

impl Figure {
    /// Returns a grid of panels, `columns` to a row, over one x axis.
    pub fn grid(height_in: f64, columns: usize, x: Axis, panels: Vec<Panel>) -> Self {
        Self {
            height_in,
            columns,
            x,
            panels,
        }
    }

    /// Returns the figure with labels of y axes in its first column alone.
    #[must_use]
    pub fn labelled_at_left(mut self) -> Self {
        for (index, panel) in self.panels.iter_mut().enumerate() {
            if index % self.columns > 0 {
                panel.y.label.clear();
            }
        }
        self
    }
}

/// An axis has a label with its unit, a range, and a scale.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Axis {
    /// Quantity and unit, as in `Time (s)`; may be empty.
    pub label: String,
    /// Lowest and highest value; `None` takes them from the data.
    pub range: Option<(f64, f64)>,
    /// Mapping from values to the length of the axis.
    pub scale: Scale,
}

impl Axis {
    /// Returns an axis that takes its range from the data.
    pub fn auto(label: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            ..Self::default()
        }
    }

    /// Returns an axis that runs between two values.
    pub fn over(label: impl Into<String>, from: f64, to: f64) -> Self {
        Self {
            range: Some((from, to)),
            ..Self::auto(label)
        }
    }

    /// Returns an axis of names; values count them from 0.
    pub fn names(names: Vec<String>) -> Self {
        Self {
            scale: Scale::Names(names),
            ..Self::default()
        }
    }

    /// Returns the axis with equal lengths for equal ratios.
    #[must_use]
    pub fn log(self) -> Self {
        Self { scale: Scale::Log, ..self }
    }
}

/// Mapping from values to the length of an axis.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Scale {
    /// Equal differences take equal lengths.
    #[default]
    Linear,
    /// Equal ratios take equal lengths; every value must be positive.
    Log,
    /// Names at 0, 1, 2 and so on, from the left or from the top; all are shown, whatever the requested range.
    Names(Vec<String>),
}

/// A panel is a single plot of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Title above the panel, at the left; may be empty.
    pub title: String,
    /// The x axis, if it is not that of the figure.
    pub x: Option<Axis>,
    /// The y axis.
    pub y: Axis,
    /// The curves, from back to front.
    pub curves: Vec<Curve>,
    /// Values of x marked by thin grey lines through the panel.
    pub markers: Vec<f64>,
    /// Values of y marked by thin dark lines through the panel.
    pub levels: Vec<f64>,
    /// Texts next to points.
    pub notes: Vec<Note>,
    /// Place of the legend of its curves.
    pub legend: Legend,
    /// Height relative to the other panels of the column; positive.
    pub weight: f64,
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

impl Panel {
    /// Returns a panel of curves over a y axis, whose legend stands above all panels together with that of the others.
    pub fn shared(title: impl Into<String>, y: Axis, curves: Vec<Curve>) -> Self {
        Self {
            title: title.into(),
            y,
            curves,
            legend: Legend::Shared,
            ..Self::default()
        }
    }

    /// Returns the panel with a line at a value of y.
    #[must_use]
    pub fn with_level(mut self, level: f64) -> Self {
        self.levels.push(level);
        self
    }
}

/// Place of the legend of a panel. Only curves with a label enter it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Legend {
    /// In rows above the panel, where it hides nothing.
    Above,
    /// Inside, in the corner where it hides least.
    Inside,
    /// Above all panels, together with other panels that choose this; equal labels appear once.
    Shared,
    /// No legend.
    Hidden,
}

/// A curve is a list of points and their appearance.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Name in the legend, if any.
    pub label: Option<String>,
    /// The points, in the units of the axes; all must be finite, and positive on a logarithmic axis.
    pub points: Vec<(f64, f64)>,
    /// Appearance of the points.
    pub kind: CurveKind,
    /// Colour.
    pub shade: Shade,
    /// Mark at every point. `None` is no mark for lines; for [`CurveKind::Points`] and [`CurveKind::Stems`] it is the mark of the shade.
    pub mark: Option<Mark>,
}

impl Curve {
    /// Returns a curve without a name.
    pub fn new(kind: CurveKind, shade: Shade, points: Vec<(f64, f64)>) -> Self {
        Self {
            label: None,
            points,
            kind,
            shade,
            mark: None,
        }
    }

    /// Returns horizontal bars, each from one value of x to another at a value of y: `(from, to, y)`.
    pub fn bars(shade: Shade, bars: &[(f64, f64, f64)]) -> Self {
        let ends = |&(from, to, y): &(f64, f64, f64)| [(from, y), (to, y)];
        Self::new(CurveKind::Bars, shade, bars.iter().flat_map(ends).collect())
    }

    /// Returns the curve with a name for the legend.
    #[must_use]
    pub fn named(self, label: impl Into<String>) -> Self {
        Self {
            label: Some(label.into()),
            ..self
        }
    }

    /// Returns the curve with a mark at every point.
    #[must_use]
    pub fn marked(self, mark: Mark) -> Self {
        Self { mark: Some(mark), ..self }
    }
}

/// Appearance of the points of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CurveKind {
    /// Joined by a line.
    Line,
    /// Joined by a thin line, for dense records.
    Thin,
    /// Joined by a dashed line.
    Dashed,
    /// Each at the end of a stem from zero, or from the lower end of a logarithmic axis.
    Stems,
    /// Joined by a line, and filled down to zero; stretches at zero stay empty.
    Area,
    /// Separate points.
    Points,
    /// Pairs of points are the ends of broad horizontal bars; see [`Curve::bars`].
    Bars,
}

/// Mark at a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A filled circle.
    Disc,
    /// A filled square.
    Square,
    /// A filled triangle that points upwards.
    Triangle,
    /// A filled triangle that points downwards.
    Inverted,
    /// A filled square on its corner.
    Diamond,
    /// An empty circle.
    Ring,
    /// An empty square.
    HollowSquare,
    /// An empty triangle that points upwards.
    HollowTriangle,
    /// An empty square on its corner.
    HollowDiamond,
    /// Two strokes that cross, ×.
    Cross,
    /// An upright stroke.
    Stroke,
}

/// A note is a text next to a point of a panel: to its right, or on the first side where it hides less.
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    /// The point, in the units of the axes.
    pub at: (f64, f64),
    /// The text.
    pub text: String,
}

impl Note {
    /// Returns a note next to a point.
    pub fn new(at: (f64, f64), text: impl Into<String>) -> Self {
        Self { at, text: text.into() }
    }
}

/// Most marker lines in a panel: more would hide its curves.
const MOST_MARKERS: usize = 60;
/// Impacts closer than this share a line \[s\].
const SAME_MEETING: f64 = 0.04;

/// Places of lines through panels that mark impacts starting at these instants \[s\]; empty if there are too many.
pub fn sparse_markers(mut starts: Vec<f64>) -> Vec<f64> {
    starts.sort_by(f64::total_cmp);
    starts.dedup_by(|later, earlier| *later - *earlier < SAME_MEETING);
    if starts.len() > MOST_MARKERS {
        starts.clear();
    }
    starts
}
