//! The outer surface under strands that do not stretch: shared by the models whose braid is a
//! pantograph.
//!
//!   cosθ = λ cosθ0,   r = r0 √(1 − λ² cos²θ0)/sinθ0,   r r' = −q λ,   r'² + r r'' = −q,   q = r0² cot²θ0
//!
//! with λ = 1 − ε and ' = d/dλ (the paper's (2)).

use super::{ModelError, Result};
use crate::muscle::Muscle;

/// The muscle's measures that the pantograph needs.
#[derive(Debug, Clone)]
pub struct Pantograph {
    /// Outer radius at rest
    pub r0: f64,
    /// Length at rest
    pub length: f64,
    /// Ro² − Ri² at rest
    pub section: f64,
    pub cos: f64,
    pub sin: f64,
}

/// One state of it.
pub struct Shape {
    pub l: f64,
    /// cosθ now
    pub cos: f64,
    pub r: f64,
    /// dr/dλ
    pub r1: f64,
    /// d²r/dλ²
    pub r2: f64,
}

impl Pantograph {
    pub fn from_muscle(muscle: &Muscle) -> Self {
        let (sin, cos) = muscle.braid().angle_rad().sin_cos();
        let ro = muscle.tube().outer_radius_mm();
        let ri = muscle.tube().inner_radius_mm();
        Self {
            r0: ro,
            length: muscle.length_mm(),
            section: ro * ro - ri * ri,
            cos,
            sin,
        }
    }

    /// The error of a contraction without a shape.
    pub fn no_shape(&self, contraction: f64) -> ModelError {
        ModelError::Geometry {
            contraction,
            lowest: 1.0 - 1.0 / self.cos,
            highest: 1.0,
        }
    }

    /// Shape at a contraction.
    pub fn shape_at(&self, contraction: f64) -> Result<Shape> {
        let l = 1.0 - contraction;
        let cos = l * self.cos;
        if !(l > 0.0 && cos < 1.0) {
            return Err(self.no_shape(contraction));
        }
        let r = self.r0 * (1.0 - cos * cos).sqrt() / self.sin;
        let q = (self.r0 * self.cos / self.sin).powi(2);
        let r1 = -q * l / r;
        Ok(Shape {
            l,
            cos,
            r,
            r1,
            r2: -(q + r1 * r1) / r,
        })
    }
}
