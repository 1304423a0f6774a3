//! Links between floors, as files give them: springs, dampers and restrainers.

use pounding_solver::{Braced, LinkFault, LinkLaw, Restrainer, Spring, Viscous};
use pounding_text::{Refused, plain};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choice::{self, Choice};
use crate::{Scene, Structure};

/// A link between two floors, or between a floor and the ground or a wall.
///
/// It pulls or pushes along the row. Its deformation is the displacement of its left end minus that of its right end.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Link {
    /// The two ends, in any order.
    #[schemars(length(equal = 2))]
    pub between: [End; 2],
    /// On which side the first end is, if the row does not tell: to the ground, or inside a building. It decides what elongation is.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "choice::maybe")]
    pub side: Option<Side>,
    /// The law of its force.
    #[serde(deserialize_with = "choice::one")]
    pub law: Law,
}

/// An end of a link.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct End {
    /// The structure or wall: its name, or its place in the row, from 1.
    pub structure: OfRow,
    /// The floor, from 1 for the lowest; 0 for the ground below the structure. The highest floor by default; a wall has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub floor: Option<usize>,
}

/// A structure of a row, by name or by place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum OfRow {
    /// Its place in the row, from 1 on the left.
    Place(usize),
    /// Its name.
    Name(String),
}

/// A side of a link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// The left.
    Left,
    /// The right.
    Right,
}

impl Choice for Side {}

/// The law of a link.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Law {
    /// A spring, with a dashpot beside it if it has damping. With a yield force it is a friction damper, or a steel damper that hardens.
    Spring {
        /// Stiffness \[N/m\], > 0.
        stiffness_n_per_m: f64,
        /// Force at which it yields or slides \[N\], > 0; elastic by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        yield_force_n: Option<f64>,
        /// Ratio of the stiffness after yielding to that before \[–\], 0 to less than 1; 0 by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        hardening_ratio: Option<f64>,
        /// Coefficient of a dashpot beside the spring \[N·s/m\], ≥ 0; none by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        damping_n_s_per_m: Option<f64>,
    },
    /// A linear viscous damper.
    Dashpot {
        /// Coefficient \[N·s/m\], ≥ 0.
        damping_n_s_per_m: f64,
    },
    /// A linear viscous damper with its brace: spring and dashpot in series.
    Maxwell {
        /// Stiffness of the brace \[N/m\], > 0.
        stiffness_n_per_m: f64,
        /// Coefficient of the damper \[N·s/m\], > 0.
        damping_n_s_per_m: f64,
    },
    /// A viscous damper F = c |v|^α with its brace.
    Viscous {
        /// Coefficient c \[N·(s/m)^α\], > 0.
        coefficient: f64,
        /// Exponent α \[–\], > 0; with a brace 1/α is a whole number up to 10, as for 0.5, 0.25 or 0.2.
        exponent: f64,
        /// Stiffness of the brace \[N/m\], > 0. Without it the exact method refuses the damper.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        brace_stiffness_n_per_m: Option<f64>,
    },
    /// A restrainer: it pulls once its slack is used up, and may yield; plastic elongation adds to the slack.
    Restrainer {
        /// Stiffness \[N/m\], > 0.
        stiffness_n_per_m: f64,
        /// Elongation without a force \[m\], ≥ 0; 0 by default.
        #[serde(default)]
        slack_m: f64,
        /// Pull at which it yields \[N\], > 0; elastic by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        yield_force_n: Option<f64>,
    },
}

impl Choice for Law {
    const EXAMPLES: &'static [&'static str] = &[
        r#"{"spring": {"stiffness_n_per_m": 1e8, "yield_force_n": 2e5}}"#,
        r#"{"dashpot": {"damping_n_s_per_m": 3e6}}"#,
        r#"{"maxwell": {"stiffness_n_per_m": 5e7, "damping_n_s_per_m": 3e6}}"#,
        r#"{"viscous": {"coefficient": 6e5, "exponent": 0.5, "brace_stiffness_n_per_m": 1e8}}"#,
        r#"{"restrainer": {"stiffness_n_per_m": 4e7, "slack_m": 0.02, "yield_force_n": 1.6e6}}"#,
    ];
}

/// Largest distance of 1/α from a whole number.
const WHOLE: f64 = 1e-9;

impl Law {
    /// Name in files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Spring { .. } => "spring",
            Self::Dashpot { .. } => "dashpot",
            Self::Maxwell { .. } => "maxwell",
            Self::Viscous { .. } => "viscous",
            Self::Restrainer { .. } => "restrainer",
        }
    }

    /// Whether push and pull differ, so that it matters which end is on the left.
    pub fn has_sides(&self) -> bool {
        matches!(self, Self::Restrainer { .. })
    }

    /// The law for the solver.
    ///
    /// # Errors
    /// [`Refused`] if 1/α of a damper with a brace is no whole number.
    pub fn for_solver(&self) -> Result<LinkLaw, Refused> {
        let spring = |stiffness, damping| Spring {
            stiffness,
            yield_force: f64::INFINITY,
            hardening: 0.0,
            damping,
        };
        Ok(match *self {
            Self::Spring {
                stiffness_n_per_m,
                yield_force_n,
                hardening_ratio,
                damping_n_s_per_m,
            } => LinkLaw::Spring(Spring {
                yield_force: yield_force_n.unwrap_or(f64::INFINITY),
                hardening: hardening_ratio.unwrap_or(0.0),
                ..spring(stiffness_n_per_m, damping_n_s_per_m.unwrap_or(0.0))
            }),
            Self::Dashpot { damping_n_s_per_m } => LinkLaw::Spring(spring(0.0, damping_n_s_per_m)),
            Self::Maxwell {
                stiffness_n_per_m,
                damping_n_s_per_m,
            } => LinkLaw::Braced(Braced {
                stiffness: stiffness_n_per_m,
                coefficient: damping_n_s_per_m,
                inverse_exponent: 1,
            }),
            Self::Viscous {
                coefficient,
                exponent,
                brace_stiffness_n_per_m: None,
            } => LinkLaw::Viscous(Viscous { coefficient, exponent }),
            Self::Viscous {
                coefficient,
                exponent,
                brace_stiffness_n_per_m: Some(stiffness),
            } => LinkLaw::Braced(Braced {
                stiffness,
                coefficient,
                inverse_exponent: inverse(exponent)?,
            }),
            Self::Restrainer {
                stiffness_n_per_m,
                slack_m,
                yield_force_n,
            } => LinkLaw::Restrainer(Restrainer {
                stiffness: stiffness_n_per_m,
                yield_force: yield_force_n.unwrap_or(f64::INFINITY),
                slack: slack_m,
            }),
        })
    }

    /// The word of a number of the solver's law.
    fn word(&self, field: &'static str) -> &'static str {
        match (self, field) {
            (Self::Viscous { .. }, "stiffness") => "brace_stiffness_n_per_m",
            (Self::Viscous { .. }, "inverse_exponent") => "exponent",
            (_, "stiffness") => "stiffness_n_per_m",
            (_, "yield_force") => "yield_force_n",
            (_, "hardening") => "hardening_ratio",
            (Self::Maxwell { .. }, "coefficient") | (_, "damping") => "damping_n_s_per_m",
            (_, "slack") => "slack_m",
            (_, other) => other,
        }
    }
}

/// 1/α of a damper with a brace.
fn inverse(exponent: f64) -> Result<u32, Refused> {
    let inverse = 1.0 / exponent;
    let whole = inverse.round();
    if (1.0..=10.0).contains(&whole) && (inverse - whole).abs() <= WHOLE * whole {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number from 1 to 10")]
        return Ok(whole as u32);
    }
    let found = Refused::at("law.viscous.exponent").found(plain(exponent));
    Err(found
        .allowed("1/n with a whole number n from 1 to 10, such as 0.5, 0.25 or 0.2")
        .help("take the nearest one, or leave the brace out and integrate by the method rk4"))
}

/// Where an end of a link is in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Standing {
    /// Index of its structure.
    pub structure: usize,
    /// Its floor, from 0 for the lowest; `None` for the ground.
    pub floor: Option<usize>,
}

impl Link {
    /// The ends in the row, the left one first.
    ///
    /// # Errors
    /// [`Refused`] if the row does not have them, or if it is not told which one is on the left.
    pub fn ends(&self, scene: &Scene) -> Result<[Standing; 2], Refused> {
        let [first, second] = [0, 1].map(|end| self.between[end].stands(scene, &format!("between[{end}]")));
        let (first, second) = (first?, second?);
        let told = self.side.map(|side| side == Side::Left);
        let by_place = first.structure != second.structure;
        if by_place && told.is_some_and(|left| left != (first.structure < second.structure)) {
            let found = Refused::at("side").found("a side against the order of the row");
            return Err(found.allowed("that of the first end in the row").help("delete `side`"));
        }
        if !by_place && told.is_none() && self.law.has_sides() {
            let found = Refused::at("side").found("none, and the row does not tell which end is on the left");
            return Err(found.allowed("\"left\" or \"right\", for the first of `between`"));
        }
        let is_left = if by_place {
            first.structure < second.structure
        } else {
            told.unwrap_or(true)
        };
        Ok(if is_left { [first, second] } else { [second, first] })
    }

    /// Refuses a link that cannot be modelled.
    pub(super) fn check(&self, scene: &Scene) -> Result<(), Refused> {
        let [left, right] = self.ends(scene)?;
        let is_fixed = |end: Standing| end.floor.is_none() || matches!(scene.structures[end.structure], Structure::Wall);
        if left == right || (is_fixed(left) && is_fixed(right)) {
            let found = Refused::at("between").found("two ends that cannot move against each other");
            return Err(found.allowed("two floors, or a floor and the ground or a wall"));
        }
        if let Law::Spring { stiffness_n_per_m, .. } = self.law
            && (stiffness_n_per_m.is_nan() || stiffness_n_per_m <= 0.0)
        {
            let found = Refused::at("law.spring.stiffness_n_per_m").found(plain(stiffness_n_per_m));
            return Err(found
                .allowed("a finite number > 0")
                .help("a damper without a spring is a `dashpot`"));
        }
        self.law.for_solver()?.check().map_err(|LinkFault { field, found, allowed }| {
            let place = format!("law.{}.{}", self.law.name(), self.law.word(field));
            Refused::at(place).found(plain(found)).allowed(allowed)
        })
    }

    /// Both ends in words, the left one first.
    pub fn names(&self, scene: &Scene) -> [String; 2] {
        let name = |Standing { structure, floor }| {
            let structure = &scene.structures[structure];
            match (structure, floor) {
                (Structure::Wall, _) => structure.name().to_owned(),
                (_, None) => "the ground".to_owned(),
                (Structure::Building(building), Some(floor)) if building.storeys.len() > 1 => {
                    format!("{}, floor {}", building.name, floor + 1)
                }
                (_, Some(_)) => structure.name().to_owned(),
            }
        };
        self.ends(scene)
            .map_or_else(|_| [String::new(), String::new()], |ends| ends.map(name))
    }
}

impl End {
    fn stands(&self, scene: &Scene, place: &str) -> Result<Standing, Refused> {
        let structure = self.structure.place(scene).map_err(|refused| refused.inside(place))?;
        let n_floors = match &scene.structures[structure] {
            Structure::Building(building) => building.storeys.len(),
            Structure::Sdof(_) | Structure::Wall => 1,
        };
        let floor = self.floor.unwrap_or(n_floors);
        if floor > n_floors {
            let found = Refused::at(format!("{place}.floor")).found(floor.to_string());
            return Err(found.allowed(format!("0 for the ground, to {n_floors} for the highest floor")));
        }
        Ok(Standing {
            structure,
            floor: floor.checked_sub(1),
        })
    }
}

impl OfRow {
    /// Place of the structure in the row, from 0.
    fn place(&self, scene: &Scene) -> Result<usize, Refused> {
        let n = scene.structures.len();
        let refused = |found: String, allowed: String| Refused::at("structure").found(found).allowed(allowed);
        match self {
            Self::Place(place) if (1..=n).contains(place) => Ok(place - 1),
            Self::Place(place) => Err(refused(place.to_string(), format!("a name, or a place from 1 to {n}"))),
            Self::Name(name) => {
                let named = |(index, structure): (usize, &Structure)| (structure.name() == name).then_some(index);
                let mut found = scene.structures.iter().enumerate().filter_map(named);
                match (found.next(), found.next()) {
                    (Some(place), None) => Ok(place),
                    (None, _) => {
                        let names = scene.structures.iter().map(|one| format!("\"{}\"", one.name()));
                        let names = names.collect::<Vec<_>>().join(", ");
                        Err(refused(format!("\"{name}\""), format!("one of {names}, or a place from 1 to {n}")))
                    }
                    (Some(_), Some(_)) => Err(refused(
                        format!("\"{name}\", the name of several structures"),
                        format!("the place in the row, from 1 to {n}"),
                    )),
                }
            }
        }
    }
}
