//! A row in slow motion around its hardest collision: an SVG that moves by style sheets, without a script.
//!
//! On paper, and for a reader who asks for less motion, the picture shows the instant of the collision.

mod drawn;

use pounding_scene::{Error, Extras, Floors, RunResult, Simulation, Structure};
use pounding_solver::Collision;
use pounding_text::{short, two_digits};

use crate::page::markup::escaped;
use drawn::Stage;

/// The name of its file.
pub(crate) const FILE: &str = "animation.svg";
/// What makes a file of it; a page needs none.
const NAMESPACE: &str = " xmlns=\"http://www.w3.org/2000/svg\"";

/// Keyframes of all storeys together, and the least and the most of one storey: they decide how large the file is.
const KEYFRAMES: usize = 1400;
const FRAMES: [usize; 2] = [30, 80];

/// Longest natural periods that are shown before the collision and after it.
const PERIODS: f64 = 1.0;

/// How long the animation lasts \[s\].
const LASTS: f64 = 12.0;

/// A row in motion around its hardest collision.
#[derive(Debug, Clone, PartialEq)]
pub struct Animation {
    /// The picture.
    pub(crate) svg: String,
    /// What it shows.
    pub(crate) caption: String,
}

/// The collision that is shown.
struct Film<'a> {
    simulation: &'a Simulation,
    run: &'a RunResult,
    hardest: Collision,
    /// First and last instant \[s\].
    from: f64,
    to: f64,
    frames: usize,
}

impl Animation {
    /// Runs a row by the exact method and shows its hardest collision; `None` if nothing touches, or if the ground motion travels
    /// along the row.
    ///
    /// # Errors
    /// As of [`Simulation::run`].
    pub fn of(simulation: &Simulation) -> Result<Option<Self>, Error> {
        let exact = simulation.exact()?;
        let periods = exact.scene().structures.iter().filter_map(Structure::period);
        let longest = periods.fold(0.0, f64::max);
        let run = exact.run_with(Extras {
            interval: Some(longest / FRAMES[1] as f64),
            ..Extras::default()
        })?;
        Ok(Self::of_run(&exact, &run))
    }

    /// As a part of a page, with its caption.
    pub(crate) fn figure(&self) -> String {
        format!(
            "<figure class=\"moving\">\n{}<figcaption>{}</figcaption>\n</figure>\n",
            self.svg.replacen(NAMESPACE, "", 1),
            escaped(&self.caption)
        )
    }

    /// The animation of a run that kept histories.
    pub(crate) fn of_run(simulation: &Simulation, run: &RunResult) -> Option<Self> {
        let film = Film::of(simulation, run)?;
        let stage = Stage::of(&film);
        let slower = LASTS / (film.to - film.from);
        let [left, right] = simulation.floors().names(film.hardest.pair);
        let caption = format!(
            "The row from {} to {} s, {} times as slow as it was. Displacements and gaps are drawn {} times as large as heights; floors that \
             touch are marked.{} The hardest collision is that of {left} and {right} at {} s.",
            short(film.from),
            short(film.to),
            two_digits(slower),
            two_digits(stage.exaggeration()),
            if simulation.scene().links.is_empty() {
                ""
            } else {
                " Blue lines are links."
            },
            short(film.at())
        );
        Some(Self {
            svg: stage.svg(&film, &caption),
            caption,
        })
    }
}

impl<'a> Film<'a> {
    fn of(simulation: &'a Simulation, run: &'a RunResult) -> Option<Self> {
        let scene = simulation.scene();
        // Grounds that move on their own change gaps, which the picture would not show.
        if scene.arrivals_s.is_some() || run.histories.is_none() {
            return None;
        }
        let force = |one: &Collision| one.peak_force.unwrap_or(0.0);
        let speed = |one: &Collision| one.approach_speed.unwrap_or(0.0);
        let hardest = *run.collisions.all().iter().max_by(|one, other| {
            let by_force = force(one).total_cmp(&force(other));
            let by_speed = by_force.then(speed(one).total_cmp(&speed(other)));
            by_speed.then(one.impulse.total_cmp(&other.impulse))
        })?;
        let periods = scene.structures.iter().filter_map(Structure::period);
        let around = PERIODS * periods.fold(0.0, f64::max);
        let at = instant(&hardest);
        let storeys = simulation.floors().all().len();
        Some(Self {
            simulation,
            run,
            hardest,
            from: (at - around).max(0.0),
            to: (at + around).min(simulation.duration()),
            frames: (KEYFRAMES / storeys).clamp(FRAMES[0], FRAMES[1]),
        })
    }

    fn floors(&self) -> &Floors {
        self.simulation.floors()
    }

    /// The instant of the hardest collision \[s\].
    fn at(&self) -> f64 {
        instant(&self.hardest)
    }

    /// The instants of the keyframes, and where each is in the animation, from 0 to 100.
    fn instants(&self) -> impl Iterator<Item = (f64, f64)> {
        let (from, span, last) = (self.from, self.to - self.from, self.frames - 1);
        (0..self.frames).map(move |frame| {
            let share = frame as f64 / last as f64;
            (from + share * span, 100.0 * share)
        })
    }

    /// Displacement of a floor at an instant \[m\], linear between the states that were kept.
    fn displacement(&self, floor: usize, time: f64) -> f64 {
        let Some(histories) = &self.run.histories else {
            return 0.0;
        };
        let states = &histories.of(floor).states;
        let place = (time / histories.interval()).max(0.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place among the states")]
        let before = place.floor() as usize;
        let at = |index: usize| {
            let state = states.get(index).or(states.last());
            state.map_or(0.0, |state| state.displacement)
        };
        let share = place - before as f64;
        at(before) * (1.0 - share) + at(before + 1) * share
    }

    /// The collisions of a pair that are shown, as parts of the animation from 0 to 100.
    fn touches(&self, pair: usize) -> Vec<[f64; 2]> {
        let share = |time: f64| 100.0 * (time - self.from) / (self.to - self.from);
        let own = self.run.collisions_of(pair);
        let shown = own.filter(|one| one.end >= self.from && one.start <= self.to);
        shown
            .map(|one| [share(one.start), share(one.end)].map(|part| part.clamp(0.0, 100.0)))
            .collect()
    }
}

/// The instant of a collision at which it is hardest \[s\].
fn instant(one: &Collision) -> f64 {
    one.peak_force_time.unwrap_or(one.start)
}
