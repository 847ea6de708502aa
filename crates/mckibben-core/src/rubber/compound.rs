//! The rubber of a tube: a law, its bulk behaviour, and where the constants come from.

use super::{
    Law, MooneyRivlin, RubberLaw,
    over_time::{Held, OgdenRoxburgh, Prony},
};
use crate::units::{Dimension, Words, typed::Pressure};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};

/// How a rubber answers to a change of volume.
///
/// As data (serde): `"incompressible"`, or the bulk modulus in MPa.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Bulk {
    /// Volume stays.
    #[default]
    Incompressible,
    /// Bulk modulus in MPa.
    #[serde(untagged)]
    Modulus(#[schemars(with = "Pressure")] f64),
}

const BULK: Words<Bulk> = Words {
    words: &[("incompressible", Bulk::Incompressible)],
    dimension: Dimension::Pressure,
    quantity: Bulk::Modulus,
};

impl<'de> Deserialize<'de> for Bulk {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        BULK.read(from)
    }
}

/// What softening rubber has been through. As data (serde) a pressure in MPa, or `{"strain": 1.0}`;
/// in a muscle file a pressure or a strain such as `"100 %"`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "a pressure in MPa, or {\"strain\": 1.0}")]
pub enum Conditioned {
    /// The muscle was cycled at this pressure in MPa, between rest length and free contraction:
    /// each point has its own W_m.
    Pressure(f64),
    /// The rubber was stretched by so much, all of it alike: W_m is W0 in simple tension at the
    /// stretch 1 + strain.
    Strain {
        /// Largest strain in simple tension; 1 is 100 %.
        strain: f64,
    },
}

/// A rubber with its origin. As data (serde) it is what is in `[tube.material]` of a muscle file,
/// moduli in MPa:
///
/// ```
/// use mckibben_core::muscle::Rubber;
/// let text = r#"{"name":"mine","law":"gent","mu":0.2,"jm":50.0,"bulk_modulus":"incompressible"}"#;
/// let rubber: Rubber = serde_json::from_str(text)?;
/// assert_eq!(rubber.law.name(), "gent");
/// assert_eq!(serde_json::to_string(&rubber)?, text);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Rubber {
    /// Name in the library of rubbers (`antonelli2018`, `dragon-skin-30`), where it has one. A muscle gives
    /// a rubber of the library the law for its own stretches; with other constants a name is only a
    /// name.
    pub name: Option<String>,
    /// The law and its constants.
    #[serde(flatten)]
    pub law: Law,
    /// Incompressible, or a bulk modulus. The closed-form models take every rubber as
    /// incompressible.
    #[serde(rename = "bulk_modulus", default)]
    pub bulk: Bulk,
    /// Largest stretch of the data the constants were fitted to, where it is known.
    pub fitted_to_stretch: Option<f64>,
    /// Strain at which a strip of it breaks, where that is stated; a rubber of the library has the
    /// one of its data sheet.
    pub elongation_at_break: Option<f64>,
    /// How rubber that was stretched before is softer, where it is known. The law is that of the
    /// first loading.
    #[doc(hidden)]
    pub softening: Option<OgdenRoxburgh>,
    /// What it was stretched by before; `None` on its first inflation. The finite elements of the
    /// section have it.
    pub conditioned: Option<Conditioned>,
    /// How the rubber relaxes, where it is known. The law is the one at once, t → 0, in every
    /// model; [`Rubber::relaxed`] is the one of later.
    #[doc(hidden)]
    pub prony: Option<Prony>,
}

impl Rubber {
    /// The rubber `antonelli2018`, which `paper` is too: Mooney–Rivlin C10 0.112 MPa, C01 0,
    /// incompressible. Identified with axisymmetric finite elements from the paper's Table 1 and
    /// formula (11) (`docs/paper.md`).
    pub fn paper() -> Self {
        Self {
            name: Some("antonelli2018".into()),
            ..Self::new(Law::MooneyRivlin(MooneyRivlin {
                c10_mpa: 0.112,
                c01_mpa: 0.0,
            }))
        }
    }

    /// An unnamed incompressible rubber.
    pub fn new(law: Law) -> Self {
        Self {
            name: None,
            law,
            bulk: Bulk::Incompressible,
            fitted_to_stretch: None,
            elongation_at_break: None,
            softening: None,
            conditioned: None,
            prony: None,
        }
    }

    /// This rubber after it was held: the law with its remaining moduli ([`Prony::relaxed_law`]), without
    /// the series. Softening keeps its shape: its m, an energy, goes with the law. A bulk modulus
    /// stays.
    #[must_use]
    #[doc(hidden)]
    pub fn relaxed(self, held: Held) -> Self {
        let Some(prony) = self.prony else { return self };
        Self {
            law: prony.relaxed_law(&self.law, held),
            softening: self.softening.map(|s| OgdenRoxburgh {
                m_mpa: prony.left(held) * s.m_mpa,
                ..s
            }),
            prony: None,
            ..self
        }
    }

    /// This rubber at a temperature in °C, by entropic elasticity: every modulus times T/T0, T
    /// absolute, T0 that of its constants ([`Rubber::OF_CONSTANTS_DEGC`]). Softening keeps its
    /// shape, its m goes with the law; a bulk modulus stays.
    ///
    /// An approximation for unfilled rubber well above its glass transition, whose stress at a
    /// stretch is proportional to T but for the expansion by heat, −20 to 120 °C \[treloar1975\]; a
    /// filler makes rubber softer as it gets warm instead.
    #[must_use]
    pub fn at_temperature(&self, degc: f64) -> Self {
        const KELVIN: f64 = 273.15;
        let factor = (degc + KELVIN) / (Self::OF_CONSTANTS_DEGC + KELVIN);
        Self {
            law: self.law.scaled(factor),
            softening: self.softening.map(|s| OgdenRoxburgh {
                m_mpa: factor * s.m_mpa,
                ..s
            }),
            ..self.clone()
        }
    }

    /// The temperature in °C at which constants are taken to be measured: that of a laboratory (ISO
    /// 23529).
    pub const OF_CONSTANTS_DEGC: f64 = 23.0;

    /// Whether this is the paper's rubber, unchanged.
    pub fn is_paper(&self) -> bool {
        self.law == Self::paper().law && self.bulk == Bulk::Incompressible && !self.is_conditioned()
    }

    /// Whether it is softer, as it was stretched before.
    pub fn is_conditioned(&self) -> bool {
        self.softening.is_some() && self.conditioned.is_some()
    }

    /// How a muscle that was cycled before is softer, and the pressure in MPa at which it was;
    /// `None` where it was not.
    #[doc(hidden)]
    pub fn conditioned(&self) -> Option<(OgdenRoxburgh, f64)> {
        match self.conditioned? {
            Conditioned::Pressure(pressure_mpa) => Some((self.softening?, pressure_mpa)),
            Conditioned::Strain { .. } => None,
        }
    }

    /// How rubber that was stretched before, all of it alike, is softer, and the largest energy W_m
    /// in MPa that it has seen.
    #[doc(hidden)]
    pub fn conditioned_alike(&self) -> Option<(OgdenRoxburgh, f64)> {
        match self.conditioned? {
            Conditioned::Strain { strain } => {
                Some((self.softening?, self.tension_energy_mpa(strain)))
            }
            Conditioned::Pressure(_) => None,
        }
    }

    /// W0 in simple tension.
    pub(crate) fn tension_energy_mpa(&self, strain: f64) -> f64 {
        let stretch = 1.0 + strain;
        self.law.biaxial(1.0 / stretch, stretch * stretch).w
    }
}
