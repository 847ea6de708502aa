//! A muscle with values for the parameters, tried or identified.

use super::Target;
use crate::measured::Section;
use mckibben_core::{
    muscle::{
        BraidStiffness, Muscle, MuscleError,
        measures::{END_FACTOR, FRICTION_COEFFICIENT, FRICTION_EXPONENT},
    },
    rubber::library,
};

/// k = k₀ (D0/D0₀)ⁿ of one strand family.
#[derive(Debug, Clone, Copy)]
pub struct Family {
    /// k₀ in N/mm.
    pub stiffness: f64,
    /// D0₀ in mm.
    pub reference_mm: f64,
    /// n
    pub exponent: f64,
}

/// A muscle that is tried.
#[derive(Debug, Clone)]
pub struct TrialMuscle {
    pub muscle: Muscle,
    pub(super) family: Option<Family>,
    /// Offset that is added to the contractions of the data.
    pub contraction_offset: f64,
    /// Volume of hose and fittings in the measured volumes, in mm³.
    pub dead_volume_mm3: f64,
    /// What the load cell shows of no pull, in N.
    pub force_offset_n: f64,
}

impl Target {
    /// The value that a muscle has; `None` where it has none.
    pub fn value(self, muscle: &Muscle) -> Option<f64> {
        let tube = muscle.tube();
        Some(match self {
            Target::Law(i) => *tube.rubber.law.values().get(i)?,
            Target::Modulus => 1.0,
            Target::Stiffness => muscle.family_stiffness_n_per_mm()?,
            // Of k at twice the diameter: 0 for a stated k, −1 for a strand count, that of the
            // braid `paper`.
            Target::StiffnessExponent => {
                let mut wide = tube.clone();
                wide.outer_diameter_mm *= 2.0;
                let twice = muscle.braid().family_stiffness_n_per_mm(&wide)?;
                (twice / muscle.family_stiffness_n_per_mm()?).log2()
            }
            Target::Measure(m) if *m == END_FACTOR || *m == FRICTION_EXPONENT => muscle
                .measure(m)
                .or(self.identify().and_then(|i| i.start(muscle)))?,
            Target::Measure(m) => muscle.measure(m)?,
            Target::ContractionOffset | Target::DeadVolume | Target::ForceOffset => 0.0,
        })
    }
}

impl TrialMuscle {
    /// A muscle with values for some of its parameters.
    pub fn new(base: &Muscle, values: &[(Target, f64)]) -> Result<Self, MuscleError> {
        let mut parts = base.parts().clone();
        let mut family = Family {
            stiffness: Target::Stiffness.value(base).unwrap_or(f64::INFINITY),
            reference_mm: base.outer_diameter_mm(),
            exponent: Target::StiffnessExponent.value(base).unwrap_or(0.0),
        };
        let (mut has_family, mut factor) = (false, 1.0);
        let (mut contraction_offset, mut dead_volume_mm3, mut force_offset_n) = (0.0, 0.0, 0.0);
        for &(target, v) in values {
            match target {
                Target::Law(i) => {
                    let law = &mut parts.tube.rubber.law;
                    *law = law.with_constants(|k, old| if k == i { v } else { old });
                }
                Target::Modulus => factor = v,
                Target::Stiffness => (family.stiffness, has_family) = (v, true),
                Target::StiffnessExponent => (family.exponent, has_family) = (v, true),
                Target::Measure(m) => {
                    // C alone has the exponent that a search for it starts from.
                    if *m == FRICTION_COEFFICIENT && base.measure(&FRICTION_EXPONENT).is_none() {
                        Target::Measure(&FRICTION_EXPONENT)
                            .value(base)
                            .into_iter()
                            .for_each(|v| (FRICTION_EXPONENT.set)(&mut parts, v));
                    }
                    (m.set)(&mut parts, v);
                }
                Target::ContractionOffset => contraction_offset = v,
                Target::DeadVolume => dead_volume_mm3 = v,
                Target::ForceOffset => force_offset_n = v,
            }
        }
        let rubber = &mut parts.tube.rubber;
        rubber.law = rubber.law.scaled(factor);
        if rubber.law != base.tube().rubber.law {
            rubber.fitted_to_stretch = None;
        }
        // Constants that are sought are those of every row of the data; the law of a named rubber
        // would follow its measures.
        if values.iter().any(|v| v.0.is_of_law()) {
            *rubber = library::without_name(rubber.clone());
        }
        let family = has_family.then_some(family);
        if let Some(family) = &family {
            parts.braid.stiffness =
                BraidStiffness::NewtonPerMm(family.stiffness_at(parts.tube.outer_diameter_mm));
        }
        Ok(Self {
            muscle: Muscle::from_parts(parts)?,
            family,
            contraction_offset,
            dead_volume_mm3,
            force_offset_n,
        })
    }

    /// The muscle of a row of data.
    pub fn section_muscle(&self, section: &Section) -> Result<Muscle, MuscleError> {
        let muscle = section.apply(&self.muscle)?;
        let Some(family) = self.family else {
            return Ok(muscle);
        };
        let mut braid = muscle.braid().clone();
        braid.stiffness =
            BraidStiffness::NewtonPerMm(family.stiffness_at(muscle.outer_diameter_mm()));
        muscle.with_braid(braid)
    }
}

impl Family {
    /// k on a diameter.
    pub fn stiffness_at(&self, outer_diameter_mm: f64) -> f64 {
        self.stiffness * self.ratio(outer_diameter_mm).powf(self.exponent)
    }

    /// D0/D0₀.
    pub fn ratio(&self, outer_diameter_mm: f64) -> f64 {
        outer_diameter_mm / self.reference_mm
    }
}
