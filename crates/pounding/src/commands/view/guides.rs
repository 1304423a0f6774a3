//! The guided pages: each shows one mechanism, with a scene whose numbers can be turned.

use pounding::report::Summary;
use pounding::scene::{FloorQuantity, PairQuantity};
use pounding::text::{Unit, digits, short};
use serde_json::{Value, json};

/// A guided page.
#[derive(Debug)]
pub(super) struct Guide {
    /// Its word in the address.
    pub(super) key: &'static str,
    title: &'static str,
    /// Sentences: a knob to turn, and its effect.
    text: &'static [&'static str],
    /// The scene, under the record of `demo`.
    pub(super) scene: &'static str,
    /// The knobs to turn, which come first.
    knobs: &'static [&'static str],
    /// A sentence with numbers of the run.
    pub(super) fact: Option<fn(&Summary) -> Option<String>>,
}

impl Guide {
    /// The page, for the browser.
    pub(super) fn json(&self) -> Value {
        json!({"key": self.key, "title": self.title, "text": self.text, "knobs": self.knobs})
    }
}

/// Every guide, in the order of the page.
pub(super) const ALL: [Guide; 8] = [
    Guide {
        key: "wider",
        title: "A wider gap can be worse",
        text: &[
            "Drag the gap from 40 to 60 mm. The record is reversed here: the blow becomes a third harder, and the new building drifts a fifth \
             further, since both pick up more speed before they meet. As given, the wider gap is better.",
            "Above the required width nothing touches. Until then wider is not always safer.",
        ],
        scene: include_str!("../../../assets/view/wider.toml"),
        knobs: &["gap.0"],
        fact: None,
    },
    Guide {
        key: "step",
        title: "Halve Δt, and the paper’s force doubles",
        text: &[
            "This contact is an impulse: the velocities jump at once. The paper divides the impulse by the time step and calls the \
             quotient the pounding force.",
            "Choose half the time step. The impulse stays, the quotient doubles: it measures the step and no force. Choose a law with a \
             stiffness to get a force.",
        ],
        scene: include_str!("../../../assets/view/impulse.toml"),
        knobs: &["step", "method", "law.0"],
        fact: Some(over_the_step),
    },
    Guide {
        key: "mirrored",
        title: "Mirrored shaking",
        text: &[
            "Nobody knows from which side an earthquake comes. Turn the direction: the same record mirrored is another earthquake for a row \
             that is not symmetric.",
            "The answer has a sentence for each direction. The worse one for the buildings comes first: here it has the softer blow, and the old \
             building drifts further and keeps more of it.",
        ],
        scene: include_str!("../../../assets/view/pair.toml"),
        knobs: &["direction", "gap.0"],
        fact: None,
    },
    Guide {
        key: "law",
        title: "Which law, which stiffness",
        text: &[
            "Choose other laws. The first touch stays at its instant. Among laws of the same restitution the first impulse goes from 200 to \
             400 kN·s, and the largest force from 2700 to 8000 kN.",
            "Then drag the stiffness. Ten times the stiffness gives about three times the force here. Nobody knows this stiffness, so \
             the force is no design force.",
        ],
        scene: include_str!("../../../assets/view/pair.toml"),
        knobs: &["law.0", "stiffness.0", "restitution.0"],
        fact: None,
    },
    Guide {
        key: "middle",
        title: "The middle building of layout C",
        text: &[
            "A weak building stands between two stiff ones, as in layout C of the paper. Both neighbours stop it: it is hit often, and \
             still moves less than alone.",
            "Widen both gaps, and the building in the middle yields more. Its neighbours hardly move differently: they are 40 times as heavy.",
        ],
        scene: include_str!("../../../assets/view/layout-c.toml"),
        knobs: &["gap.0", "gap.1", "yield.1"],
        fact: None,
    },
    Guide {
        key: "slip",
        title: "The paper’s slip",
        text: &[
            "The paper says: half the time step does not change the momenta that pass between the buildings of layout C. Its numbers say so, \
             because its program made a slip: it lets a pair collide that already parts. At 5 ms that adds a fifth.",
            "Here the method has no slip. Choose half the step, and the momenta grow by an eighth to a fifth. Choose the exact method, and they are \
             half as large again as at 5 ms. So the step matters.",
        ],
        scene: include_str!("../../../assets/view/slip.toml"),
        knobs: &["step", "method"],
        fact: Some(momenta),
    },
    Guide {
        key: "dampers",
        title: "A damper between two towers",
        text: &[
            "A viscous damper joins each of the four lower floors of two towers. At 0.1 MN·s/m the roof of the quick one gets as hard a blow as \
             without dampers.",
            "Drag the damping coefficient. Which one halves the hardest blow? Which one keeps the towers apart? More is not better: at \
             20 MN·s/m the dampers tie the lower floors together, and the storey above them drifts nearly as far as any did without dampers.",
        ],
        scene: include_str!("../../../assets/view/dampers.toml"),
        knobs: &["link.0", "gap.0"],
        fact: Some(hardest),
    },
    Guide {
        key: "slab",
        title: "A slab against a column",
        text: &[
            "The slabs of one building stand between the floors of the other. They hit columns, which push the floors above and below, and \
             which have to carry the blow in bending and shear.",
            "Drag the gap. The warnings compare the shear force of the column that is hit with what one column bears.",
        ],
        scene: include_str!("../../../assets/view/slab.toml"),
        knobs: &["gap.0", "stiffness.0", "scale"],
        fact: None,
    },
];

/// The transferred momenta.
fn momenta(summary: &Summary) -> Option<String> {
    let momenta = summary.structures.iter();
    let momenta: Option<Vec<_>> = momenta.map(|one| one.numbers.get(FloorQuantity::TransferredMomentumNS)).collect();
    let momenta = momenta?.into_iter().map(|momentum| short(1e-3 * momentum)).collect::<Vec<_>>();
    Some(format!("Transferred momenta from left to right: {} kN·s.", momenta.join(", ")))
}

/// The largest impulse of the row.
fn hardest(summary: &Summary) -> Option<String> {
    let impulses = summary.pairs.iter().filter_map(|pair| Some(pair.largest?.impulse_n_s));
    Some(format!("Hardest blow: {} kN·s.", short(1e-3 * impulses.reduce(f64::max)?)))
}

/// The largest impulse over the time step, which the paper calls a force.
fn over_the_step(summary: &Summary) -> Option<String> {
    let pair = summary.pairs.first()?;
    let impulse = pair.largest?.impulse_n_s;
    let Some(step) = summary.method.time_step_s else {
        return Some("The exact method has no time step, so nothing to divide by. Choose another method.".into());
    };
    let force = Unit::POUNDING_FORCE.text_of(impulse / step, 1.0);
    let own = pair.number(PairQuantity::PeakForceN);
    let own = own.map_or_else(String::new, |own| {
        format!(" The force of the law is {} kN.", Unit::POUNDING_FORCE.text_of(own, 1.0))
    });
    Some(format!(
        "Largest impulse {} kN·s; over the time step of {} ms this is {force} kN.{own}",
        short(1e-3 * impulse),
        digits(1e3 * step),
    ))
}
