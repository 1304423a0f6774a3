//! Drawings of claims against cases, readable in grey.

use std::ops::Range;

use super::{Beyond, Case, Group, findings, short};
use crate::files::capital;
use crate::paper::claims::{Finding, asked as claims_asked};
use pounding_plot::{Align, Drawing, Fill, PaperPoint, Pen, Shade, Shape};

/// Width and height of a cell, and distance between two motions \[mm\].
const CELL: (f64, f64) = (4.6, 7.6);
const APART: f64 = 1.5;
/// Width for the claims in words, and for the counts right of the cells \[mm\].
const WORDS: f64 = 62.0;
const COUNT: f64 = 17.0;
/// Height for the directions above the cells, and per letter of a motion's name \[mm\].
const ARROWS: f64 = 5.2;
const LETTER: f64 = 1.55;
/// Height for the legend below the cells \[mm\].
const FOOT: f64 = 14.0;
/// Least width of the paper, needed by the legend \[mm\].
const LEAST: f64 = 152.0;
/// Free margin \[mm\].
const MARGIN: f64 = 2.0;
/// Size of letters in points.
const TEXT: f64 = 8.0;
const SMALL: f64 = 7.0;
/// Distance between two lines of text \[mm\].
const LINE: f64 = 3.3;

/// Drawing of the cells of some motions. The counts at the right are of all motions.
pub(super) fn drawing(beyond: &Beyond, group: &Group, motions: Range<usize>) -> Drawing {
    let claims = findings::all(&group.worlds);
    let right = left_of(motions.len()) - APART;
    let names = beyond.motions[motions.clone()].iter().map(|motion| short(&motion.name));
    let letters = names.map(|name| name.chars().count()).max().unwrap_or(0);
    let bottom = MARGIN + FOOT;
    let top = bottom + CELL.1 * claims.len() as f64;
    let (width, height) = (LEAST.max(right + COUNT + MARGIN), top + ARROWS + LETTER * letters as f64 + MARGIN);
    let mut shapes = Vec::new();
    for (column, motion) in beyond.motions[motions.clone()].iter().enumerate() {
        heading(&motion.name, (left_of(column), top), &mut shapes);
    }
    shapes.push(Shape::text((right + 0.5 * COUNT, top + 2.4), "holds", SMALL, Align::Middle));
    for ((row, asked), (_, words)) in claims.iter().enumerate().zip(claims_asked()) {
        let middle = top - (row as f64 + 0.5) * CELL.1;
        for (column, both) in asked.findings[motions.clone()].iter().enumerate() {
            for (direction, finding) in both.iter().enumerate() {
                let left = left_of(column) + direction as f64 * CELL.0;
                cell(*finding, (left, middle - 0.5 * CELL.1), &mut shapes);
            }
        }
        lines(words, middle, &mut shapes);
        let tally = asked.tally();
        let count = format!("{} of {}", tally.holds, tally.cases);
        let at = (right + 0.5 * COUNT, middle);
        shapes.push(Shape::text(at, count, TEXT, Align::Middle));
    }
    if let Some(Case { motion, reversed }) = beyond.papers
        && motions.contains(&motion)
    {
        let left = left_of(motion - motions.start) + f64::from(u8::from(reversed)) * CELL.0;
        let size = (CELL.0, top - bottom);
        shapes.push(Shape::outlined((left, bottom), size, Pen::solid(Shade::Ink, 1.2)));
    }
    let changed = group.change.map(|change| format!("{}; ", capital(&change.to_string())));
    let framed = match beyond.papers {
        Some(_) => "; framed: the paper's record and direction",
        None => "",
    };
    let words = format!("{}→ as given, ← reversed{framed}", changed.unwrap_or_default());
    legend(words, &mut shapes);
    Drawing { width, height, shapes }
}

/// Left edge of the cells of a motion.
fn left_of(column: usize) -> f64 {
    MARGIN + WORDS + column as f64 * (2.0 * CELL.0 + APART)
}

/// Draws the name of a motion, upright, with arrows for its directions.
fn heading(name: &str, (left, top): PaperPoint, shapes: &mut Vec<Shape>) {
    for (direction, arrow) in ["→", "←"].into_iter().enumerate() {
        let x = left + (direction as f64 + 0.5) * CELL.0;
        shapes.push(Shape::text((x, top + 2.4), arrow, TEXT, Align::Middle));
    }
    shapes.push(Shape::upright((left + CELL.0, top + ARROWS), short(name), TEXT, Align::Start));
}

/// Draws the words of a claim as lines centred at a height.
fn lines(words: &str, middle: f64, shapes: &mut Vec<Shape>) {
    let count = words.lines().count() as f64;
    for (index, line) in words.lines().enumerate() {
        let y = middle + (0.5 * (count - 1.0) - index as f64) * LINE;
        let at = (MARGIN + WORDS - 2.4, y);
        shapes.push(Shape::text(at, line, TEXT, Align::End));
    }
}

/// Draws a cell with a sign that can be read in grey.
fn cell(finding: Finding, corner: PaperPoint, shapes: &mut Vec<Shape>) {
    let (shade, opacity, sign) = match finding {
        Finding::Holds => (Shade::Blue, 0.85, ""),
        Finding::HoldsOnlyAsStated => (Shade::Blue, 0.3, "•"),
        Finding::DoesNotHold => (Shade::Vermilion, 0.55, "×"),
        Finding::DoesNotApply => (Shade::Mist, 0.6, "–"),
    };
    let fill = Fill { shade, opacity };
    shapes.push(Shape::boxed(corner, CELL, fill, Pen::solid(Shade::White, 1.0)));
    let middle = (corner.0 + 0.5 * CELL.0, corner.1 + 0.5 * CELL.1);
    shapes.push(Shape::text(middle, sign, TEXT, Align::Middle));
}

/// Draws the meaning of the cells and arrows.
fn legend(words: String, shapes: &mut Vec<Shape>) {
    let mut x = MARGIN + 2.0;
    for (finding, width) in Finding::ALL.into_iter().zip([20.0, 42.0, 32.0, 0.0]) {
        let corner = (x, FOOT - 9.6);
        cell(finding, corner, shapes);
        let at = (x + CELL.0 + 1.6, corner.1 + 0.5 * CELL.1);
        shapes.push(Shape::text(at, finding.words(), SMALL, Align::Start));
        x += width;
    }
    let at = (MARGIN + 2.0, 1.6);
    shapes.push(Shape::text(at, words, SMALL, Align::Start));
}
