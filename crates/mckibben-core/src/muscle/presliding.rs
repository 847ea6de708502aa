//! How friction builds up after a reversal.

/// The presliding of a friction, with its memory: elements that stick and slip in parallel, all of
/// one stiffness, their yields spread evenly from 0 to x_s.
///
/// ```text
/// F_f = F_c z,   −1 ≤ z ≤ 1,   z opposes shortening x
/// from rest at x₀:           z = ± g(|x − x₀|),          g(u) = 1 − (1 − u/x_s)² up to x_s, then 1
/// after a reversal at x_r:   z = z_r ± 2 g(|x − x_r|/2)
/// ```
///
/// The second rule is Masing's. A branch that comes back to the reversal before the last one closes
/// a loop, and goes on as if that loop had not been (Madelung's rule): z depends on the reversals
/// that are remembered and on x alone, at any speed. At a constant F_c a loop of a stroke S ≥ 2 x_s
/// encloses 2 F_c (S − 4 x_s/3), a smaller one F_c S³/(6 x_s²); no loop gives work. Infinitely many
/// elements in closed form: z has no steps of its slope but where a loop closes. Sources: Iwan
/// (1966) \[iwan1966\]; Al-Bender, Lampaert & Swevers (2005) \[al-bender2005\].
#[derive(Debug, Clone, PartialEq)]
pub struct Presliding {
    /// x_s in mm.
    length_mm: f64,
    /// x in mm and z where it began, and at each reversal that is remembered.
    turns: Vec<(f64, f64)>,
}

impl Presliding {
    /// At a position in mm, after sliding towards `sign`; at rest where that is 0.
    pub fn new(length_mm: f64, at_mm: f64, sign: f64) -> Self {
        let mut presliding = Self {
            length_mm,
            turns: vec![(at_mm - sign * length_mm, 0.0)],
        };
        presliding.travel(at_mm);
        presliding
    }

    /// What it remembers, as numbers.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        self.turns.iter().flat_map(|&(x, z)| [x, z])
    }

    /// The same with other things to remember, an even count of [numbers](Self::numbers).
    #[must_use]
    pub fn remembering(&self, numbers: &[f64]) -> Self {
        let turns = numbers
            .chunks_exact(2)
            .filter_map(|turn| Some((*turn.first()?, *turn.last()?)));
        Self {
            length_mm: self.length_mm,
            turns: turns.collect(),
        }
    }

    /// z at a position that is reached without a reversal.
    pub fn share(&self, at_mm: f64) -> f64 {
        self.branch(at_mm).1
    }

    /// Goes to a position without a reversal on the way; the next way may be one. z there.
    pub fn travel(&mut self, to_mm: f64) -> f64 {
        let (remembered, z) = self.branch(to_mm);
        self.turns.truncate(remembered);
        self.turns.push((to_mm, z));
        z
    }

    /// How many turns are remembered at a position, and z.
    fn branch(&self, x: f64) -> (usize, f64) {
        let mut turns = self.turns.as_slice();
        while let [earlier @ .., (before, _), (turn, _)] = turns {
            let leg = turn - before;
            let way = x - turn;
            // The curve from rest is half as wide as one after a reversal.
            let closing = if earlier.is_empty() { 2.0 * leg } else { leg };
            let is_reversal = way * leg < 0.0;
            if is_reversal && way.abs() < closing.abs() {
                break;
            }
            let forgotten = if is_reversal && !earlier.is_empty() {
                2
            } else {
                1
            };
            turns = turns.get(..turns.len() - forgotten).unwrap_or_default();
        }
        let (from, z) = turns.last().copied().unwrap_or_default();
        let way = x - from;
        let width = if turns.len() > 1 { 2.0 } else { 1.0 };
        let sticking = (1.0 - way.abs() / (width * self.length_mm)).max(0.0);
        (
            turns.len(),
            z + width * (1.0 - sticking * sticking).copysign(way),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTH_MM: f64 = 0.8;

    /// Against the elements one by one: each sticks until it is stretched by its yield.
    #[test]
    fn identity_the_closed_form_is_many_elements_that_stick_and_slip() {
        let mut elements =
            Vec::from_iter((0..4000).map(|i| (LENGTH_MM * (f64::from(i) + 0.5) / 4e3, 0.0)));
        let mut ours = Presliding::new(LENGTH_MM, 0.0, 0.0);
        for i in 0..300 {
            let x =
                ((0.618 * f64::from(i * i)).fract() - 0.5) * LENGTH_MM * f64::from(1 + i / 20 % 3);
            let mut sum = 0.0;
            for (length, end) in &mut elements {
                *end = f64::clamp(*end, x - *length, x + *length);
                sum += 2.0 * (x - *end) / LENGTH_MM / 4e3;
            }
            let z = ours.travel(x);
            assert!((z - sum).abs() < 1e-6 && z.abs() <= 1.0, "{i}: {z} {sum}");
        }
    }

    /// ∫ z dx from turn to turn, by Simpson's rule.
    fn work(at: &mut Presliding, turns: &[f64]) -> f64 {
        let mut sum = 0.0;
        for turn in turns.windows(2) {
            let h = (turn[1] - turn[0]) / 200.0;
            let z = |i: i32| at.share(turn[0] + h * f64::from(i));
            sum += (1..200)
                .step_by(2)
                .map(|i| h / 3.0 * (z(i - 1) + 4.0 * z(i) + z(i + 1)))
                .sum::<f64>();
            at.travel(turn[1]);
        }
        sum
    }

    /// The first curve, and loops of a small and of a large stroke.
    #[test]
    fn closed_form_first_curve_and_work_of_loops() {
        let mut at = Presliding::new(LENGTH_MM, 3.0, 0.0);
        let curve = Vec::from_iter((0..=80).map(|i| at.share(3.0 + 0.01 * f64::from(i))));
        assert!(
            curve.windows(2).all(|w| w[0] < w[1])
                && curve[0] == 0.0
                && (curve[80] - 1.0).abs() < 1e-12
        );
        for (stroke, exact) in [
            (0.5_f64, 0.5_f64.powi(3) / (6.0 * 0.64)),
            (4.0, 8.0 - 32.0 / 15.0),
        ] {
            at.travel(2.6);
            at.travel(2.6 + stroke);
            let area = work(&mut at, &[2.6 + stroke, 2.6, 2.6 + stroke]);
            assert!((area - exact).abs() < 1e-12, "{area} {exact}");
        }
    }

    /// Return-point memory: loops inside each other close, in steps of any length, take work and
    /// leave no trace; those of one stroke are congruent whatever was before.
    #[test]
    fn identity_minor_loops_close_and_are_congruent() {
        let inside = |start: &Presliding, from: f64, stroke: f64| -> Vec<f64> {
            let (mut at, z) = (start.clone(), |way: f64| {
                start.share(from + way) - start.share(from)
            });
            let mut turns =
                Vec::from([0.0, 1.0, 0.3, 0.9, 0.35, 0.55, 0.4].map(|s| from + stroke * s));
            turns.extend((0..=8).rev().map(|i| from + stroke * f64::from(i) / 8.0));
            assert!(work(&mut at, &turns) > 0.0);
            for onward in [0.0, -0.1 * stroke, -3.0 * stroke] {
                assert!((at.share(from + onward) - start.share(from + onward)).abs() < 1e-12);
            }
            (0..8).map(|i| z(stroke * f64::from(i) / 8.0)).collect()
        };
        let mut slid = Presliding::new(LENGTH_MM, 0.0, 1.0);
        let mut stuck = slid.clone();
        assert!(slid.travel(-2.0) == -1.0 && stuck.travel(-0.5).abs() < 0.3);
        let (one, other) = (inside(&slid, -2.0, 0.4), inside(&stuck, -0.5, 0.4));
        assert!(
            one.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-12),
            "{one:?} {other:?}"
        );
        stuck.travel(0.3);
        inside(&stuck, 0.3, -0.7);
    }
}
