//! Spectra of pounding: the effects of two elastic structures on each other, over both periods.

use super::cases::{Case, Response, rows, sdof, set_period, with_gap};
use super::heat::{Classes, Heat, HeatRow};
use crate::files::{Files, drawn};
use crate::statistics::{quantile, sorted};
use crate::study::surveys::PoundingSpectra;
use crate::{StudyError, StudyFile};
use pounding_scene::{Method, STANDARD_GRAVITY, Scene, parallel};
use pounding_solver::SimultaneousImpacts;
use pounding_text::{Cell, Table, digits};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// A pair of structures with a gap.
#[derive(Debug, Clone, Copy)]
struct GapPair {
    /// Index of the left structure's period.
    left: usize,
    right: usize,
    gap: f64,
    mass_ratio: f64,
}

/// Quantities of a run in tables and figures.
#[derive(Debug, Clone, Copy)]
struct Numbers([f64; 4]);

/// Names of the quantities.
const KEYS: [&str; 4] = [
    "force_over_weight",
    "impulse_over_reduced_mass_m_per_s",
    "left_over_alone",
    "right_over_alone",
];
/// Classes of forces, impulses and amplifications.
const FORCE: Classes = Classes::Rising([0.25, 0.5, 1.0, 2.0, 4.0]);
const IMPULSE: Classes = Classes::Rising([0.5, 1.0, 2.0, 4.0, 8.0]);
const AMPLIFICATION: Classes = Classes::About([0.5, 0.75, 0.95, 1.05, 1.5, 2.5]);
/// Periods that have a number at the axes \[s\].
const TICKS: [f64; 6] = [0.1, 0.2, 0.5, 1.0, 2.0, 4.0];

/// The pairs with their motions.
struct Spectra<'a> {
    settings: &'a PoundingSpectra,
    template: &'a Scene,
    cases: Vec<&'a Case>,
    /// Peak displacement without neighbours, for every period and case \[m\].
    alone: Vec<Vec<f64>>,
}

pub(super) fn files(settings: &PoundingSpectra, file: &StudyFile, cases: &[Case]) -> Result<Files, StudyError> {
    let template = &rows(file, 2)?[0];
    let wanted = |case: &&Case| settings.motions.contains(&case.name);
    let cases: Vec<&Case> = cases.iter().filter(wanted).collect();
    let alone = parallel::try_each(&cases, |case| -> Result<_, StudyError> {
        let of_period = |period: &f64| {
            let mut scene = Scene {
                structures: template.structures[..1].to_vec(),
                contacts: None,
                ..template.clone()
            };
            set_period(sdof(&mut scene, 0), *period);
            Ok(case.run(&scene)?.peaks[0])
        };
        settings.periods_s.iter().map(of_period).collect()
    })?;
    let spectra = Spectra {
        settings,
        template,
        cases,
        alone,
    };
    let cells = spectra.cells();
    let found = parallel::try_each(&cells, |cell| spectra.numbers(*cell))?;
    let mut files = Files::from([
        ("spectra.csv".into(), spectra.table(&cells, &found).into_bytes()),
        ("digits.csv".into(), spectra.check(&cells, &found)?.into_bytes()),
    ]);
    for &mass_ratio in &settings.mass_ratios {
        let heat = spectra.heat(&cells, &found, mass_ratio);
        let name = format!("mass-ratio-{}.png", digits(mass_ratio));
        files.insert(name.into(), drawn(&heat.drawing(), &file.path)?);
    }
    Ok(files)
}

impl Spectra<'_> {
    fn cells(&self) -> Vec<GapPair> {
        let n = self.settings.periods_s.len();
        let mut cells = Vec::new();
        for &mass_ratio in &self.settings.mass_ratios {
            for &gap in &self.settings.gaps_over_srss {
                let pair = |index| GapPair {
                    left: index % n,
                    right: index / n,
                    gap,
                    mass_ratio,
                };
                cells.extend((0..n * n).map(pair));
            }
        }
        cells
    }

    fn scene(&self, cell: GapPair, case: usize) -> Scene {
        let alone = &self.alone[case];
        let gap = cell.gap * libm::hypot(alone[cell.left], alone[cell.right]);
        let mut scene = with_gap(self.template, gap);
        sdof(&mut scene, 1).mass_kg = cell.mass_ratio * sdof(&mut scene, 0).mass_kg;
        for (index, period) in [cell.left, cell.right].into_iter().enumerate() {
            set_period(sdof(&mut scene, index), self.settings.periods_s[period]);
        }
        scene
    }

    /// The quantities under every motion.
    fn numbers(&self, cell: GapPair) -> Result<Vec<Numbers>, StudyError> {
        let of = |(index, case): (usize, &&Case)| {
            let mut scene = self.scene(cell, index);
            let response = case.run(&scene)?;
            Ok(self.of_response(&mut scene, cell, index, &response))
        };
        self.cases.iter().enumerate().map(of).collect()
    }

    fn of_response(&self, scene: &mut Scene, cell: GapPair, case: usize, response: &Response) -> Numbers {
        let masses = [0, 1].map(|index| sdof(scene, index).mass_kg);
        let weight = STANDARD_GRAVITY * masses[0].min(masses[1]);
        let alone = &self.alone[case];
        Numbers([
            response.force / weight,
            response.impulse * (1.0 / masses[0] + 1.0 / masses[1]),
            response.peaks[0] / alone[cell.left],
            response.peaks[1] / alone[cell.right],
        ])
    }

    /// Table with one row per pair, gap and mass ratio.
    fn table(&self, cells: &[GapPair], found: &[Vec<Numbers>]) -> String {
        let periods = &self.settings.periods_s;
        let mut table = Table::of(cells.iter().zip(found))
            .column("mass_ratio", |(cell, _)| cell.mass_ratio)
            .column("gap_over_srss", |(cell, _)| cell.gap)
            .column("left_period_s", |(cell, _)| periods[cell.left])
            .column("right_period_s", |(cell, _)| periods[cell.right])
            .column("cases", |(_, numbers)| numbers.len())
            .column("touching_cases", |(_, numbers)| touching(numbers));
        for (quantity, key) in KEYS.into_iter().enumerate() {
            for (part, name) in [(0.5, "median"), (1.0, "largest")] {
                let value = move |numbers: &[Numbers]| quantile(&of_quantity(numbers, quantity), part).unwrap_or(0.0);
                table = table.column(format!("{key}_{name}"), move |(_, numbers)| value(numbers));
            }
        }
        table.csv()
    }

    fn heat(&self, cells: &[GapPair], found: &[Vec<Numbers>], mass_ratio: f64) -> Heat {
        let labels = [
            ("Peak force /\nweight of the\nlighter (–)", FORCE),
            ("Total impulse /\nreduced mass\n(m/s)", IMPULSE),
            ("Left: peak /\nalone (–)", AMPLIFICATION),
            ("Right: peak /\nalone (–)", AMPLIFICATION),
        ];
        let panel = |gap: f64, quantity: usize| {
            let own = cells
                .iter()
                .zip(found)
                .filter(|(cell, _)| cell.gap.total_cmp(&gap).is_eq() && cell.mass_ratio.total_cmp(&mass_ratio).is_eq());
            let value = |(_, numbers): (&GapPair, &Vec<Numbers>)| {
                let value = quantile(&of_quantity(numbers, quantity), 0.5)?;
                (2 * touching(numbers) >= numbers.len()).then_some(value)
            };
            own.map(value).collect()
        };
        let gaps = &self.settings.gaps_over_srss;
        // With equal masses, the map of the right structure is that of the left one with both periods exchanged.
        let n_rows = if mass_ratio.total_cmp(&1.0).is_eq() { 3 } else { 4 };
        let row = |(quantity, (label, classes)): (usize, (&str, Classes))| HeatRow {
            label: label.into(),
            classes,
            panels: gaps.iter().map(|gap| panel(*gap, quantity)).collect(),
        };
        Heat {
            axis: self.settings.periods_s.clone(),
            x: "Period of the left structure (s)".into(),
            y: "Period of the right structure (s)".into(),
            titles: gaps.iter().map(|gap| format!("Gap {} of SRSS", digits(*gap))).collect(),
            rows: labels.into_iter().enumerate().take(n_rows).map(row).collect(),
            ticks: TICKS.into(),
        }
    }

    /// Repeats some runs with a tolerance ten thousand times as large, and with a record scaled by 1 + 10⁻¹². Returns a table of the
    /// relative changes of the numbers.
    fn check(&self, cells: &[GapPair], found: &[Vec<Numbers>]) -> Result<String, StudyError> {
        const TOLERANCE: f64 = 1e-12;
        const SLIGHT: f64 = 1e-12;
        let mut random = Pcg64::new(1, 1);
        let mut below = |n: usize| usize::try_from(random.next_u64() % n.max(1) as u64).expect("less than a usize");
        let chosen: Vec<(usize, usize)> = (0..self.settings.checked)
            .map(|_| (below(cells.len()), below(self.cases.len())))
            .collect();
        let moved = parallel::try_each(&chosen, |&(index, case)| -> Result<_, StudyError> {
            let cell = cells[index];
            let mut scene = self.scene(cell, case);
            let prepared = self.cases[case].scaled(1.0 + SLIGHT)?.prepared(&scene)?;
            let method = Method::Exact {
                tolerance: TOLERANCE,
                simultaneous_impacts: SimultaneousImpacts::Together,
            };
            let response = Response::of(&prepared.with_method(method)?.run(None)?, 2);
            let again = self.of_response(&mut scene, cell, case, &response);
            let pairs = again.0.into_iter().zip(found[index][case].0);
            Ok(pairs
                .map(|(again, before)| if before == 0.0 { again } else { (again / before - 1.0).abs() })
                .collect::<Vec<f64>>())
        })?;
        let moves = |(quantity, key)| (key, sorted(moved.iter().map(|moves: &Vec<f64>| moves[quantity])));
        // Two digits: further ones are rounding, which differs between machines.
        let part = |moves: &[f64], part| Cell::number(quantile(moves, part).unwrap_or(0.0), |value| format!("{value:.0e}"));
        Ok(Table::of(KEYS.into_iter().enumerate().map(moves))
            .column("quantity", |(key, _)| *key)
            .column("runs", |(_, moves)| moves.len())
            .column("median", |(_, moves)| part(moves, 0.5))
            .column("quantile_95", |(_, moves)| part(moves, 0.95))
            .column("largest", |(_, moves)| part(moves, 1.0))
            .csv())
    }
}

/// Number of cases in which the pair touches.
fn touching(numbers: &[Numbers]) -> usize {
    numbers.iter().filter(|numbers| numbers.0[1] > 0.0).count()
}

/// A quantity over all cases, in rising order.
fn of_quantity(numbers: &[Numbers], quantity: usize) -> Vec<f64> {
    sorted(numbers.iter().map(|numbers| numbers.0[quantity]))
}
