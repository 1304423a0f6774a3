//! The knobs of the page: which numbers of a scene can be turned, how far, and what turning does. A new knob is a variant of [`Knob`].

use std::collections::BTreeMap;

use pounding::contact::{Calibration, ContactLaw, Exact, FreePair, LawName};
use pounding::scene::file::Law;
use pounding::scene::{Contact, Damping, Method, RecordUse, STANDARD_GRAVITY, Scene, StepMethod, Structure};
use pounding::text::{Refused, digits};
use serde::Serialize;
use serde_json::Value;

/// Time steps to choose from \[s\]: each is half of the one before, so that a duration in whole hundredths of a second has whole steps.
const STEPS: [f64; 7] = [0.02, 0.01, 0.005, 0.0025, 0.001_25, 0.000_625, 0.000_312_5];
/// The step of a method that is chosen beside the exact one.
const FIRST_STEP: f64 = 0.005;
/// The restitution of a law that is chosen in place of one without.
const USUAL_RESTITUTION: f64 = 0.65;
/// The choice of the exact method, and that of a method which the list of methods does not have.
const EXACT: &str = "exact";
const OWN: &str = "own";

/// Numbers and choices that were turned, by the names of their knobs.
pub(super) type Turned = BTreeMap<String, Value>;

/// A knob; the number is the index of a structure, a contact, or the first of links with the same law.
#[derive(Debug, Clone, Copy)]
enum Knob {
    Gap(usize),
    Law(usize),
    Stiffness(usize),
    Restitution(usize),
    Mass(usize),
    Period(usize),
    Damping(usize),
    Yield(usize),
    Link(usize),
    Scale,
    Direction,
    Method,
    Step,
}

/// A knob as the page draws it.
#[derive(Debug, Serialize)]
pub(super) struct Drawn {
    id: String,
    /// The structure, the contact or the matter that it belongs to.
    group: String,
    label: &'static str,
    #[serde(flatten)]
    kind: Kind,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case", tag = "kind")]
enum Kind {
    /// A number in SI units; the page shows it times `factor` in `unit`.
    Number {
        /// Absent beyond the last value: columns that never yield.
        value: Option<f64>,
        least: f64,
        most: f64,
        factor: f64,
        unit: &'static str,
        logarithmic: bool,
        /// The word for no value.
        #[serde(skip_serializing_if = "Option::is_none")]
        beyond: Option<&'static str>,
    },
    /// One of several words, each with its text.
    Choice { value: String, options: Vec<(String, String)> },
}

/// Returns the knobs of a scene: ranges are those of `base`, values those of `now`.
pub(super) fn drawn(base: &Scene, now: &Scene) -> Vec<Drawn> {
    let all = Knob::all(base).into_iter();
    let drawn = all.filter_map(|knob| {
        let kind = knob.kind(base, now)?;
        let (id, group, label) = knob.about(base);
        Some(Drawn { id, group, label, kind })
    });
    drawn.collect()
}

/// Returns the scene with knobs turned, in the order of the list.
///
/// # Errors
/// Refuses a knob that the scene does not have, and a value outside of its range.
pub(super) fn turned(base: &Scene, turned: &Turned) -> Result<Scene, Refused> {
    let (mut scene, all) = (base.clone(), Knob::all(base));
    let mut unknown = turned.clone();
    for knob in all {
        let (id, ..) = knob.about(base);
        if let (Some(value), Some(kind)) = (unknown.remove(&id), knob.kind(base, &scene)) {
            let done = kind.allows(&value).then(|| knob.turn(base, &mut scene, &value)).flatten();
            done.ok_or_else(|| Refused::at(id).found(value.to_string()).allowed_is("a value of this knob"))?;
        }
    }
    match unknown.into_keys().next() {
        Some(unknown) => Err(Refused::at(unknown).is("no knob of this scene")),
        None => Ok(scene),
    }
}

impl Kind {
    /// A number between bounds that its own value widens.
    fn number(value: f64, [least, most]: [f64; 2], (factor, unit): (f64, &'static str)) -> Self {
        Self::Number {
            value: Some(value),
            least: least.min(value),
            most: most.max(value),
            factor,
            unit,
            logarithmic: false,
            beyond: None,
        }
    }

    /// The same on a logarithmic scale.
    fn factor(value: f64, bounds: [f64; 2], unit: (f64, &'static str)) -> Self {
        let mut kind = Self::number(value, bounds, unit);
        if let Self::Number { logarithmic, .. } = &mut kind {
            *logarithmic = true;
        }
        kind
    }

    fn choice(value: impl Into<String>, options: impl IntoIterator<Item = (String, String)>) -> Self {
        let options = options.into_iter().collect();
        Self::Choice {
            value: value.into(),
            options,
        }
    }

    /// Whether the knob can be turned to a value.
    fn allows(&self, value: &Value) -> bool {
        match self {
            Self::Number { least, most, beyond, .. } => match value.as_f64() {
                Some(number) => (*least..=*most).contains(&number),
                None => value.is_null() && beyond.is_some(),
            },
            Self::Choice { options, .. } => value.as_str().is_some_and(|word| options.iter().any(|(known, _)| known == word)),
        }
    }
}

impl Knob {
    fn all(scene: &Scene) -> Vec<Self> {
        let contacts = 0..scene.contacts.as_ref().map_or(0, Vec::len);
        let contacts = contacts.flat_map(|one| [Self::Gap(one), Self::Law(one), Self::Stiffness(one), Self::Restitution(one)]);
        let structures = (0..scene.structures.len()).flat_map(|one| {
            // The mass comes first: turning it keeps the period.
            [Self::Mass(one), Self::Period(one), Self::Damping(one), Self::Yield(one)]
        });
        let rest = [Self::Scale, Self::Direction, Self::Method, Self::Step];
        let links = (0..scene.links.len()).filter(|one| linked(scene, *one)[0] == *one).map(Self::Link);
        contacts.chain(links).chain(structures).chain(rest).collect()
    }

    /// Its name, group and label.
    fn about(self, scene: &Scene) -> (String, String, &'static str) {
        let name = |one: usize| scene.structures[one].name().to_owned();
        let between = |key, one, label| {
            (
                format!("{key}.{one}"),
                format!("Between {} and {}", name(one), name(one + 1)),
                label,
            )
        };
        let of = |key, one, label| (format!("{key}.{one}"), name(one), label);
        let other = |key: &str, group: &str, label| (key.to_owned(), group.to_owned(), label);
        match self {
            Self::Gap(one) => between("gap", one, "Gap"),
            Self::Law(one) => between("law", one, "Contact law"),
            Self::Stiffness(one) => between("stiffness", one, "Contact stiffness"),
            Self::Restitution(one) => between("restitution", one, "Restitution"),
            Self::Mass(one) => of("mass", one, "Mass"),
            Self::Period(one) => of("period", one, "Period"),
            Self::Damping(one) => of("damping", one, "Damping ratio"),
            Self::Yield(one) => of("yield", one, "Yield force"),
            Self::Link(one) => {
                let group = match linked(scene, one).len() {
                    1 => format!("Link between {}", scene.links[one].names(scene).join(" and ")),
                    several => format!("{several} links of the same law"),
                };
                (format!("link.{one}"), group, link_number(&mut scene.links[one].law.clone()).0)
            }
            Self::Scale => other("scale", "Shaking", "Scale of the record"),
            Self::Direction => other("direction", "Shaking", "Direction"),
            Self::Method => other("method", "Method", "Method"),
            Self::Step => other("step", "Method", "Time step"),
        }
    }

    /// How the knob is drawn; `None` if the scene does not have it.
    fn kind(self, base: &Scene, now: &Scene) -> Option<Kind> {
        let contact = |scene: &Scene, one: usize| scene.contacts.as_ref()?.get(one).cloned();
        Some(match self {
            Self::Gap(one) => {
                let [before, gap] = [base, now].map(|scene| contact(scene, one).map_or(0.0, |one| one.gap_m));
                Kind::number(gap, [0.0, (3.0 * before).max(0.2)], (1e3, "mm"))
            }
            Self::Law(one) => law_choice(&contact(now, one)?),
            Self::Stiffness(one) => {
                let usual = contact(now, one)?.law.stiffness_over_usual()?;
                Kind::factor(usual, [0.01, 100.0], (1.0, "× usual"))
            }
            Self::Restitution(one) => {
                let law = contact(now, one)?.law;
                let is_free = matches!(law.about().exact, Exact::Any(_) | Exact::Parameter);
                Kind::number(law.restitution().filter(|_| is_free)?, [0.05, 0.95], (1.0, ""))
            }
            Self::Mass(one) => {
                let [before, mass] = [base, now].map(|scene| mass(&scene.structures[one]));
                Kind::factor(mass?, [before? / 5.0, before? * 5.0], (1e-3, "t"))
            }
            Self::Period(one) => {
                let [before, period] = [base, now].map(|scene| scene.structures[one].period());
                Kind::factor(period?, [before? / 4.0, before? * 4.0], (1.0, "s"))
            }
            Self::Damping(one) => Kind::number(now.structures[one].damping_ratio()?, [0.0, 0.2], (100.0, "%")),
            Self::Yield(one) => yield_kind(&base.structures[one], &now.structures[one])?,
            Self::Link(one) => {
                let [mut before, mut law] = [base, now].map(|scene| scene.links[one].law);
                let (before, (label, number, unit)) = (*link_number(&mut before).1, link_number(&mut law));
                if label == SLACK {
                    Kind::number(*number, [0.0, (3.0 * before).max(0.1)], unit)
                } else {
                    Kind::factor(*number, [1e-2 * before, 300.0 * before], unit)
                }
            }
            Self::Scale => {
                let before = Some(base.record.scale.abs()).filter(|scale| *scale > 0.0)?;
                Kind::factor(now.record.scale.abs(), [before / 10.0, before * 3.0], (1.0, "×"))
            }
            Self::Direction => {
                let words = [false, true].map(RecordUse::direction_of);
                let options = words.map(|word| (word.to_owned(), word.to_owned()));
                Kind::choice(now.record.direction(), options)
            }
            Self::Method => method_choice(now),
            Self::Step => {
                let step = now.method.time_step()?;
                let own = Some(step).filter(|step| !STEPS.contains(step));
                let options = own.into_iter().chain(STEPS);
                let options = options.map(|step| (step.to_string(), format!("{} ms", digits(1e3 * step))));
                Kind::choice(step.to_string(), options)
            }
        })
    }

    /// Turns a knob; `None` if the scene does not have it.
    fn turn(self, base: &Scene, scene: &mut Scene, to: &Value) -> Option<()> {
        match self {
            Self::Gap(one) => contact(scene, one)?.gap_m = to.as_f64()?,
            Self::Law(one) => {
                let law = &mut contact(scene, one)?.law;
                *law = other_law(law, to.as_str()?)?;
            }
            Self::Stiffness(one) => {
                let law = &mut contact(scene, one)?.law;
                *law = law.stiffened(to.as_f64()? / law.stiffness_over_usual()?);
            }
            Self::Restitution(one) => {
                let law = &mut contact(scene, one)?.law;
                *law = calibrated(LawName::from_name(law.name())?, law, to.as_f64()?)?;
            }
            Self::Mass(one) => {
                let structure = &mut scene.structures[one];
                let times = to.as_f64()? / mass(structure)?;
                scaled(structure, [times, times])?;
            }
            Self::Period(one) => {
                let structure = &mut scene.structures[one];
                let times = structure.period()? / to.as_f64()?;
                scaled(structure, [1.0, times * times])?;
            }
            Self::Damping(one) => {
                let ratio = Damping::Ratio(to.as_f64()?);
                match &mut scene.structures[one] {
                    Structure::Sdof(sdof) => sdof.damping = ratio,
                    Structure::Building(building) => building.damping = ratio,
                    Structure::Wall => return None,
                }
            }
            Self::Yield(one) => yields_at(&mut scene.structures[one], to.as_f64())?,
            Self::Link(one) => {
                for link in linked(base, one) {
                    *link_number(&mut scene.links[link].law).1 = to.as_f64()?;
                }
            }
            Self::Scale => scene.record.scale = to.as_f64()?.copysign(scene.record.scale),
            Self::Direction => scene.record.reversed = to.as_str()? == RecordUse::direction_of(true),
            Self::Method => scene.method = other_method(scene.method, to.as_str()?)?,
            Self::Step => scene.method = scene.method.with_time_step(to.as_str()?.parse().ok()?),
        }
        Some(())
    }
}

fn contact(scene: &mut Scene, one: usize) -> Option<&mut Contact> {
    scene.contacts.as_mut()?.get_mut(one)
}

/// The links with the law of this one.
fn linked(scene: &Scene, one: usize) -> Vec<usize> {
    let same = |other: &usize| scene.links[*other].law == scene.links[one].law;
    (0..scene.links.len()).filter(same).collect()
}

/// The number of a link that may be 0.
const SLACK: &str = "Slack";

/// The main number of a link: its label, the number, and its unit.
fn link_number(law: &mut Law) -> (&'static str, &mut f64, (f64, &'static str)) {
    let damping = "Damping coefficient";
    match law {
        Law::Spring { stiffness_n_per_m, .. } => ("Stiffness", stiffness_n_per_m, (1e-6, "MN/m")),
        Law::Dashpot { damping_n_s_per_m } | Law::Maxwell { damping_n_s_per_m, .. } => (damping, damping_n_s_per_m, (1e-6, "MN·s/m")),
        Law::Viscous { coefficient, .. } => (damping, coefficient, (1e-6, "MN·(s/m)^α")),
        Law::Restrainer { slack_m, .. } => (SLACK, slack_m, (1e3, "mm")),
    }
}

/// The laws to choose from: one for each force whose damping an e gives, whatever the pair, and the law of the scene.
fn law_choice(contact: &Contact) -> Kind {
    let own = contact.law.name();
    let mut options: Vec<(String, String)> = Vec::new();
    for law in LawName::ALL {
        let (about, name) = (law.about(), law.name());
        let is_force = about.names[0].name == name;
        let is_free = !matches!(about.exact, Exact::Pair(..));
        if is_force && (is_free || name == own) {
            options.push((name.into(), about.names[0].label.into()));
        }
    }
    Kind::choice(own, options)
}

/// Another law of the same restitution, and as stiff in times of the usual stiffness; the same law stays unchanged.
fn other_law(law: &ContactLaw, name: &str) -> Option<ContactLaw> {
    if law.name() == name {
        return Some(*law);
    }
    let e = law.restitution().filter(|e| *e < 1.0).unwrap_or(USUAL_RESTITUTION);
    calibrated(LawName::from_name(name)?, law, e)
}

/// The law of a name with a restitution, as stiff as `law` in times of the usual stiffness.
fn calibrated(name: LawName, law: &ContactLaw, e: f64) -> Option<ContactLaw> {
    let usual = name.stiffness().map_or(1.0, |stiffness| stiffness.usual);
    let stiffness = law.stiffness_over_usual().unwrap_or(1.0) * usual;
    let e = if name.is_elastic() { 1.0 } else { e };
    name.calibrated(stiffness, e, Calibration::Exact, &FreePair::UNIT).ok()
}

/// The method of a name with the present time step.
fn other_method(method: Method, key: &str) -> Option<Method> {
    let step = method.time_step().unwrap_or(FIRST_STEP);
    match key {
        OWN => Some(method),
        EXACT => Some(Method::EXACT),
        key => Some(StepMethod::all().find(|one| one.name() == key)?.at(step)),
    }
}

fn method_choice(scene: &Scene) -> Kind {
    let mut options = vec![(EXACT.to_owned(), "Exact".to_owned())];
    let step = scene.method.time_step();
    let is_taken = |one: &StepMethod| {
        let method = one.at(step.unwrap_or(FIRST_STEP));
        Scene { method, ..scene.clone() }.check_method().is_ok()
    };
    let taken = StepMethod::differing(scene.is_impulsive()).filter(is_taken);
    options.extend(taken.map(|one| (one.name().into(), one.label().into())));
    let known = StepMethod::all().find(|one| step.is_some_and(|step| one.at(step) == scene.method));
    let value = match known {
        Some(one) => one.name(),
        None if scene.method == Method::EXACT => EXACT,
        None => OWN,
    };
    if !options.iter().any(|(key, _)| key == value) {
        options.push((value.into(), scene.method.name().replace('_', " ")));
    }
    Kind::choice(value, options)
}

/// Mass of a structure \[kg\]; `None` for a wall.
fn mass(structure: &Structure) -> Option<f64> {
    match structure {
        Structure::Sdof(sdof) => Some(sdof.mass_kg),
        Structure::Building(building) => Some(building.storeys.iter().map(|storey| storey.mass_kg).sum()),
        Structure::Wall => None,
    }
}

/// Multiplies the masses and the stiffnesses of a structure.
fn scaled(structure: &mut Structure, [mass, stiffness]: [f64; 2]) -> Option<()> {
    match structure {
        Structure::Sdof(sdof) => {
            sdof.mass_kg *= mass;
            sdof.stiffness_n_per_m *= stiffness;
        }
        Structure::Building(building) => {
            for storey in &mut building.storeys {
                storey.mass_kg *= mass;
                storey.columns.stiffness_n_per_m *= stiffness;
            }
        }
        Structure::Wall => return None,
    }
    Some(())
}

/// The knob of the yield force of the lowest storey. Only structures of one storey can be turned from elastic to yielding: how strong the
/// storeys of an elastic building are among each other nobody knows.
fn yield_kind(base: &Structure, now: &Structure) -> Option<Kind> {
    let force = now.yield_forces().first().copied()?;
    let is_known = matches!(base, Structure::Sdof(_)) || base.yield_forces().iter().all(Option::is_some);
    let weight = STANDARD_GRAVITY * mass(base)?;
    let bounds = [0.02 * weight, 2.0 * weight];
    let mut kind = Kind::factor(force.unwrap_or(bounds[1]), bounds, (1e-3, "kN"));
    if let Kind::Number { value, beyond, .. } = &mut kind {
        *value = force;
        *beyond = Some("elastic");
    }
    is_known.then_some(kind)
}

/// Lets the columns of a structure yield at a force of the lowest storey \[N\], the others in proportion; `None` for never.
fn yields_at(structure: &mut Structure, force: Option<f64>) -> Option<()> {
    let lowest = structure.yield_forces().first().copied()?;
    match structure {
        Structure::Sdof(sdof) => {
            sdof.yield_force_n = force;
            if force.is_none() {
                (sdof.hardening_ratio, sdof.bouc_wen) = (None, None);
            }
        }
        Structure::Building(building) => {
            for storey in &mut building.storeys {
                let columns = &mut storey.columns;
                let own = columns.yield_force_n;
                columns.yield_force_n = force.and_then(|force| Some(own? * force / lowest?));
                if force.is_none() {
                    (columns.hardening_ratio, columns.bouc_wen) = (None, None);
                }
            }
        }
        Structure::Wall => return None,
    }
    Some(())
}
