//! How the angle of a joint shortens a muscle or a spring.

/// The way of a muscle (with its rope) or a spring about a joint in a plane.
///
/// Δ(φ) is how far it is shortened against the neutral angle φ = 0, in mm; dΔ/dφ is its moment arm,
/// positive where a pull turns the joint to +. By virtual work its torque is F dΔ/dφ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// Over a pulley: Δ = r φ. A negative radius winds it on the other side.
    Pulley {
        /// r in mm.
        radius_mm: f64,
    },
    /// Between a point a of the fixed link and a point c of the moving one; the axis is the origin,
    /// x and y in mm at φ = 0, angles counterclockwise. l² = |a|² + |c|² − 2 a·R(φ)c, Δ = l(0) −
    /// l(φ).
    Points {
        /// a
        origin_mm: [f64; 2],
        /// c
        insertion_mm: [f64; 2],
    },
}

/// Δ with its derivatives in φ (radians).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shortening {
    /// Δ in mm.
    pub mm: f64,
    /// dΔ/dφ in mm: the moment arm.
    pub arm_mm: f64,
    /// d²Δ/dφ² in mm.
    pub arm_by_angle_mm: f64,
}

impl Path {
    /// Δ at an angle; not finite where both points meet.
    #[doc(hidden)]
    pub fn shortening(&self, angle_rad: f64) -> Shortening {
        match *self {
            Self::Pulley { radius_mm } => Shortening {
                mm: radius_mm * angle_rad,
                arm_mm: radius_mm,
                arm_by_angle_mm: 0.0,
            },
            Self::Points {
                origin_mm: a,
                insertion_mm: c,
            } => {
                let now = turned(c, angle_rad);
                let length = self.length_mm(angle_rad);
                // l l′ = −a·c′ with c′ = (−y, x); l l″ = a·c − l′²
                let slope = (a[0] * now[1] - a[1] * now[0]) / length;
                let second = (a[0] * now[0] + a[1] * now[1] - slope * slope) / length;
                Shortening {
                    mm: self.length_mm(0.0) - length,
                    arm_mm: -slope,
                    arm_by_angle_mm: -second,
                }
            }
        }
    }

    /// Distance of both points in mm; of a pulley only its change is known, and this is nil.
    pub fn length_mm(&self, angle_rad: f64) -> f64 {
        match *self {
            Self::Pulley { .. } => 0.0,
            Self::Points {
                origin_mm: a,
                insertion_mm: c,
            } => {
                let now = turned(c, angle_rad);
                (a[0] - now[0]).hypot(a[1] - now[1])
            }
        }
    }
}

/// A point that turns about the joint.
fn turned([x, y]: [f64; 2], angle_rad: f64) -> [f64; 2] {
    let (sin, cos) = angle_rad.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arms_are_the_slopes_of_the_shortening() {
        let paths = [
            Path::Pulley { radius_mm: -25.0 },
            Path::Points {
                origin_mm: [-20.0, 250.0],
                insertion_mm: [30.0, 12.0],
            },
            Path::Points {
                origin_mm: [15.0, -180.0],
                insertion_mm: [-25.0, 5.0],
            },
        ];
        for path in paths {
            for angle in [-1.1, -0.3, 0.0, 0.4, 1.2] {
                let h = 1e-5;
                let (s, before, after) = (
                    path.shortening(angle),
                    path.shortening(angle - h),
                    path.shortening(angle + h),
                );
                assert!(
                    (s.arm_mm - (after.mm - before.mm) / (2.0 * h)).abs() < 1e-7,
                    "{path:?} {angle}"
                );
                let second = (after.arm_mm - before.arm_mm) / (2.0 * h);
                assert!(
                    (s.arm_by_angle_mm - second).abs() < 1e-6,
                    "{path:?} {angle}"
                );
            }
        }
    }

    /// A crank: with a = (0, h) and c = (r, 0) at φ = 0, l² = h² + r² − 2 h r sin φ; the arm at 0
    /// is h r/√(h² + r²).
    #[test]
    fn the_arm_of_a_crank_is_that_of_the_triangle() {
        let path = Path::Points {
            origin_mm: [0.0, 240.0],
            insertion_mm: [70.0, 0.0],
        };
        assert!((path.length_mm(0.0) - 250.0).abs() < 1e-12);
        assert!((path.shortening(0.0).arm_mm - 240.0 * 70.0 / 250.0).abs() < 1e-12);
    }
}
