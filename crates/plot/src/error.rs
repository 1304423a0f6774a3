//! Errors of pictures.

/// A picture cannot be drawn. Each variant is a fault that its author can correct.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlotError {
    /// A figure has no panel, or no column to put panels in.
    #[error("a figure needs at least one panel and one column")]
    NoPanel,
    /// The paper is too small to hold the panels, or not between 1 mm and 2 m wide and high.
    #[error("{width_mm} mm × {height_mm} mm is no size that the picture fits in: make it larger or show less")]
    Size {
        /// Requested width \[mm\].
        width_mm: f64,
        /// Requested height \[mm\].
        height_mm: f64,
    },
    /// The weights of the panels are not all positive numbers.
    #[error("panel {panel} has weight {weight}: weights must be positive")]
    Weight {
        /// Index of the panel, from 0.
        panel: usize,
        /// The weight found.
        weight: f64,
    },
    /// A point of a curve is not a pair of finite numbers, or not positive along a logarithmic axis.
    #[error("panel {panel}, curve {curve}, point {point} is not finite, or not positive along a logarithmic axis")]
    CurvePoint {
        /// Index of the panel, from 0.
        panel: usize,
        /// Index of the curve in its panel, from 0.
        curve: usize,
        /// Index of the point in its curve, from 0.
        point: usize,
    },
    /// A marker, reference line or note of a panel is at a non-finite number, or at a number ≤ 0 along a logarithmic axis.
    #[error(
        "panel {panel} has a marker, a level or a note at a number that is not finite, or not positive along a \
         logarithmic axis"
    )]
    Mark {
        /// Index of the panel, from 0.
        panel: usize,
    },
    /// An axis cannot span this range. Its ends must be finite, in order, sufficiently different, and positive if the axis is logarithmic.
    #[error("axis `{axis}` cannot run from {from} to {to}")]
    Range {
        /// Label of the axis.
        axis: String,
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// A coordinate of a drawing is not finite or lies far off the paper.
    #[error("shape {shape} of a drawing has a coordinate that is not on the paper")]
    Coordinate {
        /// Index of the shape, from 0.
        shape: usize,
    },
    /// A text holds a character that the bundled font does not have.
    #[error("the bundled font lacks {character:?} in {text:?}: choose another, or add it to the subset")]
    Character {
        /// The character.
        character: char,
        /// The whole text.
        text: String,
    },
    /// A text does not fit on the paper or beside its neighbours.
    #[error("{text:?} does not fit in its place: shorten it or make the picture larger")]
    LongText {
        /// The whole text.
        text: String,
    },
    /// The renderer refused a valid picture: a fault of this crate.
    #[error("the renderer refused the picture at the stage `{stage}`")]
    Renderer {
        /// The failed step of rendering.
        stage: &'static str,
    },
}
