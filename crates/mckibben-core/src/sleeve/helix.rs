//! The helix of a sleeve's strands: what stays when a sleeve is pulled over a thicker or thinner
//! tube.

use std::f64::consts::{FRAC_PI_4, PI};

/// The braid angle at which a muscle neither contracts nor extends: cos²θ = 1/3, in degrees.
pub const NEUTRAL_ANGLE_DEG: f64 = 54.735_610_317_245_35;

/// The helix of a sleeve, which keeps the length ℓ of strand per turn.
///
/// ```text
/// sinθ = π D/ℓ          one turn: π D around, π D/tanθ along, ℓ of strand
/// ```
///
/// θ angle of the strands to the axis, D diameter on which they lie (mm), ℓ in mm. D is the tube's
/// OUTER diameter, as in the whole program: a braid of thickness t has its midline at D + t, which
/// makes the true angle larger by (t/D) tanθ (2° at t/D 6 % and 30°).
///
/// **Jamming.** n strands in all, n/2 each way, each w wide across its length, touch their
/// neighbours where their spacing is w:
///
/// ```text
/// π D cosθ/(n/2) = w    ⇔   n w = 2π D cosθ = ℓ sin 2θ
/// ```
///
/// so a braid jams at two angles, θ_j when it is pulled long and 90° − θ_j when it is pushed wide,
/// at the diameters D₁ = (ℓ/π) sinθ_j and D₂ = (ℓ/π) cosθ_j (Davis & Caldwell 2006 \[davis2006\]
/// for the wide one). Both together give the helix back:
///
/// ```text
/// ℓ = π √(D₁² + D₂²),   tanθ_j = D₁/D₂,   n w = 2π D₁ D₂/√(D₁² + D₂²)
/// ```
///
/// This is how a sleeve with nothing but a stated range gets its angle. The assumption is that both
/// ends of the range are jammed. A seller who stops short of the wide end by a share x makes ℓ too
/// small by x/(1 + (D₁/D₂)²): the angle at a given diameter comes out too large, tanθ·x/(1 +
/// (D₁/D₂)²) in radians, 2.4° at 25°, x = 10 % and D₂ = 3 D₁. Stopping short of the narrow end by x
/// matters less, by (D₁/D₂)². Strands that lie on each other, or are flattened, jam later than
/// round ones side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helix {
    /// ℓ, length of strand per turn in mm.
    strand_length_per_turn_mm: f64,
}

impl Helix {
    /// The helix that has an angle at a diameter: ℓ = π D/sinθ. `None` where these are no measures.
    pub fn at(diameter_mm: f64, angle_deg: f64) -> Option<Self> {
        Self::checked(PI * diameter_mm / angle_deg.to_radians().sin())
            .filter(|_| angle_deg > 0.0 && angle_deg < 90.0)
    }

    /// The helix of a sleeve that jams at two diameters: ℓ = π √(D₁² + D₂²).
    pub fn jammed_at(least_mm: f64, largest_mm: f64) -> Option<Self> {
        Self::checked(PI * least_mm.hypot(largest_mm))
            .filter(|_| least_mm > 0.0 && least_mm < largest_mm)
    }

    /// The helix of a sleeve whose strands, `total_width_mm` = n w wide together, touch at its
    /// least diameter: cosθ_j = n w/(2π D₁). `None` where they do not fit around it.
    pub fn jammed_at_least(least_mm: f64, total_width_mm: f64) -> Option<Self> {
        let cos = total_width_mm / (2.0 * PI * least_mm);
        (cos > 0.0 && cos < 1.0)
            .then(|| Self::at(least_mm, cos.acos().to_degrees()))
            .flatten()
    }

    fn checked(strand_length_per_turn_mm: f64) -> Option<Self> {
        (strand_length_per_turn_mm.is_finite() && strand_length_per_turn_mm > 0.0).then_some(Self {
            strand_length_per_turn_mm,
        })
    }

    /// ℓ, length of strand per turn in mm.
    pub fn strand_length_per_turn_mm(self) -> f64 {
        self.strand_length_per_turn_mm
    }

    /// θ in degrees on a diameter; `None` from ℓ/π on, where the strands run around.
    pub fn angle_deg(self, diameter_mm: f64) -> Option<f64> {
        let sin = PI * diameter_mm / self.strand_length_per_turn_mm;
        (sin > 0.0 && sin < 1.0).then(|| sin.asin().to_degrees())
    }

    /// The diameter in mm at an angle: (ℓ/π) sinθ.
    pub fn diameter_mm(self, angle_deg: f64) -> f64 {
        self.strand_length_per_turn_mm / PI * angle_deg.to_radians().sin()
    }

    /// The diameters in mm at which strands that are n w wide together jam, least and largest;
    /// `None` where they are too wide for this helix at any diameter.
    pub fn jams_at(self, total_width_mm: f64) -> Option<(f64, f64)> {
        let angle = 0.5 * (total_width_mm / self.strand_length_per_turn_mm).asin();
        let scale = self.strand_length_per_turn_mm / PI;
        (angle > 0.0 && angle < FRAC_PI_4).then(|| (scale * angle.sin(), scale * angle.cos()))
    }

    /// n w in mm of strands that touch on a diameter: 2π D cosθ.
    pub fn width_that_jams_mm(self, diameter_mm: f64) -> Option<f64> {
        Some(2.0 * PI * diameter_mm * self.angle_deg(diameter_mm)?.to_radians().cos())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-12 * (1.0 + b.abs())
    }

    #[test]
    fn sine_of_the_angle_over_diameter_is_constant() {
        let helix = Helix::at(10.0, 30.0).unwrap();
        assert!(close(helix.strand_length_per_turn_mm(), 20.0 * PI));
        for d in [0.1, 5.0, 10.0, 14.0, 19.99] {
            let angle = helix.angle_deg(d).unwrap();
            assert!(close(angle.to_radians().sin() / d, 0.05), "{d}");
            assert!(close(helix.diameter_mm(angle), d));
        }
        assert_eq!(helix.angle_deg(20.01), None);
        assert_eq!(helix.angle_deg(f64::NAN), None);
    }

    /// The two jammed states have complementary angles and the same n w, and give the helix back.
    #[test]
    fn a_braid_jams_at_two_complementary_angles() {
        for (least, largest) in [(3.0, 10.0), (15.0, 35.0), (1.0, 1.01)] {
            let helix = Helix::jammed_at(least, largest).unwrap();
            let angles = [least, largest].map(|d| helix.angle_deg(d).unwrap());
            assert!(close(angles[0] + angles[1], 90.0), "{angles:?}");
            let width = helix.width_that_jams_mm(least).unwrap();
            assert!(close(width, helix.width_that_jams_mm(largest).unwrap()));
            let back = helix.jams_at(width * (1.0 - 1e-15)).unwrap();
            assert!(
                (back.0 - least).abs() < 1e-5 && (back.1 - largest).abs() < 1e-5,
                "{back:?}"
            );
            let from_least = Helix::jammed_at_least(least, width).unwrap();
            assert!(close(
                from_least.strand_length_per_turn_mm(),
                helix.strand_length_per_turn_mm()
            ));
        }
    }

    /// A 3-4-5 triangle by hand: D₁ 3, D₂ 4 give ℓ = 5π and n w = 2π·3·4/5.
    #[test]
    fn a_range_of_3_to_4_by_hand() {
        let helix = Helix::jammed_at(3.0, 4.0).unwrap();
        assert!(close(helix.strand_length_per_turn_mm(), 5.0 * PI));
        assert!(close(helix.width_that_jams_mm(3.0).unwrap(), 4.8 * PI));
        assert!(close(helix.angle_deg(3.0).unwrap(), 36.869_897_645_844_02));
    }

    /// The errors that the documentation states, by moving one end of the range.
    #[test]
    fn a_range_that_stops_short_of_jamming_makes_the_angle_too_large_by_what_is_stated() {
        let (least, largest, x) = (10.0, 30.0, 0.1);
        let true_helix = Helix::jammed_at(least, largest / (1.0 - x)).unwrap();
        let stated = Helix::jammed_at(least, largest).unwrap();
        let d = true_helix.diameter_mm(25.0);
        let more = stated.angle_deg(d).unwrap() - 25.0;
        let expected =
            (25f64.to_radians().tan() * x / (1.0 + (least / largest).powi(2))).to_degrees();
        assert!(
            more > 0.0 && (more / expected - 1.0).abs() < 0.15,
            "{more} against {expected}"
        );
        let true_helix = Helix::jammed_at(least * (1.0 - x), largest).unwrap();
        let less = stated.angle_deg(d).unwrap() - true_helix.angle_deg(d).unwrap();
        assert!(less < 0.0 && less.abs() < more / 5.0, "{less}");
    }

    #[test]
    fn what_is_no_helix_is_none() {
        for (d, angle) in [
            (0.0, 20.0),
            (-1.0, 20.0),
            (1.0, 0.0),
            (1.0, 90.0),
            (f64::INFINITY, 20.0),
            (1.0, f64::NAN),
        ] {
            assert_eq!(Helix::at(d, angle), None, "{d} {angle}");
        }
        assert_eq!(Helix::jammed_at(3.0, 3.0), None);
        assert_eq!(Helix::jammed_at(0.0, 3.0), None);
        assert_eq!(Helix::jammed_at(f64::NAN, 3.0), None);
        // 24 strands of 1 mm do not fit around 3 mm, and on no diameter of a helix of 20 mm.
        assert_eq!(Helix::jammed_at_least(3.0, 24.0), None);
        assert_eq!(Helix::at(3.0, 28.1).unwrap().jams_at(24.0), None);
    }
}
