//! Tables that pandas and polars take.

use std::ffi::CStr;
use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{ArrayRef, BooleanArray, Float64Array, RecordBatch, RecordBatchIterator, StringArray, UInt64Array};
use arrow_schema::{ArrowError, Schema};
use pounding_text::CellKind;
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;
use serde_json::Value;

use crate::array::Array;

/// A column of a table.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Column {
    /// Numbers; NaN for a missing one.
    Numbers(Arc<[f64]>),
    /// Whole numbers, none of them missing.
    Counts(Arc<[u64]>),
    Flags(Vec<Option<bool>>),
    Texts(Vec<Option<String>>),
}

impl Column {
    pub(crate) fn numbers(numbers: impl IntoIterator<Item = Option<f64>>) -> Self {
        let numbers = numbers.into_iter();
        Self::Numbers(numbers.map(|number| number.unwrap_or(f64::NAN)).collect())
    }

    pub(crate) fn texts(texts: impl IntoIterator<Item = String>) -> Self {
        Self::Texts(texts.into_iter().map(Some).collect())
    }

    /// A column of JSON values of one kind. A column of counts with a missing one holds numbers.
    fn of<'a>(kind: CellKind, values: impl Iterator<Item = &'a Value> + Clone) -> Self {
        match kind {
            CellKind::Truth => Self::Flags(values.map(Value::as_bool).collect()),
            CellKind::Text | CellKind::Nested => Self::Texts(values.map(|value| value.as_str().map(String::from)).collect()),
            CellKind::Count if values.clone().all(Value::is_u64) => Self::Counts(values.filter_map(Value::as_u64).collect()),
            CellKind::Count | CellKind::Number => Self::numbers(values.map(Value::as_f64)),
        }
    }

    fn len(&self) -> usize {
        match self {
            Self::Numbers(numbers) => numbers.len(),
            Self::Counts(counts) => counts.len(),
            Self::Flags(flags) => flags.len(),
            Self::Texts(texts) => texts.len(),
        }
    }

    /// The column for Arrow; a missing number is null.
    fn to_arrow(&self) -> ArrayRef {
        match self {
            Self::Numbers(numbers) if numbers.iter().any(|number| number.is_nan()) => {
                let known = |number: &f64| (!number.is_nan()).then_some(*number);
                Arc::new(numbers.iter().map(known).collect::<Float64Array>())
            }
            Self::Numbers(numbers) => Arc::new(Float64Array::from(numbers.to_vec())),
            Self::Counts(counts) => Arc::new(UInt64Array::from(counts.to_vec())),
            Self::Flags(flags) => Arc::new(BooleanArray::from(flags.clone())),
            Self::Texts(texts) => Arc::new(StringArray::from_iter(texts)),
        }
    }
}

/// A table that does not change. Every reader of the Arrow PyCapsule interface takes it, for example `polars.DataFrame(table)`.
#[pyclass(frozen, module = "pounding._pounding")]
#[derive(Debug)]
pub(crate) struct Table {
    columns: Vec<(String, Column)>,
}

impl Table {
    pub(crate) fn new<Name: Into<String>>(columns: impl IntoIterator<Item = (Name, Column)>) -> Self {
        let columns = columns.into_iter();
        Self {
            columns: columns.map(|(name, column)| (name.into(), column)).collect(),
        }
    }

    /// The rows of a table for programs that have no reason in the column `refused`, without that column.
    pub(crate) fn of_found<Row>(table: &pounding_text::Table<'_, Row>) -> Self {
        let (refused, columns): (Vec<_>, Vec<_>) = table.values().partition(|(name, ..)| *name == "refused");
        let is_found = |row: usize| refused.iter().all(|(.., reasons)| reasons[row].is_null());
        Self::new(columns.iter().map(|(name, kind, values)| {
            let found = values.iter().enumerate().filter(|(row, _)| is_found(*row));
            (*name, Column::of(*kind, found.map(|(_, value)| value)))
        }))
    }

    fn to_arrow(&self) -> Result<RecordBatch, ArrowError> {
        let columns = self.columns.iter();
        RecordBatch::try_from_iter_with_nullable(columns.map(|(name, column)| (name, column.to_arrow(), true)))
    }
}

/// Name of a capsule that holds a stream of Arrow.
const STREAM: &CStr = c"arrow_array_stream";

#[pymethods]
impl Table {
    /// Names of the columns.
    #[getter]
    fn columns(&self) -> Vec<String> {
        let columns = self.columns.iter();
        columns.map(|(name, _)| name.clone()).collect()
    }

    /// Number of rows.
    fn __len__(&self) -> usize {
        self.columns.first().map_or(0, |(_, column)| column.len())
    }

    /// A column by its name: an `Array` of numbers, or a list of flags or texts.
    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let found = self.columns.iter().find(|(known, _)| known == name);
        let Some((_, column)) = found else {
            return Err(PyKeyError::new_err(name.to_owned()));
        };
        match column {
            Column::Numbers(numbers) => Ok(Bound::new(py, Array::floats(numbers))?.into_any()),
            Column::Counts(counts) => Ok(Bound::new(py, Array::counts(counts))?.into_any()),
            Column::Flags(flags) => flags.clone().into_pyobject(py),
            Column::Texts(texts) => texts.clone().into_pyobject(py),
        }
    }

    /// The table as an Arrow stream with one batch; the requested schema is ignored.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(&self, py: Python<'py>, requested_schema: Option<Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        // The protocol allows a producer to ignore the request.
        drop(requested_schema);
        let message = |error: ArrowError| PyValueError::new_err(error.to_string());
        let batch = self.to_arrow().map_err(message)?;
        let schema: Arc<Schema> = batch.schema();
        let batches = RecordBatchIterator::new([Ok(batch)], schema);
        let stream = FFI_ArrowArrayStream::new(Box::new(batches));
        Ok(PyCapsule::new_with_value(py, stream, STREAM)?.into_any())
    }

    fn __eq__(&self, other: &Self) -> bool {
        let same = |(one, other): (&(String, Column), &(String, Column))| one.0 == other.0 && same(&one.1, &other.1);
        self.columns.len() == other.columns.len() && self.columns.iter().zip(&other.columns).all(same)
    }
}

/// Whether two columns have equal bits.
fn same(one: &Column, other: &Column) -> bool {
    match (one, other) {
        (Column::Numbers(one), Column::Numbers(other)) => {
            let bits = |numbers: &[f64]| numbers.iter().map(|one| one.to_bits()).collect::<Vec<_>>();
            bits(one) == bits(other)
        }
        (one, other) => one == other,
    }
}
