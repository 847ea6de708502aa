//! Named sleeves, from `data/braids.toml`, which states source and terms of each.

use super::{
    ANGLE_DEG, Helix, OF_STIFFNESS, Sleeve, SleeveShape, refused,
    row::{self, SleeveRow},
};
use crate::{
    catalogue::{PartsFile, Sources, named, plain},
    muscle::file::Source,
    refused::Refused,
};
use schemars::JsonSchema;
use serde::Deserialize;
use std::{f64::consts::PI, sync::OnceLock};

/// A sleeve of the library.
#[derive(Debug, Clone, PartialEq, serde::Serialize, schemars::JsonSchema)]
pub struct SleeveEntry {
    /// The sleeve.
    #[serde(flatten)]
    pub sleeve: Sleeve,
    /// Other names it answers to.
    #[serde(skip)]
    pub aliases: Vec<String>,
    /// What it is, for people.
    pub title: String,
    /// What its strands are, in a word.
    pub material: String,
    /// Nominal diameter, mm.
    #[serde(rename = "nominal_diameter_mm")]
    pub nominal_mm: Option<f64>,
    /// From what its helix was found, for people.
    #[serde(skip)]
    pub helix_from: &'static str,
    /// Where the data come from.
    pub source: String,
    /// Terms under which they may be used.
    pub terms: String,
    /// Its price, where one was seen.
    pub price: Option<String>,
    /// What else one should know.
    pub note: Option<String>,
    /// What its modulus is taken from, where it is one of [`materials`].
    #[serde(skip)]
    pub modulus_of: Option<&'static Material>,
}

/// What strands are made of: a row of the built-in table.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Name, such as `aramid-49`.
    pub name: String,
    /// What it is, for people.
    pub title: String,
    /// Young's modulus in MPa.
    #[serde(rename = "modulus")]
    pub modulus_mpa: f64,
    /// Diameter of a filament of a sleeve in mm, where its seller does not state it: an estimate.
    #[serde(rename = "filament_diameter")]
    pub filament_diameter_mm: Option<f64>,
    /// Strength of a filament in a braid in MPa: an estimate.
    #[serde(rename = "strength")]
    pub strength_mpa: Option<f64>,
    /// Strands that lie side by side on a carrier, of sleeves whose seller does not state it.
    pub strands_per_carrier: Option<f64>,
    /// Density in kg/m³.
    #[serde(rename = "density")]
    pub density_kg_per_m3: Option<f64>,
    /// Factor within which the stiffness of a sleeve with these estimates is known.
    #[serde(default = "exact")]
    pub factor: f64,
    /// What the estimates are from.
    pub estimate: Option<String>,
    /// Where the modulus comes from.
    pub source: String,
    /// What else one should know.
    pub note: Option<String>,
}

fn exact() -> f64 {
    1.0
}

/// The built-in table of sleeves.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct BuiltIn {
    material: Vec<Material>,
    sleeve: Vec<SleeveRow>,
    sources: Sources,
}

impl BuiltIn {
    fn parse(text: &str) -> Result<Self, Refused> {
        let mut table: Self = Source::parse(text)
            .and_then(|source| source.read())
            .map_err(damaged)?;
        for material in &mut table.material {
            material.source = table
                .sources
                .source_and_terms(Some(&material.source))
                .0
                .to_owned();
        }
        Ok(table)
    }

    fn get() -> Result<&'static Self, Refused> {
        static TABLE: OnceLock<Result<BuiltIn, Refused>> = OnceLock::new();
        TABLE
            .get_or_init(|| Self::parse(include_str!("../../data/braids.toml")))
            .as_ref()
            .map_err(Refused::clone)
    }
}

fn damaged(error: impl std::fmt::Display) -> Refused {
    refused(format!("the built-in table of sleeves is damaged: {error}"))
}

/// All sleeves, in the order of the table.
///
/// # Errors
/// [`Refused`], which no released program should see.
pub fn entries() -> Result<&'static [SleeveEntry], Refused> {
    static ENTRIES: OnceLock<Result<Vec<SleeveEntry>, Refused>> = OnceLock::new();
    let all = || {
        let table = BuiltIn::get()?;
        row::entries(&table.sleeve, &table.sources, &table.material).map_err(damaged)
    };
    ENTRIES.get_or_init(all).as_deref().map_err(Refused::clone)
}

/// All materials, in the order of the table.
pub fn materials() -> Result<&'static [Material], Refused> {
    BuiltIn::get().map(|table| table.material.as_slice())
}

/// The entry of a name or alias, without regard to case; spaces and underscores are as good as
/// hyphens.
pub fn entry(name: &str) -> Result<&'static SleeveEntry, Refused> {
    named(
        "sleeve",
        entries()?,
        |e| (e.sleeve.name(), &e.aliases),
        name,
    )
    .map_err(refused)
}

/// The sleeve of a name, or of a material with the two round diameters at which its strands touch,
/// such as `pet:6..18mm`, or the widths of the flat sleeve there, `pet:flat:9.4..28mm`.
pub fn find(name: &str) -> Result<Sleeve, Refused> {
    let range = || {
        let (material, range) = name.split_once(':')?;
        let (range, round) = match range.trim().strip_prefix("flat:") {
            // A flat sleeve is half as wide as its circumference.
            Some(flat) => (flat, 2.0 / PI),
            None => (range, 1.0),
        };
        let (least, largest) = range.trim().trim_end_matches("mm").split_once("..")?;
        let mm = |text: &str| Some(round * text.trim().parse::<f64>().ok()?);
        Some((material, mm(least)?, mm(largest)?))
    };
    match range() {
        Some((material, least_mm, largest_mm)) => between(material, least_mm, largest_mm),
        None => entry(name).map(|e| e.sleeve.clone()),
    }
}

/// A sleeve of which nothing but its material and its least and largest diameter is known: its
/// strands are those of the material's estimates.
pub fn between(material: &str, least_mm: f64, largest_mm: f64) -> Result<Sleeve, Refused> {
    let material =
        named("material", materials()?, |m| (&m.name, &[]), material).map_err(refused)?;
    let name = format!("{}:{least_mm}..{largest_mm}mm", material.name);
    let Some(helix) = Helix::jammed_at(least_mm, largest_mm) else {
        return Err(refused(format!(
            "{name}: the largest diameter must be above the least, and both above 0 mm"
        )));
    };
    let shape = SleeveShape {
        name,
        helix,
        least_mm,
        largest_mm,
        angle_deviation_deg: ANGLE_DEG,
    };
    Ok(estimated(Sleeve::new(shape), material, None))
}

/// What the strands of a named sleeve are made of, where it is one of [`materials`].
pub fn material_of(name: &str) -> Option<&'static Material> {
    match name.split_once(':') {
        Some((material, _)) => materials().ok()?.iter().find(|m| m.name == plain(material)),
        None => entry(name).ok()?.modulus_of,
    }
}

/// The sleeves of a user's table.
///
/// # Errors
/// [`Refused`] with the row and its key.
pub fn read(text: &str) -> Result<Vec<SleeveEntry>, Refused> {
    let wrong = |error: String| refused(format!("the table of sleeves: {error}"));
    let file = PartsFile::parse(text).map_err(|error| wrong(error.to_string()))?;
    row::entries(&file.sleeve, &file.sources, materials().unwrap_or_default()).map_err(wrong)
}

/// A sleeve with what its source does not state taken from its material.
pub(super) fn estimated(mut sleeve: Sleeve, material: &Material, factor: Option<f64>) -> Sleeve {
    let mut fill = |key: &'static str, stated: &mut Option<f64>, value: Option<f64>| {
        if stated.is_none() && value.is_some() {
            *stated = value;
            sleeve.estimated.push(key);
        }
    };
    fill(
        "strand_diameter",
        &mut sleeve.strand_diameter_mm,
        material.filament_diameter_mm,
    );
    fill(
        "strand_modulus",
        &mut sleeve.strand_modulus_mpa,
        Some(material.modulus_mpa),
    );
    fill(
        "strands_per_carrier",
        &mut sleeve.strands_per_carrier,
        material.strands_per_carrier,
    );
    let area = sleeve.strand_area_mm2();
    let strength = material.strength_mpa;
    if let Some((area, strength)) = area
        .zip(strength)
        .filter(|_| sleeve.strand_strength_n.is_none())
    {
        sleeve.strand_strength_n = Some(area * strength);
        sleeve.estimated.push("strand_strength");
    }
    if sleeve
        .estimated
        .iter()
        .any(|key| OF_STIFFNESS.contains(key))
    {
        sleeve.factor = factor.unwrap_or(material.factor);
    }
    sleeve
}

#[cfg(test)]
mod tests {
    use super::*;

    fn damage(sleeve: &str) -> String {
        let text = format!(
            "[sources.s]\ncitation = \"c\"\nterms = \"t\"\n[[sleeve]]\nname = \"n\"\ntitle \
             = \"T\"\nsource = \"s\"\nmaterial = \"m\"\n{sleeve}"
        );
        read(&text).map_or_else(|e| e.to_string(), |_| "read".into())
    }

    #[test]
    fn a_damaged_table_is_an_error() {
        for text in ["x =", "[[material]]\nname = \"n\""] {
            assert!(BuiltIn::parse(text).is_err(), "{text}");
        }
        assert!(damage("name = ").contains("TOML"));
        assert_eq!(damage("least_diameter = 3\nlargest_diameter = 4.0"), "read");
        assert_eq!(
            damage("least_diameter = 2\nstrands = 24\nstrand_diameter = 0.25"),
            "read"
        );
        assert!(damage("").contains("n: "));
        assert!(damage("nominal_diameter = 3\nangle = 20").contains("n: "));
        assert!(damage("least_diameter = 4\nlargest_diameter = 3").contains("helix"));
        assert!(damage("least_diameter = -4\nlargest_diameter = 3").contains("least_diameter"));
        assert!(damage("strands = 0").contains("strands = 0: "));
    }
}
