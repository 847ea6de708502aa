//! The end of a muscle as a membrane: from the terminal, where it has its radius at rest, to the
//! uniform middle.
//!
//! With U(λs, r) the energy of wall and braid per length at rest when the meridian is stretched by
//! λs at outer radius r, the shape r(Z), z(Z) of the muscle minimises ∫ U(√(r'² + z'²), r) − P π r²
//! z' dZ. Z does not appear, nor does z: two quantities are the same in every section,
//!
//!   F = T cosφ − P π r²,   H = U − λs T,   T = ∂U/∂λs,   cosφ = z'/λs
//!
//! and their values are those of the middle (λ, b): H = U(λ, b) − λ T(λ, b). At any r on the way
//! the second gives λs, the first the slope φ, so that what the end adds to the length of a uniform
//! muscle is an integral over r,
//!
//!   δ = ∫ (z' − λ) dZ = ∫ (λs cosφ − λ)/(λs sinφ) dr   from Ro to b
//!
//! and the volume likewise. The integrand is smooth; the rule of Radau with two points (Ro and two
//! thirds of the way, weights ¼ and ¾) is used. Derived here. Strands that do not stretch tie λs to
//! r; T is then (U − H)/λs.
//!
//! The way back from the bulge decays like e^(−Z/ℓ); in a short muscle the two ends meet before
//! they are through. In the linear theory that makes δ smaller by the factor tanh(½L0/ℓ). Here it
//! is tanh(1.2 · ½L0/ℓ) with the ℓ = (b − r)/(λs sinφ) found at the second point.
//!
//! Where the muscle would have to push, no such shape need exist; T and the axial load are kept
//! above zero and cosφ below one by smooth floors that do nothing where it pulls.

use super::dual::Dual;
use crate::model::{
    WallEnergy,
    thick_wall::{State, ThickWall},
};
use std::f64::consts::PI;

/// Places between Ro and b, and weights.
const RADAU: [(f64, f64); 2] = [(0.0, 0.25), (2.0 / 3.0, 0.75)];
/// Floor of T and of the load as a share of 2π Ro s μ, and the width of the passage to it.
const LEAST_TENSION: (f64, f64) = (0.01, 0.02);
/// Floor of 1 − cosφ as a share of ((b − r)/Ro)², and the width of the passage to it.
const LEAST_SLOPE: (f64, f64) = (0.01, 0.01);
/// |b − Ro|/Ro below which the end is that of the linear theory; at twice of it that of the membrane, between the two a mixture.
const SMALL: f64 = 1e-5;
/// Factor of ½L0/ℓ where the ends meet: in large bulges ℓ falls on the way to the middle. Chosen on
/// the campaign.
const MEETING: f64 = 1.2;
/// A step of Newton's method this small leaves an error of its square.
const SMALL_STEP: f64 = 1e-10;
const ITERATIONS: usize = 40;

/// What the end zone gives, per end.
#[derive(Clone, Copy)]
pub struct End<const N: usize = 2> {
    /// δ in mm
    pub deficit: Dual<N>,
    /// ∫ π r² z' − π b² λ dZ in mm³
    pub volume_mm3: Dual<N>,
    /// λs − λ at the terminal
    pub excess: Dual<N>,
    /// sinφ at the terminal
    pub slope: Dual<N>,
    /// T/(2π Ro s μ) at the terminal
    pub tension: Dual<N>,
}

/// The muscle's constants that the end needs.
#[derive(Debug, Clone)]
pub struct EndZone {
    pub wall: ThickWall,
    /// Ro
    pub ro: f64,
    /// 2π Ro s μ
    pub scale: f64,
    /// ½L0
    pub half: f64,
}

/// The middle, as an end sees it.
#[derive(Clone, Copy)]
pub struct Uniform<const N: usize> {
    /// λ
    pub stretch: Dual<N>,
    /// P
    pub pressure: Dual<N>,
    /// b
    pub radius: Dual<N>,
    /// T
    pub tension: Dual<N>,
}

/// λs and T at a radius.
#[derive(Clone, Copy)]
pub struct Section<const N: usize = 2> {
    pub radius: Dual<N>,
    pub stretch: Dual<N>,
    pub tension: Dual<N>,
}

/// What a section gives.
struct Point<const N: usize> {
    /// (λs cosφ − λ)/(λs sinφ)
    shortening: Dual<N>,
    /// The same of the volume
    volume: Dual<N>,
    sin: Dual<N>,
    /// λs sinφ
    per_r: Dual<N>,
    tension: Dual<N>,
}

impl EndZone {
    /// The end of a muscle whose middle is in a state, from guesses of λs at both sections; `None`
    /// where no section is found.
    pub fn end_at(&self, p: f64, l: f64, state: &State, near: Option<[f64; 2]>) -> Option<End> {
        let lambda = Dual::new(l, [1.0, 0.0]);
        let axial = Dual::new(state.axial, state.axial_by);
        let h = Dual::new(state.energy, state.energy_by) - axial * lambda;
        let middle = Uniform {
            stretch: lambda,
            pressure: Dual::new(p, [0.0, 1.0]),
            radius: Dual::new(state.r, state.r_by),
            tension: axial,
        };
        let way = middle.radius - Dual::constant(self.ro);
        let share = (way.v.abs() / (SMALL * self.ro) - 1.0).min(1.0);
        if share <= 0.0 {
            return Some(self.linear(l, state, way, self.kept(axial)));
        }
        let [a, b] = self.radii(way);
        let sections = [
            self.section(a, h, l, state, near.map(|n| n[0]))?,
            self.section(b, h, l, state, near.map(|n| n[1]))?,
        ];
        let end = self.shape(&middle, way, sections)?;
        if share < 1.0 {
            let linear = self.linear(l, state, way, self.kept(axial));
            return Some(End {
                deficit: linear.deficit * (1.0 - share) + end.deficit * share,
                ..end
            });
        }
        Some(end)
    }

    /// Whether an end is that of the membrane alone at a radius of the middle.
    #[inline]
    pub fn bulges(&self, b: f64) -> bool {
        (b - self.ro).abs() >= 2.0 * SMALL * self.ro
    }

    /// Radii of the points of the quadrature, at b − Ro.
    #[inline(always)]
    pub fn radii<const N: usize>(&self, way: Dual<N>) -> [Dual<N>; 2] {
        let [(first, _), (second, _)] = RADAU;
        let from = Dual::constant(self.ro);
        [from + way * first, from + way * second]
    }

    /// Above zero by a smooth floor.
    #[inline(always)]
    fn kept<const N: usize>(&self, x: Dual<N>) -> Dual<N> {
        let least = Dual::constant(LEAST_TENSION.0 * self.scale);
        least + (x - least).positive(Dual::constant(LEAST_TENSION.1 * self.scale))
    }

    /// The end from its two sections.
    #[inline(always)]
    pub fn shape<const N: usize>(
        &self,
        middle: &Uniform<N>,
        way: Dual<N>,
        [first, second]: [Section<N>; 2],
    ) -> Option<End<N>> {
        let [(_, weight), (place_1, weight_1)] = RADAU;
        let start = self.point(middle, &first);
        let on = self.point(middle, &second);
        let length = if way.v < 0.0 { -way } else { way };
        // The second point says how fast the bulge decays.
        let decay = on.per_r / (length * (1.0 - place_1));
        let meeting = (decay * (MEETING * self.half)).tanh();
        let deficit = (start.shortening * weight + on.shortening * weight_1) * length * meeting;
        deficit.is_finite().then_some(End {
            deficit,
            volume_mm3: (start.volume * weight + on.volume * weight_1) * length * meeting,
            excess: first.stretch - middle.stretch,
            slope: start.sin,
            tension: start.tension * (1.0 / self.scale),
        })
    }

    /// The slope at a section and what it gives the integrals.
    #[inline(always)]
    fn point<const N: usize>(&self, middle: &Uniform<N>, section: &Section<N>) -> Point<N> {
        let Uniform {
            stretch: lambda,
            radius: b,
            ..
        } = *middle;
        let Section {
            radius: r, stretch, ..
        } = *section;
        let one = Dual::constant(1.0);
        let tension = self.kept(section.tension);
        let load = self.kept(middle.tension + middle.pressure * (r.squared() - b.squared()) * PI);
        let near = ((b - r) * (1.0 / self.ro)).squared();
        // 1 − cosφ above its floor
        let above = (one - load / tension - near * LEAST_SLOPE.0).positive(near * LEAST_SLOPE.1);
        let turn = near * LEAST_SLOPE.0 + above;
        let cos = one - turn;
        let sin = (turn * (Dual::constant(2.0) - turn)).sqrt();
        let per_r = stretch * sin;
        Point {
            shortening: (stretch * cos - lambda) / per_r,
            volume: (r.squared() * stretch * cos - b.squared() * lambda) * PI / per_r,
            sin,
            per_r,
            tension,
        }
    }

    /// Hardly any bulge: r − b decays like e^(−Z/ℓ), ℓ² = (T/λ)/(d²(Π − Fλ)/dr²).
    fn linear(&self, l: f64, state: &State, way: Dual, axial: Dual) -> End {
        let length = (axial.v / (l * state.radial)).sqrt();
        let length = if state.radial > 0.0 && length > 0.0 {
            length * (MEETING * self.half / length).tanh()
        } else {
            0.0
        };
        End {
            deficit: way * (-state.stretch_by_r * length),
            volume_mm3: Dual::constant(0.0),
            excess: way * (-state.stretch_by_r),
            slope: Dual::constant(0.0),
            tension: axial * (1.0 / self.scale),
        }
    }

    fn section(
        &self,
        r: Dual,
        h: Dual,
        l: f64,
        state: &State,
        near: Option<f64>,
    ) -> Option<Section> {
        let (sin2, cos2) = self.wall.squares();
        let at = r.v / self.ro;
        let taut = self.wall.taut_stretch(r.v);
        if self.wall.k.is_some() {
            // The strands here are about as long as those of the middle.
            let strand2 = cos2 * l * l + sin2 * (state.r / self.ro).powi(2);
            return self.stretched(
                r,
                h,
                near.unwrap_or_else(|| ((strand2 - sin2 * at * at) / cos2).max(0.01).sqrt()),
            );
        }
        if taut > 0.0 {
            let w = self.wall.energy(taut, r.v);
            let stretch = r.chain(taut, self.wall.taut_stretch_by_r(r.v));
            let tension = (lift(w.w, w.l, w.r, stretch, r) - h) / stretch;
            if tension.v >= w.l {
                return Some(Section {
                    radius: r,
                    stretch,
                    tension,
                });
            }
        }
        self.stretched(r, h, if taut > 0.0 { taut } else { l })
    }

    /// Root λs of U − λs ∂U/∂λs = H, which falls with λs.
    fn stretched(&self, r: Dual, h: Dual, guess: f64) -> Option<Section> {
        let mut l = guess;
        let mut low = 0.0;
        let mut high = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let e = self.wall.energy(l, r.v);
            let value = e.w - l * e.l - h.v;
            if !(value.is_finite() && e.ll > 0.0) {
                return None;
            }
            let step = value / (l * e.ll);
            if step.abs() < SMALL_STEP * l {
                return Some(self.solved(r, h, l, step, &e));
            }
            if value > 0.0 {
                low = l;
            } else {
                high = l;
            }
            let next = l + step.clamp(-0.3 * l, 0.3 * l);
            l = if next > low && next < high {
                next
            } else {
                0.5 * (low + high.min(2.0 * l))
            };
        }
        None
    }

    /// The last step of Newton's method leaves an error of its square.
    fn solved(&self, r: Dual, h: Dual, l: f64, step: f64, e: &WallEnergy) -> Section {
        let by = [0, 1].map(|i| ((e.r - l * e.lr) * r.by[i] - h.by[i]) / (l * e.ll));
        Section {
            radius: r,
            stretch: Dual::new(l + step, by),
            tension: Dual::new(
                e.l + e.ll * step,
                [0, 1].map(|i| e.ll * by[i] + e.lr * r.by[i]),
            ),
        }
    }
}

/// A function of (λs, r) from its value and slopes.
fn lift(v: f64, by_stretch: f64, by_r: f64, stretch: Dual, r: Dual) -> Dual {
    Dual::new(
        v,
        [0, 1].map(|i| by_stretch * stretch.by[i] + by_r * r.by[i]),
    )
}
