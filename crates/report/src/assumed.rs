//! What a run or an assessment assumes, in a table: a checking engineer asks for it before the numbers.

use pounding_scene::{Contact, DampedStiffness, Damping, Floors, Link, Scene, Simulation, Structure};
use pounding_text::{Grid, Shown, Table, digits, short, two_digits};

/// An assumption.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Assumed {
    what: &'static str,
    /// The buildings or gaps that it concerns; empty if all.
    of: String,
    value: String,
    /// Where the value comes from.
    source: &'static str,
}

/// The scene says it.
pub(crate) const SCENE: &str = "scene";
/// Nobody said it.
pub(crate) const DEFAULT: &str = "default";

/// Impact stiffnesses of the literature, which `init` writes into a scene \[N/m\], \[N/m^1.5\]. They were published for one pair of
/// buildings.
const OF_LITERATURE: [f64; 2] = [9.35e7, 2.75e9];

impl Assumed {
    pub(crate) fn new(what: &'static str, value: impl Into<String>, source: &'static str) -> Self {
        Self {
            what,
            of: String::new(),
            value: value.into(),
            source,
        }
    }

    fn of(self, name: &str) -> Self {
        Self { of: name.into(), ..self }
    }

    /// The scene says it, or it is the default.
    pub(crate) fn unless_default(what: &'static str, value: impl Into<String>, is_default: bool) -> Self {
        Self::new(what, value, if is_default { DEFAULT } else { SCENE })
    }

    /// Gathers equal assumptions about several buildings or gaps, in the order of their first.
    fn gathered(all: impl Iterator<Item = Self>) -> Vec<Self> {
        let mut gathered: Vec<Self> = Vec::new();
        for one in all {
            let equal = |known: &&mut Self| (known.what, &known.value, known.source) == (one.what, &one.value, one.source);
            match gathered.iter_mut().find(equal) {
                Some(known) => known.of = format!("{}, {}", known.of, one.of),
                None => gathered.push(one),
            }
        }
        gathered
    }

    /// A table of assumptions: these, then those of the row.
    pub(crate) fn table(first: Vec<Self>, scene: &Scene, floors: &Floors) -> Grid {
        let buildings = scene.structures.iter().flat_map(of_structure);
        let contacts = scene.contacts.iter().flatten().enumerate();
        let contacts = contacts.flat_map(|(gap, contact)| of_contact(scene, floors, gap, contact));
        let ground = match scene.arrivals_s {
            Some(_) => "firm under all bases; the motion travels along the row",
            None => "firm under all bases, which move alike",
        };
        let ground = Self::unless_default("Ground", ground, scene.arrivals_s.is_none());
        let gravity = floors.says_gravity().map(|gravity| Self::new("Gravity", gravity, SCENE));
        let all = first.into_iter().chain([ground]).chain(gravity).chain(buildings).chain(contacts);
        Table::of(Self::gathered(all))
            .shown("Assumed", |one: &Self| {
                let of = (!one.of.is_empty()).then(|| one.of.clone());
                Shown::from(one.what).over(of)
            })
            .shown("Value", |one| Shown::from(one.value.as_str()).long())
            .shown("Source", |one| Shown::from(one.source).long())
            .grid()
    }
}

/// Damping and columns of a structure; none of a wall.
fn of_structure(structure: &Structure) -> Vec<Assumed> {
    let name = structure.name();
    let Some(damping) = structure.damping_ratio() else {
        return Vec::new();
    };
    let ratio = format!("{} % of critical", two_digits(100.0 * damping));
    let damping = match damping_given(structure) {
        Some(modes) if modes.starts_with("in modes") => format!("{ratio} {modes}"),
        Some(above) if above.ends_with(ABOVE) => above,
        Some(given) => format!("{ratio} in the first mode: {given}"),
        None => ratio,
    };
    let (columns, source) = match yields(structure) {
        [0, _] => ("elastic, whatever the drift", DEFAULT),
        [some, all] if some < all => ("some yield, the others are elastic; none loses strength", SCENE),
        _ => ("yield without loss of strength", SCENE),
    };
    vec![
        Assumed::new("Damping", damping, SCENE).of(name),
        Assumed::new("Columns", columns, source).of(name),
    ]
}

/// Number of storeys that yield, and of all.
fn yields(structure: &Structure) -> [usize; 2] {
    let yields: Vec<bool> = match structure {
        Structure::Sdof(one) => vec![one.columns().yield_force_n.is_some()],
        Structure::Building(one) => one.storeys.iter().map(|storey| storey.columns.yield_force_n.is_some()).collect(),
        Structure::Wall => Vec::new(),
    };
    [yields.iter().filter(|one| **one).count(), yields.len()]
}

/// Law, stiffness and levels of a contact.
fn of_contact(scene: &Scene, floors: &Floors, gap: usize, contact: &Contact) -> Vec<Assumed> {
    let between = [gap, gap + 1].map(|index| scene.structures[index].name()).join(" – ");
    let law = Assumed::new(
        "Contact",
        format!("{}, {}", contact.law.name().replace('_', " "), parameters(contact)),
        stiffness_source(contact),
    );
    let (level, source) = if contact.levels.is_some() {
        ("only the levels that the scene names can touch".to_owned(), SCENE)
    } else if floors.of_structure(gap).len() == 1 && floors.of_structure(gap + 1).len() == 1 {
        ("one floor each, taken as level".into(), DEFAULT)
    } else if let Some(columns) = floors.says_columns(gap) {
        (columns.split(':').next().unwrap_or_default().to_owned(), SCENE)
    } else if floors.are_level(gap) {
        ("level, by the heights of the storeys".into(), SCENE)
    } else {
        ("level, as the scene says".into(), SCENE)
    };
    vec![law.of(&between), Assumed::new("Floors", level, source).of(&between)]
}

/// Where the stiffness of a contact comes from; of impacts without a stiffness, the scene.
fn stiffness_source(contact: &Contact) -> &'static str {
    let law = serde_json::to_value(contact.law).unwrap_or_default();
    let parameters = law[contact.law.name()].as_object().into_iter().flatten();
    let mut stiffness = parameters.filter(|(name, _)| name.starts_with("impact_stiffness"));
    let of_literature = stiffness.any(|(_, value)| {
        let value = value.as_f64().unwrap_or(0.0);
        OF_LITERATURE.iter().any(|usual| (value / usual - 1.0).abs() < 1e-6)
    });
    if of_literature {
        "scene: a stiffness of the literature, not of these slabs"
    } else {
        SCENE
    }
}

/// A duration and what it follows from.
pub(crate) fn duration(prepared: &Simulation) -> Assumed {
    let duration = prepared.duration();
    let by_default = Scene {
        duration_s: None,
        ..prepared.scene().clone()
    };
    let by_default = by_default.duration_under(prepared.record().duration());
    let source = if (duration - by_default).abs() > 1e-9 * duration {
        SCENE
    } else {
        "default: the record and two of the longest periods"
    };
    Assumed::new("Duration", format!("{} s", digits(duration)), source)
}

/// Where the ratio of an isolated building holds.
const ABOVE: &str = "in the first mode of the building above its isolators";

/// How the damping was given, if not as a ratio of one mode.
pub(crate) fn damping_given(structure: &Structure) -> Option<String> {
    let (damping, storeys, isolators) = match structure {
        Structure::Sdof(sdof) => (sdof.damping, 1, false),
        Structure::Building(building) => (building.damping, building.storeys.len(), building.isolator_damping().is_some()),
        Structure::Wall => return None,
    };
    let two = |[one, other]: [f64; 2]| format!("{} and {}", digits(one), digits(other));
    let given = match damping {
        Damping::Ratio(ratio) if isolators => Some(format!("{} % of critical {ABOVE}", two_digits(100.0 * ratio))),
        Damping::Ratio(_) => (storeys > 1).then(|| "in modes 1 and 2".into()),
        Damping::Rayleigh { alpha_per_s, beta_s, .. } => Some(format!("α = {} /s, β = {} s", digits(alpha_per_s), digits(beta_s))),
        Damping::TwoFrequencies {
            frequencies_hz, ratios, ..
        } => Some(format!("{} at {} Hz", two(ratios), two(frequencies_hz))),
        Damping::Modes { modes, ratios, .. } => Some(format!("{} in modes {} and {}", two(ratios), modes[0], modes[1])),
    };
    match damping.stiffness() {
        DampedStiffness::Initial => given,
        DampedStiffness::Tangent => given.map(|given| format!("{given}, on the tangent stiffness")),
    }
}

/// The parameters of the law of a contact, in the words of a scene.
pub(crate) fn parameters(contact: &Contact) -> String {
    in_words(&serde_json::to_value(contact.law).unwrap_or_default(), contact.law.name())
}

/// The parameters of the law of a link, in the words of a scene.
pub fn link_parameters(link: &Link) -> String {
    in_words(&serde_json::to_value(link.law).unwrap_or_default(), link.law.name())
}

fn in_words(law: &serde_json::Value, name: &str) -> String {
    let parameter = |(name, value): (&String, &serde_json::Value)| {
        let value = value.as_f64().map_or_else(|| value.to_string(), short);
        format!("{name} = {value}")
    };
    let parameters = law[name].as_object().into_iter().flatten();
    parameters.map(parameter).collect::<Vec<_>>().join(", ")
}
