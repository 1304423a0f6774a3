//! The content of a file as a tree, for JSON and TOML alike. One deserialiser reads all types from it.
//!
//! Deserialisers are large. Without the tree, every type would have a second one for the second language.

use std::fmt::{self, Write};

use serde::de::value::MapAccessDeserializer;
use serde::de::{DeserializeSeed, Deserializer, Error, IntoDeserializer, MapAccess, SeqAccess, Unexpected, Visitor};
use serde::forward_to_deserialize_any;

use super::unfit::{CHOICE, Unfit};

/// A value of a file. Fields keep their order, and fields that occur twice stay twice.
#[derive(Debug)]
pub(super) enum Tree {
    Nothing,
    Truth(bool),
    Natural(u64),
    Integer(i64),
    Number(f64),
    Text(String),
    List(Vec<Tree>),
    Table(Vec<(String, Tree)>),
}

impl Tree {
    /// Builds a tree from any deserialiser. If that fails, `place` is the place of the fault.
    pub(super) fn grown<'de, D: Deserializer<'de>>(from: D, place: &mut String) -> Result<Self, D::Error> {
        Grower(place).deserialize(from)
    }

    fn unexpected(&self) -> Unexpected<'_> {
        match self {
            Self::Nothing => Unexpected::Unit,
            Self::Truth(truth) => Unexpected::Bool(*truth),
            Self::Natural(number) => Unexpected::Unsigned(*number),
            Self::Integer(number) => Unexpected::Signed(*number),
            Self::Number(number) => Unexpected::Float(*number),
            Self::Text(text) => Unexpected::Str(text),
            Self::List(_) => Unexpected::Seq,
            Self::Table(_) => Unexpected::Map,
        }
    }
}

/// Builds a tree and tracks its place.
struct Grower<'p>(&'p mut String);

impl<'de> DeserializeSeed<'de> for Grower<'_> {
    type Value = Tree;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Tree, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Grower<'_> {
    type Value = Tree;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str("what TOML or JSON can say")
    }

    fn visit_unit<E>(self) -> Result<Tree, E> {
        Ok(Tree::Nothing)
    }

    fn visit_bool<E>(self, truth: bool) -> Result<Tree, E> {
        Ok(Tree::Truth(truth))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Tree, E> {
        Ok(Tree::Natural(number))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Tree, E> {
        Ok(Tree::Integer(number))
    }

    // JSON gives such a number as one with a fraction.
    fn visit_i128<E>(self, number: i128) -> Result<Tree, E> {
        Ok(Tree::Number(number as f64))
    }

    fn visit_u128<E>(self, number: u128) -> Result<Tree, E> {
        Ok(Tree::Number(number as f64))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Tree, E> {
        Ok(Tree::Number(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Tree, E> {
        Ok(Tree::Text(text.into()))
    }

    fn visit_string<E>(self, text: String) -> Result<Tree, E> {
        Ok(Tree::Text(text))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Tree, A::Error> {
        let (mut list, own) = (Vec::new(), self.0.len());
        loop {
            let _ = write!(self.0, "[{}]", list.len());
            match items.next_element_seed(Grower(self.0))? {
                Some(item) => list.push(item),
                None => break,
            }
            self.0.truncate(own);
        }
        self.0.truncate(own);
        Ok(Tree::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<Tree, A::Error> {
        let (mut table, own) = (Vec::new(), self.0.len());
        while let Some(name) = fields.next_key::<String>()? {
            let dot = if own > 0 { "." } else { "" };
            let _ = write!(self.0, "{dot}{name}");
            let value = fields.next_value_seed(Grower(self.0))?;
            self.0.truncate(own);
            table.push((name, value));
        }
        Ok(Tree::Table(table))
    }
}

impl<'de> IntoDeserializer<'de, Unfit> for &'de Tree {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

impl<'de> Deserializer<'de> for &'de Tree {
    type Error = Unfit;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
        match self {
            Tree::Nothing => visitor.visit_unit(),
            Tree::Truth(truth) => visitor.visit_bool(*truth),
            Tree::Natural(number) => visitor.visit_u64(*number),
            Tree::Integer(number) => visitor.visit_i64(*number),
            Tree::Number(number) => visitor.visit_f64(*number),
            Tree::Text(text) => visitor.visit_borrowed_str(text),
            Tree::List(list) => {
                let mut items = Items { list, next: 0 };
                let read = visitor.visit_seq(&mut items)?;
                items.end()?;
                Ok(read)
            }
            Tree::Table(table) => visitor.visit_map(Fields { table, next: 0 }),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Unfit> {
        if matches!(self, Tree::Nothing) {
            visitor.visit_none()
        } else {
            visitor.visit_some(self)
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Unfit> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(self, name: &'static str, words: &'static [&'static str], visitor: V) -> Result<V::Value, Unfit> {
        if let Tree::Text(word) = self {
            return visitor.visit_enum(word.as_str().into_deserializer());
        }
        if let Tree::Table(table) = self
            && table.len() == 1
        {
            let fields = Fields { table, next: 0 };
            return MapAccessDeserializer::new(fields).deserialize_enum(name, words, visitor);
        }
        Err(Unfit::invalid_type(self.unexpected(), &CHOICE))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct seq tuple
        tuple_struct map struct identifier ignored_any
    }
}

/// Items of a list, one after another.
struct Items<'t> {
    list: &'t [Tree],
    next: usize,
}

impl Items<'_> {
    /// Refuses a list with items that were not read.
    fn end(&self) -> Result<(), Unfit> {
        if self.next == self.list.len() {
            return Ok(());
        }
        let allowed = format!("an array of length {}", self.next);
        Err(Unfit::invalid_length(self.list.len(), &allowed.as_str()))
    }
}

impl<'de> SeqAccess<'de> for &mut Items<'de> {
    type Error = Unfit;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Unfit> {
        let Some(item) = self.list.get(self.next) else {
            return Ok(None);
        };
        let place = format!("[{}]", self.next);
        self.next += 1;
        let read = seed.deserialize(item);
        read.map(Some).map_err(|refused| refused.within(&place))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.list.len() - self.next)
    }
}

/// Fields of a table, one after another.
struct Fields<'t> {
    table: &'t [(String, Tree)],
    next: usize,
}

impl<'de> MapAccess<'de> for Fields<'de> {
    type Error = Unfit;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Unfit> {
        let Some((name, _)) = self.table.get(self.next) else {
            return Ok(None);
        };
        let read = seed.deserialize(name.as_str().into_deserializer());
        read.map(Some).map_err(|unfit: Unfit| unfit.at_name(name))
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Unfit> {
        let (name, value) = &self.table[self.next];
        self.next += 1;
        let read = seed.deserialize(value);
        read.map_err(|refused| refused.within(name))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.table.len() - self.next)
    }
}
