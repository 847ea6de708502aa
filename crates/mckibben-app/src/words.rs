//! Numbers and names as people read them, in figures and texts of every front end.

use mckibben::muscle::{BraidStiffness, Muscle};
use mckibben::rubber::Law;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Units in which people are shown pressures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum PressureUnit {
    /// bar
    Bar,
    /// kPa
    Kpa,
    /// psi
    Psi,
    /// MPa
    #[default]
    Mpa,
}

impl PressureUnit {
    /// The unit's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bar => "bar",
            Self::Kpa => "kPa",
            Self::Psi => "psi",
            Self::Mpa => "MPa",
        }
    }

    /// A pressure in this unit.
    pub fn value(self, mpa: f64) -> f64 {
        match self {
            Self::Bar => mpa * 10.0,
            Self::Kpa => mpa * 1000.0,
            Self::Psi => mpa * (1.0 / 0.006_894_757_293_168_361),
            Self::Mpa => mpa,
        }
    }

    /// `2.5 bar`.
    pub fn show(self, mpa: f64) -> String {
        format!("{} {}", number(self.value(mpa), 4), self.name())
    }
}

/// A number with so many significant digits, without an exponent where it is short without.
pub fn number(v: f64, digits: usize) -> String {
    if v == 0.0 || !v.is_finite() {
        return if v == 0.0 { "0".into() } else { "–".into() };
    }
    let magnitude = v.abs().log10().floor() as i32;
    if !(-5..15).contains(&magnitude) {
        return format!("{v:.*e}", digits.saturating_sub(1));
    }
    let decimals = (digits as i32 - 1 - magnitude).max(0) as usize;
    let text = format!("{v:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.into() }
}

/// A ratio as a percentage.
pub fn percent(ratio: f64) -> String {
    format!("{} %", number(100.0 * ratio, 4))
}

/// The rubber in one word or formula.
pub fn rubber_name(m: &Muscle) -> String {
    let rubber = &m.tube().rubber;
    rubber.name.clone().unwrap_or_else(|| law_text(&rubber.law))
}

/// A law with its constants.
pub fn law_text(law: &Law) -> String {
    let constants: Vec<String> = law
        .constants()
        .into_iter()
        .map(|c| format!("{} {} {}", c.name, number(c.value, 4), c.constant.unit()).trim_end().to_owned())
        .collect();
    format!("{} ({})", law.name(), constants.join(", "))
}

/// The braid in one word or figure.
pub fn braid_name(m: &Muscle) -> String {
    let stiffness = match m.braid().stiffness {
        BraidStiffness::Paper => "paper".into(),
        BraidStiffness::Inextensible => "inextensible".into(),
        BraidStiffness::NewtonPerMm(k) => format!("{} N/mm", number(k, 4)),
        BraidStiffness::OfStrands => match (m.braid().strands, m.family_stiffness_n_per_mm()) {
            (Some(s), Some(k)) => format!("{} strands, {} N/mm", s.count, number(k, 4)),
            _ => "strands".into(),
        },
    };
    match &m.braid().sleeve {
        Some(sleeve) => format!("{}, {stiffness}", sleeve.name),
        None => stiffness,
    }
}
