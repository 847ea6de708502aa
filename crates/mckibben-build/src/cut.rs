//! Lengths of tube and sleeve to cut.

use mckibben_core::{
    muscle::Muscle,
    sleeve::{Helix, library},
};

/// Lengths and diameters of tube and sleeve before they are mounted.
#[derive(Debug, Clone, PartialEq, serde::Serialize, schemars::JsonSchema)]
pub struct Cut {
    /// Length of tube to cut in mm, before it is stretched.
    pub tube_mm: f64,
    /// Outer diameter in mm of the tube as bought or cast.
    pub tube_outer_diameter_mm: f64,
    /// Wall in mm of the tube as bought or cast.
    pub tube_wall_mm: f64,
    /// Volume of the rubber in mm³.
    pub rubber_mm3: f64,
    /// The sleeve.
    pub sleeve: SleeveCut,
}

/// A sleeve keeps the length of its strands, and so is longer the narrower it is: L = S cosθ, sinθ
/// = π D/ℓ.
#[derive(Debug, Clone, PartialEq, serde::Serialize, schemars::JsonSchema)]
pub struct SleeveCut {
    /// Length in mm of the mounted sleeve, on the tube, with what is clamped and what is trimmed.
    pub mounted_mm: f64,
    /// S, length in mm of one strand over the whole cut.
    #[serde(skip)]
    pub strand_mm: f64,
    /// Strands of both families, where their number is known.
    #[serde(skip)]
    pub strands: Option<u32>,
    /// Cross-section of a strand in mm², where it is known.
    #[serde(skip)]
    pub strand_area_mm2: Option<f64>,
    /// The relaxed diameter in mm that was given, or as which the sleeve is sold.
    pub relaxed_diameter_mm: Option<f64>,
    /// Length in mm to cut at that diameter.
    pub relaxed_mm: Option<f64>,
    /// Lengths to cut at a few diameters.
    #[serde(skip)]
    pub by_diameter: Vec<SleeveLength>,
}

/// The length of a sleeve where it has a diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SleeveLength {
    /// Diameter in mm.
    pub diameter_mm: f64,
    /// Length to cut in mm.
    pub length_mm: f64,
}

/// Diameters in the table of the sleeve.
const ROWS: usize = 5;
/// What the sleeve is cut longer in mm, and trimmed before its second end is closed (a choice).
pub const TRIM_MM: f64 = 20.0;

impl Cut {
    /// Bore in mm of the tube as bought or cast.
    pub fn bore_mm(&self) -> f64 {
        self.tube_outer_diameter_mm - 2.0 * self.tube_wall_mm
    }

    /// The cut of a muscle, whose sleeve has `relaxed_diameter_mm` as it comes off the roll, and of
    /// whose tube a length in mm lies on each plug.
    pub(crate) fn new(muscle: &Muscle, relaxed_diameter_mm: Option<f64>, on_plug_mm: f64) -> Self {
        let sheet = muscle.build_sheet();
        let beyond_mm = 2.0 * (muscle.insertion_mm() - on_plug_mm);
        let tube_mm = sheet.tube_cut_mm - beyond_mm;
        let mounted_mm = sheet.braid_cut_mm + TRIM_MM;
        let strand_mm = mounted_mm / muscle.braid().angle_rad().cos();
        // A stretched tube is thinner by √λp all over.
        let thicker = muscle.tube().prestretch.sqrt();
        let outer_mm = muscle.outer_diameter_mm();
        let braid = muscle.braid();
        let on_mm = braid.diameter_mm.unwrap_or(outer_mm);
        let helix = Helix::at(on_mm, braid.angle_deg);
        let at = |diameter: f64| {
            let angle = helix?.angle_deg(diameter)?;
            Some(strand_mm * angle.to_radians().cos())
        };
        let shape = braid.sleeve.as_ref();
        let ends = shape.map(|shape| (shape.least_mm, shape.largest_mm));
        let entry = shape.and_then(|shape| library::entry(&shape.name).ok());
        // A name by its nominal size may be below what the sleeve closes to.
        let least_mm = ends.map_or(0.0, |ends| ends.0);
        let sold = entry.and_then(|e| e.nominal_mm).map(|d| d.max(least_mm));
        let relaxed = relaxed_diameter_mm.or(sold).filter(|d| at(*d).is_some());
        let ends = ends.unwrap_or((0.6 * on_mm, 1.2 * on_mm));
        // As far as muscles of it go, and no further than it opens.
        let low = ends.0.min(on_mm);
        let high = ends
            .1
            .min(1.5 * on_mm)
            .max(on_mm)
            .max(relaxed.unwrap_or(0.0));
        let step = |i: usize| low + (high - low) * i as f64 / (ROWS - 1) as f64;
        let tenth = |d: f64| (10.0 * d).round() / 10.0;
        let rows = (0..ROWS).map(|i| tenth(step(i))).filter_map(|d| {
            Some(SleeveLength {
                diameter_mm: d,
                length_mm: at(d)?,
            })
        });
        Self {
            tube_mm,
            tube_outer_diameter_mm: outer_mm * thicker,
            tube_wall_mm: muscle.wall_mm() * thicker,
            rubber_mm3: sheet.rubber_volume_mm3 * tube_mm / sheet.tube_cut_mm,
            sleeve: SleeveCut {
                mounted_mm,
                strand_mm,
                strands: sheet.strands,
                strand_area_mm2: braid.strands.and_then(|s| s.area_mm2),
                relaxed_diameter_mm: relaxed,
                relaxed_mm: relaxed.and_then(at),
                by_diameter: rows.collect(),
            },
        }
    }
}
