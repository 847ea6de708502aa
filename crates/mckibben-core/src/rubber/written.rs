//! Laws and rubbers as plain data (serde), with the names of the muscle file:
//! `{"law": "gent", "mu": 0.24, "jm": 30}`.
//!
//! Moduli are in MPa. A law that is a sum of terms has a list for each constant:
//! `{"law": "ogden", "mu": [0.6, 0.001], "alpha": [1.3, 5.0]}`.

use super::{Law, LawKind, NEEDS_ALL, foreign, one_of_all};
use crate::nearest::{meant, nearest};
use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{Error, MapAccess, Visitor},
    ser::SerializeMap,
};
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

/// The value of a constant, or one a term.
#[derive(Deserialize)]
#[serde(untagged, expecting = "a number, or a list of numbers")]
enum Numbers {
    One(f64),
    Terms(Vec<f64>),
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
        let mut name: Option<String> = None;
        let mut written: Vec<(String, Numbers)> = vec![];
        while let Some(key) = map.next_key::<String>()? {
            if key == "law" {
                name = Some(map.next_value()?);
            } else if written.iter().any(|w| w.0 == key) {
                return Err(A::Error::custom(format!("{key} is given twice")));
            } else {
                written.push((key, map.next_value()?));
            }
        }
        let name = name
            .ok_or_else(|| A::Error::custom(format!("law is missing; it is {}", one_of_all())))?;
        let kind = Law::kind_named(&name).ok_or_else(|| {
            let meant = meant(nearest(&name, Law::names()));
            A::Error::custom(format!(
                "law \"{name}\" is not known{meant}; expected {}",
                one_of_all()
            ))
        })?;
        law(kind, written).map_err(A::Error::custom)
    }
}

fn law(kind: &LawKind, mut written: Vec<(String, Numbers)>) -> Result<Law, String> {
    if let Some((name, _)) = written
        .iter()
        .find(|w| !kind.names().contains(&w.0.as_str()))
    {
        return Err(format!("{name} {}", foreign(kind)));
    }
    let mut list = |name: &str| {
        let at = written.iter().position(|w| w.0 == name);
        match at.map(|at| written.swap_remove(at).1) {
            Some(Numbers::One(value)) if !kind.is_sum => Ok(vec![value]),
            Some(Numbers::Terms(list)) if kind.is_sum => Ok(list),
            Some(Numbers::One(_)) => Err(format!(
                "{name} is a number; expected a list such as [1.3, 5.0]"
            )),
            Some(Numbers::Terms(_)) => Err(format!("{name} is a list; expected a number")),
            None => Err(format!("{name} is missing; {NEEDS_ALL}")),
        }
    };
    let lists = kind
        .names()
        .into_iter()
        .map(&mut list)
        .collect::<Result<Vec<_>, _>>()?;
    kind.law_of_terms(&lists)
        .map_err(|e| format!("{} {e}", e.fields[0]))
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
                r#"{"law": "neo-hookean", "mu": "1"}"#,
                "a number, or a list of numbers",
            ),
        ] {
            let error = serde_json::from_str::<Law>(text).unwrap_err().to_string();
            assert!(error.contains(said), "{text}: {error}");
        }
    }
}
