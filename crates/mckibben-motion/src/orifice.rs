//! Restrictions of air after ISO 6358.

use crate::{Flow, REFERENCE_DENSITY_G_PER_L, Result, error::within};

/// T0 of ISO 6358 in K.
const REFERENCE_K: f64 = 293.15;

/// Share of the pressure ratio below equal pressures in which the flow is made smooth.
pub const LINEAR_SHARE: f64 = 0.01;

/// A restriction of air.
///
/// ```text
/// G = C p1 ρ0 √(T0/T1) ψ(p2/p1),   ψ = 1 for r ≤ b,   else √(1 − ((r − b)/(1 − b))²)
/// ```
///
/// C sonic conductance, b critical pressure ratio, 1 upstream and 2 downstream (absolute); ρ0 =
/// 1.185 kg/m³, T0 = 293.15 K. The root has an infinite slope at r = 1: for r > 0.99, ψ is the
/// parabola s (A + B s), s = (1 − r)/0.01, that has the root's value and slope at r = 0.99 and is
/// zero at r = 1; ψ rises there with a finite slope, so the flow is C¹ in both pressures, also
/// through their equality where the temperatures are equal. Reverse flow by exchange of 1 and 2.
/// Real valves: b 0.1–0.5; ±5 % in G as a rule. Source: ISO 6358-1:2013 \[iso2013\].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Orifice {
    /// C in L/(s bar).
    pub conductance_l_per_s_bar: f64,
    /// b.
    pub critical_ratio: f64,
}

impl Orifice {
    /// A restriction of a sonic conductance in L/(s bar) and a critical ratio.
    ///
    /// # Errors
    /// [`MotionError::Refused`](crate::MotionError::Refused) unless 1e-9 ≤ C ≤ 1e6 L/(s bar) and 0 ≤ b < 0.99.
    pub fn new(conductance_l_per_s_bar: f64, critical_ratio: f64) -> Result<Self> {
        within(
            "the valve's sonic conductance in L/(s bar)",
            conductance_l_per_s_bar,
            1e-9,
            1e6,
        )?;
        within(
            "the valve's critical pressure ratio",
            critical_ratio,
            0.0,
            1.0 - LINEAR_SHARE - 1e-9,
        )?;
        Ok(Self {
            conductance_l_per_s_bar,
            critical_ratio,
        })
    }

    /// The same with its conductance times a factor.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            conductance_l_per_s_bar: self.conductance_l_per_s_bar * factor,
            ..self
        }
    }

    /// ψ.
    fn shape(&self, ratio: f64) -> f64 {
        let b = self.critical_ratio;
        let root = |r: f64| (1.0 - ((r - b) / (1.0 - b)).powi(2)).max(0.0).sqrt();
        let edge = 1.0 - LINEAR_SHARE;
        if ratio <= b {
            1.0
        } else if ratio <= edge {
            root(ratio)
        } else {
            let value = root(edge);
            // dψ/ds at s = 1
            let slope = LINEAR_SHARE * (edge - b) / ((1.0 - b).powi(2) * value);
            let s = (1.0 - ratio) / LINEAR_SHARE;
            s * ((2.0 * value - slope) + (slope - value) * s)
        }
    }

    /// The flow from `from` to `to`, each absolute pressure in MPa and temperature in K; negative
    /// when it goes back.
    #[doc(hidden)]
    pub fn flow(&self, from: (f64, f64), to: (f64, f64)) -> Flow {
        let (sign, up, down) = if from.0 >= to.0 {
            (1.0, from, to)
        } else {
            (-1.0, to, from)
        };
        // 1 L/(s bar) · 10 bar/MPa · 1.185 g/L
        let choked = self.conductance_l_per_s_bar * 10.0 * up.0 * REFERENCE_DENSITY_G_PER_L;
        let mass = choked * (REFERENCE_K / up.1).sqrt() * self.shape(down.0 / up.0);
        Flow {
            mass_g_per_s: sign * mass,
            temperature_k: up.1,
        }
    }
}

/// Several restrictions one after the other: 1/C³ = Σ 1/Cᵢ³, (1 − b)/C² = Σ (1 − bᵢ)/Cᵢ².
///
/// An approximation: within some per cent of G. `None` for an empty list. Source: ISO 6358-3:2014
/// \[iso2014\]; \[beater2007\].
pub fn in_series(orifices: &[Orifice]) -> Option<Orifice> {
    // In units of the smallest, whose cube may be none.
    let least = orifices
        .iter()
        .map(|o| o.conductance_l_per_s_bar)
        .reduce(f64::min)?;
    let ratio = |o: &Orifice| {
        if least > 0.0 {
            least / o.conductance_l_per_s_bar
        } else {
            1.0
        }
    };
    let cubes: f64 = orifices.iter().map(|o| ratio(o).powi(3)).sum();
    let squares: f64 = orifices
        .iter()
        .map(|o| (1.0 - o.critical_ratio) * ratio(o).powi(2))
        .sum();
    let c = cubes.powf(-1.0 / 3.0);
    Some(Orifice {
        conductance_l_per_s_bar: least * c,
        critical_ratio: (1.0 - c * c * squares).clamp(0.0, 1.0 - LINEAR_SHARE - 1e-9),
    })
}
