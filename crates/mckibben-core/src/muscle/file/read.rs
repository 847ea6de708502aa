//! Text → muscle.

use super::{
    bench,
    error::FileError,
    material::{self, Material},
    source::Source,
    table::Measured,
};
use crate::{
    muscle::{
        Bench, BraidStiffness, EndFactor, EndsMade, Job, Muscle, MuscleError, Stated,
        measures::{MeasureValues, OUTER_DIAMETER, WALL},
    },
    sleeve::{Sleeve, library},
    units::{Positive, tidy, typed::Length},
};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Deserialize;

/// A muscle: tube, braid, terminals, friction.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MuscleFile {
    /// The rubber tube
    pub tube: OfTube,
    /// The braided sleeve
    pub braid: OfBraid,
    /// The ends
    pub terminals: OfTerminals,
    /// Friction of the braid: half of the width of the hysteresis loop
    pub friction: Measured<3>,
    /// What belongs to one model
    pub model: OfModels,
    /// What a bench says of this muscle; `identify` writes it
    pub identified: Option<Bench>,
    /// What it was designed for; `design` writes it
    pub job: Option<Job>,
    /// Name, for people
    pub name: Option<String>,
    /// Notes, for people
    pub notes: Option<String>,
}

/// The keys of `[tube]`.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(extend("additionalProperties" = false))]
pub struct OfTube {
    #[serde(flatten)]
    measures: Measured<0>,
    /// The bore, in place of the wall or of the outer diameter
    inner_diameter: Option<Positive<Length>>,
    /// Name of a rubber (`mckibben parts list rubbers`), a hardness such as "shore:30A", or a
    /// stress such as "s100:0.6MPa"
    #[schemars(schema_with = "material::rubbers")]
    rubber: Option<String>,
    /// A rubber of one's own: a law and its constants
    material: Option<Material>,
}

/// The keys of `[braid]`.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(extend("additionalProperties" = false))]
pub struct OfBraid {
    #[serde(flatten)]
    measures: Measured<1>,
    /// Stiffness k of one strand family
    stiffness: Option<BraidStiffness>,
    /// Name of a sleeve (`mckibben parts list sleeves`), or of your own beside its two diameters
    #[schemars(schema_with = "sleeves")]
    name: Option<String>,
    /// Diameter to which a sleeve of polyester closes, in place of its name
    least_diameter: Option<Positive<Length>>,
    /// Diameter to which it opens
    largest_diameter: Option<Positive<Length>>,
    /// Diameter of a round strand, in place of its area
    strand_diameter: Option<Positive<Length>>,
    /// Whether the strands carry compression
    compression: Option<bool>,
    /// Whether they lie inside of the rubber: their friction is less
    in_rubber: Option<bool>,
}

/// The keys of `[terminals]`.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(extend("additionalProperties" = false))]
pub struct OfTerminals {
    #[serde(flatten)]
    measures: Measured<2>,
    /// How the ends hold the braid: the ± of the pull follows from it
    made: Option<EndsMade>,
    /// Empirical end factor k of Tondu & Lopez
    end_factor: Option<EndFactor>,
}

/// The tables of models, `[model]`.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
pub struct OfModels {
    /// The model tondu-lopez
    tondu_lopez: OfTonduLopez,
}

#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
struct OfTonduLopez {
    /// Multiplies the contraction: k, or { a, b } of a·e^(−P) + b, P in bar (Tondu & Lopez 2000)
    end_factor: Option<EndFactor>,
}

fn sleeves(_: &mut SchemaGenerator) -> Schema {
    let all = library::entries().unwrap_or_default();
    material::named(all.iter().map(|entry| entry.sleeve.name()))
}

/// Reads the text of a muscle file.
///
/// # Errors
/// [`FileError`] with line, column, key, what stood there and what is expected.
pub fn parse_muscle(text: &str) -> Result<Muscle, FileError> {
    let source = Source::parse(text)?;
    source.read::<MuscleFile>()?.muscle(&source)
}

impl MuscleFile {
    /// The muscle of the file.
    ///
    /// # Errors
    /// [`FileError`], as [`parse_muscle`].
    pub fn muscle(mut self, source: &Source<'_>) -> Result<Muscle, FileError> {
        let (bench, job) = (self.identified.take(), self.job.take());
        let mut muscle = self
            .stated(source)?
            .over(&Muscle::prototype())
            .and_then(Muscle::from_parts)
            .map_err(|error| source.refused(&error))?;
        if let Some(bench) = bench {
            bench::check(&bench, source)?;
            muscle = muscle.with_bench(bench);
        }
        if let Some(job) = job {
            muscle = muscle.with_job(job);
        }
        Ok(muscle)
    }

    /// What the file states of a muscle.
    ///
    /// # Errors
    /// [`FileError`] of what contradicts itself, whatever the muscle.
    pub fn stated(self, source: &Source<'_>) -> Result<Stated, FileError> {
        let Self {
            tube,
            braid,
            terminals,
            friction,
            model,
            ..
        } = self;
        let sleeve = braid.sleeve(source)?.transpose();
        // What models of their own say of the ends; in the table of the terminals are their keys
        // of before.
        let (new, old) = ("model.tondu-lopez.end_factor", "terminals.end_factor");
        if source.has(new) && source.has(old) {
            return Err(source.error(
                old,
                format!("is also given at {new}: leave one of them out"),
            ));
        }
        let mut stated = Stated {
            rubber: Some(material::rubber(source, tube.rubber, tube.material)?),
            sleeve: sleeve.map_err(|error| source.refused(&error))?,
            stiffness: braid.stiffness,
            strand_diameter_mm: braid.strand_diameter.map(f64::from),
            compression: braid.compression,
            in_rubber: braid.in_rubber,
            ends: terminals.made,
            end_factor: model.tondu_lopez.end_factor.or(terminals.end_factor),
            ..Stated::default()
        };
        tube.measures.read(source, &mut stated.measures)?;
        braid.measures.read(source, &mut stated.measures)?;
        terminals.measures.read(source, &mut stated.measures)?;
        friction.read(source, &mut stated.measures)?;
        if let Some(inner) = tube.inner_diameter {
            inner_diameter(inner.into(), &mut stated.measures)
                .map_err(|problem| source.error("tube.inner_diameter", problem))?;
        }
        Ok(stated)
    }
}

impl OfBraid {
    /// The sleeve of a name, or of the two diameters that one finds by hand.
    fn sleeve(
        &self,
        source: &Source<'_>,
    ) -> Result<Option<Result<Sleeve, MuscleError>>, FileError> {
        let diameters = source.both(
            "braid",
            (
                "least_diameter",
                self.least_diameter,
                "the diameter to which it closes",
            ),
            (
                "largest_diameter",
                self.largest_diameter,
                "the diameter to which the sleeve opens",
            ),
        )?;
        match (diameters, &self.name) {
            (None, name) => Ok(name.as_deref().map(library::find)),
            (Some(_), Some(name)) if library::find(name).is_ok() => Err(source.error(
                "braid.least_diameter",
                "is that of the named sleeve: leave `name` out",
            )),
            (Some((least, largest)), name) => {
                let sleeve = library::between("pet", least.into(), largest.into());
                Ok(Some(sleeve.map(|sleeve| sleeve.named(name.as_deref()))))
            }
        }
    }
}

/// The bore, by which tubes are sold: with the outer diameter it gives the wall, with the wall the
/// outer diameter.
fn inner_diameter(inner_mm: f64, values: &mut MeasureValues) -> Result<(), &'static str> {
    let (measure, mm) = match (values.get(&OUTER_DIAMETER), values.get(&WALL)) {
        (Some(outer_mm), None) if outer_mm > inner_mm => (&WALL, 0.5 * (outer_mm - inner_mm)),
        (Some(_), None) => return Err("must lie between 0 and outer_diameter"),
        (None, Some(wall_mm)) => (&OUTER_DIAMETER, inner_mm + 2.0 * wall_mm),
        (Some(_), Some(_)) => {
            return Err(
                "follows from outer_diameter and wall_thickness; leave one of the three out",
            );
        }
        (None, None) => return Err("needs outer_diameter or wall_thickness beside it"),
    };
    values.set(measure, tidy(mm, 12));
    Ok(())
}
