//! The hosts: one file each, and the list of all.

mod c;
mod fmu;
mod mjcf;
mod python;
mod rust;
mod zip;

use crate::{
    Artefact, ExportError, ExportedJoint, ExportedMuscle, Result,
    muscle::plain,
    template::{list, lists, number},
};

/// A target of `export`.
#[derive(Debug, Clone, Copy, serde::Serialize, schemars::JsonSchema)]
#[schemars(rename = "ExportTarget")]
pub struct ExportTarget {
    /// Its word for `target`.
    pub name: &'static str,
    /// What it is.
    pub about: &'static str,
    /// What it needs.
    pub needs: &'static str,
    /// What of the muscle it loses.
    pub loses: &'static str,
    #[serde(skip)]
    make: fn(&ExportedMuscle) -> Result<Artefact>,
    /// Makes the files of a joint.
    #[serde(skip)]
    pub joint: fn(&ExportedJoint) -> Result<Artefact>,
}

impl ExportTarget {
    /// All of them.
    pub const ALL: [Self; 5] = [
        c::TARGET,
        rust::TARGET,
        python::TARGET,
        mjcf::TARGET,
        fmu::TARGET,
    ];

    /// Their words, in one line.
    pub fn names() -> String {
        Self::ALL.map(|t| t.name).join(", ")
    }

    /// The target of this name.
    pub fn named(name: &str) -> Result<Self> {
        if name.trim() == "opensim" {
            return Err(ExportError::Host(
                "the target opensim is gone: take fmu or python".into(),
            ));
        }
        Self::ALL
            .into_iter()
            .find(|t| t.name == name.trim())
            .ok_or_else(|| ExportError::Target(name.to_owned()))
    }
}

impl ExportedMuscle {
    /// The files for a target.
    pub fn to(&self, target: ExportTarget) -> Result<Artefact> {
        (target.make)(self)
    }
}

/// The values that templates of all languages have places for; lists between brackets, each number by
/// `one`.
fn values(
    muscle: &ExportedMuscle,
    brackets: [&str; 2],
    one: impl Fn(f64) -> String + Copy,
) -> Vec<(&'static str, String)> {
    let form = &muscle.form;
    let id = muscle.identifier();
    let limits = &muscle.known.limits;
    let friction = [&form.friction_n[..], &[form.presliding_m]].concat();
    vec![
        ("name", plain(&muscle.name)),
        ("version", muscle.version.into()),
        ("ID", id.to_ascii_uppercase()),
        ("id", id),
        ("length", number(form.length_m)),
        ("cord", number(muscle.cord_m)),
        ("supply", number(form.supply_pa)),
        (
            "allowed",
            number(1e6 * limits.allowed_pressure_mpa.unwrap_or(1e-6 * form.supply_pa)),
        ),
        (
            "burst",
            number(1e6 * limits.burst_pressure_mpa.unwrap_or_default()),
        ),
        ("wanted", number(0.3 * muscle.blocked_force_n)),
        ("count", form.contractions.len().to_string()),
        ("nodes", list(&form.contractions, brackets, one)),
        ("a", lists(&form.a, brackets, one)),
        ("b", lists(&form.b, brackets, one)),
        ("v", list(&form.v, brackets, one)),
        ("friction", list(&friction, brackets, one)),
    ]
}
