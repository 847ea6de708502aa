//! Tables of a muscle file that hold measures, and other keys beside them.

use super::error::without_key;
use crate::muscle::{
    Measure,
    measures::{END_FACTOR, MeasureValues, STIFFNESS, of_section},
};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{
    Deserialize,
    de::{
        DeserializeOwned, DeserializeSeed, Deserializer, Error, IntoDeserializer, MapAccess,
        Visitor, value::MapAccessDeserializer,
    },
};
use serde_json::{Map, Value};
use std::{borrow::Cow, fmt, marker::PhantomData};

/// The keys of a table beside its measures.
pub trait Beside: DeserializeOwned + JsonSchema + Default {
    const TABLE: &'static str;
}

/// A table: its measures and its other keys.
#[derive(Debug, Default)]
pub struct Table<T> {
    /// The measures.
    pub measures: MeasureValues,
    /// The other keys.
    pub other: T,
}

/// The measures of a table; what is more than a number there has its field in the struct of the
/// table.
fn plain(table: &str) -> impl Iterator<Item = &'static Measure> {
    of_section(table).filter(|m| ![&END_FACTOR, &STIFFNESS].contains(m))
}

impl<'de, T: Beside> Deserialize<'de> for Table<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_map(Reader(PhantomData))
    }
}

struct Reader<T>(PhantomData<T>);

impl<'de, T: Beside> Visitor<'de> for Reader<T> {
    type Value = Table<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(super::reader::TABLE)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Table<T>, A::Error> {
        let mut measures = MeasureValues::default();
        let take = |key: &str, map: &mut A| {
            let Some(measure) = plain(T::TABLE).find(|m| m.name() == key) else {
                return Ok(false);
            };
            measures.set(measure, map.next_value_seed(Number(measure))?);
            Ok(true)
        };
        let other = T::deserialize(MapAccessDeserializer::new(Rest { map, take }))?;
        Ok(Table { measures, other })
    }
}

/// Reads a value that its measure may have.
struct Number(&'static Measure);

impl<'de> DeserializeSeed<'de> for Number {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<f64, D::Error> {
        let value = self.0.read(from)?;
        let checked = self.0.check(value);
        let wrong = |error| D::Error::custom(without_key(&error, self.0.key));
        checked.map(|()| value).map_err(wrong)
    }
}

/// The keys of a table that `take` does not take.
pub struct Rest<A, F> {
    pub map: A,
    pub take: F,
}

impl<'de, A, F> MapAccess<'de> for Rest<A, F>
where
    A: MapAccess<'de>,
    F: FnMut(&str, &mut A) -> Result<bool, A::Error>,
{
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, A::Error> {
        while let Some(key) = self.map.next_key::<String>()? {
            if !(self.take)(&key, &mut self.map)? {
                return seed.deserialize(key.into_deserializer()).map(Some);
            }
        }
        Ok(None)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        self.map.next_value_seed(seed)
    }
}

impl<T: Beside> JsonSchema for Table<T> {
    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = T::json_schema(generator);
        let measures = plain(T::TABLE).map(|m| (m.name().to_owned(), m.file_schema()));
        let mut properties: Map<String, Value> = measures.collect();
        if let Some(Value::Object(other)) = schema.remove("properties") {
            properties.extend(other);
        }
        schema.insert("properties".into(), properties.into());
        schema
    }
}
