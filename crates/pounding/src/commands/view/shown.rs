//! A turned scene as the page shows it: the summary that `run --json` prints, the first screen of the answer, and the run to be played.

use std::panic::resume_unwind;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use pounding::assess::{JudgedSeparations, Separation, beyond_belief};
use pounding::contact::{ContactLaw, Stereomechanical};
use pounding::report::{Player, Report, Summary, other_direction};
use pounding::scene::{Contact, Error, FileUse, GroundMotion, Origin, Scene, Simulation, SimulationOptions, Source};
use pounding::text::{Refused, json_text, rounded_up, short};
use serde::Serialize;

use super::guides::Guide;
use super::knobs::{Drawn, Turned, drawn, turned};

/// A scene to be turned, with its record.
#[derive(Debug)]
pub(super) struct Base {
    scene: Scene,
    /// The record; `None` for a motion from a formula.
    origin: Option<Arc<Origin>>,
    /// The row and the widths that were found last.
    widths: Mutex<Option<(Scene, Widths)>>,
}

/// The widths of all gaps under the shaking as given, and reversed; `None` if a structure would hardly stand alone.
type Widths = Option<[Vec<Separation>; 2]>;

/// What the page shows of a run.
#[derive(Debug, Serialize)]
pub(super) struct Shown {
    summary: Summary,
    /// The first screen of the answer as markup.
    answer: String,
    gaps: Vec<GapNeeds>,
    player: Player,
    /// Displacements by the exact method beside those of a run with time steps \[µm\].
    #[serde(skip_serializing_if = "Option::is_none")]
    exact_um: Option<Vec<Vec<i64>>>,
    knobs: Vec<Drawn>,
}

/// A gap and the width that it needs, whatever the direction of shaking.
#[derive(Debug, Serialize)]
struct GapNeeds {
    /// A sentence: the required width, and that of the scene.
    says: String,
    is_enough: bool,
}

impl Shown {
    /// The sentence of a guide with numbers of this run.
    pub(super) fn fact(&self, guide: &Guide) -> Option<String> {
        guide.fact.and_then(|fact| fact(&self.summary))
    }
}

impl Base {
    fn of(scene: Scene, origin: Option<Arc<Origin>>) -> Self {
        let widths = Mutex::default();
        Self { scene, origin, widths }
    }

    /// A scene of a file with its record.
    ///
    /// # Errors
    /// Refuses a record that cannot be read.
    pub(super) fn read(scene: Scene, folder: &Path) -> Result<Self, Error> {
        Self::with(scene, |file| Origin::read(&folder.join(&file.file), file))
    }

    /// A scene of the program under a record of the program.
    ///
    /// # Errors
    /// Those of a scene and of a record.
    pub(super) fn own(scene: &str, record: &[u8]) -> Result<Self, Error> {
        let scene = Scene::parse(scene.as_bytes(), Path::new("scene.toml"))?;
        Self::with(scene, |file| Origin::of(Path::new(&file.file), record, file))
    }

    fn with(scene: Scene, read: impl FnOnce(&FileUse) -> Result<Origin, Error>) -> Result<Self, Error> {
        let origin = match &scene.record.source {
            Source::File(file) => Some(Arc::new(read(file)?)),
            Source::Generated(_) => None,
        };
        Ok(Self::of(scene, origin))
    }

    /// The scene under a record that no file of this machine is read for.
    ///
    /// # Errors
    /// Those of a record and of a scene.
    pub(super) fn under(&self, name: &str, record: &[u8]) -> Result<Self, Error> {
        let mut scene = self.scene.clone();
        let declared = match scene.record.source {
            Source::File(file) => file,
            Source::Generated(_) => FileUse::default(),
        };
        let declared = FileUse {
            file: name.into(),
            component: None,
            second_file: None,
            axis_deg: None,
            ..declared
        };
        let (origin, taken) = Origin::of_silent(Path::new(name), record, &declared)?;
        scene.record.source = Source::File(taken);
        Self::of(scene, Some(Arc::new(origin))).checked()
    }

    /// The same if it can run.
    ///
    /// # Errors
    /// Those of a scene.
    pub(super) fn checked(self) -> Result<Self, Error> {
        self.prepared(&self.scene, None)?;
        Ok(self)
    }

    /// Name of the scene.
    pub(super) fn name(&self) -> &str {
        &self.scene.name
    }

    /// The scene with knobs turned.
    ///
    /// # Errors
    /// Those of [`turned`].
    pub(super) fn turned(&self, knobs: &Turned) -> Result<Scene, Refused> {
        turned(&self.scene, knobs)
    }

    /// The turned scene, ready to run.
    ///
    /// # Errors
    /// Those of a scene.
    pub(super) fn prepared(&self, scene: &Scene, stop: Option<&'static AtomicBool>) -> Result<Simulation, Error> {
        let motion = match (&scene.record.source, &self.origin) {
            (Source::Generated(formula), _) => GroundMotion::of_formula(&scene.record, formula)?,
            (Source::File(_), Some(origin)) => GroundMotion::of_file(&scene.record, Arc::clone(origin))?,
            (Source::File(file), None) => return Err(Refused::at(file.file.clone()).is("was not read").into()),
        };
        let options = SimulationOptions {
            motion: Some(motion.into()),
            stop,
            ..SimulationOptions::default()
        };
        Simulation::new(scene, options)
    }

    /// Runs the turned scene as `run` does, in both directions, and finds the widths that its gaps need.
    ///
    /// # Errors
    /// Those of a run.
    pub(super) fn shown(&self, knobs: &Turned, stop: &'static AtomicBool) -> Result<Shown, Error> {
        let scene = self.turned(knobs)?;
        let prepared = self.prepared(&scene, Some(stop))?;
        let interval = Player::interval(&prepared);
        let ((review, exact), (other, gaps)) = both(
            || {
                let review = prepared.review_recorded(true, Some(interval));
                (review, Player::exact_beside(&prepared))
            },
            || (other_direction(&prepared), self.gaps(&prepared)),
        );
        let report = Report::of_review(&prepared, Arc::new(review?)).with_other_direction(other);
        Ok(Shown {
            summary: report.summary(),
            answer: report.first_screen(),
            gaps: gaps?,
            player: Player::of(&prepared, &report.review().outcome),
            // An exact run that fails is told in the answer.
            exact_um: exact.ok().flatten(),
            knobs: drawn(&self.scene, &scene),
        })
    }

    /// The gaps of a row and the widths that they need.
    fn gaps(&self, prepared: &Simulation) -> Result<Vec<GapNeeds>, Error> {
        let contacts = prepared.scene().contacts.as_deref().unwrap_or_default();
        if contacts.is_empty() {
            return Ok(Vec::new());
        }
        let Some([given, reversed]) = self.widths(prepared)? else {
            let says = "No width is given: a structure would hardly stand even alone.".into();
            return Ok(vec![GapNeeds { says, is_enough: false }]);
        };
        let needs = given.into_iter().zip(reversed).filter_map(|(given, reversed)| {
            let gap = contacts.get(given.left)?.gap_m;
            let is_enough = !given.asks_for_more(gap) && !reversed.asks_for_more(gap);
            let names = [given.left, given.left + 1].map(|one| prepared.scene().structures[one].name());
            let enough = rounded_up(1e3 * given.required.max(reversed.required), 1);
            let says = format!(
                "{}: required width {enough} mm, whatever the direction; it has {} mm, {}.",
                names.join(" – "),
                short(1e3 * gap),
                if is_enough { "wide enough" } else { "too narrow" }
            );
            Some(GapNeeds { says, is_enough })
        });
        Ok(needs.collect())
    }

    /// The widths of a row. They depend neither on gaps nor on laws, so that turning these takes the last ones.
    fn widths(&self, prepared: &Simulation) -> Result<Widths, Error> {
        let row = prepared.scene().apart();
        let row = Scene {
            contacts: row.contacts.map(|all| all.into_iter().map(blank).collect()),
            ..row
        };
        let known = || self.widths.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((last, widths)) = &*known()
            && *last == row
        {
            return Ok(widths.clone());
        }
        let mirrored = prepared.under(|record| record.scaled(-1.0))?;
        let (given, reversed) = both(|| JudgedSeparations::of(prepared), || JudgedSeparations::of(&mirrored));
        let all = [given?, reversed?];
        let stand = all.iter().all(|one| beyond_belief(&one.excesses).is_none());
        let widths = stand.then(|| all.map(|one| one.separations));
        *known() = Some((row, widths.clone()));
        Ok(widths)
    }
}

/// Does two things at once. Threads of their own: those of the pool may be busy with a long run of another window.
fn both<A, B: Send>(one: impl FnOnce() -> A, other: impl FnOnce() -> B + Send) -> (A, B) {
    thread::scope(|scope| {
        let other = scope.spawn(other);
        let one = one();
        (one, other.join().unwrap_or_else(|panic| resume_unwind(panic)))
    })
}

/// A contact whose gap and law are those of every other one.
fn blank(contact: Contact) -> Contact {
    Contact {
        gap_m: 0.0,
        law: ContactLaw::Stereomechanical(Stereomechanical::default()),
        ..contact
    }
}

/// A scene as a program for Python, which reads JSON as its own but for three words.
pub(super) fn python(scene: &Scene) -> String {
    format!(
        "# Run it in the folder of the scene's file, beside its record; `pounding demo` writes that of the demo and of the guided pages.\nimport pounding\n\ntrue, false, null = True, False, None\nscene = pounding.scene({})\n\
         run = scene.run()\nprint(run.sentence)\nprint(run.pairs)\n",
        json_text(scene).trim_end()
    )
}
