//! Changes of the paper's scenes besides the ground motion.

use std::fmt;

use pounding_motion::Record;
use serde::{Deserialize, Serialize};

use pounding_scene::{Building, Capacities, Columns, Damping, FloorHeights, Scene, Sdof, Storey, Structure};

/// A change under which the paper's claims are tested again.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// Replaces the structures by buildings with this number of storeys, 2 to 20.
    Storeys(usize),
    /// Multiplies every motion by this factor \[–\], between 0 and 1. Gaps, yield forces and contact laws stay.
    Weaker(f64),
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Storeys(count) => write!(f, "buildings of {count} storeys"),
            Self::Weaker(part) => write!(f, "motions multiplied by {part}"),
        }
    }
}

/// Largest number of storeys: more would take long and say nothing about the paper's structures.
const MOST_STOREYS: usize = 20;

impl Change {
    /// Name of the change's folder, and end of its column names. A list has at most one change of a kind.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Storeys(_) => "storeys",
            Self::Weaker(_) => "weaker",
        }
    }

    /// Whether the change takes too long for `reproduce`. `cargo xtask beyond` then runs it, and hashes identify its results.
    pub(crate) fn is_long(self) -> bool {
        matches!(self, Self::Storeys(_))
    }

    /// The value found and the values allowed; `None` if the change is allowed.
    pub(crate) fn fault(self) -> Option<(String, &'static str)> {
        match self {
            Self::Storeys(count) if !(2..=MOST_STOREYS).contains(&count) => Some((format!("storeys: {count}"), "2 to 20")),
            Self::Weaker(part) if !(part > 0.0 && part < 1.0) => Some((format!("weaker: {part}"), "a number between 0 and 1")),
            Self::Storeys(_) | Self::Weaker(_) => None,
        }
    }

    /// The changed scene. Its name stays, because the claims find scenes by name.
    pub(crate) fn of_scene(self, mut scene: Scene) -> Scene {
        if let Self::Storeys(count) = self {
            scene.floors = Some(FloorHeights::Level);
            for structure in &mut scene.structures {
                if let Structure::Sdof(sdof) = structure {
                    *structure = Structure::Building(building(sdof, count));
                }
            }
        }
        scene
    }

    /// The changed ground motion.
    pub(crate) fn of_record(self, record: Record) -> Record {
        match self {
            Self::Storeys(_) => record,
            Self::Weaker(part) => record.scaled(part).expect("less than a record of finite numbers is finite"),
        }
    }
}

/// A building of several storeys in place of a structure: its twin.
///
/// A twin has the structure's total mass M, natural period, damping ratio and yield force. The yield force is that of its first storey, so
/// the twin yields at the same base shear. All floors are equal. Stiffness and yield force of the storeys follow the shear of forces that
/// grow with height, as in design codes: Vᵢ = i + … + n. The first mode is then a straight line, and all storeys yield at one drift: no
/// storey is soft or weak by chance. With floors of M/n and the structure's stiffness K, kᵢ = (K/n) Vᵢ gives exactly its period.
///
/// Damping is Rayleigh's with the structure's ratio in the first two modes. Gaps and contact laws stay, and hold between all floors of one
/// level. Two numbers differ from the structure's. In the first mode the roof moves 3n/(2n + 1) times as far as the structure (three
/// storeys: 9/7). This mode carries 3(n + 1)/(2(2n + 1)) of the mass (6/7).
fn building(sdof: &Sdof, count: usize) -> Building {
    // The sums are whole numbers below 1000, hence exact.
    let shear = |storey: usize| (storey..=count).sum::<usize>() as f64;
    let columns = |storey: usize| Columns {
        stiffness_n_per_m: sdof.stiffness_n_per_m * shear(storey) / count as f64,
        yield_force_n: sdof.yield_force_n.map(|force| force * shear(storey) / shear(1)),
        ..sdof.columns()
    };
    let storey = |storey: usize| {
        let height = storey as f64 / count as f64;
        Storey {
            mass_kg: sdof.mass_kg / count as f64,
            height_m: sdof.height_m.map(|height| height / count as f64),
            capacities: Capacities::default(),
            columns: columns(storey),
            initial_displacement_m: height * sdof.initial_displacement_m,
            initial_velocity_m_per_s: height * sdof.initial_velocity_m_per_s,
        }
    };
    Building {
        name: sdof.name.clone(),
        damping: Damping::Ratio(sdof.damping_ratio()),
        storeys: (1..=count).map(storey).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn structure() -> Sdof {
        Sdof {
            name: "weak".into(),
            mass_kg: 3e5,
            stiffness_n_per_m: 8.2e6,
            damping: Damping::Ratio(0.05),
            yield_force_n: Some(9e5),
            hardening_ratio: None,
            bouc_wen: None,
            height_m: None,
            capacities: Capacities::default(),
            initial_displacement_m: 0.0,
            initial_velocity_m_per_s: 0.0,
        }
    }

    #[test]
    fn limit_a_twin_of_one_storey_is_the_structure() {
        let sdof = structure();
        let twin = building(&sdof, 1);
        assert_eq!(twin.storeys.len(), 1);
        assert_eq!(twin.storeys[0].columns, sdof.columns());
        assert_eq!(twin.dampings(), [(sdof.damping_coefficient(), 0.0)]);
    }

    #[test]
    fn reference_a_twin_has_mass_period_damping_and_base_yield_force() {
        let sdof = structure();
        for count in [2, 3, 7, 20] {
            let twin = building(&sdof, count);
            let same = |one: f64, other: f64| assert!((one / other - 1.0).abs() < 1e-12);
            let modes = twin.modes();
            same(modes[0].period(), sdof.period());
            same(modes[0].damping_ratio, 0.05);
            same(modes[1].damping_ratio, 0.05);
            let masses = twin.storeys.iter().map(|storey| storey.mass_kg);
            same(masses.sum(), sdof.mass_kg);
            let first = &twin.storeys[0].columns;
            assert_eq!(first.yield_force_n, sdof.yield_force_n);
            let drift = |columns: &Columns| columns.yield_force_n.expect("they yield") / columns.stiffness_n_per_m;
            for storey in &twin.storeys {
                same(drift(&storey.columns), drift(first));
            }
            // The two numbers in the description of a twin.
            let n = count as f64;
            let share = modes[0].effective_mass() / sdof.mass_kg;
            same(share, 3.0 * (n + 1.0) / (2.0 * (2.0 * n + 1.0)));
        }
    }
}
