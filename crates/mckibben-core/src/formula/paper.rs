//! The terms of the paper's formula (11), and the numbers that its authors published.
//!
//!   (11)  F = a ε² + b ε + c,   a = m_a P + q_a,   m_a = A1 s² + A2 s + A3,   q_a = A4 s² + A5 s + A6
//!         A_k = A_k1 D0² + A_k2 D0 + A_k3;  b likewise with B, c with C, where C_k is a straight line in D0
//!
//! F in N, P in MPa, s and D0 in mm.

/// The numbers X_k1, X_k2, X_k3 of (11) for X = A, B, C and k = 1…6.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// A, of ε².
    pub a: [[f64; 3]; 6],
    /// B, of ε.
    pub b: [[f64; 3]; 6],
    /// C; its D0² column is zero in the paper.
    pub c: [[f64; 3]; 6],
}

/// Table 2 of the paper, columns D0², D0, 1.
static TABLE_2: Coefficients = Coefficients {
    a: [
        [-12.079, 1122.2, -26214.0],
        [43.917, -4364.9, 100482.0],
        [14.061, 1969.0, -64578.0],
        [2.5976, -247.07, 5929.1],
        [-9.1771, 935.22, -21081.0],
        [3.888, -495.47, 13380.0],
    ],
    b: [
        [0.882, -89.553, 2331.4],
        [-1.9985, 309.05, -7824.9],
        [-23.591, -1.3836, 4592.1],
        [-0.1886, 19.928, -534.44],
        [0.414, -66.297, 1433.3],
        [0.6582, -22.524, -89.23],
    ],
    c: [
        [0.0, -0.0366, -7.9276],
        [0.0, -4.9662, 78.727],
        [0.0, 345.94, -6378.4],
        [0.0, 0.0477, -2.2277],
        [0.0, -0.2709, 8.9142],
        [0.0, 0.3005, -10.664],
    ],
};

/// (11) for one diameter and wall: a = m P + q and likewise b and c.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Slope and intercept of a in P (mm², N).
    pub a: (f64, f64),
    /// Slope and intercept of b in P.
    pub b: (f64, f64),
    /// Slope and intercept of c in P.
    pub c: (f64, f64),
}

impl Coefficients {
    /// The published numbers.
    pub fn published() -> &'static Self {
        &TABLE_2
    }

    /// Puts in diameter and wall, in mm.
    pub fn section(&self, outer_diameter_mm: f64, wall_mm: f64) -> Section {
        let d = outer_diameter_mm;
        let s = wall_mm;
        let line = |x: &[[f64; 3]; 6]| {
            let [x1, x2, x3, x4, x5, x6] = x.map(|[d2, d1, d0]| (d2 * d + d1) * d + d0);
            ((x1 * s + x2) * s + x3, (x4 * s + x5) * s + x6)
        };
        Section {
            a: line(&self.a),
            b: line(&self.b),
            c: line(&self.c),
        }
    }
}

impl Section {
    /// a, b, c of F = a ε² + b ε + c at a pressure in MPa.
    pub fn quadratic_at(&self, pressure_mpa: f64) -> (f64, f64, f64) {
        let line = |(m, q): (f64, f64)| m * pressure_mpa + q;
        (line(self.a), line(self.b), line(self.c))
    }

    /// F in N.
    pub fn force_n(&self, pressure_mpa: f64, contraction: f64) -> f64 {
        let (a, b, c) = self.quadratic_at(pressure_mpa);
        (a * contraction + b) * contraction + c
    }

    /// ∂F/∂ε in N.
    pub fn by_contraction(&self, pressure_mpa: f64, contraction: f64) -> f64 {
        let (a, b, _) = self.quadratic_at(pressure_mpa);
        2.0 * a * contraction + b
    }

    /// ∂F/∂P in mm².
    pub fn by_pressure(&self, contraction: f64) -> f64 {
        (self.a.0 * contraction + self.b.0) * contraction + self.c.0
    }
}
