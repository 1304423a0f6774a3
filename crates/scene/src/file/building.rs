//! Buildings of several storeys, as files give them.

use pounding_solver::{Damping as SolverDamping, Elastic, Mode, Storey as SolverStorey, modes};
use pounding_text::Refused;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choice;
use super::columns::{BoucWen, Capacities, Columns, ColumnsFile, positive};
use super::isolator::Isolator;
use crate::{Damping, STANDARD_GRAVITY};

/// A building whose floors move as rigid plates on the columns of their storeys (shear building).
///
/// A file may give the natural period of the building instead of the stiffness of its storeys. A storey may stand for several equal
/// storeys.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "BuildingFile")]
#[schemars(with = "BuildingFile")]
pub struct Building {
    /// Name for tables and figures.
    pub name: String,
    /// Viscous damping. It does not change if columns yield.
    pub damping: Damping,
    /// The storeys, from the ground up.
    pub storeys: Vec<Storey>,
}

/// A storey: its columns, and the floor that they carry.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Storey {
    /// Mass of the floor \[kg\], > 0.
    pub mass_kg: f64,
    /// Height of the storey \[m\], > 0; for drift ratios and for which floors face each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height_m: Option<f64>,
    /// Columns of the storey.
    #[serde(flatten)]
    pub columns: Columns,
    /// What the scene says of the limits of the storey.
    #[serde(flatten)]
    pub capacities: Capacities,
    /// Displacement of the floor at t = 0 \[m\], relative to the ground.
    #[serde(skip_serializing_if = "super::is_zero")]
    pub initial_displacement_m: f64,
    /// Velocity of the floor at t = 0 \[m/s\].
    #[serde(skip_serializing_if = "super::is_zero")]
    pub initial_velocity_m_per_s: f64,
}

/// A building in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct BuildingFile {
    /// Name for tables and figures.
    name: String,
    /// Viscous damping: a `ratio` holds in the first two modes.
    #[serde(deserialize_with = "choice::one")]
    damping: Damping,
    /// First natural period of the building \[s\], > 0: storeys then need no stiffness. If all storeys have `stiffness_n_per_m`, only their
    /// proportions count.
    period_s: Option<f64>,
    /// The storeys, from the ground up, 1 to 200.
    storeys: Vec<StoreyFile>,
}

/// A storey, or several equal ones, in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct StoreyFile {
    /// Mass of the floor \[kg\], > 0.
    mass_kg: f64,
    /// Stiffness of the columns \[N/m\], > 0; optional if the building has `period_s`.
    stiffness_n_per_m: Option<f64>,
    /// Shear force at which the columns yield \[N\], > 0. Columns without yield force, yield displacement and yield drift ratio stay
    /// elastic.
    yield_force_n: Option<f64>,
    /// Drift at which the columns yield \[m\], > 0.
    yield_displacement_m: Option<f64>,
    /// Drift at which the columns yield over `height_m` \[–\], > 0.
    yield_drift_ratio: Option<f64>,
    /// Ratio of the stiffness after yielding to the stiffness before \[–\], 0 to less than 1; 0 by default.
    hardening_ratio: Option<f64>,
    /// Smooth yielding; by default columns yield at one point.
    bouc_wen: Option<BoucWen>,
    /// Friction of isolators that stick, beside their stiffness \[N\], > 0, with `isolation_layer`; the words of `isolator` set it.
    friction_n: Option<f64>,
    /// Height of the storey \[m\], > 0; for drift ratios and for which floors face each other. An isolation layer without it has its base
    /// slab at the ground.
    height_m: Option<f64>,
    /// Isolators of the lowest storey, in place of its stiffness and yielding.
    #[serde(default, deserialize_with = "choice::maybe")]
    isolator: Option<Isolator>,
    /// Viscous damping of the isolators \[N·s/m\], ≥ 0; 0 by default. `damping` of the building leaves their storey out.
    isolator_damping_n_s_per_m: Option<f64>,
    /// Displacement that the isolators bear \[m\], > 0; by default it is not judged.
    displacement_capacity_m: Option<f64>,
    /// Whether the lowest storey stands for isolators, which have no limits of columns; `isolator` says it with their own loop and damping. By
    /// default `check` asks if it looks like them.
    isolation_layer: Option<bool>,
    /// Drift over `height_m` that the columns bear \[–\], > 0; by default that of ductile construction, 0.025 and a ductility of 6.
    drift_capacity_ratio: Option<f64>,
    /// Shear force that the columns bear \[N\], > 0; by default it is not judged.
    shear_capacity_n: Option<f64>,
    /// Shear force that one column bears \[N\], > 0, when a slab of the neighbour hits it; by default it is not judged.
    column_capacity_n: Option<f64>,
    /// Number of equal columns, ≥ 1: the bending of the one that a slab hits stands in series with a linear contact. By default columns do
    /// not bend there.
    columns: Option<u32>,
    /// Weight on the floor that acts on the leaning storeys below (P-Δ) \[N\], ≥ 0; by default none.
    gravity_load_n: Option<f64>,
    /// Depth of the slab below the height of its floor \[m\], ≥ 0: slabs whose depths overlap meet as floors. By default only floors at one
    /// height do.
    slab_depth_m: Option<f64>,
    /// Displacement of the floor at t = 0 \[m\], relative to the ground.
    #[serde(default)]
    initial_displacement_m: f64,
    /// Velocity of the floor at t = 0 \[m/s\].
    #[serde(default)]
    initial_velocity_m_per_s: f64,
    /// Number of equal storeys, one above the other; 1 by default.
    #[serde(default = "once")]
    repeat: usize,
}

fn once() -> usize {
    1
}

/// Least ratio of the stiffness of the second storey to that of a lowest storey that looks like isolators \[–\]. The storeys of frames
/// differ less, those of a soft ground storey included.
const ISOLATORS_SOFTER: f64 = 5.0;
/// Least period of a building on isolators \[s\]; usual ones are 2 to 4 s.
const ISOLATORS_PERIOD: f64 = 1.5;

/// Largest number of storeys of a building.
const MOST_STOREYS: usize = 200;

impl TryFrom<BuildingFile> for Building {
    type Error = Refused;

    fn try_from(words: BuildingFile) -> Result<Self, Refused> {
        if let Some(storey) = words.storeys.iter().position(|one| one.repeat == 0) {
            let none = Refused::at(format!("storeys[{storey}].repeat")).found("0");
            return Err(none.allowed("a whole number from 1").help("leave the storey out instead"));
        }
        let count = words.storeys.iter().map(|one| one.repeat);
        let count = count.fold(0_usize, usize::saturating_add);
        if !(1..=MOST_STOREYS).contains(&count) {
            let found = Refused::at("storeys").found(count.to_string()).allowed_are("1 to 200");
            return Err(found.help("`repeat` counts too"));
        }
        words.check_isolation()?;
        let isolators = words.isolators()?;
        let stiffnesses = words.stiffnesses(isolators.as_ref())?;
        let mut storeys = Vec::with_capacity(count);
        for (index, (storey, stiffness)) in words.storeys.iter().zip(stiffnesses).enumerate() {
            let isolators = isolators.as_ref().filter(|_| index == 0);
            let one = storey.storey(stiffness, isolators).map_err(|refused| in_storey(index, refused))?;
            storeys.extend(std::iter::repeat_n(one, storey.repeat));
        }
        Ok(Self {
            name: words.name,
            damping: words.damping,
            storeys,
        })
    }
}

impl BuildingFile {
    /// Refuses an isolation layer that is not the lowest storey alone.
    fn check_isolation(&self) -> Result<(), Refused> {
        let mut storeys = self.storeys.iter().enumerate();
        let above = storeys.find(|(index, one)| one.isolation_layer == Some(true) && (*index > 0 || one.repeat > 1));
        let slides = |one: &StoreyFile| one.friction_n.is_some() && one.isolation_layer != Some(true);
        if let Some(index) = self.storeys.iter().position(slides) {
            let found = Refused::at(format!("storeys[{index}].friction_n")).found("it without isolators");
            return Err(found
                .allowed_is("it beside isolation_layer = true")
                .help("isolator.friction_pendulum sets it"));
        }
        above.map_or(Ok(()), |(index, _)| {
            let found = Refused::at(format!("storeys[{index}].isolation_layer")).found("true above the lowest storey");
            let allowed = found.allowed("the lowest storey of a building, once");
            Err(allowed.help("give the isolators an entry of their own, the first of `storeys`"))
        })
    }

    /// The loop of the isolators under the building, if there are any.
    ///
    /// The weight above is the sum of the gravity loads, or without any that of the masses.
    fn isolators(&self) -> Result<Option<Columns>, Refused> {
        let mut all = self
            .storeys
            .iter()
            .enumerate()
            .filter_map(|(index, one)| Some((index, one, one.isolator?)));
        let Some((index, storey, isolator)) = all.next() else {
            let alone = self
                .storeys
                .iter()
                .position(|one| one.isolator_damping_n_s_per_m.is_some() && one.isolation_layer != Some(true));
            return alone.map_or(Ok(None), |index| {
                let found = Refused::at(format!("storeys[{index}].isolator_damping_n_s_per_m")).found("it without an isolator");
                Err(found.allowed_is("it beside isolator, or beside isolation_layer = true"))
            });
        };
        let place = format!("storeys[{index}].isolator");
        if index > 0 || storey.repeat > 1 {
            let found = Refused::at(place).found("isolators above the lowest storey");
            return Err(found.allowed("the lowest storey of a building, once"));
        }
        let has_columns = storey.stiffness_n_per_m.is_some()
            || storey.yield_force_n.is_some()
            || storey.yield_displacement_m.is_some()
            || storey.yield_drift_ratio.is_some()
            || storey.hardening_ratio.is_some()
            || storey.bouc_wen.is_some()
            || storey.friction_n.is_some();
        if has_columns {
            let found = Refused::at(place).found("isolators beside a stiffness or a yield point of the storey");
            return Err(found.allowed_is("one of both").help("isolators have their own stiffness"));
        }
        let times = |one: &StoreyFile, value: f64| one.repeat as f64 * value;
        let loads: f64 = self.storeys.iter().map(|one| times(one, one.gravity_load_n.unwrap_or(0.0))).sum();
        let masses: f64 = self.storeys.iter().map(|one| times(one, one.mass_kg)).sum();
        let weight = if loads > 0.0 { loads } else { masses * STANDARD_GRAVITY };
        isolator.columns(weight).map(Some).map_err(|refused| in_storey(index, refused))
    }

    /// Stiffness of every storey in the list \[N/m\]. A period is that of the building fixed above its isolators.
    fn stiffnesses(&self, isolators: Option<&Columns>) -> Result<Vec<f64>, Refused> {
        let Some(isolators) = isolators else {
            return self.stiffnesses_of(0);
        };
        let above = self.stiffnesses_of(1)?;
        Ok(std::iter::once(isolators.stiffness_n_per_m).chain(above).collect())
    }

    /// Stiffness of every storey from this one on \[N/m\].
    fn stiffnesses_of(&self, first: usize) -> Result<Vec<f64>, Refused> {
        let storeys = &self.storeys[first..];
        if storeys.is_empty() {
            return Ok(Vec::new());
        }
        let given = storeys.iter().map(|one| one.stiffness_n_per_m);
        let Some(period) = self.period_s else {
            let stiffness = |(index, given): (usize, Option<f64>)| given.ok_or_else(|| no_stiffness(first + index));
            return given.enumerate().map(stiffness).collect();
        };
        let n_given = given.clone().flatten().count();
        if n_given != 0 && n_given != storeys.len() {
            let some = Refused::at("storeys").found("`stiffness_n_per_m` in some of them");
            return Err(some.allowed_is("in all or, with `period_s`, in none"));
        }
        let period = positive("period_s", period)?;
        let proportions: Vec<f64> = given.map(|given| given.unwrap_or(1.0)).collect();
        let mut all = Vec::new();
        for (index, (storey, proportion)) in storeys.iter().zip(&proportions).enumerate() {
            let index = first + index;
            let mass = positive(format!("storeys[{index}].mass_kg"), storey.mass_kg)?;
            let field = format!("storeys[{index}].stiffness_n_per_m");
            let stiffness = positive(field, *proportion)?;
            let one = undamped(mass, stiffness);
            all.extend(std::iter::repeat_n(one, storey.repeat));
        }
        let found = modes(&all).ok();
        let found = found.and_then(|modes| modes.first().map(Mode::period));
        let found = found.ok_or_else(|| {
            let unlike = Refused::at("storeys").found("masses and stiffnesses so unlike that their modes cannot be told");
            unlike.help("give like ones")
        })?;
        let factor = (found / period) * (found / period);
        Ok(proportions.iter().map(|one| factor * one).collect())
    }
}

fn no_stiffness(storey: usize) -> Refused {
    let none = Refused::at(format!("storeys[{storey}]"));
    none.found("no `stiffness_n_per_m`, which must be there, or the building's `period_s` instead")
        .help("add one of them")
}

/// Names the storey in a refusal of its columns, or of a field of them.
fn in_storey(storey: usize, refused: Refused) -> Refused {
    let field = refused.place().field.as_ref();
    let field = field.map_or_else(String::new, |field| format!(".{}", field.path()));
    refused.in_field(format!("storeys[{storey}]{field}"))
}

impl StoreyFile {
    fn storey(&self, stiffness: f64, isolators: Option<&Columns>) -> Result<Storey, Refused> {
        let words = ColumnsFile {
            yield_force_n: self.yield_force_n,
            yield_displacement_m: self.yield_displacement_m,
            yield_drift_ratio: self.yield_drift_ratio,
            hardening_ratio: self.hardening_ratio,
            bouc_wen: self.bouc_wen,
            friction_n: self.friction_n,
            height_m: self.height_m,
        };
        Ok(Storey {
            mass_kg: self.mass_kg,
            height_m: self.height_m,
            columns: isolators.map_or_else(|| words.columns(stiffness), |isolators| Ok(*isolators))?,
            capacities: Capacities {
                isolation_layer: isolators.map(|_| true).or(self.isolation_layer),
                isolator_damping_n_s_per_m: self.isolator_damping_n_s_per_m.or(isolators.map(|_| 0.0)),
                displacement_capacity_m: self.displacement_capacity_m,
                drift_capacity_ratio: self.drift_capacity_ratio,
                shear_capacity_n: self.shear_capacity_n,
                column_capacity_n: self.column_capacity_n,
                columns: self.columns,
                slab_depth_m: self.slab_depth_m,
                gravity_load_n: self.gravity_load_n,
            },
            initial_displacement_m: self.initial_displacement_m,
            initial_velocity_m_per_s: self.initial_velocity_m_per_s,
        })
    }
}

/// A storey without damping, from which modes are found.
fn undamped(mass: f64, stiffness: f64) -> SolverStorey<Elastic> {
    SolverStorey {
        mass,
        damping: 0.0,
        ground_damping: 0.0,
        column: Elastic { stiffness },
    }
}

impl Building {
    /// Returns an elastic building of equal storeys with these heights \[m\], this mass \[kg\], > 0, and this first natural period \[s\], >
    /// 0; `None` if they are out of range.
    pub(super) fn uniform(mass: f64, period: f64, damping: Damping, heights: &[Option<f64>]) -> Option<Self> {
        let storey = |height_m: &Option<f64>| StoreyFile {
            mass_kg: mass / heights.len() as f64,
            stiffness_n_per_m: None,
            yield_force_n: None,
            yield_displacement_m: None,
            yield_drift_ratio: None,
            hardening_ratio: None,
            bouc_wen: None,
            friction_n: None,
            height_m: *height_m,
            isolator: None,
            isolator_damping_n_s_per_m: None,
            displacement_capacity_m: None,
            isolation_layer: None,
            drift_capacity_ratio: None,
            shear_capacity_n: None,
            column_capacity_n: None,
            columns: None,
            slab_depth_m: None,
            gravity_load_n: None,
            initial_displacement_m: 0.0,
            initial_velocity_m_per_s: 0.0,
            repeat: 1,
        };
        let words = BuildingFile {
            name: "Unknown neighbour".into(),
            damping,
            period_s: Some(period),
            storeys: heights.iter().map(storey).collect(),
        };
        words.try_into().ok()
    }

    /// Natural modes of the elastic building, the slowest first; empty if a value is refused by the check of the building.
    pub fn modes(&self) -> Vec<Mode> {
        modes(&self.elastic()).unwrap_or_default()
    }

    /// The elastic storeys with their damping, from the ground up.
    fn elastic(&self) -> Vec<SolverStorey<Elastic>> {
        let storeys = self.storeys.iter().zip(self.dampings());
        let storey = |(storey, (damping, ground_damping)): (&Storey, (f64, f64))| SolverStorey {
            damping,
            ground_damping,
            ..undamped(storey.mass_kg, storey.columns.stiffness_n_per_m)
        };
        storeys.map(storey).collect()
    }

    /// Damping coefficients of every storey \[N·s/m\]: between its floor and the floor below, and of its floor against the ground.
    pub fn dampings(&self) -> Vec<(f64, f64)> {
        if let Some(isolators) = self.isolator_damping() {
            let factor = self.damping_above_isolators();
            let above = self.storeys[1..].iter().map(|one| (factor * one.columns.stiffness_n_per_m, 0.0));
            return std::iter::once((isolators, 0.0)).chain(above).collect();
        }
        // Finding modes takes time with the cube of the number of storeys.
        let damping = self.rayleigh();
        let of = |storey: &Storey| match damping {
            SolverDamping::Rayleigh { alpha, beta } => (beta * storey.columns.stiffness_n_per_m, alpha * storey.mass_kg),
            // One storey.
            SolverDamping::Ratio(_) => (damping.coefficient(storey.mass_kg, storey.columns.stiffness_n_per_m), 0.0),
        };
        self.storeys.iter().map(of).collect()
    }

    /// Viscous damping of the isolators \[N·s/m\]; `None` of a building without isolators' words, whose damping has no exception.
    pub fn isolator_damping(&self) -> Option<f64> {
        self.storeys.first()?.capacities.isolator_damping_n_s_per_m
    }

    /// Factor β of the damping above isolators, proportional to stiffness \[s\]: a ratio holds in the first mode of the building that is fixed
    /// above them.
    pub(super) fn damping_above_isolators(&self) -> f64 {
        match self.damping {
            Damping::Ratio(ratio) => {
                let above: Vec<_> = self.storeys[1..]
                    .iter()
                    .map(|one| undamped(one.mass_kg, one.columns.stiffness_n_per_m))
                    .collect();
                let first = modes(&above)
                    .ok()
                    .and_then(|modes| Some(modes.first()?.oscillation().angular_frequency));
                first.map_or(0.0, |omega| 2.0 * ratio / omega)
            }
            Damping::Rayleigh { beta_s, .. } => beta_s,
            // The check of a scene refuses them.
            Damping::TwoFrequencies { .. } | Damping::Modes { .. } => 0.0,
        }
    }

    /// Factor α of the damping that is proportional to mass \[1/s\]: dashpots between every floor and the ground; 0 for a building of one
    /// storey, whose damping is that of the storey.
    pub(crate) fn mass_damping(&self) -> f64 {
        if self.isolator_damping().is_some() {
            return 0.0;
        }
        match self.rayleigh() {
            SolverDamping::Rayleigh { alpha, .. } if self.storeys.len() > 1 => alpha,
            SolverDamping::Rayleigh { .. } | SolverDamping::Ratio(_) => 0.0,
        }
    }

    /// First period \[s\] of the building with these stiffnesses of its storeys \[N/m\], from the ground up.
    pub(crate) fn period_with(&self, stiffnesses: &[f64]) -> Option<f64> {
        let storeys = self.storeys.iter().zip(stiffnesses);
        let storeys: Vec<_> = storeys.map(|(one, stiffness)| undamped(one.mass_kg, *stiffness)).collect();
        modes(&storeys).ok()?.first().map(Mode::period)
    }

    /// The period \[s\] of the lowest storey under the rigid building, and how many times softer it is than the storey above, if it looks
    /// like isolators: softer than a fifth, with a period of 1.5 s or more by its stiffness after yielding.
    pub(crate) fn looks_isolated(&self) -> Option<(f64, f64)> {
        let [lowest, above, ..] = &self.storeys[..] else {
            return None;
        };
        let softer = above.columns.stiffness_n_per_m / lowest.columns.stiffness_n_per_m;
        let period = self.period_after_yielding(lowest);
        (softer > ISOLATORS_SOFTER && period >= ISOLATORS_PERIOD).then_some((period, softer))
    }

    /// The period \[s\] of the rigid building on its isolators by their stiffness after yielding, which bounds the effective one from above;
    /// `None` without isolators that are told.
    fn isolated_period(&self) -> Option<f64> {
        let lowest = self.storeys.first().filter(|one| one.capacities.isolation_layer == Some(true))?;
        Some(self.period_after_yielding(lowest))
    }

    fn period_after_yielding(&self, lowest: &Storey) -> f64 {
        let mass: f64 = self.storeys.iter().map(|one| one.mass_kg).sum();
        let after = lowest.columns.hardening_ratio.filter(|ratio| *ratio > 0.0).unwrap_or(1.0);
        2.0 * std::f64::consts::PI * (mass / (after * lowest.columns.stiffness_n_per_m)).sqrt()
    }

    /// Longest period that counts for spectra \[s\]: the first, or that on isolators that yield.
    pub(crate) fn longest_period(&self) -> Option<f64> {
        let first = self.modes().first().map(Mode::period)?;
        Some(self.isolated_period().map_or(first, |period| period.max(first)))
    }

    /// Whether its lowest storey is told to stand for isolators, or looks like them and is not told to be none.
    pub(crate) fn may_be_isolated(&self) -> bool {
        let told = self.storeys.first().and_then(|one| one.capacities.isolation_layer);
        told.unwrap_or_else(|| self.looks_isolated().is_some())
    }

    /// Rayleigh damping of all storeys; a damping ratio for a building of one storey.
    pub(super) fn rayleigh(&self) -> SolverDamping {
        let (of_modes, ratios) = match self.damping {
            Damping::Ratio(ratio) if self.storeys.len() > 1 => ([1, 2], [ratio, ratio]),
            Damping::Modes { modes, ratios, .. } => (modes, ratios),
            Damping::Ratio(_) | Damping::Rayleigh { .. } | Damping::TwoFrequencies { .. } => {
                return self.damping.to_solver();
            }
        };
        let storeys = self.storeys.iter();
        let storeys = storeys
            .map(|storey| undamped(storey.mass_kg, storey.columns.stiffness_n_per_m))
            .collect::<Vec<_>>();
        let all = modes(&storeys).unwrap_or_default();
        let mode = |number: usize| all.get(number.wrapping_sub(1));
        let found = mode(of_modes[0])
            .zip(mode(of_modes[1]))
            .and_then(|(one, other)| SolverDamping::rayleigh_from_modes([one, other], ratios).ok());
        // The check of a scene refuses modes that do not exist.
        found.unwrap_or(SolverDamping::Ratio(0.0))
    }
}
