//! Deformation and stress of an axisymmetric state, and what a law must tell of them.

/// Deformation gradient of an axisymmetric state.
#[derive(Debug, Clone, Copy, Default)]
pub struct Gradient {
    /// F_rR
    pub a: f64,
    /// F_rZ
    pub b: f64,
    /// F_zR
    pub c: f64,
    /// F_zZ
    pub d: f64,
    /// F_θθ = r/R
    pub t: f64,
}

impl Gradient {
    /// Area ratio D in the section.
    pub fn section(&self) -> f64 {
        self.a * self.d - self.b * self.c
    }

    /// Volume ratio J.
    pub fn volume(&self) -> f64 {
        self.section() * self.t
    }

    /// Principal stretches: the larger and the smaller one in the section, and the hoop stretch.
    pub fn principal(&self) -> [f64; 3] {
        let Self { a, b, c, d, t } = *self;
        let sum = (a + d).hypot(c - b);
        let difference = (a - d).hypot(b + c);
        [0.5 * (sum + difference), 0.5 * (sum - difference), t]
    }
}

/// First Piola–Kirchhoff stress and its tangent, in MPa; r stands for (a, b, t), z for (c, d).
#[derive(Debug, Clone, Copy, Default)]
pub struct Stress {
    /// Energy per reference volume (without the multiplier's part, which vanishes at J = 1).
    pub w: f64,
    /// ∂φ/∂(a, b, t)
    pub r: [f64; 3],
    /// ∂φ/∂(c, d)
    pub z: [f64; 2],
    /// Tangent (a, b, t) × (a, b, t), symmetric.
    pub rr: [[f64; 3]; 3],
    /// Tangent (a, b, t) × (c, d).
    pub rz: [[f64; 2]; 3],
    /// Tangent (c, d) × (c, d), symmetric.
    pub zz: [[f64; 2]; 2],
}

/// A rubber law in an axisymmetric state.
pub trait PlaneLaw {
    /// Stress at F, and the tangent where `TANGENT`; `p` multiplies J − 1.
    fn stress<const TANGENT: bool>(&self, f: &Gradient, p: f64) -> Stress;
}

/// A [`PlaneLaw`] whose type is not known when what is around it is compiled: elements, sections
/// and sums are the same code for all.
pub trait AnyPlaneLaw {
    /// [`PlaneLaw::stress`] at every F of `f` with its multiplier in `p`; tangents where `tangent`.
    fn stresses(&self, tangent: bool, f: &[Gradient], p: &[f64], out: &mut [Stress]);

    /// Stress and energy at one F.
    fn stress_at(&self, f: &Gradient, p: f64) -> Stress;
}

impl<L: PlaneLaw> AnyPlaneLaw for L {
    fn stresses(&self, tangent: bool, f: &[Gradient], p: &[f64], out: &mut [Stress]) {
        for ((out, f), p) in out.iter_mut().zip(f).zip(p) {
            *out = if tangent {
                self.stress::<true>(f, *p)
            } else {
                self.stress::<false>(f, *p)
            };
        }
    }

    fn stress_at(&self, f: &Gradient, p: f64) -> Stress {
        self.stress::<false>(f, p)
    }
}
