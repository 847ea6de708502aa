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
//!
//! What is computed here is the exported file of Rust, `templates/mckibben.rs`.

use serde::Serialize;

#[rustfmt::skip]
#[path = "../templates/mckibben.rs"]
mod functions;

use functions::Muscle;
pub(crate) use functions::functions;
pub use functions::{CONTRACTION_OUTSIDE, FUNCTIONS, Node, PRESSURE_OUTSIDE, SLACK};

/// Largest number of nodes in ε.
pub const NODES: usize = 10;
/// The point lies inside of the box, and the muscle pulls.
pub const OK: u32 = 0;

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
    /// Lower end of the box in ε, zero or negative.
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
    /// Half-width of the hysteresis, N: (h0 + h1 ε + h2 ε²) √q + (h3 + h4 ε + h5 ε²) q; zeros where
    /// no friction is known.
    pub friction_n: [f64; 6],
    /// Way over which it builds up after a reversal, m.
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

impl Form {
    /// The values and slopes of c0 to c4 at each node.
    pub fn nodes(&self) -> Vec<Node> {
        let node = |(k, &contraction)| Node {
            contraction,
            value_n: std::array::from_fn(|i| self.a[i][k]),
            slope_n: std::array::from_fn(|i| self.b[i][k]),
        };
        self.contractions.iter().enumerate().map(node).collect()
    }

    fn muscle<'n>(&self, nodes: &'n [Node], beyond: bool) -> Muscle<'n> {
        Muscle {
            length_m: self.length_m,
            cord_m: 0.0,
            supply_pa: self.supply_pa,
            nodes,
            volume_m3: self.v,
            friction: [0.0; 7],
            beyond,
        }
    }

    /// The pull that the form gives, negative where the muscle would have to push, and its slope in
    /// ε; pressure in Pa.
    pub fn two_sided_n(&self, pressure_pa: f64, contraction: f64) -> (f64, f64) {
        let state = self
            .muscle(&self.nodes(), true)
            .state(pressure_pa, contraction);
        (state.pull, state.slope_in_contraction())
    }

    /// Everything at the point of the box that is nearest to a pressure in Pa and a contraction.
    pub fn point_at(&self, pressure_pa: f64, contraction: f64) -> Point {
        self.point(false, pressure_pa, contraction)
    }

    /// The same, along the tangents outside of the box.
    pub fn beyond(&self, pressure_pa: f64, contraction: f64) -> Point {
        self.point(true, pressure_pa, contraction)
    }

    fn point(&self, beyond: bool, pressure_pa: f64, contraction: f64) -> Point {
        let nodes = self.nodes();
        let muscle = self.muscle(&nodes, beyond);
        let state = muscle.state(pressure_pa, contraction);
        let is_taut = state.pull > 0.0;
        let taut = |value: f64| if is_taut { value } else { 0.0 };
        Point {
            force_n: taut(state.pull),
            stiffness_n_per_m: taut(-state.slope_in_contraction() / self.length_m),
            force_per_pressure_m2: taut(state.slope_in_q() / self.supply_pa),
            volume_m3: muscle.volume_of(pressure_pa, contraction),
            status: state.status,
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
            let mut behind: Vec<_> = (0..=125)
                .map(|k| low + width * f64::from(k) / 125.0)
                .map(|e| (q, e, self.two_sided_n(q * self.supply_pa, e).0))
                .skip_while(|p| p.2 >= -rounding_n)
                .collect();
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

    /// The contraction at which the pull is `force_n` at a pressure in Pa; along the tangent outside
    /// of the box.
    pub fn contraction(&self, force_n: f64, pressure_pa: f64) -> f64 {
        let nodes = self.nodes();
        self.muscle(&nodes, true)
            .contraction_and_status(force_n, pressure_pa)
            .0
    }
}
