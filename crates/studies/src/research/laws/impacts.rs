//! Free impacts under each law at one e: forces over deformation and time, with their extremes.

use pounding_contact::{Clamp, ContactLaw, LawName};
use pounding_solver::{Clock, Exact, Excitation, Histories, Integrator, Recorders, State};

use super::entry::{Entry, by_name, label, shade};
use crate::study::laws::{AtlasSettings, is_linear};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Panel, Shade};
use pounding_scene::{Error, FreeCollision, Refused, parallel};
use pounding_text::Table;

/// Number of points of a history, from touch to parting.
const N_POINTS: u32 = 500;
/// Number of intervals before the touch, and again after the parting.
const BESIDE: u32 = 2;

/// A free impact of a compliant law over time.
#[derive(Debug)]
pub(super) struct Impact {
    /// Time after the touch \[s\], deformation \[m\] and force \[N\].
    points: Vec<[f64; 3]>,
    /// Time from the touch to the end of the force \[s\].
    force_duration: f64,
}

/// The collision of the free pair under every law; `None` for an impulsive law.
pub(super) fn collide(entries: &[Entry], settings: &AtlasSettings) -> Result<Vec<Option<Impact>>, Refused> {
    let collision = settings.collision();
    parallel::try_each(entries, |entry| match entry.certificate.impact {
        Some(impact) => Impact::new(entry.certificate.law, &collision, impact.duration).map(Some),
        None => Ok(None),
    })
}

impl Impact {
    /// Follows the impact by the exact method.
    fn new(law: ContactLaw, collision: &FreeCollision, duration: f64) -> Result<Self, Refused> {
        let interval = duration / f64::from(N_POINTS);
        let touch = f64::from(BESIDE) * interval;
        let gap = collision.speed * touch;
        let row = collision.row(law, gap)?;
        let end = duration + 2.0 * touch;
        let clock = Clock {
            time_step: end,
            n_steps: 1,
        };
        let rest = Excitation::new(end, &[0.0]).map_err(|_| FreeCollision::no_step(end))?;
        let mut recorders = Recorders {
            histories: Some(Histories::new(2, interval, end)),
            ..Recorders::usual(2, row.pairs())
        };
        let exact = Integrator::Exact(Exact::default());
        let ran = row.run(&exact, rest, clock.into(), &mut recorders);
        ran.map_err(|error| Error::ended(&error))?;
        let states = |structure| {
            let histories = recorders.histories.iter();
            histories.flat_map(move |all| all.of(structure).states.iter())
        };
        let state = |(i, (left, right)): (usize, (&State, &State))| {
            let deformation = left.displacement - right.displacement - gap;
            let time = i as f64 * interval - touch;
            [time, deformation.max(0.0), -left.force_from_right]
        };
        let pair = collision.free_pair();
        let form = law.form(pair.reduced_mass, pair.approach_speed);
        // The force of a linear dashpot begins with a jump.
        let jump = form.map_or(0.0, |form| form.unclamped(0.0, pair.approach_speed));
        let mut points = vec![[0.0; 3], [0.0, 0.0, jump]];
        let after = states(0).zip(states(1)).enumerate().skip(BESIDE as usize + 1);
        points.extend(after.map(state).take_while(|[time, ..]| *time <= duration));
        points.push([duration, 0.0, 0.0]);
        let forces = recorders.collisions.all().iter().map(|met| met.end - met.start);
        Ok(Self {
            points,
            force_duration: forces.fold(0.0, f64::max),
        })
    }
}

/// Table of the duration, the extremes and the clamp of every law.
pub(super) fn table(entries: &[Entry], impacts: &[Option<Impact>], settings: &AtlasSettings) -> String {
    let rows = entries
        .iter()
        .zip(impacts)
        .flat_map(|(entry, impact)| by_name(entry, [impact.as_ref()]));
    let free = |entry: &Entry| entry.certificate.impact;
    // Once the force is clamped, the pair flies apart at e v₀.
    let clamped = |entry: &Entry, impact: Option<&Impact>| {
        let (impact, free) = impact.zip(free(entry)).filter(|_| entry.law().clamp() == Clamp::EveryCollision)?;
        let flight = free.duration - impact.force_duration;
        let speed = entry.certificate.by_exact * settings.approach_speed_m_per_s;
        Some((impact.force_duration, speed * flight))
    };
    Table::of(rows)
        .column("law", |(name, ..)| name.name())
        .column("restitution", |(_, entry, _)| entry.certificate.by_exact)
        .column("duration_s", |(_, entry, _)| free(entry).map(|free| free.duration))
        .column("max_deformation_m", |(_, entry, _)| free(entry).map(|free| free.max_deformation))
        .column("peak_force_n", |(_, entry, _)| free(entry).map(|free| free.peak_force))
        .column("impulse_n_s", |(_, entry, _)| entry.certificate.impulse)
        .column("would_pull", |(_, entry, _)| match entry.law().clamp() {
            Clamp::Never => "never",
            Clamp::DrivenApart => "driven apart",
            Clamp::EveryCollision => "every collision",
        })
        .column("clamped_from_s", |(_, entry, impact)| {
            clamped(entry, *impact).map(|clamped| clamped.0)
        })
        .column("deformation_at_clamp_m", |(_, entry, impact)| {
            clamped(entry, *impact).map(|clamped| clamped.1)
        })
        .csv()
}

/// Figure of force over deformation.
pub(super) fn loops(entries: &[Entry], impacts: &[Option<Impact>]) -> Figure {
    let point = |[_, deformation, force]: [f64; 3]| (1e3 * deformation, 1e-6 * force);
    figure(entries, impacts, "Deformation (mm)", |entry, impact| {
        // The force of a spring returns along the same curve, where dashes would fill each other's gaps.
        let turns = entry.name().is_elastic();
        let deeper = |pair: &&[[f64; 3]]| !turns || pair[1][1] >= pair[0][1];
        let steps = impact.points.windows(2).take_while(deeper);
        steps.map(|pair| point(pair[0])).collect()
    })
}

/// Figure of force over time.
pub(super) fn histories(entries: &[Entry], impacts: &[Option<Impact>]) -> Figure {
    let point = |[time, _, force]: &[f64; 3]| (1e3 * time, 1e-6 * force);
    figure(entries, impacts, "Time since the touch (ms)", |_, impact| {
        impact.points.iter().map(point).collect()
    })
}

/// A panel for each law with damping, with its spring alone in the background; linear springs are on the left. The last panel shows the
/// springs.
fn figure(entries: &[Entry], impacts: &[Option<Impact>], x: &str, points: impl Fn(&Entry, &Impact) -> Vec<(f64, f64)>) -> Figure {
    let met = entries.iter().zip(impacts);
    let met = met.filter_map(|(entry, impact)| {
        let curve = Curve::new(CurveKind::Line, shade(entry.name()), points(entry, impact.as_ref()?));
        Some((entry.name(), curve))
    });
    let (springs, damped): (Vec<_>, Vec<_>) = met.partition(|(law, _)| law.is_elastic());
    let peak = springs.iter().chain(&damped).flat_map(|(_, curve)| &curve.points);
    let peak = peak.map(|point| point.1).fold(0.0, f64::max);
    let panel = |title: &str, curves| Panel::shared(title, Axis::over("Force (MN)", 0.0, 1.05 * peak), curves);
    let of_law = |(law, curve): &(LawName, Curve)| {
        let same = springs
            .iter()
            .filter(|(spring, _)| *spring != LawName::TwoSlopes && is_linear(*spring) == is_linear(*law));
        let behind = same.map(|(_, spring)| Curve {
            kind: CurveKind::Dashed,
            shade: Shade::Ink,
            ..spring.clone().named("The same spring without damping")
        });
        panel(label(*law), behind.chain([curve.clone()]).collect())
    };
    let (left, right): (Vec<_>, Vec<_>) = damped.iter().partition(|(law, _)| is_linear(*law));
    let mut panels = Vec::new();
    let mut right = right.into_iter();
    for law in left {
        panels.push(of_law(law));
        panels.extend(right.next().map(of_law));
    }
    let both = springs.iter().map(|(law, curve)| curve.clone().named(label(*law)));
    panels.push(panel("Springs without damping", both.collect()));
    Figure::grid(8.2, 2, Axis::auto(x), panels).labelled_at_left()
}
