//! Effect of pounding on the middle one of three structures, over the stiffness of the stiff ones, and where the effect changes its sign.

use super::cases::{Case, rows, sdof};
use crate::drivers::pairs;
use crate::files::{Files, capital, drawn};
use crate::listed::listed;
use crate::statistics::{quantile, sorted};
use crate::study::surveys::{HeldConstant, StiffnessRatio};
use crate::{StudyError, StudyFile};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Note, Panel, Shade};
use pounding_scene::{Scene, Structure, parallel};
use pounding_text::Table;

/// Index of the middle structure.
const MIDDLE: usize = 1;
/// Time between the states whose plastic travel is summed \[s\].
const INTERVAL: f64 = 0.01;
/// Number of bisections between two ratios where the effect changes its sign: the interval shrinks to 2⁻⁸.
const HALVINGS: usize = 8;

/// A layout with the property that stays constant.
#[derive(Debug)]
struct VariedLayout<'a> {
    scene: &'a Scene,
    kept: HeldConstant,
    /// Quantities of the middle structure without neighbours, for every motion. `None` if its own stiffness varies.
    alone: Option<Vec<StructureQuantities>>,
}

listed! {
    /// A quantity of a structure \[m\].
    enum Quantity { words: &'static str;
        Peak = "peak displacement",
        Travel = "plastic travel",
    }
}

/// Every quantity of a structure \[m\].
type StructureQuantities = [f64; Quantity::ALL.len()];

/// Every quantity of the middle structure over the one without neighbours; `None` if that is zero.
type Middle = [Option<f64>; Quantity::ALL.len()];

/// The layouts with their motions.
struct Survey<'a> {
    settings: &'a StiffnessRatio,
    cases: &'a [Case],
    papers: Option<usize>,
}

/// A stiffness ratio at which a quantity crosses its value without neighbours, rising or falling.
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
            let alone = (!varies)
                .then(|| parallel::try_each(cases, |case| alone(case, scene)))
                .transpose()?;
            lines.push(VariedLayout { scene, kept, alone });
        }
    }
    let (name, reversed) = &settings.papers;
    let is_papers = |case: &Case| case.name == *name && case.reversed == *reversed;
    let survey = Survey {
        settings,
        cases,
        papers: cases.iter().position(is_papers),
    };
    let tasks = pairs(&lines, &settings.stiffness_ratios);
    let found = parallel::try_each(&tasks, |(line, ratio)| survey.middles(line, **ratio))?;
    let per_line = settings.stiffness_ratios.len();
    let found: Vec<&[Vec<Middle>]> = found.chunks(per_line.max(1)).collect();
    let turns = survey.turns(&lines, &found)?;
    Ok(Files::from([
        ("middle.csv".into(), survey.table(&lines, &found).into_bytes()),
        ("turn-over.csv".into(), turn_table(&lines, &turns).into_bytes()),
        ("middle.png".into(), drawn(&survey.figure(&lines, &found, &turns), &file.path)?),
    ]))
}

impl VariedLayout<'_> {
    fn scene(&self, settings: &StiffnessRatio, ratio: f64) -> Scene {
        let mut scene = self.scene.clone();
        let weak = self.scene.structures.iter().position(|one| one.name() == settings.weak);
        let of_weak = weak.map_or(1.0, |place| sdof(&mut scene, place).stiffness_n_per_m);
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
    /// Quantities of the middle structure under every motion.
    fn middles(&self, line: &VariedLayout<'_>, ratio: f64) -> Result<Vec<Middle>, StudyError> {
        let scene = line.scene(self.settings, ratio);
        let places: Vec<usize> = (0..self.cases.len()).collect();
        parallel::try_each(&places, |&place| {
            let case = &self.cases[place];
            let alone = match &line.alone {
                Some(alone) => alone[place],
                None => alone(case, &scene)?,
            };
            let beside = measured(case, &scene, MIDDLE)?;
            let over = |quantity| {
                let (beside, alone) = (beside[quantity as usize], alone[quantity as usize]);
                (quantity == Quantity::Peak || alone > 0.0).then(|| beside / alone)
            };
            Ok(Quantity::ALL.map(over))
        })
    }

    /// The value to follow over stiffness ratios: that of the paper's case, or the median of all cases.
    fn followed(&self, middles: &[Middle], quantity: Quantity, of_paper: bool) -> Option<f64> {
        if of_paper {
            return middles[self.papers?][quantity as usize];
        }
        quantile(&known(middles, quantity), 0.5)
    }

    /// Finds where the followed value crosses one, by bisection between the ratios of the grid.
    fn turns(&self, lines: &[VariedLayout<'_>], found: &[&[Vec<Middle>]]) -> Result<Vec<Turn>, StudyError> {
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
        parallel::try_each(&between, |&((line, quantity, of_paper), (mut low, mut high), rises)| {
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

    /// Table with one row per layout, constant property, ratio and quantity.
    fn table<'s>(&self, lines: &'s [VariedLayout<'s>], found: &'s [&[Vec<Middle>]]) -> String {
        let of_line = |(line, of_line): (&'s VariedLayout<'s>, &'s &[Vec<Middle>])| {
            let of_ratio = move |(ratio, middles): (&f64, &'s Vec<Middle>)| {
                Quantity::ALL.map(|quantity| MiddleRow::of(line, *ratio, quantity, middles))
            };
            self.settings.stiffness_ratios.iter().zip(*of_line).flat_map(of_ratio)
        };
        let cells = lines.iter().zip(found).flat_map(of_line).filter(|one| !one.known.is_empty());
        Table::of(cells)
            .column("scene", |one| one.line.scene.name.clone())
            .column("kept", |one| one.line.kept.word())
            .column("stiffness_ratio", |one| one.ratio)
            .column("quantity", |one| one.quantity.words())
            .column("cases", |one| one.known.len())
            .column("less_than_alone", |one| one.known.iter().filter(|value| **value < 1.0).count())
            .column("least_over_alone", |one| quantile(&one.known, 0.0))
            .column("median_over_alone", |one| quantile(&one.known, 0.5))
            .column("largest_over_alone", |one| quantile(&one.known, 1.0))
            .column("papers_over_alone", |one| self.followed(one.middles, one.quantity, true))
            .csv()
    }

    /// Figure with one panel per layout and constant property: medians, and the paper's record. A note marks the ratio above which pounding
    /// helps.
    fn figure(&self, lines: &[VariedLayout<'_>], found: &[&[Vec<Middle>]], turns: &[Turn]) -> Figure {
        let ratios = &self.settings.stiffness_ratios;
        let panel = |(index, (line, of_line)): (usize, (&VariedLayout<'_>, &&[Vec<Middle>]))| {
            let note = |ratio: f64| Note::new((ratio, 1.0), format!("{ratio:.*}", usize::from(ratio < 10.0)));
            let title = format!("{}, {} kept", capital(&line.scene.name), line.kept.word());
            let y = Axis::over("Middle / alone (–)", LEAST, MOST).log();
            Panel {
                notes: self.last_fall(turns, index, of_line).map(note).into_iter().collect(),
                ..Panel::shared(title, y, self.curves(of_line)).with_level(1.0)
            }
        };
        let panels: Vec<Panel> = lines.iter().zip(found).enumerate().map(panel).collect();
        let x = Axis::over("Stiff / weak stiffness (–)", ratios[0], ratios[ratios.len() - 1]).log();
        Figure::grid(0.9 + 1.9 * panels.len().div_ceil(COLUMNS) as f64, COLUMNS, x, panels).labelled_at_left()
    }

    /// The last ratio at which the median peak falls below the peak without neighbours, if it becomes noticeably smaller beyond.
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

    /// Curves of the followed values over the ratios; values outside the panel stay at its edge.
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
                (CurveKind::Dashed, "the paper's motion")
            } else {
                (CurveKind::Line, "median of all")
            };
            let name = format!("{}, {of}", capital(quantity.words()));
            (!points.is_empty()).then(|| Curve::new(kind, shade, points).named(name))
        };
        both.filter_map(curve).collect()
    }
}

/// Largest value over the one without neighbours that is noticeably smaller \[–\].
const NOTICED: f64 = 0.95;
/// Number of panels in a row.
const COLUMNS: usize = 3;
/// Least and largest value over the one without neighbours in the figure \[–\].
const LEAST: f64 = 0.1;
const MOST: f64 = 10.0;

/// A quantity under all motions that have it, in rising order.
fn known(middles: &[Middle], quantity: Quantity) -> Vec<f64> {
    sorted(middles.iter().filter_map(|middle| middle[quantity as usize]))
}

/// A row of the table: a quantity of a layout at a stiffness ratio.
struct MiddleRow<'a> {
    line: &'a VariedLayout<'a>,
    ratio: f64,
    quantity: Quantity,
    middles: &'a [Middle],
    /// Values of the quantity in rising order.
    known: Vec<f64>,
}

impl<'a> MiddleRow<'a> {
    fn of(line: &'a VariedLayout<'a>, ratio: f64, quantity: Quantity, middles: &'a [Middle]) -> Self {
        Self {
            line,
            ratio,
            quantity,
            middles,
            known: known(middles, quantity),
        }
    }
}

/// Table with one row per crossing.
fn turn_table(lines: &[VariedLayout<'_>], turns: &[Turn]) -> String {
    Table::of(turns)
        .column("scene", |turn| lines[turn.line].scene.name.clone())
        .column("kept", |turn| lines[turn.line].kept.word())
        .column("quantity", |turn| turn.quantity.words())
        .column("of", |turn| {
            if turn.of_paper {
                "the paper's motion"
            } else {
                "median of all motions"
            }
        })
        .column("stiffness_ratio", |turn| turn.ratio)
        .column(
            "from_there_on",
            |turn| if turn.rises { "more than alone" } else { "less than alone" },
        )
        .csv()
}

/// Quantities of the middle structure of a scene without its neighbours.
fn alone(case: &Case, scene: &Scene) -> Result<StructureQuantities, StudyError> {
    let alone = Scene {
        structures: vec![scene.structures[MIDDLE].clone()],
        contacts: None,
        ..scene.clone()
    };
    measured(case, &alone, 0)
}

/// Quantities of a structure in a scene under a motion.
fn measured(case: &Case, scene: &Scene, place: usize) -> Result<StructureQuantities, StudyError> {
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
        // In elastic columns the difference is only rounding.
        let step: f64 = plastic - before;
        if step.abs() > ROUNDING {
            travel += step.abs();
            before = plastic;
        }
    }
    Ok([outcome.peaks.of(place).displacement.value.abs(), travel])
}

/// Largest change of a plastic displacement that counts as rounding \[m\].
const ROUNDING: f64 = 1e-9;
