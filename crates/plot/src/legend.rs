//! The legend of a panel.

use super::scale::Frame;
use super::text::{self, MM_PER_POINT};
use super::{Align, Curve, Figure, Fill, Legend, Panel, PaperPoint, Shade, Shape, clip, curves};

/// Size of the text in points.
const POINTS: f64 = 8.5;

/// Distance of rows \[mm\].
const ROW: f64 = 4.6;

/// Space between the sample of a curve and its label \[mm\].
const GAP: f64 = 1.6;

/// Space between entries of a row \[mm\].
const SPACE: f64 = 6.0;

/// Space below a legend above all panels \[mm\].
const BELOW: f64 = 1.6;

/// Space between the text and the edge of the box inside a panel \[mm\].
const INSET: f64 = 1.6;

/// Distance of the box inside a panel from the axes \[mm\].
const MARGIN: f64 = 1.2;

/// An entry is a curve with its label, and where it starts in its row \[mm\].
struct Entry<'a> {
    curve: &'a Curve,
    label: &'a str,
    start: f64,
}

/// Returns the height of the legend above a panel \[mm\].
pub(super) fn height(panel: &Panel, width: f64) -> f64 {
    let rows = if panel.legend == Legend::Above {
        rows(panel, width).len()
    } else {
        0
    };
    ROW * count(rows)
}

/// Draws the legend of a panel, above or inside; `width` is the room for its rows.
pub(super) fn shapes(panel: &Panel, frame: &Frame, width: f64) -> Vec<Shape> {
    match panel.legend {
        Legend::Above => above(panel, frame, width),
        Legend::Inside => inside(panel, frame),
        Legend::Shared | Legend::Hidden => Vec::new(),
    }
}

/// A legend above all panels of a figure.
pub(super) struct Shared<'a> {
    /// The columns of entries; all have equal length, except the last.
    columns: Vec<Vec<(&'a Curve, &'a str)>>,
}

impl<'a> Shared<'a> {
    /// Gathers the curves that share a legend of a width \[mm\]: for each label the first curve that has it.
    pub(super) fn of(figure: &'a Figure, width: f64) -> Self {
        let sharing = |panel: &&Panel| panel.legend == Legend::Shared;
        let mut entries: Vec<(&Curve, &str)> = Vec::new();
        for (curve, label) in figure.panels.iter().filter(sharing).flat_map(labelled) {
            if entries.iter().all(|entry| entry.1 != label) {
                entries.push((curve, label));
            }
        }
        let of_rows = |rows: usize| Self {
            columns: entries.chunks(rows).map(<[_]>::to_vec).collect(),
        };
        let mut legends = (1..=entries.len()).map(of_rows);
        legends
            .find(|legend| legend.width() <= width)
            .unwrap_or_else(|| of_rows(entries.len().max(1)))
    }

    /// Returns the height with the space below \[mm\].
    pub(super) fn height(&self) -> f64 {
        match self.columns.first() {
            Some(column) => ROW * count(column.len()) + BELOW,
            None => 0.0,
        }
    }

    /// Draws the legend from its upper left corner.
    pub(super) fn shapes(&self, (mut left, top): PaperPoint) -> Vec<Shape> {
        let mut shapes = Vec::new();
        for column in &self.columns {
            let sample = widest_sample(column);
            for (row, (curve, label)) in column.iter().enumerate() {
                let middle = top - ROW * (count(row) + 0.5);
                shapes.extend(explain(curve, label, (left, middle), sample));
            }
            left += sample + longest(column) + SPACE;
        }
        shapes
    }

    /// Returns the width \[mm\].
    pub(super) fn width(&self) -> f64 {
        let widths = self.columns.iter().map(|column| widest_sample(column) + longest(column) + SPACE);
        widths.sum::<f64>() - SPACE
    }
}

fn above(panel: &Panel, frame: &Frame, width: f64) -> Vec<Shape> {
    let ((left, _), (right, top)) = frame.edges;
    let mut middle = top + height(panel, width) - ROW / 2.0 + 0.6;
    let mut shapes = Vec::new();
    for row in rows(panel, width) {
        let ends = row
            .iter()
            .map(|entry| entry.start + curves::sample_width(entry.curve.kind) + length(entry.label));
        // A row that is wider than its panel starts further left.
        let left = left.min(right - ends.fold(0.0, f64::max));
        for entry in row {
            let sample = curves::sample_width(entry.curve.kind);
            let at = (left + entry.start, middle);
            shapes.extend(explain(entry.curve, entry.label, at, sample));
        }
        middle -= ROW;
    }
    shapes
}

/// Fills rows from left to right.
fn rows(panel: &Panel, width: f64) -> Vec<Vec<Entry<'_>>> {
    let mut rows: Vec<Vec<Entry<'_>>> = Vec::new();
    let mut start = 0.0;
    for (curve, label) in labelled(panel) {
        let long = curves::sample_width(curve.kind) + length(label);
        if rows.is_empty() || start + long > width {
            rows.push(Vec::new());
            start = 0.0;
        }
        if let Some(row) = rows.last_mut() {
            row.push(Entry { curve, label, start });
        }
        start += long + SPACE;
    }
    rows
}

/// Draws the entries below each other on nearly white paper, in the corner where this hides least.
fn inside(panel: &Panel, frame: &Frame) -> Vec<Shape> {
    let entries: Vec<(&Curve, &str)> = labelled(panel).collect();
    if entries.is_empty() {
        return Vec::new();
    }
    let sample = widest_sample(&entries);
    let size = (sample + longest(&entries) + 2.0 * INSET, ROW * count(entries.len()) + INSET);
    let (left, bottom) = emptiest(panel, frame, size);
    let mut shapes = vec![Shape::filled(
        (left, bottom),
        size,
        Fill {
            shade: Shade::White,
            opacity: 0.88,
        },
    )];
    let mut middle = bottom + size.1 - f64::midpoint(ROW, INSET);
    for (curve, label) in entries {
        shapes.extend(explain(curve, label, (left + INSET, middle), sample));
        middle -= ROW;
    }
    shapes
}

/// Returns the lower left corner of the box that hides the fewest points; of equal boxes, the upper right one.
fn emptiest(panel: &Panel, frame: &Frame, (width, height): PaperPoint) -> PaperPoint {
    let ((left, bottom), (right, top)) = frame.edges;
    let (near, far) = (left + MARGIN, right - MARGIN - width);
    let (low, high) = (bottom + MARGIN, top - MARGIN - height);
    let mut points: Vec<PaperPoint> = panel.curves.iter().flat_map(|curve| curves::traces(curve, frame)).collect();
    // A note has a large weight: a hidden word is worse than a hidden piece of a curve.
    points.extend(panel.notes.iter().flat_map(|note| [frame.place(note.at); 20]));
    let hidden = |&(x, y): &PaperPoint| {
        let near = ((x - MARGIN, y - MARGIN), (x + width + MARGIN, y + height + MARGIN));
        points.iter().filter(|&&point| clip::contains(near, point)).count()
    };
    let corners = [(far, high), (near, high), (far, low), (near, low)];
    corners.into_iter().min_by_key(hidden).unwrap_or((far, high))
}

/// Returns the curves that have a label.
fn labelled(panel: &Panel) -> impl Iterator<Item = (&Curve, &str)> {
    panel
        .curves
        .iter()
        .filter_map(|curve| curve.label.as_deref().map(|label| (curve, label)))
}

/// Returns the width of the widest sample of entries \[mm\].
fn widest_sample(entries: &[(&Curve, &str)]) -> f64 {
    let widths = entries.iter().map(|entry| curves::sample_width(entry.0.kind));
    widths.fold(0.0, f64::max)
}

/// Returns the width of the longest label of entries with the space before it \[mm\].
fn longest(entries: &[(&Curve, &str)]) -> f64 {
    let widths = entries.iter().map(|entry| length(entry.1));
    widths.fold(0.0, f64::max)
}

/// Turns a count into a factor.
fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

/// Returns the width of a label with the space before it \[mm\].
fn length(label: &str) -> f64 {
    GAP + text::width(label, POINTS)
}

/// Draws the sample of a curve and its label.
fn explain(curve: &Curve, label: &str, (left, middle): PaperPoint, sample: f64) -> Vec<Shape> {
    let mut shapes = curves::sample(curve, (left, middle), sample);
    // The middle of small letters looks like the middle of the text.
    let at = (left + sample + GAP, middle + 0.06 * POINTS * MM_PER_POINT);
    shapes.push(Shape::text(at, label, POINTS, Align::Start));
    shapes
}
