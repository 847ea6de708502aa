//! What an equilibrium tells, in the words of the axisymmetric model: averages around the
//! circumference.

use super::{
    body::Body,
    kinematics::{gradient, largest_principal, now},
    mesh::{Brick, BrickMesh},
    muscle::MuscleInBricks,
};
use crate::{
    FemError, Result,
    element::{
        brick::{ShapePoint, determinant, jacobian},
        hexahedron::shape_at,
        spatial::Vector,
    },
    results::{MuscleBody, ProfilePoint, StrandState, StretchAt, largest_of_most},
};
use mckibben_core::{cancel, extremes::peak, muscle::Muscle};
use std::f64::consts::{FRAC_PI_4, PI};

impl MuscleBody for MuscleInBricks {
    fn derivatives(&mut self) -> Result<[f64; 3]> {
        let body = &mut self.bricks;
        let force_n = body.totals.pull;
        body.factorise()
            .map_err(|reason| FemError::at_force(force_n, reason))?;
        // By Maxwell's relation ∂F/∂P = −∂V/∂L.
        let (stiffness, force_per_pressure) = body.terminal_response();
        let volume_per_pressure = body.volume_per_pressure();
        cancel::check()?;
        Ok([stiffness, force_per_pressure, volume_per_pressure])
    }

    fn rest_volume_mm3(&self, _muscle: &Muscle) -> f64 {
        let mesh = &self.mesh;
        // Less the nose: ∫ (height) 2πr dr, a quarter of it.
        let nose = mesh.plug.as_ref().map_or(0.0, |plug| plug.nose_mm);
        let flat = mesh.tube.inner_mm - nose;
        let solid = FRAC_PI_4 * flat * flat * nose
            + 0.5 * PI * (flat * FRAC_PI_4 * nose.powi(2) + nose.powi(3) / 3.0);
        8.0 * (mesh.lid_mm2() * mesh.tube.half_mm - solid)
    }

    fn profile(&self) -> Vec<ProfilePoint> {
        let body = &self.bricks;
        let mesh = &self.mesh;
        let [ni, ..] = mesh.grid();
        let row = |k: usize| {
            let (outer_z_mm, outer_r_mm) = ring(body, mesh, ni - 1, k);
            let (inner_z_mm, inner_r_mm) = ring(body, mesh, 0, k);
            ProfilePoint {
                rest_z_mm: mesh.nodes[mesh.node(0, 0, k)][2],
                outer_z_mm,
                outer_r_mm,
                inner_z_mm,
                inner_r_mm,
            }
        };
        (0..=mesh.free_rows()).map(row).collect()
    }

    /// Means over both families, row of quads by row.
    fn strands(&self, muscle: &Muscle) -> Vec<StrandState> {
        let body = &self.bricks;
        let mesh = &self.mesh;
        let [_, nj, nk] = mesh.grid();
        let row = nj - 1;
        let family = (nj - 1) * (nk - 1);
        let width = mesh.strand_width_mm(muscle);
        let spacing = muscle
            .braid()
            .strands
            .map(|n| muscle.braid().strand_spacing_mm(muscle.tube(), n.count));
        (0..mesh.free_rows())
            .map(|k: usize| {
                let mut stretch = 0.0;
                let mut angle = 0.0;
                let mut tension = 0.0;
                let pieces =
                    (k * row..(k + 1) * row).chain(family + k * row..family + (k + 1) * row);
                for t in pieces {
                    let pull = body.discretisation.pull(&body.state, t, 0.0);
                    stretch += 1.0 + pull.strain;
                    angle += pull.direction[0]
                        .hypot(pull.direction[1])
                        .atan2(pull.direction[2].abs());
                    tension += pull.tension;
                }
                let count = 2.0 * row as f64;
                let per_width = tension / count / width;
                let z = |k: usize| mesh.nodes[mesh.node(0, 0, k)][2];
                StrandState {
                    rest_mm: 0.5 * (z(k) + z(k + 1)),
                    stretch: stretch / count,
                    angle_deg: (angle / count).to_degrees(),
                    tension_n_per_mm: per_width,
                    tension_n: spacing.map(|s| per_width * s),
                }
            })
            .collect()
    }

    fn bulge_mm(&self) -> f64 {
        peak(self.profile().iter().map(|p| p.outer_r_mm))
    }

    /// Looked at in three layers of every brick.
    fn largest_stretch(&self) -> StretchAt {
        const LAYERS: [f64; 3] = [-2.0 / 3.0, 0.0, 2.0 / 3.0];
        let along = if self.mesh.brick == Brick::Linear {
            &LAYERS[1..2]
        } else {
            &LAYERS
        };
        let places: Vec<Vector> = LAYERS
            .iter()
            .flat_map(|x| along.iter().map(move |z| [*x, 0.0, *z]))
            .collect();
        largest_of_most(stretches_at(&self.bricks, &places))
    }

    /// On the inner and outer face of the row of bricks at the middle plane.
    fn middle_stretch(&self) -> f64 {
        let list = stretches_at(&self.bricks, &[-1.0, 1.0].map(|x| [x, 0.0, -1.0]));
        let near = 1e-6 * self.mesh.tube.half_mm;
        list.iter()
            .filter(|s| s.0.rest_mm[1].abs() < near)
            .map(|s| s.0.value)
            .fold(1.0, f64::max)
    }
}

/// Mean (z, r) of a ring of nodes; the ends of the quarter count half.
fn ring(body: &Body, mesh: &BrickMesh, i: usize, k: usize) -> (f64, f64) {
    let nj = mesh.grid()[1];
    let mut z = 0.0;
    let mut r = 0.0;
    let mut sum = 0.0;
    for j in 0..nj {
        let w = if j == 0 || j + 1 == nj { 0.5 } else { 1.0 };
        let x = now(body, mesh.node(i, j, k));
        z += w * x[2];
        r += w * x[0].hypot(x[1]);
        sum += w;
    }
    (z / sum, r / sum)
}

/// The stretch at places of every brick of rubber.
fn stretches_at(body: &Body, places: &[Vector]) -> Vec<(StretchAt, f64)> {
    let d = &body.discretisation;
    let points: Vec<ShapePoint> = places
        .iter()
        .map(|x| shape_at(d.problem.brick.order(), *x, 1.0))
        .collect();
    let mut list = vec![];
    for (e, nodes) in d.problem.bricks[d.materials[0].bricks.clone()]
        .iter()
        .enumerate()
    {
        let rest: Vec<Vector> = nodes.iter().map(|n| d.problem.nodes[*n as usize]).collect();
        for p in &points {
            let Some((f, _)) = gradient(body, e, p) else {
                continue;
            };
            let [x, y, z] = p.place(&rest);
            let at = StretchAt {
                value: largest_principal(&f),
                rest_mm: [x.hypot(y), z],
            };
            list.push((at, determinant(&jacobian(&rest, &p.dn)).abs()));
        }
    }
    list
}
