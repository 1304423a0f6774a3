//! Where the panels of a figure stand.

use super::panel::{
    FOOT, LABEL_LINE, LABEL_POINTS, OVERHANG, Plot, RIGHT, TICK, TICK_POINTS, TITLE,
};
use super::scale::{Frame, Range, x_range, y_range};
use super::ticks::{self, Tick};
use super::{Axis, Drawing, Figure, Panel, PlotError, legend, text};

/// Width of a figure \[mm\]: 7 inches, two columns of a journal.
const WIDTH: f64 = 7.0 * 25.4;

/// Free margin around a figure \[mm\].
const MARGIN: f64 = 1.2;

/// Room above a panel that has nothing there \[mm\].
const TOP: f64 = 1.4;

/// Distance of rows, beside what is written above and below them \[mm\].
const ROW_SPACE: f64 = 2.2;

/// Distance of columns \[mm\].
const COLUMN_SPACE: f64 = 4.0;

/// Room taken left of a panel as long as its numbers are not known \[mm\].
const USUAL_GUTTER: f64 = 14.0;

/// Least width and height of a panel worth drawing \[mm\].
const LEAST: (f64, f64) = (12.0, 6.0);

/// Least distance of numbers: along the x axis between their texts, along the y axis between their middles \[mm\].
const NUMBER_SPACE: (f64, f64) = (2.2, 6.2);

/// A cell is a panel with its place in the grid and its ranges.
struct Cell<'a> {
    panel: &'a Panel,
    axis: &'a Axis,
    ranges: (Range, Range),
    row: usize,
    column: usize,
    footed: bool,
}

/// A band is the height that a row has for its panels, and where that starts \[mm\].
struct Band {
    bottom: f64,
    height: f64,
}

/// Lays a figure out.
pub(super) fn lay_out(figure: &Figure) -> Result<Drawing, PlotError> {
    check(figure)?;
    let height = figure.height_in * 25.4;
    let cells = cells(figure)?;
    let share = (WIDTH - 2.0 * MARGIN + COLUMN_SPACE) / count(figure.columns) - COLUMN_SPACE;
    let legend_width = share - USUAL_GUTTER - RIGHT;
    let bands = bands(&cells, height, legend_width);
    let y_ticks: Vec<Vec<Tick>> = cells
        .iter()
        .map(|cell| y_ticks(cell.ranges.1, bands[cell.row].height))
        .collect();
    let mut shapes = Vec::new();
    for (cell, ticks) in cells.iter().zip(&y_ticks) {
        let margin = MARGIN + count(cell.column) * (share + COLUMN_SPACE);
        let band = &bands[cell.row];
        let column = cells
            .iter()
            .zip(&y_ticks)
            .filter(|(other, _)| other.column == cell.column);
        let gutter = column
            .map(|(cell, ticks)| gutter(cell.panel, ticks, bands[cell.row].height))
            .fold(0.0, f64::max);
        let edges = (
            (margin + gutter, band.bottom),
            (margin + share - RIGHT, band.bottom + band.height),
        );
        let frame = Frame {
            edges,
            x: cell.ranges.0,
            y: cell.ranges.1,
        };
        if !(frame.width() >= LEAST.0 && band.height >= LEAST.1) {
            return Err(PlotError::Size {
                width_mm: WIDTH,
                height_mm: height,
            });
        }
        let (panel, x, footed, y_ticks) = (cell.panel, cell.axis, cell.footed, ticks.clone());
        let x_ticks = x_ticks(cell.ranges.0, frame.width());
        shapes.extend(
            Plot {
                panel,
                frame,
                x,
                x_ticks,
                y_ticks,
                footed,
                margin,
                legend_width,
            }
            .shapes(),
        );
    }
    Ok(Drawing {
        width: WIDTH,
        height,
        shapes,
    })
}

/// Refuses what cannot be laid out.
fn check(figure: &Figure) -> Result<(), PlotError> {
    if figure.panels.is_empty() || figure.columns == 0 {
        return Err(PlotError::NoPanel);
    }
    for (index, panel) in figure.panels.iter().enumerate() {
        if !(panel.weight > 0.0 && panel.weight.is_finite()) {
            return Err(PlotError::Weight {
                panel: index,
                weight: panel.weight,
            });
        }
        for (curve, points) in panel.curves.iter().map(|curve| &curve.points).enumerate() {
            if let Some(point) = points
                .iter()
                .position(|(x, y)| !(x.is_finite() && y.is_finite()))
            {
                return Err(PlotError::CurvePoint {
                    panel: index,
                    curve,
                    point,
                });
            }
        }
        let notes = panel.notes.iter().flat_map(|note| [note.at.0, note.at.1]);
        let mut marks = panel
            .markers
            .iter()
            .chain(&panel.levels)
            .copied()
            .chain(notes);
        if marks.any(|mark| !mark.is_finite()) {
            return Err(PlotError::Mark { panel: index });
        }
    }
    Ok(())
}

/// Puts the panels into rows and columns and finds their ranges.
fn cells(figure: &Figure) -> Result<Vec<Cell<'_>>, PlotError> {
    let panels = &figure.panels;
    let sharing: Vec<&Panel> = panels.iter().filter(|panel| panel.x.is_none()).collect();
    let cell = |(index, panel): (usize, &'_ Panel)| -> Result<(Range, Range, bool), PlotError> {
        let x = match &panel.x {
            Some(own) => x_range(own, &[panel])?,
            None => x_range(&figure.x, &sharing)?,
        };
        // Numbers are left out only where the panel below repeats them.
        let below = panels.get(index + figure.columns);
        Ok((
            x,
            y_range(panel)?,
            panel.x.is_some() || below.is_none_or(|below| below.x.is_some()),
        ))
    };
    let mut cells = Vec::new();
    for (index, panel) in panels.iter().enumerate() {
        let (x, y, footed) = cell((index, panel))?;
        let axis = panel.x.as_ref().unwrap_or(&figure.x);
        let (row, column) = (index / figure.columns, index % figure.columns);
        cells.push(Cell {
            panel,
            axis,
            ranges: (x, y),
            row,
            column,
            footed,
        });
    }
    Ok(cells)
}

/// Divides the height among the rows by their weights, after what is written above and below them.
fn bands(cells: &[Cell<'_>], height: f64, legend_width: f64) -> Vec<Band> {
    let rows = cells.last().map_or(0, |cell| cell.row + 1);
    let most = |row: usize, measure: &dyn Fn(&Cell<'_>) -> f64| {
        cells
            .iter()
            .filter(|cell| cell.row == row)
            .map(measure)
            .fold(0.0, f64::max)
    };
    let heads: Vec<f64> = (0..rows)
        .map(|row| most(row, &|cell| head(cell.panel, legend_width)))
        .collect();
    let feet: Vec<f64> = (0..rows).map(|row| most(row, &foot)).collect();
    let weights: Vec<f64> = (0..rows)
        .map(|row| most(row, &|cell| cell.panel.weight))
        .collect();
    let taken =
        heads.iter().chain(&feet).sum::<f64>() + 2.0 * MARGIN + ROW_SPACE * (count(rows) - 1.0);
    let unit = (height - taken) / weights.iter().sum::<f64>();
    let mut top = height - MARGIN;
    let mut bands = Vec::new();
    for ((head, foot), weight) in heads.iter().zip(&feet).zip(&weights) {
        let bottom = top - head - weight * unit;
        bands.push(Band {
            bottom,
            height: weight * unit,
        });
        top = bottom - foot - ROW_SPACE;
    }
    bands
}

/// Returns the room above a panel \[mm\].
fn head(panel: &Panel, legend_width: f64) -> f64 {
    let title = if panel.title.is_empty() { 0.0 } else { TITLE };
    TOP.max(title + legend::height(panel, legend_width))
}

/// Returns the room below a panel \[mm\].
fn foot(cell: &Cell<'_>) -> f64 {
    match (cell.footed, cell.axis.label.is_empty()) {
        (false, _) => TICK.0,
        (true, true) => FOOT.0,
        (true, false) => FOOT.0 + FOOT.1,
    }
}

/// Returns the room left of a panel for the label and the numbers of its y axis \[mm\].
fn gutter(panel: &Panel, ticks: &[Tick], height: f64) -> f64 {
    let lines = if panel.y.label.is_empty() {
        0
    } else {
        text::broken(&panel.y.label, LABEL_POINTS, height + OVERHANG).len()
    };
    widest(ticks) + TICK.0 + TICK.1 + 0.6 + LABEL_LINE * count(lines)
}

/// Chooses the numbers of an x axis of a length \[mm\].
fn x_ticks(range: Range, length: f64) -> Vec<Tick> {
    ticks::choose(range, 12, |ticks| {
        spacing(ticks, range, length) >= NUMBER_SPACE.0 + widest(ticks).max(4.0)
    })
}

/// Chooses the numbers of a y axis of a length \[mm\]: about ten, or as many as stand apart in a low panel.
fn y_ticks(range: Range, length: f64) -> Vec<Tick> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "paper is at most 2 m high"
    )]
    let most = (length / NUMBER_SPACE.1).clamp(0.0, 9.0) as u32;
    ticks::choose(range, most, |ticks| {
        spacing(ticks, range, length) >= NUMBER_SPACE.1
    })
}

/// Returns the distance of ticks on an axis of a length \[mm\].
fn spacing(ticks: &[Tick], (from, to): Range, length: f64) -> f64 {
    match ticks {
        [first, second, ..] => (second.value - first.value) / (to - from) * length,
        _ => length,
    }
}

/// Returns the width of the widest number \[mm\].
fn widest(ticks: &[Tick]) -> f64 {
    ticks
        .iter()
        .map(|tick| text::width(&tick.label, TICK_POINTS))
        .fold(0.0, f64::max)
}

/// Turns a count into a factor.
fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}
