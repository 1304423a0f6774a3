//! Fragility of pounding: the share of many random motions under which structures touch, and drift further than without neighbours.

use super::cases::{Case, rows, with_gap};
use crate::drivers::pairs;
use crate::files::{Files, capital, drawn};
use crate::study::surveys::Fragility;
use crate::{StudyError, StudyFile};
use pounding_assess::{Separation, wilson};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Mark, Panel, Shade};
use pounding_scene::{Generated, GroundMotion, RecordUse, Scene, Source, parallel};
use pounding_text::{Table, digits};

/// Peak displacements over those without neighbours, for one motion, intensity and gap. `None` if the pair does not touch.
type Excess = Option<[f64; 2]>;

/// An event with a probability.
#[derive(Debug, Clone, Copy)]
enum Event {
    Touch,
    /// The structure with this index drifts further than without neighbours, by at least this factor.
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

/// Number of motions under which an event happens, at a gap \[m\] and an intensity \[m/s²\].
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

/// The motions, scaled to a peak of 1 m/s².
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
            // The run waits for two of the longest periods of the scene after the motion.
            duration: scene.duration_under(motion.record.duration()),
            motion: motion.into(),
        })
    })
}

/// The results of a motion at every gap. Until their first touch structures move as without neighbours. A gap wider than their largest
/// closing therefore needs no run.
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

/// Counts every event at every gap and intensity. `found` has the results at all gaps for every motion and intensity.
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

/// Name of the bounds of all gaps in the legend.
const BOUNDS: &str = "95 % bounds of the share";

/// Figure with one panel per event: one curve per gap over intensity, with bounds.
fn figure(settings: &Fragility, counts: &[Count]) -> Figure {
    let n_pga = settings.pga_m_per_s2.len().max(1);
    let of_gap = |(counts, (shade, mark)): (&[Count], (Shade, Mark))| {
        let curve = |kind, value: fn(&Count) -> f64| {
            let points = counts.iter().map(|one| (one.pga, value(one)));
            Curve::new(kind, shade, points.collect())
        };
        let name = format!("gap {} mm", digits(1e3 * counts[0].gap));
        [
            curve(CurveKind::Thin, |one| one.bounds().0).named(BOUNDS),
            curve(CurveKind::Thin, |one| one.bounds().1),
            curve(CurveKind::Line, Count::share).marked(mark).named(name),
        ]
    };
    let panel = |counts: &[Count]| {
        let curves = counts.chunks(n_pga).zip(LOOKS).flat_map(of_gap).collect();
        Panel::shared(capital(&counts[0].event), Axis::over("Probability (–)", 0.0, 1.0), curves)
    };
    // An event under less than 1 % of the motions gets no panel.
    let happens = |counts: &&[Count]| counts.iter().any(|one| 100 * one.happens >= one.motions);
    let events = counts.chunks((n_pga * settings.gaps_m.len()).max(1));
    let panels: Vec<Panel> = events.filter(happens).map(panel).collect();
    let strongest = settings.pga_m_per_s2.iter().copied().fold(0.0, f64::max);
    let x = Axis::over("Peak ground acceleration (m/s²)", 0.0, strongest);
    Figure::grid(0.7 + 2.5 * panels.len().div_ceil(2) as f64, 2, x, panels).labelled_at_left()
}
