//! Refusals of numbers and settings, by the fields of a scene.

use std::fmt::Display;

use pounding_text::{Refused, plain};

/// Refuses a number.
pub(crate) fn out_of_range(place: impl Display, found: f64, allowed: &'static str) -> Refused {
    Refused::at(place.to_string()).found(plain(found)).allowed(allowed)
}

/// Adds the field of a scene to the refusal of a setting of a filter, a formula or a spectrum.
pub(crate) fn in_setting(place: &str, refused: Refused) -> Refused {
    let setting = refused.place().field.as_ref();
    let field = match setting.map_or("", |setting| setting.path()) {
        "" | "gravity" | "target" => return refused.in_field(place.to_owned()),
        "time_step" if place.ends_with("_s") => return refused.in_field(place.to_owned()),
        "time_step" => "time_step_s",
        "low_corner" => "low_hz",
        "high_corner" => "high_hz",
        "amplitude" => "amplitude_m_per_s2",
        "frequency" => "frequency_hz",
        "phase" => "phase_rad",
        "duration" => "duration_s",
        "peak" => "pga_m_per_s2",
        "envelope.strong_from" => "strong_from_s",
        "envelope.strong_until" => "strong_until_s",
        "envelope.decay" => "decay_per_s",
        "cutoff" => "cutoff_hz",
        "ground.angular_frequency" => "ground.filters.angular_frequency_rad_per_s",
        "ground.damping_ratio" => "ground.filters.damping_ratio",
        "ground.high_pass_angular_frequency" => "ground.filters.high_pass_angular_frequency_rad_per_s",
        "ground.high_pass_damping_ratio" => "ground.filters.high_pass_damping_ratio",
        "periods[0]" => "period_s",
        own => own,
    };
    let field = format!("{place}.{field}");
    refused.in_field(field)
}
