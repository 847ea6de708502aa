//! Text → muscle.

use super::{
    bench,
    error::{FileError, without_key},
    material::{self, Material},
    source::Source,
    table::{Beside, Table},
};
use crate::{
    muscle::{
        Bench, BraidStiffness, EndFactor, EndsMade, Job, Muscle, MuscleError, Stated,
        measures::{MeasureValues, OUTER_DIAMETER, WALL},
    },
    sleeve::{Sleeve, library},
    units::{Positive, typed::Length},
};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Deserialize;
use std::borrow::Cow;

/// A muscle: tube, braid, terminals, friction.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MuscleFile {
    /// The rubber tube
    pub tube: Table<OfTube>,
    /// The braided sleeve
    pub braid: Table<OfBraid>,
    /// The ends
    pub terminals: Table<OfTerminals>,
    /// Friction of the braid: half of the width of the hysteresis loop
    pub friction: Table<OfFriction>,
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

/// The keys of `[tube]` beside its measures.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfTube {
    /// The bore, in place of the wall or of the outer diameter
    inner_diameter: Option<Positive<Length>>,
    /// Name of a rubber (`mckibben parts list rubbers`), a hardness such as "shore:30A", or a
    /// stress such as "s100:0.6MPa"
    #[schemars(schema_with = "material::rubbers")]
    rubber: Option<String>,
    /// A rubber of one's own: a law and its constants
    material: Option<Material>,
}

/// The keys of `[braid]` beside its measures.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfBraid {
    /// Stiffness k of one strand family
    stiffness: Option<BraidStiffness>,
    /// Name of a sleeve (`mckibben parts list sleeves`); it gives angle and strands. Of one of
    /// your own, beside its two diameters
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

/// The keys of `[terminals]` beside its measures.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfTerminals {
    /// How the ends hold the braid: the ± of the pull follows from it
    made: Option<EndsMade>,
    /// Empirical end factor k of Tondu & Lopez
    end_factor: Option<EndFactor>,
}

/// The keys of `[friction]` beside its measures: none.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfFriction {}

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
    /// End factor k of Tondu & Lopez: a number, or { a, b } for a·e^(−P) + b with P in bar
    end_factor: Option<EndFactor>,
}

impl Beside for OfTube {
    const TABLE: &'static str = "tube";
}

impl Beside for OfBraid {
    const TABLE: &'static str = "braid";
}

impl Beside for OfTerminals {
    const TABLE: &'static str = "terminals";
}

impl Beside for OfFriction {
    const TABLE: &'static str = "friction";
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
    pub fn muscle(self, source: &Source<'_>) -> Result<Muscle, FileError> {
        let located = |error: MuscleError| located(source, &error);
        let Self {
            tube,
            braid,
            terminals,
            friction,
            model,
            identified,
            job,
            ..
        } = self;
        let sleeve = braid.other.sleeve(source)?;
        let mut stated = Stated {
            rubber: Some(material::rubber(
                source,
                tube.other.rubber,
                tube.other.material,
            )?),
            sleeve: sleeve.transpose().map_err(located)?,
            stiffness: braid.other.stiffness,
            strand_diameter_mm: braid.other.strand_diameter.map(f64::from),
            ..Stated::default()
        };
        let all = [
            tube.measures,
            braid.measures,
            terminals.measures,
            friction.measures,
        ];
        for (measure, value) in all.iter().flat_map(MeasureValues::iter) {
            stated.measures.set(measure, value);
        }
        if let Some(inner) = tube.other.inner_diameter {
            inner_diameter(inner.into(), &mut stated.measures)
                .map_err(|problem| source.error("tube.inner_diameter", problem))?;
        }
        let mut parts = stated.over(&Muscle::prototype()).map_err(located)?;
        // What models of their own say of the ends; in the table of the terminals are their keys
        // of before.
        let (new, old) = ("model.tondu-lopez.end_factor", "terminals.end_factor");
        if source.has(new) && source.has(old) {
            let said = format!("is also given at {new}: leave one of them out");
            return Err(source.error(old, said));
        }
        let of_model = model.tondu_lopez.end_factor;
        parts.terminals.end_factor = of_model.or(terminals.other.end_factor);
        parts.terminals.made = terminals.other.made;
        if let Some(compression) = braid.other.compression {
            parts.braid.compression = compression;
        }
        parts.braid.in_rubber = braid.other.in_rubber.unwrap_or(false);
        if let Some(bench) = &identified {
            bench::check(bench, source)?;
        }
        let mut muscle = Muscle::from_parts(parts).map_err(located)?;
        if let Some(bench) = identified {
            muscle = muscle.with_bench(bench);
        }
        if let Some(job) = job {
            muscle = muscle.with_job(job);
        }
        Ok(muscle)
    }
}

impl OfBraid {
    /// The sleeve of a name, or of the two diameters that one finds by hand.
    fn sleeve(
        &self,
        source: &Source<'_>,
    ) -> Result<Option<Result<Sleeve, MuscleError>>, FileError> {
        const LEAST: &str = "braid.least_diameter";
        const LARGEST: &str = "braid.largest_diameter";
        match (self.least_diameter, self.largest_diameter, &self.name) {
            (None, None, name) => Ok(name.as_deref().map(library::find)),
            (Some(_), None, _) => {
                Err(source.missing(LARGEST, LEAST, "the diameter to which the sleeve opens"))
            }
            (None, Some(_), _) => {
                Err(source.missing(LEAST, LARGEST, "the diameter to which it closes"))
            }
            (Some(_), Some(_), Some(name)) if library::find(name).is_ok() => {
                Err(source.error(LEAST, "is that of the named sleeve: leave `name` out"))
            }
            (Some(least), Some(largest), name) => {
                let sleeve = library::between("pet", least.into(), largest.into());
                Ok(Some(sleeve.map(|sleeve| sleeve.named(name.as_deref()))))
            }
        }
    }
}

/// The error of the muscle, at the line of the key that caused it.
fn located(source: &Source<'_>, error: &MuscleError) -> FileError {
    // A constant of a law is a key of the rubber's table.
    let full = |key: &&'static str| {
        if key.contains('.') {
            Cow::Borrowed(*key)
        } else {
            Cow::from(format!("tube.material.{key}"))
        }
    };
    let keys: Vec<Cow<'_, str>> = error.fields.iter().map(full).collect();
    let written = keys.iter().find(|k| source.has(k)).or(keys.first());
    let key = written.map_or("muscle", |key| key.as_ref());
    // What does not suit the other measures may be a default.
    let sizes = [OUTER_DIAMETER.key, WALL.key, "tube.length"];
    let default = keys
        .iter()
        .find(|k| sizes.contains(&k.as_ref()) && !source.has(k));
    let default = default.map(|key| format!("; {key} is not written, so this is its default"));
    source.error(key, without_key(error, key) + &default.unwrap_or_default())
}

/// The bore, by which tubes are sold: with the outer diameter it gives the wall, with the wall the
/// outer diameter.
fn inner_diameter(inner_mm: f64, values: &mut MeasureValues) -> Result<(), &'static str> {
    match (values.get(&OUTER_DIAMETER), values.get(&WALL)) {
        (Some(outer_mm), None) if outer_mm > inner_mm => {
            values.set(&WALL, 0.5 * (outer_mm - inner_mm));
            Ok(())
        }
        (Some(_), None) => Err("must lie between 0 and outer_diameter"),
        (None, Some(wall_mm)) => {
            values.set(&OUTER_DIAMETER, inner_mm + 2.0 * wall_mm);
            Ok(())
        }
        (Some(_), Some(_)) => {
            Err("follows from outer_diameter and wall_thickness; leave one of the three out")
        }
        (None, None) => Err("needs outer_diameter or wall_thickness beside it"),
    }
}
