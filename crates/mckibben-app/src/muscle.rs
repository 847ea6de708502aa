//! From fields to a muscle, and a muscle in a few words.

use crate::fields::{MuscleFields, NamedStiffness, Stiffness, TextFile};
use crate::problem::{Problem, ProblemKind};
use crate::units::Units;
use crate::words;
use mckibben::muscle::file::parse_muscle;
use mckibben::muscle::{Braid, BraidStiffness, EndFactor, MeasuredStrand, Muscle, Rubber};
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
        self.over(&match &self.muscle {
            Some(file) => muscle_of(file)?,
            None => Muscle::prototype(),
        })
    }

    /// A muscle with the fields' values in place of its own.
    ///
    /// # Errors
    /// As [`MuscleFields::resolve`].
    pub fn over(&self, base: &Muscle) -> Result<Muscle, Problem> {
        let mut tube = base.tube().clone();
        let mut terminals = base.terminals().clone();
        tube.outer_diameter_mm = self.outer_diameter_mm.unwrap_or(tube.outer_diameter_mm);
        tube.wall_mm = self.wall_mm.unwrap_or(tube.wall_mm);
        tube.length_mm = self.length_mm.unwrap_or(tube.length_mm);
        let mut braid = self.braid_on(tube.outer_diameter_mm, base)?;
        if let Some(name) = &self.rubber {
            tube.rubber = rubber(name)?;
        }
        terminals.seating_mm = self.seating_mm.or(terminals.seating_mm);
        terminals.slip_mm_per_n = self.slip_mm_per_n.or(terminals.slip_mm_per_n);
        terminals.grip_mm = self.grip_mm.or(terminals.grip_mm);
        if let Some(k) = self.end_factor {
            terminals.end_factor = Some(EndFactor::Constant(k));
        }
        if let Some(kc) = self.cone_factor {
            terminals.cone_factor = Some(kc);
        }
        match (self.strand_length_mm, self.turns) {
            (Some(strand_length_mm), Some(turns)) => {
                braid.measured = Some(MeasuredStrand { strand_length_mm, turns });
            }
            (None, None) => {}
            _ => {
                let message = "`strand_length_mm` and `turns` belong together: give both";
                return Err(Problem::new(ProblemKind::Usage, message, ""));
            }
        }
        Ok(Muscle::new(tube, braid, terminals, base.friction().copied())?.with_bench_of(base))
    }

    /// What the fields are of a muscle, each as it may be given; none where it has none of a name or a number.
    pub fn of(muscle: &Muscle) -> Self {
        let (tube, braid, terminals) = (muscle.tube(), muscle.braid(), muscle.terminals());
        let section = braid.strands.and_then(|strands| strands.section);
        Self {
            muscle: None,
            outer_diameter_mm: Some(tube.outer_diameter_mm),
            wall_mm: Some(tube.wall_mm),
            length_mm: Some(tube.length_mm),
            angle_deg: Some(braid.angle_deg),
            rubber: tube.rubber.name.clone(),
            braid: braid.sleeve.as_ref().map(|sleeve| sleeve.name.clone()),
            strand_diameter_mm: section.map(|(area, _)| (4.0 * area / PI).sqrt()),
            strand_modulus_mpa: section.map(|(_, modulus)| modulus),
            stiffness: match braid.stiffness {
                BraidStiffness::NewtonPerMm(k) => Some(Stiffness::NewtonPerMm(k)),
                BraidStiffness::Inextensible => Some(Stiffness::Named(NamedStiffness::Inextensible)),
                BraidStiffness::Paper => Some(Stiffness::Named(NamedStiffness::Paper)),
                BraidStiffness::OfStrands => muscle.family_stiffness_n_per_mm().map(Stiffness::NewtonPerMm),
            },
            seating_mm: terminals.seating_mm,
            slip_mm_per_n: terminals.slip_mm_per_n,
            grip_mm: terminals.grip_mm,
            end_factor: match terminals.end_factor {
                Some(EndFactor::Constant(k)) => Some(k),
                Some(EndFactor::OfPressure { .. }) | None => None,
            },
            cone_factor: terminals.cone_factor,
            strand_length_mm: braid.measured.map(|strand| strand.strand_length_mm),
            turns: braid.measured.map(|strand| strand.turns),
        }
    }

    /// The braid on a tube of a diameter: the named sleeve, or the muscle's own braid, with the angle and stiffness that are stated.
    pub(crate) fn braid_on(&self, outer_diameter_mm: f64, base: &Muscle) -> Result<Braid, Problem> {
        let strands = self.strand_diameter_mm.is_some() || self.strand_modulus_mpa.is_some();
        if strands && (self.braid.is_none() || self.stiffness.is_some()) {
            let message = "`strand_diameter_mm` and `strand_modulus_mpa` complete a named `braid`, in place of a `stiffness`";
            return Err(Problem::new(ProblemKind::Usage, message, "other strands stand in a muscle file"));
        }
        let mut braid = match self.braid.as_deref().map(sleeve).transpose()? {
            Some(sleeve) => {
                let sleeve = sleeve.with_strands(self.strand_diameter_mm, self.strand_modulus_mpa)?;
                let (stiffness, strands) = match self.stiffness {
                    Some(stiffness) => (stiffness.into(), sleeve.strands_beside_stiffness()),
                    None => (BraidStiffness::OfStrands, Some(sleeve.of_strands()?)),
                };
                let own = base.braid().clone();
                Braid { stiffness, strands, sleeve: Some(sleeve.shape), ..own }
                    .on_diameter(outer_diameter_mm)?
            }
            None => base.braid_on(outer_diameter_mm)?,
        };
        if let Some(angle_deg) = self.angle_deg {
            braid = braid.with_stated_angle(angle_deg, outer_diameter_mm)?;
        }
        if let Some(stiffness) = self.stiffness {
            braid.stiffness = stiffness.into();
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
        // Keys of a muscle file there, fields of a request here.
        let message = error
            .to_string()
            .replace("`strand_diameter`", "`strand_diameter_mm`")
            .replace("`strand_modulus`", "`strand_modulus_mpa`");
        Self::new(ProblemKind::Braid, message, "")
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
