//! Response spectra as a table and as a picture.

use pounding_plot::{Axis, Curve, CurveKind, Figure, Legend, Panel, PlotError, Shade, render_both, writable};
use pounding_scene::{DuctilitySpectrum, DuctilityValues, PairSpectrum, PairValues, SpectralValues, Spectrum};
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

/// A row for each damping ratio, ductility and period.
pub fn ductility_table(spectra: &[DuctilitySpectrum]) -> Table<'_, ([f64; 2], DuctilityValues)> {
    let rows = spectra.iter().flat_map(|spectrum| {
        let of = [spectrum.damping_ratio, spectrum.ductility];
        spectrum.values.iter().map(move |values| (of, *values))
    });
    let table = Table::of(rows)
        .column("damping_ratio", |([damping, _], _)| Cell::exact(*damping))
        .column("ductility", |([_, ductility], _)| Cell::exact(*ductility));
    ductility_columns(table, |(_, values)| values)
}

/// Returns the table with the strength of a structure of one period.
pub fn ductility_columns<'a, Of: 'a>(table: Table<'a, Of>, values: fn(&Of) -> &DuctilityValues) -> Table<'a, Of> {
    table
        .number("period_s", "Period", &Unit::PERIOD, move |row| values(row).period)
        .number("yield_acceleration_m_per_s2", "fy/m", &Unit::ACCELERATION, move |row| {
            values(row).yield_acceleration
        })
        .number("sd_m", "Sd", &Unit::METRE, move |row| values(row).displacement)
        .number("strength_reduction", "R", &Unit::ONE, move |row| values(row).strength_reduction)
}

/// A row for each frequency \[Hz\] and its Fourier amplitude \[m/s\].
pub fn fourier_table<'a>(amplitudes: Vec<[f64; 2]>) -> Table<'a, [f64; 2]> {
    Table::of(amplitudes)
        .number("frequency_hz", "Frequency", &Unit::HERTZ, |[frequency, _]| *frequency)
        .number("fourier_amplitude_m_per_s", "Amplitude", &Unit::SPEED, |[_, amplitude]| *amplitude)
}

/// A row for each pair of horizontal components, damping ratio and period; `pairs` has the name of each pair and its spectra.
pub fn pair_spectra_table<'p>(pairs: &'p [(String, Vec<PairSpectrum>)]) -> Table<'p, (&'p str, f64, &'p PairValues)> {
    let rows = pairs.iter().flat_map(|(name, spectra)| {
        let of_ratio = move |one: &'p PairSpectrum| one.values.iter().map(move |values| (name.as_str(), one.damping_ratio, values));
        spectra.iter().flat_map(of_ratio)
    });
    let table = Table::of(rows)
        .column("pair", |(name, ..)| (*name).to_owned())
        .column("damping_ratio", |(_, damping, _)| Cell::exact(*damping));
    pair_spectral_columns(table, |(.., values)| values)
}

/// A pseudo-acceleration of a structure under two components \[m/s²\].
type PairValue = fn(&PairValues) -> f64;

/// Returns the table with the pseudo-accelerations of a structure of one period under two horizontal components.
pub fn pair_spectral_columns<'a, Of: 'a>(table: Table<'a, Of>, values: fn(&Of) -> &PairValues) -> Table<'a, Of> {
    let table = table.number("period_s", "Period", &Unit::PERIOD, move |row| values(row).period);
    let columns: [(&str, &str, PairValue); 6] = [
        ("first_sa_m_per_s2", "first", |one| one.of_components[0]),
        ("second_sa_m_per_s2", "second", |one| one.of_components[1]),
        ("geometric_mean_sa_m_per_s2", "geo. mean", |one| one.geometric_mean),
        ("rotd00_sa_m_per_s2", "RotD00", |one| one.rotd00),
        ("rotd50_sa_m_per_s2", "RotD50", |one| one.rotd50),
        ("rotd100_sa_m_per_s2", "RotD100", |one| one.rotd100),
    ];
    columns.into_iter().fold(table, |table, (name, heading, value)| {
        table.number(name, heading, &Unit::ACCELERATION, move |row| value(values(row)))
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
