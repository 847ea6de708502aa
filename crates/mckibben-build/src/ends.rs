//! How an end holds tube and sleeve, by the load that it carries.
//!
//! | ends | load | what holds |
//! |---|---|---|
//! | tied | to a quarter of what the ties hold by estimate, about 100 N | cable ties in grooves |
//! | clamped | to 500 N | hose clamps behind barbs |
//! | crimped | above | a ferrule that presses the sleeve on a metal shoulder beyond the tube; a hose clamp seals the tube |
//!
//! The limits are choices: no pull-off force of a clamp on a muscle was found in any source. So
//! every end is proved under the load of the proof pressure.

use mckibben_core::{analysis::SAFETY, muscle::EndsMade};
use std::f64::consts::PI;

/// Ties with their least loop strength (QB/T 4494-2013). The stems are a choice: a narrow tie bends
/// to a small circle more evenly.
const TIES: [Tie; 4] = [
    Tie::new(2.5, 80.0, 6.0),
    Tie::new(3.6, 130.0, 15.0),
    Tie::new(4.8, 180.0, 40.0),
    Tie::new(7.6, 450.0, f64::INFINITY),
];
/// A tie that is tightened by hand has this share of its strength (a choice).
const TIGHTENED: f64 = 1.0 / 3.0;
/// Friction of a sleeve on a tube under a band (an estimate).
const FRICTION: f64 = 0.3;
/// Ties at an end at most.
const MOST_TIES: usize = 3;

/// Largest load in N of an end with hose clamps (a choice).
const CLAMPED_TO_N: f64 = 500.0;
/// Bands of hose clamps (DIN 3017-1) in mm; the wider one from this diameter on.
const BANDS_MM: [f64; 2] = [9.0, 12.0];
const WIDE_FROM_MM: f64 = 40.0;
/// By this share a clamp squeezes the wall of the tube (a choice).
pub const SQUEEZE: f64 = 0.25;

/// A cable tie.
#[derive(Clone, Copy)]
struct Tie {
    width_mm: f64,
    /// Least loop strength.
    strength_n: f64,
    /// Largest diameter of a stem.
    stem_mm: f64,
}

impl Tie {
    const fn new(width_mm: f64, strength_n: f64, stem_mm: f64) -> Self {
        Self {
            width_mm,
            strength_n,
            stem_mm,
        }
    }

    /// The tie for a stem.
    fn around(stem_mm: f64) -> Self {
        let fits = TIES.into_iter().find(|tie| stem_mm <= tie.stem_mm);
        fits.unwrap_or(TIES[TIES.len() - 1])
    }

    /// Its holding force in N by friction: 2π μ T.
    fn holds_n(self) -> f64 {
        2.0 * PI * FRICTION * TIGHTENED * self.strength_n
    }
}

/// The tube in its clamps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clamped {
    /// Bore, and wall.
    pub bore_mm: f64,
    pub wall_mm: f64,
    /// Shear modulus of the rubber.
    pub mu_mpa: f64,
    /// Diameter over tube and sleeve on the plug.
    pub diameter_mm: f64,
}

/// What holds tube and sleeve at each end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ends {
    pub made: EndsMade,
    /// Width in mm of a tie, or of the band of a clamp.
    pub band_mm: f64,
    /// Ties or clamps at each end.
    pub at_each_end: usize,
    /// What they hold by estimate in N, from and to: of a hose clamp if the rubber flows out under
    /// it, and if none does. None of a ferrule, for which no estimate is known.
    pub holds_n: Option<[f64; 2]>,
}

impl Ends {
    /// Thickness of ties, bands and ferrules in mm.
    pub const CLAMP_MM: f64 = 1.5;

    /// The ends for a load in N; `made` is how they are held, where that is stated.
    pub(crate) fn new(load_n: f64, tube: Clamped, made: Option<EndsMade>) -> Self {
        let tie = Tie::around(tube.bore_mm);
        let needed = (SAFETY * load_n / tie.holds_n()).ceil().max(2.0);
        let usual = match load_n {
            _ if needed <= MOST_TIES as f64 => EndsMade::Tied,
            load_n if load_n <= CLAMPED_TO_N => EndsMade::Clamped,
            _ => EndsMade::Crimped,
        };
        let made = made.unwrap_or(usual);
        let (band_mm, at_each_end) = match made {
            EndsMade::Tied => (tie.width_mm, needed.min(MOST_TIES as f64) as usize),
            _ if tube.diameter_mm < WIDE_FROM_MM => (BANDS_MM[0], 1),
            _ => (BANDS_MM[1], 1),
        };
        let holds_n = match made {
            EndsMade::Tied => Some([at_each_end as f64 * tie.holds_n(); 2]),
            EndsMade::Clamped => Some(squeezed_n(tube, band_mm)),
            EndsMade::Crimped => None,
        };
        Self {
            made,
            band_mm,
            at_each_end,
            holds_n,
        }
    }

    /// Least length in mm of tube and sleeve on the plug.
    pub(crate) fn least_mm(&self) -> f64 {
        match self.made {
            EndsMade::Tied => self.at_each_end as f64 * (self.band_mm + 2.0),
            EndsMade::Clamped => self.band_mm + 3.0,
            EndsMade::Crimped => self.band_mm + 3.0 + 16.0,
        }
    }

    /// Whether their estimate bears a load with the factor of safety; none where there is no
    /// estimate.
    pub(crate) fn bear(&self, load_n: f64) -> Option<bool> {
        Some(self.holds_n?[0] >= SAFETY * load_n)
    }
}

/// What a hose clamp holds in N by friction, as it squeezes the wall of the tube by a share q: 0.3 π
/// D w p, with the stress p = (4/3) E q of a long strip between plates that slide, and (4/3) E q (1 +
/// S²) of one that is bonded to them, S = w/2s (Gent & Lindley 1959 \[gent1959\]).
fn squeezed_n(tube: Clamped, band_mm: f64) -> [f64; 2] {
    let flows_mpa = 4.0 * tube.mu_mpa * SQUEEZE;
    let shape = band_mm / (2.0 * tube.wall_mm);
    let held_mpa = flows_mpa * (1.0 + shape * shape);
    [flows_mpa, held_mpa].map(|p| FRICTION * PI * tube.diameter_mm * band_mm * p)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: two ties of 4.8 mm hold 2 · 2π · 0.3 · 180/3 = 226 N, a quarter of it is 56.5 N. A
    /// clamp of 9 mm on 26 mm over 3 mm of μ 0.4 MPa: 0.3 π 26 · 9 · 4 · 0.4 · 0.25 = 88.2 N, bonded
    /// (S = 1.5) 3.25 times as much.
    #[test]
    fn by_hand_ends_hold_four_times_their_load_or_are_of_another_kind() {
        let tube = Clamped {
            bore_mm: 20.0,
            wall_mm: 3.0,
            mu_mpa: 0.4,
            diameter_mm: 26.0,
        };
        let ends = |load_n: f64| Ends::new(load_n, tube, None);
        let tied = ends(56.0);
        assert_eq!((tied.made, tied.at_each_end), (EndsMade::Tied, 2));
        assert!((tied.holds_n.unwrap_or_default()[0] - 226.2).abs() < 0.05);
        assert_eq!(
            (ends(57.0).made, ends(57.0).at_each_end),
            (EndsMade::Tied, 3)
        );
        let clamped = ends(96.0);
        assert_eq!(clamped.made, EndsMade::Clamped);
        let [low, high] = clamped.holds_n.unwrap_or_default();
        assert!((low - 88.22).abs() < 0.01 && (high / low - 3.25).abs() < 1e-9);
        assert_eq!(ends(501.0).made, EndsMade::Crimped);
        let stated = Ends::new(96.0, tube, Some(EndsMade::Tied));
        assert_eq!(stated.bear(96.0), Some(false));
    }
}
