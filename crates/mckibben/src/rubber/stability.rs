//! Where a law stays stable in the two-axis stretch of a muscle wall.

use super::RubberLaw;

/// How far a law is stable along the path a muscle wall takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stability {
    /// Stable up to the hoop stretch that was asked for.
    Stable,
    /// Unstable from this hoop stretch on.
    UnstableFrom {
        /// Hoop stretch λθ at which the tangent first loses its positive definiteness.
        hoop_stretch: f64,
    },
}

/// Walks the hoop stretch from 1 to `largest_hoop_stretch` at the axial stretches of a contracting muscle
/// (λz = 1 and 0.75) and asks whether ŵ(λθ, λz) stays convex in the logarithms of the stretches (Hill's inequality;
/// Drucker stability of incompressible rubber).
pub fn biaxial_stability<L: RubberLaw + ?Sized>(law: &L, largest_hoop_stretch: f64) -> Stability {
    const STEPS: usize = 200;
    for i in 0..=STEPS {
        let hoop = 1.0 + (largest_hoop_stretch - 1.0) * i as f64 / STEPS as f64;
        for axial in [1.0_f64, 0.75] {
            let (u, v) = (hoop * hoop, axial * axial);
            let b = law.biaxial(u, v);
            // With x = ln λθ, y = ln λz: ∂x = 2u ∂u, ∂y = 2v ∂v.
            let xx = 4.0 * u * (u * b.uu + b.u);
            let yy = 4.0 * v * (v * b.vv + b.v);
            let xy = 4.0 * u * v * b.uv;
            let stable = xx > 0.0 && yy > 0.0 && xx * yy > xy * xy;
            if !stable {
                return Stability::UnstableFrom { hoop_stretch: hoop };
            }
        }
    }
    Stability::Stable
}
