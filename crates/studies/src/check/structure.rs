//! Checks a structure, field by field.

use super::{FINITE, NOT_NEGATIVE, POSITIVE, require};
use crate::{Damping, SceneError, Sdof};

/// Refuses the first field of a structure that cannot be modelled.
pub(super) fn check(index: usize, structure: &Sdof) -> Result<(), SceneError> {
    let place = |field: &str| format!("structures[{index}].sdof.{field}");
    let Sdof {
        mass_kg: m,
        stiffness_n_per_m: k,
        ..
    } = *structure;
    require(m > 0.0, place("mass_kg"), m, POSITIVE)?;
    require(k > 0.0, place("stiffness_n_per_m"), k, POSITIVE)?;
    check_damping(structure, &place)?;
    if let Some(height) = structure.height_m {
        require(height > 0.0, place("height_m"), height, POSITIVE)?;
    }
    if let Some(force) = structure.yield_force_n {
        require(force > 0.0, place("yield_force_n"), force, POSITIVE)?;
    }
    require(
        true,
        place("initial_displacement_m"),
        structure.initial_displacement_m,
        FINITE,
    )?;
    require(
        true,
        place("initial_velocity_m_per_s"),
        structure.initial_velocity_m_per_s,
        FINITE,
    )
}

fn check_damping(structure: &Sdof, place: &impl Fn(&str) -> String) -> Result<(), SceneError> {
    match structure.damping {
        Damping::Ratio(ratio) => {
            require(ratio >= 0.0, place("damping.ratio"), ratio, NOT_NEGATIVE)?;
        }
        Damping::Rayleigh {
            alpha_per_s,
            beta_s,
        } => {
            require(
                alpha_per_s >= 0.0,
                place("damping.rayleigh.alpha_per_s"),
                alpha_per_s,
                NOT_NEGATIVE,
            )?;
            require(
                beta_s >= 0.0,
                place("damping.rayleigh.beta_s"),
                beta_s,
                NOT_NEGATIVE,
            )?;
        }
        Damping::TwoFrequencies {
            frequencies_hz: [first, second],
            ratios,
        } => {
            let frequency =
                |index| place(&format!("damping.two_frequencies.frequencies_hz[{index}]"));
            require(first > 0.0, frequency(0), first, POSITIVE)?;
            let allowed = "a finite number above the first frequency";
            require(second > first, frequency(1), second, allowed)?;
            for (index, ratio) in ratios.into_iter().enumerate() {
                let place = place(&format!("damping.two_frequencies.ratios[{index}]"));
                require(ratio >= 0.0, place, ratio, NOT_NEGATIVE)?;
            }
            let found = structure.damping_ratio();
            let allowed = "a damping ratio >= 0 at the structure's own frequency; closer ratios, or frequencies on either \
                           side of it, give one";
            require(
                found >= 0.0,
                place("damping.two_frequencies"),
                found,
                allowed,
            )?;
        }
    }
    Ok(())
}
