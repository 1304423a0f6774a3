//! Numbers in memory that NumPy reads without a copy.

use std::sync::Arc;

use pounding_scene::SharedMotion;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The memory of the numbers.
#[derive(Debug, Clone)]
enum Memory {
    Floats(Arc<[f64]>),
    Counts(Arc<[u64]>),
    /// Samples of a ground motion.
    Motion(SharedMotion),
}

/// Numbers that do not change: `numpy.asarray` gives a read-only view of them.
#[pyclass(frozen, module = "pounding._pounding")]
#[derive(Debug)]
pub(crate) struct Array {
    memory: Memory,
    shape: Vec<usize>,
}

impl Array {
    pub(crate) fn floats(numbers: &Arc<[f64]>) -> Self {
        Self {
            shape: vec![numbers.len()],
            memory: Memory::Floats(Arc::clone(numbers)),
        }
    }

    pub(crate) fn counts(numbers: &Arc<[u64]>) -> Self {
        Self {
            shape: vec![numbers.len()],
            memory: Memory::Counts(Arc::clone(numbers)),
        }
    }

    /// A matrix with one row per list; all lists are as long as the first.
    pub(crate) fn rows(lists: &[Vec<f64>]) -> Self {
        Self {
            shape: vec![lists.len(), lists.first().map_or(0, Vec::len)],
            memory: Memory::Floats(lists.concat().into()),
        }
    }

    pub(crate) fn motion(motion: &SharedMotion) -> Self {
        Self {
            shape: vec![motion.record().samples().len()],
            memory: Memory::Motion(motion.clone()),
        }
    }
}

#[pymethods]
impl Array {
    /// Address, type and shape in NumPy's form. The memory lives as long as this object.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (address, kind) = match &self.memory {
            Memory::Floats(numbers) => (numbers.as_ptr().addr(), "f8"),
            Memory::Counts(numbers) => (numbers.as_ptr().addr(), "u8"),
            Memory::Motion(motion) => (motion.record().samples().as_ptr().addr(), "f8"),
        };
        let order = if cfg!(target_endian = "little") { "<" } else { ">" };
        let interface = PyDict::new(py);
        interface.set_item("version", 3)?;
        interface.set_item("typestr", format!("{order}{kind}"))?;
        interface.set_item("shape", pyo3::types::PyTuple::new(py, &self.shape)?)?;
        interface.set_item("data", (address, true))?;
        Ok(interface.into_any())
    }
}
