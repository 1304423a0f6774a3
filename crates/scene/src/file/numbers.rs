//! Numbers of a structure of one storey by the names of their fields: a sweep sets them without reading the scene again.

use super::structure::SdofFile;
use crate::Damping;

/// Sets a number in the words of a file.
pub type SetNumber = fn(&mut SdofFile, f64);

/// What sets the field of this name, from the structure on; nothing for a field that is not one number.
pub fn set_number(field: &str) -> Option<SetNumber> {
    Some(match field {
        "mass_kg" => |words, number| words.mass_kg = number,
        "stiffness_n_per_m" => |words, number| words.stiffness_n_per_m = Some(number),
        "period_s" => |words, number| words.period_s = Some(number),
        "damping.ratio" => |words, number| words.damping = Damping::Ratio(number),
        "yield_force_n" => |words, number| words.yield_force_n = Some(number),
        "yield_displacement_m" => |words, number| words.yield_displacement_m = Some(number),
        "yield_drift_ratio" => |words, number| words.yield_drift_ratio = Some(number),
        "hardening_ratio" => |words, number| words.hardening_ratio = Some(number),
        "height_m" => |words, number| words.height_m = Some(number),
        "initial_displacement_m" => |words, number| words.initial_displacement_m = number,
        "initial_velocity_m_per_s" => |words, number| words.initial_velocity_m_per_s = number,
        _ => return None,
    })
}
