//! Rounded ends: quarter circles from the terminals to the bulge shorten the cylinder between them.
//!
//! Kothera & Wereley (2009) \[kothera2009\] put the effective length L − 2(r − r0) in place of L in
//! the force balance: each end rounds off with a quarter circle of radius r − r0 and so takes r −
//! r0 of the muscle's length. The pull is the same in every cross-section, so it is that of the
//! cylinder in the middle. What is measured is the whole length,
//!
//!   L = λ L0 = λm L0 + 2 (r(λm) − r0),   F = F_force-balance(λm)
//!
//! so the stretch λm of the middle has to be found from the measured one: it is smaller (the middle
//! has shortened and bulged more than the muscle as a whole), and the pull with it. The strand in
//! the ends is taken as if it belonged to the middle. Kothera et al. was not at hand in full; this
//! reading is derived from the sentence above.

use super::{
    ForceModel, ModelEntry, ModelError, ModelInfo, Result,
    force_balance::balance,
    pantograph::Pantograph,
    proportional::{PerPressure, proportional},
    root::rising_root,
};
use crate::muscle::Muscle;

pub const ENTRY: ModelEntry = ModelEntry {
    name: "rounded-ends",
    description: "force balance of the middle of a muscle with round ends",
    source: "effective length of Kothera & Wereley 2009 [kothera2009] in the force balance",
};

/// The force balance of the middle of a muscle whose ends are round; for short muscles.
///
/// It needs 1 + (2/L0) dr/dλ > 0: below L0 = D0 cot²θ0 the ends of a muscle at rest would take up
/// more than the middle gives, and the model refuses.
pub fn build(muscle: &Muscle) -> Result<Box<dyn ForceModel>> {
    let braid = Pantograph::from_muscle(muscle);
    let cot2 = (braid.cos / braid.sin).powi(2);
    let least_mm = 2.0 * braid.r0 * cot2;
    if braid.length <= least_mm {
        return Err(ModelError::TooShort {
            model: ENTRY.name,
            least_mm,
            length_mm: braid.length,
        });
    }
    // The λm at which the whole length no longer grows with that of the middle: dr/dλ = −r0 cotθ0
    // c/√(1−c²) with c = λ cosθ0 is −L0/2.
    let t = 0.5 * braid.length * braid.sin / (braid.r0 * braid.cos);
    let turn = t / (1.0 + t * t).sqrt() / braid.cos;
    let per_pressure = move |contraction| {
        let (lm, slope) = middle(&braid, turn, contraction)?;
        let middle = balance(&braid, 1.0 - lm)?;
        Ok(PerPressure {
            f_l: middle.f_l * slope,
            volume_mm3: None,
            ..middle
        })
    };
    proportional(ModelInfo::new(&ENTRY, muscle), per_pressure)
}

/// λm and dλm/dλ at a contraction of the whole muscle.
fn middle(b: &Pantograph, turn: f64, contraction: f64) -> Result<(f64, f64)> {
    let l = 1.0 - contraction;
    let length = |lm: f64| match b.shape_at(1.0 - lm) {
        Ok(g) => (
            lm + 2.0 * (g.r - b.r0) / b.length - l,
            1.0 + 2.0 * g.r1 / b.length,
        ),
        Err(_) => (f64::NAN, f64::NAN),
    };
    // At λm → 0 the ends meet.
    let highest = 1.0 - 2.0 * b.r0 * (1.0 / b.sin - 1.0) / b.length;
    let error = ModelError::Geometry {
        contraction,
        lowest: 1.0 - (length(turn).0 + l),
        highest,
    };
    if !(contraction < highest && length(turn).0 > 0.0) {
        return Err(error);
    }
    let lm = rising_root(1e-12, turn, l.min(turn), 0.0, length).ok_or(error)?;
    Ok((lm, 1.0 / length(lm).1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        model::{ModelKind, Workspace},
        muscle::Tube,
    };

    fn long(length_mm: f64) -> Muscle {
        Muscle::prototype()
            .with_tube(Tube {
                length_mm,
                ..Tube::prototype()
            })
            .unwrap()
    }

    #[test]
    fn at_rest_and_for_long_muscles_it_is_the_force_balance() {
        let m = Muscle::prototype();
        let (a, b) = (
            build(&m).unwrap(),
            ModelKind::ForceBalance.build(&m).unwrap(),
        );
        assert!(
            (a.force_n(&mut Workspace::new(), 0.2, 0.0).unwrap()
                - b.force_n(&mut Workspace::new(), 0.2, 0.0).unwrap())
            .abs()
                < 1e-9
        );
        let errors = [1e4, 1e5].map(|length| {
            let m = long(length);
            let exact = ModelKind::ForceBalance.build(&m).unwrap();
            let exact = exact.force_n(&mut Workspace::new(), 0.2, 0.15).unwrap();
            build(&m)
                .unwrap()
                .force_n(&mut Workspace::new(), 0.2, 0.15)
                .unwrap()
                - exact
        });
        assert!(
            errors[0] < 0.0 && (errors[0] / errors[1] - 10.0).abs() < 0.1,
            "{errors:?}"
        );
    }

    #[test]
    fn the_length_adds_up() {
        let (m, b) = (
            Muscle::prototype(),
            Pantograph::from_muscle(&Muscle::prototype()),
        );
        let model = build(&m).unwrap();
        for e in [0.0, 0.1, 0.25] {
            let r = 0.5
                * model
                    .response(&mut Workspace::new(), 0.2, e)
                    .unwrap()
                    .bulged_diameter_mm
                    .unwrap();
            let lm = (1.0 - (b.sin * r / b.r0).powi(2)).sqrt() / b.cos;
            assert!(
                (lm * 285.0 + 2.0 * (r - 15.0) - (1.0 - e) * 285.0).abs() < 1e-9,
                "ε {e}"
            );
        }
    }

    #[test]
    fn muscles_too_short_and_vanished_middles_are_refused() {
        let least = 30.0 / 28f64.to_radians().tan().powi(2);
        assert!(matches!(
            build(&long(0.99 * least)),
            Err(ModelError::TooShort { .. })
        ));
        let model = build(&long(1.01 * least)).unwrap();
        assert!(model.force_n(&mut Workspace::new(), 0.2, 0.0).is_ok());
        assert!(matches!(
            model.force_n(&mut Workspace::new(), 0.2, 0.8),
            Err(ModelError::Geometry { .. })
        ));
    }
}
