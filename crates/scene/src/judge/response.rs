//! Responses of a run beyond the range of its model, or beyond the limits of codes.

use std::fmt::{self, Display, Formatter};

use pounding_text::{percent, short};

use crate::{RunResult, Simulation};

/// Drift of a storey of unknown height \[m\] that is more than 2.5 % of any usual height, at most 12 m.
const MOST_UNKNOWN: f64 = 0.3;

/// A response beyond the range of the model, or beyond the limits of codes.
#[derive(Debug, Clone, PartialEq)]
pub struct Excess {
    /// Kind of the response.
    pub kind: ExcessKind,
    /// Index of the floor in the row; the storey is the one below it.
    pub floor: usize,
    /// Name of the floor, or of the levels that are left out.
    pub name: String,
    /// Value, in the unit of the kind.
    pub found: f64,
    /// Number of runs with this kind, and number of all runs; `None` for a single run.
    pub often: Option<[usize; 2]>,
}

/// Kinds of responses that are judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ExcessKind {
    /// Upper bound of how far a floor and the neighbour's column beside it move together, beyond the gap \[m\].
    AtColumn,
    /// Upper bound of how far a floor and the neighbour's column beside it move together, if no contact gives the gap \[m\].
    BesideColumn,
    /// Upper bound of how far two floors of a level that a contact leaves out move together, beyond the gap \[m\].
    LeftOut,
    /// Drift of a storey of unknown height \[m\].
    Displacement,
    /// Stability coefficient P Δ/(V h) of a storey \[–\].
    Stability,
    /// Ratio of the drift to the height of the storey \[–\].
    Drift,
    /// Ratio of the drift to the drift at yielding \[–\].
    Ductility,
    /// Ratio of the drift at the end to the height of the storey \[–\].
    ResidualDrift,
}

impl Excess {
    /// Largest drift ratio that codes allow for ordinary buildings \[–\]: NBCC 2015, 4.1.8.13 (3).
    pub const MOST_DRIFT: f64 = 0.025;

    /// Largest ductility demand for which bilinear columns are meaningful \[–\]. A convention: ductile frames are designed for about 6 (NZS
    /// 1170.5).
    pub const MOST_DUCTILITY: f64 = 6.0;

    /// Drift ratio at the end of a run above which repair is hardly economical \[–\]: J. McCormick, H. Aburano, M. Ikenaga and M.
    /// Nakashima, 14th World Conf. Earthquake Engng (2008).
    pub const MOST_RESIDUAL: f64 = 0.005;

    /// Stability coefficients \[–\]: gravity matters above the first one, and a building is unstable above the second one. EN 1998-1,
    /// 4.4.2.2 (2), and ASCE 7-16, 12.8.7.
    pub const MOST_STABILITY: [f64; 2] = [0.1, 0.25];

    /// Gathers responses over several runs, the most harmful kind first: the worst of every kind, and the number of runs with it.
    pub fn gathered(runs: impl IntoIterator<Item: AsRef<[Self]>>) -> Vec<Self> {
        let mut all = Vec::new();
        let mut of = 0;
        for run in runs {
            all.extend_from_slice(run.as_ref());
            of += 1;
        }
        let mut worst = Self::worst(all.clone());
        for one in &mut worst {
            let of_kind = all.iter().filter(|other| other.kind == one.kind);
            one.often = Some([of_kind.count(), of]);
        }
        worst
    }

    /// Returns the worst response of every kind, the most harmful kind first; of equal ones the first.
    fn worst(mut all: Vec<Self>) -> Vec<Self> {
        all.sort_by(|one, other| {
            let by_kind = one.kind.cmp(&other.kind);
            by_kind.then(other.found.total_cmp(&one.found))
        });
        all.dedup_by_key(|one| one.kind);
        all
    }

    /// Describes the response in a few words.
    pub fn brief(&self) -> String {
        let colon = if self.kind.is_unwatched() { "" } else { ":" };
        let limit = match self.kind {
            ExcessKind::Displacement => ", above 0.3 m",
            ExcessKind::Drift => ", above 2.5 %",
            ExcessKind::Ductility => ", above 6",
            ExcessKind::AtColumn | ExcessKind::BesideColumn | ExcessKind::LeftOut | ExcessKind::Stability | ExcessKind::ResidualDrift => "",
        };
        let brief = self.kind.brief(self.found);
        let often = self.often();
        let comma = if often.is_empty() { "" } else { ", " };
        format!("{}{colon} {brief}{limit}{comma}{often}", self.name)
    }

    /// Writes "in 4 of 4 runs"; empty for a single run.
    fn often(&self) -> String {
        self.often.map_or_else(String::new, |[n, of]| format!("in {n} of {of} runs"))
    }
}

impl Simulation {
    /// Returns the responses of a run beyond its model or beyond the limits of codes, each at the worst floor of its kind, the most harmful
    /// kind first.
    pub fn excesses(&self, result: &RunResult) -> Vec<Excess> {
        let floors = self.floors();
        let mut all = self.unwatched(result);
        for (floor, one) in floors.all().iter().enumerate() {
            let judged = self.judged(result, floor).into_iter();
            let beyond = judged.filter(|(kind, found)| *found > kind.most());
            all.extend(beyond.map(|(kind, found)| Excess {
                kind,
                floor,
                name: one.name.clone(),
                found,
                often: None,
            }));
        }
        let mut worst = Excess::worst(all);
        for one in &mut worst {
            if one.kind == ExcessKind::LeftOut {
                let levels = floors.left_out(floors.all()[one.floor].structure);
                one.name = levels.unwrap_or_default();
            }
        }
        worst
    }

    /// Largest drift or ductility of a run over its limit, and its place. Directions of shaking are compared by it.
    pub fn strain(&self, result: &RunResult) -> Option<(f64, Excess)> {
        let floors = 0..self.floors().all().len();
        let all = floors.flat_map(|floor| {
            let judged = self.judged(result, floor).into_iter();
            judged.map(move |(kind, found)| (found / kind.most(), kind, found, floor))
        });
        let strains = all.filter(|(share, kind, ..)| kind.strains() && share.is_finite());
        let (share, kind, found, floor) = strains.max_by(|one, other| one.0.total_cmp(&other.0))?;
        let name = self.floors().all()[floor].name.clone();
        Some((
            share,
            Excess {
                kind,
                floor,
                name,
                found,
                often: None,
            },
        ))
    }

    fn judged(&self, result: &RunResult, floor: usize) -> Vec<(ExcessKind, f64)> {
        let floors = self.floors();
        let one = &floors.all()[floor];
        let Some(made_of) = one.made_of else {
            return Vec::new();
        };
        let peaks = result.peaks.of(floor);
        let drift = peaks.drift().value.abs();
        let below = floors.below(floor).map_or(0.0, |below| result.last.of(below).displacement);
        let residual = result.last.of(floor).displacement - below;
        let mut all = Vec::new();
        all.extend(one.ductility(drift).map(|found| (ExcessKind::Ductility, found)));
        let Some(height) = made_of.height_m else {
            all.push((ExcessKind::Displacement, drift));
            return all;
        };
        let above = floors.of_structure(one.structure).iter();
        let above = above.filter(|other| floors.storey_of(**other) >= floors.storey_of(floor));
        let masses = above.filter_map(|other| floors.all()[*other].made_of).map(|made| made.mass_kg);
        let weight = self.scene().record.gravity_m_per_s2 * masses.sum::<f64>();
        let shear = peaks.restoring_force.value.abs();
        all.push((ExcessKind::Drift, drift / height));
        all.push((ExcessKind::Stability, weight * drift / (shear * height)));
        if one.can_yield() {
            all.push((ExcessKind::ResidualDrift, residual.abs() / height));
        }
        all
    }
}

impl ExcessKind {
    /// Limit of the kind.
    fn most(self) -> f64 {
        match self {
            Self::AtColumn | Self::BesideColumn | Self::LeftOut => 0.0,
            Self::Displacement => MOST_UNKNOWN,
            Self::Stability => Excess::MOST_STABILITY[0],
            Self::Drift => Excess::MOST_DRIFT,
            Self::Ductility => Excess::MOST_DUCTILITY,
            Self::ResidualDrift => Excess::MOST_RESIDUAL,
        }
    }

    /// Whether it is a drift, alone or over the drift at yielding. Effects of gravity and residual drifts follow from drifts.
    fn strains(self) -> bool {
        match self {
            Self::Displacement | Self::Drift | Self::Ductility => true,
            Self::AtColumn | Self::BesideColumn | Self::LeftOut | Self::Stability | Self::ResidualDrift => false,
        }
    }

    /// Whether something may touch without a contact in the model: a column, or floors of a level that is left out.
    pub fn is_unwatched(self) -> bool {
        matches!(self, Self::AtColumn | Self::BesideColumn | Self::LeftOut)
    }

    /// Whether an answer about gaps depends on it. Stability and residual drift do not count: both are estimates beyond the model.
    pub fn is_caution(self) -> bool {
        self.strains() || self.is_unwatched()
    }

    /// Describes a value of this kind in a few words.
    pub fn brief(self, found: f64) -> String {
        match self {
            Self::AtColumn => "may hit a column, which is not modelled".into(),
            Self::BesideColumn => "stands beside a column, which is not modelled".into(),
            Self::LeftOut => "may touch, and were not looked at".into(),
            Self::Displacement => format!("drift of {} mm", short(1e3 * found)),
            Self::Stability => format!("stability coefficient of {}", short(found)),
            Self::Drift => format!("drift of {}", percent(found)),
            Self::Ductility => format!("ductility of {}", short(found)),
            Self::ResidualDrift => format!("{} of drift left", percent(found)),
        }
    }

    /// Describes a value of this kind in a sentence; `often` is the number of runs with it.
    fn says(self, found: f64, often: &str) -> String {
        let [often, worst] = if often.is_empty() {
            [String::new(), String::new()]
        } else {
            [format!("{often} "), format!("{often}, at worst ")]
        };
        match self {
            Self::AtColumn | Self::BesideColumn => format!(
                "faces columns of its neighbour between floors; {often}both together may move up to {} mm{}: a floor that hits a column can \
                 bring a building down, and is not modelled",
                short(1e3 * found),
                if self == Self::AtColumn { " farther than the gap" } else { "" }
            ),
            Self::LeftOut => format!(
                "not looked at, because `levels` of the contact leaves them out; {often}both neighbours together may move up to {} mm farther \
                 than the gap",
                short(1e3 * found)
            ),
            Self::Displacement => format!(
                "{worst}drift of {} m: more than 2.5 % of any usual storey; give height_m, and look at the scale of the record",
                short(found)
            ),
            Self::Stability if found > Excess::MOST_STABILITY[1] => format!(
                "{worst}stability coefficient P Δ/(V h) = {}, above 0.25 (ASCE 7-16, 12.8.7): gravity, which the model leaves out, would bring the \
                 storey down",
                short(found)
            ),
            Self::Stability => format!(
                "{worst}stability coefficient P Δ/(V h) = {}, above 0.1 (EN 1998-1, 4.4.2.2): gravity, which the model leaves out, adds to the drift",
                short(found)
            ),
            Self::Drift => format!(
                "{worst}drift of {} of the storey height, above 2.5 % (NBCC 2015, 4.1.8.13): columns that lose strength, which the model leaves out, \
                 decide",
                percent(found)
            ),
            Self::Ductility => format!(
                "{worst}ductility demand of {}, above 6: columns lose strength, which the model leaves out",
                short(found)
            ),
            Self::ResidualDrift => format!(
                "{worst}drift of {} of the storey height left at the end, above 0.5 % (McCormick et al. 2008): repair hardly pays",
                percent(found)
            ),
        }
    }
}

impl Display for Excess {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        let said = self.kind.says(self.found, &self.often());
        write!(to, "{}: {said}", self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A structure that starts at a displacement without shaking exceeds a limit, or does not.
    fn excesses(height: Option<f64>, displacement: f64, yields: Option<f64>) -> Vec<(ExcessKind, f64)> {
        let mut structure = serde_json::json!({
            "name": "one", "mass_kg": 1e5, "stiffness_n_per_m": 1e7, "damping": {"ratio": 0.0},
            "initial_displacement_m": displacement,
        });
        if let Some(height) = height {
            structure["height_m"] = height.into();
        }
        if let Some(force) = yields {
            structure["yield_force_n"] = force.into();
        }
        let scene = serde_json::json!({
            "name": "still",
            "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 0.0, "duration_s": 0.4, "time_step_s": 0.01}}},
            "duration_s": 2.0,
            "structures": [{"sdof": structure}, "wall"],
        });
        let scene = serde_json::from_value(scene).expect("a scene");
        let simulation = Simulation::new(&scene, "").expect("it is sound");
        let result = simulation.run(None).expect("it runs");
        let all = simulation.excesses(&result);
        all.into_iter().map(|one| (one.kind, one.found)).collect()
    }

    fn are(found: &[(ExcessKind, f64)], wanted: &[(ExcessKind, f64)]) {
        let close = |(one, other): (&(ExcessKind, f64), &(ExcessKind, f64))| one.0 == other.0 && (one.1 / other.1 - 1.0).abs() < 1e-9;
        assert!(
            found.len() == wanted.len() && found.iter().zip(wanted).all(close),
            "{found:?} {wanted:?}"
        );
    }

    /// An elastic structure has θ = m g/(k h) whatever its drift, 0.0981 for a height of 1 m and 0.1226 for one of 0.8 m.
    #[test]
    fn reference_drift_and_stability() {
        are(&excesses(Some(1.0), 0.024, None), &[]);
        are(&excesses(Some(1.0), 0.026, None), &[(ExcessKind::Drift, 0.026)]);
        let theta = 1e5 * 9.80665 / (1e7 * 0.8);
        are(&excesses(Some(0.8), 0.01, None), &[(ExcessKind::Stability, theta)]);
        assert!(ExcessKind::Stability.says(0.2, "").contains("EN 1998-1"));
        assert!(ExcessKind::Stability.says(0.3, "").contains("ASCE 7-16"));
    }

    /// The lower of two equal storeys carries both floors: θ = 2 m g/(k h). The upper storey has half of it.
    #[test]
    fn reference_a_storey_carries_the_floors_above() {
        let storey = serde_json::json!({"mass_kg": 1e5, "stiffness_n_per_m": 1e7, "height_m": 1.2, "initial_displacement_m": 0.001});
        let scene = serde_json::json!({
            "name": "still",
            "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 0.0, "duration_s": 0.4, "time_step_s": 0.01}}},
            "structures": [{"building": {"name": "two", "damping": {"ratio": 0.0}, "storeys": [storey, storey]}}, "wall"],
        });
        let scene = serde_json::from_value(scene).expect("a scene");
        let simulation = Simulation::new(&scene, "").expect("it is sound");
        let result = simulation.run(None).expect("it runs");
        let all = simulation.excesses(&result);
        let theta = 2.0 * 1e5 * 9.80665 / (1e7 * 1.2);
        assert!(all.len() == 1 && all[0].floor == 0, "{all:?}");
        assert!((all[0].found / theta - 1.0).abs() < 1e-9, "{all:?}");
    }

    /// The drift itself is judged if the height is unknown.
    #[test]
    fn reference_unknown_heights() {
        are(&excesses(None, 0.29, None), &[]);
        are(&excesses(None, 0.31, None), &[(ExcessKind::Displacement, 0.31)]);
    }

    /// Columns that start at six times their yield drift stay within the limit, those that start at seven times do not.
    #[test]
    fn reference_ductility() {
        let of = |times: f64| excesses(Some(10.0), 1e-3 * times, Some(1e4));
        are(&of(5.9), &[]);
        are(&of(7.0), &[(ExcessKind::Ductility, 7.0)]);
    }
}
