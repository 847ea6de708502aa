//! Units by themselves, as written in the headings of tables.

use super::{
    convert::convert,
    dimension::{
        Dimension::{self, *},
        Spelled,
    },
};

/// A unit of some dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its usual spelling; empty for a plain ratio.
    pub name: &'static str,
    /// `num / den` that turns it into the unit used inside.
    pub(super) fraction: (f64, f64),
}

impl Unit {
    pub(super) fn new(spelled: &Spelled) -> Self {
        Self {
            name: spelled.0.first().copied().unwrap_or_default(),
            fraction: (spelled.1, spelled.2),
        }
    }

    /// A value in the unit that is used inside (mm, MPa, degrees, N, ratio, N/mm, mm²).
    pub fn inside(self, value: f64) -> f64 {
        convert(value, self.fraction)
    }

    /// `num / den` that turns a value inside into this unit.
    pub fn outside(self) -> (f64, f64) {
        (self.fraction.1, self.fraction.0)
    }
}

/// A plain ratio.
const RATIO: Unit = Unit {
    name: "",
    fraction: (1.0, 1.0),
};

/// Spellings that mean a unit only where it is known what is measured, as in the heading of a
/// column: `Load (kg)` can only be a force. Without regard to case.
const SPOKEN: &[(Dimension, &[&str], &str)] = &[
    (Force, &["kg"], "kgf"),
    (Force, &["lb", "lbs"], "lbf"),
    (Force, &["g"], "gf"),
    (Force, &["newton", "newtons"], "N"),
    (
        Pressure,
        &["psig", "psi(g)", "psi g", "lbf/in2", "lbf/in²"],
        "psi",
    ),
    (Pressure, &["barg", "bar(g)", "bar g", "bar(ü)"], "bar"),
    (Pressure, &["kPag", "kPa(g)", "kPa g"], "kPa"),
    (Pressure, &["MPag", "MPa(g)", "MPa g"], "MPa"),
    (
        Ratio,
        &["percent", "pct", "prozent", "pourcent", "porcentaje"],
        "%",
    ),
    (
        Ratio,
        &["mm/mm", "m/m", "in/in", "-", "–", "1", "ratio"],
        "",
    ),
    (Angle, &["degrees", "degree"], "deg"),
];

/// A spelling in plain form: no raised digits, points between factors, or Greek letters.
fn plain(name: &str) -> String {
    let letter = |c: char| match c {
        '²' => '2',
        '³' => '3',
        '·' | '*' => ' ',
        'µ' | 'μ' => 'u',
        c => c,
    };
    name.chars().filter(|c| *c != '^').map(letter).collect()
}

#[doc(hidden)]
impl Dimension {
    /// The unit of a spelling: exact first, then without regard to case where that leaves one
    /// meaning (`mPa` and `MN` would not, and are refused).
    pub fn unit(self, name: &str) -> Option<Unit> {
        let plain = plain(name);
        let exact = |d: Dimension| {
            d.units()
                .iter()
                .find(|u| u.0.contains(&&*plain))
                .map(Unit::new)
        };
        if let Some(unit) = exact(self) {
            return Some(unit);
        }
        let careful = ["mPa", "MN", "mn", "Mm", "MBAR", "Mbar"];
        if careful.contains(&name) || Dimension::all().any(|d| exact(d).is_some()) {
            return None;
        }
        self.units()
            .iter()
            .find(|u| u.0.iter().any(|s| s.eq_ignore_ascii_case(&plain)))
            .map(Unit::new)
    }

    /// The unit that a word means in the heading of a column of this dimension: what people type as
    /// a quantity, and what they only say (`Load (kg)`, `bar(g)`, `percent`).
    pub fn heading_unit(self, word: &str) -> Option<Unit> {
        self.unit(word).or_else(|| {
            let lower = word.to_lowercase();
            let said = |s: &&(Dimension, &[&str], &str)| {
                s.0 == self && s.1.iter().any(|spelling| spelling.to_lowercase() == lower)
            };
            let name = SPOKEN.iter().find(said)?.2;
            if name.is_empty() {
                Some(RATIO)
            } else {
                self.unit(name)
            }
        })
    }

    /// The unit used inside.
    pub fn unit_inside(self) -> Unit {
        self.units()
            .iter()
            .find(|u| u.1 == u.2)
            .map(Unit::new)
            .unwrap_or(RATIO)
    }

    /// The usual spellings of all its units, for messages.
    pub fn unit_names(self) -> Vec<&'static str> {
        self.units()
            .iter()
            .filter_map(|u| u.0.first().copied())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_heading_may_say_what_nobody_types() {
        let said = Dimension::Force.heading_unit("kg");
        assert_eq!(said.map(|u| u.inside(1.0)), Some(9.80665));
        assert_eq!(Dimension::Force.unit("kg"), None);
    }

    /// Definitions: CODATA 2018, table of conversion factors (NIST SP 811, appendix B.8).
    #[test]
    fn units_have_the_values_of_their_definitions() {
        let cases = [
            (Dimension::Pressure, "psi(g)", 6.894_757_293_168_361e-3),
            (Dimension::Pressure, "mbar", 1e-4),
            (Dimension::Pressure, "hPa", 1e-4),
            (Dimension::Pressure, "kgf/cm²", 0.098_066_5),
            (Dimension::Pressure, "atm", 0.101_325),
            (Dimension::Pressure, "BAR", 0.1),
            (Dimension::Force, "lb", 4.448_221_615_260_5),
            (Dimension::Force, "gf", 9.806_65e-3),
            (Dimension::Force, "mN", 1e-3),
            (Dimension::Length, "inches", 25.4),
            (Dimension::Ratio, "Percent", 0.01),
            (Dimension::Ratio, "mm/mm", 1.0),
        ];
        for (dimension, name, value) in cases {
            let unit = dimension
                .heading_unit(name)
                .unwrap_or_else(|| panic!("{name}"));
            assert!(
                (unit.inside(1.0) - value).abs() <= 1e-14 * value,
                "{name}: {unit:?}"
            );
        }
    }

    #[test]
    fn what_could_be_two_things_is_none() {
        for (dimension, name) in [
            (Dimension::Pressure, "mPa"),
            (Dimension::Force, "MN"),
            (Dimension::Force, "mm"),
            (Dimension::Pressure, "bara"),
        ] {
            assert_eq!(dimension.heading_unit(name), None, "{name}");
        }
        assert_eq!(Dimension::Ratio.unit_inside().name, "");
        assert_eq!(Dimension::Pressure.unit_inside().name, "MPa");
    }
}
