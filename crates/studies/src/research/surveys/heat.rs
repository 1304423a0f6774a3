//! Maps over two logarithmic axes: coloured cells in panels, with one row of panels and one scale per quantity.

use pounding_plot::{Align, Drawing, Fill, Pen, Shade, Shape};
use pounding_text::digits;

/// Width of the paper \[mm\]: two columns of a journal.
const WIDTH: f64 = 177.8;
/// Room left of the panels, between them, above each panel, and below the last row \[mm\].
const MARGIN: (f64, f64, f64, f64) = (13.0, 4.0, 5.4, 9.0);
/// Room for the scale beside the panels \[mm\].
const SCALE: f64 = 27.0;
/// Width and height of one step of the scale \[mm\].
const STEP: (f64, f64) = (4.2, 4.6);
/// Radius of the dot that marks a class in grey \[mm\].
const DOT: f64 = 0.3;
/// Sizes of letters in points.
const TEXT: f64 = 8.0;
const SMALL: f64 = 7.0;

/// A map of several quantities.
pub(super) struct Heat {
    /// Values along both axes, rising by a constant ratio.
    pub(super) axis: Vec<f64>,
    pub(super) x: String,
    pub(super) y: String,
    /// Titles of the columns of panels.
    pub(super) titles: Vec<String>,
    pub(super) rows: Vec<HeatRow>,
    /// Values that have a number at the axes.
    pub(super) ticks: Vec<f64>,
}

/// One quantity.
pub(super) struct HeatRow {
    pub(super) label: String,
    pub(super) classes: Classes,
    /// Cells of every panel, row by row from below; a `None` stays white.
    pub(super) panels: Vec<Vec<Option<f64>>>,
}

/// Colours of the values.
#[derive(Debug, Clone, Copy)]
pub(super) enum Classes {
    /// A darker colour is a larger value; the bounds rise.
    Rising([f64; 5]),
    /// Blue with a dot is less than one, orange is more. The bounds rise, three on either side.
    About([f64; 6]),
}

impl Classes {
    fn bounds(&self) -> &[f64] {
        match self {
            Self::Rising(bounds) => bounds,
            Self::About(bounds) => bounds,
        }
    }

    /// Colour of a class, counted from the lowest, and whether the class has a dot.
    fn look(self, class: usize) -> (Fill, bool) {
        let fill = |shade, opacity| Fill { shade, opacity };
        match self {
            Self::Rising(_) => {
                let opacities = [0.06, 0.2, 0.38, 0.58, 0.8, 1.0];
                (fill(Shade::Blue, opacities[class]), false)
            }
            Self::About(_) => match class {
                0..=2 => (fill(Shade::Blue, [0.95, 0.6, 0.28][class]), true),
                3 => (fill(Shade::Mist, 0.5), false),
                more => (fill(Shade::Vermilion, [0.3, 0.62, 1.0][more - 4]), false),
            },
        }
    }

    fn class(&self, value: f64) -> usize {
        self.bounds().iter().filter(|bound| value >= **bound).count()
    }

    /// Label of a class in the scale.
    fn words(&self, class: usize) -> String {
        let bounds = self.bounds();
        match class {
            0 => format!("< {}", digits(bounds[0])),
            last if last == bounds.len() => format!("≥ {}", digits(bounds[last - 1])),
            middle => format!("{}–{}", digits(bounds[middle - 1]), digits(bounds[middle])),
        }
    }
}

impl Heat {
    /// Drawing of the map.
    pub(super) fn drawing(&self) -> Drawing {
        let n_columns = self.titles.len() as f64;
        let (left, between, above, below) = MARGIN;
        let side = (WIDTH - left - SCALE - (n_columns - 1.0) * between) / n_columns;
        let height = self.rows.len() as f64 * (side + above) + below + 2.0;
        let mut shapes = Vec::new();
        for (row, of_row) in self.rows.iter().enumerate() {
            let bottom = height - 2.0 - (row + 1) as f64 * (side + above);
            for (column, cells) in of_row.panels.iter().enumerate() {
                let corner = (left + column as f64 * (side + between), bottom);
                self.panel(corner, side, cells, of_row.classes, &mut shapes);
                if row == 0 {
                    let at = (corner.0 + 0.5 * side, bottom + side + 2.6);
                    shapes.push(Shape::text(at, &*self.titles[column], TEXT, Align::Middle));
                }
                self.numbers(corner, side, column == 0, row + 1 == self.rows.len(), &mut shapes);
            }
            let at = (3.2, bottom + 0.5 * side);
            shapes.push(Shape::upright(at, &*self.y, TEXT, Align::Middle));
            scale(WIDTH - SCALE + 3.0, bottom + side, of_row, &mut shapes);
        }
        let middle = left + 0.5 * (WIDTH - left - SCALE);
        shapes.push(Shape::text((middle, 2.6), &*self.x, TEXT, Align::Middle));
        Drawing {
            width: WIDTH,
            height,
            shapes,
        }
    }

    fn panel(&self, corner: (f64, f64), side: f64, cells: &[Option<f64>], classes: Classes, shapes: &mut Vec<Shape>) {
        let n = self.axis.len();
        let cell = side / n as f64;
        for (index, value) in cells.iter().enumerate() {
            let Some(value) = value else {
                continue;
            };
            let (fill, dot) = classes.look(classes.class(*value));
            let at = (corner.0 + (index % n) as f64 * cell, corner.1 + (index / n) as f64 * cell);
            shapes.push(Shape::filled(at, (cell, cell), fill));
            if dot {
                shapes.push(spot((at.0 + 0.5 * cell, at.1 + 0.5 * cell)));
            }
        }
        shapes.push(Shape::outlined(corner, (side, side), Pen::solid(Shade::Ink, 0.6)));
    }

    /// Draws ticks, with numbers at the left and below if requested.
    fn numbers(&self, corner: (f64, f64), side: f64, beside: bool, under: bool, shapes: &mut Vec<Shape>) {
        let n = self.axis.len();
        let (from, to) = (self.axis[0], self.axis[n - 1]);
        let cell = side / n as f64;
        let pen = Pen::solid(Shade::Ink, 0.6);
        for &tick in &self.ticks {
            let part = libm::log(tick / from) / libm::log(to / from);
            let along = (0.5 + part * (n - 1) as f64) * cell;
            let (x, y) = (corner.0 + along, corner.1 + along);
            shapes.push(Shape::line((x, corner.1 - 0.9), (x, corner.1), pen));
            shapes.push(Shape::line((corner.0 - 0.9, y), (corner.0, y), pen));
            if under {
                let at = (x, corner.1 - 2.9);
                shapes.push(Shape::text(at, digits(tick), SMALL, Align::Middle));
            }
            if beside {
                let at = (corner.0 - 1.5, y);
                shapes.push(Shape::text(at, digits(tick), SMALL, Align::End));
            }
        }
    }
}

/// Draws the classes of a quantity from top to bottom, below its name.
fn scale(x: f64, top: f64, row: &HeatRow, shapes: &mut Vec<Shape>) {
    let lines: Vec<&str> = row.label.lines().collect();
    for (index, line) in lines.iter().enumerate() {
        let at = (x, top - 1.6 - 3.3 * index as f64);
        shapes.push(Shape::text(at, *line, SMALL, Align::Start));
    }
    let top = top - 2.4 - 3.3 * lines.len() as f64;
    let n_classes = row.classes.bounds().len() + 1;
    for class in 0..n_classes {
        let (fill, dot) = row.classes.look(class);
        let corner = (x, top - (n_classes - class) as f64 * STEP.1);
        shapes.push(Shape::boxed(corner, STEP, fill, Pen::solid(Shade::Grey, 0.4)));
        if dot {
            shapes.push(spot((corner.0 + 0.5 * STEP.0, corner.1 + 0.5 * STEP.1)));
        }
        let at = (x + STEP.0 + 1.4, corner.1 + 0.5 * STEP.1);
        shapes.push(Shape::text(at, row.classes.words(class), SMALL, Align::Start));
    }
}

fn spot(centre: (f64, f64)) -> Shape {
    Shape::Circle {
        centre,
        radius: DOT,
        fill: Some(Fill::solid(Shade::White)),
        outline: None,
    }
}
