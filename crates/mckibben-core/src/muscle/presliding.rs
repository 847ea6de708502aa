//! How friction builds up after a reversal.

use crate::by_number::ByNumber;

/// The presliding of a friction, with its memory: elements that stick and slip in parallel, all of
/// one stiffness, their yields spread evenly from 0 to x_s.
///
/// ```text
/// F_f = ∫₀¹ s(w) dw,   |s(w)| ≤ 2 w F_c,   ds = (2 F_m/x_s) dx where an element sticks
/// ```
///
/// An element slips where its limit is reached, by its way or because F_c falls with the pressure;
/// its stiffness does not follow F_c down, so that a closed cycle of position and pressure gives no
/// work. F_m is the largest F_c so far: while F_c rises above it the elements become stiffer under
/// the forces that they have, and lose energy. So x_s belongs to F_m, and x_s F_c/F_m to a lower F_c.
/// At a constant F_c, with z = F_f/F_c,
///
/// ```text
/// from rest at x₀:           z = ± g(|x − x₀|),          g(u) = 1 − (1 − u/x_s)² up to x_s, then 1
/// after a reversal at x_r:   z = z_r ± 2 g(|x − x_r|/2)
/// ```
///
/// The second rule is Masing's. A branch that comes back to the reversal before the last one closes
/// a loop, and goes on as if that loop had not been (Madelung's rule), at any speed. A loop of a
/// stroke S ≥ 2 x_s encloses 2 F_c (S − 4 x_s/3), a smaller one F_c S³/(6 x_s²). s(w) is a chain of
/// straight lines, whose ends are remembered: z has no steps of its slope but where a loop closes.
/// Sources: Iwan (1966) \[iwan1966\]; Al-Bender, Lampaert & Swevers (2005) \[al-bender2005\].
#[derive(Debug, Clone, PartialEq)]
pub struct Presliding {
    /// x_s in mm.
    length_mm: f64,
    /// x in mm.
    at_mm: f64,
    /// F_m.
    largest: f64,
    /// w and s, by rising w from 0 to 1.
    elements: Vec<(f64, f64)>,
}

/// A bend of s(w) below this share of F_m is none.
const STRAIGHT: f64 = 1e-12;
/// Of more bends the least is forgotten.
const BENDS: usize = 100;

impl Presliding {
    /// At a position in mm, after sliding towards `sign` with a friction of 1; at rest where that is
    /// 0.
    pub fn new(length_mm: f64, at_mm: f64, sign: f64) -> Self {
        Self {
            length_mm,
            at_mm,
            largest: sign.abs(),
            elements: vec![(0.0, 0.0), (1.0, 2.0 * sign)],
        }
    }

    /// What it remembers, as numbers.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        [self.at_mm, self.largest]
            .into_iter()
            .chain(self.elements.iter().flat_map(|&(w, s)| [w, s]))
    }

    /// The same with other things to remember, an even count of [numbers](Self::numbers).
    #[must_use]
    pub fn remembering(&self, numbers: &[f64]) -> Self {
        let mut pairs = numbers
            .chunks_exact(2)
            .filter_map(|pair| Some((*pair.first()?, *pair.last()?)));
        let (at_mm, largest) = pairs.next().unwrap_or((self.at_mm, self.largest));
        Self {
            length_mm: self.length_mm,
            at_mm,
            largest,
            elements: pairs.collect(),
        }
    }

    /// F_f at a position that is reached without a reversal, with F_c there.
    pub fn friction(&self, at_mm: f64, limit: f64) -> f64 {
        sum(&self.moved(at_mm, limit))
    }

    /// Goes to a position without a reversal on the way, with F_c there; the next way may be one.
    /// F_f there.
    pub fn go(&mut self, to_mm: f64, limit: f64) -> f64 {
        let mut elements = self.moved(to_mm, limit);
        self.at_mm = to_mm;
        self.largest = self.largest.max(limit);
        // By how much s(w) changes where a bend is left out.
        let bend = |three: &[(f64, f64)]| match *three {
            [(a, x), (b, y), (c, z)] => ((b - a) * (z - y) - (c - b) * (y - x)).abs(),
            _ => f64::INFINITY,
        };
        loop {
            let bends = elements.windows(3).map(bend).enumerate();
            match bends.min_by_number(|a| a.1) {
                Some((i, least)) if least <= STRAIGHT * self.largest || elements.len() > BENDS => {
                    elements.remove(i + 1);
                }
                _ => break,
            }
        }
        self.elements = elements;
        sum(&self.elements)
    }

    /// Goes to a position without a reversal on the way, at a constant F_c. z there.
    pub fn travel(&mut self, to_mm: f64) -> f64 {
        self.go(to_mm, 1.0)
    }

    /// s(w) at a position, cut by the limits.
    fn moved(&self, at_mm: f64, limit: f64) -> Vec<(f64, f64)> {
        let stretch = 2.0 * self.largest.max(limit) / self.length_mm * (at_mm - self.at_mm);
        let most = 2.0 * limit.max(0.0);
        let stretched = self.elements.iter().map(|&(w, s)| (w, s + stretch));
        let mut out = vec![(0.0, 0.0)];
        for ((v, r), (w, s)) in stretched.clone().zip(stretched.skip(1)) {
            // The shares of the way from v to w at which s(w) reaches a limit.
            let mut cuts = [most, -most].map(|limit| {
                let excess = r - limit * v;
                excess / (excess - s + limit * w)
            });
            cuts.sort_by(f64::total_cmp);
            let cuts = cuts.into_iter().filter(|cut| *cut > 0.0 && *cut < 1.0);
            out.extend(cuts.map(|cut| (v + cut * (w - v), r + cut * (s - r))));
            out.push((w, s));
        }
        for (w, s) in &mut out {
            *s = s.clamp(-most * *w, most * *w);
        }
        out
    }
}

/// ∫ s dw.
fn sum(elements: &[(f64, f64)]) -> f64 {
    elements
        .iter()
        .zip(elements.iter().skip(1))
        .map(|((v, r), (w, s))| 0.5 * (w - v) * (r + s))
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTH_MM: f64 = 0.8;

    impl Presliding {
        /// z at a position that is reached without a reversal, at a constant F_c.
        fn share(&self, at_mm: f64) -> f64 {
            self.friction(at_mm, 1.0)
        }
    }

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

    /// Elements one by one, of one stiffness and with limits that follow F_c: our friction is theirs
    /// in steps of position and pressure.
    #[test]
    fn identity_limits_that_move_are_those_of_single_elements() {
        let mut random = crate::random::Random(13);
        let mut elements = vec![0.0_f64; 4000];
        let mut ours = Presliding::new(LENGTH_MM, 0.0, 0.0);
        let (mut x, mut largest) = (0.0, 0.0_f64);
        for i in 0..400 {
            let to = random.between(-1.0, 1.0) * LENGTH_MM;
            let limit = random.between(0.0, 50.0);
            let stiffer = 2.0 * largest.max(limit) / LENGTH_MM;
            largest = largest.max(limit);
            for (k, s) in (0..).zip(&mut elements) {
                let most = 2.0 * limit * (f64::from(k) + 0.5) / 4e3;
                *s = (*s + stiffer * (to - x)).clamp(-most, most);
            }
            x = to;
            let theirs = elements.iter().sum::<f64>() / 4e3;
            let friction = ours.go(to, limit);
            assert!((friction - theirs).abs() < 1e-4, "{i}: {friction} {theirs}");
        }
    }

    /// Closed cycles of position and pressure of random amplitudes and phases, the pressure at once,
    /// twice or three times the frequency: none gives work. Of F_c z with z of the position alone
    /// one in ten does.
    #[test]
    fn bound_no_cycle_of_position_and_pressure_gives_work() {
        let mut random = crate::random::Random(2);
        let cycles = crate::random::rounds(400);
        let mut old_gives = 0;
        for _ in 0..cycles {
            let stroke = LENGTH_MM * 10f64.powf(random.between(-2.0, 0.5));
            let (swing, phase) = (random.between(0.0, 1.0), random.between(0.0, 6.3));
            let times = random.one_of(&[1.0, 2.0, 3.0]);
            let mut ours = Presliding::new(LENGTH_MM, 0.0, 0.0);
            let mut shares = Presliding::new(LENGTH_MM, 0.0, 0.0);
            let (mut works, mut old) = ([0.0; 3], 0.0);
            let (mut x, mut before, mut old_before) = (0.0, 0.0, 0.0);
            for work in &mut works {
                old = 0.0;
                for i in 0..800 {
                    let turn = std::f64::consts::TAU * f64::from(i) / 800.0;
                    let to = stroke * turn.sin();
                    let limit = 60.0 * (0.5 + 0.5 * swing * (times * turn + phase).sin());
                    let friction = ours.go(to, limit);
                    let of_share = limit * shares.travel(to);
                    *work += 0.5 * (friction + before) * (to - x);
                    old += 0.5 * (of_share + old_before) * (to - x);
                    (x, before, old_before) = (to, friction, of_share);
                }
            }
            let rounding = 1e-5 * 60.0 * stroke;
            assert!(
                works[2] > -rounding,
                "{works:?}: {stroke} {swing} {phase} {times}"
            );
            old_gives += usize::from(old < -rounding);
        }
        assert!(old_gives > cycles / 20, "{old_gives} of {cycles}");
    }
}
