//! Regular files with a bounded length.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// Largest length of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Length {
    /// Number of bytes.
    most: u64,
    /// Advice for a longer file.
    help: &'static str,
}

impl Length {
    /// At most `most` bytes; `help` is the advice for a longer file.
    pub const fn new(most: u64, help: &'static str) -> Self {
        Self { most, help }
    }

    fn refused(self) -> io::Error {
        let most = self.most >> 20;
        refused(format!("it is longer than {most} MB, allowed are {most} MB; {}", self.help))
    }
}

fn refused(message: String) -> io::Error {
    io::Error::new(ErrorKind::InvalidInput, message)
}

/// Reads a regular file to its end. A file with a stated length of 0 is empty, whatever reading it would return.
///
/// # Errors
/// The error of the system. Pipes, devices and files that are too long are refused before memory is allocated.
pub fn read(path: &Path, length: Length) -> io::Result<Vec<u8>> {
    // Opening a pipe would wait for a writer.
    check(&fs::metadata(path)?, length)?;
    let file = File::open(path)?;
    let about = file.metadata()?;
    check(&about, length)?;
    // Files of /proc also state a length of 0: reading `/proc/kmsg` waits for a message of the kernel.
    if about.is_file() && about.len() == 0 {
        return Ok(Vec::new());
    }
    let mut bytes = Vec::with_capacity(usize::try_from(about.len()).unwrap_or_default());
    file.take(length.most + 1).read_to_end(&mut bytes)?;
    within(bytes, length)
}

/// Whether there is a regular file with these bytes; nothing else is opened.
///
/// # Errors
/// The error of the system, including [`ErrorKind::NotFound`].
pub fn holds(path: &Path, bytes: &[u8]) -> io::Result<bool> {
    let about = fs::metadata(path)?;
    let may = about.is_file() && about.len() == bytes.len() as u64;
    Ok(may && fs::read(path)? == bytes)
}

/// Reads a stream, such as standard input, to its end.
///
/// # Errors
/// The error of the system, or an error if the stream is too long.
pub fn read_stream(stream: impl Read, length: Length) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    stream.take(length.most + 1).read_to_end(&mut bytes)?;
    within(bytes, length)
}

fn within(bytes: Vec<u8>, length: Length) -> io::Result<Vec<u8>> {
    if bytes.len() as u64 > length.most {
        return Err(length.refused());
    }
    Ok(bytes)
}

fn check(about: &fs::Metadata, length: Length) -> io::Result<()> {
    // The system describes the error for a folder best.
    if about.is_dir() {
        return Ok(());
    }
    if !about.is_file() {
        return Err(refused(
            "it is a pipe or a device, allowed is a file; write its text into one".into(),
        ));
    }
    if about.len() > length.most {
        return Err(length.refused());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOST: Length = Length::new(1 << 20, "take less");

    #[test]
    fn limit_a_file_is_read_up_to_its_allowed_length() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        for (length, allowed) in [(0, true), (1 << 20, true), ((1 << 20) + 1, false)] {
            fs::write(&path, vec![b'x'; length]).unwrap();
            assert_eq!(read(&path, MOST).is_ok(), allowed, "{length}");
            let stream = &*vec![b'x'; length];
            assert_eq!(read_stream(stream, MOST).is_ok(), allowed, "{length}");
        }
        let said = read(&path, MOST).unwrap_err().to_string();
        assert_eq!(said, "it is longer than 1 MB, allowed are 1 MB; take less");
        assert_eq!(read(folder.path(), MOST).unwrap_err().kind(), ErrorKind::IsADirectory);
    }

    /// The comparison waited for a pipe in the place of a file.
    #[cfg(unix)]
    #[test]
    fn issue_what_is_no_file_holds_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let [file, pipe] = ["file", "pipe"].map(|name| folder.path().join(name));
        assert_eq!(holds(&file, b"a").unwrap_err().kind(), ErrorKind::NotFound);
        fs::write(&file, b"a").unwrap();
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.unwrap().success());
        let held = |path: &Path, bytes: &[u8]| holds(path, bytes).unwrap();
        assert!(held(&file, b"a") && !held(&file, b"b") && !held(&file, b"aa"));
        for other in [&pipe, folder.path(), Path::new("/dev/zero")] {
            assert!(!held(other, b"") && !held(other, b"a"), "{}", other.display());
        }
    }

    /// A device was read until memory was full.
    #[cfg(unix)]
    #[test]
    fn issue_a_device_without_end_is_refused() {
        for device in ["/dev/zero", "/dev/null"] {
            let said = read(Path::new(device), MOST).unwrap_err().to_string();
            assert!(said.starts_with("it is a pipe or a device"), "{said}");
        }
    }

    /// A file of /proc is regular, and reading `/proc/kmsg` had no end.
    #[cfg(target_os = "linux")]
    #[test]
    fn issue_a_file_without_length_is_empty() {
        let about_this_process = Path::new("/proc/self/status");
        assert!(!fs::read(about_this_process).unwrap().is_empty());
        assert_eq!(read(about_this_process, MOST).unwrap(), b"");
    }
}
