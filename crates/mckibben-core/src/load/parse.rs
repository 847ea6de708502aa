//! Loads as people write them.

use super::{Lever, Load, LoadTable, refused};
use crate::{
    refused::Refused,
    units::{Dimension, parse_quantity},
};

impl Load {
    /// Reads a load; `table` gives the points of a table by the name behind `table:`.
    ///
    /// ```
    /// use mckibben_core::load::Load;
    /// let load = Load::parse("mass:2kg+spring:12N/mm@50N", &|_| None)?;
    /// assert!((load.force_n(10.0) - (2.0 * 9.80665 + 170.0)).abs() < 1e-9);
    /// # Ok::<(), mckibben_core::refused::Refused>(())
    /// ```
    pub fn parse(text: &str, table: &dyn Fn(&str) -> Option<LoadTable>) -> Result<Self, Refused> {
        let mut loads = parts(text)
            .map(|part| parse_part(part.trim(), table))
            .collect::<Result<Vec<_>, _>>()?;
        match (loads.pop(), loads.is_empty()) {
            (Some(only), true) => Ok(only),
            (Some(last), false) => {
                loads.push(last);
                Ok(Self::Sum(loads))
            }
            (None, _) => Err(not_a_load(text)),
        }
    }

    /// The names of the tables that a text speaks of.
    pub fn tables(text: &str) -> impl Iterator<Item = &str> {
        parts(text).filter_map(|part| part.trim().strip_prefix("table:"))
    }
}

/// Parts between plus signs; one that is followed by a digit is an exponent's.
fn parts(text: &str) -> impl Iterator<Item = &str> {
    let next = |at: usize| {
        text[at + 1..]
            .trim_start()
            .starts_with(|c: char| c.is_ascii_alphabetic())
    };
    let cuts: Vec<usize> = text
        .match_indices('+')
        .map(|(at, _)| at)
        .filter(|at| next(*at))
        .collect();
    std::iter::once(0)
        .chain(cuts.clone().into_iter().map(|at| at + 1))
        .zip(cuts.into_iter().chain([text.len()]))
        .map(|(a, b)| &text[a..b])
}

fn not_a_load(text: &str) -> Refused {
    refused(format!(
        "\"{text}\" is not a valid load: write force:300N, mass:20kg, spring:12N/mm@50N, \
         lever:5kg@300mm/40mm/-30deg or table:load.csv, several joined by +"
    ))
}

fn refuse(load: &str, what: &str) -> Refused {
    refused(format!("load {load}: {what}"))
}

fn quantity(load: &str, part: &str, dimension: Dimension) -> Result<f64, Refused> {
    parse_quantity(part, dimension).map_err(|error| refuse(load, &error.to_string()))
}

fn above_zero(load: &str, part: &str, dimension: Dimension, what: &str) -> Result<f64, Refused> {
    match quantity(load, part, dimension)? {
        value if value > 0.0 => Ok(value),
        _ => Err(refuse(load, &format!("{what} must be above zero"))),
    }
}

/// A lever with its mass and the quantities behind `@`.
fn lever(load: &str, mass: &str, behind: &str) -> Result<Load, Refused> {
    let wrong = || {
        refuse(
            load,
            "expected a mass, its distance from the pivot, the pulley's radius and the angle from \
             the horizontal, as in lever:5kg@300mm/40mm/-30deg",
        )
    };
    let (arm, radius, from) = match behind.split('/').collect::<Vec<_>>()[..] {
        [arm, radius] => (arm, radius, None),
        [arm, radius, from] => (arm, radius, Some(from)),
        _ => return Err(wrong()),
    };
    let mass = above_zero(load, mass, Dimension::Mass, "the mass")?;
    let arm = above_zero(load, arm, Dimension::Length, "the distance")?;
    let radius = above_zero(load, radius, Dimension::Length, "the radius")?;
    let from = from.map_or(Ok(0.0), |from| quantity(load, from, Dimension::Angle))?;
    Lever::new(mass, arm, radius, from)
        .map(Load::Lever)
        .ok_or_else(wrong)
}

fn parse_part(text: &str, table: &dyn Fn(&str) -> Option<LoadTable>) -> Result<Load, Refused> {
    let (kind, rest) = text.split_once(':').ok_or_else(|| not_a_load(text))?;
    let (main, behind) = match rest.split_once('@') {
        Some((main, behind)) => (main, Some(behind)),
        None => (rest, None),
    };
    match (kind.trim(), behind) {
        ("table", _) => table(rest)
            .map(Load::Table)
            .ok_or_else(|| refuse(text, "there is no such table")),
        ("force", None) => {
            let force_n = above_zero(text, main, Dimension::Force, "the force")?;
            Ok(Load::Force { force_n })
        }
        ("mass", behind) => Ok(Load::Mass {
            mass_kg: above_zero(text, main, Dimension::Mass, "the mass")?,
            level: match behind.map(str::trim) {
                None => false,
                Some("level") => true,
                Some(_) => {
                    return Err(refuse(
                        text,
                        "expected a hanging mass, such as mass:20kg, or mass:20kg@level",
                    ));
                }
            },
        }),
        ("spring", behind) => Ok(Load::Spring {
            rate_n_per_mm: above_zero(text, main, Dimension::Stiffness, "the rate")?,
            preload_n: behind.map_or(Ok(0.0), |b| quantity(text, b, Dimension::Force))?,
        }),
        ("lever", behind) => lever(text, main, behind.unwrap_or_default()),
        ("force", Some(_)) => Err(refuse(text, "expected a force alone, such as force:300N")),
        _ => Err(not_a_load(text)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Load, Refused> {
        Load::parse(text, &|_| None)
    }

    #[test]
    fn every_kind_is_read() {
        assert_eq!(read("force:0.3kN"), Ok(Load::Force { force_n: 300.0 }));
        assert_eq!(
            read(" mass:500 g @ level "),
            Ok(Load::Mass {
                mass_kg: 0.5,
                level: true
            })
        );
        assert_eq!(
            read("spring:12N/mm"),
            Ok(Load::Spring {
                rate_n_per_mm: 12.0,
                preload_n: 0.0
            })
        );
        let lever = Lever::new(5.0, 300.0, 40.0, -30.0).map(Load::Lever);
        assert_eq!(read("lever:5kg@300mm/4cm/-30deg").ok(), lever);
        let Ok(Load::Sum(both)) = read("mass:5kg + force:1e+2N") else {
            panic!()
        };
        assert_eq!(both.len(), 2);
        assert_eq!(
            Load::tables("mass:1kg+table:a b.csv").collect::<Vec<_>>(),
            ["a b.csv"]
        );
    }

    #[test]
    fn what_is_no_load_is_refused_in_words() {
        for text in [
            "",
            "20kg",
            "mass:",
            "mass:-3kg",
            "mass:20N",
            "weight:3kg",
            "spring:0N/mm",
            "spring:3N/mm@4kg",
            "lever:5kg",
            "lever:5kg@300mm",
            "lever:5kg@300mm/0mm",
            "table:none.csv",
            "mass:NaN",
            "force:1N@2N",
            "mass:2kg+",
            "mass:2kg@wall",
        ] {
            let error = read(text).unwrap_err();
            assert!(!error.to_string().is_empty(), "{text}");
        }
    }
}
