//! From fields to a muscle, and a muscle in a few words.

use crate::{
    MuscleFields, NamedFields, NamedStiffness, Problem, ProblemKind, Stiffness, TextFile, Units, words,
};
use mckibben::muscle::measures::{
    ANGLE, END_FACTOR, SECTIONS, SLEEVE_DIAMETER, STIFFNESS_FACTOR, STRAND_AREA, STRAND_MODULUS,
    STRAND_STRENGTH, STRANDS, STRANDS_PER_CARRIER, fields,
};
use mckibben::muscle::{Braid, BraidStiffness, EndFactor, Measure, Muscle, Parts, Rubber, Strands};
use mckibben::sleeve::{self, Sleeve, SleeveError};
use mckibben::{muscle::file::parse_muscle, rubber::library};
use mckibben_fit::validation::library as muscles;
use schemars::JsonSchema;
use serde::Serialize;
use std::{borrow::Cow, f64::consts::PI, path::Path};

impl MuscleFields {
    /// The muscle that file and fields describe.
    pub fn resolve(&self) -> Result<Muscle, Problem> {
        self.over(&match &self.named.muscle {
            Some(file) => muscle_of(file)?,
            None => Muscle::prototype(),
        })
    }

    /// A muscle with the fields' values in place of its own.
    pub fn over(&self, base: &Muscle) -> Result<Muscle, Problem> {
        let mut parts = base.parts().clone();
        for section in SECTIONS.into_iter().filter(|section| *section != "braid") {
            self.put(section, &mut parts)?;
        }
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
        Ok(Muscle::from_parts(parts)?.with_bench_of(base))
    }

    /// Puts the measures of a table of the muscle file into the parts; the angle follows from the whole braid.
    fn put(&self, section: &str, parts: &mut Parts) -> Result<(), Problem> {
        for (measure, value) in self.measures.iter().filter(|v| v.0.section() == section && *v.0 != ANGLE) {
            let beside = measure.beside.and_then(|(key, _)| Measure::of_key(key));
            let lacks = |m: &Measure| self.measures.get(m).is_none() && (m.get)(parts).is_none();
            if let Some(beside) = beside.filter(|other| lacks(other)) {
                return Err(together(measure, beside));
            }
            // A count cannot hold every number.
            measure.check(value)?;
            (measure.set)(parts, value);
        }
        Ok(())
    }

    /// What the fields are of a muscle, each as it may be given; none where it has none of a name or a number.
    pub fn of(muscle: &Muscle) -> Self {
        let (tube, braid) = (muscle.tube(), muscle.braid());
        let section = braid.strands.and_then(|strands| strands.section);
        let diameter_mm = |(area, _): (f64, f64)| (4.0 * area / PI).sqrt();
        let mut out = Self::from(NamedFields {
            muscle: None,
            rubber: tube.rubber.name.clone(),
            rubber_file: None,
            braid: braid.sleeve.as_ref().map(|sleeve| sleeve.name.clone()),
            strand_diameter_mm: section.map(diameter_mm),
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
        let mut parts = base.parts().clone();
        self.put("braid", &mut parts)?;
        let own = parts.braid;
        let mut braid = match self.named.braid.as_deref().map(sleeve).transpose()? {
            Some(sleeve) => self.of_sleeve(sleeve, own)?.on_diameter(outer_diameter_mm)?,
            None => {
                let own = self.of_strands(own)?;
                // An angle that was stated for this diameter stays.
                let same = outer_diameter_mm == base.outer_diameter_mm()
                    && self.measures.get(&SLEEVE_DIAMETER).is_none();
                if same { own } else { own.on_diameter(outer_diameter_mm)? }
            }
        };
        if let Some(angle_deg) = self.measures.get(&ANGLE) {
            braid = braid.with_stated_angle(angle_deg, outer_diameter_mm)?;
        }
        if let Some(stiffness) = self.named.stiffness {
            braid.stiffness = stiffness.into();
            braid.stiffness_factor = self.measures.get(&STIFFNESS_FACTOR).unwrap_or(1.0);
            // What it takes the place of is no longer stated.
            braid.strands = braid.strands.map(|strands| Strands { section: None, ..strands });
        }
        Ok(braid)
    }
}

/// The strands of a braid.
impl MuscleFields {
    /// The cross-section of a strand, as an area or as the diameter of a round one.
    fn strand_area_mm2(&self) -> Result<Option<f64>, Problem> {
        let usage = |message| Err(Problem::new(ProblemKind::Usage, message, ""));
        match (self.measures.get(&STRAND_AREA), self.named.strand_diameter_mm) {
            (Some(_), Some(_)) => {
                usage("give either `strand_area_mm2` or `strand_diameter_mm`; both are given")
            }
            (None, Some(value)) if !(value.is_finite() && value > 0.0) => {
                Err(SleeveError::NotPositive { key: "strand_diameter", value }.into())
            }
            (area, diameter) => Ok(area.or(diameter.map(|d| PI * d * d / 4.0))),
        }
    }

    /// The cross-section, and whether the strands describe the stiffness.
    fn section(&self) -> Result<(Option<f64>, bool), Problem> {
        let area = self.strand_area_mm2()?;
        let described = area.is_some() || self.measures.get(&STRAND_MODULUS).is_some();
        if described && self.named.stiffness.is_some() {
            let message = "`strand_diameter_mm` (or `strand_area_mm2`) and `strand_modulus_mpa` complete a named `braid`, or a number of `strands`, in place of a `stiffness`";
            return Err(Problem::new(ProblemKind::Usage, message, "leave one of them out"));
        }
        Ok((area, described))
    }

    /// A braid with a named sleeve, whose strands the fields complete.
    fn of_sleeve(&self, sleeve: Sleeve, own: Braid) -> Result<Braid, Problem> {
        let (area, _) = self.section()?;
        let diameter = self.named.strand_diameter_mm.or(area.map(|a| 2.0 * (a / PI).sqrt()));
        let sleeve = sleeve.with_strands(diameter, self.measures.get(&STRAND_MODULUS))?;
        let count = self.measures.get(&STRANDS).map(|count| count as u32);
        let sleeve = sleeve.with(count, None, None, self.measures.get(&STRAND_STRENGTH));
        let (stiffness, mut strands, factor) = match self.named.stiffness {
            Some(stiffness) => (stiffness.into(), sleeve.strands_beside_stiffness(), 1.0),
            None => (BraidStiffness::OfStrands, Some(sleeve.of_strands()?), sleeve.stiffness_factor()),
        };
        let stiffness_factor = self.measures.get(&STIFFNESS_FACTOR).unwrap_or(factor);
        if let (Some(area), Some(Strands { section: Some(section), .. })) = (area, &mut strands) {
            // To the last bit, not by way of the diameter.
            section.0 = area;
        }
        let strands_per_carrier = self.measures.get(&STRANDS_PER_CARRIER).or(sleeve.strands_per_carrier);
        let sleeve = Some(sleeve.shape);
        Ok(Braid { stiffness, strands, stiffness_factor, strands_per_carrier, sleeve, ..own })
    }

    /// A braid whose strands the fields may have changed: all that a stiffness needs, or none of it.
    fn of_strands(&self, mut braid: Braid) -> Result<Braid, Problem> {
        let (area, described) = self.section()?;
        if let (Some(area), Some(strands)) = (area, &mut braid.strands) {
            strands.section.get_or_insert((0.0, 0.0)).0 = area;
        }
        let found = braid.strands.unwrap_or(Strands { count: 0, section: None, strength_n: None });
        let strength = self.measures.get(&STRAND_STRENGTH).is_some();
        let (own_area, own_modulus) = found.section.unwrap_or_default();
        let missing = [
            ("strands", (described || strength) && found.count == 0),
            ("strand_area_mm2", described && own_area == 0.0),
            ("strand_modulus_mpa", described && own_modulus == 0.0),
        ];
        if let Some((missing, _)) = missing.into_iter().find(|m| m.1) {
            let message = match described {
                true => format!(
                    "`strand_diameter_mm` (or `strand_area_mm2`) and `strand_modulus_mpa` complete a named `braid`, or a number of `strands`; `{missing}` is missing"
                ),
                false => "`strand_strength_n` needs `strands`: the load is shared among them".to_owned(),
            };
            let hint = "a muscle file can state all of them";
            return Err(Problem::new(ProblemKind::Usage, message, hint).in_field(missing));
        }
        if described {
            braid.stiffness = BraidStiffness::OfStrands;
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
    Problem::new(ProblemKind::Usage, message, "").in_field(name(other))
}

/// The name of the paper's muscle in place of a file.
pub const PAPER: &str = "paper";

/// The text of a muscle file; of a name of the library without a text (`lib:NAME`) that of its muscle.
pub(crate) fn text_of(file: &TextFile) -> Result<Cow<'_, str>, Problem> {
    let mut lines = file.text.lines().map(str::trim);
    if lines.any(|line| !line.is_empty() && !line.starts_with('#')) || file.name == PAPER {
        return Ok(Cow::Borrowed(&file.text));
    }
    let Some(name) = muscles::named(&file.name) else {
        let message = format!("\"{}\" says nothing of a muscle", file.name);
        let hint = "give the text of a muscle file, or lib:NAME for a muscle of the library";
        return Err(Problem::new(ProblemKind::File, message, hint).in_field("muscle"));
    };
    if !cfg!(feature = "whole") {
        let message = "the library of muscles needs the full engine; this is a reduced one";
        return Err(Problem::new(ProblemKind::File, message, ""));
    }
    let hint = "`parts list muscles` shows them with their sources";
    muscles::file(name).map(Cow::Owned).map_err(|error| Problem::new(ProblemKind::File, error, hint))
}

/// The muscle of a muscle file, or that of the library whose name stands in the place of one: `lib:dmsp-20-300`.
pub fn muscle_of(file: &TextFile) -> Result<Muscle, Problem> {
    Ok(parse_muscle(&text_of(file)?).map_err(|e| e.of(Path::new(&file.name)))?)
}

/// A rubber of the library.
pub fn rubber(name: &str) -> Result<Rubber, Problem> {
    library::find(name.trim()).map_err(|e| Problem::new(ProblemKind::Rubber, e.to_string(), ""))
}

/// A sleeve of the library.
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
#[serde_with_macros::skip_serializing_none]
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
    pub sleeve: Option<String>,
    /// Factor within which the stiffness of the braid is known, where that and the strength of its strands are estimates.
    pub stiffness_factor: Option<f64>,
    /// Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    pub rubber_mass_g: Option<f64>,
    /// Mass of tube and sleeve between the terminals, g, where both are known; the terminals are not in it.
    pub mass_g: Option<f64>,
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
            mass_g: m.mass_g(),
        }
    }
}

impl MuscleSummary {
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
