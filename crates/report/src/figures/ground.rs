//! The ground motion, and what it does to structures of all periods.

use super::thin::thinned;
use super::{Seen, around, brief, heights, named};
use pounding_plot::{Axis, Curve, Figure, Kind, Mark, Note, Panel, Shade};
use pounding_scene::{SpectralValues, response_spectrum};

/// Number of periods of the spectrum.
const PERIODS: u32 = 120;
/// Periods that every spectrum shows \[s\].
const USUAL: (f64, f64) = (0.05, 4.0);
/// The spectrum reaches beyond the periods of the structures by this factor.
const BEYOND: f64 = 1.25;
/// Damping ratio of the spectrum \[–\].
const DAMPING_RATIO: f64 = 0.05;

/// What stands at the periods of structures.
const MARKS: [Mark; 6] = [
    Mark::Disc,
    Mark::Square,
    Mark::Triangle,
    Mark::Diamond,
    Mark::Inverted,
    Mark::Ring,
];

pub(super) fn figure(seen: &Seen<'_>) -> (Figure, String) {
    let gravity = seen.prepared.scene().record.gravity_m_per_s2;
    let spectrum = spectrum(seen, gravity);
    let spectral = match spectrum {
        Some(_) => {
            " Below, its pseudo-acceleration spectrum for a damping ratio of 5 %, with the periods of the structures marked."
        }
        None => " Its response spectrum could not be computed.",
    };
    let caption = format!(
        "Ground acceleration as the scene uses it.{spectral} {}",
        seen.shown.left_out
    );
    let panels: Vec<Panel> = std::iter::once(acceleration(seen, gravity))
        .chain(spectrum)
        .collect();
    let figure = Figure {
        height_in: 0.6 + 2.2 * panels.len() as f64,
        panels,
        ..Figure::default()
    };
    (figure, caption.trim_end().into())
}

fn acceleration(seen: &Seen<'_>, gravity: f64) -> Panel {
    let record = seen.prepared.record();
    let duration = seen.prepared.duration();
    let samples = record.samples().iter().enumerate();
    let points = samples.map(|(i, sample)| (i as f64 * record.time_step(), sample / gravity));
    let points = thinned(points.take_while(|point| point.0 <= duration).collect());
    let peak = points.iter().copied().reduce(|most, next| {
        if next.1.abs() > most.1.abs() {
            next
        } else {
            most
        }
    });
    let note = peak.map(|peak| {
        let text = format!("{} g at {} s", brief(peak.1, 3), brief(peak.0, 4));
        Note::new(peak, text)
    });
    let marked = Curve::new(Kind::Points, Shade::Vermilion, peak.into_iter().collect());
    Panel {
        x: Some(Axis::over("Time (s)", 0.0, duration)),
        y: Axis::auto("Ground acceleration (g)"),
        levels: vec![0.0],
        notes: note.into_iter().collect(),
        curves: vec![Curve::new(Kind::Thin, Shade::Blue, points), marked],
        ..Panel::default()
    }
}

/// Nothing where the spectrum is refused: a period so short that the record holds some hundred thousand.
fn spectrum(seen: &Seen<'_>, gravity: f64) -> Option<Panel> {
    let (scene, floors) = (seen.prepared.scene(), seen.prepared.floors().all());
    let shown = seen.shown.floors.iter();
    let own: Vec<(usize, f64)> = shown
        .filter_map(|&index| Some((index, floors[index].oscillation(scene)?.0)))
        .collect();
    let shortest = own.iter().map(|one| one.1 / BEYOND).fold(USUAL.0, f64::min);
    let longest = own.iter().map(|one| one.1 * BEYOND).fold(USUAL.1, f64::max);
    let step = libm::log(longest / shortest) / f64::from(PERIODS - 1);
    let mut periods: Vec<f64> = (0..PERIODS)
        .map(|index| shortest * libm::exp(f64::from(index) * step))
        .collect();
    periods.extend(own.iter().map(|one| one.1));
    let values = response_spectrum(seen.prepared.record(), &periods, DAMPING_RATIO).ok()?;
    let point = |value: &SpectralValues| (value.period, value.pseudo_acceleration / gravity);
    let of_structures = &values[PERIODS as usize..];
    let mut all: Vec<(f64, f64)> = values.iter().map(point).collect();
    all.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut curves = vec![Curve::new(Kind::Line, Shade::Grey, all)];
    for (position, (&(index, _), value)) in own.iter().zip(of_structures).enumerate() {
        let curve = Curve::new(Kind::Points, Shade::nth(position), vec![point(value)]);
        let label = named(seen.prepared, index, true);
        curves.push(curve.marked(MARKS[position % MARKS.len()]).named(label));
    }
    Some(Panel {
        x: Some(Axis::over("Natural period (s)", periods[0], longest).log()),
        y: Axis {
            range: around(heights(&curves).chain([0.0]), 0.0, 0.08),
            ..Axis::auto("Pseudo-acceleration (g)")
        },
        curves,
        ..Panel::default()
    })
}
