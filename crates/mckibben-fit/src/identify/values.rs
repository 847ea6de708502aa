//! A muscle with values for some of its parameters.

use super::Target;
use mckibben_core::{
    muscle::{
        BraidStiffness, Muscle, MuscleError,
        measures::{END_FACTOR, FRICTION_COEFFICIENT, FRICTION_EXPONENT},
    },
    rubber::library,
};

impl Target {
    /// The value that a muscle has; `None` where it has none.
    pub fn value(self, muscle: &Muscle) -> Option<f64> {
        match self {
            Target::Law(i) => muscle.tube().rubber.law.values().get(i).copied(),
            Target::Modulus => Some(1.0),
            Target::ForceOffset => None,
            Target::Stiffness => muscle.family_stiffness_n_per_mm(),
            Target::Measure(m) if *m == END_FACTOR || *m == FRICTION_EXPONENT => muscle
                .measure(m)
                .or(self.identify().and_then(|i| i.start(muscle))),
            Target::Measure(m) => muscle.measure(m),
        }
    }
}

/// A muscle with other values of some parameters.
///
/// # Errors
/// Values that make no muscle.
pub fn with_values(base: &Muscle, values: &[(Target, f64)]) -> Result<Muscle, MuscleError> {
    let mut parts = base.parts().clone();
    let mut factor = 1.0;
    for &(target, v) in values {
        match target {
            Target::Law(i) => {
                let law = &mut parts.tube.rubber.law;
                *law = law.with_constants(|k, old| if k == i { v } else { old });
            }
            Target::Modulus => factor = v,
            Target::ForceOffset => {}
            Target::Stiffness => parts.braid.stiffness = BraidStiffness::NewtonPerMm(v),
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
    Muscle::from_parts(parts)
}
