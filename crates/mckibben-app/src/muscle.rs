//! From fields to a muscle, and a muscle in a few words.

use crate::fields::{MuscleFields, NamedFields, NamedStiffness, Stiffness, TextFile};
use crate::problem::{Problem, ProblemKind};
use crate::units::Units;
use crate::words;
use mckibben::muscle::file::parse_muscle;
use mckibben::muscle::measures::{ANGLE, END_FACTOR, fields};
use mckibben::muscle::{Braid, BraidStiffness, EndFactor, Measure, Muscle, Rubber};
use mckibben::rubber::library;
use mckibben::sleeve::{self, Sleeve, SleeveError};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::PI;
use std::path::Path;

impl MuscleFields {
    /// The muscle that file and fields describe.
    ///
    /// # Errors
    /// [`Problem`] of kind `file`, `rubber` or `muscle`.
    pub fn resolve(&self) -> Result<Muscle, Problem> {
        self.over(&match &self.named.muscle {
            Some(file) => muscle_of(file)?,
            None => Muscle::prototype(),
        })
    }

    /// A muscle with the fields' values in place of its own.
    ///
    /// # Errors
    /// As [`MuscleFields::resolve`].
    pub fn over(&self, base: &Muscle) -> Result<Muscle, Problem> {
        let mut parts = base.parts().clone();
        let (tube, others): (Vec<_>, Vec<_>) =
            self.measures.iter().filter(|v| *v.0 != ANGLE).partition(|v| v.0.section() == "tube");
        tube.into_iter().for_each(|(measure, value)| (measure.set)(&mut parts, value));
        match (&self.named.rubber, &self.named.rubber_file) {
            (Some(_), Some(_)) => {
                let message = "`rubber` and `rubber_file` each set the rubber: give one of them";
                return Err(Problem::new(ProblemKind::Usage, message, ""));
            }
            (Some(name), None) => parts.tube.rubber = rubber(name)?,
            (None, Some(file)) => parts.tube.rubber = muscle_of(file)?.tube().rubber.clone(),
            (None, None) => {}
        }
        parts.braid = self.braid_on(parts.tube.outer_diameter_mm, base)?;
        for (measure, value) in others {
            let beside = measure.beside.and_then(|(key, _)| Measure::of_key(key));
            if let Some(beside) = beside.filter(|other| self.measures.get(other).is_none()) {
                return Err(together(measure, beside));
            }
            (measure.set)(&mut parts, value);
        }
        Ok(Muscle::from_parts(parts)?.with_bench_of(base))
    }

    /// What the fields are of a muscle, each as it may be given; none where it has none of a name or a number.
    pub fn of(muscle: &Muscle) -> Self {
        let (tube, braid) = (muscle.tube(), muscle.braid());
        let section = braid.strands.and_then(|strands| strands.section);
        let mut out = Self::from(NamedFields {
            muscle: None,
            rubber: tube.rubber.name.clone(),
            rubber_file: None,
            braid: braid.sleeve.as_ref().map(|sleeve| sleeve.name.clone()),
            strand_diameter_mm: section.map(|(area, _)| (4.0 * area / PI).sqrt()),
            strand_modulus_mpa: section.map(|(_, modulus)| modulus),
            stiffness: match braid.stiffness {
                BraidStiffness::NewtonPerMm(k) => Some(Stiffness::NewtonPerMm(k)),
                BraidStiffness::Inextensible => Some(Stiffness::Named(NamedStiffness::Inextensible)),
                BraidStiffness::Paper => Some(Stiffness::Named(NamedStiffness::Paper)),
                BraidStiffness::OfStrands => muscle.family_stiffness_n_per_mm().map(Stiffness::NewtonPerMm),
            },
        });
        // A factor that changes with the pressure is no number.
        let varies = matches!(muscle.terminals().end_factor, Some(EndFactor::OfPressure { .. }));
        for (_, measure) in fields().filter(|(_, m)| !(varies && **m == END_FACTOR)) {
            if let Some(value) = muscle.measure(measure) {
                out.measures.set(measure, value);
            }
        }
        out
    }

    /// The braid on a tube of a diameter: the named sleeve, or the muscle's own braid, with the angle and stiffness that are stated.
    pub(crate) fn braid_on(&self, outer_diameter_mm: f64, base: &Muscle) -> Result<Braid, Problem> {
        let strands = self.named.strand_diameter_mm.is_some() || self.named.strand_modulus_mpa.is_some();
        if strands && (self.named.braid.is_none() || self.named.stiffness.is_some()) {
            let message = "`strand_diameter_mm` and `strand_modulus_mpa` complete a named `braid`, in place of a `stiffness`";
            return Err(Problem::new(ProblemKind::Usage, message, "state other strands in a muscle file"));
        }
        let mut braid = match self.named.braid.as_deref().map(sleeve).transpose()? {
            Some(sleeve) => {
                let sleeve =
                    sleeve.with_strands(self.named.strand_diameter_mm, self.named.strand_modulus_mpa)?;
                let stiffness_factor = sleeve.stiffness_factor();
                let (stiffness, strands, stiffness_factor) = match self.named.stiffness {
                    Some(stiffness) => (stiffness.into(), sleeve.strands_beside_stiffness(), 1.0),
                    None => (BraidStiffness::OfStrands, Some(sleeve.of_strands()?), stiffness_factor),
                };
                let own = base.braid().clone();
                Braid { stiffness, strands, stiffness_factor, sleeve: Some(sleeve.shape), ..own }
                    .on_diameter(outer_diameter_mm)?
            }
            None => base.braid_on(outer_diameter_mm)?,
        };
        if let Some(angle_deg) = self.measures.get(&ANGLE) {
            braid = braid.with_stated_angle(angle_deg, outer_diameter_mm)?;
        }
        if let Some(stiffness) = self.named.stiffness {
            (braid.stiffness, braid.stiffness_factor) = (stiffness.into(), 1.0);
        }
        Ok(braid)
    }
}

impl From<Stiffness> for BraidStiffness {
    fn from(stiffness: Stiffness) -> Self {
        match stiffness {
            Stiffness::NewtonPerMm(k) => Self::NewtonPerMm(k),
            Stiffness::Named(NamedStiffness::Inextensible) => Self::Inextensible,
            Stiffness::Named(NamedStiffness::Paper) => Self::Paper,
        }
    }
}

/// A measure that was given without the one that belongs to it.
fn together(one: &Measure, other: &Measure) -> Problem {
    let place = |m: &Measure| fields().position(|(_, other)| other == m);
    let (a, b) = if place(one) < place(other) { (one, other) } else { (other, one) };
    let name = |m: &Measure| m.field.unwrap_or(m.key);
    let message = format!("`{}` and `{}` belong together: give both", name(a), name(b));
    Problem::new(ProblemKind::Usage, message, "")
}

/// The muscle of a muscle file.
///
/// # Errors
/// [`Problem`] of kind `file`, with line, column and key.
pub fn muscle_of(file: &TextFile) -> Result<Muscle, Problem> {
    Ok(parse_muscle(&file.text).map_err(|e| e.of(Path::new(&file.name)))?)
}

/// A rubber of the library.
///
/// # Errors
/// [`Problem`] of kind `rubber`.
pub fn rubber(name: &str) -> Result<Rubber, Problem> {
    library::find(name.trim()).map_err(|e| Problem::new(ProblemKind::Rubber, e.to_string(), ""))
}

/// A sleeve of the library.
///
/// # Errors
/// [`Problem`] of kind `braid`.
pub fn sleeve(name: &str) -> Result<Sleeve, Problem> {
    Ok(sleeve::library::find(name)?)
}

impl From<SleeveError> for Problem {
    fn from(error: SleeveError) -> Self {
        let field = |key| match key {
            "strand_diameter" => "strand_diameter_mm",
            "strand_modulus" => "strand_modulus_mpa",
            other => other,
        };
        Self::new(ProblemKind::Braid, error.named(field).to_string(), "")
    }
}

/// A muscle's measures.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MuscleSummary {
    /// Outer diameter D0 at rest, mm.
    pub outer_diameter_mm: f64,
    /// Wall thickness s at rest, mm.
    pub wall_mm: f64,
    /// Length L0 between the terminals at rest, mm.
    pub length_mm: f64,
    /// Braid angle θ0 at rest, degrees.
    pub angle_deg: f64,
    /// The rubber, by name or law.
    pub rubber: String,
    /// The braid: `paper`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    pub braid: String,
    /// Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sleeve: Option<String>,
    /// Factor within which the stiffness of the braid is known, where that and the strength of its strands are estimates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness_factor: Option<f64>,
    /// Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rubber_mass_g: Option<f64>,
}

impl From<&Muscle> for MuscleSummary {
    fn from(m: &Muscle) -> Self {
        Self {
            outer_diameter_mm: m.outer_diameter_mm(),
            wall_mm: m.wall_mm(),
            length_mm: m.length_mm(),
            angle_deg: m.braid().angle_deg,
            rubber: words::rubber_name(m),
            braid: words::braid_name(m),
            sleeve: m.braid().sleeve.as_ref().map(|s| s.name.clone()),
            stiffness_factor: Some(m.braid().stiffness_factor).filter(|factor| *factor > 1.0),
            rubber_mass_g: m.tube().rubber_mass_g(),
        }
    }
}

impl MuscleSummary {
    /// The muscle in one line.
    pub fn line(&self, u: &Units) -> String {
        format!(
            "D0 {}, s {}, L0 {}, θ0 {}°, rubber {}, braid {}",
            u.length.show(self.outer_diameter_mm),
            u.length.show(self.wall_mm),
            u.length.show(self.length_mm),
            words::number(self.angle_deg, 4),
            self.rubber,
            self.braid
        )
    }
}
