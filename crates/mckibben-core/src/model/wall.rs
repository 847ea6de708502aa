//! Elastic energy of a uniformly deformed tube wall, per unit of length at rest.
//!
//! A point at radius R of the wall moves to r(R)² = (R² − Ro²)/λ + ro² (volume kept), so that with
//! t = R²
//!
//!   u = λθ² = (ro² − (Ro² − t)/λ)/t,   v = λz² = λ²,   λr² = 1/(uv)
//!   W(λ, ro) = ∫ ŵ(u, v) 2πR dR = π ∫ ŵ dt
//!
//! with λ the axial stretch and ro the outer radius now. Source: Green & Zerna (1954)
//! \[green1954\]; Liu & Rahn (2003) \[liu2003\] use the same kinematics for the muscle. The
//! integral runs over y = ln t, where Gauss points converge fastest; for neo-Hookean and
//! Mooney–Rivlin rubber it is known in closed form ([`super::wall_mooney`]).
//!
//! A tube that was mounted with a stretch λp has its natural shape elsewhere: longer by 1/λp and
//! wider by √λp than at rest in the muscle, with free lateral surfaces and its volume kept. There
//! R, Ro and the law's stretches are taken: λz = λp λ, and
//!
//!   W(λ, ro) = Wn(λp λ, ro)/λp
//!
//! per length at rest in the muscle, Wn that of the natural tube per its own length.

use super::{
    quadrature::rule,
    wall_energy::{SquareEnergy, WallEnergy},
    wall_mooney::Mooney,
};
use crate::{
    muscle::Tube,
    rubber::{Law, LawVisitor, MooneyRivlin, RubberLaw},
};
use std::f64::consts::PI;

/// The wall of a tube at rest with its integration points.
#[derive(Debug, Clone)]
pub struct Wall {
    /// Of the natural tube
    ro2: f64,
    ri2: f64,
    /// ln(Ro²/Ri²)
    span: f64,
    /// (t = R², weight)
    points: Vec<(f64, f64)>,
    /// λp
    prestretch: f64,
}

impl Wall {
    /// The wall of a tube. The number of points grows with Ro/Ri so that the integral is good to
    /// about 1e-12.
    pub fn new(tube: &Tube) -> Self {
        let wider = tube.prestretch.sqrt();
        let ro = wider * tube.outer_radius_mm();
        let ri = wider * tube.inner_radius_mm();
        let span = 2.0 * (ro / ri).ln();
        let points = match span {
            s if s < 0.15 => 4,
            s if s < 0.4 => 6,
            s if s < 0.9 => 8,
            s if s < 1.8 => 12,
            _ => 20,
        };
        // Nearly solid rods: as many panels as it takes, each over no more than a factor e² in R².
        let panels = (span / 2.0).ceil().max(1.0) as usize;
        Self {
            prestretch: tube.prestretch,
            ..Self::with_panels(ro, ri, panels, points)
        }
    }

    fn with_panels(ro: f64, ri: f64, panels: usize, points: usize) -> Self {
        let y0 = 2.0 * ri.ln();
        let half = (ro / ri).ln() / panels as f64;
        let mut list = Vec::with_capacity(panels * points);
        for panel in 0..panels {
            let mid = y0 + half * (2 * panel + 1) as f64;
            list.extend(rule(points).iter().map(|&(x, weight)| {
                let t = (mid + half * x).exp();
                (t, PI * half * weight * t)
            }));
        }
        Self {
            ro2: ro * ro,
            ri2: ri * ri,
            span: 2.0 * (ro / ri).ln(),
            points: list,
            prestretch: 1.0,
        }
    }

    /// Ro² − Ri² of the mounted tube in mm².
    pub fn section(&self) -> f64 {
        (self.ro2 - self.ri2) / self.prestretch
    }

    /// Inner radius squared now, in mm²; not above zero where the bore would vanish.
    pub fn bore2(&self, axial_stretch: f64, outer_radius_mm: f64) -> f64 {
        outer_radius_mm * outer_radius_mm - self.section() / axial_stretch
    }

    /// W and its derivatives at an axial stretch λ and outer radius ro in mm.
    pub fn energy(&self, law: &Law, axial_stretch: f64, outer_radius_mm: f64) -> WallEnergy {
        self.of_square(law, axial_stretch, outer_radius_mm * outer_radius_mm)
            .by_radius(outer_radius_mm)
    }

    /// The same at λ and x = ro².
    #[inline(always)]
    pub(super) fn of_square(&self, law: &Law, axial_stretch: f64, x: f64) -> SquareEnergy {
        let p = self.prestretch;
        let l = self.prestretch * axial_stretch;
        let e = match self.closed(law) {
            Some(wall) => wall.of_square(l, x),
            None => self.integrated(law, l, x),
        };
        SquareEnergy {
            w: e.w / p,
            l: e.l,
            x: e.x / p,
            ll: p * e.ll,
            lx: e.lx,
            xx: e.xx / p,
        }
    }

    #[inline(always)]
    fn closed(&self, law: &Law) -> Option<Mooney> {
        let MooneyRivlin { c10_mpa, c01_mpa } = law.as_mooney_rivlin()?;
        Some(Mooney {
            c10_mpa,
            c01_mpa,
            ro2: self.ro2,
            section: self.ro2 - self.ri2,
            span: self.span,
        })
    }

    /// W and its derivatives by integration, for any law.
    fn integrated(&self, law: &Law, axial_stretch: f64, x: f64) -> SquareEnergy {
        law.visit(Integral {
            wall: self,
            lambda: axial_stretch,
            x,
        })
    }

    /// Largest principal stretch in the wall (it is at the bore or at the outer surface).
    pub fn largest_stretch(&self, axial_stretch: f64, outer_radius_mm: f64) -> f64 {
        let lambda = self.prestretch * axial_stretch;
        let inside = (self.bore2(axial_stretch, outer_radius_mm) / self.ri2)
            .max(0.0)
            .sqrt();
        let outside = outer_radius_mm / self.ro2.sqrt();
        inside
            .max(outside)
            .max(lambda)
            .max(1.0 / (lambda * inside.min(outside)))
    }
}

struct Integral<'a> {
    wall: &'a Wall,
    lambda: f64,
    /// ro²
    x: f64,
}

impl LawVisitor for Integral<'_> {
    type Output = SquareEnergy;

    fn law<L: RubberLaw>(self, law: &L) -> SquareEnergy {
        let Integral { wall, lambda, x } = self;
        let v = lambda * lambda;
        let mut sum = SquareEnergy::default();
        for &(t, weight) in &wall.points {
            let a = (wall.ro2 - t) / (lambda * t);
            let u_x = 1.0 / t;
            let u = x * u_x - a;
            let e = law.biaxial(u, v);
            let u_l = a / lambda;
            let v_l = 2.0 * lambda;
            sum.w += weight * e.w;
            sum.l += weight * (e.u * u_l + e.v * v_l);
            sum.x += weight * e.u * u_x;
            sum.ll += weight
                * (e.uu * u_l * u_l + 2.0 * e.uv * u_l * v_l + e.vv * v_l * v_l
                    - 2.0 * e.u * u_l / lambda
                    + 2.0 * e.v);
            sum.lx += weight * u_x * (e.uu * u_l + e.uv * v_l);
            sum.xx += weight * e.uu * u_x * u_x;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rubber::{Gent, MooneyRivlin, Ogden};

    fn laws() -> [Law; 3] {
        [
            Law::MooneyRivlin(MooneyRivlin {
                c10_mpa: 0.1,
                c01_mpa: 0.02,
            }),
            Law::Gent(Gent {
                mu_mpa: 0.24,
                jm: 300.0,
            }),
            Law::Ogden(Ogden {
                terms: vec![(0.6178, 1.3), (0.001177, 5.0), (-0.009807, -2.0)],
            }),
        ]
    }

    /// The rule chosen from Ro/Ri gives what 40 points give.
    #[test]
    fn chosen_integration_points_are_enough() {
        for (ro, ri) in [
            (25.0, 24.0),
            (15.0, 12.0),
            (9.5, 8.0),
            (2.5, 0.5),
            (15.0, 7.0),
            (5.0, 2.0),
            (10.0, 8.3),
        ] {
            let mut tube = Tube::prototype();
            (tube.outer_diameter_mm, tube.wall_mm) = (2.0 * ro, ro - ri);
            let (chosen, fine) = (Wall::new(&tube), Wall::with_panels(ro, ri, 1, 40));
            let at = |wall: &Wall, law: &Law, lambda: f64, r: f64| {
                wall.integrated(law, lambda, r * r).by_radius(r)
            };
            for law in laws() {
                for (lambda, bulge) in [(1.0, 1.0), (0.8, 1.6), (0.7, 1.9)] {
                    let (a, b) = (
                        at(&chosen, &law, lambda, bulge * ro),
                        at(&fine, &law, lambda, bulge * ro),
                    );
                    let scale = b.w.abs() + b.l.abs() + law.shear_modulus_mpa() * ro * ro * 1e-3;
                    let worst = [a.w - b.w, a.l - b.l, (a.r - b.r) * ro, a.ll - b.ll].map(f64::abs);
                    let worst = worst.into_iter().fold(0.0, f64::max) / scale;
                    assert!(
                        worst < 1e-9,
                        "{ro}/{ri} {} λ {lambda}: {worst:e}",
                        law.name()
                    );
                }
            }
        }
    }

    /// The closed form for Mooney–Rivlin rubber is the integral.
    #[test]
    fn the_closed_form_is_the_integral() {
        let law = &laws()[0];
        for (ro, ri) in [(25.0, 24.9), (25.0, 24.0), (15.0, 12.0), (5.0, 2.0)] {
            let wall = Wall::with_panels(ro, ri, 1, 40);
            for (l, bulge) in [(1.0, 1.0), (1.1, 0.97), (0.8, 1.6), (0.7, 1.9)] {
                let r = bulge * ro;
                let (a, b) = (
                    wall.energy(law, l, r),
                    wall.integrated(law, l, r * r).by_radius(r),
                );
                let scale = 0.24 * wall.section();
                for (a, b) in [
                    (a.w, b.w),
                    (a.l, b.l),
                    (a.r * ro, b.r * ro),
                    (a.ll, b.ll),
                    (a.lr * ro, b.lr * ro),
                    (a.rr * ro * ro, b.rr * ro * ro),
                ] {
                    assert!(
                        (a - b).abs() < 1e-11 * (scale + b.abs()),
                        "{ro}/{ri} λ {l}: {a} {b}"
                    );
                }
            }
        }
    }

    /// A nearly solid rod without pressure is in uniaxial compression: F = σ(λ) × section.
    #[test]
    fn a_nearly_solid_rod_is_compressed_as_a_rod() {
        let law = Law::MooneyRivlin(MooneyRivlin {
            c10_mpa: 0.1,
            c01_mpa: 0.02,
        });
        for ri in [1.0, 1e-1, 1e-2, 1e-4] {
            let mut tube = Tube::prototype();
            (tube.outer_diameter_mm, tube.wall_mm) = (20.0, 10.0 - ri);
            let (wall, l) = (Wall::new(&tube), 0.6_f64);
            let section = PI * (100.0 - tube.inner_radius_mm().powi(2));
            let e = wall.energy(&law, l, 10.0 / l.sqrt());
            // Rounding of ro is worth (Ro/Ri)² times as much in the hoop stretch of the bore.
            let allowed = section * (1e-9 + 1e-15 * (10.0 / ri).powi(2));
            // Uniform: r = R/√λ everywhere, and the wall is in equilibrium there without pressure.
            assert!(
                (e.l - law.uniaxial_stress_mpa(l) * section).abs() < allowed,
                "{ri}"
            );
            assert!(e.r.abs() < allowed, "{ri}: {}", e.r);
        }
    }

    #[test]
    fn derivatives_are_those_of_finite_differences() {
        let wall = Wall::with_panels(9.5, 8.0, 1, 12);
        for law in laws() {
            let (l, r, h) = (0.85, 13.0, 1e-5);
            let at = |l, r| wall.energy(&law, l, r);
            let e = at(l, r);
            let (lp, lm, rp, rm) = (at(l + h, r), at(l - h, r), at(l, r + h), at(l, r - h));
            let fd = |a: f64, b: f64| (a - b) / (2.0 * h);
            for (got, exact) in [
                (fd(lp.w, lm.w), e.l),
                (fd(rp.w, rm.w), e.r),
                (fd(lp.l, lm.l), e.ll),
                (fd(rp.l, rm.l), e.lr),
                (fd(lp.r, lm.r), e.lr),
                (fd(rp.r, rm.r), e.rr),
            ] {
                assert!(
                    (got - exact).abs() < 1e-6 * (1.0 + exact.abs()),
                    "{}: {got} vs {exact}",
                    law.name()
                );
            }
        }
    }
}
