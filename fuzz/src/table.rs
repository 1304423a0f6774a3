//! The assertions on every table beside records: it is refused, or no file vanishes and all values are finite.

use std::fs;
use std::path::Path;

use pounding_assess::{FolderUse, SelectionFactors, Suite};

/// Reads a folder with two lists of numbers and the bytes as a table of them.
pub(crate) fn check(bytes: &[u8], folder: &Path) {
    let values = |rate: f64| {
        let one = |step: i32| format!("{}\n", rate * f64::from(step * (40 - step)));
        (0..40).map(one).collect::<Vec<_>>().concat()
    };
    for (name, rate) in [("one.txt", 0.3), ("two.txt", 0.7)] {
        fs::write(folder.join(name), values(rate)).expect("a disk");
    }
    for table in ["records.csv", "_SearchResults.csv"] {
        let path = folder.join(table);
        fs::write(&path, bytes).expect("a disk");
        let asked = FolderUse {
            selection_factors: SelectionFactors::Used,
            ..FolderUse::default()
        };
        if let Ok(suite) = Suite::of(&[folder.to_path_buf()], asked) {
            assert_eq!(suite.n_entries, 3, "an entry vanished");
            let values = suite.motions.iter().flat_map(|one| one.origin().file.values());
            assert!(values.into_iter().all(|value| value.is_finite()), "a value is not finite");
            assert!(!suite.said(true).is_empty(), "nothing is said");
        }
        fs::remove_file(&path).expect("it was made");
    }
}
