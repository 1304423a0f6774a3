//! Positions of the panels of a figure.

use super::panel::{FOOT, LABEL_LINE, LABEL_POINTS, OVERHANG, Plot, RIGHT, TICK, TITLE};
use super::ruler::{Ruler, TICK_POINTS};
use super::scale::{Frame, Range, x_range, y_range};
use super::{Axis, Drawing, Figure, Panel, PlotError, Scale, legend, text};

/// Width of a figure \[mm\]: 7 inches, two columns of a journal.
const WIDTH: f64 = 7.0 * 25.4;

/// Free margin around a figure \[mm\].
const MARGIN: f64 = 1.2;

/// Room above a panel without a title or legend \[mm\].
const TOP: f64 = 1.4;

/// Distance of rows, in addition to the text above and below them \[mm\].
const ROW_SPACE: f64 = 2.2;

/// Distance of columns \[mm\].
const COLUMN_SPACE: f64 = 4.0;

/// Room left of a panel whose numbers are not known yet \[mm\].
const USUAL_GUTTER: f64 = 14.0;

/// Least width and height of a panel worth drawing \[mm\].
const LEAST: (f64, f64) = (12.0, 6.0);

/// A cell is a panel with its place in the grid and its ranges.
struct PanelCell<'a> {
    panel: &'a Panel,
    axis: &'a Axis,
    ranges: (Range, Range),
    row: usize,
    column: usize,
    /// Whether the axes have numbers.
    numbered: (bool, bool),
}

/// A band is the height of the panels of a row, and its start \[mm\].
struct Band {
    bottom: f64,
    height: f64,
}

/// A column is the left end of the paper of its panels, and the left and right end of the panels \[mm\].
struct PanelColumn {
    margin: f64,
    left: f64,
    right: f64,
}

/// Lays a figure out.
pub(super) fn lay_out(figure: &Figure) -> Result<Drawing, PlotError> {
    check(figure)?;
    let height = figure.height_in * 25.4;
    let cells = cells(figure)?;
    let share = (WIDTH - 2.0 * MARGIN + COLUMN_SPACE) / count(figure.columns) - COLUMN_SPACE;
    let named = cells.iter().map(|cell| names_width(&cell.panel.y));
    let legend_width = share - named.fold(USUAL_GUTTER, f64::max) - RIGHT;
    let shared = legend::Shared::of(figure, WIDTH - 2.0 * MARGIN);
    let bands = bands(&cells, height - shared.height(), legend_width);
    let ruler = |cell: &PanelCell<'_>| Ruler::up(&cell.panel.y, cell.ranges.1, bands[cell.row].height);
    let rulers: Vec<Ruler> = cells.iter().map(ruler).collect();
    let columns = columns(&cells, &rulers, &bands, figure.columns);
    // A legend that is too wide starts further left than the axis.
    let left = columns[0].left.min(WIDTH - MARGIN - shared.width());
    let mut shapes = shared.shapes((left, height - MARGIN));
    for (cell, y_ruler) in cells.iter().zip(rulers) {
        let (column, band) = (&columns[cell.column], &bands[cell.row]);
        let frame = Frame {
            edges: ((column.left, band.bottom), (column.right, band.bottom + band.height)),
            x: cell.ranges.0,
            y: cell.ranges.1,
        };
        let width = column.right - column.left;
        let x_ruler = Ruler::across(cell.axis, cell.ranges.0, width);
        let large = width >= LEAST.0 && band.height >= LEAST.1;
        if !large || x_ruler.crowded || y_ruler.crowded {
            return Err(PlotError::Size {
                width_mm: WIDTH,
                height_mm: height,
            });
        }
        check_texts(cell, width)?;
        let (panel, x, numbered) = (cell.panel, cell.axis, cell.numbered);
        shapes.extend(
            Plot {
                panel,
                frame,
                x,
                x_ruler,
                y_ruler,
                numbered,
                margin: column.margin,
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

/// Refuses figures that cannot be laid out.
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
        let (x, y) = (panel.x.as_ref().unwrap_or(&figure.x), &panel.y);
        for (curve, points) in panel.curves.iter().map(|curve| &curve.points).enumerate() {
            let unsound = |point: &(f64, f64)| !(fits(x, point.0) && fits(y, point.1));
            if let Some(point) = points.iter().position(unsound) {
                return Err(PlotError::CurvePoint {
                    panel: index,
                    curve,
                    point,
                });
            }
        }
        let notes = || panel.notes.iter().map(|note| note.at);
        let mut across = panel.markers.iter().copied().chain(notes().map(|at| at.0));
        let mut up = panel.levels.iter().copied().chain(notes().map(|at| at.1));
        if !(across.all(|value| fits(x, value)) && up.all(|value| fits(y, value))) {
            return Err(PlotError::Mark { panel: index });
        }
    }
    Ok(())
}

/// Whether a value can be on an axis.
fn fits(axis: &Axis, value: f64) -> bool {
    value.is_finite() && (value > 0.0 || axis.scale != Scale::Log)
}

/// Refuses texts that would overlap a neighbour of a panel with this width.
fn check_texts(cell: &PanelCell<'_>, width: f64) -> Result<(), PlotError> {
    let room = width + RIGHT + COLUMN_SPACE;
    let written = |text| (text, text::width(text, LABEL_POINTS));
    let (title, long) = written(&cell.panel.title);
    if long > room {
        return Err(PlotError::LongText { text: title.into() });
    }
    let (label, long) = written(&cell.axis.label);
    if cell.numbered.0 && long > room + RIGHT + COLUMN_SPACE {
        return Err(PlotError::LongText { text: label.into() });
    }
    Ok(())
}

/// Puts the panels into rows and columns and finds their ranges.
fn cells(figure: &Figure) -> Result<Vec<PanelCell<'_>>, PlotError> {
    let panels = &figure.panels;
    let sharing: Vec<&Panel> = panels.iter().filter(|panel| panel.x.is_none()).collect();
    let mut cells: Vec<PanelCell<'_>> = Vec::new();
    for (index, panel) in panels.iter().enumerate() {
        let (row, column) = (index / figure.columns, index % figure.columns);
        let axis = panel.x.as_ref().unwrap_or(&figure.x);
        let x = match &panel.x {
            Some(own) => x_range(own, &[panel])?,
            None => x_range(axis, &sharing)?,
        };
        let y = y_range(panel)?;
        // Numbers are omitted only if the panel below, or the panel to the left, has them.
        let below = panels.get(index + figure.columns);
        let footed = panel.x.is_some() || below.is_none_or(|below| below.x.is_some());
        let beside = cells.last().filter(|_| column > 0 && panel.y.label.is_empty());
        let same = |left: &PanelCell<'_>| left.ranges.1 == y && left.panel.y.scale == panel.y.scale;
        cells.push(PanelCell {
            panel,
            axis,
            ranges: (x, y),
            row,
            column,
            numbered: (footed, !beside.is_some_and(same)),
        });
    }
    Ok(cells)
}

/// Returns the width of the longest name along an axis \[mm\].
fn names_width(axis: &Axis) -> f64 {
    match &axis.scale {
        Scale::Linear | Scale::Log => 0.0,
        Scale::Names(names) => names.iter().map(|name| text::width(name, TICK_POINTS)).fold(0.0, f64::max),
    }
}

/// Divides the height among the rows by their weights, after subtracting the text above and below them.
fn bands(cells: &[PanelCell<'_>], height: f64, legend_width: f64) -> Vec<Band> {
    let rows = cells.last().map_or(0, |cell| cell.row + 1);
    let most =
        |row: usize, measure: &dyn Fn(&PanelCell<'_>) -> f64| cells.iter().filter(|cell| cell.row == row).map(measure).fold(0.0, f64::max);
    let heads: Vec<f64> = (0..rows).map(|row| most(row, &|cell| head(cell.panel, legend_width))).collect();
    let feet: Vec<f64> = (0..rows).map(|row| most(row, &foot)).collect();
    let weights: Vec<f64> = (0..rows).map(|row| most(row, &|cell| cell.panel.weight)).collect();
    let taken = heads.iter().chain(&feet).sum::<f64>() + 2.0 * MARGIN + ROW_SPACE * (count(rows) - 1.0);
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

/// Divides the width among the columns, after subtracting the text to the left of them. All panels are equally wide.
fn columns(cells: &[PanelCell<'_>], rulers: &[Ruler], bands: &[Band], n: usize) -> Vec<PanelColumn> {
    let gutters: Vec<f64> = (0..n)
        .map(|column| {
            let inside = cells.iter().zip(rulers);
            inside
                .filter(|(cell, _)| cell.column == column)
                .map(|(cell, ruler)| gutter(cell, ruler, bands[cell.row].height))
                .fold(0.0, f64::max)
        })
        .collect();
    let besides = count(n) * (RIGHT + COLUMN_SPACE) - COLUMN_SPACE + 2.0 * MARGIN;
    let width = (WIDTH - besides - gutters.iter().sum::<f64>()) / count(n);
    let mut margin = MARGIN;
    let mut columns = Vec::new();
    for gutter in gutters {
        let left = margin + gutter;
        let right = left + width;
        columns.push(PanelColumn { margin, left, right });
        margin = right + RIGHT + COLUMN_SPACE;
    }
    columns
}

/// Returns the room above a panel \[mm\].
fn head(panel: &Panel, legend_width: f64) -> f64 {
    let title = if panel.title.is_empty() { 0.0 } else { TITLE };
    TOP.max(title + legend::height(panel, legend_width))
}

/// Returns the room below a panel \[mm\].
fn foot(cell: &PanelCell<'_>) -> f64 {
    match (cell.numbered.0, cell.axis.label.is_empty()) {
        (false, _) => TICK.0,
        (true, true) => FOOT.0,
        (true, false) => FOOT.0 + FOOT.1,
    }
}

/// Returns the room left of a panel for the label and the numbers of its y axis \[mm\].
fn gutter(cell: &PanelCell<'_>, ruler: &Ruler, height: f64) -> f64 {
    if !cell.numbered.1 {
        return TICK.0;
    }
    let panel = cell.panel;
    let lines = if panel.y.label.is_empty() {
        0
    } else {
        text::broken(&panel.y.label, LABEL_POINTS, height + OVERHANG).len()
    };
    ruler.widest() + TICK.0 + TICK.1 + 0.6 + LABEL_LINE * count(lines)
}

/// Turns a count into a factor.
fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}
