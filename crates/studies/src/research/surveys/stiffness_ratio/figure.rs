//! The middle structure over the ratio of stiffnesses, a panel per layout and kept property.

use super::{Line, Middle, Quantity, Survey, Turn};
use crate::paper::figures::capital;
use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Note, Panel, Shade};

impl Survey<'_> {
    /// A panel per scene of a kept property: medians, and the paper's record; a note where pounding begins to help for good.
    pub(super) fn figure(&self, lines: &[Line<'_>], found: &[&[Vec<Middle>]], turns: &[Turn]) -> Figure {
        let ratios = &self.settings.stiffness_ratios;
        let n_scenes = lines.len() / self.settings.keeps.len().max(1);
        let panel = |(index, (line, of_line)): (usize, (&Line<'_>, &&[Vec<Middle>]))| {
            let marked = self.last_fall(turns, index, of_line);
            let note = |ratio: f64| Note::new((ratio, 1.0), short(ratio));
            let label = if index % COLUMNS.min(n_scenes) == 0 {
                "Middle / alone (–)"
            } else {
                ""
            };
            Panel {
                title: format!("{}, {} kept", capital(&line.scene.name), line.kept.word()),
                y: Axis::over(label, LEAST, MOST).log(),
                curves: self.curves(of_line),
                levels: vec![1.0],
                notes: marked.map(note).into_iter().collect(),
                legend: Legend::Shared,
                ..Panel::default()
            }
        };
        let panels: Vec<Panel> = lines.iter().zip(found).enumerate().map(panel).collect();
        let (from, to) = (ratios[0], ratios[ratios.len() - 1]);
        Figure {
            height_in: 0.9 + 1.9 * panels.len().div_ceil(COLUMNS) as f64,
            columns: COLUMNS,
            x: Axis::over("Stiff / weak stiffness (–)", from, to).log(),
            panels,
        }
    }

    /// The last ratio at which the median of the peaks of a line falls below that alone, if it is noticeably less beyond.
    fn last_fall(&self, turns: &[Turn], index: usize, of_line: &[Vec<Middle>]) -> Option<f64> {
        let falls = |turn: &&Turn| turn.line == index && !turn.of_paper && turn.quantity == Quantity::Peak && !turn.rises;
        let last = turns.iter().rfind(falls)?.ratio;
        let beyond = self.settings.stiffness_ratios.iter().zip(of_line);
        let mut beyond = beyond.filter(|(ratio, _)| **ratio > last);
        let less = |middles: &[Middle]| self.followed(middles, Quantity::Peak, false);
        beyond
            .any(|(_, middles)| less(middles).is_some_and(|value| value < NOTICED))
            .then_some(last)
    }

    /// What is followed over the ratios; what leaves the panel stays at its edge.
    fn curves(&self, of_line: &[Vec<Middle>]) -> Vec<Curve> {
        let looks = [(Quantity::Peak, Shade::Ink), (Quantity::Travel, Shade::Vermilion)];
        let both = looks.into_iter().flat_map(|look| [(look, false), (look, true)]);
        let curve = |((quantity, shade), of_paper): ((Quantity, Shade), bool)| {
            let point = |(ratio, middles): (&f64, &Vec<Middle>)| {
                let value = self.followed(middles, quantity, of_paper)?;
                Some((*ratio, value.clamp(LEAST, MOST)))
            };
            let ratios = self.settings.stiffness_ratios.iter();
            let points: Vec<_> = ratios.zip(of_line).filter_map(point).collect();
            let (kind, of) = if of_paper {
                (Kind::Dashed, "the paper's motion")
            } else {
                (Kind::Line, "median of all")
            };
            let name = format!("{}, {of}", capital(quantity.words()));
            (!points.is_empty()).then(|| Curve::new(kind, shade, points).named(name))
        };
        both.filter_map(curve).collect()
    }
}

/// What is noticeably less than alone.
const NOTICED: f64 = 0.95;
/// Panels side by side.
const COLUMNS: usize = 3;
/// Least and largest value over alone that is drawn.
const LEAST: f64 = 0.1;
const MOST: f64 = 10.0;

/// A ratio as it stands in a note.
fn short(ratio: f64) -> String {
    if ratio < 10.0 {
        format!("{ratio:.1}")
    } else {
        format!("{ratio:.0}")
    }
}
