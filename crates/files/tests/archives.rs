//! Archives: what is unpacked, and what is refused.

use std::io::Write;

use flate2::Compression;
use flate2::write::{DeflateEncoder, GzEncoder};
use pounding_files::{ArchiveBounds, Archived, is_archive, unpacked};
use rawzip::path::EntryPath;
use rawzip::{CompressionMethod, ZipArchiveWriter};

const USUAL: ArchiveBounds = ArchiveBounds::USUAL;

fn zip(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = ZipArchiveWriter::new(Vec::new());
    for (index, (name, bytes)) in files.iter().enumerate() {
        let method = if index % 2 == 0 {
            CompressionMethod::DEFLATE
        } else {
            CompressionMethod::STORE
        };
        let path = EntryPath::verbatim(name.as_bytes());
        let (mut entry, config) = archive.new_file(path).compression_method(method).start().expect("an entry");
        let descriptor = if index % 2 == 0 {
            let mut writer = config.wrap(DeflateEncoder::new(&mut entry, Compression::default()));
            writer.write_all(bytes).expect("memory");
            let (encoder, descriptor) = writer.finish().expect("memory");
            encoder.finish().expect("memory");
            descriptor
        } else {
            let mut writer = config.wrap(&mut entry);
            writer.write_all(bytes).expect("memory");
            writer.finish().expect("memory").1
        };
        entry.finish(descriptor).expect("an entry");
    }
    archive.finish().expect("an archive")
}

fn tar(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut builder = tar::Builder::new(Vec::new());
    for (name, bytes) in files {
        let mut header = tar::Header::new_gnu();
        header.set_size(bytes.len() as u64);
        header.set_mode(0o644);
        // `set_path` refuses paths that leave the archive.
        header.as_old_mut().name[..name.len()].copy_from_slice(name.as_bytes());
        header.set_cksum();
        builder.append(&header, *bytes).expect("memory");
    }
    builder.into_inner().expect("memory")
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).expect("memory");
    encoder.finish().expect("memory")
}

fn found(bytes: &[u8]) -> Vec<(String, Result<Vec<u8>, String>)> {
    let all = unpacked("a.zip", bytes, USUAL).expect("an archive").into_iter();
    all.map(|Archived { name, bytes }| (name, bytes.map_err(|error| error.to_string())))
        .collect()
}

const FILES: [(&str, &[u8]); 5] = [
    ("a.AT2", b"one"),
    ("folder/b.AT2", b"two"),
    (".hidden", b"three"),
    ("__MACOSX/c", b"four"),
    ("folder/.git/d", b"five"),
];

#[test]
fn reference_files_of_zip_tar_and_gzip() {
    let wanted = vec![
        ("a.AT2".to_owned(), Ok(b"one".to_vec())),
        ("folder/b.AT2".to_owned(), Ok(b"two".to_vec())),
    ];
    for bytes in [zip(&FILES), tar(&FILES), gzip(&tar(&FILES))] {
        assert!(is_archive(&bytes));
        assert_eq!(found(&bytes), wanted);
    }
    let single = unpacked("quake.AT2.gz", &gzip(b"one"), USUAL).expect("one file");
    assert_eq!(single[0].name, "quake.AT2");
    assert_eq!(single[0].bytes.as_ref().expect("its bytes"), b"one");
}

/// Agencies pack the archive of each station into that of an event.
#[test]
fn reference_archives_in_archives() {
    let station = zip(&[("x.V2", b"one")]);
    let wanted = [("s/station.zip/x.V2".to_owned(), Ok(b"one".to_vec()))];
    assert_eq!(found(&zip(&[("s/station.zip", &station)])), wanted);
    // One more is a file like any other.
    let deeper = zip(&[("s.zip", &zip(&[("t.zip", &station)]))]);
    assert_eq!(found(&deeper), [("s.zip/t.zip".to_owned(), Ok(station))]);
}

/// A damaged archive of one station does not take those of the others with it.
#[test]
fn issue_a_damaged_archive_within_an_archive() {
    let station = zip(&[("x.V2", b"one")]);
    let event = zip(&[
        ("bad.zip", &station[..station.len() / 2]),
        ("good.zip", &station),
        ("bad.gz", &gzip(b"two")[..9]),
    ]);
    let found = found(&event);
    let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["bad.zip", "good.zip/x.V2", "bad.gz"]);
    assert!(found[0].1.as_ref().expect_err("damaged").contains("the ZIP archive is damaged"));
    assert_eq!(found[1].1, Ok(b"one".to_vec()));
    assert!(found[2].1.is_err());
}

#[test]
fn extreme_paths_that_leave_the_archive() {
    let names = ["../a", "/etc/b", "c/../../d", "C:\\e", "..\\f", "ok/g"];
    let files: Vec<(&str, &[u8])> = names.iter().map(|name| (*name, &b"x"[..])).collect();
    for bytes in [zip(&files), tar(&files)] {
        let found = found(&bytes);
        let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["a", "etc/b", "c/d", "C:/e", "f", "ok/g"]);
        for (name, bytes) in &found[..5] {
            assert_eq!(bytes, &Err("its path leads out of the archive".to_owned()), "{name}");
        }
        assert_eq!(found[5].1, Ok(b"x".to_vec()));
    }
}

#[test]
fn extreme_entries_that_are_not_unpacked() {
    let mut builder = tar::Builder::new(Vec::new());
    let mut header = tar::Header::new_gnu();
    header.set_entry_type(tar::EntryType::Symlink);
    header.set_size(0);
    builder.append_link(&mut header, "link", "/etc/passwd").expect("memory");
    let linked = found(&builder.into_inner().expect("memory"));
    assert_eq!(linked, [("link".to_owned(), Err("it is a link, which is not followed".to_owned()))]);
    let twice = found(&tar(&[("a", b"1"), ("a", b"2")]));
    assert_eq!(twice[1].1, Err("its name occurs twice in the archive".to_owned()));
    let mut encrypted = zip(&[("a", b"secret")]);
    // The flags in the central directory.
    let at = encrypted.windows(4).position(|four| four == b"PK\x01\x02").expect("a directory");
    encrypted[at + 8] |= 1;
    assert_eq!(
        found(&encrypted)[0].1,
        Err("it is encrypted: unpack the archive with its password".to_owned())
    );
}

/// A few kilobytes that unpack to gigabytes, and lists without end.
#[test]
fn extreme_archives_beyond_their_bounds() {
    let zeros = vec![0; 1 << 26];
    for bytes in [zip(&[("zeros", &zeros)]), gzip(&zeros), gzip(&tar(&[("zeros", &zeros)]))] {
        assert!(bytes.len() < 1 << 18, "{}", bytes.len());
        let refused = unpacked("a", &bytes, USUAL).expect_err("too much");
        assert!(refused.to_string().contains("far more bytes than it has"), "{refused}");
    }
    let bounds = ArchiveBounds { entries: 2, ..USUAL };
    let many = [("a", &b"1"[..]), ("b", b"2"), ("c", b"3")];
    for bytes in [zip(&many), tar(&many)] {
        assert!(unpacked("a", &bytes, bounds).is_err(), "three entries");
        assert_eq!(
            unpacked("a", &bytes, ArchiveBounds { entries: 3, ..USUAL }).expect("three").len(),
            3
        );
    }
    let exact = ArchiveBounds { bytes: 3, ..USUAL };
    assert!(unpacked("a", &zip(&many), exact).is_ok(), "three bytes");
    assert!(
        unpacked("a", &zip(&many), ArchiveBounds { bytes: 2, ..USUAL }).is_err(),
        "two bytes"
    );
}

/// Damage is an error of a file or of the archive, and no panic.
#[test]
fn extreme_damaged_archives() {
    for whole in [zip(&FILES), tar(&FILES), gzip(&tar(&FILES))] {
        for end in 0..whole.len() {
            let _ = unpacked("a", &whole[..end], USUAL);
        }
        for at in 0..whole.len() {
            let mut bytes = whole.clone();
            bytes[at] ^= 0x55;
            for one in unpacked("a", &bytes, USUAL).into_iter().flatten() {
                assert!(!one.name.contains(".."), "{at}: {}", one.name);
            }
        }
    }
    assert!(!is_archive(b"PEER NGA STRONG MOTION DATABASE RECORD"));
    assert!(unpacked("a", b"text", USUAL).is_err());
}

#[path = "../../../fuzz/src/archive.rs"]
mod fuzzed;

/// The seeds in `fuzz/corpus` pass the checks of the fuzz target for archives, and so do their beginnings.
#[test]
fn extreme_seeds_of_the_fuzz_target() {
    let seeds = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fuzz/corpus/archive");
    for seed in std::fs::read_dir(seeds).expect("seeds") {
        let bytes = std::fs::read(seed.expect("a seed").path()).expect("a seed");
        assert!(is_archive(&bytes), "a seed is an archive");
        (0..=bytes.len()).for_each(|end| fuzzed::check(&bytes[..end]));
    }
}
