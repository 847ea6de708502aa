//! Middle and ends at once: Newton's method in λ, the radius and the stretches of both sections
//! together.
//!
//! One step evaluates the energy three times: at the middle and at both sections of the membrane.
//! Each equation is corrected to first order at its place, and δ with its slope in λ follows from
//! the corrected values, so that the step in λ is that of Newton's method for all four. With steps
//! below the limits here the answer has an error of their squares. It serves where the muscle
//! pulls, the strands of the middle are taut and stretch, and the end is a membrane; `None`
//! elsewhere, or when it does not settle: the nested search of [`super::Universal`] takes over and
//! finds the same root.
//!
//! The unknown of the middle is q = λf², in which its equation is nearly linear however stiff the
//! strands are.

use super::{
    Universal,
    dual::Dual,
    end::{Section, Uniform},
};
use std::f64::consts::PI;

/// Largest step of λ with which it ends.
const SMALL_STEP: f64 = 4e-6;
/// Largest change of the pull in its last step, over P π r².
const SMALL_PULL: f64 = 2e-5;
/// Step of λs that may cross the kink of strands that go slack.
const KINK_STEP: f64 = 1e-11;
/// Largest square of the relative steps of r² and λs with which it ends, over the strain: the
/// tension of stiff strands feels them most.
const SMALL_SQUARE: f64 = 1e-10;
const ITERATIONS: usize = 9;
const LARGEST_STEP: f64 = 0.1;
/// −2δ/Ro over the bulge 1 − Ro/b, for first guesses.
const START: f64 = 0.8;

pub struct Root {
    pub force: f64,
    /// λ and r
    pub l: f64,
    pub r: f64,
    /// λs at both sections
    pub stretches: [f64; 2],
}

impl Universal {
    /// A start from nothing: λ and λf² of the middle, λs at both sections.
    fn start(&self, p: f64, contraction: f64) -> (f64, f64, [f64; 2]) {
        let wall = &self.zone.wall;
        let (sin2, cos2) = wall.squares();
        let ro = self.zone.ro;
        let section = wall.section();
        let ro2 = ro * ro;
        // Strands carry the pressure less what a thin neo-Hookean wall takes: ∂B/∂q = ½c (1 −
        // 1/λf).
        let by = 2.0 * ro2 / (4.0 * PI * ro * wall.k.unwrap_or(0.0) * sin2);
        let squared = |l: f64, x: f64| {
            let hoop = l * (x - 0.5 * section / l) / (ro2 - 0.5 * section);
            let share = (PI * l * p - self.wall_modulus * (1.0 - 1.0 / (hoop * hoop))) * by;
            let strand = 1.0 / (1.0 - share.clamp(1e-4, 0.2));
            strand * strand
        };
        let l = 1.0 - contraction;
        let q = squared(l, wall.square_at(1.0, l).max(0.5 * ro2));
        let x = wall.square_at(q, l).max(0.5 * ro2);
        let l = l - START * ro / self.length * (1.0 - ro / x.sqrt());
        let q = squared(l, wall.square_at(q, l).max(0.5 * ro2));
        let way = wall.square_at(q, l).max(0.0).sqrt() - ro;
        // H of strands alone: (λf − 1) λs² is about the same in every section.
        let strain = (q.sqrt() - 1.0) * l * l;
        let stretches = self.zone.radii(Dual::<1>::constant(way)).map(|r| {
            let hoop = sin2 * r.v * r.v / ro2;
            let square = ((q - hoop) / cos2).max(0.1);
            let strand = 1.0 + strain / square;
            ((strand * strand - hoop) / cos2).max(0.01).sqrt()
        });
        (l, q, stretches)
    }

    /// Whether there is something to couple: strands that stretch.
    pub(super) fn is_coupled(&self) -> bool {
        self.zone.wall.k.is_some() && self.zone.wall.is_plain()
    }

    /// The root at a pressure and contraction.
    pub(super) fn coupled(&self, p: f64, contraction: f64) -> Option<Root> {
        if !self.is_coupled() {
            return None;
        }
        let wall = &self.zone.wall;
        let (sin2, cos2) = wall.squares();
        let b = sin2 / (self.zone.ro * self.zone.ro);
        let section = wall.section();
        let (mut l, mut q, mut stretches) = self.start(p, contraction);
        for _ in 0..ITERATIONS {
            let x = wall.square_at(q, l);
            if !(l > 0.0 && x * l > section) {
                return None;
            }
            let e = wall.sheet(l, x);
            let value = e.x - PI * l * p;
            let dx = -value / e.xx;
            let x_l = -(e.lx - PI * p) / e.xx;
            let x1 = x + dx;
            if !(e.xx > 0.0 && x1 * l > section && (e.strand > 1.0 || wall.compression)) {
                return None;
            }
            let r = x1.sqrt();
            if !self.zone.bulges(r) {
                return None;
            }
            let tension = Dual::new(e.l + e.lx * dx, [e.ll + e.lx * x_l]);
            let energy = e.w + dx * (e.x + 0.5 * e.xx * dx);
            let h = Dual::new(
                energy - l * tension.v,
                [PI * l * p * x_l - l * tension.by[0]],
            );
            let strand_by = (cos2 * l + 0.5 * b * x_l) / e.strand;
            let strain = Dual::new(e.strand - 1.0 + 0.5 * b * dx / e.strand, [strand_by]);
            let radius = Dual::new(r, [0.5 * x_l / r]);
            let way = radius - Dual::constant(self.zone.ro);
            let radii = self.zone.radii(way);
            let at_start = self.stepped(radii[0], h, stretches[0])?;
            let on_way = self.stepped(radii[1], h, stretches[1])?;
            let sections = [at_start.section, on_way.section];
            let middle = Uniform {
                stretch: Dual::new(l, [1.0]),
                pressure: Dual::constant(p),
                radius,
                tension,
            };
            let end = self.zone.shape(&middle, way, sections)?;
            let delta = self.deficit.with_wall(&end, strain);
            let slope = 1.0 + 2.0 * delta.by[0] / self.length;
            let left = 1.0 - l - 2.0 * delta.v / self.length - contraction;
            let step = left / slope;
            if !(slope > LEAST_SLOPE && step.is_finite()) {
                return None;
            }
            let q_l = 2.0 * cos2 * l + b * x_l;
            let step = step.clamp(-LARGEST_STEP, LARGEST_STEP);
            let force_l = tension.by[0] - p * PI * x_l;
            // How much the slope of a flat end makes of an error in T.
            let flat = end.slope.v * end.slope.v * self.zone.ro / way.v.abs();
            let settled = step.abs() < SMALL_STEP
                && (force_l * step).abs() <= SMALL_PULL * PI * (p * x).abs()
                && dx * dx < SMALL_SQUARE * x * x * (e.strand - 1.0).abs()
                && at_start.settled(step, flat)
                && on_way.settled(step, flat);
            l += step;
            q += b * dx + q_l * step;
            stretches = sections.map(|s| s.stretch.v + s.stretch.by[0] * step);
            if settled {
                let force = tension.v - p * PI * x1 + force_l * step;
                return (force >= 0.0).then_some(Root {
                    force,
                    l,
                    r: r + radius.by[0] * step,
                    stretches,
                });
            }
        }
        None
    }

    /// One step of Newton's method for λs at a radius, U − λs ∂U/∂λs = H.
    #[inline(always)]
    fn stepped(&self, radius: Dual<1>, h: Dual<1>, s: f64) -> Option<Stepped> {
        let wall = &self.zone.wall;
        let x = radius.squared();
        if !(s > 0.0 && x.v * s > wall.section()) {
            return None;
        }
        let e = wall.sheet(s, x.v);
        let slope = 1.0 / (s * e.ll);
        let step = (e.w - s * e.l - h.v) * slope;
        let by = ((e.x - s * e.lx) * x.by[0] - h.by[0]) * slope;
        let section = Section {
            radius,
            stretch: Dual::new(s + step, [by]),
            tension: Dual::new(e.l + e.ll * step, [e.ll * by + e.lx * x.by[0]]),
        };
        (e.ll > 0.0).then_some(Stepped {
            section,
            rest: step.abs(),
            room: (e.strand - 1.0).abs(),
        })
    }
}

/// A section after a step.
struct Stepped {
    section: Section<1>,
    /// Size of the step of λs
    rest: f64,
    /// |λf − 1| before it
    room: f64,
}

impl Stepped {
    /// Whether its error after a step of λ is below the limits; not where both may have crossed the
    /// kink of strands that go slack.
    #[inline(always)]
    fn settled(&self, step: f64, flat: f64) -> bool {
        let step = step.abs();
        let all = self.rest + (1.0 + self.section.stretch.by[0].abs()) * step;
        (all < self.room && self.rest * (self.rest + step) < SMALL_SQUARE * self.room * flat)
            || all < KINK_STEP
    }
}

/// Slope −∂ε/∂λ below which there is no answer.
pub const LEAST_SLOPE: f64 = 0.02;
