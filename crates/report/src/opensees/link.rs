//! Links between floors as elements of OpenSees.

use pounding_solver::{Link, LinkLaw, Point};

/// A link: the places of its ends, and its materials side by side.
pub(super) struct ScriptLink {
    /// The floor of the left and of the right end, and whether the end is on the ground below it.
    pub(super) ends: [(usize, bool); 2],
    pub(super) materials: Vec<LinkMaterial>,
}

/// A uniaxial material, as Python writes it: its name, and its parameters after the tag.
///
/// Its strain is the displacement of the right end less that of the left one: an elongation.
pub(super) struct LinkMaterial {
    pub(super) name: &'static str,
    pub(super) parameters: Vec<String>,
}

/// Elongation at which a restrainer that never yields would yield \[m\].
const FAR: f64 = 1e6;

impl ScriptLink {
    pub(super) fn of(link: &Link) -> Self {
        let ends = link
            .relation
            .points()
            .map(|point| (point.floor(), matches!(point, Point::Ground(_))));
        let material = |name, parameters: &[f64]| LinkMaterial {
            name,
            parameters: parameters.iter().map(|one| format!("{one:?}")).collect(),
        };
        let materials = match link.law {
            LinkLaw::Spring(spring) if spring.yield_force.is_infinite() => vec![material("Elastic", &[spring.stiffness, spring.damping])],
            LinkLaw::Spring(spring) => {
                let yields = match spring.hardening {
                    0.0 => material("ElasticPP", &[spring.stiffness, spring.yield_force / spring.stiffness]),
                    hardening => material("Steel01", &[spring.yield_force, spring.stiffness, hardening]),
                };
                let dashpot = (spring.damping > 0.0).then(|| material("Elastic", &[0.0, spring.damping]));
                [yields].into_iter().chain(dashpot).collect()
            }
            LinkLaw::Restrainer(cable) => {
                let yields = if cable.yield_force.is_finite() {
                    cable.yield_force
                } else {
                    cable.stiffness * FAR
                };
                let mut gap = material("ElasticPPGap", &[cable.stiffness, yields, cable.slack, 0.0]);
                // Plastic elongation adds to the slack.
                gap.parameters.push("\"damage\"".into());
                vec![gap]
            }
            LinkLaw::Braced(damper) => {
                let exponent = 1.0 / f64::from(damper.inverse_exponent);
                vec![material("ViscousDamper", &[damper.stiffness, damper.coefficient, exponent])]
            }
            // No script has it as long as the exact run beside it refuses it.
            LinkLaw::Viscous(damper) => vec![material("Viscous", &[damper.coefficient, damper.exponent])],
        };
        Self { ends, materials }
    }

    /// The link as Python writes it.
    pub(super) fn written(&self) -> String {
        let end = |(floor, on_ground): (usize, bool)| format!("({floor}, {})", if on_ground { "True" } else { "False" });
        let material = |one: &LinkMaterial| format!("(\"{}\", {})", one.name, one.parameters.join(", "));
        let materials: Vec<String> = self.materials.iter().map(material).collect();
        let [left, right] = self.ends.map(end);
        format!("{{\"ends\": ({left}, {right}), \"materials\": [{}]}}", materials.join(", "))
    }
}
