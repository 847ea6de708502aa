//! Friction between the strands of the braid: hysteresis of the pull.

use super::Presliding;

/// Friction of the braid, half the width of the hysteresis loop.
///
/// ```text
/// F = F_model ± (C P^β + μw G(P, ε))        + while the muscle is lengthened, − while it shortens
/// ```
///
/// C P^β is a rule for measured loops. μw G is friction from contact: strands that cross press on
/// each other and turn as the length L changes, with a coefficient of friction μ and a lever w,
/// which only their product shows,
///
/// ```text
/// G = (2/3) ∫ pc |dθ/dL| dA
/// ```
///
/// pc pressure of the strands on the tube, θ their angle, A the surface:
/// [`pivoting_n_per_mm`](crate::model::pivoting_n_per_mm). It falls with the contraction, as
/// measured half-widths do, and grows faster with the pressure than they do: of one muscle (Tondu
/// 2012, Fig. 3) μw G misses by 7.6 N rms with one number, C P^β by 8.8 N with two. Source of the
/// crossings: Davis & Caldwell (2006) \[davis2006\].
///
/// Measured exponents are 0.57 (20° muscle) and 0.82 (30°) in Tondu (2012) \[tondu2012\], Fig. 3.
/// The friction belongs to the muscle, not to the model of its pull: it is added to what any model
/// says.
///
/// Of a muscle that states none, the half-width on a stated branch is estimated:
///
/// ```text
/// h = η T cosθ
/// ```
///
/// T tension of all strands in N and θ their angle, so that T cosθ is their pull along the axis, of
/// the infinitely long muscle at P and ε; h ends where the strands go slack. η (–) is that of
/// [`Experience`](crate::built::Experience), from the two braided muscles whose loops were measured
/// (Tondu 2012 \[tondu2012\], 20° and 30°, 1 to 5 bar; below ε 0.02, h is up to twice as large).
/// Both have rayon strands, one diameter, length, laboratory and bench: they do not tell how h grows
/// with the diameter, nor what strands of PET or nylon, or another bench, make of it. Of strands
/// inside of the rubber it is a fraction of that; of muscles that extend none is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// C in N/MPa^β: the half-width at 1 MPa.
    pub coefficient: f64,
    /// β (–).
    pub exponent: f64,
    /// μw in mm: coefficient of friction times lever of the strands' crossings. 0 where it is not
    /// stated.
    pub lever_mm: f64,
    /// Presliding length x_s in mm, for motions and loops with history ([`Presliding`]). `None`
    /// where it is not stated.
    pub presliding_mm: Option<f64>,
}

impl Friction {
    /// C P^β alone.
    pub fn power_law(coefficient: f64, exponent: f64) -> Self {
        Self {
            coefficient,
            exponent,
            lever_mm: 0.0,
            presliding_mm: None,
        }
    }

    /// Whether none of its numbers makes a force.
    pub(super) fn is_zero(&self) -> bool {
        self.coefficient == 0.0 && self.exponent == 0.0 && self.lever_mm == 0.0
    }

    /// Presliding length in mm where none is stated.
    pub const PRESLIDING_MM: f64 = 0.5;

    /// The stated presliding length, or [`Friction::PRESLIDING_MM`].
    pub fn presliding_length_mm(&self) -> f64 {
        self.presliding_mm.unwrap_or(Self::PRESLIDING_MM)
    }

    /// How it builds up, over [`Friction::presliding_length_mm`], from a position in mm on, after
    /// sliding towards `sign` (0: at rest).
    #[doc(hidden)]
    pub fn presliding(&self, at_mm: f64, sign: f64) -> Presliding {
        Presliding::new(self.presliding_length_mm(), at_mm, sign)
    }

    /// C P^β + μw G in N, of G in N/mm; 0 without pressure.
    pub fn half_width_n(&self, pressure_mpa: f64, pivoting_n_per_mm: f64) -> f64 {
        let half_n = || {
            self.coefficient * pressure_mpa.powf(self.exponent) + self.lever_mm * pivoting_n_per_mm
        };
        if pressure_mpa > 0.0 { half_n() } else { 0.0 }
    }
}
