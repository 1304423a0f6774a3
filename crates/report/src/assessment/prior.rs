//! Sentences of an assessment about a neighbour that is not known.

use pounding_assess::{Distribution, GapAssessment};
use pounding_scene::file::{DrawnNeighbour, UnknownNeighbour};
use pounding_text::{digits, millimetres, millimetres_up, two_decimals};
use serde_json::{Value, json};

use super::AssessmentReport;
use super::tables::statistics;

/// Probabilities whose width is reported \[–\].
const PROBABILITIES: [f64; 4] = [0.5, 0.84, 0.95, 1.0];

/// A neighbour that was drawn, over all events.
pub(super) struct OfNeighbour {
    pub(super) drawn: DrawnNeighbour,
    /// Width that its gap needs \[m\].
    pub(super) required: Distribution,
    /// Number of runs in which it is touched.
    touching: usize,
}

impl AssessmentReport {
    /// The assumptions about the neighbour, if it is not known.
    fn unknown(&self) -> Option<&UnknownNeighbour> {
        let neighbour = self.asked.neighbour.as_ref();
        neighbour.map(|neighbour| &neighbour.unknown)
    }

    /// The gap beside the unknown neighbour, the last of the row.
    fn gap_beside_unknown(&self) -> Option<&GapAssessment> {
        self.unknown()?;
        self.assessment.gaps.last()
    }

    /// Every neighbour that was drawn, by period; empty if all are known.
    pub(super) fn neighbours(&self) -> Vec<OfNeighbour> {
        let Some(gap) = self.gap_beside_unknown() else {
            return Vec::new();
        };
        let mut drawn: Vec<DrawnNeighbour> = Vec::new();
        for one in self.motions.iter().filter_map(|motion| motion.neighbour) {
            if !drawn.contains(&one) {
                drawn.push(one);
            }
        }
        let of = |drawn: DrawnNeighbour| {
            let of_events = self.motions.iter().filter(|motion| motion.neighbour == Some(drawn));
            let own = of_events.clone().map(|motion| &motion.run);
            let needed = of_events.filter_map(|motion| {
                let mut gaps = motion.run.separations.iter();
                gaps.find(|one| one.left == gap.left).map(|one| ([motion.event, 0], one.required))
            });
            let facing = self.floors.facing().iter().enumerate();
            let pairs: Vec<usize> = facing
                .filter(|(_, pair)| pair.contact == gap.left)
                .map(|(index, _)| index)
                .collect();
            let touches = |run: &&pounding_assess::AssessedRun| pairs.iter().any(|pair| run.pairs[*pair].collisions > 0);
            Some(OfNeighbour {
                drawn,
                required: Distribution::of_cases(needed)?,
                touching: own.filter(touches).count(),
            })
        };
        drawn.into_iter().filter_map(of).collect()
    }

    /// The width beside an unknown neighbour with its probability, in sentences; empty if all are known.
    pub fn prior(&self) -> Vec<String> {
        let (Some(unknown), Some(gap)) = (self.unknown(), self.gap_beside_unknown()) else {
            return Vec::new();
        };
        let neighbours = self.neighbours();
        let beside = self.scene.structures[gap.left].name();
        let range = |[from, to]: [f64; 2]| format!("{} to {}", digits(from), digits(to));
        let widths = PROBABILITIES.map(|part| {
            let width = millimetres(gap.built(gap.required.quantile(part)));
            if part < 1.0 {
                format!("{:.0} %: {width} mm", 100.0 * part)
            } else {
                format!("in all: {width} mm")
            }
        });
        let (enough, is_enough) = if self.over_capacity().is_empty() {
            ("Enough", "is enough")
        } else {
            ("Floors stay apart", "keeps floors apart")
        };
        let mut said = vec![format!(
            "The neighbour of {beside} is not known. Drawn: {} with periods of {} s and {} times its mass, all as likely by their logarithms, \
             each under every motion. {enough} with a probability of {}.",
            neighbours.len(),
            range(unknown.period_s),
            range(unknown.mass_ratio),
            widths.join(", ")
        )];
        let worst = neighbours
            .iter()
            .max_by(|one, other| one.required.largest().total_cmp(&other.required.largest()));
        if let Some(OfNeighbour { drawn, required, .. }) = worst {
            let enough = gap.own.map_or_else(String::new, |own| {
                let free = neighbours.iter().filter(|one| one.touching == 0).count();
                let free = match free {
                    0 => "none".into(),
                    n => n.to_string(),
                };
                let own = millimetres(own);
                format!("{own} mm {is_enough} in every run beside {free} of them. ")
            });
            said.push(format!(
                "{enough}Most is needed beside one with a period of {} s: {} mm.",
                two_decimals(drawn.period_s),
                millimetres_up(required.largest())
            ));
        }
        said
    }

    /// The assumptions for programs; null if all neighbours are known.
    pub(super) fn prior_json(&self) -> Value {
        let (Some(unknown), Some(gap)) = (self.unknown(), self.gap_beside_unknown()) else {
            return Value::Null;
        };
        let width = |part: &f64| json!({"probability": part, "required_m": gap.required.quantile(*part)});
        let one = |one: &OfNeighbour| {
            json!({
                "period_s": one.drawn.period_s,
                "mass_ratio": one.drawn.mass_ratio,
                "required_m": statistics(&one.required),
                "touching_runs": gap.own.map(|_| one.touching),
            })
        };
        json!({
            "unknown": unknown,
            "widths": PROBABILITIES.iter().map(width).collect::<Vec<_>>(),
            "drawn": self.neighbours().iter().map(one).collect::<Vec<_>>(),
        })
    }
}
