//! The functions and classes that Python calls: scenes, records, runs and answers of the other crates as objects that do not change.
//!
//! Users see the package `pounding` in `python/`, which has the words, units and defaults. This library below it takes scenes as JSON, in
//! the words of their files. It gives numbers as memory that NumPy and Arrow read. It makes no decisions.
//!
//! Work runs on a separate thread. The caller waits without the lock of the interpreter and watches for Ctrl-C (`waiting.rs`).

mod answers;
mod array;
mod disk;
mod folder;
mod ida;
mod record;
mod refused;
mod run;
mod sweep;
mod table;
mod waiting;

use pyo3::prelude::*;

/// Functions and classes for the package `pounding`.
#[pymodule]
mod _pounding {
    #[pymodule_export]
    use super::answers::{
        advise, certify, check_scene, effects, laws, opensees, periods_between, read_words, sketch_scene, visible, words_of,
    };
    #[pymodule_export]
    use super::array::Array;
    #[pymodule_export]
    use super::disk::write_files;
    #[pymodule_export]
    use super::folder::{Assessment, assess, required_gap};
    #[pymodule_export]
    use super::ida::{Ida, ida};
    #[pymodule_export]
    use super::record::Record;
    #[pymodule_export]
    use super::run::{Run, run};
    #[pymodule_export]
    use super::sweep::sweep;
    #[pymodule_export]
    use super::table::Table;
}
