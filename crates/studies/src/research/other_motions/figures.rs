//! Figures of peak displacements with pounding over those without, under every motion in both directions, and of response spectra of the
//! motions.

use std::ops::Range;

use super::shaking::{DAMPING, Shaking};
use super::world::{MotionCase, StructureResult};
use super::{Beyond, Group, short};
use crate::files::capital;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Legend, Mark, Panel, Shade};
use pounding_scene::{periods_between, response_spectrum};

/// Tables of the layouts with the names of their contact laws.
const TABLES: [(&str, &str); 2] = [("6", "stereomechanical"), ("7", "viscoelastic")];

/// The layouts, one column each.
const LAYOUTS: [&str; 3] = ["A", "B", "C"];
const COLUMNS: usize = LAYOUTS.len();

/// Least number of motions to leave room for: with fewer, the labels beside the panels would not fit.
const LEAST: usize = 8;

/// Distance of a direction from the line of its motion, and of a kind of structure from the line of its direction, in lines.
const APART: [f64; 2] = [0.2, 0.09];

/// Colours and marks of structures by their names, as given and reversed.
const LOOKS: [(Shade, [Mark; 2]); 3] = [
    (Shade::Blue, [Mark::Disc, Mark::Ring]),
    (Shade::Vermilion, [Mark::Square, Mark::HollowSquare]),
    (Shade::Ink, [Mark::Triangle, Mark::HollowTriangle]),
];

/// Figure with one panel per layout, behaviour and contact law.
pub(super) fn response(beyond: &Beyond, group: &Group, motions: Range<usize>) -> Figure {
    let worlds = &group.worlds[motions.clone()];
    let names: Vec<String> = beyond.motions[motions].iter().map(|motion| short(&motion.name)).collect();
    let mut panels = Vec::new();
    for behaviour in ["elastic", "nonlinear"] {
        for (table, law) in TABLES {
            for layout in LAYOUTS {
                let scene = format!("layout {layout} {behaviour}");
                let of_scene = |row: &&StructureResult| row.table == table && row.scene == scene;
                let y = Axis {
                    label: format!("{}, {law}", capital(behaviour)),
                    ..Axis::names(names.clone())
                };
                let title = if panels.len() < COLUMNS {
                    format!("Layout {layout}")
                } else {
                    String::new()
                };
                panels.push(Panel {
                    markers: vec![1.0],
                    ..Panel::shared(title, y, curves(worlds, of_scene))
                });
            }
        }
    }
    let height_in = 2.1 + 0.52 * names.len().max(LEAST) as f64;
    Figure::grid(height_in, COLUMNS, Axis::auto("Displacement over alone"), panels).labelled_at_left()
}

/// Curves with, for every kind of structure, the largest peak displacement over the one without pounding.
fn curves(worlds: &[[MotionCase; 2]], of_scene: impl Fn(&&StructureResult) -> bool) -> Vec<Curve> {
    let mut kinds: Vec<&str> = Vec::new();
    for row in worlds.iter().take(1).flat_map(|[world, _]| world.rows.iter().filter(&of_scene)) {
        if !kinds.contains(&&*row.structure) {
            kinds.push(&row.structure);
        }
    }
    kinds.sort_by(|one, other| other.cmp(one));
    let mut curves = Vec::new();
    for (rank, (kind, (shade, marks))) in kinds.into_iter().zip(LOOKS).enumerate() {
        for (direction, mark) in marks.into_iter().enumerate() {
            let point = |(line, both): (usize, &[MotionCase; 2])| {
                let rows = both[direction].rows.iter().filter(&of_scene);
                let own = rows.filter(|row| row.structure == kind);
                let largest = own.filter_map(StructureResult::amplification).max_by(f64::total_cmp)?;
                let aside = |index: usize, apart: f64| if index == 0 { -apart } else { apart };
                let [of_direction, of_kind] = APART;
                let line = line as f64 + aside(direction, of_direction) + aside(rank, of_kind);
                Some((largest, line))
            };
            let points = worlds.iter().enumerate().filter_map(point).collect();
            let name = format!("{}, {}", capital(kind), crate::files::direction(direction == 1));
            curves.push(Curve::new(CurveKind::Points, shade, points).marked(mark).named(name));
        }
    }
    curves
}

/// First and last period of the spectra \[s\], and the number of periods.
const PERIODS: (f64, f64, u32) = (0.1, 5.0, 100);

/// Colours of the motions of a panel.
const SHADES: [Shade; 3] = [Shade::Ink, Shade::Blue, Shade::Vermilion];

/// Largest number of panels in a row.
const SPECTRA_IN_A_ROW: usize = 2;

/// Room above the lowest and the highest value, as a factor.
const ROOM: f64 = 1.15;

/// Figure of the pseudo-acceleration of every motion with a spectrum, with marks at the periods of the structures \[s\].
pub(super) fn spectra(motions: &[Shaking], structures: &[f64]) -> Figure {
    let (from, to, count) = PERIODS;
    let periods = periods_between(from, to, count);
    let curve = |(motion, shade): (&Shaking, Shade)| {
        let spectrum = response_spectrum(&motion.heard(), &periods, DAMPING).ok()?;
        let points: Vec<_> = spectrum.iter().map(|values| (values.period, values.pseudo_acceleration)).collect();
        // A logarithmic axis cannot show the zeros of a motion without shaking.
        let moves = points.iter().all(|(_, value)| *value > 0.0);
        moves.then(|| Curve::new(CurveKind::Line, shade, points).named(short(&motion.name)))
    };
    let panels: Vec<Vec<Curve>> = motions
        .chunks(SHADES.len())
        .map(|some| some.iter().zip(SHADES).filter_map(curve).collect())
        .collect();
    let values = || panels.iter().flatten().flat_map(|curve| &curve.points);
    let lowest = values().fold(f64::INFINITY, |low, (_, value)| low.min(*value));
    let highest = values().fold(0.0_f64, |high, (_, value)| high.max(*value));
    let range = (lowest < highest).then_some((lowest / ROOM, highest * ROOM));
    let (n_rows, n_columns) = (panels.len().div_ceil(SPECTRA_IN_A_ROW), SPECTRA_IN_A_ROW.min(panels.len().max(1)));
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
