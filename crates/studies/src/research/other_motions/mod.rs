//! The paper's future work for its own scenes: other ground motions, in both directions, and its claims under them.
//!
//! The scenes are those of Tables 2, 4, 6 and 7 and of Fig. 15 with the paper's structures, gaps and contact laws, by the
//! exact method. A run lasts until the ground has been at rest for a while, so that no collision is cut off; only
//! where a motion has a duration of its own does it end earlier, as the paper's does after 10 s.
//!
//! All of it is asked once more of changed scenes ([`Change`]): with buildings of several storeys in place of the structures, and
//! under weaker shaking.
//!
//! A case is a motion in one direction. A claim of the paper is asked in every case; where nothing touches it does not
//! apply.

mod figures;
mod findings;
mod matrix;
mod numbers;
mod shaking;
mod study;
mod world;

use crate::StudyError;
use crate::files::{Files, drawn, in_folder, made_by};
use crate::paper::claims::{ClaimCount, ClaimCounts, asked};
use crate::study::change::Change;
use pounding_plot::writable;
use pounding_scene::parallel;
use std::ops::Range;
use std::path::PathBuf;

use shaking::Shaking;
pub use study::BeyondStudy;
pub(crate) use study::motions_of;
use world::MotionCase;

/// A motion, by its place in the list, in one direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Case {
    motion: usize,
    reversed: bool,
}

/// What the scenes did under every motion in both directions.
#[derive(Debug)]
pub struct Beyond {
    path: PathBuf,
    motions: Vec<Shaking>,
    /// The paper's scenes first, then each change of them.
    groups: Vec<Group>,
    papers: Option<Case>,
    periods: Vec<f64>,
    left_out: Vec<(String, String)>,
}

/// What the scenes did under every motion in both directions, as the paper has them or with one change.
#[derive(Debug)]
struct Group {
    change: Option<Change>,
    /// For each motion as recorded and reversed.
    worlds: Vec<[MotionCase; 2]>,
}

/// A claim, and in how many cases it holds.
pub type Counted = (&'static str, ClaimCount);

/// Motions in a figure; of more there are several.
const MOTIONS_PER_FIGURE: usize = 12;

impl Beyond {
    /// In how many cases each of the paper's claims holds, a column for the paper's scenes and one for each change of them.
    pub fn tallies(&self) -> Vec<ClaimCounts> {
        let of = |(change, counted): (Option<Change>, Vec<Counted>)| {
            let mut claims = Vec::new();
            for ((index, _), (_, tally)) in asked().zip(counted) {
                claims.resize(index, None);
                claims.push(Some(tally));
            }
            let of_change = change.map(|change| format!("_{}", change.word()));
            let column = ClaimCounts::default().column + &of_change.unwrap_or_default();
            ClaimCounts { column, claims }
        };
        self.claims().into_iter().map(of).collect()
    }

    /// The claims that exact runs can be asked, and in how many cases each holds: of the paper's scenes, and of each change
    /// of them.
    pub fn claims(&self) -> Vec<(Option<Change>, Vec<Counted>)> {
        let of = |group: &Group| {
            let claims = findings::all(&group.worlds);
            let counted = |asked: &findings::Asked<'_>| (asked.claim.claim, asked.tally());
            (group.change, claims.iter().map(counted).collect())
        };
        self.groups.iter().map(of).collect()
    }

    /// Records that shook nothing, and why.
    pub fn left_out(&self) -> &[(String, String)] {
        &self.left_out
    }

    /// Tables and figures by their path in the results folder.
    ///
    /// # Errors
    /// [`StudyError::Plot`] for a figure that cannot be drawn.
    pub fn files(&self) -> Result<Files, StudyError> {
        let motions = shaking::table(&self.motions, &self.periods);
        let mut files = Files::from([("motions.csv".into(), motions.into_bytes())]);
        for page in self.pages() {
            let spectra = figures::spectra(&self.motions[page.clone()], &self.periods);
            files.insert(page_name("spectra", &page), drawn(&spectra, &self.path)?);
        }
        let groups = parallel::try_each(&self.groups, |group| self.of_group(group))?;
        for (group, made) in self.groups.iter().zip(groups) {
            files.extend(in_folder(group.change.map_or("", Change::word), made));
        }
        Ok(in_folder("beyond", files))
    }

    /// Tables and figures of a group by their names.
    fn of_group(&self, group: &Group) -> Result<Files, StudyError> {
        let (motions, worlds) = (&self.motions, &group.worlds);
        let tables = [
            ("scenes.csv", numbers::table(motions, worlds)),
            ("direction.csv", numbers::directions(motions, worlds)),
            ("claims.csv", self.findings(group)),
            ("verdicts.csv", findings::verdicts(motions, worlds)),
        ];
        let mut files = in_folder("", tables.map(|(name, text)| (name, text.into_bytes())));
        if group.change.is_some_and(Change::is_long) {
            files.insert("made-by.txt".into(), made_by("cargo xtask beyond", &files));
        }
        for page in self.pages() {
            let matrix = matrix::drawing(self, group, page.clone());
            files.insert(page_name("claims", &page), drawn(&matrix, &self.path)?);
            let response = figures::response(self, group, page.clone());
            files.insert(page_name("response", &page), drawn(&response, &self.path)?);
        }
        Ok(files)
    }

    /// The claims of a group; of changed scenes beside those of the paper's.
    fn findings(&self, group: &Group) -> String {
        let plain = group.change.is_some().then(|| findings::all(&self.groups[0].worlds));
        findings::table(&self.motions, &findings::all(&group.worlds), (plain, self.papers))
    }

    /// The motions of every page of a figure.
    fn pages(&self) -> impl Iterator<Item = Range<usize>> {
        let all = self.motions.len();
        let starts = (0..all).step_by(MOTIONS_PER_FIGURE);
        starts.map(move |from| from..all.min(from + MOTIONS_PER_FIGURE))
    }
}

/// Name of a figure of some of the motions.
fn page_name(figure: &str, motions: &Range<usize>) -> PathBuf {
    match motions.start / MOTIONS_PER_FIGURE {
        0 => format!("{figure}.png").into(),
        page => format!("{figure}-{}.png", page + 1).into(),
    }
}

/// A name that fits into a figure.
fn short(name: &str) -> String {
    const LONGEST: usize = 22;
    let name = writable(name);
    if name.chars().count() <= LONGEST {
        return name;
    }
    let start: String = name.chars().take(LONGEST - 1).collect();
    start + "…"
}
