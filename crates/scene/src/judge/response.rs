//! Responses of a run beyond the range of its model, or beyond the limits of codes.

use pounding_text::{digits, percent, short};

use super::excess_kind::ExcessKind;
use crate::{RunResult, Simulation, Structure};

/// A response beyond the range of the model, or beyond the limits of codes.
#[derive(Debug, Clone, PartialEq)]
pub struct Excess {
    /// Kind of the response.
    pub kind: ExcessKind,
    /// Index of the floor in the row; the storey is the one below it.
    pub floor: usize,
    /// Name of the storey, of a floor that may touch, or of the levels that are left out.
    pub name: String,
    /// Value, in the unit of the kind.
    pub found: f64,
    /// Capacity that the scene gives in place of the general limit, in the unit of the kind.
    pub capacity: Option<f64>,
    /// How often responses of this kind occur; `None` for a single run.
    pub often: Option<Often>,
}

/// How often responses of a kind occur.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Often {
    /// Number of samples with such a response.
    pub n: usize,
    /// Number of samples.
    pub of: usize,
    /// Word for a sample, such as "run".
    pub sample: &'static str,
}

impl Excess {
    /// Limit that it exceeds, in the unit of its kind.
    fn limit(&self) -> f64 {
        self.capacity.unwrap_or(self.kind.most())
    }

    /// The response over its limit, or itself if the limit is 0. The larger of two of a kind is the worse. Nothing is worse than a collapse.
    pub fn share(&self) -> f64 {
        if self.kind == ExcessKind::Collapse {
            return f64::MAX;
        }
        let limit = self.limit();
        if limit > 0.0 { self.found / limit } else { self.found }
    }

    /// Whether a limit belongs to it: a column without a capacity has none.
    pub fn is_judged(&self) -> bool {
        self.kind != ExcessKind::ColumnHit || self.capacity.is_some()
    }

    /// Whether an answer about gaps depends on it: by its kind, or because no building bears a base shear of its whole weight.
    pub fn is_caution(&self) -> bool {
        self.kind.is_caution() || (self.kind == ExcessKind::BaseShear && self.found >= 1.0)
    }

    /// Describes the response in a few words.
    pub fn brief(&self) -> String {
        let colon = if self.kind.is_unwatched() { "" } else { ":" };
        let limit = match (self.kind.bound(), self.capacity) {
            _ if self.found <= self.limit() => String::new(),
            (_, Some(capacity)) if [ExcessKind::Shear, ExcessKind::ColumnHit].contains(&self.kind) => {
                format!(", above its capacity of {} kN", short(1e-3 * capacity))
            }
            (_, Some(capacity)) if self.kind == ExcessKind::Displacement => format!(", above its capacity of {} mm", short(1e3 * capacity)),
            (_, Some(capacity)) => format!(", above its capacity of {}", percent(capacity)),
            (bound, None) => bound.into(),
        };
        let often = self.often();
        if self.kind == ExcessKind::BaseShear && !often.is_empty() {
            // The number of samples is that above the limit, far below the worst of them.
            return format!(
                "{}: shear force of up to {:.1} times the weight above; above {} times {often}",
                self.name,
                self.found,
                digits(self.limit())
            );
        }
        let brief = self.kind.brief(self.found);
        let comma = if often.is_empty() { "" } else { ", " };
        format!("{}{colon} {brief}{limit}{comma}{often}", self.name)
    }

    /// Writes "in 4 of 4 runs"; empty for a single run.
    pub(super) fn often(&self) -> String {
        self.often.map_or_else(String::new, |Often { n, of, sample }| {
            let s = if of == 1 { "" } else { "s" };
            format!("in {n} of {of} {sample}{s}")
        })
    }
}

/// Share of a response without a capacity to compare with that may bring a building down: above all that are judged.
const UNJUDGED: f64 = 1e6;

/// A response of a storey, whether or not it exceeds its limit.
type Judged = (ExcessKind, f64, Option<f64>);

impl Simulation {
    /// Returns the responses of a run beyond its model or beyond the limits of codes, each at the worst floor of its kind, the most harmful
    /// kind first.
    pub fn excesses(&self, result: &RunResult) -> Vec<Excess> {
        Excess::worst(self.all_excesses(result))
    }

    /// Returns the responses of a run beyond its model or beyond the limits of codes, of every floor: what several runs are
    /// [gathered](Excess::gathered) from.
    pub fn all_excesses(&self, result: &RunResult) -> Vec<Excess> {
        let floors = self.floors();
        let dampers = self.damper_forces(result);
        let mut all = self.unwatched(result);
        for one in all.iter_mut().filter(|one| one.kind == ExcessKind::LeftOut) {
            let levels = floors.left_out(floors.all()[one.floor].structure);
            one.name = levels.unwrap_or_default();
        }
        all.extend(self.columns_hit(result));
        for floor in 0..floors.all().len() {
            let dampers = self.judged_damping(result, floor, dampers.get(floor).copied());
            let judged = self.judged(result, floor).into_iter().chain(dampers);
            let judged = judged.map(|one| self.excess(floor, one));
            all.extend(judged.filter(|one| one.found > one.limit()));
        }
        all
    }

    /// Returns the drift or force of every structure that is farthest above a capacity that the scene gives, of those above one.
    pub fn over_capacity(&self, result: &RunResult) -> Vec<Excess> {
        let floors = self.floors();
        let structures = 0..self.scene().structures.len();
        let worst = structures.filter_map(|structure| {
            let own = self.floors().of_structure(structure).iter();
            let all = own.flat_map(|floor| self.judged(result, *floor).into_iter().map(|one| self.excess(*floor, one)));
            // The wall of a moat stops isolators: what they would do alone is no capacity that no gap helps.
            let told = all.filter(|one| one.capacity.is_some() && one.share() > 1.0 && !floors.all()[one.floor].is_isolation_layer());
            told.max_by(|one, other| one.share().total_cmp(&other.share()))
        });
        worst.collect()
    }

    /// Columns that slabs hit, unless they bear the shear force.
    fn columns_hit(&self, result: &RunResult) -> Vec<Excess> {
        let floors = self.floors();
        let pairs = floors.facing().iter().enumerate();
        let hit = pairs.filter_map(|(pair, facing)| {
            let column = floors.column_of(facing)?;
            let [shear, _] = column.forces()?;
            let found = result.of_pair(pair);
            found.first?;
            let shear = found.peak_force.map(|peak| shear * peak.value);
            let capacity = floors.all()[column.above].made_of?.capacities.column_capacity_n;
            let bears = shear.zip(capacity).is_some_and(|(shear, capacity)| shear <= capacity);
            (!bears).then(|| Excess {
                kind: ExcessKind::ColumnHit,
                floor: column.above,
                name: floors.column_name(column),
                found: shear.unwrap_or(0.0),
                capacity,
                often: None,
            })
        });
        let mut hit: Vec<Excess> = hit.collect();
        // Those above a capacity of the scene are told apart from those without one.
        for told in [true, false] {
            let n = hit.iter().filter(|one| one.capacity.is_some() == told).count();
            for one in hit.iter_mut().filter(|one| n > 1 && one.capacity.is_some() == told) {
                one.name = format!("{} (the hardest of {n})", one.name);
            }
        }
        hit
    }

    fn excess(&self, floor: usize, (kind, found, capacity): Judged) -> Excess {
        let one = &self.floors().all()[floor];
        let is_lowest = self.floors().below(floor).is_none();
        let of_structure = kind == ExcessKind::MassDamping || (kind == ExcessKind::BaseShear && is_lowest);
        let name = if of_structure {
            self.scene().structures[one.structure].name().into()
        } else {
            self.floors().storey_name(floor)
        };
        Excess {
            kind,
            floor,
            name,
            found,
            capacity,
            often: None,
        }
    }

    /// Largest drift, ductility or shear force of a run over its limit, and its place. Directions of shaking are compared by it.
    pub fn strain(&self, result: &RunResult) -> Option<(f64, Excess)> {
        let floors = 0..self.floors().all().len();
        let all = floors.flat_map(|floor| self.judged(result, floor).into_iter().map(move |one| (floor, one)));
        let all = all.filter(|(_, (kind, ..))| kind.strains());
        let all = all.map(|(floor, one)| self.excess(floor, one));
        let strains = all.map(|one| (one.share(), one)).filter(|(share, _)| share.is_finite());
        let columns = self.columns_hit(result).into_iter().map(|one| {
            let share = if one.is_judged() { one.share() } else { UNJUDGED + one.found };
            (share, one)
        });
        let strains = strains.chain(columns);
        strains.max_by(|one, other| one.0.total_cmp(&other.0))
    }

    /// Responses of a storey. Of one that falls only its collapse and capacities are judged: the rest is that of the fall.
    fn judged(&self, result: &RunResult, floor: usize) -> Vec<Judged> {
        let floors = self.floors();
        let one = &floors.all()[floor];
        let Some(made_of) = one.made_of else {
            return Vec::new();
        };
        let peaks = result.peaks.of(floor);
        let (drift, shear) = (peaks.drift().value.abs(), peaks.column_force().value.abs());
        let told = made_of.capacities;
        let ratio = made_of.height_m.map(|height| drift / height);
        let mut all = Vec::new();
        let collapse = result.collapse.filter(|one| one.floor == floor);
        let falls = collapse.is_some();
        all.extend(collapse.and(ratio).map(|ratio| (ExcessKind::Collapse, ratio, None)));
        all.extend(told.shear_capacity_n.map(|capacity| (ExcessKind::Shear, shear, Some(capacity))));
        all.extend(
            told.displacement_capacity_m
                .map(|capacity| (ExcessKind::Displacement, drift, Some(capacity))),
        );
        if let Some((ratio, capacity)) = ratio.zip(told.drift_capacity_ratio) {
            all.push((ExcessKind::Drift, ratio, Some(capacity)));
        } else if !falls && !one.is_isolation_layer() {
            let of_storey = ratio.filter(|_| !floors.is_bridge());
            all.extend(of_storey.map(|ratio| (ExcessKind::Drift, ratio, None)));
            all.extend(one.ductility(drift).map(|found| (ExcessKind::Ductility, found, None)));
        }
        if falls || one.is_isolation_layer() {
            return all;
        }
        if told.shear_capacity_n.is_none() {
            all.extend(
                self.shear_over_weight(result, floor)
                    .map(|found| (ExcessKind::BaseShear, found, None)),
            );
        }
        let Some(height) = made_of.height_m else {
            all.push((ExcessKind::Displacement, drift, None));
            return all;
        };
        if made_of.gravity_n_per_m <= 0.0 {
            let weight = self.weight_above(floor);
            all.push((ExcessKind::Stability, weight * drift / (shear * height), None));
        }
        // At a collapse the run ends before its end.
        if one.can_yield() && result.collapse.is_none() {
            let below = floors.below(floor).map_or(0.0, |below| result.last.of(below).displacement);
            let residual = result.last.of(floor).displacement - below;
            all.push((ExcessKind::ResidualDrift, residual.abs() / height, None));
        }
        all
    }

    /// Peak shear force of the lowest storey over the weight of its structure \[–\]; `None` for other storeys and for a wall.
    pub(crate) fn base_shear(&self, result: &RunResult, floor: usize) -> Option<f64> {
        let floors = self.floors();
        let is_base = !floors.all()[floor].is_wall() && floors.below(floor).is_none();
        is_base.then(|| result.peaks.of(floor).restoring_force.value.abs() / self.weight_above(floor))
    }

    /// Peak shear force over the weight above of the lowest storey that is no isolation layer \[–\]; `None` for other storeys and a wall.
    fn shear_over_weight(&self, result: &RunResult, floor: usize) -> Option<f64> {
        let floors = self.floors();
        let is_lowest = floors.below(floor).is_none_or(|below| floors.all()[below].is_isolation_layer());
        let judged = is_lowest && !floors.all()[floor].is_wall();
        judged.then(|| result.peaks.of(floor).restoring_force.value.abs() / self.weight_above(floor))
    }

    /// Weight of a floor and of those above it \[N\].
    fn weight_above(&self, floor: usize) -> f64 {
        let floors = self.floors();
        let own = floors.of_structure(floors.all()[floor].structure).iter();
        let above = own.filter(|other| floors.storey_of(**other) >= floors.storey_of(floor));
        let masses = above.filter_map(|one| floors.all()[*one].made_of).map(|made| made.mass_kg);
        self.scene().record.gravity_m_per_s2 * masses.sum::<f64>()
    }

    /// The force of the damper over the yield force, and the mass term of the lowest storey if the building is on isolators.
    fn judged_damping(&self, result: &RunResult, floor: usize, damper: Option<f64>) -> Vec<Judged> {
        let one = &self.floors().all()[floor];
        let yields = one.made_of.and_then(|made| made.columns.yield_force_n);
        // The damper of isolators is meant, and that of a storey that falls damps no shaking.
        let falls = result.collapse.is_some_and(|collapse| collapse.floor == floor);
        let damper = damper.filter(|_| !falls && !one.is_isolation_layer());
        let damper = damper
            .zip(yields)
            .map(|(force, yields)| (ExcessKind::DamperForce, force / yields, None));
        let is_isolated = match &self.scene().structures[one.structure] {
            Structure::Building(building) => self.floors().below(floor).is_none() && building.may_be_isolated(),
            Structure::Sdof(_) | Structure::Wall => false,
        };
        let mass = is_isolated.then(|| self.mass_damping(result, one.structure)).flatten();
        let mass = mass.map(|mass| (ExcessKind::MassDamping, mass.ratio, None));
        damper.into_iter().chain(mass).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A structure that starts at a displacement without shaking exceeds a limit, or does not.
    fn excesses(height: Option<f64>, displacement: f64, yields: Option<f64>) -> Vec<(ExcessKind, f64)> {
        let mut structure = serde_json::json!({
            "name": "one", "shear_capacity_n": 1e9, "mass_kg": 1e5, "stiffness_n_per_m": 1e7, "damping": {"ratio": 0.0},
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
