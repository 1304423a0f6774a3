//! A map of a grid: a panel per method, a square per scene, in the colour of the worst number of the run.

use super::class::Class;
use super::measure::{Measured, Run};
use crate::study::stress::{Cell, Map};
use pounding_plot::{Align, Drawing, Fill, Pen, PlotError, Shade, Shape, render_png};
use pounding_scene::{REFERENCE, label_of};

/// Side of a square \[mm\].
const SIDE: f64 = 4.2;
/// Panels in a row.
const COLUMNS: usize = 3;
/// Space left of a panel, below and above it \[mm\].
const MARGIN: (f64, f64, f64) = (13.0, 12.0, 6.0);
/// Height of the legend \[mm\].
const LEGEND: f64 = 12.0;
/// Size of letters in points.
const TEXT: f64 = 7.5;
/// Size of the letters in squares, and of those at the axes, in points.
const SMALL: f64 = 6.0;

/// The map as PNG.
pub(super) fn png(map: &Map, cells: &[Cell], measured: &[Measured]) -> Result<Vec<u8>, PlotError> {
    let own: Vec<&Measured> = cells
        .iter()
        .zip(measured)
        .filter(|(cell, _)| cell.place == map.name)
        .map(|(_, measured)| measured)
        .collect();
    let methods: Vec<&str> = own
        .first()
        .map(|measured| measured.runs.iter().map(|run| run.method).collect())
        .unwrap_or_default();
    render_png(&drawing(map, &methods, &own))
}

fn drawing(map: &Map, methods: &[&str], own: &[&Measured]) -> Drawing {
    let (n_x, n_y) = (map.x.values.len() as f64, map.y.values.len() as f64);
    let (left, below, above) = MARGIN;
    let (width, height) = (left + n_x * SIDE + 3.0, below + n_y * SIDE + above);
    let n_rows = methods.len().div_ceil(COLUMNS);
    let paper = (COLUMNS as f64 * width + 2.0, n_rows as f64 * height + LEGEND);
    let mut shapes = legend(paper.0, paper.1);
    for (index, method) in methods.iter().enumerate() {
        let (column, row) = (index % COLUMNS, index / COLUMNS);
        let corner = (column as f64 * width + left, paper.1 - LEGEND - (row + 1) as f64 * height + below);
        let runs: Vec<&Run> = own.iter().map(|measured| &measured.runs[index]).collect();
        let title = match *method {
            REFERENCE => "Exact, by the second route".into(),
            // The panels are narrow.
            method => label_of(method).replace(" in contact", ""),
        };
        panel(map, (corner, &title), &runs, &mut shapes);
    }
    Drawing {
        width: paper.0,
        height: paper.1,
        shapes,
    }
}

/// One method: squares row by row from below, numbers at the axes.
fn panel(map: &Map, (corner, title): ((f64, f64), &str), runs: &[&Run], shapes: &mut Vec<Shape>) {
    let (n_x, n_y) = (map.x.values.len(), map.y.values.len());
    for (index, run) in runs.iter().enumerate() {
        let at = (corner.0 + (index % n_x) as f64 * SIDE, corner.1 + (index / n_x) as f64 * SIDE);
        square(worst(run), at, shapes);
    }
    let size = (n_x as f64 * SIDE, n_y as f64 * SIDE);
    shapes.push(Shape::Rectangle {
        corner,
        size,
        fill: None,
        outline: Some(Pen::solid(Shade::Ink, 0.6)),
    });
    shapes.push(Shape::text((corner.0, corner.1 + size.1 + 2.6), title, TEXT, Align::Start));
    for (index, value) in map.x.values.iter().enumerate() {
        let x = corner.0 + (index as f64 + 0.5) * SIDE;
        shapes.push(upright((x, corner.1 - 0.8), number(*value), Align::End));
    }
    for (index, value) in map.y.values.iter().enumerate() {
        let y = corner.1 + (index as f64 + 0.5) * SIDE;
        let at = (corner.0 - 0.8, y);
        shapes.push(Shape::text(at, number(*value), SMALL, Align::End));
    }
    let middle = (corner.0 + 0.5 * size.0, corner.1 - 9.2);
    shapes.push(Shape::text(middle, map.x.axis.label(), TEXT, Align::Middle));
    let Shape::Text { text, at, .. } = Shape::text((corner.0 - 10.4, corner.1 + 0.5 * size.1), map.y.axis.label(), TEXT, Align::Middle)
    else {
        return;
    };
    shapes.push(Shape::Text {
        at,
        text,
        points: TEXT,
        align: Align::Middle,
        upright: true,
        shade: Shade::Ink,
    });
}

fn upright(at: (f64, f64), text: String, align: Align) -> Shape {
    Shape::Text {
        at,
        text,
        points: SMALL,
        align,
        upright: true,
        shade: Shade::Ink,
    }
}

/// The worst class of a run's numbers.
fn worst(run: &Run) -> Class {
    let rank = |class: Class| ORDER.iter().position(|other| *other == class);
    let classes = run.numbers.iter().map(|number| number.class);
    classes.max_by_key(|class| rank(*class)).unwrap_or(Class::Nothing)
}

/// From good to bad.
const ORDER: [Class; 9] = [
    Class::Nothing,
    Class::ExactToTolerance,
    Class::Accurate,
    Class::Degraded,
    Class::Refused,
    Class::Caught,
    Class::NoReference,
    Class::NotVerified,
    Class::SilentlyWrong,
];

/// A square with the letter of its class, so that it is read in grey too.
fn square(class: Class, corner: (f64, f64), shapes: &mut Vec<Shape>) {
    let (shade, opacity, letter) = match class {
        Class::Nothing => (Shade::White, 1.0, ""),
        Class::ExactToTolerance => (Shade::Blue, 0.75, ""),
        Class::Accurate => (Shade::Blue, 0.3, ""),
        Class::Degraded => (Shade::Amber, 0.6, "d"),
        Class::Refused => (Shade::Mist, 1.0, "r"),
        Class::Caught => (Shade::Vermilion, 0.7, "c"),
        Class::NoReference => (Shade::White, 1.0, "–"),
        Class::NotVerified => (Shade::White, 1.0, "?"),
        Class::SilentlyWrong => (Shade::Ink, 1.0, ""),
    };
    shapes.push(Shape::Rectangle {
        corner,
        size: (SIDE, SIDE),
        fill: Some(Fill { shade, opacity }),
        outline: Some(Pen::solid(Shade::White, 0.5)),
    });
    let middle = (corner.0 + 0.5 * SIDE, corner.1 + 0.5 * SIDE);
    shapes.push(Shape::text(middle, letter, SMALL, Align::Middle));
}

/// The classes in two rows, from good to bad.
fn legend(width: f64, height: f64) -> Vec<Shape> {
    let mut shapes = Vec::new();
    let column = (width - 6.0) / 5.0;
    for (index, class) in ORDER.into_iter().enumerate() {
        let corner = (3.0 + (index % 5) as f64 * column, height - 5.4 - (index / 5) as f64 * 5.2);
        square(class, corner, &mut shapes);
        shapes.push(Shape::Rectangle {
            corner,
            size: (SIDE, SIDE),
            fill: None,
            outline: Some(Pen::solid(Shade::Grey, 0.4)),
        });
        let at = (corner.0 + SIDE + 1.4, corner.1 + 0.5 * SIDE);
        shapes.push(Shape::text(at, class.words(), TEXT, Align::Start));
    }
    shapes
}

/// A value at an axis: plain, or as a power of ten.
fn number(value: f64) -> String {
    if value == 0.0 || (1e-2..=1e3).contains(&value) {
        format!("{value}")
    } else {
        format!("{value:e}").replace('-', "−")
    }
}
