//! How friction builds up after a reversal.

/// A share of the friction, and the length over which it builds up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PreslidingElement {
    /// sᵢ (–).
    pub share: f64,
    /// xᵢ in mm.
    pub length_mm: f64,
}

/// Elements with history side by side, in series with the level F_c of the [`Friction`](super::Friction).
///
/// ```text
/// F_f = F_c Σ sᵢ zᵢ,   dzᵢ/dx = (1 − zᵢ sgn ẋ)/xᵢ,   Σ sᵢ = 1,   −1 ≤ zᵢ ≤ 1
/// ```
///
/// F_f opposes shortening x; each element is Dahl's. Closed forms at a constant F_c: from z = 0 on F_f/F_c = 1 − Σ sᵢ e^(−x/xᵢ); after a
/// reversal in full sliding twice that, −1 + 2 Σ sᵢ e^(−x/xᵢ); cycles of a stroke S tend to a closed loop with zᵢ = ± tanh(S/2xᵢ) at its
/// ends, which encloses 2 F_c Σ sᵢ (S − 2 xᵢ tanh(S/2xᵢ)). An element tends to that loop by e^(−2S/xᵢ) a cycle; until then a minor loop
/// drifts, as Dahl's equation is known to. Elements with shares are those of Maxwell-slip models, with a smooth transition to sliding.
/// Source: Dahl (1976) \[dahl1976\].
#[derive(Debug, Clone, PartialEq)]
pub struct Presliding(pub Vec<PreslidingElement>);

impl Default for Presliding {
    /// 0.5 mm, where nothing is stated.
    fn default() -> Self {
        Self::from_length(0.5)
    }
}

impl Presliding {
    /// One element.
    pub fn from_length(length_mm: f64) -> Self {
        Self(vec![PreslidingElement { share: 1.0, length_mm }])
    }

    /// Σ sᵢ zᵢ.
    pub fn share(&self, states: &[f64]) -> f64 {
        self.0.iter().zip(states).map(|(element, z)| element.share * z).sum()
    }

    /// The states after a shortening (below zero: a lengthening) without reversal.
    pub fn travel(&self, states: &mut [f64], shortening_mm: f64) {
        for (element, z) in self.0.iter().zip(states) {
            *z -= (shortening_mm.signum() - *z) * (-shortening_mm.abs() / element.length_mm).exp_m1();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Virgin curve, reversal and the closed loop after some cycles, by the closed forms.
    #[test]
    fn elements_follow_their_closed_forms() {
        let two = Presliding(vec![
            PreslidingElement { share: 0.6, length_mm: 0.5 },
            PreslidingElement { share: 0.4, length_mm: 3.0 },
        ]);
        let sum = |of: &dyn Fn(f64) -> f64| 0.6 * of(0.5) + 0.4 * of(3.0);
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        let mut z = [0.0; 2];
        for _ in 0..7 {
            two.travel(&mut z, 0.1);
        }
        near(two.share(&z), 1.0 - sum(&|x| (-0.7 / x).exp()));
        two.travel(&mut z, 200.0);
        two.travel(&mut z, -1.3);
        near(two.share(&z), -1.0 + 2.0 * sum(&|x| (-1.3 / x).exp()));
        for _ in 0..40 {
            two.travel(&mut z, 2.0);
            two.travel(&mut z, -2.0);
        }
        near(two.share(&z), -sum(&|x| (1.0 / x).tanh()));
        // No way, no change.
        let before = z;
        two.travel(&mut z, 0.0);
        assert_eq!(z, before);
    }
}
