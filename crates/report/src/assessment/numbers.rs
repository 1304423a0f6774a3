//! Every number of an assessment on a separate line, for programs.

use pounding_assess::Rule;
use pounding_text::{Cell, Table};

use super::{AssessedMotion, AssessmentReport};
use crate::site::{Site, SitedNumber};

impl AssessmentReport {
    /// A line for each number \[SI\]: record, reversed, building, floor, neighbour, quantity, value.
    pub(super) fn numbers(&self) -> Table<'_, (&AssessedMotion, SitedNumber)> {
        let rows = self.motions.iter().flat_map(|motion| {
            let numbers = [
                self.of_gaps(motion),
                self.of_floors(motion),
                self.of_pairs(motion),
                self.with_bumper(motion),
            ]
            .concat();
            numbers.into_iter().map(move |number| (motion, number))
        });
        let table = Table::of(rows)
            .column("record", |(motion, _)| motion.name.as_str())
            .column("reversed", |(motion, _)| motion.reversed)
            .column("scale_factor", |(motion, _)| Cell::exact(motion.run.scale))
            .column("neighbour_period_s", |(motion, _)| {
                Cell::exact(motion.neighbour.map(|one| one.period_s))
            })
            .column("neighbour_mass_ratio", |(motion, _)| {
                Cell::exact(motion.neighbour.map(|one| one.mass_ratio))
            });
        Site::columns(table, |(_, number)| &number.site)
            .column("quantity", |(_, number)| Cell::from(number.quantity.as_str()))
            .column("value", |(_, number)| Cell::exact(number.value))
    }

    fn of_gaps(&self, motion: &AssessedMotion) -> Vec<SitedNumber> {
        let gaps = motion.run.separations.iter();
        let numbers = gaps.flat_map(|gap| {
            let site = Site::gap(&self.scene, gap.left);
            let ruled = Rule::ALL.into_iter();
            let ruled = ruled.filter_map(|rule| Some(SitedNumber::at(&site, rule.key(), rule.width(gap)?)));
            let required = SitedNumber::at(&site, "required_m", gap.required);
            std::iter::once(required).chain(ruled).collect::<Vec<_>>()
        });
        numbers.collect()
    }

    /// The sites of floors that move, each with its place.
    fn moving(&self) -> impl Iterator<Item = (usize, Site)> {
        let moving = (0..self.floors.all().len()).filter(|index| !self.floors.all()[*index].is_wall());
        moving.map(|index| (index, Site::floor(&self.scene, &self.floors, index)))
    }

    fn facing(&self) -> impl Iterator<Item = Site> {
        let pairs = self.floors.facing().iter();
        pairs.map(|facing| Site::pair(&self.scene, &self.floors, facing))
    }

    fn of_floors(&self, motion: &AssessedMotion) -> Vec<SitedNumber> {
        let numbers = self.moving().flat_map(|(index, site)| {
            let floor = &motion.run.floors[index];
            let (alone, beside) = (floor.alone, floor.beside);
            let [least, largest] = floor.over_stiffness;
            [
                ("peak_drift_alone_m", alone.drift),
                ("peak_drift_m", beside.drift),
                ("peak_shear_force_alone_n", alone.shear),
                ("peak_shear_force_n", beside.shear),
                ("peak_acceleration_alone_m_per_s2", alone.acceleration),
                ("peak_acceleration_m_per_s2", beside.acceleration),
                ("peak_drift_least_m", least.drift),
                ("peak_drift_largest_m", largest.drift),
                ("peak_acceleration_least_m_per_s2", least.acceleration),
                ("peak_acceleration_largest_m_per_s2", largest.acceleration),
            ]
            .map(|(quantity, value)| SitedNumber::at(&site, quantity, value))
        });
        numbers.collect()
    }

    fn of_pairs(&self, motion: &AssessedMotion) -> Vec<SitedNumber> {
        let end = |range: Option<[f64; 2]>, end: usize| range.map(|range| range[end]);
        let numbers = motion.run.pairs.iter().zip(self.facing()).flat_map(|(pair, site)| {
            [
                ("collisions", Some(pair.collisions as f64)),
                ("peak_force_least_n", end(pair.peak_force, 0)),
                ("peak_force_largest_n", end(pair.peak_force, 1)),
                ("largest_impulse_least_n_s", end(pair.largest_impulse, 0)),
                ("largest_impulse_largest_n_s", end(pair.largest_impulse, 1)),
                ("approach_speed_m_per_s", pair.approach_speed),
            ]
            .map(|(quantity, value)| SitedNumber::at(&site, quantity, value))
        });
        numbers.filter(|number| number.value.is_some()).collect()
    }

    fn with_bumper(&self, motion: &AssessedMotion) -> Vec<SitedNumber> {
        let Some(run) = &motion.bumper else {
            return Vec::new();
        };
        let floors = self.moving().flat_map(|(index, site)| {
            let floor = &run.floors[index];
            [
                ("peak_drift_with_bumper_m", floor.drift),
                ("peak_shear_force_with_bumper_n", floor.shear),
                ("peak_acceleration_with_bumper_m_per_s2", floor.acceleration),
            ]
            .map(|(quantity, value)| SitedNumber::at(&site, quantity, value))
        });
        let pairs = run.pairs.iter().zip(self.facing()).flat_map(|(pair, site)| {
            let force = pair
                .peak_force
                .map(|force| SitedNumber::at(&site, "peak_force_with_bumper_n", force));
            let compression = SitedNumber::at(&site, "bumper_compression_m", pair.compression);
            force.into_iter().chain([compression])
        });
        floors.chain(pairs).collect()
    }
}
