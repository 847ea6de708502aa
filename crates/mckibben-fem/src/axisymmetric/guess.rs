//! First iterates for a muscle that was never looked at.
//!
//! Tensions and pressures of the ideal muscle, q = P Ro λ/(2 sin²θ0) and p = −P: without them the first tangent would
//! lack the very stiffness that holds the tube. And a shape: the outer line keeps the length of its strands,
//!
//!   λm² = (λf² − sin²θ0 λθ²)/cos²θ0,   r = Ro [1 + b (1 − e^(−(L0/2 − Z)/ℓ))],   z' = √(λm² − r'²),
//!
//! with the bulge b that brings the terminal to its place; the wall behind it keeps its volume. Where the strands of the
//! infinitely long muscle are slack there is no tension, and the bulge is the infinitely long muscle's.

use super::discretisation::{BraidSpec, Discretisation};
use crate::element::strand::STRAND_POINTS;
use crate::solver::body::State;
use mckibben::muscle::StrandLay;

/// ℓ over the outer radius.
const LAYER: f64 = 1.4;
/// Steps of integration per station.
const STEPS: usize = 4;

/// Tensions and pressures of the ideal muscle.
pub(super) fn loads(d: &Discretisation, state: &mut State, stretch: f64) {
    let Some(BraidSpec { lay, .. }) = d.problem.braid else { return };
    let q = tension(d, lay.angle_rad, state.pressure) * stretch;
    state.q.fill(q);
    let l = d.layout;
    for slab in 0..l.along {
        for i in 0..l.through {
            state.u[l.pressure(slab, i)] = -state.pressure;
        }
        if l.multipliers {
            let at = l.tension(slab);
            state.u[at..at + STRAND_POINTS].fill(q);
        }
    }
}

fn tension(d: &Discretisation, angle_rad: f64, pressure: f64) -> f64 {
    0.5 * pressure * d.radius / angle_rad.sin().powi(2)
}

/// The outer line for a bulge b.
struct Line {
    lay: StrandLay,
    sin2: f64,
    cos2: f64,
    strand2: f64,
    radius: f64,
    half: f64,
    layer: f64,
    bulge: f64,
}

impl Line {
    /// r and r' at Z.
    fn radius(&self, z: f64) -> (f64, f64) {
        let fall = (-(self.half - z) / self.layer).exp();
        (self.radius * (1.0 + self.bulge * (1.0 - fall)), -self.radius * self.bulge * fall / self.layer)
    }

    /// z' and λm at Z.
    fn slope(&self, z: f64) -> (f64, f64) {
        let (r, dr) = self.radius(z);
        let hoop = self.lay.hoop_stretch(r);
        let meridian2 = ((self.strand2 - self.sin2 * hoop * hoop) / self.cos2).max(0.01);
        ((meridian2 - dr * dr).max(0.09 * meridian2).sqrt(), meridian2.sqrt())
    }

    /// z from `from` to `to` by Simpson's rule.
    fn advance(&self, from: f64, to: f64) -> f64 {
        let h = (to - from) / STEPS as f64;
        (0..STEPS)
            .map(|i| {
                let z = from + h * i as f64;
                h / 6.0 * (self.slope(z).0 + 4.0 * self.slope(z + 0.5 * h).0 + self.slope(z + h).0)
            })
            .sum()
    }
}

/// Fills the displacements of `state`, whose pressure is set, for a displacement of the terminal and, where the strands
/// are slack, the outer radius in the middle; `false` where no bulge brings the terminal there.
pub(super) fn shape(d: &Discretisation, state: &mut State, terminal: f64, slack: Option<f64>) -> bool {
    let Some(BraidSpec { lay, stiffness, .. }) = d.problem.braid else { return false };
    let angle_rad = lay.angle_rad;
    let (sin2, half, l) = (angle_rad.sin().powi(2), d.half_length(), d.layout);
    let outer = 2 * l.through;
    let strain = stiffness.map_or(0.0, |k| 0.8 * tension(d, angle_rad, state.pressure) / k).min(0.1);
    let strand2 = (1.0 + strain).powi(2);
    let station = |j: usize| d.mesh.node(outer, j)[1];
    let mut line = Line {
        lay,
        sin2,
        cos2: 1.0 - sin2,
        strand2,
        radius: d.radius,
        half,
        layer: LAYER * d.radius,
        bulge: 0.0,
    };
    let length =
        |line: &Line| (0..2 * l.along).map(|j| line.advance(station(j), station(j + 1))).sum::<f64>();
    let wanted = half + terminal;
    if let Some(radius) = slack {
        line.bulge = radius / d.radius - 1.0;
        state.q.fill(0.0);
        if l.multipliers {
            (0..l.along).for_each(|slab| state.u[l.tension(slab)..][..STRAND_POINTS].fill(0.0));
        }
    } else {
        let highest = lay.outer_radius_mm((strand2 / sin2).sqrt()) / d.radius;
        let (mut low, mut high) = (-0.3, 0.995 * highest - 1.0);
        for _ in 0..14 {
            line.bulge = 0.5 * (low + high);
            if length(&line) > wanted { low = line.bulge } else { high = line.bulge }
        }
        if low == -0.3 {
            return false;
        }
    }
    let scale = wanted / length(&line);
    let mut z = 0.0;
    for j in 0..=2 * l.along {
        let at = station(j);
        if j > 0 {
            z += scale * line.advance(station(j - 1), at);
        }
        let ((r, dr), (_, meridian)) = (line.radius(at), line.slope(at));
        // The normal turns with the line, but not at the terminal, which holds the wall.
        let tilt = (-dr / meridian).clamp(-0.7, 0.7)
            * ((half - at) / (2.0 * (d.radius - d.mesh.node(0, j)[0]))).min(1.0);
        let lean = (1.0 - tilt * tilt).sqrt();
        for i in 0..=outer {
            let rest = d.mesh.node(i, j);
            let k = l.at(j) + 2 * i;
            if j == 2 * l.along {
                (state.u[k], state.u[k + 1]) = (0.0, terminal);
                continue;
            }
            // r h − h²/2 = (Ro² − R²)/(2 λm): what lies outside of R keeps its volume.
            let section = (d.radius * d.radius - rest[0] * rest[0]) / meridian;
            let depth = r - (r * r - section).max(0.04 * r * r).sqrt();
            state.u[k] = r - depth * lean - rest[0];
            state.u[k + 1] = z - depth * tilt - rest[1];
        }
    }
    for i in 0..=outer {
        state.u[2 * i + 1] = 0.0;
    }
    state.terminal = terminal;
    true
}
