//! The future work that the paper names, for its own scenes: other ground motions in both directions, and the paper's claims under them.
//!
//! The scenes are those of Tables 2, 4, 6 and 7 and of Fig. 15 with the paper's structures, gaps and contact laws, by the exact method. A
//! run lasts until the ground has been at rest for a while, so no collision is cut off. A motion with its own duration ends earlier: the
//! paper's ends after 10 s.
//!
//! All runs are repeated with changed scenes ([`Change`]): with buildings of several storeys instead of the structures, and under weaker
//! shaking.
//!
//! A case is a motion in one direction. Every claim of the paper is tested in every case; it does not apply if nothing touches.

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

/// A motion, by its index in the list, in one direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Case {
    motion: usize,
    reversed: bool,
}

/// Results of the scenes under every motion in both directions.
#[derive(Debug)]
pub struct Beyond {
    path: PathBuf,
    motions: Vec<Shaking>,
    /// The paper's scenes first, then one group per change.
    groups: Vec<Group>,
    papers: Option<Case>,
    periods: Vec<f64>,
    left_out: Vec<(String, String)>,
}

/// Results under every motion in both directions, of the paper's scenes or of one change of them.
#[derive(Debug)]
struct Group {
    change: Option<Change>,
    /// For each motion the results as given and reversed.
    worlds: Vec<[MotionCase; 2]>,
}

/// A claim in few words, with its counts.
pub type Counted = (&'static str, ClaimCount);

/// Number of motions in one figure; further motions get further figures.
const MOTIONS_PER_FIGURE: usize = 12;

impl Beyond {
    /// Counts for each of the paper's claims: one column for the paper's scenes, and one per change.
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

    /// Counts for the claims that exact runs can test, for the paper's scenes and for each change of them.
    pub fn claims(&self) -> Vec<(Option<Change>, Vec<Counted>)> {
        let of = |group: &Group| {
            let claims = findings::all(&group.worlds);
            let counted = |asked: &findings::TestedClaim<'_>| (asked.claim.claim, asked.tally());
            (group.change, claims.iter().map(counted).collect())
        };
        self.groups.iter().map(of).collect()
    }

    /// Names of the records that could not be used, with the reasons.
    pub fn left_out(&self) -> &[(String, String)] {
        &self.left_out
    }

    /// Tables and figures by their paths in the results folder.
    ///
    /// # Errors
    /// [`StudyError::Plot`] if a figure cannot be drawn.
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

    /// Table of the claims of a group; for changed scenes it includes the counts of the paper's scenes.
    fn findings(&self, group: &Group) -> String {
        let plain = group.change.is_some().then(|| findings::all(&self.groups[0].worlds));
        findings::table(&self.motions, &findings::all(&group.worlds), plain.as_deref(), self.papers)
    }

    /// The range of motions on every page of a figure.
    fn pages(&self) -> impl Iterator<Item = Range<usize>> {
        let all = self.motions.len();
        let starts = (0..all).step_by(MOTIONS_PER_FIGURE);
        starts.map(move |from| from..all.min(from + MOTIONS_PER_FIGURE))
    }
}

/// File name of a figure of some of the motions.
fn page_name(figure: &str, motions: &Range<usize>) -> PathBuf {
    match motions.start / MOTIONS_PER_FIGURE {
        0 => format!("{figure}.png").into(),
        page => format!("{figure}-{}.png", page + 1).into(),
    }
}

/// The name, shortened to fit into a figure.
fn short(name: &str) -> String {
    const LONGEST: usize = 22;
    let name = writable(name);
    if name.chars().count() <= LONGEST {
        return name;
    }
    let start: String = name.chars().take(LONGEST - 1).collect();
    start + "…"
}
