//! What pounding does to the middle of three structures, over the stiffness of the stiff ones: where a finding about it turns over.

mod figure;

use super::cases::{Case, each, rows, sdof};
use super::{Files, csv, drawn};
use crate::statistics::{quantile, sorted};
use crate::study::surveys::{HeldConstant, StiffnessRatio};
use crate::{StudyError, StudyFile};
use pounding_scene::{Scene, Structure};
use pounding_text::digits;
use strum::EnumCount;

/// Place of the middle structure.
const MIDDLE: usize = 1;
/// Time between the states from which plastic travel is summed \[s\].
const INTERVAL: f64 = 0.01;
/// Halvings of the distance of two ratios between which a finding turns over: to 2⁻⁸ of it.
const HALVINGS: usize = 8;

/// A layout with one thing kept.
#[derive(Debug)]
struct Line<'a> {
    scene: &'a Scene,
    kept: HeldConstant,
    /// What the middle structure does alone under every motion, where it is none of those that vary.
    alone: Option<Vec<Measured>>,
}

/// Peak displacement and plastic travel of a structure \[m\].
#[derive(Debug, Clone, Copy)]
struct Measured {
    peak: f64,
    travel: f64,
}

/// What happens to the middle structure, over what it does alone.
#[derive(Debug, Clone, Copy)]
struct Middle {
    peak: f64,
    /// Plastic travel; nothing where there is none alone.
    travel: Option<f64>,
}

/// Quantities of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount)]
enum Quantity {
    Peak,
    Travel,
}

impl Quantity {
    const ALL: [Self; Self::COUNT] = [Self::Peak, Self::Travel];

    fn of(self, middle: &Middle) -> Option<f64> {
        match self {
            Self::Peak => Some(middle.peak),
            Self::Travel => middle.travel,
        }
    }

    fn words(self) -> &'static str {
        match self {
            Self::Peak => "peak displacement",
            Self::Travel => "plastic travel",
        }
    }
}

/// The layouts under the motions.
struct Survey<'a> {
    settings: &'a StiffnessRatio,
    cases: &'a [Case],
    papers: Option<usize>,
}

/// A ratio at which a quantity passes that alone, rising or falling.
struct Turn {
    line: usize,
    quantity: Quantity,
    of_paper: bool,
    ratio: f64,
    rises: bool,
}

pub(super) fn files(settings: &StiffnessRatio, file: &StudyFile, cases: &[Case]) -> Result<Files, StudyError> {
    let scenes = rows(file, 3)?;
    let mut lines = Vec::new();
    for &kept in &settings.keeps {
        for scene in scenes {
            let varies = scene.structures[MIDDLE].name() == settings.stiff;
            let alone = (!varies).then(|| each(cases, |case| alone(case, scene)));
            let alone = alone.transpose()?;
            lines.push(Line { scene, kept, alone });
        }
    }
    let (name, reversed) = &settings.papers;
    let is_papers = |case: &Case| case.name == *name && case.reversed == *reversed;
    let survey = Survey {
        settings,
        cases,
        papers: cases.iter().position(is_papers),
    };
    let tasks: Vec<(usize, f64)> = (0..lines.len())
        .flat_map(|line| settings.stiffness_ratios.iter().map(move |ratio| (line, *ratio)))
        .collect();
    let found = each(&tasks, |&(line, ratio)| survey.middles(&lines[line], ratio))?;
    let per_line = settings.stiffness_ratios.len();
    let found: Vec<&[Vec<Middle>]> = found.chunks(per_line.max(1)).collect();
    let turns = survey.turns(&lines, &found)?;
    Ok(Files::from([
        ("middle.csv".into(), survey.table(&lines, &found)),
        ("turn-over.csv".into(), turn_table(&lines, &turns)),
        ("middle.png".into(), drawn(&survey.figure(&lines, &found, &turns), file)?),
    ]))
}

impl Line<'_> {
    fn scene(&self, settings: &StiffnessRatio, ratio: f64) -> Scene {
        let mut scene = self.scene.clone();
        let is_weak = |structure: &&Structure| structure.name() == settings.weak;
        let place = self.scene.structures.iter().position(|one| is_weak(&one));
        let of_weak = place.map_or(1.0, |place| sdof(&mut scene, place).stiffness_n_per_m);
        for place in 0..scene.structures.len() {
            if scene.structures[place].name() != settings.stiff {
                continue;
            }
            let stiff = sdof(&mut scene, place);
            let by = ratio * of_weak / stiff.stiffness_n_per_m;
            stiff.stiffness_n_per_m *= by;
            stiff.yield_force_n = stiff.yield_force_n.map(|force| by * force);
            if self.kept == HeldConstant::Period {
                stiff.mass_kg *= by;
            }
        }
        scene
    }
}

impl Survey<'_> {
    /// The middle structure under every motion.
    fn middles(&self, line: &Line<'_>, ratio: f64) -> Result<Vec<Middle>, StudyError> {
        let scene = line.scene(self.settings, ratio);
        let places: Vec<usize> = (0..self.cases.len()).collect();
        each(&places, |&place| {
            let case = &self.cases[place];
            let alone = match &line.alone {
                Some(alone) => alone[place],
                None => alone(case, &scene)?,
            };
            let beside = Measured::of(case, &scene, MIDDLE)?;
            Ok(Middle {
                peak: beside.peak / alone.peak,
                travel: (alone.travel > 0.0).then(|| beside.travel / alone.travel),
            })
        })
    }

    /// The number that is followed over ratios: of the paper's case, or the median of all.
    fn followed(&self, middles: &[Middle], quantity: Quantity, of_paper: bool) -> Option<f64> {
        if of_paper {
            return quantity.of(&middles[self.papers?]);
        }
        let known = sorted(middles.iter().filter_map(|middle| quantity.of(middle)));
        quantile(&known, 0.5)
    }

    /// Where what is followed passes one, halved down between the ratios of the grid.
    fn turns(&self, lines: &[Line<'_>], found: &[&[Vec<Middle>]]) -> Result<Vec<Turn>, StudyError> {
        let mut between = Vec::new();
        for (line, of_line) in found.iter().enumerate() {
            for quantity in Quantity::ALL {
                for of_paper in [true, false] {
                    let ratios = self.settings.stiffness_ratios.windows(2);
                    for (ratios, middles) in ratios.zip(of_line.windows(2)) {
                        let of = |index: usize| self.followed(&middles[index], quantity, of_paper);
                        if let (Some(one), Some(other)) = (of(0), of(1))
                            && (one < 1.0) != (other < 1.0)
                        {
                            between.push(((line, quantity, of_paper), (ratios[0], ratios[1]), one < 1.0));
                        }
                    }
                }
            }
        }
        each(&between, |&((line, quantity, of_paper), (mut low, mut high), rises)| {
            for _ in 0..HALVINGS {
                let ratio = (low * high).sqrt();
                let middles = self.middles(&lines[line], ratio)?;
                let is_less = self.followed(&middles, quantity, of_paper).is_some_and(|value| value < 1.0);
                if is_less == rises {
                    low = ratio;
                } else {
                    high = ratio;
                }
            }
            Ok(Turn {
                line,
                quantity,
                of_paper,
                ratio: (low * high).sqrt(),
                rises,
            })
        })
    }

    /// A row per layout, kept property, ratio and quantity.
    fn table(&self, lines: &[Line<'_>], found: &[&[Vec<Middle>]]) -> Vec<u8> {
        let header = [
            "scene",
            "kept",
            "stiffness_ratio",
            "quantity",
            "cases",
            "less_than_alone",
            "least_over_alone",
            "median_over_alone",
            "largest_over_alone",
            "papers_over_alone",
        ];
        let mut table = Vec::new();
        for (line, of_line) in lines.iter().zip(found) {
            for (ratio, middles) in self.settings.stiffness_ratios.iter().zip(*of_line) {
                for quantity in Quantity::ALL {
                    let known = sorted(middles.iter().filter_map(|one| quantity.of(one)));
                    if known.is_empty() {
                        continue;
                    }
                    let less = known.iter().filter(|value| **value < 1.0).count();
                    let mut row = vec![
                        line.scene.name.clone(),
                        line.kept.word().into(),
                        digits(*ratio),
                        quantity.words().into(),
                        known.len().to_string(),
                        less.to_string(),
                    ];
                    let parts = [0.0, 0.5, 1.0].map(|part| quantile(&known, part));
                    let papers = self.followed(middles, quantity, true);
                    let all = parts.into_iter().chain([papers]);
                    row.extend(all.map(|value| value.map_or_else(String::new, digits)));
                    table.push(row);
                }
            }
        }
        csv(&header, &table)
    }
}

/// A row per place at which a quantity passes that alone.
fn turn_table(lines: &[Line<'_>], turns: &[Turn]) -> Vec<u8> {
    let header = ["scene", "kept", "quantity", "of", "stiffness_ratio", "from_there_on"];
    let row = |turn: &Turn| {
        vec![
            lines[turn.line].scene.name.clone(),
            lines[turn.line].kept.word().into(),
            turn.quantity.words().into(),
            if turn.of_paper {
                "the paper's motion"
            } else {
                "median of all motions"
            }
            .into(),
            digits(turn.ratio),
            if turn.rises { "more than alone" } else { "less than alone" }.into(),
        ]
    };
    csv(&header, &turns.iter().map(row).collect::<Vec<_>>())
}

/// The middle structure of a scene without its neighbours.
fn alone(case: &Case, scene: &Scene) -> Result<Measured, StudyError> {
    let alone = Scene {
        structures: vec![scene.structures[MIDDLE].clone()],
        contacts: None,
        ..scene.clone()
    };
    Measured::of(case, &alone, 0)
}

impl Measured {
    /// What a structure does in a scene under a motion.
    fn of(case: &Case, scene: &Scene, place: usize) -> Result<Self, StudyError> {
        let Structure::Sdof(structure) = &scene.structures[place] else {
            unreachable!("a row of structures of one storey");
        };
        let yields = structure.yield_force_n.is_some();
        let outcome = case.prepared(scene)?.run(yields.then_some(INTERVAL))?;
        let plastic = outcome.histories.iter().flat_map(|histories| {
            let states = histories.of(place).states.iter();
            states.map(|state| state.displacement - state.restoring_force / structure.stiffness_n_per_m)
        });
        let (mut travel, mut before) = (0.0, 0.0);
        for plastic in plastic {
            // Where columns are elastic the difference is rounding.
            let step: f64 = plastic - before;
            if step.abs() > ROUNDING {
                travel += step.abs();
                before = plastic;
            }
        }
        Ok(Self {
            peak: outcome.peaks.of(place).displacement.value.abs(),
            travel,
        })
    }
}

/// Changes of the plastic displacement that are none \[m\].
const ROUNDING: f64 = 1e-9;
