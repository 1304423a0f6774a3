//! Pairs of horizontal components of one recording, and the motions along an axis between them.

use std::ffi::OsString;
use std::path::Path;
use std::sync::Arc;

use pounding_motion::Bearing;
use pounding_scene::{Error, FileUse, PairAngles};

use super::{LeftOut, LeftOutKind, Suite, SuiteMotion};

/// Two horizontal components of one recording.
#[derive(Debug, Clone, PartialEq)]
pub struct HorizontalPair<'s> {
    /// The components.
    pub motions: [&'s SuiteMotion; 2],
    /// Their angles.
    pub angles: PairAngles,
}

impl HorizontalPair<'_> {
    /// Name of the recording: that of its only file, the common name of two files, or both names.
    pub fn name(&self) -> String {
        let [one, other] = self.motions;
        if one.path == other.path {
            pounding_files::shown_name(&one.path)
        } else if one.named.stem == other.named.stem {
            one.named.stem.clone()
        } else {
            format!("{} + {}", one.name, other.name)
        }
    }
}

impl Suite {
    /// Returns the pairs of the folder, in the order of its events.
    ///
    /// A pair is an event of exactly two motions that begin together and have one time step and one unit. By their names they are at right
    /// angles, up to 5°. Without names the second is taken as a right angle clockwise from the first.
    pub fn pairs(&self) -> Vec<HorizontalPair<'_>> {
        (0..self.n_events).filter_map(|event| self.pair(event)).collect()
    }

    fn pair(&self, event: usize) -> Option<HorizontalPair<'_>> {
        let of_event: Vec<&SuiteMotion> = self.motions.iter().filter(|one| one.event == event).collect();
        let [one, other] = of_event[..] else {
            return None;
        };
        let steps = [one, other].map(|one| one.origin.file.time_step());
        let are_even = (steps[0] - steps[1]).abs() <= 1e-9 * steps[0] && one.origin.file.unit() == other.origin.file.unit();
        let begin_together = one.identity.time.is_none() || other.identity.time.is_none() || one.identity.time == other.identity.time;
        let are_factors = self
            .alike
            .iter()
            .any(|(a, b, _)| *a == one.name && *b == other.name || *a == other.name && *b == one.name);
        if !are_even || !begin_together || are_factors {
            return None;
        }
        let bearings = [one, other].map(|one| match (&one.taken.component, &one.told.component) {
            // Of several components the name of the file tells nothing.
            (Some(_), _) => one.origin.file.component().and_then(Bearing::of_component),
            (None, Some(word)) => Bearing::of_component(word),
            (None, None) => one.origin.bearing(&one.named),
        });
        Some(HorizontalPair {
            motions: [one, other],
            angles: PairAngles::of(bearings)?,
        })
    }

    /// Tells the motions of each pair of each other.
    pub(super) fn join_pairs(&mut self) {
        let joined = self.pairs().into_iter().map(|pair| {
            let [one, other] = pair.motions.map(|one| Arc::clone(&one.origin));
            (pair.motions[0].event, (one, other, pair.angles))
        });
        let joined: Vec<_> = joined.collect();
        for motion in &mut self.motions {
            let of_event = joined.iter().find(|(event, _)| *event == motion.event);
            motion.pair = of_event.map(|(_, pair)| pair.clone());
        }
    }

    /// Turns each pair into one motion along an axis \[°\], and leaves out motions without a second one.
    pub(super) fn turn(&mut self, axis: f64) -> Result<(), Error> {
        let pairs = self.pairs();
        let turned = pairs.iter().map(|pair| along(pair, axis)).collect::<Result<Vec<_>, _>>()?;
        let from_first = pairs.iter().filter(|pair| !pair.angles.from_north).map(HorizontalPair::name);
        self.from_first = from_first.collect();
        let is_paired = |motion: &SuiteMotion| turned.iter().any(|one: &SuiteMotion| one.event == motion.event);
        let alone = self.motions.iter().filter(|motion| !is_paired(motion)).map(|motion| LeftOut {
            name: motion.name.clone(),
            path: motion.path.clone(),
            reason: LeftOutKind::Unpaired.saying(""),
            motion: Some(Box::new(motion.clone())),
        });
        self.left_out.extend(alone);
        self.motions = turned;
        self.number_events();
        Ok(())
    }
}

/// The motion of a pair along an axis \[°\].
fn along(pair: &HorizontalPair<'_>, axis: f64) -> Result<SuiteMotion, Error> {
    let [one, other] = pair.motions;
    let origin = one.origin.rotated(&other.origin, pair.angles, axis);
    let origin = origin.map_err(|refused| refused.in_file(&one.path))?;
    let same_file = one.path == other.path;
    let second_file = (!same_file).then(|| beside(&one.path, &other.path));
    Ok(SuiteMotion {
        name: pair.name(),
        taken: FileUse {
            component: None,
            second_file,
            axis_deg: Some(axis),
            ..one.taken.clone()
        },
        origin: Arc::new(origin),
        ..one.clone()
    })
}

/// A file as it is named from the folder of another one; both paths begin at one place.
fn beside(path: &Path, other: &Path) -> String {
    let parts = |path: &Path| {
        path.parent().map_or_else(Vec::new, |folder| {
            folder.components().map(|part| part.as_os_str().to_owned()).collect()
        })
    };
    let [own, its]: [Vec<OsString>; 2] = [path, other].map(parts);
    let n_shared = own.iter().zip(&its).take_while(|(one, other)| one == other).count();
    let up = own[n_shared..].iter().map(|_| "../".to_owned());
    let down = its[n_shared..].iter().map(|part| format!("{}/", part.display()));
    up.chain(down).chain([pounding_files::shown_name(other)]).collect()
}
