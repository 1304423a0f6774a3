//! Gravity on leaning storeys (P-Δ): the weight above a storey over its height is a stiffness that every branch of its columns loses.

use pounding_text::{Refused, digits, short};

use crate::{Capacities, Columns, PDelta, Scene, StoreyProperties, Structure};

/// Weight that a floor adds to the storeys below \[N\].
pub(super) fn weight(scene: &Scene, mass: f64, capacities: &Capacities) -> f64 {
    let own = match scene.p_delta {
        Some(PDelta::FromMasses) => mass * scene.record.gravity_m_per_s2,
        None => 0.0,
    };
    own + capacities.gravity_load_n.unwrap_or(0.0)
}

/// P/h \[N/m\]; 0 without a height, which [`check`] refuses if there is a weight.
pub(super) fn over(weight: f64, height: Option<f64>) -> f64 {
    height.map_or(0.0, |height| weight / height)
}

impl StoreyProperties {
    /// The columns with what gravity leaves of them.
    ///
    /// k − P/h before yielding and a k − P/h after it, from the same drift of yielding: a loop of the same kind.
    pub fn leaning_columns(&self) -> Columns {
        let (columns, lost) = (self.columns, self.gravity_n_per_m);
        if lost <= 0.0 {
            return columns;
        }
        let left = columns.stiffness_n_per_m - lost;
        let after = columns.hardening_ratio.unwrap_or(0.0) * columns.stiffness_n_per_m - lost;
        Columns {
            stiffness_n_per_m: left,
            yield_force_n: columns.yield_force_n.map(|force| force * left / columns.stiffness_n_per_m),
            hardening_ratio: columns.yield_force_n.map(|_| after / left),
            ..columns
        }
    }
}

/// Refuses a storey without height under a weight, and one that its weight would bring down at once.
pub(super) fn check(scene: &Scene) -> Result<(), Refused> {
    for (index, structure) in scene.structures.iter().enumerate() {
        match structure {
            Structure::Sdof(sdof) => {
                let own = weight(scene, sdof.mass_kg, &sdof.capacities);
                let place = format!("structures[{index}].sdof");
                check_storey(&place, own, sdof.height_m, &sdof.columns())?;
                if own > 0.0 {
                    check_start(scene, &place, sdof.initial_displacement_m, sdof.height_m)?;
                }
            }
            Structure::Building(building) => {
                let mut above = 0.0;
                for (storey, one) in building.storeys.iter().enumerate().rev() {
                    above += weight(scene, one.mass_kg, &one.capacities);
                    let place = format!("structures[{index}].building.storeys[{storey}]");
                    // Isolators without a height have what their own loop gives.
                    let leans = one.capacities.isolation_layer != Some(true) || one.height_m.is_some();
                    check_storey(&place, if leans { above } else { 0.0 }, one.height_m, &one.columns)?;
                    if above > 0.0 && one.capacities.isolation_layer != Some(true) {
                        let below = storey
                            .checked_sub(1)
                            .map_or(0.0, |below| building.storeys[below].initial_displacement_m);
                        check_start(scene, &place, one.initial_displacement_m - below, one.height_m)?;
                    }
                }
            }
            Structure::Wall => {}
        }
    }
    Ok(())
}

/// Refuses a storey that begins at a drift \[m\] at which it has collapsed.
fn check_start(scene: &Scene, place: &str, drift: f64, height: Option<f64>) -> Result<(), Refused> {
    let most = height.map_or(f64::INFINITY, |height| scene.collapse_drift() * height);
    if drift.abs() < most {
        return Ok(());
    }
    let found = Refused::at(format!("{place}.initial_displacement_m")).found(format!("a drift of {} m", digits(drift)));
    let found = found.allowed(format!(
        "less than {} m, at which the storey has collapsed under gravity",
        digits(most)
    ));
    Err(found.help("a smaller one, or a larger collapse_drift_ratio"))
}

fn check_storey(place: &str, weight: f64, height: Option<f64>, columns: &Columns) -> Result<(), Refused> {
    if weight <= 0.0 {
        return Ok(());
    }
    let Some(height) = height else {
        let found = Refused::at(format!("{place}.height_m")).found("none, under a weight that acts on the leaning storey");
        return Err(found
            .allowed_is("the height of the storey")
            .help("without it leave out p_delta and gravity_load_n"));
    };
    let theta = weight / (columns.stiffness_n_per_m * height);
    if theta < 1.0 {
        return Ok(());
    }
    let found = format!("P/(k h) = {} for a weight of {} kN", short(theta), short(1e-3 * weight));
    let found = Refused::at(place.to_owned())
        .found(found)
        .allowed("less than 1: the elastic building stands under its weight");
    Err(found.help("a stiffer storey, or a smaller gravity_load_n"))
}
