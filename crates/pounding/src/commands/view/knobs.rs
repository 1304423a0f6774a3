//! The knobs of the page: which numbers of a scene can be turned, how far, and what turning does. A new knob is a variant of [`Knob`].

use std::collections::BTreeMap;

use pounding::contact::{Calibration, ContactLaw, Exact, FreePair, LawName};
use pounding::scene::{Contact, Damping, Method, RecordUse, STANDARD_GRAVITY, Scene, StepMethod, Structure};
use pounding::scene::file::Law;
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
        Some(Drawn {
            id: knob.id(),
            group: knob.group(base),
            label: knob.label(base),
            kind: knob.kind(base, now)?,
        })
    });
    drawn.collect()
}

/// Returns the scene with knobs turned, in the order of the list.
///
/// # Errors
/// Refuses a knob that the scene does not have, and a value outside of its range.
pub(super) fn turned(base: &Scene, turned: &Turned) -> Result<Scene, Refused> {
    let mut scene = base.clone();
    let all = Knob::all(base);
    for knob in &all {
        let id = knob.id();
        if let (Some(value), Some(kind)) = (turned.get(&id), knob.kind(base, &scene)) {
            let refused = |found: String| Refused::at(id.clone()).found(found).allowed_is("a value of this knob");
            let setting = kind.setting(value).ok_or_else(|| refused(value.to_string()))?;
            knob.turn(base, &mut scene, &setting).ok_or_else(|| refused(value.to_string()))?;
        }
    }
    match turned.keys().find(|id| !all.iter().any(|knob| knob.id() == **id)) {
        Some(unknown) => Err(Refused::at(unknown.clone()).is("no knob of this scene")),
        None => Ok(scene),
    }
}

/// The new value of a knob.
enum Setting {
    Number(Option<f64>),
    Choice(String),
}

impl Setting {
    fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => *number,
            Self::Choice(_) => None,
        }
    }

    fn choice(&self) -> &str {
        match self {
            Self::Number(_) => "",
            Self::Choice(word) => word,
        }
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

    /// A value that the knob allows.
    fn setting(&self, value: &Value) -> Option<Setting> {
        match self {
            Self::Number { least, most, beyond, .. } => match value.as_f64() {
                Some(number) if (*least..=*most).contains(&number) => Some(Setting::Number(Some(number))),
                None if value.is_null() && beyond.is_some() => Some(Setting::Number(None)),
                _ => None,
            },
            Self::Choice { options, .. } => {
                let word = value.as_str()?;
                let known = options.iter().any(|(known, _)| known == word);
                known.then(|| Setting::Choice(word.into()))
            }
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

    fn id(self) -> String {
        match self {
            Self::Gap(one) => format!("gap.{one}"),
            Self::Law(one) => format!("law.{one}"),
            Self::Stiffness(one) => format!("stiffness.{one}"),
            Self::Restitution(one) => format!("restitution.{one}"),
            Self::Mass(one) => format!("mass.{one}"),
            Self::Period(one) => format!("period.{one}"),
            Self::Damping(one) => format!("damping.{one}"),
            Self::Yield(one) => format!("yield.{one}"),
            Self::Link(one) => format!("link.{one}"),
            Self::Scale => "scale".into(),
            Self::Direction => "direction".into(),
            Self::Method => "method".into(),
            Self::Step => "step".into(),
        }
    }

    fn label(self, scene: &Scene) -> &'static str {
        match self {
            Self::Gap(_) => "Gap",
            Self::Law(_) => "Contact law",
            Self::Stiffness(_) => "Contact stiffness",
            Self::Restitution(_) => "Restitution",
            Self::Mass(_) => "Mass",
            Self::Period(_) => "Period",
            Self::Damping(_) => "Damping ratio",
            Self::Yield(_) => "Yield force",
            Self::Link(one) => link_number(&mut scene.links[one].law.clone()).label,
            Self::Scale => "Scale of the record",
            Self::Direction => "Direction",
            Self::Method => "Method",
            Self::Step => "Time step",
        }
    }

    fn group(self, scene: &Scene) -> String {
        let name = |one: usize| scene.structures[one].name().to_owned();
        match self {
            Self::Gap(one) | Self::Law(one) | Self::Stiffness(one) | Self::Restitution(one) => {
                format!("Between {} and {}", name(one), name(one + 1))
            }
            Self::Mass(one) | Self::Period(one) | Self::Damping(one) | Self::Yield(one) => name(one),
            Self::Link(one) => match linked(scene, one).len() {
                1 => format!("Link between {}", scene.links[one].names(scene).join(" and ")),
                several => format!("{several} links of the same law"),
            },
            Self::Scale | Self::Direction => "Shaking".into(),
            Self::Method | Self::Step => "Method".into(),
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
                let (before, number) = (*link_number(&mut before).value, link_number(&mut law));
                if number.label == SLACK {
                    Kind::number(*number.value, [0.0, (3.0 * before).max(0.1)], number.unit)
                } else {
                    Kind::factor(*number.value, [1e-3 * before, 1e2 * before], number.unit)
                }
            }
            Self::Scale => {
                let before = base.record.scale.abs();
                let is_some = before > 0.0;
                is_some.then(|| Kind::factor(now.record.scale.abs(), [before / 10.0, before * 3.0], (1.0, "×")))?
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
    fn turn(self, base: &Scene, scene: &mut Scene, to: &Setting) -> Option<()> {
        match self {
            Self::Gap(one) => contact(scene, one)?.gap_m = to.number()?,
            Self::Law(one) => {
                let law = &mut contact(scene, one)?.law;
                *law = other_law(law, to.choice())?;
            }
            Self::Stiffness(one) => {
                let law = &mut contact(scene, one)?.law;
                *law = law.stiffened(to.number()? / law.stiffness_over_usual()?);
            }
            Self::Restitution(one) => {
                let law = &mut contact(scene, one)?.law;
                *law = calibrated(LawName::from_name(law.name())?, law, to.number()?)?;
            }
            Self::Mass(one) => {
                let structure = &mut scene.structures[one];
                let times = to.number()? / mass(structure)?;
                scaled(structure, [times, times])?;
            }
            Self::Period(one) => {
                let structure = &mut scene.structures[one];
                let times = structure.period()? / to.number()?;
                scaled(structure, [1.0, times * times])?;
            }
            Self::Damping(one) => {
                let ratio = Damping::Ratio(to.number()?);
                match &mut scene.structures[one] {
                    Structure::Sdof(sdof) => sdof.damping = ratio,
                    Structure::Building(building) => building.damping = ratio,
                    Structure::Wall => return None,
                }
            }
            Self::Yield(one) => yields_at(&mut scene.structures[one], to.number())?,
            Self::Link(one) => {
                for link in linked(base, one) {
                    *link_number(&mut scene.links[link].law).value = to.number()?;
                }
            }
            Self::Scale => scene.record.scale = to.number()?.copysign(scene.record.scale),
            Self::Direction => scene.record.reversed = to.choice() == RecordUse::direction_of(true),
            Self::Method => scene.method = other_method(scene.method, to.choice())?,
            Self::Step => scene.method = scene.method.with_time_step(to.choice().parse().ok()?),
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

/// The main number of a link.
struct LinkNumber<'a> {
    label: &'static str,
    value: &'a mut f64,
    unit: (f64, &'static str),
}

/// The number of a link that may be 0.
const SLACK: &str = "Slack";

fn link_number(law: &mut Law) -> LinkNumber<'_> {
    let (label, value, unit) = match law {
        Law::Spring { stiffness_n_per_m: value, .. } => ("Stiffness", value, (1e-6, "MN/m")),
        Law::Dashpot { damping_n_s_per_m: value } | Law::Maxwell { damping_n_s_per_m: value, .. } => {
            ("Damping coefficient", value, (1e-6, "MN·s/m"))
        }
        Law::Viscous { coefficient: value, .. } => ("Damping coefficient", value, (1e-6, "MN·(s/m)^α")),
        Law::Restrainer { slack_m: value, .. } => (SLACK, value, (1e3, "mm")),
    };
    LinkNumber { label, value, unit }
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
