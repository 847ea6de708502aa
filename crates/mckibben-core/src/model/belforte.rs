//! Belforte's formula: the ideal muscle with strand length and turns measured on the real one.
//!
//!   (3)   F = P (3L² − b²)/(4π n²),   V = (b² − L²) L/(4π n²),   D = √(b² − L²)/(π n),   L = (1 − ε) L0
//!
//! b: length of one strand, n: its turns. Source: the paper's (3) after Belforte et al. The printed
//! form has lost its squares (its dimension is force/length) and holds for one turn; this is F = −P
//! dV/dL.

use super::{
    ForceModel, ModelEntry, ModelError, ModelInfo, Result,
    proportional::{PerPressure, proportional},
};
use crate::muscle::Muscle;
use std::f64::consts::PI;

pub const ENTRY: ModelEntry = ModelEntry {
    name: "belforte",
    description: "ideal muscle with strand length and turns as measured",
    source: "Belforte et al., as given by Antonelli et al. 2018 [antonelli2018], (3), with its \
        squares restored",
};

/// Belforte's formula (3), F in N for P in MPa, of a muscle whose strands have been measured.
///
/// b is measured on the muscle and so includes the rounded ends; with b = L0/cosθ0 and n = L0
/// tanθ0/(π D0) it is the ideal formula.
///
/// # Errors
/// [`ModelError::Missing`] without a measured strand. One too short to span the muscle is refused
/// with the muscle.
pub fn build(muscle: &Muscle) -> Result<Box<dyn ForceModel>> {
    let measured = muscle.braid().measured.ok_or(ModelError::Missing {
        model: ENTRY.name,
        missing: "a strand measured on the muscle: `braid.strand_length` and `braid.turns` in the \
            muscle file",
        key: "braid.strand_length",
    })?;
    let b = measured.strand_length_mm;
    let n2 = 4.0 * PI * measured.turns * measured.turns;
    let length = muscle.length_mm();
    let per_pressure = move |contraction: f64| {
        let l = (1.0 - contraction) * length;
        if !(l > 0.0 && l < b) {
            return Err(ModelError::Geometry {
                contraction,
                lowest: 1.0 - b / length,
                highest: 1.0,
            });
        }
        let f = (3.0 * l * l - b * b) / n2;
        // π D²/4 = (b² − L²)/(4π n²); axial balance of a cut: F + P π D²/4 = (sum of tensions) ·
        // L/b.
        let area = (b * b - l * l) / n2;
        Ok(PerPressure {
            f,
            f_l: 6.0 * l * length / n2,
            volume_mm3: area * l,
            diameter_mm: 2.0 * (area / PI).sqrt(),
            tension: Some((f + area) * b / l),
        })
    };
    proportional(ModelInfo::new(&ENTRY, muscle), per_pressure)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        model::{Ideal, Workspace},
        muscle::{Braid, MeasuredStrand},
    };

    fn with_strand(strand_length_mm: f64, turns: f64) -> Muscle {
        let measured = Some(MeasuredStrand {
            strand_length_mm,
            turns,
        });
        Muscle::prototype()
            .with_braid(Braid {
                measured,
                ..Braid::paper()
            })
            .unwrap()
    }

    #[test]
    fn with_the_ideal_strand_it_is_the_ideal_formula() {
        let m = Muscle::prototype();
        let measured = with_strand(m.strand_length_mm(), m.turns());
        let (ideal, belforte) = (Ideal::between_ends(&m), build(&measured).unwrap());
        for e in [-0.05, 0.0, 0.1, 0.3] {
            let (a, b) = (
                ideal.response(&mut Workspace::new(), 0.2, e).unwrap(),
                belforte.response(&mut Workspace::new(), 0.2, e).unwrap(),
            );
            for (a, b) in [
                (a.force_n, b.force_n),
                (a.volume_mm3.unwrap(), b.volume_mm3.unwrap()),
                (a.stiffness_n_per_mm.unwrap(), b.stiffness_n_per_mm.unwrap()),
                (a.bulged_diameter_mm.unwrap(), b.bulged_diameter_mm.unwrap()),
                (a.braid_tension_n.unwrap(), b.braid_tension_n.unwrap()),
            ] {
                assert!((a - b).abs() < 1e-11 * a.abs(), "ε {e}: {a} {b}");
            }
        }
    }

    #[test]
    fn what_was_not_measured_is_required_and_short_strands_are_refused() {
        assert!(matches!(
            build(&Muscle::prototype()),
            Err(ModelError::Missing { .. })
        ));
        let measured = Some(MeasuredStrand {
            strand_length_mm: 284.0,
            turns: 1.6,
        });
        let refused = Muscle::prototype().with_braid(Braid {
            measured,
            ..Braid::paper()
        });
        let refused = refused.unwrap_err();
        assert!(refused.to_string().contains("284"), "{refused}");
        let model = build(&with_strand(330.0, 1.6)).unwrap();
        assert!(matches!(
            model.response(&mut Workspace::new(), 0.1, -0.2),
            Err(ModelError::Geometry { .. })
        ));
        assert!(matches!(
            model.response(&mut Workspace::new(), 0.1, f64::NAN),
            Err(ModelError::Geometry { .. })
        ));
    }
}
