//! What the model leaves out and would matter for a scene: each entry with the scenes that it concerns.

use pounding_scene::{Excess, ExcessKind, Scene, Structure};

/// Title of the box.
pub(crate) const TITLE: &str = "Not modelled here, and important for this scene";

/// From so many structures on the row is long enough for a ground motion that travels.
const LONG: usize = 5;

/// A scene, and what its runs found.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Found<'a> {
    pub(crate) scene: &'a Scene,
    /// Responses beyond the model in any run.
    pub(crate) excesses: &'a [Excess],
    /// Whether something touches in any run.
    pub(crate) touch: bool,
}

/// An effect that the model leaves out: when it matters, and a sentence about it.
struct LeftOut {
    applies: fn(&Found<'_>) -> bool,
    says: &'static str,
}

const ALL: [LeftOut; 9] = [
    LeftOut {
        applies: |found| found.exceeds(&[ExcessKind::AtColumn, ExcessKind::BesideColumn, ExcessKind::LeftOut]),
        says: "Floors that hit columns of the neighbour, or levels that no contact watches: a slab against a column can bring a building down, \
               and no force and no damage of it is in these numbers.",
    },
    LeftOut {
        applies: |found| found.exceeds(&[ExcessKind::Stability]),
        says: "Gravity on leaning storeys (P-Δ): a stability coefficient is above 0.1, so that drifts are larger than they stand here.",
    },
    LeftOut {
        applies: |found| found.exceeds_columns(),
        says: "Loss of strength: columns carry their yield force at any drift, and drifts here are beyond those that columns survive.",
    },
    LeftOut {
        applies: |found| found.touch,
        says: "Eccentricity in plan: a blow beside the centre of mass turns the building, and moves corners farther than this plane row. It \
               meets a smaller mass, 1/m_eff = 1/m + y²/I: 0.4 of the mass for a square slab that is hit half a side off its centre.",
    },
    LeftOut {
        applies: |found| found.touch && found.is_compliant(),
        says: "Slabs as distributed masses: each is one rigid mass here. In a real one the blow runs through the slab as a wave and back, \
               2L/c or some 10 ms for 20 m, and its edge is crushed; both change force and acceleration.",
    },
    LeftOut {
        applies: |found| found.is_isolated(),
        says: "Isolators that tear, stiffen at the end of their displacement or lift off. A moat as wide as their displacement is no proof that \
               they bear it (displacement_capacity_m).",
    },
    LeftOut {
        applies: |found| found.touch && found.has_wall(),
        says: "Soil behind a wall: the wall is rigid and moves with the ground. Backfill yields, so that its force has a limit and the gap \
               grows with every push.",
    },
    LeftOut {
        applies: |found| found.scene.structures.len() >= LONG && found.scene.arrivals_s.is_none(),
        says: "A ground motion that travels: all bases of this long row move alike, while waves reach one after the other.",
    },
    LeftOut {
        applies: |found| found.touch && found.is_impulsive(),
        says: "The force of impacts: the impulsive law gives impulses and no force, and accelerations leave them out.",
    },
];

impl Found<'_> {
    fn exceeds(&self, kinds: &[ExcessKind]) -> bool {
        self.excesses.iter().any(|one| kinds.contains(&one.kind))
    }

    /// Whether columns drift too far; isolators have a capacity of displacement.
    fn exceeds_columns(&self) -> bool {
        let of_columns = |one: &Excess| one.kind != ExcessKind::Displacement || one.capacity.is_none();
        let kinds = [ExcessKind::Ductility, ExcessKind::Drift, ExcessKind::Displacement];
        let mut all = self.excesses.iter();
        all.any(|one| kinds.contains(&one.kind) && of_columns(one))
    }

    fn is_isolated(&self) -> bool {
        let mut buildings = self.scene.structures.iter().filter_map(|one| match one {
            Structure::Building(building) => building.storeys.first(),
            Structure::Sdof(_) | Structure::Wall => None,
        });
        buildings.any(|lowest| lowest.capacities.isolation_layer == Some(true))
    }

    fn has_wall(&self) -> bool {
        self.scene.structures.iter().any(|one| matches!(one, Structure::Wall))
    }

    fn is_compliant(&self) -> bool {
        self.scene.contacts.iter().flatten().any(|one| one.law.is_compliant())
    }

    fn is_impulsive(&self) -> bool {
        self.scene.contacts.iter().flatten().any(|one| !one.law.is_compliant())
    }

    /// The sentences that concern the scene; links between buildings and the soil below them are in no scene.
    pub(crate) fn not_modelled(&self) -> Vec<String> {
        let concern = ALL.iter().filter(|one| (one.applies)(self));
        concern.map(|one| one.says.to_owned()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(contact: &str, others: &str) -> Scene {
        let text = format!(
            r#"{{"name": "x", "record": {{"file": "a.csv"}},
                "structures": [{{"sdof": {{"name": "a", "mass_kg": 1e5, "period_s": 1.0, "damping": {{"ratio": 0.05}}}}}}, {others}],
                "contacts": [{contact}]}}"#
        );
        serde_json::from_str(&text).expect("a scene")
    }

    fn said(scene: &Scene, kinds: &[ExcessKind], touch: bool) -> Vec<String> {
        let excess = |kind: &ExcessKind| Excess {
            kind: *kind,
            floor: 0,
            name: "a".into(),
            found: 1.0,
            capacity: None,
            often: None,
        };
        let excesses: Vec<Excess> = kinds.iter().map(excess).collect();
        let found = Found {
            scene,
            excesses: &excesses,
            touch,
        };
        let first = |text: String| text.split([':', ',']).next().unwrap_or_default().to_owned();
        found.not_modelled().into_iter().map(first).collect()
    }

    /// A report listed no limit of the model, or all of them whatever the scene.
    #[test]
    fn issue_only_what_matters_for_a_scene_is_said() {
        let spring = r#"{"gap_m": 0.01, "law": {"linear_spring": {"impact_stiffness_n_per_m": 9.35e7}}}"#;
        let wall = scene(spring, r#"{"wall": {}}"#);
        assert_eq!(said(&wall, &[], false), Vec::<String>::new());
        assert_eq!(
            said(&wall, &[], true),
            ["Eccentricity in plan", "Slabs as distributed masses", "Soil behind a wall"]
        );
        let impact = r#"{"gap_m": 0.01, "law": {"stereomechanical": {"restitution": 0.5}}}"#;
        let other = r#"{"sdof": {"name": "b", "mass_kg": 1e5, "period_s": 0.5, "damping": {"ratio": 0.05}}}"#;
        let impulsive = scene(impact, other);
        assert_eq!(said(&impulsive, &[], true), ["Eccentricity in plan", "The force of impacts"]);
        assert_eq!(
            said(&impulsive, &[ExcessKind::Stability, ExcessKind::Ductility], false),
            ["Gravity on leaning storeys (P-Δ)", "Loss of strength"]
        );
    }
}
