//! How the strands press on the tube and turn against each other, and what friction follows.
//!
//! A strand of tension T presses on what it lies over with T κn per length, κn = sin²θ cosφ/rb +
//! cos²θ κm: the curvature of its line normal to the tube (Meusnier and Euler), with θ its angle to
//! the meridian, φ the slope of the meridian, κm its curvature, rb the radius of the midline. Both
//! families together press with pc on the tube; per area of the sleeve as made
//!
//!   pc dA = 2 q λf κn dA0,
//!
//! q the tension per width of a family. As the muscle's length L changes at constant pressure,
//! strands that cross turn against each other by 2 dθ, against a friction with the lever w (of the
//! width and the shape of the contact) and the coefficient μ. By virtual work the half-width of the
//! hysteresis loop is
//!
//!   F_f = μw G,   G = (2/3) ∫ pc |dθ/dL| dA,
//!
//! and G = (4π/3) pc r cotθ of an infinitely long muscle with strands that do not stretch.
//! Crossings as in Davis & Caldwell 2006 \[davis2006\]; strands are tied to the tube, so that
//! nothing slides on it. Where they are slack pc vanishes, and the friction with it.

use super::{Axisymmetric, discretisation::Discretisation, results::strand};
use crate::{
    Result,
    element::q2::{GAUSS2, along},
    simulation::Given,
};
use mckibben_core::{by_number::SortByNumber, model::Workspace};
use std::f64::consts::PI;

/// Second derivatives of the shape functions of a line element in its coordinate: middle, left,
/// right.
const CURVED: [f64; 3] = [-2.0, 1.0, 1.0];

/// Contact of the strands at a place along the half muscle.
#[derive(Debug, Clone, Copy, Default)]
pub struct ContactPlace {
    /// Z at rest in mm, from the middle.
    pub rest_mm: f64,
    /// pc in MPa.
    pub pressure_mpa: f64,
    /// dθ/dL in rad per mm of the muscle's length, at constant pressure.
    pub turning_rad_per_mm: f64,
    /// Surface under the strands now that belongs to this place, of the half muscle, in mm².
    pub area_mm2: f64,
}

/// Contact of the strands of a muscle.
#[derive(Debug)]
pub struct Contact {
    /// From the middle to the terminal.
    pub places: Vec<ContactPlace>,
    /// G = (2/3) ∫ pc |dθ/dL| dA over the whole muscle, in N per mm of μw.
    pub pivoting_n_per_mm: f64,
}

impl Axisymmetric {
    /// The contact of the strands at a pressure in MPa and a contraction.
    pub fn contact(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Contact> {
        let c = self.led_to(workspace, Given::at(pressure_mpa, contraction))?;
        let body = &mut c.body;
        body.tangent()?;
        // What every unknown does as the terminal, and so half of the length, moves by 1 mm.
        let mut by = vec![0.0; body.state.u.len()];
        body.solve_linear(&mut by, 1.0);
        let d = &body.discretisation;
        let mut places: Vec<ContactPlace> = (0..d.strands.len())
            .flat_map(|slab| (0..GAUSS2.len()).map(move |g| (slab, g)))
            .map(|at| contact_at(d, &body.state.u, &by, at))
            .collect();
        places.sort_by_number(|a| a.rest_mm);
        // Both halves turn alike.
        let work =
            |p: &ContactPlace| 2.0 * p.pressure_mpa * p.turning_rad_per_mm.abs() * p.area_mm2;
        Ok(Contact {
            pivoting_n_per_mm: 2.0 / 3.0 * places.iter().map(work).sum::<f64>(),
            places,
        })
    }
}

fn contact_at(
    d: &Discretisation,
    u: &[f64],
    by: &[f64],
    (slab, g): (usize, usize),
) -> ContactPlace {
    let l = d.layout;
    let Some(braid) = d.problem.braid else {
        return ContactPlace::default();
    };
    let point = &d.strands[slab][g];
    let line = l.line(u, slab, 2 * l.through);
    let (stretch, q) = strand(d, u, slab, g);
    let [v_r, v_z, v_hoop] = stretch.vector;
    let meridian = v_r.hypot(v_z);
    // dθ of tanθ = v_hoop/meridian
    let [d_r, d_z, d_hoop] = point.moved([0.0; 3], &l.line(by, slab, 2 * l.through));
    let d_meridian = (v_r * d_r + v_z * d_z) / meridian;
    let square = stretch.value * stretch.value;
    let turning = (meridian * d_hoop - v_hoop * d_meridian) / square;
    // Curvature of the meridian, positive where it bulges.
    let nodes = d.mesh.line(slab, 2 * l.through);
    let (n, slope) = along(GAUSS2[g].0);
    let mut r = 0.0;
    let mut r1 = 0.0;
    let mut z1 = 0.0;
    let mut r2 = 0.0;
    let mut z2 = 0.0;
    for a in 0..3 {
        let r_a = nodes[a][0] + line[2 * a];
        let z_a = nodes[a][1] + line[2 * a + 1];
        r += n[a] * r_a;
        r1 += slope[a] * r_a;
        z1 += slope[a] * z_a;
        r2 += CURVED[a] * r_a;
        z2 += CURVED[a] * z_a;
    }
    let length = r1.hypot(z1);
    let bending = (r1 * z2 - z1 * r2) / length.powi(3);
    let midline = r + braid.lay.offset_mm;
    let sin2 = v_hoop * v_hoop / square;
    let cos2 = meridian * meridian / square;
    let curvature = sin2 * z1 / (length * midline) + cos2 * bending;
    let area = 2.0 * PI * GAUSS2[g].1 * r * length;
    let pressed = 2.0 * q * stretch.value * curvature * point.area;
    ContactPlace {
        rest_mm: point.place,
        pressure_mpa: pressed / area,
        // The terminal's 1 mm are 2 mm of the muscle.
        turning_rad_per_mm: 0.5 * turning,
        area_mm2: area,
    }
}
