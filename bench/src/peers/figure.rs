//! Figure of error over CPU time for programs that solve equal scenes.

use pounding_plot::{Axis, Curve, CurveKind, Figure, Mark, Panel, PlotError, Shade, render_png};

/// Smaller errors are rounding \[–\].
const ROUNDING: f64 = 1e-14;
/// Larger errors are not drawn \[–\].
const WORTHLESS: f64 = 1e1;

/// A solver of the scenes; its methods share a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Competitor {
    /// This project.
    Ours,
    /// A loop of a few lines, compiled.
    Loop,
    /// `SciPy`.
    Scipy,
    /// `SUNDIALS`.
    Sundials,
    /// `OpenSees`.
    OpenSees,
}

/// CPU times and errors of a method over its settings.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct WorkPrecision {
    /// The solver of the method.
    pub(super) competitor: Competitor,
    /// Name in the legend, after that of the solver.
    pub(super) label: String,
    /// CPU time in some unit and relative error of each setting, both > 0.
    pub(super) points: Vec<(f64, f64)>,
}

impl Competitor {
    fn shade(self) -> Shade {
        match self {
            Self::Ours => Shade::Blue,
            Self::Loop => Shade::Green,
            Self::Scipy => Shade::Amber,
            Self::Sundials => Shade::Vermilion,
            Self::OpenSees => Shade::Ink,
        }
    }

    /// Marks of the solver's methods, in their order.
    fn marks(self) -> [Mark; 4] {
        match self {
            Self::Ours => [Mark::Disc, Mark::Square, Mark::Diamond, Mark::Inverted],
            Self::Loop | Self::Scipy | Self::Sundials | Self::OpenSees => {
                [Mark::Ring, Mark::HollowSquare, Mark::HollowTriangle, Mark::HollowDiamond]
            }
        }
    }
}

/// Panels over one axis of CPU time, each with its title and its methods, as a PNG.
///
/// The position of a method among its solver's methods, equal in all panels, chooses its mark. The CPU time of our central differences with
/// steps of 0.01 s is 1.
///
/// # Errors
/// [`PlotError`] if a number cannot be drawn.
pub(super) fn work_precision_figure(panels: &[(&str, Vec<WorkPrecision>)]) -> Result<Vec<u8>, PlotError> {
    let mut names: Vec<(Competitor, &str)> = Vec::new();
    for one in panels.iter().flat_map(|(_, methods)| methods) {
        let name = (one.competitor, one.label.as_str());
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let panel = |(title, methods): &(&str, Vec<WorkPrecision>)| {
        let y = Axis::over("Relative error", ROUNDING, WORTHLESS).log();
        Panel::shared(*title, y, methods.iter().map(|one| curve(one, &names)).collect())
    };
    let x = Axis::auto("CPU time / ours, steps of 0.01 s").log();
    render_png(&Figure::grid(4.6, panels.len(), x, panels.iter().map(panel).collect()).labelled_at_left())
}

fn curve(one: &WorkPrecision, names: &[(Competitor, &str)]) -> Curve {
    let own = names.iter().filter(|(whose, _)| *whose == one.competitor);
    let place = own.map(|(_, label)| *label).position(|label| label == one.label);
    let marks = one.competitor.marks();
    let mark = marks[place.unwrap_or(0) % marks.len()];
    let visible = one.points.iter().filter(|(_, error)| *error < WORTHLESS);
    let points = visible.map(|(time, error)| (*time, error.max(ROUNDING)));
    let curve = Curve::new(CurveKind::Line, one.competitor.shade(), points.collect());
    curve.marked(mark).named(one.label.clone())
}
