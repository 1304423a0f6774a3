//! Files that studies write, and the words that several of their tables share.

use crate::StudyError;
use pounding_plot::{Picture, render_png};
use pounding_scene::sha256;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Contents of files by path.
pub(crate) type Files = BTreeMap<PathBuf, Vec<u8>>;

/// Puts files into a folder.
pub(crate) fn in_folder<Name: AsRef<Path>>(folder: impl AsRef<Path>, files: impl IntoIterator<Item = (Name, Vec<u8>)>) -> Files {
    let files = files.into_iter();
    files.map(|(name, bytes)| (folder.as_ref().join(name), bytes)).collect()
}

/// Draws a picture as PNG; `path` is the study file.
///
/// # Errors
/// [`StudyError::Plot`] if the picture cannot be drawn.
pub(crate) fn drawn(picture: &impl Picture, path: &Path) -> Result<Vec<u8>, StudyError> {
    render_png(picture).map_err(|source| StudyError::Plot {
        path: path.to_path_buf(),
        source,
    })
}

/// A text that records the command behind files that `reproduce` does not make. It lists the hash of each table, which a test compares with
/// the committed tables.
pub(crate) fn made_by<Name: AsRef<Path>>(command: &str, files: &BTreeMap<Name, Vec<u8>>) -> Vec<u8> {
    let tables = files.iter().map(|(name, bytes)| (name.as_ref(), bytes));
    let tables = tables.filter(|(name, _)| name.extension().is_some_and(|end| end == "csv"));
    let lines = tables.map(|(name, bytes)| format!("SHA-256 of {}: {}\n", name.display(), sha256(bytes)));
    format!("{command}\n{}", lines.collect::<String>()).into_bytes()
}

/// The word for a truth value in tables.
pub(crate) fn yes_or_no(truth: bool) -> &'static str {
    if truth { "yes" } else { "no" }
}

/// The word for the direction of a ground motion in tables.
pub(crate) fn direction(reversed: bool) -> &'static str {
    if reversed { "reversed" } else { "as given" }
}

/// The name with its first letter in upper case.
pub(crate) fn capital(name: &str) -> String {
    let mut letters = name.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}
