//! What is said of a ground motion: where it came from, what was read, and what was done to it.

use pounding::studies::{Detrend, Prepared, RecordUse, ScaleTo, digits};

use crate::text::short;

/// Source, peak, what was read and from which line, what was done, and what the file says of itself.
pub(crate) fn lines(prepared: &Prepared) -> Vec<String> {
    let (scene, record) = (prepared.scene(), prepared.record());
    let (time, peak) = record.peak();
    let mut lines = vec![
        scene.record.source.to_string(),
        format!(
            "peak {} g = {} m/s² at {} s, {} s long in steps of {} s",
            short(peak / scene.record.gravity_m_per_s2),
            short(peak),
            digits(time),
            digits(record.duration()),
            digits(record.time_step()),
        ),
    ];
    let readings = prepared.origin().map(|origin| origin.file.readings());
    let read = readings.into_iter().flatten().map(|reading| {
        let line = reading
            .line
            .map_or(String::new(), |line| format!(" (line {line})"));
        format!("{} {}{line}", reading.what, reading.found)
    });
    let read: Vec<String> = read.collect();
    if !read.is_empty() {
        lines.push(format!("read: {}", read.join(", ")));
    }
    let done = processing(&scene.record);
    if !done.is_empty() {
        lines.push(format!("then: {}", done.join(", ")));
    }
    lines.extend(record.source().lines().map(String::from));
    lines
}

/// What was done, a line each.
pub(crate) fn processing(record: &RecordUse) -> Vec<String> {
    let detrend = record.detrend.map(|line| match line {
        Detrend::Constant => "mean taken away".into(),
        Detrend::Linear => "straight line of least squares taken away".into(),
    });
    let band = record.band_pass.map(|band| {
        let passes = if band.causal {
            "forward"
        } else {
            "forward and backward"
        };
        format!(
            "band-pass {} to {} Hz, Butterworth, order {}, {passes}",
            digits(band.low_hz),
            digits(band.high_hz),
            band.order
        )
    });
    let resampled = record
        .resample_s
        .map(|step| format!("resampled every {step} s"));
    let target = record.scale_to.map(|target| match target {
        ScaleTo::PgaG(peak) => format!("scaled to a PGA of {peak} g"),
        ScaleTo::Sa {
            period_s,
            damping_ratio,
            sa_g,
        } => format!("scaled to Sa({period_s} s, damping {damping_ratio}) = {sa_g} g"),
    });
    let needs_g = target.is_some();
    let gravity = needs_g.then(|| format!("with g = {} m/s²", record.gravity_m_per_s2));
    let one = 1.0_f64.to_bits();
    let scale = (record.scale.to_bits() != one).then(|| format!("multiplied by {}", record.scale));
    let reversed = record.reversed.then(|| "reversed".into());
    let all = [detrend, band, resampled, target, gravity, scale, reversed];
    all.into_iter().flatten().collect()
}
