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
        let loads = text
            .split('+')
            .map(|part| parse_part(part.trim(), table))
            .collect::<Result<Vec<_>, _>>()?;
        Ok(match <[Self; 1]>::try_from(loads) {
            Ok([only]) => only,
            Err(several) => Self::Sum(several),
        })
    }

    /// The names of the tables that a text speaks of.
    pub fn tables(text: &str) -> impl Iterator<Item = &str> {
        text.split('+')
            .filter_map(|part| part.trim().strip_prefix("table:"))
    }
}

fn not_a_load(text: &str) -> Refused {
    refused(format!(
        "\"{text}\" is not a valid load: give a mass (20 kg), a force (300 N) or a spring (12 N/mm)"
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
    let (kind, rest) = text.split_once(':').unwrap_or(("", text));
    let (main, behind) = match rest.split_once('@') {
        Some((main, behind)) => (main, Some(behind)),
        None => (rest, None),
    };
    // What a quantity alone is says its unit.
    let has_unit = main.trim().parse::<f64>().is_err();
    let is = |name: &str, dimension: Dimension| match kind.trim() {
        "" => has_unit && parse_quantity(main, dimension).is_ok(),
        kind => kind == name,
    };
    if kind.trim() == "table" {
        table(rest)
            .map(Load::Table)
            .ok_or_else(|| refuse(text, "there is no such table"))
    } else if kind.trim() == "lever" {
        lever(text, main, behind.unwrap_or_default())
    } else if is("force", Dimension::Force) {
        if behind.is_some() {
            return Err(refuse(text, "expected a force alone, such as 300 N"));
        }
        Ok(Load::Force {
            force_n: above_zero(text, main, Dimension::Force, "the force")?,
        })
    } else if is("mass", Dimension::Mass) {
        Ok(Load::Mass {
            mass_kg: above_zero(text, main, Dimension::Mass, "the mass")?,
            level: match behind.map(str::trim) {
                None => false,
                Some("level") => true,
                Some(_) => {
                    return Err(refuse(
                        text,
                        "expected a hanging mass, such as 20 kg, or 20 kg@level",
                    ));
                }
            },
        })
    } else if is("spring", Dimension::Stiffness) {
        Ok(Load::Spring {
            rate_n_per_mm: above_zero(text, main, Dimension::Stiffness, "the rate")?,
            preload_n: behind.map_or(Ok(0.0), |b| quantity(text, b, Dimension::Force))?,
        })
    } else {
        Err(not_a_load(text))
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
        for (alone, named) in [
            ("20 kg", "mass:20kg"),
            ("20kg@level", "mass:20kg@level"),
            ("0.3 kN", "force:300N"),
            ("12 N/mm@50N", "spring:12N/mm@50N"),
            ("5 kg + 1e2N", "mass:5kg+force:100N"),
        ] {
            assert_eq!(read(alone).ok(), read(named).ok(), "{alone}");
        }
        let Ok(Load::Sum(both)) = read("mass:5kg + force:1e2N") else {
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
            "20",
            "-20 kg",
            "20 mm",
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
