//! Quantities as types: what a field of a request or a key of a file holds, and how it is read.
//!
//! As text each takes a number with a unit (`2.5bar`); in JSON and TOML a bare number in the unit
//! inside, or such a text. It is written as a bare number, under a name that carries the unit.

use super::{
    dimension::Dimension,
    quantity::{BOUNDS, QuantityError, parse_quantity, plausible},
    range::{RangeError, Values, parse_values},
};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{
    Deserialize, Deserializer, Serialize,
    de::{
        Error, IntoDeserializer, MapAccess, SeqAccess, Visitor,
        value::{MapAccessDeserializer, SeqAccessDeserializer},
    },
};
use std::{borrow::Cow, fmt, marker::PhantomData, ops::Deref, str::FromStr};

/// A number of a dimension, in the unit inside.
pub trait Quantity: Copy + From<f64> + Into<f64> {
    /// What it measures.
    const DIMENSION: Dimension;
}

/// A plain number, which has no unit.
impl Quantity for f64 {
    const DIMENSION: Dimension = Dimension::Ratio;
}

/// A type for each dimension.
macro_rules! quantities {
    ($($(#[$about:meta])* $name:ident)*) => {$(
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default, Serialize)]
        #[serde(transparent)]
        pub struct $name(pub f64);

        impl Quantity for $name {
            const DIMENSION: Dimension = Dimension::$name;
        }

        impl From<f64> for $name {
            fn from(inside: f64) -> Self {
                Self(inside)
            }
        }

        impl From<$name> for f64 {
            fn from(quantity: $name) -> Self {
                quantity.0
            }
        }

        impl FromStr for $name {
            type Err = QuantityError;

            fn from_str(text: &str) -> Result<Self, QuantityError> {
                parse_quantity(text, Dimension::$name).map(Self)
            }
        }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                read_number(Dimension::$name, from).map(Self)
            }
        }

        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }

            fn inline_schema() -> bool {
                true
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                number_schema(Dimension::$name)
            }
        }
    )*};
}

quantities! {
    /// In mm.
    Length
    /// In MPa.
    Pressure
    /// In degrees.
    Angle
    /// In N.
    Force
    /// A plain number, or a percentage.
    Ratio
    /// Of a strand family or a spring, in N/mm.
    Stiffness
    /// In mm/N.
    Compliance
    /// In mm².
    Area
    /// In kg.
    Mass
    /// In N m.
    Torque
    /// Of a joint, in N m/rad.
    AngularStiffness
    /// In kg m².
    Inertia
    /// In s.
    Time
    /// In Hz.
    Frequency
    /// In °C.
    Temperature
    /// Sonic conductance in L/(s bar).
    Conductance
    /// In N s/m.
    Damping
    /// Of a joint, in N m s/rad.
    AngularDamping
    /// In mm³.
    Volume
    /// In kg/m³.
    Density
    /// In mm³/s.
    Flow
}

impl Pressure {
    /// Of a number in MPa.
    pub const fn mpa(mpa: f64) -> Self {
        Self(mpa)
    }

    /// Of a number in bar.
    pub const fn bar(bar: f64) -> Self {
        Self(bar / 10.0)
    }
}

fn number_schema(dimension: Dimension) -> Schema {
    let mut schema = json_schema!({ "type": "number", "x-quantity": dimension });
    let unit = dimension.unit_inside().name;
    if !unit.is_empty() {
        schema.insert("x-unit".into(), unit.into());
    }
    schema
}

/// A number in the unit inside, or a text with a unit.
pub fn read_number<'de, D: Deserializer<'de>>(
    dimension: Dimension,
    from: D,
) -> Result<f64, D::Error> {
    let parse = |text: &str| parse_quantity(text, dimension);
    let value = text_or_number(&dimension.expectation(), parse, |inside| inside, from)?;
    // What is not finite has words of its own, or is a limit that is none.
    if plausible(value) || !value.is_finite() {
        return Ok(value);
    }
    Err(D::Error::custom(format!(
        "{value:e} is outside the allowed range ({BOUNDS})"
    )))
}

/// Reads a text, or a number; `expected` says in messages what may be there.
pub fn text_or_number<'de, T, D: Deserializer<'de>>(
    expected: &dyn fmt::Display,
    of_text: impl FnOnce(&str) -> Result<T, QuantityError>,
    of_number: impl FnOnce(f64) -> T,
    from: D,
) -> Result<T, D::Error> {
    struct TextOrNumber<'e, F, G>(&'e dyn fmt::Display, F, G);

    impl<T, F, G> Visitor<'_> for TextOrNumber<'_, F, G>
    where
        F: FnOnce(&str) -> Result<T, QuantityError>,
        G: FnOnce(f64) -> T,
    {
        type Value = T;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            self.0.fmt(f)
        }

        fn visit_f64<E: Error>(self, inside: f64) -> Result<T, E> {
            Ok(self.2(inside))
        }

        fn visit_i64<E: Error>(self, inside: i64) -> Result<T, E> {
            Ok(self.2(inside as f64))
        }

        fn visit_u64<E: Error>(self, inside: u64) -> Result<T, E> {
            Ok(self.2(inside as f64))
        }

        fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
            self.1(text).map_err(E::custom)
        }
    }

    from.deserialize_any(TextOrNumber(expected, of_text, of_number))
}

/// Reads a quantity into a number in the unit inside.
pub fn read_quantity<'de, Q: Deserialize<'de> + Into<f64>, D: Deserializer<'de>>(
    from: D,
) -> Result<f64, D::Error> {
    Q::deserialize(from).map(Into::into)
}

/// Reads two quantities.
pub fn pair<'de, Q: Deserialize<'de> + Into<f64>, D: Deserializer<'de>>(
    from: D,
) -> Result<(f64, f64), D::Error> {
    <(Q, Q)>::deserialize(from).map(|(first, second)| (first.into(), second.into()))
}

/// Reads a list of quantities.
pub fn several<'de, Q: Deserialize<'de> + Into<f64>, D: Deserializer<'de>>(
    from: D,
) -> Result<Vec<f64>, D::Error> {
    Vec::<Q>::deserialize(from).map(|list| list.into_iter().map(Into::into).collect())
}

/// Parts of an interval without a step, where a list is needed.
const DIVISIONS: usize = 20;

/// Several quantities: as text a list or a range, `1,2,3bar` or `0..0.25:0.01`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(transparent)]
pub struct List<Q>(pub Vec<f64>, PhantomData<Q>);

impl<Q> Default for List<Q> {
    fn default() -> Self {
        vec![].into()
    }
}

impl<Q> From<Vec<f64>> for List<Q> {
    fn from(inside: Vec<f64>) -> Self {
        Self(inside, PhantomData)
    }
}

impl<Q> Deref for List<Q> {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.0
    }
}

impl<Q: Quantity> FromStr for List<Q> {
    type Err = RangeError;

    fn from_str(text: &str) -> Result<Self, RangeError> {
        Ok(parse_values(text, Q::DIMENSION)?.sampled(DIVISIONS).into())
    }
}

impl<'de, Q: Quantity + Deserialize<'de>> Deserialize<'de> for List<Q> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        Ok(match Choice::<Q>::deserialize(from)? {
            Choice::One(one) => vec![one.into()],
            Choice::Several(list) => list.into_iter().map(Into::into).collect(),
            Choice::Between { low, high } => {
                Values::Interval(low.into(), high.into()).sampled(DIVISIONS)
            }
        }
        .into())
    }
}

impl<Q: JsonSchema> JsonSchema for List<Q> {
    fn schema_name() -> Cow<'static, str> {
        format!("List_of_{}", Q::schema_name()).into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = json_schema!({ "type": "array", "items": Q::json_schema(generator) });
        for key in ["x-quantity", "x-unit"] {
            if let Some(value) = schema.get("items").and_then(|item| item.get(key)).cloned() {
                schema.insert(key.to_owned(), value);
            }
        }
        schema
    }
}

/// Values to search through: one, several, or all between two; as text `30`, `30,40` or `20..40`.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Choice<Q> {
    /// One value.
    One(Q),
    /// These values.
    Several(Vec<Q>),
    /// An interval.
    Between {
        /// Its lower end.
        low: Q,
        /// Its upper end.
        high: Q,
    },
}

impl<Q: Quantity> From<Values> for Choice<Q> {
    fn from(values: Values) -> Self {
        match values {
            Values::List(list) => match list[..] {
                [one] => Self::One(one.into()),
                _ => Self::Several(list.into_iter().map(Into::into).collect()),
            },
            Values::Interval(low, high) => Self::Between {
                low: low.into(),
                high: high.into(),
            },
        }
    }
}

impl<Q: Quantity> FromStr for Choice<Q> {
    type Err = RangeError;

    fn from_str(text: &str) -> Result<Self, RangeError> {
        Ok(parse_values(text, Q::DIMENSION)?.into())
    }
}

impl<'de, Q: Quantity + Deserialize<'de>> Deserialize<'de> for Choice<Q> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(Searched(PhantomData))
    }
}

/// Reads a number, a text, a list, or `low` and `high`.
struct Searched<Q>(PhantomData<Q>);

impl<'de, Q: Quantity + Deserialize<'de>> Visitor<'de> for Searched<Q> {
    type Value = Choice<Q>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a list of numbers, or `low` and `high`")
    }

    fn visit_f64<E: Error>(self, inside: f64) -> Result<Choice<Q>, E> {
        Q::deserialize(inside.into_deserializer()).map(Choice::One)
    }

    fn visit_i64<E: Error>(self, inside: i64) -> Result<Choice<Q>, E> {
        self.visit_f64(inside as f64)
    }

    fn visit_u64<E: Error>(self, inside: u64) -> Result<Choice<Q>, E> {
        self.visit_f64(inside as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Choice<Q>, E> {
        text.parse().map_err(E::custom)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Choice<Q>, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(seq)).map(Choice::Several)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Choice<Q>, A::Error> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Between<Q> {
            low: Q,
            high: Q,
        }

        let Between { low, high } = Between::deserialize(MapAccessDeserializer::new(map))?;
        Ok(Choice::Between { low, high })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Definitions: 1 bar = 0.1 MPa, 1 in = 25.4 mm, 1 % = 0.01.
    #[test]
    fn a_text_with_a_unit_and_a_bare_number_are_the_same_quantity() {
        assert_eq!("2.5bar".parse(), Ok(Pressure(0.25)));
        for (json, value) in [("30", 30.0), ("\"30 mm\"", 30.0), ("\"1in\"", 25.4)] {
            let read: Length = serde_json::from_str(json).unwrap();
            assert_eq!(read, Length(value), "{json}");
        }
        assert_eq!(serde_json::to_string(&Pressure(0.25)).unwrap(), "0.25");
        let error = serde_json::from_str::<Length>("\"30bar\"").unwrap_err();
        assert!(error.to_string().contains("is a pressure"), "{error}");
    }

    /// The command line's bounds, 1e-30 to 1e30 or 0, hold for numbers of JSON.
    #[test]
    fn a_number_has_the_bounds_of_a_text() {
        for wrong in ["5e-324", "1e300", "-1e31", "1e-31"] {
            let said = wrong.parse::<Pressure>().unwrap_err().to_string();
            assert!(said.contains("is outside the allowed range"), "{said}");
            for read in [
                serde_json::from_str::<Pressure>(wrong).err(),
                serde_json::from_str::<List<Pressure>>(wrong).err(),
                serde_json::from_str::<List<Pressure>>(&format!("[0.1, {wrong}]")).err(),
                serde_json::from_str::<Choice<Length>>(wrong).err(),
            ] {
                let said = read.unwrap().to_string();
                assert!(
                    said.contains("is outside the allowed range (1e-30"),
                    "{said}"
                );
            }
        }
        for right in ["0", "1e-30", "-1e30"] {
            assert!(serde_json::from_str::<Pressure>(right).is_ok(), "{right}");
        }
    }

    #[test]
    fn lists_and_choices_read_numbers_texts_and_ranges() {
        for json in [
            "[0, 0.1, 0.2]",
            "\"0..2:1bar\"",
            "[0, \"1bar\", \"200kPa\"]",
        ] {
            let read: List<Pressure> = serde_json::from_str(json).unwrap();
            assert_eq!(read.0, [0.0, 0.1, 0.2], "{json}");
        }
        let between = Choice::Between {
            low: Length(20.0),
            high: Length(40.0),
        };
        assert_eq!("20..40".parse(), Ok(between.clone()));
        let read: Choice<Length> = serde_json::from_str(r#"{"low": 20, "high": "4cm"}"#).unwrap();
        assert_eq!(read, between);
        assert_eq!("30".parse(), Ok(Choice::One(Length(30.0))));
    }
}
