//! Lines through few points, drawn without visible corners.
//!
//! Between neighbours x_i, x_{i+1} of a function y(x) the line is y = chord + D (x − x_i)(x −
//! x_{i+1}), D the second divided difference, linear between those at both ends: the cubic through
//! four points. Where D changes its sign or by more than `ALIKE`, at a corner or a jump, the
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
    let mut seconds: Vec<f64> = run
        .windows(3)
        .map(|p| second_difference(p[0], p[1], p[2]))
        .collect();
    // The first and last piece go on as their neighbour does.
    let n = seconds.len();
    let [first, last] = [[0, 1], [n - 1, n - 2]].map(|[i, j]| 2.0 * seconds[i] - seconds[j]);
    seconds.insert(0, first);
    seconds.push(last);
    let mut out = Vec::with_capacity(2 * run.len());
    for (pair, ends) in run.windows(2).zip(seconds.windows(2)) {
        let ([a, b], [d, e]) = ([pair[0], pair[1]], [ends[0], ends[1]]);
        out.push(a);
        if !alike(d, e) {
            continue;
        }
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
