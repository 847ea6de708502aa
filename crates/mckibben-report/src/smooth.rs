//! Lines through few points, drawn without visible corners.
//!
//! Between neighbours x_i, x_{i+1} of a function y(x) the line is y = chord + D (x − x_i)(x −
//! x_{i+1}), D the second divided difference, linear between those at both ends: the cubic through
//! four points. Where D changes its sign or by more than [`ALIKE`], at a corner or a jump, the
//! chord is kept; the ends of a line are straight where they have one neighbour only.

use crate::rect::Spot;

/// A chord may be this far from the line, in units of the drawing.
const FACET: f64 = 0.1;
/// A chord that is further off is not one of a smooth line.
const MOST: f64 = 4.0;
/// Second differences at both ends of a smooth piece differ by less than this factor.
const ALIKE: f64 = 3.0;

/// The spots of a run, with more between them where the line is curved.
pub fn smooth(run: &[Spot]) -> Vec<Spot> {
    let rises = run.windows(2).all(|p| p[1].0 > p[0].0);
    let falls = run.windows(2).all(|p| p[1].0 < p[0].0);
    if run.len() < 4 || !(rises || falls) {
        return run.to_vec();
    }
    let seconds: Vec<f64> = run
        .windows(3)
        .map(|p| second_difference(p[0], p[1], p[2]))
        .collect();
    // At the spot `i`; the two ends have none.
    let at = |i: usize| i.checked_sub(1).and_then(|i| seconds.get(i)).copied();
    let mut out = Vec::with_capacity(2 * run.len());
    for (i, pair) in run.windows(2).enumerate() {
        let a = pair[0];
        let b = pair[1];
        out.push(a);
        // The first and last piece go on as their neighbour does.
        let ends = match (at(i), at(i + 1)) {
            (Some(d), Some(e)) => Some((d, e)),
            (None, Some(e)) => at(i + 2).map(|next| (2.0 * e - next, e)),
            (Some(d), None) => i
                .checked_sub(1)
                .and_then(at)
                .map(|before| (d, 2.0 * d - before)),
            (None, None) => None,
        };
        let Some((d, e)) = ends.filter(|(d, e)| alike(*d, *e)) else {
            continue;
        };
        let off = 0.125 * (d + e).abs() * (b.0 - a.0).powi(2);
        if !(FACET..MOST).contains(&off) {
            continue;
        }
        let parts = (off / FACET).sqrt().ceil() as usize + 1;
        out.extend((1..parts).map(|k| {
            let s = k as f64 / parts as f64;
            let x = a.0 + s * (b.0 - a.0);
            let curved = (d + s * (e - d)) * (x - a.0) * (x - b.0);
            (x, a.1 + s * (b.1 - a.1) + curved)
        }));
    }
    out.extend(run.last());
    out
}

/// Half the second derivative of the parabola through three spots.
fn second_difference(a: Spot, b: Spot, c: Spot) -> f64 {
    let slope = |p: Spot, q: Spot| (q.1 - p.1) / (q.0 - p.0);
    (slope(b, c) - slope(a, b)) / (c.0 - a.0)
}

fn alike(d: f64, e: f64) -> bool {
    let low = d.abs().min(e.abs());
    let high = d.abs().max(e.abs());
    d * e > 0.0 && high <= ALIKE * low
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest distance of the drawn line from a function, in y.
    fn off(spots: &[Spot], function: impl Fn(f64) -> f64) -> f64 {
        let between = |p: &[Spot], s: f64| {
            (
                p[0].0 + s * (p[1].0 - p[0].0),
                p[0].1 + s * (p[1].1 - p[0].1),
            )
        };
        let all = spots
            .windows(2)
            .flat_map(|p| (0..=10).map(move |k| between(p, f64::from(k) / 10.0)));
        all.map(|(x, y)| (y - function(x)).abs())
            .fold(0.0, f64::max)
    }

    fn sampled(places: &[f64], function: impl Fn(f64) -> f64) -> Vec<Spot> {
        places.iter().map(|x| (*x, function(*x))).collect()
    }

    /// Exact: the cubic through four points of a parabola or a cubic is that; its error is that of
    /// chords of a part of the way.
    #[test]
    fn parabolas_and_cubics_have_no_facets_at_any_spacing() {
        let places = [
            0.0, 55.0, 100.0, 160.0, 240.0, 300.0, 380.0, 450.0, 520.0, 600.0,
        ];
        let parabola = |x: f64| 400.0 - (600.0 - x).powi(2) / 900.0;
        let cubic = |x: f64| 100.0 + (x - 700.0).powi(3) / 1e6;
        for of in [parabola, cubic] {
            let chords = sampled(&places, of);
            assert!(off(&chords, of) > 0.5);
            assert!(
                off(&smooth(&chords), of) < 0.2,
                "{}",
                off(&smooth(&chords), of)
            );
            let back: Vec<Spot> = chords.iter().rev().copied().collect();
            assert!(off(&smooth(&back), of) < 0.2);
        }
    }

    #[test]
    fn corners_jumps_loops_and_straight_lines_are_kept() {
        let places: Vec<f64> = (0..12).map(|i| 20.0 * f64::from(i)).collect();
        let corner = sampled(&places, |x| (x - 100.0).abs());
        let jump = sampled(&places, |x| if x < 90.0 { 10.0 } else { 60.0 });
        let line = sampled(&places, |x| 3.0 * x);
        let round: Vec<Spot> = places
            .iter()
            .map(|x| ((x / 20.0).cos() * 50.0, (x / 20.0).sin() * 50.0))
            .collect();
        for run in [
            corner,
            jump,
            line,
            round,
            vec![],
            vec![(0.0, 1.0), (1.0, 4.0), (2.0, 9.0)],
        ] {
            assert_eq!(smooth(&run), run);
        }
    }

    /// A parabola that ends at zero and goes on flat, as a pull where a muscle becomes slack:
    /// nothing is drawn beyond the corner.
    #[test]
    fn beside_a_corner_the_chord_is_kept() {
        let places: Vec<f64> = (0..21).map(|i| 30.0 * f64::from(i)).collect();
        let run = sampled(&places, |x| {
            if x < 400.0 {
                (400.0 - x).powi(2) / 400.0 + (400.0 - x) / 5.0
            } else {
                0.0
            }
        });
        let drawn = smooth(&run);
        assert!(drawn.len() > run.len() && drawn.iter().all(|s| s.1 >= 0.0));
        assert!(
            drawn
                .iter()
                .filter(|s| s.0 > 390.0)
                .all(|s| run.contains(s))
        );
    }
}
