//! The assertions on every archive: bounds hold, no name leaves the archive, and no name occurs twice.

use std::collections::BTreeSet;

use pounding_files::{ArchiveBounds, unpacked};

const BOUNDS: ArchiveBounds = ArchiveBounds {
    entries: 100,
    bytes: 1 << 20,
    ratio: 200,
};

/// Unpacks bytes as an archive.
pub(crate) fn check(bytes: &[u8]) {
    let Ok(all) = unpacked("a.csv.gz", bytes, BOUNDS) else {
        return;
    };
    assert!(all.len() <= BOUNDS.entries, "{} files", all.len());
    let mut names = BTreeSet::new();
    let mut length = 0;
    for one in &all {
        let leaves = one.name.starts_with('/') || one.name.split('/').any(|part| part == "..");
        assert!(!leaves, "{}", one.name);
        if let Ok(content) = &one.bytes {
            length += content.len() as u64;
            assert!(names.insert(&one.name), "{} occurs twice", one.name);
        }
    }
    assert!(length <= BOUNDS.bytes, "{length} bytes");
}
