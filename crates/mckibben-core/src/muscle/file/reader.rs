//! TOML → structs, by serde: an error names the key, the value that was found and what is expected.

use super::keys::join;
use crate::{
    nearest::{meant, nearest},
    units::plausible,
};
use serde::{
    de::{
        DeserializeSeed, Deserializer, Error, Expected, IntoDeserializer, MapAccess, Unexpected,
        Visitor, value::SeqDeserializer,
    },
    forward_to_deserialize_any,
};
use std::fmt;
use toml_edit::{ArrayOfTables, Item, TableLike, Value};

/// What is expected, for messages.
pub const PLAIN: &str = "a number without unit, such as 0.8";
pub const TEXT: &str = "a text in quotes";
pub const LIST: &str = "a list";
/// The only tuples in files.
pub const PAIR: &str = "a pair";
pub const TABLE: &str = "a table of keys";

/// Why a value is not what its struct needs.
#[derive(Debug)]
pub struct Wrong {
    /// The dotted key, once it is known.
    pub path: Option<String>,
    pub problem: Wrongness,
}

/// What is wrong there.
#[derive(Debug)]
pub enum Wrongness {
    /// A sentence that the key is before.
    Said(String),
    /// What there is, once it is known, and what is expected.
    Expected(Option<&'static str>, String),
    /// The table has a key that its struct has not.
    Unknown(String),
    /// The table has not this key.
    Missing(&'static str),
}

impl Wrong {
    /// The same at a dotted key, where it has none.
    fn at(mut self, path: String) -> Self {
        self.path.get_or_insert(path);
        self
    }
}

impl From<Wrongness> for Wrong {
    fn from(problem: Wrongness) -> Self {
        Self {
            path: None,
            problem,
        }
    }
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.problem)
    }
}

impl std::error::Error for Wrong {}

impl Error for Wrong {
    fn custom<T: fmt::Display>(said: T) -> Self {
        Wrongness::Said(said.to_string()).into()
    }

    /// What there is, the value knows better than the visitor.
    fn invalid_type(_: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Wrongness::Expected(None, expected.to_string()).into()
    }

    fn unknown_field(key: &str, _: &'static [&'static str]) -> Self {
        Wrongness::Unknown(key.into()).into()
    }

    fn missing_field(key: &'static str) -> Self {
        Wrongness::Missing(key).into()
    }
}

enum Node<'s> {
    Table(&'s dyn TableLike),
    Tables(&'s ArrayOfTables),
    Nothing,
    Value(&'s Value),
}

impl<'s> From<&'s Value> for Node<'s> {
    fn from(value: &'s Value) -> Self {
        match value {
            Value::InlineTable(table) => Self::Table(table),
            value => Self::Value(value),
        }
    }
}

impl<'s> From<&'s Item> for Node<'s> {
    fn from(item: &'s Item) -> Self {
        match item {
            Item::Table(table) => Self::Table(table),
            Item::Value(value) => value.into(),
            Item::ArrayOfTables(tables) => Self::Tables(tables),
            Item::None => Self::Nothing,
        }
    }
}

/// What is at a dotted key; of an element of a list, that of the list; of a table in a list, with
/// its number behind it.
pub struct At<'s> {
    path: String,
    node: Node<'s>,
}

impl<'s> At<'s> {
    pub fn root(item: &'s Item) -> Self {
        Self {
            path: String::new(),
            node: item.into(),
        }
    }

    fn list(&self) -> Option<Vec<At<'s>>> {
        let value = |value: &'s Value| At {
            path: self.path.clone(),
            node: value.into(),
        };
        let table = |(table, number): (&'s toml_edit::Table, usize)| At {
            path: join(&self.path, &number.to_string()),
            node: Node::Table(table),
        };
        match self.node {
            Node::Value(Value::Array(array)) => Some(array.iter().map(value).collect()),
            Node::Tables(tables) => Some(tables.iter().zip(1..).map(table).collect()),
            _ => None,
        }
    }

    fn is(&self) -> &'static str {
        match self.node {
            Node::Table(_) => "a table",
            Node::Tables(_) => "a list of tables",
            Node::Nothing => "nothing",
            Node::Value(value) => match value {
                Value::Array(_) => LIST,
                Value::Boolean(_) => "true or false",
                Value::Float(x) if !x.value().is_finite() => "not a finite number",
                Value::Float(x) if !plausible(*x.value()) => "a number beyond 1e-30 to 1e30",
                Value::Float(_) | Value::Integer(_) => "a number",
                Value::String(_) => "a text",
                Value::Datetime(_) | Value::InlineTable(_) => "a date or time",
            },
        }
    }

    /// Something else than was expected.
    fn is_not(&self, expected: &dyn Expected) -> Wrong {
        Wrongness::Expected(Some(self.is()), expected.to_string()).into()
    }
}

/// A method for values of one kind.
macro_rules! only {
    ($($method:ident: $pattern:pat, $expected:expr;)*) => {$(
        fn $method<V: Visitor<'s>>(self, visitor: V) -> Result<V::Value, Wrong> {
            match self.node {
                $pattern => self.deserialize_any(visitor),
                _ => Err(self.is_not(&$expected)),
            }
        }
    )*};
}

impl<'s> Deserializer<'s> for At<'s> {
    type Error = Wrong;

    fn deserialize_any<V: Visitor<'s>>(self, visitor: V) -> Result<V::Value, Wrong> {
        let is = self.is();
        let read = match self.node {
            Node::Table(table) => Entries::new(self.path, table, &[]).read(visitor),
            Node::Value(Value::String(text)) => visitor.visit_borrowed_str(text.value()),
            Node::Value(Value::Integer(i)) => visitor.visit_i64(*i.value()),
            Node::Value(Value::Float(x)) if plausible(*x.value()) => visitor.visit_f64(*x.value()),
            Node::Value(Value::Boolean(is)) => visitor.visit_bool(*is.value()),
            _ => match self.list() {
                Some(list) => visitor.visit_seq(SeqDeserializer::new(list.into_iter())),
                None => Err(self.is_not(&visitor)),
            },
        };
        read.map_err(|mut wrong| {
            if let Wrongness::Expected(given, _) = &mut wrong.problem {
                given.get_or_insert(is);
            }
            wrong
        })
    }

    only! {
        deserialize_bool: Node::Value(Value::Boolean(_)), "true or false, without quotes";
        deserialize_f64: Node::Value(Value::Integer(_) | Value::Float(_)), PLAIN;
        deserialize_str: Node::Value(Value::String(_)), TEXT;
        deserialize_string: Node::Value(Value::String(_)), TEXT;
        deserialize_seq: Node::Value(Value::Array(_)) | Node::Tables(_), LIST;
        deserialize_map: Node::Table(_), TABLE;
    }

    fn deserialize_u64<V: Visitor<'s>>(self, visitor: V) -> Result<V::Value, Wrong> {
        let number = match self.node {
            Node::Value(Value::Integer(i)) => *i.value() as f64,
            Node::Value(Value::Float(x)) => *x.value(),
            _ => return Err(self.is_not(&PLAIN)),
        };
        if number.fract() == 0.0 && (0.0..=1e15).contains(&number) {
            visitor.visit_u64(number as u64)
        } else {
            Err(Wrong::custom("must be a whole number, zero or above"))
        }
    }

    /// The keys in the order of the struct: a table can begin with what the others depend on.
    fn deserialize_struct<V: Visitor<'s>>(
        self,
        _: &'static str,
        keys: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        match self.node {
            Node::Table(table) => Entries::new(self.path, table, keys).read(visitor),
            _ => Err(self.is_not(&TABLE)),
        }
    }

    fn deserialize_tuple<V: Visitor<'s>>(
        self,
        count: usize,
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        match self.list().filter(|list| list.len() == count) {
            Some(list) => visitor.visit_seq(SeqDeserializer::new(list.into_iter())),
            None => Err(self.is_not(&PAIR)),
        }
    }

    fn deserialize_enum<V: Visitor<'s>>(
        self,
        _: &'static str,
        words: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        let expected = format!("one of {}", words.join(", "));
        let Node::Value(Value::String(text)) = self.node else {
            return Err(self.is_not(&expected.as_str()));
        };
        let text = text.value().trim();
        if words.contains(&text) {
            return visitor.visit_enum(IntoDeserializer::<Wrong>::into_deserializer(text));
        }
        let near = meant(nearest(text, words.iter().copied()));
        Err(Wrong::custom(format!(
            "is not known{near}; expected {expected}"
        )))
    }

    fn deserialize_option<V: Visitor<'s>>(self, visitor: V) -> Result<V::Value, Wrong> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'s>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_u32<V: Visitor<'s>>(self, visitor: V) -> Result<V::Value, Wrong> {
        self.deserialize_u64(visitor)
    }

    forward_to_deserialize_any! {
        <V: Visitor<'s>>
        i8 i16 i32 i64 u8 u16 f32 char bytes byte_buf unit unit_struct tuple_struct identifier
        ignored_any
    }
}

impl<'s> IntoDeserializer<'s, Wrong> for At<'s> {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

/// The entries of a table.
struct Entries<'s> {
    path: String,
    entries: std::vec::IntoIter<(&'s str, &'s Item)>,
    value: Option<At<'s>>,
}

impl<'s> Entries<'s> {
    fn new(path: String, table: &'s dyn TableLike, keys: &[&str]) -> Self {
        let mut entries: Vec<_> = table.iter().collect();
        let place = |key| keys.iter().position(|known| *known == key);
        entries.sort_by_key(|(key, _)| place(*key).unwrap_or(keys.len()));
        Self {
            path,
            entries: entries.into_iter(),
            value: None,
        }
    }

    fn read<V: Visitor<'s>>(self, visitor: V) -> Result<V::Value, Wrong> {
        let path = self.path.clone();
        visitor.visit_map(self).map_err(|wrong| wrong.at(path))
    }
}

impl<'s> MapAccess<'s> for Entries<'s> {
    type Error = Wrong;

    fn next_key_seed<K: DeserializeSeed<'s>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Wrong> {
        let Some((key, item)) = self.entries.next() else {
            return Ok(None);
        };
        self.value = Some(At {
            path: join(&self.path, key),
            node: item.into(),
        });
        let key = IntoDeserializer::<Wrong>::into_deserializer(key);
        seed.deserialize(key).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'s>>(&mut self, seed: V) -> Result<V::Value, Wrong> {
        let Some(at) = self.value.take() else {
            return Err(Wrong::custom("has no value"));
        };
        let path = at.path.clone();
        seed.deserialize(at).map_err(|wrong| wrong.at(path))
    }
}
