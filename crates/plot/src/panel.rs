//! A panel on the paper.

use super::clip::{self, Box2};
use super::marks::SIZE;
use super::ruler::{Ruler, TICK_POINTS};
use super::scale::Frame;
use super::{Align, Axis, Fill, Note, Panel, PaperPoint, Pen, Shade, Shape, curves, legend, scale, text};

pub(super) const LABEL_POINTS: f64 = 9.0;
const NOTE_POINTS: f64 = 8.0;

/// Room right of a panel, for half a number \[mm\].
pub(super) const RIGHT: f64 = 3.4;

/// Length of a tick mark, and the space between it and its number \[mm\].
pub(super) const TICK: (f64, f64) = (1.0, 0.9);

/// Length of a short tick mark \[mm\].
const SHORT: f64 = 0.6;

/// Distance of the lines of a label \[mm\].
pub(super) const LABEL_LINE: f64 = 3.9;

/// Height of a title above a panel \[mm\].
pub(super) const TITLE: f64 = 5.0;

/// Room below a panel for numbers, and more for the label \[mm\].
pub(super) const FOOT: (f64, f64) = (4.8, 4.6);

/// Largest excess length of the label of a y axis over its panel \[mm\].
pub(super) const OVERHANG: f64 = 3.0;

const AXIS: Pen = Pen::solid(Shade::Ink, 0.7);
const SHORT_TICK: Pen = Pen::solid(Shade::Ink, 0.5);
const GRID: Pen = Pen::solid(Shade::Mist, 0.4);
const MARKER: Pen = Pen::solid(Shade::Silver, 0.55);
const LEVEL: Pen = Pen::solid(Shade::Ink, 0.5);

/// Distance of the paper of a note from its point \[mm\].
const NOTE_SPACE: f64 = 1.1;

/// Margin of the paper of a note beside and above its text \[mm\].
const NOTE_EDGE: PaperPoint = (0.5, 0.6);

/// A plot is a panel with its place on the paper and the numbers of its axes.
pub(super) struct Plot<'a> {
    pub(super) panel: &'a Panel,
    pub(super) frame: Frame,
    pub(super) x: &'a Axis,
    pub(super) x_ruler: Ruler,
    pub(super) y_ruler: Ruler,
    /// Whether the axes have numbers, and the x axis its label.
    pub(super) numbered: (bool, bool),
    /// Left end of the paper of this panel \[mm\].
    pub(super) margin: f64,
    /// Width available for the rows of a legend \[mm\].
    pub(super) legend_width: f64,
}

impl Plot<'_> {
    /// Draws the panel completely.
    pub(super) fn shapes(&self) -> Vec<Shape> {
        let mut shapes = self.grid();
        shapes.extend(self.marks());
        shapes.extend(self.panel.curves.iter().flat_map(|curve| curves::shapes(curve, &self.frame)));
        shapes.extend(self.axes());
        shapes.extend(self.panel.notes.iter().flat_map(|note| self.note(note)));
        shapes.extend(legend::shapes(self.panel, &self.frame, self.legend_width));
        shapes.extend(self.title());
        shapes
    }

    fn grid(&self) -> Vec<Shape> {
        let across = self.y_ruler.ticks.iter().map(|tick| self.level(tick.value, GRID));
        self.x_ruler
            .ticks
            .iter()
            .map(|tick| self.upright(tick.value, GRID))
            .chain(across)
            .collect()
    }

    fn marks(&self) -> Vec<Shape> {
        let (x, y) = (self.frame.x, self.frame.y);
        let markers = self.panel.markers.iter().filter(|&&at| x.contains(at));
        let zero = self.panel.curves.iter().any(scale::starts_from_zero).then_some(0.0);
        let levels = self.panel.levels.iter().chain(zero.as_ref()).filter(|&&at| y.contains(at));
        let markers = markers.map(|&at| self.upright(at, MARKER));
        markers.chain(levels.map(|&at| self.level(at, LEVEL))).collect()
    }

    fn axes(&self) -> Vec<Shape> {
        let ((left, bottom), (right, top)) = self.frame.edges;
        let corner = vec![(left, top), (left, bottom), (right, bottom)];
        let mut shapes = vec![Shape::Line { points: corner, pen: AXIS }];
        for tick in &self.y_ruler.ticks {
            let y = self.frame.up(tick.value);
            shapes.push(Shape::line((left - TICK.0, y), (left, y), AXIS));
            if self.numbered.1 {
                let at = (left - TICK.0 - TICK.1, y);
                shapes.push(Shape::text(at, &*tick.label, TICK_POINTS, Align::End));
            }
        }
        shapes.extend(self.short_ticks());
        let numbers = bottom - TICK.0 - TICK.1 - text::height(TICK_POINTS) / 2.0;
        for tick in &self.x_ruler.ticks {
            let x = self.frame.across(tick.value);
            shapes.push(Shape::line((x, bottom - TICK.0), (x, bottom), AXIS));
            if self.numbered.0 {
                let half = text::width(&tick.label, TICK_POINTS) / 2.0;
                let at = (x.min(right + RIGHT - half), numbers);
                shapes.push(Shape::text(at, &*tick.label, TICK_POINTS, Align::Middle));
            }
        }
        shapes.extend(self.labels());
        shapes
    }

    fn short_ticks(&self) -> Vec<Shape> {
        let ((left, bottom), _) = self.frame.edges;
        let across = self.x_ruler.between.iter().map(|&value| {
            let x = self.frame.across(value);
            Shape::line((x, bottom - SHORT), (x, bottom), SHORT_TICK)
        });
        let up = self.y_ruler.between.iter().map(|&value| {
            let y = self.frame.up(value);
            Shape::line((left - SHORT, y), (left, y), SHORT_TICK)
        });
        across.chain(up).collect()
    }

    fn labels(&self) -> Vec<Shape> {
        let ((left, bottom), (right, top)) = self.frame.edges;
        let mut shapes = Vec::new();
        if self.numbered.0 && !self.x.label.is_empty() {
            let at = (f64::midpoint(left, right), bottom - FOOT.0 - FOOT.1 / 2.0 + 0.3);
            shapes.push(Shape::text(at, &*self.x.label, LABEL_POINTS, Align::Middle));
        }
        let mut across = self.margin + text::height(LABEL_POINTS) / 2.0;
        for line in text::broken(&self.panel.y.label, LABEL_POINTS, top - bottom + OVERHANG) {
            let at = (across, self.label_middle(line));
            let (text, points, shade) = (line.to_owned(), LABEL_POINTS, Shade::Ink);
            shapes.push(Shape::Text {
                at,
                text,
                points,
                align: Align::Middle,
                upright: true,
                shade,
            });
            across += LABEL_LINE;
        }
        shapes
    }

    /// Returns the height of the middle of a label of the y axis; a long label may not end above its panel.
    fn label_middle(&self, line: &str) -> f64 {
        let ((_, bottom), (_, top)) = self.frame.edges;
        let half = text::width(line, LABEL_POINTS) / 2.0;
        f64::midpoint(bottom, top).min(top - half).max(f64::midpoint(bottom, top) - 2.0)
    }

    fn title(&self) -> Option<Shape> {
        let ((left, _), (_, top)) = self.frame.edges;
        let at = (left, top + legend::height(self.panel, self.legend_width) + TITLE / 2.0 + 0.3);
        let title = &self.panel.title;
        (!title.is_empty()).then(|| Shape::text(at, &**title, LABEL_POINTS, Align::Start))
    }

    /// Writes a note next to its point on nearly white paper, to its right or on the next side that hides less.
    fn note(&self, note: &Note) -> [Shape; 2] {
        let size = (text::width(&note.text, NOTE_POINTS), text::height(NOTE_POINTS));
        let traces: Vec<PaperPoint> = self
            .panel
            .curves
            .iter()
            .flat_map(|curve| curves::traces(curve, &self.frame))
            .collect();
        let boxes = self.beside(self.frame.place(note.at), size);
        let hidden = |&(low, high): &Box2| {
            // The width of lines and marks counts, too.
            let near = ((low.0 - SIZE, low.1 - SIZE), (high.0 + SIZE, high.1 + SIZE));
            traces.iter().filter(|&&point| clip::contains(near, point)).count()
        };
        let (low, high) = boxes.into_iter().min_by_key(hidden).unwrap_or(boxes[0]);
        let paper = Fill {
            shade: Shade::White,
            opacity: 0.8,
        };
        let at = (low.0 + NOTE_EDGE.0, f64::midpoint(low.1, high.1));
        let text = Shape::text(at, &*note.text, NOTE_POINTS, Align::Start);
        [Shape::filled(low, (high.0 - low.0, high.1 - low.1), paper), text]
    }

    /// Returns the boxes of a note with this size to the right, left, above and below a point, moved into the panel.
    fn beside(&self, (x, y): PaperPoint, size: PaperPoint) -> [Box2; 4] {
        let ((left, bottom), (right, top)) = self.frame.edges;
        let (wide, high) = (size.0 / 2.0 + NOTE_EDGE.0, size.1 / 2.0 + NOTE_EDGE.1);
        let middles = [
            (x + NOTE_SPACE + wide, y),
            (x - NOTE_SPACE - wide, y),
            (x, y + NOTE_SPACE + high),
            (x, y - NOTE_SPACE - high),
        ];
        middles.map(|(x, y)| {
            let x = x.min(right - wide).max(left + wide + 0.3);
            let y = y.min(top - high).max(bottom + high + 0.3);
            ((x - wide, y - high), (x + wide, y + high))
        })
    }

    fn upright(&self, x: f64, pen: Pen) -> Shape {
        let ((_, bottom), (_, top)) = self.frame.edges;
        let x = self.frame.across(x);
        Shape::line((x, bottom), (x, top), pen)
    }

    fn level(&self, y: f64, pen: Pen) -> Shape {
        let ((left, _), (right, _)) = self.frame.edges;
        let y = self.frame.up(y);
        Shape::line((left, y), (right, y), pen)
    }
}
