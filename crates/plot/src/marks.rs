//! Marks at points.

use super::{Fill, Mark, PaperPoint, Pen, Shade, Shape};

/// Half the size of a mark \[mm\].
pub(super) const SIZE: f64 = 0.75;

/// Width of the strokes of marks in points.
const STROKE: f64 = 0.9;

/// Height of an upright stroke and of a bar \[mm\].
pub(super) const TALL: f64 = 3.2;

impl Mark {
    /// Returns the default mark of a shade, which distinguishes points even in grey.
    pub(super) fn of(shade: Shade) -> Self {
        match shade {
            Shade::Vermilion => Self::Square,
            Shade::Ink => Self::Triangle,
            Shade::Green => Self::Diamond,
            Shade::Amber | Shade::Rose => Self::Inverted,
            Shade::Blue | Shade::Grey | Shade::Silver | Shade::Mist | Shade::White => Self::Disc,
        }
    }

    /// Tells whether only the outline is drawn.
    fn is_hollow(self) -> bool {
        match self {
            Self::Ring | Self::HollowSquare | Self::HollowTriangle | Self::HollowDiamond => true,
            Self::Disc | Self::Square | Self::Triangle | Self::Inverted | Self::Diamond | Self::Cross | Self::Stroke => false,
        }
    }
}

/// Draws a mark; a hollow one hides the line that runs through it.
pub(super) fn shapes(mark: Mark, centre: PaperPoint, shade: Shade) -> Vec<Shape> {
    let pen = Pen::solid(shade, STROKE);
    let (fill, outline) = if mark.is_hollow() {
        (Shade::White, Some(pen))
    } else {
        (shade, None)
    };
    let fill = Fill::solid(fill);
    let place = |&(x, y): &PaperPoint| (centre.0 + SIZE * x, centre.1 + SIZE * y);
    let polygon = |corners: &[PaperPoint]| {
        vec![Shape::Polygon {
            corners: corners.iter().map(place).collect(),
            fill,
            outline,
        }]
    };
    let stroke = |from, to| Shape::line(place(&from), place(&to), pen);
    match mark {
        Mark::Disc | Mark::Ring => vec![Shape::Circle {
            centre,
            radius: SIZE,
            fill: Some(fill),
            outline,
        }],
        Mark::Square | Mark::HollowSquare => polygon(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
        Mark::Triangle | Mark::HollowTriangle => polygon(&[(-1.1, -0.8), (1.1, -0.8), (0.0, 1.1)]),
        Mark::Inverted => polygon(&[(-1.1, 0.8), (1.1, 0.8), (0.0, -1.1)]),
        Mark::Diamond | Mark::HollowDiamond => polygon(&[(-1.2, 0.0), (0.0, -1.2), (1.2, 0.0), (0.0, 1.2)]),
        Mark::Cross => vec![stroke((-0.9, -0.9), (0.9, 0.9)), stroke((-0.9, 0.9), (0.9, -0.9))],
        Mark::Stroke => {
            let half = TALL / 2.0 / SIZE;
            vec![stroke((0.0, -half), (0.0, half))]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::clip;
    use super::*;

    #[test]
    fn limit_marks_differ_and_stay_at_their_point() {
        let drawn = [
            Mark::Disc,
            Mark::Square,
            Mark::Triangle,
            Mark::Inverted,
            Mark::Diamond,
            Mark::Ring,
            Mark::HollowSquare,
            Mark::HollowTriangle,
            Mark::HollowDiamond,
            Mark::Cross,
            Mark::Stroke,
        ]
        .map(|mark| shapes(mark, (10.0, 20.0), Shade::Ink));
        for (n, one) in drawn.iter().enumerate() {
            assert!(!drawn[..n].contains(one), "{one:?}");
            let reach = TALL / 2.0 + 1e-9;
            let near = ((10.0 - reach, 20.0 - reach), (10.0 + reach, 20.0 + reach));
            for shape in one {
                let points = match shape {
                    Shape::Line { points, .. } | Shape::Polygon { corners: points, .. } => points.clone(),
                    Shape::Circle { centre, radius, .. } => {
                        vec![(centre.0 - radius, centre.1), (centre.0, centre.1 + radius)]
                    }
                    Shape::Rectangle { .. } | Shape::Arrow { .. } | Shape::Text { .. } => vec![],
                };
                assert!(!points.is_empty() && points.iter().all(|&at| clip::contains(near, at)));
            }
        }
    }
}
