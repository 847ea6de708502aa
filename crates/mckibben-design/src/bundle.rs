//! Equal muscles side by side: the circle around them, and when they touch.
//!
//! The smallest circle around n equal circles of radius r has the radius R = ρ(n) r. ρ up to n = 20
//! is that of the best packings known (Graham, Lubachevsky, Nurmela & Östergård 1998
//! \[graham1998\]; proven to be the best up to 13, and of 19). Of more circles it is that of the n
//! points of a hexagonal lattice which are nearest to one of its centres of symmetry: ρ = 1 + d/r,
//! d the distance of the farthest of them. Such a bundle is up to a tenth wider than the best one
//! that is known.

use crate::{Build, Candidate, CandidatePoint, OperatingPoint, Spec};
use mckibben_core::{
    analysis::{Evaluation, Options, bisect},
    extremes::peak,
    model::{ForceModel, ThickWall, Workspace},
};
use serde::Serialize;

/// What the muscles of a bundle do together.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "BundleAnswer")]
pub struct Bundle {
    /// How many muscles.
    pub muscles: u32,
    /// Diameter of the circle around them at rest, mm.
    pub rest_envelope_mm: f64,
    /// The same at the largest bulged diameter, mm.
    pub envelope_mm: Option<f64>,
    /// Width of all in one flat row at the largest bulged diameter, mm.
    pub row_mm: Option<f64>,
    /// Distance between the axes of neighbours, mm: as given, that of the largest envelope, or the
    /// bulged diameter.
    pub pitch_mm: Option<f64>,
    /// Contraction at which neighbours touch at that distance and the pressure of the supply; none
    /// where they do not.
    pub touch_contraction: Option<f64>,
    /// The operating points of all together.
    pub points: Vec<BundlePoint>,
    /// Mass of tubes and sleeves between the terminals, g, where both are known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass_g: Option<f64>,
}

/// An operating point of all muscles of a bundle together.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BundlePoint {
    /// What is required.
    #[serde(flatten)]
    pub wanted: OperatingPoint,
    /// Pull at the pressure of the supply, N.
    pub force_at_max_pressure_n: f64,
    /// 95 % half-width of that pull, N. What is not known of one muscle is not known of all: so
    /// many times that of one.
    pub uncertainty_n: Option<f64>,
    /// Air from rest to the point, normal litres; none with a liquid.
    pub air_normal_litres: Option<f64>,
    /// Liquid pushed in from rest to the point, measured at atmospheric pressure, mm³.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub liquid_volume_mm3: Option<f64>,
}

impl Bundle {
    /// The contraction at which neighbours touch, and the largest that is wanted, where that is
    /// beyond.
    pub fn touches_before(&self) -> Option<(f64, f64)> {
        let largest = peak(self.points.iter().map(|q| q.wanted.contraction));
        let touch = self.touch_contraction?;
        (touch < largest - 1e-6).then_some((touch, largest))
    }
}

/// The bundle of the best muscle.
pub fn of_winner(spec: &Spec, build: &Build<'_>, winner: &Candidate) -> Bundle {
    let ratio = envelope_ratio(spec.count);
    let count = f64::from(spec.count);
    let bulged = winner.bulged_diameter_mm();
    let of_envelope = spec.limits.envelope_mm.map(|mm| mm / ratio);
    let pitch_mm = spec.pitch_mm.or(of_envelope).or(bulged);
    let model = build(&winner.muscle).ok().filter(|_| spec.count > 1);
    let touch_contraction = model.zip(pitch_mm).and_then(|(model, pitch_mm)| {
        let pressure_mpa = winner.highest_pressure_mpa;
        touches_at(&*model, &mut Workspace::new(), pressure_mpa, pitch_mm)
    });
    let point = |q: &CandidatePoint| BundlePoint {
        wanted: OperatingPoint {
            force_n: count * q.wanted.force_n,
            ..q.wanted
        },
        force_at_max_pressure_n: count * q.force_at_max_pressure_n,
        uncertainty_n: q.uncertainty_n.map(|n| count * n),
        air_normal_litres: q.air_normal_litres.map(|litres| count * litres),
        liquid_volume_mm3: q.liquid_volume_mm3.map(|mm3| count * mm3),
    };
    Bundle {
        muscles: spec.count,
        rest_envelope_mm: ratio * winner.muscle.outer_diameter_mm(),
        envelope_mm: bulged.map(|mm| ratio * mm),
        row_mm: bulged.map(|mm| count * mm),
        pitch_mm,
        touch_contraction,
        points: winner.points.iter().map(point).collect(),
        mass_g: winner.muscle.mass_g().map(|g| count * g),
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
        let distance = |(i, j): (i32, i32)| {
            (2.0 * f64::from(i) + f64::from(j) - x).hypot(height * f64::from(j) - y)
        };
        let mut all: Vec<f64> = lattice.map(distance).collect();
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
        let own = model
            .response(workspace, pressure_mpa, contraction)
            .ok()?
            .bulged_diameter_mm;
        own.or_else(|| {
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
