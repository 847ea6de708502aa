//! Why parts do not make a muscle.

use crate::rubber::LawError;
use crate::rubber::over_time::OverTimeError;
use crate::sleeve::SleeveError;
use std::borrow::Cow;
use thiserror::Error;

/// What is wrong with a muscle; every variant carries the value that was given.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MuscleError {
    /// A length, area, modulus or count that must be above zero.
    #[error("{key} is {}; it must be above zero and finite", with_unit(*.value, .unit))]
    NotPositive {
        /// Key as in the muscle file, such as `tube.outer_diameter`.
        key: &'static str,
        /// What was given.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A number below zero, or not finite, where zero is the least.
    #[error("{key} is {}; it must not be below zero, and finite", with_unit(*.value, .unit))]
    Negative {
        /// Key as in the muscle file.
        key: &'static str,
        /// What was given.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A number outside of its bounds.
    #[error("{key} is {}; it must lie between {low} and {high}", with_unit(*.value, .unit))]
    OutOfBounds {
        /// Key as in the muscle file.
        key: &'static str,
        /// What was given.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// The lowest value.
        low: f64,
        /// The highest value.
        high: f64,
    },
    /// A wall that leaves no bore.
    #[error(
        "tube.wall_thickness is {wall_mm} mm, but the radius is {radius_mm} mm: the wall must be thinner than the radius (half of tube.outer_diameter)"
    )]
    WallTooThick {
        /// Wall in mm.
        wall_mm: f64,
        /// Outer radius in mm.
        radius_mm: f64,
    },
    /// A plug on which the tube cannot be clamped.
    #[error(
        "terminals.plug_diameter is {plug_mm} mm, and the bore of the tube {bore_mm} mm: a plug has between half of the bore and twice the bore"
    )]
    PlugDiameter {
        /// Diameter of the plug in mm.
        plug_mm: f64,
        /// Bore at rest in mm.
        bore_mm: f64,
    },
    /// A presliding length without a friction.
    #[error(
        "friction.presliding needs the friction itself: friction.lever, or friction.coefficient and friction.exponent"
    )]
    PreslidingAlone,
    /// A braid angle outside 0 < θ0 ≤ 75°.
    #[error(
        "braid.angle is {angle_deg} deg; the angle of the strands to the axis must be between 0 and 75 deg: a muscle contracts below 54.7356 deg and extends above"
    )]
    Angle {
        /// Angle in degrees.
        angle_deg: f64,
    },
    /// A muscle that extends, where only one that contracts will do.
    #[error(
        "braid.angle is {angle_deg} deg; this muscle extends, and the calculation is for muscles that contract: take an angle below 54.7356 deg"
    )]
    Extends {
        /// Angle in degrees.
        angle_deg: f64,
    },
    /// A muscle that contracts, where one that pushes is needed.
    #[error(
        "braid.angle is {angle_deg} deg; this muscle contracts, and a push is required: take an angle above 54.7356 deg"
    )]
    Contracts {
        /// Angle in degrees.
        angle_deg: f64,
    },
    /// Rubber constants that make no law.
    #[error("tube.material: {0}")]
    Rubber(#[from] LawError),
    /// Softening constants that make no rubber.
    #[error("tube.material.softening: {0}")]
    Softening(OverTimeError),
    /// A series that makes no rubber.
    #[error("tube.material.prony: {0}")]
    Relaxation(OverTimeError),
    /// A muscle that was cycled, of a rubber that does not soften.
    #[error(
        "tube.material.conditioned is stated, but the rubber has no tube.material.softening: give its r, m and beta, or leave it out"
    )]
    ConditionedWithoutSoftening,
    /// A strain that the rubber cannot have seen.
    #[error(
        "tube.material.conditioned is a strain of {strain}, at which the rubber's law has locked: state less, or the pressure of the cycles"
    )]
    ConditionedBeyondLock {
        /// The strain in simple tension.
        strain: f64,
    },
    /// A named sleeve that is not known, does not fit, or does not say enough.
    #[error("braid: {0}")]
    Sleeve(#[from] SleeveError),
    /// An angle beside a named sleeve that has another one on this tube.
    #[error(
        "braid.angle is {angle_deg} deg, but {name} has {of_sleeve_deg:.2} deg on a tube of {outer_diameter_mm} mm: leave one of them out"
    )]
    SleeveAngle {
        /// The sleeve.
        name: String,
        /// The angle that was given, in degrees.
        angle_deg: f64,
        /// The sleeve's, in degrees.
        of_sleeve_deg: f64,
        /// The tube's outer diameter in mm.
        outer_diameter_mm: f64,
    },
    /// A strand's cross-section both as an area and as a diameter.
    #[error("braid: give either `strand_area` or `strand_diameter`; both are given")]
    SectionTwice,
    /// A stiffness together with the three lines it replaces.
    #[error(
        "braid: give either `stiffness`, or `strands`, `strand_area` (or `strand_diameter`) and `strand_modulus`; both are given"
    )]
    StiffnessTwice,
    /// Some but not all of the three strand lines.
    #[error(
        "braid: {missing} is missing; a braid described by its strands needs `strands`, `strand_area` (or `strand_diameter`) and `strand_modulus`"
    )]
    StrandsIncomplete {
        /// The missing key.
        missing: &'static str,
    },
    /// Strand counts are even: half in each family.
    #[error("braid.strands is {count}; it must be an even whole number (half of them run each way)")]
    StrandCount {
        /// What was given.
        count: f64,
    },
    /// A strength without the number of strands that share the load.
    #[error("braid.strand_strength needs braid.strands: the load is shared among them")]
    StrengthWithoutCount,
    /// A strand length measured on the muscle that cannot span it.
    #[error(
        "braid.strand_length is {strand_length_mm} mm, not above the muscle's length of {length_mm} mm, which it must span slantwise"
    )]
    StrandTooShort {
        /// Strand length in mm.
        strand_length_mm: f64,
        /// Muscle length in mm.
        length_mm: f64,
    },
    /// Ends that hold all of the muscle.
    #[error(
        "terminals.grip is {grip_mm} mm at each end; twice that, with a seating of {seating_mm} mm, must be below the muscle's length of {length_mm} mm"
    )]
    GripTooLong {
        /// At each end, in mm.
        grip_mm: f64,
        /// Both ends together, in mm.
        seating_mm: f64,
        /// Muscle length in mm.
        length_mm: f64,
    },
    /// Ends that give way by as much as there is of the muscle.
    #[error("terminals.seating is {seating_mm} mm; it must be below the muscle's length of {length_mm} mm")]
    SeatingTooLong {
        /// Both ends together, in mm.
        seating_mm: f64,
        /// Muscle length in mm.
        length_mm: f64,
    },
    /// A braid as thick as the tube.
    #[error(
        "braid.thickness is {thickness_mm} mm; it must be below the tube's outer diameter of {outer_diameter_mm} mm (both layers of strands, not the sleeve's diameter)"
    )]
    BraidTooThick {
        /// Both layers, in mm.
        thickness_mm: f64,
        /// D0 in mm.
        outer_diameter_mm: f64,
    },
    /// A sleeve that the tube does not fit into.
    #[error(
        "braid.diameter is {diameter_mm} mm, but the tube has an outer diameter of {outer_diameter_mm} mm: a sleeve that is pulled over a wider tube has the angle that it takes there; give that angle and leave the diameter out"
    )]
    SleeveTooNarrow {
        /// Inner diameter of the sleeve in mm.
        diameter_mm: f64,
        /// D0 in mm.
        outer_diameter_mm: f64,
    },
    /// Strands that would grow softer as they straighten.
    #[error(
        "braid.crimp_stiffness is {stiffness_ratio}; it is the share of the strands' stiffness that they have before they are straight, above 0 and at most 1"
    )]
    CrimpStiffer {
        /// κ
        stiffness_ratio: f64,
    },
    /// Crimp in strands without a stiffness.
    #[error(
        "braid.crimp needs strands with a stiffness: it is a share of it that they have before they are straight"
    )]
    CrimpOfRigidStrands,
    /// A cone factor beyond what fits into the muscle.
    #[error(
        "terminals.cone_factor is {value}; it must lie between 0 and {largest:.4}, or the two tips touch before the largest contraction"
    )]
    ConeFactor {
        /// What was given.
        value: f64,
        /// (1 − ε_max)/(2 ε_max).
        largest: f64,
    },
}

impl MuscleError {
    /// The keys of the muscle file that can be at fault, the likeliest first.
    pub fn keys(&self) -> Vec<Cow<'static, str>> {
        let keys: Vec<&'static str> = match self {
            // A key may carry an explanation behind it: "terminals.end_factor at 0 MPa (a + b)".
            MuscleError::NotPositive { key, .. }
            | MuscleError::Negative { key, .. }
            | MuscleError::OutOfBounds { key, .. } => {
                let key = key.split(' ').next().unwrap_or(key);
                match key {
                    "terminals.end_factor" => vec![key, "model.tondu-lopez.end_factor"],
                    "terminals.cone_factor" => vec![key, "model.conical-ends.cone_factor"],
                    _ => vec![key],
                }
            }
            MuscleError::WallTooThick { .. } => vec!["tube.wall_thickness", "tube.outer_diameter"],
            MuscleError::PreslidingAlone => vec!["friction.presliding"],
            MuscleError::PlugDiameter { .. } => vec!["terminals.plug_diameter", "tube.outer_diameter"],
            MuscleError::Angle { .. } | MuscleError::Extends { .. } | MuscleError::Contracts { .. } => {
                vec!["braid.angle"]
            }
            MuscleError::Rubber(error) => {
                let constant = error.constant().map(|name| Cow::from(format!("tube.material.{name}")));
                return constant.into_iter().chain(["tube.material".into()]).collect();
            }
            MuscleError::Softening(_) => vec!["tube.material.softening"],
            MuscleError::Relaxation(_) => vec!["tube.material.prony"],
            MuscleError::ConditionedWithoutSoftening | MuscleError::ConditionedBeyondLock { .. } => {
                vec!["tube.material.conditioned"]
            }
            MuscleError::Sleeve(SleeveError::OutOfRange { .. } | SleeveError::NoContraction { .. }) => {
                vec!["braid.name", "tube.outer_diameter"]
            }
            MuscleError::Sleeve(_) => vec!["braid.name"],
            MuscleError::SleeveAngle { .. } => vec!["braid.angle"],
            MuscleError::SectionTwice => vec!["braid.strand_diameter"],
            MuscleError::StiffnessTwice => vec!["braid.stiffness"],
            MuscleError::StrandsIncomplete { .. } => {
                vec!["braid.strand_area", "braid.strand_modulus", "braid.strands"]
            }
            MuscleError::StrandCount { .. } => vec!["braid.strands"],
            MuscleError::StrengthWithoutCount => vec!["braid.strand_strength"],
            MuscleError::StrandTooShort { .. } => vec!["braid.strand_length"],
            MuscleError::GripTooLong { .. } => vec!["terminals.grip", "tube.length"],
            MuscleError::SeatingTooLong { .. } => vec!["terminals.seating", "tube.length"],
            MuscleError::BraidTooThick { .. } => vec!["braid.thickness", "tube.outer_diameter"],
            MuscleError::SleeveTooNarrow { .. } => vec!["braid.diameter", "tube.outer_diameter"],
            MuscleError::CrimpStiffer { .. } => vec!["braid.crimp_stiffness"],
            MuscleError::CrimpOfRigidStrands => vec!["braid.crimp", "braid.stiffness"],
            MuscleError::ConeFactor { .. } => vec!["terminals.cone_factor", "model.conical-ends.cone_factor"],
        };
        keys.into_iter().map(Cow::from).collect()
    }
}

fn with_unit(value: f64, unit: &str) -> String {
    format!("{value} {unit}").trim_end().to_string()
}

pub(super) fn positive(key: &'static str, value: f64, unit: &'static str) -> Result<(), MuscleError> {
    if value.is_finite() && value > 0.0 { Ok(()) } else { Err(MuscleError::NotPositive { key, value, unit }) }
}

pub(super) fn not_negative(key: &'static str, value: f64, unit: &'static str) -> Result<(), MuscleError> {
    if value.is_finite() && value >= 0.0 { Ok(()) } else { Err(MuscleError::Negative { key, value, unit }) }
}
