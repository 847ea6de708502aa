//! Where a law stays stable in the two-axis stretch of a muscle wall.

use super::RubberLaw;
use crate::extremes::even;

/// Axial stretches between which a muscle wall lies: contracted by up to 40 %, or drawn out by up
/// to 10 %.
pub const MUSCLE_AXIAL_STRETCH: (f64, f64) = (0.6, 1.1);
/// Hoop stretch that the bore of a thick muscle reaches.
pub const MUSCLE_HOOP_STRETCH: f64 = 3.0;

/// Walks the hoop stretch from 1 to `largest_hoop_stretch` at the axial stretches of a contracting
/// muscle (λz = 1 and 0.75) and asks whether ŵ(λθ, λz) stays convex in the logarithms of the
/// stretches (Hill's inequality; Drucker stability of incompressible rubber). The hoop stretch λθ
/// at which the tangent first loses its positive definiteness, where it does.
pub fn biaxial_unstable_from<L: RubberLaw + ?Sized>(
    law: &L,
    largest_hoop_stretch: f64,
) -> Option<f64> {
    const STEPS: u32 = 200;
    even((1.0, largest_hoop_stretch), STEPS).find(|&hoop| {
        [1.0, 0.75]
            .iter()
            .any(|&axial| !is_stable_at(law, hoop, axial))
    })
}

/// ∂²ŵ/∂x², ∂²ŵ/∂x∂y, ∂²ŵ/∂y² with x = ln λ1, y = ln λ2 of incompressible rubber, in MPa.
pub fn log_hessian<L: RubberLaw + ?Sized>(law: &L, stretch_1: f64, stretch_2: f64) -> [f64; 3] {
    let u = stretch_1 * stretch_1;
    let v = stretch_2 * stretch_2;
    let b = law.biaxial(u, v);
    // ∂x = 2u ∂u, ∂y = 2v ∂v.
    let xx = 4.0 * u * (u * b.uu + b.u);
    let yy = 4.0 * v * (v * b.vv + b.v);
    [xx, 4.0 * u * v * b.uv, yy]
}

/// Hill's inequality in one state: the Hessian in the logarithms of the stretches is positive
/// definite.
pub fn is_stable_at<L: RubberLaw + ?Sized>(law: &L, stretch_1: f64, stretch_2: f64) -> bool {
    let [xx, xy, yy] = log_hessian(law, stretch_1, stretch_2);
    xx > 0.0 && yy > 0.0 && xx * yy > xy * xy
}

/// The states of a muscle wall in which a law is tested: axial stretches 0.6 to 1.1, hoop stretches
/// from 1 upward.
pub fn muscle_states(largest_hoop_stretch: f64) -> impl Iterator<Item = (f64, f64)> {
    const HOOPS: u32 = 80;
    const AXIALS: u32 = 10;
    even((1.0, largest_hoop_stretch), HOOPS)
        .flat_map(|hoop| even(MUSCLE_AXIAL_STRETCH, AXIALS).map(move |axial| (hoop, axial)))
}

/// [`biaxial_unstable_from`] over the whole field of a muscle's stretches instead of along two
/// paths.
pub fn muscle_unstable_from<L: RubberLaw + ?Sized>(
    law: &L,
    largest_hoop_stretch: f64,
) -> Option<f64> {
    let mut states = muscle_states(largest_hoop_stretch);
    states
        .find(|&(hoop, axial)| !is_stable_at(law, hoop, axial))
        .map(|(hoop, _)| hoop)
}
