//! Response spectra of the motions.

use super::shaking::{DAMPING, Shaking};
use super::short;
use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Panel, Shade};
use pounding_scene::{periods_between, response_spectrum};

/// Periods shown \[s\], and how many.
const PERIODS: (f64, f64, u32) = (0.1, 5.0, 100);

/// Colours of the motions of a panel.
const SHADES: [Shade; 3] = [Shade::Ink, Shade::Blue, Shade::Vermilion];

/// Most panels in a row.
const COLUMNS: usize = 2;

/// Room above the lowest and the highest value, as a factor.
const ROOM: f64 = 1.15;

/// Pseudo-acceleration of every motion that has a spectrum, with marks at the periods of the structures \[s\].
pub(super) fn figure(motions: &[Shaking], structures: &[f64]) -> Figure {
    let (from, to, count) = PERIODS;
    let periods = periods_between(from, to, count);
    let curve = |(motion, shade): (&Shaking, Shade)| {
        let spectrum = response_spectrum(&motion.heard(), &periods, DAMPING).ok()?;
        let points: Vec<_> = spectrum.iter().map(|values| (values.period, values.pseudo_acceleration)).collect();
        // What does not move has no place on a logarithmic axis.
        let moves = points.iter().all(|(_, value)| *value > 0.0);
        moves.then(|| Curve::new(Kind::Line, shade, points).named(short(&motion.name)))
    };
    let panels: Vec<Vec<Curve>> = motions
        .chunks(SHADES.len())
        .map(|some| some.iter().zip(SHADES).filter_map(curve).collect())
        .collect();
    let values = || panels.iter().flatten().flat_map(|curve| &curve.points);
    let lowest = values().fold(f64::INFINITY, |low, (_, value)| low.min(*value));
    let highest = values().fold(0.0_f64, |high, (_, value)| high.max(*value));
    let range = (lowest < highest).then_some((lowest / ROOM, highest * ROOM));
    let (n_rows, n_columns) = (panels.len().div_ceil(COLUMNS), COLUMNS.min(panels.len().max(1)));
    let panel = |curves| Panel {
        y: Axis {
            range,
            ..Axis::auto("Pseudo-acceleration (m/s²)").log()
        },
        curves,
        markers: structures.to_vec(),
        legend: Legend::Inside,
        ..Panel::default()
    };
    let x = Axis::over("Period (s)", from, to).log();
    Figure::grid(0.4 + 2.5 * n_rows as f64, n_columns, x, panels.into_iter().map(panel).collect()).labelled_at_left()
}
