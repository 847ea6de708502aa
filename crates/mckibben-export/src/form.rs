//! The exported muscle: one closed form of pull and volume.
//!
//! With q = P/P_supply and ε = 1 − L/L0,
//!
//! ```text
//! F = c0(ε) + c1(ε) q + c2(ε) φ0(q) + c3(ε) φ1(q) + c4(ε) φ2(q),     φk = max(q − κk, 0)²,  κ = 0, 0.15, 0.45
//! ```
//!
//! Each c is a cubic spline in ε, given by its values a and its slopes b at a few nodes. Strands
//! that are taut without pressure make the pull a convex function of the length beyond that at
//! rest, and of the pressure: the nodes lie closer there. Volume and pull have one potential, ∂F/∂P
//! = −∂V/∂L, so that a closed cycle in P and L does no net work:
//!
//! ```text
//! V = v0 + v1 q + v2 φ0 + v3 φ1 + v4 φ2 + (L0/P_supply) (C1 + C2 φ0' + C3 φ1' + C4 φ2'),     Ci = ∫ ci dε from the lower end of the box
//! ```
//!
//! Between two of 0, 0.15, 0.45 and 1 the pull is of second degree in q, so that the pressure of a
//! pull is a root of a quadratic equation. Outside of the box the values are those of its nearest
//! point, with a status. For simulators each function of q and each function of ε continues along
//! its tangent ([`Form::beyond`]): value, slope and potential are continuous there. Where F would
//! be negative the muscle is slack: F = 0, and V is that at its free contraction.

use serde::Serialize;

/// Functions of the pressure: 1, q, φ0, φ1 and φ2.
pub const FUNCTIONS: usize = 5;
/// κ: where the functions of second degree begin, shares of the supply.
pub const PRESSURE_KNOTS: [f64; 3] = [0.0, 0.15, 0.45];
/// Largest number of nodes in ε.
pub const NODES: usize = 10;
/// The point lies inside of the box, and the muscle pulls.
pub const OK: u32 = 0;
/// The muscle would have to push, and is slack.
pub const SLACK: u32 = 1;
/// The pressure lies outside of the box.
pub const PRESSURE_OUTSIDE: u32 = 2;
/// The contraction lies outside of the box.
pub const CONTRACTION_OUTSIDE: u32 = 4;

/// Pull and volume of a muscle in closed form. Units: Pa, m, N, m³.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "ExportForm")]
pub struct Form {
    /// Length at rest L0, m.
    #[schemars(extend("x-unit" = "m"))]
    pub length_m: f64,
    /// Supply pressure, the upper end of the box, Pa.
    #[schemars(extend("x-unit" = "Pa"))]
    pub supply_pa: f64,
    /// Lower end of the box in ε, negative.
    pub contraction_low: f64,
    /// Upper end of the box in ε: the free contraction at the supply.
    pub contraction_high: f64,
    /// Nodes in ε, from the lower end of the box to the upper one.
    pub contractions: Vec<f64>,
    /// Values of c0 to c4 at the nodes, N.
    #[schemars(extend("x-unit" = "N"))]
    pub a: [Vec<f64>; FUNCTIONS],
    /// Slopes of c0 to c4 in ε at the nodes, N.
    #[schemars(extend("x-unit" = "N"))]
    pub b: [Vec<f64>; FUNCTIONS],
    /// v0 to v4, m³.
    #[schemars(extend("x-unit" = "m³"))]
    pub v: [f64; FUNCTIONS],
    /// Half-width of the hysteresis, N: h0 √q + h1 q; zeros where the muscle does not state its
    /// friction.
    pub friction_n: [f64; 2],
    /// Way over which it builds up after a reversal, m; 0 where the muscle does not state its
    /// friction.
    #[schemars(extend("x-unit" = "m"))]
    pub presliding_m: f64,
}

/// Everything at a point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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

/// c, dc/dε and C at a contraction, for each function of the pressure.
#[derive(Default)]
struct Coefficients {
    c: [f64; FUNCTIONS],
    slope: [f64; FUNCTIONS],
    integral: [f64; FUNCTIONS],
}

/// The functions of the pressure at q, and their slopes.
pub fn functions(q: f64) -> ([f64; FUNCTIONS], [f64; FUNCTIONS]) {
    let mut value = [0.0; FUNCTIONS];
    let mut slope = [0.0; FUNCTIONS];
    (value[0], value[1], slope[1]) = (1.0, q, 1.0);
    for (k, knot) in PRESSURE_KNOTS.into_iter().enumerate() {
        let t = (q - knot).clamp(0.0, 1.0 - knot);
        value[k + 2] = t * (t + 2.0 * (q - 1.0).max(0.0));
        slope[k + 2] = 2.0 * t;
    }
    (value, slope)
}

fn sum(c: &[f64; FUNCTIONS], functions: &[f64; FUNCTIONS]) -> f64 {
    c.iter().zip(functions).map(|(c, f)| c * f).sum()
}

impl Form {
    fn coefficients(&self, contraction: f64) -> Coefficients {
        let nodes = &self.contractions;
        let inside = contraction
            .max(self.contraction_low)
            .min(self.contraction_high);
        let beyond = contraction - inside;
        let n = nodes
            .partition_point(|node| *node <= inside)
            .clamp(1, nodes.len() - 1)
            - 1;
        let h = nodes[n + 1] - nodes[n];
        let t = (inside - nodes[n]) / h;
        let s = 1.0 - t;
        // Hermite's cubic polynomials, their slopes and their integrals: value and slope at the one
        // end, value and slope at the other.
        let value = [
            (1.0 + 2.0 * t) * s * s,
            h * t * s * s,
            t * t * (3.0 - 2.0 * t),
            -h * t * t * s,
        ];
        let slope = [
            -6.0 * t * s / h,
            s * (1.0 - 3.0 * t),
            6.0 * t * s / h,
            t * (3.0 * t - 2.0),
        ];
        let cube = t * t * t;
        let fourth = t * t * t * t;
        let integral = [
            h * (t - cube + 0.5 * fourth),
            h * h * (0.5 * t * t - 2.0 / 3.0 * cube + 0.25 * fourth),
            h * (cube - 0.5 * fourth),
            h * h * (0.25 * fourth - cube / 3.0),
        ];
        let mut out = Coefficients::default();
        for i in 0..FUNCTIONS {
            let a = &self.a[i];
            let b = &self.b[i];
            let here = |w: &[f64; 4]| w[0] * a[n] + w[1] * b[n] + w[2] * a[n + 1] + w[3] * b[n + 1];
            let c = here(&value);
            let by_contraction = here(&slope);
            let before: f64 = (0..n)
                .map(|k| {
                    let g = nodes[k + 1] - nodes[k];
                    0.5 * g * (a[k] + a[k + 1] + g / 6.0 * (b[k] - b[k + 1]))
                })
                .sum();
            out.integral[i] =
                before + here(&integral) + beyond * (c + 0.5 * by_contraction * beyond);
            out.c[i] = c + by_contraction * beyond;
            out.slope[i] = by_contraction;
        }
        out
    }

    /// The pull that the form gives, negative where the muscle would have to push, and its slope in
    /// ε; pressure in Pa.
    pub fn two_sided_n(&self, pressure_pa: f64, contraction: f64) -> (f64, f64) {
        let (k, (phi, _)) = (
            self.coefficients(contraction),
            functions(pressure_pa / self.supply_pa),
        );
        (sum(&k.c, &phi), sum(&k.slope, &phi))
    }

    fn two_sided_volume_m3(&self, pressure_pa: f64, contraction: f64) -> f64 {
        let q = pressure_pa / self.supply_pa;
        sum(&self.v, &functions(q).0) + self.potential_volume_m3(q, contraction)
    }

    /// The part of the potential of the pull in the volume of the muscle at rest length, m³.
    pub(crate) fn potential_volume_m3(&self, q: f64, contraction: f64) -> f64 {
        self.length_m / self.supply_pa
            * sum(&self.coefficients(contraction).integral, &functions(q).1)
    }

    fn outside(&self, pressure_pa: f64, contraction: f64) -> u32 {
        let pressure = if (0.0..=self.supply_pa).contains(&pressure_pa) {
            OK
        } else {
            PRESSURE_OUTSIDE
        };
        let inside = (self.contraction_low..=self.contraction_high).contains(&contraction);
        pressure | if inside { OK } else { CONTRACTION_OUTSIDE }
    }

    /// Everything at the point of the box that is nearest to a pressure in Pa and a contraction.
    pub fn point_at(&self, pressure_pa: f64, contraction: f64) -> Point {
        let inside = contraction.clamp(self.contraction_low, self.contraction_high);
        let point = self.beyond(pressure_pa.clamp(0.0, self.supply_pa), inside);
        Point {
            status: point.status | self.outside(pressure_pa, contraction),
            ..point
        }
    }

    /// The same, along the tangents outside of the box.
    pub fn beyond(&self, pressure_pa: f64, contraction: f64) -> Point {
        let (k, (phi, slope)) = (
            self.coefficients(contraction),
            functions(pressure_pa / self.supply_pa),
        );
        let force_n = sum(&k.c, &phi);
        let status = self.outside(pressure_pa, contraction);
        if force_n <= 0.0 {
            let free = self.contraction(0.0, pressure_pa);
            return Point {
                volume_m3: self.two_sided_volume_m3(pressure_pa, free),
                status: status | SLACK,
                ..Point::default()
            };
        }
        Point {
            force_n,
            stiffness_n_per_m: -sum(&k.slope, &phi) / self.length_m,
            force_per_pressure_m2: sum(&k.c, &slope) / self.supply_pa,
            volume_m3: sum(&self.v, &phi)
                + self.length_m / self.supply_pa * sum(&k.integral, &slope),
            status,
        }
    }

    /// Points q, ε of the box with their pulls, from where it becomes slack to where it pulls
    /// again: the volume of a slack muscle would not be known there.
    pub fn pulls_again(&self) -> Vec<(f64, f64, f64)> {
        let low = self.contraction_low;
        let width = self.contraction_high - self.contraction_low;
        // Without pressure a model without a wall is slack nowhere: its pull is rounding.
        let rounding_n = 1e-7 * self.two_sided_n(self.supply_pa, 0.0).0;
        let line = |i: i32| {
            let q = (f64::from(i) / 40.0).powi(2);
            let all = (0..=125)
                .map(|k| low + width * f64::from(k) / 125.0)
                .map(|e| (q, e, self.two_sided_n(q * self.supply_pa, e).0));
            let mut behind: Vec<_> = all.skip_while(|p| p.2 >= -rounding_n).collect();
            behind.truncate(
                behind
                    .iter()
                    .rposition(|p| p.2 > rounding_n)
                    .map_or(0, |last| last + 1),
            );
            behind
        };
        (0..=40).flat_map(line).collect()
    }

    /// The contraction at which the pull is `force_n` at a pressure in Pa: Newton's method between
    /// bounds, the tangent outside of the box.
    pub fn contraction(&self, force_n: f64, pressure_pa: f64) -> f64 {
        let mut low = self.contraction_low;
        let mut high = self.contraction_high;
        for end in [low, high] {
            let (pull, slope) = self.two_sided_n(pressure_pa, end);
            let beyond = if end == low {
                force_n >= pull
            } else {
                force_n <= pull
            };
            if beyond {
                return if slope < 0.0 {
                    end + (force_n - pull) / slope
                } else {
                    end
                };
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
}
