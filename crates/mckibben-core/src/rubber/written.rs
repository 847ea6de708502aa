//! Laws and rubbers as plain data (serde), with the names of the muscle file:
//! `{"law": "gent", "mu": 0.24, "jm": 30}`.
//!
//! Moduli are in MPa. A law that is a sum of terms has a list for each constant:
//! `{"law": "ogden", "mu": [0.6, 0.001], "alpha": [1.3, 5.0]}`.

use super::{
    Constant, Law, LawKind,
    constant::{NEEDS_ALL, foreign, one_of_all},
};
use crate::{
    nearest::{meant, nearest},
    refused::Refused,
    units::{Dimension, typed::read_number},
};
use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{Error, MapAccess, Visitor},
    ser::SerializeMap,
};
use serde_json::{Map, Value, map::Entry};
use std::fmt;

impl Serialize for Law {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let kind = self.kind();
        let values = self.values();
        let count = kind.constants.len();
        let mut map = serializer.serialize_map(Some(1 + count))?;
        map.serialize_entry("law", kind.name)?;
        for (i, constant) in kind.constants.iter().enumerate() {
            let terms: Vec<f64> = values.iter().copied().skip(i).step_by(count).collect();
            match terms.first() {
                Some(value) if !kind.is_sum => map.serialize_entry(constant.name, value)?,
                _ => map.serialize_entry(constant.name, &terms)?,
            }
        }
        map.end()
    }
}

struct Reader;

impl<'de> Visitor<'de> for Reader {
    type Value = Law;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "a rubber law with its constants, such as {{\"law\": \"neo-hookean\", \"mu\": 0.2}}"
        )
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Law, A::Error> {
        let mut written = Map::new();
        while let Some((key, value)) = map.next_entry::<String, Value>()? {
            if let Entry::Occupied(twice) = written.entry(&key) {
                return Err(A::Error::custom(format!("{} is given twice", twice.key())));
            }
            written.insert(key, value);
        }
        law_of(&written).map_err(A::Error::custom)
    }
}

/// The law of what is written: its name and its constants.
///
/// # Errors
/// [`Refused`] with the keys to blame; the first of them is before its sentence.
pub fn law_of(written: &Map<String, Value>) -> Result<Law, Refused> {
    let wrong = |key: &'static str, said: &str| Refused::new([key, "law"], format!("{key} {said}"));
    let missing = || wrong("law", &format!("is missing; it is {}", one_of_all()));
    let name = written.get("law").ok_or_else(missing)?;
    let word = name.as_str().unwrap_or_default().trim();
    let kind = Law::kind_named(word).ok_or_else(|| {
        let meant = meant(nearest(word, Law::names()));
        wrong(
            "law",
            &format!("{name} is not known{meant}; expected {}", one_of_all()),
        )
    })?;
    let names = kind.names();
    let is_foreign = |key: &&String| *key != "law" && !names.contains(&key.as_str());
    if let Some(key) = written.keys().find(is_foreign) {
        let fields = Law::KINDS
            .iter()
            .flat_map(LawKind::names)
            .filter(|name| name == key)
            .chain(["law"]);
        return Err(Refused::new(fields, format!("{key} {}", foreign(kind))));
    }
    let one = |constant: &Constant, value: &Value| match constant.dimension {
        Dimension::Ratio => f64::deserialize(value),
        dimension => read_number(dimension, value),
    };
    let list = |constant: &Constant| {
        let wrong = |said: &str| wrong(constant.name, said);
        let numbers = match written.get(constant.name) {
            Some(Value::Array(terms)) if kind.is_sum => {
                terms.iter().map(|value| one(constant, value)).collect()
            }
            Some(Value::Array(_)) => return Err(wrong("is a list; expected a number")),
            Some(Value::Number(_)) if kind.is_sum => {
                return Err(wrong("is a number; expected a list such as [1.3, 5.0]"));
            }
            Some(value) => one(constant, value).map(|number| vec![number]),
            None => return Err(wrong(&format!("is missing; {NEEDS_ALL}"))),
        };
        numbers.map_err(|error| wrong(&error.to_string()))
    };
    let lists = kind
        .constants
        .iter()
        .map(list)
        .collect::<Result<Vec<_>, _>>()?;
    kind.law_of_terms(&lists)
        .map_err(|e| wrong(e.fields[0], &e.message))
}

impl<'de> Deserialize<'de> for Law {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Law, D::Error> {
        deserializer.deserialize_map(Reader)
    }
}

#[cfg(test)]
mod tests {
    use crate::rubber::Law;

    #[test]
    fn every_law_comes_back_from_its_data() {
        for law in Law::examples() {
            let text = serde_json::to_string(&law).unwrap();
            assert!(
                text.starts_with(&format!("{{\"law\":\"{}\",", law.name())),
                "{text}"
            );
            assert_eq!(serde_json::from_str::<Law>(&text).unwrap(), law, "{text}");
        }
        let ogden = Law::named("ogden", &[0.6, 1.3, -0.01, -2.0]).unwrap();
        let text = serde_json::to_string(&ogden).unwrap();
        assert_eq!(
            text,
            r#"{"law":"ogden","mu":[0.6,-0.01],"alpha":[1.3,-2.0]}"#
        );
    }

    #[test]
    fn data_that_make_no_law_are_refused_in_the_words_of_the_muscle_file() {
        for (text, said) in [
            (
                r#"{"mu": 1}"#,
                "law is missing; it is one of mooney-rivlin, neo-hookean",
            ),
            (
                r#"{"law": "gant", "mu": 1}"#,
                "law \"gant\" is not known (did you mean gent?); expected one of",
            ),
            (
                r#"{"law": "gent", "mu": 1}"#,
                "jm is missing; a law needs all of its constants",
            ),
            (
                r#"{"law": "neo-hookean", "mu": 1, "c10": 1}"#,
                "c10 is not a constant of the neo-hookean law; its constants are mu",
            ),
            (
                r#"{"law": "neo-hookean", "mu": 1, "mu": 1}"#,
                "mu is given twice",
            ),
            (
                r#"{"law": "neo-hookean", "mu": [1]}"#,
                "mu is a list; expected a number",
            ),
            (
                r#"{"law": "ogden", "mu": 1, "alpha": [2]}"#,
                "mu is a number; expected a list such as",
            ),
            (
                r#"{"law": "ogden", "mu": [1, 2], "alpha": [2]}"#,
                "alpha has 1 numbers, but mu has 2; an ogden law needs one alpha for each mu",
            ),
            (
                r#"{"law": "neo-hookean", "mu": "one"}"#,
                "mu \"one\" does not start with a number; expected a pressure",
            ),
        ] {
            let error = serde_json::from_str::<Law>(text).unwrap_err().to_string();
            assert!(error.contains(said), "{text}: {error}");
        }
    }
}
