//! Drawings of rows: masses on columns with gaps between them.

use crate::files::capital;
use pounding_plot::{Align, Drawing, Fill, Pen, Shade, Shape};
use pounding_scene::{Scene, Sdof, Structure};

/// Width of one layout on paper \[mm\].
const CELL: f64 = 58.0;
/// Height of the paper \[mm\].
const HEIGHT: f64 = 62.0;
/// Height of the ground line \[mm\].
const GROUND: f64 = 19.0;
/// Height of the columns \[mm\].
const COLUMN: f64 = 22.0;
/// Drawn gap \[mm\], far from true to scale.
const GAP: f64 = 4.5;
/// Size of the letters in points.
const TEXT: f64 = 8.5;

/// Every scene as a drawn row, next to each other.
pub(super) fn drawing(scenes: &[Scene]) -> Drawing {
    let mut shapes = Vec::new();
    for (index, scene) in scenes.iter().enumerate() {
        layout(scene, (index as f64 + 0.5) * CELL, &mut shapes);
    }
    Drawing {
        width: CELL * scenes.len() as f64,
        height: HEIGHT,
        shapes,
    }
}

/// Half the width of a drawn structure and the height of its mass \[mm\]; a heavy structure is larger.
fn size(structure: &Sdof) -> (f64, f64) {
    if is_heavy(structure) { (7.0, 9.0) } else { (5.0, 5.0) }
}

fn is_heavy(structure: &Sdof) -> bool {
    structure.mass_kg > 1e6
}

fn layout(scene: &Scene, middle: f64, shapes: &mut Vec<Shape>) {
    let half = |structure: &Structure| match structure {
        Structure::Sdof(sdof) => size(sdof).0,
        Structure::Building(_) | Structure::Wall => 2.0,
    };
    let halves: Vec<f64> = scene.structures.iter().map(half).collect();
    let width = 2.0 * halves.iter().sum::<f64>() + GAP * (halves.len() - 1) as f64;
    let mut x = middle - 0.5 * width;
    ground(x - 3.0, x + width + 3.0, shapes);
    shapes.push(Shape::text((middle, HEIGHT - 4.0), capital(&scene.name), TEXT + 1.0, Align::Middle));
    for (index, (structure, half)) in scene.structures.iter().zip(&halves).enumerate() {
        if let Structure::Sdof(sdof) = structure {
            storey(sdof, x + half, Shade::nth(index), shapes);
        }
        x += 2.0 * half + GAP;
        if let Some(contact) = scene.contacts.as_ref().and_then(|contacts| contacts.get(index)) {
            gap(x - GAP, contact.gap_m, shapes);
        }
    }
}

/// The ground with short strokes below it.
fn ground(from: f64, to: f64, shapes: &mut Vec<Shape>) {
    shapes.push(Shape::line((from, GROUND), (to, GROUND), Pen::solid(Shade::Ink, 1.2)));
    let mut x = from + 1.0;
    while x < to {
        shapes.push(Shape::line((x, GROUND), (x - 1.4, GROUND - 1.6), Pen::solid(Shade::Grey, 0.5)));
        x += 1.8;
    }
}

/// Draws one structure: two columns, a mass, and its name and data below.
///
/// The colour follows the position in the row, as in the histories.
fn storey(structure: &Sdof, x: f64, shade: Shade, shapes: &mut Vec<Shape>) {
    let (half, mass) = size(structure);
    let pen = if is_heavy(structure) { 3.0 } else { 1.2 };
    let leg = half - 1.6;
    for side in [-leg, leg] {
        let (foot, top) = ((x + side, GROUND), (x + side, GROUND + COLUMN - 0.5 * mass));
        shapes.push(Shape::line(foot, top, Pen::solid(Shade::Ink, pen)));
    }
    let corner = (x - half, GROUND + COLUMN - 0.5 * mass);
    shapes.push(Shape::boxed(
        corner,
        (2.0 * half, mass),
        Fill::solid(shade),
        Pen::solid(Shade::Ink, 0.8),
    ));
    let line = |row: f64, text: String, points| Shape::text((x, GROUND - 4.6 - 3.6 * row), text, points, Align::Middle);
    shapes.push(line(0.0, capital(&structure.name), TEXT));
    shapes.push(line(1.0, format!("{:.0} t", structure.mass_kg / 1e3), TEXT - 1.5));
    shapes.push(line(2.0, format!("T = {:.1} s", structure.period()), TEXT - 1.5));
}

/// Draws the gap to the right of `from` as a dimension above the masses.
fn gap(from: f64, gap: f64, shapes: &mut Vec<Shape>) {
    let (top, pen) = (GROUND + COLUMN + 8.0, Pen::solid(Shade::Ink, 0.5));
    for x in [from, from + GAP] {
        let grey = Pen::solid(Shade::Grey, 0.5);
        shapes.push(Shape::line((x, GROUND + COLUMN + 5.2), (x, top + 1.0), grey));
    }
    shapes.push(Shape::Arrow {
        from: (from, top),
        to: (from + GAP, top),
        pen,
    });
    let text = format!("{:.0} mm", 1e3 * gap);
    shapes.push(Shape::text((from + 0.5 * GAP, top + 3.4), text, TEXT - 1.5, Align::Middle));
}
