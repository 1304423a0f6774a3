//! The paper's future work for its own scenes: other ground motions, in both directions, and its claims under them.
//!
//! The scenes are those of Tables 2, 4, 6 and 7 and of Fig. 15 with the paper's structures, gaps and contact laws, by the
//! exact method. A run lasts until the ground has been at rest for a while, so that no collision is cut off; only
//! where a motion has a duration of its own does it end earlier, as the paper's does after 10 s.
//!
//! A case is a motion in one direction. A claim of the paper is asked in every case; where nothing touches it does not
//! apply.

mod findings;
mod matrix;
mod numbers;
mod response;
mod settings;
mod shaking;
mod spectra;
mod study;
mod world;

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::StudyError;
use crate::claims::{Tally, asked};
use crate::plot::{PlotError, render_png, writable};

pub use settings::{BeyondSettings, ListedMotion, Strength};
use shaking::Shaking;
pub use study::BeyondStudy;
use world::World;

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
    /// For each motion as recorded and reversed.
    worlds: Vec<[World; 2]>,
    papers: Option<Case>,
    periods: Vec<f64>,
    left_out: Vec<(String, String)>,
}

/// Motions in a figure; of more there are several.
const MOTIONS_PER_FIGURE: usize = 12;

impl Beyond {
    /// In how many cases each of the paper's claims holds, in their order; nothing for those that exact runs cannot be
    /// asked.
    pub fn tallies(&self) -> Vec<Option<Tally>> {
        let mut tallies = Vec::new();
        for ((index, _), asked) in asked().zip(findings::all(&self.worlds)) {
            tallies.resize(index, None);
            tallies.push(Some(asked.tally()));
        }
        tallies
    }

    /// The claims that exact runs can be asked, and in how many cases each holds.
    pub fn claims(&self) -> Vec<(&'static str, Tally)> {
        let claims = findings::all(&self.worlds);
        let counted = |asked: &findings::Asked<'_>| (asked.claim.claim, asked.tally());
        claims.iter().map(counted).collect()
    }

    /// Records that shook nothing, and why.
    pub fn left_out(&self) -> &[(String, String)] {
        &self.left_out
    }

    /// Tables and figures by their path in the results folder.
    ///
    /// # Errors
    /// [`StudyError::Plot`] for a figure that cannot be drawn.
    pub fn files(&self) -> Result<BTreeMap<PathBuf, Vec<u8>>, StudyError> {
        let (motions, worlds) = (&self.motions, &self.worlds);
        let mut files: BTreeMap<String, Vec<u8>> = [
            ("motions.csv", shaking::table(motions, &self.periods)),
            ("scenes.csv", numbers::table(motions, worlds)),
            ("direction.csv", numbers::directions(motions, worlds)),
            ("claims.csv", findings::table(motions, worlds, self.papers)),
            ("verdicts.csv", findings::verdicts(motions, worlds)),
        ]
        .map(|(name, text)| (name.into(), text.into_bytes()))
        .into();
        let pages: Vec<usize> = (0..motions.len()).step_by(MOTIONS_PER_FIGURE).collect();
        let pages: Result<Vec<_>, StudyError> = pages
            .into_par_iter()
            .map(|from| self.page(from..motions.len().min(from + MOTIONS_PER_FIGURE)))
            .collect();
        files.extend(pages?.into_iter().flatten());
        let folder = Path::new("beyond");
        let files = files.into_iter();
        Ok(files
            .map(|(name, bytes)| (folder.join(name), bytes))
            .collect())
    }

    /// The figures of some of the motions.
    fn page(&self, motions: Range<usize>) -> Result<Vec<(String, Vec<u8>)>, StudyError> {
        let number = match motions.start / MOTIONS_PER_FIGURE {
            0 => String::new(),
            page => format!("-{}", page + 1),
        };
        let drawn = |name: &str, png: Result<Vec<u8>, PlotError>| {
            let png = png.map_err(|source| StudyError::Plot {
                path: self.path.clone(),
                source,
            })?;
            Ok((format!("{name}{number}.png"), png))
        };
        let matrix = matrix::drawing(self, motions.clone());
        let response = response::figure(self, motions.clone());
        let spectra = spectra::figure(&self.motions[motions], &self.periods);
        Ok(vec![
            drawn("claims", render_png(&matrix))?,
            drawn("response", render_png(&response))?,
            drawn("spectra", render_png(&spectra))?,
        ])
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
