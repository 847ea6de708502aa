//! How far a muscle stretches its rubber.

use super::{Braid, Muscle, NEUTRAL_ANGLE_DEG, Parts, Tube};

/// Largest principal stretch of the rubber of a tube in a braid, from rest to the free contraction
/// of the ideal muscle: strands that do not stretch, at θ = 54.7° (cos²θ = 1/3), where no pressure
/// contracts it further.
///
///   λz = cos54.7°/cosθ0 = 1/(√3 cosθ0),   ro = Ro sin54.7°/sinθ0,   ri² = ro² − (Ro² − Ri²)/λz,   λ = ri/Ri
///
/// Ro, Ri: radii of the tube at rest; ro, ri: those of the contracted one, whose wall keeps its
/// volume; θ0: angle of the strands to the axis at rest; braids of some thickness and wide sleeves
/// as [`StrandLay`](super::StrandLay) has them. λ is the hoop stretch at the bore, which is the
/// largest: the wall grows thinner on its way out, so that ri/Ri ≥ ro/Ro. For a thin wall it is
/// sin54.7°/sinθ0. It follows from the measures alone, not from a pressure. Of a tube that was
/// mounted with a stretch λp it is ri/(Ri √λp), or λp where that is more.
pub fn largest_stretch(tube: &Tube, braid: &Braid) -> f64 {
    let (sin, cos) = braid.angle_rad().sin_cos();
    let (sin_neutral, cos_neutral) = NEUTRAL_ANGLE_DEG.to_radians().sin_cos();
    let outer = tube.outer_radius_mm();
    let inner = tube.inner_radius_mm();
    let lay = braid.lay(tube);
    let axial = cos_neutral / cos;
    let bore =
        lay.outer_radius_mm(sin_neutral / sin).powi(2) - (outer * outer - inner * inner) / axial;
    // Before it was mounted the bore was wider by √λp, and at rest the tube is as long as λp. A
    // muscle that extends is longest at 54.7°.
    (bore.max(0.0).sqrt() / (inner * tube.prestretch.sqrt())).max(tube.prestretch * axial.max(1.0))
}

impl Parts {
    /// [`largest_stretch`] of a muscle of these parts.
    pub(super) fn reach(&self) -> f64 {
        largest_stretch(&self.tube, &self.braid)
    }
}

impl Muscle {
    /// Largest principal stretch that its rubber reaches: [`largest_stretch`].
    pub fn reach(&self) -> f64 {
        self.parts.reach()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reach(outer_diameter_mm: f64, wall_mm: f64, angle_deg: f64) -> f64 {
        let tube = Tube {
            outer_diameter_mm,
            wall_mm,
            ..Tube::prototype()
        };
        largest_stretch(
            &tube,
            &Braid {
                angle_deg,
                ..Braid::paper()
            },
        )
    }

    /// The limit of a thin wall: the strands turn from θ0 to 54.7°, sin54.7° = √(2/3).
    #[test]
    fn of_a_thin_wall_it_is_the_ratio_of_the_sines() {
        for angle in [15.0_f64, 20.0, 28.0, 40.0, 54.0] {
            let thin = (2.0_f64 / 3.0).sqrt() / angle.to_radians().sin();
            assert!(
                (reach(30.0, 1e-7, angle) / thin - 1.0).abs() < 1e-6,
                "{angle}"
            );
        }
    }

    /// The volume of the wall, π (Ro² − Ri²) L0, is that of the contracted wall; and the prototype
    /// by hand: λz 0.65389, ro 26.0877, ri 23.5944 mm.
    #[test]
    fn the_wall_keeps_its_volume() {
        assert!(
            (reach(30.0, 3.0, 28.0) - 23.5944 / 12.0).abs() < 1e-4,
            "{}",
            reach(30.0, 3.0, 28.0)
        );
        for (d0, s, angle) in [(30.0, 3.0, 28.0), (20.0, 6.0, 20.0), (50.0, 1.0, 35.0)] {
            let (ro, ri) = (0.5 * d0, 0.5 * d0 - s);
            let angle_rad = f64::to_radians(angle);
            let length = 1.0 / (3f64.sqrt() * angle_rad.cos());
            let outer = ro * (2.0_f64 / 3.0).sqrt() / angle_rad.sin();
            let inner = ri * reach(d0, s, angle);
            let before = ro * ro - ri * ri;
            assert!(((outer * outer - inner * inner) * length / before - 1.0).abs() < 1e-12);
        }
    }

    /// Of three principal stretches λθ at the bore is the largest, at any angle: none is below it
    /// anywhere in the wall.
    #[test]
    fn no_other_stretch_of_the_wall_is_larger() {
        for angle in 5..=54 {
            let (outer, bore) = (
                reach(30.0, 1e-9, f64::from(angle)),
                reach(30.0, 4.0, f64::from(angle)),
            );
            let axial = 1.0 / (3f64.sqrt() * f64::from(angle).to_radians().cos());
            assert!(bore >= outer - 1e-9 && outer >= 1.0, "{angle}");
            assert!(bore >= 1.0 / (outer * axial), "{angle}");
        }
    }
}
