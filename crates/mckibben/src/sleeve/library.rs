//! Named sleeves, from `data/braids.toml`, which states source and terms of each.

use super::{Helix, OF_STIFFNESS, Sleeve, SleeveShape, refused};
use crate::catalogue::{Catalogue, CatalogueError, Row, named, plain};
use crate::refused::Refused;
use std::sync::OnceLock;

/// An angle at a diameter, as stated.
const OF_ANGLE: &str = "the angle that its source states at a diameter";
/// Least and largest diameter.
const OF_RANGE: &str =
    "the range that its source states; strands are taken to touch at both ends of it";
/// The least diameter and the width of all strands.
const OF_LEAST: &str = "its least diameter and its strands, which are taken to touch there";

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

/// What strands are made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Name, such as `aramid-49`.
    pub name: String,
    /// What it is, for people.
    pub title: String,
    /// Young's modulus in MPa.
    pub modulus_mpa: f64,
    /// Diameter of a filament of a sleeve in mm, where its seller does not state it: an estimate.
    pub filament_diameter_mm: Option<f64>,
    /// Strength of a filament in a braid in MPa: an estimate.
    pub strength_mpa: Option<f64>,
    /// Strands that lie side by side on a carrier, of sleeves whose seller does not state it.
    pub strands_per_carrier: Option<f64>,
    /// Density in kg/m³.
    pub density_kg_per_m3: Option<f64>,
    /// Factor within which the stiffness of a sleeve with these estimates is known.
    pub factor: f64,
    /// What the estimates are from.
    pub estimate: Option<String>,
    /// Where the modulus comes from.
    pub source: String,
    /// What else one should know.
    pub note: Option<String>,
}

const TEXT: &str = include_str!("../../data/braids.toml");

/// All sleeves, in the order of the table.
///
/// # Errors
/// [`Refused`], which no released program should see.
pub fn entries() -> Result<&'static [SleeveEntry], Refused> {
    static ENTRIES: OnceLock<Result<Vec<SleeveEntry>, Refused>> = OnceLock::new();
    ENTRIES
        .get_or_init(|| Ok(entries_of(&Catalogue::parse(TEXT)?, materials()?)?))
        .as_deref()
        .map_err(Refused::clone)
}

/// All materials, in the order of the table.
pub fn materials() -> Result<&'static [Material], Refused> {
    static MATERIALS: OnceLock<Result<Vec<Material>, Refused>> = OnceLock::new();
    MATERIALS
        .get_or_init(|| read_materials(TEXT))
        .as_deref()
        .map_err(Refused::clone)
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

/// The sleeve of a name, or of a material with the two diameters at which its strands touch, such
/// as `pet:6..18mm`.
pub fn find(name: &str) -> Result<Sleeve, Refused> {
    let range = || {
        let (material, range) = name.split_once(':')?;
        let (least, largest) = range.trim().trim_end_matches("mm").split_once("..")?;
        Some((
            material,
            least.trim().parse().ok()?,
            largest.trim().parse().ok()?,
        ))
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
    let entries =
        Catalogue::parse(text).and_then(|file| entries_of(&file, materials().unwrap_or_default()));
    entries.map_err(|e| refused(format!("the table of sleeves: {e}")))
}

/// Keys of a sleeve in a table.
pub const KEYS: &str = "name aliases title material like factor nominal_diameter nominal_diameters \
    range angle least_diameter \
    largest_diameter strands filaments strand_diameter strand_modulus strand_strength \
    strands_per_carrier price note source";

impl From<CatalogueError> for Refused {
    fn from(error: CatalogueError) -> Self {
        refused(format!("the built-in table of sleeves is damaged: {error}"))
    }
}
fn read_materials(file: &str) -> Result<Vec<Material>, Refused> {
    let one = |row: &Row<'_>| {
        Ok(Material {
            name: row.text("name")?.to_owned(),
            title: row.text("title")?.to_owned(),
            modulus_mpa: row.needed("modulus")?,
            filament_diameter_mm: row.number("filament_diameter")?,
            strength_mpa: row.number("strength")?,
            strands_per_carrier: row.number("strands_per_carrier")?,
            density_kg_per_m3: row.number("density")?,
            factor: row.number("factor")?.unwrap_or(1.0),
            estimate: row.owned("estimate"),
            source: row.source()?.text("citation")?.to_owned(),
            note: row.owned("note"),
        })
    };
    Catalogue::parse(file)?
        .rows("material")
        .iter()
        .map(one)
        .collect()
}

/// A row is a sleeve, or a family of them: one of each nominal diameter, of a `range` in shares of
/// it.
fn entries_of(
    file: &Catalogue<'_>,
    materials: &'static [Material],
) -> Result<Vec<SleeveEntry>, CatalogueError> {
    let mut out = vec![];
    for row in file.rows("sleeve") {
        match (
            &row.numbers("nominal_diameters")?[..],
            &row.numbers("range")?[..],
        ) {
            ([], _) => out.push(read_entry(&row, materials, None)?),
            (sizes, &[least, largest]) => {
                for &mm in sizes {
                    // Tenths, without the last binary digits.
                    let [least, largest] =
                        [least, largest].map(|share| (1e6 * share * mm).round() / 1e6);
                    out.push(read_entry(&row, materials, Some((mm, least, largest)))?);
                }
            }
            _ => return Err(row.wrong("`range` must be two numbers")),
        }
    }
    Ok(out)
}

fn read_entry(
    row: &Row<'_>,
    materials: &'static [Material],
    size: Option<(f64, f64, f64)>,
) -> Result<SleeveEntry, CatalogueError> {
    let (mut name, material) = (
        row.text("name")?.to_owned(),
        row.optional("material").unwrap_or("pet").to_owned(),
    );
    let mut title = row.optional("title").unwrap_or(&name).to_owned();
    if let Some((mm, ..)) = size {
        (name, title) = (format!("{name}-{mm}"), format!("{title}, nominal {mm} mm"));
    }
    let (source, terms) = match row.source() {
        Ok(origin) => (origin.text("citation")?, origin.text("terms")?),
        Err(_) => (row.source_text(), "not stated"),
    };
    // What its strands are taken to be, where their material is not stated or not one of the table.
    let like = row.optional("like").unwrap_or(&material);
    let modulus_of = materials.iter().find(|m| m.name == like);
    let (nominal_mm, angle) = (
        row.number("nominal_diameter")?.or(size.map(|s| s.0)),
        row.number("angle")?,
    );
    let least = row.number("least_diameter")?.or(size.map(|s| s.1));
    let largest = row.number("largest_diameter")?.or(size.map(|s| s.2));
    let (strands, filaments) = (row.count("strands")?, row.count("filaments")?.unwrap_or(1));
    let strand_diameter_mm = row.number("strand_diameter")?;
    let width = strands
        .zip(strand_diameter_mm)
        .map(|(n, d)| f64::from(n * filaments) * d);
    let (helix, helix_from) = match (nominal_mm.zip(angle), least.zip(largest), least.zip(width)) {
        (Some((diameter, angle)), _, _) => (Helix::at(diameter, angle), OF_ANGLE),
        (None, Some((least, largest)), _) => (Helix::jammed_at(least, largest), OF_RANGE),
        (None, None, Some((least, width))) => (Helix::jammed_at_least(least, width), OF_LEAST),
        (None, None, None) => (None, OF_ANGLE),
    };
    let helix = helix.ok_or_else(|| row.wrong("nothing that gives a helix"))?;
    // What is not stated of the range is where the strands jam.
    let jams = width.and_then(|w| helix.jams_at(w));
    let bounds = least
        .or(jams.map(|j| j.0))
        .zip(largest.or(jams.map(|j| j.1)));
    let (least_mm, largest_mm) = bounds.ok_or_else(|| row.wrong("no range"))?;
    let stated = Sleeve {
        strands,
        filaments,
        strand_diameter_mm,
        strand_modulus_mpa: row.number("strand_modulus")?,
        strand_strength_n: row.number("strand_strength")?,
        strands_per_carrier: row.number("strands_per_carrier")?,
        ..Sleeve::new(SleeveShape {
            name,
            helix,
            least_mm,
            largest_mm,
        })
    };
    let factor = row.number("factor")?;
    Ok(SleeveEntry {
        modulus_of: modulus_of.filter(|_| stated.strand_modulus_mpa.is_none()),
        sleeve: match modulus_of {
            Some(material) => estimated(stated, material, factor),
            None => stated,
        },
        aliases: row.texts("aliases"),
        title,
        material,
        nominal_mm,
        helix_from,
        source: source.to_owned(),
        terms: terms.to_owned(),
        price: row.owned("price"),
        note: row.owned("note"),
    })
}

/// A sleeve with what its source does not state taken from its material.
fn estimated(mut sleeve: Sleeve, material: &Material, factor: Option<f64>) -> Sleeve {
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
    let (area, strength) = (sleeve.strand_area_mm2(), material.strength_mpa);
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
        let read = Catalogue::parse(&text).and_then(|file| entries_of(&file, &[]));
        read.map_or_else(|e| e.to_string(), |_| "read".into())
    }

    #[test]
    fn a_damaged_table_is_an_error() {
        for text in ["x =", "[[material]]\nname = \"n\""] {
            assert!(
                matches!(read_materials(text), Err(Refused { .. })),
                "{text}"
            );
        }
        assert!(damage("name = ").contains("TOML"));
        assert_eq!(damage("least_diameter = 3\nlargest_diameter = 4.0"), "read");
        assert_eq!(
            damage("least_diameter = 2\nstrands = 24\nstrand_diameter = 0.25"),
            "read"
        );
        assert!(damage("").contains("n: nothing that gives a helix"));
        assert!(damage("nominal_diameter = 3\nangle = 20").contains("n: no range"));
        assert!(damage("least_diameter = 4\nlargest_diameter = 3").contains("helix"));
        assert!(damage("least_diameter = -4\nlargest_diameter = 3").contains("least_diameter"));
        assert!(damage("strands = 0").contains("`strands` must be a count"));
    }
}
