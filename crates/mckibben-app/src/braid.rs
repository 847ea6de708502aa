//! Sleeves of the library, and the braid that each becomes on a tube.

use crate::{Result, TextFile, parts::sleeve_entries};
use mckibben_core::{
    muscle::NEUTRAL_ANGLE_DEG,
    sleeve::{Sleeve, SleeveEntry, library},
};
use schemars::JsonSchema;
use serde::Serialize;

/// A sleeve in a line.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct BraidSummary {
    /// The word for `braid`.
    pub name: String,
    /// What it is.
    pub title: String,
    /// What its strands are.
    pub material: String,
    /// Least outer diameter of a tube in it, mm.
    pub least_diameter_mm: f64,
    /// Largest outer diameter of a tube in it, mm.
    pub largest_diameter_mm: f64,
    /// Angle on the least diameter, degrees.
    pub least_angle_deg: f64,
    /// Strands of both families, where they are known.
    pub strands: Option<u32>,
    /// What its source does not state and its stiffness needs, with spaces between; estimates
    /// replace it.
    pub missing: String,
    /// Factor within which its stiffness is known; 1 where all of its strands are stated.
    pub stiffness_factor: f64,
    /// Where the data come from.
    pub source: String,
}

/// A sleeve, its source and terms, and what it is on tubes.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
pub struct BraidDetails {
    /// What the library has of it.
    #[serde(flatten)]
    pub entry: SleeveEntry,
    /// Its name.
    pub name: String,
    /// Least diameter it closes to, mm.
    pub least_diameter_mm: f64,
    /// Largest diameter it opens to, mm.
    pub largest_diameter_mm: f64,
    /// The diameter at 54.7°, beyond which a muscle does not contract, mm.
    pub neutral_diameter_mm: f64,
    /// Length of strand per turn, mm, which stays on any tube.
    pub strand_length_per_turn_mm: f64,
    /// Source of the helix.
    pub helix_from: String,
    /// Strands of both families; those that fit, where only range and diameter are known.
    pub strands: Option<u32>,
    /// Whether that number is stated; otherwise it and the stiffness are upper bounds.
    pub strands_stated: bool,
    /// Where that comes from, where not from the source of the sleeve.
    pub modulus_source: Option<String>,
    /// What its source does not state and its stiffness needs: keys of a muscle file.
    pub missing: Vec<String>,
    /// Factor within which its stiffness is known; 1 where all of its strands are stated.
    pub stiffness_factor: f64,
    /// What the estimates are from.
    pub estimate: Option<String>,
    /// What it is on tubes.
    pub points: Vec<BraidPoint>,
}

/// A sleeve on a tube.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
pub struct BraidPoint {
    /// Outer diameter D0 of the tube, mm.
    pub outer_diameter_mm: f64,
    /// Angle θ0 on it, degrees.
    pub angle_deg: f64,
    /// Stiffness k of one strand family, N/mm, where the strands are known.
    pub stiffness_n_per_mm: Option<f64>,
    /// Remaining contraction: to 54.7°, or to where the strands jam before.
    pub largest_contraction: f64,
}

/// What gives the stiffness and is not stated, or an estimate.
fn unstated(sleeve: &Sleeve) -> Vec<&'static str> {
    let estimated = sleeve
        .estimated
        .iter()
        .copied()
        .filter(|key| *key != "strand_strength");
    sleeve.missing().into_iter().chain(estimated).collect()
}

/// The sleeves of the library, or of a table of the user's own.
pub fn sleeves(parts: Option<&TextFile>) -> Result<Vec<BraidSummary>> {
    let one = |entry: &SleeveEntry| {
        let (least_diameter_mm, largest_diameter_mm) = entry.sleeve.shape.tubes_mm();
        Ok(BraidSummary {
            name: entry.sleeve.name().into(),
            title: entry.title.clone(),
            material: entry.material.clone(),
            least_diameter_mm,
            largest_diameter_mm,
            least_angle_deg: entry.sleeve.shape.angle_deg_on(least_diameter_mm)?,
            strands: entry.sleeve.strands,
            missing: unstated(&entry.sleeve).join(" "),
            stiffness_factor: entry.sleeve.stiffness_factor(),
            source: entry.source.clone(),
        })
    };
    sleeve_entries(parts)?.iter().map(one).collect()
}

/// A sleeve; `None` where there is none of that name.
pub fn sleeve_details(name: &str) -> Result<Option<BraidDetails>> {
    let Ok(entry) = library::entry(name) else {
        return Ok(None);
    };
    let sleeve = &entry.sleeve;
    let diameters = round_diameters(sleeve.shape.tubes_mm());
    let (least_diameter_mm, largest_diameter_mm) = sleeve.diameters();
    Ok(Some(BraidDetails {
        entry: entry.clone(),
        name: sleeve.name().into(),
        least_diameter_mm,
        largest_diameter_mm,
        neutral_diameter_mm: sleeve.shape.helix.diameter_mm(NEUTRAL_ANGLE_DEG),
        strand_length_per_turn_mm: sleeve.shape.helix.strand_length_per_turn_mm(),
        helix_from: entry.helix_from.to_string(),
        strands: sleeve.strand_count(),
        strands_stated: sleeve.strands.is_some(),
        modulus_source: entry.modulus_of.map(|m| match &m.note {
            Some(note) => format!("{}: {}. {note}", m.title, m.source),
            None => format!("{}: {}", m.title, m.source),
        }),
        missing: sleeve.missing().into_iter().map(str::to_string).collect(),
        stiffness_factor: sleeve.stiffness_factor(),
        estimate: entry
            .modulus_of
            .filter(|_| !sleeve.estimated.is_empty())
            .and_then(|m| m.estimate.clone()),
        points: diameters
            .iter()
            .map(|d| point(sleeve, *d))
            .collect::<Result<_>>()?,
    }))
}

fn point(sleeve: &Sleeve, outer_diameter_mm: f64) -> Result<BraidPoint> {
    Ok(BraidPoint {
        outer_diameter_mm,
        angle_deg: sleeve.shape.angle_deg_on(outer_diameter_mm)?,
        stiffness_n_per_mm: sleeve.stiffness_n_per_mm(outer_diameter_mm)?,
        largest_contraction: sleeve.shape.largest_contraction_on(outer_diameter_mm)?,
    })
}

/// The least diameter, and round ones below the largest.
fn round_diameters((least, largest): (f64, f64)) -> Vec<f64> {
    let decade = 10f64.powf((largest - least).log10().floor() - 1.0);
    let step = [1.0, 2.0, 5.0, 10.0, 20.0]
        .map(|s| s * decade)
        .into_iter()
        .find(|s| (largest - least) / s <= 12.0)
        .unwrap_or(largest - least);
    let first = (least / step * (1.0 + 1e-9)).floor() + 1.0;
    let count = ((largest - least) / step).ceil();
    // Multiples of a power of ten, without the last binary digits.
    let round = |v: f64| (v * 1e6).round() / 1e6;
    let inside = (0..=count as u32).map(|i| round((first + f64::from(i)) * step));
    std::iter::once(least)
        .chain(inside.filter(|d| *d < largest))
        .collect()
}
