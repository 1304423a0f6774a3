//! Angles of horizontal components, and the motion along an axis between two of them.

use crate::direction::telling_words;
use crate::named_file::Way;
use crate::named_file::way::COMPASS;
use crate::{Accelerogram, NamedFile, Reading, Refused};
use pounding_text::digits;

/// A `Bearing` is the direction of positive values of a horizontal component, according to its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bearing {
    /// Kind of the words: compass points and azimuths, or one of the pairs X and Y, H1 and H2, L and T, FN and FP.
    pub(crate) kind: char,
    /// Angle clockwise from north, or from the first component of the pair \[°\].
    pub(crate) degrees: u16,
}

impl NamedFile {
    /// Returns the bearing of the component; `None` if the name does not show it.
    pub fn bearing(&self) -> Option<Bearing> {
        match self.way? {
            Way::Level(kind, degrees) => Some(Bearing { kind, degrees }),
            Way::Upright(_) | Way::Channel => None,
        }
    }
}

impl Bearing {
    /// Returns the bearing from the words of a component's name: `NS`, `Chan 1: 90 Deg`, `N08W`, `HNE`, `H2`; `None` if no word has one, or
    /// if two words contradict each other.
    pub fn of_component(name: &str) -> Option<Self> {
        let words = telling_words(name).into_iter();
        let mut found: Vec<Self> = words.filter_map(|word| Self::of_word(&word)).collect();
        found.dedup();
        match found[..] {
            [one] => Some(one),
            _ => None,
        }
    }

    fn of_word(word: &str) -> Option<Self> {
        let azimuth = word.parse().ok().filter(|degrees| *degrees <= 360);
        match azimuth.map(|degrees| Way::Level(COMPASS, degrees)).or_else(|| Way::of(word))? {
            Way::Level(kind, degrees) => Some(Self {
                kind,
                degrees: degrees % 360,
            }),
            Way::Upright(_) | Way::Channel => None,
        }
    }

    /// Returns the angle clockwise from north, or from the first component of the pair \[°\].
    pub fn degrees(self) -> f64 {
        f64::from(self.degrees)
    }

    /// Returns whether the angle counts from north.
    pub fn is_from_north(self) -> bool {
        self.kind == COMPASS
    }

    /// Returns whether two components have words of one kind and are at right angles, up to 5°.
    pub fn is_right_angle(self, other: Self) -> bool {
        let way = |one: Self| Way::Level(one.kind, one.degrees);
        way(self).pairs(way(other))
    }
}

/// Largest cosine of the angle between two components of a pair \[–\]: 6° off a right angle.
const SKEWED: f64 = 0.105;

impl Accelerogram {
    /// Returns the motion along an axis, from two horizontal components of one recording that begin together.
    ///
    /// `angles` are the directions of positive values of `self` and `other`, `axis` is the direction of positive values of the result; all
    /// are clockwise from a common origin \[°\]. The shorter component is continued with zeros. The axis of a component gives its values to
    /// the last bit.
    ///
    /// # Errors
    /// Refuses different time steps or units, components that are not at right angles, and an axis that is not finite.
    pub fn rotated(&self, other: &Self, angles: [f64; 2], axis: f64) -> Result<Self, Refused> {
        let [one, another] = [self.time_step, other.time_step];
        if (one - another).abs() > 1e-9 * one {
            let found = Refused::that(format!("the two components have time steps of {one} s and {another} s"));
            return Err(found.allowed_are("equal ones").help("resample one of them"));
        }
        if self.unit != other.unit {
            let units = [self.unit.name(), other.unit.name()].join(" and ");
            let found = Refused::that(format!("the two components are in {units}"));
            return Err(found.allowed_is("one unit").help("convert one of them"));
        }
        let between = angles[1] - angles[0];
        if cosine(between).abs() > SKEWED || !axis.is_finite() {
            let [one, another, axis] = [angles[0], angles[1], axis].map(digits);
            let found = Refused::that(format!("the components point to {one}° and {another}°, the axis to {axis}°"));
            return Err(found.allowed_are("components at right angles, up to 5°, and a finite axis"));
        }
        let of_self = sine(angles[1] - axis) / sine(between);
        let of_other = sine(axis - angles[0]) / sine(between);
        let value = |values: &[f64], index: usize| values.get(index).copied().unwrap_or(0.0);
        let length = self.values.len().max(other.values.len());
        let sum = |index: usize| match (of_self == 0.0, of_other == 0.0) {
            (false, true) => of_self * value(&self.values, index),
            (true, false) => of_other * value(&other.values, index),
            _ => of_self * value(&self.values, index) + of_other * value(&other.values, index),
        };
        let mut rotated = self.clone();
        rotated.values = (0..length).map(sum).collect();
        let name = |one: &Self| one.component().map_or_else(|| "a component".to_owned(), str::to_owned);
        let said = format!("{} and {}, along {}°", name(self), name(other), digits(axis));
        // The peaks of the headers are those of the components.
        rotated.readings.retain(|one| !one.what.contains("peak") && one.what != "component");
        rotated.readings.push(Reading {
            what: "component",
            line: None,
            found: said,
        });
        rotated.unusual.extend(other.unusual.iter().cloned());
        Ok(rotated)
    }
}

/// Sine of an angle \[°\], exact at right angles.
fn sine(degrees: f64) -> f64 {
    match degrees.rem_euclid(360.0) {
        0.0 | 180.0 => 0.0,
        90.0 => 1.0,
        270.0 => -1.0,
        other => libm::sin(other.to_radians()),
    }
}

fn cosine(degrees: f64) -> f64 {
    sine(degrees + 90.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read;

    fn column(values: [f64; 3]) -> Accelerogram {
        let [a, b, c] = values;
        let text = format!("time_s,acceleration_g\n0.00,{a}\n0.01,{b}\n0.02,{c}\n");
        read(text.as_bytes()).expect("a record")
    }

    #[test]
    fn reference_bearings_as_formats_write_them() {
        for (name, kind, degrees) in [
            ("Chan 1: 90 Deg", COMPASS, 90),
            ("S16W", COMPASS, 196),
            ("COMP N08W", COMPASS, 352),
            ("N-S", COMPASS, 0),
            ("acc_EW(gal)", COMPASS, 90),
            ("HNE", COMPASS, 90),
            ("HNN", COMPASS, 0),
            ("HN2", 'H', 90),
            ("360", COMPASS, 0),
            ("West", COMPASS, 270),
            ("FP", 'F', 90),
        ] {
            assert_eq!(Bearing::of_component(name), Some(Bearing { kind, degrees }), "{name}");
        }
        for name in ["Up", "HNZ", "", "Chan 1", "N and E", "column 2", "400"] {
            assert_eq!(Bearing::of_component(name), None, "{name}");
        }
    }

    /// A ground that moves along 30° only: N has its cosine, E its sine; west has the sine with the other sign.
    #[test]
    fn reference_a_motion_along_one_axis_is_found_again() {
        let along = [1.0, -0.5, 0.25];
        let [north, east, west] =
            [0.0_f64, 90.0, 270.0].map(|azimuth| column(along.map(|one| one * libm::cos((azimuth - 30.0_f64).to_radians()))));
        for (other, azimuth) in [(&east, 90.0), (&west, 270.0)] {
            let axis = |axis: f64| north.rotated(other, [0.0, azimuth], axis).expect("a pair").values;
            let close = |found: Vec<f64>, factor: f64| found.iter().zip(along).all(|(found, one)| (found - factor * one).abs() < 1e-15);
            assert!(close(axis(30.0), 1.0), "along");
            assert!(close(axis(120.0), 0.0), "across");
            assert!(close(axis(210.0), -1.0), "from the other end");
        }
        // Lucerne 1992 has 260 and 345.
        let [one, other] = [260.0_f64, 345.0].map(|azimuth| column(along.map(|one| one * libm::cos((azimuth - 30.0_f64).to_radians()))));
        let found = one.rotated(&other, [260.0, 345.0], 30.0).expect("a pair");
        assert!(
            found.values.iter().zip(along).all(|(found, one)| (found - one).abs() < 1e-14),
            "not quite at right angles"
        );
    }

    #[test]
    fn limit_the_axis_of_a_component_gives_its_bits() {
        let (one, other) = (column([0.1, -0.3, 0.7]), column([0.9, 1e-9, -0.1]));
        for (angles, axis, same) in [
            ([17.0, 107.0], 17.0, &one),
            ([17.0, 107.0], 107.0, &other),
            ([340.0, 250.0], 250.0, &other),
        ] {
            assert_eq!(one.rotated(&other, angles, axis).expect("a pair").values, same.values);
        }
    }

    #[test]
    fn extreme_components_that_make_no_pair_are_refused() {
        let one = column([0.1, -0.3, 0.7]);
        for (angles, axis) in [
            ([0.0, 45.0], 0.0),
            ([10.0, 10.0], 0.0),
            ([0.0, 90.0], f64::NAN),
            ([0.0, 180.0], 1.0),
        ] {
            assert!(one.rotated(&one, angles, axis).is_err(), "{angles:?} {axis}");
        }
        let text = "time_s,acceleration_g\n0.00,0\n0.02,1\n0.04,2\n0.06,1\n";
        let slower = read(text.as_bytes()).expect("a record");
        let refused = one.rotated(&slower, [0.0, 90.0], 0.0).expect_err("two time steps").to_string();
        assert!(refused.contains("time steps of 0.01 s and 0.02 s"), "{refused}");
    }

    #[test]
    fn extreme_the_shorter_component_ends_in_zeros() {
        let text = "time_s,acceleration_g\n0.00,0\n0.01,1\n0.02,2\n0.03,1\n";
        let (one, longer) = (column([0.1, -0.3, 0.7]), read(text.as_bytes()).expect("a record"));
        assert_eq!(
            one.rotated(&longer, [0.0, 90.0], 0.0).expect("a pair").values,
            [0.1, -0.3, 0.7, 0.0]
        );
    }
}
