//! From fields to a muscle, and a muscle in a few words.

use crate::{
    Model, MuscleFields, NameOrFile, Problem, ProblemKind, Result, Stiffness, TextFile, Units,
    made_for, words,
};
use mckibben_core::{
    muscle::{
        Braid, BraidStiffness, EndFactor, Measure, Muscle, MuscleError, Rubber, Stated,
        file::{FileError, parse_muscle, to_toml, with_keys},
        measures::{END_FACTOR, MEASURES, OUTER_DIAMETER, WALL, fields},
    },
    rubber::library,
    sleeve::{self, Sleeve},
    units::tidy,
};
use mckibben_fit::library as muscles;
use schemars::JsonSchema;
use serde::Serialize;
use std::{borrow::Cow, f64::consts::PI, path::Path};

impl MuscleFields {
    /// The muscle that file and fields describe.
    pub fn resolve(&self) -> Result<Muscle> {
        self.resolve_for(&Model::FE)
    }

    /// The same; without a file a muscle of the make that a formula is for.
    pub fn resolve_for(&self, model: &Model) -> Result<Muscle> {
        let file = self.file();
        let made = match file {
            Some(_) => None,
            None => made_for(model)?,
        };
        let base = match (file, &made) {
            (Some(file), _) => muscle_of(file),
            (None, Some(made)) => Ok(made.clone()),
            (None, None) => Ok(Muscle::prototype()),
        };
        if self.with.is_empty() && base.is_ok() {
            return self.over(&base?);
        }
        let text = match (file, &made) {
            (Some(file), _) => text_of(file)?,
            (None, made) => made.as_ref().map(to_toml).unwrap_or_default().into(),
        };
        let with = |keys: &[String]| with_keys(&text, keys).and_then(|text| parse_muscle(&text));
        // What a file or a key says may need the values of fields beside it.
        let stated = self.stated()?.measures;
        let stated = stated.iter().map(|(m, value)| format!("{}={value}", m.key));
        let all = || [self.with.clone(), stated.collect()].concat();
        let with = with(&self.with).or_else(|_| with(&all()));
        self.over(&with.map_err(|error| {
            let in_keys = ProblemKind::File
                .problem(FileError {
                    place: None,
                    ..error
                })
                .in_field("with");
            base.err().unwrap_or(in_keys)
        })?)
    }

    /// A muscle with the fields' values in place of those of the base.
    pub fn over(&self, base: &Muscle) -> Result<Muscle> {
        Ok(Muscle::from_parts(self.stated()?.over(base)?)?.with_bench_of(base))
    }

    /// The braid on a tube of a diameter.
    pub fn braid_on(&self, outer_diameter_mm: f64, base: &Muscle) -> Result<Braid> {
        Ok(self.stated()?.braid_on(outer_diameter_mm, base)?)
    }

    /// What the fields state of a muscle, with the parts that they name.
    fn stated(&self) -> Result<Stated> {
        self.validate()?;
        let mut measures = self.measures.0.clone();
        let mut of_tube = None;
        if let Some(tube) = &self.tube {
            of_tube = tube.part.as_ref().map(|(_, rubber)| rubber.clone());
            measures.set(&OUTER_DIAMETER, tube.outer_mm);
            measures.set(&WALL, tidy(0.5 * (tube.outer_mm - tube.inner_mm), 12));
        }
        Ok(Stated {
            measures,
            rubber: match &self.rubber {
                Some(NameOrFile::Name(name)) => Some(rubber(name)?),
                Some(NameOrFile::File(file)) => Some(muscle_of(file)?.tube().rubber.clone()),
                None => of_tube,
            },
            sleeve: self.braid.as_deref().map(sleeve).transpose()?,
            stiffness: self.stiffness,
            strand_diameter_mm: self.strand_diameter_mm.map(f64::from),
            ..Stated::default()
        })
    }

    /// What the fields are of a muscle, each as it may be given; none where it has none of a name
    /// or a number.
    pub fn from_muscle(muscle: &Muscle) -> Self {
        let tube = muscle.tube();
        let braid = muscle.braid();
        let area_mm2 = braid.strands.and_then(|strands| strands.area_mm2);
        let diameter_mm = |area: f64| (4.0 * area / PI).sqrt();
        let mut out = Self {
            rubber: tube.rubber.name.clone().map(NameOrFile::Name),
            braid: braid.sleeve.as_ref().map(|sleeve| sleeve.name.clone()),
            strand_diameter_mm: area_mm2.map(|area| diameter_mm(area).into()),
            stiffness: match braid.stiffness {
                BraidStiffness::OfStrands => muscle
                    .family_stiffness_n_per_mm()
                    .map(Stiffness::NewtonPerMm),
                stated => Some(stated),
            },
            ..Self::default()
        };
        // A factor that changes with the pressure is no number.
        let varies = matches!(
            muscle.terminals().end_factor,
            Some(EndFactor::OfPressure { .. })
        );
        for (_, measure) in fields().filter(|(_, m)| !(varies && **m == END_FACTOR)) {
            if let Some(value) = muscle.measure(measure) {
                out.measures.set(measure, value);
            }
        }
        out
    }
}

/// The name of the paper's muscle in place of a file.
pub const PAPER: &str = "paper";

/// The text of a muscle file; of a name of the library without a text (`lib:NAME`) that of its
/// muscle.
pub fn text_of(file: &TextFile) -> Result<Cow<'_, str>> {
    let mut lines = file.text.lines().map(str::trim);
    if lines.any(|line| !line.is_empty() && !line.starts_with('#')) || file.name == PAPER {
        return Ok(Cow::Borrowed(&file.text));
    }
    let Some(name) = muscles::named(&file.name) else {
        return Err(Problem::new(
            ProblemKind::File,
            format!("\"{}\" says nothing of a muscle", file.name),
            "give the text of a muscle file, or lib:NAME for a muscle of the library",
        )
        .in_field("muscle"));
    };
    if !cfg!(feature = "whole") {
        return Err(ProblemKind::File
            .problem("the library of muscles needs the full engine; this is a reduced one"));
    }
    let hint = "`parts list muscles` shows them with their sources";
    muscles::file(name)
        .map(Cow::Borrowed)
        .map_err(|error| Problem::new(ProblemKind::File, error, hint))
}

/// The muscle of a muscle file, or that of the library whose name replaces one: `lib:dmsp-20-300`.
pub fn muscle_of(file: &TextFile) -> Result<Muscle> {
    Ok(parse_muscle(&text_of(file)?).map_err(|e| e.in_file(Path::new(&file.name)))?)
}

/// A rubber of the library.
pub fn rubber(name: &str) -> Result<Rubber> {
    library::find(name.trim()).map_err(|e| ProblemKind::Rubber.problem(e))
}

/// A sleeve of the library.
pub fn sleeve(name: &str) -> Result<Sleeve> {
    Ok(sleeve::library::find(name)?)
}

impl From<MuscleError> for Problem {
    fn from(error: MuscleError) -> Self {
        let first = error.fields.first().copied().unwrap_or_default();
        // Keys of a muscle file are fields in a request.
        let names = MEASURES
            .iter()
            .filter_map(|m| Some((m.name(), m.field?)))
            .chain([("strand_diameter", "strand_diameter_mm")]);
        let in_fields = |message: String| {
            names.fold(message, |text, (key, field)| {
                text.replace(&format!("`{key}`"), &format!("`{field}`"))
            })
        };
        let missing = error
            .message
            .strip_prefix(first)
            .filter(|rest| rest.starts_with(" is missing"));
        match missing.zip(Measure::of_key(first).and_then(|measure| measure.field)) {
            Some((rest, field)) => Self::new(
                ProblemKind::Usage,
                in_fields(format!("`{field}`{rest}")),
                "a muscle file can state it",
            )
            .in_field(field),
            None if first == "braid.name" => ProblemKind::Braid.problem(in_fields(error.message)),
            None => ProblemKind::Muscle.problem(in_fields(error.message)),
        }
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
    /// The braid: `antonelli2018`, `inextensible`, its stiffness, or its strands; the sleeve's name before
    /// it.
    pub braid: String,
    /// Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    pub sleeve: Option<String>,
    /// Factor within which the stiffness of the braid is known, where that and the strength of its
    /// strands are estimates.
    pub stiffness_factor: Option<f64>,
    /// Mass of the rubber between the terminals, g, where its density is stated; braid and
    /// terminals are not in it.
    pub rubber_mass_g: Option<f64>,
    /// Mass of tube and sleeve between the terminals, g, where both are known; the terminals are
    /// not in it.
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
    /// What belongs behind numbers that follow from estimates of the strands.
    pub fn estimate(&self) -> &'static str {
        match self.stiffness_factor {
            Some(_) => " (estimate: the strands of this sleeve are not stated)",
            None => "",
        }
    }

    /// The muscle on one line.
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
