//! Whether two names belong to the same file.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use same_file::Handle;

/// The input that `output` would overwrite, under this name or another: a link of either kind, or another path to the same folder. `None`
/// if there is none, or if `output` does not exist yet.
pub fn input_at<'a>(output: &Path, inputs: &'a [PathBuf]) -> Option<&'a Path> {
    // Opening it could wait for a writer, as for a pipe.
    if !output.is_file() {
        return None;
    }
    let written = Handle::from_path(output).ok()?;
    let read = |input: &Path| input.is_file().then(|| Handle::from_path(input).ok());
    let mut inputs = inputs.iter().map(PathBuf::as_path);
    inputs.find(|input| read(input).flatten().is_some_and(|input| input == written))
}

/// Whether a file is still the file at a path.
pub(crate) fn is_at(file: &File, path: &Path) -> io::Result<bool> {
    match Handle::from_path(path) {
        Ok(there) => Ok(there == Handle::from_file(file.try_clone()?)?),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[cfg(unix)]
    #[test]
    fn extreme_all_names_of_an_input() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        for name in ["input", "other"] {
            fs::write(at(name), "x").unwrap();
        }
        fs::hard_link(at("input"), at("hard")).unwrap();
        std::os::unix::fs::symlink(at("input"), at("soft")).unwrap();
        let inputs = [at("nowhere"), at("input")];
        for name in ["input", "hard", "soft", "../input"] {
            let output = match name.strip_prefix("../") {
                Some(name) => folder.path().join(".").join(name),
                None => at(name),
            };
            assert_eq!(input_at(&output, &inputs), Some(&*inputs[1]), "{name}");
        }
        for name in ["other", "nowhere"] {
            assert_eq!(input_at(&at(name), &inputs), None, "{name}");
        }
    }
}
