//! The sentences of an assessment about touching: drifts against their limit, forces, and what gets worse or better.

use pounding_assess::{Distribution, FloorAssessment};
use pounding_scene::ExcessKind;
use pounding_text::{percent, two_decimals, two_digits};

use super::AssessmentReport;

/// Part of its limit \[–\] up to which a drift does not lead, however many times that of the building alone it is: 1 % of the height.
const SMALL: f64 = 0.4;

/// Floors with a response over that alone, and the worst or the best of them.
struct Changed<'f> {
    count: usize,
    floor: usize,
    ratio: &'f Distribution,
}

impl AssessmentReport {
    /// The effects of touching, in a sentence each: the largest drift against its limit, the largest force, what gets worse, what gets better.
    pub fn consequences(&self) -> Vec<String> {
        // The answer says before that no effect is to be believed.
        let is_believed = self.assessment.disbelieved < self.assessment.cases;
        if self.hit().is_empty() || !is_believed {
            return Vec::new();
        }
        let said = [
            self.largest_drift(),
            self.largest_force(),
            self.worse_drifts(),
            self.worse_accelerations(),
            self.better_drifts(),
        ];
        said.into_iter().flatten().collect()
    }

    /// Name of the storey below a floor.
    pub(super) fn storey_name(&self, floor: usize) -> String {
        self.floors.storey_name(floor)
    }

    /// A drift over the storey height and its limit \[–\]; `None` if the height is not known, and of a bridge without capacities.
    fn of_limit(&self, floor: usize, drift: f64) -> Option<[f64; 2]> {
        let made_of = self.floors.all()[floor].made_of?;
        let general = (!self.floors.is_bridge()).then_some(ExcessKind::MOST_DRIFT);
        let limit = made_of.capacities.drift_capacity_ratio.or(general)?;
        Some([drift / made_of.height_m?, limit])
    }

    /// Whether the drift of a storey stays small, however much it grows.
    fn is_small(&self, floor: usize, one: &FloorAssessment) -> bool {
        let of_limit = self.of_limit(floor, Self::at_most(one));
        of_limit.is_some_and(|[drift, limit]| drift <= SMALL * limit)
    }

    /// Largest drift of a storey when they touch, over the stiffness of contact \[m\].
    pub(super) fn at_most(one: &FloorAssessment) -> f64 {
        one.largest_drift.max(one.largest_drift_range[1])
    }

    /// Storeys whose drift their columns have to bear: an isolation layer is made to drift.
    fn columns(&self) -> Vec<(usize, &FloorAssessment)> {
        let mut floors = self.floors_in_order();
        floors.retain(|(floor, _)| !self.floors.all()[*floor].is_isolation_layer());
        floors
    }

    /// The largest drift beside the neighbours, against its limit.
    fn largest_drift(&self) -> Option<String> {
        let floors = self.columns();
        let share = |(floor, one): &(usize, &FloorAssessment)| {
            let most = Self::at_most(one);
            let of_limit = self.of_limit(*floor, most);
            of_limit.map_or((0.0, most), |[drift, limit]| (drift / limit, most))
        };
        let (floor, one) = floors.into_iter().max_by(|one, other| {
            let (one, other) = (share(one), share(other));
            one.0.total_cmp(&other.0).then(one.1.total_cmp(&other.1))
        })?;
        let name = self.storey_name(floor);
        let Some([drift, limit]) = self.of_limit(floor, Self::at_most(one)) else {
            let [drift, alone] = [Self::at_most(one), one.largest_drift_alone].map(|drift| two_digits(1e3 * drift));
            let why = if self.floors.is_bridge() {
                "limits for storeys of buildings do not hold for a bridge (drift_capacity_ratio)"
            } else {
                "without its height there is no limit for it"
            };
            return Some(format!(
                "Largest drift when they touch: {drift} mm ({name}), alone {alone} mm; {why}."
            ));
        };
        let of_height = |drift: f64| self.of_limit(floor, drift).map(|[drift, _]| percent(drift));
        let [least, most] = [of_height(one.largest_drift_range[0])?, percent(drift)];
        let alone = of_height(one.largest_drift_alone)?;
        let range = if least == most {
            String::new()
        } else {
            format!("; from {least} on, by the stiffness of contact")
        };
        let within = if drift > limit { "above" } else { "within" };
        let has_capacity = self.floors.all()[floor]
            .made_of
            .is_some_and(|one| one.capacities.drift_capacity_ratio.is_some());
        let whose = if has_capacity {
            "that it bears"
        } else {
            "of NBCC 2015 for buildings of normal importance"
        };
        let n = self.assessment.cases - self.assessment.disbelieved;
        let others = match self.assessment.disbelieved {
            0 => String::new(),
            1 => format!(" That is of {}; the other is past the model.", self.of_cases(n)),
            past => format!(" That is of {}; the other {past} are past the model.", self.of_cases(n)),
        };
        Some(format!(
            "Largest drift when they touch: {most} of the height ({name}{range}), {within} the {} {whose}; alone {alone}.{others}",
            percent(limit),
        ))
    }

    /// The range of the largest force over the stiffness of contact.
    fn largest_force(&self) -> Option<String> {
        let (index, pair) = self.hit().into_iter().next()?;
        let [left, right] = self.floors.names(index);
        let Some([low, high]) = &pair.peak_force else {
            let speed = two_digits(pair.approach_speed.unwrap_or(0.0));
            return Some(format!(
                "{left} – {right} meet with up to {speed} m/s; the contact law of the scene has no force."
            ));
        };
        let [low, high] = [low, high].map(|of| two_digits(1e-3 * of.largest()));
        let [from, to] = self.stiffness.map(two_digits);
        Some(if low == high {
            format!(
                "Largest force: {high} kN ({left} – {right}), for the assumed contact stiffness alone. Another stiffness gives several times \
                 more or less: no force to design for."
            )
        } else {
            format!(
                "Largest force: {low} to {high} kN ({left} – {right}), as the contact is {from} to {to} times as stiff as in the scene. The \
                 real stiffness is not known better: no force to design for."
            )
        })
    }

    /// The floors whose ratio `of` changes as `changes` tells, and that of them whose ratio is the largest, or the least.
    fn changed<'f>(
        &'f self,
        of: impl Fn(usize, &'f FloorAssessment) -> Option<&'f Distribution>,
        changes: impl Fn(f64) -> bool,
        is_worse: bool,
    ) -> Option<Changed<'f>> {
        let floors = self.columns().into_iter();
        let ratios = floors.filter_map(|(floor, one)| Some((floor, of(floor, one)?)));
        let mut changed: Vec<_> = ratios.filter(|(_, ratio)| changes(ratio.upper())).collect();
        changed.sort_by(|one, other| other.1.upper().total_cmp(&one.1.upper()));
        let at = if is_worse { changed.first() } else { changed.last() };
        at.map(|(floor, ratio)| Changed {
            count: changed.len(),
            floor: *floor,
            ratio,
        })
    }

    /// Storeys whose drift grows, without those that stay small.
    fn worse_drifts(&self) -> Option<String> {
        let grows = |ratio: f64| ratio > FloorAssessment::WORSE;
        let all = self.changed(|_, one| Some(&one.drift), grows, true)?;
        let harmful = |floor, one| (!self.is_small(floor, one)).then_some(&one.drift);
        let limit = |whose: &str| format!("{} of {whose} limit", percent(SMALL));
        let Some(Changed { count, floor, ratio }) = self.changed(harmful, grows, true) else {
            return Some(format!(
                "{} below {}.",
                self.storeys_that(all.count, ["drifts over 10 % more, but stays", "drift over 10 % more, but stay"]),
                limit(if all.count == 1 { "its" } else { "their" })
            ));
        };
        let harmless = match all.count - count {
            0 => String::new(),
            1 => format!(" One other does so, too, but stays below {}.", limit("its")),
            n => format!(" {n} others do so, too, but stay below {}.", limit("their")),
        };
        Some(format!(
            "{} by more than 10 %, {}: {}.{harmless}",
            self.storeys_that(count, ["drifts more", "drift more"]),
            named(count, &self.storey_name(floor)),
            self.times(ratio)
        ))
    }

    /// Floors whose acceleration grows.
    fn worse_accelerations(&self) -> Option<String> {
        // The range that is printed decides: the stiffness of contact is not known.
        let changed = self.changed(
            |_, one| Some(&one.acceleration_range[1]),
            |ratio| ratio > FloorAssessment::WORSE,
            true,
        )?;
        let one = self.assessment.floors[changed.floor].as_ref()?;
        let [low, high] = one.acceleration_range.each_ref().map(|of| two_digits(of.upper()));
        let of = if low == high {
            format!("{high} times the acceleration alone")
        } else {
            format!("{low} to {high} times the acceleration alone, over the stiffness of contact")
        };
        Some(format!(
            "{} by more than 10 %, {}: {of}.",
            counted(changed.count, ["floor shakes harder", "floors shake harder"]),
            named(changed.count, &self.floor_name(changed.floor))
        ))
    }

    /// Storeys whose drift becomes less.
    fn better_drifts(&self) -> Option<String> {
        let Changed { count, floor, ratio } = self.changed(|_, one| Some(&one.drift), |ratio| ratio < 0.9, false)?;
        Some(format!(
            "{} by more than 10 %, {}: {} times as far as alone.",
            self.storeys_that(count, ["drifts less", "drift less"]),
            named(count, &self.storey_name(floor)),
            two_decimals(ratio.upper())
        ))
    }

    /// "3 storeys drift more".
    fn storeys_that(&self, count: usize, [does, do_so]: [&str; 2]) -> String {
        let storey = self.scene.words().storey;
        counted(count, [&format!("{storey} {does}"), &format!("{storey}s {do_so}")])
    }

    /// "up to 3.00 times as far as alone with the contact of the scene (the largest of 4 events)".
    fn times(&self, ratio: &Distribution) -> String {
        let upper = two_decimals(ratio.upper());
        if ratio.has_quantiles() {
            format!(
                "up to {upper} times as far as alone with the contact of the scene in 84 % of {} {}s, {} times in the median",
                ratio.sorted().len(),
                self.sample(),
                two_decimals(ratio.median())
            )
        } else {
            format!(
                "up to {upper} times as far as alone with the contact of the scene ({})",
                self.largest_of(ratio)
            )
        }
    }
}

/// Names the one that is meant, or the one of several that changes most.
fn named(count: usize, name: &str) -> String {
    let most = if count == 1 { "" } else { "most " };
    format!("{most}{name}")
}

/// "One floor shakes harder", "3 floors shake harder".
fn counted(count: usize, [one, several]: [&str; 2]) -> String {
    match count {
        1 => format!("One {one}"),
        n => format!("{n} {several}"),
    }
}
