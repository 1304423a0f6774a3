//! Appearance of a curve, in its panel and in a legend.

use super::clip::{self, Box2};
use super::scale::Frame;
use super::{Curve, CurveKind, Fill, Mark, PaperPoint, Pen, Shade, Shape, marks};

/// Width of a curve in points.
const LINE: f64 = 1.05;

/// Width of a thin curve and of the outline of an area in points.
const THIN: f64 = 0.65;

/// Opacity of an area.
const OPACITY: f64 = 0.5;

/// Draws a curve in its panel.
pub(super) fn shapes(curve: &Curve, frame: &Frame) -> Vec<Shape> {
    match curve.kind {
        CurveKind::Line | CurveKind::Thin | CurveKind::Dashed | CurveKind::Points => {
            let marks = visible(curve, frame).flat_map(|at| marked(curve, at));
            lines(curve, frame).into_iter().chain(marks).collect()
        }
        CurveKind::Stems => curve.points.iter().flat_map(|&point| stem(curve, point, frame)).collect(),
        CurveKind::Area => runs(&curve.points).iter().flat_map(|run| area(run, curve.shade, frame)).collect(),
        CurveKind::Bars => bars(curve, frame).map(|ends| bar(ends, curve.shade)).collect(),
    }
}

/// Draws the mark of a curve at a point, if it has any.
fn marked(curve: &Curve, at: PaperPoint) -> Vec<Shape> {
    let own = match curve.kind {
        CurveKind::Line | CurveKind::Thin | CurveKind::Dashed | CurveKind::Area | CurveKind::Bars => None,
        CurveKind::Stems | CurveKind::Points => Some(Mark::of(curve.shade)),
    };
    curve
        .mark
        .or(own)
        .map_or_else(Vec::new, |mark| marks::shapes(mark, at, curve.shade))
}

/// Returns points of the curve on the paper, dense enough to find what a box would hide.
pub(super) fn traces(curve: &Curve, frame: &Frame) -> Vec<PaperPoint> {
    let placed = |&point: &PaperPoint| frame.place(point);
    let points: Vec<PaperPoint> = match curve.kind {
        CurveKind::Points => return visible(curve, frame).collect(),
        CurveKind::Bars => {
            return bars(curve, frame).flat_map(|(from, to)| between(from, to)).collect();
        }
        CurveKind::Line | CurveKind::Thin | CurveKind::Dashed | CurveKind::Area => curve.points.iter().map(placed).collect(),
        CurveKind::Stems => {
            let foot = |&(x, _): &PaperPoint| (frame.across(x), frame.base());
            curve
                .points
                .iter()
                .flat_map(|point| [foot(point), placed(point), foot(point)])
                .collect()
        }
    };
    clip::pieces(&points, frame.edges)
        .iter()
        .flat_map(|piece| piece.windows(2))
        .flat_map(|pair| between(pair[0], pair[1]))
        .collect()
}

/// Returns the width that the sample of a curve should have in a legend \[mm\].
pub(super) fn sample_width(kind: CurveKind) -> f64 {
    match kind {
        CurveKind::Line | CurveKind::Thin | CurveKind::Dashed => 7.0,
        CurveKind::Area | CurveKind::Bars => 4.0,
        CurveKind::Stems | CurveKind::Points => 2.0,
    }
}

/// Draws the sample of a curve in a legend, from a point at half height to the right.
pub(super) fn sample(curve: &Curve, (left, middle): PaperPoint, width: f64) -> Vec<Shape> {
    let centre = left + width / 2.0;
    let pen = pen(curve);
    match curve.kind {
        CurveKind::Line | CurveKind::Thin | CurveKind::Dashed => {
            let line = Shape::line((left, middle), (left + width, middle), pen);
            let mut shapes = vec![line];
            shapes.extend(marked(curve, (centre, middle)));
            shapes
        }
        CurveKind::Stems => {
            let (foot, head) = ((centre, middle - 1.3), (centre, middle + 0.6));
            let mut shapes = vec![Shape::line(foot, head, pen)];
            shapes.extend(marked(curve, head));
            shapes
        }
        CurveKind::Area => {
            let (corner, size) = ((left, middle - 0.9), (width, 1.8));
            let fill = Some(Fill {
                shade: curve.shade,
                opacity: OPACITY,
            });
            vec![Shape::Rectangle {
                corner,
                size,
                fill,
                outline: Some(pen),
            }]
        }
        CurveKind::Bars => vec![bar(((left, middle), (left + width, middle)), curve.shade)],
        CurveKind::Points => marked(curve, (centre, middle)),
    }
}

/// Returns the pen of a curve.
fn pen(curve: &Curve) -> Pen {
    match curve.kind {
        CurveKind::Line | CurveKind::Stems | CurveKind::Points => Pen::solid(curve.shade, LINE),
        CurveKind::Thin | CurveKind::Area | CurveKind::Bars => Pen::solid(curve.shade, THIN),
        CurveKind::Dashed => Pen::dashed(curve.shade, LINE),
    }
}

fn lines(curve: &Curve, frame: &Frame) -> Vec<Shape> {
    if curve.kind == CurveKind::Points {
        return Vec::new();
    }
    let points: Vec<PaperPoint> = curve.points.iter().map(|&point| frame.place(point)).collect();
    let pieces = clip::pieces(&points, frame.edges);
    pieces.into_iter().map(|points| Shape::Line { points, pen: pen(curve) }).collect()
}

fn stem(curve: &Curve, (x, y): (f64, f64), frame: &Frame) -> Vec<Shape> {
    if !frame.x.contains(x) {
        return Vec::new();
    }
    let ((_, bottom), (_, top)) = frame.edges;
    let (foot, head) = ((frame.across(x), frame.base()), frame.place((x, y)));
    let cut = (head.0, head.1.clamp(bottom, top));
    let mut shapes = vec![Shape::line(foot, cut, pen(curve))];
    // A head at the edge would suggest that the value ends there.
    if clip::contains(frame.edges, head) {
        shapes.extend(marked(curve, head));
    }
    shapes
}

fn area(run: &[(f64, f64)], shade: Shade, frame: &Frame) -> Vec<Shape> {
    let ((left, bottom), (right, top)) = frame.edges;
    let tall: Box2 = ((left, f64::NEG_INFINITY), (right, f64::INFINITY));
    let points: Vec<PaperPoint> = run.iter().map(|&point| frame.place(point)).collect();
    let mut shapes = Vec::new();
    for piece in clip::pieces(&points, tall) {
        let edge: Vec<PaperPoint> = piece.into_iter().map(|(x, y)| (x, y.clamp(bottom, top))).collect();
        let (first, last) = (edge[0].0, edge[edge.len() - 1].0);
        let mut corners = vec![(first, frame.base())];
        corners.extend(&edge);
        corners.push((last, frame.base()));
        shapes.push(Shape::Polygon {
            corners,
            fill: Fill { shade, opacity: OPACITY },
            outline: None,
        });
        shapes.push(Shape::Line {
            points: edge,
            pen: Pen::solid(shade, THIN),
        });
    }
    shapes
}

/// Returns the visible ends of bars.
fn bars(curve: &Curve, frame: &Frame) -> impl Iterator<Item = (PaperPoint, PaperPoint)> {
    let frame = *frame;
    let pairs = curve.points.chunks_exact(2);
    pairs
        .map(move |pair| [frame.place(pair[0]), frame.place(pair[1])])
        .flat_map(move |ends| clip::pieces(&ends, frame.edges))
        .map(|piece| (piece[0], piece[1]))
}

/// Draws a bar; a bar without length is a stroke.
fn bar(((left, middle), (right, _)): (PaperPoint, PaperPoint), shade: Shade) -> Shape {
    Shape::Rectangle {
        corner: (left, middle - marks::TALL / 2.0),
        size: (right - left, marks::TALL),
        fill: Some(Fill { shade, opacity: OPACITY }),
        outline: Some(Pen::solid(shade, THIN)),
    }
}

/// Cuts a curve into the runs that leave zero, each with the zeros beside it.
fn runs(points: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
    let mut runs = Vec::new();
    let mut run: Vec<(f64, f64)> = Vec::new();
    for &point in points {
        let zero = point.1 == 0.0;
        match run.len() {
            1 if zero && run[0].1 == 0.0 => run[0] = point,
            0 => run.push(point),
            _ if zero => {
                run.push(point);
                runs.push(std::mem::replace(&mut run, vec![point]));
            }
            _ => run.push(point),
        }
    }
    runs.push(run);
    runs.retain(|run| run.len() > 1);
    runs
}

/// Returns the points of a curve that lie in the panel, on the paper.
fn visible(curve: &Curve, frame: &Frame) -> impl Iterator<Item = PaperPoint> {
    let frame = *frame;
    curve
        .points
        .iter()
        .map(move |&point| frame.place(point))
        .filter(move |&point| clip::contains(frame.edges, point))
}

/// Returns points on a segment, about a millimetre apart.
fn between(from: PaperPoint, to: PaperPoint) -> Vec<PaperPoint> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "paper is at most 2 m wide and high"
    )]
    let steps = (dx.abs().max(dy.abs()).ceil() as u32).max(1);
    (0..steps)
        .map(|k| f64::from(k) / f64::from(steps))
        .map(|s| (from.0 + s * dx, from.1 + s * dy))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_runs_leave_out_the_rest_at_zero() {
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 5.0), (3.0, 0.0), (4.0, 0.0), (5.0, 0.0), (6.0, 1.0)];
        let expected = [vec![(1.0, 0.0), (2.0, 5.0), (3.0, 0.0)], vec![(5.0, 0.0), (6.0, 1.0)]];
        assert_eq!(runs(&points), expected);
    }

    #[test]
    fn limit_no_run_in_a_curve_at_zero() {
        assert!(runs(&[]).is_empty());
        assert!(runs(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]).is_empty());
    }
}
