//! Response spectra as a table and as a picture.

use pounding_plot::{Axis, Curve, CurveKind, Figure, Legend, Panel, PlotError, Shade, render_both, writable};
use pounding_scene::{SpectralValues, Spectrum};
use pounding_text::{Cell, Table, Unit, digits};

/// How spectra are shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectraLabels<'t> {
    /// The title; letters without a picture in the bundled font become question marks.
    pub title: &'t str,
    /// Acceleration of gravity \[m/s²\].
    pub gravity: f64,
}

/// Colours of the damping ratios, the first seven apart.
const SHADES: [Shade; 7] = [
    Shade::Blue,
    Shade::Vermilion,
    Shade::Ink,
    Shade::Green,
    Shade::Amber,
    Shade::Rose,
    Shade::Grey,
];

/// Draws spectra of one record over the period as SVG and PNG: pseudo-acceleration, pseudo-velocity, displacement.
///
/// Periods of 0 are left out: the axis is logarithmic.
///
/// # Errors
/// [`PlotError`] for values that are not finite.
pub fn spectra_figure(spectra: &[Spectrum], shown: SpectraLabels<'_>) -> Result<(String, Vec<u8>), PlotError> {
    render_both(&figure(spectra, shown))
}

/// A row for each damping ratio and period.
pub fn spectra_table(spectra: &[Spectrum]) -> Table<'_, (f64, &SpectralValues)> {
    let rows = spectra
        .iter()
        .flat_map(|spectrum| spectrum.values.iter().map(move |values| (spectrum.damping_ratio, values)));
    let table = Table::of(rows).column("damping_ratio", |(damping, _)| Cell::exact(*damping));
    spectral_columns(table, |(_, values)| values)
}

/// Returns the table with the responses of a structure of one period.
pub fn spectral_columns<'a, Of: 'a>(table: Table<'a, Of>, values: fn(&Of) -> &SpectralValues) -> Table<'a, Of> {
    table
        .number("period_s", "Period", &Unit::PERIOD, move |row| values(row).period)
        .number("sd_m", "Sd", &Unit::METRE, move |row| values(row).displacement)
        .number("pseudo_sv_m_per_s", "pseudo-Sv", &Unit::SPEED, move |row| {
            values(row).pseudo_velocity
        })
        .number("pseudo_sa_m_per_s2", "pseudo-Sa", &Unit::ACCELERATION, move |row| {
            values(row).pseudo_acceleration
        })
        .number("sa_m_per_s2", "Sa", &Unit::ACCELERATION, move |row| {
            values(row).absolute_acceleration
        })
}

fn figure(spectra: &[Spectrum], shown: SpectraLabels<'_>) -> Figure {
    let panel = |label: &str, quantity: fn(&SpectralValues, f64) -> f64| {
        let curve = |(spectrum, shade): (&Spectrum, &Shade)| {
            let points = spectrum.values.iter().filter(|values| values.period > 0.0);
            let points = points.map(|values| (values.period, quantity(values, shown.gravity)));
            let damping = format!("{} % damping", digits(100.0 * spectrum.damping_ratio));
            Curve::new(CurveKind::Line, *shade, points.collect()).named(damping)
        };
        Panel {
            y: Axis::auto(label),
            curves: spectra.iter().zip(SHADES.iter().cycle()).map(curve).collect(),
            legend: Legend::Shared,
            ..Panel::default()
        }
    };
    let mut panels = vec![
        panel("Pseudo-Sa (g)", |values, gravity| values.pseudo_acceleration / gravity),
        panel("Pseudo-Sv (m/s)", |values, _| values.pseudo_velocity),
        panel("Sd (mm)", |values, _| 1e3 * values.displacement),
    ];
    panels[0].title = writable(shown.title);
    Figure {
        height_in: 6.4,
        x: Axis::auto("Period (s)").log(),
        panels,
        ..Figure::default()
    }
}
