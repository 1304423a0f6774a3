//! Maps of grids: one panel per method, one square per scene in the colour of the worst number of the run.

use super::class::Class;
use super::measure::{JudgedRun, JudgedScene};
use crate::study::stress::{ExtremeScene, Map};
use pounding_plot::{Align, Drawing, Pen, Shade, Shape};
use pounding_scene::ComparedMethod;

/// Side of a square \[mm\].
const SIDE: f64 = 4.2;
/// Number of panels in a row.
const COLUMNS: usize = 3;
/// Space left of a panel, below and above it \[mm\].
const MARGIN: (f64, f64, f64) = (13.0, 12.0, 6.0);
/// Height of the legend \[mm\].
const LEGEND: f64 = 12.0;
/// Size of letters in points.
const TEXT: f64 = 7.5;
/// Size of the letters in squares and at the axes, in points.
const SMALL: f64 = 6.0;

/// Drawing of a map.
pub(super) fn drawing(map: &Map, cells: &[ExtremeScene], measured: &[JudgedScene]) -> Drawing {
    let own = cells.iter().zip(measured).filter(|(cell, _)| cell.place == map.name);
    let own: Vec<&JudgedScene> = own.map(|(_, measured)| measured).collect();
    let methods: &[JudgedRun] = own.first().map_or(&[], |measured| &measured.runs);
    let (n_x, n_y) = (map.x.values.len() as f64, map.y.values.len() as f64);
    let (left, below, above) = MARGIN;
    let (width, height) = (left + n_x * SIDE + 3.0, below + n_y * SIDE + above);
    let n_rows = methods.len().div_ceil(COLUMNS);
    let paper = (COLUMNS as f64 * width + 2.0, n_rows as f64 * height + LEGEND);
    let mut shapes = legend(paper.0, paper.1);
    for (index, run) in methods.iter().enumerate() {
        let (column, row) = (index % COLUMNS, index / COLUMNS);
        let corner = (column as f64 * width + left, paper.1 - LEGEND - (row + 1) as f64 * height + below);
        let runs: Vec<&JudgedRun> = own.iter().map(|measured| &measured.runs[index]).collect();
        let title = match run.method {
            ComparedMethod::REFERENCE => "Exact, by the second route".into(),
            // The panels are too narrow for the whole name.
            method => ComparedMethod::label_of(method).replace(" in contact", ""),
        };
        panel(map, corner, &title, &runs, &mut shapes);
    }
    Drawing {
        width: paper.0,
        height: paper.1,
        shapes,
    }
}

/// Draws one method: squares row by row from below, numbers at the axes.
fn panel(map: &Map, corner: (f64, f64), title: &str, runs: &[&JudgedRun], shapes: &mut Vec<Shape>) {
    let (n_x, n_y) = (map.x.values.len(), map.y.values.len());
    for (index, run) in runs.iter().enumerate() {
        let at = (corner.0 + (index % n_x) as f64 * SIDE, corner.1 + (index / n_x) as f64 * SIDE);
        square(worst(run), at, shapes);
    }
    let size = (n_x as f64 * SIDE, n_y as f64 * SIDE);
    shapes.push(Shape::outlined(corner, size, Pen::solid(Shade::Ink, 0.6)));
    shapes.push(Shape::text((corner.0, corner.1 + size.1 + 2.6), title, TEXT, Align::Start));
    for (index, value) in map.x.values.iter().enumerate() {
        let x = corner.0 + (index as f64 + 0.5) * SIDE;
        shapes.push(Shape::upright((x, corner.1 - 0.8), number(*value), SMALL, Align::End));
    }
    for (index, value) in map.y.values.iter().enumerate() {
        let y = corner.1 + (index as f64 + 0.5) * SIDE;
        shapes.push(Shape::text((corner.0 - 0.8, y), number(*value), SMALL, Align::End));
    }
    let middle = (corner.0 + 0.5 * size.0, corner.1 + 0.5 * size.1);
    shapes.push(Shape::text((middle.0, corner.1 - 9.2), map.x.axis.texts().1, TEXT, Align::Middle));
    shapes.push(Shape::upright(
        (corner.0 - 10.4, middle.1),
        map.y.axis.texts().1,
        TEXT,
        Align::Middle,
    ));
}

/// The worst class of a run's numbers.
fn worst(run: &JudgedRun) -> Class {
    let classes = run.numbers.iter().map(|number| number.class);
    classes.max_by_key(|class| class.look().rank).unwrap_or(Class::Nothing)
}

/// Draws a square with the letter of its class.
fn square(class: Class, corner: (f64, f64), shapes: &mut Vec<Shape>) {
    let look = class.look();
    shapes.push(Shape::boxed(corner, (SIDE, SIDE), look.fill, Pen::solid(Shade::White, 0.5)));
    let middle = (corner.0 + 0.5 * SIDE, corner.1 + 0.5 * SIDE);
    shapes.push(Shape::text(middle, look.letter, SMALL, Align::Middle));
}

/// The legend of the classes in two rows, from good to bad.
fn legend(width: f64, height: f64) -> Vec<Shape> {
    let mut shapes = Vec::new();
    let column = (width - 6.0) / 5.0;
    let mut classes = Class::ALL;
    classes.sort_by_key(|class| class.look().rank);
    for (index, class) in classes.into_iter().enumerate() {
        let corner = (3.0 + (index % 5) as f64 * column, height - 5.4 - (index / 5) as f64 * 5.2);
        square(class, corner, &mut shapes);
        shapes.push(Shape::outlined(corner, (SIDE, SIDE), Pen::solid(Shade::Grey, 0.4)));
        let at = (corner.0 + SIDE + 1.4, corner.1 + 0.5 * SIDE);
        shapes.push(Shape::text(at, class.look().words, TEXT, Align::Start));
    }
    shapes
}

/// A value at an axis: a plain number, or a power of ten.
fn number(value: f64) -> String {
    if value == 0.0 || (1e-2..=1e3).contains(&value) {
        format!("{value}")
    } else {
        format!("{value:e}").replace('-', "−")
    }
}
