//! Friction between the strands of the braid: hysteresis of the pull.

use super::{Direction, Presliding};

/// Friction of the braid, half the width of the hysteresis loop.
///
/// ```text
/// F = F_model ± (C P^β + μw G(P, ε))        + while the muscle is lengthened, − while it shortens
/// ```
///
/// C P^β is a rule for measured loops. μw G is friction from contact: strands that cross press on each other and turn as the length L
/// changes, with a coefficient of friction μ and a lever w, which only their product shows,
///
/// ```text
/// G = (2/3) ∫ pc |dθ/dL| dA
/// ```
///
/// pc pressure of the strands on the tube, θ their angle, A the surface: [`pivoting_n_per_mm`](crate::model::pivoting_n_per_mm). It falls
/// with the contraction, as measured half-widths do, and grows faster with the pressure than they do: of one muscle (Tondu 2012, Fig. 3)
/// μw G misses by 7.6 N rms with one number, C P^β by 8.8 N with two. Source of the crossings: Davis & Caldwell (2006) \[davis2006\].
///
/// Measured exponents are 0.57 (20° muscle) and 0.82 (30°) in Tondu (2012) \[tondu2012\], Fig. 3. The friction belongs to the muscle,
/// not to the model of its pull: it is added to what any model says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// C in N/MPa^β: the half-width at 1 MPa.
    pub coefficient: f64,
    /// β (–).
    pub exponent: f64,
    /// μw in mm: coefficient of friction times lever of the strands' crossings. 0 where it is not stated.
    pub lever_mm: f64,
    /// Presliding length in mm, for motions and loops with history ([`Presliding`]). `None` where it is not stated.
    pub presliding_mm: Option<f64>,
}

impl Friction {
    /// C P^β alone.
    pub fn power_law(coefficient: f64, exponent: f64) -> Self {
        Self { coefficient, exponent, lever_mm: 0.0, presliding_mm: None }
    }

    /// Whether none of its numbers makes a force.
    pub(super) fn is_zero(&self) -> bool {
        self.coefficient == 0.0 && self.exponent == 0.0 && self.lever_mm == 0.0
    }

    /// How it builds up after a reversal: over the stated length, or 0.5 mm.
    pub fn presliding(&self) -> Presliding {
        self.presliding_mm.map_or_else(Presliding::default, Presliding::from_length)
    }

    /// The signed part C P^β in N at a pressure (zero without pressure).
    pub fn force_n(&self, pressure_mpa: f64, direction: Direction) -> f64 {
        if direction.is_mean() || pressure_mpa.is_nan() || pressure_mpa <= 0.0 {
            return 0.0;
        }
        direction.sign() * (self.coefficient * pressure_mpa.powf(self.exponent))
    }

    /// d(force)/dP in mm².
    pub fn slope_mm2(&self, pressure_mpa: f64, direction: Direction) -> f64 {
        if pressure_mpa > 0.0 {
            self.exponent * self.force_n(pressure_mpa, direction) / pressure_mpa
        } else {
            0.0
        }
    }
}
