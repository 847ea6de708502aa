//! Strands with crimp: woven over and under each other they straighten before they stretch.
//!
//! Force f of a family per width over its stiffness k, of the strain c = λf − 1:
//!
//!   f/k = κ c                                   c ≤ c1 − w
//!   f/k = κ c + (1 − κ)(c − c1 + w)²/(4w)       between
//!   f/k = κ c + (1 − κ)(c − c1)                 c ≥ c1 + w
//!
//! c1: strain at which the strands are straight; κ: stiffness before that, as a share of k; w =
//! c1/4: half of the width over which one slope becomes the other, so that force and tangent have
//! no jump. For c1 → 0 or κ → 1 it is f = k c.

/// Blend over crimp: w/c1.
const BLEND: f64 = 0.25;

/// What straightens in a strand before it stretches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crimp {
    /// c1: strain of the strands at which they are straight.
    pub strain: f64,
    /// κ: their stiffness before that, as a share of k; above 0, at most 1.
    pub stiffness_ratio: f64,
}

impl Crimp {
    /// κ where nothing is said.
    pub const STIFFNESS_RATIO: f64 = 0.1;

    /// Energy, force and tangent at a strain, each over k.
    #[inline]
    pub fn energy_and_slopes(&self, strain: f64) -> [f64; 3] {
        let kappa = self.stiffness_ratio;
        let width = BLEND * self.strain;
        let rest = 1.0 - kappa;
        let into = strain - self.strain + width;
        let beyond = strain - self.strain;
        let [energy, force, slope] = if into <= 0.0 {
            [0.0; 3]
        } else if beyond < width {
            [
                into * into * into / (12.0 * width),
                into * into / (4.0 * width),
                into / (2.0 * width),
            ]
        } else {
            [0.5 * beyond * beyond + width * width / 6.0, beyond, 1.0]
        };
        [
            0.5 * kappa * strain * strain + rest * energy,
            kappa * strain + rest * force,
            kappa + rest * slope,
        ]
    }

    /// Force over k at a strain, of strands with crimp or without.
    #[inline]
    pub fn force(crimp: Option<&Self>, strain: f64) -> f64 {
        crimp.map_or(strain, |crimp| crimp.energy_and_slopes(strain)[1])
    }

    /// The strain at a force over k.
    pub fn strain_at(&self, force: f64) -> f64 {
        let kappa = self.stiffness_ratio;
        let width = BLEND * self.strain;
        let rest = 1.0 - kappa;
        let low = self.strain - width;
        let straight = force + rest * self.strain;
        if force <= kappa * low {
            force / kappa
        } else if straight >= self.strain + width {
            straight
        } else {
            // κ (low + x) + (1 − κ) x²/(4w) = force, in x = c − low.
            let b = kappa;
            let a = rest / (4.0 * width);
            let left = force - kappa * low;
            low + 2.0 * left / (b + (b * b + 4.0 * a * left).sqrt())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CRIMP: Crimp = Crimp {
        strain: 0.01,
        stiffness_ratio: 0.1,
    };

    #[test]
    fn force_and_tangent_are_slopes_of_energy_and_force_by_central_differences() {
        let h = 1e-6;
        for i in -20..60 {
            let c = 4e-4 * f64::from(i) + 1e-5;
            let [_, f, t] = CRIMP.energy_and_slopes(c);
            let ([above, f_above, _], [below, f_below, _]) = (
                CRIMP.energy_and_slopes(c + h),
                CRIMP.energy_and_slopes(c - h),
            );
            assert!(((above - below) / (2.0 * h) - f).abs() < 1e-9, "{c}");
            assert!(((f_above - f_below) / (2.0 * h) - t).abs() < 1e-6, "{c}");
            assert!(
                (CRIMP.strain_at(f) - c).abs() < 1e-15 + 1e-12 * c.abs(),
                "{c}"
            );
        }
    }

    /// By hand: 1/2 of the blend at c1 adds (1 − κ) w/4; far beyond it the strain is short of the
    /// line by (1 − κ) c1.
    #[test]
    fn values_by_hand_and_the_limits_of_no_crimp() {
        let [_, middle, slope] = CRIMP.energy_and_slopes(0.01);
        assert!(
            (middle - (0.001 + 0.9 * 0.0025 / 4.0)).abs() < 1e-17 && (slope - 0.55).abs() < 1e-12
        );
        assert!((CRIMP.energy_and_slopes(0.05)[1] - (0.05 - 0.9 * 0.01)).abs() < 1e-15);
        for c in [-0.01, 0.001, 0.02] {
            let none = [0.5 * c * c, c, 1.0];
            for (crimp, off) in [
                (
                    Crimp {
                        stiffness_ratio: 1.0,
                        ..CRIMP
                    },
                    1e-16,
                ),
                (
                    Crimp {
                        strain: 1e-13,
                        ..CRIMP
                    },
                    if c < 0.0 { 1.0 } else { 1e-12 },
                ),
            ] {
                for (a, b) in crimp.energy_and_slopes(c).into_iter().zip(none) {
                    assert!((a - b).abs() <= off, "{crimp:?} {c}");
                }
            }
        }
    }
}
