//! What was modelled: the tables of structures and contacts that a reader checks against drawings.

use pounding_scene::{Columns, Floor, RunResult, Scene, Simulation, StoreyProperties, Structure};
use pounding_text::{Grid, NONE, Shown, Table, Unit, digits, percent, short};

use crate::assumed::{damping_given, link_parameters, parameters};

/// A floor of a structure and its properties; a wall has neither.
#[derive(Clone, Copy)]
struct Modelled<'a> {
    structure: &'a Structure,
    floor: Option<(&'a Floor, StoreyProperties)>,
}

impl Modelled<'_> {
    /// A number of the storey; a dash for a wall.
    fn storey(&self, number: impl Fn(&StoreyProperties) -> Option<f64>) -> Option<f64> {
        number(&self.floor?.1)
    }

    /// A number of the building, in the row of its first storey.
    fn building(&self, number: Option<f64>) -> Shown {
        match self.floor {
            None => NONE.into(),
            Some((floor, _)) if floor.storey.is_none_or(|storey| storey == 1) => {
                number.map_or_else(|| "".into(), |number| Shown::from(short(number)))
            }
            Some(_) => "".into(),
        }
    }

    fn name(&self) -> Shown {
        match self.floor {
            Some((floor, made)) => Shown::from(floor.name.as_str()).over(start(made.initial_displacement_m, made.initial_velocity_m_per_s)),
            None => Shown::from(self.structure.name()).over(Some("fixed".into())),
        }
    }
}

/// A row for each floor, building by building from the ground up.
pub(super) fn structures(prepared: &Simulation) -> Grid {
    let floors = prepared.floors();
    let structures = prepared.scene().structures.iter().enumerate();
    let rows = structures.flat_map(|(index, structure)| {
        let own = floors.of_structure(index).iter().map(|floor| &floors.all()[*floor]);
        let own = own.filter_map(|floor| Some((floor, floor.made_of?)));
        let rows: Vec<_> = own
            .map(|floor| Modelled {
                structure,
                floor: Some(floor),
            })
            .collect();
        if rows.is_empty() {
            vec![Modelled { structure, floor: None }]
        } else {
            rows
        }
    });
    Table::of(rows)
        .shown("Structure", Modelled::name)
        .shown_in("t", "Mass", |one| {
            one.storey(|made| Some(made.mass_kg)).map(|mass| short(1e-3 * mass))
        })
        .shown_in("MN/m", "Stiffness", |one| {
            one.storey(|made| Some(made.columns.stiffness_n_per_m))
                .map(|stiffness| short(1e-6 * stiffness))
        })
        .shown_in("m", "Height", |one| one.storey(|made| made.height_m).map(digits))
        .shown_in("kN", "Yields at", |one| {
            one.storey(|made| made.columns.yield_force_n.or(made.columns.friction_n))
                .map(|force| short(1e-3 * force))
        })
        .shown("Columns", |one| match one.floor {
            Some((_, made)) => Shown::from(kind(&made.columns)).over(shape(&made.columns)),
            None => NONE.into(),
        })
        .shown_in("s", "Period", |one| one.building(one.structure.period()))
        .shown("Damping ratio", |one| one.building(one.structure.damping_ratio()))
        .grid()
}

/// How a floor starts, if it is not at rest.
fn start(displacement: f64, velocity: f64) -> Option<String> {
    (displacement != 0.0 || velocity != 0.0).then(|| {
        let (displacement, velocity) = (digits(1e3 * displacement), digits(velocity));
        format!("starts at {displacement} mm, {velocity} m/s")
    })
}

fn kind(columns: &Columns) -> &'static str {
    match (columns.yield_force_n, columns.bouc_wen) {
        (None, _) if columns.friction_n.is_some() => "friction",
        (None, _) => "elastic",
        (Some(_), Some(_)) => "Bouc–Wen",
        (Some(_), None) if columns.hardening_ratio.is_some_and(|ratio| ratio > 0.0) => "bilinear",
        (Some(_), None) => "perfectly plastic",
    }
}

/// What the loop of yielding columns looks like.
fn shape(columns: &Columns) -> Option<String> {
    columns.yield_force_n?;
    let hardening = columns.hardening_ratio.filter(|ratio| *ratio > 0.0);
    let hardening = hardening.map(|ratio| format!("hardening {}", digits(ratio)));
    let smooth = columns.bouc_wen;
    let smooth = smooth.map(|one| format!("n = {}, β = {}", one.exponent, digits(one.beta)));
    let parts: Vec<String> = smooth.into_iter().chain(hardening).collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// Sentences about damping that was not given as a ratio of one mode, and about its part that is proportional to mass.
pub fn damping_facts(prepared: &Simulation, outcome: &RunResult) -> Vec<String> {
    let said = |(index, structure): (usize, &Structure)| {
        let mass = prepared.mass_damping(outcome, index);
        let mass = mass.map_or_else(String::new, |mass| {
            format!(
                "; its mass term is {} of critical at {} s, the first period with the stiffness at the peak drifts",
                percent(mass.ratio),
                short(mass.period_s)
            )
        });
        Some(format!("{}: {}{mass}", structure.name(), damping_given(structure)?))
    };
    prepared.scene().structures.iter().enumerate().filter_map(said).collect()
}

/// A row for each contact.
pub(super) fn contacts(scene: &Scene) -> Grid {
    let contacts = scene.contacts.iter().flatten();
    let between = scene.structures.windows(2).zip(contacts);
    Table::of(between)
        .shown("Contact", |(neighbours, contact)| {
            let levels = contact.levels.as_ref().map(|levels| {
                let levels: Vec<String> = levels.iter().map(ToString::to_string).collect();
                format!("at levels {}", levels.join(", "))
            });
            let names: Vec<&str> = neighbours.iter().map(Structure::name).collect();
            Shown::from(names.join(" – ")).over(levels)
        })
        .shown_number("Gap", &Unit::GAP, |(_, contact)| contact.gap_m)
        .shown("Law", |(_, contact)| contact.law.name().replace('_', " "))
        .shown("Delivers e", |(_, contact)| contact.law.restitution().map(short))
        .shown("Parameters", |(_, contact)| Shown::from(parameters(contact)).long())
        .grid()
}

/// A row for each link.
pub(super) fn links(scene: &Scene) -> Grid {
    Table::of(&scene.links)
        .shown("Link", |link| link.names(scene).join(" – "))
        .shown("Law", |link| link.law.name())
        .shown("Parameters", |link| Shown::from(link_parameters(link)).long())
        .grid()
}
