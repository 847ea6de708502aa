//! Equal muscles side by side: the circle around them, and when they touch.
//!
//! The smallest circle around n equal circles of radius r has the radius R = ρ(n) r. ρ up to n = 20
//! is that of the best packings known (Graham, Lubachevsky, Nurmela & Östergård 1998
//! \[graham1998\]; proven to be the best up to 13, and of 19). Of more circles it is that of the n
//! points of a hexagonal lattice which are nearest to one of its centres of symmetry: ρ = 1 + d/r,
//! d the distance of the farthest of them. Such a bundle is up to a tenth wider than the best one
//! that is known.

use crate::{Build, Candidate, Ends, Spec, limits::all_g};
use mckibben_core::{
    analysis::{Evaluation, Options, bisect},
    model::{ForceModel, ThickWall, Workspace},
};
use serde::Serialize;

/// What the muscles of a bundle do together.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "BundleAnswer")]
pub struct Bundle {
    /// How many muscles.
    pub muscles: u32,
    /// Diameter of the circle around them and their ends at rest, mm.
    pub rest_envelope_mm: f64,
    /// The same at the largest width, mm.
    pub envelope_mm: f64,
    /// Distance between the axes of neighbours, mm: as given, or the width of one.
    pub pitch_mm: f64,
    /// Contraction at which neighbours touch at that distance and the pressure of the supply; none
    /// where they do not.
    pub touch_contraction: Option<f64>,
    /// Mass of all with their ends, g, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass_g: Option<f64>,
}

/// The bundle of a candidate.
pub fn of_candidate(spec: &Spec, build: &Build<'_>, one: &Candidate) -> Bundle {
    let ratio = envelope_ratio(one.count);
    let pitch_mm = spec.pitch_mm.unwrap_or(one.width_mm);
    let ends_mm = one.ends.map_or(0.0, |ends| ends.width_mm);
    let around = |width_mm: f64| (ratio - 1.0) * pitch_mm.max(width_mm) + width_mm;
    let touch_contraction = build(&one.muscle).ok().and_then(|model| {
        let pressure_mpa = one.highest_pressure_mpa;
        touches_at(&*model, &mut Workspace::new(), pressure_mpa, pitch_mm)
    });
    Bundle {
        muscles: one.count,
        rest_envelope_mm: around(one.muscle.outer_diameter_mm().max(ends_mm)),
        envelope_mm: around(one.width_mm),
        pitch_mm,
        touch_contraction,
        mass_g: all_g(&one.muscle, one.ends.unwrap_or(Ends::NONE), one.count),
    }
}

/// ρ(n) of 1 to 20 circles.
const KNOWN: [f64; 20] = [
    1.0,
    2.0,
    2.154_700_5,
    2.414_213_6,
    2.701_301_6,
    3.0,
    3.0,
    3.304_764_9,
    3.613_125_9,
    3.813_025_6,
    3.923_804_4,
    4.029_601_9,
    4.236_068_0,
    4.328_428_6,
    4.521_357_0,
    4.615_425_6,
    4.792_033_7,
    4.863_703_3,
    4.863_703_3,
    5.122_320_7,
];

/// Muscles of a bundle at most.
pub const MOST: u32 = 1000;

/// ρ: the radius of the circle around so many equal circles, over theirs.
pub fn envelope_ratio(count: u32) -> f64 {
    match KNOWN.get((count.max(1) - 1) as usize) {
        Some(known) => *known,
        None => hexagonal(count),
    }
}

/// ρ of points of a hexagonal lattice with unit distances 2 around a point, the middle of an edge,
/// or that of a triangle.
pub fn hexagonal(count: u32) -> f64 {
    let height = 3f64.sqrt();
    // Rings of the lattice that hold them all, and one more for centres beside a point.
    let rings = (f64::from(count) / 3.0).sqrt().ceil() as i32 + 2;
    let centres = [(0.0, 0.0), (1.0, 0.0), (1.0, height / 3.0)];
    let around = |(x, y): (f64, f64)| {
        let lattice = (-rings..=rings).flat_map(|j| (-rings..=rings).map(move |i| (i, j)));
        let mut all: Vec<f64> = lattice
            .map(|(i, j): (i32, i32)| {
                (2.0 * f64::from(i) + f64::from(j) - x).hypot(height * f64::from(j) - y)
            })
            .collect();
        all.sort_by(f64::total_cmp);
        1.0 + all
            .get(count as usize - 1)
            .copied()
            .unwrap_or(f64::INFINITY)
    };
    centres
        .map(around)
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

/// The smallest contraction at which muscles touch whose axes lie `pitch_mm` apart: where the
/// bulged diameter at that pressure reaches the pitch. `None` where they do not touch up to the
/// free contraction, or where the model has no answer.
pub fn touches_at(
    model: &dyn ForceModel,
    workspace: &mut Workspace,
    pressure_mpa: f64,
    pitch_mm: f64,
) -> Option<f64> {
    let thick_wall = ThickWall::between_ends(model.muscle());
    let mut diameter = |contraction: f64| {
        model
            .response(workspace, pressure_mpa, contraction)
            .ok()?
            .bulged_diameter_mm
            .or_else(|| {
                thick_wall
                    .response(workspace, pressure_mpa, contraction)
                    .ok()?
                    .bulged_diameter_mm
            })
    };
    if diameter(0.0)? >= pitch_mm {
        return Some(0.0);
    }
    let workspace = &mut Workspace::new();
    let free = Evaluation::new(model, workspace, Options::default())
        .free_contraction(pressure_mpa)
        .ok()?;
    if diameter(free)? < pitch_mm {
        return None;
    }
    Some(
        bisect(0.0, free, 40, |contraction| {
            diameter(contraction).is_none_or(|mm| mm < pitch_mm)
        })
        .1,
    )
}
