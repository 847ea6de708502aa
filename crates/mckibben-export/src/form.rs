//! The exported muscle: one closed form of pull and volume.
//!
//! With q = P/P_supply and ε = 1 − L/L0,
//!
//! ```text
//! F = c0(ε) + c1(ε) q + c2(ε) φ(q)
//! ci = Σ_{j=0..5} a_ij ε^j + s² (b_i0 + b_i1 s),     s = max(−ε, 0)
//! ```
//!
//! φ = q². A polynomial of degree 5 in ε is one in x = 1 − ε; in ε it loses no digits in single precision. The strands of a muscle that is
//! stretched beyond its length at rest are taut, and the pull rises faster: s² and s³ are for that. Volume and pull have one potential,
//! ∂F/∂P = −∂V/∂L, so that a closed cycle in P and L does no net work:
//!
//! ```text
//! V = v0 + v1 q + v2 φ(q) + (L0/P_supply) (C1 + C2 φ'(q)),     Ci = ∫0^ε ci dε
//! ```
//!
//! Outside of the box each function of q and each function of ε continues along its tangent: φ = 2q − 1 above the supply, 0 below zero.
//! Value, slope and potential are continuous there. Where F would be negative the muscle is slack: F = 0, and V is that at its free
//! contraction.

use serde::Serialize;

/// Powers of ε: 0 to 5.
pub const POWERS: usize = 6;
/// The point lies inside of the box, and the muscle pulls.
pub const OK: u32 = 0;
/// The muscle would have to push, and is slack.
pub const SLACK: u32 = 1;
/// The pressure lies outside of the box.
pub const PRESSURE_OUTSIDE: u32 = 2;
/// The contraction lies outside of the box.
pub const CONTRACTION_OUTSIDE: u32 = 4;
/// No pressure gives this pull.
pub const NO_ANSWER: u32 = 8;

/// Pull and volume of a muscle in closed form. Units: Pa, m, N, m³.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "ExportForm"))]
pub struct Form {
    /// Length at rest L0, m.
    #[cfg_attr(feature = "schema", schemars(extend("x-unit" = "m")))]
    pub length_m: f64,
    /// Supply pressure, the upper end of the box, Pa.
    #[cfg_attr(feature = "schema", schemars(extend("x-unit" = "Pa")))]
    pub supply_pa: f64,
    /// Lower end of the box in ε, negative.
    pub contraction_low: f64,
    /// Upper end of the box in ε: the free contraction at the supply.
    pub contraction_high: f64,
    /// a_ij, N.
    #[cfg_attr(feature = "schema", schemars(extend("x-unit" = "N")))]
    pub a: [[f64; POWERS]; 3],
    /// b_i0 and b_i1, N.
    #[cfg_attr(feature = "schema", schemars(extend("x-unit" = "N")))]
    pub b: [[f64; 2]; 3],
    /// v0, v1 and v2, m³.
    #[cfg_attr(feature = "schema", schemars(extend("x-unit" = "m³")))]
    pub v: [f64; 3],
    /// Half-width of the hysteresis, N: h0 √q + h1 q; zeros where the muscle does not state its friction.
    pub friction_n: [f64; 2],
}

/// Everything at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Pull, N.
    pub force_n: f64,
    /// ∂F/∂L at fixed P, N/m.
    pub stiffness_n_per_m: f64,
    /// ∂F/∂P at fixed L, m².
    pub force_per_pressure_m2: f64,
    /// Volume, m³.
    pub volume_m3: f64,
    /// [`OK`], or a sum of the other constants.
    pub status: u32,
}

/// c, dc/dε and C at a contraction, for each power of the pressure.
struct Coefficients {
    c: [f64; 3],
    slope: [f64; 3],
    integral: [f64; 3],
}

/// φ and φ' at q.
fn square(q: f64) -> (f64, f64) {
    if q <= 0.0 {
        (0.0, 0.0)
    } else if q <= 1.0 {
        (q * q, 2.0 * q)
    } else {
        (2.0 * q - 1.0, 2.0)
    }
}

impl Form {
    /// ε of a length in m.
    pub fn contraction_of(&self, length_m: f64) -> f64 {
        1.0 - length_m / self.length_m
    }

    fn coefficients(&self, contraction: f64) -> Coefficients {
        let inside = contraction.max(self.contraction_low).min(self.contraction_high);
        let (beyond, s) = (contraction - inside, (-inside).max(0.0));
        let mut out = Coefficients { c: [0.0; 3], slope: [0.0; 3], integral: [0.0; 3] };
        for i in 0..3 {
            let (mut c, mut slope, mut integral) = (0.0, 0.0, 0.0);
            for j in (0..POWERS).rev() {
                slope = slope * inside + c;
                c = c * inside + self.a[i][j];
                integral = integral * inside + self.a[i][j] / (j + 1) as f64;
            }
            let [b0, b1] = self.b[i];
            c += s * s * (b0 + b1 * s);
            slope -= s * (2.0 * b0 + 3.0 * b1 * s);
            integral = integral * inside - s * s * s * (b0 / 3.0 + b1 * s / 4.0);
            out.integral[i] = integral + beyond * (c + 0.5 * slope * beyond);
            out.c[i] = c + slope * beyond;
            out.slope[i] = slope;
        }
        out
    }

    /// The pull that the form gives, negative where the muscle would have to push, and its slope in ε; pressure in Pa.
    pub fn two_sided_n(&self, pressure_pa: f64, contraction: f64) -> (f64, f64) {
        let q = pressure_pa / self.supply_pa;
        let (k, (square, _)) = (self.coefficients(contraction), square(q));
        let at = |c: &[f64; 3]| c[0] + c[1] * q + c[2] * square;
        (at(&k.c), at(&k.slope))
    }

    fn two_sided_volume_m3(&self, pressure_pa: f64, contraction: f64) -> f64 {
        let q = pressure_pa / self.supply_pa;
        let (k, (square, slope)) = (self.coefficients(contraction), square(q));
        let rest = self.v[0] + self.v[1] * q + self.v[2] * square;
        rest + self.length_m / self.supply_pa * (k.integral[1] + k.integral[2] * slope)
    }

    fn outside(&self, pressure_pa: f64, contraction: f64) -> u32 {
        let pressure = if (0.0..=self.supply_pa).contains(&pressure_pa) { OK } else { PRESSURE_OUTSIDE };
        let inside = (self.contraction_low..=self.contraction_high).contains(&contraction);
        pressure | if inside { OK } else { CONTRACTION_OUTSIDE }
    }

    /// Everything at a pressure in Pa and a contraction.
    pub fn at(&self, pressure_pa: f64, contraction: f64) -> Point {
        let (force_n, by_contraction) = self.two_sided_n(pressure_pa, contraction);
        let status = self.outside(pressure_pa, contraction);
        if force_n <= 0.0 {
            let free = self.contraction(0.0, pressure_pa);
            return Point {
                force_n: 0.0,
                stiffness_n_per_m: 0.0,
                force_per_pressure_m2: 0.0,
                volume_m3: self.two_sided_volume_m3(pressure_pa, free),
                status: status | SLACK,
            };
        }
        let q = pressure_pa / self.supply_pa;
        let k = self.coefficients(contraction);
        Point {
            force_n,
            stiffness_n_per_m: -by_contraction / self.length_m,
            force_per_pressure_m2: (k.c[1] + k.c[2] * square(q).1) / self.supply_pa,
            volume_m3: self.two_sided_volume_m3(pressure_pa, contraction),
            status,
        }
    }

    /// The pressure in Pa at which the pull is `force_n` at a contraction, and the status. Closed: a root of a quadratic equation.
    pub fn pressure(&self, force_n: f64, contraction: f64) -> (f64, u32) {
        let k = self.coefficients(contraction);
        let [c0, c1, c2] = k.c;
        let missing = force_n - c0;
        let status = self.outside(0.0, contraction);
        if missing <= 0.0 {
            // It pulls as much without pressure.
            return (0.0, status | if missing < 0.0 { NO_ANSWER } else { OK });
        }
        let root = c1 * c1 + 4.0 * c2 * missing;
        let below = if root > 0.0 { c1 + root.sqrt() } else { 0.0 };
        if below > 0.0 && 2.0 * missing <= below {
            return (2.0 * missing / below * self.supply_pa, status);
        }
        let slope = c1 + 2.0 * c2;
        if slope > 0.0 && missing + c2 >= slope {
            return ((missing + c2) / slope * self.supply_pa, status | PRESSURE_OUTSIDE);
        }
        (self.supply_pa, status | NO_ANSWER)
    }

    /// The contraction at which the pull is `force_n` at a pressure in Pa: Newton's method between bounds, the tangent outside of the box.
    pub fn contraction(&self, force_n: f64, pressure_pa: f64) -> f64 {
        let (mut low, mut high) = (self.contraction_low, self.contraction_high);
        for end in [low, high] {
            let (pull, slope) = self.two_sided_n(pressure_pa, end);
            let beyond = if end == low { force_n >= pull } else { force_n <= pull };
            if beyond {
                return if slope < 0.0 { end + (force_n - pull) / slope } else { end };
            }
        }
        let mut at = 0.5 * (low + high);
        for _ in 0..60 {
            let (pull, slope) = self.two_sided_n(pressure_pa, at);
            let miss = pull - force_n;
            if miss > 0.0 {
                low = at;
            } else {
                high = at;
            }
            let mut next = at - miss / slope;
            if !(next > low && next < high) {
                next = 0.5 * (low + high);
            }
            if (next - at).abs() <= 1e-14 {
                return next;
            }
            at = next;
        }
        at
    }

    /// Half the width of the hysteresis in N at a pressure in Pa: it adds while the muscle is lengthened and subtracts while it shortens.
    pub fn friction_half_width_n(&self, pressure_pa: f64) -> f64 {
        let q = (pressure_pa / self.supply_pa).max(0.0);
        self.friction_n[0] * q.sqrt() + self.friction_n[1] * q
    }
}

impl Form {
    /// What the potential of the pull adds to the volume of the muscle at rest length, m³.
    pub(crate) fn potential_volume_m3(&self, q: f64, contraction: f64) -> f64 {
        let k = self.coefficients(contraction);
        self.length_m / self.supply_pa * (k.integral[1] + k.integral[2] * square(q).1)
    }
}
