//! Units in which people are shown what is in mm, MPa and N inside.

use crate::words::{half_width, number};
use mckibben_core::{
    joined,
    units::{Dimension, Unit},
};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::{borrow::Cow, fmt, str::FromStr};

/// Values inside (MPa, N, mm, and quotients of these) below every measurement: zero but for
/// rounding.
const NOTHING: f64 = 1e-9;

/// Between number and unit of a quantity in a sentence; moduli and stresses, which stay in MPa,
/// have a plain space.
const JOIN: char = '\u{a0}';

/// How one kind of quantity is shown.
#[must_use]
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// The unit's name.
    pub name: Cow<'static, str>,
    /// By what a value inside is multiplied.
    factor: (f64, f64),
    /// Significant digits of what is shown.
    pub digits: usize,
}

/// Numbers without a unit.
pub const NUMBER: Scale = Scale::fixed("");
/// Ratios, in per cent.
pub const PERCENT: Scale = Scale::constant("%", 100.0);
/// Angles.
pub const DEGREES: Scale = Scale::fixed("°");
/// Masses.
pub const GRAMS: Scale = Scale::fixed("g");
/// Energies.
pub const JOULES: Scale = Scale::fixed("J");
/// Moduli and stresses, which stay in MPa.
pub const MEGAPASCALS: Scale = Scale::fixed("MPa");
/// Sizes of files, from bytes.
pub const MEGABYTES: Scale = Scale::constant("MB", 1e-6);
/// Air at 0 °C and 1.01325 bar.
pub const NORMAL_LITRES: Scale = Scale::fixed("normal L");
/// Torques.
pub const NEWTON_METRES: Scale = Scale::fixed("N m");

impl Scale {
    /// A unit that is shown as it is inside.
    pub const fn fixed(name: &'static str) -> Self {
        Self::constant(name, 1.0)
    }

    const fn constant(name: &'static str, factor: f64) -> Self {
        Self {
            name: Cow::Borrowed(name),
            factor: (factor, 1.0),
            digits: 4,
        }
    }

    /// The same with other digits.
    pub fn digits(&self, digits: usize) -> Self {
        Self {
            digits,
            ..self.clone()
        }
    }

    fn new(unit: Unit, digits: usize) -> Self {
        Self {
            name: unit.name.into(),
            factor: unit.outside(),
            digits,
        }
    }

    /// The unit of a kind of quantity.
    pub fn unit(&self, kind: Dimension) -> Unit {
        kind.unit(&self.name).unwrap_or(kind.unit_inside())
    }

    /// This for each of another.
    fn per(&self, other: &Self) -> Self {
        let a = self.factor;
        let b = other.factor;
        Self {
            name: format!("{}/{}", self.name, other.name).into(),
            factor: (a.0 * b.1, a.1 * b.0),
            digits: 4,
        }
    }

    /// A value inside as the number shown.
    pub fn value(&self, inside: f64) -> f64 {
        inside * self.factor.0 / self.factor.1
    }

    /// A value inside as a text with its unit.
    pub fn show(&self, inside: f64) -> String {
        self.with_unit(self.bare(inside))
    }

    /// A text of a number with its unit.
    pub fn with_unit(&self, number: String) -> String {
        if self.name.is_empty() {
            number
        } else {
            number + " " + &self.name
        }
    }

    /// The same for a sentence.
    fn joined(&self, inside: f64) -> String {
        format!("{}{JOIN}{}", self.bare(inside), self.name)
    }

    /// A value inside as a text without its unit.
    pub fn bare(&self, inside: f64) -> String {
        self.to(inside, self.digits)
    }

    /// A value in this unit; rounding errors about zero are zero.
    pub fn rounded(&self, inside: f64) -> f64 {
        if inside.abs() < NOTHING {
            0.0
        } else {
            self.value(inside)
        }
    }

    /// `2.5`, to so many digits; rounding errors about zero are zero.
    pub fn to(&self, inside: f64, digits: usize) -> String {
        number(self.rounded(inside), digits)
    }

    /// The ± of such a value.
    pub fn half_width(&self, inside: f64) -> String {
        half_width(self.value(inside))
    }

    /// The heading of a column: symbol and unit.
    pub fn heading(&self, symbol: &str) -> String {
        format!("{symbol} [{}]", self.name)
    }
}

/// The kinds of quantities whose units a user selects.
const KINDS: [Dimension; 3] = [Dimension::Pressure, Dimension::Force, Dimension::Length];

/// The units of a text or figure; as text a list of names such as `bar` or `psi,lbf,in`, where what
/// is not named is in MPa, N and mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Units {
    /// Inside MPa.
    pub pressure: Scale,
    /// Inside N.
    pub force: Scale,
    /// Inside mm.
    pub length: Scale,
    /// Volumes: cm³, or in³ beside inches.
    pub volume: Scale,
    named: Vec<&'static str>,
}

impl Units {
    fn new([pressure, force, length]: [Unit; 3], named: Vec<&'static str>) -> Self {
        let volume = match length.name {
            "in" => Scale {
                name: "in³".into(),
                factor: (1.0, 25.4_f64.powi(3)),
                digits: 4,
            },
            _ => Scale {
                name: "cm³".into(),
                factor: (1.0, 1000.0),
                digits: 4,
            },
        };
        Self {
            pressure: Scale::new(pressure, 4),
            force: Scale::new(force, 5),
            length: Scale::new(length, 5),
            volume,
            named,
        }
    }

    /// Force per length.
    pub fn stiffness(&self) -> Scale {
        self.force.per(&self.length)
    }

    /// Force per pressure.
    pub fn slope(&self) -> Scale {
        self.force.per(&self.pressure)
    }

    /// Length per second.
    pub fn speed(&self) -> Scale {
        Scale {
            name: format!("{}/s", self.length.name).into(),
            ..self.length.digits(4)
        }
    }

    /// A quantity of a kind with its unit.
    pub fn show(&self, kind: Dimension, inside: f64) -> String {
        match kind {
            Dimension::Pressure => self.pressure.joined(inside),
            Dimension::Force => self.force.joined(inside),
            Dimension::Length => self.length.joined(inside),
            _ => format!("{} {}", number(inside, 5), kind.unit_inside().name)
                .trim_end()
                .to_owned(),
        }
    }

    /// The units behind texts that a user typed, as far as people who type them want to read them
    /// too; of each kind the first.
    pub fn typed<'a>(texts: impl IntoIterator<Item = &'a str>) -> Self {
        let known = ["bar", "kPa", "MPa", "psi", "lbf", "in"];
        let mut units: [Option<&str>; 3] = [None; 3];
        for text in texts.into_iter().flat_map(|text| text.split([',', '@'])) {
            let unit = text
                .trim()
                .rsplit(|c: char| c.is_ascii_digit() || ".: ".contains(c))
                .next();
            let named = KINDS
                .into_iter()
                .enumerate()
                .find_map(|(i, kind)| Some((i, kind.unit(unit?)?.name)));
            if let Some((i, name)) = named.filter(|(_, name)| known.contains(name)) {
                units[i].get_or_insert(name);
            }
        }
        joined(units.into_iter().flatten(), ",")
            .parse()
            .unwrap_or_default()
    }

    /// A sentence of the layers below in these units: its quantities are those whose number a
    /// no-break space joins to a unit inside.
    pub fn sentence(&self, text: &str) -> String {
        let scales = |u: &Self| {
            [
                u.pressure.clone(),
                u.force.clone(),
                u.length.clone(),
                u.stiffness(),
                u.slope(),
            ]
        };
        let inside = scales(&Self::default());
        let shown = scales(self);
        let mut parts = text.split(JOIN);
        let mut out = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let from = out
                .trim_end_matches(|c: char| c.is_ascii_digit() || "+-.e".contains(c))
                .len();
            let end = part
                .find(|c: char| !(c.is_ascii_alphabetic() || "/^".contains(c)))
                .unwrap_or(part.len());
            let (unit, rest) = part.split_at(end);
            let other = inside
                .iter()
                .position(|scale| scale.name == unit)
                .map(|i| &shown[i]);
            match (
                other.filter(|scale| scale.name != unit),
                out[from..].parse::<f64>(),
            ) {
                (Some(scale), Ok(value)) => {
                    let digits = out[from..]
                        .split('e')
                        .next()
                        .unwrap_or_default()
                        .trim_start_matches(['-', '+', '0', '.'])
                        .matches(|c: char| c.is_ascii_digit());
                    let value = number(scale.value(value), digits.count().clamp(3, 6));
                    out.replace_range(from.., &format!("{value} {}{rest}", scale.name));
                }
                _ => out.extend([" ", part]),
            }
        }
        out
    }
}

impl Default for Units {
    fn default() -> Self {
        Self::new(KINDS.map(Dimension::unit_inside), vec![])
    }
}

impl FromStr for Units {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut units = KINDS.map(Dimension::unit_inside);
        let mut named = vec![];
        for word in text.split(',').map(str::trim) {
            let Some((i, unit)) = (0..3).find_map(|i| Some((i, KINDS[i].unit(word)?))) else {
                return Err(format!(
                    "\"{word:.40}\" is not a unit of pressure, force or length; one of {}, or several \
                     with commas: psi,lbf,in",
                    joined(KINDS.into_iter().flat_map(Dimension::unit_names), ", ")
                ));
            };
            units[i] = unit;
            named.push(unit.name);
        }
        Ok(Self::new(units, named))
    }
}

impl fmt::Display for Units {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&if self.named.is_empty() {
            self.pressure.name.to_string()
        } else {
            self.named.join(",")
        })
    }
}

impl Serialize for Units {
    fn serialize<S: Serializer>(&self, out: S) -> Result<S::Ok, S::Error> {
        out.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Units {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        String::deserialize(from)?
            .parse()
            .map_err(serde::de::Error::custom)
    }
}

impl JsonSchema for Units {
    fn schema_name() -> Cow<'static, str> {
        "Units".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "string",
            "description": "Units in which people are shown quantities: names with commas between, \
                such as `bar` or `psi,lbf,in`; what is not named is in MPa, N and mm.",
            "examples": ["bar", "psi,lbf,in"]
        })
    }
}
