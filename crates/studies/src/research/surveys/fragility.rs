//! Fragility of pounding: in how many of many random motions structures touch, and drift further than alone.

use super::cases::{Case, each, rows, with_gap};
use super::{Files, csv, drawn};
use crate::paper::figures::capital;
use crate::study::surveys::Fragility;
use crate::{StudyError, StudyFile};
use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Mark, Panel, Shade};
use pounding_scene::{Generated, GroundMotion, RecordUse, Scene, Source, wilson};
use pounding_text::digits;

/// What one motion does at one intensity and gap: peak displacements over those alone, where the pair touches.
type Excess = Option<[f64; 2]>;

/// An event whose probability is asked for.
#[derive(Debug, Clone, Copy)]
enum Event {
    Touch,
    /// A structure, by its place, drifts so much further than alone.
    Drift(usize, f64),
}

impl Event {
    fn happens(self, outcome: &Excess) -> bool {
        match self {
            Self::Touch => outcome.is_some(),
            Self::Drift(structure, limit) => outcome.is_some_and(|amplifications| amplifications[structure] > limit),
        }
    }

    fn words(self, names: [&str; 2]) -> String {
        match self {
            Self::Touch => "touching".into(),
            Self::Drift(structure, limit) => {
                format!("{} drifts > {} of alone", names[structure], digits(limit))
            }
        }
    }
}

pub(super) fn files(settings: &Fragility, file: &StudyFile) -> Result<Files, StudyError> {
    let scene = &rows(file, 2)?[0];
    let cases = suite(settings, scene, file)?;
    let tasks: Vec<(&Case, f64)> = cases
        .iter()
        .flat_map(|case| settings.pga_m_per_s2.iter().map(move |pga| (case, *pga)))
        .collect();
    let found = each(&tasks, |&(case, pga)| outcomes(&case.scaled(pga)?, scene, &settings.gaps_m))?;
    let counts = Counts {
        settings,
        names: [0, 1].map(|index| scene.structures[index].name()),
        found,
    };
    Ok(Files::from([
        ("fragility.csv".into(), counts.table()),
        ("fragility.png".into(), drawn(&counts.figure(), file)?),
    ]))
}

/// The motions with a peak of 1 m/s².
fn suite(settings: &Fragility, scene: &Scene, file: &StudyFile) -> Result<Vec<Case>, StudyError> {
    let Source::Generated(Generated::Stochastic(motion)) = &scene.record.source else {
        return Err(StudyError::Study {
            path: file.path.clone(),
            place: "scenes.record",
            found: scene.record.source.to_string(),
            allowed: "`generated`, `stochastic`, whose seed makes further motions",
        });
    };
    let seeds: Vec<u64> = (0..settings.motions).map(|index| motion.seed + index).collect();
    each(&seeds, |&seed| {
        let mut motion = motion.clone();
        (motion.seed, motion.pga_m_per_s2) = (seed, 1.0);
        let record = RecordUse::of(Source::Generated(Generated::Stochastic(motion)));
        let name = format!("motion {seed}");
        let motion = GroundMotion::of(&record, file.base(), &name)?;
        let duration = scene.duration_under(motion.record.duration());
        Ok(Case::of_motion(name, motion.into(), duration))
    })
}

/// What a motion does at every gap. Until they touch first, structures move as if they were alone: where the gap is wider
/// than the largest closing of both alone nothing else is run.
fn outcomes(case: &Case, scene: &Scene, gaps: &[f64]) -> Result<Vec<Excess>, StudyError> {
    let separation = case.prepared(scene)?.separations()?[0];
    let outcome = |gap: &f64| {
        if *gap >= separation.required {
            return Ok(None);
        }
        let peaks = case.run(&with_gap(scene, *gap))?.peaks;
        Ok(Some([0, 1].map(|index| peaks[index] / separation.peaks[index])))
    };
    gaps.iter().map(outcome).collect()
}

struct Counts<'a> {
    settings: &'a Fragility,
    names: [&'a str; 2],
    /// For every motion and intensity the outcomes of all gaps.
    found: Vec<Vec<Excess>>,
}

impl Counts<'_> {
    fn events(&self) -> Vec<Event> {
        let limits = self.settings.amplifications.iter();
        let drifts = limits.flat_map(|limit| [0, 1].map(|index| Event::Drift(index, *limit)));
        std::iter::once(Event::Touch).chain(drifts).collect()
    }

    /// In how many motions it happens at an intensity and a gap, by their places.
    fn count(&self, event: Event, pga: usize, gap: usize) -> usize {
        let of_pga = self.found.iter().skip(pga);
        let of_pga = of_pga.step_by(self.settings.pga_m_per_s2.len());
        of_pga.filter(|outcomes| event.happens(&outcomes[gap])).count()
    }

    fn n(&self) -> usize {
        self.found.len() / self.settings.pga_m_per_s2.len().max(1)
    }

    /// A row per event, gap and intensity.
    fn table(&self) -> Vec<u8> {
        let header = ["event", "gap_m", "pga_m_per_s2", "motions", "count", "probability", "from", "to"];
        let mut rows = Vec::new();
        for event in self.events() {
            for (gap, width) in self.settings.gaps_m.iter().enumerate() {
                for (index, pga) in self.settings.pga_m_per_s2.iter().enumerate() {
                    let count = self.count(event, index, gap);
                    let (from, to) = wilson(count as u64, self.n() as u64);
                    let mut row = vec![event.words(self.names), digits(*width), digits(*pga)];
                    row.extend([self.n(), count].map(|count| count.to_string()));
                    let share = count as f64 / self.n() as f64;
                    row.extend([share, from, to].map(digits));
                    rows.push(row);
                }
            }
        }
        csv(&header, &rows)
    }

    /// A panel per event: curves of gaps over intensity, with bounds.
    fn figure(&self) -> Figure {
        const LOOKS: [(Shade, Mark); 5] = [
            (Shade::Ink, Mark::Disc),
            (Shade::Blue, Mark::Square),
            (Shade::Vermilion, Mark::Triangle),
            (Shade::Green, Mark::Diamond),
            (Shade::Grey, Mark::Inverted),
        ];
        let panel = |(index, event): (usize, Event)| {
            let mut curves = Vec::new();
            for ((gap, width), (shade, mark)) in self.settings.gaps_m.iter().enumerate().zip(LOOKS) {
                let mut line = Vec::new();
                let (mut lower, mut upper) = (Vec::new(), Vec::new());
                for (place, pga) in self.settings.pga_m_per_s2.iter().enumerate() {
                    let count = self.count(event, place, gap);
                    let (from, to) = wilson(count as u64, self.n() as u64);
                    line.push((*pga, count as f64 / self.n() as f64));
                    lower.push((*pga, from));
                    upper.push((*pga, to));
                }
                curves.extend([lower, upper].map(|bound| Curve::new(Kind::Thin, shade, bound)));
                let name = format!("gap {} mm", digits(1e3 * width));
                curves.push(Curve::new(Kind::Line, shade, line).marked(mark).named(name));
            }
            Panel {
                title: capital(&event.words(self.names)),
                y: Axis::over(if index % 2 == 0 { "Probability (–)" } else { "" }, 0.0, 1.0),
                curves,
                legend: Legend::Shared,
                ..Panel::default()
            }
        };
        // What hardly ever happens has no panel.
        let happens = |event: &Event| {
            let gaps = 0..self.settings.gaps_m.len();
            let most = gaps.flat_map(|gap| {
                let intensities = 0..self.settings.pga_m_per_s2.len();
                intensities.map(move |pga| self.count(*event, pga, gap))
            });
            100 * most.max().unwrap_or(0) >= self.n()
        };
        let events = self.events().into_iter().filter(happens);
        let panels: Vec<Panel> = events.enumerate().map(panel).collect();
        Figure {
            height_in: 0.7 + 2.5 * panels.len().div_ceil(2) as f64,
            columns: 2,
            x: Axis::over("Peak ground acceleration (m/s²)", 0.0, self.strongest()),
            panels,
        }
    }

    fn strongest(&self) -> f64 {
        self.settings.pga_m_per_s2.iter().copied().fold(0.0, f64::max)
    }
}
