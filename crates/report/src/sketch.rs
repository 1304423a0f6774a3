//! The row as a sketch: heights to scale, floors that touch in orange.

use pounding_plot::{Align, Drawing, Fill, Pen, PlotError, Shade, Shape, render_both, writable};
use pounding_scene::{Floors, Link, Scene, Standing};
use pounding_text::millimetres;

use crate::figures::elevation;

const CAPTION: &str = "The row: heights to scale, storeys without a height 3 m high, widths and gaps not to scale. Floors \
                       that touch in some run are orange and thick.";
const LINKED: &str = " Blue lines are links.";

pub(super) fn caption(scene: &Scene) -> String {
    let linked = if scene.links.is_empty() { "" } else { LINKED };
    format!("{CAPTION}{linked}")
}

/// Largest height on paper \[mm\].
const TALL: f64 = 60.0;
/// Width of a building, and of the space between two \[mm\].
const WIDE: f64 = 26.0;
const BETWEEN: f64 = 14.0;
/// Ground, and the margin above the highest roof \[mm\].
const GROUND: f64 = 8.0;
const ABOVE: f64 = 6.0;

/// A row, and which of its floors touch.
#[derive(Debug, Clone, Copy)]
pub struct Sketch<'a> {
    /// The row.
    pub scene: &'a Scene,
    /// Its floors.
    pub floors: &'a Floors,
    /// Indices of the floors that touch.
    pub touched: &'a [usize],
}

impl Sketch<'_> {
    /// The sketch as SVG.
    ///
    /// # Errors
    /// What cannot be drawn: see [`PlotError`].
    pub fn svg(&self) -> Result<String, PlotError> {
        Ok(render_both(&drawing(self))?.0)
    }
}

pub(super) fn drawing(sketch: &Sketch<'_>) -> Drawing {
    let Sketch { scene, floors, .. } = sketch;
    let structures = &scene.structures;
    let elevations = (0..floors.all().len()).map(|floor| elevation(floors, floor));
    let scale = TALL / elevations.fold(0.0, f64::max);
    let width = structures.len() as f64 * (WIDE + BETWEEN) + BETWEEN;
    let mut shapes = vec![Shape::line((0.0, GROUND), (width, GROUND), Pen::solid(Shade::Ink, 1.0))];
    for (index, structure) in structures.iter().enumerate() {
        let left = BETWEEN + index as f64 * (WIDE + BETWEEN);
        shapes.extend(building(sketch, index, left, scale));
        let below = (left + WIDE / 2.0, GROUND - 4.0);
        shapes.push(Shape::text(below, shortened(structure.name()), 8.0, Align::Middle));
    }
    for (left, contact) in scene.contacts.iter().flatten().enumerate() {
        let at = BETWEEN + (left as f64 + 1.0) * (WIDE + BETWEEN) - BETWEEN / 2.0;
        let text = format!("{} mm", millimetres(contact.gap_m));
        shapes.push(Shape::text((at, GROUND + 2.0), text, 8.0, Align::Middle));
    }
    shapes.extend(scene.links.iter().filter_map(|link| linked(sketch, link, scale)));
    Drawing {
        width,
        height: GROUND + TALL + ABOVE,
        shapes,
    }
}

/// A structure from its left side on, with its floors; a wall is half as high as the paper.
fn building(sketch: &Sketch<'_>, index: usize, left: f64, scale: f64) -> Vec<Shape> {
    let Sketch { floors, touched, .. } = sketch;
    let own = floors.of_structure(index);
    let is_wall = own.iter().all(|floor| floors.all()[*floor].is_wall());
    let tops = own.iter().map(|floor| scale * elevation(floors, *floor));
    let (top, shade) = if is_wall {
        (TALL / 2.0, Shade::Silver)
    } else {
        (tops.fold(0.0, f64::max), Shade::Mist)
    };
    let mut shapes = vec![Shape::Rectangle {
        corner: (left, GROUND),
        size: (WIDE, top),
        fill: Some(Fill::solid(shade)),
        outline: Some(Pen::solid(Shade::Ink, 0.8)),
    }];
    for floor in own.iter().filter(|_| !is_wall) {
        let height = GROUND + scale * elevation(floors, *floor);
        let pen = if touched.contains(floor) {
            Pen::solid(Shade::Vermilion, 3.0)
        } else {
            Pen::solid(Shade::Ink, 0.8)
        };
        shapes.push(Shape::line((left, height), (left + WIDE, height), pen));
    }
    shapes
}

/// A line from the face of the left structure to that of the right one; inside a structure from side to side.
fn linked(sketch: &Sketch<'_>, link: &Link, scale: f64) -> Option<Shape> {
    let Sketch { scene, floors, .. } = sketch;
    let ends = link.ends(scene).ok()?;
    let [left, right] = ends.map(|end| end.structure);
    let side = |structure: usize| BETWEEN + structure as f64 * (WIDE + BETWEEN);
    let from = if left == right { side(left) } else { side(left) + WIDE };
    let to = if left == right { side(right) + WIDE } else { side(right) };
    let [low, high] = heights(floors, ends).map(|height| GROUND + scale * height);
    Some(Shape::line((from, low), (to, high), Pen::solid(Shade::Blue, 1.6)))
}

/// Heights of the ends of a link \[m\], of the ground 0; at a wall the link is level.
pub(crate) fn heights(floors: &Floors, ends: [Standing; 2]) -> [f64; 2] {
    let height = |Standing { structure, floor }| {
        let floor = floors.of_structure(structure).get(floor?)?;
        (!floors.all()[*floor].is_wall()).then(|| elevation(floors, *floor))
    };
    let is_wall = |end: Standing| {
        floors
            .of_structure(end.structure)
            .iter()
            .all(|floor| floors.all()[*floor].is_wall())
    };
    let [left, right] = ends.map(height);
    let of = |end: Standing, own: Option<f64>, other: Option<f64>| own.or(other.filter(|_| is_wall(end))).unwrap_or(0.0);
    [of(ends[0], left, right), of(ends[1], right, left)]
}

fn shortened(name: &str) -> String {
    let name = writable(name);
    if name.chars().count() <= 16 {
        return name;
    }
    name.chars().take(15).chain(['…']).collect()
}
