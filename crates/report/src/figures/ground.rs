//! The ground motion, and its response spectrum.

use super::thin::thinned;
use super::{Seen, around, brief, fitting, heights};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Mark, Note, Panel, Shade};
use pounding_scene::{SpectralValues, Structure, response_spectrum};

/// Number of periods of the spectrum.
const PERIODS: u32 = 120;
/// Periods that every spectrum shows \[s\].
const USUAL: (f64, f64) = (0.05, 4.0);
/// The spectrum reaches beyond the periods of the structures by this factor.
const BEYOND: f64 = 1.25;
/// Damping ratio of the spectrum \[–\].
const DAMPING_RATIO: f64 = 0.05;

/// Labels at the periods of structures.
const MARKS: [Mark; 6] = [Mark::Disc, Mark::Square, Mark::Triangle, Mark::Diamond, Mark::Inverted, Mark::Ring];

pub(super) fn figure(seen: &Seen<'_>) -> (Figure, String) {
    let gravity = seen.prepared.scene().record.gravity_m_per_s2;
    let spectrum = spectrum(seen, gravity);
    let spectral = match spectrum {
        Some(_) => {
            " Below, its pseudo-acceleration spectrum for a damping ratio of 5 %, with the periods of the structures marked. Grey upright lines: 0.2 times the shortest and 2 \
                    times the longest period, between which codes compare spectra."
        }
        None => " Its response spectrum could not be computed.",
    };
    let structures = seen.prepared.scene().structures.iter();
    let left_out = match structures.filter_map(Structure::period).count() {
        n if n > MARKS.len() => format!(" Of {n} structures those are marked whose pairs are hit hardest, or come closest to it."),
        _ => String::new(),
    };
    let caption = format!("Ground acceleration as the scene uses it.{spectral}{left_out}");
    let panels: Vec<Panel> = std::iter::once(acceleration(seen, gravity)).chain(spectrum).collect();
    let figure = Figure {
        height_in: 0.6 + 2.2 * panels.len() as f64,
        panels,
        ..Figure::default()
    };
    (figure, caption)
}

fn acceleration(seen: &Seen<'_>, gravity: f64) -> Panel {
    let record = seen.prepared.record();
    let duration = seen.until;
    let samples = record.samples().iter().enumerate();
    let points = samples.map(|(i, sample)| (i as f64 * record.time_step(), sample / gravity));
    let points = thinned(points.take_while(|point| point.0 <= duration).collect());
    let peak = points
        .iter()
        .copied()
        .reduce(|most, next| if next.1.abs() > most.1.abs() { next } else { most });
    let note = peak.map(|peak| {
        let text = format!("{} g at {} s", brief(peak.1, 3), brief(peak.0, 4));
        Note::new(peak, text)
    });
    let marked = Curve::new(CurveKind::Points, Shade::Vermilion, peak.into_iter().collect());
    Panel {
        x: Some(Axis::over("Time (s)", 0.0, duration)),
        y: Axis::auto("Ground acceleration (g)"),
        levels: vec![0.0],
        notes: note.into_iter().collect(),
        curves: vec![Curve::new(CurveKind::Thin, Shade::Blue, points), marked],
        ..Panel::default()
    }
}

/// Names and first periods \[s\] of the structures that move: of all, or of so many as there are marks those that the other pictures
/// show.
fn periods_of(seen: &Seen<'_>) -> Vec<(String, f64)> {
    let (scene, floors) = (seen.prepared.scene(), seen.prepared.floors().all());
    let moving = scene.structures.iter().enumerate();
    let mut all: Vec<_> = moving
        .filter_map(|(index, one)| Some((index, fitting(one.name()), one.period()?)))
        .collect();
    if all.len() > MARKS.len() {
        let shown = |structure: usize| {
            let mut floors = seen.shown.floors.iter().map(|floor| &floors[*floor]);
            floors.any(|floor| floor.structure == structure)
        };
        all.retain(|(index, ..)| shown(*index));
    }
    all.into_iter().map(|(_, name, period)| (name, period)).collect()
}

/// `None` if the spectrum is refused: a period so short that the record holds some hundred thousand of them.
fn spectrum(seen: &Seen<'_>, gravity: f64) -> Option<Panel> {
    let own = periods_of(seen);
    let shortest = own.iter().map(|one| one.1 / BEYOND).fold(USUAL.0, f64::min);
    let longest = own.iter().map(|one| one.1 * BEYOND).fold(USUAL.1, f64::max);
    let step = libm::log(longest / shortest) / f64::from(PERIODS - 1);
    let mut periods: Vec<f64> = (0..PERIODS).map(|index| shortest * libm::exp(f64::from(index) * step)).collect();
    periods.extend(own.iter().map(|one| one.1));
    let values = response_spectrum(seen.prepared.record(), &periods, DAMPING_RATIO).ok()?;
    let point = |value: &SpectralValues| (value.period, value.pseudo_acceleration / gravity);
    let of_structures = &values[PERIODS as usize..];
    let mut all: Vec<(f64, f64)> = values.iter().map(point).collect();
    all.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut curves = vec![Curve::new(CurveKind::Line, Shade::Grey, all)];
    for (position, ((name, period), value)) in own.iter().zip(of_structures).enumerate() {
        let curve = Curve::new(CurveKind::Points, Shade::nth(position), vec![point(value)]);
        let label = format!("{name} (T = {} s)", brief(*period, 3));
        curves.push(curve.marked(MARKS[position % MARKS.len()]).named(label));
    }
    let ends = own
        .iter()
        .fold([f64::INFINITY, 0.0], |[least, most], one| [one.1.min(least), one.1.max(most)]);
    let between = [0.2 * ends[0], 2.0 * ends[1]].into_iter();
    Some(Panel {
        markers: between.filter(|period| (periods[0]..=longest).contains(period)).collect(),
        x: Some(Axis::over("Natural period (s)", periods[0], longest).log()),
        y: Axis {
            range: around(heights(&curves).chain([0.0]), 0.0, 0.08),
            ..Axis::auto("Pseudo-acceleration (g)")
        },
        curves,
        ..Panel::default()
    })
}
