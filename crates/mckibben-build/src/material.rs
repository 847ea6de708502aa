//! The bill of materials.

use crate::{
    Clamps, Cut, Fitting, Plan, SleeveCut,
    text::{mm, trimmed},
};
use mckibben_core::{muscle::Muscle, rubber::library as rubbers, sleeve::library as sleeves};
use mckibben_design::tubes::{self, TubePart};

/// Density of printed plugs in g/mm³: solid PETG, 1.27 g/cm³ (PLA has 1.24).
const PRINTED_G_PER_MM3: f64 = 1.27e-3;
/// Tolerance of equal diameters of part and muscle, in mm.
const SAME_MM: f64 = 0.011;

/// A line of the bill.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize, schemars::JsonSchema)]
pub struct BuildPart {
    /// Number in the drawing.
    pub number: u32,
    /// What it is.
    pub part: String,
    /// How much of it.
    pub amount: String,
    /// Name as sold, where it is of the catalogue.
    pub sold_as: Option<String>,
    /// Mass in g, where it is known.
    pub mass_g: Option<f64>,
    /// Price as its source states it.
    pub price: Option<String>,
    /// Where name and price come from.
    pub source: Option<String>,
}

/// The tube of the catalogue that has the muscle's diameters and rubber.
fn tube_of(muscle: &Muscle, cut: &Cut) -> Option<&'static TubePart> {
    let name = muscle.tube().rubber.name.as_deref()?;
    let same = |a: f64, b: f64| (a - b).abs() < SAME_MM;
    tubes::catalogue().ok()?.iter().find(|t| {
        same(t.outer_diameter_mm, cut.tube_outer_diameter_mm)
            && same(t.wall_mm, cut.tube_wall_mm)
            && t.rubber.name.as_deref() == Some(name)
    })
}

pub fn bill(plan: &Plan) -> Vec<BuildPart> {
    let Plan {
        muscle,
        cut,
        air_plug,
        eye_plug,
        ..
    } = plan;
    let tube = tube_of(muscle, cut);
    let rubber = muscle.tube().rubber.name.as_deref();
    let of_rubber = || {
        rubber
            .and_then(|n| rubbers::entry(n).ok())
            .and_then(|e| e.density_kg_per_m3)
    };
    let density = muscle.tube().density_kg_per_m3.or_else(of_rubber);
    let bore = cut.tube_outer_diameter_mm - 2.0 * cut.tube_wall_mm;
    let what = if tube.is_some_and(|t| t.is_cast) {
        "cast tube"
    } else {
        "tube"
    };
    let first = BuildPart {
        number: 1,
        part: format!(
            "{what}, bore {} mm, outer diameter {} mm{}",
            mm(bore),
            mm(cut.tube_outer_diameter_mm),
            rubber.map_or_else(String::new, |name| format!(", rubber {name}"))
        ),
        amount: format!("{} mm", mm(cut.tube_mm)),
        sold_as: tube.map(|t| t.name.clone()),
        mass_g: density.map(|d| 1e-6 * d * cut.rubber_mm3),
        price: tube.and_then(|t| t.price.clone()),
        source: tube.map(|t| t.source.clone()),
    };
    let clamp = match plan.clamps {
        Clamps::Ties { width_mm, .. } => format!("cable tie, {} mm wide", mm(width_mm)),
        Clamps::Crimped => "crimped ferrule or hose clamp".into(),
    };
    let bought = |number, part: String, amount: &str| BuildPart {
        number,
        part,
        amount: amount.into(),
        ..BuildPart::default()
    };
    let printed = plan.is_printed();
    let plug = |number, part: &str, volume_mm3: f64| BuildPart {
        mass_g: printed.then_some(PRINTED_G_PER_MM3 * volume_mm3),
        ..bought(
            number,
            part.into(),
            if printed {
                "1, printed solid"
            } else {
                "1, turned from metal"
            },
        )
    };
    let fitting = match air_plug.fitting {
        Fitting::Barb { bore_mm } => {
            format!("hose with a bore of {} mm, and a clamp for it", mm(bore_mm))
        }
        thread => format!("push-in fitting with thread {thread}, with its seal"),
    };
    vec![
        first,
        sleeve(muscle, &cut.sleeve),
        plug(3, "air plug (air-plug.stl)", air_plug.mesh().volume_mm3()),
        plug(4, "eye plug (eye-plug.stl)", eye_plug.mesh().volume_mm3()),
        bought(5, clamp, &plan.clamps.amount()),
        bought(6, fitting, "1"),
        bought(7, format!("bolt M{}", mm(eye_plug.bolt_mm)), "1"),
    ]
}

fn sleeve(muscle: &Muscle, cut: &SleeveCut) -> BuildPart {
    let shape = muscle.braid().sleeve.as_ref();
    let entry = shape.and_then(|s| sleeves::entry(&s.name).ok());
    let density = entry
        .and_then(|e| e.modulus_of)
        .and_then(|material| material.density_kg_per_m3);
    let volume = cut
        .strands
        .zip(cut.strand_area_mm2)
        .map(|(n, area)| f64::from(n) * area * cut.strand_mm);
    let angle = mm(muscle.braid().angle_deg);
    let amount = match (cut.relaxed_mm, cut.relaxed_diameter_mm) {
        (Some(length), Some(diameter)) => {
            format!("{} mm at ⌀ {} mm", trimmed(length, 1), mm(diameter))
        }
        _ => format!("{} mm on the tube", mm(cut.mounted_mm)),
    };
    let strands = cut
        .strands
        .map_or_else(String::new, |n| format!(", {n} strands"));
    BuildPart {
        number: 2,
        part: match entry {
            Some(entry) => format!("{}{strands}", entry.title),
            None => {
                format!(
                    "braided sleeve, {angle}° on {} mm{strands}",
                    mm(muscle.outer_diameter_mm())
                )
            }
        },
        amount,
        sold_as: shape.map(|s| s.name.clone()),
        mass_g: volume.zip(density).map(|(v, d)| 1e-6 * d * v),
        price: entry.and_then(|e| e.price.clone()),
        source: entry.map(|e| e.source.clone()),
    }
}
