//! A muscle with values for the parameters: what is tried, and what comes out.

use super::parameter::Target;
use crate::measured::Section;
use crate::muscle::{BraidStiffness, Crimp, EndFactor, Friction, Muscle, MuscleError};

/// k = k₀ (D0/D0₀)ⁿ of one strand family.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Family {
    /// k₀ in N/mm.
    pub stiffness: f64,
    /// D0₀ in mm.
    pub reference_mm: f64,
    /// n
    pub exponent: f64,
}

/// β where nothing is known: between the 0.57 and 0.82 seen by Tondu (2012) \[tondu2012\].
const FRICTION_EXPONENT: f64 = 0.6;

/// A muscle that is tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    muscle: Muscle,
    family: Option<Family>,
    /// What is added to the contractions of the data.
    pub contraction_offset: f64,
}

/// The muscle's own value of a parameter; `None` where it has none.
pub fn own_value(muscle: &Muscle, target: Target) -> Option<f64> {
    let tube = muscle.tube();
    let friction = muscle.friction();
    Some(match target {
        Target::Law(i) => *tube.rubber.law.values().get(i)?,
        Target::Modulus => 1.0,
        Target::Stiffness => muscle.family_stiffness_n_per_mm()?,
        // Of k at twice the diameter: 0 for a stated k, −1 for a strand count, that of the braid `paper`.
        Target::StiffnessExponent => {
            let mut wide = tube.clone();
            wide.outer_diameter_mm *= 2.0;
            let twice = muscle.braid().family_stiffness_n_per_mm(&wide)?;
            (twice / muscle.family_stiffness_n_per_mm()?).log2()
        }
        Target::Angle => muscle.braid().angle_deg,
        Target::Thickness => Some(muscle.braid().thickness_mm).filter(|t| *t > 0.0)?,
        Target::SleeveDiameter => muscle.braid().diameter_mm?,
        Target::Crimp => muscle.braid().crimp?.strain,
        Target::OuterDiameter => tube.outer_diameter_mm,
        Target::Wall => tube.wall_mm,
        Target::Length => tube.length_mm,
        Target::Seating => muscle.terminals().seating_mm?,
        Target::Slip => muscle.terminals().slip_mm_per_n?,
        Target::Grip => muscle.terminals().grip_mm?,
        Target::EndFactor => muscle.terminals().end_factor.map_or(1.0, |k| k.at(0.0)),
        Target::FrictionCoefficient => friction?.coefficient,
        Target::FrictionLever => Some(friction?.lever_mm).filter(|l| *l > 0.0)?,
        Target::FrictionExponent => friction.map_or(FRICTION_EXPONENT, |f| f.exponent),
        Target::ContractionOffset => 0.0,
    })
}

impl Candidate {
    /// A muscle with values in place of its own.
    ///
    /// # Errors
    /// [`MuscleError`] where they make none.
    pub fn new(base: &Muscle, values: &[(Target, f64)]) -> Result<Self, MuscleError> {
        let (mut tube, mut braid) = (base.tube().clone(), base.braid().clone());
        let mut terminals = base.terminals().clone();
        let mut friction = base.friction().copied();
        let mut family = Family {
            stiffness: own_value(base, Target::Stiffness).unwrap_or(f64::INFINITY),
            reference_mm: base.outer_diameter_mm(),
            exponent: own_value(base, Target::StiffnessExponent).unwrap_or(0.0),
        };
        let (mut has_family, mut contraction_offset, mut factor) = (false, 0.0, 1.0);
        for &(target, v) in values {
            match target {
                Target::Law(i) => {
                    tube.rubber.law = tube.rubber.law.with_constants(|k, old| if k == i { v } else { old });
                }
                Target::Modulus => factor = v,
                Target::Stiffness => (family.stiffness, has_family) = (v, true),
                Target::StiffnessExponent => (family.exponent, has_family) = (v, true),
                Target::Angle => braid.angle_deg = v,
                Target::OuterDiameter => tube.outer_diameter_mm = v,
                Target::Thickness => braid.thickness_mm = v,
                Target::SleeveDiameter => braid.diameter_mm = Some(v),
                Target::Crimp => {
                    let stiffness_ratio = braid.crimp.map_or(Crimp::STIFFNESS_RATIO, |c| c.stiffness_ratio);
                    braid.crimp = Some(Crimp { strain: v, stiffness_ratio });
                }
                Target::Wall => tube.wall_mm = v,
                Target::Length => tube.length_mm = v,
                Target::Seating => terminals.seating_mm = Some(v),
                Target::Slip => terminals.slip_mm_per_n = Some(v),
                Target::Grip => terminals.grip_mm = Some(v),
                Target::EndFactor => terminals.end_factor = Some(EndFactor::Constant(v)),
                Target::FrictionCoefficient | Target::FrictionExponent | Target::FrictionLever => {
                    let mut f = friction.unwrap_or(Friction::power_law(0.0, FRICTION_EXPONENT));
                    match target {
                        Target::FrictionCoefficient => f.coefficient = v,
                        Target::FrictionLever => f.lever_mm = v,
                        _ => f.exponent = v,
                    }
                    friction = Some(f);
                }
                Target::ContractionOffset => contraction_offset = v,
            }
        }
        tube.rubber.law = tube.rubber.law.scaled(factor);
        if tube.rubber.law != base.tube().rubber.law {
            tube.rubber.fitted_to_stretch = None;
        }
        // Constants that are sought are those of every row of the data; the law of a named rubber would follow its measures.
        if values.iter().any(|v| matches!(v.0, Target::Law(_) | Target::Modulus)) {
            tube.rubber.name = None;
        }
        let family = has_family.then_some(family);
        if let Some(family) = &family {
            braid.stiffness = BraidStiffness::NewtonPerMm(family.at(tube.outer_diameter_mm));
        }
        Ok(Self { muscle: Muscle::new(tube, braid, terminals, friction)?, family, contraction_offset })
    }

    /// The muscle.
    pub fn muscle(&self) -> &Muscle {
        &self.muscle
    }

    /// The muscle of a row of data.
    ///
    /// # Errors
    /// [`MuscleError`].
    pub fn of_section(&self, section: &Section) -> Result<Muscle, MuscleError> {
        let muscle = section.apply(&self.muscle)?;
        let Some(family) = self.family else { return Ok(muscle) };
        let mut braid = muscle.braid().clone();
        braid.stiffness = BraidStiffness::NewtonPerMm(family.at(muscle.outer_diameter_mm()));
        muscle.with_braid(braid)
    }

    pub(super) fn family(&self) -> Option<Family> {
        self.family
    }
}

impl Family {
    /// k on a diameter.
    pub fn at(&self, outer_diameter_mm: f64) -> f64 {
        self.stiffness * self.ratio(outer_diameter_mm).powf(self.exponent)
    }

    /// D0/D0₀.
    pub fn ratio(&self, outer_diameter_mm: f64) -> f64 {
        outer_diameter_mm / self.reference_mm
    }
}
