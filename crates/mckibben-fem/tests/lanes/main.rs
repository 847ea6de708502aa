//! The lanes of the processor, in a separate executable: their limit is that of a whole process.

#![allow(clippy::unwrap_used)]

mod kernel;
mod supernodal;

use mckibben_core::{
    model::{ForceModel, Workspace},
    muscle::{Muscle, Rubber},
    rubber::{Law, Yeoh},
};
use mckibben_fem::{
    axisymmetric::Axisymmetric,
    element::lanes::Width,
    three_dimensional::{BrickSpec, ThreeDimensional},
};
use std::sync::{Mutex, PoisonError};

/// The limit is that of the process: one test at a time changes it.
static ONE: Mutex<()> = Mutex::new(());

/// Work on lanes of each width that this processor has.
fn each_width(mut work: impl FnMut(Width)) {
    let _one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
    for width in [Width::One, Width::Four, Width::Eight]
        .into_iter()
        .filter(|w| *w <= Width::widest())
    {
        width.limit();
        work(width);
    }
    Width::Eight.limit();
}

/// The prototype, and a thin one of another law.
fn muscles() -> [Muscle; 2] {
    let yeoh = Rubber::new(Law::Yeoh(Yeoh {
        c10_mpa: 0.1,
        c20_mpa: -0.0007,
        c30_mpa: 2e-5,
    }));
    let prototype = Muscle::prototype();
    let tube = prototype.with_section(20.0, 1.0).unwrap().tube().clone();
    [
        prototype.clone(),
        prototype
            .with_tube(mckibben_core::muscle::Tube {
                rubber: yeoh,
                ..tube
            })
            .unwrap(),
    ]
}

fn answers(model: &dyn ForceModel) -> Vec<f64> {
    let w = &mut Workspace::new();
    let at = |(p, e)| {
        let r = model.response(w, p, e).unwrap();
        [
            Some(r.force_n),
            r.volume_mm3,
            r.stiffness_n_per_mm,
            r.bulged_diameter_mm,
            r.max_stretch,
        ]
    };
    [(0.1, 0.0), (0.25, 0.1)]
        .map(at)
        .into_iter()
        .flatten()
        .flatten()
        .collect()
}

/// Without fused products the axisymmetric elements give the same bits on any processor; the
/// bricks, whose products are fused in wide lanes, the same to rounding. Wider lanes than this
/// processor has are not tried.
#[test]
fn every_width_gives_the_same_answers() {
    let spec = BrickSpec::parse("1x4").unwrap();
    for muscle in muscles() {
        let mut narrow = None;
        each_width(|width| {
            assert_eq!(Width::here(), width);
            let plane = answers(&Axisymmetric::between_ends(&muscle).unwrap());
            let bricks = answers(&ThreeDimensional::between_ends_with(&muscle, &spec).unwrap());
            let (same, alike) = narrow.get_or_insert((plane.clone(), bricks.clone()));
            assert_eq!(*same, plane, "{width:?}");
            for (a, b) in bricks.iter().zip(alike) {
                assert!((a / *b - 1.0).abs() < 1e-12, "{width:?}: {a} {b}");
            }
        });
    }
}
