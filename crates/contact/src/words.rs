//! Laws in files: `{ name = { parameters } }`. An e may replace the damping.

use std::borrow::Cow;
use std::fmt;
use std::sync::LazyLock;

use pounding_text::Refused;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{DeserializeSeed, EnumAccess, Error, MapAccess, VariantAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value, json};

use crate::law::Exact;
use crate::parameter::RESTITUTION;
use crate::{Calibration, ContactLaw, FreePair, LawName, Parameter};

const CALIBRATION: &str = "calibration";

impl LawName {
    /// The names that files know: one for each force.
    fn forces() -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(|law| law.place() == 0)
    }

    /// The damping parameter that an e may replace in files.
    fn damping(self) -> Option<&'static Parameter> {
        let is_damped = matches!(self.about().exact, Exact::Any(_));
        self.parameters().pop().filter(|_| is_damped)
    }

    /// Names of the settings: the parameters, then those that may replace the damping.
    fn settings(self) -> Words {
        static ALL: LazyLock<Vec<Vec<&str>>> = LazyLock::new(|| {
            let all = LawName::ALL.into_iter().map(|law| {
                let parameters = law.parameters().into_iter().map(|row| row.name);
                let instead = law.damping().map(|_| [RESTITUTION.name, CALIBRATION]);
                parameters.chain(instead.into_iter().flatten()).collect()
            });
            all.collect()
        });
        &ALL[self as usize]
    }
}

impl ContactLaw {
    /// An example in JSON of every law, with usual values.
    pub fn examples() -> impl Iterator<Item = String> {
        LawName::forces().map(|law| {
            let mut parameters = law.parameters();
            if let (Some(last), Some(_)) = (parameters.last_mut(), law.damping()) {
                *last = &RESTITUTION;
            }
            let words = parameters.into_iter().map(|Parameter { name, usual, .. }| {
                // As a person writes it: 0.65, 2.75e9.
                if *usual < 1e3 {
                    format!("\"{name}\": {usual}")
                } else {
                    format!("\"{name}\": {usual:e}")
                }
            });
            let words: Vec<_> = words.collect();
            format!("{{\"{}\": {{{}}}}}", law.name(), words.join(", "))
        })
    }
}

impl Serialize for ContactLaw {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_map([(self.name(), Numbers(*self))])
    }
}

struct Numbers(ContactLaw);

impl Serialize for Numbers {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut law = self.0;
        let parameters = law.parameters().into_iter();
        to.collect_map(parameters.map(|(parameter, number)| (parameter.name, *number)))
    }
}

impl<'de> Deserialize<'de> for ContactLaw {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_enum("ContactLaw", Self::NAMES, Named)
    }
}

/// Known words.
type Words = &'static [&'static str];

/// Reads the name of a law or of a setting and gives its index among the known words.
enum Word {
    Law,
    Setting(Words),
}

impl<'de> DeserializeSeed<'de> for Word {
    type Value = usize;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<usize, D::Error> {
        from.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Word {
    type Value = usize;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("a name")
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<usize, E> {
        let known = match self {
            Self::Law => ContactLaw::NAMES,
            Self::Setting(known) => known,
        };
        let place = known.iter().position(|name| *name == word);
        place.ok_or_else(|| match self {
            Self::Law => E::unknown_variant(word, known),
            Self::Setting(_) => E::unknown_field(word, known),
        })
    }
}

/// Reads the name of a law, then its settings.
struct Named;

impl<'de> Visitor<'de> for Named {
    type Value = ContactLaw;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("enum ContactLaw")
    }

    fn visit_enum<A: EnumAccess<'de>>(self, access: A) -> Result<ContactLaw, A::Error> {
        let (index, settings) = access.variant_seed(Word::Law)?;
        let law = LawName::forces().nth(index);
        settings.newtype_variant_seed(Settings(law.expect("a name for every law")))
    }
}

/// Reads the settings of a law.
struct Settings(LawName);

impl<'de> DeserializeSeed<'de> for Settings {
    type Value = ContactLaw;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<ContactLaw, D::Error> {
        from.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Settings {
    type Value = ContactLaw;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("struct of a law")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<ContactLaw, A::Error> {
        let law = self.0;
        let damping = law.damping().map(|damping| damping.name);
        let known = law.settings();
        let mut seen = vec![false; known.len()];
        let (mut numbers, mut calibration) = (vec![None; known.len()], None);
        while let Some(index) = map.next_key_seed(Word::Setting(known))? {
            let name = known[index];
            if std::mem::replace(&mut seen[index], true) {
                return Err(A::Error::duplicate_field(name));
            }
            match name {
                CALIBRATION => calibration = map.next_value::<Option<Calibration>>()?,
                _ if damping.is_some() && index > 0 => numbers[index] = map.next_value()?,
                _ => numbers[index] = Some(map.next_value()?),
            }
        }
        let number = |index: usize| {
            let missing = || A::Error::missing_field(known[index]);
            numbers[index].ok_or_else(missing)
        };
        let Some(damping) = damping else {
            let numbers: Result<Vec<_>, _> = (0..known.len()).map(number).collect();
            return Ok(law.with(numbers?));
        };
        let stiffness = number(0)?;
        // By default the law delivers e exactly, for every pair.
        let refused = match (numbers[1], numbers[2], calibration) {
            (Some(damping), None, None) => return Ok(law.with([stiffness, damping])),
            (None, Some(e), calibration) => {
                return law
                    .calibrated(stiffness, e, calibration.unwrap_or(Calibration::Exact), &FreePair::UNIT)
                    .map_err(|error| A::Error::custom(Refused::from(error)));
            }
            (Some(_), None, Some(_)) => ("`calibration` without `restitution`".into(), "only with it"),
            (Some(_), Some(_), _) => (format!("both `{damping}` and `restitution`"), "one of them"),
            (None, None, _) => (format!("neither `{damping}` nor `restitution`"), "one of them"),
        };
        let (found, allowed) = refused;
        Err(A::Error::custom(Refused::default().found(found).allowed(allowed)))
    }
}

impl JsonSchema for ContactLaw {
    fn schema_name() -> Cow<'static, str> {
        "ContactLaw".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let laws: Vec<_> = LawName::forces().map(|law| law.schema(generator)).collect();
        json_schema!({ "description": "A contact law with its parameters, as a scene names it.", "oneOf": laws })
    }
}

impl LawName {
    /// The settings of a law under its name.
    fn schema(self, generator: &mut SchemaGenerator) -> Value {
        let (about, damping) = (self.about(), self.damping());
        let describe = |row: &Parameter, instead: &str| {
            let Parameter { meaning, unit, .. } = row;
            format!("{meaning} ({unit}), {}{instead}", row.allowed.words)
        };
        let (mut fields, mut required) = (Map::new(), Vec::new());
        for row in self.parameters() {
            let number = if damping.is_some_and(|damping| damping.name == row.name) {
                json!({ "description": describe(row, "; or `restitution`"), "type": ["number", "null"], "format": "double" })
            } else {
                required.push(row.name);
                json!({ "description": describe(row, ""), "type": "number", "format": "double" })
            };
            fields.insert(row.name.into(), number);
        }
        if let Some(damping) = damping {
            let asked = Parameter {
                allowed: about.exact.allowed(),
                ..RESTITUTION
            };
            let instead = format!("; or `{}`", damping.name);
            fields.insert(
                RESTITUTION.name.into(),
                json!({
                    "description": describe(&asked, &instead), "type": ["number", "null"], "format": "double",
                }),
            );
            fields.insert(
                CALIBRATION.into(),
                json!({
                    "description": "How the damping follows from the restitution; without it exactly.",
                    "anyOf": [generator.subschema_for::<Calibration>(), { "type": "null" }],
                }),
            );
        }
        let name = self.name();
        json!({
            "description": format!("{}: {}. Source: {}.", about.names[0].label, about.force, about.names[0].citation),
            "type": "object",
            "properties": { name: {
                "type": "object", "properties": fields, "additionalProperties": false, "required": required,
            } },
            "additionalProperties": false,
            "required": [name],
        })
    }
}
