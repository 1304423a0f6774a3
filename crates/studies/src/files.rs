//! Files that studies make, and the words that several of their tables share.

use crate::StudyError;
use pounding_plot::{Picture, render_png};
use pounding_scene::sha256;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Contents of files by their paths.
pub(crate) type Files = BTreeMap<PathBuf, Vec<u8>>;

/// Files in a folder.
pub(crate) fn in_folder<Name: AsRef<Path>>(folder: impl AsRef<Path>, files: impl IntoIterator<Item = (Name, Vec<u8>)>) -> Files {
    let files = files.into_iter();
    files.map(|(name, bytes)| (folder.as_ref().join(name), bytes)).collect()
}

/// A picture as PNG; `path` is the file of its study.
///
/// # Errors
/// [`StudyError::Plot`] if it cannot be drawn.
pub(crate) fn drawn(picture: &impl Picture, path: &Path) -> Result<Vec<u8>, StudyError> {
    render_png(picture).map_err(|source| StudyError::Plot {
        path: path.to_path_buf(),
        source,
    })
}

/// The command that makes files which `reproduce` does not, and the hashes by which committed tables are known to be its.
pub(crate) fn made_by<Name: AsRef<Path>>(command: &str, files: &BTreeMap<Name, Vec<u8>>) -> Vec<u8> {
    let tables = files.iter().map(|(name, bytes)| (name.as_ref(), bytes));
    let tables = tables.filter(|(name, _)| name.extension().is_some_and(|end| end == "csv"));
    let lines = tables.map(|(name, bytes)| format!("SHA-256 of {}: {}\n", name.display(), sha256(bytes)));
    format!("{command}\n{}", lines.collect::<String>()).into_bytes()
}

/// A truth in a table.
pub(crate) fn yes_or_no(truth: bool) -> &'static str {
    if truth { "yes" } else { "no" }
}

/// Direction of a ground motion in words.
pub(crate) fn direction(reversed: bool) -> &'static str {
    if reversed { "reversed" } else { "as recorded" }
}

/// A name with its first letter large.
pub(crate) fn capital(name: &str) -> String {
    let mut letters = name.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}
