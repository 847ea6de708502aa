//! What an equilibrium of the section tells.

use super::{
    body::Body,
    discretisation::{Discretisation, nodes},
    sensitivity::slopes,
};
use crate::{
    Result,
    element::{
        q2::{NODES, Point},
        solid::{Unknowns, gradient},
        strand::{STRAND_POINTS, Stretch},
    },
    results::{MuscleBody, ProfilePoint, Sensitivity, StrandState, StretchAt, largest_of_most},
    solver::body::State,
};
use mckibben_core::{by_number::SortByNumber, extremes::peak, muscle::Muscle};

impl MuscleBody for Body {
    fn derivatives(&mut self) -> Result<[f64; 3]> {
        self.tangent()?;
        let (half_volume_per_pressure, force_per_pressure) = self.by_pressure();
        Ok([
            self.end.stiffness(),
            force_per_pressure,
            2.0 * half_volume_per_pressure,
        ])
    }

    fn rest_volume_mm3(&self, muscle: &Muscle) -> f64 {
        muscle.rest_volume_mm3()
    }

    fn profile(&self) -> Vec<ProfilePoint> {
        let d = &self.discretisation;
        let s = &self.state;
        let l = self.discretisation.layout;
        let station = |j: usize| {
            let at = |i: usize| {
                let [r, z] = d.mesh.node(i, j);
                let k = l.station_offset(j) + 2 * i;
                (z + s.u[k + 1], r + s.u[k])
            };
            let (outer_z_mm, outer_r_mm) = at(2 * l.through);
            let (inner_z_mm, inner_r_mm) = at(0);
            ProfilePoint {
                rest_z_mm: d.cylinder.node(0, j)[1],
                outer_z_mm,
                outer_r_mm,
                inner_z_mm,
                inner_r_mm,
            }
        };
        (0..=2 * l.along).map(station).collect()
    }

    fn strands(&self, muscle: &Muscle) -> Vec<StrandState> {
        strands(&self.discretisation, &self.state, muscle)
    }

    fn bulge_mm(&self) -> f64 {
        let outer: Vec<f64> = self.profile().iter().map(|p| p.outer_r_mm).collect();
        let slabs = (0..self.discretisation.layout.along).map(|slab| 2 * slab);
        peak(slabs.map(|j| highest([outer[j], outer[j + 1], outer[j + 2]])))
    }

    fn largest_stretch(&self) -> StretchAt {
        let d = &self.discretisation;
        let middle = |i: usize, n: usize| (2 * i + 1) as f64 / n as f64 - 1.0;
        let [through, along] = PARTS;
        let mut list = Vec::with_capacity(d.layout.along * d.layout.through * through * along);
        for (rest, u) in elements(d, &self.state) {
            for i in 0..through {
                for j in 0..along {
                    let Some(p) = d.point(&rest, middle(i, through), middle(j, along)) else {
                        continue;
                    };
                    // ψ of a single point still holds 1 + its place.
                    let at = StretchAt {
                        value: largest_principal(&p, &u),
                        rest_mm: [p.psi[1], p.psi[2]],
                    };
                    list.push((at, p.volume));
                }
            }
        }
        largest_of_most(list)
    }

    fn middle_stretch(&self) -> f64 {
        let d = &self.discretisation;
        let largest_at = |(rest, u): &([[f64; 2]; NODES], Unknowns), xi: f64| {
            d.point(rest, xi, -1.0).map(|p| largest_principal(&p, u))
        };
        elements(d, &self.state)
            .take(d.layout.through)
            .flat_map(|e| [largest_at(&e, -1.0), largest_at(&e, 1.0)])
            .flatten()
            .fold(1.0, f64::max)
    }

    fn sensitivities(&mut self, muscle: &Muscle) -> Result<Vec<Sensitivity>> {
        if self.discretisation.has_slopes() {
            slopes(self, muscle, |_| true)
        } else {
            Ok(vec![])
        }
    }
}

/// Parts of an element in which its stretch is looked at: through the wall and along.
const PARTS: [usize; 2] = [4, 6];

/// The largest principal stretch at a point.
fn largest_principal(p: &Point, u: &Unknowns) -> f64 {
    peak(gradient(p, u).principal())
}

/// The highest place of the quadratic edge of an element through its three nodes, which may lie
/// between them.
fn highest([a, b, c]: [f64; 3]) -> f64 {
    let slope = 0.5 * (c - a);
    let bend = a - 2.0 * b + c;
    let between = if bend < 0.0 && slope.abs() < -bend {
        b - 0.5 * slope * slope / bend
    } else {
        b
    };
    between.max(a).max(c)
}

/// λf and the tension per width of a strand point.
pub fn strand(d: &Discretisation, u: &[f64], slab: usize, g: usize) -> (Stretch, f64) {
    let l = d.layout;
    let stretch = d.strands[slab][g].stretch(&l.line(u, slab, 2 * l.through));
    let multiplier = if l.multipliers {
        u[l.tension(slab) + g]
    } else {
        0.0
    };
    let tension =
        |b| super::assembly::tension(&b, stretch.value - 1.0, multiplier, d.augment_strand).0;
    let q = d.problem.braid.map_or(0.0, tension);
    (stretch, q)
}

pub fn strands(d: &Discretisation, s: &State, muscle: &Muscle) -> Vec<StrandState> {
    let spacing = muscle
        .braid()
        .strands
        .map(|n| muscle.braid().strand_spacing_mm(muscle.tube(), n.count));
    let mut out: Vec<StrandState> = (0..d.strands.len())
        .flat_map(|slab| (0..STRAND_POINTS).map(move |g| (slab, g)))
        .map(|(slab, g)| {
            let (stretch, q) = strand(d, &s.u, slab, g);
            StrandState {
                rest_mm: d.strands[slab][g].place,
                stretch: stretch.value,
                angle_deg: d.strands[slab][g].angle_rad(&stretch).to_degrees(),
                tension_n_per_mm: q,
                tension_n: spacing.map(|w| q * w),
            }
        })
        .collect();
    out.sort_by_number(|a| a.rest_mm);
    out
}

/// Nodes of every element before it is drawn on plugs, and displacements from there, from the
/// middle to the terminal.
pub fn elements(
    d: &Discretisation,
    s: &State,
) -> impl Iterator<Item = ([[f64; 2]; NODES], Unknowns)> {
    let through = d.layout.through;
    (0..d.elements.len()).map(move |index| {
        let slab = index / through;
        let element = index % through;
        let [cylinder, drawn] = [&d.cylinder, &d.mesh].map(|mesh| nodes(mesh, slab, element));
        let mut u = d.layout.element(&s.u, slab, element);
        for a in 0..NODES {
            u.r[a] += drawn[a][0] - cylinder[a][0];
            u.z[a] += drawn[a][1] - cylinder[a][1];
        }
        (cylinder, u)
    })
}
