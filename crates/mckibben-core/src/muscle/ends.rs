//! The ends of a muscle: gripped length, seating and slip reduce what is free between them, and
//! the slack of the braid what the pressure does.
//!
//! The muscle between its ends, La = L0 − 2h long at rest, is contracted by x where the whole is
//! contracted by ε, and its pressure is Pa where that of the whole is P:
//!
//!   x = (ε L0 + u)/La,   u = δ + c N,   N = F + π Ri² Pa,   Pa = max(P − P0, 0),
//!   F(P, ε) = F₀(Pa, x),  V(P, ε) = V₀(Pa, x) + π Ri² c N,
//!
//! F₀ (N) and V₀ (mm³) of a muscle of length La whose ends hold, h the grip at each end (mm), δ the
//! seating (mm), c the slip (mm/N), both of both ends together, N the load of a clamp (N): what
//! tube and braid carry there, the pull and the pressure Pa (MPa) on the plug of the bore Ri (mm),
//! P0 the take-up pressure (MPa), which takes up the slack of the braid (below zero, Pa = P).
//! As F₀ falls with x, u has one solution; Newton's method for it begins where a neighbouring state
//! points to, to first order, or comes from below, where F₀ is convex. With K₀ = −(1/La) ∂F₀/∂x
//!
//!   K = K₀/(1 + c K₀),   ∂F/∂P = (∂F₀/∂P − c K₀ π Ri²)/(1 + c K₀),   ∂F/∂δ = −K,   ∂F/∂c = −K N,
//!   ∂F/∂h = −2 (∂F₀/∂La + K₀ x)/(1 + c K₀),   ∂F/∂L0 = (∂F₀/∂La + K₀ (x − ε))/(1 + c K₀),
//!
//! and by all else ∂F₀/(1 + c K₀), with −K c P ∂(π Ri²) where the bore changes. L0 ∂F/∂P = ∂V/∂ε
//! holds as it does for F₀ and V₀.
//!
//! Range: the slip is a spring; strands that slip for good, and only one way, are none. It goes on
//! where a clamp would be pressed (N below 0). In the grip tube and braid have the plug in them and
//! stay as they are.

use super::Muscle;
use crate::model::Response;
use std::{borrow::Cow, f64::consts::PI};

/// The ends of a muscle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ends {
    /// L0 in mm.
    pub length_mm: f64,
    /// h: what is held at each end, in mm.
    pub grip_mm: f64,
    /// δ in mm.
    pub seating_mm: f64,
    /// c in mm/N.
    pub slip_mm_per_n: f64,
    /// P0 in MPa.
    pub take_up_mpa: f64,
    /// Ri at rest in mm, or the radius of the plugs where it is stated.
    pub bore_radius_mm: f64,
    stated: bool,
}

/// The state of the ends at a pressure and a contraction of the whole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndState {
    /// P in MPa.
    pub pressure_mpa: f64,
    /// ε.
    pub whole: f64,
    /// x.
    pub between: f64,
    /// N in N.
    pub load_n: f64,
    /// K₀ in N/mm; 0 where the ends do not slip and nobody needs it.
    pub stiffness_n_per_mm: f64,
    /// ∂N/∂P in mm², where it is known.
    pub load_per_pressure_mm2: Option<f64>,
}

impl Muscle {
    /// Its ends.
    #[doc(hidden)]
    pub fn ends(&self) -> Ends {
        let t = &self.parts.terminals;
        Ends {
            length_mm: self.parts.tube.length_mm,
            grip_mm: t.grip_mm.unwrap_or(0.0),
            seating_mm: t.seating_mm.unwrap_or(0.0),
            slip_mm_per_n: t.slip_mm_per_n.unwrap_or(0.0),
            take_up_mpa: self.parts.braid.take_up_mpa.unwrap_or(0.0),
            bore_radius_mm: self.parts.plug_radius_mm(),
            stated: self.parts.braid.take_up_mpa.is_some()
                || t.grip_mm.is_some()
                || t.seating_mm.is_some()
                || t.slip_mm_per_n.is_some(),
        }
    }

    /// The muscle between its ends, which hold: itself where nothing is said of them.
    pub fn between_ends(&self) -> Cow<'_, Self> {
        let ends = self.ends();
        if !ends.give() {
            return Cow::Borrowed(self);
        }
        let mut inner = self.clone();
        inner.parts.tube.length_mm = ends.active_mm();
        let ends = &mut inner.parts.terminals;
        (ends.grip_mm, ends.seating_mm, ends.slip_mm_per_n) = (None, None, None);
        inner.parts.braid.take_up_mpa = None;
        Cow::Owned(inner)
    }
}

impl Ends {
    /// Steps of Newton's method at most; three to five are the rule.
    pub const STEPS: usize = 40;

    /// Whether anything is said of them.
    pub fn give(&self) -> bool {
        self.stated
    }

    /// Pa in MPa of P.
    pub fn active_mpa(&self, pressure_mpa: f64) -> f64 {
        pressure_mpa.min(0.0) + (pressure_mpa - self.take_up_mpa).max(0.0)
    }

    /// P in MPa of Pa; P0 of a muscle that does not pull yet.
    pub fn whole_mpa(&self, active_mpa: f64) -> f64 {
        active_mpa
            + if active_mpa < 0.0 {
                0.0
            } else {
                self.take_up_mpa
            }
    }

    /// La in mm.
    pub fn active_mm(&self) -> f64 {
        self.length_mm - 2.0 * self.grip_mm
    }

    /// π Ri² in mm².
    pub fn bore_mm2(&self) -> f64 {
        PI * self.bore_radius_mm * self.bore_radius_mm
    }

    /// N in N at a pressure in MPa and a pull in N.
    pub fn load_n(&self, pressure_mpa: f64, force_n: f64) -> f64 {
        force_n + self.bore_mm2() * pressure_mpa
    }

    /// u in mm at a pressure in MPa and a pull in N.
    pub fn end_displacement_mm(&self, pressure_mpa: f64, force_n: f64) -> f64 {
        self.seating_mm + self.slip_mm_per_n * self.load_n(pressure_mpa, force_n)
    }

    /// x of ε, where the ends move by `displacement_mm`.
    pub fn between(&self, contraction: f64, displacement_mm: f64) -> f64 {
        contraction * (self.length_mm / self.active_mm()) + displacement_mm / self.active_mm()
    }

    /// ε of x.
    pub fn whole(&self, between: f64, displacement_mm: f64) -> f64 {
        (between - displacement_mm / self.active_mm()) / (self.length_mm / self.active_mm())
    }

    /// u in mm where x goes with ε.
    pub fn displacement_between_mm(&self, contraction: f64, between: f64) -> f64 {
        between * self.active_mm() - contraction * self.length_mm
    }

    /// u in mm at a pressure in MPa and a contraction, to first order from a state of the ends.
    pub fn displacement_near_mm(&self, at: &EndState, pressure_mpa: f64, contraction: f64) -> f64 {
        let k = at.stiffness_n_per_mm / self.series_factor(at.stiffness_n_per_mm);
        let by_pressure = at.load_per_pressure_mm2.unwrap_or_else(|| self.bore_mm2());
        let more_n = by_pressure * (pressure_mpa - at.pressure_mpa);
        let less_n = k * self.length_mm * (contraction - at.whole);
        self.seating_mm + self.slip_mm_per_n * (at.load_n + more_n - less_n)
    }

    /// The state of the ends; `pull` answers at x. The search begins at `start_mm`, or without it
    /// at a muscle that does not pull. `None` where Newton's method does not find it.
    pub fn solve_end_displacement<E>(
        &self,
        pressure_mpa: f64,
        contraction: f64,
        start_mm: Option<f64>,
        mut pull: impl FnMut(f64) -> Result<Response, E>,
    ) -> Result<Option<EndState>, E> {
        let mut displacement =
            start_mm.unwrap_or_else(|| self.end_displacement_mm(pressure_mpa, 0.0));
        for _ in 0..Self::STEPS {
            let between = self.between(contraction, displacement);
            let inner = pull(between)?;
            let k = inner.stiffness_n_per_mm.unwrap_or(0.0);
            let slip = self.slip_mm_per_n;
            let force_n = inner.force_n;
            let miss = self.end_displacement_mm(pressure_mpa, force_n) - displacement;
            if slip == 0.0 || miss.abs() <= 1e-9 * (1.0 + displacement.abs()) {
                let by_pressure = |slope: f64| (slope + self.bore_mm2()) / self.series_factor(k);
                return Ok(Some(EndState {
                    pressure_mpa,
                    whole: contraction,
                    between,
                    load_n: self.load_n(pressure_mpa, force_n),
                    stiffness_n_per_mm: k,
                    load_per_pressure_mm2: inner.force_per_pressure_mm2.map(by_pressure),
                }));
            }
            displacement += miss / self.series_factor(k).max(0.5);
        }
        Ok(None)
    }

    /// 1 + c K₀.
    pub fn series_factor(&self, stiffness_n_per_mm: f64) -> f64 {
        1.0 + self.slip_mm_per_n * stiffness_n_per_mm
    }

    /// ∂F by a constant or measure of the whole muscle, of which `inner` is ∂F₀; that by the grip
    /// needs ∂F₀/∂La.
    pub fn slope(&self, at: &EndState, name: &str, inner: f64) -> f64 {
        let k = at.stiffness_n_per_mm;
        let wider = k * self.slip_mm_per_n * at.pressure_mpa * PI * self.bore_radius_mm;
        let held = match name {
            "terminals.seating" => -k,
            "terminals.slip" => -k * at.load_n,
            "terminals.grip" => -2.0 * (inner + k * at.between),
            "tube.length" => inner + k * (at.between - at.whole),
            "tube.outer_diameter" => inner - wider,
            "tube.wall_thickness" => inner + 2.0 * wider,
            _ => inner,
        };
        held / self.series_factor(k)
    }

    /// Of which constant of the muscle between its ends [`Ends::slope`] needs ∂F₀; `None` for those
    /// of the ends alone.
    pub fn inner_name(name: &str) -> Option<&str> {
        match name {
            "terminals.seating" | "terminals.slip" => None,
            "terminals.grip" => Some("tube.length"),
            name => Some(name),
        }
    }
}
