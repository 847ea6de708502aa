//! The rubber of a tube: a law, its bulk behaviour, and where the constants come from.

use super::error::{MuscleError, positive};
use crate::rubber::over_time::{Held, OgdenRoxburgh, Prony};
use crate::rubber::{Law, MooneyRivlin};
use serde::{Deserialize, Serialize};

/// How a rubber answers to a change of volume.
///
/// As data (serde): `"incompressible"`, or the bulk modulus in MPa.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(into = "WrittenBulk", from = "WrittenBulk")]
pub enum Bulk {
    /// Volume stays.
    #[default]
    Incompressible,
    /// Bulk modulus in MPa.
    Modulus(f64),
}

/// [`Bulk`] as muscle files have it.
#[derive(Serialize, Deserialize)]
#[serde(untagged, expecting = "\"incompressible\", or a bulk modulus in MPa")]
enum WrittenBulk {
    Word(Incompressible),
    Modulus(f64),
}

#[derive(Serialize, Deserialize)]
enum Incompressible {
    #[serde(rename = "incompressible")]
    Word,
}

impl From<Bulk> for WrittenBulk {
    fn from(bulk: Bulk) -> Self {
        match bulk {
            Bulk::Incompressible => Self::Word(Incompressible::Word),
            Bulk::Modulus(k) => Self::Modulus(k),
        }
    }
}

impl From<WrittenBulk> for Bulk {
    fn from(written: WrittenBulk) -> Self {
        match written {
            WrittenBulk::Word(Incompressible::Word) => Self::Incompressible,
            WrittenBulk::Modulus(k) => Self::Modulus(k),
        }
    }
}

/// A rubber with its origin. As data (serde) it is what stands in `[tube.material]` of a muscle file, moduli in MPa:
///
/// ```
/// use mckibben::muscle::Rubber;
/// let text = r#"{"name":"mine","law":"gent","mu":0.2,"jm":50.0,"bulk_modulus":"incompressible"}"#;
/// let rubber: Rubber = serde_json::from_str(text)?;
/// assert_eq!(rubber.law.name(), "gent");
/// assert_eq!(serde_json::to_string(&rubber)?, text);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Rubber {
    /// Name in the library of rubbers (`paper`, `dragon-skin-30`), where it has one. A muscle gives a rubber of the library the
    /// law for its own stretches; with other constants a name is only a name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The law and its constants.
    #[serde(flatten)]
    pub law: Law,
    /// Incompressible, or a bulk modulus. The closed-form models take every rubber as incompressible.
    #[serde(rename = "bulk_modulus", default)]
    pub bulk: Bulk,
    /// Largest stretch of the data the constants were fitted to, where it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fitted_to_stretch: Option<f64>,
    /// How rubber that was stretched before is softer, where it is known. The law is that of the first loading.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub softening: Option<OgdenRoxburgh>,
    /// Pressure in MPa at which the muscle was cycled before, between rest length and free contraction; `None` on its first inflation. The
    /// finite elements of the section have it.
    #[serde(rename = "conditioned", default, skip_serializing_if = "Option::is_none")]
    pub conditioned_mpa: Option<f64>,
    /// How the rubber relaxes, where it is known. The law is the one at once, t → 0, in every model; [`Rubber::held`] is the one of later.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub prony: Option<Prony>,
}

impl Rubber {
    /// The rubber `paper`: Mooney–Rivlin C10 0.112 MPa, C01 0, incompressible. Identified with axisymmetric finite elements from
    /// the paper's Table 1 and formula (11) (`docs/identify/paper.md`).
    pub fn paper() -> Self {
        Self {
            name: Some("paper".into()),
            ..Self::of(Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.112, c01_mpa: 0.0 }))
        }
    }

    /// An unnamed incompressible rubber.
    pub fn of(law: Law) -> Self {
        Self {
            name: None,
            law,
            bulk: Bulk::Incompressible,
            fitted_to_stretch: None,
            softening: None,
            conditioned_mpa: None,
            prony: None,
        }
    }

    /// This rubber after it was held: the law with what is left of its moduli ([`Prony::held`]), without the series. Softening keeps its
    /// shape: its m, an energy, goes with the law. A bulk modulus stays.
    #[must_use]
    pub fn held(self, held: Held) -> Self {
        let Some(prony) = self.prony else { return self };
        let softening = self.softening.map(|s| OgdenRoxburgh { m_mpa: prony.left(held) * s.m_mpa, ..s });
        Self { law: prony.held(&self.law, held), softening, prony: None, ..self }
    }

    /// Whether this is the paper's rubber, unchanged.
    pub fn is_paper(&self) -> bool {
        self.law == Self::paper().law && self.bulk == Bulk::Incompressible && self.conditioned().is_none()
    }

    /// How a muscle that was cycled before is softer, and the pressure in MPa at which it was; `None` on a first inflation.
    pub fn conditioned(&self) -> Option<(OgdenRoxburgh, f64)> {
        self.softening.zip(self.conditioned_mpa)
    }

    pub(crate) fn check(&self) -> Result<(), MuscleError> {
        self.law.clone().validated()?;
        if let Some(softening) = self.softening {
            softening.validated().map_err(MuscleError::Softening)?;
        }
        if let Some(pressure_mpa) = self.conditioned_mpa {
            positive("tube.material.conditioned", pressure_mpa, "MPa")?;
            if self.softening.is_none() {
                return Err(MuscleError::ConditionedWithoutSoftening { pressure_mpa });
            }
        }
        if let Some(prony) = self.prony.clone() {
            prony.validated().map_err(MuscleError::Relaxation)?;
        }
        match self.bulk {
            Bulk::Incompressible => Ok(()),
            Bulk::Modulus(k) => positive("tube.material.bulk_modulus", k, "MPa"),
        }
    }
}
