//! The braided sleeve: two families of helical strands at ±θ0 on the tube's outer surface.

use super::{
    Crimp, LARGEST_ANGLE_DEG,
    error::{MuscleError, positive},
    tube::Tube,
};
use crate::{
    refused::Refused,
    sleeve::SleeveShape,
    units::{Dimension, QuantityError, Words, typed::Stiffness},
};
use serde::{Deserialize, Deserializer, Serialize};
use std::str::FromStr;

/// How far a written angle may be from that of a named sleeve on the tube, in degrees.
pub const SLEEVE_ANGLE_TOLERANCE_DEG: f64 = 0.5;

/// How stiff a strand family is, as a force per length of a cut across the strands: k =
/// E·A/spacing.
///
/// As data (serde): a number in N/mm, `"inextensible"` or `"antonelli2018"`, which `"paper"` is too.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "Stiffness")]
pub enum BraidStiffness {
    /// Strands that do not stretch: the limit k → ∞.
    Inextensible,
    /// The paper's braid: k = 452 N/mm · (D0/40 mm)^1.2, identified together with the rubber
    /// `antonelli2018` (`docs/paper.md`).
    #[serde(rename = "antonelli2018")]
    Paper,
    /// From [`Strands`]: k = E·A/spacing, spacing = π D0 cosθ0/(N/2).
    #[serde(skip)]
    OfStrands,
    /// k of one family in N/mm.
    #[serde(untagged)]
    NewtonPerMm(#[schemars(with = "Stiffness")] f64),
}

const STIFFNESS: Words<BraidStiffness> = Words {
    words: &[
        ("antonelli2018", BraidStiffness::Paper),
        ("paper", BraidStiffness::Paper),
        ("inextensible", BraidStiffness::Inextensible),
    ],
    dimension: Dimension::Stiffness,
    quantity: BraidStiffness::NewtonPerMm,
};

impl FromStr for BraidStiffness {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        STIFFNESS.parse(text)
    }
}

impl<'de> Deserialize<'de> for BraidStiffness {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        STIFFNESS.read(from)
    }
}

/// The strands one by one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strands {
    /// N, both families together; even.
    pub count: u32,
    /// Cross-section of one strand, mm².
    pub area_mm2: Option<f64>,
    /// Young's modulus of one strand, MPa, where the stiffness follows from it.
    pub modulus_mpa: Option<f64>,
    /// Force at which one strand breaks, in N.
    pub strength_n: Option<f64>,
    /// Factor by which there may be fewer: 1 where they were counted.
    pub count_factor: f64,
    /// Factor by which they may be weaker: 1 where the strength is stated.
    pub strength_factor: f64,
}

impl Strands {
    /// Strands that were counted, of a strength that is stated; section: area in mm² and Young's
    /// modulus in MPa of one.
    pub fn new(count: u32, section: Option<(f64, f64)>, strength_n: Option<f64>) -> Self {
        let (area_mm2, modulus_mpa) = section.unzip();
        Self {
            count,
            area_mm2,
            modulus_mpa,
            strength_n,
            count_factor: 1.0,
            strength_factor: 1.0,
        }
    }

    /// Factor by which all strands together may bear less. Both factors are 95 % bounds of
    /// quantities that do not depend on each other, so that their logarithms add as squares.
    pub fn load_factor(&self) -> f64 {
        self.count_factor
            .ln()
            .hypot(self.strength_factor.ln())
            .exp()
    }
}

/// A strand measured on a real muscle, for Belforte's formula; includes the rounded ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredStrand {
    /// Length b of one strand from terminal to terminal, in mm.
    pub strand_length_mm: f64,
    /// Turns n it makes around the muscle.
    pub turns: f64,
}

/// A braid at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Braid {
    /// Angle θ0 of the strands to the muscle's axis at rest, in degrees.
    pub angle_deg: f64,
    /// Stiffness of one family.
    pub stiffness: BraidStiffness,
    /// The single strands, where they are known.
    pub strands: Option<Strands>,
    /// Strand length and turns measured on the muscle, where they are known.
    #[doc(hidden)]
    pub measured: Option<MeasuredStrand>,
    /// Whether strands carry compression, as the paper's trusses do. Real strands buckle: default
    /// false.
    pub compression: bool,
    /// t: thickness of the braid, both layers of strands, in mm. 0: the strands lie on the tube's
    /// surface.
    pub thickness_mm: f64,
    /// Whether the strands lie inside of the rubber, where they hardly rub on each other.
    pub in_rubber: bool,
    /// P0: pressure in MPa that takes up the slack of the braid before the muscle pulls, where it is
    /// stated.
    pub take_up_mpa: Option<f64>,
    /// Inner diameter in mm at which the sleeve has its angle, where it is wider than the tube.
    pub diameter_mm: Option<f64>,
    /// What straightens in the strands before they stretch.
    #[doc(hidden)]
    pub crimp: Option<Crimp>,
    /// Factor within which the stiffness is known; 1 where it is taken as it is.
    pub stiffness_factor: f64,
    /// b: strands that lie side by side on a carrier of the braiding machine, where it is known.
    pub strands_per_carrier: Option<f64>,
    /// The named sleeve that it was cut from, which gives its angle on another tube.
    #[doc(hidden)]
    pub sleeve: Option<SleeveShape>,
}

/// What a braid described by its strands takes.
pub const NEEDS_STRANDS: &str = "a braid described by its strands needs `strands`, \
    `strand_area` (or `strand_diameter`) and `strand_modulus`";

impl Braid {
    /// Outer diameters in mm from which the stiffness `antonelli2018` comes: its muscles had these.
    pub const PAPER_DIAMETERS_MM: (f64, f64) = (30.0, 50.0);
    /// k of the braid `antonelli2018` at D0 40 mm, in N/mm.
    pub const PAPER_AT_40_N_PER_MM: f64 = 452.0;
    /// Its k grows like this power of D0.
    pub const PAPER_EXPONENT: f64 = 1.2;

    /// The paper's braid: 28°, stiffness `antonelli2018`.
    pub fn paper() -> Self {
        Self {
            angle_deg: 28.0,
            stiffness: BraidStiffness::Paper,
            strands: None,
            measured: None,
            compression: false,
            thickness_mm: 0.0,
            in_rubber: false,
            take_up_mpa: None,
            diameter_mm: None,
            crimp: None,
            stiffness_factor: 1.0,
            strands_per_carrier: None,
            sleeve: None,
        }
    }

    /// This braid on a tube of another diameter: a named sleeve has another angle there; any other
    /// braid stays as it is.
    ///
    /// # Errors
    /// [`MuscleError`] where the sleeve does not fit the tube.
    pub fn on_diameter(self, outer_diameter_mm: f64) -> Result<Self, MuscleError> {
        let angle_deg = match &self.sleeve {
            Some(sleeve) => sleeve.angle_deg_on(self.diameter_mm.unwrap_or(outer_diameter_mm))?,
            None => self.angle_deg,
        };
        Ok(Self { angle_deg, ..self })
    }

    /// This braid with an angle that somebody stated, on a tube of a diameter.
    ///
    /// # Errors
    /// [`MuscleError`] where it is not that of the named sleeve within
    /// [`SLEEVE_ANGLE_TOLERANCE_DEG`], or the sleeve does not fit.
    pub fn with_stated_angle(
        self,
        angle_deg: f64,
        outer_diameter_mm: f64,
    ) -> Result<Self, MuscleError> {
        if let Some(sleeve) = &self.sleeve {
            let outer_diameter_mm = self.diameter_mm.unwrap_or(outer_diameter_mm);
            let of_sleeve_deg = sleeve.angle_deg_on(outer_diameter_mm)?;
            let off_deg = (angle_deg - of_sleeve_deg).abs();
            let name = &sleeve.name;
            // A NaN is no angle, and `check` says so.
            Refused::unless(
                off_deg.is_nan() || off_deg <= SLEEVE_ANGLE_TOLERANCE_DEG,
                ["braid.angle"],
                || {
                    format!(
                        "braid.angle is {angle_deg} deg, but {name} has {of_sleeve_deg:.2} deg on \
                         a tube of {outer_diameter_mm}\u{a0}mm: leave one of them out"
                    )
                },
            )?;
        }
        Ok(Self { angle_deg, ..self })
    }

    pub(super) fn check(&self) -> Result<(), MuscleError> {
        let angle = self.angle_deg;
        // No braid is laid at less than a degree, and many are at half a radian.
        Refused::unless(!(angle > 0.0 && angle < 1.0), ["braid.angle"], || {
            format!(
                "braid.angle is {angle} deg, less than any braid has; was {angle} rad meant? write \
                 {:.4} deg",
                angle.to_degrees()
            )
        })?;
        Refused::unless(
            angle > 0.0 && angle <= LARGEST_ANGLE_DEG,
            ["braid.angle"],
            || {
                format!(
                    "braid.angle is {angle} deg; the angle of the strands to the axis must be \
                     between 0 and 75 deg: a muscle contracts below 54.7356 deg and extends above"
                )
            },
        )?;
        if let BraidStiffness::NewtonPerMm(k) = self.stiffness {
            positive("braid.stiffness", k, "N/mm")?;
        }
        let missing = match self.strands {
            _ if self.stiffness != BraidStiffness::OfStrands => return Ok(()),
            None => "strands",
            Some(strands) if strands.area_mm2.is_none() => "strand_area",
            Some(strands) if strands.modulus_mpa.is_none() => "strand_modulus",
            Some(_) => return Ok(()),
        };
        Err(MuscleError::new(
            ["braid.strand_area", "braid.strand_modulus", "braid.strands"],
            format!("braid: {missing} is missing; {NEEDS_STRANDS}"),
        ))
    }

    /// Crimp whose measures are possible by themselves.
    pub(super) fn check_crimp(&self) -> Result<(), MuscleError> {
        let Some(Crimp {
            stiffness_ratio, ..
        }) = self.crimp
        else {
            return Ok(());
        };
        Refused::unless(stiffness_ratio <= 1.0, ["braid.crimp_stiffness"], || {
            format!(
                "braid.crimp_stiffness is {stiffness_ratio}; it is the share of the strands' \
                 stiffness that they have before they are straight, above 0 and at most 1"
            )
        })?;
        Refused::unless(
            self.stiffness != BraidStiffness::Inextensible,
            ["braid.crimp", "braid.stiffness"],
            || {
                "braid.crimp needs strands with a stiffness: it is a share of it that they have \
                 before they are straight"
                    .into()
            },
        )
    }

    /// Whether the tube fits into the sleeve.
    pub(super) fn check_on(&self, tube: &Tube) -> Result<(), MuscleError> {
        let thickness_mm = self.thickness_mm;
        let outer_diameter_mm = tube.outer_diameter_mm;
        Refused::unless(
            thickness_mm < outer_diameter_mm,
            ["braid.thickness", "tube.outer_diameter"],
            || {
                format!(
                    "braid.thickness is {thickness_mm}\u{a0}mm; it must be below the tube's outer \
                     diameter of {outer_diameter_mm}\u{a0}mm (both layers of strands, not the \
                     sleeve's diameter)"
                )
            },
        )?;
        let diameter_mm = self.diameter_mm.unwrap_or(outer_diameter_mm);
        Refused::unless(
            diameter_mm >= outer_diameter_mm,
            ["braid.diameter", "tube.outer_diameter"],
            || {
                format!(
                    "braid.diameter is {diameter_mm}\u{a0}mm, but the tube has an outer diameter \
                     of {outer_diameter_mm}\u{a0}mm: a sleeve that is pulled over a wider tube has \
                     the angle that it takes there; give that angle and leave the diameter out"
                )
            },
        )
    }

    /// What the user should know of this braid on this tube.
    pub(super) fn warning(&self, tube: &Tube) -> Option<String> {
        let (least, largest) = Self::PAPER_DIAMETERS_MM;
        let d = tube.outer_diameter_mm;
        let scaled = self.stiffness == BraidStiffness::Paper && !(least..=largest).contains(&d);
        scaled.then(|| {
            format!(
                "the braid `antonelli2018` is known for D0 {least}\u{a0}mm to {largest}\u{a0}mm; on \
                 {d}\u{a0}mm its stiffness is scaled like D0^{}, which no sleeve does: name a \
                 sleeve, or state stiffness or strands",
                Self::PAPER_EXPONENT
            )
        })
    }

    /// θ0 in radians.
    pub fn angle_rad(&self) -> f64 {
        self.angle_deg.to_radians()
    }

    /// k of one family on this tube in N/mm; `None` for inextensible strands.
    pub fn family_stiffness_n_per_mm(&self, tube: &Tube) -> Option<f64> {
        match self.stiffness {
            BraidStiffness::Paper => {
                let ratio = tube.outer_diameter_mm / 40.0;
                Some(Self::PAPER_AT_40_N_PER_MM * ratio.powf(Self::PAPER_EXPONENT))
            }
            BraidStiffness::NewtonPerMm(k) => Some(k),
            BraidStiffness::Inextensible => None,
            BraidStiffness::OfStrands => self.strands.and_then(|s| {
                let spacing = self.strand_spacing_mm(tube, s.count);
                Some(s.modulus_mpa? * s.area_mm2? / spacing)
            }),
        }
    }

    /// Distance between neighbouring strands of one family, across them: 2π Rs cosθ0/(N/2), in mm,
    /// Rs of [`super::StrandLay`] (π D0 cosθ0/(N/2) of strands on the surface).
    pub fn strand_spacing_mm(&self, tube: &Tube, count: u32) -> f64 {
        let lay = self.lay(tube);
        2.0 * std::f64::consts::PI * (2.0 * lay.radius_mm) * lay.angle_rad.cos() / f64::from(count)
    }
}
