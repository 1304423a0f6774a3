//! Files within archives, unpacked in memory and within bounds.

use std::collections::BTreeSet;
use std::io::{self, ErrorKind, Read};

use flate2::read::{DeflateDecoder, MultiGzDecoder};
use rawzip::{CompressionMethod, ZipArchive};

/// A file of an archive.
#[derive(Debug)]
pub struct Archived {
    /// Its path in the archive, with `/` between folders.
    pub name: String,
    /// Its content, or the reason why it is not unpacked.
    pub bytes: io::Result<Vec<u8>>,
}

/// Bounds of the content of an archive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ArchiveBounds {
    /// Largest number of entries, those of archives within the archive included.
    pub entries: usize,
    /// Largest number of bytes of all files together.
    pub bytes: u64,
    /// Largest ratio of the bytes of all files to those of the archive, from [`Self::FREE`] bytes on.
    pub ratio: u64,
}

impl ArchiveBounds {
    /// 20 000 entries, 1 GiB, and 200 times the bytes of the archive.
    pub const USUAL: Self = Self {
        entries: 20_000,
        bytes: 1 << 30,
        ratio: 200,
    };
    /// Number of bytes that any archive may hold, whatever their ratio.
    pub const FREE: u64 = 16 << 20;
}

/// Largest number of archives within each other: agencies pack a ZIP for each station into one for an event.
const DEEPEST: usize = 2;

/// Whether bytes begin like an archive: ZIP, gzip or tar.
pub fn is_archive(bytes: &[u8]) -> bool {
    Kind::of(bytes).is_some()
}

/// Unpacks the files of a ZIP, tar or gzip archive in memory, in the order of the archive, archives within it included. `name` is the
/// name of the archive; a gzip file that is no tar holds one file with this name without `.gz`.
///
/// Folders and hidden files are skipped. Links, encrypted entries and names that leave the archive (`../x`, `/x`) are not unpacked; they are
/// returned with the reason.
///
/// # Errors
/// Refuses bytes that are no archive, a damaged list of entries, and content beyond the bounds.
pub fn unpacked(name: &str, bytes: &[u8], bounds: ArchiveBounds) -> io::Result<Vec<Archived>> {
    let most = bounds
        .bytes
        .min((bytes.len() as u64).saturating_mul(bounds.ratio).max(ArchiveBounds::FREE));
    let mut unpacking = Unpacking {
        most_entries: bounds.entries,
        entries: bounds.entries,
        bytes: most,
        names: BTreeSet::new(),
        found: Vec::new(),
    };
    let kind = Kind::of(bytes).ok_or_else(|| refused("it is no archive of a known form".into()))?;
    unpacking.archive(kind, name, "", bytes, 1)?;
    Ok(unpacking.found)
}

#[derive(Clone, Copy)]
enum Kind {
    Zip,
    Gzip,
    Tar,
}

impl Kind {
    fn of(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06") {
            Some(Self::Zip)
        } else if bytes.starts_with(&[0x1f, 0x8b, 8]) {
            Some(Self::Gzip)
        } else if bytes.get(257..262) == Some(b"ustar") {
            Some(Self::Tar)
        } else {
            None
        }
    }
}

fn refused(message: String) -> io::Error {
    io::Error::new(ErrorKind::InvalidData, message)
}

/// The room that is left, and the files that were found.
struct Unpacking {
    most_entries: usize,
    entries: usize,
    bytes: u64,
    names: BTreeSet<String>,
    found: Vec<Archived>,
}

impl Unpacking {
    /// Unpacks an archive; `name` is its own name, `folder` that of its files, with a `/` at the end unless it is empty.
    fn archive(&mut self, kind: Kind, name: &str, folder: &str, bytes: &[u8], depth: usize) -> io::Result<()> {
        match kind {
            Kind::Zip => self.zip(folder, bytes, depth),
            Kind::Tar => self.tar(folder, bytes, depth),
            Kind::Gzip => {
                let content = self.read(MultiGzDecoder::new(bytes))?;
                if let Some(Kind::Tar) = Kind::of(&content) {
                    // The bytes of the files count, not those of the tar.
                    self.bytes += content.len() as u64;
                    return self.tar(folder, &content, depth);
                }
                self.entry()?;
                let file = name.strip_suffix(".gz").or_else(|| name.strip_suffix(".GZ")).unwrap_or(name);
                self.file(format!("{folder}{file}"), Ok(content), depth)
            }
        }
    }

    fn zip(&mut self, folder: &str, bytes: &[u8], depth: usize) -> io::Result<()> {
        let damaged = |error: rawzip::Error| refused(format!("the ZIP archive is damaged: {error}"));
        let archive = ZipArchive::from_slice(bytes).map_err(damaged)?;
        for entry in archive.entries() {
            let entry = entry.map_err(damaged)?;
            self.entry()?;
            if entry.is_dir() {
                continue;
            }
            let raw = String::from_utf8_lossy(entry.file_path().as_ref()).into_owned();
            let mut content = || {
                // Bit 0 of the flags.
                if entry.flags().is_encrypted() {
                    return Err(refused("it is encrypted: unpack the archive with its password".into()));
                }
                let data = archive.get_entry(entry.wayfinder()).map_err(damaged)?;
                match entry.compression_method() {
                    CompressionMethod::STORE => self.read(data.verifying_reader(data.data())),
                    CompressionMethod::DEFLATE => self.read(data.verifying_reader(DeflateDecoder::new(data.data()))),
                    _ => Err(refused("its compression is not known here: unpack the archive".into())),
                }
            };
            let content = content();
            self.named(folder, &raw, content, depth)?;
        }
        Ok(())
    }

    fn tar(&mut self, folder: &str, bytes: &[u8], depth: usize) -> io::Result<()> {
        let damaged = |error: io::Error| refused(format!("the tar archive is damaged: {error}"));
        for entry in tar::Archive::new(bytes).entries().map_err(damaged)? {
            let entry = entry.map_err(damaged)?;
            self.entry()?;
            let raw = String::from_utf8_lossy(&entry.path_bytes()).into_owned();
            let kind = entry.header().entry_type();
            let content = if kind.is_file() {
                let stated = entry.size();
                let content = self.read(entry);
                // A tar that ends early gives fewer bytes, and no error.
                content.and_then(|content| {
                    if content.len() as u64 == stated {
                        Ok(content)
                    } else {
                        Err(refused("it is cut short".into()))
                    }
                })
            } else if kind.is_symlink() || kind.is_hard_link() {
                Err(refused("it is a link, which is not followed".into()))
            } else {
                continue;
            };
            self.named(folder, &raw, content, depth)?;
        }
        Ok(())
    }

    /// Counts an entry.
    fn entry(&mut self) -> io::Result<()> {
        self.entries = self.entries.checked_sub(1).ok_or_else(|| {
            let most = self.most_entries;
            let message = format!("the archive has more than {most} entries; unpack what you need of it");
            io::Error::new(ErrorKind::FileTooLarge, message)
        })?;
        Ok(())
    }

    /// Reads a file within the room that is left. Only [`ErrorKind::FileTooLarge`] ends the archive.
    fn read(&mut self, from: impl Read) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        from.take(self.bytes + 1).read_to_end(&mut bytes)?;
        match self.bytes.checked_sub(bytes.len() as u64) {
            Some(left) => {
                self.bytes = left;
                Ok(bytes)
            }
            None => Err(io::Error::new(
                ErrorKind::FileTooLarge,
                "the archive holds far more bytes than it has; unpack what you need of it",
            )),
        }
    }

    /// Keeps a file of an archive under its own name.
    fn named(&mut self, folder: &str, raw: &str, content: io::Result<Vec<u8>>, depth: usize) -> io::Result<()> {
        if let Err(error) = &content
            && error.kind() == ErrorKind::FileTooLarge
        {
            return content.map(|_| ());
        }
        let name = raw.replace('\\', "/");
        let mut parts: Vec<&str> = name.split('/').filter(|part| !part.is_empty() && *part != ".").collect();
        let escapes = name.starts_with('/') || parts.contains(&"..") || parts.first().is_some_and(|first| first.ends_with(':'));
        if parts.iter().any(|part| part.starts_with('.') && *part != "..") || parts.first() == Some(&"__MACOSX") {
            return Ok(());
        }
        parts.retain(|part| *part != "..");
        let content = if escapes {
            Err(refused("its path leads out of the archive".into()))
        } else {
            content
        };
        self.file(format!("{folder}{}", parts.join("/")), content, depth)
    }

    /// Keeps a file, or the files of an archive within the archive. Of two with one name, the first stays.
    fn file(&mut self, name: String, mut bytes: io::Result<Vec<u8>>, depth: usize) -> io::Result<()> {
        if let Ok(content) = &bytes
            && depth < DEEPEST
            && let Some(kind) = Kind::of(content)
        {
            let own = name.rsplit('/').next().unwrap_or_default().to_owned();
            match self.archive(kind, &own, &format!("{name}/"), content, depth + 1) {
                // A damaged archive within the archive costs its own files only.
                Err(error) if error.kind() != ErrorKind::FileTooLarge => bytes = Err(error),
                done => return done,
            }
        }
        let bytes = if self.names.insert(name.clone()) {
            bytes
        } else {
            Err(refused("its name occurs twice in the archive".into()))
        };
        self.found.push(Archived { name, bytes });
        Ok(())
    }
}
