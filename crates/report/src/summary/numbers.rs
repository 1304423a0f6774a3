//! The numbers of a floor or a pair in `summary.json`, by the table of numbers: a field for each.

use std::fmt::{self, Formatter};

use pounding_scene::{PairQuantity, Quantity, QuantityGroup, QuantityKind, RunErrors, RunValues};
use serde::de::{Deserialize, Deserializer, IgnoredAny, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::{CollisionSummary, PairSummary};

/// The numbers that a place has, SI, in the order of the table.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Numbers(Vec<(Quantity, f64)>);

/// Distances of numbers from the exact run by name: relative to the exact magnitude \[–\] if the name has no unit. `None` if they cannot be
/// compared, or if the exact number is 0 and this run's is not.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ErrorSummary(Vec<(Quantity, Option<f64>)>);

impl Numbers {
    /// All numbers of a place, without those that are fields of a collision.
    pub(super) fn of(values: &RunValues<'_>, (all, place): (impl Iterator<Item = Quantity>, usize)) -> Self {
        let own = all.filter(|one| one.about().collision.is_none());
        Self(own.filter_map(|one| Some((one, values.of(one, place)?))).collect())
    }

    /// A number; `None` if the place has no such number.
    pub fn get(&self, quantity: impl Into<Quantity>) -> Option<f64> {
        let quantity = quantity.into();
        let found = self.0.iter().find(|(known, _)| *known == quantity);
        found.map(|(_, number)| *number)
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
fn whole(count: f64) -> usize {
    count as usize
}

fn write<Map: SerializeMap>(map: &mut Map, (quantity, number): (Quantity, f64)) -> Result<(), Map::Error> {
    let about = quantity.about();
    if about.kind == QuantityKind::Count {
        return map.serialize_entry(about.name, &whole(number));
    }
    map.serialize_entry(about.name, &number)
}

impl Serialize for Numbers {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(None)?;
        self.0.iter().try_for_each(|one| write(&mut map, *one))?;
        map.end()
    }
}

/// Reads fields by their names; those that it does not know are of a later version.
struct Reader(fn(Quantity) -> Option<&'static str>);

impl<'de> Visitor<'de> for Reader {
    type Value = Vec<(Quantity, Option<f64>)>;

    fn expecting(&self, to: &mut Formatter<'_>) -> fmt::Result {
        to.write_str("numbers by name")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut read = Vec::new();
        while let Some(name) = map.next_key::<String>()? {
            match Quantity::all().find(|one| self.0(*one) == Some(&name)) {
                Some(quantity) => read.push((quantity, map.next_value()?)),
                None => drop(map.next_value::<IgnoredAny>()?),
            }
        }
        read.sort_by_key(|(one, _)| *one);
        Ok(read)
    }
}

impl<'de> Deserialize<'de> for Numbers {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let read = from.deserialize_map(Reader(|one| Some(one.about().name)))?.into_iter();
        Ok(Self(read.filter_map(|(one, number)| Some((one, number?))).collect()))
    }
}

impl<'de> Deserialize<'de> for ErrorSummary {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_map(Reader(|one| one.about().error_name())).map(Self::in_order)
    }
}

impl ErrorSummary {
    /// The errors of all numbers of a place; a drift that the place does not have, and a collapse or another event that is rare, have no error.
    pub(super) fn of(errors: &RunErrors, (all, place): (impl Iterator<Item = Quantity>, usize)) -> Self {
        let told = all.filter_map(|one| {
            let about = one.about();
            // JSON has no infinity.
            let error = errors.told(one, place).filter(|error| error.is_finite());
            let is_rare = about.kind == QuantityKind::First && about.collision.is_none();
            let is_written = about.error_name().is_some() && (error.is_some() || (about.on_ground.is_none() && !is_rare));
            is_written.then_some((one, error))
        });
        Self::in_order(told.collect())
    }

    /// Those of floors group by group, of momenta last, as the first files had them.
    fn in_order(mut all: Vec<(Quantity, Option<f64>)>) -> Self {
        all.sort_by_key(|(one, _)| {
            let group = one.about().group.unwrap_or(QuantityGroup::Displacement);
            matches!(one, Quantity::Floor(_)).then_some((group == QuantityGroup::Momentum, group))
        });
        Self(all)
    }

    /// That of a number.
    pub fn get(&self, quantity: impl Into<Quantity>) -> Option<f64> {
        let quantity = quantity.into();
        self.0.iter().find(|(known, _)| *known == quantity)?.1
    }
}

impl Serialize for ErrorSummary {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_map(
            self.0
                .iter()
                .map(|(one, error)| (one.about().error_name().unwrap_or_default(), error)),
        )
    }
}

impl PairSummary {
    /// Its collisions by name, each with the number behind which it is written.
    fn in_fields(&self) -> [(&'static str, PairQuantity, Option<CollisionSummary>); 3] {
        [
            ("first", PairQuantity::Collisions, self.first),
            ("largest", PairQuantity::Collisions, self.largest),
            ("leaning", PairQuantity::TouchingS, self.leaning),
        ]
    }

    /// Number of collisions.
    pub fn collisions(&self) -> usize {
        self.number(PairQuantity::Collisions).map_or(0, whole)
    }

    /// Least opening of the gap \[m\].
    pub fn least_opening(&self) -> f64 {
        self.number(PairQuantity::LeastOpeningM).unwrap_or(f64::NAN)
    }

    /// A number; `None` if the pair has no such number.
    pub fn number(&self, quantity: PairQuantity) -> Option<f64> {
        let about = quantity.about();
        let Some(name) = about.collision else {
            return self.numbers.get(quantity);
        };
        let (_, _, one) = self.in_fields().into_iter().find(|(known, ..)| *known == name)?;
        let fields = serde_json::to_value(one?).ok()?;
        fields.get(about.name.strip_prefix(name)?.strip_prefix('_')?)?.as_f64()
    }
}

impl Serialize for PairSummary {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(None)?;
        map.serialize_entry("left", &self.left)?;
        map.serialize_entry("right", &self.right)?;
        for (quantity, number) in &self.numbers.0 {
            write(&mut map, (*quantity, *number))?;
            if *quantity == PairQuantity::GapM.into() {
                map.serialize_entry("law", &self.law)?;
            }
            for (name, after, one) in self.in_fields() {
                if let Some(one) = one.filter(|_| *quantity == after.into()) {
                    map.serialize_entry(name, &one)?;
                }
            }
        }
        if let Some(errors) = &self.errors {
            map.serialize_entry("errors", errors)?;
        }
        map.end()
    }
}
