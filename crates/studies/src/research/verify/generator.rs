//! Random plausible scenes: rows of buildings and walls as in cities, with every feature that scenes can have.
//!
//! Features on which a route fails are included too.

use std::f64::consts::PI;

use super::contacts;
use super::links;
use super::random::Random;
use super::written::rewritten;
use pounding_scene::file::Stochastic;
use pounding_scene::file::{BoucWen, Ground, RunBudget, ScaleTo};
use pounding_scene::{
    Building, Capacities, ColumnShape, Columns, Contact, DampedStiffness, Damping, FileUse, FloorHeights, Generated, Method, PDelta,
    RecordUse,
};
use pounding_scene::{Scene, Sdof, Source, Storey, Structure};

/// Acceleration by which weights follow from masses \[m/s²\].
const GRAVITY: f64 = 9.81;

/// Largest number of storeys of a building.
const MOST_STOREYS: f64 = 12.0;

/// Scene number `index` of the campaign with a seed. Its numbers have at most five digits.
pub(super) fn scene(seed: u64, index: usize) -> Scene {
    let mut random = Random::new(seed, index);
    let mut structures = structures(&mut random);
    let contacts = contacts::all(&mut random, &structures);
    if random.chance(0.08) {
        push(&mut random, &mut structures, &contacts);
    }
    let n = structures.len();
    let scene = Scene {
        name: format!("seed {seed}, scene {index}"),
        record: motion(&mut random),
        duration_s: Some(random.within(5.0, 20.0)),
        neighbour: None,
        p_delta: None,
        collapse_drift_ratio: None,
        links: Vec::new(),
        arrivals_s: arrivals(&mut random, n),
        floors: Some(FloorHeights::Level),
        structures,
        contacts: Some(contacts),
        method: Method::EXACT,
        budget: RunBudget::default(),
        seeks_gaps: false,
    };
    let scene = match index % 3 {
        0 if index >= FIRST_WITH_MORE => beside_columns(seed, index, scene),
        1 if index >= FIRST_WITH_MORE => linked(&mut Random::new(!seed, index), scene),
        2 if index >= FIRST_WITH_MORE => sliding(seed, index, scene),
        _ => scene,
    };
    let all = ["record", "duration_s", "arrivals_s", "structures", "contacts", "links"];
    rewritten(&scene, &all, &mut in_few_digits)
}

/// From this number on a third of the scenes has floors beside columns, another third has links, and the last one has isolators that stick
/// under friction; earlier scenes are known by their numbers.
const FIRST_WITH_MORE: usize = 1000;

/// The scene with links.
fn linked(random: &mut Random, scene: Scene) -> Scene {
    let links = links::all(random, &scene.structures);
    Scene { links, ..scene }
}

/// The scene with friction pendulums that stick under at least one building, in some scenes with links.
fn sliding(seed: u64, index: usize, mut scene: Scene) -> Scene {
    let mut random = Random::new(!seed, index);
    let structures = &mut scene.structures;
    let moves = |structure: &Structure| !matches!(structure, Structure::Wall);
    let first = structures.iter().position(moves);
    for (index, structure) in structures.iter_mut().enumerate() {
        let slides = random.chance(0.5);
        if let Some(building) = upper(structure)
            && (slides || Some(index) == first)
        {
            *structure = Structure::Building(isolated(&mut random, building));
        }
    }
    if random.chance(0.3) { linked(&mut random, scene) } else { scene }
}

/// A structure as a building; `None` for a wall.
fn upper(structure: &Structure) -> Option<Building> {
    match structure {
        Structure::Building(building) => Some(building.clone()),
        Structure::Sdof(sdof) => Some(Building {
            name: sdof.name.clone(),
            damping: sdof.damping,
            storeys: vec![Storey {
                mass_kg: sdof.mass_kg,
                height_m: None,
                capacities: Capacities::default(),
                columns: sdof.columns(),
                initial_displacement_m: sdof.initial_displacement_m,
                initial_velocity_m_per_s: sdof.initial_velocity_m_per_s,
            }],
        }),
        Structure::Wall => None,
    }
}

/// The building on a base slab on friction pendulums.
fn isolated(random: &mut Random, mut building: Building) -> Building {
    let mass = building.storeys[0].mass_kg * random.within(0.3, 1.5);
    let weight = GRAVITY * building.storeys.iter().map(|one| one.mass_kg).sum::<f64>() + GRAVITY * mass;
    let (radius, friction) = (random.within(0.8, 6.0), random.log_within(0.01, 0.2));
    let stiffness = weight / radius;
    let damping = if random.chance(0.3) {
        random.within(0.0, 0.2) * (stiffness * weight / GRAVITY).sqrt()
    } else {
        0.0
    };
    // Masses are not damped: damping leaves isolators out.
    if let Damping::Rayleigh { alpha_per_s, .. } = &mut building.damping {
        *alpha_per_s = 0.0;
    }
    let base = Storey {
        mass_kg: mass,
        height_m: None,
        capacities: Capacities {
            isolation_layer: Some(true),
            isolator_damping_n_s_per_m: Some(damping),
            ..Capacities::default()
        },
        columns: Columns {
            friction_n: Some(friction * weight),
            ..Columns::elastic(stiffness)
        },
        initial_displacement_m: 0.0,
        initial_velocity_m_per_s: 0.0,
    };
    building.storeys.insert(0, base);
    building
}

/// The scene with storeys of any height, so that floors face columns.
fn beside_columns(seed: u64, index: usize, scene: Scene) -> Scene {
    let mut random = Random::new(!seed, index);
    let straight = random.chance(0.3);
    let mut structures = scene.structures;
    for structure in &mut structures {
        let height = random.within(2.6, 4.5);
        match structure {
            Structure::Sdof(sdof) => sdof.height_m = Some(height),
            Structure::Building(building) => {
                for storey in &mut building.storeys {
                    storey.height_m = Some(height);
                }
            }
            Structure::Wall => {}
        }
    }
    let contact = |one: Contact| Contact {
        levels: None,
        column_shape: if straight { ColumnShape::Straight } else { ColumnShape::Fixed },
        ..one
    };
    let p_delta = random.chance(0.5).then_some(PDelta::FromMasses);
    Scene {
        floors: None,
        p_delta,
        structures,
        contacts: scene.contacts.map(|all| all.into_iter().map(contact).collect()),
        ..scene
    }
}

/// A number rounded to five digits: files with such numbers are easy to read and give exactly this scene.
fn in_few_digits(number: f64) -> f64 {
    format!("{number:.4e}").parse().unwrap_or(f64::NAN)
}

/// Two to five buildings, or one beside a wall; a wall may be at either end or at both.
fn structures(random: &mut Random) -> Vec<Structure> {
    let walls = if random.chance(0.4) {
        random.one_of(&[(true, false), (false, true), (true, true)])
    } else {
        (false, false)
    };
    let alone = (walls.0 || walls.1) && random.chance(0.2);
    let n = if alone { 1 } else { 2 + random.below(4) };
    let low = random.chance(0.35);
    let twins = random.chance(0.1);
    let mut row: Vec<Structure> = Vec::new();
    for number in 1..=n {
        let name = format!("building {number}");
        let next = match row.first() {
            Some(first) if twins => named(first, name),
            _ => building(random, name, low),
        };
        row.push(next);
    }
    if walls.0 {
        row.insert(0, Structure::Wall);
    }
    if walls.1 {
        row.push(Structure::Wall);
    }
    row
}

/// The structure with another name.
fn named(structure: &Structure, name: String) -> Structure {
    match structure {
        Structure::Sdof(sdof) => Structure::Sdof(Sdof { name, ..sdof.clone() }),
        Structure::Building(building) => Structure::Building(Building { name, ..building.clone() }),
        Structure::Wall => Structure::Wall,
    }
}

/// Gives a structure a velocity at the start. A one-storey structure also gets a displacement, at most as large as the gaps allow.
fn push(random: &mut Random, structures: &mut [Structure], contacts: &[Contact]) {
    let gaps = contacts.iter().map(|contact| contact.gap_m);
    let room = gaps.fold(0.02, f64::min);
    let moving = random.below(structures.len());
    let (displacement, velocity) = (random.within(-room, room), random.within(-0.5, 0.5));
    match &mut structures[moving] {
        Structure::Sdof(sdof) => {
            sdof.initial_displacement_m = 0.9 * displacement;
            sdof.initial_velocity_m_per_s = velocity;
        }
        Structure::Building(building) => {
            for storey in &mut building.storeys {
                storey.initial_velocity_m_per_s = velocity;
            }
        }
        Structure::Wall => {}
    }
}

fn building(random: &mut Random, name: String, low: bool) -> Structure {
    let storeys = if low {
        1.0
    } else {
        random.log_within(1.0, MOST_STOREYS + 1.0).floor()
    };
    if storeys <= 1.0 && random.chance(0.8) {
        return Structure::Sdof(sdof(random, name));
    }
    let mass = random.log_within(3e4, 5e5);
    let period = storeys * random.within(0.07, 0.16);
    // Frequency of a uniform shear building: ω₁ = 2 √(k/m) sin(π/(4n + 2)).
    let rate = PI / (period * libm::sin(PI / (4.0 * storeys + 2.0)));
    let taper = random.within(0.4, 1.0);
    let roof = random.within(0.5, 1.0);
    let mut kind = ColumnKind::one(random);
    let changing = random.chance(0.1);
    let mut all = Vec::new();
    let mut below = 0.0;
    while below < storeys {
        let part = 1.0 - (1.0 - taper) * below / storeys;
        if changing {
            kind = ColumnKind::one(random);
        }
        below += 1.0;
        all.push(Storey {
            mass_kg: if below < storeys { mass } else { roof * mass },
            height_m: None,
            capacities: Capacities::default(),
            columns: kind.columns(random, mass * rate * rate * part),
            initial_displacement_m: 0.0,
            initial_velocity_m_per_s: 0.0,
        });
    }
    Structure::Building(Building {
        name,
        damping: damping(random),
        storeys: all,
    })
}

fn sdof(random: &mut Random, name: String) -> Sdof {
    let mass = random.log_within(3e4, 3e6);
    let omega = 2.0 * PI / random.log_within(0.15, 2.0);
    let kind = ColumnKind::one(random);
    let columns = kind.columns(random, mass * omega * omega);
    Sdof {
        name,
        mass_kg: mass,
        stiffness_n_per_m: columns.stiffness_n_per_m,
        damping: damping(random),
        yield_force_n: columns.yield_force_n,
        hardening_ratio: columns.hardening_ratio,
        bouc_wen: columns.bouc_wen,
        height_m: None,
        capacities: Capacities::default(),
        initial_displacement_m: 0.0,
        initial_velocity_m_per_s: 0.0,
    }
}

fn damping(random: &mut Random) -> Damping {
    match random.below(7) {
        0 => Damping::Ratio(0.0),
        1 => Damping::Rayleigh {
            alpha_per_s: random.within(0.0, 1.0),
            beta_s: random.within(0.0, 3e-3),
            stiffness: DampedStiffness::Initial,
        },
        2 => Damping::Ratio(random.within(0.0, 0.2)),
        _ => Damping::Ratio(random.one_of(&[0.02, 0.03, 0.05])),
    }
}

/// Behaviour of the columns of a building.
#[derive(Debug, Clone, Copy)]
enum ColumnKind {
    Elastic,
    PerfectlyPlastic,
    Bilinear,
    BoucWen { exponent: u32, beta: f64 },
}

impl ColumnKind {
    fn one(random: &mut Random) -> Self {
        match random.below(4) {
            0 => Self::Elastic,
            1 => Self::PerfectlyPlastic,
            2 => Self::Bilinear,
            _ => Self::BoucWen {
                exponent: random.one_of(&[1, 1, 2, 2, 3, 5, 10, 20]),
                beta: if random.chance(0.4) { 0.5 } else { random.within(0.0, 1.0) },
            },
        }
    }

    fn columns(self, random: &mut Random, stiffness: f64) -> Columns {
        let drift = random.log_within(2e-3, 5e-2);
        let hardening = random.within(0.0, 0.3);
        let hardens = random.chance(0.5);
        let elastic = Columns::elastic(stiffness);
        let plastic = Columns {
            yield_force_n: Some(stiffness * drift),
            ..elastic
        };
        match self {
            Self::Elastic => elastic,
            Self::PerfectlyPlastic => plastic,
            Self::Bilinear => Columns {
                hardening_ratio: Some(hardening),
                ..plastic
            },
            Self::BoucWen { exponent, beta } => Columns {
                hardening_ratio: hardens.then_some(hardening),
                bouc_wen: Some(BoucWen { exponent, beta }),
                ..plastic
            },
        }
    }
}

/// Arrivals of a wave that travels along the row, or `None`.
fn arrivals(random: &mut Random, n: usize) -> Option<Vec<f64>> {
    if !random.chance(0.3) {
        return None;
    }
    let delay = random.within(10.0, 40.0) / random.log_within(100.0, 2000.0);
    // Some delays are a whole number of samples: the ground's rate then jumps under all structures at once.
    let delay = if random.chance(0.3) { 0.01 * (100.0 * delay).ceil() } else { delay };
    let first_to_last = (0..n).map(|index| delay * index as f64);
    let mut arrivals: Vec<f64> = first_to_last.collect();
    if random.chance(0.5) {
        arrivals.reverse();
    }
    Some(arrivals)
}

/// The project's records, relative to the folder of the studies.
const RECORDS: [&str; 2] = [
    "records/el-centro-1940-ns-chopra.csv",
    "records/el-centro-1940-ns-peer-pacific-engineering.csv",
];

/// A ground motion: a record of the project, random shaking or a pulse, scaled to the strength of earthquakes.
fn motion(random: &mut Random) -> RecordUse {
    let reversed = random.chance(0.5);
    let (source, scale_to) = match random.below(20) {
        0..=6 => (file(random), Some(ScaleTo::PgaG(random.log_within(0.1, 0.8)))),
        7..=13 => (stochastic(random), None),
        14..=15 => (ricker(random), None),
        16..=17 => (half_sine(random), None),
        _ => (harmonic(random), None),
    };
    RecordUse {
        scale_to,
        reversed,
        ..RecordUse::of(source)
    }
}

fn file(random: &mut Random) -> Source {
    Source::File(FileUse {
        file: random.one_of(&RECORDS).into(),
        ..FileUse::default()
    })
}

fn stochastic(random: &mut Random) -> Source {
    let strong_from_s = random.within(0.5, 2.0);
    Source::Generated(Generated::Stochastic(Stochastic {
        ground: random.one_of(&[Ground::Firm, Ground::Medium, Ground::Soft]),
        pga_m_per_s2: random.log_within(1.0, 8.0),
        strong_from_s,
        strong_until_s: strong_from_s + random.within(2.0, 8.0),
        decay_per_s: random.within(0.2, 1.0),
        cutoff_hz: None,
        duration_s: 15.0,
        time_step_s: random.one_of(&[0.005, 0.01, 0.02]),
        seed: random.seed(),
    }))
}

fn ricker(random: &mut Random) -> Source {
    Source::Generated(Generated::Ricker {
        amplitude_m_per_s2: random.within(1.0, 8.0),
        frequency_hz: random.log_within(0.4, 4.0),
        time_step_s: random.one_of(&[0.005, 0.01, 0.02]),
    })
}

fn half_sine(random: &mut Random) -> Source {
    Source::Generated(Generated::HalfSine {
        amplitude_m_per_s2: random.within(1.0, 6.0),
        duration_s: random.log_within(0.1, 1.5),
        time_step_s: random.one_of(&[0.005, 0.01, 0.02]),
    })
}

fn harmonic(random: &mut Random) -> Source {
    let frequency_hz = random.log_within(0.3, 5.0);
    Source::Generated(Generated::Harmonic {
        amplitude_m_per_s2: random.within(0.5, 4.0),
        frequency_hz,
        phase_rad: if random.chance(0.5) { 0.0 } else { random.within(0.0, 6.0) },
        ramp_periods: random.one_of(&[0.0, 1.0, 2.0]),
        // The duration has at least five periods; ramps take up to four.
        duration_s: random.within(3.0, 12.0).max(5.0 / frequency_hz),
        time_step_s: random.one_of(&[0.005, 0.01, 0.02]),
    })
}
