//! The ideal muscle: a cylinder with a massless, wall-less tube and strands that do not stretch.
//!
//!   (1)    F = (π D0² P / (4 sin²θ0)) · [3 (1−ε)² cos²θ0 − 1]
//!   (1.2)  F = (π D0² P / (4 sin²θ0)) · [3 cos²θ − 1],  cosθ = (1−ε) cosθ0
//!          F = −P dV/dL,  V = (B² − L²) L/(4π N²),  B = L0/cosθ0,  N = L0 tanθ0/(π D0)
//!   (4)    ε = 1 − √{ (1 + 4 sin²θ0 F/(π D0² P)) / (3 cos²θ0) }
//!
//! Sources: Gaylord (1958) \[gaylord1958\]; Schulte (1961) \[schulte1961\]; Chou & Hannaford (1996)
//! \[chou1996\]; Tondu & Lopez (2000) \[tondu2000\]. Equation numbers are those of the paper; its
//! (1.2) is printed without 1/sin²θ0.

use super::{ForceModel, ModelEntry, ModelError, ModelInfo, Response, Result, Workspace};
use crate::muscle::Muscle;
use std::f64::consts::PI;

pub const ENTRY: ModelEntry = ModelEntry {
    name: "ideal",
    description: "cylinder without wall, rubber and ends",
    source: "Chou & Hannaford 1996 [chou1996]; Antonelli et al. 2018 [antonelli2018], (1)",
};

/// The ideal formula (1). F in N for P in MPa and D0 in mm.
///
/// No rubber, no wall, no ends: pulls more than a real muscle, the more so the thicker the wall and
/// the lower the pressure. Free contraction 1 − 1/(√3 cosθ0) at any pressure.
#[derive(Debug, Clone)]
pub struct Ideal {
    info: ModelInfo,
    /// π D0²/(4 sin²θ0)
    area: f64,
    /// cos²θ0
    cos2: f64,
}

impl Ideal {
    /// The ideal model of a muscle.
    pub fn between_ends(muscle: &Muscle) -> Self {
        let (sin, cos) = muscle.braid().angle_rad().sin_cos();
        let d0 = muscle.outer_diameter_mm();
        Self {
            area: PI * d0 * d0 / (4.0 * sin * sin),
            cos2: cos * cos,
            info: ModelInfo::new(&ENTRY, muscle),
        }
    }

    /// Formula (1).
    pub fn pull(&self, pressure_mpa: f64, contraction: f64) -> f64 {
        let l = 1.0 - contraction;
        self.area * pressure_mpa * (3.0 * l * l * self.cos2 - 1.0)
    }

    /// Volume (B² − L²) L/(4π N²) of the cylinder in mm³.
    pub fn volume(&self, contraction: f64) -> f64 {
        let l = 1.0 - contraction;
        self.area * self.info.muscle.length_mm() * l * (1.0 - l * l * self.cos2)
    }
}

impl ForceModel for Ideal {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<Response> {
        let l = 1.0 - contraction;
        let cos = self.cos2.sqrt();
        let c = l * cos;
        if !(l > 0.0 && c < 1.0) {
            return Err(ModelError::Geometry {
                contraction,
                lowest: 1.0 - 1.0 / cos,
                highest: 1.0,
            });
        }
        let force_n = self.pull(pressure_mpa, contraction);
        let muscle = self.muscle();
        let by_pressure = self.pull(1.0, contraction);
        let d = muscle.pantograph_diameter_mm(contraction);
        // Axial balance of a cut: F + P π D²/4 = (sum of tensions) · cosθ.
        let tension = (force_n + pressure_mpa * 0.25 * PI * d * d) / c;
        Response {
            pressure_mpa,
            contraction,
            force_n,
            volume_mm3: Some(self.volume(contraction)),
            volume_per_pressure_mm3_per_mpa: Some(0.0),
            volume_per_contraction_mm3: Some(muscle.length_mm() * by_pressure),
            stiffness_n_per_mm: Some(
                6.0 * self.area * pressure_mpa * l * self.cos2 / muscle.length_mm(),
            ),
            force_per_pressure_mm2: Some(by_pressure),
            bulged_diameter_mm: Some(d),
            ..Response::default()
        }
        .with_braid_tension(tension, muscle)
        .finite(ENTRY.name)
    }

    /// Formula (4).
    fn contraction_at_pull(
        &self,
        _: &mut Workspace,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Option<f64> {
        let inside = (1.0 + force_n / (self.area * pressure_mpa)) / (3.0 * self.cos2);
        (pressure_mpa > 0.0 && inside > 0.0).then(|| 1.0 - inside.sqrt())
    }
}
