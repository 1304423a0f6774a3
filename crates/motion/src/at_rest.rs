//! Correction of a motion so that the ground ends at rest at its initial position.

use crate::{Record, Refused};

/// The record minus (p + q·t) times weights, with p and q such that velocity and displacement end at zero, to rounding.
///
/// There is one weight ≥ 0 for every sample. If fewer than two are above zero, the record stays unchanged.
pub(crate) fn brought_to_rest(record: &Record, weights: &[f64]) -> Result<Record, Refused> {
    let middle = 0.5 * (weights.len() - 1) as f64;
    let tilted = |(index, weight): (usize, &f64)| weight * (index as f64 - middle);
    let tilted: Vec<f64> = weights.iter().enumerate().map(tilted).collect();
    let end = end_of(record);
    let of_level = end_of(&with(record, weights.to_vec())?);
    let of_tilt = end_of(&with(record, tilted.clone())?);
    let cross = |left: [f64; 2], right: [f64; 2]| left[0] * right[1] - left[1] * right[0];
    let determinant = cross(of_level, of_tilt);
    if determinant == 0.0 {
        return Ok(record.clone());
    }
    let level = cross(end, of_tilt) / determinant;
    let tilt = cross(of_level, end) / determinant;
    let shapes = weights.iter().zip(&tilted);
    let samples = record.samples().iter().zip(shapes);
    let less = |(sample, (weight, tilted))| sample - level * weight - tilt * tilted;
    with(record, samples.map(less).collect())
}

/// Replaces the samples of a record.
fn with(record: &Record, samples: Vec<f64>) -> Result<Record, Refused> {
    Record::new(record.time_step(), samples, record.source())
}

/// Velocity \[m/s\] and displacement \[m\] at the end of a record.
fn end_of(record: &Record) -> [f64; 2] {
    let integrated = record.integrated();
    let last = |values: Vec<f64>| values.last().copied().unwrap_or(0.0);
    [last(integrated.velocity), last(integrated.displacement)]
}
