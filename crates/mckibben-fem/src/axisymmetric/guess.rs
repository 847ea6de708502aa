//! First iterates for a muscle that was never looked at.
//!
//! Tensions and pressures of the ideal muscle, q = P Ro λ/(2 sin²θ0) and p = −P: without them the
//! first tangent would lack the very stiffness that holds the tube. And a shape: the outer line
//! keeps the length of its strands,
//!
//!   λm² = (λf² − sin²θ0 λθ²)/cos²θ0,   r = Ro (1 + b) + [Re − Ro (1 + b)] e^(−(L0/2 − Z)/ℓ),   z' = √(λm² − r'²),
//!
//! Re the outer radius on the plug, with the bulge b that brings the terminal to its place; the
//! wall behind it keeps its volume. Where the strands of the infinitely long muscle are slack there
//! is no tension, and the bulge is the infinitely long muscle's.
//!
//! Strands at a small angle let the tube become several times as wide, and its end zone as long as
//! that makes it ([`Outline::Net`]): there the line is that of strands alone. With their angle α to
//! the meridian, sinα = sinθ0 λθ/λf, and rm the radius of the middle, equilibrium along the axis is
//!
//!   cosφ = [rm² (2 cot²αm − 1) + r²] sin²αm/(2 rm² cosαm cosα),   dr/dZ = −λm sinφ.

use super::discretisation::{BraidSpec, Discretisation, LAYER};
use crate::{element::strand::STRAND_POINTS, solver::body::State};
use mckibben_core::{analysis::bisect, muscle::StrandLay};

/// Steps of integration per station.
const STEPS: usize = 4;
/// Steps of the line of strands alone.
const NET: usize = 24;

/// How the outer line runs from the middle to the terminal.
#[derive(Clone, Copy, PartialEq)]
pub enum Outline {
    /// In a layer of the same length whatever the bulge.
    Layer,
    /// As strands alone would.
    Net,
    /// Likewise in a layer, to this outer radius in mm in the middle: the strands are slack.
    Slack(f64),
}

/// Tensions and pressures of the ideal muscle.
pub fn loads(d: &Discretisation, state: &mut State, stretch: f64) {
    let Some(BraidSpec { lay, .. }) = d.problem.braid else {
        return;
    };
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
    /// Re in mm.
    end: f64,
    half: f64,
    layer: f64,
    bulge: f64,
    /// Distance from the terminal, r and r' of strands alone; empty for [`Outline::Layer`].
    net: Vec<[f64; 3]>,
}

impl Line {
    /// Sets b, and for strands alone what follows from it.
    fn set(&mut self, bulge: f64, outline: Outline) {
        self.bulge = bulge;
        self.net.clear();
        // A neck has no end zone of this kind.
        let middle = self.radius * (1.0 + bulge);
        if outline != Outline::Net || middle <= self.end {
            return;
        }
        let square = |r: f64| {
            let hoop = self.lay.hoop_stretch(r);
            (self.sin2 * hoop * hoop / self.strand2).min(1.0)
        };
        let sin2 = square(middle);
        let lowest = (2.0 * (1.0 - sin2) / sin2 - 1.0) * middle * middle;
        let mut place = 0.0;
        let mut before = 0.0;
        for i in 0..=NET {
            // Finer towards the middle, where dZ/dr is infinite.
            let t = 1.0 - i as f64 / NET as f64;
            let r = middle - (middle - self.end) * t * t;
            let cos_alpha = (1.0 - square(r)).max(1e-6).sqrt();
            let cos_middle = (1.0 - sin2).max(1e-6).sqrt();
            let cos = (lowest + r * r) * sin2 / (2.0 * middle * middle * cos_middle * cos_alpha);
            let slope = (self.strand2 / self.cos2).sqrt()
                * cos_alpha
                * (1.0 - cos.clamp(0.0, 1.0).powi(2)).sqrt();
            // dr = 2 (rm − Ro) t dt: at the middle both dr and r' vanish, and their ratio does not.
            let rate = if slope > 0.0 && t > 0.0 {
                2.0 * (middle - self.end) * t / slope
            } else {
                before
            };
            if i > 0 {
                place += 0.5 * (before + rate) / NET as f64;
            }
            before = rate;
            self.net.push([place, r, -slope]);
        }
        // A muscle that is shorter than its end zones has them in part.
        if place > self.half {
            let share = self.half / place;
            self.net
                .iter_mut()
                .for_each(|p| *p = [share * p[0], p[1], p[2] / share]);
        }
    }

    /// r and r' at Z.
    fn radius(&self, z: f64) -> (f64, f64) {
        if !self.net.is_empty() {
            let place = self.half - z;
            let after = self.net.partition_point(|p| p[0] <= place);
            return match (
                after.checked_sub(1).and_then(|i| self.net.get(i)),
                self.net.get(after),
            ) {
                (Some(a), Some(b)) => {
                    let t = (place - a[0]) / (b[0] - a[0]);
                    (a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]))
                }
                (Some(end), None) => (end[1], 0.0),
                (None, _) => (self.end, 0.0),
            };
        }
        let fall = (-(self.half - z) / self.layer).exp();
        // What a plug adds is nothing without one, to the last bit.
        let more = (self.end - self.radius) * fall;
        (
            self.radius * (1.0 + self.bulge * (1.0 - fall)) + more,
            -self.radius * self.bulge * fall / self.layer + more / self.layer,
        )
    }

    /// z' and λm at Z.
    fn slope(&self, z: f64) -> (f64, f64) {
        let (r, dr) = self.radius(z);
        let hoop = self.lay.hoop_stretch(r);
        let meridian2 = ((self.strand2 - self.sin2 * hoop * hoop) / self.cos2).max(0.01);
        (
            (meridian2 - dr * dr).max(0.09 * meridian2).sqrt(),
            meridian2.sqrt(),
        )
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

/// Fills the displacements of `state`, whose pressure is set, for a displacement of the terminal;
/// `false` where no bulge brings the terminal there.
pub fn shape(d: &Discretisation, state: &mut State, terminal: f64, outline: Outline) -> bool {
    let Some(BraidSpec { lay, stiffness, .. }) = d.problem.braid else {
        return false;
    };
    let angle_rad = lay.angle_rad;
    let sin2 = angle_rad.sin().powi(2);
    let half = d.half_length();
    let l = d.layout;
    let outer = 2 * l.through;
    let strain = stiffness
        .map_or(0.0, |k| 0.8 * tension(d, angle_rad, state.pressure) / k)
        .min(0.1);
    let strand2 = (1.0 + strain).powi(2);
    let station = |j: usize| d.cylinder.node(outer, j)[1];
    let mut line = Line {
        lay,
        sin2,
        cos2: 1.0 - sin2,
        strand2,
        radius: d.radius,
        end: d.mesh.node(outer, 2 * l.along)[0],
        half,
        layer: LAYER * d.radius,
        bulge: 0.0,
        net: vec![],
    };
    let length = |line: &Line| {
        (0..2 * l.along)
            .map(|j| line.advance(station(j), station(j + 1)))
            .sum::<f64>()
    };
    let wanted = half + terminal;
    if let Outline::Slack(radius) = outline {
        line.set(radius / d.radius - 1.0, outline);
        state.q.fill(0.0);
        if l.multipliers {
            (0..l.along).for_each(|slab| state.u[l.tension(slab)..][..STRAND_POINTS].fill(0.0));
        }
    } else {
        let highest = lay.outer_radius_mm((strand2 / sin2).sqrt()) / d.radius;
        let (low, _) = bisect(-0.3, 0.995 * highest - 1.0, 14, |bulge| {
            line.set(bulge, outline);
            length(&line) > wanted
        });
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
        let (r, dr) = line.radius(at);
        let (_, meridian) = line.slope(at);
        // The normal turns with the line, but not at the terminal, which holds the wall.
        let tilt = (-dr / meridian).clamp(-0.7, 0.7)
            * ((half - at) / (2.0 * (d.radius - d.mesh.node(0, j)[0]))).min(1.0);
        let lean = (1.0 - tilt * tilt).sqrt();
        for i in 0..=outer {
            let rest = d.cylinder.node(i, j);
            let from = d.mesh.node(i, j);
            let k = l.station_offset(j) + 2 * i;
            if j == 2 * l.along {
                state.u[k] = 0.0;
                state.u[k + 1] = terminal;
                continue;
            }
            // r h − h²/2 = (Ro² − R²)/(2 λm): what lies outside of R keeps its volume.
            let section = (d.radius * d.radius - rest[0] * rest[0]) / meridian;
            let depth = r - (r * r - section).max(0.04 * r * r).sqrt();
            state.u[k] = r - depth * lean - from[0];
            state.u[k + 1] = z - depth * tilt - from[1];
        }
    }
    (0..=outer).for_each(|i| state.u[2 * i + 1] = 0.0);
    state.terminal = terminal;
    true
}
