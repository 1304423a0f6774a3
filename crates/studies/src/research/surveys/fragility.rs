//! Fragility of pounding: in how many of many random motions structures touch, and drift further than alone.

use super::cases::{Case, rows, with_gap};
use crate::drivers::pairs;
use crate::files::{Files, capital, drawn};
use crate::study::surveys::Fragility;
use crate::{StudyError, StudyFile};
use pounding_assess::{Separation, wilson};
use pounding_plot::{Axis, Curve, Figure, Kind, Mark, Panel, Shade};
use pounding_scene::{Generated, GroundMotion, RecordUse, Scene, Source, parallel};
use pounding_text::{Table, digits};

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
    fn all(settings: &Fragility) -> impl Iterator<Item = Self> {
        let limits = settings.amplifications.iter();
        let drifts = limits.flat_map(|limit| [0, 1].map(|index| Self::Drift(index, *limit)));
        std::iter::once(Self::Touch).chain(drifts)
    }

    fn happens(self, outcome: &Excess) -> bool {
        match self {
            Self::Touch => outcome.is_some(),
            Self::Drift(structure, limit) => outcome.is_some_and(|amplifications| amplifications[structure] > limit),
        }
    }

    fn words(self, scene: &Scene) -> String {
        match self {
            Self::Touch => "touching".into(),
            Self::Drift(structure, limit) => format!("{} drifts > {} of alone", scene.structures[structure].name(), digits(limit)),
        }
    }
}

/// In how many motions an event happens at a gap \[m\] and an intensity \[m/s²\].
struct Count {
    event: String,
    gap: f64,
    pga: f64,
    motions: usize,
    happens: usize,
}

impl Count {
    fn share(&self) -> f64 {
        self.happens as f64 / self.motions as f64
    }

    fn bounds(&self) -> (f64, f64) {
        wilson(self.happens as u64, self.motions as u64)
    }
}

pub(super) fn files(settings: &Fragility, file: &StudyFile) -> Result<Files, StudyError> {
    let scene = &rows(file, 2)?[0];
    let cases = suite(settings, scene, file)?;
    let tasks = pairs(&cases, &settings.pga_m_per_s2);
    let found = parallel::try_each(&tasks, |(case, pga)| outcomes(&case.scaled(**pga)?, scene, &settings.gaps_m))?;
    let counts = counts(settings, scene, &found);
    let table = Table::of(&counts)
        .column("event", |one| one.event.clone())
        .column("gap_m", |one| one.gap)
        .column("pga_m_per_s2", |one| one.pga)
        .column("motions", |one| one.motions)
        .column("count", |one| one.happens)
        .column("probability", |one| one.share())
        .column("from", |one| one.bounds().0)
        .column("to", |one| one.bounds().1)
        .csv();
    Ok(Files::from([
        ("fragility.csv".into(), table.into_bytes()),
        ("fragility.png".into(), drawn(&figure(settings, &counts), &file.path)?),
    ]))
}

/// The motions with a peak of 1 m/s².
fn suite(settings: &Fragility, scene: &Scene, file: &StudyFile) -> Result<Vec<Case>, StudyError> {
    let Source::Generated(Generated::Stochastic(motion)) = &scene.record.source else {
        let allowed = "`generated`, `stochastic`, whose seed makes further motions";
        return Err(file.refuse("scenes.record", scene.record.source.to_string(), allowed));
    };
    let seeds: Vec<u64> = (0..settings.motions).map(|index| motion.seed + index).collect();
    parallel::try_each(&seeds, |&seed| {
        let mut motion = motion.clone();
        (motion.seed, motion.pga_m_per_s2) = (seed, 1.0);
        let record = RecordUse::of(Source::Generated(Generated::Stochastic(motion)));
        let name = format!("motion {seed}");
        let motion = GroundMotion::of(&record, file.base(), &name)?;
        Ok(Case {
            name,
            reversed: false,
            // Two of the longest periods of the scene are waited for.
            duration: scene.duration_under(motion.record.duration()),
            motion: motion.into(),
        })
    })
}

/// What a motion does at every gap. Until they touch first, structures move as if they were alone: where the gap is wider
/// than the largest closing of both alone nothing else is run.
fn outcomes(case: &Case, scene: &Scene, gaps: &[f64]) -> Result<Vec<Excess>, StudyError> {
    let separation = Separation::of(&case.prepared(scene)?)?[0];
    let outcome = |gap: &f64| {
        if *gap >= separation.required {
            return Ok(None);
        }
        let peaks = case.run(&with_gap(scene, *gap))?.peaks;
        Ok(Some([0, 1].map(|index| peaks[index] / separation.peaks[index])))
    };
    gaps.iter().map(outcome).collect()
}

/// Every event at every gap and intensity; `found` has the outcomes of all gaps for every motion and intensity.
fn counts(settings: &Fragility, scene: &Scene, found: &[Vec<Excess>]) -> Vec<Count> {
    let n_pga = settings.pga_m_per_s2.len();
    let mut counts = Vec::new();
    for event in Event::all(settings) {
        for (gap, width) in settings.gaps_m.iter().enumerate() {
            for (index, pga) in settings.pga_m_per_s2.iter().enumerate() {
                let of_pga = found.iter().skip(index).step_by(n_pga);
                counts.push(Count {
                    event: event.words(scene),
                    gap: *width,
                    pga: *pga,
                    motions: found.len() / n_pga,
                    happens: of_pga.filter(|outcomes| event.happens(&outcomes[gap])).count(),
                });
            }
        }
    }
    counts
}

/// Colours and marks of the gaps.
const LOOKS: [(Shade, Mark); 5] = [
    (Shade::Ink, Mark::Disc),
    (Shade::Blue, Mark::Square),
    (Shade::Vermilion, Mark::Triangle),
    (Shade::Green, Mark::Diamond),
    (Shade::Grey, Mark::Inverted),
];

/// A panel per event: curves of gaps over intensity, with bounds.
fn figure(settings: &Fragility, counts: &[Count]) -> Figure {
    let n_pga = settings.pga_m_per_s2.len().max(1);
    let of_gap = |(counts, (shade, mark)): (&[Count], (Shade, Mark))| {
        let curve = |kind, value: fn(&Count) -> f64| {
            let points = counts.iter().map(|one| (one.pga, value(one)));
            Curve::new(kind, shade, points.collect())
        };
        let name = format!("gap {} mm", digits(1e3 * counts[0].gap));
        [
            curve(Kind::Thin, |one| one.bounds().0),
            curve(Kind::Thin, |one| one.bounds().1),
            curve(Kind::Line, Count::share).marked(mark).named(name),
        ]
    };
    let panel = |counts: &[Count]| {
        let curves = counts.chunks(n_pga).zip(LOOKS).flat_map(of_gap).collect();
        Panel::shared(capital(&counts[0].event), Axis::over("Probability (–)", 0.0, 1.0), curves)
    };
    // What hardly ever happens has no panel.
    let happens = |counts: &&[Count]| counts.iter().any(|one| 100 * one.happens >= one.motions);
    let events = counts.chunks((n_pga * settings.gaps_m.len()).max(1));
    let panels: Vec<Panel> = events.filter(happens).map(panel).collect();
    let strongest = settings.pga_m_per_s2.iter().copied().fold(0.0, f64::max);
    let x = Axis::over("Peak ground acceleration (m/s²)", 0.0, strongest);
    Figure::grid(0.7 + 2.5 * panels.len().div_ceil(2) as f64, 2, x, panels).labelled_at_left()
}
