//! A straight two-node truss in space with Green's strain.
//!
//!   Π = ½ E A L0 e²,   e = (l² − L0²)/(2 L0²),   l = |x1 − x0| now, L0 at rest
//!   ∂Π/∂x1 = (N/L0) d,   N = E A e,   d = x1 − x0,   ∂Π/∂x0 = −∂Π/∂x1
//!   ∂²Π/∂x1∂x1 = (N/L0) 1 + (E A/L0³) d⊗d
//!
//! Crisfield (1991), ch. 1 and 3. Tension-only trusses carry nothing where e < 0.

/// A truss at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Truss {
    /// L0 in mm.
    pub length_mm: f64,
    /// E·A in N.
    pub stiffness_n: f64,
    /// Whether it carries compression.
    pub compression: bool,
}

/// Force and tangent of a truss on its second node; the first node has the opposite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrussForce {
    /// Elastic energy in N·mm.
    pub energy: f64,
    /// ∂Π/∂x1 in N.
    pub force: [f64; 3],
    /// ∂²Π/∂x1∂x1 in N/mm; with respect to x0 it is the negative.
    pub tangent: [[f64; 3]; 3],
}

impl Truss {
    /// Energy, force and exact tangent for d = x1 − x0 in mm.
    pub fn force(&self, d: [f64; 3]) -> TrussForce {
        let l0 = self.length_mm;
        let strain = (d.iter().map(|x| x * x).sum::<f64>() - l0 * l0) / (2.0 * l0 * l0);
        if strain < 0.0 && !self.compression {
            return TrussForce { energy: 0.0, force: [0.0; 3], tangent: [[0.0; 3]; 3] };
        }
        let n = self.stiffness_n * strain;
        let material = self.stiffness_n / (l0 * l0 * l0);
        let tangent = |i: usize, j: usize| material * d[i] * d[j] + if i == j { n / l0 } else { 0.0 };
        TrussForce {
            energy: 0.5 * n * l0 * strain,
            force: d.map(|x| n / l0 * x),
            tangent: [0, 1, 2].map(|i| [0, 1, 2].map(|j| tangent(i, j))),
        }
    }
}
